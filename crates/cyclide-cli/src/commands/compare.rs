//! `compare`: curves of all kinds from the same points, measured side by side.

use cyclide::{Aabb, curve::bounds, model::CurveObject};
use cyclide_io::{Document, compare::Comparison};

use crate::arguments::compare::{ComparePlan, ComparisonFile};
use crate::commands::load::{self, Inputs};
use crate::output::failure::Failure;
use crate::output::files;
use crate::output::progress::Progress;
use crate::output::terminal;

/// The default tolerance, in parts of the diagonal of the points.
const TOLERANCE: f64 = 1e-3;

/// Carries the plan out.
pub fn run(plan: &ComparePlan) -> Result<(), Failure> {
    let inputs = Inputs::default();
    let (document, folder) = load::document(&plan.input, &inputs)?;
    let polygon = load::build_one(&document, &folder, 0, &inputs, &Progress::new(1))?;
    let size = polygon.item.curves().iter().map(CurveObject::as_curve).map(bounds).reduce(Aabb::union);
    let tolerance = plan.tolerance.unwrap_or_else(|| TOLERANCE * size.map_or(1.0, |size| size.diagonal()));
    let source = plan.points.display().to_string();
    let kinds = plan.kinds(tolerance)?;
    let progress = Progress::new(kinds.len());
    let mut made = Vec::with_capacity(kinds.len());
    for (word, spec) in kinds {
        progress.doing(word.clone());
        let built = match spec {
            None => Err("this kind cannot be closed".to_owned()),
            Some(spec) => {
                let document = Document::from_objects(&source, document.units, vec![(word.clone(), spec)]);
                load::build_quietly(&document, &folder, 0, &inputs)
            }
        };
        made.push((word, built));
        progress.done();
    }
    let name = plan.points.file_name().map_or(source.clone(), |name| name.to_string_lossy().into_owned());
    let comparison = Comparison::new(&name, document.units, &polygon, made, tolerance);
    drop(progress);
    for kind in &comparison.kinds {
        if let Some(why) = &kind.refused {
            terminal::warning(&format!("{}: not available: {why}", kind.kind));
        }
    }
    let content = |file: &ComparisonFile| match file {
        ComparisonFile::Page => comparison.html(),
        ComparisonFile::Table => comparison.csv(),
        ComparisonFile::Json => comparison.json(),
    };
    let written: Vec<_> = plan.outputs.iter().map(|(path, file)| (path.clone(), content(file).into_bytes())).collect();
    if written.is_empty() {
        return terminal::print(&comparison.text());
    }
    files::write(&written, plan.write, &comparison.text())
}
