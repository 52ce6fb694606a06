//! Necks of pipes: at a ball's radius from its way, tangent to pipe and plate, exact, and as solids with known volumes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Error, Point3, Quat, Vec3,
    conformal::{Conformal as _, Mobius},
    construct::{NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape},
    error::PipeError,
    surface::{ParamSurface as _, PatchKind},
    topology::{Body, FaceGeometry as _, FaceSurface, Side, surface_joints},
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const SIDES: [NeckSide; 2] = [NeckSide::Outside, NeckSide::Inside];
const VARIANTS: [NeckVariant; 2] = [NeckVariant::Pipe, NeckVariant::Vertical];
const SLOPES: [f64; 6] = [0.0, 0.2, -0.7, 1.1, -1.3, 1.5];

/// Every kind of neck of a pipe of radius 3 and a ball of radius 0.8.
fn necks() -> impl Iterator<Item = (NeckBlend, f64, NeckSide, NeckVariant)> {
    SLOPES.into_iter().flat_map(|slope| {
        SIDES.into_iter().flat_map(move |side| {
            VARIANTS
                .into_iter()
                .map(move |variant| (NeckBlend::new(3.0, 0.8, slope, side, variant).unwrap(), slope, side, variant))
        })
    })
}

#[test]
fn the_ball_touches_pipe_and_plate() {
    for (neck, slope, side, _) in necks() {
        let axis = neck.axis();
        // Coordinates grow with the slope, and their rounding.
        let bound = 1e-14 / slope.cos();
        for k in 0..24 {
            let angle = TAU * f64::from(k) / 24.0;
            let (m, q0, q1) = (neck.center(angle), neck.contact_on_pipe(angle), neck.contact_on_plate(angle));
            assert!((q0.distance(m) - 0.8).abs() < bound && (q1.distance(m) - 0.8).abs() < bound);
            assert!(q1.z == 0.0 && (m.z - 0.8).abs() < bound);
            let off_axis = |p: Point3| p.to_vec().cross(axis).length();
            let reach = if side == NeckSide::Outside { 3.8 } else { 2.2 };
            assert!((off_axis(q0) - 3.0).abs() < bound && (off_axis(m) - reach).abs() < bound);
        }
    }
}

#[test]
fn the_exact_form_is_the_arcs() {
    for (neck, slope, side, variant) in necks() {
        for (quarter, offset) in (0..4).flat_map(|k| [(k, 0.0), (k, 0.1)]) {
            let from = FRAC_PI_2 * f64::from(quarter) + offset;
            let surface = neck.surface(from, from + FRAC_PI_2).unwrap();
            assert_eq!(surface.degrees(), [4, 2]);
            assert!(surface.has_positive_weights() || offset > 0.0);
            for (k, s) in [0.0_f64, 0.25, 0.6, 1.0].into_iter().enumerate() {
                // The angle at s of the rational quadratic with weights 1, cos(π/4), 1.
                let half = 0.25 * PI;
                let angle = from + 2.0 * (s * half.sin()).atan2(1.0 - s + s * half.cos());
                let arc = neck.arc(angle).unwrap();
                for t in [0.0, 0.3, 0.5, 0.9, 1.0] {
                    let (p, q) = (surface.point(s, t), arc.point(t));
                    // Rounding of the products of the rows, and of coordinates that grow with the slope.
                    let bound = 2e-14 / slope.cos();
                    assert!(p.distance(q) < bound, "{slope} {side:?} {variant:?} {k} {t}: {}", p.distance(q));
                }
            }
        }
    }
}

#[test]
fn the_pipe_variant_is_at_the_radius_from_the_way_of_the_ball_and_has_its_normal() {
    for (neck, slope, _, variant) in necks() {
        for k in 0..24 {
            let angle = TAU * f64::from(k) / 24.0;
            let (m, arc) = (neck.center(angle), neck.arc(angle).unwrap());
            let step = 1e-5;
            let along = neck.center(angle + step) - neck.center(angle - step);
            for t in [0.0, 0.2, 0.5, 0.7, 1.0] {
                let way = arc.point(t) - m;
                if variant == NeckVariant::Pipe {
                    assert!((way.length() - 0.8).abs() < 1e-13 / slope.cos(), "{slope} {angle} {t}");
                    // Across the way of the center; its direction is known to the square of the step.
                    assert!(way.dot(along).abs() < 1e-8 * along.length(), "{slope} {angle} {t}");
                } else {
                    // In a plane along the axis.
                    let plane = neck.axis().cross(arc.chord());
                    let off = (arc.point(t) - arc.start()).dot(plane);
                    assert!(off.abs() < 1e-13 * plane.length() / slope.cos());
                }
            }
        }
    }
}

fn made(height: f64, plate: Option<PlateShape>, thickness: Option<f64>, wall: Option<f64>) -> NeckBody {
    let mut made = NeckBody::new(height);
    (made.plate, made.thickness, made.wall) = (plate, thickness, wall);
    made
}

/// The bodies of a neck with all kinds of plates, open and, unless it folds, solid.
fn bodies(neck: &NeckBlend, side: NeckSide) -> Vec<Body> {
    let plates = match side {
        NeckSide::Outside => vec![Some(PlateShape::Rectangle([130.0, 150.0])), Some(PlateShape::Disk(71.0))],
        NeckSide::Inside => vec![None],
    };
    let kinds = [(None, None), (Some(0.7), None), (Some(0.7), Some(0.5))];
    let kinds = &kinds[..if !neck.warnings().is_empty() { 1 } else { 3 }];
    let all = plates
        .into_iter()
        .flat_map(|plate| kinds.iter().map(move |&(thickness, wall)| made(70.0, plate, thickness, wall)));
    all.map(|made| neck.body(&made).unwrap()).collect()
}

#[test]
fn neighbors_are_tangent_along_the_contacts() {
    for (neck, slope, side, variant) in necks() {
        for body in bodies(&neck, side) {
            let edges = body.outer.faces_along_edges();
            let is_neck = |face: usize| match &body.outer.faces()[face].surface {
                // Of far leaning pipes with even arcs.
                FaceSurface::Rational(surface) => [[4, 2], [6, 2]].contains(&surface.degrees()),
                FaceSurface::Cyclide(patch) => matches!(patch.recognize(), PatchKind::Torus { .. }),
            };
            let mut contacts = 0;
            for along in edges.iter().filter(|along| along.len() == 2) {
                let [(first, one), (second, other)] = along[..] else { panic!("two faces") };
                // Along both contacts and within the neck.
                if !is_neck(first) && !is_neck(second) {
                    continue;
                }
                contacts += 1;
                for x in [0.0, 0.13, 0.5, 0.8, 1.0] {
                    let normal = |face: usize, side: Side| {
                        let (s, t) = side.place(x);
                        let face = &body.outer.faces()[face];
                        (face.surface.point(s, t), face.surface.unit_normal(s, t))
                    };
                    let ((p, n), (q, m)) = (normal(first, one), normal(second, other));
                    assert!(p.distance(q) < 1e-12);
                    let angle = n.cross(m).length();
                    assert!(angle < 1e-7 && n.dot(m) > 0.0, "{slope} {side:?} {variant:?} {x}: {angle}");
                }
            }
            assert!(contacts == 12 || contacts == 24, "{contacts}");
            for joint in surface_joints(&body.outer) {
                assert!(joint.gap < 1e-12, "{joint:?}");
            }
        }
    }
}

#[test]
fn solids_of_upright_pipes_have_the_volumes_of_pappus() {
    let (pipe, ball, height, thickness, wall) = (3.0, 0.8, 9.0, 0.7, 0.5);
    let plate = Some(PlateShape::Rectangle([20.0, 16.0]));
    for variant in VARIANTS {
        let neck = NeckBlend::new(pipe, ball, 0.0, NeckSide::Outside, variant).unwrap();
        let volume = |made: &NeckBody| {
            let body = neck.body(made).unwrap();
            assert!(body.is_solid());
            body.outer.known_volume().unwrap()
        };
        // The corner outside a quarter of a disk: its area, and the distance of its center from the axis.
        let corner = ball * ball * (1.0 - 0.25 * PI);
        let moment =
            ball * ball * (pipe + 0.5 * ball) - 0.25 * PI * ball * ball * (pipe + ball - 4.0 * ball / (3.0 * PI));
        assert!(corner > 0.0 && moment > pipe * corner);
        let filled = 20.0 * 16.0 * thickness + PI * pipe * pipe * height + TAU * moment;
        let found = volume(&made(height, plate, Some(thickness), None));
        assert!((found / filled - 1.0).abs() < 1e-12, "{found} {filled}");
        let bore = PI * (pipe - wall) * (pipe - wall) * (height + thickness);
        let found = volume(&made(height, plate, Some(thickness), Some(wall)));
        assert!((found / (filled - bore) - 1.0).abs() < 1e-12, "{found}");
        // The cup: its wall, its floor, and the round corner inside.
        let cup = NeckBlend::new(pipe, ball, 0.0, NeckSide::Inside, variant).unwrap();
        let body = cup.body(&made(height, None, Some(thickness), Some(wall))).unwrap();
        let moment =
            ball * ball * (pipe - 0.5 * ball) - 0.25 * PI * ball * ball * (pipe - ball + 4.0 * ball / (3.0 * PI));
        let outer = PI * (pipe + wall) * (pipe + wall) * (height + thickness);
        let want = outer - PI * pipe * pipe * height + TAU * moment;
        let found = body.outer.known_volume().unwrap();
        assert!((found / want - 1.0).abs() < 1e-12, "{found} {want}");
    }
}

/// Of leaning pipes: the pipe and its bore are cylinders between parallel or tilted planes, the rest has the volume of the balls'
/// way, by Pappus along the ellipse with the place of each cross-section.
#[test]
fn solids_of_leaning_pipes_differ_by_the_bore_and_the_plate() {
    for slope in [0.3, -0.9] {
        let neck = NeckBlend::new(3.0, 0.8, slope, NeckSide::Outside, NeckVariant::Pipe).unwrap();
        let volume = |thickness: f64, wall: Option<f64>| {
            let plate = Some(PlateShape::Rectangle([40.0, 36.0]));
            let body = neck.body(&made(20.0, plate, Some(thickness), wall)).unwrap();
            assert!(body.is_solid());
            body.outer.known_volume().unwrap()
        };
        let thicker = volume(1.5, None) - volume(0.5, None);
        assert!((thicker - 40.0 * 36.0).abs() < 1e-9, "{thicker}");
        // The bore is as long along its axis as the pipe over and the plate under the place where the axis meets it.
        let bore = volume(1.5, None) - volume(1.5, Some(1.0));
        let length = 20.0 + 1.5 / f64::cos(slope);
        assert!((bore / (PI * 4.0 * length) - 1.0).abs() < 1e-9, "{bore}");
    }
}

/// Points of a small torus and of the neck of a pipe that hardly leans differ by less than what tells patches; their arcs do by more than a shell allows.
#[test]
fn small_balls_and_hardly_leaning_pipes_are_made() {
    for (ball, slope) in [-3, -4, -5, -6].into_iter().flat_map(|ball| (-12..-5).map(move |slope| (ball, slope))) {
        for (side, variant) in SIDES.into_iter().flat_map(|side| VARIANTS.map(|variant| (side, variant))) {
            let neck =
                NeckBlend::new(1.0, 2.1 * 10.0_f64.powi(ball), 1.5 * 10.0_f64.powi(slope), side, variant).unwrap();
            let plate = Some(PlateShape::Disk(3.0)).filter(|_| side == NeckSide::Outside);
            let body = neck.body(&made(3.0, plate, Some(0.5), None)).unwrap();
            assert!(body.is_solid() && surface_joints(&body.outer).iter().all(|joint| joint.gap < 1e-12));
        }
    }
}

#[test]
fn similar_data_give_similar_bodies() {
    let plate = |scale: f64| Some(PlateShape::Rectangle([20.0 * scale, 18.0 * scale]));
    for scale in [1e-9, 1e-3, 1e6] {
        for side in SIDES {
            let body = |scale: f64| {
                let neck = NeckBlend::new(3.0 * scale, 0.8 * scale, 0.4, side, NeckVariant::Pipe).unwrap();
                let plate = plate(scale).filter(|_| side == NeckSide::Outside);
                neck.body(&made(12.0 * scale, plate, Some(scale), Some(0.5 * scale))).unwrap()
            };
            let (one, other) = (body(1.0), body(scale));
            let map = Mobius::similarity(Quat::ONE, scale, Vec3::ZERO).unwrap();
            let image = one.transformed(&map).unwrap();
            for (a, b) in image.outer.faces().iter().zip(other.outer.faces()) {
                for (s, t) in [(0.0, 0.0), (0.3, 0.8), (0.9, 0.5)] {
                    assert!(a.surface.point(s, t).distance(b.surface.point(s, t)) < 1e-13 * 20.0 * scale);
                }
            }
        }
    }
}

/// With balls below the limit no part of the envelope runs backwards; above it some does, on the outer side of the pipe only.
#[test]
fn large_balls_fold_outer_necks_and_are_warned_of() {
    for slope in [0.6, 1.0, -1.2] {
        for side in SIDES {
            for part in [0.5, 0.97, 1.03, 2.0] {
                let cos = f64::cos(slope);
                // ρ = part (R + ρ) cos φ, with R = 1.
                let ball = match side {
                    NeckSide::Outside if part * cos < 1.0 => part * cos / (1.0 - part * cos),
                    NeckSide::Outside => continue,
                    NeckSide::Inside => part / 2.1,
                };
                let neck = NeckBlend::new(1.0, ball, slope, side, NeckVariant::Pipe).unwrap();
                let folds = side == NeckSide::Outside && part > 1.0;
                assert_eq!(
                    neck.warnings().first().map(|w| w.reason()),
                    folds.then_some("neck-folds"),
                    "{slope} {part}"
                );
                // No solid has such a boundary.
                let plate = Some(PlateShape::Rectangle([1e3; 2])).filter(|_| side == NeckSide::Outside);
                assert!(neck.body(&made(1e3, plate, None, None)).is_ok());
                match neck.body(&made(1e3, plate, Some(1.0), None)) {
                    Err(Error::Pipe(PipeError::NeckFolds { radius, limit })) => {
                        assert!(folds && (radius - ball).abs() < 1e-12 && radius > limit)
                    }
                    other => assert!(other.is_ok_and(|body| body.is_solid()) && !folds, "{slope} {part}"),
                }
                let mut least = f64::INFINITY;
                for quarter in 0..4 {
                    let from = FRAC_PI_2 * (f64::from(quarter) + 0.5);
                    let surface = neck.surface(from, from + FRAC_PI_2).unwrap();
                    for (i, j) in (0..=40).flat_map(|i| (0..=40).map(move |j| (i, j))) {
                        let (s, t) = (f64::from(i) / 40.0, f64::from(j) / 40.0);
                        // Seen along the way from the ball's center the surface runs counter-clockwise outside, clockwise inside.
                        let jet = surface.jet(s, t);
                        let half = 0.25 * PI;
                        let angle = from + 2.0 * (s * half.sin()).atan2(1.0 - s + s * half.cos());
                        let normal = (jet.point - neck.center(angle)).unit().unwrap();
                        let sense = if side == NeckSide::Outside { 1.0 } else { -1.0 };
                        least = least.min(sense * jet.ds.cross(jet.dt).dot(normal));
                    }
                }
                assert_eq!(least < -1e-9, folds, "{slope} {side:?} {part}: {least}");
            }
        }
    }
}

/// Seen along the pipe the surface covers each place once, whatever ball rolls: it goes on outwards in t and round in s.
#[test]
fn the_vertical_variant_never_folds() {
    for (slope, ball) in [(PI / 3.0, 2.0), (1.0, 20.0), (-1.4, 5.0), (0.3, 100.0)] {
        let neck = NeckBlend::new(1.0, ball, slope, NeckSide::Outside, NeckVariant::Vertical).unwrap();
        assert_eq!(neck.warnings(), []);
        for quarter in 0..4 {
            let surface = neck.surface(FRAC_PI_2 * f64::from(quarter), FRAC_PI_2 * f64::from(quarter + 1)).unwrap();
            for (i, j) in (0..=40).flat_map(|i| (1..=40).map(move |j| (i, j))) {
                let jet = surface.jet(f64::from(i) / 40.0, f64::from(j) / 40.0);
                // The part of the area that is across the pipe: at its start the arc runs along it.
                let across = -jet.ds.cross(jet.dt).dot(neck.axis()) / (jet.ds.length() * jet.dt.length());
                assert!(across > 1e-4, "{slope} {ball} {i} {j}: {across}");
            }
        }
        let plate = Some(PlateShape::Rectangle([1e4; 2]));
        let body = neck.body(&made(3e3, plate, Some(1.0), None)).unwrap();
        assert!(body.is_solid() && body.outer.volume() > 1e8);
    }
}

#[test]
fn necks_and_bodies_that_are_none_are_refused() {
    let neck = |pipe, ball, slope, side| NeckBlend::new(pipe, ball, slope, side, NeckVariant::Pipe);
    let reason = |made: cyclide::Result<NeckBlend>| made.unwrap_err().reason();
    let outside = NeckSide::Outside;
    assert_eq!(reason(neck(0.0, 1.0, 0.0, outside)), "radius-not-positive");
    assert_eq!(reason(neck(1.0, -1.0, 0.0, outside)), "radius-not-positive");
    assert_eq!(reason(neck(1.0, f64::NAN, 0.0, outside)), "not-finite");
    assert_eq!(reason(neck(1.0, 1.0, FRAC_PI_2, outside)), "angle-out-of-range");
    assert_eq!(reason(neck(1.0, 1.0, f64::NAN, outside)), "angle-out-of-range");
    assert_eq!(reason(neck(1.0, 1.0, 0.0, NeckSide::Inside)), "ball-does-not-fit");
    assert!(neck(1.0, 1.0, 0.0, outside).is_ok());
    let neck = neck(3.0, 0.8, 0.5, outside).unwrap();
    let rectangle = |sides| Some(PlateShape::Rectangle(sides));
    let refused = |made: NeckBody| neck.body(&made).unwrap_err().reason();
    let whole = rectangle([20.0, 20.0]);
    assert!(neck.body(&made(8.0, whole, Some(1.0), Some(0.5))).is_ok());
    assert_eq!(refused(made(2.0, whole, None, None)), "parameter-out-of-range");
    assert_eq!(refused(made(f64::NAN, whole, None, None)), "not-finite");
    assert_eq!(refused(made(8.0, None, None, None)), "plate-too-small");
    for plate in [[7.5, 20.0], [20.0, 9.5], [f64::NAN, 20.0], [-20.0, 20.0]] {
        assert_eq!(refused(made(8.0, rectangle(plate), None, None)), "plate-too-small");
    }
    assert_eq!(refused(made(8.0, Some(PlateShape::Disk(4.7)), None, None)), "plate-too-small");
    assert_eq!(refused(made(8.0, whole, Some(0.0), None)), "parameter-out-of-range");
    assert_eq!(refused(made(8.0, whole, Some(f64::INFINITY), None)), "not-finite");
    assert_eq!(refused(made(8.0, whole, Some(1.0), Some(3.0))), "parameter-out-of-range");
    assert_eq!(refused(made(8.0, whole, Some(1.0), Some(-1.0))), "parameter-out-of-range");
    // Of a thick plate a bore that leans comes out beside it.
    assert_eq!(refused(made(8.0, whole, Some(20.0), Some(1.0))), "plate-too-small");
    assert!(neck.body(&made(8.0, whole, Some(20.0), None)).is_ok());
}

#[test]
fn upright_pipes_have_analytic_faces() {
    let kinds = |body: &Body| {
        let mut kinds: Vec<&str> = Vec::new();
        for face in body.outer.faces() {
            kinds.push(match face.surface.patch().map(cyclide::surface::CyclidePatch::recognize) {
                Some(PatchKind::Torus { .. }) => "torus",
                Some(PatchKind::Cylinder { .. }) => "cylinder",
                Some(PatchKind::Plane { .. }) => "plane",
                Some(_) => "other",
                None => "rational",
            });
        }
        kinds.sort_unstable();
        kinds.dedup();
        kinds
    };
    for variant in VARIANTS {
        let outside = NeckBlend::new(3.0, 0.8, 0.0, NeckSide::Outside, variant).unwrap();
        for wall in [None, Some(0.5)] {
            let disk = outside.body(&made(9.0, Some(PlateShape::Disk(12.0)), Some(0.7), wall)).unwrap();
            assert_eq!(kinds(&disk), ["cylinder", "plane", "torus"]);
            // Between a circle and a straight side planes are rational.
            let rectangle = outside.body(&made(9.0, Some(PlateShape::Rectangle([20.0; 2])), Some(0.7), wall)).unwrap();
            assert_eq!(kinds(&rectangle), ["cylinder", "plane", "rational", "torus"]);
        }
        let inside = NeckBlend::new(3.0, 0.8, 0.0, NeckSide::Inside, variant).unwrap();
        assert_eq!(kinds(&inside.body(&made(9.0, None, Some(0.7), None)).unwrap()), ["cylinder", "plane", "torus"]);
    }
}
