//! Readers meet bytes that nobody wrote: an error or curves, never a panic.

use crate::models::{coil, flat, mixed, model, space_chain};
use cyclide::model::{CurveObject, Model};
use cyclide_io::{
    ExportOptions, Format,
    export::{DxfVersion, VtuEncoding},
    formats::{export, read_back},
};
use proptest::prelude::*;
use std::sync::OnceLock;

/// Files of every kind of entity.
fn files() -> Vec<(Format, Vec<u8>)> {
    use cyclide::curve::BlendVariant::Rational;
    let spline = crate::models::circle_spline(&coil(4), false, Rational, vec![]);
    let spatial = model(vec![("s", vec![CurveObject::ArcPath(space_chain()), spline])]);
    let exact = ExportOptions { dxf_splines: true, ..ExportOptions::default() };
    let r12 = ExportOptions { dxf_version: DxfVersion::R12, ..ExportOptions::default() };
    let file = |m: &Model, format, options: &ExportOptions| (format, export(m, format, options).unwrap().bytes);
    let mut files = Vec::new();
    for m in [mixed(flat), spatial] {
        for format in [
            Format::Step,
            Format::Dxf,
            Format::Svg,
            Format::Csv,
            Format::Json,
            Format::Vtu,
            Format::Mfem,
            Format::Gismo,
        ] {
            files.push(file(&m, format, &exact));
        }
        files.push(file(&m, Format::Dxf, &r12));
    }
    let meshes = crate::models::curve_and_surfaces();
    for format in [Format::Glb, Format::Obj, Format::Stl, Format::Ply, Format::Vtu, Format::Mfem, Format::Gismo] {
        let coarse = ExportOptions { tolerance: Some(0.3), glb_edges: true, ..ExportOptions::default() };
        files.push(file(&meshes, format, &coarse));
    }
    let cube = cyclide::volume::SphericalCube::cuboid(
        cyclide::Point3::ORIGIN,
        [cyclide::Vec3::X, cyclide::Vec3::Y, cyclide::Vec3::Z],
    );
    let block = cyclide::volume::CyclideVolume::new(&cube.unwrap(), cyclide::volume::VolumeFrame::Auto).unwrap();
    let blocks = Model::default().with_volume("block", block);
    for format in [Format::Vtu, Format::Mfem, Format::Gismo, Format::ThreeMf] {
        let appended = ExportOptions { vtu_encoding: VtuEncoding::Base64, ..ExportOptions::default() };
        files.push(file(&blocks, format, &appended));
    }
    files
}

/// Those, made once.
static FILES: OnceLock<Vec<(Format, Vec<u8>)>> = OnceLock::new();

/// What happens to a file: some bytes replaced, a part cut out, a part repeated.
#[derive(Debug, Clone)]
enum Damage {
    Replace(Vec<(prop::sample::Index, u8)>),
    Cut(prop::sample::Index, prop::sample::Index),
    Repeat(prop::sample::Index, prop::sample::Index),
}

fn damage() -> impl Strategy<Value = Damage> {
    // Bytes that mean something in one of the formats come more often than others.
    let byte = prop_oneof![Just(b"0123456789-.eE"[..].to_vec()), Just(b"(),#'*$\"/\n \\AMZ[]{}"[..].to_vec())]
        .prop_flat_map(prop::sample::select)
        .boxed();
    let byte = prop_oneof![4 => byte, 1 => any::<u8>()];
    let index = any::<prop::sample::Index>;
    prop_oneof![
        prop::collection::vec((index(), byte), 1..12).prop_map(Damage::Replace),
        (index(), index()).prop_map(|(a, b)| Damage::Cut(a, b)),
        (index(), index()).prop_map(|(a, b)| Damage::Repeat(a, b)),
    ]
}

fn damaged(bytes: &[u8], damage: &Damage) -> Vec<u8> {
    let span = |a: &prop::sample::Index, b: &prop::sample::Index| {
        let (a, b) = (a.index(bytes.len()), b.index(bytes.len()));
        a.min(b)..a.max(b)
    };
    match damage {
        Damage::Replace(changes) => {
            let mut out = bytes.to_vec();
            for (index, byte) in changes {
                let at = index.index(out.len());
                out[at] = *byte;
            }
            out
        }
        Damage::Cut(a, b) => {
            let span = span(a, b);
            [&bytes[..span.start], &bytes[span.end..]].concat()
        }
        Damage::Repeat(a, b) => {
            let span = span(a, b);
            [&bytes[..span.end], &bytes[span.start..]].concat()
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn damaged_files_do_not_panic(damage in damage()) {
        for (format, bytes) in FILES.get_or_init(files) {
            let _ = read_back(*format, &damaged(bytes, &damage));
        }
    }
}

#[test]
fn what_is_wrong_is_said_with_its_place() {
    let cases: [(Format, &[u8], &str); 21] = [
        (Format::Step, b"", "no DATA section"),
        (Format::Step, b"DATA;#1=A(;ENDSEC;", "expected a name"),
        (Format::Step, b"DATA;#1=A();#1=B();ENDSEC;", "#1 is defined twice"),
        (Format::Step, b"DATA;#1=GEOMETRIC_CURVE_SET('',(#7));ENDSEC;", "#7"),
        (Format::Dxf, b"  0\nSECTION\n  2\nENTITIES\n  0\nMTEXT\n", "MTEXT at line 5"),
        (Format::Dxf, b"  0\nSECTION\n  2\nENTITIES\n  0\nTEXT\n", "line 5: no value with group code 40"),
        (Format::Dxf, b"x\n", "line 1"),
        (Format::Svg, b"<path class=\"contour\" d=\"M0 0 C\"", "command C"),
        (Format::Csv, b"a,b\n", "line 1"),
        (Format::Json, b"{\n\"objects\": 3}", "line 2"),
        (Format::Glb, b"glTF\x02\0\0\0\x0c\0\0\0", "JSON chunk"),
        (Format::Obj, b"v 1 2\n", "line 1"),
        (Format::Obj, b"v 1 2 3\nvn 0 0 1\nf 1//1 1//1 2//1\n", "line 3"),
        (Format::Stl, &[b'x'; 90], "byte 80"),
        (Format::Ply, b"ply\nformat ascii 1.0\nend_header\n", "an unexpected list of elements"),
        (Format::ThreeMf, b"PK\x03\x04", "the archive is truncated"),
        (Format::Vtu, b"<VTKFile>", "version"),
        (Format::Mfem, b"MFEM NURBS mesh v1.0\ndimension\n4\n", "line 3"),
        (Format::Mfem, b"MFEM mesh v1.0\n", "the head"),
        (Format::Gismo, b"<xml><Geometry type=\"Nurbs\">", "to which it belongs"),
        (Format::Gismo, b"<svg>", "expected <xml>"),
    ];
    for (format, bytes, part) in cases {
        let message = read_back(format, bytes).unwrap_err().to_string();
        assert!(message.contains(part), "{format:?}: {message}");
    }
    #[cfg(feature = "png")]
    assert_eq!(read_back(Format::Png, b"x").unwrap_err(), cyclide_io::check::ReadError::NoGeometry { format: "png" });
}

#[test]
fn deep_lists_are_refused() {
    let deep = format!("DATA;#1=A({});ENDSEC;", "(".repeat(100_000));
    assert!(read_back(Format::Step, deep.as_bytes()).unwrap_err().to_string().contains("levels deep"));
}
