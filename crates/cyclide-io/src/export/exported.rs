//! The content of a file with the promises that hold for it.

use crate::export::drawn_line::LinePlace;
use crate::export::face_plan::ShellPlan;
use crate::export::mesh_plan::MeshPlan;
use cyclide::{
    curve::{Arc, ArcPath, Correspondence, ParamCurve, PieceForm},
    model::{ChainPiece, CurveChain, Exactness, Lowered},
    rational::NurbsCurve,
};

/// The content of a file with its error bounds.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::Model};
/// use cyclide_io::{ExportOptions, Format, formats::export};
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0))?;
/// let model = Model::default().with_curve("line", segment);
/// let file = export(&model, Format::Step, &ExportOptions::default())?;
/// assert!(file.exact && file.notes.is_empty() && file.bytes.starts_with(b"ISO-10303-21;"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// True if the curves in the file equal those of the objects up to the rounding of the numbers.
    pub exact: bool,
    /// Bound on the distance between the curve in the file and the object, in model units; 0 if exact.
    pub bound: f64,
    /// True if the bound of a part of the file is sampled, not proved.
    pub sampled: bool,
    /// Additional error from the precision of the numbers in the file, in model units: positive if curves come near
    /// infinity.
    pub rounding: f64,
    /// Notes for the user, one sentence each.
    pub notes: Vec<String>,
    /// The name of the whole.
    pub(crate) title: String,
    /// What the file is checked against.
    pub(crate) written: Written,
}

/// What a file was written from, part by part: what it is checked against.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Written {
    /// The connected curves, in file order.
    pub(crate) curves: Vec<WrittenCurve>,
    /// What is promised for each body, in the model's order.
    pub(crate) bodies: Vec<Promise>,
    /// What the faces of each body stand for, shell by shell in file order, in formats that hold faces.
    pub(crate) shells: Vec<Vec<ShellPlan>>,
    /// The parts of blocks that the hexahedra of each body stand for, in file order, in formats that hold volumes.
    pub(crate) volumes: Vec<Vec<[[f64; 2]; 3]>>,
    /// What is said of each of these hexahedra, in file order, in formats that say how good cells are.
    pub(crate) qualities: Vec<[f64; 5]>,
    /// True if blocks are divided into plain cells.
    pub(crate) plain_cells: bool,
    /// What the polygons of a mesh stand for.
    pub(crate) mesh: MeshPlan,
    /// True if the edges of the patches are drawn on the meshes.
    pub(crate) mesh_edges: bool,
    /// What the lines of surfaces in a drawing stand for, in file order, with those that are points there.
    pub(crate) lines: Vec<DrawnLine>,
    /// What is promised of each motion, in the model's order.
    pub(crate) motions: Vec<Promise>,
    /// The tolerance of curves that the file is made with.
    pub(crate) tolerance: f64,
    /// The tolerance that was asked for, if one was.
    pub(crate) asked: Option<f64>,
}

/// A connected curve of a file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WrittenCurve {
    /// Which parts of the object's curve its pieces stand for.
    pub(crate) parts: Correspondence,
    pub(crate) promise: Promise,
    /// The distinct knots of its splines, one spline after the other.
    pub(crate) knots: Vec<f64>,
}

impl WrittenCurve {
    /// True if nothing of it is in the file: a drawing has no place for a curve that is a point in it.
    pub(crate) fn is_left_out(&self) -> bool {
        self.parts.piece_count() == 0
    }
}

/// A line that a drawing was made of.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DrawnLine {
    pub(crate) place: LinePlace,
    /// The parts of it that its pieces in the drawing stand for; without a piece it is a point there and not drawn.
    pub(crate) parts: Correspondence,
    pub(crate) promise: Promise,
}

impl DrawnLine {
    pub(crate) fn is_drawn(&self) -> bool {
        self.parts.piece_count() > 0
    }
}

/// The distinct knots of a piece, none of an arc.
pub(crate) fn knots_of(piece: &ChainPiece) -> &[f64] {
    match piece {
        ChainPiece::Arc(_) => &[],
        ChainPiece::Spline(curve) => curve.breaks(),
    }
}

/// What the smooth pieces of a curve become in a format that has splines.
#[derive(Debug, Default)]
pub(crate) struct PieceNotes {
    /// How many pieces of the file each has become.
    pub(crate) counts: Vec<usize>,
    /// The distinct knots of the splines among these, one spline after the other.
    pub(crate) knots: Vec<f64>,
}

impl PieceNotes {
    /// Notes a spline that stays one.
    pub(crate) fn spline(&mut self, curve: &NurbsCurve) {
        self.counts.extend(std::iter::repeat_n(1, curve.piece_count()));
        self.knots.extend(curve.breaks());
    }

    /// Notes one arc as a spline.
    pub(crate) fn arc_as_spline(&mut self, curve: &NurbsCurve) {
        self.counts.push(curve.piece_count());
        self.knots.extend(curve.breaks());
    }

    /// The curve that the pieces are of.
    pub(crate) fn of(self, promise: Promise, parts: Correspondence) -> WrittenCurve {
        WrittenCurve { parts: parts.recounted(self.counts), promise, knots: self.knots }
    }
}

impl Written {
    /// The finished file.
    pub(crate) fn exported(self, bytes: Vec<u8>, notes: Vec<String>) -> Exported {
        let mut whole = Promise::EXACT;
        self.curves.iter().for_each(|curve| whole.merge(curve.promise));
        self.bodies.iter().for_each(|body| whole.merge(*body));
        self.lines.iter().for_each(|line| whole.merge(line.promise));
        self.motions.iter().for_each(|motion| whole.merge(*motion));
        let Promise { bound, sampled, rounding } = whole;
        let (exact, bound, title) = (bound.is_none(), bound.unwrap_or(0.0), String::new());
        Exported { bytes, exact, bound, sampled, rounding, notes, title, written: self }
    }
}

/// What is promised for one connected curve, line or body of a file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Promise {
    /// Largest distance from the model; `None` if exact.
    bound: Option<f64>,
    sampled: bool,
    /// What the digits of its numbers may cost beside it.
    rounding: f64,
}

impl Promise {
    pub(crate) const EXACT: Self = Self { bound: None, sampled: false, rounding: 0.0 };

    /// A proved bound; none if it is zero.
    pub(crate) fn proved(bound: f64) -> Self {
        let mut promise = Self::EXACT;
        promise.add(if bound > 0.0 { Exactness::Proved(bound) } else { Exactness::Exact });
        promise
    }

    /// A bound that was found at many places, with a reserve between them.
    pub(crate) fn sampled(bound: f64) -> Self {
        let mut promise = Self::EXACT;
        promise.add(Exactness::Sampled(bound));
        promise
    }

    /// The promise of a polyline within a tolerance: its vertices are points of the curve, to the digits of that.
    pub(crate) fn of_polyline(curve: &dyn ParamCurve, tolerance: f64) -> Self {
        let rounding = |piece: usize| match curve.piece_form(piece) {
            PieceForm::Arc(arc) => arc_rounding(&arc),
            PieceForm::Circle(_) | PieceForm::Free => 0.0,
        };
        let rounding = (0..curve.piece_count()).map(rounding).fold(0.0, f64::max);
        Self { rounding, ..Self::proved(tolerance) }
    }

    pub(crate) fn add(&mut self, exactness: Exactness) {
        self.sampled |= matches!(exactness, Exactness::Sampled(_));
        if let Exactness::Proved(bound) | Exactness::Sampled(bound) = exactness {
            self.bound = Some(self.bound.map_or(bound, |b| b.max(bound)));
        }
    }

    /// Beside the bound, digits may cost this.
    pub(crate) fn add_rounding(&mut self, rounding: f64) {
        self.rounding = self.rounding.max(rounding);
    }

    fn merge(&mut self, other: Self) {
        self.bound = match (self.bound, other.bound) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        };
        self.sampled |= other.sampled;
        self.rounding = self.rounding.max(other.rounding);
    }

    pub(crate) fn is_exact(&self) -> bool {
        self.bound.is_none()
    }

    /// Largest distance that was promised, and what the digits may cost beside it.
    pub(crate) fn distances(&self) -> [f64; 2] {
        [self.bound.unwrap_or(0.0), self.rounding]
    }

    /// The promise of a chain. A spline that comes near infinity has weights of very different sizes, and its numbers
    /// carry the smallest ones to so many digits less.
    pub(crate) fn of_chain(lowered: &Lowered<CurveChain>) -> Self {
        let mut promise = Self::EXACT;
        promise.add(lowered.exactness);
        for piece in lowered.form.pieces() {
            promise.rounding = promise.rounding.max(match piece {
                ChainPiece::Arc(arc) => arc_rounding(arc),
                ChainPiece::Spline(curve) => spline_rounding(curve),
            });
        }
        promise
    }

    /// The promise of arcs.
    pub(crate) fn of_arcs(lowered: &Lowered<ArcPath>) -> Self {
        let mut promise = Self::EXACT;
        promise.add(lowered.exactness);
        promise.rounding = lowered.form.arcs().iter().map(arc_rounding).fold(0.0, f64::max);
        promise
    }

    /// The promise of one curve with the parts that its pieces stand for.
    pub(crate) fn of(self, parts: Correspondence) -> WrittenCurve {
        WrittenCurve { parts, promise: self, knots: Vec::new() }
    }
}

/// Rounding of the points of a spline with even weights, relative to its coordinates.
const WEIGHT_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Smallest radius that is kept as an arc, relative to its coordinates: of a smaller one the center and the points round
/// to the same numbers.
pub(crate) const SMALLEST_RADIUS: f64 = 8.0 * f64::EPSILON;

/// Smallest swept angle that drawings and polylines keep as an arc. Readers find the circle from the chord and a
/// radius or bulge: below, they would lose more digits than the arc's sagitta has.
const SMALLEST_SWEEP: f64 = 5e-8;

/// Rounding of a spline by the quotient of its weights.
fn spline_rounding(curve: &NurbsCurve) -> f64 {
    let (least, most) = curve.weights().iter().fold((f64::INFINITY, 0.0_f64), |(lo, hi), w| (lo.min(*w), hi.max(*w)));
    let size = curve.control_points().iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    WEIGHT_ROUNDING * (most / least) * size
}

/// Rounding of an arc that goes round nearly all of its circle: by one over the sine of half its angle, as far as its
/// circle is known from chord and weight.
fn arc_rounding(arc: &Arc) -> f64 {
    let half = 0.5 * arc.angle();
    match arc.radius() {
        Some(radius) if half > std::f64::consts::FRAC_PI_2 => {
            let sine = 0.5 * arc.chord().length() / radius;
            WEIGHT_ROUNDING * radius / sine.max(f64::EPSILON)
        }
        _ => 0.0,
    }
}

/// What is lost if the arc is written as its chord, for arcs that have to be; `None` for arcs that stay arcs.
pub(crate) fn straightened(arc: &Arc) -> Option<Exactness> {
    if arc.is_straight() {
        return Some(Exactness::Exact);
    }
    let size = arc.start().to_vec().max_abs().max(arc.end().to_vec().max_abs());
    if let Some(radius) = arc.radius().filter(|radius| *radius <= SMALLEST_RADIUS * size) {
        return Some(Exactness::Proved(2.0 * radius));
    }
    if arc.angle() >= SMALLEST_SWEEP {
        return None;
    }
    let sagitta = 0.5 * arc.chord().length() * arc.bulge_vector().length();
    let rounding = f64::EPSILON * size;
    Some(if sagitta > rounding { Exactness::Proved(sagitta) } else { Exactness::Exact })
}
