use super::*;
use cyclide::Vec3;
use serde_json::json;

/// A GLB file of a document and bytes.
fn file(document: &Value, binary: &[u8]) -> Vec<u8> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut binary = binary.to_vec();
    binary.resize(binary.len().next_multiple_of(4), 0);
    let length = 12 + 8 + text.len() + 8 + binary.len();
    let mut bytes = b"glTF".to_vec();
    bytes.extend(2_u32.to_le_bytes());
    bytes.extend((length as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", text), (b"BIN\0", binary)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

const POINTS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 4.0]];
const TRIANGLES_OF: [[u8; 3]; 2] = [[0, 1, 2], [0, 3, 1]];

/// Points with a normal each, interleaved, and indices of some width behind them.
fn binary(width: usize) -> Vec<u8> {
    let mut bytes: Vec<u8> = Vec::new();
    for p in POINTS {
        p.iter().chain(&[0.0, 0.0, 1.0]).for_each(|v: &f32| bytes.extend(v.to_le_bytes()));
    }
    for index in TRIANGLES_OF.as_flattened() {
        bytes.push(*index);
        bytes.extend(std::iter::repeat_n(0, width - 1));
    }
    bytes
}

fn document(width: usize, nodes: &Value) -> Value {
    let component = match width {
        1 => 5121,
        2 => 5123,
        _ => 5125,
    };
    json!({
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}],
        "buffers": [{"byteLength": 96 + 6 * width}],
        "bufferViews": [
            {"buffer": 0, "byteLength": 96, "byteStride": 24},
            {"buffer": 0, "byteOffset": 96, "byteLength": 6 * width},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": component, "count": 6, "type": "SCALAR"},
        ],
    })
}

/// The point with the second axis up.
fn up(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, -z, y)
}

#[test]
fn strides_and_widths_of_indices_are_read() {
    for width in [1, 2, 4] {
        let found = read_scene("a.glb", &file(&document(width, &json!([{"mesh": 0}])), &binary(width))).unwrap();
        assert_eq!(found.mesh.points, POINTS.map(|p| p.map(f64::from)).map(|[x, y, z]| up(x, y, z)));
        assert_eq!(found.mesh.faces, [vec![0, 1, 2], vec![0, 3, 1]]);
        assert_eq!(found.mesh.normals, [Vec3::new(0.0, -1.0, 0.0); 4]);
        assert_eq!(found.mesh.corner_normals, found.mesh.faces);
        assert!(found.lines == 0 && !found.moves);
    }
}

#[test]
fn nodes_map_their_meshes() {
    // A quarter turn about the third axis and a shift in one that doubles the first axis, given as a matrix.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let nodes = json!([
        {"children": [1], "matrix": [2, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  10, 0, 0, 1]},
        {"mesh": 0, "rotation": [0, 0, half, half], "translation": [0, 0, 5]},
    ]);
    let found = read_scene("a.glb", &file(&document(2, &nodes), &binary(2))).unwrap();
    for (p, [x, y, z]) in found.mesh.points.iter().zip(POINTS.map(|p| p.map(f64::from))) {
        // (x, y, z) -> (-y, x, z + 5) -> (2 (-y) + 10, x, z + 5); the quaternion has the digits of a double.
        assert!(p.distance(up(10.0 - 2.0 * y, x, z + 5.0)) < 1e-14, "{p:?}");
    }
    // A mirror turns triangles and normals with their outer side.
    let nodes = json!([{"mesh": 0, "scale": [1, 1, -3]}]);
    let found = read_scene("a.glb", &file(&document(2, &nodes), &binary(2))).unwrap();
    assert_eq!(found.mesh.faces, [vec![0, 2, 1], vec![0, 1, 3]]);
    assert!(found.mesh.normals.iter().all(|n| n.unit() == Some(Vec3::new(0.0, 1.0, 0.0))), "{:?}", found.mesh.normals);
}

#[test]
fn strips_and_fans_are_triangles() {
    let read = |mode: u64| {
        let mut document = document(1, &json!([{"mesh": 0}]));
        document["meshes"][0]["primitives"][0]["mode"] = json!(mode);
        document["accessors"][2]["count"] = json!(4);
        let mut bytes = binary(1);
        bytes[96..100].copy_from_slice(&[0, 1, 2, 3]);
        read_scene("a.glb", &file(&document, &bytes)).map(|found| found.mesh.faces)
    };
    assert_eq!(read(5).unwrap(), [vec![0, 1, 2], vec![2, 1, 3]]);
    assert_eq!(read(6).unwrap(), [vec![0, 1, 2], vec![0, 2, 3]]);
    assert!(read(4).unwrap_err().to_string().contains("a multiple of three"));
    assert!(read(1).unwrap_err().to_string().contains("no triangles"));
    assert!(read(9).unwrap_err().to_string().contains("does not define"));
}

#[test]
fn what_is_not_read_is_refused_by_name() {
    let message = |change: &dyn Fn(&mut Value)| {
        let mut document = document(2, &json!([{"mesh": 0}]));
        change(&mut document);
        read_scene("a.glb", &file(&document, &binary(2))).unwrap_err().to_string()
    };
    for (text, change) in [
        (
            "KHR_draco_mesh_compression",
            &(|d: &mut Value| {
                d["meshes"][0]["primitives"][0]["extensions"] = json!({"KHR_draco_mesh_compression": {}});
            }) as &dyn Fn(&mut Value),
        ),
        ("EXT_meshopt_compression", &|d| d["bufferViews"][0]["extensions"] = json!({"EXT_meshopt_compression": {}})),
        ("KHR_mesh_quantization", &|d| d["extensionsRequired"] = json!(["KHR_mesh_quantization"])),
        ("sparse", &|d| d["accessors"][0]["sparse"] = json!({})),
        ("quantized", &|d| d["accessors"][0]["componentType"] = json!(5122)),
        ("another file", &|d| d["buffers"][0]["uri"] = json!("a.bin")),
        ("are missing", &|d| d["accessors"][0]["count"] = json!(5)),
        ("are missing", &|d| d["accessors"][2]["count"] = json!(u64::MAX)),
        ("are missing", &|d| d["bufferViews"][0]["byteStride"] = json!(0)),
        ("type VEC3", &|d| d["accessors"][0]["type"] = json!("VEC2")),
        ("no entry 7", &|d| d["nodes"][0]["mesh"] = json!(7)),
        ("levels deep", &|d| d["nodes"][0]["children"] = json!([0])),
        ("affine", &|d| d["nodes"][0]["matrix"] = json!([1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])),
        ("unit quaternion", &|d| d["nodes"][0]["rotation"] = json!([1, 1, 0, 0])),
        ("8, 16 or 32 bits", &|d| d["accessors"][2]["componentType"] = json!(5124)),
        ("no triangles", &|d| d["scenes"][0]["nodes"] = json!([])),
    ] {
        let message = message(change);
        assert!(message.contains(text), "{message}");
    }
    // Harmless ones are passed over.
    let mut harmless = document(2, &json!([{"mesh": 0, "skin": 0}]));
    harmless["extensionsRequired"] = json!(["KHR_materials_unlit", "KHR_texture_transform"]);
    assert!(read_scene("a.glb", &file(&harmless, &binary(2))).unwrap().moves);
    let whole = file(&document(2, &json!([{"mesh": 0}])), &binary(2));
    for end in 0..whole.len() {
        assert!(read_scene("a.glb", &whole[..end]).is_err(), "{end} bytes");
    }
}
