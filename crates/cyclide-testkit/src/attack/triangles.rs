//! Triangle meshes that are nearly flat, folded, with slivers, far away, with normals that point anywhere; and patches over one triangle
//! whose spheres nearly cancel.

use super::{Objects, Random};
use serde_json::{Value, json};

/// Vertices of a closed mesh: an octahedron with its triangles.
const OCTAHEDRON: [[usize; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];

pub(super) fn surface(random: &mut Random) -> Objects {
    if random.chance(0.3) { blend(random) } else { mesh(random) }
}

fn mesh(random: &mut Random) -> Objects {
    let size = random.decades(-6.0, 6.0);
    let place = if random.chance(0.3) { random.vector().map(|x| x * size * 1e4) } else { [0.0; 3] };
    let thin = if random.chance(0.3) { random.decades(-10.0, 0.0) } else { 1.0 };
    let noise = if random.chance(0.5) { random.decades(-12.0, 0.0) } else { 0.1 };
    let axes =
        [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let mut points: Vec<[f64; 3]> = Vec::with_capacity(axes.len());
    for axis in axes {
        let off = random.vector();
        points.push([0, 1, 2].map(|k| {
            let along = if k == 2 { thin } else { 1.0 };
            place[k] + size * along * (axis[k] + noise * off[k])
        }));
    }
    if random.chance(0.1) {
        let (a, b) = (random.below(points.len()), random.below(points.len()));
        points[a] = points[b].map(|x| x + size * random.normal() * random.decades(-16.0, -4.0));
    }
    let mut triangles = OCTAHEDRON.to_vec();
    // An open one, and one with a triangle turned over or added.
    if random.chance(0.3) {
        triangles.truncate(1 + random.below(7));
    }
    if random.chance(0.1) {
        let k = random.below(triangles.len());
        triangles[k].swap(0, 1);
    }
    let mut object = json!({"type": "smooth-mesh", "vertices": points, "triangles": triangles});
    match random.below(4) {
        0 => object["normals"] = json!("sphere"),
        1 => object["normals"] = Value::Array(points.iter().map(|_| json!(random.vector())).collect()),
        2 => object["crease_angle"] = json!(random.between(0.0, std::f64::consts::PI)),
        _ => {}
    }
    Objects { tolerance: Some(tolerance(random, size)), ..Objects::surface(object) }
}

fn blend(random: &mut Random) -> Objects {
    let size = random.decades(-6.0, 6.0);
    let corners = [0; 3].map(|_| random.vector().map(|x| size * x));
    let mut object = json!({"type": "sphere-blend", "corners": corners});
    if random.chance(0.5) {
        object["normals"] = json!([0; 3].map(|_| random.vector()));
    } else {
        let reach = size * random.decades(-8.0, 3.0);
        let near = random.below(3);
        object["control"] = json!([0; 3].map(|_| {
            let off = random.vector();
            [0, 1, 2].map(|k| corners[near][k] + reach * off[k])
        }));
    }
    Objects { tolerance: Some(tolerance(random, size)), ..Objects::surface(object) }
}

/// With the default tolerance wild ones have some hundred thousand triangles. Where they fold does not depend on it: most are coarse.
fn tolerance(random: &mut Random, size: f64) -> f64 {
    size * if random.chance(0.1) { 0.02 } else { 0.2 }
}
