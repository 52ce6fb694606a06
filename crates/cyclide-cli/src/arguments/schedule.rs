//! `schedule`: nets as lists and drawings for a workshop.

use std::path::PathBuf;

use clap::{ArgAction, Args as ClapArgs};
use cyclide_io::{file::WriteOptions, schedule::ScheduleOptions};

use super::files::{Input, ReadArgs, WriteArgs, refuse_file_name};
use super::numbers::positive;
use crate::output::failure::Failure;

pub const EXAMPLES: &str = "\
Examples:
  cyclide schedule roof.json -o workshop
  cyclide schedule roof.json -o workshop --thickness 0.04 --beam-depth -0.25
  cyclide schedule roof.json -o workshop --object skin --tolerance 0.002 --congruent-within 0.001

The folder contains panels.csv, edges.csv, nodes.csv and beams.csv, the same data with totals in schedule.json, plan.dxf with the panel
numbers, beams.dxf with the beams unrolled, and patterns.dxf with the flat patterns of singly curved panels. docs/schedule.md explains
every column.";

#[derive(Debug, ClapArgs)]
pub struct ScheduleArgs {
    /// The model document (JSON), or - for standard input.
    pub model: PathBuf,
    #[command(flatten)]
    pub read: ReadArgs,
    /// The folder for the files, created if it does not exist.
    #[arg(short, long = "output", value_name = "FOLDER")]
    pub output: PathBuf,
    /// Thickness of the panels: the distance to their other side along the normals, negative for the opposite direction [default:
    /// that of the document's 'offset' of the net, if it has one].
    #[arg(long, value_name = "T", value_parser = not_zero, allow_hyphen_values = true)]
    pub thickness: Option<f64>,
    /// Depth of the beams from the edges along the normals, negative for the opposite direction [default: the
    /// thickness].
    #[arg(long, value_name = "D", value_parser = not_zero, allow_hyphen_values = true)]
    pub beam_depth: Option<f64>,
    /// Largest distance between a panel and its mould, which is a plane, sphere, cylinder or torus [default: a thousandth of the
    /// mean edge].
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub tolerance: Option<f64>,
    /// Largest distance between superimposed panels that count as congruent [default: the tolerance].
    #[arg(long, value_name = "T", value_parser = positive, allow_hyphen_values = true)]
    pub congruent_within: Option<f64>,
    /// An object to schedule, which may be construction geometry; repeat it for several [default: all nets except
    /// construction geometry].
    #[arg(long = "object", value_name = "NAME", action = ArgAction::Append)]
    pub objects: Vec<String>,
    #[command(flatten)]
    pub write: WriteArgs,
}

/// Schedule a model.
pub struct SchedulePlan {
    pub input: Input,
    pub read_below: Option<PathBuf>,
    pub folder: PathBuf,
    pub options: ScheduleOptions,
    pub write: WriteOptions,
}

impl ScheduleArgs {
    pub fn plan(self) -> Result<SchedulePlan, Failure> {
        refuse_file_name(&self.output)?;
        let Self { model, read, output, thickness, beam_depth, tolerance, congruent_within, objects, write } = self;
        let options = ScheduleOptions { thickness, beam_depth, tolerance, congruent_within, objects };
        let (input, read_below) = (Input::File(model), read.read_below);
        Ok(SchedulePlan { input, read_below, folder: output, options, write: write.options() })
    }
}

/// A finite number that is not 0.
fn not_zero(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.abs() > 0.0 && value.is_finite() => Ok(value),
        Ok(_) => Err("must be finite and not 0".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}
