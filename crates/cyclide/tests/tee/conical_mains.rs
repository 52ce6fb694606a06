//! Tees whose main pipe is a cone.

use super::crosses::{on_side, sum_of_tees, volume};
use super::*;
use cyclide::error::PipeError;

fn cone(taper: f64) -> TeeMain {
    TeeMain { taper, ..MAIN }
}

/// A single branch on each, with the taper of the main pipe.
fn variants() -> Vec<(f64, TeeBranch)> {
    vec![
        (0.08, branch()),
        (-0.12, TeeBranch { blend: law(), at: -2.0, ..branch() }),
        (0.1, TeeBranch { angle: 0.8, offset: 0.5, azimuth: 2.0, at: 1.5, blend: law(), ..branch() }),
        (0.06, TeeBranch { taper: 0.1, angle: 2.0, offset: -0.6, ..branch() }),
        (-0.15, TeeBranch { taper: -0.1, angle: 1.0, offset: 0.7, azimuth: 4.0, blend: law(), ..branch() }),
        (
            -0.1,
            TeeBranch { radius: 1.0, taper: 0.05, angle: 1.9, offset: 0.8, blend: TeeBlend::Least(0.4), ..branch() },
        ),
    ]
}

#[test]
fn balls_touch_the_cone_and_the_branch() {
    for (taper, branch) in variants() {
        let main = cone(taper);
        let tee = made(main, vec![branch.clone()], None, TeeEnds::Flat).expect("a tee");
        assert!(tee.body.is_solid());
        check_balls(&tee, &main, &[branch]);
    }
}

#[test]
fn all_else_is_on_the_cone_the_branch_and_the_ends_and_smooth() {
    for (taper, branch) in variants() {
        let main = cone(taper);
        let tee = made(main, vec![branch.clone()], None, TeeEnds::Flat).expect("a tee");
        for face in tee.body.outer.faces() {
            let FaceSurface::Rational(surface) = &face.surface else { panic!("all are rational") };
            assert!(surface.has_positive_weights());
            if surface.degrees() == [12, 2] {
                continue;
            }
            for (s, t) in [(0.2, 0.3), (0.5, 0.5), (0.9, 0.8)] {
                let p = surface.point(s, t);
                let (foot, way) = axis(&branch);
                let ends = [p.x - main.ends[0], p.x - main.ends[1], (p - foot).dot(way) - branch.length];
                let off = ends.into_iter().chain([off_main(p, &main), off_branch(p, &branch)]).map(f64::abs);
                // Coordinates up to 16.
                assert!(off.fold(f64::INFINITY, f64::min) < 1e-13, "{p:?}");
            }
        }
        // Creases at the ends: right angles, and those of cones.
        let creases = [0.0, taper, -taper, branch.taper, -branch.taper].map(|lean| FRAC_PI_2 + lean);
        for joint in surface_joints(&tee.body.outer) {
            let is_crease = creases.iter().any(|crease| (joint.angle - crease).abs() < 1e-9);
            assert!(joint.angle < 1e-8 || is_crease, "{}", joint.angle);
        }
    }
}

/// A small ball leaves the union of both cones: the part of the branch outside the main one by quadrature over its cross sections.
#[test]
fn a_small_blend_leaves_the_volume_of_both_cones() {
    let (main, upright) = (cone(0.1), TeeBranch { taper: 0.05, ..TeeBranch::upright(1.2, 12.0, 1e-3) });
    let tee = made(main, vec![upright.clone()], None, TeeEnds::Flat).expect("a tee");
    // In lines up: from the main pipe to the branch's cone, over its width where they leave the main pipe and above.
    let radius = |h: f64| upright.radius - h * upright.taper.tan();
    let main_radius = |x: f64| main.radius - x * main.taper.tan();
    let (rings, spokes) = (400, 720);
    let mut outside = 0.0;
    for k in 0..spokes {
        let (sin, cos) = (2.0 * PI * f64::from(k) / f64::from(spokes)).sin_cos();
        // Where a line of the branch leaves the main pipe, by bisection.
        let (mut low, mut high) = (0.0, 4.0);
        for _ in 0..60 {
            let h = 0.5 * (low + high);
            let r = radius(h);
            if (r * sin).hypot(h) < main_radius(r * cos) { low = h } else { high = h }
        }
        // The sector from there up, a part of a frustum, and below it from the surface of the main pipe within the line.
        let edge = radius(low);
        let top = radius(upright.length);
        outside += (upright.length - low) * (edge * edge + edge * top + top * top) / 3.0 * 0.5;
        for j in 0..rings {
            let r = edge * (f64::from(j) + 0.5) / f64::from(rings);
            let height = (main_radius(r * cos).powi(2) - (r * sin).powi(2)).sqrt();
            outside += (low - height) * r * edge / f64::from(rings);
        }
    }
    outside *= 2.0 * PI / f64::from(spokes);
    let frustum = {
        let [a, b] = main.ends.map(main_radius);
        PI / 3.0 * (main.ends[1] - main.ends[0]) * (a * a + a * b + b * b)
    };
    // The fillet of 1e-3 adds less than its square times the length of the edge, the rule of the middle is good to 1e-5.
    let more = volume(&tee) - frustum - outside;
    assert!(more.abs() < 3e-5, "{more}");
}

#[test]
fn walls_crosses_and_ends_of_cones_add_up() {
    let main = cone(0.07);
    let thin = |at: f64| TeeBranch { at, ..TeeBranch::upright(1.2, 10.0, 0.3) };
    let branches = vec![
        TeeBranch { angle: 1.2, taper: 0.04, ..TeeBranch::upright(1.8, 10.0, 0.4) },
        on_side(180.0, thin(0.5)),
        on_side(90.0, thin(-7.0)),
    ];
    for (wall, ends) in [(None, TeeEnds::Flat), (Some(0.2), TeeEnds::Flat), (Some(0.2), TeeEnds::Closed)] {
        let tee = made(main, branches.clone(), wall, ends).expect("a tee");
        assert!(tee.body.is_solid());
        let expected = sum_of_tees(main, &branches, wall, ends);
        assert!((volume(&tee) / expected - 1.0).abs() < 1e-11, "{} {expected}", volume(&tee));
        let Some(wall) = wall else { continue };
        let faces = canals(&tee.body);
        let (outer, inner) = faces.split_at(faces.len() / 2);
        for ((outside, face), (inside, _)) in outer.iter().zip(inner) {
            for (s, t) in [(0.0, 0.0), (0.3, 0.4), (0.7, 1.0)] {
                let below = outside.point(s, t) - normal(outside, face, s, t) * wall;
                assert!(below.distance(inside.point(s, t)) < 1e-10);
            }
        }
    }
}

#[test]
fn scale_and_place_change_no_tee_on_a_cone() {
    let volume = |scale: f64, azimuth: f64| {
        let main = TeeMain { radius: 3.0 * scale, taper: 0.09, ends: [-14.0 * scale, 16.0 * scale] };
        let lateral = TeeBranch {
            angle: 1.0,
            offset: 0.5 * scale,
            azimuth,
            at: 2.0 * scale,
            taper: -0.05,
            ..TeeBranch::upright(1.7 * scale, 12.0 * scale, 0.4 * scale)
        };
        made(main, vec![lateral], None, TeeEnds::Flat).expect("a tee").body.outer.volume() / scale.powi(3)
    };
    let own = volume(1.0, 0.0);
    for (scale, azimuth) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 2.3)] {
        assert!((volume(scale, azimuth) / own - 1.0).abs() < 1e-10, "{scale} {azimuth}");
    }
}

#[test]
fn cones_that_are_no_main_pipe_are_refused() {
    let refused = |taper: f64, branch, wall| made(cone(taper), vec![branch], wall, TeeEnds::Flat).expect_err("no tee");
    // Radius 3 less 16 tan 0.2 is below zero, and so is 3 less 14 tan 0.22 on the other side.
    let Error::Pipe(PipeError::ConeReachesApex { apex, reached, .. }) = refused(0.2, branch(), None) else {
        panic!("the apex")
    };
    assert!((apex - 3.0 / 0.2_f64.tan()).abs() < 1e-12 && (reached - 16.0).abs() < 1e-12);
    assert!(matches!(refused(-0.22, branch(), None), Error::Pipe(PipeError::ConeReachesApex { .. })));
    assert!(matches!(refused(0.15, branch(), Some(0.7)), Error::Pipe(PipeError::ConeReachesApex { .. })));
    assert_eq!(refused(2.0, branch(), None).reason(), "parameter-out-of-range");
    // A branch as wide as the cone at its foot, and a line of one along a line of the other.
    let wide = TeeBranch { radius: 3.0, ..branch() };
    assert_eq!(refused(0.1, wide, None).reason(), "tee-branch-too-wide");
    assert_eq!(refused(0.1, TeeBranch { angle: 0.14, ..branch() }, None).reason(), "angle-out-of-range");
    assert_eq!(refused(f64::NAN, branch(), None).reason(), "not-finite");
}
