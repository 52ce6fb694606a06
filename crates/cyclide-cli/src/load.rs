//! Reading a model document (or one made from the command line) and building its objects.

use std::collections::HashMap;
use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use cyclide::{Model, Units};
use cyclide_io::{BuiltObject, Document, ModelBuilder};

use crate::failure::Failure;
use crate::mistaken::{Wanted, refuse_content};
use crate::plan::Input;
use crate::progress::Progress;
use crate::terminal;

/// Warnings of one kind shown per object; the JSON report holds them all.
const SHOWN_WARNINGS: usize = 3;

/// A built model.
pub struct Loaded {
    pub units: Units,
    pub objects: Vec<BuiltObject>,
    /// The files that the document refers to.
    pub input_files: Vec<PathBuf>,
}

impl Loaded {
    /// The objects for files, without what is known about them besides: construction geometry stays behind.
    pub fn model(&self) -> Model {
        let shown = self.objects.iter().filter(|built| !built.construction);
        Model { units: self.units, items: shown.map(|built| built.item.clone()).collect() }
    }
}

/// Reads the document.
pub fn document(input: &Input) -> Result<(Document, PathBuf), Failure> {
    match input {
        Input::Made { document, sniff } => {
            for path in document.input_files().map(Path::new).filter(|_| *sniff) {
                // What cannot be read is refused where it is needed.
                refuse_content(path, &head(path).unwrap_or_default(), Wanted::Points)?;
            }
            Ok((document.as_ref().clone(), PathBuf::new()))
        }
        Input::File(path) => {
            let bytes = std::fs::read(path).map_err(|e| Failure::read(path, &e))?;
            refuse_content(path, &bytes, Wanted::Document)?;
            let document = Document::parse(&path.display().to_string(), &bytes);
            let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
            document.map(|d| (d, folder)).map_err(|message| Failure::Refused(message.to_string()))
        }
    }
}

/// Bytes that tell what a file is, and more.
const HEAD: u64 = 1 << 16;

/// The first bytes of a file.
fn head(path: &Path) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(HEAD).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Builds the document's objects one by one and shows their warnings.
pub fn build(document: &Document, folder: &Path, progress: &Progress) -> Result<Loaded, Failure> {
    let read = |path: &Path| std::fs::read(path);
    let mut builder = ModelBuilder::new(document, folder, &read)?;
    let mut objects = Vec::with_capacity(document.objects.len());
    for index in 0..document.objects.len() {
        objects.push(build_next(&mut builder, document, index, progress)?);
    }
    Ok(Loaded { units: document.units, objects, input_files: input_files(document, folder) })
}

/// Builds one object, and what it is made from, and shows its warnings.
pub fn build_one(
    document: &Document,
    folder: &Path,
    index: usize,
    progress: &Progress,
) -> Result<BuiltObject, Failure> {
    let read = |path: &Path| std::fs::read(path);
    build_next(&mut ModelBuilder::new(document, folder, &read)?, document, index, progress)
}

fn build_next(
    builder: &mut ModelBuilder<'_>,
    document: &Document,
    index: usize,
    progress: &Progress,
) -> Result<BuiltObject, Failure> {
    let (name, spec) = &document.objects[index];
    let title = format!("{name}: {}", spec.type_word());
    progress.doing(title.clone());
    let built = builder.build(index, &mut |step| progress.doing(format!("{title}, {step}")))?;
    progress.suspended(|| show_warnings(&built));
    progress.done();
    Ok(built)
}

/// The files that the document refers to.
pub fn input_files(document: &Document, folder: &Path) -> Vec<PathBuf> {
    document.input_files().map(|file| folder.join(file)).collect()
}

fn show_warnings(built: &BuiltObject) {
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for remark in &built.remarks {
        let count = counts.entry(remark.reason).or_default();
        *count += 1;
        if *count <= SHOWN_WARNINGS {
            let name = &built.item.name;
            let place = remark.place.as_ref().map_or_else(|| name.clone(), |place| format!("{place}: {name}"));
            terminal::warning(&format!("{place}: {} [{}]", remark.message, remark.reason));
        }
    }
    // In the order of their first appearance, so that equal runs print equal text.
    let mut rest: Vec<&str> = Vec::new();
    for remark in &built.remarks {
        if counts[remark.reason] > SHOWN_WARNINGS && !rest.contains(&remark.reason) {
            rest.push(remark.reason);
        }
    }
    for reason in rest {
        let more = counts[reason] - SHOWN_WARNINGS;
        terminal::warning(&format!("{}: {more} more of these (--json reports all) [{reason}]", built.item.name));
    }
}
