//! The surfaces of faces: planes, cylinders, cones, spheres and tori where the patch lies on one, planes, cylinders and cones where
//! a rational face does, else exact rational surfaces of one Bézier span.
//!
//! A face of a sphere is written as `SPHERICAL_SURFACE` only if its edges are meridians and parallels about one axis,
//! which is then the placement's: readers find parameter curves by interpolation, and edges that are no lines of the
//! parameters lose digits there (an octant with its poles elsewhere: parameter curves off by 3e-7 of the size, area by
//! 6e-9). The other faces of spheres, whose circles belong to two elliptic and hyperbolic pencils, stay rational, and
//! so do tori without a hole: `TOROIDAL_SURFACE` is for a smaller radius of the tube. The edges of patches of
//! all other kinds are lines of the parameters anyway; those of rational faces on cylinders and cones are written with their curves.
//! The seam is turned to the side away from the face.

use super::data::{Data, push_list, push_reference};
use super::polar_curves::PolarCurve;
use crate::export::options::StepEdges;
use crate::export::scaled_weights::scaled_weights;
use crate::text::number::push_step;
use cyclide::{
    Frame, Point3, Result, Vec3,
    curve::Arc,
    error::NurbsError,
    rational::RationalBezierSurface,
    surface::{CyclidePatch, ParamSurface as _, PatchKind},
    topology::{EdgeCurve, FaceSurface, Shell, ShellFace},
};
use std::fmt::Write as _;

/// Beyond this radius, in sizes of the model, an analytic surface loses digits: its points are the center plus the
/// radius, rounded.
const LARGEST_RADIUS: f64 = 1e4;
/// Cones at least this far from cylinders and planes, radians.
const SMALLEST_CONE_ANGLE: f64 = 1e-3;
/// The radius of a torus' hole is at least this part of its major radius.
const SMALLEST_HOLE: f64 = 1e-6;
/// Angle up to which circles of a sphere are parallel to, or contain, an axis.
const AXIS_LIMIT: f64 = 1e-10;

/// The surface of a face as it is written: the kind with its placement, of a rational face a plane, a cylinder, a cone or the
/// general one. Where rational edges are asked for, all but planes is rational: only there do rational edges have exact parameter curves.
pub(super) fn kind(shell: &Shell, face: &ShellFace, size: f64, edges: StepEdges) -> PatchKind {
    let patch = match &face.surface {
        FaceSurface::Cyclide(patch) => patch,
        FaceSurface::Rational(surface) => return rational_kind(shell, face, surface, size, edges),
    };
    let kind = patch.recognize();
    let keep = match kind {
        PatchKind::Plane { .. } => true,
        _ if edges == StepEdges::Rational => false,
        PatchKind::Cylinder { .. } | PatchKind::Cone { .. } => has_good_radius(&kind, size),
        // A torus that crosses itself has another entity, which few systems read, and whose two parts they confuse; one
        // that meets itself is such a torus or not by rounding.
        PatchKind::Torus { major_radius, minor_radius, .. } => {
            major_radius - minor_radius >= SMALLEST_HOLE * major_radius && major_radius <= LARGEST_RADIUS * size
        }
        PatchKind::Sphere { frame, radius, outward } => {
            let center = frame.origin();
            let axis = (radius <= LARGEST_RADIUS * size).then(|| axis(shell, face, center, radius)).flatten();
            let away = center - patch.point(0.5, 0.5);
            let frame = axis.and_then(|axis| Frame::from_normal(center, axis, away).ok());
            return frame.map_or(PatchKind::Cyclide, |frame| PatchKind::Sphere { frame, radius, outward });
        }
        PatchKind::Cyclide => false,
    };
    if keep { kind } else { PatchKind::Cyclide }
}

/// The surface of a face as part of a larger one; `own` is that as it is written for itself. Spheres are such about any axis.
pub(super) fn whole_kind(face: &ShellFace, own: &PatchKind, size: f64, edges: StepEdges) -> PatchKind {
    if *own != PatchKind::Cyclide || edges == StepEdges::Rational {
        return *own;
    }
    let kind = match &face.surface {
        FaceSurface::Cyclide(patch) => patch.recognize(),
        FaceSurface::Rational(surface) => rational_sphere(surface).unwrap_or(PatchKind::Cyclide),
    };
    match kind {
        PatchKind::Sphere { radius, .. } if radius <= LARGEST_RADIUS * size => kind,
        _ => *own,
    }
}

/// The sphere of a rational face, about any axis.
fn rational_sphere(surface: &RationalBezierSurface) -> Option<PatchKind> {
    let (center, radius) = surface.sphere()?;
    let frame = Frame::from_normal(center, Vec3::Z, Vec3::X).ok()?;
    Some(PatchKind::Sphere { frame, radius: radius.abs(), outward: radius > 0.0 })
}

/// Whether a cylinder or cone is neither too large to keep its digits nor too near to another kind.
fn has_good_radius(kind: &PatchKind, size: f64) -> bool {
    match kind {
        PatchKind::Cylinder { radius, .. } => *radius <= LARGEST_RADIUS * size,
        PatchKind::Cone { radius, half_angle, .. } => {
            let steep = std::f64::consts::FRAC_PI_2 - half_angle;
            *radius <= LARGEST_RADIUS * size && *half_angle >= SMALLEST_CONE_ANGLE && steep >= SMALLEST_CONE_ANGLE
        }
        _ => false,
    }
}

/// The same of a rational face. One on a cylinder or cone is written so only if all its rational edges have curves in the parameters of
/// that: readers do not find these well enough.
fn rational_kind(
    shell: &Shell,
    face: &ShellFace,
    surface: &RationalBezierSurface,
    size: f64,
    edges: StepEdges,
) -> PatchKind {
    let kind = match edges {
        StepEdges::Rational => surface.plane().map_or(PatchKind::Cyclide, |frame| PatchKind::Plane { frame }),
        StepEdges::Circles => surface.recognize(),
    };
    if matches!(kind, PatchKind::Plane { .. }) {
        return kind;
    }
    let is_followed = |curve: &EdgeCurve| match curve {
        EdgeCurve::Arc(_) => true,
        EdgeCurve::Rational(curve) => PolarCurve::of(curve, &kind, size).is_some(),
    };
    let mut curves = face.sides.iter().flatten().map(|side| &shell.edges()[side.edge].curve);
    if has_good_radius(&kind, size) && curves.all(is_followed) { kind } else { PatchKind::Cyclide }
}

/// The axis about which the edges of a spherical face are meridians and parallels, if there is one.
fn axis(shell: &Shell, face: &ShellFace, center: Point3, radius: f64) -> Option<Vec3> {
    let arc = |k: usize| face.sides[k].and_then(|side| shell.edges()[side.edge].curve.arc());
    let through_center = |arc: &Arc, normal: Vec3| (arc.start() - center).dot(normal).abs() <= AXIS_LIMIT * radius;
    [[0, 1, 2, 3], [2, 3, 0, 1]].into_iter().find_map(|[k, l, m, n]| {
        let (a, b) = (arc(k)?, arc(l)?);
        let (normal_a, normal_b) = (a.normal()?, b.normal()?);
        let meridians = through_center(a, normal_a) && through_center(b, normal_b);
        let axis = normal_a.cross(normal_b);
        // Narrow faces leave the axis undetermined by the rounding of the normals.
        let axis = if axis.length() > 1e-4 { axis.unit()? } else { return None };
        let parallel = |arc: &Arc| arc.normal().is_some_and(|normal| normal.cross(axis).length() <= AXIS_LIMIT);
        (meridians && [m, n].into_iter().filter_map(arc).all(parallel)).then_some(axis)
    })
}

/// The analytic surface of a kind, and whether its own normal is that of the patch, `f_s × f_t`; `None` for a rational
/// face.
pub(super) fn analytic(data: &mut Data, kind: &PatchKind) -> Option<(usize, bool)> {
    let (entity, frame, measures, outward) = match kind {
        PatchKind::Plane { frame } => ("PLANE", frame, [None; 2], true),
        PatchKind::Sphere { frame, radius, outward } => ("SPHERICAL_SURFACE", frame, [Some(*radius), None], *outward),
        PatchKind::Cylinder { frame, radius, outward } => {
            ("CYLINDRICAL_SURFACE", frame, [Some(*radius), None], *outward)
        }
        PatchKind::Cone { frame, radius, half_angle, outward } => {
            ("CONICAL_SURFACE", frame, [Some(*radius), Some(*half_angle)], *outward)
        }
        PatchKind::Torus { frame, major_radius, minor_radius, outward } => {
            ("TOROIDAL_SURFACE", frame, [Some(*major_radius), Some(*minor_radius)], *outward)
        }
        PatchKind::Cyclide => return None,
    };
    let placement = data.placement(frame.origin(), frame.z(), frame.x());
    let surface = data.write(|out| {
        // Writing to a string cannot fail.
        let _ = write!(out, "{entity}('',#{placement}");
        for measure in measures.into_iter().flatten() {
            out.push(',');
            push_step(out, measure);
        }
        out.push(')');
    });
    Some((surface, outward))
}

/// The patch as a rational B-spline surface. `middles` are the control points of the sides t=0, t=1, s=0, s=1, so that
/// neighbors share them; for a side of one point that point.
///
/// # Errors
/// `weight-not-positive`: no other weight is ever written.
pub(super) fn biquadratic(data: &mut Data, patch: &CyclidePatch, middles: [Point3; 4]) -> Result<usize> {
    let [a0, a1, a2, a3] = patch.corners();
    let [x, y, z, w] = patch.to_rational().rows()[4];
    let middle = Point3::new(x / w, y / w, z / w);
    let [bottom, top, left, right] = middles;
    // Outer lists along s, inner ones along t.
    let points = [a0, left, a2, bottom, middle, top, a1, right, a3];
    b_spline(data, [2, 2], &points, patch.real_weights().as_flattened())
}

/// A rational surface as it is.
///
/// # Errors
/// `weight-not-positive`: no other weight is ever written.
pub(super) fn rational(data: &mut Data, surface: &RationalBezierSurface) -> Result<usize> {
    let points: Vec<Point3> = surface.rows().iter().map(|[x, y, z, w]| Point3::new(x / w, y / w, z / w)).collect();
    let weights: Vec<f64> = surface.rows().iter().map(|row| row[3]).collect();
    b_spline(data, surface.degrees(), &points, &weights)
}

/// A rational B-spline surface of one Bézier span, a complex instance; control points and weights with t fastest.
fn b_spline(data: &mut Data, [p, q]: [usize; 2], points: &[Point3], weights: &[f64]) -> Result<usize> {
    let weights = scaled_weights(weights);
    for (index, &weight) in weights.iter().enumerate() {
        if !(weight > 0.0) {
            return Err(NurbsError::WeightNotPositive { index, weight }.into());
        }
    }
    let points: Vec<usize> = points.iter().map(|point| data.point(*point)).collect();
    Ok(data.write(|out| {
        // Writing to a string cannot fail.
        let _ = write!(out, "(BOUNDED_SURFACE() B_SPLINE_SURFACE({p},{q},");
        push_list(out, points.chunks(q + 1), |out, row| push_list(out, row.iter().copied(), push_reference));
        let _ = write!(
            out,
            ",.UNSPECIFIED.,.F.,.F.,.F.) \
             B_SPLINE_SURFACE_WITH_KNOTS(({m},{m}),({n},{n}),(0.,1.),(0.,1.),.UNSPECIFIED.) \
             GEOMETRIC_REPRESENTATION_ITEM() RATIONAL_B_SPLINE_SURFACE(",
            m = p + 1,
            n = q + 1
        );
        push_list(out, weights.chunks(q + 1), |out, row| push_list(out, row, |out, w| push_step(out, *w)));
        out.push_str(") REPRESENTATION_ITEM('') SURFACE())");
    }))
}

/// The middle control point of an arc below half a turn: where its end tangents meet.
pub(super) fn middle_point(arc: &Arc) -> Point3 {
    let ratio = arc.weight_ratio();
    arc.start().midpoint(arc.end()) + arc.chord().cross(ratio.vector()) * (0.5 / ratio.w)
}
