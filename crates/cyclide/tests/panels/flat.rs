use crate::shapes::{Random, cone, cylinder, general, narrow_cone, plane, sphere, torus};
use cyclide::{
    Point3, Vec3,
    conformal::Conformal,
    curve::ParamCurve,
    panel::{FlatPattern, PanelMeasures},
    surface::{CyclidePatch, ParamSurface, PatchKind},
    topology::Side,
};

#[test]
fn panels_of_bent_sheets_keep_area_and_lengths() {
    let mut random = Random::new(12);
    for (patch, arcs) in [(plane(), 4), (cylinder(), 0), (cone(), 2)] {
        for (scale, far) in [(1.0, 0.0), (1e-6, 1e-6), (1e6, 1e6), (1.0, 1e5)] {
            let moved = patch.transformed(&random.similarity(scale, far)).unwrap();
            let rounding = 1e-11 + 1e3 * f64::EPSILON * far / moved.size();
            let flat = FlatPattern::new(&moved, 1e-9 * moved.size().max(10.0 * f64::EPSILON * far)).unwrap().unwrap();
            assert!(flat.area_change.abs() <= rounding, "{flat:?}");
            assert!(flat.length_change <= rounding, "{} {rounding}", flat.length_change);
            assert!(flat.deviation <= rounding * moved.size());
            let measures = PanelMeasures::new(&moved).unwrap();
            for side in Side::ALL {
                let (path, own) = (&flat.sides[side as usize], &measures.sides[side as usize]);
                assert!((path.length() / own.length - 1.0).abs() <= rounding);
                assert!(path.arcs().iter().all(|arc| arc.start().z.abs() <= 0.0 && arc.end().z.abs() <= 0.0));
            }
            if far < 1e5 {
                let curved = flat.sides.iter().filter(|path| path.arcs().iter().any(|arc| !arc.is_straight())).count();
                assert!(flat.sides.iter().all(|path| path.arcs().len() == 1) && curved == arcs, "{curved} {arcs}");
            }
        }
    }
}

#[test]
fn lengths_inside_and_angles_are_kept_and_the_outline_is_closed() {
    for patch in [plane(), cylinder(), cone()] {
        let flat = FlatPattern::new(&patch, 1e-9).unwrap().unwrap();
        let end = |side: Side, at_end: bool| {
            let arcs = flat.sides[side as usize].arcs();
            if at_end { arcs[arcs.len() - 1].end() } else { arcs[0].start() }
        };
        // To the bit.
        for (a, b) in [
            (end(Side::Bottom, false), end(Side::Left, false)),
            (end(Side::Bottom, true), end(Side::Right, false)),
            (end(Side::Left, true), end(Side::Top, false)),
            (end(Side::Right, true), end(Side::Top, true)),
        ] {
            assert_eq!(a, b);
        }
        assert_eq!(end(Side::Bottom, false), Point3::ORIGIN);
        assert!(end(Side::Bottom, true).y.abs() < 1e-15 && end(Side::Bottom, true).x > 0.0);
        // Sides cross at right angles on the panel, and so they do flat, s to t counter-clockwise.
        let tangent = |side: Side| flat.sides[side as usize].piece_jet(0, 0.0).d1.unit().unwrap();
        let (x, y) = (tangent(Side::Bottom), tangent(Side::Left));
        assert!(x.dot(y).abs() < 1e-12 && x.cross(y).z > 0.0, "{x:?} {y:?}");
    }
}

#[test]
fn a_panel_near_a_cylinder_is_laid_on_it() {
    // A short part of a wide torus: off a cylinder by its bend along.
    let at = |u: f64, v: f64| {
        let rho = 200.0 + v.cos();
        Point3::new(rho * u.cos(), rho * u.sin(), v.sin())
    };
    let corners = [at(0.0, 0.3), at(0.005, 0.3), at(0.0, 1.1), at(0.005, 1.1)];
    let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::new(-(0.3_f64.sin()), 0.0, 0.3_f64.cos()))
        .unwrap();
    assert!(FlatPattern::new(&patch, 1e-6).unwrap().is_none());
    let flat = FlatPattern::new(&patch, 2e-3).unwrap().unwrap();
    assert!(matches!(flat.surface, PatchKind::Cylinder { .. }) && flat.surface_distance <= 2e-3);
    // Lengths change by distance times curvature at most, and areas twice that; the tube has radius 1.
    assert!(flat.deviation <= 2e-3 && flat.length_change < 2e-3 && flat.area_change.abs() < 4e-3, "{flat:?}");
}

/// Within the tolerance of a cylinder, even of a plane, and on a cone: a sector of a ring, whose radii are the distances from the apex.
#[test]
fn a_panel_on_a_cone_is_a_sector_at_any_tolerance() {
    let sine = (1.0_f64 / 20.0).atan().sin();
    for tolerance in [1e-9, 1e-3, 0.1, 1.0] {
        let flat = FlatPattern::new(&narrow_cone(0.0), tolerance).unwrap().unwrap();
        assert!(matches!(flat.surface, PatchKind::Cone { .. }), "{tolerance}");
        assert!(flat.length_change < 1e-12 && flat.area_change.abs() < 1e-12 && flat.deviation < 1e-11, "{flat:?}");
        for (side, radius) in [(Side::Bottom, Some(2.0 / sine)), (Side::Top, Some(2.05 / sine)), (Side::Left, None)] {
            let [arc] = flat.sides[side as usize].arcs() else { panic!("one arc") };
            // Its sagitta is 3e-3: rounding of the plane's coordinates is 1e-13 of it.
            assert_eq!(arc.radius().is_some(), radius.is_some(), "{side:?}");
            assert!(arc.radius().zip(radius).is_none_or(|(r, is)| (r / is - 1.0).abs() < 1e-10), "{arc:?}");
        }
    }
}

#[test]
fn panels_bent_both_ways_have_none() {
    let mut random = Random::new(13);
    for patch in [sphere(2.0), torus(0.5), general(&mut random)] {
        assert_eq!(FlatPattern::new(&patch, 1e-6).unwrap(), None);
    }
    assert_eq!(FlatPattern::new(&plane(), -1.0).unwrap_err().reason(), "tolerance-not-positive");
    let _ = plane().point(0.0, 0.0);
}
