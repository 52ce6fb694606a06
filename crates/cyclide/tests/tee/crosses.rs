//! Branches beside each other on the main pipe: crosses, rows of branches, equal crosses.

use super::*;
use cyclide::error::TeeError;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A branch on a side of the main pipe, in degrees from up.
pub(super) fn on_side(degrees: f64, branch: TeeBranch) -> TeeBranch {
    TeeBranch { azimuth: degrees.to_radians(), ..branch }
}

/// The volume of a body with its hollows.
pub(super) fn volume(tee: &MadeTee) -> f64 {
    let hollows: f64 = tee.body.voids.iter().map(|hollow| hollow.volume().abs()).sum();
    tee.body.outer.volume() - hollows
}

/// What branches add to the main pipe each alone, and the main pipe: branches that are apart add nothing else.
pub(super) fn sum_of_tees(main: TeeMain, branches: &[TeeBranch], wall: Option<f64>, ends: TeeEnds) -> f64 {
    let frustum = |radius: f64, [from, to]: [f64; 2]| {
        let [a, b] = [from, to].map(|x| radius - x * main.taper.tan());
        PI / 3.0 * (to - from) * (a * a + a * b + b * b)
    };
    let hollow = wall.map_or(0.0, |wall| {
        let short = if ends == TeeEnds::Closed { wall } else { 0.0 };
        frustum(main.radius - wall / main.taper.cos(), [main.ends[0] + short, main.ends[1] - short])
    });
    let bare = frustum(main.radius, main.ends) - hollow;
    let alone = |branch: &TeeBranch| volume(&made(main, vec![branch.clone()], wall, ends).expect("a tee")) - bare;
    bare + branches.iter().map(alone).sum::<f64>()
}

fn check(branches: &[TeeBranch], wall: Option<f64>, ends: TeeEnds) -> MadeTee {
    let tee = made(MAIN, branches.to_vec(), wall, ends).expect("a cross");
    assert!(tee.body.is_solid() && tee.blends.len() == branches.len());
    // Quadrature to 1e-12 of bodies of a thousand.
    let expected = sum_of_tees(MAIN, branches, wall, ends);
    assert!((volume(&tee) / expected - 1.0).abs() < 1e-11, "{} {expected}", volume(&tee));
    let creases: Vec<f64> =
        branches.iter().flat_map(|branch| [0.0, branch.taper, -branch.taper]).map(|lean| FRAC_PI_2 + lean).collect();
    for shell in tee.body.shells() {
        for joint in surface_joints(shell) {
            let is_crease = creases.iter().any(|crease| (joint.angle - crease).abs() < 1e-9);
            assert!(joint.angle < 1e-7 || is_crease, "{}", joint.angle);
        }
        let surfaces = shell.faces().iter().filter_map(|face| match &face.surface {
            FaceSurface::Rational(surface) => Some(surface),
            FaceSurface::Cyclide(_) => None,
        });
        assert!(surfaces.into_iter().all(RationalBezierSurface::has_positive_weights));
    }
    if wall.is_none() {
        check_balls(&tee, &MAIN, branches);
    }
    tee
}

/// Crosses of every kind.
fn crosses() -> Vec<Vec<TeeBranch>> {
    let thin = || TeeBranch::upright(0.8, 10.0, 0.3);
    vec![
        // Four ways, of equal branches and of different ones.
        vec![branch(), on_side(180.0, branch())],
        vec![TeeBranch { blend: law(), ..branch() }, on_side(180.0, TeeBranch { at: 0.7, offset: 0.4, ..thin() })],
        // A wye, both laterals towards one end.
        vec![TeeBranch { angle: 0.9, ..branch() }, on_side(180.0, TeeBranch { angle: 0.9, blend: law(), ..branch() })],
        // Three round the pipe, one a cone; two on one side of a wide one.
        vec![
            TeeBranch::upright(1.5, 10.0, 0.3),
            on_side(120.0, TeeBranch { taper: 0.06, ..TeeBranch::upright(1.4, 10.0, 0.2) }),
            on_side(240.0, TeeBranch { at: 0.6, angle: 1.2, ..TeeBranch::upright(1.3, 10.0, 0.3) }),
        ],
        vec![
            TeeBranch::upright(2.6, 12.0, 0.5),
            on_side(185.0, TeeBranch { at: -1.7, ..thin() }),
            on_side(170.0, TeeBranch { at: 1.4, ..thin() }),
        ],
        // A header, staggered on both sides, and a branch apart from all of it.
        vec![
            TeeBranch { at: -6.0, ..branch() },
            TeeBranch { at: 0.5, ..branch() },
            on_side(200.0, TeeBranch { at: -3.0, ..branch() }),
            on_side(170.0, TeeBranch { at: 4.0, ..branch() }),
            on_side(90.0, TeeBranch { at: 11.0, ..branch() }),
        ],
        // A branch as wide as the main pipe, and a thinner one opposite.
        vec![TeeBranch { angle: 1.2, ..TeeBranch::upright(3.0, 14.0, 0.5) }, on_side(180.0, branch())],
    ]
}

#[test]
fn crosses_are_solids_that_add_up() {
    for branches in crosses() {
        check(&branches, None, TeeEnds::Flat);
    }
}

#[test]
fn crosses_have_walls_and_ends() {
    let crosses = crosses();
    for (branches, ends) in [(&crosses[1], TeeEnds::Flat), (&crosses[3], TeeEnds::Closed)] {
        let tee = check(branches, Some(0.2), ends);
        assert_eq!(tee.body.voids.len(), usize::from(ends == TeeEnds::Closed));
    }
    let open = made(MAIN, crosses[0].clone(), None, TeeEnds::Open).expect("a cross");
    let shell = &open.body.outer;
    let mut ends = [0; 4];
    for (edge, faces) in shell.edges().iter().zip(shell.faces_along_edges()) {
        let p = shell.vertices()[edge.start];
        let off = [p.x + 14.0, p.x - 16.0, p.z - 12.0, p.z + 12.0];
        let at = (0..4).find(|&k| off[k].abs() < 1e-12);
        if faces.len() == 1 {
            ends[at.expect("only ends are free")] += 1;
        }
    }
    assert!(ends.iter().all(|&edges| edges > 7), "{ends:?}");
}

#[test]
fn equal_crosses_share_their_flanks() {
    let equal = |angle: f64, blend: f64| TeeBranch { angle, ..TeeBranch::upright(3.0, 14.0, blend) };
    for (branches, wall, ends) in [
        (vec![equal(FRAC_PI_2, 0.5), on_side(180.0, equal(FRAC_PI_2, 0.5))], None, TeeEnds::Flat),
        (vec![equal(0.9, 0.4), on_side(180.0, equal(1.4, 0.7))], None, TeeEnds::Flat),
        (vec![on_side(40.0, equal(1.0, 0.5)), on_side(220.0, equal(PI - 1.0, 0.5))], Some(0.25), TeeEnds::Closed),
    ] {
        let tee = check(&branches, wall, ends);
        // All of the main pipe is ruled: no part of it is beside a hole or behind it.
        for (shell, depth) in tee.body.shells().zip([0.0, wall.unwrap_or(0.0)]) {
            let is_flank = |p: &Point3| p.x.abs() < 1e-12 && (p.y.hypot(p.z) - MAIN.radius + depth).abs() < 1e-12;
            assert_eq!(shell.vertices().iter().filter(|p| is_flank(p)).count(), 2, "where four pipes touch");
        }
    }
    // With a branch apart.
    let apart = vec![equal(FRAC_PI_2, 0.5), on_side(180.0, equal(FRAC_PI_2, 0.5)), TeeBranch { at: 10.0, ..branch() }];
    check(&apart, None, TeeEnds::Flat);
}

#[test]
fn scale_and_place_change_no_cross() {
    let volume = |scale: f64, turn: f64, at: f64| {
        let main = TeeMain { radius: 3.0 * scale, taper: 0.0, ends: [(-14.0 + at) * scale, (16.0 + at) * scale] };
        let branch = |degrees: f64, radius: f64, offset: f64| TeeBranch {
            angle: 1.0,
            offset: offset * scale,
            at: at * scale,
            azimuth: turn + degrees.to_radians(),
            ..TeeBranch::upright(radius * scale, 12.0 * scale, 0.4 * scale)
        };
        let branches = vec![branch(0.0, 2.0, 0.3), branch(175.0, 1.2, -0.2)];
        made(main, branches, None, TeeEnds::Flat).expect("a cross").body.outer.volume() / scale.powi(3)
    };
    let own = volume(1.0, 0.0, 0.0);
    for (scale, turn, at) in [(1e-6, 0.0, 0.0), (1e6, 0.0, 0.0), (1.0, 2.3, 0.0), (1.0, -9.0, 500.0)] {
        // Quadrature to 1e-12, in coordinates up to 500.
        assert!((volume(scale, turn, at) / own - 1.0).abs() < 1e-10, "{scale} {turn} {at}");
    }
}

#[test]
fn branches_without_room_beside_each_other_are_refused() {
    let refused = |branches| made(MAIN, branches, None, TeeEnds::Flat).expect_err("no room");
    let Error::Tee(TeeError::BranchesMeet { first: 0, second: 1, distance, round, .. }) =
        refused(vec![on_side(60.0, TeeBranch { at: 1.0, ..branch() }), branch()])
    else {
        panic!("they overlap")
    };
    // Contacts reach 2.5 along and asin(2.5/3.5) round to both sides.
    assert!((distance + 4.0).abs() < 1e-3, "{distance}");
    let overlap = 2.0 * (2.5_f64 / 3.5).asin() - PI / 3.0;
    assert!((round + overlap).abs() < 1e-3, "{round}");
    // Two are apart, but a third, behind them, reaches across all that is between them, and a fourth is beside all.
    let between = || TeeBranch { at: 5.0, ..TeeBranch::upright(1.5, 10.0, 0.3) };
    let beside = |at: f64| TeeBranch { at, ..TeeBranch::upright(2.2, 10.0, 0.3) };
    let pair = || [0.0, 120.0].map(|degrees| on_side(degrees, TeeBranch::upright(1.5, 10.0, 0.3)));
    let four = |at: f64| pair().into_iter().chain([on_side(60.0, between()), on_side(240.0, beside(at))]).collect();
    assert_eq!(refused(four(2.5)), Error::Tee(TeeError::NoFreeLine { first: 0, second: 1 }));
    // Beside the pair only it is fine.
    assert!(made(MAIN, four(-1.0), None, TeeEnds::Flat).is_ok_and(|tee| tee.body.is_solid()));
    // A row of two that reaches far round: the line beyond the first would be 169 degrees from the middle of the second.
    let far = vec![
        on_side(-93.0, TeeBranch { at: -2.3, ..TeeBranch::upright(2.4, 10.0, 0.3) }),
        TeeBranch { at: 2.7, ..TeeBranch::upright(1.8, 10.0, 0.3) },
        on_side(125.0, TeeBranch { at: 0.5, ..TeeBranch::upright(1.0, 10.0, 0.3) }),
    ];
    assert_eq!(refused(far), Error::Tee(TeeError::NoFreeLine { first: 0, second: 1 }));
    // Equal pipes are opposite each other exactly, or apart.
    let equal = || TeeBranch::upright(3.0, 14.0, 0.5);
    for other in [on_side(179.0, equal()), on_side(180.0, TeeBranch { at: 0.01, ..equal() })] {
        let error = refused(vec![equal(), other]);
        let Error::Tee(TeeError::EqualBranchesNotOpposite { first: 0, second: 1, angle, along, needed }) = error else {
            panic!("{error}")
        };
        // One is off by a degree, the other by 0.01 along the pipe: radii and blends on both sides are between them.
        assert!((angle.to_degrees() - 1.0).abs() < 1e-9 || (along - 0.01).abs() < 1e-12, "{error}");
        assert!(needed > 6.0 && needed < 8.0, "{needed}");
        let moved = TeeBranch { at: 1.001 * needed, ..equal() };
        let long = TeeMain { ends: [-12.0, 20.0], ..MAIN };
        assert!(made(long, vec![equal(), on_side(179.0, moved)], None, TeeEnds::Flat).is_ok());
    }
    // Radii that differ by rounding are one.
    let third = TeeBranch::upright(0.1 + 0.2, 1.4, 0.05);
    assert!(third.radius > 0.3);
    let small = TeeMain { radius: 0.3, taper: 0.0, ends: [-1.2, 1.2] };
    assert!(made(small, vec![third], None, TeeEnds::Flat).is_ok_and(|tee| tee.body.is_solid()));
    // Beside one of them, which ends before the other.
    let lateral = on_side(180.0, TeeBranch { angle: 0.6, ..TeeBranch::upright(3.0, 20.0, 0.3) });
    let error = refused(vec![equal(), lateral, TeeBranch { at: 5.0, ..TeeBranch::upright(0.8, 10.0, 0.2) }]);
    assert_eq!(error, Error::Tee(TeeError::NoFreeLine { first: 1, second: 2 }));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]

    /// Two to four branches anywhere: what is made adds up, what is not has no room.
    #[test]
    fn random_crosses_add_up(
        numbers in prop::collection::vec((0.15..0.9_f64, -1.0..1.0_f64, 0.0..360.0_f64, 0.6..2.5_f64, -2.5..2.5_f64, -0.08..0.05_f64), 2..5)
    ) {
        let count = numbers.len() as f64;
        let branches: Vec<TeeBranch> = numbers
            .iter()
            .enumerate()
            .map(|(k, &(size, side, degrees, angle, at, taper))| {
                let radius = 3.0 * (size * PI / count).sin().min(size);
                let blend = TeeBlend::Radius { radius: 0.1 * radius, tolerance: Some(0.01 * radius) };
                let offset = 0.5 * side * (3.0 - radius);
                let azimuth = (degrees / count + 360.0 * k as f64 / count).to_radians();
                TeeBranch { angle, offset, at, azimuth, taper, blend, ..TeeBranch::upright(radius, 12.0, 1.0) }
            })
            .collect();
        match made(MAIN, branches.clone(), None, TeeEnds::Flat) {
            Ok(tee) => {
                prop_assert!(tee.body.is_solid());
                let expected = sum_of_tees(MAIN, &branches, None, TeeEnds::Flat);
                prop_assert!((volume(&tee) / expected - 1.0).abs() < 1e-11);
            }
            Err(error) => prop_assert!(["tee-branches-meet", "tee-no-free-line", "tee-pipe-too-short", "tee-blend-folds", "radius-not-positive"].contains(&error.reason()), "{error}"),
        }
    }
}
