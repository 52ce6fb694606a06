//! The plane of a torus: points, normals, tangents, the inverse, complex coordinates.

use crate::data::{modulo, places, rates, reach, tori};
use cyclide::{
    Point2, Point3, Quat, Vec2, Vec3,
    conformal::Mobius,
    surface::{ParamSurface, TorusClasses},
};
use cyclide_testkit::attack::Random;
use cyclide_testkit::torus_splines::off_torus;

/// Rounding of a few operations.
const ROUNDING: f64 = 1e-14;

#[test]
fn points_lie_on_the_torus_at_their_longitude() {
    for torus in tori() {
        for place in places() {
            let p = torus.point(place);
            assert!(off_torus(&torus, p) <= ROUNDING * reach(&torus), "{place:?}");
            let (plane, _) = torus.frame().to_local(p);
            let longitude = plane.y.atan2(plane.x);
            let turn = (longitude - 2.0 * place.x).rem_euclid(std::f64::consts::TAU);
            assert!(turn.min(std::f64::consts::TAU - turn) < 1e-12, "{turn}");
        }
    }
}

#[test]
fn angles_go_there_and_back() {
    for torus in tori() {
        for place in places() {
            let [longitude, meridian] = torus.angles_of_place(place);
            let back = torus.place_of_angles(longitude, meridian);
            // The meridian angle runs up to sqrt((a+b)/(a-b)), here 6.3, times as fast.
            assert!((back - place).length() < 1e-13, "{place:?} {back:?}");
            let (a, b) = (torus.major_radius(), torus.minor_radius());
            let (rho, z) = (a + b * meridian.cos(), b * meridian.sin());
            let f = torus.frame();
            let want = f.origin() + f.x() * (rho * longitude.cos()) + f.y() * (rho * longitude.sin()) + f.z() * z;
            assert!(torus.point(place).distance(want) < 1e-13 * reach(&torus));
        }
    }
}

#[test]
fn the_inverse_finds_the_place_modulo_half_turns() {
    for torus in tori() {
        for place in places() {
            let p = torus.point(place);
            let found = torus.locate(p, 1e-9 * reach(&torus)).unwrap();
            // At b/a = 0.95 the inner side is 6 times as wide in the plane as in space, twice that in its angle.
            assert!(modulo(found, place) < 1e-12, "{torus:?} {place:?} {found:?}");
        }
    }
}

#[test]
fn points_off_the_torus_go_to_the_nearest_ones() {
    for torus in tori() {
        for place in places() {
            // Not as far as the axis.
            let out = 0.3 * torus.minor_radius().min(torus.major_radius() - torus.minor_radius());
            let p = torus.point(place) + torus.unit_normal(place) * out;
            let off = modulo(torus.locate(p, 1.01 * out).unwrap(), place);
            assert!(off < 1e-12, "{torus:?} {place:?} {off:e}");
            assert_eq!(torus.locate(p, 0.99 * out).unwrap_err().reason(), "point-off-torus");
        }
    }
}

/// Tangents are conformal: `|v| = 2 rho sqrt(A'² + k² B'²)`, `k = b/c`, and the difference quotients say the same.
#[test]
fn tangents_are_derivatives_and_go_back() {
    for torus in tori() {
        let (a, b) = (torus.major_radius(), torus.minor_radius());
        let k = b / ((a - b) * (a + b)).sqrt();
        for place in places() {
            for rate in rates() {
                let v = torus.tangent(place, rate);
                let (plane, _) = torus.frame().to_local(torus.point(place));
                let conformal = 2.0 * plane.x.hypot(plane.y) * rate.x.hypot(k * rate.y);
                assert!((v.length() - conformal).abs() < 1e-12 * conformal + ROUNDING * reach(&torus));
                let h = 1e-6 / rate.length();
                let quotient = (torus.point(place + rate * h) - torus.point(place + rate * -h)) / (2.0 * h);
                // Central differences: h² times the third derivative, and rounding over h.
                assert!((quotient - v).length() < 1e-8 * rate.length() * reach(&torus), "{torus:?} {place:?}");
                assert!((torus.rate(place, v) - rate).length() < 1e-12 * rate.length());
                assert!(v.dot(torus.unit_normal(place)).abs() < 1e-13 * v.length());
            }
        }
    }
}

#[test]
fn the_jet_of_the_surface_is_that_of_its_points() {
    for torus in tori() {
        for place in places() {
            let (s, t) = (place.x / std::f64::consts::PI, place.y / std::f64::consts::PI);
            let (jet, h) = (torus.jet(s, t), 1e-4);
            let at = |i: f64, j: f64| torus.jet(s + i * h, t + j * h).point.to_vec();
            let mixed = (at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)) / (4.0 * h * h);
            let along = (at(1.0, 0.0) - at(0.0, 0.0) * 2.0 + at(-1.0, 0.0)) / (h * h);
            let up = (at(0.0, 1.0) - at(0.0, 0.0) * 2.0 + at(0.0, -1.0)) / (h * h);
            // h² times fourth derivatives, which grow with the sixth power of 6.3 on the nearly closed torus.
            let allowed = 1e-2 * reach(&torus) * 40.0;
            for (got, want) in [(jet.dst, mixed), (jet.dss, along), (jet.dtt, up)] {
                assert!((got - want).length() < allowed, "{torus:?} {place:?} {got:?} {want:?}");
            }
            let (n, outward) = (jet.normal().unwrap(), ParamSurface::normal(&torus, s, t).unwrap());
            assert!((n - outward).length() < 1e-12);
        }
    }
}

/// Second derivatives against the known curvature of the torus, to all digits: the parameter lines are lines of curvature.
#[test]
fn normal_curvatures_are_those_of_a_torus() {
    for torus in tori() {
        for place in places() {
            let jet = torus.jet(place.x / std::f64::consts::PI, place.y / std::f64::consts::PI);
            let [k1, k2] = jet.normal_curvatures().unwrap();
            let [_, meridian] = torus.angles_of_place(place);
            let rho = torus.major_radius() + torus.minor_radius() * meridian.cos();
            assert!((k1 + meridian.cos() / rho).abs() < 1e-11 / torus.minor_radius(), "{place:?}");
            assert!((k2 + 1.0 / torus.minor_radius()).abs() < 1e-11 / torus.minor_radius());
        }
    }
}

fn random_classes(r: &mut Random) -> [[f64; 2]; 4] {
    [0; 4].map(|_| [r.normal(), r.normal()])
}

fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

/// The group of the parametrisation: `(r l conj(m) z0, conj(l) z1, m z2, s l m z3)` is the same point.
#[test]
fn the_group_leaves_points_where_they_are() {
    let mut r = Random::new(30, 3);
    for torus in tori() {
        for _ in 0..50 {
            let [z0, z1, z2, z3] = random_classes(&mut r);
            let (l, m) = ([r.normal(), r.normal()], [r.normal(), r.normal()]);
            let conj = |z: [f64; 2]| [z[0], -z[1]];
            let real = |x: f64, z: [f64; 2]| [x * z[0], x * z[1]];
            let (p, q) = (r.decades(-2.0, 2.0), -r.decades(-2.0, 2.0));
            let moved = [
                real(p, times(times(l, conj(m)), z0)),
                times(conj(l), z1),
                times(m, z2),
                real(q, times(times(l, m), z3)),
            ];
            let point = |z| torus.point_of_classes(&TorusClasses::new(z).unwrap());
            assert!(point([z0, z1, z2, z3]).distance(point(moved)) < 1e-13 * 10.0 * reach(&torus));
            // Powers of two, and huge and tiny numbers.
            let scaled = [real(2.0_f64.powi(900), z0), real(1e-300, z1), z2, real(-0.5, z3)];
            assert!(point([z0, z1, z2, z3]).distance(point(scaled)) < ROUNDING * 10.0 * reach(&torus));
        }
    }
}

/// The homogeneous form, written down once more, and additive angles.
#[test]
fn classes_are_the_universal_parametrisation() {
    let mut r = Random::new(30, 4);
    for torus in tori().into_iter().filter(|t| t.frame() == cyclide::Frame::WORLD) {
        let (a, b) = (torus.major_radius(), torus.minor_radius());
        let c2 = (a - b) * (a + b);
        for _ in 0..50 {
            let z = random_classes(&mut r);
            let norm = |z: [f64; 2]| z[0] * z[0] + z[1] * z[1];
            let w = times(times(z[0], z[1]), z[2]);
            let v = times(times(z[1], [z[2][0], -z[2][1]]), z[3]);
            let (w2, n0, n3) = (times(w, w), norm(z[0]), norm(z[3]));
            let weight = n0 * ((a - b) * v[0] * v[0] + (a + b) * v[1] * v[1]);
            let want = Point3::new(c2 * n3 * w2[0], c2 * n3 * w2[1], 2.0 * b * c2.sqrt() * n0 * v[0] * v[1]);
            let want = Point3::ORIGIN + want.to_vec() / weight;
            let classes = TorusClasses::new(z).unwrap();
            assert!(torus.point_of_classes(&classes).distance(want) < 1e-12 * reach(&torus));
            let [al0, al1, al2, al3] = z.map(|z| z[1].atan2(z[0]));
            let place = Point2::new(al0 + al1 + al2, al1 - al2 + al3);
            assert!(modulo(place, classes.place()) < 1e-14 * 10.0);
        }
    }
}

/// Mirror images: `-A` across the plane of the first and third axis, `-B` across that of the first two.
#[test]
fn mirrors_change_the_sign_of_an_angle() {
    for torus in tori() {
        let f = torus.frame();
        for place in places() {
            let p = torus.point(place);
            for (normal, image) in [(f.y(), Point2::new(-place.x, place.y)), (f.z(), Point2::new(place.x, -place.y))] {
                let mirror = Mobius::reflection(f.origin(), normal).unwrap();
                assert!(torus.point(image).distance(mirror.map_point(p).unwrap()) < 1e-14 * 4.0 * reach(&torus));
            }
        }
    }
}

#[test]
fn similarities_move_the_torus_and_keep_places() {
    let map = Mobius::similarity(Quat::new(0.5, 0.1, -0.7, 0.3), 2.5, Vec3::new(1.0, -2.0, 0.5)).unwrap();
    for torus in tori() {
        let moved = torus.similar(&map).unwrap();
        for place in places() {
            let want = map.map_point(torus.point(place)).unwrap();
            assert!(moved.point(place).distance(want) < 1e-14 * 10.0 * (reach(&moved) + 3.0 * reach(&torus)));
        }
    }
}

/// The meridian angle at `b/a` next to 1: the nearest point to the middle of the hole keeps its digits.
#[test]
fn nearly_closed_tori_keep_the_outer_side() {
    let torus = cyclide::surface::Torus::new(cyclide::Frame::WORLD, 1.0, 1.0 - 2.0_f64.powi(-40)).unwrap();
    for b in [0.0, 1e-9, 1e-7, 1e-6, 1e-3, 0.5] {
        let p = torus.point(Point2::new(0.4, b));
        assert!(off_torus(&torus, p) < 1e-14, "{b}");
        let v = torus.tangent(Point2::new(0.4, b), Vec2::new(0.0, 1.0));
        assert!(v.length() > 0.0 && v.dot(torus.unit_normal(Point2::new(0.4, b))).abs() < 1e-12 * v.length());
    }
}

/// The torus as a cyclide: its patches lie on it, their normals are those of the places.
#[test]
fn it_is_a_cyclide() {
    for torus in tori() {
        let net = torus.to_cyclide().unwrap().nets([6, 4]).unwrap().remove(0);
        for (i, j) in [(0, 0), (3, 1), (5, 3)] {
            let patch = net.patch(i, j);
            for (s, t) in [(0.0, 0.0), (0.4, 0.7), (1.0, 0.3)] {
                let p = patch.point(s, t);
                assert!(off_torus(&torus, p) < 1e-13 * reach(&torus));
                let place = torus.locate(p, 1e-9 * reach(&torus)).unwrap();
                assert!((patch.unit_normal(s, t) - torus.unit_normal(place)).length() < 1e-11);
            }
        }
    }
}
