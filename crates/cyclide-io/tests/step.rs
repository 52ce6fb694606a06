//! STEP written and read back.

mod models;

use cyclide::CurveObject;
use cyclide_io::{ExportOptions, Format, deviation, export, file_deviation, read_back};
use models::{flat, mixed, model, slot, space_chain, tilted};

#[test]
fn arcs_come_back_exactly() {
    for m in [mixed(flat), mixed(tilted), model(vec![("s", vec![CurveObject::ArcPath(space_chain())])])] {
        let file = export(&m, Format::Step, &ExportOptions::default()).unwrap();
        assert!(file.exact);
        // Largest radius 7.4e5 (chord 30): the rounding of centre and radius, half an ulp each; extent about 60.
        let d = file_deviation(&m, Format::Step, &file.bytes).unwrap();
        assert!(d < 3e-16 * 7.4e5, "{d:e}");
    }
}

#[test]
fn swapped_pieces_are_seen() {
    let whole = model(vec![("s", vec![CurveObject::ArcPath(slot(flat))])]);
    let bytes = export(&whole, Format::Step, &ExportOptions::default()).unwrap().bytes;
    let chains = read_back(Format::Step, &bytes).unwrap();
    let mut pieces = chains[0].pieces().to_vec();
    pieces.swap(0, 2);
    let swapped = cyclide::CurveChain::new(pieces, true, 100.0).unwrap();
    assert!(deviation(&whole, &[swapped]).unwrap() > 10.0);
}

#[test]
fn dump() {
    for (name, m) in [
        ("flat", mixed(flat)),
        ("tilted", mixed(tilted)),
        ("space", model(vec![("s", vec![CurveObject::ArcPath(space_chain())])])),
    ] {
        std::fs::write(
            format!("/tmp/fmt/{name}.step"),
            export(&m, Format::Step, &ExportOptions::default()).unwrap().bytes,
        )
        .unwrap();
    }
}
