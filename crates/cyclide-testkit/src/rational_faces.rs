//! Bodies of rational faces that are no cyclides.

use cyclide::{
    Point3, Vec3,
    rational::{RationalBezier, RationalBezierSurface},
    topology::{Body, EdgeCurve, FaceEdge, Shell, ShellEdge, ShellFace, Side},
};

/// Homogeneous rows of the control points of a Bézier curve or surface.
type Rows = Vec<[f64; 4]>;

/// Two bicubic faces with uneven weights that meet G1 along an edge.
#[must_use]
pub fn smooth_pair() -> Shell {
    // Heights and weights of a grid of 4 by 7 control points; the fourth column is the common edge.
    let height = |i: usize, j: usize| 0.4 * (1.3 * i as f64 + 0.4).sin() * (0.9 * j as f64 - 0.2).cos();
    let weight = |i: usize, j: usize| 1.0 + 0.2 * (2.1 * i as f64 + 1.7 * j as f64).sin();
    let control = |i: usize, j: usize| {
        let w = weight(i, j);
        [(i as f64 - 1.0) * w, (j as f64 + 0.1 * i as f64) * w, height(i, j) * w, w]
    };
    let first: Rows = (0..16).map(|k| control(k / 4, k % 4)).collect();
    // The first column behind the edge continues the last one before it, also in its weights, by three quarters.
    let second: Rows = (0..16)
        .map(|k| {
            let (i, j) = (k / 4, k % 4);
            let (edge, before) = (first[4 * i + 3], first[4 * i + 2]);
            match j {
                0 => edge,
                1 => std::array::from_fn(|d| edge[d] + 0.75 * (edge[d] - before[d])),
                _ => control(i, j + 3),
            }
        })
        .collect();
    let surface = |rows: Rows| RationalBezierSurface::new([3, 3], rows);
    let Ok([first, second]) = [first, second].map(surface).into_iter().collect::<Result<Vec<_>, _>>().map(to_pair)
    else {
        unreachable!("finite rows of a bicubic surface")
    };
    let [a, b] = [first.corners(), second.corners()];
    // Corners of a surface by s + 2 t.
    let vertices = vec![a[0], a[1], a[2], a[3], b[2], b[3]];
    let side = |of: &RationalBezierSurface, side: Side| EdgeCurve::Rational(side_of(of, side));
    let edge = |start, end, curve| ShellEdge { start, end, curve };
    let edges = vec![
        edge(0, 1, side(&first, Side::Bottom)),
        edge(2, 3, side(&first, Side::Top)),
        edge(0, 2, side(&first, Side::Left)),
        edge(1, 3, side(&first, Side::Right)),
        edge(4, 5, side(&second, Side::Top)),
        edge(2, 4, side(&second, Side::Left)),
        edge(3, 5, side(&second, Side::Right)),
    ];
    let on = |edges: [usize; 4]| edges.map(|edge| Some(FaceEdge { edge, forward: true }));
    let face = |surface: RationalBezierSurface, sides| ShellFace { surface: surface.into(), sides, same_sense: true };
    let faces = vec![face(first, on([0, 1, 2, 3])), face(second, on([1, 4, 5, 6]))];
    shell(vertices, edges, faces)
}

/// The body of revolution of a cubic profile from one point of the z axis to another, in four faces of degree (3, 2): a
/// solid with two poles.
#[must_use]
pub fn egg() -> Body {
    // Radius, height, weight.
    let profile = [[0.0, -1.0, 1.0], [1.6, -1.0, 1.2], [1.1, 1.3, 0.9], [0.0, 1.5, 1.1]];
    let turned = |quarter: usize| -> Rows {
        let (sin, cos) = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][quarter % 4];
        profile.iter().map(|[r, z, w]| [r * cos * w, r * sin * w, z * w, *w]).collect()
    };
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let surface = |quarter: usize| {
        let (from, to) = (turned(quarter), turned(quarter + 1));
        // Between two rows the corner of the square round the quarter circle, with the weight of half its angle.
        let rows = from.iter().zip(&to).flat_map(|(a, b)| {
            let middle = [(a[0] + b[0]) * half, (a[1] + b[1]) * half, a[2] * half, a[3] * half];
            [*a, middle, *b]
        });
        RationalBezierSurface::new([3, 2], rows.collect())
    };
    let Ok(surfaces) = (0..4).map(surface).collect::<Result<Vec<_>, _>>() else {
        unreachable!("finite rows of degree (3, 2)")
    };
    let ends = surfaces[0].corners();
    let meridian =
        |k: usize| ShellEdge { start: 0, end: 1, curve: EdgeCurve::Rational(side_of(&surfaces[k], Side::Bottom)) };
    let edges: Vec<ShellEdge> = (0..4).map(meridian).collect();
    let sides = |k: usize| {
        let on = |edge: usize| Some(FaceEdge { edge, forward: true });
        [on(k), on((k + 1) % 4), None, None]
    };
    let faces = surfaces.iter().enumerate();
    // Along the profile times round the axis looks inwards.
    let faces = faces.map(|(k, s)| ShellFace { surface: s.clone().into(), sides: sides(k), same_sense: false });
    Body { outer: shell(vec![ends[0], ends[1]], edges.clone(), faces.collect()), voids: Vec::new() }
}

/// Radius and height of the profile of the [`egg`], with its derivative, at a parameter.
#[must_use]
pub fn egg_profile(x: f64) -> [f64; 4] {
    let outer = egg().outer;
    let jet = cyclide::curve::ParamCurve::piece_jet(&outer.edges()[0].curve, 0, x);
    let Vec3 { x: dr, z: dz, .. } = jet.d1;
    [jet.point.x, jet.point.z, dr, dz]
}

/// The curve on a side of a surface.
fn side_of(surface: &RationalBezierSurface, side: Side) -> RationalBezier {
    let (s, t) = side.place(0.0);
    if side.direction() == 0 { surface.s_line(t) } else { surface.t_line(s) }
}

fn to_pair(mut surfaces: Vec<RationalBezierSurface>) -> [RationalBezierSurface; 2] {
    let second = surfaces.remove(1);
    [surfaces.remove(0), second]
}

fn shell(vertices: Vec<Point3>, edges: Vec<ShellEdge>, faces: Vec<ShellFace>) -> Shell {
    match Shell::new(vertices, edges, faces) {
        Ok(shell) => shell,
        Err(error) => unreachable!("{error}"),
    }
}
