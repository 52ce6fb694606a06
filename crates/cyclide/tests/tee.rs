//! Blended tees: closed, exact, tangent to both partners.

use cyclide::{PipeTee, PipeTeeBody, surface_joints};
use std::f64::consts::PI;

const MADE: PipeTeeBody = PipeTeeBody { reach: [5.0, 5.0], height: 5.0, wall: None };

#[test]
fn a_solid_tee_is_closed_and_smooth() {
    for (radii, offset, stations) in [
        ([2.0, 1.0], 0.0, vec![[0.0, 0.4]]),
        ([2.0, 1.1], 0.3, vec![[0.0, 0.4]]),
        ([2.0, 0.5], -1.2, vec![[0.0, 0.2], [2.0, 0.4], [4.0, 0.3]]),
        ([1.0, 0.9], 0.0, vec![[0.0, 0.3]]),
    ] {
        let tee = PipeTee::new(radii, offset, &stations, 2e-3).unwrap();
        println!(
            "{radii:?} {offset}: {} patches, {:e}, {:?}",
            tee.patches().len(),
            tee.deviation(),
            tee.radius_range()
        );
        let body = tee.body(&MADE).unwrap();
        assert!(body.is_solid());
        let volume = body.outer.volume();
        let [r1, r2] = radii;
        println!(
            "volume {volume} faces {} {}",
            body.outer.faces().len(),
            10.0 * PI * r1 * r1 + PI * r2 * r2 * (5.0 - r1)
        );
        let joints = surface_joints(&body.outer);
        let gap = joints.iter().map(|joint| joint.gap).fold(0.0, f64::max);
        let mut angles: Vec<(f64, [usize; 2])> = joints.iter().map(|joint| (joint.angle, joint.faces)).collect();
        angles.sort_by(|a, b| b.0.total_cmp(&a.0));
        println!("gap {gap:e} angles {:?}", angles.iter().filter(|(a, _)| *a < 1.5).take(8).collect::<Vec<_>>());
    }
}
