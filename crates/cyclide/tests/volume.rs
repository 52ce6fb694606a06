//! Laws of volumes: three orthogonal families of cyclides, Möbius maps, parts, folds, measures (`docs/math/volumes.md`).

use cyclide::{
    Error, Point3, Quat, Vec3, VolumeJet,
    conformal::{Conformal, Mobius},
    error::{PartError, PatchError, VolumeError},
    surface::{DupinCyclide, ParamSurface},
    volume::{CyclideGrid, CyclideVolume, FoldVerdict, ParamVolume, SphericalCube, VolumeFrame},
};
use cyclide_testkit::volumes::{cube, deterministic, vector};
use proptest::prelude::*;

fn places() -> impl Iterator<Item = [f64; 3]> {
    let steps = [0.0, 0.3, 0.71, 1.0];
    steps.into_iter().flat_map(move |s| steps.into_iter().flat_map(move |t| steps.into_iter().map(move |u| [s, t, u])))
}

/// Largest size of the points of a block: what rounding of its coordinates is relative to.
fn place_of(block: &CyclideVolume) -> f64 {
    block.corners().iter().map(|p| p.to_vec().max_abs()).fold(block.size(), f64::max)
}

proptest! {
    #![proptest_config(deterministic(200))]

    /// Barycentric cubes are embedded, all their faces concircular: twelve points on six circles, on one sphere.
    #[test]
    fn cubes_are_spherical(cube in cube()) {
        prop_assert!(cube.is_embedded());
        let a = cube.corners();
        let size = a.iter().map(|p| p.distance(a[0])).fold(0.0, f64::max);
        for face in [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 4, 5], [2, 3, 6, 7], [0, 2, 4, 6], [1, 3, 5, 7]] {
            let [p, q, r, s] = face.map(|k| a[k]);
            // The imaginary part of a cross-ratio vanishes for points on a circle.
            let quat = |v: Vec3| Quat::from(v);
            let ratio = quat(p - q) * quat(q - s).inverse().unwrap() * quat(s - r) * quat(r - p).inverse().unwrap();
            let rounding = a.iter().map(|p| p.to_vec().max_abs()).fold(size, f64::max) / size;
            prop_assert!(ratio.vector().length() <= 1e-11 * rounding * ratio.norm().max(1.0), "{face:?}: {ratio:?}");
            prop_assert!(ratio.w < 0.0, "the sides of {face:?} cross");
        }
    }

    /// Parameter lines cross at right angles, derivatives are those of differences, the Jacobian is its closed form.
    #[test]
    fn coordinates_are_orthogonal(cube in cube()) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.is_ok());
        let block = block.unwrap();
        let rounding = place_of(&block) / block.size();
        for at in places() {
            let jet = block.jet(at);
            prop_assert!(jet.orthogonality() < 1e-13 * rounding, "{}", jet.orthogonality());
            prop_assert!(block.real_residual(at) < 1e-12 * rounding * block.size());
            let closed = block.jacobian(at);
            prop_assert!((jet.jacobian() - closed).abs() <= 1e-12 * closed.abs());
            check_differences(&block, at, &jet)?;
        }
    }

    /// The six faces and all coordinate surfaces are the patches of their corners and frames, and they have the lines of the block.
    #[test]
    fn coordinate_surfaces_are_patches(cube in cube(), x in 0.0..1.0) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.is_ok());
        let block = block.unwrap();
        let limit = 1e-12 * place_of(&block);
        for axis in 0..3 {
            let surface = block.surface(axis, x).unwrap();
            for (p, q) in [(0.0, 0.0), (0.2, 0.9), (1.0, 0.6)] {
                let at = match axis { 0 => [x, p, q], 1 => [p, x, q], _ => [p, q, x] };
                prop_assert!(surface.point(p, q).distance(block.point(at)) < limit);
                // The normal of one family is the direction of the lines across.
                let across = block.moving_frame(at)[axis];
                prop_assert!(surface.unit_normal(p, q).cross(across).length() < 1e-12);
                let arc = block.line(axis, [p, q]).unwrap();
                prop_assert!(arc.point(x).distance(block.point(at)) < limit);
            }
        }
        let inner = block.surface(0, 1.0).unwrap();
        prop_assert_eq!(inner, block.faces()[1]);
    }

    /// Möbius images have the same parameters and stay orthogonal.
    #[test]
    fn moebius_maps_keep_volumes(cube in cube(), centre in vector(1.0)) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.is_ok());
        let block = block.unwrap();
        let centre = block.corners()[0] + centre.unit().unwrap_or(Vec3::X) * (3.0 * block.size());
        let inversion = Mobius::inversion(centre, 2.0 * block.size()).unwrap();
        let mirror = Mobius::reflection(centre, Vec3::new(1.0, 2.0, -2.0)).unwrap();
        for map in [inversion, mirror, mirror.after(&inversion)] {
            let image = block.transformed(&map).unwrap();
            prop_assert_eq!(image.is_right_handed(), map.determinant() > 0.0);
            for at in places() {
                let wanted = map.map_point(block.point(at)).unwrap();
                prop_assert!(image.point(at).distance(wanted) < 1e-11 * (place_of(&block) + place_of(&image)));
            }
            prop_assert_eq!(image.folds() == FoldVerdict::Regular, block.folds() == FoldVerdict::Regular);
        }
    }

    /// Parts, reversals and permutations are the same points; the exact form is the block.
    #[test]
    fn parts_and_forms_are_the_block(cube in cube(), x in 0.1..0.9) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.is_ok());
        let block = block.unwrap();
        let limit = 1e-12 * place_of(&block);
        let [left, right] = block.split(1, x).unwrap();
        let (reversed, permuted) = (block.reversed(2), block.permuted([2, 0, 1]).unwrap());
        prop_assert!(block.is_right_handed() && !reversed.is_right_handed() && permuted.is_right_handed());
        let exact = block.to_rational_parts().unwrap();
        for [s, t, u] in places() {
            let p = block.point([s, t, u]);
            prop_assert!(left.point([s, t / x, u]).distance(p) < limit || t > x);
            prop_assert!(right.point([s, (t - x) / (1.0 - x), u]).distance(p) < limit || t < x);
            prop_assert!(reversed.point([s, t, 1.0 - u]).distance(p) < limit);
            prop_assert!(permuted.point([u, s, t]).distance(p) < limit);
            let jet = permuted.jet([u, s, t]);
            prop_assert!((jet.jacobian() - block.jacobian([s, t, u])).abs() <= 1e-11 * jet.jacobian().abs());
        }
        for (ranges, form) in exact {
            prop_assert!(form.has_positive_weights());
            for at in places() {
                let place = std::array::from_fn(|k| ranges[k][0] + (ranges[k][1] - ranges[k][0]) * at[k]);
                prop_assert!(form.point(at).distance(block.point(place)) < limit);
            }
        }
    }

    /// The place of a point of the block is found; the solid has the volume and the centroid of the quadrature.
    #[test]
    fn places_and_measures(cube in cube(), at in (0.0..1.0, 0.0..1.0, 0.0..1.0)) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.as_ref().is_ok_and(|block| block.folds() == FoldVerdict::Regular));
        let block = block.unwrap();
        let at = [at.0, at.1, at.2];
        let found = block.locate(block.point(at));
        prop_assert!(found.distance < 1e-11 * place_of(&block), "{found:?} {at:?}");
        let measure = block.measure();
        let body = block.to_body().unwrap();
        prop_assert!(body.is_solid());
        // Coordinates are rounded: the volume is known to that times the surface.
        let limit = 1e-11 * measure.volume + 1e-15 * place_of(&block) * block.size().powi(2);
        prop_assert!((body.outer.volume() - measure.volume).abs() < limit, "{} {}", body.outer.volume(), measure.volume);
        let (whole, parts) = (measure, block.split(0, 0.4).unwrap().map(|part| part.measure()));
        let sum = parts[0].volume + parts[1].volume;
        prop_assert!((sum - whole.volume).abs() < limit);
        let first = block.corners()[0];
        let mean = ((parts[0].centroid - first) * parts[0].volume + (parts[1].centroid - first) * parts[1].volume) / sum;
        prop_assert!((mean - (whole.centroid - first)).length() < 1e-11 * place_of(&block));
    }
}

/// Derivatives against central differences, to the square of the step and rounding over it.
fn check_differences(block: &CyclideVolume, at: [f64; 3], jet: &VolumeJet) -> Result<(), TestCaseError> {
    let step = 1e-4;
    // Beyond the ends the formula goes on.
    let moved = |axis: usize, by: f64| {
        let mut to = at;
        to[axis] += by;
        block.jet(to)
    };
    let pairs = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];
    for (axis, mixed) in pairs.into_iter().enumerate() {
        let (before, after) = (moved(axis, -step), moved(axis, step));
        let slope = (after.point - before.point) / (2.0 * step);
        let size = jet.first.iter().map(|v| v.length()).fold(block.size(), f64::max);
        let rounding = 1e-11 * place_of(block);
        prop_assert!(
            (slope - jet.first[axis]).length() < 1e-5 * size + rounding,
            "{axis}: {slope:?} {:?}",
            jet.first[axis]
        );
        for (other, place) in mixed.into_iter().enumerate() {
            let slope = (after.first[other] - before.first[other]) / (2.0 * step);
            let second = jet.second[place];
            prop_assert!(
                (slope - second).length() < 1e-4 * (size + second.length()) + rounding,
                "{axis}{other}: {slope:?} {second:?}"
            );
        }
    }
    Ok(())
}

#[test]
fn a_cuboid_with_its_own_frame_is_trilinear() {
    let cube = SphericalCube::cuboid(Point3::new(1.0, 2.0, 3.0), [Vec3::X * 2.0, Vec3::Y * 3.0, Vec3::Z]).unwrap();
    let block = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
    for [s, t, u] in places() {
        assert!(block.point([s, t, u]).distance(Point3::new(1.0 + 2.0 * s, 2.0 + 3.0 * t, 3.0 + u)) < 1e-14); // a few roundings of 5
    }
    assert!((block.measure().volume - 6.0).abs() < 1e-13); // a sum of 4096 terms
}

#[test]
fn a_spherical_shell_has_its_volume() {
    // Between the spheres of radius 1 and 2, longitudes and latitudes from 0 to 0.8: r by u.
    let at = |radius: f64, long: f64, lat: f64| {
        Point3::new(radius * lat.cos() * long.cos(), radius * lat.cos() * long.sin(), radius * lat.sin())
    };
    let corners = [
        (1.0, 0.0, 0.0),
        (1.0, 0.8, 0.0),
        (1.0, 0.0, 0.8),
        (1.0, 0.8, 0.8),
        (2.0, 0.0, 0.0),
        (2.0, 0.8, 0.0),
        (2.0, 0.0, 0.8),
    ];
    let cube = SphericalCube::new(corners.map(|(r, a, b)| at(r, a, b))).unwrap();
    assert!(cube.corners()[7].distance(at(2.0, 0.8, 0.8)) < 1e-14);
    let block = CyclideVolume::new(&cube, VolumeFrame::First(Vec3::Y, Vec3::Z)).unwrap();
    assert_eq!(block.folds(), FoldVerdict::Regular);
    let volume = 7.0 / 3.0 * 0.8 * 0.8_f64.sin();
    let measure = block.measure();
    assert!((measure.volume - volume).abs() < 1e-13, "{} {volume}", measure.volume);
    assert!((block.to_body().unwrap().outer.volume() - volume).abs() < 1e-12);
    for [s, t, u] in places() {
        let p = block.point([s, t, u]).to_vec();
        assert!((p.length() - block.point([0.0, 0.0, u]).to_vec().length()).abs() < 1e-14);
    }
}

#[test]
fn left_handed_corners_make_left_handed_blocks() {
    let sides = [Vec3::Y, Vec3::X, Vec3::Z];
    let cube = SphericalCube::cuboid(Point3::ORIGIN, sides).unwrap();
    let block = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
    assert!(!block.is_right_handed() && block.jacobian([0.5; 3]) < 0.0);
    let turned = block.right_handed();
    assert!(turned.is_right_handed() && turned.jacobian([0.5; 3]) > 0.0);
    assert_eq!(turned.point([0.2, 0.7, 0.1]), block.point([0.7, 0.2, 0.1]));
    // A frame that is bent away from the sides works as well on both.
    let corners = [[0.0, 0.0, 0.0], [-0.2, 1.0, 0.1], [1.0, 0.2, -0.1], [0.1, -0.1, 0.9]].map(Point3::from);
    let cube = SphericalCube::from_barycentric(corners, [1.0, 0.8, 1.3], 0.4).unwrap();
    let block = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
    for at in places() {
        assert!(block.jet(at).orthogonality() < 1e-14 && block.real_residual(at) < 1e-14 && block.jacobian(at) < 0.0);
    }
}

#[test]
fn what_has_no_volume_is_named() {
    let reason = |points: [[f64; 3]; 7]| SphericalCube::new(points.map(Point3::from)).unwrap_err().reason();
    let mut cuboid = [[0., 0., 0.], [2., 0., 0.], [0., 3., 0.], [2., 3., 0.], [0., 0., 1.], [2., 0., 1.], [0., 3., 1.]];
    assert!(SphericalCube::new(cuboid.map(Point3::from)).is_ok());
    cuboid[1] = [0.0, 0.0, 0.0];
    assert_eq!(reason(cuboid), "coincident-points");
    cuboid[1] = [f64::NAN, 0.0, 0.0];
    assert_eq!(reason(cuboid), "not-finite");
    cuboid[1] = [2.0, 0.0, 0.3];
    assert_eq!(reason(cuboid), "not-concircular");
    let flat =
        [[0., 0., 0.], [2., 0., 0.], [0., 3., 0.], [2.5, 2.5, 0.], [2., 3., 0.], [2.5, 0.5, 0.], [-0.5, 2.5, 0.]];
    assert_eq!(reason(flat), "concircular-cube");
    // Faces away from the first corner may cross: the positions of a twisted cube.
    let corners = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]].map(Point3::from);
    let twisted = SphericalCube::from_positions(corners, [0.9, 0.9, 0.5]).unwrap();
    assert!(!twisted.is_embedded());
    let error = CyclideVolume::new(&twisted, VolumeFrame::Auto).unwrap_err();
    assert_eq!(error.reason(), "crossing-face");
    assert!(matches!(error, Error::Volume(VolumeError::CrossingFace { speed, limit, .. }) if speed < limit));
}

/// Blocks side by side agree on their common face, point by point.
fn check_shared(grid: &CyclideGrid, limit: f64) {
    let [m, n, l] = grid.size();
    for (i, j, k) in (0..l).flat_map(|k| (0..n).flat_map(move |j| (0..m).map(move |i| (i, j, k)))) {
        let block = grid.block([i, j, k]);
        for (x, y) in [(0.0, 0.0), (0.3, 0.8), (1.0, 0.5)] {
            let near = |axis: usize, end: f64| match axis {
                0 => [end, x, y],
                1 => [x, end, y],
                _ => [x, y, end],
            };
            for (axis, size) in grid.size().into_iter().enumerate() {
                let mut next = [i, j, k];
                next[axis] += 1;
                if next[axis] < size {
                    let other = grid.block(next);
                    assert!(block.point(near(axis, 1.0)).distance(other.point(near(axis, 0.0))) <= limit);
                }
            }
        }
    }
}

#[test]
fn layers_of_a_ring_cyclide_close_and_are_orthogonal() {
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([6, 6]).unwrap().remove(0);
    let distances = [-0.8, -0.3, 0.0, 0.4];
    let grid = CyclideGrid::layers(&ring, &distances).unwrap();
    assert_eq!(grid.size(), [6, 6, 3]);
    check_shared(&grid, 1e-14); // points are counted from the first corner of each block
    let mut sum = 0.0;
    for (number, block) in grid.blocks().enumerate() {
        assert_eq!(block.folds(), FoldVerdict::Regular);
        let (quad, layer) = (number % 36, number / 36);
        let patch = ring.patch(quad % 6, quad / 6);
        for [s, t, u] in places() {
            assert!(block.jet([s, t, u]).orthogonality() < 1e-13);
            let h = distances[layer] + u * (distances[layer + 1] - distances[layer]);
            let offset = patch.point(s, t) + patch.unit_normal(s, t) * h;
            assert!(block.point([s, t, u]).distance(offset) < 1e-13);
        }
        sum += block.measure().volume;
    }
    // Between the solids of the offsets.
    let solid = |h: f64| ring.offset(h).unwrap().to_shell().unwrap().volume();
    let between = solid(0.4) - solid(-0.8);
    assert!((sum - between.abs()).abs() < 1e-10 * sum, "{sum} {between}");
}

/// The limit of layers is that of the whole net: whatever is asked for it is the same, and what is just nearer is made.
#[test]
fn the_limit_of_layers_is_that_of_the_nearest_patch() {
    // Inwards the tube is thinnest where its radius is mu - c = 1.
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([6, 6]).unwrap().remove(0);
    let limit = |h: f64| match CyclideGrid::layers(&ring, &[h, 0.0]).unwrap_err() {
        Error::Part(PartError::InQuad { cause, .. }) => match *cause {
            Error::Patch(PatchError::OffsetNotRegular { limit, .. }) => limit,
            other => panic!("{other}"),
        },
        other => panic!("{other}"),
    };
    let all: Vec<f64> = [-1.02, -1.2, -1.7, -2.5, -2.9].map(limit).to_vec();
    assert!(all.iter().all(|found| (found + 1.0).abs() < 1e-9), "{all:?}"); // mu - c
    assert!(CyclideGrid::layers(&ring, &[-1.0 + 1e-6, 0.0]).is_ok());
    // What the message says can be taken, in its few digits.
    let (mut refused, mut made) = (0, 0);
    for (c, mu) in [(0.712_345_6, 1.987_654_3), (0.3, 1.123_456_7), (1.0 / 3.0, 10.0 / 3.0)] {
        let net = DupinCyclide::new(4.0, c, mu).unwrap().nets([8, 6]).unwrap().remove(0);
        for h in [-9.0, -3.5, 3.5, 9.0] {
            let layers = |h: f64| CyclideGrid::layers(&net, &[h.min(0.0), h.max(0.0)]);
            let Err(error) = layers(h) else { continue };
            refused += 1;
            let text = error.to_string();
            let words = text.split("limit ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
            made += usize::from(layers(words.parse().unwrap()).is_ok());
        }
    }
    assert!(refused >= 6 && made == refused, "{made} of {refused}");
}

#[test]
fn grids_follow_from_their_coordinate_planes() {
    // A grid of boxes of uneven sizes, inverted: the last corner of every cube is the image of that of the box.
    let (x, y, z) = ([0.0, 1.0, 1.5, 2.5], [0.0, 0.7, 1.9], [0.0, 0.5, 1.2]);
    let map = Mobius::inversion(Point3::new(-1.0, 2.5, 3.5), 2.0).unwrap();
    let image = |[i, j, k]: [usize; 3]| map.map_point(Point3::new(x[i], y[j], z[k])).unwrap();
    // The map reverses orientation: of two directions pushed forward the third is against theirs.
    let [v1, v2] = [Vec3::X, Vec3::Y].map(|v| map.push_forward(Point3::ORIGIN, v).unwrap());
    let turned = |[i, j, k]: [usize; 3]| image([j, i, k]);
    let grid = CyclideGrid::from_coordinate_planes([2, 3, 2], turned, VolumeFrame::First(v2, v1)).unwrap();
    check_shared(&grid, 1e-14);
    for (number, p) in grid.points().iter().enumerate() {
        let at = [number % 3, number / 3 % 4, number / 12];
        assert!(p.distance(turned(at)) < 1e-13, "{at:?}");
    }
    for block in grid.blocks() {
        assert_eq!(block.folds(), FoldVerdict::Regular);
        for at in places() {
            assert!(block.real_residual(at) < 1e-13 && block.jet(at).orthogonality() < 1e-12);
        }
    }
    // Left-handed grids have left-handed frames.
    let left = CyclideGrid::from_coordinate_planes([3, 2, 2], image, VolumeFrame::Auto).unwrap();
    check_shared(&left, 1e-14);
    for block in left.blocks() {
        assert!(!block.is_right_handed());
        for at in places() {
            assert!(block.real_residual(at) < 1e-13 && block.jet(at).orthogonality() < 1e-12);
        }
    }
    assert_eq!(
        CyclideGrid::from_coordinate_planes([2, 0, 2], turned, VolumeFrame::First(v2, v1)).unwrap_err().reason(),
        "too-few-points"
    );
    let off = |at: [usize; 3]| turned(at) + if at == [2, 1, 0] { Vec3::new(0.0, 0.0, 0.1) } else { Vec3::ZERO };
    let error = CyclideGrid::from_coordinate_planes([2, 3, 2], off, VolumeFrame::First(v2, v1)).unwrap_err();
    assert_eq!((error.reason(), error.index()), ("not-concircular", Some(1)));
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([6, 6]).unwrap().remove(0);
    assert_eq!(CyclideGrid::layers(&ring, &[0.0]).unwrap_err().reason(), "too-few-points");
    assert_eq!(CyclideGrid::layers(&ring, &[0.0, 0.0]).unwrap_err().reason(), "parameters-not-increasing");
}

/// The corners of a bend between two radii, by height: of the box of radius, angle and height in another order.
fn bend([from, to]: [f64; 2], angle: f64, height: f64, order: usize) -> [Point3; 7] {
    std::array::from_fn(|k| {
        let bit = |axis: usize| (k >> ((axis + order) % 3) & 1) as f64;
        let (radius, angle) = (from + (to - from) * bit(0), angle * bit(1));
        Point3::new(radius * angle.cos(), radius * angle.sin(), height * bit(2))
    })
}

#[test]
fn bends_and_shells_have_straight_sides_without_a_frame() {
    for (radii, degrees, height) in
        [([40.0, 60.0], 90.0_f64, 20.0), ([40.0, 60.0], 180.0, 0.2), ([1.0, 100.0], 30.0, 7.0)]
    {
        let angle = degrees.to_radians();
        let volume = 0.5 * angle * (radii[1] * radii[1] - radii[0] * radii[0]) * height;
        for order in 0..3 {
            let cube = SphericalCube::new(bend(radii, angle, height, order)).unwrap();
            let block = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
            assert_eq!(block.folds(), FoldVerdict::Regular);
            assert!((block.measure().volume / volume - 1.0).abs() < 1e-12, "{degrees} {order}"); // corners of 1e2, rounded, over sides of 0.2
        }
    }
    // Of a part of the shell of a sphere only the radii are straight: longitudes and latitudes 0 to 0.8.
    let cube = SphericalCube::new(std::array::from_fn(|k| {
        let bit = |axis: usize| (k >> axis & 1) as f64;
        let (long, lat, radius) = (0.8 * bit(0), 0.8 * bit(1), 1.0 + bit(2));
        Point3::new(radius * lat.cos() * long.cos(), radius * lat.cos() * long.sin(), radius * lat.sin())
    }));
    let block = CyclideVolume::new(&cube.unwrap(), VolumeFrame::Auto).unwrap();
    assert!((block.measure().volume - 7.0 / 3.0 * 0.8 * 0.8_f64.sin()).abs() < 1e-13);
}

/// Of thin boxes the short sides decide: where the frame is off these by an angle, it bends them by that over their length.
#[test]
fn noisy_boxes_with_short_sides_are_regular() {
    let mut seed = 1_u64;
    let mut random = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut made, mut regular) = (0, 0);
    while made < 200 {
        let mut corners = [Point3::ORIGIN; 4];
        for (k, axis) in [Vec3::X, Vec3::Y, Vec3::Z].into_iter().enumerate() {
            let length = 10f64.powf(-3.0 * random());
            // Sums of three, of the variance 1/16.
            let mut noise = || 0.25 * 2.0 * (random() + random() + random() - 1.5);
            corners[k + 1] = Point3::ORIGIN + (axis + Vec3::new(noise(), noise(), noise())) * length;
        }
        let ways = [1, 2, 3].map(|k| corners[k] - corners[0]);
        if ways[0].cross(ways[1]).dot(ways[2]) <= 0.0 {
            continue;
        }
        made += 1;
        let cube = SphericalCube::from_barycentric(corners, ways.map(Vec3::length_squared), 0.5).unwrap();
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        regular += usize::from(block.is_ok_and(|block| block.folds() == FoldVerdict::Regular));
    }
    // With the unit directions of the sides little more than half of them were.
    assert!(regular >= 197, "{regular} of {made}");
    // A thin box, its corners rounded ten sizes from the origin: the thin side has its direction to 1e-7.
    let turn = Quat::from_axis_angle(Vec3::new(1.0, 2.0, -0.7).unit().unwrap(), 1.1);
    let sides = [Vec3::X, Vec3::Y, Vec3::Z * 1e-8].map(|side| turn.rotate(side));
    let cube = SphericalCube::cuboid(Point3::new(10.0, 10.0, 10.0), sides).unwrap();
    let volume = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap().measure().volume;
    assert!((volume / 1e-8 - 1.0).abs() < 1e-6, "{volume:e}"); // four roundings of 2e-15 over 1e-8
}

#[test]
fn left_handed_corners_take_the_directions_of_their_sides() {
    let mirrored = |p: Point3| Point3::new(-p.x, p.y, p.z);
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, -0.1], [-0.2, 1.0, 0.1], [0.1, -0.1, 0.9]].map(Point3::from);
    let block = |corners: [Point3; 4], [v1, v2]: [Vec3; 2]| {
        let cube = SphericalCube::from_barycentric(corners, [1.0, 0.8, 1.3], 0.4).unwrap();
        CyclideVolume::new(&cube, VolumeFrame::First(v1, v2)).unwrap()
    };
    let frame = [Vec3::new(1.0, 0.2, 0.0), Vec3::new(-0.2, 1.0, 0.0)];
    let plain = block(corners, frame);
    let image = block(corners.map(mirrored), frame.map(|v| Vec3::new(-v.x, v.y, v.z)));
    assert!(plain.is_right_handed() && !image.is_right_handed());
    for at in places() {
        assert!(image.point(at).distance(mirrored(plain.point(at))) < 1e-14);
    }
    // A box with s and t exchanged, and a grid of such.
    let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::Y, Vec3::X, Vec3::Z]).unwrap();
    let exchanged = CyclideVolume::new(&cube, VolumeFrame::First(Vec3::Y, Vec3::X)).unwrap();
    assert!(exchanged.point([0.2, 0.7, 0.1]).distance(Point3::new(0.7, 0.2, 0.1)) < 1e-15);
    let at = |[i, j, k]: [usize; 3]| Point3::new(j as f64, i as f64, k as f64);
    let grid = CyclideGrid::from_coordinate_planes([2; 3], at, VolumeFrame::First(Vec3::Y, Vec3::X)).unwrap();
    assert!((grid.blocks().map(|block| block.measure().volume).sum::<f64>() - 8.0).abs() < 1e-13);
    // Sides of half a turn are neither with their direction nor against it: that is the cross product.
    let half = SphericalCube::new(bend([40.0, 60.0], std::f64::consts::PI, 20.0, 1)).unwrap();
    let half = CyclideVolume::new(&half, VolumeFrame::First(Vec3::Z, Vec3::X)).unwrap();
    assert!(half.is_right_handed() && half.point([0.0, 0.0, 0.5]).distance(Point3::new(0.0, 40.0, 0.0)) < 1e-13);
}
