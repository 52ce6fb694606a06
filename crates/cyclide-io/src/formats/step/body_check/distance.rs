//! How far faces and edges of a file are from the part of a face of the uncut model that they stand for.
//!
//! Rational surfaces and edges are compared at equal parameters, analytic surfaces and circles by distance.

use super::border::Border;
use super::{Mismatch, require};
use crate::check::bodies::{FileCurve, FileEdge, FileFace, FileSurface};
use crate::check::deviation::larger;
use crate::formats::step::layout::outward;
use cyclide::{
    Point2, Point3,
    curve::ParamCurve as _,
    model::ChainPiece,
    rational::{NurbsCurve, RationalBezierSurface},
    surface::{ParamSurface as _, PatchKind},
    topology::{FacePart, FaceSurface, Side},
};

/// Places per parameter at which surfaces and edges are compared.
const PLACES: u32 = 9;
/// By so much of its length and of the model's size an edge may leave its face at equal parameters: far below readers' own
/// tolerance, above the rounding of parameters with very uneven weights.
const PARAMETER_LIMIT: (f64, f64) = (1e-9, 1e-12);
/// Edges below this part of the model's size are points for other programs; the kernel takes corners for concircular to it.
const SHORT_EDGE: f64 = 1e-9;
/// Rounding of a point of an edge or a face, or of the length of an edge, relative to the coordinates.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A part of a face of the uncut model: a surface with its own parameters, from 0 to 1.
pub(super) struct Piece<'a> {
    pub(super) surface: &'a FaceSurface,
    pub(super) part: &'a FacePart,
}

impl Piece<'_> {
    fn point(&self, (x, y): (f64, f64)) -> Point3 {
        let (s, t) = self.part.place(x, y);
        self.surface.point(s, t)
    }

    /// The points of one side from its start to its end.
    pub(super) fn along(&self, side: Side) -> impl Iterator<Item = Point3> {
        (0..PLACES).map(move |i| self.point(side.place(parameter(i))))
    }

    /// How far the points of a side are from being one.
    pub(super) fn width(&self, side: Side) -> f64 {
        let start = self.point(side.place(0.0));
        self.along(side).map(|p| p.distance(start)).fold(0.0, larger)
    }

    /// The surface of the file's face against it.
    ///
    /// # Errors
    /// A face that looks to the other side than the model's `outer_side`, which is that of `f_s × f_t` if it is true.
    pub(super) fn surface_deviation(&self, file: &FileFace, outer_side: bool) -> Result<f64, Mismatch> {
        let places = (0..PLACES * PLACES).map(|k| (parameter(k % PLACES), parameter(k / PLACES)));
        let (distance, outward) = match &file.surface {
            FileSurface::Rational(surface) => {
                let apart = places.map(|(x, y)| surface.point(x, y).distance(self.point((x, y))));
                (apart.fold(0.0, larger), true)
            }
            FileSurface::Analytic(kind) => {
                let apart = places.map(|place| kind.distance(self.point(place)).unwrap_or(f64::INFINITY));
                let (s, t) = self.part.place(0.5, 0.5);
                let (middle, normal) = (self.surface.point(s, t), self.surface.normal(s, t));
                let outward = normal.zip(outward(kind, middle)).is_some_and(|(n, out)| n.dot(out) > 0.0);
                (apart.fold(0.0, larger), outward)
            }
        };
        require(file.same_sense == (outward == outer_side), "a face has the wrong orientation")?;
        Ok(distance)
    }

    /// The file's edge against one of its sides, which is this border.
    pub(super) fn edge_deviation(&self, side: Side, border: Border, edge: &FileEdge) -> f64 {
        let mut largest = 0.0_f64;
        for (i, p) in (0..PLACES).zip(self.along(side)) {
            let along = border.turned(parameter(i));
            largest = larger(
                largest,
                match &edge.curve {
                    FileCurve::Piece(ChainPiece::Arc(arc)) => arc.closest_point(p).distance,
                    FileCurve::Piece(ChainPiece::Spline(curve)) => curve.point(along).distance(p),
                    FileCurve::Circle(_) => f64::INFINITY,
                },
            );
            if i == 0 || i + 1 == PLACES {
                largest = larger(largest, edge.ends[usize::from(along > 0.5)].distance(p));
            }
        }
        let (start, end) = match &edge.curve {
            FileCurve::Piece(ChainPiece::Arc(arc)) => (arc.start(), arc.end()),
            FileCurve::Piece(ChainPiece::Spline(curve)) => (curve.point(0.0), curve.point(1.0)),
            FileCurve::Circle(circle) => (circle.start(), circle.start()),
        };
        larger(largest, larger(start.distance(edge.ends[0]), end.distance(edge.ends[1])))
    }
}

/// Holds an edge against its face's surface at equal parameters of the edge, as readers do: on the curve that the file has
/// in the surface's parameters; without one they interpolate, which is exact where the parameters are proportional.
pub(super) fn check_parameters(
    surface: &RationalBezierSurface,
    (side, border): (Side, Border),
    edge: &FileEdge,
    size: f64,
) -> Result<(), Mismatch> {
    let arc = match (&edge.curve, &edge.parameter_curve) {
        (FileCurve::Piece(ChainPiece::Arc(arc)), _) => arc,
        (FileCurve::Piece(ChainPiece::Spline(_)), None) => return Ok(()), // in the parameter of its faces, and compared there
        (FileCurve::Piece(ChainPiece::Spline(curve)), Some(on_face)) => {
            return check_proportional(surface, curve, on_face, size);
        }
        (FileCurve::Circle(_), _) => return Err(Mismatch("a full circle in the boundary of a rational face")),
    };
    // Far from the origin the file's points are as coarse as their numbers.
    let rounding = ROUNDING * arc.start().to_vec().max_abs().max(arc.end().to_vec().max_abs());
    if let Some(curve) = &edge.parameter_curve {
        // Short edges carry the rounding of their place.
        let (range, unit) = arc.radius().map_or((arc.length(), 1.0), |radius| (arc.angle(), radius));
        let (from, to) = curve.domain();
        require(
            from == 0.0 && (to - range).abs() <= 1e-9 * range + rounding / unit,
            "the range of a parameter curve differs from that of its edge",
        )?;
    }
    let places = (0..PLACES).map(|i| {
        let x = parameter(i);
        let on_curve = edge.parameter_curve.as_ref().map(|curve| curve.point(x));
        let (u, v) = on_curve.map_or_else(|| side.place(border.turned(x)), |at| (at.x, at.y));
        surface.point(u, v).distance(arc.point_at_length(x))
    });
    let (of_length, of_size) = PARAMETER_LIMIT;
    let apart = places.fold(0.0, larger);
    let limit = of_length * arc.length() + of_size * size + rounding;
    // Corners of a net may be off their circle by so much: along a side as short as that the weights disagree.
    let short = arc.length() <= SHORT_EDGE * size;
    require(
        apart <= limit || (short && apart <= arc.length()),
        "an edge and its curve on the face differ at equal parameters",
    )
}

/// The same of an analytic surface: rational edges have curves in the parameters of cylinders and cones, arcs in those of spheres; others
/// readers find, as circles and lines are parameter lines.
pub(super) fn check_on_analytic(kind: &PatchKind, edge: &FileEdge, size: f64) -> Result<(), Mismatch> {
    let none_needed = "a parameter curve on a surface that needs none";
    let Some(on_face) = &edge.parameter_curve else { return Ok(()) };
    let (frame, radius, slope) = match kind {
        PatchKind::Cylinder { frame, radius, .. } => (frame, *radius, 0.0),
        PatchKind::Cone { frame, radius, half_angle, .. } => (frame, *radius, half_angle.tan()),
        PatchKind::Sphere { frame, radius, .. } => {
            let FileCurve::Piece(ChainPiece::Arc(arc)) = &edge.curve else { return Err(Mismatch(none_needed)) };
            let on_sphere = |at: Point3| {
                let ((sin, cos), (up, out)) = (at.x.sin_cos(), at.y.sin_cos());
                frame.to_world(Point2::new(radius * out * cos, radius * out * sin)) + frame.z() * (radius * up)
            };
            let (from, to) = on_face.domain();
            let same_range = from == 0.0 && (to - arc.angle()).abs() <= 1e-9 * to;
            require(same_range, "the range of a parameter curve differs from that of its edge")?;
            return check_near(size, arc.start(), |x| {
                on_sphere(on_face.point_at_knot(to * x)).distance(arc.point_at_length(x))
            });
        }
        _ => return Err(Mismatch(none_needed)),
    };
    let FileCurve::Piece(ChainPiece::Spline(curve)) = &edge.curve else { return Err(Mismatch(none_needed)) };
    // Angle and height along the axis.
    let round_axis = |at: Point3| {
        let ((sin, cos), from_axis) = (at.x.sin_cos(), radius + slope * at.y);
        frame.to_world(Point2::new(from_axis * cos, from_axis * sin)) + frame.z() * at.y
    };
    check_where(round_axis, curve, on_face, size)
}

/// Holds a rational edge against its face's rational surface where the file says that it runs.
fn check_proportional(
    surface: &RationalBezierSurface,
    curve: &NurbsCurve,
    on_face: &NurbsCurve,
    size: f64,
) -> Result<(), Mismatch> {
    check_where(|at| surface.point(at.x, at.y), curve, on_face, size)
}

/// Holds a rational edge against a surface at the parameters that the file gives.
fn check_where(
    surface: impl Fn(Point3) -> Point3,
    curve: &NurbsCurve,
    on_face: &NurbsCurve,
    size: f64,
) -> Result<(), Mismatch> {
    let [range, on_face_range] = [curve, on_face].map(NurbsCurve::domain);
    require(range == on_face_range, "the range of a parameter curve differs from that of its edge")?;
    check_near(size, curve.point_at_knot(range.0), |x| {
        let x = range.0 + (range.1 - range.0) * x;
        surface(on_face.point_at_knot(x)).distance(curve.point_at_knot(x))
    })
}

/// Requires a distance of an edge from its face at fractions of the edge's parameter to be rounding.
fn check_near(size: f64, start: Point3, apart: impl Fn(f64) -> f64) -> Result<(), Mismatch> {
    let rounding = ROUNDING * start.to_vec().max_abs();
    let apart = (0..PLACES).map(|i| apart(parameter(i))).fold(0.0, larger);
    require(
        apart <= PARAMETER_LIMIT.1 * size + rounding,
        "an edge and its curve on the face differ at equal parameters",
    )
}

fn parameter(i: u32) -> f64 {
    f64::from(i) / f64::from(PLACES - 1)
}
