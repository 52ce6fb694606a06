//! Numbers of a GLB file: accessors into views of its binary chunk.

use std::cell::Cell;

use serde_json::Value;

/// Types of components.
const UNSIGNED_BYTE: u64 = 5121;
const UNSIGNED_SHORT: u64 = 5123;
const UNSIGNED_INT: u64 = 5125;
const FLOAT: u64 = 5126;

/// The entries of a list; none if there is no list.
pub(super) fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// A whole number from 0.
pub(super) fn number(value: &Value, key: &str) -> Option<usize> {
    value.get(key)?.as_u64().and_then(|n| usize::try_from(n).ok())
}

/// The entry of a list of the document that an index names.
pub(super) fn entry<'a>(document: &'a Value, key: &str, index: Option<&Value>) -> Result<&'a Value, String> {
    let place = index.and_then(Value::as_u64).and_then(|i| usize::try_from(i).ok());
    let entry = place.and_then(|i| list(document, key).get(i));
    entry.ok_or_else(|| match place {
        Some(place) => format!("{key}: there is no entry {place}"),
        None => format!("{key}: an index is missing"),
    })
}

/// The numbers of a file.
pub(super) struct Accessors<'a> {
    document: &'a Value,
    binary: &'a [u8],
    /// Bytes that may still be read: some times those there are, so that nothing is made many times from the same few.
    left: Cell<usize>,
}

/// How often the bytes of a file may be used, by nodes that share a mesh.
const MOST_USES: usize = 64;

impl<'a> Accessors<'a> {
    pub(super) fn new(document: &'a Value, binary: &'a [u8]) -> Self {
        Self { document, binary, left: Cell::new(binary.len().saturating_mul(MOST_USES)) }
    }

    /// Points or normals.
    pub(super) fn vectors(&self, accessor: Option<&Value>) -> Result<Vec<[f64; 3]>, String> {
        let accessor = entry(self.document, "accessors", accessor)?;
        if accessor.get("componentType").and_then(Value::as_u64) != Some(FLOAT) {
            return Err(
                "points or normals are not in single precision (quantized): export without quantization".to_owned()
            );
        }
        let rows = self.rows(accessor, "VEC3", 12)?;
        let float = |bytes: &[u8]| bytes.first_chunk().map_or(f64::NAN, |b| f64::from(f32::from_le_bytes(*b)));
        let vectors = rows.map(|row| [float(&row[..4]), float(&row[4..8]), float(&row[8..])]);
        let vectors: Vec<[f64; 3]> = vectors.collect();
        if vectors.iter().flatten().all(|v| v.is_finite()) {
            Ok(vectors)
        } else {
            Err("a coordinate is not finite".to_owned())
        }
    }

    /// Numbers of vertices.
    pub(super) fn indices(&self, accessor: &Value) -> Result<Vec<usize>, String> {
        let accessor = entry(self.document, "accessors", Some(accessor))?;
        let width = match accessor.get("componentType").and_then(Value::as_u64) {
            Some(UNSIGNED_BYTE) => 1,
            Some(UNSIGNED_SHORT) => 2,
            Some(UNSIGNED_INT) => 4,
            _ => return Err("indices are not unsigned integers of 8, 16 or 32 bits".to_owned()),
        };
        let rows = self.rows(accessor, "SCALAR", width)?;
        Ok(rows.map(|row| row.iter().rev().fold(0, |sum, byte| sum << 8 | usize::from(*byte))).collect())
    }

    /// The entries of an accessor, `width` bytes each.
    fn rows(&self, accessor: &Value, kind: &str, width: usize) -> Result<impl Iterator<Item = &'a [u8]>, String> {
        if accessor.get("sparse").is_some() {
            return Err("an accessor is sparse, which is not supported: export without sparse accessors".to_owned());
        }
        if accessor.get("type").and_then(Value::as_str) != Some(kind) {
            return Err(format!("an accessor does not have type {kind}"));
        }
        let view = entry(self.document, "bufferViews", accessor.get("bufferView"))?;
        if let Some(extension) = view.get("extensions").and_then(Value::as_object).and_then(|e| e.keys().next())
            && extension.ends_with("_compression")
        {
            return Err(format!("the data are compressed with {extension}, which is not supported: export without it"));
        }
        let buffer = number(view, "buffer").unwrap_or_default();
        if list(self.document, "buffers").get(buffer).is_none_or(|b| b.get("uri").is_some()) || buffer > 0 {
            return Err(
                "the data are in another file or embedded as text: export everything to one GLB file".to_owned()
            );
        }
        let bytes = || {
            let (start, length) = (number(view, "byteOffset").unwrap_or_default(), number(view, "byteLength")?);
            let bytes = self.binary.get(start..)?.get(..length)?;
            let (offset, count) = (number(accessor, "byteOffset").unwrap_or_default(), number(accessor, "count")?);
            let stride = number(view, "byteStride").unwrap_or(width);
            // The last entry need not be padded.
            let needed = count.saturating_sub(1).checked_mul(stride)?.checked_add(if count > 0 { width } else { 0 })?;
            let bytes = bytes.get(offset..)?.get(..needed)?;
            self.left.set(self.left.get().checked_sub(needed)?);
            (stride >= width).then_some((bytes, stride))
        };
        let (bytes, stride) = bytes().ok_or("the bytes of an accessor are missing")?;
        Ok(bytes.chunks(stride).map(move |row| &row[..width]))
    }
}
