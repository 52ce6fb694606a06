//! What is asked of a format: its names, its suffixes, and which one a suffix stands for.

use crate::export::error::ExportError;
use crate::formats::Format;
use crate::formats::foreign::in_place_of_writing;
use crate::text::suggest::did_you_mean;
use std::path::Path;

impl Format {
    /// The supported suffixes, in lower case and without dots.
    pub fn suffixes() -> impl Iterator<Item = &'static str> {
        Self::ALL.iter().flat_map(|format| format.entry().suffixes).copied()
    }

    /// The lower-case name, as in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.entry().name
    }

    /// True if the file contains geometry that can be read back (all formats except the picture).
    #[must_use]
    pub const fn has_geometry(self) -> bool {
        self.entry().reading.is_some()
    }

    /// The usual suffix of its files, without the dot.
    pub(crate) const fn suffix(self) -> &'static str {
        self.entry().suffixes[0]
    }

    /// True if files of the format hold a geometry, which has an exact form or not.
    pub(crate) fn holds(self, geometry: &cyclide::model::Geometry, exact: bool) -> bool {
        self.entry().loses(geometry).is_none() && (exact || !self.entry().holds_exact_only)
    }

    /// The format that a suffix in lower case stands for.
    pub(crate) fn of_suffix(suffix: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|format| format.entry().suffixes.contains(&suffix))
    }

    /// The format for the suffix of a file, in upper or lower case.
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
        Self::of_suffix(&suffix).ok_or_else(|| {
            let known: Vec<String> = Self::suffixes().map(|suffix| format!(".{suffix}")).collect();
            ExportError::UnknownSuffix { path: path.to_path_buf(), known: known.join(" "), hint: hint_for(&suffix) }
        })
    }
}

/// What to write in the place of a format that is not written, or the suffix that was meant.
fn hint_for(suffix: &str) -> String {
    match in_place_of_writing(suffix) {
        Some(place) => format!("; {place}"),
        None => did_you_mean(suffix, Format::suffixes()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_suffix_that_main_returns_can_be_read() {
        let error = Box::<dyn std::error::Error>::from(Format::from_path(Path::new("a.iges")).unwrap_err());
        assert!(format!("{error:?}").ends_with("[unknown-suffix]"));
    }

    #[test]
    fn an_unknown_suffix_is_answered_with_one_that_serves() {
        for (path, hint) in [
            ("a.iges", "; .step transfers curves and surfaces to CAD"),
            ("a.PDF", "; .svg is a drawing at true size for printing or conversion"),
            ("a.setp", "; did you mean `step` or `stp`?"),
            ("a.dfx", "; did you mean `dxf`?"),
            ("a.msh", "; .vtu represents blocks exactly; .mesh (MFEM) and .xml (G+Smo) are for isogeometric analysis"),
            ("a.nc", "; .dxf contains arcs, from which CAM generates machine code"),
            ("a", ""),
            ("a.qqqq", ""),
        ] {
            let message = Format::from_path(Path::new(path)).unwrap_err().to_string();
            assert!(message.ends_with(&format!(".glb .obj .stl .ply .3mf .vtu .mesh .xml{hint}")), "{message}");
        }
    }
}
