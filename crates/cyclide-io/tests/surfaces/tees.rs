//! Tees of pipes.

use super::{build, surface};

fn tee(branches: &str, rest: &str) -> Result<cyclide_io::document::BuiltObject, String> {
    build(&format!(
        r#""t": {{"type": "pipe-tee", "main": {{"radius": 12, "ends": [-50, 60]}}, "branches": [{branches}]{rest}}}"#
    ))
}

const BRANCH: &str = r#"{"radius": 8, "length": 40, "blend": {"crotch": 3, "flank": 2}}"#;

#[test]
fn tees_are_solids_with_a_report_on_their_blends() {
    let filled = surface(&tee(BRANCH, "").unwrap());
    assert!(filled.closed && filled.bodies == 1);
    let [blend] = &filled.blends[..] else { panic!("one blend: {:?}", filled.blends) };
    assert!((blend.radius.min - 2.0).abs() < 1e-9 && (blend.radius.max - 3.0).abs() < 1e-9, "{blend:?}");
    assert!(blend.tightest > 0.0 && blend.tightest < 1.0);
    assert!(blend.deviation > 0.0 && blend.deviation < 3e-3, "a thousandth of the radius: {blend:?}");
    let hollow = surface(&tee(BRANCH, r#", "wall": 1"#).unwrap());
    let closed = surface(&tee(BRANCH, r#", "wall": 1, "ends": "closed""#).unwrap());
    // Two disks of the main pipe and one of the branch, one thick.
    let disks = std::f64::consts::PI * (2.0 * 121.0 + 49.0);
    let more = closed.volume.unwrap() - hollow.volume.unwrap();
    assert!((more / disks - 1.0).abs() < 1e-10, "{more}");
    assert!(!surface(&tee(BRANCH, r#", "ends": "open""#).unwrap()).closed);
}

#[test]
fn tees_that_are_none_are_refused_in_their_place() {
    let leaning = r#"{"radius": 6, "length": 60, "angle": {"degrees": 22}, "blend": 4}"#;
    for (branches, rest, place, reason) in [
        (r#"{"radius": 8, "length": 40, "offset": 5, "blend": 2}"#, "", "branches[0]", "[tee-branch-too-wide]"),
        (r#"{"radius": 8, "length": 13, "blend": 2}"#, "", "branches[0]", "[tee-pipe-too-short]"),
        (r#"{"radius": 8, "length": 40, "at": 50, "blend": 2}"#, "", "main", "[tee-pipe-too-short]"),
        (leaning, "", "branches[0]", "[tee-blend-folds]"),
        (r#"{"radius": 11, "length": 40, "blend": {"least": 2}}"#, "", "branches[0]", "[tee-blend-too-large]"),
        (BRANCH, r#", "wall": 9"#, "wall", "[parameter-out-of-range]"),
        (BRANCH, r#", "wall": 1, "ends": "open""#, "", "`wall` makes a solid"),
        (
            r#"{"radius": 8, "length": 40, "blend": {"radius": 2, "flank": 3}}"#,
            "",
            "",
            "a blend requires exactly one of",
        ),
    ] {
        let error = tee(branches, rest).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{error}");
    }
    for (branches, place, reason) in [
        (r#"{"radius": 8, "length": 40, "blend": -1}"#, "branches[0].blend", "[radius-not-positive]"),
        (r#"{"radius": -8, "length": 40, "blend": 1}"#, "branches[0].radius", "[radius-not-positive]"),
        (
            r#"{"radius": 8, "taper": {"degrees": 89}, "length": 40, "blend": 1}"#,
            "branches[0].taper",
            "[parameter-out-of-range]",
        ),
        (r#"{"radius": 8, "taper": 0.4, "length": 40, "blend": 1}"#, "branches[0].taper", "apex at 18.9"),
        (r#"{"radius": 8, "length": 40, "angle": 90, "blend": 1}"#, "branches[0].angle", "[angle-out-of-range]"),
        (r#"{"radius": 8, "length": 40, "offset": 15, "blend": 1}"#, "branches[0]", "`pipe-crossing`"),
        (
            r#"{"radius": 12, "length": 40, "blend": {"crotch": 3, "flank": 2}}"#,
            "branches[0]",
            "[tee-law-on-equal-pipes]",
        ),
    ] {
        let error = tee(branches, "").unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{error}");
    }
    let reversed = r#""t": {"type": "pipe-tee", "main": {"radius": 12, "ends": [60, -50]}, "branches": [{"radius": 8, "length": 40, "blend": 2}]}"#;
    let error = build(reversed).unwrap_err();
    assert!(error.contains("t.main") && error.contains("[pipe-ends-reversed]"), "{error}");
    let both = format!("{BRANCH}, {}", BRANCH.replacen('{', r#"{"at": 20, "#, 1));
    let error = tee(&both, "").unwrap_err();
    assert!(error.contains("branches[1]") && error.contains("[tee-branches-meet]"), "{error}");
    let beside = format!("{BRANCH}, {}", BRANCH.replacen('{', r#"{"azimuth": {"degrees": 60}, "#, 1));
    let error = tee(&beside, "").unwrap_err();
    assert!(error.contains("branches[1]") && error.contains("radians round it"), "{error}");
}

#[test]
fn crosses_are_solids_that_add_up() {
    let opposite = |branch: &str| format!("{branch}, {}", branch.replacen('{', r#"{"azimuth": {"degrees": 180}, "#, 1));
    let equal = r#"{"radius": 12, "length": 40, "blend": 2}"#;
    for branch in [BRANCH, equal] {
        for rest in ["", r#", "wall": 1, "ends": "closed""#] {
            let [one, both] =
                [branch.to_owned(), opposite(branch)].map(|branches| surface(&tee(&branches, rest).unwrap()));
            assert!(both.closed && both.blends.len() == 2);
            let pipe = |radius: f64, length: f64| std::f64::consts::PI * radius * radius * length;
            let bare = pipe(12.0, 110.0) - if rest.is_empty() { 0.0 } else { pipe(11.0, 108.0) };
            let expected = bare + 2.0 * (one.volume.unwrap() - bare);
            assert!((both.volume.unwrap() / expected - 1.0).abs() < 1e-10, "{expected}");
        }
    }
}

#[test]
fn main_pipes_may_be_cones() {
    let on_cone = |taper: &str| {
        build(&format!(
            r#""t": {{"type": "pipe-tee", "main": {{"radius": 12, "taper": {taper}, "ends": [-50, 60]}}, "branches": [{BRANCH}]}}"#
        ))
    };
    let built = surface(&on_cone(r#"{"degrees": 4}"#).unwrap());
    // More than the cone alone, from 12 + 50 tan 4° to 12 - 60 tan 4°.
    let [a, b] = [-50.0, 60.0].map(|x: f64| 12.0 - x * 4_f64.to_radians().tan());
    let frustum = std::f64::consts::PI / 3.0 * 110.0 * (a * a + a * b + b * b);
    assert!(built.closed && built.volume.unwrap() > frustum + 4000.0);
    let error = on_cone("0.3").unwrap_err();
    assert!(error.contains("t.main") && error.contains("apex at 38.79"), "{error}");
}
