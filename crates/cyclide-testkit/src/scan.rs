//! The scan of the examples: a stone with a hollow for the thumb as a scanner sees it, triangles without order and a little noise.

use cyclide::{Point3, Vec3, construct::ConvexPolyhedron};
use std::f64::consts::PI;
use std::fmt::Write;

use crate::attack::Random;

/// Noise of the scanner, millimeters.
const NOISE: f64 = 0.04;

/// Points and triangles of a mesh.
pub type Mesh = (Vec<Point3>, Vec<[usize; 3]>);

/// A place of the stone in millimeters, by a direction: an egg with a hollow on its upper side.
fn place(v: Vec3) -> Vec3 {
    let off = v - Vec3::new(-0.35, 0.1, 0.93);
    let hollow = 11.0 * (-4.0 * off.length_squared()).exp();
    let height = 21.0 + 4.0 * v.x + 1.5 * (3.0 * v.y).sin() - hollow;
    Vec3::new(40.0 * v.x + 3.0 * v.y * v.y, (28.0 + 5.0 * v.x) * v.y, height * v.z)
}

/// A closed mesh of `2 count - 4` triangles. The vertices lie a little irregularly, and off the stone by noise.
///
/// # Panics
/// If there are fewer than 4 vertices.
#[must_use]
#[allow(clippy::expect_used, reason = "points of a sphere have a hull")]
pub fn scan(count: usize) -> Mesh {
    let mut random = Random::new(11, count as u64);
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    // About a tenth of the distance between neighbors.
    let jitter = 0.35 / (count as f64).sqrt();
    let directions: Vec<Vec3> = (0..count)
        .map(|k| {
            let z = 1.0 - (2.0 * k as f64 + 1.0) / count as f64;
            let (sine, cosine) = (golden * k as f64).sin_cos();
            let rim = (1.0 - z * z).sqrt();
            let v = Vec3::new(rim * cosine, rim * sine, z) + random_vector(&mut random) * jitter;
            v.unit().expect("not the centre")
        })
        .collect();
    let sphere: Vec<Point3> = directions.iter().map(|v| Point3::ORIGIN + *v).collect();
    let hull = ConvexPolyhedron::hull_with_flatness(&sphere, 1e-12).expect("points of a sphere");
    let fans = hull.faces().iter().flat_map(|face| face.windows(2).skip(1).map(|w| [face[0], w[0], w[1]]));
    let triangles = fans.collect();
    let off = |random: &mut Random| random_vector(random) * NOISE;
    (directions.iter().map(|v| Point3::ORIGIN + place(*v) + off(&mut random)).collect(), triangles)
}

fn random_vector(random: &mut Random) -> Vec3 {
    Vec3::new(random.normal(), random.normal(), random.normal())
}

/// The scan as PLY text, coordinates in hundredths of a millimeter.
#[must_use]
pub fn scan_ply(count: usize) -> String {
    let (points, triangles) = scan(count);
    let mut text = format!(
        "ply\nformat ascii 1.0\ncomment a stone with a hollow for the thumb, millimetres; written by `cargo xtask scan`\n\
         element vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        points.len(),
        triangles.len()
    );
    for p in points {
        // Adding 0 turns -0 into 0.
        let _ = writeln!(text, "{:.2} {:.2} {:.2}", p.x + 0.0, p.y + 0.0, p.z + 0.0);
    }
    for [a, b, c] in triangles {
        let _ = writeln!(text, "3 {a} {b} {c}");
    }
    text
}
