//! Splines on tori run backwards, moved and mirrored; rotations about the axis.

use crate::data::reach;
use cyclide::{
    Point2, Quat, Vec2, Vec3, conformal::Mobius, construct::TorusTangent, curve::ParamCurve, surface::TorusSpline,
};
use cyclide_testkit::torus_splines::{Problem, faults, winding};

fn splines() -> Vec<(Problem, TorusSpline)> {
    (0..40).map(|case| Problem::awkward(31, case)).map(|p| (p.clone(), p.solve().unwrap())).collect()
}

#[test]
fn reversed_splines_run_through_the_same_points() {
    for (problem, spline) in splines() {
        let back = spline.reversed();
        assert_eq!(faults(&back), Vec::<String>::new());
        let size = reach(&problem.torus);
        for k in 0..=60 {
            let t = f64::from(k) / 60.0;
            let gap = spline.point(t).distance(back.point(1.0 - t));
            // The parameter 1 - t is rounded; speeds are up to some hundred sizes.
            assert!(gap < 1e-11 * size, "{gap:e}");
        }
        let twice = back.reversed();
        assert!(twice.knots().iter().zip(spline.knots()).all(|(a, b)| (a - b).abs() <= 1e-14 * (1.0 + b.abs())));
        assert_eq!(twice.segments(), spline.segments());
    }
}

#[test]
fn similar_splines_have_similar_points() {
    let turn = Mobius::similarity(Quat::new(0.5, 0.1, -0.7, 0.3), 2.5, Vec3::new(1.0, -2.0, 0.5)).unwrap();
    let mirror = Mobius::reflection(cyclide::Point3::new(0.3, 0.1, -2.0), Vec3::new(1.0, 2.0, 0.7)).unwrap();
    for (problem, spline) in splines() {
        for map in [&turn, &mirror] {
            let moved = spline.similar(map).unwrap();
            let size = 10.0 * (reach(&problem.torus) + reach(moved.torus()));
            assert_eq!(faults(&moved), Vec::<String>::new());
            for piece in 0..spline.piece_count() {
                for s in [0.0, 0.3, 0.8, 1.0] {
                    let want = map.map_point(spline.piece_point(piece, s)).unwrap();
                    assert!(moved.piece_point(piece, s).distance(want) < 1e-13 * size);
                }
            }
            if let Some(told) = moved.winding() {
                assert_eq!(told, winding(&moved));
            }
        }
    }
}

/// Angles `A + const` are a rotation about the axis: the spline through the moved places is the rotated one.
#[test]
fn rotations_about_the_axis_move_places() {
    for (problem, spline) in splines() {
        let (angle, f) = (0.7, problem.torus.frame());
        let mut moved = problem.clone();
        for place in &mut moved.places {
            *place += Vec2::new(0.5 * angle, 0.0);
        }
        // Half turns to the nearest: points at just half a turn may go the other way after rounding.
        let turned = moved.solve().unwrap();
        let map = Mobius::rotation(f.origin(), f.z(), angle).unwrap();
        assert_eq!(turned.piece_count(), spline.piece_count());
        for piece in 0..spline.piece_count() {
            for s in [0.0, 0.4, 1.0] {
                let want = map.map_point(spline.piece_point(piece, s)).unwrap();
                let gap = turned.piece_point(piece, s).distance(want);
                assert!(gap < 1e-10 * reach(&problem.torus), "{gap:e} {piece} {s} {:?} {problem:?}", spline.segments());
            }
        }
    }
}

/// `(A, B) -> (-A, B)` mirrors data and spline; `(A, -B)` likewise.
#[test]
fn mirrored_data_give_mirrored_splines() {
    for (problem, spline) in splines() {
        let f = problem.torus.frame();
        for (signs, normal) in [([-1.0, 1.0], f.y()), ([1.0, -1.0], f.z())] {
            let image = |v: Vec2| Vec2::new(signs[0] * v.x, signs[1] * v.y);
            let mut moved = problem.clone();
            // A cusp is rounded to one side, a point opposite to the step goes round one way: not symmetric.
            if spline.segments().iter().any(|s| s.method == cyclide::surface::SegmentMethod::Detour) {
                continue;
            }
            for place in &mut moved.places {
                *place = Point2::default() + image(*place - Point2::default());
            }
            for tangent in &mut moved.options.tangents {
                if let TorusTangent::Rate(rate) = tangent {
                    *rate = image(*rate);
                }
            }
            moved.options.winding = match moved.options.winding {
                cyclide::construct::TorusWinding::Shortest => cyclide::construct::TorusWinding::Shortest,
                cyclide::construct::TorusWinding::Total([n, m]) => {
                    cyclide::construct::TorusWinding::Total([n * signs[0] as i32, m * signs[1] as i32])
                }
                cyclide::construct::TorusWinding::PerSegment(list) => cyclide::construct::TorusWinding::PerSegment(
                    list.into_iter().map(|[n, m]| [n * signs[0] as i32, m * signs[1] as i32]).collect(),
                ),
            };
            let mirrored = moved.solve().unwrap();
            let map = Mobius::reflection(f.origin(), normal).unwrap();
            for i in 0..problem.places.len() {
                let u = problem.options.knots.get(i).copied().unwrap_or(i as f64);
                let want = map.map_point(spline.jet_at_knot(u).point).unwrap();
                assert!(mirrored.jet_at_knot(u).point.distance(want) < 1e-13 * reach(&problem.torus));
            }
            assert_eq!(faults(&mirrored), Vec::<String>::new());
        }
    }
}
