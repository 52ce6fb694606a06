//! A checked request to a writer: the model lowered to contours and bodies, the options with the defaults filled in.

use crate::export_error::ExportError;
use crate::exporter::Exporter;

use crate::format::{Format, Kind};
use crate::options::{DEFAULT_MOST_PIECES, ExportOptions, PIECES_OF_EACH};
use crate::pieces::Pieces;
use crate::shape::Shape;
use cyclide::{
    Aabb, Arc, ArcPath, ChainPiece, CurveChain, CurveObject, Item, Lower, Lowered, Model, ParamCurve as _, Units,
    bounds,
};

/// Tolerance of curves when none is asked for: this part of the model's diagonal.
const DEFAULT_RELATIVE_TOLERANCE: f64 = 1e-5;
/// The same of meshes, whose size grows with its inverse (that of polylines with the root only).
const DEFAULT_MESH_TOLERANCE: f64 = 1e-4;

/// A body of a surface with the object it belongs to.
pub(crate) struct BodyOf<'a> {
    /// Name of the object.
    pub(crate) object: &'a str,
    /// Index of the object in the model.
    pub(crate) item: usize,
    /// Which of the object's surfaces it belongs to.
    pub(crate) surface: usize,
    /// Which of the object's bodies.
    pub(crate) index: usize,
    /// How many bodies the object has: one per surface, or more where one falls apart into lobes.
    pub(crate) count: usize,
    pub(crate) body: Shape<'a>,
}

impl BodyOf<'_> {
    /// The error of a surface that has no form as a format needs it.
    pub(crate) fn unfit(&self, source: cyclide::Error) -> ExportError {
        ExportError::Surface { object: self.object.to_owned(), surface: self.surface, source }
    }

    /// The object's name, with the body's number from 0, as in reports, behind it where there are several.
    pub(crate) fn label(&self) -> String {
        if self.count == 1 { self.object.to_owned() } else { format!("{} {}", self.object, self.index) }
    }
}

/// A checked request: the model, the options with the defaults filled in, and the model's size.
pub(crate) struct Job<'a> {
    pub(crate) model: &'a Model,
    pub(crate) options: &'a ExportOptions,
    /// Tolerance of curves.
    pub(crate) tolerance: f64,
    /// Tolerance of meshes.
    pub(crate) mesh_tolerance: f64,
    /// How many pieces the file may be made of.
    pub(crate) pieces: Pieces,
    /// The smallest box around all curves and surfaces.
    pub(crate) bounds: Aabb,
    /// The bodies of all surfaces, in the model's order.
    pub(crate) bodies: &'a [BodyOf<'a>],
}

/// One connected curve with the object it belongs to.
pub(crate) struct Contour<'a> {
    /// Name of the object.
    pub(crate) object: &'a str,
    /// Index of the object in the model.
    pub(crate) item: usize,
    /// Which of the object's contours.
    pub(crate) index: usize,
    /// How many contours the object has.
    pub(crate) count: usize,
    pub(crate) curve: &'a CurveObject,
}

impl Contour<'_> {
    /// The object's name, with the contour's number from 0, as in reports, behind it where there are several.
    pub(crate) fn label(&self) -> String {
        if self.count == 1 { self.object.to_owned() } else { format!("{} {}", self.object, self.index) }
    }

    /// A result of the kernel with the place it belongs to.
    pub(crate) fn lowered<T>(&self, result: cyclide::Result<T>) -> Result<T, ExportError> {
        result.map_err(|source| ExportError::Lowering { object: self.object.to_owned(), contour: self.index, source })
    }
}

impl<'a> Job<'a> {
    pub(crate) fn new(exporter: &'a Exporter<'a>, options: &'a ExportOptions) -> Result<Self, ExportError> {
        let Exporter { model, ref bodies, bounds, .. } = *exporter;
        let tolerance = options.tolerance.unwrap_or_else(|| default_tolerance(bounds));
        let relative = DEFAULT_MESH_TOLERANCE / DEFAULT_RELATIVE_TOLERANCE;
        let mesh_tolerance = options.tolerance.unwrap_or_else(|| relative * default_tolerance(bounds));
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(ExportError::ToleranceNotPositive { tolerance });
        }
        let pieces = Pieces::new(options.max_pieces.unwrap_or_else(|| most_pieces(model, bodies)));
        Ok(Self { model, options, tolerance, mesh_tolerance, pieces, bounds, bodies })
    }

    pub(crate) fn units(&self) -> Units {
        self.model.units
    }

    /// Diagonal of the model, never zero.
    pub(crate) fn size(&self) -> f64 {
        self.bounds.diagonal().max(f64::MIN_POSITIVE)
    }

    /// The model's name: asked for, or that of the only object.
    pub(crate) fn title(&self) -> &str {
        match (&self.options.title, self.model.items.as_slice()) {
            (Some(title), _) => title,
            (None, [only]) => &only.name,
            _ => "cyclide",
        }
    }

    pub(crate) fn contours(&self) -> impl Iterator<Item = Contour<'a>> {
        contours(self.model)
    }

    /// Refuses surfaces without an exact form where the format holds exact ones only.
    ///
    /// # Errors
    /// [`ExportError::NoExactForm`].
    pub(crate) fn check_exact_form(&self, format: Format) -> Result<(), ExportError> {
        match self.bodies.iter().find(|body| body.body.triangles().is_some()) {
            Some(body) if format.holds_exact_only() => {
                Err(ExportError::NoExactForm { object: body.object.to_owned(), format: format.title() })
            }
            _ => Ok(()),
        }
    }

    /// A note on the objects that the format has no place for; refused where nothing remains.
    pub(crate) fn left_out(&self, format: Format) -> Result<Option<String>, ExportError> {
        let Some(kind) = format.lacks() else {
            return Ok(None);
        };
        let has = |item: &&Item, kind: Kind| match kind {
            Kind::Curves => !item.contours.is_empty(),
            Kind::Surfaces => !item.surfaces.is_empty(),
        };
        let (other, what) = match kind {
            Kind::Curves => (Kind::Surfaces, "curves"),
            Kind::Surfaces => (Kind::Curves, "surfaces"),
        };
        let lost: Vec<&str> =
            self.model.items.iter().filter(|item| has(item, kind)).map(|item| item.name.as_str()).collect();
        let Some(first) = lost.first() else {
            return Ok(None);
        };
        if !self.model.items.iter().any(|item| has(&item, other)) {
            let (object, format) = ((*first).to_owned(), format.title());
            return Err(ExportError::NotInFormat { object, format, detail: what });
        }
        Ok(Some(format!("{what} are left out ({} cannot hold them): {}", format.title(), lost.join(", "))))
    }

    /// The contour as arcs and rational splines, without pieces of no length, which no format wants.
    pub(crate) fn chain(&self, contour: &Contour<'_>) -> Result<Lowered<CurveChain>, ExportError> {
        let lowered = contour.lowered(contour.curve.lower_to_chain(self.tolerance))?;
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

    /// The contour as arcs and segments, without those of no length.
    pub(crate) fn arcs(&self, contour: &Contour<'_>) -> Result<Lowered<ArcPath>, ExportError> {
        let lowered = contour.lowered(contour.curve.lower_to_arcs(self.tolerance))?;
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
}

/// How many pieces each smooth piece of a chain becomes in a file: an arc as many as the function says, the span of a
/// spline one.
pub(crate) fn piece_counts<'a>(
    chain: &'a CurveChain,
    mut of_arc: impl FnMut(&Arc) -> usize + 'a,
) -> impl Iterator<Item = usize> + 'a {
    chain.pieces().iter().flat_map(move |piece| match piece {
        ChainPiece::Arc(arc) => std::iter::repeat_n(of_arc(arc), 1),
        ChainPiece::Spline(curve) => std::iter::repeat_n(1, curve.piece_count()),
    })
}

/// The pieces that a file may have if nothing else is asked for.
fn most_pieces(model: &Model, bodies: &[BodyOf<'_>]) -> usize {
    let of_curves: usize = contours(model).map(|contour| contour.curve.as_curve().piece_count()).sum();
    let faces: usize = bodies.iter().map(|body| body.body.part_count()).sum();
    DEFAULT_MOST_PIECES.saturating_add((of_curves + faces).saturating_mul(PIECES_OF_EACH))
}

/// The bodies of a model's surfaces in the order in which every format writes them.
pub(crate) fn bodies(model: &Model) -> Result<Vec<BodyOf<'_>>, ExportError> {
    let mut bodies = Vec::new();
    for (item, it) in model.items.iter().enumerate() {
        let mut own: Vec<(usize, Shape<'_>)> = Vec::new();
        for (index, surface) in it.surfaces.iter().enumerate() {
            let lowered = |source| ExportError::Surface { object: it.name.clone(), surface: index, source };
            if let Some(triangles) = surface.as_triangles() {
                own.push((index, Shape::of_triangles(triangles).map_err(lowered)?));
            }
            own.extend(surface.to_bodies().map_err(lowered)?.into_iter().map(|body| (index, body.into())));
        }
        let count = own.len();
        let named = |(index, (surface, body))| BodyOf { object: &it.name, item, surface, index, count, body };
        bodies.extend(own.into_iter().enumerate().map(named));
    }
    Ok(bodies)
}

/// The boxes round all curves and surfaces of a model, each with the name of its object.
pub(crate) fn boxes<'a>(model: &'a Model, bodies: &'a [BodyOf<'a>]) -> impl Iterator<Item = (&'a str, Aabb)> {
    let curves = contours(model).map(|contour| (contour.object, bounds(contour.curve.as_curve())));
    curves.chain(bodies.iter().map(|body| (body.object, body.body.bounds())))
}

/// The connected curves of a model in the order in which every format writes them.
pub(crate) fn contours(model: &Model) -> impl Iterator<Item = Contour<'_>> {
    model.items.iter().enumerate().flat_map(|(index, item)| contours_of(index, item))
}

/// The connected curves of one object, by its number in the model.
pub(crate) fn contours_of(item: usize, it: &Item) -> impl Iterator<Item = Contour<'_>> {
    let count = it.contours.len();
    let own = it.contours.iter().enumerate();
    own.map(move |(index, curve)| Contour { object: &it.name, item, index, count, curve })
}

/// The tolerance that applies when none is asked for; for a model without extent that of a model of size 1.
pub(crate) fn default_tolerance(bounds: Aabb) -> f64 {
    let size = bounds.diagonal();
    DEFAULT_RELATIVE_TOLERANCE * if size > 0.0 { size } else { 1.0 }
}
