//! `sample`: which places, and which frames.

use std::path::PathBuf;

use clap::{Args as ClapArgs, ValueEnum};
use cyclide::{
    Point3, Vec3,
    curve::{ClosedTwist, FrameRule},
};
use cyclide_io::{
    file::WriteOptions,
    report::{SamplePlaces, Spacing},
};

use super::files::{Input, ReadArgs, WriteArgs, refuse_folder_name, refuse_other_suffix, refuse_overwriting};
use super::numbers::positive;
use crate::output::failure::Failure;
use crate::output::standard::is_standard_output;

pub const EXAMPLES: &str = "\
Examples:
  cyclide sample logo.json --count 500 > logo.csv
  cyclide sample cable.json --object cable --count 200 --equal-length -o cable.csv
  cyclide sample road.json --step 5 --frames up -o road.csv
  cyclide sample dolly.json --count 240 --equal-length --frames look-at --toward 0,0,1.6 -o camera.csv
  cyclide sample cable.json --object cable --step 10 --frames rotation-minimizing -o cable-frames.json
  cyclide sample roof.json --object 'outer skin' --count 8 -o roof.csv
  cyclide sample gripper.json --object gripper --count 101 -o poses.csv
  cyclide sample gripper.json --object gripper --step 0.008 -o controller.csv

Curves: columns t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion, with --frames also normal_x to
normal_z and binormal_x to binormal_z (for look-at preceded by look_x to look_z), with a leading column 'contour' if the object has several. The station is the arc length
from the start; signed curvature is for plane curves only and positive to the left. Each contour gets its own samples, including both ends.
Surfaces: columns patch,s,t,x,y,z,normal_x,normal_y,normal_z,curvature_s,curvature_t on a grid of N by N points of every
patch, including its edges, with a leading column 'body' if the object has several.
Volumes: columns s,t,u,x,y,z,jacobian on a grid of N by N by N points of every block, with a leading column 'block' if the object has several.
Motions: columns time,x,y,z,qw,qx,qy,qz,m11 to m34 (a quaternion, and the rows of the matrix),speed,angular_speed,acceleration at equal
time steps, or at a given interval in seconds (--step) and at the end; JSON has poses in the form of documents. Both can be read back as poses.";

#[derive(Debug, ClapArgs)]
pub struct SampleArgs {
    /// The model document (JSON), - for standard input; 'cyclide new' prints one to start from.
    pub model: PathBuf,
    #[command(flatten)]
    pub read: ReadArgs,
    /// Name of the object; optional if there is only one.
    #[arg(long, value_name = "NAME")]
    pub object: Option<String>,
    /// Samples per contour of a curve or per motion, N by N per patch of a surface, N by N by N per block of a volume; at least 2.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=10_000_000), allow_hyphen_values = true, required_unless_present_any = ["step", "cells"])]
    pub count: Option<u32>,
    /// Curves: a sample at every arc length D and at the end; motions: every D seconds and at the end.
    #[arg(long, value_name = "D", value_parser = positive, allow_hyphen_values = true, conflicts_with = "count")]
    pub step: Option<f64>,
    /// Volumes: sample the nodes of the cells into which the document divides the blocks.
    #[arg(long, conflicts_with_all = ["count", "step"])]
    pub cells: bool,
    /// Curves: equal steps in arc length instead of the parameter.
    #[arg(long, conflicts_with = "step")]
    pub equal_length: bool,
    /// Curves: add a frame to each sample: normal and binormal (tangent x normal) besides the tangent.
    #[arg(long, value_name = "KIND", value_enum)]
    pub frames: Option<FrameKind>,
    /// Frames: the up direction for up and look-at, or the direction of the first normal for rotation-minimizing [default: 0,0,1].
    #[arg(long, value_name = "X,Y,Z", value_parser = triple, allow_hyphen_values = true)]
    pub up: Option<[f64; 3]>,
    /// Frames: the target point for toward and look-at.
    #[arg(long, value_name = "X,Y,Z", value_parser = triple, allow_hyphen_values = true, required_if_eq_any([("frames", "toward"), ("frames", "look-at")]))]
    pub toward: Option<[f64; 3]>,
    /// Frames, rotation-minimizing: distribute the closing rotation of the frame over a closed curve, so that the
    /// frames close.
    #[arg(long)]
    pub spread_twist: bool,
    /// Curves and motions: print JSON instead of CSV; so does an output FILE.json.
    #[arg(long)]
    pub json: bool,
    /// Write to a file instead of standard output.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub write: WriteArgs,
}

/// The rule for normals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum FrameKind {
    /// As close to the up direction (--up) as possible.
    Up,
    /// As close to the direction of a point (--toward) as possible.
    Toward,
    /// A first axis that points exactly at a point (--toward) instead of the tangent, with normals as close to up (--up) as
    /// possible: for cameras and tools.
    LookAt,
    /// Toward the center of curvature; undefined where the curve is straight.
    Frenet,
    /// Without rotation about the tangent.
    RotationMinimizing,
}

/// Sample one object of a model.
pub struct SamplePlan {
    pub input: Input,
    pub read_below: Option<PathBuf>,
    pub object: Option<String>,
    pub places: SamplePlaces,
    pub frames: Option<FrameRule>,
    /// The nodes of cells, not places.
    pub cells: bool,
    pub json: bool,
    /// `None` is standard output.
    pub output: Option<PathBuf>,
    pub write: WriteOptions,
}

impl SampleArgs {
    pub fn plan(self) -> Result<SamplePlan, Failure> {
        self.output.as_deref().map_or(Ok(()), refuse_folder_name)?;
        refuse_overwriting(self.output.as_deref(), &self.model)?;
        let frames = self.frame_rule()?;
        let output = self.output.filter(|path| !is_standard_output(path));
        let has_suffix = |path: &PathBuf| path.extension().is_some_and(|suffix| suffix.eq_ignore_ascii_case("json"));
        let json = self.json || output.as_ref().is_some_and(has_suffix);
        let (suffix, what) = if json { ("json", "--json requests JSON") } else { ("csv", "samples are CSV or JSON") };
        output.as_deref().map_or(Ok(()), |path| refuse_other_suffix(path, suffix, what))?;
        let spacing = if self.equal_length { Spacing::Length } else { Spacing::Parameter };
        let places = match (self.step, self.count) {
            (Some(step), _) => SamplePlaces::Step(step),
            (None, count) => SamplePlaces::Count { count: count.unwrap_or(2) as usize, spacing },
        };
        let (input, write) = (Input::File(self.model), self.write.options());
        Ok(SamplePlan {
            input,
            read_below: self.read.read_below,
            object: self.object,
            places,
            frames,
            cells: self.cells,
            json,
            output,
            write,
        })
    }

    fn frame_rule(&self) -> Result<Option<FrameRule>, Failure> {
        let idle = |given: bool, option: &str, with: &str| {
            let message = format!("{option} would have no effect: it requires --frames {with}");
            if given { Err(Failure::Usage(message)) } else { Ok(()) }
        };
        let minimal = self.frames == Some(FrameKind::RotationMinimizing);
        let has_up = minimal || matches!(self.frames, Some(FrameKind::Up | FrameKind::LookAt));
        let has_point = matches!(self.frames, Some(FrameKind::Toward | FrameKind::LookAt));
        idle(self.up.is_some() && !has_up, "--up", "up, look-at or rotation-minimizing")?;
        idle(self.toward.is_some() && !has_point, "--toward", "toward or look-at")?;
        idle(self.spread_twist && !minimal, "--spread-twist", "rotation-minimizing")?;
        let closed = if self.spread_twist { ClosedTwist::Spread } else { ClosedTwist::Leave };
        let (up, point) = (self.up.map_or(Vec3::Z, Vec3::from), self.toward.map_or(Point3::ORIGIN, Point3::from));
        Ok(self.frames.map(|kind| match kind {
            FrameKind::Up => FrameRule::Up(up),
            FrameKind::Toward => FrameRule::Toward(point),
            FrameKind::LookAt => FrameRule::LookAt { target: point, up },
            FrameKind::Frenet => FrameRule::Frenet,
            FrameKind::RotationMinimizing => match FrameRule::rotation_minimizing() {
                FrameRule::RotationMinimizing { tolerance, .. } => {
                    FrameRule::RotationMinimizing { start: self.up.map(Vec3::from), closed, tolerance }
                }
                other => other,
            },
        }))
    }
}

/// Three numbers between commas.
fn triple(text: &str) -> Result<[f64; 3], String> {
    let numbers: Vec<f64> = text.split(',').filter_map(|part| part.trim().parse().ok()).collect();
    match <[f64; 3]>::try_from(numbers) {
        Ok(numbers) if text.split(',').count() == 3 && numbers.iter().all(|v| v.is_finite()) => Ok(numbers),
        _ => Err("must be three comma-separated numbers, as in 0,0,1".to_owned()),
    }
}
