//! Meshes damaged in their bytes: what happens to a file is found in its deviation, or said.

use crate::models::{bent_quad, surfaces, torus_part};
use cyclide::{Point3, model::Model};
use cyclide_io::{
    ExportOptions, Format,
    check::ReadError,
    export::Exported,
    formats::{export, file_deviation},
};

/// Head of an STL file, and its records.
const HEAD: usize = 84;
const RECORD: usize = 50;

struct Damage {
    model: Model,
    format: Format,
    file: Exported,
}

impl Damage {
    /// Two bodies, of which the second one is damaged.
    fn new(format: Format) -> Self {
        let model = surfaces(&[bent_quad(), torus_part(Point3::ORIGIN)]);
        let options = ExportOptions { tolerance: Some(1e-2), ..ExportOptions::default() };
        let file = export(&model, format, &options).unwrap();
        assert!(file_deviation(&model, format, &file).unwrap() <= file.bound);
        Self { model, format, file }
    }

    fn bytes(&self, change: impl FnOnce(&mut Vec<u8>)) -> Result<f64, ReadError> {
        let mut wrong = self.file.clone();
        change(&mut wrong.bytes);
        file_deviation(&self.model, self.format, &wrong)
    }

    /// The lines of a text.
    fn lines(&self, change: impl FnOnce(&mut Vec<String>)) -> Result<f64, ReadError> {
        self.bytes(|bytes| {
            let text = String::from_utf8(std::mem::take(bytes)).unwrap();
            let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
            change(&mut lines);
            *bytes = lines.join("\n").into_bytes();
        })
    }

    /// The last record of STL: its numbers, normal first.
    fn last_record(&self, change: impl FnOnce(&mut [[f32; 3]; 4])) -> Result<f64, ReadError> {
        self.bytes(|bytes| {
            let start = bytes.len() - RECORD;
            let record = &mut bytes[start..start + 48];
            let mut vectors = [[0.0; 3]; 4];
            for (v, b) in vectors.as_flattened_mut().iter_mut().zip(record.chunks_exact(4)) {
                *v = f32::from_le_bytes(b.try_into().unwrap());
            }
            change(&mut vectors);
            for (v, b) in vectors.as_flattened().iter().zip(record.chunks_exact_mut(4)) {
                b.copy_from_slice(&v.to_le_bytes());
            }
        })
    }
}

fn last(lines: &mut [String], keyword: &str) -> usize {
    lines.iter().rposition(|line| line.starts_with(keyword)).unwrap()
}

fn numbers(line: &str) -> [f64; 3] {
    let numbers: Vec<f64> = line.split(' ').skip(1).map(|v| v.parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

fn wrong_side(result: &Result<f64, ReadError>) -> bool {
    matches!(result, Err(ReadError::WrongSide { object, face: 0 }) if object == "s1")
}

fn normal(result: &Result<f64, ReadError>, from: f64, to: f64) -> bool {
    matches!(result, Err(ReadError::Normal { object, face: 0, off, .. }) if object == "s1" && *off > from && *off < to)
}

/// The sides that were joined and are not, or the other way.
fn torn(result: &Result<f64, ReadError>, sides: usize) -> bool {
    matches!(result, Err(ReadError::SideUse { object, free: [found, made], .. })
        if object == "s1" && found.abs_diff(*made) == sides)
}

#[test]
fn moved_swapped_and_missing_polygons() {
    let stl = Damage::new(Format::Stl);
    let length = stl.file.bytes.len();
    // Two triangles swapped: all there, none in its place.
    let swapped = stl.bytes(|bytes| {
        let (head, tail) = bytes.split_at_mut(length - RECORD);
        head[HEAD..HEAD + RECORD].swap_with_slice(tail);
    });
    assert!(swapped.as_ref().is_ok_and(|d| *d > 0.5) || swapped.is_err(), "{swapped:?}");
    // A triangle missing.
    let missing = stl.bytes(|bytes| {
        bytes.truncate(length - RECORD);
        let count = u32::from_le_bytes(bytes[80..HEAD].try_into().unwrap()) - 1;
        bytes[80..HEAD].copy_from_slice(&count.to_le_bytes());
    });
    assert!(missing.unwrap_err().to_string().contains("polygons"));
    // A vertex moved by a twentieth.
    let moved = Damage::new(Format::Obj).lines(|lines| {
        let v = last(lines, "v ");
        let [x, y, z] = numbers(&lines[v]);
        lines[v] = format!("v {x} {y} {}", z + 0.05);
    });
    assert!(moved.as_ref().is_ok_and(|d| *d > 0.03), "{moved:?}");
}

#[test]
fn polygons_that_look_to_the_wrong_side() {
    let reversed = Damage::new(Format::Obj).lines(|lines| {
        let f = last(lines, "f ");
        let corners: Vec<&str> = lines[f].split(' ').skip(1).collect();
        lines[f] = format!("f {}", corners.into_iter().rev().collect::<Vec<_>>().join(" "));
    });
    assert!(wrong_side(&reversed), "{reversed:?}");
    let reversed = Damage::new(Format::Stl).last_record(|[normal, _, b, c]| {
        std::mem::swap(b, c);
        *normal = normal.map(|v| -v);
    });
    assert!(wrong_side(&reversed), "{reversed:?}");
    let reversed = Damage::new(Format::Glb).bytes(|bytes| {
        // The indices of the last mesh end the file.
        let end = bytes.len();
        let (one, other) = bytes[end - 8..].split_at_mut(4);
        one.swap_with_slice(other);
    });
    assert!(wrong_side(&reversed), "{reversed:?}");
}

#[test]
fn normals_of_another_surface() {
    let obj = Damage::new(Format::Obj);
    let negated = obj.lines(|lines| {
        let n = last(lines, "vn ");
        let [x, y, z] = numbers(&lines[n]);
        lines[n] = format!("vn {} {} {}", -x, -y, -z);
    });
    assert!(normal(&negated, 1.999, 2.001), "{negated:?}");
    let tilted = obj.lines(|lines| {
        let n = last(lines, "vn ");
        let [x, y, z] = numbers(&lines[n]);
        lines[n] = format!("vn {x} {} {}", y + 1e-5, z);
    });
    assert!(normal(&tilted, 0.9e-5, 1.1e-5), "{tilted:?}");
    // Polygons that say the normals of other corners, here the second and the third the other's.
    let swapped = obj.lines(|lines| {
        let f = last(lines, "f ");
        let corners: Vec<(&str, &str)> = lines[f].split(' ').skip(1).map(|c| c.split_once("//").unwrap()).collect();
        let [a, b, c, d] = corners[..] else { panic!("a quad") };
        lines[f] = format!("f {}//{} {}//{} {}//{} {}//{}", a.0, a.1, b.0, c.1, c.0, b.1, d.0, d.1);
    });
    assert!(normal(&swapped, 0.01, 1.0), "{swapped:?}");
    let turned = Damage::new(Format::Stl).last_record(|[normal, ..]| *normal = normal.map(|v| -v));
    assert!(normal(&turned, 1.999, 2.001), "{turned:?}");
    let none = Damage::new(Format::Stl).last_record(|[normal, ..]| *normal = [0.0; 3]);
    assert!(normal(&none, 0.999, 1.001), "{none:?}");
    let glb = Damage::new(Format::Glb).bytes(|bytes| {
        let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
        let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
        let accessor = json["meshes"][1]["primitives"][0]["attributes"]["NORMAL"].as_u64().unwrap() as usize;
        let view = json["accessors"][accessor]["bufferView"].as_u64().unwrap() as usize;
        let start = 28 + length + json["bufferViews"][view]["byteOffset"].as_u64().unwrap() as usize;
        // The signs of the first normal.
        for k in 0..3 {
            bytes[start + 4 * k + 3] ^= 0x80;
        }
    });
    assert!(normal(&glb, 1.999, 2.001), "{glb:?}");
}

#[test]
fn vertices_that_are_no_longer_shared() {
    // A copy of a vertex for one polygon alone: two of its sides, which others have too, or one at the border.
    let copied = Damage::new(Format::Obj).lines(|lines| {
        let f = last(lines, "f ");
        let corner = lines[f].split(' ').nth(1).unwrap().to_owned();
        let (vertex, rest) = corner.split_once("//").unwrap();
        let vertex: usize = vertex.parse().unwrap();
        let points: Vec<usize> = (0..lines.len()).filter(|&i| lines[i].starts_with("v ")).collect();
        let copy = lines[points[vertex - 1]].clone();
        let new = points.len() + 1;
        lines[f] = lines[f].replacen(&corner, &format!("{new}//{rest}"), 1);
        lines.insert(f, copy);
    });
    assert!(torn(&copied, 4), "{copied:?}");
    // The last bit of a coordinate of one triangle.
    let torn_apart = Damage::new(Format::Stl).last_record(|[_, a, _, _]| a[0] = f32::from_bits(a[0].to_bits() + 1));
    assert!(torn(&torn_apart, 4), "{torn_apart:?}");
}
