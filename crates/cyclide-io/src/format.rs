//! The formats that are written, by file suffix.

use crate::export_error::ExportError;
use crate::suggest::did_you_mean;
use std::path::Path;

/// What a model consists of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Curves,
    Surfaces,
}

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// STEP AP214 (ISO 10303-21): CAD systems.
    Step,
    /// AutoCAD DXF: laser cutters, 2D CAD.
    Dxf,
    /// Scalable Vector Graphics: browsers, laser cutters.
    Svg,
    /// Comma-separated samples.
    Csv,
    /// Exact rational B-splines as JSON.
    Json,
    /// A picture.
    Png,
    /// Binary glTF 2.0: rendering, browsers.
    Glb,
    /// Wavefront OBJ: meshes with quads.
    Obj,
    /// Binary STL: 3D printing.
    Stl,
}

impl Format {
    /// Every format.
    pub const ALL: [Self; 9] =
        [Self::Step, Self::Dxf, Self::Svg, Self::Csv, Self::Json, Self::Png, Self::Glb, Self::Obj, Self::Stl];

    /// The suffixes that are understood, for messages.
    pub const SUFFIXES: &'static str = ".step .stp .dxf .svg .csv .json .png .glb .obj .stl";

    /// Lower-case name, as in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Dxf => "dxf",
            Self::Svg => "svg",
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Png => "png",
            Self::Glb => "glb",
            Self::Obj => "obj",
            Self::Stl => "stl",
        }
    }

    /// The name that people use, for messages.
    pub(crate) const fn title(self) -> &'static str {
        match self {
            Self::Step => "STEP",
            Self::Dxf => "DXF",
            Self::Svg => "SVG",
            Self::Csv => "CSV",
            Self::Json => "JSON",
            Self::Png => "PNG",
            Self::Glb => "GLB",
            Self::Obj => "OBJ",
            Self::Stl => "STL",
        }
    }

    /// The kind of objects that the format cannot hold.
    pub(crate) const fn lacks(self) -> Option<Kind> {
        match self {
            Self::Dxf | Self::Csv => Some(Kind::Surfaces),
            Self::Stl => Some(Kind::Curves),
            Self::Step | Self::Json | Self::Svg | Self::Png | Self::Glb | Self::Obj => None,
        }
    }

    /// True if surfaces stand in it by their exact form, or by exact lines of it.
    pub(crate) const fn holds_exact_only(self) -> bool {
        matches!(self, Self::Step | Self::Json | Self::Svg)
    }

    /// True if the file holds geometry that can be read back (everything but the picture).
    #[must_use]
    pub const fn has_geometry(self) -> bool {
        !matches!(self, Self::Png)
    }

    /// The format that a file's suffix stands for, upper or lower case.
    ///
    /// # Errors
    /// [`ExportError::UnknownSuffix`].
    ///
    /// ```
    /// use cyclide_io::Format;
    /// assert_eq!(Format::from_path("logo.STP".as_ref()).unwrap(), Format::Step);
    /// assert!(Format::from_path("logo.iges".as_ref()).unwrap_err().to_string().contains(".step"));
    /// ```
    pub fn from_path(path: &Path) -> Result<Self, ExportError> {
        let suffix = path.extension().map(|s| s.to_string_lossy().to_lowercase()).unwrap_or_default();
        match suffix.as_str() {
            "step" | "stp" => Ok(Self::Step),
            "dxf" => Ok(Self::Dxf),
            "svg" => Ok(Self::Svg),
            "csv" => Ok(Self::Csv),
            "json" => Ok(Self::Json),
            "png" => Ok(Self::Png),
            "glb" => Ok(Self::Glb),
            "obj" => Ok(Self::Obj),
            "stl" => Ok(Self::Stl),
            other => {
                let (path, known) = (path.to_path_buf(), Self::SUFFIXES);
                Err(ExportError::UnknownSuffix { path, known, hint: in_place_of(other) })
            }
        }
    }
}

/// What to write in the place of a format that is not written, or the suffix that was meant.
fn in_place_of(suffix: &str) -> String {
    let known = || Format::SUFFIXES.split(' ').map(|known| known.trim_start_matches('.'));
    let place = match suffix {
        "iges" | "igs" | "x_t" | "x_b" | "sat" | "brep" | "brp" | "fcstd" | "sldprt" | "ipt" | "3dm" | "f3d" => {
            ".step carries curves and surfaces to CAD"
        }
        "dwg" => ".dxf is what programs that read DWG read too",
        "pdf" | "eps" | "ps" | "ai" => ".svg is a drawing at true size, to print or convert",
        "jpg" | "jpeg" | "webp" | "gif" | "bmp" | "tif" | "tiff" => ".png is a picture",
        "gltf" => ".glb is the same in one file",
        "3mf" | "ply" | "off" | "fbx" | "dae" | "usd" | "usdz" => ".glb, .obj and .stl are meshes",
        "nc" | "ngc" | "tap" | "gcode" | "cnc" => ".dxf holds arcs, from which CAM makes the machine's code",
        "txt" | "tsv" | "xyz" | "dat" | "asc" => ".csv is a list of points",
        _ => return did_you_mean(suffix, known()),
    };
    format!("; {place}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_suffix_is_answered_with_one_that_serves() {
        for (path, hint) in [
            ("a.iges", "; .step carries curves and surfaces to CAD"),
            ("a.PDF", "; .svg is a drawing at true size, to print or convert"),
            ("a.setp", "; did you mean `step` or `stp`?"),
            ("a.dfx", "; did you mean `dxf`?"),
            ("a.nc", "; .dxf holds arcs, from which CAM makes the machine's code"),
            ("a", ""),
            ("a.qqqq", ""),
        ] {
            let message = Format::from_path(Path::new(path)).unwrap_err().to_string();
            assert!(message.ends_with(&format!(".glb .obj .stl{hint}")), "{message}");
        }
    }
}
