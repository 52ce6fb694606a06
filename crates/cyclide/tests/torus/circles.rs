//! The four families of circles, and arcs of them; types and switches.

use crate::data::{places, reach, tori};
use cyclide::{
    Point2, Vec2,
    curve::ParamCurve,
    surface::{CircleFamily, QuarticType, TorusClasses},
};
use cyclide_testkit::attack::Random;
use cyclide_testkit::torus_splines::off_torus;

#[test]
fn circles_lie_on_the_torus_and_run_along_their_family() {
    for torus in tori() {
        for place in places() {
            for family in CircleFamily::ALL {
                let circle = torus.circle(family, place).unwrap();
                let start = torus.tangent(place, family.direction());
                assert!(circle.jet(0.0).tangent().unwrap().angle(start) < 1e-11, "{family:?} {place:?}");
                for k in 0..16 {
                    let p = circle.point(f64::from(k) / 16.0);
                    assert!(off_torus(&torus, p) < 2e-14 * reach(&torus), "{torus:?} {family:?} {place:?}");
                    // Steps of the coordinate stay on the circle.
                    let q = torus.point(place + family.direction() * (0.2 * f64::from(k)));
                    assert!(circle.closest_point(q).distance < 1e-13 * reach(&torus));
                }
            }
        }
    }
}

#[test]
fn radii_and_planes() {
    for torus in tori() {
        let (a, b, f) = (torus.major_radius(), torus.minor_radius(), torus.frame());
        for place in places() {
            for family in [CircleFamily::Villarceau, CircleFamily::MirrorVillarceau] {
                let circle = torus.circle(family, place).unwrap();
                // The frame has unit axes to rounding, the center is known to rounding of its place.
                assert!((circle.radius() - a).abs() < 1e-14 * 4.0 * reach(&torus));
                assert!((circle.center().distance(f.origin()) - b).abs() < 1e-14 * 4.0 * reach(&torus));
                let slope = circle.normal().angle(f.z());
                assert!((slope.sin() - b / a).abs() < 1e-13, "{slope}");
            }
            assert!((torus.circle(CircleFamily::Meridian, place).unwrap().radius() - b).abs() < 4e-14 * reach(&torus));
        }
    }
}

#[test]
fn arcs_end_at_their_places() {
    for torus in tori() {
        for place in places() {
            for family in CircleFamily::ALL {
                for step in [1.3, -0.7, 1e-3, 2.5] {
                    let arc = torus.arc(family, place, step).unwrap();
                    let end = torus.point(place + family.direction() * step);
                    assert!(arc.end() == end && arc.start() == torus.point(place));
                    for k in 1..8 {
                        // Nearly closed arcs amplify the rounding of their ends.
                        let off = off_torus(&torus, arc.point(f64::from(k) / 8.0));
                        assert!(off < 1e-11 * reach(&torus), "{family:?} {step} {off:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn types_are_linear_coordinates() {
    let mut r = Random::new(30, 5);
    for kind in QuarticType::ALL {
        for _ in 0..20 {
            let v = Vec2::new(r.normal(), r.normal());
            assert!((kind.back(kind.local(v)) - v).length() < 1e-15 * 8.0);
            // A type counts the steps along its two families.
            let [i, j] = kind.families();
            let [p, q] = kind.local(v);
            assert!((i.direction() * p + j.direction() * q - v).length() < 1e-15 * 8.0);
        }
        let [i, j] = kind.families();
        assert_eq!((QuarticType::between(i, j), QuarticType::between(j, i)), (Some(kind), Some(kind)));
        assert_eq!(QuarticType::between(i, i), None);
    }
}

/// All 30 switches and the six that stay: the point is the same, and back again are the same classes.
#[test]
fn switches_keep_points() {
    let mut r = Random::new(30, 6);
    let classes = |kind: QuarticType, z: [[f64; 2]; 2]| {
        let mut all = [[1.0, 0.0]; 4];
        for (family, z) in kind.families().into_iter().zip(z) {
            all[family.index()] = z;
        }
        TorusClasses::new(all).unwrap()
    };
    let torus = &tori()[0];
    for from in QuarticType::ALL {
        for to in QuarticType::ALL {
            for _ in 0..20 {
                let angles = [r.between(-4.0, 4.0), r.between(-4.0, 4.0)];
                let z = angles.map(|al| [al.cos() * 3.0, al.sin() * 3.0]);
                let switched = from.switch(to, z).unwrap();
                let (p, q) =
                    (torus.point_of_classes(&classes(from, z)), torus.point_of_classes(&classes(to, switched)));
                assert!(p.distance(q) < 1e-14 * 10.0, "{from:?} {to:?}");
                let back = to.switch(from, switched).unwrap();
                let parallel = |a: [f64; 2], b: [f64; 2]| (a[0] * b[1] - a[1] * b[0]).abs() < 1e-14 * 30.0;
                let right_angle = |a: [f64; 2], b: [f64; 2]| (a[0] * b[0] + a[1] * b[1]).abs() < 1e-14 * 30.0;
                // The type between the Villarceau circles has two pairs for each point, a quarter turn apart.
                assert!(
                    (parallel(z[0], back[0]) && parallel(z[1], back[1]))
                        || (right_angle(z[0], back[0]) && right_angle(z[1], back[1])),
                    "{from:?} {to:?}"
                );
                // Angles switch as speeds do, modulo pi and that quarter.
                let place = Point2::new(0.0, 0.0) + from.back(angles);
                assert!(p.distance(torus.point(place)) < 1e-14 * 20.0);
            }
        }
    }
}
