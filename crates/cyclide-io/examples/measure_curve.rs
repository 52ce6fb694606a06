//! What a curve is like: length, box, joints, largest curvature, and the place nearest to a point.
//!
//! `cargo run --release --example measure_curve`
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3,
    construct::Pipe,
    curve::{ArcPath, ParamCurve, bounds, closest_point, extreme_curvature, joints, length},
};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let points = [[0.0, 0.0, 0.0], [120.0, 0.0, 0.0], [120.0, 80.0, 0.0], [120.0, 80.0, 90.0]].map(Point3::from);
    let run = ArcPath::rounded_polyline(&points, false, &[25.0; 4])?;
    let size = bounds(&run);
    println!("length {:.3} mm, box {:?} to {:?}", length(&run), size.min.to_array(), size.max.to_array());
    let kink = joints(&run).iter().map(|joint| joint.angle).fold(0.0, f64::max);
    println!("{} joints, {kink:.1e} rad off at most", joints(&run).len());
    let bend = extreme_curvature(&run);
    println!("smallest radius {:.3} mm", 1.0 / bend.max);
    let foot = closest_point(&run, Point3::new(60.0, 40.0, 10.0));
    println!(
        "nearest at t = {:.4}, {:.3} mm away; direction there {:?}",
        foot.t,
        foot.distance,
        run.jet(foot.t).tangent()
    );
    // And what it is the middle line of.
    let pipe = Pipe::new(10.0)?.with_wall(2.0)?.body(&run)?;
    println!("a pipe about it holds {:.0} mm³", pipe.outer.volume());
    Ok(())
}
