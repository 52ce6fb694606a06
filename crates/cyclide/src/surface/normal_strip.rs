//! The strip that the normals of a surface make along a circular line of curvature, as of a beam along the edge of a net:
//! developable, unrolled exactly (`docs/math/surface-measures.md#strips-of-normals`).
//!
//! Along a line of curvature `N' = -k f'` with its normal curvature `k`, so that the strip `f + h N` has the metric
//! `(1 - k h)² ds² + dh²`: that of a ring about the place `h = 1/k`, of a rectangle for `k = 0`. In space a circle of radius
//! `r` whose normals lean against its plane by the angle `acos(|k| r)` gives a cone of revolution, a cylinder for `k = 0`,
//! and a flat ring for `|k| r = 1`.

use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ArcPath};
use crate::error::{Error, ErrorItem, NumberError, PatchError, Result};

/// Leaning (radians) by which normals may be out of the plane of their circle, or off its axis, and count as in it: beyond
/// the rounding of frames carried over a net, and far below what a strip as thick as paper would show. A normal that leans
/// from its edge by less has no direction.
const LEANING: f64 = 1e-9;
/// A strip is wider than this part of its edge.
const THINNEST: f64 = 1e-9;
/// Largest width, and largest distance from the edge.
const WIDEST: f64 = 1e150;

/// How a strip of normals is bent in space.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Arc, surface::{NormalStrip, StripForm}};
/// let parallel = Arc::from_center(Point3::ORIGIN, Vec3::Z, Point3::new(2.0, 0.0, 0.0), 1.0)?;
/// let form = NormalStrip::new(&parallel, Vec3::Z, [0.0, 0.5])?.form();
/// assert!(matches!(form, StripForm::Cylinder { radius } if (radius - 2.0).abs() < 1e-14));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum StripForm {
    /// In a plane: nothing is bent.
    Flat,
    /// On a cylinder of revolution.
    Cylinder {
        /// Radius.
        radius: f64,
    },
    /// On a cone of revolution.
    Cone {
        /// Angle between axis and rulings, radians, in (0, pi/2).
        half_angle: f64,
        /// Radii of both long edges, about the axis.
        radii: [f64; 2],
    },
}

/// The strip of normals along an edge, between two signed distances along them.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Arc, surface::NormalStrip};
/// // A rib under the parallel of a sphere of radius 2 at height 1: a cone.
/// let r = 3.0_f64.sqrt();
/// let edge = Arc::from_center(Point3::new(0.0, 0.0, 1.0), Vec3::Z, Point3::new(r, 0.0, 1.0), 1.0)?;
/// let strip = NormalStrip::new(&edge, Vec3::new(r, 0.0, 1.0) / 2.0, [-0.5, 0.0])?;
/// assert!((strip.curvature() + 0.5).abs() < 1e-15); // that of the sphere
/// let [inner, outer] = strip.lengths();
/// assert!((inner - 0.75 * r).abs() < 1e-14 && (outer - r).abs() < 1e-14);
/// assert!((strip.outline()?.length() - (inner + outer + 2.0 * 0.5)).abs() < 1e-14); // as long when it is laid flat
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalStrip {
    length: f64,
    curvature: f64,
    bend: f64,
    /// Cosine of the angle between the normals and the axis of the edge.
    along_axis: f64,
    heights: [f64; 2],
}

impl NormalStrip {
    /// Along an edge that is a line of curvature of its surface, with the normal of the surface at its start, between two
    /// distances along the normals, the lesser first.
    ///
    /// # Errors
    /// `not-finite`; `zero-axis` (a normal without length or along the edge); `parameter-out-of-range` (a width that is no
    /// width); `offset-not-regular` if the normals meet between the distances.
    pub fn new(edge: &Arc, normal: Vec3, heights: [f64; 2]) -> Result<Self> {
        for (index, height) in heights.into_iter().enumerate() {
            if !height.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::OffsetDistance, index }.into());
            }
        }
        let zero = || Error::zero_axis(ErrorItem::Normal);
        let tangent = edge.start_tangent().ok_or_else(zero)?;
        let across = normal - tangent * normal.dot(tangent);
        let normal = across.unit().filter(|_| across.length() > LEANING * normal.length()).ok_or_else(zero)?;
        let (length, value) = (edge.length(), heights[1] - heights[0]);
        let min = THINNEST * length;
        if !(value >= min && value <= WIDEST) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Depth, value, min, max: WIDEST }.into());
        }
        let binormal = edge.curvature_binormal();
        let (bend, curvature) = (binormal.length(), binormal.dot(tangent.cross(normal)));
        let along_axis = binormal.unit().map_or(0.0, |axis| axis.dot(normal));
        let strip = Self { length, curvature, bend, along_axis, heights };
        let beyond = |height: &&f64| curvature * **height >= 1.0;
        match heights.iter().find(beyond) {
            Some(&distance) => Err(PatchError::OffsetNotRegular { distance, limit: 1.0 / curvature }.into()),
            None => Ok(strip),
        }
    }

    /// Normal curvature of the edge, signed by the normal: the curvature that it has in the flat strip.
    #[must_use]
    pub const fn curvature(&self) -> f64 {
        self.curvature
    }

    /// The distances along the normals of both long edges.
    #[must_use]
    pub const fn heights(&self) -> [f64; 2] {
        self.heights
    }

    /// Lengths of both long edges: those of the edges of the parallel surfaces at these distances.
    #[must_use]
    pub fn lengths(&self) -> [f64; 2] {
        self.heights.map(|height| self.length * (1.0 - self.curvature * height))
    }

    /// Area of the strip.
    #[must_use]
    pub fn area(&self) -> f64 {
        let [a, b] = self.lengths();
        0.5 * (a + b) * (self.heights[1] - self.heights[0])
    }

    /// How it is bent in space.
    #[must_use]
    pub fn form(&self) -> StripForm {
        let across = self.curvature.abs();
        if self.bend == 0.0 || self.along_axis.abs() <= LEANING {
            return StripForm::Flat;
        }
        let radius = 1.0 / self.bend;
        if across <= LEANING * self.bend {
            return StripForm::Cylinder { radius };
        }
        let radii = self.heights.map(|height| radius * (1.0 - self.curvature * height));
        StripForm::Cone { half_angle: (across * radius).atan2(self.along_axis.abs()), radii }
    }

    /// Radii of both long edges of the flat strip; `None` for a rectangle.
    #[must_use]
    pub fn flat_radii(&self) -> Option<[f64; 2]> {
        let radii = self.heights.map(|height| (1.0 / self.curvature - height).abs());
        radii.iter().all(|radius| radius.is_finite()).then_some(radii)
    }

    /// The angle of the flat strip, radians; 0 for a rectangle.
    #[must_use]
    pub fn flat_angle(&self) -> f64 {
        (self.curvature * self.length).abs()
    }

    /// The strip laid flat in `z = 0`, exact: the long edge of the lesser distance from left to right, the end, the other long
    /// edge back, the start. The normal in the middle of the edge is the y-axis, the middle of the edge itself the origin.
    ///
    /// # Errors
    /// `nearly-full-circle`.
    pub fn outline(&self) -> Result<ArcPath> {
        let half = 0.5 * self.curvature * self.length;
        let (sin, cos) = half.sin_cos();
        // (s, (1 - cos ks)/k) at the ends, in forms that hold for k = 0.
        let (x, y) = (0.5 * self.length * over(half), 0.5 * self.length * over(0.5 * half) * (0.5 * half).sin());
        let ends = self.heights.map(|h| [-1.0, 1.0].map(|side| Point3::new(side * (x - h * sin), y + h * cos, 0.0)));
        let bulge = (0.5 * half).tan();
        let [[a, b], [d, c]] = ends;
        let long = |from, to, bulge| Arc::from_bulge(from, to, Vec3::Z, bulge);
        let arcs = vec![long(a, b, bulge)?, Arc::segment(b, c)?, long(c, d, -bulge)?, Arc::segment(d, a)?];
        ArcPath::new(arcs, true)
    }
}

/// `sin(x)/x`.
fn over(x: f64) -> f64 {
    // Next term x^4/120: below 1e-18.
    if x.abs() < 1e-4 { 1.0 - x * x / 6.0 } else { x.sin() / x }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{CyclidePatch, ParamSurface as _};

    /// A patch of a general cyclide.
    fn patch() -> CyclidePatch {
        let corners = [[-4.0, -3.0, 0.0], [4.0, -3.0, 0.0], [-3.0, 4.0, 0.0], [3.0, 4.0, 0.0]].map(Point3::from);
        CyclidePatch::from_corners_and_frame(corners, Vec3::new(8.0, -1.0, 4.0), Vec3::new(-1.0, 4.0, 3.0)).unwrap()
    }

    #[test]
    fn long_edges_are_those_of_the_parallel_surfaces() {
        let heights = [-0.35, 0.2];
        let patch = patch();
        let offsets = heights.map(|h| patch.offset(h).unwrap());
        let sides: [(_, f64); 2] = [(0.0, patch.k1(0.0)), (1.0, patch.k1(1.0))];
        for (t, k) in sides {
            let strip = NormalStrip::new(&patch.s_line(t).unwrap(), patch.unit_normal(0.0, t), heights).unwrap();
            assert!((strip.curvature() - k).abs() < 1e-13, "the principal curvature along the side");
            let want = offsets.map(|offset| offset.s_line(t).unwrap().length());
            let outline = strip.outline().unwrap();
            for (i, want) in want.into_iter().enumerate() {
                assert!((strip.lengths()[i] - want).abs() < 1e-13);
                assert!((outline.arcs()[2 * i].length() - want).abs() < 1e-13, "also when laid flat");
                assert!((outline.arcs()[2 * i + 1].length() - 0.55).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn distances_on_the_strip_are_kept() {
        // The diagonals of a fine net of the strip in space are as long as on the flat ring: it is unrolled without stretch.
        let (patch, heights, n) = (patch(), [-0.35, 0.2], 2000);
        let strip = NormalStrip::new(&patch.t_line(0.0).unwrap(), patch.unit_normal(0.0, 0.0), heights).unwrap();
        let edge = patch.t_line(0.0).unwrap();
        let place = |k: usize| edge.parameter_at_length(k as f64 / n as f64);
        let in_space = |k: usize, h: f64| patch.point(0.0, place(k)) + patch.unit_normal(0.0, place(k)) * h;
        let k = strip.curvature();
        let flat = |i: usize, h: f64| {
            let a = k * edge.length() * (i as f64 / n as f64 - 0.5);
            Point3::new((1.0 / k - h) * a.sin(), 1.0 / k - (1.0 / k - h) * a.cos(), 0.0)
        };
        for i in (0..n).step_by(97) {
            let (h0, h1) = (0.1, 0.1 + edge.length() / n as f64);
            let lengths = [in_space(i, h0).distance(in_space(i + 1, h1)), flat(i, h0).distance(flat(i + 1, h1))];
            // Chords differ from the ways on the surface by their cube.
            assert!((lengths[0] / lengths[1] - 1.0).abs() < 1e-6, "{lengths:?}");
        }
        let ends = [flat(0, heights[0]), flat(n, heights[0]), flat(n, heights[1]), flat(0, heights[1])];
        for (arc, end) in strip.outline().unwrap().arcs().iter().zip(ends) {
            assert!(arc.start().distance(end) < 1e-12);
        }
    }

    #[test]
    fn planes_cylinders_and_cones() {
        let edge = Arc::from_center(Point3::ORIGIN, Vec3::Z, Point3::new(2.0, 0.0, 0.0), 1.0).unwrap();
        let near = |found: [f64; 2], want: [f64; 2]| (0..2).all(|i| (found[i] - want[i]).abs() < 1e-14);
        let flat = NormalStrip::new(&edge, -Vec3::X, [0.0, 0.5]).unwrap();
        assert!(flat.form() == StripForm::Flat && (flat.curvature() - 0.5).abs() < 1e-15);
        assert!(near(flat.flat_radii().unwrap(), [2.0, 1.5]));
        let up = NormalStrip::new(&edge, Vec3::Z, [0.0, 0.5]).unwrap();
        let StripForm::Cylinder { radius } = up.form() else { panic!("normals are along the axis") };
        assert!((radius - 2.0).abs() < 1e-14 && near(up.lengths(), [2.0, 2.0]) && up.flat_radii().is_none());
        let lean = NormalStrip::new(&edge, Vec3::new(-1.0, 0.0, 1.0), [0.0, 0.5]).unwrap();
        let StripForm::Cone { half_angle, radii } = lean.form() else { panic!("normals lean") };
        assert!((half_angle - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
        assert!((radii[1] - (2.0 - 0.5 * 0.5_f64.sqrt())).abs() < 1e-14);
        let straight = Arc::segment(Point3::ORIGIN, Point3::new(0.0, 3.0, 0.0)).unwrap();
        let board = NormalStrip::new(&straight, Vec3::Z, [-0.1, 0.3]).unwrap();
        assert_eq!((board.form(), board.lengths(), board.flat_angle()), (StripForm::Flat, [3.0, 3.0], 0.0));
        assert!((board.area() - 1.2).abs() < 1e-15);
    }

    #[test]
    fn refused_widths() {
        let edge = Arc::from_center(Point3::ORIGIN, Vec3::Z, Point3::new(2.0, 0.0, 0.0), 1.0).unwrap();
        let reason = |normal, heights| NormalStrip::new(&edge, normal, heights).unwrap_err().reason();
        assert_eq!(reason(-Vec3::X, [0.0, 2.5]), "offset-not-regular");
        assert_eq!(reason(-Vec3::X, [0.5, 0.5]), "parameter-out-of-range");
        assert_eq!(reason(-Vec3::X, [0.0, f64::NAN]), "not-finite");
        assert_eq!(reason(Vec3::Y, [0.0, 1.0]), "zero-axis");
    }
}
