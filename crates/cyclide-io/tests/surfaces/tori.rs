//! Curves on tori, and what is made of them.

use cyclide::{
    Aabb, Point3, Vec3,
    curve::ParamCurve,
    model::CurveObject,
    surface::{Torus, TorusSpline},
};
use cyclide_io::{
    Report,
    document::BuiltObject,
    report::{CurvesReport, GeometryReport, Spacing, sample},
};

use super::{build, surface};

const RING: &str = r#""ring": {"type": "cyclide", "a": 40, "mu": 12, "center": [5, 0, 1], "axis": [0, 1, 1]}"#;
const HERE: &str = r#""torus": {"major_radius": 40, "minor_radius": 12}"#;

fn report(built: &BuiltObject) -> CurvesReport {
    let report = Report::new(cyclide::model::Units::Millimetre, std::slice::from_ref(built), None);
    let Some(GeometryReport::Curves(curves)) = report.objects.into_values().next().map(|o| o.geometry) else {
        panic!("curves")
    };
    *curves
}

fn as_torus_spline(curve: &CurveObject) -> Option<&TorusSpline> {
    match curve {
        CurveObject::TorusSpline(spline) => Some(spline),
        _ => None,
    }
}

fn splines(built: &BuiltObject) -> Vec<&TorusSpline> {
    let splines: Vec<_> = built.item.curves().iter().filter_map(as_torus_spline).collect();
    assert_eq!(splines.len(), built.item.curves().len());
    splines
}

fn spline(fields: &str) -> Result<BuiltObject, String> {
    build(&format!(r#""s": {{"type": "torus-spline", {HERE}, {fields}}}"#))
}

fn reasons(built: &BuiltObject) -> Vec<&str> {
    built.remarks.iter().map(|remark| remark.reason).collect()
}

/// The same four places as angles in degrees and in radians, and as points near the torus.
#[test]
fn points_and_angles_give_one_curve() {
    let torus = Torus::new(cyclide::Frame::WORLD, 40.0, 12.0).unwrap();
    let degrees = [[0.0, 20.0], [70.0, 80.0], [140.0, -30.0], [250.0, -170.0]];
    let radians = degrees.map(|pair: [f64; 2]| pair.map(f64::to_radians));
    let points = radians.map(|[a, b]| torus.point(torus.place_of_angles(a, b)).to_array());
    let near = points.map(|[x, y, z]| [x, y, z + 3e-7]);
    let built = |fields: String| spline(&format!(r#"{fields}, "closed": true, "winding": [1, -1]"#)).unwrap();
    let all = [
        built(format!(r#""angles": {{"degrees": {degrees:?}}}"#)),
        built(format!(r#""angles": {radians:?}"#)),
        built(format!(r#""points": {points:?}"#)),
        built(format!(r#""points": {near:?}"#)),
    ];
    for (made, tolerance) in all.iter().zip([1e-12, 1e-12, 1e-12, 1e-5]) {
        let one = splines(made)[0];
        assert_eq!(one.winding(), Some([1, -1]));
        for (k, p) in points.iter().enumerate() {
            assert!(one.jet_at_knot(k as f64).point.distance(Point3::from(*p)) <= tolerance, "{k}");
        }
        assert!(reasons(made).is_empty(), "{:?}", made.remarks);
    }
    let told = report(&all[3]).torus.unwrap();
    assert!(told.moved.unwrap() > 1e-8 && told.moved.unwrap() < 4e-7, "{told:?}");
    assert!(told.off < 1e-12 && told.velocity_jump < 1e-10 && told.winding == [Some([1, -1])]);
    assert_eq!(told.types.values().sum::<usize>(), splines(&all[3])[0].pieces().len());
}

/// Velocities in space, the same as rates of the angles, knots, turns of each step, several contours.
#[test]
fn directions_knots_and_turns_reach_the_kernel() {
    let with = |fields: &str| spline(&format!(r#""angles": [[0, 0], [1, 0.5], [2, 0]], {fields}"#)).unwrap();
    let rates = with(r#""rates": {"degrees": [[90, 0], "free", [0, 45]]}, "knots": [0, 2, 3]"#);
    let one = splines(&rates)[0];
    // At the longitude 0 on the outer side: 52 round the axis for each radian.
    let start = one.jet_at_knot(0.0).d1;
    assert!((start - Vec3::new(0.0, 52.0 * std::f64::consts::FRAC_PI_2, 0.0)).length() < 1e-12, "{start:?}");
    let end = one.jet_at_knot(3.0).d1;
    assert!((end - Vec3::new(0.0, 0.0, 12.0 * std::f64::consts::FRAC_PI_4)).length() < 1e-11, "{end:?}");
    let tangents = with(&format!(
        r#""tangents": [[5, {}, 0], "free", [0, 0, {}]], "knots": [0, 2, 3]"#,
        52.0 * std::f64::consts::FRAC_PI_2,
        12.0 * std::f64::consts::FRAC_PI_4
    ));
    let other = splines(&tangents)[0];
    assert!((0..50).all(|k| one.point(f64::from(k) / 49.0).distance(other.point(f64::from(k) / 49.0)) < 1e-10));
    let turned = with(r#""winding": [[1, 0], [0, -2]]"#);
    let last = splines(&turned)[0].pieces().len() - 1;
    let way = splines(&turned)[0].unrolled_place(last, 1.0);
    assert!((way.x - (1.0 + std::f64::consts::PI)).abs() < 1e-12, "{way:?}");
    let two = spline(r#""points": [[[52, 0, 0], [0, 52, 0]], [[-52, 0, 0], [0, -52, 0]]]"#).unwrap();
    assert_eq!(splines(&two).len(), 2);
}

#[test]
fn repeated_points_are_merged_or_get_loops() {
    let merged = spline(
        r#""angles": {"degrees": [[0, 0], [50, 20], [50, 20], [90, 0], [0, 360]]}, "closed": true,
        "rates": [[1, 0], "free", [0, 1], "free", [1, 0]], "knots": [0, 1, 1.5, 2, 2.5, 3]"#,
    )
    .unwrap();
    assert_eq!(reasons(&merged), ["points-merged", "closing-point-merged"]);
    assert_eq!(merged.remarks[0].place.as_deref(), Some("objects.s.angles.degrees[2]"), "{:?}", merged.remarks);
    assert_eq!(splines(&merged)[0].segments().len(), 3);
    let looped = spline(r#""angles": [[0, 0], [1, 0], [1, 0], [2, 0.5]], "loops": true"#).unwrap();
    assert!(splines(&looped)[0].segments().len() == 3 && reasons(&looped).is_empty());
    let idle = spline(r#""angles": [[0, 0], [1, 0], [2, 0.5]], "loops": true"#).unwrap();
    assert_eq!(reasons(&idle), ["no-effect"]);
}

/// The torus by name is that of the object, wherever it stands.
#[test]
fn a_torus_is_named() {
    let made = build(&format!(r#"{RING}, "k": {{"type": "torus-knot", "torus": "ring", "turns": [2, 3]}}"#)).unwrap();
    let torus = splines(&made)[0].torus();
    assert_eq!((torus.major_radius(), torus.minor_radius()), (40.0, 12.0));
    assert!(torus.frame().origin() == Point3::new(5.0, 0.0, 1.0) && torus.frame().z().y > 0.7);
    for (objects, message) in [
        (
            r#""t": {"type": "cyclide", "a": 40, "c": 3, "mu": 12}, "k": {"type": "torus-knot", "torus": "t", "turns": [2, 3]}"#,
            "`t` is a `cyclide` with `c` = 3",
        ),
        (
            r#""t": {"type": "circle", "center": [0, 0], "radius": 1}, "k": {"type": "torus-knot", "torus": "t", "turns": [2, 3]}"#,
            "`t` is of type `circle`: a torus is a `cyclide`",
        ),
        (
            r#""k": {"type": "torus-knot", "torus": "rinng", "turns": [2, 3]}, "ring": {"type": "cyclide", "a": 40, "mu": 12}"#,
            "there is no object `rinng`; did you mean `ring`?",
        ),
    ] {
        let error = build(objects).unwrap_err();
        assert!(error.contains(message) && error.contains("objects.k.torus"), "{error}");
    }
}

/// The image of a torus under a similarity is named as well, also that of an image: the curve lies on it, and begins at the image of its start.
#[test]
fn an_image_of_a_torus_is_named() {
    let steps = r#"[{"rotation": {"axis": [1, 2, 0], "angle": 0.7}}, {"scale": {"factor": 2}}]"#;
    let images = format!(
        r#""i": {{"type": "transform", "of": "ring", "steps": {steps}}}, "j": {{"type": "transform", "of": "i", "steps": [{{"mirror": {{"normal": [0, 1, 3]}}}}]}}"#
    );
    let knot = |of: &str| {
        build(&format!(r#"{RING}, {images}, "k": {{"type": "torus-knot", "torus": "{of}", "turns": [2, 3]}}"#))
    };
    let (on_ring, on_image) = (knot("ring").unwrap(), knot("j").unwrap());
    let torus = splines(&on_image)[0].torus();
    assert!((torus.major_radius() - 80.0).abs() < 1e-12 && (torus.minor_radius() - 24.0).abs() < 1e-12);
    let start = |made: &BuiltObject| splines(made)[0].point(0.0);
    let maps = [
        cyclide::conformal::Mobius::rotation(Point3::ORIGIN, Vec3::new(1.0, 2.0, 0.0), 0.7),
        cyclide::conformal::Mobius::similarity(cyclide::Quat::ONE, 2.0, Vec3::ZERO),
        cyclide::conformal::Mobius::reflection(Point3::ORIGIN, Vec3::new(0.0, 1.0, 3.0)),
    ];
    let moved = maps.into_iter().fold(start(&on_ring), |p, map| map.unwrap().map_point(p).unwrap());
    assert!(moved.distance(start(&on_image)) < 1e-12, "{moved:?}");
    let inverted = format!(
        r#"{RING}, "i": {{"type": "transform", "of": "ring", "steps": [{{"translation": [1, 0, 0]}}, {{"inversion": {{"center": [300, 0, 0], "radius": 100}}}}]}}, "k": {{"type": "torus-knot", "torus": "i", "turns": [2, 3]}}"#
    );
    let error = build(&inverted).unwrap_err();
    assert!(
        error.contains("objects.k.torus") && error.contains("step 1 of the `transform` `i` is not a similarity"),
        "{error}"
    );
}

/// Angles of many turns are those of the turn: in degrees exactly, and the largest radians are refused by their limit.
#[test]
fn whole_turns_do_not_matter() {
    let spline = |angles: &str| build(&format!(r#""s": {{"type": "torus-spline", {HERE}, "angles": {angles}}}"#));
    let near = spline(r#"{"degrees": [[30, 40], [100, 20], [150, 200]]}"#).unwrap();
    let far = spline(r#"{"degrees": [[3600030, -35999960], [100, 7220], [36000000150, 200]]}"#);
    let far = far.unwrap();
    for t in [0.0, 0.2, 0.45] {
        assert!(splines(&near)[0].point(t).distance(splines(&far)[0].point(t)) < 1e-13, "{t}");
    }
    let error = spline("[[3e6, 0], [1, 1]]").unwrap_err();
    assert!(error.contains("[parameter-out-of-range]") && error.contains("angles"), "{error}");
}

/// Every circle passes through its point, on the torus; Villarceau circles have the major radius.
#[test]
fn circles_of_all_families() {
    for (family, radius) in [("villarceau", 40.0), ("mirror-villarceau", 40.0), ("parallel", 46.0), ("meridian", 12.0)]
    {
        let made = build(&format!(
            r#""c": {{"type": "torus-circle", {HERE}, "family": "{family}", "at": [0, {{"degrees": 60}}]}}"#
        ))
        .unwrap();
        let CurveObject::Circle(circle) = &made.item.curves()[0] else { panic!("a circle") };
        assert!((circle.radius() - radius).abs() < 1e-12, "{family}: {}", circle.radius());
        assert!(circle.point(0.0).distance(Point3::new(46.0, 0.0, 12.0 * 0.75_f64.sqrt())) < 1e-12, "{family}");
    }
    let near = |tolerance: &str| {
        build(&format!(r#""c": {{"type": "torus-circle", {HERE}, "through": [53, 0, 0]{tolerance}}}"#))
    };
    assert!(near("").unwrap_err().contains("objects.c.through"));
    assert_eq!(reasons(&near(r#", "tolerance": 1.5"#).unwrap()), ["moved-onto-torus"]);
}

#[test]
fn curves_are_laid_flat_with_what_became_of_them() {
    let knot = format!(r#""k": {{"type": "torus-knot", {HERE}, "turns": [2, 3]}}"#);
    let flat = build(&format!(r#"{knot}, "u": {{"type": "unrolled", "of": "k", "border": true}}"#)).unwrap();
    assert_eq!(reasons(&flat), ["cut-at-seam"]);
    let told = report(&flat);
    let unrolled = told.unrolled.unwrap();
    assert_eq!((told.contours, unrolled.cuts, unrolled.map), (5, 4, "belt"));
    assert!((unrolled.size[0] / (80.0 * std::f64::consts::PI) - 1.0).abs() < 1e-15);
    let size = flat.item.curves().iter().map(|c| cyclide::curve::bounds(c.as_curve())).reduce(Aabb::union).unwrap();
    assert!((size.diagonal() - unrolled.size[0].hypot(unrolled.size[1])).abs() < 1e-9, "lines are inside the border");
    assert!(unrolled.stretch[0] >= 40.0 / 52.0 - 1e-12 && unrolled.stretch[1] <= 40.0 / 28.0 + 1e-12);
    let elsewhere = build(&format!(
        r#"{knot}, "u": {{"type": "unrolled", "of": "k", "map": "conformal", "seam": [{{"degrees": 45}}, 0], "tolerance": 0.01}}"#
    ))
    .unwrap();
    assert_eq!(report(&elsewhere).unrolled.unwrap().map, "conformal");
}

/// A torch that stands off a seam: the same normals, two further out.
#[test]
fn samples_of_parallel_curves_have_the_normals_of_the_torus() {
    let made = build(&format!(
        r#""k": {{"type": "torus-knot", {HERE}, "turns": [2, 3]}}, "off": {{"type": "offset", "of": "k", "distance": 2}}"#
    ))
    .unwrap();
    let table = sample(&made, 41, Spacing::Parameter);
    let knot = build(&format!(r#""k": {{"type": "torus-knot", {HERE}, "turns": [2, 3]}}"#)).unwrap();
    let torus = splines(&knot)[0].torus();
    assert!(table.starts_with("t,x,y,z,tangent_x") && table.lines().count() == 42);
    for line in table.lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|f| f.parse().unwrap_or(f64::NAN)).collect();
        let (p, n) = (Point3::new(row[1], row[2], row[3]), Vec3::new(row[11], row[12], row[13]));
        assert!((torus.distance(p) - 2.0).abs() < 1e-11 && torus.distance(p - n * 2.0).abs() < 1e-11);
        let t = Vec3::new(row[4], row[5], row[6]);
        assert!(n.dot(t).abs() < 1e-11 && (t.cross(n) - Vec3::new(row[14], row[15], row[16])).length() < 1e-11);
    }
}

/// The frames along a seam: normals of the torus, at even distances along the curve.
#[test]
fn samples_have_the_normals_of_the_torus() {
    let made = build(&format!(r#""k": {{"type": "torus-knot", {HERE}, "turns": [2, 3]}}"#)).unwrap();
    let table = sample(&made, 41, Spacing::Length);
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some(
            "t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion,normal_x,normal_y,normal_z,binormal_x,binormal_y,binormal_z"
        )
    );
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|f| f.parse().unwrap_or(f64::NAN)).collect()).collect();
    assert_eq!(rows.len(), 41);
    let torus = splines(&made)[0].torus();
    for row in &rows {
        let (p, t, n) = (&row[1..4], &row[4..7], &row[11..14]);
        let dot: f64 = t.iter().zip(n).map(|(a, b)| a * b).sum();
        assert!(dot.abs() < 1e-12);
        // A step along the normal is that far from the torus.
        let out = Point3::new(p[0] + 0.5 * n[0], p[1] + 0.5 * n[1], p[2] + 0.5 * n[2]);
        assert!((torus.distance(out) - 0.5).abs() < 1e-12);
    }
    let curve = splines(&made)[0];
    let step = cyclide::curve::length(curve) / 40.0;
    let between = |a: f64, b: f64| -> f64 {
        (0..200)
            .map(|k| {
                curve
                    .point(a + (b - a) * f64::from(k) / 200.0)
                    .distance(curve.point(a + (b - a) * f64::from(k + 1) / 200.0))
            })
            .sum()
    };
    for pair in rows.windows(2) {
        assert!((between(pair[0][0], pair[1][0]) / step - 1.0).abs() < 1e-4, "constant speed");
    }
}

/// A curve at a distance along the normal of its torus: of the outer equator the circle that is so much larger.
#[test]
fn curves_of_a_torus_have_parallel_curves() {
    let offset = |turns: &str, fields: &str| {
        let knot = format!(r#""k": {{"type": "torus-knot", "torus": "ring", "turns": {turns}}}"#);
        build(&format!(r#"{RING}, {knot}, "o": {{"type": "offset", "of": "k", {fields}}}"#))
    };
    for (distance, radius) in [("2", 54.0), ("-3.5", 48.5)] {
        let made = offset("[1, 0]", &format!(r#""distance": {distance}"#)).unwrap();
        let told = report(&made);
        assert!(made.bodies.is_empty() && told.closed && told.contours == 1);
        assert!((told.length / (std::f64::consts::TAU * radius) - 1.0).abs() < 1e-9, "{}", told.length);
    }
    assert!(report(&offset("[2, 3]", r#""distance": 2"#).unwrap()).closed);
    let error = offset("[2, 3]", r#""distance": -12"#).unwrap_err();
    assert!(error.contains("objects.o.distance") && error.contains("[parameter-out-of-range]"), "{error}");
    assert!(offset("[2, 3]", r#""distance": 2, "thick": true"#).unwrap_err().contains("objects.o.thick"));
    let line =
        r#""l": {"type": "polyline", "points": [[0, 0], [1, 0]]}, "o": {"type": "offset", "of": "l", "distance": 1}"#;
    assert!(build(line).unwrap_err().contains("has a parallel curve"));
}

#[test]
fn seams_are_solids_and_say_where_they_meet() {
    let curve = r#""m": {"type": "torus-spline", "torus": "ring", "angles": {"degrees": [[60, 0], [90, 50], [120, 0], [90, -50]]}, "closed": true}"#;
    let seam = |fields: &str| build(&format!(r#"{RING}, {curve}, "s": {{"type": "torus-seam", "of": "m", {fields}}}"#));
    let made = seam(r#""width": 2, "height": [-0.5, 0.5]"#).unwrap();
    let told = surface(&made);
    assert!(told.closed && told.volume.is_some_and(|v| v > 0.0) && reasons(&made).is_empty());
    let narrow = r#""k": {"type": "torus-knot", "torus": "ring", "turns": [1, 40]}"#;
    let seam_of = |curve: &str, width: f64| {
        let fields = r#""height": [-0.5, 0.5], "tolerance": 0.2"#;
        build(&format!(r#"{RING}, {curve}, "s": {{"type": "torus-seam", "of": "k", "width": {width}, {fields}}}"#))
    };
    let error = seam_of(narrow, 5.0).unwrap_err();
    assert!(error.contains("objects.s.width") && error.contains("[seam-meets-itself]"), "{error}");
    // Circles of all families have seams, and are laid flat.
    for (family, length) in [("villarceau", 80.0), ("mirror-villarceau", 80.0), ("parallel", 92.0), ("meridian", 24.0)]
    {
        let circle = format!(
            r#""k": {{"type": "torus-circle", "torus": "ring", "family": "{family}", "at": [0.3, {{"degrees": 60}}]}}"#
        );
        let volume = surface(&seam_of(&circle, 2.0).unwrap()).volume.unwrap();
        // The middle line has the volume of the section, to a part of the height over the radius.
        assert!((volume / (2.0 * length * std::f64::consts::PI) - 1.0).abs() < 0.01, "{family}: {volume}");
        let flat = build(&format!(r#"{RING}, {circle}, "u": {{"type": "unrolled", "of": "k"}}"#)).unwrap();
        assert!((report(&flat).unrolled.unwrap().length_on_torus / (length * std::f64::consts::PI) - 1.0).abs() < 1e-9);
    }
    for (fields, place, reason) in [
        (r#""width": 90, "height": [-0.5, 0.5]"#, "objects.s.width", "[seam-too-wide]"),
        (r#""width": 0, "height": [-0.5, 0.5]"#, "objects.s.width", "[parameter-out-of-range]"),
        (r#""width": 2, "height": [0.5, 0.5]"#, "objects.s.height", "[parameter-out-of-range]"),
        (r#""width": 2, "height": [-12, 0.5]"#, "objects.s.height", "[parameter-out-of-range]"),
        (r#""width": 2, "height": [-0.5, 0.5], "tolerance": 0"#, "objects.s.tolerance", "[tolerance-not-positive]"),
    ] {
        let error = seam(fields).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{place} {reason}: {error}");
    }
    let once_round = |rest: &str| {
        let angles = "[[0, 0], [6.283185307179586, 0]]";
        build(&format!(r#""w": {{"type": "torus-spline", {HERE}, "angles": {angles}{rest}}}"#))
    };
    let error = once_round("").unwrap_err();
    assert!(error.contains("`winding`") && error.contains("[coincident-points]"), "{error}");
    assert!(once_round(r#", "winding": [[1, 0]]"#).is_ok());
    let error = build(r#""c": {"type": "circle", "center": [0, 0], "radius": 1}, "s": {"type": "torus-seam", "of": "c", "width": 1, "height": [0, 1]}"#).unwrap_err();
    assert!(error.contains("`c` is of type `circle`: only a `torus-spline`"), "{error}");
}

#[test]
fn quartics_of_a_type() {
    let quartic = |families: &str, ratio: &str| {
        build(&format!(r#""q": {{"type": "torus-quartic", {HERE}, "families": {families}, "ratio": {ratio}}}"#))
    };
    let told = report(&quartic(r#"["parallel", "meridian"]"#, "3").unwrap()).torus.unwrap();
    assert_eq!(told.winding, vec![Some([1, 1])]);
    // The ratio is that of the second family given.
    let [one, other] = [(r#"["parallel", "villarceau"]"#, "4"), (r#"["villarceau", "parallel"]"#, "0.25")]
        .map(|(families, ratio)| quartic(families, ratio).unwrap());
    assert!(splines(&one)[0].point(0.3).distance(splines(&other)[0].point(0.3)) < 1e-12);
    for (families, ratio, place, message) in [
        (r#"["parallel", "parallel"]"#, "2", "objects.q.families", "two different families"),
        (r#"["villarceau", "mirror-villarceau"]"#, "1", "objects.q.ratio", "[not-coprime]"),
        (r#"["parallel", "meridian"]"#, "0", "objects.q.ratio", "[parameter-out-of-range]"),
    ] {
        let error = quartic(families, ratio).unwrap_err();
        assert!(error.contains(place) && error.contains(message), "{error}");
    }
}

#[test]
fn two_types_make_the_loop_of_four_points() {
    let fields = r#""angles": [[0, 0.8], [1, 0], [0, -0.8], [-1, 0]], "closed": true, "method": "two-types""#;
    let made = spline(&format!(r#"{fields}, "rates": [[1.4, 0], [0, -1.2], [-1.4, 0], [0, 1.2]]"#)).unwrap();
    let told = report(&made).torus.unwrap();
    assert_eq!((told.segments.two_types, report(&made).pieces, told.winding), (4, 8, vec![Some([0, 0])]));
    for (rest, message) in [
        (r#", "rates": [[1.4, 0], [0, -1.2], "free", [0, 1.2]]"#, "a direction at every point"),
        (r#", "rates": [[1.4, 0], [0, -1.2], [-1.4, 0], [0, 1.2]], "winding": [1, 0]"#, "remove `knots`"),
        (r#", "rates": [[1.4, 0], [0, 1.2], [1.4, 0], [0, 1.2]]"#, "[no-two-type-solution]"),
    ] {
        let error = spline(&format!("{fields}{rest}")).unwrap_err();
        assert!(error.contains(message), "{message}: {error}");
    }
}

#[test]
fn what_is_refused_is_shown_at_its_place() {
    for (fields, place, reason) in [
        (r#""points": [[52, 0, 0], [0, 0, 3]]"#, "objects.s.points[1]", "[point-on-axis]"),
        (r#""points": [[52, 0, 0], [0, 40, 0]]"#, "objects.s.points[1]", "[point-on-core-circle]"),
        (r#""points": [[52, 0, 0], [0, 53, 0]]"#, "objects.s.points[1]", "[point-off-torus]"),
        (r#""points": [[52, 0, 0], [0, 52, 0]], "tolerance": -1"#, "objects.s.tolerance", "[tolerance-not-positive]"),
        (r#""points": [[52, 0, 0]]"#, "objects.s", "[too-few-points]"),
        (r#""angles": [[0, 0], [1, 0]], "rates": [[0, 0], "free"]"#, "objects.s.rates[0]", "[zero-tangent]"),
        (r#""angles": [[0, 0], [1, 0]], "rates": [[0, 1]]"#, "objects.s.rates", "[count-differs]"),
        (
            r#""angles": [[0, 0], [1, 0]], "tangents": [[0, 1], "free", "free", "free"]"#,
            "objects.s.tangents",
            "[count-differs]",
        ),
        (r#""angles": [[0, 0], [1, 0]], "knots": [0, 1, 2]"#, "objects.s.knots", "[count-differs]"),
        (r#""angles": [[0, 0], [1, 0], [2, 0]], "knots": [0, 1, 1]"#, "objects.s.knots[2]", "[empty-interval]"),
        (r#""angles": [[0, 0], [1, 0]], "winding": [[1, 0], [1, 0]]"#, "objects.s.winding", "[count-differs]"),
        (
            r#""angles": [[0, 0], [1, 0]], "closed": true, "winding": [99999, 0]"#,
            "objects.s.winding",
            "[parameter-out-of-range]",
        ),
        (r#""angles": [[0, 0], [1e9, 0]]"#, "objects.s.angles", "[parameter-out-of-range]"),
    ] {
        let error = spline(fields).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{fields}: {place} {reason}: {error}");
    }
    for (fields, message) in [
        (r#""angles": [[0, 0]], "points": [[52, 0, 0]]"#, "requires either `points` or `angles`"),
        (r#""closed": true"#, "requires either `points` or `angles`"),
        (r#""angles": [[0, 0], [1, 0]], "winding": [1, 0]"#, "requires a closed curve"),
        (r#""angles": [[0, 0], [1, 0]], "tolerance": 1"#, "`tolerance` requires `points`"),
        (
            r#""angles": [[0, 0], [1, 0]], "tangents": [[1, 0, 0], "free"]"#,
            "tangent 0 is normal to the torus there: it has no tangential component",
        ),
        (r#""angles": [[0, 0]], "closed": true"#, "[too-few-points]"),
        (
            r#""angles": [[0, 0], [1, 0]], "rates": [[1, 0], "free"], "tangents": ["free", "free"]"#,
            "require either `tangents` or `rates`",
        ),
    ] {
        let error = spline(fields).unwrap_err();
        assert!(error.contains(message), "{fields}: {error}");
    }
    for (object, place, reason) in [
        (
            r#""type": "torus-knot", "torus": {"major_radius": 1, "minor_radius": 2}, "turns": [2, 3]"#,
            "objects.k.torus",
            "[not-a-ring-torus]",
        ),
        (
            r#""type": "torus-knot", "torus": {"major_radius": 3, "minor_radius": 2, "axis": [0, 0, 0]}, "turns": [2, 3]"#,
            "objects.k.torus",
            "[zero-axis]",
        ),
        (
            r#""type": "torus-knot", "torus": {"major_radius": 3, "minor_radius": 2}, "turns": [2, 4]"#,
            "objects.k.turns",
            "[not-coprime]",
        ),
        (
            r#""type": "torus-knot", "torus": {"major_radius": 3, "minor_radius": 2}, "turns": [1, 20000]"#,
            "objects.k.turns",
            "[parameter-out-of-range]",
        ),
    ] {
        let error = build(&format!(r#""k": {{{object}}}"#)).unwrap_err();
        assert!(error.contains(place) && error.contains(reason), "{object}: {error}");
    }
}

/// Knots so uneven that a part of the curve has no parameter of its own are refused where they stand, not when a file is written; even ones, and a torus that is none any more, likewise.
#[test]
fn splines_without_a_rational_form_are_refused() {
    let fields = |knots: &str| {
        format!(
            r#""angles": [[0, 0], [0.1, 0.1], [2, 1], [2.1, 1.2], [3, 2]], "rates": [[1, 1], [1, 1], [1, 1], [1, 1], [1, 1]], "knots": {knots}"#
        )
    };
    let error = spline(&fields("[0, 1e-10, 1, 1.0000000001, 2]")).unwrap_err();
    assert!(error.contains("objects.s.knots[") && error.contains("[empty-interval]"), "{error}");
    assert!(spline(&fields("[0, 0.01, 1, 1.1, 2]")).is_ok());
    let near = fields("[0, 1, 2, 3, 4]");
    let horn = r#""torus": {"major_radius": 40, "minor_radius": 39.9999999999999}"#;
    let error = build(&format!(r#""s": {{"type": "torus-spline", {horn}, {near}}}"#)).unwrap_err();
    assert!(error.contains("objects.s.torus"), "{error}");
}

/// What is said of a ratio is said of what was typed, and open curves have no turns.
#[test]
fn facts_are_those_of_what_was_given() {
    for (ratio, typed) in [("33", "ratio = 33"), ("0", "ratio = 0 ")] {
        let families = r#"["meridian", "mirror-villarceau"]"#;
        let text = format!(r#""q": {{"type": "torus-quartic", {HERE}, "families": {families}, "ratio": {ratio}}}"#);
        let error = build(&text).unwrap_err();
        assert!(error.contains(typed), "{error}");
    }
    let open = spline(r#""angles": [[0, 0], [1, 1]]"#).unwrap();
    let closed = spline(r#""angles": [[0, 0], [1, 1], [2, 0]], "closed": true"#).unwrap();
    let text = |built: &BuiltObject| {
        let report = Report::new(cyclide::model::Units::Millimetre, std::slice::from_ref(built), None);
        serde_json::to_string(&report).unwrap()
    };
    assert!(!text(&open).contains("winding") && text(&closed).contains("\"winding\":[["));
}
