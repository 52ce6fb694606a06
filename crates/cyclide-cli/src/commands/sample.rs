//! `sample`: places of one object as a table, without writing exchange files.

use cyclide::{
    curve::length,
    model::{CurveObject, Geometry},
    motion::MovingBody,
    topology::Body,
};
use cyclide_io::{
    document::{BuiltObject, NO_EFFECT},
    report::{CurveSamples, MotionSamples, SampleOptions, SamplePlaces, Spacing},
    text::did_you_mean,
};

use crate::arguments::files::refuse_overwriting;
use crate::arguments::sample::SamplePlan;
use crate::commands::load::{self, Inputs};
use crate::output::failure::Failure;
use crate::output::files;
use crate::output::progress::Progress;
use crate::output::terminal;

/// Most rows that one run samples: about a gigabyte of text, which is held in memory.
const MOST_ROWS: f64 = 1e7;

/// Samples one object.
pub fn run(plan: &SamplePlan) -> Result<(), Failure> {
    let inputs = Inputs::below(plan.read_below.as_deref())?;
    let (document, folder) = load::document(&plan.input, &inputs)?;
    let names = || document.objects.iter().map(|(name, _)| format!("'{name}'")).collect::<Vec<_>>().join(", ");
    let index = match &plan.object {
        Some(name) => document.objects.iter().position(|(n, _)| n == name).ok_or_else(|| {
            let hint = did_you_mean(name, document.objects.iter().map(|(n, _)| n.as_str()));
            Failure::Usage(format!("the model has no object '{name}'; its objects are {}{hint}", names()))
        })?,
        None if document.objects.len() == 1 => 0,
        None => return Err(Failure::Usage(format!("--object is required: the objects of the model are {}", names()))),
    };
    for input in load::input_files(&document, &folder) {
        refuse_overwriting(plan.output.as_deref(), &input)?;
    }
    let object = load::build_one(&document, &folder, index, &inputs, &Progress::new(1))?;
    if plan.cells && object.item.volumes().is_empty() {
        return Err(Failure::Usage("--cells requires a volume".to_owned()));
    }
    let text = match &object.item.geometry {
        Geometry::Curves(_) | Geometry::Grids(_) => curves(plan, &object)?,
        Geometry::Surfaces(_) => surface(plan, &object)?,
        Geometry::Volumes(blocks) => volume(plan, &object, blocks.len())?,
        Geometry::Motion(_) => motion(plan, &object)?,
    };
    match &plan.output {
        None => terminal::print_bytes(text.as_bytes()),
        Some(path) => files::write(&[(path, text)], plan.write, ""),
    }
}

fn motion(plan: &SamplePlan, object: &BuiltObject) -> Result<String, Failure> {
    let (option, rows) = match plan.places {
        SamplePlaces::Step(step) => {
            let for_curves = "--frames is for curves; the object is a motion".to_owned();
            plan.frames.is_none().then_some(()).ok_or(Failure::Usage(for_curves))?;
            let duration = object.item.motion().map_or(0.0, MovingBody::duration);
            (format!("--step {step}"), plan.places.count_on(duration))
        }
        SamplePlaces::Count { .. } => {
            let count = count_alone(plan, "a motion")?;
            (format!("--count {count}"), count as f64)
        }
    };
    refuse_many(&option, rows, 1, "motion")?;
    let samples = MotionSamples::new(object, plan.places);
    Ok(samples.map_or_else(String::new, |samples| if plan.json { samples.json() } else { samples.csv() }))
}

fn surface(plan: &SamplePlan, object: &BuiltObject) -> Result<String, Failure> {
    let count = count_alone(plan, "a surface")?;
    if plan.json {
        return Err(Failure::Usage("JSON is for curves and motions; the object is a surface: use CSV".to_owned()));
    }
    let patches: usize = object.bodies.iter().flat_map(Body::shells).map(|shell| shell.faces().len()).sum();
    refuse_many(&format!("--count {count}"), patches as f64 * (count as f64).powi(2), patches, "patches")?;
    Ok(cyclide_io::report::sample(object, count, Spacing::Parameter))
}

fn volume(plan: &SamplePlan, object: &BuiltObject, blocks: usize) -> Result<String, Failure> {
    let count = count_alone(plan, "a volume")?;
    if plan.json {
        return Err(Failure::Usage("JSON is for curves and motions; the object is a volume: use CSV".to_owned()));
    }
    if plan.cells {
        let places = object.provenance.places.iter().flatten().map(|places| places.len() as f64);
        refuse_many("--cells", blocks as f64 * places.product::<f64>(), blocks, "blocks")?;
        let none =
            "--cells: the document does not divide the object into cells (`cells`); use --count for an even grid";
        return cyclide_io::report::sample_cells(object).ok_or_else(|| Failure::Usage(none.to_owned()));
    }
    refuse_many(&format!("--count {count}"), blocks as f64 * (count as f64).powi(3), blocks, "blocks")?;
    Ok(cyclide_io::report::sample(object, count, Spacing::Parameter))
}

/// The number of samples, where no option may be given that only curves have.
fn count_alone(plan: &SamplePlan, what: &str) -> Result<usize, Failure> {
    let for_curves = |option: &str| Failure::Usage(format!("{option} is for curves; the object is {what}"));
    match plan.places {
        SamplePlaces::Step(_) => {
            Err(Failure::Usage(format!("--step is for curves and motions; the object is {what}: use --count")))
        }
        SamplePlaces::Count { spacing: Spacing::Length, .. } => Err(for_curves("--equal-length")),
        SamplePlaces::Count { .. } if plan.frames.is_some() => Err(for_curves("--frames")),
        SamplePlaces::Count { count, .. } => Ok(count),
    }
}

fn curves(plan: &SamplePlan, object: &BuiltObject) -> Result<String, Failure> {
    let contours = object.item.curves();
    let rows = contours.iter().map(CurveObject::as_curve).map(|curve| match plan.places {
        SamplePlaces::Count { count, .. } => count as f64,
        SamplePlaces::Step(_) => plan.places.count_on(length(curve)),
    });
    let option = match plan.places {
        SamplePlaces::Count { count, .. } => format!("--count {count}"),
        SamplePlaces::Step(step) => format!("--step {step}"),
    };
    refuse_many(&option, rows.sum(), contours.len(), "contours")?;
    let options = SampleOptions { places: plan.places, frames: plan.frames };
    let samples = CurveSamples::new(object, &options)
        .map_err(|error| Failure::Refused(format!("{}: {error} [{}]", object.item.name, error.reason())))?;
    for note in samples.notes() {
        terminal::warning(&note);
    }
    if let Some(why) = samples.spread_without_effect() {
        terminal::warning(&format!("--spread-twist has no effect: {why} [{NO_EFFECT}]"));
    }
    Ok(if plan.json { samples.json() } else { samples.csv() })
}

fn refuse_many(option: &str, rows: f64, parts: usize, what: &str) -> Result<(), Failure> {
    if rows <= MOST_ROWS {
        return Ok(());
    }
    Err(Failure::Usage(format!("{option} gives {rows} rows on {parts} {what}; the limit is {MOST_ROWS}")))
}
