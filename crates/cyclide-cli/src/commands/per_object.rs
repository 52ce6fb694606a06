//! Files for each object of a model, named after it, and for VTU an index of them.

use std::collections::{HashMap, HashSet};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use cyclide::model::{Model, Units};
use cyclide_io::{Format, export::Provenance, formats::vtk_multi_block};

use crate::output::failure::Failure;

/// A model and the files that it goes into.
pub struct Part {
    pub model: Model,
    pub provenance: Vec<Provenance>,
    pub outputs: Vec<(PathBuf, Format)>,
}

/// The objects of a model as models of their own, each with its files.
///
/// # Errors
/// Two objects whose files would have the same name.
pub fn split(model: Model, provenance: Vec<Provenance>, outputs: &[(PathBuf, Format)]) -> Result<Vec<Part>, Failure> {
    let Model { units, items } = model;
    let mut names: HashMap<String, String> = HashMap::new();
    let mut parts = Vec::with_capacity(items.len());
    for (item, provenance) in items.into_iter().zip(provenance) {
        let name = in_file_names(&item.name);
        // Some systems know no capitals in the names of files.
        if let Some(other) = names.insert(name.to_lowercase(), item.name.clone()) {
            let message = format!("the files of `{other}` and of `{}` would have the same names", item.name);
            return Err(Failure::Refused(message));
        }
        let outputs = outputs.iter().map(|(path, format)| (of_object(path, &name), *format)).collect();
        parts.push(Part { model: Model { units, items: vec![item] }, provenance: vec![provenance], outputs });
    }
    Ok(parts)
}

/// Leaves the VTU files of objects out that are no blocks, where plain cells are asked for, which are those of blocks; unless there
/// are none at all, which is refused where they are written. Gives the names of these objects.
pub fn leave_out_plain(parts: &mut [Part], outputs: &[(PathBuf, Format)]) -> Vec<String> {
    let has_blocks = |part: &Part| part.model.items.iter().any(|item| !item.volumes().is_empty());
    if !outputs.iter().any(|(_, format)| *format == Format::Vtu) || !parts.iter().any(has_blocks) {
        return Vec::new();
    }
    let others = parts.iter_mut().filter(|part| !has_blocks(part));
    let without = |part: &mut Part| {
        part.outputs.retain(|(_, format)| *format != Format::Vtu);
        part.model.items.iter().map(|item| item.name.clone()).collect::<Vec<_>>()
    };
    others.flat_map(without).collect()
}

/// The whole model again.
pub fn joined(parts: Vec<Part>) -> (Model, Vec<Provenance>) {
    let units = parts.first().map_or(Units::default(), |part| part.model.units);
    let (mut items, mut provenance) = (Vec::new(), Vec::new());
    for part in parts {
        items.extend(part.model.items);
        provenance.extend(part.provenance);
    }
    (Model { units, items }, provenance)
}

/// For each VTU output the file that names those of the objects as blocks.
pub fn indices(parts: &[Part], outputs: &[(PathBuf, Format)]) -> Vec<(PathBuf, Vec<u8>)> {
    let vtu = outputs.iter().filter(|(_, format)| *format == Format::Vtu);
    let index = |(path, _): &(PathBuf, Format)| {
        let block = |part: &Part| {
            let name = &part.model.items.first()?.name;
            let file = of_object(path, &in_file_names(name));
            let is_written = part.outputs.iter().any(|(output, _)| *output == file);
            is_written.then_some((name.clone(), file.file_name()?.to_string_lossy().into_owned()))
        };
        let blocks: Vec<(String, String)> = parts.iter().filter_map(block).collect();
        (path.with_extension("vtm"), vtk_multi_block(&blocks))
    };
    vtu.map(index).collect()
}

/// Files beside those of the objects that are named as theirs, from a run of a model that had more objects: of `part.step` all
/// `part-….step` that are not written now.
pub fn left_from_before(parts: &[Part], outputs: &[(PathBuf, Format)]) -> Vec<PathBuf> {
    let written: HashSet<&Path> = parts.iter().flat_map(|part| &part.outputs).map(|(path, _)| path.as_path()).collect();
    let mut left = Vec::new();
    for (path, _) in outputs {
        let begin = format!("{}-", path.file_stem().unwrap_or_default().to_string_lossy());
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            let other = path.with_file_name(entry.file_name());
            let is_named_so = entry.file_name().to_string_lossy().starts_with(&begin);
            if is_named_so && other.extension() == path.extension() && !written.contains(other.as_path()) {
                left.push(other);
            }
        }
    }
    left.sort();
    left
}

/// The name of an object as part of the name of a file: letters, digits, `-`, `_` and `.`, anything else as `_`.
fn in_file_names(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' }).collect()
}

/// `part.step` of `lid` is `part-lid.step`.
fn of_object(path: &Path, name: &str) -> PathBuf {
    let mut file = OsString::from(path.file_stem().unwrap_or_default());
    file.push("-");
    file.push(name);
    if let Some(suffix) = path.extension() {
        file.push(".");
        file.push(suffix);
    }
    path.with_file_name(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_objects_are_names_of_files() {
        assert_eq!(of_object(Path::new("out/part.step"), "lid"), Path::new("out/part-lid.step"));
        assert_eq!(of_object(Path::new("part"), "lid.2"), Path::new("part-lid.2"));
        assert_eq!(in_file_names("Dach/Süd 1:2.a-b_c"), "Dach_Süd_1_2.a-b_c");
    }
}
