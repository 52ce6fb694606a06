use crate::shapes::{Random, cylinder, general, plane, torus};
use cyclide::{
    Point3, Vec3,
    conformal::Conformal,
    panel::{PanelMeasures, PanelSideForm},
    surface::ParamSurface,
    topology::Side,
};

#[test]
fn measures_of_a_part_of_a_torus() {
    // Radii 3 and 1, from the outer side 0.6 up the tube, 0.5 about the axis.
    let measures = PanelMeasures::new(&torus(0.0)).unwrap();
    let area = 0.5 * (3.0 * 0.6 + 0.6_f64.sin());
    assert!((measures.area - area).abs() < 1e-12 * area);
    let side = |side: Side| measures.sides[side as usize];
    for (which, radius, sweep) in [
        (Side::Bottom, 4.0, 0.5),
        (Side::Top, 3.0 + 0.6_f64.cos(), 0.5),
        (Side::Left, 1.0, 0.6),
        (Side::Right, 1.0, 0.6),
    ] {
        let side = side(which);
        assert_eq!((side.side, side.form), (which, PanelSideForm::Arc));
        assert!((side.radius.unwrap() - radius).abs() < 1e-13 && (side.sweep - sweep).abs() < 1e-13);
        assert!((side.length - radius * sweep).abs() < 1e-13);
        assert!((side.chord - 2.0 * radius * (0.5 * sweep).sin()).abs() < 1e-13);
    }
    assert!(side(Side::Bottom).center.unwrap().distance(Point3::ORIGIN) < 1e-13);
    assert!((side(Side::Bottom).normal.unwrap() - Vec3::Z).length() < 1e-13);
    // Normal outward: the tube bends by -1 everywhere, the parallels by -1/4 outside and less above.
    let [least, most] = measures.curvatures;
    assert!((least.value + 1.0).abs() < 1e-13 && least.direction == 1);
    let flattest = -0.6_f64.cos() / (3.0 + 0.6_f64.cos());
    assert!((most.value - flattest).abs() < 1e-13 && most.direction == 0 && most.place.1 > 0.999_999);
    assert!(measures.corner_lift < 1e-15);
}

#[test]
fn rise_turn_and_size_are_those_of_many_points() {
    let mut random = Random::new(4);
    for _ in 0..20 {
        let patch = general(&mut random).transformed(&random.similarity(3.0, 10.0)).unwrap();
        let measures = PanelMeasures::new(&patch).unwrap();
        let [a, b, c, d] = patch.corners();
        let normal = (b - a).cross(c - a).unit().unwrap();
        let points: Vec<Point3> =
            (0..201 * 201).map(|k| patch.point(f64::from(k % 201) / 200.0, f64::from(k / 201) / 200.0)).collect();
        let height = |p: &Point3| (*p - a).dot(normal);
        let rise = points.iter().map(|p| height(p).abs()).fold(0.0, f64::max);
        // Samples miss a smooth extreme by the square of their distance.
        assert!(measures.sagitta >= rise - 1e-13 && measures.sagitta - rise < 1e-4 * patch.size());
        assert!(measures.corner_lift <= 1e-12 * patch.size() && (d - a).dot(normal).abs() <= 1e-12 * patch.size());
        // The box has the least base of all: of those in 360 directions none is less, but for what samples miss.
        let x = (b - a).unit().unwrap();
        let y = normal.cross(x);
        let flat: Vec<[f64; 2]> = points.iter().map(|p| [(*p - a).dot(x), (*p - a).dot(y)]).collect();
        let extent = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            let values = flat.iter().map(|[x, y]| cos * x + sin * y);
            let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], v| [lo.min(v), hi.max(v)]);
            high - low
        };
        let base = |k: i32| {
            extent(f64::from(k).to_radians() / 4.0)
                * extent(f64::from(k).to_radians() / 4.0 + std::f64::consts::FRAC_PI_2)
        };
        let least = (0..360).map(base).fold(f64::INFINITY, f64::min);
        let base = measures.size[0] * measures.size[1];
        assert!(base <= least * (1.0 + 2e-4) && measures.size[0] >= measures.size[1], "{base} {least}");
        let turn = patch.unit_normal(0.0, 0.0).angle(patch.unit_normal(1.0, 1.0));
        let other = patch.unit_normal(1.0, 0.0).angle(patch.unit_normal(0.0, 1.0));
        assert!((measures.turn - turn.max(other)).abs() < 1e-12);
        for k in 0..=100 {
            let x = f64::from(k) / 100.0;
            for value in [patch.k1(x), patch.k2(x)] {
                let [least, most] = measures.curvatures.map(|extreme| extreme.value);
                assert!(value >= least - 1e-9 * least.abs() && value <= most + 1e-9 * most.abs());
            }
        }
        for extreme in measures.curvatures {
            let (s, t) = extreme.place;
            let there = if extreme.direction == 0 { patch.k1(t) } else { patch.k2(s) };
            assert!((there - extreme.value).abs() < 1e-9 * (1.0 + there.abs()), "{extreme:?}");
        }
    }
}

#[test]
fn straight_sides_have_that_name() {
    let mut random = Random::new(5);
    for (scale, far) in [(1.0, 0.0), (1e-6, 0.0), (1e6, 0.0), (1.0, 1e5)] {
        let moved = cylinder().transformed(&random.similarity(scale, far)).unwrap();
        let sides = PanelMeasures::new(&moved).unwrap().sides;
        let forms = sides.map(|side| side.form);
        use PanelSideForm::{Arc, Straight};
        assert_eq!(forms, [Arc, Arc, Straight, Straight], "{scale} {far}");
        assert!(sides[2].radius.is_none() && sides[2].normal.is_none() && sides[2].sweep.abs() <= 0.0);
    }
    let octant = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::Z].map(|v| Point3::ORIGIN + v);
    let octant = cyclide::surface::CyclidePatch::from_corners_and_frame(octant, Vec3::Y, Vec3::Z).unwrap();
    let measures = PanelMeasures::new(&octant).unwrap();
    assert_eq!(measures.sides[1].form, PanelSideForm::Point);
    assert!((measures.area - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    let flat = PanelMeasures::new(&plane()).unwrap();
    assert!(flat.sagitta < 1e-15 && flat.curvatures.iter().all(|extreme| extreme.value.abs() < 1e-14));
}
