//! Meshes for printing and for programs of points: 3MF and PLY.

use crate::damage::Damage;
use crate::models::{curve_and_surfaces, surfaces, torus_part};
use cyclide::{
    Point3,
    model::{Model, Units},
    surface::DupinCyclide,
};
use cyclide_io::{
    ExportOptions, Format,
    formats::{export, file_deviation, read_back},
};

fn with_tolerance(tolerance: f64) -> ExportOptions {
    ExportOptions { tolerance: Some(tolerance), ..ExportOptions::default() }
}

/// A ring cyclide, closed.
fn ring(units: Units) -> Model {
    Model::new(units).with_surface("ring", DupinCyclide::new(3.0, 1.0, 1.5).unwrap().nets([4, 4]).unwrap().remove(0))
}

#[test]
fn solids_are_watertight_by_their_numbers() {
    for tolerance in [0.1, 1e-2, 1e-3] {
        let model = ring(Units::Centimetre)
            .with_surface("other", DupinCyclide::new(2.0, 0.0, 0.5).unwrap().nets([3, 5]).unwrap().remove(0));
        let file = export(&model, Format::ThreeMf, &with_tolerance(tolerance)).unwrap();
        let off = file_deviation(&model, Format::ThreeMf, &file).unwrap();
        assert!(off <= file.bound && off > 0.05 * tolerance, "{off:e} of {:e}", file.bound);
        assert_eq!(file.bytes, export(&model, Format::ThreeMf, &with_tolerance(tolerance)).unwrap().bytes);
        let content = read_back(Format::ThreeMf, &file.bytes).unwrap();
        assert_eq!(content.meshes.len(), 2);
        for mesh in &content.meshes {
            // A torus: as many corners and triangles as sides.
            assert_eq!(2 * mesh.positions.len(), mesh.faces.len());
        }
        assert_eq!(content.labels.unit, Some(10.0));
    }
}

#[test]
fn what_is_open_cannot_be_printed() {
    let model = surfaces(&[torus_part(Point3::ORIGIN)]);
    let error = export(&model, Format::ThreeMf, &with_tolerance(0.1)).unwrap_err();
    assert_eq!(error.reason(), "not-in-format");
    let start = "object s0: 3MF cannot represent this: an open surface has no interior to print: make it a solid";
    assert!(error.to_string().starts_with(start), "{error}");
    // Of a model with a solid too: nobody misses half of what was asked for.
    let mixed = ring(Units::Millimetre).with_surface("open", torus_part(Point3::ORIGIN));
    assert!(
        export(&mixed, Format::ThreeMf, &with_tolerance(0.1)).unwrap_err().to_string().starts_with("object open: ")
    );
}

/// A part of the archive that is changed does not have its check sum; the list at the end says the same as the parts.
#[test]
fn a_damaged_archive_is_refused() {
    let damage = Damage::new(ring(Units::Inch), Format::ThreeMf);
    let length = damage.file.bytes.len();
    for at in [0, 20, 40, length / 2, length - 30, length - 10, length - 1] {
        let message = damage.bytes(|bytes| bytes[at] ^= 0x11).unwrap_err().to_string();
        assert!(message.starts_with("not readable at the container"), "{at}: {message}");
    }
    let cut = damage.bytes(|bytes| bytes.truncate(length / 2));
    assert!(cut.unwrap_err().to_string().contains("is truncated"));
}

#[test]
fn ply_has_quads_with_the_normals_of_the_surface() {
    let model = ring(Units::Metre);
    let file = export(&model, Format::Ply, &with_tolerance(1e-2)).unwrap();
    assert!(file.bytes.starts_with(b"ply\nformat binary_little_endian 1.0\ncomment cyclide, units m\n"));
    assert!(file.notes[0].contains("coordinates are in m"));
    let mesh = read_back(Format::Ply, &file.bytes).unwrap().meshes.remove(0);
    assert!(mesh.faces.iter().all(|face| face.corners().len() == 4));
    // The patches are smooth into each other: no vertex stands twice.
    assert_eq!((mesh.positions.len(), mesh.normals.len()), (mesh.faces.len(), mesh.faces.len()));
}

#[test]
fn damage_of_ply_is_found_out() {
    let damage = Damage::new(curve_and_surfaces(), Format::Ply);
    let text = String::from_utf8_lossy(&damage.file.bytes).into_owned();
    let start = text.find("end_header\n").unwrap() + 11;
    let of = |changed: Result<f64, cyclide_io::check::ReadError>| {
        changed.map_or_else(|e| e.to_string(), |off| format!("off by {off:e}"))
    };
    // The sign of the first coordinate, of the first normal, and the object of the first vertex.
    let moved = damage.bytes(|bytes| bytes[start + 7] ^= 0x80);
    assert!(moved.is_err() || moved.is_ok_and(|off| off > 1.0));
    let turned = of(damage.bytes(|bytes| (0..3).for_each(|k| bytes[start + 24 + 4 * k + 3] ^= 0x80)));
    assert!(turned.contains("normal"), "{turned}");
    let other = of(damage.bytes(|bytes| bytes[start + 36] = 7));
    assert!(other.contains("vertices of"), "{other}");
    let unit = of(damage.bytes(|bytes| {
        let at = text.find("units mm").unwrap() + 7;
        bytes[at] = b' ';
    }));
    assert!(unit.contains("unit"), "{unit}");
    let name = of(damage.bytes(|bytes| bytes[text.find("slot").unwrap()] = b'b'));
    assert_eq!(name, "object 0 is `blot` in the file, `slot` in the model");
}
