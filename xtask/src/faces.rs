//! `cargo xtask faces FOLDER`: bodies of rational faces that are no cyclides, through every format that holds surfaces, for the tests of
//! foreign readers. No document makes these.

use cyclide::{
    model::{Model, Units},
    topology::Body,
};
use cyclide_io::{ExportOptions, Exporter, Format};
use cyclide_testkit::rational_faces::{egg, smooth_pair};
use std::path::Path;
use std::process::ExitCode;

const FORMATS: [Format; 5] = [Format::Step, Format::Json, Format::Glb, Format::Obj, Format::Stl];

pub fn main(arguments: &[String]) -> ExitCode {
    let [folder] = arguments else {
        eprintln!("usage: cargo xtask faces FOLDER");
        return ExitCode::from(2);
    };
    match write(Path::new(folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Writes both bodies, each file checked as the program checks them.
fn write(folder: &Path) -> Result<(), String> {
    for (name, body) in [("egg", egg()), ("pair", Body { outer: smooth_pair(), voids: Vec::new() })] {
        let model = Model::new(Units::Millimetre).with_surface(name, body);
        let exporter = Exporter::new(&model).map_err(|error| error.to_string())?;
        for format in FORMATS {
            let path = folder.join(format!("{name}.{}", format.name()));
            let file = exporter.export(format, &ExportOptions::default()).map_err(|error| error.to_string())?;
            let report = exporter.check(&path, format, &file).map_err(|error| error.to_string())?;
            std::fs::write(&path, file.bytes).map_err(|error| format!("{}: {error}", path.display()))?;
            println!("{}: within {:e}", report.path, report.bound);
        }
    }
    Ok(())
}
