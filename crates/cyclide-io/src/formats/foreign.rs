//! Formats of other programs that are not read, or not written: what people call them, and what to take in their place.

/// Suffixes of one kind of files.
struct Foreign {
    suffixes: &'static [&'static str],
    /// Its name as an input, and what to save instead; `None` if it may be read.
    reading: Option<(&'static str, &'static str)>,
    /// What to write instead; `None` if nothing is similar.
    writing: Option<&'static str>,
}

/// A mesh in a format that is not read.
pub(super) const OTHER_MESH: (&str, &str) = ("a mesh in another format", "save it as OBJ, keeping any quads");
/// A drawing.
pub(super) const DRAWING: (&str, &str) = ("a drawing", "export points of its curves as CSV");

const FOREIGN: &[Foreign] = &[
    Foreign {
        suffixes: &["iges", "igs", "x_t", "x_b", "sat", "brep", "brp", "fcstd", "sldprt", "ipt", "3dm", "f3d"],
        reading: Some(("a CAD file", "export points of its curves as CSV, or a mesh of quads as OBJ")),
        writing: Some(".step transfers curves and surfaces to CAD"),
    },
    Foreign { suffixes: &["dwg"], reading: Some(DRAWING), writing: Some("programs that read DWG also read .dxf") },
    Foreign {
        suffixes: &["pdf", "eps", "ps", "ai"],
        reading: Some(DRAWING),
        writing: Some(".svg is a drawing at true size for printing or conversion"),
    },
    Foreign {
        suffixes: &["jpg", "jpeg", "webp", "gif", "bmp", "tif", "tiff"],
        reading: None,
        writing: Some(".png is a picture"),
    },
    Foreign { suffixes: &["gltf"], reading: Some(OTHER_MESH), writing: Some(".glb is glTF in a single file") },
    Foreign {
        suffixes: &["off", "fbx", "dae", "blend", "usd", "usdz"],
        reading: Some(OTHER_MESH),
        writing: Some(".glb, .obj, .ply, .stl and .3mf are meshes"),
    },
    Foreign {
        suffixes: &["vtk", "vtp", "vts", "vtm", "pvtu", "vtkhdf", "exo"],
        reading: None,
        writing: Some("ParaView and VTK read .vtu"),
    },
    Foreign {
        suffixes: &["msh", "cgns", "p3d", "inp", "bdf"],
        reading: None,
        writing: Some(".vtu represents blocks exactly; .mesh (MFEM) and .xml (G+Smo) are for isogeometric analysis"),
    },
    Foreign {
        suffixes: &["nc", "ngc", "tap", "gcode", "cnc"],
        reading: None,
        writing: Some(".dxf contains arcs, from which CAM generates machine code"),
    },
    Foreign {
        suffixes: &["txt", "tsv", "xyz", "dat", "asc"],
        reading: None,
        writing: Some(".csv is a list of points"),
    },
    Foreign { suffixes: &["xlsx", "xls", "ods"], reading: Some(("a spreadsheet", "save it as CSV")), writing: None },
    Foreign {
        suffixes: &["gpx", "kml", "geojson"],
        reading: Some(("a geographic file", "save its points as CSV in projected (plane) coordinates")),
        writing: None,
    },
];

fn of_suffix(suffix: &str) -> Option<&'static Foreign> {
    FOREIGN.iter().find(|foreign| foreign.suffixes.contains(&suffix))
}

/// What a file that is not read is called, and what to save in its place.
pub(super) fn in_place_of_reading(suffix: &str) -> Option<(&'static str, &'static str)> {
    of_suffix(suffix)?.reading
}

/// What to write in the place of a format that is not written.
pub(super) fn in_place_of_writing(suffix: &str) -> Option<&'static str> {
    of_suffix(suffix)?.writing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::{Format, MeshFormat};

    #[test]
    fn what_is_read_or_written_is_not_foreign() {
        let suffixes: Vec<&str> = FOREIGN.iter().flat_map(|foreign| foreign.suffixes).copied().collect();
        for (index, suffix) in suffixes.iter().enumerate() {
            assert!(!suffixes[..index].contains(suffix), "{suffix} stands there twice");
            assert!(Format::of_suffix(suffix).is_none(), "{suffix} is written");
            assert!(MeshFormat::of_word(suffix).is_none() || in_place_of_reading(suffix).is_none(), "{suffix} is read");
        }
    }
}
