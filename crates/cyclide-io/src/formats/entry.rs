//! What there is to know of a format: one entry each, which the format's own module gives.

use crate::check::deviation::Deviations;
use crate::check::file_content::FileContent;
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::Exported;
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::options::ExportOptions;
use cyclide::model::Geometry;

/// What a model consists of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Curves,
    Surfaces,
}

/// Everything that there is to know of a format.
pub(crate) struct Entry {
    /// Lower-case name, as in reports.
    pub(crate) name: &'static str,
    /// What people call it, or a file of it, for messages.
    pub(crate) title: &'static str,
    /// The suffixes of its files in lower case, the usual one first.
    pub(crate) suffixes: &'static [&'static str],
    /// The kind of objects that it cannot hold.
    pub(crate) lacks: Option<Kind>,
    /// True if it holds motions.
    pub(crate) animates: bool,
    /// True if surfaces stand in it by their exact form, or by exact lines of it.
    pub(crate) holds_exact_only: bool,
    /// The forms of curves that a file needs.
    pub(crate) forms: fn(&ExportOptions) -> Forms,
    /// Writes a model.
    pub(crate) write: fn(&Job<'_>) -> Result<Exported, ExportError>,
    /// The way back; `None` where the file holds no geometry.
    pub(crate) reading: Option<Reading>,
}

impl Entry {
    /// What of a geometry the format has no place for; `None` if it holds all of it. Empty geometry is never lost.
    pub(crate) fn loses(&self, geometry: &Geometry) -> Option<&'static str> {
        match geometry {
            Geometry::Curves(contours) if self.lacks == Some(Kind::Curves) && !contours.is_empty() => Some("curves"),
            Geometry::Grids(_) if self.lacks == Some(Kind::Curves) => Some("curves"),
            Geometry::Surfaces(surfaces) if self.lacks == Some(Kind::Surfaces) && !surfaces.is_empty() => {
                Some("surfaces")
            }
            Geometry::Volumes(volumes) if self.lacks == Some(Kind::Surfaces) && !volumes.is_empty() => Some("volumes"),
            Geometry::Motion(_) if !self.animates => Some("motions"),
            _ => None,
        }
    }
}

/// The way back from the bytes of a file.
pub(crate) struct Reading {
    /// Reads a file of ours; never panics, whatever the bytes are.
    pub(crate) read: fn(&[u8]) -> Result<FileContent, ReadError>,
    /// Reads a file and holds all that it says against its model; gives how far its parts are off.
    pub(crate) compare: fn(&Made<'_>) -> Result<Deviations, ReadError>,
    /// True if parts are written by the size of the whole model, and rounded by it.
    pub(crate) rounds_by_model: bool,
}
