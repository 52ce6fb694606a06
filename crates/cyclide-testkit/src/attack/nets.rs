//! Nets over grids: regular, with random heights made circular, folded over, with cells that nearly vanish.

use super::{Objects, Random};
use serde_json::{Value, json};

pub(super) fn object(random: &mut Random) -> Objects {
    let (rows, columns) = (2 + random.below(4), 2 + random.below(4));
    let mut grid: Vec<Vec<[f64; 3]>> =
        (0..rows).map(|t| (0..columns).map(|s| [s as f64, t as f64, 0.0]).collect()).collect();
    let mut make_circular = false;
    match random.below(4) {
        // A rectangle of its own spacing in each direction stays circular.
        0 => {
            let (s, t) = (random.decades(-6.0, 3.0), random.decades(-6.0, 3.0));
            grid.iter_mut().flatten().for_each(|p| *p = [p[0] * s, p[1] * t, 0.0]);
        }
        1 => {
            let height = random.decades(-3.0, 0.0);
            grid.iter_mut().flatten().for_each(|p| p[2] = height * random.normal());
            make_circular = true;
        }
        2 => folded(random, &mut grid),
        // On a sphere or a torus every grid of its circles is circular.
        _ => on_sphere(random, &mut grid),
    }
    let mut object = json!({"type": "cyclidic-net", "grid": grid});
    if make_circular {
        object["make_circular"] = json!(true);
    }
    if random.chance(0.7) && !make_circular {
        object["frame"] = frame(random);
    }
    Objects::surface(object)
}

/// One corner nearly on another.
fn folded(random: &mut Random, grid: &mut [Vec<[f64; 3]>]) {
    let e = random.decades(-12.0, -1.0);
    let (last, column) = (grid.len() - 1, grid[0].len() - 1);
    grid[last][column][0] = grid[last][column - 1][0] + e;
}

fn on_sphere(random: &mut Random, grid: &mut [Vec<[f64; 3]>]) {
    let step = random.between(0.1, 0.6);
    for (t, row) in grid.iter_mut().enumerate() {
        for (s, p) in row.iter_mut().enumerate() {
            let (u, v) = (step * s as f64, -0.6 + step * t as f64);
            *p = [u.cos() * v.cos(), u.sin() * v.cos(), v.sin()];
        }
    }
}

fn frame(random: &mut Random) -> Value {
    let (u, v) = (random.vector(), random.vector());
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let part = dot(&u, &v) / dot(&u, &u);
    let v = [0, 1, 2].map(|i| v[i] - part * u[i]);
    json!([u, v])
}
