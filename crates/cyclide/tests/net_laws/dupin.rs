//! Whole cyclides against their implicit equation, their closed form and formula (C).

use crate::data::{HORNS, PLACES, RINGS, SPINDLES, gap, kink};
use cyclide::{CyclideKind, CyclidePatch, DupinCyclide, Frame, ParamSurface, Point3, Vec3};
use std::f64::consts::PI;

fn all() -> impl Iterator<Item = DupinCyclide> {
    RINGS.iter().chain(&HORNS).chain(&SPINDLES).map(|&[a, c, mu]| DupinCyclide::new(a, c, mu).unwrap())
}

/// `|F|/|grad F|` of the implicit quartic, a distance; the points are of size `a`.
fn distance(d: &DupinCyclide, p: Point3) -> f64 {
    let ([a, c, mu], v) = (d.parameters(), p.to_vec());
    let b2 = (a - c) * (a + c);
    let (g, x) = (v.length_squared() + b2 - mu * mu, a * v.x - c * mu);
    let f = g * g - 4.0 * x * x - 4.0 * b2 * v.y * v.y;
    let gradient = v * (4.0 * g) - Vec3::new(8.0 * a * x, 8.0 * b2 * v.y, 0.0);
    f.abs() / gradient.length()
}

#[test]
fn kinds() {
    use CyclideKind::{Horn, Ring, Spindle};
    for (list, kind) in [(&RINGS[..], Ring), (&HORNS[..], Horn), (&SPINDLES[..], Spindle)] {
        for &[a, c, mu] in list {
            assert_eq!(DupinCyclide::new(a, c, mu).unwrap().kind(), kind, "{a} {c} {mu}");
        }
    }
}

#[test]
fn points_satisfy_the_implicit_equation() {
    for d in all() {
        let [a, c, mu] = d.parameters();
        let size = a + c + mu;
        for net in d.nets([4, 6]).unwrap() {
            // The gradient vanishes in nodes, where F/|grad F| says nothing: places next to them are left out.
            for (patch, s, t) in
                net.patches().flat_map(|p| [0.3, 0.5, 0.7].map(|s| [0.4, 0.5, 0.6].map(|t| (p, s, t)))).flatten()
            {
                let off = distance(&d, patch.point(s, t));
                let nearness = size / (size.min(patch.jet(s, t).area_element().sqrt()));
                assert!(off <= 2e-15 * size * nearness * nearness, "{d:?}: {off:e}");
            }
        }
    }
}

#[test]
fn rings_agree_with_the_patches_of_their_corners_and_frames() {
    for &[a, c, mu] in &RINGS {
        let net = DupinCyclide::new(a, c, mu).unwrap().nets([5, 7]).unwrap().remove(0);
        let [m, n] = net.size();
        for (i, j) in (0..n).flat_map(|j| (0..m).map(move |i| (i, j))) {
            let patch = net.patch(i, j);
            let [v1, v2, normal] = net.vertex_frame(i, j);
            let other = CyclidePatch::from_corners_and_frame(patch.corners(), v1, v2).unwrap();
            // Same corners, same frames, same edges; only the speeds along the edges differ.
            for (s, t) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
                for (x, y) in patch.moving_frame(s, t).into_iter().zip(other.moving_frame(s, t)) {
                    assert!((x - y).length() < 1e-11, "{a} {c} {mu}: {:e}", (x - y).length());
                }
            }
            for (x, y) in [(patch.s_line(0.0), other.s_line(0.0)), (patch.t_line(1.0), other.t_line(1.0))] {
                let (x, y) = (x.unwrap(), y.unwrap());
                assert!((x.bulge_vector() - y.bulge_vector()).length() < 1e-11);
            }
            assert!((normal - patch.unit_normal(0.0, 0.0)).length() < 1e-15);
        }
    }
}

#[test]
fn rings_are_closed_and_have_positive_weights() {
    for &[a, c, mu] in &RINGS {
        for segments in [[4, 4], [3, 5], [8, 6]] {
            let d = DupinCyclide::new(a, c, mu).unwrap();
            let net = d.nets(segments).unwrap().remove(0);
            let floor = (a - c) / a * (PI / 4.0).cos().powi(2);
            for patch in net.patches() {
                assert!(patch.is_regular());
                let smallest = patch.real_weights().into_iter().flatten().fold(f64::INFINITY, f64::min);
                // W >= (a - c) ka ka', and ka >= cos(pi/4) for steps up to pi/2 (`20`, section 4).
                assert!(smallest >= floor * (1.0 - 1e-12), "{smallest:e} {floor:e}");
            }
            let shell = net.to_shell().unwrap();
            assert!(shell.is_closed());
            let (m, n) = (net.size()[0], net.size()[1]);
            assert_eq!((shell.vertices().len(), shell.edges().len(), shell.faces().len()), (m * n, 2 * m * n, m * n));
            assert!(gap(&net) <= 1e-14 * (a + c + mu));
            // The pairs of neighbours are the same doubles; each evaluates its normal with a few roundings.
            assert!(kink(&net) <= 1e-14);
        }
    }
}

#[test]
fn volumes_and_areas_of_tori_are_those_of_pappus() {
    let (a, mu) = (3.0, 1.0);
    let torus = DupinCyclide::new(a, 0.0, mu).unwrap().to_shell().unwrap();
    assert!((torus.volume() - 2.0 * PI * PI * a * mu * mu).abs() < 1e-11);
    assert!((torus.area() - 4.0 * PI * PI * a * mu).abs() < 1e-11);
    // A spindle torus: its two bodies by the integral of the slices, x from the axis: the circle about (a, 0) of
    // radius r turned round the axis; inner volume 2 pi ∫ x (2 sqrt(r² - (x+a)²)) over 0 <= x <= r-a.
    let (a, r) = (1.0, 1.5_f64);
    let bodies = DupinCyclide::new(a, 0.0, r).unwrap().to_bodies([4, 4]).unwrap();
    let [inner, outer] = [&bodies[0], &bodies[1]].map(|b| b.outer.volume());
    let integral = |shift: f64, to: f64| {
        // Midpoint rule in x = to - u², which takes the root away from the end.
        let steps = 20_000;
        let top = to.sqrt();
        (0..steps)
            .map(|k| {
                let u = top * (f64::from(k) + 0.5) / f64::from(steps);
                let x = to - u * u;
                4.0 * PI * x * (r * r - (x - shift).powi(2)).max(0.0).sqrt() * 2.0 * u * top / f64::from(steps)
            })
            .sum::<f64>()
    };
    // The midpoint rule of 20,000 steps is good to 1e-8.
    assert!((inner - integral(-a, r - a)).abs() < 1e-7, "{inner} {}", integral(-a, r - a));
    assert!((outer - integral(a, r + a)).abs() < 1e-7, "{outer} {}", integral(a, r + a));
}

#[test]
fn horns_and_spindles_are_closed_parts_that_touch_in_their_nodes() {
    for d in HORNS.iter().chain(&SPINDLES).map(|&[a, c, mu]| DupinCyclide::new(a, c, mu).unwrap()) {
        let [a, c, mu] = d.parameters();
        let horn = d.kind() == CyclideKind::Horn;
        let one_node = mu.to_bits() == a.to_bits() || mu.to_bits() == c.to_bits();
        let nets = d.nets([4, 4]).unwrap();
        assert_eq!(nets.len(), if one_node { 1 } else { 2 });
        let nodes = if horn {
            let y = (d.parameters()[0].powi(2) - c * c).sqrt() * (1.0 - (mu / c).powi(2)).max(0.0).sqrt();
            [-1.0, 1.0].map(|sign| Point3::new(a * mu / c, sign * y, 0.0))
        } else {
            let z = ((a - c) * (a + c)).sqrt() / a * (mu * mu - a * a).max(0.0).sqrt();
            [1.0, -1.0].map(|sign| Point3::new(c * mu / a, 0.0, sign * z))
        };
        for net in &nets {
            let size = net.grid().size();
            let [first, last] = [
                net.grid().point(0, 0),
                net.grid().point(if horn { size[0] - 1 } else { 0 }, if horn { 0 } else { size[1] - 1 }),
            ];
            let far = |p: Point3| nodes.iter().map(|q| q.distance(p)).fold(f64::INFINITY, f64::min);
            // The node angle is an arc cosine: its rounding grows with the square root near the end.
            assert!(far(first) < 1e-8 * a && far(last) < 1e-8 * a, "{first:?} {last:?} {nodes:?}");
            for patch in net.patches() {
                assert!(patch.is_regular(), "{d:?}: {:?} {:?}", patch.singular_s(), patch.singular_t());
                assert!(patch.real_weights().into_iter().flatten().all(|w| w > 0.0));
            }
            let shell = net.to_shell().unwrap();
            assert!(shell.is_closed());
            assert!(shell.volume() > 0.0);
            // As many vertices as a sphere with its poles: V - E + F = 2.
            assert_eq!(shell.vertices().len() + shell.faces().len(), shell.edges().len() + 2);
            let poles = shell.faces().iter().flat_map(|f| f.sides).filter(Option::is_none).count();
            assert_eq!(poles, 2 * size[usize::from(horn)], "every line into a node has a side of one point");
            assert!(gap(net) <= 1e-14 * (a + c + mu) && kink(net) <= 1e-14);
        }
    }
}

#[test]
fn a_placed_cyclide_is_the_same_in_its_frame() {
    let frame = Frame::from_normal(Point3::new(1.0, -2.0, 3.0), Vec3::new(0.3, -0.5, -2.0), Vec3::new(-1.0, 1.0, 0.2));
    let frame = frame.unwrap();
    let here = DupinCyclide::new(2.0, 0.7, 1.1).unwrap();
    let there = here.placed(frame);
    let (here, there) = (here.nets([4, 4]).unwrap().remove(0), there.nets([4, 4]).unwrap().remove(0));
    for (p, q) in here.patches().zip(there.patches()) {
        for (s, t) in PLACES.iter().flat_map(|&s| PLACES.map(|t| (s, t))) {
            let p = p.point(s, t);
            let moved = frame.origin() + frame.x() * p.x + frame.y() * p.y + frame.z() * p.z;
            assert!(moved.distance(q.point(s, t)) < 2e-14);
        }
    }
}

#[test]
fn parameters_out_of_range_are_refused() {
    for [a, c, mu] in
        [[1.0, 1.0, 0.5], [1.0, 2.0, 0.5], [0.0, 0.0, 1.0], [1.0, -0.1, 0.5], [1.0, 0.2, -0.1], [1.0, 0.0, 0.0]]
    {
        assert_eq!(DupinCyclide::new(a, c, mu).unwrap_err().reason(), "parameter-out-of-range", "{a} {c} {mu}");
    }
    assert_eq!(DupinCyclide::new(1.0, f64::NAN, 0.5).unwrap_err().reason(), "not-finite");
    let ring = DupinCyclide::new(1.0, 0.2, 0.5).unwrap();
    assert_eq!(ring.nets([2, 4]).unwrap_err().reason(), "parameter-out-of-range");
    assert_eq!(DupinCyclide::new(1.0, 0.5, 0.2).unwrap().to_shell().unwrap_err().reason(), "not-a-shell");
    assert_eq!(ring.offset(-0.6).unwrap_err().reason(), "parameter-out-of-range");
    assert_eq!(ring.offset(-0.4).unwrap().kind(), CyclideKind::Horn);
}
