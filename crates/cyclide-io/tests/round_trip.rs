//! Every format with geometry: written, read back, compared.

mod models;

use cyclide::{CurveObject, Model};
use cyclide_io::{ExportOptions, Format, export, file_deviation};
use models::{flat, mixed, model, space_chain, tilted};

const FORMATS: [Format; 5] = [Format::Step, Format::Dxf, Format::Svg, Format::Csv, Format::Json];

fn all_models() -> Vec<(&'static str, Model)> {
    let space = model(vec![("space", vec![CurveObject::ArcPath(space_chain())])]);
    vec![("flat", mixed(flat)), ("tilted", mixed(tilted)), ("space", space)]
}

#[test]
fn files_keep_their_promise() {
    for (name, m) in all_models() {
        for format in FORMATS {
            let file = export(&m, format, &ExportOptions::default()).unwrap();
            assert_eq!(file.exact, file.bound == 0.0);
            let d = file_deviation(&m, format, &file.bytes).unwrap();
            // Rounding: half ulps of the largest radius, 7.4e5, and of coordinates up to 60.
            assert!(d <= file.bound + 3e-16 * 7.4e5, "{name} {format:?}: {d:e} of {:e}", file.bound);
        }
    }
}

#[test]
fn bytes_are_reproducible() {
    for (name, m) in all_models() {
        for format in FORMATS {
            let bytes = || export(&m, format, &ExportOptions::default()).unwrap().bytes;
            assert_eq!(bytes(), bytes(), "{name} {format:?}");
        }
    }
}
