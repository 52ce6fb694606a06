//! Curves, faces and blocks as patches of B-splines with weights, as programs of isogeometric analysis have them: a contour is one curve where it can be,
//! faces and blocks are Bézier patches.

use crate::export::error::ExportError;
use crate::export::exported::{PieceNotes, Promise, Written, WrittenCurve};
use crate::export::job::Job;
use crate::export::parts::Contour;
use crate::export::rational_cells::{Node, RationalCell, Tags};
use cyclide::{ChainPiece, CurveChain, DEFAULT_PIECE_ANGLE, Lowered, NurbsCurve, ParamCurve as _, RationalBezier};

/// The knots along a parameter.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Knots {
    pub(crate) degree: usize,
    pub(crate) knots: Vec<f64>,
}

impl Knots {
    /// Those of one Bézier span.
    pub(crate) fn of_span(degree: usize) -> Self {
        Self { degree, knots: [vec![0.0; degree + 1], vec![1.0; degree + 1]].concat() }
    }
}

/// A patch of B-splines with positive weights.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SplinePatch {
    /// Along each of its parameters.
    pub(crate) knots: Vec<Knots>,
    pub(crate) net: RationalCell,
}

impl From<RationalCell> for SplinePatch {
    fn from(cell: RationalCell) -> Self {
        let knots = cell.degrees[..cell.dimension()].iter().map(|degree| Knots::of_span(*degree)).collect();
        Self { knots, net: cell }
    }
}

impl SplinePatch {
    fn of_curve(curve: &NurbsCurve, tags: Tags) -> Self {
        let nodes = curve.control_points().iter().zip(curve.weights()).map(|(p, w)| (p.to_array(), *w)).collect();
        let net = RationalCell { degrees: [curve.control_points().len() - 1, 0, 0], nodes, tags };
        Self { knots: vec![Knots { degree: curve.degree(), knots: curve.knots().to_vec() }], net }
    }

    pub(crate) fn dimension(&self) -> usize {
        self.knots.len()
    }

    /// The corners, in binary order.
    pub(crate) fn corners(&self) -> impl Iterator<Item = Node> {
        let degrees = self.net.degrees;
        (0..1_usize << self.dimension())
            .map(move |corner| self.net.node(std::array::from_fn(|axis| degrees[axis] * (corner >> axis & 1))))
    }

    /// The control points of a side, the earlier of the other parameters fastest: side `2 axis + end` is that at the start (end 0) or end (1) of a
    /// parameter.
    pub(crate) fn side(&self, side: usize) -> Vec<Node> {
        let (axis, at) = (side / 2, (side % 2) * self.net.degrees[side / 2]);
        self.net.first_fastest().filter(|index| index[axis] == at).map(|index| self.net.node(index)).collect()
    }
}

/// Adds the contours of a model, each as one curve as far as arcs or splines follow each other, and notes what they stand for.
///
/// # Errors
/// [`ExportError::Lowering`].
pub(crate) fn push_curves(
    job: &Job<'_>,
    patches: &mut Vec<SplinePatch>,
    written: &mut Written,
) -> Result<(), ExportError> {
    for contour in job.contours() {
        let lowered = job.chain(&contour)?;
        written.curves.push(contour.lowered(push_contour(patches, &contour, lowered))?);
    }
    Ok(())
}

fn push_contour(
    patches: &mut Vec<SplinePatch>,
    contour: &Contour<'_>,
    lowered: Lowered<CurveChain>,
) -> cyclide::Result<WrittenCurve> {
    let promise = Promise::of_chain(&lowered);
    let Lowered { form: chain, correspondence, .. } = lowered;
    let tags = Tags { object: contour.item, part: contour.index, shell: 0, flag: usize::from(chain.is_closed()) };
    let (mut notes, mut arcs) = (PieceNotes::default(), Arcs::default());
    for piece in chain.into_pieces() {
        match piece {
            ChainPiece::Arc(arc) => {
                let spans = arc.to_nurbs(DEFAULT_PIECE_ANGLE)?.to_beziers();
                notes.counts.push(spans.len());
                arcs.push(spans);
            }
            ChainPiece::Spline(curve) => {
                patches.extend(arcs.joined(&mut notes)?.map(|run| SplinePatch::of_curve(&run, tags)));
                notes.spline(&curve);
                patches.push(SplinePatch::of_curve(&curve.with_c1_knots().unwrap_or(curve), tags));
            }
        }
    }
    patches.extend(arcs.joined(&mut notes)?.map(|run| SplinePatch::of_curve(&run, tags)));
    Ok(notes.of(promise, correspondence))
}

/// Arcs that follow each other, as rational quadratics.
#[derive(Default)]
struct Arcs {
    spans: Vec<RationalBezier>,
    intervals: Vec<f64>,
}

impl Arcs {
    /// Adds one, over an interval of length 1.
    fn push(&mut self, spans: Vec<RationalBezier>) {
        self.intervals.extend(std::iter::repeat_n(1.0 / spans.len() as f64, spans.len()));
        self.spans.extend(spans);
    }

    /// All of them as one curve, if there are any; there are none after it.
    fn joined(&mut self, notes: &mut PieceNotes) -> cyclide::Result<Option<NurbsCurve>> {
        let Self { spans, intervals } = std::mem::take(self);
        if spans.is_empty() {
            return Ok(None);
        }
        let curve = NurbsCurve::from_beziers(&spans, &intervals)?;
        notes.knots.extend(curve.breaks());
        Ok(Some(curve))
    }
}
