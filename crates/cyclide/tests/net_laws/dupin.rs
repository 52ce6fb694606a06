//! Whole cyclides against their implicit equation, their closed form and formula (C).

use crate::data::{HORNS, PLACES, RINGS, SPINDLES, gap, kink};
use cyclide::{
    Frame, Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    surface::{CyclideKind, CyclidePatch, DupinCyclide, ParamSurface},
    topology::surface_joints,
};
use std::f64::consts::PI;

fn all() -> impl Iterator<Item = DupinCyclide> {
    RINGS.iter().chain(&HORNS).chain(&SPINDLES).map(|&[a, c, mu]| DupinCyclide::new(a, c, mu).unwrap())
}

/// `|F|/|grad F|` of the implicit quartic, a distance; the points are of size `a`.
fn distance(d: &DupinCyclide, p: Point3) -> f64 {
    let (in_plane, height) = d.frame().to_local(p);
    let ([a, c, mu], v) = (d.parameters(), Vec3::new(in_plane.x, in_plane.y, height));
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
                // W >= (a - c) ka ka', and ka >= cos(pi/4) for steps up to pi/2
                // (`docs/math/cyclides-and-nets.md#weights-of-a-whole-cyclide`).
                assert!(smallest >= floor * (1.0 - 1e-12), "{smallest:e} {floor:e}");
            }
            let shell = net.to_shell().unwrap();
            assert!(shell.is_closed());
            let (m, n) = (net.size()[0], net.size()[1]);
            assert_eq!((shell.vertices().len(), shell.edges().len(), shell.faces().len()), (m * n, 2 * m * n, m * n));
            assert!(gap(&net) <= 1e-14 * (a + c + mu));
            // The pairs of neighbors are the same doubles; each evaluates its normal with a few roundings.
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
fn normals_of_all_parts_are_outward() {
    for d in all() {
        for net in d.nets([4, 4]).unwrap() {
            assert!(net.flipped_patches().is_empty(), "{d:?}");
            for patch in net.patches() {
                // Where both nodes are one its speed has a double zero, up to rounding.
                assert!(patch.q1().into_iter().chain(patch.q2()).all(|q| q >= -1e-15 * patch.size()), "{d:?}");
                assert!(patch.normal(0.4, 0.6).unwrap().dot(patch.unit_normal(0.4, 0.6)) > 0.0);
            }
            // Not turned round to be outward.
            let shell = net.to_shell().unwrap();
            assert!(shell.volume() > 0.0 && shell.faces().iter().all(|face| face.same_sense), "{d:?}");
        }
    }
}

#[test]
fn nodes_are_known_with_the_finite_curvatures_beside_them() {
    for d in all() {
        let ([_, c, mu], kind) = (d.parameters(), d.kind());
        for (part, net) in d.nets([4, 4]).unwrap().into_iter().enumerate() {
            let (mut nodes, mut range) = ([0, 0], [f64::INFINITY, f64::NEG_INFINITY]);
            for patch in net.patches() {
                nodes[0] += patch.node_s().len();
                nodes[1] += patch.node_t().len();
                let [low, high] = patch.k2_range();
                range = [range[0].min(low), range[1].max(high)];
            }
            let want = match kind {
                CyclideKind::Ring => [0, 0],
                CyclideKind::Horn => [2 * net.size()[1], 0],
                CyclideKind::Spindle => [0, 2 * net.size()[0]],
            };
            assert_eq!(nodes, want, "{d:?}");
            // Towards a node of a horn the lines across bend more and more, away from the outward normal.
            assert_eq!(range[0].is_infinite(), kind == CyclideKind::Horn, "{d:?}: {range:?}");
            assert!(range[1].is_finite());
            if kind == CyclideKind::Horn {
                // k2 = -1/|mu - c cos th|, against the outward normal: flattest in the middle of each part.
                let middle = if part == 0 && net.patch(0, 0).corners()[1].to_vec().x > 0.0 && mu < c {
                    -1.0 / (c - mu)
                } else {
                    -1.0 / (c + mu)
                };
                assert!((range[1] / middle - 1.0).abs() < 1e-9, "{d:?} {part}: {range:?} {middle}");
            }
        }
    }
}

#[test]
fn nearly_singular_cyclides_have_no_edges_like_points_in_files() {
    // Its parts near the nodes have a size of 5e-8, and are cut where much larger ones have to be.
    let d = DupinCyclide::new(5.0, 4.999_999_9, 4.999_999_95).unwrap();
    let error = d.to_shell().unwrap().with_positive_weights().unwrap_err();
    assert_eq!(error.reason(), "short-edge", "{error}");
    // Still good.
    DupinCyclide::new(5.0, 4.99, 4.995).unwrap().to_shell().unwrap().with_positive_weights().unwrap();
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

/// Points of a cyclide off its nodes.
fn points(d: &DupinCyclide) -> Vec<Point3> {
    let patches = d.nets([6, 6]).unwrap().into_iter().flat_map(|net| net.patches().collect::<Vec<_>>());
    patches.flat_map(|p| [0.3, 0.7].map(|s| [0.4, 0.6].map(|t| p.point(s, t))).into_iter().flatten()).collect()
}

#[test]
fn images_are_whole_cyclides_through_the_images_of_points() {
    let kinds = |d: &DupinCyclide| d.kind() == CyclideKind::Ring;
    for d in all() {
        let [a, c, mu] = d.parameters();
        let size = a + c + mu;
        let frame = Frame::from_normal(Point3::new(0.2, -0.1, 0.4), Vec3::new(1.0, 2.0, 2.0), Vec3::X).unwrap();
        let d = d.placed(frame);
        let at = |x: f64, y: f64, z: f64| frame.origin() + Vec3::new(x, y, z) * size;
        let turn = Mobius::similarity(Quat::new(1.0, 2.0, -1.0, 0.5), 0.3, Vec3::X * size).unwrap();
        let mirror = Mobius::reflection(at(0.1, 0.2, 0.3), Vec3::new(1.0, 2.0, -2.0)).unwrap();
        // Outside, near the center, inside the tube (where a ring's families of spheres change places), far away.
        let tube = frame.origin() - frame.x() * (a + 0.2 * (mu + c)) + frame.z() * (0.3 * (mu + c));
        let centres = [at(1.0, 0.5, 2.0), at(0.03, 0.05, -0.02), tube, at(300.0, -200.0, 100.0)];
        let inversions = centres.map(|center| Mobius::inversion(center, size).unwrap());
        let both = [turn.after(&inversions[0]), inversions[0].after(&mirror), inversions[1].after(&inversions[0])];
        for map in [turn, mirror].into_iter().chain(inversions).chain(both) {
            let image = d.transformed(&map).unwrap();
            let [a1, c1, mu1] = image.parameters();
            let size1 = a1 + c1 + mu1;
            assert_eq!(kinds(&image), kinds(&d), "{d:?} {image:?}");
            let mut magnified_back = size;
            for p in points(&d) {
                let q = map.map_point(p).unwrap();
                // Rounding of the image, and of the point, which the map magnifies.
                let magnified = map.push_forward(p, Vec3::X).unwrap().length();
                let far = q.to_vec().max_abs() + size1;
                let bound = 1e-13 * (far + size * magnified);
                let off = distance(&image, q);
                assert!(off <= bound, "{d:?} {image:?}: {off:e} > {bound:e}");
                magnified_back = magnified_back.max(far / magnified);
            }
            // And back: what is small in the image is wrong by the rounding of all of it.
            let back = image.transformed(&map.inverse()).unwrap();
            for (p, q) in back.parameters().into_iter().zip(d.parameters()) {
                assert!((p - q).abs() <= 1e-13 * magnified_back, "{:?} {d:?}", back.parameters());
            }
        }
        // A similarity keeps the parameters up to its factor, and the place.
        let turned = d.transformed(&turn).unwrap();
        for (p, q) in turned.parameters().into_iter().zip(d.parameters()) {
            assert!((p - 0.3 * q).abs() <= 1e-14 * size);
        }
        let origin = turn.map_point(frame.origin()).unwrap();
        assert!(turned.frame().origin().distance(origin) <= 1e-14 * size);
    }
}

#[test]
fn cyclides_through_the_centre_have_no_bounded_image() {
    for d in all() {
        for p in points(&d).into_iter().step_by(7) {
            let refused = d.transformed(&Mobius::inversion(p, 1.0).unwrap()).unwrap_err().reason();
            assert!(["point-at-infinity", "parameter-out-of-range"].contains(&refused), "{refused}");
        }
    }
    let ring = DupinCyclide::new(2.0, 0.5, 1.0).unwrap();
    let on_it = Mobius::inversion(Point3::new(2.5, 0.0, 0.0), 1.0).unwrap();
    assert_eq!(ring.transformed(&on_it).unwrap_err().reason(), "point-at-infinity");
    // A torus becomes a torus by an inversion on its axis, and a ring again by one in its tube.
    let torus = DupinCyclide::new(2.0, 0.0, 1.0).unwrap();
    let on_the_axis = torus.transformed(&Mobius::inversion(Point3::ORIGIN, 3.0).unwrap()).unwrap();
    // The circles at distance 1 and 3 go to 9 and 3: (9 + 3)/2 and (9 - 3)/2.
    for (p, q) in on_the_axis.parameters().into_iter().zip([6.0, 0.0, 3.0]) {
        assert!((p - q).abs() <= 1e-14);
    }
    let in_the_tube = torus.transformed(&Mobius::inversion(Point3::new(2.0, 0.0, 0.0), 1.0).unwrap()).unwrap();
    assert_eq!(in_the_tube.kind(), CyclideKind::Ring);
}

#[test]
fn double_nodes_are_one_point_of_one_surface() {
    // mu = c, mu = a, the horn torus: the speed has a double zero, of which rounding makes two or none.
    let needle = [2.1741761016485346, 2.172001925546886, 2.1741761016485346];
    for [a, c, mu] in [[4.0, 1.0, 1.0], [50.0, 20.0, 20.0], [7.0, 2.0, 2.0], [2.0, 0.0, 2.0], [4.0, 1.0, 4.0], needle] {
        for segments in [[4, 4], [3, 9], [12, 12], [24, 12]] {
            for axis in [Vec3::Z, Vec3::new(-0.68, -0.36, 0.46)] {
                let place = Frame::from_normal(Point3::new(0.1, 0.2, 0.3), axis, Vec3::new(1.0, 2.0, 0.1)).unwrap();
                let nets = DupinCyclide::new(a, c, mu).unwrap().placed(place).nets(segments).unwrap();
                let [net] = nets.as_slice() else { panic!("{} nets", nets.len()) };
                let shells = net.to_shells().unwrap();
                assert_eq!((shells.len(), shells[0].faces().len()), (1, net.patches().count()), "{a} {c} {mu}");
                assert!(net.patches().all(|patch| patch.is_regular() && !patch.is_flipped()), "{a} {c} {mu}");
            }
        }
    }
}

#[test]
fn offsets_to_double_nodes_are_one_surface() {
    let place = Frame::from_normal(Point3::new(0.1, 0.2, 0.3), Vec3::new(1.0, 2.0, 3.0), Vec3::X).unwrap();
    for ([a, c, mu], segments, distance) in
        [([2.0, 0.0, 1.0], [12, 12], 1.0), ([4.0, 1.0, 1.9], [7, 5], -2.9), ([50.0, 45.0, 49.0], [12, 3], 1.0)]
    {
        let net = DupinCyclide::new(a, c, mu).unwrap().placed(place).nets(segments).unwrap().remove(0);
        let offset = net.offset(distance).unwrap();
        let shells = offset.to_shells().unwrap();
        assert_eq!(shells.len(), 1, "{a} {c} {mu}");
        let whole = DupinCyclide::new(a, c, (mu + distance).abs()).unwrap().nets(segments).unwrap();
        let whole: f64 = whole.iter().map(|net| net.to_shell().unwrap().volume()).sum();
        assert!((shells[0].volume() / whole - 1.0).abs() < 1e-11, "{} {whole}", shells[0].volume());
        // The normals have one side, at the node too.
        assert!(surface_joints(&shells[0]).iter().all(|joint| joint.angle < 1e-9), "{a} {c} {mu}");
    }
}
