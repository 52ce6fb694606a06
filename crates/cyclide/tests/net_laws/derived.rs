//! Offsets, thick shells, Möbius images, singular patches.

use crate::data::{PLACES, cyclide_grid, gap, generic_grid, inverted, kink, nets};
use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    error::{PartError, PatchError},
    surface::{CyclidicNet, DupinCyclide, NetFrame, ParamSurface},
    topology::{Body, Shell, surface_joints},
};
use proptest::prelude::*;
use std::ops::Range;
use std::sync::LazyLock;

/// Largest coordinate and largest patch: what rounding is relative to.
fn size(net: &CyclidicNet) -> f64 {
    net.grid().points().iter().map(|p| p.to_vec().length()).fold(0.0, f64::max)
}

fn places() -> impl Iterator<Item = (f64, f64)> {
    PLACES.iter().flat_map(|&s| PLACES.map(|t| (s, t)))
}

#[test]
fn offsets_move_every_point_along_its_normal_and_back() {
    for (name, net) in nets() {
        let h = 0.05;
        let offset = net.offset(h).unwrap();
        for (p, q) in net.patches().zip(offset.patches()) {
            for (s, t) in places() {
                let want = p.point(s, t) + p.unit_normal(s, t) * h;
                // The patches are in space to 1e-13; the weights are the same doubles.
                assert!(q.point(s, t).distance(want) < 1e-12 * size(&net), "{name}");
                assert!((q.unit_normal(s, t) - p.unit_normal(s, t)).length() < 1e-15, "{name}");
            }
        }
        assert!(offset.flipped_patches().is_empty() && offset.singular_patches().is_empty(), "{name}");
        let back = offset.offset(-h).unwrap();
        for (p, q) in net.grid().points().iter().zip(back.grid().points()) {
            assert!(p.distance(*q) < 4e-16 * size(&net), "{name}");
        }
        assert!(gap(&offset) < 1e-13 * size(&net) && kink(&offset) < 1e-12, "{name}");
    }
}

proptest! {
    #[test]
    fn offsets_have_the_same_weights_and_frame(which in 0..6usize, parts in [-1.5..1.5, -1.5..1.5]) {
        static NETS: LazyLock<Vec<(&'static str, CyclidicNet)>> = LazyLock::new(nets);
        let (name, net) = &NETS[which];
        let mut before = net.clone();
        for part in parts {
            let h = part * net.patch(0, 0).size();
            let offset = before.offset(h).unwrap();
            // Bit for bit, and again for the offset of an offset: all weights, those after one turn, and the frame.
            let [m, n] = net.grid().size().map(|k| 0..k);
            let round = |k: Range<usize>, d: usize| if net.grid().closed()[d] { k.start..2 * k.end } else { k };
            for (i, j) in round(n, 1).flat_map(|j| round(m.clone(), 0).map(move |i| (i, j))) {
                let bits = |net: &CyclidicNet| net.weight(i, j).to_array().map(f64::to_bits);
                prop_assert_eq!(bits(&offset), bits(net), "{} ({}, {})", name, i, j);
                // It is another net: the vertex moved by the distance, rounded like a turned normal and coordinates.
                if net.grid().index(i, j) == i + j * net.grid().size()[0] {
                    let (p, q) = (before.grid().point(i, j), offset.grid().point(i, j));
                    let far = p.to_vec().max_abs().max(h.abs());
                    prop_assert!((p.distance(q) - h.abs()).abs() <= 16.0 * f64::EPSILON * far, "{}", name);
                }
            }
            let bits = |net: &CyclidicNet| net.frame().map(|v| v.to_array().map(f64::to_bits));
            prop_assert_eq!(bits(&offset), bits(net), "{}", name);
            before = offset;
        }
    }
}

#[test]
fn offsets_of_cyclides_are_those_with_another_mu() {
    let d = DupinCyclide::new(2.0, 0.7, 1.1).unwrap();
    for h in [0.3, -0.2, 1.5] {
        let (by_net, by_mu) = (d.nets([4, 4]).unwrap().remove(0).offset(h).unwrap(), d.offset(h).unwrap());
        let [a, c, mu] = by_mu.parameters();
        for patch in by_net.patches() {
            for (s, t) in places() {
                let v = patch.point(s, t).to_vec();
                let b2 = (a - c) * (a + c);
                let (g, x) = (v.length_squared() + b2 - mu * mu, a * v.x - c * mu);
                let f = g * g - 4.0 * x * x - 4.0 * b2 * v.y * v.y;
                // A quartic of terms up to (2a + mu)^4.
                assert!(f.abs() < 1e-13 * (2.0 * a + mu).powi(4), "{h}: {f:e}");
            }
        }
    }
}

#[test]
fn beyond_the_focal_surface_patches_flip() {
    // The tube of the ring has radii between mu - c and mu + c: inwards by more, it turns inside out.
    let net = DupinCyclide::new(2.0, 0.7, 1.1).unwrap().nets([4, 4]).unwrap().remove(0);
    assert!(net.offset(-0.39).unwrap().flipped_patches().is_empty());
    assert_eq!(net.offset(-1.9).unwrap().flipped_patches().len(), 16);
    let error = net.thick(-1.0).unwrap_err();
    assert_eq!(error.reason(), "offset-not-regular");
    let cyclide::Error::Part(PartError::InQuad { quad, cause }) = error else { panic!("in a quad") };
    let cyclide::Error::Patch(PatchError::OffsetNotRegular { limit, .. }) = *cause else { panic!("a limit") };
    // The limit is where it begins: a millionth less is made, a millionth more is not.
    let patch = net.patches().nth(quad).unwrap();
    assert!(
        limit < -0.39
            && patch.offset_is_regular(limit * (1.0 - 1e-6))
            && !patch.offset_is_regular(limit * (1.0 + 1e-6))
    );
    let half = net.offset(-1.0).unwrap();
    assert!(!half.singular_patches().is_empty());
    for found in half.singular_patches() {
        let patch = half.patch(found.quad[0], found.quad[1]);
        for s in found.singular_s {
            assert!(patch.point(s, 0.1).distance(patch.point(s, 0.9)) < 1e-14);
        }
        assert!(found.singular_t.is_empty());
    }
}

/// Volume of the layer over the patches by their curvatures, exact: `∫∫ h - (k1 + k2) h²/2 + k1 k2 h³/3 dA`, for the
/// convention `N_s = -k1 f_s`, under which the area element at height z is `(1 - k1 z)(1 - k2 z)`.
pub fn layer(net: &CyclidicNet, h: f64) -> f64 {
    let nodes =
        [(0.046_910_077_030_668, 0.118_463_442_528_094_5), (0.230_765_344_947_158_45, 0.239_314_335_249_683_23)];
    let rule: Vec<(f64, f64)> = nodes
        .iter()
        .flat_map(|&(x, w)| [(x, w), (1.0 - x, w)])
        .chain([(0.5, 0.284_444_444_444_444_4)])
        .flat_map(|(x, w)| (0..4).map(move |k| ((f64::from(k) + x) / 4.0, w / 4.0)))
        .collect();
    let mut sum = 0.0;
    for patch in net.patches() {
        for &(s, u) in &rule {
            for &(t, v) in &rule {
                let (k1, k2) = (patch.k1(t), patch.k2(s));
                let height = h - (k1 + k2) * h * h / 2.0 + k1 * k2 * h * h * h / 3.0;
                sum += u * v * patch.jet(s, t).area_element() * height;
            }
        }
    }
    // Below for h < 0: the volume is positive.
    sum.abs()
}

#[test]
fn thick_nets_are_closed_solids_outwards() {
    for (name, net) in nets() {
        for h in [0.03, -0.05] {
            let body: Body = net.thick(h).unwrap();
            assert!(body.is_solid(), "{name}");
            let volume: f64 = body.shells().map(|s| s.volume()).sum();
            assert!(body.outer.volume() > 0.0, "{name}");
            let want = layer(&net, h);
            // Gauss rules of 20 × 20 points per patch.
            assert!((volume - want).abs() < 1e-9 * want, "{name} {h}: {volume} {want}");
            let ([m, n], closed) = (net.size(), net.grid().closed());
            if closed == [true, true] {
                assert_eq!((body.voids.len(), body.voids[0].faces().len()), (1, m * n), "{name}");
                assert!(body.voids[0].volume() < 0.0, "{name}: the outer side of a void is in the hollow");
            } else {
                let rim = if closed[0] { 0 } else { 2 * n } + if closed[1] { 0 } else { 2 * m };
                assert_eq!((body.voids.len(), body.outer.faces().len()), (0, 2 * m * n + rim), "{name}");
                // A closed surface of genus 0, or a torus if one direction is closed.
                let euler = body.outer.vertices().len() + body.outer.faces().len();
                let genus = if closed == [false; 2] { 2 } else { 0 };
                assert_eq!(euler, body.outer.edges().len() + genus, "{name}");
            }
        }
        assert_eq!(net.thick(0.0).unwrap_err().reason(), "parameter-out-of-range");
        assert_eq!(net.thick(f64::NAN).unwrap_err().reason(), "not-finite");
    }
}

#[test]
fn rims_are_ruled_by_the_normals() {
    let net = CyclidicNet::new(generic_grid([5, 4]), NetFrame::Auto).unwrap();
    let h = 0.1;
    let body = net.thick(h).unwrap();
    let ([m, n], faces) = (net.size(), body.outer.faces());
    // After both skins come the rims of the sides t=0 and t=1, quad by quad.
    for i in 0..m {
        for (k, t) in [(0, 0.0), (1, 1.0)] {
            let rim = &faces[2 * m * n + 2 * i + k].surface.patch().unwrap();
            let patch = net.patch(i, if k == 0 { 0 } else { n - 1 });
            for (s, x) in places() {
                let want = patch.point(s, t) + patch.unit_normal(s, t) * (h * x);
                assert!(rim.point(s, x).distance(want) < 1e-14);
            }
            // Developable, with straight lines across.
            assert!(PLACES.iter().all(|&s| rim.k2(s).abs() < 1e-14));
        }
    }
}

#[test]
fn a_lobe_has_no_rim() {
    let horn = DupinCyclide::new(1.0, 0.5, 0.2).unwrap().nets([4, 4]).unwrap();
    assert_eq!(horn[0].thick(0.01).unwrap_err().reason(), "collapsed-side");
}

#[test]
fn images_of_nets_are_nets_of_images() {
    let turn = Mobius::similarity(Quat::new(1.0, 2.0, -1.0, 0.5), 0.3, Vec3::X).unwrap();
    let inversion = Mobius::inversion(Point3::new(0.3, 0.4, 9.0), 3.0).unwrap();
    let mirror = Mobius::reflection(Point3::new(1.0, 2.0, 3.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
    for (name, net) in nets() {
        for map in [turn, inversion, mirror, turn.after(&inversion)] {
            let image = net.transformed(&map).unwrap();
            for (p, q) in net.patches().zip(image.patches()) {
                for (s, t) in places() {
                    let want = map.map_point(p.point(s, t)).unwrap();
                    assert!(q.point(s, t).distance(want) < 1e-12 * size(&image), "{name}");
                }
            }
            assert!(gap(&image) < 1e-13 * size(&image) && kink(&image) < 1e-12, "{name}");
            assert_eq!(image.to_shell().unwrap().is_closed(), net.to_shell().unwrap().is_closed());
            // The same net from the images of the points and of the frame.
            let at = net.grid().point(0, 0);
            let [v1, v2] = [0, 1].map(|k| map.push_forward(at, net.vertex_frame(0, 0)[k]).unwrap().unit().unwrap());
            let other = CyclidicNet::new(image.grid().clone(), NetFrame::First(v1, v2)).unwrap();
            let ([m, n], _) = (image.size(), ());
            for (i, j) in [(0, 0), (m / 2, n / 2), (m - 1, n - 1)] {
                for (x, y) in image.vertex_frame(i, j).into_iter().zip(other.vertex_frame(i, j)) {
                    assert!((x - y).length() < 1e-11, "{name}");
                }
            }
        }
    }
    let net = &nets()[0].1;
    let on_it = Mobius::inversion(net.patch(2, 3).point(0.4, 0.3), 1.0).unwrap();
    let error = net.transformed(&on_it).unwrap_err();
    assert_eq!((error.reason(), error.index()), ("patch-through-infinity", Some(2 + 3 * net.size()[0])));
}

#[test]
fn vertices_at_infinity_are_refused_to_rounding() {
    // The vertex at th = ps = 0 is at mu (c - a)/(a - c) + a + c = 38, but for rounding.
    let net = DupinCyclide::new(50.0, 20.0, 32.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let vertex = Point3::new(38.0, 0.0, 0.0);
    for k in 0..net.grid().points().len() {
        let vertex = if k == 0 { vertex } else { net.grid().points()[k] };
        // Along the normal, so that no other point of the surface is nearer.
        let patch = net.patch(k % 4, k / 4);
        for beside in [0.0, 1e-13, 1e-9] {
            let center = vertex + patch.unit_normal(0.0, 0.0) * beside;
            let error = net.transformed(&Mobius::inversion(center, 10.0).unwrap()).unwrap_err();
            let refused = ["point-at-infinity", "patch-through-infinity"];
            assert!(refused.contains(&error.reason()), "{k} {beside}: {error}");
        }
    }
    let on_it = |net: &CyclidicNet| net.transformed(&Mobius::inversion(vertex, 10.0).unwrap()).unwrap_err();
    assert_eq!((on_it(&net).reason(), on_it(&net).index()), ("point-at-infinity", Some(0)));
    // One part in a hundred thousand away, what comes back is what went in, and in space.
    let beside = Mobius::inversion(vertex + Vec3::X * 1e-3, 10.0).unwrap();
    let image = net.transformed(&beside).unwrap();
    let back = image.transformed(&beside).unwrap();
    for (p, q) in net.grid().points().iter().zip(back.grid().points()) {
        // Rounding of the image's 1e5, which is the inverse of 1e-3 in a sphere of radius 10, through the map's 1e-6
        // and 100 times its own size at the other vertices: 1e-16 (1e5)² / 100.
        assert!(p.distance(*q) < 1e-7, "{p:?} {q:?}");
    }
    assert!(gap(&image) < 1e-13 * size(&image));
}

#[test]
fn lobes_keep_their_nodes_under_inversion() {
    let map = Mobius::inversion(Point3::new(0.3, 0.4, 5.0), 3.0).unwrap();
    for lobe in DupinCyclide::new(1.0, 0.3, 1.2).unwrap().nets([4, 4]).unwrap() {
        let shell = lobe.transformed(&map).unwrap().to_shell().unwrap();
        assert!(shell.is_closed() && shell.volume() > 0.0);
        assert_eq!(shell.faces().iter().flat_map(|f| f.sides).filter(Option::is_none).count(), 8);
    }
}

#[test]
fn the_automatic_frame_leaves_no_patch_singular_where_others_leave_hundreds() {
    let ring = cyclide_grid([2.0, 0.7, 1.1], [41, 41], [false; 2]);
    let grids = [inverted(&ring, Point3::new(0.4, 0.5, 2.6), 1.5), generic_grid([41, 41])];
    for grid in grids {
        let auto = CyclidicNet::new(grid.clone(), NetFrame::Auto).unwrap();
        assert_eq!(auto.size(), [40, 40]);
        assert_eq!(auto.singular_patches().len(), 0);
        assert_eq!(auto.flipped_patches().len(), 0);
        for patch in auto.patches() {
            for (s, t) in places() {
                let jet = patch.jet(s, t);
                let cosine = jet.ds.dot(jet.dt) / (jet.ds.length() * jet.dt.length());
                assert!(patch.real_residual(s, t) < 1e-12 * patch.size() && cosine.abs() < 1e-12, "{s} {t}");
            }
        }
        let joints = surface_joints(&auto.to_shell().unwrap());
        assert_eq!(joints.len(), 2 * 39 * 40);
        assert!(joints.iter().all(|joint| joint.angle < 1e-12 && joint.gap < 1e-13));
        let mut weights = auto.patches().flat_map(|patch| patch.weights()).map(|w| w.norm());
        assert!(weights.all(|length| (0.3..3.0).contains(&length)));
        // Frames that have nothing to do with the grid. All of them make a net: none is refused, all are counted.
        let mut counts: Vec<usize> = (0..15)
            .map(|k| {
                let x = f64::from(k);
                let normal = Vec3::new((1.3 * x).sin(), (2.1 * x).cos(), (0.7 * x + 1.0).sin()).unit().unwrap();
                let v1 = normal.cross(Vec3::new((3.1 * x).cos(), 0.2, (1.7 * x).sin())).unit().unwrap();
                let net = CyclidicNet::new(grid.clone(), NetFrame::First(v1, normal.cross(v1))).unwrap();
                net.singular_patches().len()
            })
            .collect();
        counts.sort_unstable();
        assert!(counts[7] >= 100, "{counts:?}");
    }
}

#[test]
fn the_frame_of_a_cyclide_gives_the_cyclide_back() {
    let parameters = [2.0, 0.7, 1.1];
    let net = CyclidicNet::new(cyclide_grid(parameters, [8, 7], [true, true]), NetFrame::Auto).unwrap();
    let [a, c, mu] = parameters;
    // e_th and e_ps at the first vertex, by `docs/math/cyclides-and-nets.md#cyclides-by-parameters`; both angles there
    // are 0.2 (+ the uneven spacing, 0 at 0).
    let ((st, ct), (sp, cp)) = (0.2_f64.sin_cos(), 0.2_f64.sin_cos());
    let (b, den) = (((a - c) * (a + c)).sqrt(), a - c * ct * cp);
    let v1 = Vec3::new(-b * st, a * ct - c * cp, -c * st * sp) / den;
    let v2 = Vec3::new(b * ct * sp, a * st * sp, c * ct - a * cp) / den;
    let own = CyclidicNet::new(net.grid().clone(), NetFrame::First(v1, v2)).unwrap();
    let implicit = |p: Point3| {
        let (v, b2) = (p.to_vec(), b * b);
        let (g, x) = (v.length_squared() + b2 - mu * mu, a * v.x - c * mu);
        (g * g - 4.0 * x * x - 4.0 * b2 * v.y * v.y).abs()
    };
    for patch in own.patches() {
        for (s, t) in places() {
            // A quartic of terms up to (2a + mu)^4 = 676.
            assert!(implicit(patch.point(s, t)) < 1e-12 * 676.0);
        }
    }
    // Closed with an odd number of edges along t, the automatic frame has v2 along the lines of curvature, as it must.
    let [_, e2, _] = net.vertex_frame(0, 0);
    assert!((e2 - v2).length() < 1e-12);
}

#[test]
fn offsets_with_nodes_fall_apart_into_lobes() {
    let net = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([4, 4]).unwrap().remove(0);
    assert_eq!(net.to_shells().unwrap(), [net.to_shell().unwrap()]);
    // A horn with its nodes on edges and inside patches, a spindle.
    for (distance, on_edges) in [(-2.0, true), (-1.5, false), (3.0, false)] {
        let offset = net.offset(distance).unwrap();
        assert_eq!(offset.to_shell().map_err(|e| e.reason()).err(), on_edges.then_some("not-a-shell"));
        let lobes = offset.to_shells().unwrap();
        let whole = DupinCyclide::new(4.0, 1.0, 2.0 + distance).unwrap().to_bodies([4, 4]).unwrap();
        assert_eq!(lobes.len(), 2);
        let by_volume = |mut shells: Vec<Shell>| {
            shells.sort_by(|a, b| a.volume().total_cmp(&b.volume()));
            shells
        };
        let whole = by_volume(whole.into_iter().map(|body| body.outer).collect());
        for (lobe, whole) in by_volume(lobes).iter().zip(&whole) {
            assert!(
                lobe.is_closed()
                    && lobe.parts().len() == 1
                    && lobe.faces().iter().all(|f| f.surface.patch().unwrap().is_regular())
            );
            assert!((lobe.volume() / whole.volume() - 1.0).abs() < 1e-12, "{distance}: {}", lobe.volume());
            assert!((lobe.area() / whole.area() - 1.0).abs() < 1e-12, "{distance}: {}", lobe.area());
            let (v, e, f) = (lobe.vertices().to_vec(), lobe.edges().to_vec(), lobe.faces().to_vec());
            assert_eq!(&Shell::new(v, e, f).unwrap(), lobe);
        }
    }
}
