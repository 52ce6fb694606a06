//! Boxes of patches.

use super::data;
use cyclide::{
    Aabb, Point3,
    surface::{CyclidePatch, ParamSurface},
};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// The box of a grid of `n + 1` times `n + 1` points.
fn sampled(patch: &CyclidePatch, n: u32) -> Aabb {
    let at = |k: u32| f64::from(k) / f64::from(n);
    Aabb::of_points((0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))).map(|(i, j)| patch.point(at(i), at(j)))).unwrap()
}

/// How far the second box sticks out of the first.
fn excess(outer: Aabb, inner: Aabb) -> f64 {
    let low = outer.min - inner.min;
    let high = inner.max - outer.max;
    [low.x, low.y, low.z, high.x, high.y, high.z].into_iter().fold(0.0, f64::max)
}

#[test]
fn boxes_of_known_patches() {
    let unit = data::octant().bounds();
    assert!(unit.min.distance(Point3::ORIGIN) < 1e-15 && unit.max.distance(Point3::new(1.0, 1.0, 1.0)) < 1e-15);
    // All four quarters round the axis, all the way round the tube in thirds: 2.5 wide, 0.5 high.
    let third = |k: f64| [TAU / 3.0 * k, TAU / 3.0 * (k + 1.0)];
    let parts = [0.0, 1.0, 2.0].map(third);
    let patches = parts.iter().flat_map(|&u| parts.iter().map(move |&v| data::torus(u, v)));
    let whole = patches.map(|p| p.bounds()).reduce(Aabb::union).unwrap();
    assert!(whole.max.distance(Point3::new(2.5, 2.5, 0.5)) < 1e-14, "{whole:?}");
    assert!(whole.min.distance(Point3::new(-2.5, -2.5, -0.5)) < 1e-14, "{whole:?}");
}

#[test]
fn known_patches_stay_inside_and_touch() {
    for (name, patch) in data::known() {
        let (bounds, grid) = (patch.bounds(), sampled(&patch, 400));
        let size = grid.diagonal();
        // Rounding of the points; a grid of 400 misses a smooth extreme by (1/800)² of its curvature.
        assert!(excess(bounds, grid) <= 1e-14 * size, "{name}: {:e}", excess(bounds, grid) / size);
        assert!(excess(grid, bounds) <= 1e-4 * size, "{name}: {:e}", excess(grid, bounds) / size);
    }
}

proptest! {
    #[test]
    fn no_point_is_outside(patch in data::patch()) {
        let (bounds, grid) = (patch.bounds(), sampled(&patch, 48));
        prop_assert!(excess(bounds, grid) <= 1e-13 * grid.diagonal(), "{:e}", excess(bounds, grid));
    }

    #[test]
    fn every_side_is_touched_by_a_part(patch in data::patch()) {
        // The union of the boxes of sixteen parts is the same box: a missed or invented extreme would show.
        let at = |k: u32| f64::from(k) / 4.0;
        let parts = (0..16).map(|k| patch.sub_patch([at(k % 4), at(k % 4 + 1)], [at(k / 4), at(k / 4 + 1)]).unwrap());
        let union = parts.map(|p| p.bounds()).reduce(Aabb::union).unwrap();
        let whole = patch.bounds();
        let size = whole.diagonal();
        prop_assert!(excess(whole, union).max(excess(union, whole)) <= 1e-12 * size, "{whole:?} {union:?}");
    }
}
