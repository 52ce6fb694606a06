//! What a file is, told by its suffix or its first bytes, so that one given in the wrong place is called by its name.

use std::path::Path;

use crate::formats::foreign::{DRAWING, OTHER_MESH, in_place_of_reading};
use crate::formats::{Format, MeshFormat};
use crate::text::lines::lines;

/// The kind of an input file.
///
/// ```
/// use cyclide_io::formats::InputKind;
/// assert_eq!(InputKind::of_path("scan.ply".as_ref()), Some(InputKind::PolygonMesh));
/// assert_eq!(InputKind::of_bytes(b"x;y\n0;1\n"), Some(InputKind::Points));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InputKind {
    /// A model document.
    Document,
    /// A list of points.
    Points,
    /// Points as JSON, to be used in a document.
    PointsJson,
    /// Points in rows and columns, or the samples of a surface.
    PointGrid,
    /// An OBJ mesh: its quads are for nets, its polygons for all other objects made from meshes.
    Mesh,
    /// A polygon mesh in a format that nets do not read: STL, PLY, GLB.
    PolygonMesh,
    /// A format that is written but not read, by name.
    Written(&'static str),
    /// A format that is neither written nor read, and what to save instead.
    Foreign(&'static str, &'static str),
}

/// Bytes of a file that tell what it is.
const HEAD: usize = 4096;

/// Lines that are looked at.
const LINES: usize = 20;

/// The part of a 3MF file with the model.
const MODEL: &[u8] = b"3D/3dmodel.model";

impl InputKind {
    /// The kind by the suffix; `None` for an unknown suffix.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let suffix = path.extension()?.to_string_lossy().to_lowercase();
        Some(match suffix.as_str() {
            "json" => Self::Document,
            "csv" | "tsv" | "xyz" => Self::Points,
            other => {
                let mesh = MeshFormat::of_word(other).map(Self::of_mesh);
                let foreign = || in_place_of_reading(other).map(Self::foreign);
                return mesh.or_else(foreign).or_else(|| Format::of_suffix(other).map(Self::written));
            }
        })
    }

    /// A mesh that is read.
    fn of_mesh(format: MeshFormat) -> Self {
        if format.entry().has_quads { Self::Mesh } else { Self::PolygonMesh }
    }

    /// What is not read, with what to save in its place.
    const fn foreign((name, instead): (&'static str, &'static str)) -> Self {
        Self::Foreign(name, instead)
    }

    /// A file of a format that is written.
    fn written(format: Format) -> Self {
        Self::Written(format.entry().title)
    }

    /// The kind by the first bytes; `None` if they do not determine it.
    #[must_use]
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        let head = &bytes[..bytes.len().min(HEAD)];
        let magic: &[(&[u8], Self)] = &[
            #[cfg(feature = "png")]
            (b"\x89PNG", Self::written(Format::Png)),
            (b"%PDF", Self::foreign(DRAWING)),
            (b"PK\x03\x04", Self::Foreign("an archive or a spreadsheet", "unpack it, or save it as CSV")),
        ];
        // Spreadsheets are archives too: 3MF is told by the name of its model.
        if head.starts_with(b"PK\x03\x04") && head.windows(MODEL.len()).any(|own| own == MODEL) {
            return Some(Self::written(Format::ThreeMf));
        }
        if let Some((_, found)) = magic.iter().find(|(start, _)| head.starts_with(start)) {
            return Some(*found);
        }
        let text = String::from_utf8_lossy(head);
        let text = text.trim_start_matches('\u{feff}').trim_start();
        match text.as_bytes().first()? {
            b'{' if text.contains("\"cyclide\"") => Some(Self::Document),
            b'{' => text.contains("\"cyclide-nurbs\"").then(|| Self::written(Format::Json)),
            b'[' => text[1..].trim_start().starts_with('[').then_some(Self::PointsJson),
            b'<' => {
                let words = [
                    ("<svg", Format::Svg),
                    ("<VTKFile", Format::Vtu),
                    ("<Geometry ", Format::Gismo),
                    ("<MultiPatch ", Format::Gismo),
                ];
                words.into_iter().find(|(word, _)| text.contains(word)).map(|(_, format)| Self::written(format))
            }
            b'M' if text.starts_with("MFEM ") => Some(Self::written(Format::Mfem)),
            _ if text.starts_with("ISO-10303-21") => Some(Self::written(Format::Step)),
            _ if text.starts_with("0\nSECTION") || text.starts_with("0\r\nSECTION") => Some(Self::written(Format::Dxf)),
            _ => MeshFormat::of_start(text).map(Self::of_mesh).or_else(|| Self::of_lines(text)),
        }
    }

    /// Lists of points, by their first lines that are no remark.
    fn of_lines(text: &str) -> Option<Self> {
        let fields = |line: &str| -> Vec<String> {
            let fields = line.split([',', ';', '\t', ' ']).map(|f| f.trim_matches('"').to_lowercase());
            fields.filter(|field| !field.is_empty()).collect()
        };
        let number = |field: &String| field.parse::<f64>().is_ok();
        for (_, line) in lines(text).take(LINES) {
            let names = fields(line.trim_start_matches('#'));
            let has = |name: &str| names.iter().any(|field| field == name);
            // Not `u`, `v`, which are velocities as often, nor `i`, `j`, `k`, the direction of a tool.
            let grid = [["patch", "s"], ["i", "j"], ["row", "column"], ["row", "col"]];
            let in_space = ["x", "y", "z"].into_iter().all(has) && !has("k");
            if in_space && grid.iter().any(|pair| pair.iter().all(|name| has(name))) {
                return Some(Self::PointGrid);
            }
            if line.trim_start().starts_with('#') {
                continue;
            }
            match names.as_slice() {
                [] => {}
                [first, second, ..] if number(first) && number(second) => return Some(Self::Points),
                _ => {}
            }
        }
        None
    }

    /// True for what may be a mesh.
    pub(crate) fn is_mesh(self) -> bool {
        [Self::Mesh, Self::PolygonMesh, Self::foreign(OTHER_MESH)].contains(&self)
    }

    /// Its common name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Document => "a model document",
            Self::Points => "a list of points",
            Self::PointsJson => "a list of points as JSON",
            Self::PointGrid => "points of a surface (its columns name rows or patches)",
            Self::Mesh | Self::PolygonMesh => "a mesh",
            Self::Written(name) | Self::Foreign(name, _) => name,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_bytes_tell_what_a_file_is() {
        for (head, found) in [
            (&b"{\"cyclide\": 1}"[..], Some(InputKind::Document)),
            (b"\xef\xbb\xbf {\n\"cyclide\": 1}", Some(InputKind::Document)),
            (b"{\"cyclide-nurbs\": 1}", Some(InputKind::Written("a file of exact B-splines"))),
            (b"{\"other\": 1}", None),
            (b"[[0, 1], [2, 3]]", Some(InputKind::PointsJson)),
            (b"ISO-10303-21;\nHEADER;", Some(InputKind::Written("STEP"))),
            (b"  0\nSECTION\n  2\nHEADER", Some(InputKind::Written("DXF"))),
            (b"<?xml version=\"1.0\"?>\n<svg>", Some(InputKind::Written("SVG"))),
            (b"<?xml version=\"1.0\"?>\n<VTKFile>", Some(InputKind::Written("VTU"))),
            (b"<xml>\n<MultiPatch parDim=\"3\">", Some(InputKind::Written("G+Smo XML"))),
            (b"PK\x03\x04 ... 3D/3dmodel.model", Some(InputKind::Written("3MF"))),
            (
                b"PK\x03\x04 ... xl/workbook.xml",
                Some(InputKind::Foreign("an archive or a spreadsheet", "unpack it, or save it as CSV")),
            ),
            (b"MFEM NURBS mesh v1.0\n", Some(InputKind::Written("MFEM"))),
            (b"# roof\nv 0 0 0\nv 1 0 0\n", Some(InputKind::Mesh)),
            (b"mtllib a.mtl\no roof\n", Some(InputKind::Mesh)),
            (b"# lone carriage returns\rv 0 0 0\r", Some(InputKind::Mesh)),
            (b"# x_m,y_m\n0,1\n", Some(InputKind::Points)),
            (b"x;y\n0;1\n", Some(InputKind::Points)),
            (b"0 1 2\n", Some(InputKind::Points)),
            (b"i,j,x,y,z\n0,0,1,2,3\n", Some(InputKind::PointGrid)),
            (b"patch,s,t,x,y,z\n", Some(InputKind::PointGrid)),
            (b"t,x,y,z,tangent_x\n0,1,2,3,4\n", Some(InputKind::Points)),
            (b"x,y,speed,u,v\n0,1,2,3,4\n", Some(InputKind::Points)),
            (b"x,y,i,j\n0,1,2,3\n", Some(InputKind::Points)),
            (b"x,y,z,i,j,k\n0,1,2,0,0,1\n", Some(InputKind::Points)),
            (b"ply\nformat ascii 1.0\nelement vertex 3\n", Some(InputKind::PolygonMesh)),
            (b"solid part\nfacet normal 0 0 1\n", Some(InputKind::PolygonMesh)),
            (b"solid ground\n", None),
            (b"glTF\x02\0\0\0", Some(InputKind::PolygonMesh)),
            (b"vertex v\n", None),
            (b"", None),
            (b"\xff\xfe\x00", None),
        ] {
            assert_eq!(InputKind::of_bytes(head), found, "{}", String::from_utf8_lossy(head));
        }
    }
}
