//! Nets and shells far from the origin, and their images there.

use super::data::{PLACES, cyclide_grid, generic_grid, kink};
use cyclide::{
    Frame, Point3, Vec3,
    conformal::{Conformal, Mobius},
    surface::{CyclidicNet, DupinCyclide, NetFrame, ParamSurface, QuadGrid},
};

const DISTANCES: [f64; 3] = [1.0, 1e3, 1e6];

fn shift(distance: f64) -> Vec3 {
    Vec3::new(0.48, -0.6, 0.64) * distance
}

#[test]
fn images_of_whole_cyclides_are_alike_wherever_they_are() {
    for distance in DISTANCES {
        let origin = Point3::ORIGIN + shift(distance);
        let place = |origin| Frame::from_normal(origin, Vec3::Z, Vec3::X).unwrap();
        let net =
            |origin| DupinCyclide::new(2.0, 0.7, 1.1).unwrap().placed(place(origin)).nets([4, 4]).unwrap().remove(0);
        let map = |origin| Mobius::inversion(origin + Vec3::new(0.3, 0.4, 2.6), 1.5).unwrap();
        let image = net(Point3::ORIGIN).transformed(&map(Point3::ORIGIN)).unwrap();
        let far = net(origin).transformed(&map(origin)).unwrap();
        // Rounding of the coordinates, by the directions of edges a fifth as long as the cyclide.
        let bound = 512.0 * f64::EPSILON * (distance + 4.0);
        for (here, there) in image.patches().zip(far.patches()) {
            for s in PLACES {
                for t in PLACES {
                    let error = there.point(s, t).distance(here.point(s, t) + shift(distance));
                    assert!(error <= bound, "{distance}: {error:e} > {bound:e}");
                }
            }
        }
        assert!(kink(&far) <= bound, "{:e}", kink(&far));
        let (here, there) = (image.to_shell().unwrap(), far.to_shell().unwrap());
        assert!(there.is_closed());
        assert!((there.volume() / here.volume() - 1.0).abs() <= bound, "{distance}");
        // And the shells themselves.
        let mapped = net(origin).to_shell().unwrap().transformed(&map(origin)).unwrap();
        assert!((mapped.volume() / here.volume() - 1.0).abs() <= bound, "{distance}");
    }
}

#[test]
fn nets_are_made_of_points_rounded_far_from_the_origin() {
    let moved = |grid: &QuadGrid, v: Vec3| {
        let points = grid.points().iter().map(|p| *p + v).collect();
        QuadGrid::new(points, grid.size(), grid.closed()).unwrap()
    };
    // Coordinates up to 1e8: rounded to 1e-8, that is to 1e-7 of the shortest edges.
    for distance in [1.0, 1e5, 1e8] {
        for grid in [
            cyclide_grid([2.0, 0.7, 1.1], [9, 7], [false; 2]),
            cyclide_grid([2.0, 0.7, 1.1], [16, 12], [true; 2]),
            generic_grid([8, 6]),
        ] {
            let here = CyclidicNet::new(grid.clone(), NetFrame::Auto).unwrap();
            let there = CyclidicNet::new(moved(&grid, shift(distance)), NetFrame::Auto).unwrap();
            let bound = 1e4 * f64::EPSILON * (distance + 4.0);
            for (here, there) in here.patches().zip(there.patches()) {
                let error = there.point(0.5, 0.5).distance(here.point(0.5, 0.5) + shift(distance));
                assert!(error <= bound, "{distance}: {error:e} > {bound:e}");
            }
        }
    }
}

#[test]
fn areas_and_volumes_of_images_near_infinity() {
    // Inverted about a point beside the vertex (38, 0, 0): one corner of four faces goes far away, and nearly all of the
    // area is near it in the parameters. The image is a whole cyclide again; cut at its own angles it has no such corner.
    let ring = DupinCyclide::new(50.0, 20.0, 32.0).unwrap();
    for beside in [1.0, 1e-2, 1e-3, -1e-3] {
        let map = Mobius::inversion(Point3::new(38.0 + beside, 1e-3 * beside, 0.0), 10.0).unwrap();
        let image = ring.to_shell().unwrap().transformed(&map).unwrap();
        let own = ring.transformed(&map).unwrap().to_shell().unwrap();
        // A center in the tube turns the shell inside out.
        let [area, volume] = [image.area() / own.area(), image.volume().abs() / own.volume()];
        // The size of the whole image is a difference of spheres: what is left of them is the square of the distance.
        let bound = 1e-11 + 32.0 * f64::EPSILON * (38.0 / beside).powi(2);
        assert!((area - 1.0).abs() < bound && (volume - 1.0).abs() < bound, "{beside}: {area} {volume}");
    }
}

#[test]
fn areas_and_volumes_far_away_are_those_here() {
    // Coordinates are rounded to 1e-8 there, but patches are smooth: the element is taken from their corners.
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap();
    let shell = |origin| {
        let place = Frame::from_normal(origin, Vec3::Z, Vec3::X).unwrap();
        ring.placed(place).nets([16, 16]).unwrap().remove(0).to_shell().unwrap()
    };
    let (here, there) = (shell(Point3::ORIGIN), shell(Point3::ORIGIN + shift(1e8)));
    for (a, b) in [(here.area(), there.area()), (here.volume(), there.volume())] {
        assert!((a / b - 1.0).abs() < 1e-7, "{a} {b}");
    }
}
