//! `gallery`: every example model as files, with a page that shows them.

mod entries;
mod page;

use std::collections::HashSet;
use std::io;
use std::path::Path;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use cyclide_io::{Document, ExportOptions, Exporter, Format, ModelBuilder, Report};

use crate::arguments::plan::GalleryPlan;
use crate::commands::load::Loaded;
use crate::output::failure::Failure;
use crate::output::files;
use crate::output::progress::Progress;
use entries::{ENTRIES, Entry};
use page::Shown;

/// Width of the pictures, pixels: twice that of their place on the page.
const PICTURE: u32 = 1280;

/// Models that are built at once, at most: each holds its meshes in memory.
const AT_ONCE: usize = 4;

/// Builds all entries, checks their files, and writes them and the page: all, or none.
pub fn run(plan: &GalleryPlan) -> Result<(), Failure> {
    // Said before the work is done.
    if plan.folder.exists() && !plan.folder.is_dir() {
        return Err(Failure::write(plan.folder.display(), &io::ErrorKind::NotADirectory.into()));
    }
    let progress = Progress::new(ENTRIES.iter().map(|entry| entry.formats.len() + 1).sum());
    let mut shown = make_all(&progress)?;
    let mut files: Vec<(String, Vec<u8>)> =
        shown.iter_mut().flat_map(|shown| std::mem::take(&mut shown.files)).collect();
    drop(progress);
    // Entries may read the same file.
    let mut names = HashSet::new();
    files.retain(|(name, _)| names.insert(name.clone()));
    files.push(("index.html".to_owned(), page::html(&shown).into_bytes()));
    files.push(("viewer.js".to_owned(), page::VIEWER.as_bytes().to_vec()));
    let page = plan.folder.join("index.html");
    let text = format!("{} models, {} files: {}\n", ENTRIES.len(), files.len(), page.display());
    files::write_folder(&plan.folder, &files, plan.write, &text)
}

/// Builds all entries, some at once; in their order.
fn make_all(progress: &Progress) -> Result<Vec<Shown>, Failure> {
    let next = AtomicUsize::new(0);
    let made: Vec<OnceLock<Result<Shown, Failure>>> = ENTRIES.iter().map(|_| OnceLock::new()).collect();
    let workers = thread::available_parallelism().map_or(1, usize::from).min(AT_ONCE);
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| {
                while let Some((entry, place)) = ENTRIES.iter().zip(&made).nth(next.fetch_add(1, Ordering::Relaxed)) {
                    progress.doing(entry.title.to_owned());
                    // Each place is reached once.
                    let _ = place.set(make(entry, progress));
                }
            });
        }
    });
    made.into_iter().filter_map(OnceLock::into_inner).collect()
}

/// Builds one entry.
fn make(entry: &'static Entry, progress: &Progress) -> Result<Shown, Failure> {
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let fault = |message: String| Failure::Check(format!("{}: {message}", entry.name));
    let read = |path: &Path| {
        let found = entry.inputs.iter().find(|(name, _)| Path::new(name) == path);
        found.map(|(_, bytes)| bytes.to_vec()).ok_or_else(|| io::ErrorKind::NotFound.into())
    };
    let name = format!("{}.json", entry.name);
    let document = Document::parse(&name, entry.document.as_bytes()).map_err(|message| fault(message.to_string()))?;
    let mut builder = ModelBuilder::new(&document, Path::new(""), &read).map_err(|error| fault(error.to_string()))?;
    let mut hear = |step| progress.doing(format!("{}, {step}", entry.title));
    let objects = (0..document.objects.len()).map(|index| builder.build(index, &mut hear));
    let objects = objects.collect::<cyclide_io::Result<_>>().map_err(|error| fault(error.to_string()))?;
    let loaded = Loaded { units: document.units, objects, input_files: Vec::new() };
    let mut report = Report::new(loaded.units, &loaded.objects, None);
    let (model, provenance) = loaded.into_model();
    let exporter = Exporter::with_provenance(&model, &provenance).map_err(|error| fault(error.to_string()))?;
    files.push((name, entry.document.as_bytes().to_vec()));
    files.extend(entry.inputs.iter().map(|(name, bytes)| ((*name).to_owned(), bytes.to_vec())));
    progress.done();
    for format in entry.formats {
        let name = format!("{}.{}", entry.name, format.name());
        progress.doing(name.clone());
        let title = if *format == Format::Png { entry.title } else { entry.name };
        let camera = if entry.camera.is_empty() { None } else { Some(entry.camera.parse().map_err(fault)?) };
        let title = Some(title.to_owned());
        let options = ExportOptions {
            title,
            png_width: Some(PICTURE),
            camera,
            png_colour: entry.colour,
            ..ExportOptions::default()
        };
        let exported = exporter.export(*format, &options).map_err(|error| fault(error.to_string()))?;
        let checked = exporter.check(Path::new(&name), *format, &exported);
        report.files.push(checked.map_err(|error| fault(error.to_string()))?);
        if *format == Format::Glb {
            files.push((format!("{name}.js"), page::handed_over(entry.name, &exported.bytes).into_bytes()));
        }
        files.push((name, exported.bytes));
        progress.done();
    }
    Ok(Shown { entry, report, files })
}
