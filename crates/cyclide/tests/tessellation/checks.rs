//! What every mesh must be.

use cyclide::{
    Point3, Vec3,
    mesh::{MeshFace, SurfaceMesh},
    surface::ParamSurface,
    topology::{Body, Shell},
};
use std::collections::HashMap;

/// The corners' positions.
pub fn polygon(mesh: &SurfaceMesh, face: &MeshFace) -> Vec<Point3> {
    face.corners().iter().map(|c| mesh.positions[c.position]).collect()
}

/// Distance from a point to a triangle.
fn triangle_distance(p: Point3, [a, b, c]: [Point3; 3]) -> f64 {
    let segment = |a: Point3, b: Point3| {
        let l2 = (b - a).length_squared();
        let x = if l2 > 0.0 { ((p - a).dot(b - a) / l2).clamp(0.0, 1.0) } else { 0.0 };
        p.distance(a.lerp(b, x))
    };
    let edges = segment(a, b).min(segment(b, c)).min(segment(c, a));
    let Some(n) = (b - a).cross(c - a).unit() else { return edges };
    let inside = [(a, b), (b, c), (c, a)].iter().all(|&(u, v)| (v - u).cross(p - u).dot(n) >= 0.0);
    if inside { (p - a).dot(n).abs().min(edges) } else { edges }
}

/// Distance from a point to a convex polygon.
pub fn polygon_distance(p: Point3, corners: &[Point3]) -> f64 {
    let fan = corners.windows(2).skip(1).map(|w| triangle_distance(p, [corners[0], w[0], w[1]]));
    fan.fold(f64::INFINITY, f64::min)
}

/// The shells of bodies, counted through.
pub fn shells(body: &Body) -> Vec<&Shell> {
    body.shells().collect()
}

/// Largest distance of sampled points of the surface from the polygon of their cell, and of points of the polygons from the
/// surface, with `n + 1` places each way in every cell. Both are upper bounds of the distances meant: from the nearest polygon, to the
/// nearest point.
pub fn deviation(body: &Body, mesh: &SurfaceMesh, n: u32) -> [f64; 2] {
    let shells = shells(body);
    let mut worst = [0.0_f64; 2];
    for (face, source) in mesh.faces.iter().zip(&mesh.sources) {
        let patch = shells[source.shell].faces()[source.face].surface.patch().unwrap();
        let corners = polygon(mesh, face);
        let [[s0, s1], [t0, t1]] = [source.s, source.t];
        // Corners of the cell as bilinear ones of the polygon; a triangle repeats one.
        let places = [(s0, t0), (s1, t0), (s0, t1), (s1, t1)];
        let nearest =
            |q: Point3| corners.iter().copied().min_by(|a, b| a.distance(q).total_cmp(&b.distance(q))).unwrap();
        let quad = places.map(|(s, t)| nearest(patch.point(s, t)));
        for k in 0..(n + 1) * (n + 1) {
            let [x, y] = [k % (n + 1), k / (n + 1)].map(|k| f64::from(k) / f64::from(n));
            let (s, t) = (s0 + (s1 - s0) * x, t0 + (t1 - t0) * y);
            worst[0] = worst[0].max(polygon_distance(patch.point(s, t), &corners));
            let p = quad[0].lerp(quad[1], x).lerp(quad[2].lerp(quad[3], x), y);
            let distance = surface_distance(patch, p, s, t);
            // The steps may run off in a large cell: they then start at the nearest of its places.
            let distance = if distance <= mesh.bound {
                distance
            } else {
                let places = (0..=400).map(|k| (f64::from(k % 20) / 20.0, f64::from(k / 20) / 20.0));
                let places = places.map(|(x, y)| (s0 + (s1 - s0) * x, t0 + (t1 - t0) * y));
                let from = |&(s, t): &(f64, f64)| patch.point(s, t).distance(p);
                let (s, t) = places.min_by(|a, b| from(a).total_cmp(&from(b))).unwrap();
                distance.min(surface_distance(patch, p, s, t)).min(descent_distance(patch, p, s, t))
            };
            worst[1] = worst[1].max(distance);
        }
    }
    worst
}

/// Distance from a point to the surface near parameters: steps along the orthogonal parameter lines.
fn surface_distance(patch: &dyn ParamSurface, p: Point3, mut s: f64, mut t: f64) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..12 {
        let jet = patch.jet(s, t);
        let off = p - jet.point;
        best = best.min(off.length());
        let step = |v: Vec3| {
            let l2 = v.length_squared();
            if l2 > 0.0 { off.dot(v) / l2 } else { 0.0 }
        };
        (s, t) = ((s + step(jet.ds)).clamp(0.0, 1.0), (t + step(jet.dt)).clamp(0.0, 1.0));
    }
    best
}

/// As [`surface_distance`], slower and never running off: of each step the part that comes nearest, as the speed changes much near
/// a pole.
pub fn descent_distance(patch: &dyn ParamSurface, p: Point3, mut s: f64, mut t: f64) -> f64 {
    let mut best = patch.point(s, t).distance(p);
    for _ in 0..40 {
        let jet = patch.jet(s, t);
        let off = p - jet.point;
        let along = |v: Vec3| {
            let l2 = v.length_squared();
            if l2 > 0.0 { off.dot(v) / l2 } else { 0.0 }
        };
        let (ds, dt) = (along(jet.ds), along(jet.dt));
        let parts = (0..12).map(|k| {
            let share = 0.5_f64.powi(k);
            let (s, t) = ((s + share * ds).clamp(0.0, 1.0), (t + share * dt).clamp(0.0, 1.0));
            (patch.point(s, t).distance(p), s, t)
        });
        let Some(next) = parts.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|next| next.0 < best) else { break };
        (best, s, t) = next;
    }
    best
}

/// How often each undirected edge of the mesh is used, and that its uses run in opposite directions.
pub fn edges(mesh: &SurfaceMesh) -> HashMap<(usize, usize), Vec<bool>> {
    let mut uses: HashMap<(usize, usize), Vec<bool>> = HashMap::new();
    for face in &mesh.faces {
        let c = face.corners();
        for k in 0..c.len() {
            let (a, b) = (c[k].position, c[(k + 1) % c.len()].position);
            assert_ne!(a, b, "an edge of one vertex");
            uses.entry((a.min(b), a.max(b))).or_default().push(a < b);
        }
    }
    uses
}

/// Fails unless the mesh is sound: two polygons at most and opposite ones on an edge, planar, none degenerate or reflex, every
/// vertex used, unit normals on the polygon's side, one source each, and no parameters of a face left out.
pub fn sound(name: &str, mesh: &SurfaceMesh) {
    sound_of(name, mesh, 1.0);
}

/// As [`sound`], of patches whose points are rounded `condition` times as much as their coordinates.
pub fn sound_of(name: &str, mesh: &SurfaceMesh, condition: f64) {
    for (edge, uses) in edges(mesh) {
        assert!(uses.len() == 1 || (uses.len() == 2 && uses[0] != uses[1]), "{name}: edge {edge:?} used {uses:?}");
    }
    let mut covered: HashMap<(usize, usize), f64> = HashMap::new();
    for source in &mesh.sources {
        let [s, t] = [source.s, source.t].map(|ends| ends[1] - ends[0]);
        *covered.entry((source.shell, source.face)).or_default() += s * t;
    }
    for (face, area) in covered {
        // Lines closer than 4e-9 that are points may share a cut.
        assert!((area - 1.0).abs() <= 1e-8, "{name}: {area} of the parameters of {face:?}");
    }
    let mut used = vec![false; mesh.positions.len()];
    assert_eq!(mesh.faces.len(), mesh.sources.len());
    for face in &mesh.faces {
        let p = polygon(mesh, face);
        let size = p.iter().map(|q| p[0].distance(*q)).fold(0.0, f64::max);
        let reach = p.iter().map(|q| q.to_vec().max_abs()).fold(0.0, f64::max);
        // Newell's normal: twice the area.
        let area = (1..p.len() - 1).map(|k| (p[k] - p[0]).cross(p[k + 1] - p[0])).fold(Vec3::ZERO, |a, b| a + b);
        assert!(area.length() > 0.0, "{name}: no area {p:?}");
        let n = area.unit().unwrap();
        for k in 0..p.len() {
            let (a, b, c) = (p[k], p[(k + 1) % p.len()], p[(k + 2) % p.len()]);
            assert!((b - a).cross(c - b).dot(n) > 0.0, "{name}: not strictly convex {p:?}");
            // Of the polygon's size, and the rounding of its coordinates.
            let off = (p[k] - p[0]).dot(n).abs();
            let allowed = 1e-12 * size + 1e-15 * reach * condition;
            assert!(off <= allowed, "{name}: {off:e} off its plane, size {size:e}, condition {condition:e}");
        }
        for corner in face.corners() {
            used[corner.position] = true;
            let normal = mesh.normals[corner.normal];
            assert!((normal.length() - 1.0).abs() < 1e-14, "{name}");
            // Arcs of a cell turn by 120 degrees at most, 60 to each side.
            assert!(normal.dot(n) > 0.0, "{name}: the normal is on the other side: {}", normal.dot(n));
        }
    }
    assert!(used.iter().all(|&u| u), "{name}: unused vertices");
}
