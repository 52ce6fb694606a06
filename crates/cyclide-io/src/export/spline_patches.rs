//! Curves, faces and blocks as patches of B-splines with weights, as programs of isogeometric analysis have them: a contour is one curve where it can be,
//! faces and blocks are Bézier patches, blocks with knots where their cells end.

use crate::export::error::ExportError;
use crate::export::exported::{PieceNotes, Promise, Written, WrittenCurve};
use crate::export::job::Job;
use crate::export::parts::Contour;
use crate::export::rational_cells::{Degrees, Halving, Node, RationalCell, Tags, boxes_between, cells_of, push_bodies};
use cyclide::{
    Point3,
    curve::{DEFAULT_PIECE_ANGLE, ParamCurve as _},
    model::{ChainPiece, CurveChain, Lowered},
    rational::{NurbsCurve, RationalBezier},
};

/// The knots along a parameter.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Knots {
    pub(crate) degree: usize,
    pub(crate) knots: Vec<f64>,
}

impl Knots {
    /// Those of one Bézier span.
    fn of_span(degree: usize) -> Self {
        Self::divided(degree, &[])
    }

    /// Those of one Bézier span with more, rising, between its ends.
    fn divided(degree: usize, inner: &[f64]) -> Self {
        Self { degree, knots: [&vec![0.0; degree + 1], inner, &vec![1.0; degree + 1]].concat() }
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

    /// A Bézier patch with more knots, rising, between the ends of each parameter: the same points. The control point between knots is the blossom at the
    /// n knots inside its own n + 2 (L. Ramshaw, *Blossoms are polar forms*, 1989).
    fn divided(cell: RationalCell, inner: &[Vec<f64>; 3]) -> cyclide::Result<Self> {
        let (mut degrees, mut rows, dimension) = (cell.degrees, cell.rows(), cell.dimension());
        let mut knots = Vec::new();
        for (axis, inner) in inner.iter().enumerate().take(dimension) {
            let own = Knots::divided(degrees[axis], inner);
            let with_knots = |row: &[[f64; 4]]| {
                let points = own.knots.windows(own.degree).skip(1).take(own.degree + inner.len() + 1);
                Ok(points.map(|at| blossom(row, at)).collect())
            };
            (degrees, rows) = along(degrees, &rows, axis, with_knots)?;
            knots.push(own);
        }
        Ok(Self { knots, net: RationalCell::of_rows(degrees, &rows, cell.tags) })
    }

    /// The Bézier patches between its knots, the first parameter fastest.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::new`]: knots that are none.
    pub(crate) fn spans(&self) -> cyclide::Result<Vec<RationalCell>> {
        let (mut degrees, mut rows) = (self.net.degrees, self.net.rows());
        let (mut own, mut counts) = ([0; 3], [1; 3]);
        for (axis, Knots { degree, knots }) in self.knots.iter().enumerate() {
            let parted = |row: &[[f64; 4]]| {
                let points = row.iter().map(|[x, y, z, w]| Point3::new(x / w, y / w, z / w)).collect();
                let weights = row.iter().map(|row| row[3]).collect();
                let spans = NurbsCurve::new(*degree, knots.clone(), points, weights)?.to_beziers();
                Ok(spans.iter().flat_map(|span| span.rows().to_vec()).collect())
            };
            (degrees, rows) = along(degrees, &rows, axis, parted)?;
            (own[axis], counts[axis]) = (*degree, (degrees[axis] + 1) / (degree + 1));
        }
        let all = RationalCell { degrees, nodes: Vec::new(), tags: self.net.tags };
        let [m, n, l] = counts;
        let span = |k: usize| {
            let at = [k % m, k / m % n, k / (m * n)];
            let shape = RationalCell { degrees: own, nodes: Vec::new(), tags: all.tags };
            let mut nodes = vec![[0.0; 4]; own.iter().map(|d| d + 1).product()];
            for index in shape.first_fastest() {
                let from = std::array::from_fn(|axis| at[axis] * (own[axis] + 1) + index[axis]);
                nodes[shape.index(index)] = rows[all.index(from)];
            }
            RationalCell::of_rows(own, &nodes, all.tags)
        };
        Ok((0..m * n * l).map(span).collect())
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

/// Replaces the lines along a parameter of a net of homogeneous rows, all of them with as many others.
fn along(
    degrees: Degrees,
    rows: &[[f64; 4]],
    axis: usize,
    new: impl Fn(&[[f64; 4]]) -> cyclide::Result<Vec<[f64; 4]>>,
) -> cyclide::Result<(Degrees, Vec<[f64; 4]>)> {
    let stride: usize = degrees[axis + 1..].iter().map(|degree| degree + 1).product();
    let count = degrees[axis] + 1;
    let lines = (0..rows.len() / count).map(|line| {
        let first = line / stride * stride * count + line % stride;
        new(&(0..count).map(|k| rows[first + k * stride]).collect::<Vec<_>>())
    });
    let lines = lines.collect::<cyclide::Result<Vec<_>>>()?;
    let new_count = lines.first().map_or(0, Vec::len);
    let mut out = vec![[0.0; 4]; lines.len() * new_count];
    for (line, row) in lines.iter().enumerate() {
        let first = line / stride * stride * new_count + line % stride;
        row.iter().enumerate().for_each(|(k, value)| out[first + k * stride] = *value);
    }
    let mut degrees = degrees;
    degrees[axis] = new_count.saturating_sub(1);
    Ok((degrees, out))
}

/// De Casteljau's scheme with another parameter in each step.
fn blossom(row: &[[f64; 4]], at: &[f64]) -> [f64; 4] {
    let mut work = row.to_vec();
    for (level, t) in at.iter().enumerate() {
        for i in 0..row.len() - 1 - level {
            work[i] = std::array::from_fn(|d| (1.0 - t) * work[i][d] + t * work[i + 1][d]);
        }
    }
    work[0]
}

/// Adds the faces and blocks of a model, or only those of a dimension, and notes what they stand for. Blocks that are divided have knots where their cells
/// end.
///
/// # Errors
/// [`ExportError::Surface`].
pub(crate) fn push_surfaces_and_volumes(
    job: &Job<'_>,
    only: Option<usize>,
    patches: &mut Vec<SplinePatch>,
    written: &mut Written,
) -> Result<(), ExportError> {
    let mut cells = Vec::new();
    push_bodies(job, only, Halving::Evenly, &mut cells, written)?;
    let (blocks, faces): (Vec<_>, Vec<_>) = cells.into_iter().partition(|cell| cell.dimension() == 3);
    patches.extend(faces.into_iter().map(SplinePatch::from));
    let mut blocks = blocks.into_iter();
    for (body, parts) in job.bodies.iter().zip(&mut written.volumes) {
        let ends = cells_of(job, body);
        let halves = std::mem::take(parts);
        for (half, cell) in halves.into_iter().zip(blocks.by_ref()) {
            let Some(ends) = &ends else {
                parts.push(half);
                patches.push(cell.into());
                continue;
            };
            let inside = |axis: usize| {
                let [from, to] = half[axis];
                ends[axis].iter().copied().filter(move |x| *x > from && *x < to)
            };
            let local = |axis: usize| inside(axis).map(move |x| (x - half[axis][0]) / (half[axis][1] - half[axis][0]));
            let divided = SplinePatch::divided(cell, &std::array::from_fn(|axis| local(axis).collect()));
            patches.push(divided.map_err(|source| body.unfit(source))?);
            let with_ends = |axis: usize| [half[axis][0]].into_iter().chain(inside(axis)).chain([half[axis][1]]);
            parts.extend(boxes_between(&std::array::from_fn(|axis| with_ends(axis).collect())));
        }
    }
    Ok(())
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
