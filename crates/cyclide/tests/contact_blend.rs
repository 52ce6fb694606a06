//! Blends of tubes with plates and spheres: the envelope, solids, tangency, similarity, what is refused.

use std::f64::consts::FRAC_PI_2;

use cyclide::{BlendBase, BlendTube, Body, ContactBlend, NeckSide, PlateShape, Point3, TeeEnds, Vec3, surface_joints};

const SPHERE: BlendBase = BlendBase::Sphere { radius: 5.0 };
const PLATE: BlendBase = BlendBase::Plane(PlateShape::Rectangle([30.0, 28.0]));
const DISK: BlendBase = BlendBase::Plane(PlateShape::Disk(15.0));

fn tube(through: [f64; 3], direction: [f64; 3], radius: f64, taper: f64) -> BlendTube {
    let [x, y, z] = through;
    let [u, v, w] = direction;
    BlendTube { through: Point3::new(x, y, z), direction: Vec3::new(u, v, w), radius, taper, length: 12.0 }
}

/// Every edge closed and smooth, or a crease at a right angle, more or less by the taper where the tube ends.
fn check(body: &Body, taper: f64) {
    for joint in body.shells().flat_map(surface_joints) {
        let crease = [FRAC_PI_2 - taper, FRAC_PI_2 + taper, FRAC_PI_2].iter().any(|a| (joint.angle - a).abs() < 1e-9);
        assert!(joint.gap < 1e-11 && (joint.angle < 1e-8 || crease), "{joint:?}");
    }
}

#[test]
fn struts_on_spheres_are_solids() {
    for (through, direction, taper) in [
        ([0.0, 1.5, 0.0], [0.0, 0.0, 1.0], 0.0),
        ([0.4, 1.5, 0.0], [0.3, 0.1, 1.0], 0.05),
        ([0.0, 2.0, 1.0], [0.0, 0.0, 1.0], -0.05),
        ([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], 0.05),
    ] {
        let strut = tube(through, direction, 1.0, taper);
        for side in [NeckSide::Outside, NeckSide::Inside] {
            for wall in [None, Some(0.2)] {
                for ends in [TeeEnds::Flat, TeeEnds::Closed, TeeEnds::Open] {
                    let blend = ContactBlend::new(strut, SPHERE, 0.5).unwrap().with_side(side).with_ends(ends);
                    let blend = wall.map_or(Ok(blend), |wall| blend.with_wall(wall)).unwrap();
                    let made = blend.made().unwrap_or_else(|e| panic!("{through:?} {side:?} {wall:?} {ends:?}: {e}"));
                    println!(
                        "{through:?} {side:?} {wall:?} {ends:?} {:?} faces {}",
                        made.blend,
                        made.body.outer.faces().len()
                    );
                    assert_eq!(made.body.is_solid(), ends != TeeEnds::Open);
                    check(&made.body, taper);
                }
            }
        }
    }
}

#[test]
fn tubes_on_plates_are_solids() {
    for base in [PLATE, DISK] {
        for (direction, taper) in
            [([0.0, 0.0, 1.0], 0.1), ([0.5, 0.3, 1.0], 0.1), ([0.0, -0.8, 1.0], -0.1), ([0.4, 0.0, 1.0], 0.0)]
        {
            let strut = tube([0.3, 0.2, 0.0], direction, 2.0, taper);
            for side in [NeckSide::Outside, NeckSide::Inside] {
                for wall in [None, Some(0.2)] {
                    for ends in [TeeEnds::Flat, TeeEnds::Closed, TeeEnds::Open] {
                        let blend = ContactBlend::new(strut, base, 0.6).unwrap().with_side(side).with_ends(ends);
                        let blend = blend.with_thickness(1.0).unwrap();
                        let blend = wall.map_or(Ok(blend), |wall| blend.with_wall(wall)).unwrap();
                        let made =
                            blend.made().unwrap_or_else(|e| panic!("{direction:?} {side:?} {wall:?} {ends:?}: {e}"));
                        println!(
                            "{direction:?} {taper} {side:?} {wall:?} {ends:?} {:?} faces {}",
                            made.blend,
                            made.body.outer.faces().len()
                        );
                        assert_eq!(made.body.is_solid(), ends != TeeEnds::Open);
                        check(&made.body, taper);
                        assert!(made.blend.radii[1] - made.blend.radii[0] < 1e-13);
                    }
                }
            }
        }
    }
}
