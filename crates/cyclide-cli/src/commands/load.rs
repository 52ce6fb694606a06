//! Reading a model document (or one made from the command line) and building its objects.

use std::cell::RefCell;
use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};

use cyclide::model::{Model, Units};
use cyclide_io::{
    Document, ModelBuilder,
    document::BuiltObject,
    export::Provenance,
    input::{PointColumns, ReadFolder, read_head, read_input, read_standard_input, unit_of_columns},
};

use crate::arguments::files::Input;
use crate::arguments::mistaken::{Wanted, refuse_content};
use crate::output::failure::Failure;
use crate::output::progress::Progress;
use crate::output::standard::is_standard;
use crate::output::terminal;

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
    /// The objects for files and how they came about, without what is known about them besides (of large models a copy would
    /// be half of all memory): construction geometry stays behind.
    pub fn into_model(self) -> (Model, Vec<Provenance>) {
        let shown = self.objects.into_iter().filter(|built| !built.construction);
        let (items, provenance) = shown.map(|built| (built.item, built.provenance)).unzip();
        (Model { units: self.units, items }, provenance)
    }
}

/// What is read: files, and standard input by the name `-`, which is read once however often it is asked for.
#[derive(Default)]
pub struct Inputs {
    standard: RefCell<Option<Vec<u8>>>,
    /// What files a document may name.
    below: Option<ReadFolder>,
}

impl Inputs {
    /// Inputs of documents that may name files below one folder only.
    pub fn below(folder: Option<&Path>) -> Result<Self, Failure> {
        let open = |path: &Path| ReadFolder::open(path).map_err(|error| Failure::read(path, &error));
        Ok(Self { below: folder.map(open).transpose()?, ..Self::default() })
    }

    /// All bytes of an input that a document names.
    fn read_named(&self, path: &Path) -> io::Result<Vec<u8>> {
        match &self.below {
            Some(folder) if !is_standard(path) => folder.read(path),
            _ => self.read(path),
        }
    }

    /// All bytes of an input.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        if is_standard(path) { self.standard(usize::MAX) } else { read_input(path) }
    }

    /// Bytes that tell what an input is, and more.
    fn head(&self, path: &Path) -> io::Result<Vec<u8>> {
        if is_standard(path) { self.standard(HEAD) } else { read_head(path, HEAD as u64) }
    }

    fn standard(&self, count: usize) -> io::Result<Vec<u8>> {
        let mut read = self.standard.borrow_mut();
        let bytes = match read.as_ref() {
            Some(bytes) => bytes,
            None => read.insert(read_standard_input()?),
        };
        Ok(bytes[..bytes.len().min(count)].to_vec())
    }
}

/// Reads the document.
pub fn document(input: &Input, inputs: &Inputs) -> Result<(Document, PathBuf), Failure> {
    match input {
        Input::Made { document, columns, unit_of_columns } => {
            let mut document = document.as_ref().clone();
            let paths: Vec<PathBuf> = document.input_files().map(PathBuf::from).collect();
            for path in paths {
                // What cannot be read is refused where it is needed.
                let head = inputs.head(&path).unwrap_or_default();
                if columns.coordinates.is_none() {
                    refuse_content(&path, &head, Wanted::Points)?;
                }
                if *unit_of_columns {
                    take_unit(&mut document, &path, &head, columns);
                }
            }
            Ok((document, PathBuf::new()))
        }
        Input::File(path) => {
            let bytes = inputs.read(path).map_err(|e| Failure::read(path, &e))?;
            refuse_content(path, &bytes, Wanted::Document)?;
            let standard = is_standard(path);
            let name = if standard { "standard input".to_owned() } else { path.display().to_string() };
            let document = Document::parse(&name, &bytes).map_err(|message| Failure::Refused(message.to_string()))?;
            if standard && document.input_files().any(|file| is_standard(Path::new(file))) {
                let message = "standard input is the document and cannot also be one of its files";
                return Err(Failure::Usage(message.to_owned()));
            }
            Ok((document, path.parent().map(Path::to_path_buf).unwrap_or_default()))
        }
    }
}

/// Takes the unit that the names of the columns agree on, and says so.
fn take_unit(document: &mut Document, path: &Path, head: &[u8], columns: &PointColumns) {
    if let Some(found) = unit_of_columns(head, columns).filter(|found| found.unit != document.units) {
        document.units = found.unit;
        let (names, unit) = (found.columns.join(", "), found.unit.symbol());
        terminal::note(&format!(
            "{}: the unit is {unit}, taken from the columns {names} (change it with --units)",
            path.display()
        ));
    }
}

/// Bytes that tell what a file is, and its columns.
const HEAD: usize = 1 << 16;

/// Builds the document's objects one by one and shows their warnings.
pub fn build(document: &Document, folder: &Path, inputs: &Inputs, progress: &Progress) -> Result<Loaded, Failure> {
    let read = |path: &Path| inputs.read_named(path);
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
    inputs: &Inputs,
    progress: &Progress,
) -> Result<BuiltObject, Failure> {
    let read = |path: &Path| inputs.read_named(path);
    build_next(&mut ModelBuilder::new(document, folder, &read)?, document, index, progress)
}

/// Builds one object without a word; what is wrong with it in one line.
pub fn build_quietly(document: &Document, folder: &Path, index: usize, inputs: &Inputs) -> Result<BuiltObject, String> {
    let read = |path: &Path| inputs.read_named(path);
    let built = ModelBuilder::new(document, folder, &read).and_then(|mut builder| builder.build(index, &mut |_| ()));
    built.map_err(|error| match error {
        cyclide_io::Error::Input(found) => {
            let reason = found.reason.map(|reason| format!(" [{reason}]")).unwrap_or_default();
            format!("{}:{}: {}{reason}", found.file, found.line, found.message)
        }
        other => other.to_string(),
    })
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
    let place = |file: &str| if is_standard(Path::new(file)) { PathBuf::from(file) } else { folder.join(file) };
    document.input_files().map(place).collect()
}

/// Outliers are bad rows of a file: each is shown, as far as the kernel names them.
fn most_shown(reason: &str) -> usize {
    if reason == "outlier" { usize::MAX } else { SHOWN_WARNINGS }
}

fn show_warnings(built: &BuiltObject) {
    for note in &built.notes {
        terminal::note(note);
    }
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for remark in &built.remarks {
        let count = counts.entry(remark.reason).or_default();
        *count += 1;
        if *count <= most_shown(remark.reason) {
            let name = &built.item.name;
            let place = remark.place.as_ref().map_or_else(|| name.clone(), |place| format!("{place}: {name}"));
            terminal::warning(&format!("{place}: {} [{}]", remark.message, remark.reason));
        }
    }
    // In the order of their first appearance, so that equal runs print equal text.
    let mut rest: Vec<&str> = Vec::new();
    for remark in &built.remarks {
        if counts[remark.reason] > most_shown(remark.reason) && !rest.contains(&remark.reason) {
            rest.push(remark.reason);
        }
    }
    for reason in rest {
        let more = counts[reason] - most_shown(reason);
        terminal::warning(&format!("{}: {more} more of these warnings (--json lists all) [{reason}]", built.item.name));
    }
}
