//! The binary part of a GLB file, the accessors that describe it, and the container around both.

use serde_json::{Value, json};

/// Types of components.
const FLOAT: u64 = 5126;
const UNSIGNED_INT: u64 = 5125;

/// What a part of the buffer is for.
#[derive(Clone, Copy)]
pub(super) enum Target {
    /// Attributes of vertices.
    Vertices = 34962,
    /// Indices of vertices.
    Elements = 34963,
}

/// The binary chunk and its accessors, one view each.
#[derive(Default)]
pub(super) struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Adds points with their bounds, which are the stored numbers exactly; gives the accessor.
    pub(super) fn positions(&mut self, points: &[[f32; 3]]) -> usize {
        let bound = |pick: fn(f32, f32) -> f32, start: f32| {
            let extreme = points.iter().fold([start; 3], |b, p| [0, 1, 2].map(|i| pick(b[i], p[i])));
            extreme.map(f64::from)
        };
        let (min, max) = (bound(f32::min, f32::INFINITY), bound(f32::max, f32::NEG_INFINITY));
        let accessor = self.vectors(points.iter().copied());
        self.accessors[accessor]["min"] = json!(min);
        self.accessors[accessor]["max"] = json!(max);
        accessor
    }

    /// Adds vectors; gives the accessor.
    pub(super) fn vectors(&mut self, vectors: impl Iterator<Item = [f32; 3]>) -> usize {
        let start = self.bytes.len();
        let mut count = 0;
        for v in vectors {
            self.bytes.extend(v.iter().flat_map(|c| c.to_le_bytes()));
            count += 1;
        }
        self.accessor(start, Some(Target::Vertices), FLOAT, count, "VEC3")
    }

    /// Adds rising times with their bounds; gives the accessor.
    pub(super) fn times(&mut self, times: &[f32]) -> usize {
        let rows: Vec<[f32; 1]> = times.iter().map(|t| [*t]).collect();
        let accessor = self.free_vectors(&rows);
        self.accessors[accessor]["min"] = json!([times.first()]);
        self.accessors[accessor]["max"] = json!([times.last()]);
        accessor
    }

    /// Adds numbers that are no attributes of vertices, in rows of 1, 3 or 4; gives the accessor.
    pub(super) fn free_vectors<const D: usize>(&mut self, rows: &[[f32; D]]) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(rows.as_flattened().iter().flat_map(|c| c.to_le_bytes()));
        let kind = match D {
            1 => "SCALAR",
            3 => "VEC3",
            _ => "VEC4",
        };
        self.accessor(start, None, FLOAT, rows.len(), kind)
    }

    /// Adds indices; gives the accessor.
    pub(super) fn indices(&mut self, indices: &[u32]) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(indices.iter().flat_map(|i| i.to_le_bytes()));
        self.accessor(start, Some(Target::Elements), UNSIGNED_INT, indices.len(), "SCALAR")
    }

    fn accessor(&mut self, start: usize, target: Option<Target>, component: u64, count: usize, kind: &str) -> usize {
        let length = self.bytes.len() - start;
        let mut view = json!({"buffer": 0, "byteOffset": start, "byteLength": length});
        if let Some(target) = target {
            view["target"] = json!(target as u64);
        }
        self.views.push(view);
        let view = self.views.len() - 1;
        self.accessors.push(json!({"bufferView": view, "componentType": component, "count": count, "type": kind}));
        view
    }

    /// The whole file: head, document and buffer, each padded to four bytes; `None` beyond the length that the head can say.
    pub(super) fn container(mut self, mut document: Value) -> Option<Vec<u8>> {
        document["accessors"] = Value::Array(self.accessors);
        document["bufferViews"] = Value::Array(self.views);
        document["buffers"] = json!([{"byteLength": self.bytes.len()}]);
        let mut text = document.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let length = u32::try_from(12 + 8 + text.len() + 8 + self.bytes.len()).ok()?;
        let mut file = Vec::with_capacity(length as usize);
        file.extend(b"glTF");
        file.extend(2_u32.to_le_bytes());
        file.extend(length.to_le_bytes());
        for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &self.bytes)] {
            // Shorter than the whole.
            file.extend((chunk.len() as u32).to_le_bytes());
            file.extend(kind);
            file.extend(chunk);
        }
        Some(file)
    }
}
