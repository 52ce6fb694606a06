//! The curves of a model as arcs and rational splines: each form is made once for all files that need it.
//!
//! A form of a long curve is as large as its file. It is kept while another file is known to need it, or nothing is known of
//! what is to come; the last file gets what was kept, and no more is in memory than if it were the only one.

use crate::export::error::ExportError;
use crate::export::parts::Contour;
use cyclide::{
    curve::{Arc, ArcPath, ParamCurve as _},
    model::{ChainPiece, CurveChain, Lower as _, Lowered},
};
use std::collections::HashMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The forms of curves that a file needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Forms {
    /// Arcs and rational splines.
    pub(crate) chains: bool,
    /// Arcs and segments only.
    pub(crate) arcs: bool,
}

impl Forms {
    pub(crate) const NONE: Self = Self { chains: false, arcs: false };
    pub(crate) const CHAINS: Self = Self { chains: true, arcs: false };
    pub(crate) const ARCS: Self = Self { chains: false, arcs: true };
    pub(crate) const BOTH: Self = Self { chains: true, arcs: true };
}

/// The forms that are kept of a model's curves.
#[derive(Debug, Default)]
pub(crate) struct LoweredCurves {
    chains: Kept<CurveChain>,
    arcs: Kept<ArcPath>,
}

impl LoweredCurves {
    /// Says which files are to come.
    pub(crate) fn expect(&self, files: &[Forms]) {
        self.chains.expect(files.iter().filter(|forms| forms.chains).count());
        self.arcs.expect(files.iter().filter(|forms| forms.arcs).count());
    }

    /// Says that a file with these forms is made.
    pub(crate) fn made(&self, forms: Forms) {
        if forms.chains {
            self.chains.made();
        }
        if forms.arcs {
            self.arcs.made();
        }
    }

    /// How many chains and how many paths of arcs were made, and how many of each are kept.
    #[cfg(test)]
    pub(crate) fn counts(&self) -> [[usize; 2]; 2] {
        let (chains, arcs) = (self.chains.state(), self.arcs.state());
        [[chains.made, arcs.made], [chains.forms.len(), arcs.forms.len()]]
    }

    /// The contour as arcs and rational splines, without pieces of no length, which no format wants.
    ///
    /// # Errors
    /// [`ExportError::Lowering`].
    pub(crate) fn chain(&self, contour: &Contour<'_>, tolerance: f64) -> Result<Lowered<CurveChain>, ExportError> {
        self.chains.form(contour, tolerance, || chain(contour, tolerance))
    }

    /// The contour as arcs and segments, without those of no length.
    ///
    /// # Errors
    /// [`ExportError::Lowering`].
    pub(crate) fn arcs(&self, contour: &Contour<'_>, tolerance: f64) -> Result<Lowered<ArcPath>, ExportError> {
        self.arcs.form(contour, tolerance, || arcs(contour, tolerance))
    }
}

/// Forms of one kind, kept for the files that are still to come.
#[derive(Debug)]
struct Kept<C>(Mutex<Forthcoming<C>>);

#[derive(Debug)]
struct Forthcoming<C> {
    /// How many files are still to need them, with the one that is being made; `None` if that is not known.
    files: Option<usize>,
    /// By object and contour, with the tolerance.
    forms: HashMap<(usize, usize), (f64, Lowered<C>)>,
    /// How many were made.
    #[cfg(test)]
    made: usize,
}

impl<C> Default for Kept<C> {
    fn default() -> Self {
        Self(Mutex::new(Forthcoming {
            files: None,
            forms: HashMap::new(),
            #[cfg(test)]
            made: 0,
        }))
    }
}

impl<C: Clone> Kept<C> {
    /// Nothing that is done under the lock can leave what is kept half done.
    fn state(&self) -> MutexGuard<'_, Forthcoming<C>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn expect(&self, files: usize) {
        self.state().files = Some(files);
    }

    /// What is kept for nobody is given up.
    fn made(&self) {
        let mut state = self.state();
        state.files = state.files.map(|files| files.saturating_sub(1));
        if state.files == Some(0) {
            state.forms = HashMap::new();
        }
    }

    fn form(
        &self,
        contour: &Contour<'_>,
        tolerance: f64,
        make: impl FnOnce() -> Result<Lowered<C>, ExportError>,
    ) -> Result<Lowered<C>, ExportError> {
        let place = (contour.item, contour.index);
        let mut state = self.state();
        let is_last = state.files.is_some_and(|files| files <= 1);
        // One for another tolerance is of no use any more.
        let kept = if is_last { state.forms.remove(&place) } else { state.forms.get(&place).cloned() };
        if let Some((_, form)) = kept.filter(|(of, _)| of.to_bits() == tolerance.to_bits()) {
            return Ok(form);
        }
        let form = make()?;
        #[cfg(test)]
        {
            state.made += 1;
        }
        if !is_last {
            state.forms.insert(place, (tolerance, form.clone()));
        }
        Ok(form)
    }
}

fn chain(contour: &Contour<'_>, tolerance: f64) -> Result<Lowered<CurveChain>, ExportError> {
    let lowered = contour.lowered(contour.curve.lower_to_chain(tolerance))?;
    let is_point = |p: &ChainPiece| matches!(p, ChainPiece::Arc(arc) if arc.start() == arc.end());
    let Lowered { form, exactness, correspondence } = lowered;
    if !form.pieces().iter().any(is_point) {
        return Ok(Lowered { form, exactness, correspondence });
    }
    let correspondence = correspondence.recounted(piece_counts(&form, |arc| usize::from(arc.start() != arc.end())));
    let pieces = form.pieces().iter().filter(|p| !is_point(p)).cloned().collect();
    let form = contour.lowered(CurveChain::new(pieces, form.is_closed(), 0.0))?;
    Ok(Lowered { form, exactness, correspondence })
}

fn arcs(contour: &Contour<'_>, tolerance: f64) -> Result<Lowered<ArcPath>, ExportError> {
    let lowered = contour.lowered(contour.curve.lower_to_arcs(tolerance))?;
    let Lowered { form, exactness, correspondence } = lowered;
    let is_kept = |arc: &Arc| arc.start() != arc.end();
    if form.arcs().iter().all(is_kept) {
        return Ok(Lowered { form, exactness, correspondence });
    }
    let correspondence = correspondence.recounted(form.arcs().iter().map(|arc| usize::from(is_kept(arc))));
    let arcs = form.arcs().iter().filter(|arc| is_kept(arc)).copied().collect();
    let form = contour.lowered(ArcPath::new(arcs, form.is_closed()))?;
    Ok(Lowered { form, exactness, correspondence })
}

/// How many pieces each smooth piece of a chain becomes in a file: an arc as many as the function says, the span of a
/// spline one.
fn piece_counts<'a>(
    chain: &'a CurveChain,
    mut of_arc: impl FnMut(&Arc) -> usize + 'a,
) -> impl Iterator<Item = usize> + 'a {
    chain.pieces().iter().flat_map(move |piece| match piece {
        ChainPiece::Arc(arc) => std::iter::repeat_n(of_arc(arc), 1),
        ChainPiece::Spline(curve) => std::iter::repeat_n(1, curve.piece_count()),
    })
}
