//! The laws of volumes on awkward ones: sizes from 1e-6 to 1e6, far from the origin, flat, nearly degenerate.
//!
//! Corners are rounded where they are: limits are relative to the largest coordinate, times how much the shape magnifies.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Error, Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    error::VolumeError,
    surface::ParamSurface,
    volume::{CyclideGrid, CyclideVolume, FoldVerdict, ParamVolume, SphericalCube, VolumeFrame, miquel_point},
};
use cyclide_testkit::volumes::{awkward_cube, cube, deterministic, vector};
use proptest::prelude::*;

const PLACES: [[f64; 3]; 6] = [[0.0; 3], [0.3, 0.7, 0.1], [0.5; 3], [1.0, 0.2, 0.9], [0.05, 0.95, 0.6], [1.0; 3]];

fn size_and_place(block: &CyclideVolume) -> (f64, f64) {
    (block.size(), block.corners().iter().map(|p| p.to_vec().max_abs()).fold(block.size(), f64::max))
}

/// The shortest side over the longest distance.
fn flatness(block: &CyclideVolume) -> f64 {
    let a = block.corners();
    let sides = (0..3).flat_map(|d| (0..8).filter(move |k| k >> d & 1 == 0).map(move |k| (k, k | 1 << d)));
    sides.map(|(j, k)| a[j].distance(a[k])).fold(f64::INFINITY, f64::min) / block.size()
}

proptest! {
    #![proptest_config(deterministic(300))]

    /// In space, orthogonal, with faces that are the patches: of flat cubes a million sizes from the origin.
    #[test]
    fn laws_hold_far_away_and_flat(cube in awkward_cube(0.3, 0..6, 4)) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.is_ok());
        let block = block.unwrap();
        let (size, place) = size_and_place(&block);
        // A corner that is off by a rounding turns the sides at it by that over their length; faces and weights follow.
        let magnified = f64::EPSILON * place / size / flatness(&block).powi(2);
        prop_assume!(magnified < 1e-3);
        for at in PLACES {
            prop_assert!(block.real_residual(at) <= 300.0 * magnified * size, "{:e} of {magnified:e}", block.real_residual(at) / size);
            prop_assert!(block.jet(at).orthogonality() <= 300.0 * magnified, "{:e} of {magnified:e}", block.jet(at).orthogonality());
        }
        for (k, face) in block.faces().into_iter().enumerate() {
            for [p, q] in [[0.0, 0.0], [0.4, 0.9], [0.5, 0.5]] {
                let end = (k % 2) as f64;
                let at = [[end, p, q], [p, end, q], [p, q, end]][k / 2];
                prop_assert!(face.point(p, q).distance(block.point(at)) <= 300.0 * magnified * size + 4.0 * f64::EPSILON * place);
            }
        }
    }

    /// The eighth point is the same from whichever corner it is computed: each corner follows from the seven others.
    #[test]
    fn miquels_point_is_symmetric(cube in awkward_cube(0.3, 0..3, 2), from in 0usize..8) {
        let a = cube.corners();
        // The corner opposite to `from` is left out.
        let seven: [Point3; 7] = std::array::from_fn(|k| a[k ^ from]);
        let found = miquel_point(seven);
        prop_assume!(!matches!(found, Err(Error::Volume(VolumeError::ConcircularCube { .. }))));
        let size = a.iter().map(|p| p.distance(a[0])).fold(0.0, f64::max);
        let place = a.iter().map(|p| p.to_vec().max_abs()).fold(size, f64::max);
        let sides = (0..8).flat_map(|j| (0..j).map(move |k| (j, k))).map(|(j, k)| a[j].distance(a[k]) / size);
        let flat = sides.fold(f64::INFINITY, f64::min);
        let magnified = f64::EPSILON * place / size / flat.powi(3);
        prop_assume!(magnified < 1e-6);
        let off = found.unwrap().distance(a[from ^ 7]);
        prop_assert!(off <= 3e3 * magnified * size, "{off:e}: {:e} of {magnified:e}", off / size);
    }

    /// Scaled and moved blocks are those of scaled and moved corners.
    #[test]
    fn similar_cubes_have_similar_blocks(cube in cube(), exponent in -6..=6i32, by in vector(1e3)) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.is_ok());
        let block = block.unwrap();
        let scale = 10f64.powi(exponent);
        let map = Mobius::similarity(Quat::ONE, scale, by * block.size() * scale).unwrap();
        let image = block.transformed(&map).unwrap();
        let corners: [Point3; 7] = std::array::from_fn(|k| map.map_point(cube.corners()[k]).unwrap());
        let again = CyclideVolume::new(&SphericalCube::new(corners).unwrap(), VolumeFrame::Auto).unwrap();
        let (size, place) = size_and_place(&image);
        for at in PLACES {
            let off = image.point(at).distance(again.point(at));
            prop_assert!(off <= 1e-13 * place / flatness(&image).powi(2), "{:e} of {:e}", off / size, place / size);
            prop_assert!((image.jacobian(at) / (block.jacobian(at) * scale.powi(3)) - 1.0).abs() < 1e-9 * place / size);
        }
    }

    /// Cubes that are nearly on one circle are refused or, if not, are blocks as all others up to what that magnifies.
    #[test]
    fn nearly_concircular_cubes_are_blocks_or_refused(tilt in -14.0..0.0f64, inside in (0.5..2.0, 0.5..2.0, 0.5..2.0)) {
        let lift = 10f64.powf(tilt);
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [-1.0, 0.0, lift]].map(Point3::from);
        let (x, y, z) = inside;
        match SphericalCube::from_barycentric(corners, [x, y, z], 0.5) {
            Err(error) => {
                let expected = ["concircular-cube", "coincident-points", "point-at-infinity"];
                prop_assert!(expected.contains(&error.reason()) && tilt < -11.0, "{tilt}: {error}");
            }
            Ok(cube) => {
                let a = cube.corners();
                // The corners of a face at the first one are on a circle by construction, those of the others by Miquel.
                for face in [[4, 5, 6, 7], [2, 3, 6, 7], [1, 3, 5, 7]] {
                    let [p, q, r, s] = face.map(|k: usize| a[k]);
                    let volume = (q - p).cross(r - p).dot(s - p);
                    prop_assert!(volume.abs() < 1e-12 / lift.min(1.0), "{tilt} {face:?} {volume:e}");
                }
                if let Ok(block) = CyclideVolume::new(&cube, VolumeFrame::Auto) {
                    prop_assert!(block.real_residual([0.5; 3]) < 1e-12 / lift * block.size());
                    prop_assert!(block.folds() != FoldVerdict::Regular || block.jacobian([0.5; 3]) != 0.0);
                }
            }
        }
    }
}

#[test]
fn boxes_are_trilinear_at_any_scale() {
    for exponent in -6..=6 {
        let size = 10f64.powi(exponent);
        for far in [0.0, 1.0, 1e6] {
            let origin = Point3::new(far * size, -2.0 * far * size, 0.5 * far * size);
            let sides = [Vec3::X * (2.0 * size), Vec3::Y * (3.0 * size), Vec3::Z * size];
            let block = CyclideVolume::new(&SphericalCube::cuboid(origin, sides).unwrap(), VolumeFrame::Auto).unwrap();
            for [s, t, u] in PLACES {
                let wanted = origin + sides[0] * s + sides[1] * t + sides[2] * u;
                // Corners are rounded to 2^-52 of 2e6 sizes, and the frame is turned by that over a side.
                assert!(block.point([s, t, u]).distance(wanted) < 8.0 * f64::EPSILON * (4.0 + 2.0 * far) * size);
                let jacobian = 6.0 * size.powi(3);
                assert!((block.jacobian([s, t, u]) / jacobian - 1.0).abs() < 1e-14 * (1.0 + far));
            }
        }
    }
}

/// A rotation along no axis.
fn rotation() -> Quat {
    Quat::from_axis_angle(Vec3::new(1.0, 2.0, -0.7).unit().unwrap(), 1.1)
}

/// Every vertex is the last corner of a cube of computed ones: their rounding must not grow from cube to cube.
#[test]
fn grids_of_many_cubes_keep_their_digits() {
    let inversion = Mobius::inversion(Point3::new(-1.0, -1.2, -0.7), 1.0).unwrap();
    let turned = |v: Vec3| Point3::ORIGIN + rotation().rotate(v);
    let eleven_digits = |p: Point3| {
        let rounded = |x: f64| (x * 1e11).round() / 1e11;
        Point3::new(rounded(p.x), rounded(p.y), rounded(p.z))
    };
    type Place<'a> = Box<dyn Fn(Vec3) -> Point3 + 'a>;
    // The limits: roundings of coordinates up to 2 of rows of 24 cubes; of 1e6; and what was rounded away, times the reach of three planes.
    let cases: [(usize, Place<'_>, f64); 5] = [
        (24, Box::new(|v| Point3::ORIGIN + v), 1e-14),
        (24, Box::new(turned), 2e-14),
        (24, Box::new(|v| inversion.map_point(turned(v)).unwrap()), 2e-14),
        (8, Box::new(|v| turned(v) + Vec3::new(1e6, -3e5, 2e5)), 1e-8),
        (8, Box::new(|v| eleven_digits(turned(v))), 1e-10),
    ];
    for (case, (n, place, limit)) in cases.into_iter().enumerate() {
        let at = |[i, j, k]: [usize; 3]| place(Vec3::new(i as f64, j as f64, k as f64) / n as f64);
        let grid = CyclideGrid::from_coordinate_planes([n; 3], at, VolumeFrame::Auto).unwrap();
        let m = n + 1;
        for (number, p) in grid.points().iter().enumerate() {
            let off = p.distance(at([number % m, number / m % m, number / m / m]));
            assert!(off < limit, "{case}: {number} is off by {off:e}");
        }
        for block in grid.blocks() {
            assert!(block.real_residual([0.4, 0.5, 0.7]) < limit, "{case}");
        }
    }
    // Layers that grow by a third: cells of 1e-3 of the side.
    let height = |k: usize| (1.3_f64.powi(k as i32) - 1.0) / (1.3_f64.powi(19) - 1.0);
    let at = |[i, j, k]: [usize; 3]| turned(Vec3::new(i as f64 / 19.0, j as f64 / 19.0, height(k)));
    let grid = CyclideGrid::from_coordinate_planes([19; 3], at, VolumeFrame::Auto).unwrap();
    for (number, p) in grid.points().iter().enumerate() {
        assert!(p.distance(at([number % 20, number / 20 % 20, number / 400])) < 2e-14);
    }
}

/// Whichever side is the thin one, the last corner is known to the rounding of the others.
#[test]
fn thin_boxes_have_their_last_corner() {
    for thin in [1e-2, 1e-4, 1e-6, 1e-8] {
        for axis in 0..3 {
            let mut sides = [Vec3::X, Vec3::Y, Vec3::Z];
            sides[axis] *= thin;
            let [s, t, u] = sides.map(|side| rotation().rotate(side));
            let cube = SphericalCube::cuboid(Point3::ORIGIN, [s, t, u]).unwrap();
            let off = cube.corners()[7].distance(Point3::ORIGIN + s + t + u);
            assert!(off < 4e-15, "{thin:e} along {axis}: {off:e}"); // roundings of six corners of size 1
            let block = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
            assert_eq!(block.folds(), FoldVerdict::Regular, "{thin:e} along {axis}");
            // Corners are rounded to 2^-53 of 1: of the thin side that part is lost.
            assert!((block.measure().volume / thin - 1.0).abs() < 1e-15 / thin + 1e-13, "{thin:e} along {axis}");
        }
    }
}

/// The integral of the Jacobian is the flux through the faces, by quadrature of their own; or it is not known.
#[test]
fn volumes_of_thin_blocks_and_near_infinity_are_right_or_not_known() {
    let inside = [1.0; 3];
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.01]].map(Point3::from);
    let thin =
        CyclideVolume::new(&SphericalCube::from_barycentric(corners, inside, 0.5).unwrap(), VolumeFrame::Auto).unwrap();
    let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z]).unwrap();
    let cuboid = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
    let near = |x: f64, y: f64, above: f64| {
        cuboid.transformed(&Mobius::inversion(Point3::new(x, y, -above), 1.0).unwrap()).unwrap()
    };
    for (block, limit) in [(thin, 1e-11), (near(0.37, 0.61, 0.1), 1e-11), (near(-1e-3, -1e-3, 1e-3), 1e-11)] {
        let measure = block.measure().known().unwrap();
        let faces = block.to_body().unwrap().outer.known_volume().unwrap();
        assert!((measure.volume / faces - 1.0).abs() < limit, "{} {faces}", measure.volume);
    }
    // A ball of diameter 1000, but for its cap of angle 1e-3 and eight corners of the size 1: all of it is within 1e-3 of one place of a face.
    let ball = near(0.37, 0.61, 1e-3).measure().known().unwrap();
    let radius = 500.0_f64;
    let whole = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    assert!((ball.volume / whole - 1.0).abs() < 1e-6, "{}", ball.volume);
    assert!(ball.centroid.distance(Point3::new(0.37, 0.61, radius - 1e-3)) < 1e-3 * radius);
    // Through infinity there is no volume.
    let backwards = CyclideVolume::unbounded(&cube, VolumeFrame::First(Vec3::Y, Vec3::X)).unwrap();
    assert_eq!(backwards.measure().known().unwrap_err().reason(), "too-many-pieces");
}
