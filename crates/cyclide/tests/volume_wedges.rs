//! Blocks with sides of one point, given by their corners: wedges about an axis, shells to the pole of a sphere, parts of balls.
//! A corner that follows is on its neighbor then, bit for bit, and lines stand still there exactly.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "what stands still does so exactly")]

use std::collections::HashMap;

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    mesh::tessellate,
    volume::{CyclideVolume, FoldVerdict, Grading, ParamVolume, SphericalCube, StructuredGrid, VolumeFrame},
};
use cyclide_testkit::volumes::{deterministic, vector};
use proptest::prelude::*;

/// Turned, scaled and moved.
#[derive(Debug, Clone, Copy)]
struct Place {
    turn: Quat,
    size: f64,
    way: Vec3,
}

impl Place {
    fn point(&self, p: Vec3) -> Point3 {
        Point3::ORIGIN + (self.turn.rotate(p) + self.way) * self.size
    }

    fn frame(&self, [v, w]: [Vec3; 2]) -> VolumeFrame {
        VolumeFrame::First(self.turn.rotate(v), self.turn.rotate(w))
    }
}

fn place() -> impl Strategy<Value = Place> {
    (vector(1.0), 0.0..6.0, -3..=3, vector(10.0)).prop_map(|(axis, angle, exponent, way)| {
        let turn = Quat::from_axis_angle(axis.unit().unwrap_or(Vec3::X), angle);
        Place { turn, size: 10f64.powi(exponent), way }
    })
}

/// The seven corners that are given, of places in a box of parameters.
fn seven(at: impl Fn([f64; 3]) -> Vec3, place: &Place) -> [Point3; 7] {
    std::array::from_fn(|k| place.point(at(std::array::from_fn(|axis| (k >> axis & 1) as f64))))
}

/// Sides of one point of a block in each direction.
fn points(block: &CyclideVolume) -> [usize; 3] {
    let corners = block.corners();
    [0, 1, 2].map(|axis| (0..8).filter(|k| k >> axis & 1 == 0 && corners[*k] == corners[k | 1 << axis]).count())
}

/// What holds of every block with sides of one point, and of its image: `volume` in units of its size.
fn check(block: &CyclideVolume, place: &Place, volume: f64, faces: usize) -> Result<(), TestCaseError> {
    prop_assert_eq!(block.folds(), FoldVerdict::Regular);
    // Rounding of coordinates of ten sizes over the thinnest side, of a tenth, and a fifth as much again.
    let limit = 1e-12;
    let wanted = volume * place.size.powi(3);
    prop_assert!((block.measure().volume / wanted - 1.0).abs() < limit, "{} {wanted}", block.measure().volume);
    let body = block.to_body().unwrap();
    prop_assert!(body.is_solid());
    prop_assert_eq!(body.outer.faces().len(), faces);
    prop_assert!((body.outer.volume() / wanted - 1.0).abs() < 1e-9, "{} {wanted}", body.outer.volume());
    let mesh = tessellate(&body, 0.02 * place.size).unwrap();
    let mut uses: HashMap<[usize; 2], i32> = HashMap::new();
    for face in &mesh.faces {
        let corners: Vec<usize> = face.corners().iter().map(|corner| corner.position).collect();
        for (k, a) in corners.iter().enumerate() {
            let b = corners[(k + 1) % corners.len()];
            *uses.entry([*a.min(&b), *a.max(&b)]).or_default() += if *a < b { 1 } else { -1 };
        }
    }
    prop_assert!(uses.values().all(|uses| *uses == 0), "the mesh is open");
    let grid = StructuredGrid::graded(std::slice::from_ref(block), [4; 3], [Grading::Uniform; 3]).unwrap();
    let quality = grid.quality();
    prop_assert!(quality.inverted == 0 && quality.collapsed > 0, "{quality:?}");
    Ok(())
}

proptest! {
    #![proptest_config(deterministic(25))]

    /// Slices of a pie, with their frame and without one: a quarter of a turn and any other, of any order of the directions.
    #[test]
    fn wedges_are_solids(place in place(), angle in 0.3..3.0_f64, height in 0.2..3.0_f64, order in 0_usize..3) {
        // The first corner is off the axis: its radius, the angle and the height, in turn.
        let at = |x: [f64; 3]| {
            let [inwards, round, up]: [f64; 3] = [0, 1, 2].map(|k| x[(k + order) % 3]);
            let (long, radius) = (angle * round, 1.0 - inwards);
            Vec3::new(radius * f64::cos(long), radius * f64::sin(long), height * up)
        };
        let cube = SphericalCube::new(seven(at, &place)).unwrap();
        let directions = [Vec3::new(-1.0, 0.0, 0.0), Vec3::Y, Vec3::Z];
        let frame = [0, 1].map(|k| directions[(k + 3 - order) % 3]);
        for frame in [place.frame(frame), VolumeFrame::Auto] {
            let block = CyclideVolume::new(&cube, frame).unwrap();
            check(&block, &place, 0.5 * angle * height, 5)?;
            let round = (1 + order) % 3;
            prop_assert_eq!(points(&block)[round], 2);
            // On the axis the lines round it stand still, elsewhere they do not.
            let mut on_axis = [0.3; 3];
            on_axis[order % 3] = 1.0;
            let standing = block.standing_lines(on_axis);
            prop_assert!(standing[round] && standing.iter().filter(|still| **still).count() == 1);
            prop_assert_eq!(block.standing_lines([0.4; 3]), [false; 3]);
            prop_assert_eq!(block.jacobian(on_axis), 0.0);
            // Parts, images and other orders keep their points.
            prop_assert_eq!(points(&block.split(order % 3, 0.3).unwrap()[1])[round], 2);
            prop_assert_eq!(block.split(round, 0.7).unwrap().map(|part| points(&part)[round]), [2; 2]);
            prop_assert_eq!(block.reversed(round).folds(), FoldVerdict::Regular);
            let map = Mobius::inversion(place.point(Vec3::new(2.5, 1.0, -0.7)), place.size).unwrap();
            prop_assert_eq!(block.transformed(&map).unwrap().folds(), FoldVerdict::Regular);
        }
    }

    /// Shells of spheres from a latitude to the pole.
    #[test]
    fn shells_to_the_pole_are_solids(place in place(), angle in 0.3..3.0_f64, latitude in -0.8..1.0_f64, thick in 0.1..1.0_f64) {
        let at = |[round, up, out]: [f64; 3]| {
            let (long, radius): (f64, f64) = (angle * round, 1.0 + thick * out);
            // The pole as it is typed, not the cosine of half of pi.
            let [cosine, sine] = if up > 0.5 { [0.0, 1.0] } else { [f64::cos(latitude), f64::sin(latitude)] };
            Vec3::new(cosine * long.cos(), cosine * long.sin(), sine) * radius
        };
        let cube = SphericalCube::new(seven(at, &place)).unwrap();
        let frame = place.frame([Vec3::Y, Vec3::new(-f64::sin(latitude), 0.0, f64::cos(latitude))]);
        let block = CyclideVolume::new(&cube, frame).unwrap();
        let volume = angle / 3.0 * ((1.0 + thick).powi(3) - 1.0) * (1.0 - f64::sin(latitude));
        check(&block, &place, volume, 5)?;
        prop_assert_eq!(points(&block), [2, 0, 0]);
    }

    /// Parts of balls from a meridian to another one: four corners at the center, two at the pole.
    #[test]
    fn parts_of_balls_are_solids(place in place(), angle in 0.3..3.0_f64, latitude in -0.5..1.0_f64) {
        let at = |[inwards, round, up]: [f64; 3]| {
            let [cosine, sine] = if up > 0.5 { [0.0, 1.0] } else { [f64::cos(latitude), f64::sin(latitude)] };
            let long: f64 = angle * round;
            Vec3::new(cosine * long.cos(), cosine * long.sin(), sine) * (1.0 - inwards)
        };
        let cube = SphericalCube::new(seven(at, &place)).unwrap();
        let frame = place.frame([-Vec3::new(f64::cos(latitude), 0.0, f64::sin(latitude)), Vec3::Y]);
        let block = CyclideVolume::new(&cube, frame).unwrap();
        check(&block, &place, angle / 3.0 * (1.0 - f64::sin(latitude)), 4)?;
        prop_assert_eq!(points(&block), [0, 3, 2]);
    }
}

/// Corners that are typed with ten decimals are on their neighbors as well.
#[test]
fn rounded_corners_of_a_wedge_are_on_its_axis() {
    let (cosine, sine) = (0.731_688_868_9, 0.681_638_760_0); // of 0.75
    let corners = [
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [cosine, sine, 0.0],
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 1.0],
        [0.0, 0.0, 1.0],
        [cosine, sine, 1.0],
    ];
    let block = CyclideVolume::new(&SphericalCube::new(corners.map(Point3::from)).unwrap(), VolumeFrame::Auto).unwrap();
    assert_eq!((block.folds(), points(&block)), (FoldVerdict::Regular, [0, 2, 0]));
    assert!((block.measure().volume - 0.375).abs() < 1e-9); // of ten decimals
}
