//! The free-form roof of the examples: a hall over a curved plan.

use cyclide::{Point3, surface::QuadGrid};
use std::f64::consts::PI;
use std::fmt::Write;

/// Radius of the plan's axis and half the angle it covers.
const AXIS: (f64, f64) = (44.0, 0.62);
/// Half the angle of an arch.
const ARCH: f64 = 1.2;

/// A point of the roof in meters, `u` along and `v` across, both in `[-1, 1]`.
///
/// Arches stand across an arc in plan. Their span and height change along the hall, it swells towards one end, and the
/// crowns lean out over both entrances. Arches and lengthwise lines are near the curvature lines, as a designer
/// would lay them; the surface is neither a graph over the plan nor a product of two functions.
#[must_use]
pub fn roof_point(u: f64, v: f64) -> Point3 {
    let (radius, half_angle) = AXIS;
    let half_span = 10.0 + 2.2 * u * u + 1.4 * u;
    let height = 8.2 + 1.5 * (PI * (u + 0.25)).sin() + 1.2 * u * u;
    let angle = ARCH * v;
    let across = half_span * angle.sin() / ARCH.sin();
    let share = (angle.cos() - ARCH.cos()) / (1.0 - ARCH.cos());
    // Positive towards the ends, and more at the crown: the entrances lean out.
    let lean = 3.0 * u * u * u * share;
    let (sine, cosine) = (half_angle * u + lean / radius).sin_cos();
    Point3::new((radius - across) * sine, radius - (radius - across) * cosine, height * share)
}

/// The roof with `faces` times `faces` quads, coordinates rounded to a millimeter as drawings have them.
///
/// # Panics
/// If `faces` is 0.
#[must_use]
#[allow(clippy::expect_used, reason = "the points are finite and there are enough of them")]
pub fn roof(faces: usize) -> QuadGrid {
    let at = |k: usize| 2.0 * k as f64 / faces as f64 - 1.0;
    let millimetre = |x: f64| (1000.0 * x).round() / 1000.0;
    let point = |(i, j)| Point3::from(roof_point(at(i), at(j)).to_array().map(millimetre));
    let indices = (0..=faces).flat_map(|j| (0..=faces).map(move |i| (i, j)));
    QuadGrid::new(indices.map(point).collect(), [faces + 1; 2], [false; 2]).expect("a grid of at least one quad")
}

/// The roof as OBJ text.
#[must_use]
pub fn roof_obj(faces: usize) -> String {
    let grid = roof(faces);
    let mut text =
        format!("# Free-form roof of {faces} x {faces} quads, metres; written by `cargo xtask roof`\no roof\n");
    for p in grid.points() {
        // Adding 0 turns -0 into 0.
        let _ = writeln!(text, "v {:.3} {:.3} {:.3}", p.x + 0.0, p.y + 0.0, p.z + 0.0);
    }
    for j in 0..faces {
        for i in 0..faces {
            let [a, b, c, d] = grid.corners(i, j).map(|k| k + 1);
            let _ = writeln!(text, "f {a} {b} {d} {c}");
        }
    }
    text
}
