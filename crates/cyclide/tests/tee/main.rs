//! Tees: balls that touch both pipes, tangent planes, walls of one thickness, and bodies of known volume.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod conical_mains;
mod crosses;

use cyclide::{
    Error, Point3, Vec3,
    construct::{MadeTee, PipeTee, TeeBlend, TeeBranch, TeeEnds, TeeMain},
    curve::ParamCurve as _,
    error::{PartError, TeeError},
    rational::RationalBezierSurface,
    topology::{Body, FaceSurface, ShellFace, surface_joints},
};
use std::f64::consts::{FRAC_PI_2, PI};

const MAIN: TeeMain = TeeMain { radius: 3.0, taper: 0.0, ends: [-14.0, 16.0] };

fn branch() -> TeeBranch {
    TeeBranch::upright(2.0, 12.0, 0.5)
}

fn law() -> TeeBlend {
    let values = vec![[0.0, 0.8], [FRAC_PI_2, 0.4], [PI, 1.0], [1.5 * PI, 0.5]];
    TeeBlend::Angles { values, tolerance: None }
}

fn made(main: TeeMain, branches: Vec<TeeBranch>, wall: Option<f64>, ends: TeeEnds) -> Result<MadeTee, Error> {
    let tee = PipeTee::new(main, branches)?.with_ends(ends);
    wall.map_or(Ok(tee.clone()), |wall| tee.with_wall(wall))?.made()
}

fn solid(branches: Vec<TeeBranch>) -> MadeTee {
    made(MAIN, branches, None, TeeEnds::Flat).expect("a tee")
}

/// The canals of a body: the faces of degree (12, 2), of equal pipes (8, 2).
fn canals(body: &Body) -> Vec<(&RationalBezierSurface, &ShellFace)> {
    let faces = body.shells().flat_map(|shell| shell.faces());
    let rational = faces.filter_map(|face| match &face.surface {
        FaceSurface::Rational(surface) => Some((surface, face)),
        FaceSurface::Cyclide(_) => None,
    });
    rational.filter(|(surface, _)| [[12, 2], [8, 2]].contains(&surface.degrees())).collect()
}

/// Point and direction of the axis of a branch.
fn axis(branch: &TeeBranch) -> (Point3, Vec3) {
    let ((lean_sin, lean_cos), (sin, cos)) = (branch.angle.sin_cos(), branch.azimuth.sin_cos());
    let foot = Point3::new(branch.at, 0.0, 0.0) + Vec3::new(0.0, cos, sin) * branch.offset;
    (foot, Vec3::X * lean_cos + Vec3::new(0.0, -sin, cos) * lean_sin)
}

fn off_axis(p: Point3, (foot, way): (Point3, Vec3)) -> Vec3 {
    let v = p - foot;
    v - way * v.dot(way)
}

/// Distance of a point from a branch, a cone or a cylinder.
fn off_branch(p: Point3, branch: &TeeBranch) -> f64 {
    let ((foot, way), (sin, cos)) = (axis(branch), branch.taper.sin_cos());
    (off_axis(p, (foot, way)).length() - branch.radius) * cos + (p - foot).dot(way) * sin
}

/// Outside normal of a face.
fn normal(surface: &RationalBezierSurface, face: &ShellFace, s: f64, t: f64) -> Vec3 {
    let jet = surface.jet(s, t);
    let n = jet.ds.cross(jet.dt).unit().expect("a normal");
    if face.same_sense { n } else { -n }
}

/// Distance of a point from a main pipe, a cone or a cylinder.
fn off_main(p: Point3, main: &TeeMain) -> f64 {
    let (sin, cos) = main.taper.sin_cos();
    (off_axis(p, (Point3::ORIGIN, Vec3::X)).length() - main.radius) * cos + p.x * sin
}

/// The radius of the ball on the outer side that touches a canal at a point and the main pipe: by bisection of the distance from it less the radius, which falls along the
/// normal from there on (the normal leans off that of the pipe).
fn ball(p: Point3, n: Vec3, main: &TeeMain, most: f64) -> f64 {
    let gap = |r: f64| off_main(p + n * r, main) - r;
    let (mut low, mut high) = (0.0, most);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if gap(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[test]
fn every_circle_of_the_blend_is_on_one_ball_that_touches_both_pipes() {
    let variants = [
        branch(),
        TeeBranch { blend: law(), ..branch() },
        TeeBranch { angle: 0.8, offset: 0.7, azimuth: 2.0, at: 1.5, blend: law(), ..branch() },
        TeeBranch { radius: 1.0, angle: 2.2, offset: -0.3, blend: TeeBlend::Least(0.4), ..branch() },
        TeeBranch { taper: 0.1, ..branch() },
        TeeBranch { taper: -0.2, angle: 0.9, offset: 0.7, azimuth: 2.0, at: 1.5, blend: law(), ..branch() },
        TeeBranch { radius: 1.0, taper: 0.06, angle: 2.0, offset: -0.3, blend: TeeBlend::Least(0.4), ..branch() },
    ];
    for variant in variants {
        check_balls(&solid(vec![variant.clone()]), &MAIN, &[variant]);
    }
}

/// Every circle of the blends of a solid tee is on one ball that touches the main pipe and a branch, and is as large as is said.
fn check_balls(tee: &MadeTee, main: &TeeMain, branches: &[TeeBranch]) {
    let most = tee.blends.iter().fold(0.0, |most: f64, blend| most.max(blend.radii[1]));
    let mut seen = vec![0; branches.len()];
    for (surface, face) in canals(&tee.body) {
        for s in [0.1, 0.55, 0.9] {
            let found = [0.15, 0.5, 0.85].map(|t| {
                let (p, n) = (surface.point(s, t), normal(surface, face, s, t));
                let radius = ball(p, n, main, 4.0 * most);
                (p + n * radius, radius)
            });
            // Branches opposite each other have one axis.
            let off = |k: usize| {
                let ((sin, cos), centre) = (branches[k].azimuth.sin_cos(), found[1].0);
                let on_side = centre.z * cos - centre.y * sin > 0.0;
                if on_side { (off_branch(centre, &branches[k]) - found[1].1).abs() } else { f64::INFINITY }
            };
            let nearest = (1..branches.len()).fold(0, |best, k| if off(k) < off(best) { k } else { best });
            seen[nearest] += 1;
            let [least, most] = tee.blends[nearest].radii;
            for (centre, radius) in found {
                // Coordinates up to 16 and quotients of degree 12, and the slow way of the gap near its zero.
                assert!(centre.distance(found[0].0) < 1e-10 && (radius - found[0].1).abs() < 1e-10);
                let touching = off_branch(centre, &branches[nearest]) - radius;
                assert!(touching.abs() < 1e-10, "{touching}");
                assert!(radius > least - 1e-10 && radius < most + 1e-10, "{radius}");
            }
        }
    }
    assert!(seen.iter().zip(&tee.blends).all(|(seen, blend)| *seen == 3 * blend.pieces), "{seen:?}");
}

#[test]
fn blends_are_tangent_to_both_pipes() {
    let lateral = || TeeBranch { angle: 1.0, offset: 0.8, blend: law(), ..branch() };
    let tapers = [0.08, -0.15].map(|taper| vec![TeeBranch { taper, ..lateral() }]);
    for branches in [vec![branch()], vec![lateral()]].into_iter().chain(tapers) {
        let taper = branches[0].taper;
        let tee = made(MAIN, branches, Some(0.2), TeeEnds::Flat).expect("a tee");
        let joints = surface_joints(&tee.body.outer);
        let smooth = joints.iter().filter(|joint| joint.angle < 0.1);
        // Creases are at the rings of the ends only: right angles, and those of cones.
        let creases = [0.0, taper, -taper].map(|lean| FRAC_PI_2 + lean);
        let is_crease = |angle: f64| creases.iter().any(|crease| (angle - crease).abs() < 1e-9);
        assert!(joints.iter().all(|joint| joint.angle < 0.1 || is_crease(joint.angle)));
        assert!(smooth.map(|joint| joint.angle).fold(0.0, f64::max) < 1e-8);
    }
}

#[test]
fn radii_are_those_asked_for() {
    // Near one radius, to the tolerance.
    let near =
        |tolerance| TeeBranch { blend: TeeBlend::Radius { radius: 0.6, tolerance: Some(tolerance) }, ..branch() };
    for tolerance in [1e-2, 1e-4, 1e-6] {
        let facts = solid(vec![near(tolerance)]).blends[0];
        assert!(facts.radii[0] >= 0.6 - tolerance && facts.radii[1] <= 0.6 + tolerance);
        // The bound is not a wild one: a tenth of the tolerance is used.
        assert!(facts.radii[1] - facts.radii[0] > 0.1 * tolerance);
    }
    // The law is met at its angles: there the contact round the branch is at the angle, and the ball as large as asked.
    let asked = TeeBranch { blend: law(), angle: 1.1, offset: 0.6, ..branch() };
    let tee = solid(vec![asked.clone()]);
    let (foot, way) = axis(&asked);
    let TeeBlend::Angles { values, .. } = &asked.blend else { panic!("a law") };
    let (across, beside) = (Vec3::X * asked.angle.sin() - Vec3::Z * asked.angle.cos(), Vec3::Y);
    for &[angle, radius] in values {
        let (mut nearest, mut found) = (f64::INFINITY, 0.0);
        for (surface, face) in canals(&tee.body) {
            let contact = off_axis(surface.point(0.0, 0.0), (foot, way));
            let off = (contact.dot(beside).atan2(contact.dot(across)) - angle).rem_euclid(2.0 * PI);
            let off = off.min(2.0 * PI - off);
            if off < nearest {
                let (p, n) = (surface.point(0.0, 0.5), normal(surface, face, 0.0, 0.5));
                (nearest, found) = (off, ball(p, n, &MAIN, 5.0));
            }
        }
        assert!(nearest < 1e-9 && (found - radius).abs() < 1e-9, "{angle}: {nearest} {found}");
    }
}

#[test]
fn walls_have_one_thickness_also_in_the_blend() {
    let wall = 0.25;
    for taper in [0.0, 0.1, -0.2] {
        let lateral = TeeBranch { angle: 1.0, offset: 0.5, taper, blend: law(), ..branch() };
        let tee = made(MAIN, vec![lateral], Some(wall), TeeEnds::Closed).expect("a tee");
        assert!(tee.body.is_solid() && tee.body.voids.len() == 1);
        let faces = canals(&tee.body);
        let (outer, inner) = faces.split_at(faces.len() / 2);
        assert_eq!(outer.len(), inner.len());
        for ((outside, face), (inside, _)) in outer.iter().zip(inner) {
            for (s, t) in [(0.0, 0.0), (0.3, 0.4), (0.7, 1.0)] {
                let below = outside.point(s, t) - normal(outside, face, s, t) * wall;
                assert!(below.distance(inside.point(s, t)) < 1e-10);
            }
        }
    }
}

#[test]
fn tapers_are_cones_to_their_ends() {
    // Against the tee whose branch is a cylinder the volume changes by the frustum's, but for what is inside the main pipe and the blend.
    for (taper, angle, offset) in [(0.05, 1.2, 0.3), (-0.2, 0.9, -0.4), (0.12, 2.0, 0.0)] {
        let branch = TeeBranch { taper, angle, offset, ..branch() };
        let tee = solid(vec![branch.clone()]);
        assert!(tee.body.is_solid());
        let (foot, way) = axis(&branch);
        let end = branch.radius - branch.length * taper.tan();
        let mut on_cone = 0;
        for face in tee.body.outer.faces() {
            let FaceSurface::Rational(surface) = &face.surface else { continue };
            if surface.degrees() != [6, 1] {
                continue;
            }
            on_cone += 1;
            for (s, t) in [(0.2, 0.1), (0.5, 0.5), (0.9, 1.0)] {
                let p = surface.point(s, t);
                assert!(off_branch(p, &branch).abs() < 1e-13, "coordinates up to 14");
                let out = off_axis(p, (foot, way)).unit().expect("off the axis") * taper.cos() + way * taper.sin();
                assert!(normal(surface, face, s, t).dot(out) > 1.0 - 1e-12);
            }
            let top = surface.point(0.5, 1.0);
            assert!((off_axis(top, (foot, way)).length() - end).abs() < 1e-13);
            assert!(((top - foot).dot(way) - branch.length).abs() < 1e-13);
        }
        assert!(on_cone > 7);
        // Above what the main pipe and the blend reach the branch is a frustum: cut off the same from branches of two lengths.
        let longer = TeeBranch { length: 12.5, ..branch.clone() };
        let more = solid(vec![longer]).body.outer.volume() - tee.body.outer.volume();
        let last = branch.radius - 12.5 * taper.tan();
        let frustum = PI / 3.0 * 0.5 * (end * end + end * last + last * last);
        assert!((more - frustum).abs() < 1e-9, "{more} {frustum}: of volumes of a thousand");
    }
}

#[test]
fn tapers_that_leave_no_branch_are_refused() {
    let refused = |branch| made(MAIN, vec![branch], None, TeeEnds::Flat).expect_err("no tee");
    // It comes to a point at 12/6, at 12 and inside the main pipe.
    assert_eq!(refused(TeeBranch { taper: 0.33, ..branch() }).reason(), "radius-not-positive");
    assert_eq!(refused(TeeBranch { taper: (2.0_f64 / 12.0).atan(), ..branch() }).reason(), "radius-not-positive");
    let inside = TeeBranch { taper: (2.0_f64 / 2.9).atan(), length: 2.8, ..branch() };
    assert_eq!(refused(inside).reason(), "tee-pipe-too-short");
    // A line of it along the main pipe.
    let along = TeeBranch { taper: -0.5, angle: 0.52, ..branch() };
    assert_eq!(refused(along).reason(), "angle-out-of-range");
    assert_eq!(refused(TeeBranch { taper: -0.3, radius: 3.2, ..branch() }).reason(), "tee-branch-too-wide");
}

#[test]
fn a_tiny_blend_leaves_the_volume_of_both_pipes() {
    // Beyond the main pipe an upright branch of radius a, offset by e, has the volume of its chords: simpson over y.
    let (a, e) = (2.0_f64, 0.6);
    let tee = solid(vec![TeeBranch { offset: e, ..TeeBranch::upright(a, 12.0, 1e-3) }]);
    let steps = 20_000;
    let inside = |k: i32| {
        // y = a sin θ takes the root at the border away.
        let theta = -FRAC_PI_2 + PI * f64::from(k) / f64::from(steps);
        let y = a * theta.sin();
        2.0 * (a * theta.cos()).powi(2) * (9.0 - (y - e) * (y - e)).sqrt()
    };
    let weight = |k: i32| {
        if k == 0 || k == steps {
            1.0
        } else if k % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    let chords: f64 = (0..=steps).map(|k| weight(k) * inside(k)).sum::<f64>() * PI / f64::from(3 * steps);
    let expected = PI * 9.0 * 30.0 + PI * a * a * 12.0 - chords;
    // The fillet of 1e-3 adds less than its square times the length of the edge.
    let more = tee.body.outer.volume() - expected;
    assert!(more > 0.0 && more < 1.5e-5, "{more}");
}

#[test]
fn the_whole_range_of_pipes_makes_solids() {
    for part in [0.05, 0.5, 0.98] {
        for angle in [0.5, 2.6] {
            for offset in [-0.9, 0.0, 0.9] {
                let main = TeeMain { radius: 1.0, taper: 0.0, ends: [-20.0, 20.0] };
                let blend = TeeBlend::Radius { radius: 0.1 * part, tolerance: Some(0.01 * part) };
                let offset = offset * (1.0 - part);
                let branch = TeeBranch { angle, offset, blend, ..TeeBranch::upright(part, 20.0, 1.0) };
                let tee = made(main, vec![branch], None, TeeEnds::Flat).expect("a tee");
                assert!(tee.body.is_solid());
                let least = PI * 40.0 + PI * part * part * (20.0 - 1.0 / angle.sin() - part / angle.tan().abs());
                assert!(tee.body.outer.volume() > least, "{part} {angle} {offset}");
            }
        }
    }
}

#[test]
fn scale_and_place_change_nothing_else() {
    let volume = |scale: f64, azimuth: f64, at: f64| {
        let main = TeeMain { radius: 3.0 * scale, taper: 0.0, ends: [(-14.0 + at) * scale, (16.0 + at) * scale] };
        let blend = TeeBlend::Radius { radius: 0.5 * scale, tolerance: None };
        let lateral = TeeBranch {
            angle: 1.0,
            offset: 0.5 * scale,
            azimuth,
            at: at * scale,
            blend,
            ..TeeBranch::upright(2.0 * scale, 12.0 * scale, 1.0)
        };
        made(main, vec![lateral], None, TeeEnds::Flat).expect("a tee").body.outer.volume() / scale.powi(3)
    };
    let own = volume(1.0, 0.0, 0.0);
    for (scale, azimuth, at) in [(1e-6, 0.0, 0.0), (1e6, 0.0, 0.0), (1.0, 2.3, 0.0), (1.0, 0.0, 500.0)] {
        // Quadrature to 1e-12, in coordinates up to 500.
        assert!((volume(scale, azimuth, at) / own - 1.0).abs() < 1e-10, "{scale} {azimuth} {at}");
    }
}

/// Balls of the inner skin are larger by the wall: what that folds is not the ball's fault.
#[test]
fn a_wall_that_folds_the_blend_is_named() {
    let main = TeeMain { radius: 30.0, taper: 0.0, ends: [-90.0, 90.0] };
    let tee = |radius: f64, wall: f64| {
        let branch = TeeBranch::upright(radius, 85.0, 6.0);
        made(main, vec![branch], Some(wall), TeeEnds::Flat)
    };
    for (radius, wall) in [(18.0, 17.0), (30.0, 29.0)] {
        let error = tee(radius, wall).expect_err("its inner side folds");
        assert!(matches!(error, Error::Tee(TeeError::BlendFolds { wall: Some(_), .. })), "{error}");
        assert!(error.to_string().contains("use a thinner wall"), "{error}");
    }
    assert!(tee(18.0, 12.0).is_ok());
    // In the sharp crotch it is the ball.
    let leaning = TeeBranch { angle: 0.4, ..TeeBranch::upright(15.0, 400.0, 10.0) };
    let long = TeeMain { ends: [-400.0, 400.0], ..main };
    let error = made(long, vec![leaning], Some(1.0), TeeEnds::Flat).expect_err("folds");
    assert!(matches!(error, Error::Tee(TeeError::BlendFolds { wall: None, .. })), "{error}");
}

#[test]
fn a_manifold_is_one_solid_that_adds_up() {
    let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-20.0, 20.0] };
    let branches = || {
        vec![
            TeeBranch { at: 10.0, radius: 1.5, offset: 0.9, angle: 1.3, ..branch() },
            TeeBranch { at: -10.0, ..branch() },
            TeeBranch { at: 0.0, azimuth: 1.7, blend: law(), ..branch() },
        ]
    };
    let whole = made(main, branches(), None, TeeEnds::Flat).expect("a tee");
    assert!(whole.body.is_solid() && whole.blends.len() == 3);
    let bare = PI * 9.0 * 40.0;
    let alone =
        |branch: TeeBranch| made(main, vec![branch], None, TeeEnds::Flat).expect("a tee").body.outer.volume() - bare;
    let sum: f64 = bare + branches().into_iter().map(alone).sum::<f64>();
    assert!((whole.body.outer.volume() / sum - 1.0).abs() < 1e-11);
    let hollow = made(main, branches(), Some(0.2), TeeEnds::Flat).expect("a tee");
    assert!(hollow.body.is_solid() && hollow.body.voids.is_empty());
    let joints = surface_joints(&hollow.body.outer);
    assert!(joints.iter().all(|joint| joint.angle < 1e-8 || (joint.angle - FRAC_PI_2).abs() < 1e-9));
    let open = made(main, branches(), None, TeeEnds::Open).expect("a tee");
    assert!(!open.body.is_solid());
}

#[test]
fn what_is_no_tee_is_refused_with_its_measures() {
    let refused = |main, branches| made(main, branches, None, TeeEnds::Flat).expect_err("no tee");
    let beside = TeeBranch { offset: 1.2, ..branch() };
    let wide = Error::Tee(TeeError::BranchTooWide { branch: 0, reach: 3.2, limit: 3.0, rest: 1e-4 * 3.0, offset: 1.2 });
    assert_eq!(refused(MAIN, vec![beside]), wide);
    // Thinner by too little: what helps is said, and it does.
    let narrow = |radius: f64| TeeBranch { radius, ..TeeBranch::upright(1.0, 10.0, 0.3) };
    let message = refused(TeeMain { radius: 1.0, ..MAIN }, vec![narrow(0.9999)]).to_string();
    assert!(
        message.contains("clearance between them is below 1e-4") && message.contains("make its radius at most 0.9998"),
        "{message}"
    );
    assert!(made(TeeMain { radius: 1.0, ..MAIN }, vec![narrow(0.9998)], None, TeeEnds::Flat).is_ok());
    assert_eq!(refused(MAIN, vec![TeeBranch { radius: 3.1, ..branch() }]).reason(), "tee-branch-too-wide");
    assert_eq!(refused(MAIN, vec![TeeBranch { radius: 3.0, offset: 0.1, ..branch() }]).reason(), "tee-branch-too-wide");
    for angle in [0.0, PI, -1.0, 0.04] {
        assert_eq!(refused(MAIN, vec![TeeBranch { angle, ..branch() }]).reason(), "angle-out-of-range");
    }
    // The contact of the ball in the crotch is at 2.5 along the main pipe, and sqrt(3.5²) up.
    let short = TeeMain { ends: [-14.0, 2.4], ..MAIN };
    let Error::Tee(TeeError::PipeTooShort { end, needed, .. }) = refused(short, vec![branch()]) else {
        panic!("too short")
    };
    assert!((end - 2.4).abs() < 1e-15 && (needed - 2.503).abs() < 1e-6, "{needed}");
    let Error::Tee(TeeError::PipeTooShort { needed, .. }) = refused(MAIN, vec![TeeBranch { length: 3.4, ..branch() }])
    else {
        panic!("too short")
    };
    assert!((needed - 3.502).abs() < 1e-6, "{needed}");
    let nan = TeeBranch { offset: f64::NAN, ..branch() };
    assert_eq!(PipeTee::new(MAIN, vec![nan]).expect_err("no number").reason(), "not-finite");
    assert_eq!(PipeTee::new(MAIN, vec![]).expect_err("none").reason(), "too-few-points");
    let twice = TeeBlend::Angles { values: vec![[0.0, 1.0], [2.0 * PI, 1.0]], tolerance: None };
    assert_eq!(refused(MAIN, vec![TeeBranch { blend: twice, ..branch() }]).reason(), "coincident-points");
}

/// What helps against too many pieces is what does: a law is named only where there is one, and the width of a branch that leaves hardly any room.
#[test]
fn advice_on_too_many_pieces_fits_what_was_asked_for() {
    let refused = |radius: f64, blend: TeeBlend| {
        let main = TeeMain { radius: 1.0, taper: 0.0, ends: [-10.0, 10.0] };
        made(main, vec![TeeBranch { blend, ..TeeBranch::upright(radius, 10.0, 0.1) }], None, TeeEnds::Flat)
            .expect_err("too many pieces")
            .to_string()
    };
    let one = || TeeBlend::Radius { radius: 0.1, tolerance: Some(1e-13) };
    let law = || TeeBlend::Angles { values: vec![[0.0, 0.3], [1.5, 0.1]], tolerance: Some(1e-13) };
    for (radius, blend, of_law, nearly_equal) in [
        (0.5, one(), false, false),
        (0.5, law(), true, false),
        (0.9998, one(), false, true),
        (0.9998, law(), true, true),
    ] {
        let message = refused(radius, blend);
        assert!(message.contains("the limit is 2048: use a larger tolerance"), "{message}");
        assert_eq!(message.contains("a law that changes less"), of_law, "{message}");
        assert_eq!(message.contains("a thinner branch"), nearly_equal, "{message}");
    }
}

/// Angles of a law are counted counter-clockwise seen from the end of the branch: a quarter turn is towards +y of a branch that goes up, and with the azimuth that
/// turns towards where +y was. What the balls are is measured by how far their centers are from the axis of the main pipe.
#[test]
fn angles_of_a_law_turn_from_the_end_of_the_main_pipe_to_plus_y() {
    let values = [[0.0, 0.5], [FRAC_PI_2, 0.8], [PI, 0.6], [1.5 * PI, 0.4]];
    for azimuth in [0.0, FRAC_PI_2] {
        let blend = TeeBlend::Angles { values: values.to_vec(), tolerance: None };
        let branch = TeeBranch { azimuth, blend, ..TeeBranch::upright(1.5, 10.0, 0.5) };
        let centers = made(MAIN, vec![branch], None, TeeEnds::Flat).expect("a tee").centers;
        let path = &centers.paths()[0];
        let [x, y] = [Vec3::X, Vec3::new(0.0, azimuth.cos(), azimuth.sin())];
        for (way, [_, radius]) in [x, y, -x, -y].into_iter().zip(values) {
            let places = (0..=4000).map(|k| path.point(f64::from(k) / 4000.0));
            let farthest = places.max_by(|a, b| a.to_vec().dot(way).total_cmp(&b.to_vec().dot(way))).expect("places");
            let found = farthest.y.hypot(farthest.z) - MAIN.radius;
            // Where the way reaches farthest is not quite where the law has its value.
            assert!((found - radius).abs() < 0.04, "{azimuth} {way:?}: {found} {radius}");
        }
    }
}

/// The least and the largest radius and the largest difference from the law, of a branch of 29, 25 or 15 on a pipe of 30.
#[test]
fn radii_follow_their_law_without_swings() {
    let main = TeeMain { radius: 30.0, taper: 0.0, ends: [-400.0, 400.0] };
    let quarters = |crotch: f64, flank: f64| {
        let values = vec![[0.0, crotch], [FRAC_PI_2, flank], [PI, crotch], [1.5 * PI, flank]];
        TeeBlend::Angles { values, tolerance: None }
    };
    for (radius, offset, crotch, flank) in [
        (29.0, 0.0, 3.0, 3.0),
        (29.7, 0.0, 3.0, 3.0),
        (28.0, 0.0, 3.0, 2.0),
        (20.0, 0.0, 3.0, 3.0),
        (15.0, 14.8, 2.0, 2.0),
        (15.0, 14.8, 3.0, 2.0),
    ] {
        let lateral = TeeBranch { offset, blend: quarters(crotch, flank), ..TeeBranch::upright(radius, 300.0, 1.0) };
        let tee = made(main, vec![lateral], None, TeeEnds::Flat).expect("a tee");
        let facts = tee.blends[0];
        // To a thousandth of the radius.
        assert!(facts.deviation <= 3e-3 && facts.radii[0] >= flank - 2e-3, "{radius}: {facts:?}");
        assert!(facts.radii[1] <= crotch + 3e-3, "{radius}: {facts:?}");
        assert!(facts.pieces < 600, "{radius}: {}", facts.pieces);
    }
    // As near as is asked for.
    let TeeBlend::Angles { values, .. } = law() else { panic!("a law") };
    for tolerance in [1e-3, 1e-5] {
        let blend = TeeBlend::Angles { values: values.clone(), tolerance: Some(tolerance) };
        let facts = solid(vec![TeeBranch { blend, ..branch() }]).blends[0];
        assert!(facts.deviation <= tolerance && facts.deviation > 1e-2 * tolerance, "{facts:?}");
        assert!(facts.radii[0] >= 0.4 - tolerance && facts.radii[1] <= 1.0 + tolerance);
    }
}

#[test]
fn radii_are_proved_to_be_positive() {
    let main = TeeMain { radius: 30.0, taper: 0.0, ends: [-80.0, 80.0] };
    let values = vec![[PI / 4.0, 0.01], [200.0 * PI / 180.0, 4.0]];
    let blend = TeeBlend::Angles { values, tolerance: None };
    let steep = TeeBranch { blend, ..TeeBranch::upright(25.0, 75.0, 1.0) };
    let facts = made(main, vec![steep], None, TeeEnds::Flat).expect("a tee").blends[0];
    // To a thousandth of the least radius, and of the largest.
    assert!(facts.radii[0] >= 0.01 - 1e-5 && facts.radii[1] <= 4.0 + 4e-3, "{facts:?}");
    let negative = TeeBranch { radius: -1.0, ..branch() };
    let error = PipeTee::new(MAIN, vec![branch(), negative]).expect_err("no tee");
    assert_eq!((error.reason(), error.index()), ("radius-not-positive", Some(1)));
    let error = made(MAIN, vec![TeeBranch::upright(2.0, 12.0, -1.0)], None, TeeEnds::Flat).expect_err("no tee");
    assert!(
        matches!(error, Error::Part(PartError::InBranch { branch: 0, what: cyclide::error::ErrorItem::Blend, .. })),
        "{error}"
    );
}

#[test]
fn what_rounding_would_spoil_is_refused() {
    let refused = |main, branch| made(main, vec![branch], None, TeeEnds::Flat).expect_err("no tee").reason();
    let far = TeeMain { ends: [1e12 - 14.0, 1e12 + 16.0], ..MAIN };
    assert_eq!(refused(far, TeeBranch { at: 1e12, ..branch() }), "below-rounding-of-place");
    let main = TeeMain { radius: 30.0, taper: 0.0, ends: [-90.0, 90.0] };
    assert_eq!(refused(main, TeeBranch::upright(29.999_96, 90.0, 6.0)), "tee-branch-too-wide");
    let beside = TeeBranch { offset: 9.999_95, ..TeeBranch::upright(20.0, 90.0, 2.0) };
    assert_eq!(refused(main, beside), "tee-branch-too-wide");
}

#[test]
fn branches_that_run_into_each_other_are_refused() {
    let main = TeeMain { radius: 50.0, taper: 0.0, ends: [-700.0, 400.0] };
    let stub = |blend: f64| TeeBranch { offset: -12.0, at: -310.0, ..TeeBranch::upright(8.0, 90.0, blend) };
    let lying = |length: f64, offset: f64| TeeBranch {
        offset,
        at: 140.0,
        angle: 172_f64.to_radians(),
        ..TeeBranch::upright(8.0, length, 0.2)
    };
    // The lying branch goes through the blend of the stub, and through its wall.
    for (blend, offset) in [(25.0, 4.5), (2.0, -10.0)] {
        let error = made(main, vec![stub(blend), lying(600.0, offset)], None, TeeEnds::Flat).expect_err("meet");
        let Error::Tee(TeeError::BranchesTooNear { first: 0, second: 1, point, .. }) = error else { panic!("{error}") };
        // The stub is that wide with its blend, and that high.
        let [x, y, z] = point;
        assert!((x + 310.0).abs() < 9.0 + blend && (y + 12.0).abs() < 9.0 + blend && z > 30.0 && z < 91.0, "{error}");
    }
    // Long branches whose axes meet far out.
    let thin = TeeMain { radius: 10.0, taper: 0.0, ends: [-150.0, 300.0] };
    let [upright, leaning] = [(0.0, FRAC_PI_2), (100.0, 0.75 * PI)].map(|(at, angle)| TeeBranch {
        at,
        angle,
        ..TeeBranch::upright(2.0, 1000.0, 0.5)
    });
    let error = made(thin, vec![upright, leaning], None, TeeEnds::Flat).expect_err("meet");
    assert_eq!(error.reason(), "tee-branches-meet");
    // Beside the stub, whose blend is small, or short of it, they are apart.
    for (blend, length, offset) in [(2.0, 600.0, 8.0), (10.0, 425.0, 4.5)] {
        let tee = made(main, vec![stub(blend), lying(length, offset)], None, TeeEnds::Flat).expect("apart");
        assert!(tee.body.is_solid());
    }
}

#[test]
fn equal_pipes_have_an_exact_blend_that_vanishes_at_the_flanks() {
    for (angle, azimuth, wall) in [(FRAC_PI_2, 0.0, None), (0.9, 0.0, Some(0.25)), (2.1, 1.3, None)] {
        let equal = TeeBranch { angle, azimuth, ..TeeBranch::upright(3.0, 14.0, 0.5) };
        let tee = made(MAIN, vec![equal.clone()], wall, TeeEnds::Flat).expect("a tee");
        assert!(tee.body.is_solid());
        let facts = tee.blends[0];
        assert!(facts.radii.iter().all(|radius| (radius - 0.5).abs() < 1e-12), "{facts:?}");
        let mut seen = 0;
        for face in tee.body.shells().flat_map(|shell| shell.faces()) {
            let FaceSurface::Rational(surface) = &face.surface else { continue };
            if surface.degrees() != [8, 2] {
                continue;
            }
            seen += 1;
            for (s, t) in [(0.3, 0.2), (0.5, 0.5), (0.8, 0.9)] {
                let (p, n) = (surface.point(s, t), normal(surface, face, s, t));
                // The inner skin has the larger ball on its inner side.
                let outside = off_axis(p + n * 0.5, (Point3::ORIGIN, Vec3::X)).length() - 3.5;
                let inside = off_axis(p - n * 0.75, (Point3::ORIGIN, Vec3::X)).length() - 3.5;
                let centre = if outside.abs() < inside.abs() { p + n * 0.5 } else { p - n * 0.75 };
                let off = off_axis(centre, (Point3::ORIGIN, Vec3::X)).length() - 3.5;
                assert!(off.abs() < 1e-11 && (off_branch(centre, &equal) - 0.5).abs() < 1e-11, "{off}");
            }
        }
        assert_eq!(seen, facts.pieces * if wall.is_some() { 2 } else { 1 });
        let joints = surface_joints(&tee.body.outer);
        assert!(joints.iter().all(|joint| joint.angle < 1e-7 || (joint.angle - FRAC_PI_2).abs() < 1e-9));
    }
    // Without a blend the branch adds its volume beyond half of Steinmetz's solid, 16/3 r³; a small ball adds little.
    let tee = made(MAIN, vec![TeeBranch::upright(3.0, 14.0, 1e-3)], None, TeeEnds::Flat).expect("a tee");
    let expected = PI * 9.0 * (30.0 + 14.0) - 8.0 / 3.0 * 27.0;
    let more = tee.body.outer.volume() - expected;
    assert!(more > 0.0 && more < 1.5e-5, "{more}");
    let error = made(MAIN, vec![TeeBranch { blend: law(), ..TeeBranch::upright(3.0, 14.0, 1.0) }], None, TeeEnds::Flat);
    assert_eq!(error.expect_err("a law").reason(), "tee-law-on-equal-pipes");
}

/// The way of the centers is as far from both axes as the radius of a ball on it, one curve for each branch, in their order.
#[test]
fn centres_are_a_path_for_each_branch() {
    let lateral = TeeBranch { angle: 0.9, at: 6.0, azimuth: PI, blend: law(), ..branch() };
    let made = solid(vec![TeeBranch { at: -5.0, offset: 0.4, ..branch() }, lateral]);
    let paths = made.centers.paths();
    assert_eq!(paths.len(), 2);
    let axis = Vec3::new(0.9_f64.cos(), 0.0, -0.9_f64.sin());
    for (path, (foot, axis), radii) in [
        (&paths[0], (Point3::new(-5.0, 0.4, 0.0), Vec3::Z), made.blends[0].radii),
        (&paths[1], (Point3::new(6.0, 0.0, 0.0), axis), made.blends[1].radii),
    ] {
        for k in 0..40 {
            let m = path.point_at_knot(f64::from(k) / 40.0);
            let way = m - foot;
            let [ball, other] = [m.y.hypot(m.z) - 3.0, (way - axis * way.dot(axis)).length() - 2.0];
            assert!(
                (ball - other).abs() < 1e-12 && radii[0] - 1e-12 < ball && ball < radii[1] + 1e-12,
                "{ball} {other}"
            );
        }
        let breaks = path.breaks();
        let velocity = |span: usize, s: f64| path.span_jet(span, s).d1 * (1.0 / (breaks[span + 1] - breaks[span]));
        let count = path.span_count();
        for span in 0..count {
            let [before, after] = [velocity(span, 1.0), velocity((span + 1) % count, 0.0)];
            assert!((before - after).length() <= 1e-8 * before.length(), "C1 at {span}");
        }
    }
}
