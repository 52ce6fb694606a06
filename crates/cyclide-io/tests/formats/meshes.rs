//! Meshes of surfaces: written, read back, compared, refused.

use crate::models::{annulus, bent_quad, curve_and_surfaces, octant, surfaces, torus_part};
use cyclide::{
    Point3,
    mesh::{MeshFace, SurfaceMesh, tessellate},
    model::{CurveObject, Item, Model, SurfaceObject},
    surface::DupinCyclide,
};
use cyclide_io::{
    ExportOptions, Format,
    formats::{export, file_deviation, read_back},
};
use std::collections::HashMap;

const FORMATS: [Format; 4] = [Format::Glb, Format::Obj, Format::Stl, Format::Ply];

fn with_tolerance(tolerance: f64) -> ExportOptions {
    ExportOptions { tolerance: Some(tolerance), glb_edges: true, ..ExportOptions::default() }
}

fn all_models() -> Vec<(&'static str, Model)> {
    let far = Point3::new(2e4, -1e4, 3e4);
    vec![
        ("patches", surfaces(&[octant(), annulus(), torus_part(Point3::ORIGIN), bent_quad()])),
        ("far", surfaces(&[torus_part(far)])),
        ("with curve", curve_and_surfaces()),
    ]
}

#[test]
fn files_keep_their_promise_and_use_it() {
    for (name, m) in all_models() {
        for format in FORMATS {
            for tolerance in [0.1, 1e-2, 1e-3] {
                let made = export(&m, format, &with_tolerance(tolerance));
                if (name, format, tolerance) == ("far", Format::Stl, 1e-3) {
                    // Numbers of up to 3e4 in single precision are 2e-3 apart.
                    assert_eq!(made.unwrap_err().reason(), "rounding-above-tolerance");
                    continue;
                }
                let file = made.unwrap();
                let d = file_deviation(&m, format, &file).unwrap();
                assert!(d <= file.bound, "{name} {format:?}: {d:e} of {:e}", file.bound);
                assert!(!file.exact && d > 0.05 * tolerance, "{name} {format:?}: {d:e} of {tolerance:e}");
                // 6e-8 of the distance from the origin, 3.8e4, in STL; from the center of the object, up to 27, in GLB.
                let rounding = if format == Format::Stl { 2.3e-3 } else { 1.7e-6 };
                assert!(file.bound <= tolerance + rounding, "{name} {format:?}: {:e}", file.bound);
            }
        }
    }
}

#[test]
fn bytes_are_reproducible() {
    for (name, m) in all_models() {
        for format in FORMATS {
            let bytes = || export(&m, format, &with_tolerance(1e-2)).unwrap().bytes;
            assert_eq!(bytes(), bytes(), "{name} {format:?}");
        }
    }
}

/// The tolerance of meshes is 1e-4 of the diagonal, that of curves in the same file 1e-5.
#[test]
fn default_tolerances_follow_the_size() {
    let m = surfaces(&[annulus()]);
    // From the box (-2, 0, 0) to (2, 2, 0) round the half annulus.
    let size = 20.0_f64.sqrt();
    let file = export(&m, Format::Obj, &ExportOptions::default()).unwrap();
    assert!(file.bound <= 1e-4 * size && file.bound > 0.2e-4 * size, "{:e}", file.bound);
    let curve = &curve_and_surfaces().items[0];
    let m = Model { items: vec![curve.clone()], ..Model::default() };
    let file = export(&m, Format::Obj, &ExportOptions::default()).unwrap();
    assert!(file.bound < 1.1e-5 * 53.4, "{:e}", file.bound);
}

/// Vertices told apart by their bits alone.
fn merged(mesh: &SurfaceMesh) -> Vec<Vec<usize>> {
    let mut index: HashMap<[u64; 3], usize> = HashMap::new();
    let mut vertex = |p: Point3| {
        let next = index.len();
        *index.entry(p.to_array().map(f64::to_bits)).or_insert(next)
    };
    let polygon = |f: &MeshFace| f.corners().iter().map(|c| vertex(mesh.positions[c.position])).collect();
    mesh.faces.iter().map(polygon).collect()
}

/// Every patch is a disc: no crack, no T-joint, all polygons turn the same way round, V - E + F = 1.
#[test]
fn meshes_are_discs_from_the_bytes() {
    let patches = [octant(), annulus(), torus_part(Point3::ORIGIN), bent_quad()];
    for patch in patches {
        let m = surfaces(&[patch]);
        for format in FORMATS {
            let file = export(&m, format, &with_tolerance(2e-3)).unwrap();
            let mesh = &read_back(format, &file.bytes).unwrap().meshes[0];
            let polygons = merged(mesh);
            let mut sides: HashMap<[usize; 2], [usize; 2]> = HashMap::new();
            let mut vertices = 0;
            for polygon in &polygons {
                vertices = vertices.max(1 + polygon.iter().max().unwrap());
                for (i, &a) in polygon.iter().enumerate() {
                    let b = polygon[(i + 1) % polygon.len()];
                    assert_ne!(a, b, "a side of no length");
                    sides.entry([a.min(b), a.max(b)]).or_default()[usize::from(a < b)] += 1;
                }
            }
            assert!(sides.values().all(|[there, back]| *there <= 1 && *back <= 1), "{format:?}");
            assert_eq!(vertices + polygons.len(), sides.len() + 1, "{format:?}");
        }
    }
}

/// A ring, and a solid shell of it with a hollow: every side of a polygon has another one running back, and the volume
/// is that of the torus within the bound.
#[test]
fn closed_bodies_are_watertight_from_the_bytes() {
    use std::f64::consts::PI;
    let net = DupinCyclide::new(5.0, 0.0, 2.0).unwrap().nets([6, 6]).unwrap().remove(0);
    let volume = |m: &Model, format| {
        let file = export(m, format, &with_tolerance(0.01)).unwrap();
        assert!(file_deviation(m, format, &file).unwrap() <= file.bound);
        let mesh = read_back(format, &file.bytes).unwrap().meshes.remove(0);
        let polygons = merged(&mesh);
        let mut sides: HashMap<[usize; 2], [usize; 2]> = HashMap::new();
        for polygon in &polygons {
            for (i, &a) in polygon.iter().enumerate() {
                let b = polygon[(i + 1) % polygon.len()];
                sides.entry([a.min(b), a.max(b)]).or_default()[usize::from(a < b)] += 1;
            }
        }
        assert!(sides.values().all(|uses| *uses == [1, 1]), "{format:?}");
        let tetrahedron = |face: &MeshFace| {
            let p: Vec<_> = face.corners().iter().map(|c| mesh.positions[c.position].to_vec()).collect();
            p.windows(2).skip(1).map(|w| p[0].dot(w[0].cross(w[1])) / 6.0).sum::<f64>()
        };
        (mesh.faces.iter().map(tetrahedron).sum::<f64>(), file.bound)
    };
    for format in FORMATS {
        let (ring, bound) = volume(&solid(SurfaceObject::Net(net.clone())), format);
        let area = 4.0 * PI * PI * 5.0 * 2.0;
        // A layer as thick as the bound; the area of its outer side is 2.01/2 of the torus.
        assert!((ring - PI * PI * 40.0).abs() < 1.01 * bound * area, "{format:?}: {ring}");
        let (thick, bound) = volume(&solid(SurfaceObject::Body(net.thick(0.25).unwrap())), format);
        let exact = 2.0 * PI * PI * 5.0 * (2.25 * 2.25 - 4.0);
        assert!((thick - exact).abs() < 1.01 * bound * area * (1.0 + 2.25 / 2.0), "{format:?}: {thick}");
    }
}

fn solid(surface: SurfaceObject) -> Model {
    Model::default().with_surface("ring", surface)
}

#[test]
fn obj_keeps_quads_and_doubles() {
    let m = surfaces(&[torus_part(Point3::ORIGIN)]);
    let file = export(&m, Format::Obj, &with_tolerance(1e-2)).unwrap();
    let made = tessellate(&m.items[0].surfaces()[0].to_bodies().unwrap()[0], 1e-2).unwrap();
    let read = read_back(Format::Obj, &file.bytes).unwrap().meshes.remove(0);
    assert_eq!((&read.positions, &read.normals, &read.faces), (&made.positions, &made.normals, &made.faces));
    assert!(read.faces.iter().all(|f| matches!(f, MeshFace::Quad(_))));
    assert!(String::from_utf8(file.bytes).unwrap().starts_with("# cyclide, units mm\no s0\ng s0\nv "));
}

#[test]
fn stl_is_binary_with_the_length_it_says() {
    let m = surfaces(&[octant(), annulus()]);
    let bytes = export(&m, Format::Stl, &with_tolerance(1e-2)).unwrap().bytes;
    let count = u32::from_le_bytes(bytes[80..84].try_into().unwrap()) as usize;
    let made: usize = m
        .items
        .iter()
        .map(|item| tessellate(&item.surfaces()[0].to_bodies().unwrap()[0], 1e-2).unwrap().triangle_count())
        .sum();
    assert_eq!((count, bytes.len()), (made, 84 + 50 * made));
    assert!(!bytes.starts_with(b"solid"));
    // The normal of the first triangle is that of its corners: the octant's outside is that of f_s × f_t.
    let mesh = read_back(Format::Stl, &bytes).unwrap().meshes.remove(0);
    let normal = mesh.normals[0];
    let middle = mesh.positions[0].midpoint(mesh.positions[1]).midpoint(mesh.positions[2]);
    assert!(normal.dot(middle.to_vec()) > 0.9 && (normal.length() - 1.0).abs() < 1e-6);
}

#[test]
fn formats_without_a_kind_say_what_is_left_out() {
    let m = curve_and_surfaces();
    let note = |format| export(&m, format, &ExportOptions::default()).unwrap().notes.join("; ");
    assert!(note(Format::Stl).contains("curves are left out (STL cannot hold them): slot"), "{}", note(Format::Stl));
    for format in [Format::Dxf, Format::Csv] {
        assert!(note(format).contains("surfaces are left out") && note(format).contains("s0, s1"), "{}", note(format));
    }
    for format in [Format::Glb, Format::Obj] {
        assert_eq!(note(format), "", "{format:?}");
    }
    let (curves, surfaces) = (m.items[..1].to_vec(), m.items[1..].to_vec());
    for (items, format, what) in [
        (curves.clone(), Format::Stl, "object slot: STL cannot represent this: curves"),
        (curves, Format::Ply, "object slot: PLY cannot represent this: curves"),
        (surfaces.clone(), Format::Dxf, "object s0: DXF cannot represent this: surfaces"),
        (surfaces, Format::Csv, "object s0: CSV cannot represent this: surfaces"),
    ] {
        let error = export(&Model { items, ..Model::default() }, format, &ExportOptions::default()).unwrap_err();
        assert_eq!((error.reason(), error.to_string().as_str()), ("not-in-format", what));
    }
}

#[test]
fn sizes_beyond_single_precision_are_refused() {
    for scale in [1e-20, 1e20] {
        let corners = bent_quad().corners().map(|p| Point3::ORIGIN + p.to_vec() * scale);
        let [v1, v2, _] = bent_quad().frame();
        let m = surfaces(&[cyclide::surface::CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap()]);
        for format in [Format::Glb, Format::Stl] {
            let error = export(&m, format, &ExportOptions::default()).unwrap_err();
            assert_eq!(error.reason(), "not-in-format", "{format:?}");
        }
        let file = export(&m, Format::Obj, &ExportOptions::default()).unwrap();
        assert!(file_deviation(&m, Format::Obj, &file).unwrap() <= file.bound);
    }
}

/// Products of four lengths neither vanish nor overflow when the file is measured.
#[test]
fn sizes_near_the_limits_of_doubles_are_measured() {
    let deviation = |scale: f64| {
        let corners = bent_quad().corners().map(|p| Point3::ORIGIN + p.to_vec() * scale);
        let [v1, v2, _] = bent_quad().frame();
        let m = surfaces(&[cyclide::surface::CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap()]);
        let file = export(&m, Format::Obj, &ExportOptions::default()).unwrap();
        (file_deviation(&m, Format::Obj, &file).unwrap() / scale, file.bound / scale)
    };
    let (usual, bound) = deviation(1.0);
    assert!(usual <= bound);
    for scale in [1e-140, 1e-80, 1e80, 1e100] {
        // The cuts depend on rounding; the distance of each cell is a part of the tolerance that does not.
        let (own, bound) = deviation(scale);
        assert!(own <= bound && (own / usual - 1.0).abs() < 1e-6, "{scale:e}: {own:e} and {usual:e}");
    }
}

/// Single precision has seven digits: far from the origin nothing of a small body is left. STL has no offset, the other
/// formats are as near as at the origin.
#[test]
fn stl_far_from_the_origin_is_refused() {
    let torus = |at: f64| {
        let frame = cyclide::Frame::from_normal(Point3::new(at, at, at), cyclide::Vec3::Z, cyclide::Vec3::X).unwrap();
        solid(SurfaceObject::Net(
            DupinCyclide::new(3.0, 0.0, 1.0).unwrap().placed(frame).nets([4, 4]).unwrap().remove(0),
        ))
    };
    for (at, tolerance, numbers) in [
        (1e9, Some(1e-3), "coordinates of up to 1e9 by 4"),
        (1e7, Some(1e-3), "coordinates of up to 1e7 by 0.8"),
        (1e7, None, "coordinates of up to 1e7 by 0.8"),
    ] {
        let options = ExportOptions { tolerance, ..ExportOptions::default() };
        let error = export(&torus(at), Format::Stl, &options).unwrap_err();
        assert_eq!(error.reason(), "rounding-above-tolerance");
        let text = error.to_string();
        assert!(text.starts_with("object ring: STL rounds ") && text.contains(numbers), "{text}");
        assert!(text.contains("more than the tolerance") && text.contains("move the model to the origin"), "{text}");
        for format in [Format::Glb, Format::Obj] {
            let file = export(&torus(at), format, &options).unwrap();
            assert!(file_deviation(&torus(at), format, &file).unwrap() <= file.bound, "{format:?} {at:e}");
        }
    }
    let file = export(&torus(1e3), Format::Stl, &with_tolerance(1e-3)).unwrap();
    let d = file_deviation(&torus(1e3), Format::Stl, &file).unwrap();
    // To the tolerance comes the rounding of numbers up to 1004, half of 6e-5 in each direction.
    assert!(d > 0.5e-3 && d <= file.bound && file.bound < 1.06e-3, "{d:e} {:e}", file.bound);
    // At the origin there is nothing to move: a flat square of one cell, whose coordinates are no binary numbers.
    let corners = [[0.1, 0.1, 0.0], [1.1, 0.1, 0.0], [0.1, 1.1, 0.0], [1.1, 1.1, 0.0]].map(Point3::from);
    let square =
        cyclide::surface::CyclidePatch::from_corners_and_frame(corners, cyclide::Vec3::X, cyclide::Vec3::Y).unwrap();
    let error = export(&surfaces(&[square]), Format::Stl, &with_tolerance(1e-9)).unwrap_err();
    let text = error.to_string();
    assert!(text.ends_with("more than the tolerance 1e-9: use a larger tolerance or write OBJ"), "{text}");
}

/// What is checked besides the distance (sides, normals, joined polygons) holds for whole cyclides of every kind, as
/// coarse as they may be, and their mirror images, also where the patch's own normal is not that of `f_s × f_t`.
#[test]
fn whole_cyclides_pass_every_check() {
    for (a, c, mu) in
        [(3.0, 0.0, 1.0), (3.0, 1.0, 2.0), (2.0, 1.5, 1.0), (2.0, 1.0, 3.0), (1.0, 0.0, 2.0), (10.0, 0.0, 10.000001)]
    {
        for net in DupinCyclide::new(a, c, mu).unwrap().nets([3, 3]).unwrap() {
            for map in ["as made", "mirrored"] {
                let surface = SurfaceObject::Net(net.clone());
                let mirror =
                    cyclide::conformal::Mobius::reflection(Point3::ORIGIN, cyclide::Vec3::new(1.0, 2.0, 2.0)).unwrap();
                let surface = if map == "mirrored" {
                    cyclide::conformal::Conformal::transformed(&surface, &mirror).unwrap()
                } else {
                    surface
                };
                let m = solid(surface);
                for format in FORMATS {
                    for tolerance in [100.0, 0.5, 0.02] {
                        let file = export(&m, format, &with_tolerance(tolerance)).unwrap();
                        let d = file_deviation(&m, format, &file);
                        assert!(
                            d.as_ref().is_ok_and(|d| *d <= file.bound),
                            "{a} {c} {mu} {map} {format:?} {tolerance}: {d:?}"
                        );
                    }
                }
            }
        }
    }
}

/// The JSON of a GLB file.
fn document(bytes: &[u8]) -> (serde_json::Value, &[u8]) {
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    assert_eq!(length % 4, 0);
    (serde_json::from_slice(&bytes[20..20 + length]).unwrap(), &bytes[28 + length..])
}

#[test]
fn glb_says_its_bounds_exactly_and_stays_near_its_centre() {
    let far = Point3::new(2e4, -1e4, 3e4);
    let m = Model { units: cyclide::model::Units::Metre, ..surfaces(&[torus_part(far)]) };
    let bytes = export(&m, Format::Glb, &with_tolerance(1e-2)).unwrap().bytes;
    let (json, binary) = document(&bytes);
    let accessor = &json["accessors"][0];
    let view = &json["bufferViews"][0];
    let (start, length) = (view["byteOffset"].as_u64().unwrap(), view["byteLength"].as_u64().unwrap());
    let numbers: Vec<f64> = binary[start as usize..(start + length) as usize]
        .chunks_exact(4)
        .map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap())))
        .collect();
    assert_eq!(numbers.len(), 3 * accessor["count"].as_u64().unwrap() as usize);
    for axis in 0..3 {
        let own = || numbers.iter().skip(axis).step_by(3).copied();
        assert_eq!(accessor["min"][axis].as_f64().unwrap(), own().fold(f64::INFINITY, f64::min));
        assert_eq!(accessor["max"][axis].as_f64().unwrap(), own().fold(f64::NEG_INFINITY, f64::max));
        assert!(own().all(|v| v.abs() < 3.0), "relative to the centre");
        assert!((json["nodes"][0]["translation"][axis].as_f64().unwrap() - far.to_array()[axis]).abs() < 3.0);
    }
    let root = &json["nodes"][1];
    assert_eq!(root["scale"], serde_json::json!([1.0, 1.0, 1.0]));
    assert_eq!(json["scenes"][0]["nodes"], serde_json::json!([1]));
    assert_eq!(json["extensionsUsed"], serde_json::json!(["KHR_materials_unlit"]));
}

/// The lines on a GLB are the four sides of the patch.
#[test]
fn glb_lines_are_the_edges() {
    let m = surfaces(&[torus_part(Point3::ORIGIN)]);
    let bytes = export(&m, Format::Glb, &with_tolerance(1e-2)).unwrap().bytes;
    let (json, binary) = document(&bytes);
    let primitives = json["meshes"][0]["primitives"].as_array().unwrap();
    assert_eq!(primitives.len(), 2);
    assert_eq!(primitives[1]["attributes"], serde_json::json!({"POSITION": 0}));
    let view = &json["bufferViews"][primitives[1]["indices"].as_u64().unwrap() as usize];
    let start = view["byteOffset"].as_u64().unwrap() as usize;
    let length = view["byteLength"].as_u64().unwrap() as usize;
    let indices = binary[start..start + length].chunks_exact(4).map(|b| u32::from_le_bytes(b.try_into().unwrap()));
    let mesh = read_back(Format::Glb, &bytes).unwrap().meshes.remove(0);
    let patch = torus_part(Point3::ORIGIN);
    let sides = [patch.s_line(0.0), patch.s_line(1.0), patch.t_line(0.0), patch.t_line(1.0)].map(Result::unwrap);
    let mut length = 0.0;
    let points: Vec<Point3> = indices.map(|i| mesh.positions[i as usize]).collect();
    for segment in points.chunks_exact(2) {
        let near = |p: Point3| sides.iter().map(|a| cyclide::curve::closest_point(a, p).distance).fold(9.0, f64::min);
        assert!(near(segment[0]) < 1e-6 && near(segment[1]) < 1e-6, "single precision of lengths up to 3");
        length += segment[0].distance(segment[1]);
    }
    let whole: f64 = sides.iter().map(cyclide::curve::Arc::length).sum();
    // Chords are shorter than their arcs by a part of (angle)²/24, here of less than 0.5 radians.
    assert!(length < whole && length > 0.98 * whole, "{length} of {whole}");
}

#[test]
fn curves_of_meshes_are_lines() {
    let m = Model { items: curve_and_surfaces().items[..1].to_vec(), ..Model::default() };
    let CurveObject::ArcPath(slot) = &m.items[0].curves()[0] else { panic!("a path") };
    assert!(cyclide::curve::ParamCurve::is_closed(slot));
    for format in [Format::Glb, Format::Obj] {
        let content = read_back(format, &export(&m, format, &ExportOptions::default()).unwrap().bytes).unwrap();
        assert!(content.meshes.is_empty() && content.curves.len() == 1);
        assert!(cyclide::curve::ParamCurve::is_closed(&content.curves[0]), "{format:?}");
    }
}

#[test]
fn refusals_name_the_surface() {
    let patches = [torus_part(Point3::ORIGIN), octant()].map(SurfaceObject::Patch);
    let item = Item::new("parts", patches.to_vec());
    let model = Model { items: vec![item], ..Model::default() };
    let error = export(&model, Format::Obj, &with_tolerance(1e-12)).unwrap_err();
    assert!(error.to_string().starts_with("object parts, surface 0: "), "{error}");
    assert_eq!(error.reason(), "too-many-pieces");
    // A ring offset to a horn of two lobes: the large one, which is the second, is at fault. Both are of the one surface.
    let net = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([4, 4]).unwrap().remove(0).offset(-1.01).unwrap();
    let lobes = SurfaceObject::Net(net.clone()).to_bodies().unwrap();
    assert!(lobes.len() == 2 && tessellate(&lobes[0], 1e-7).is_ok() && tessellate(&lobes[1], 1e-7).is_err());
    let error = export(&Model::default().with_surface("", net), Format::Obj, &with_tolerance(1e-7)).unwrap_err();
    assert!(error.to_string().contains(", surface 0: the mesh needs "), "{error}");
}
