//! The front door of the writers: a model in, the bytes of a file out, with what was kept and what was promised.

use crate::deviation::MeshPlan;
use crate::format::Format;
use crate::{csv_samples, dxf, glb, nurbs_json, obj, png, step, stl, svg};
use cyclide::{Arc, Exactness, Model, ShortNumber};
use std::path::PathBuf;

pub(crate) use crate::job::{Contour, Job, contours, default_tolerance};

/// Why a file could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The suffix stands for no known format.
    #[error("{}: no format for this suffix; known are {known}", path.display())]
    UnknownSuffix {
        /// The file's path.
        path: PathBuf,
        /// The suffixes that are known.
        known: &'static str,
    },
    /// The model has no curve and no surface.
    #[error("there is nothing to write")]
    Empty,
    /// The tolerance is not a positive number.
    #[error("the tolerance {} is not positive", ShortNumber(*.tolerance))]
    ToleranceNotPositive {
        /// The tolerance given.
        tolerance: f64,
    },
    /// Coordinates are too large for the formats' arithmetic.
    #[error("object {object}: coordinate {} is beyond {}", ShortNumber(*.value), ShortNumber(*.limit))]
    TooLarge {
        /// Name of the object.
        object: String,
        /// Largest coordinate found.
        value: f64,
        /// Largest one accepted.
        limit: f64,
    },
    /// The curve has no form of the kind that the format needs.
    #[error("object {object}, contour {contour}: {source}")]
    Lowering {
        /// Name of the object.
        object: String,
        /// Which of its contours, from 0.
        contour: usize,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// The format cannot express this.
    #[error("object {object}: {format} cannot hold this: {detail}")]
    NotInFormat {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
        /// What cannot be expressed.
        detail: &'static str,
    },
    /// The format's numbers are rounded by more than the tolerance.
    #[error(
        "object {object}: {format} rounds coordinates of up to {} by {}, more than the tolerance {}: {hint}",
        ShortNumber(*.largest), ShortNumber(*.rounding), ShortNumber(*.tolerance)
    )]
    Rounding {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
        /// Largest coordinate.
        largest: f64,
        /// How far a vertex moves.
        rounding: f64,
        /// The tolerance.
        tolerance: f64,
        /// What to do instead.
        hint: &'static str,
    },
    /// The picture could not be encoded.
    #[error("the picture could not be encoded: {detail}")]
    Picture {
        /// What the encoder said.
        detail: String,
    },
}

impl ExportError {
    /// Stable kebab-case name of the reason; the kernel's own where a curve could not be lowered.
    #[must_use]
    pub fn reason(&self) -> &'static str {
        match self {
            Self::UnknownSuffix { .. } => "unknown-suffix",
            Self::Empty => "empty-model",
            Self::ToleranceNotPositive { .. } => "tolerance-not-positive",
            Self::TooLarge { .. } => "coordinate-too-large",
            Self::Lowering { source, .. } => source.reason(),
            Self::NotInFormat { .. } => "not-in-format",
            Self::Rounding { .. } => "rounding-above-tolerance",
            Self::Picture { .. } => "picture",
        }
    }
}

/// Which DXF.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DxfVersion {
    /// AC1015: LWPOLYLINE, SPLINE, groups. The default.
    #[default]
    R2000,
    /// AC1009: POLYLINE, for old machines; no splines.
    R12,
}

/// The curves of the edges between faces in STEP.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StepEdges {
    /// `CIRCLE` and `LINE`: CAD systems show radii and centres. The default.
    #[default]
    Circles,
    /// Rational B-splines in the parameter of the faces: readers find exact parameter curves.
    Rational,
}

/// What may be chosen about a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ExportOptions {
    /// Largest distance between the file's curve or mesh and the object where the format needs an approximation, in
    /// model units; `None` is 1e-5 of the model's diagonal for curves and 1e-4 for meshes.
    pub tolerance: Option<f64>,
    /// Name of the model, for formats that have a place for it; `None` is the name of the only object, or
    /// `cyclide`.
    pub title: Option<String>,
    /// DXF: rational curves as exact SPLINE entities instead of arcs within the tolerance. Many readers that cut
    /// or draw ignore the weights of a SPLINE; CAD systems do not.
    pub dxf_splines: bool,
    /// DXF: the version.
    pub dxf_version: DxfVersion,
    /// GLB: draw the edges of the patches as lines on their mesh.
    pub glb_edges: bool,
    /// STEP: the curves of the edges between faces.
    pub step_edges: StepEdges,
    /// SVG: draw the curvature comb.
    pub svg_comb: bool,
    /// SVG: draw the joints of the curves as dots.
    pub svg_points: bool,
    /// PNG: leave out the curvature comb.
    pub png_plain: bool,
}

/// A file's content with the promises that hold for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// True if the file's curves are the objects' curves up to the rounding of the numbers.
    pub exact: bool,
    /// Promised bound on the distance between the file's curve and the object, model units; 0 if exact.
    pub bound: f64,
    /// Remarks for the user, one sentence each.
    pub notes: Vec<String>,
    /// What the polygons of a mesh stand for: what the file is checked against.
    pub(crate) mesh: MeshPlan,
    /// What the lines of surfaces in a drawing stand for, in file order: what the file is checked against.
    pub(crate) lines: Vec<Arc>,
}

/// Makes the content of a file. The same model and options give the same bytes.
///
/// # Errors
/// [`ExportError`], naming the object and contour at fault.
pub fn export(model: &Model, format: Format, options: &ExportOptions) -> Result<Exported, ExportError> {
    let job = Job::new(model, options)?;
    let left_out = job.left_out(format)?;
    let file = match format {
        Format::Step => step::write(&job),
        Format::Dxf => dxf::write(&job),
        Format::Svg => svg::write(&job),
        Format::Csv => csv_samples::write(&job),
        Format::Json => nurbs_json::write(&job),
        Format::Png => png::write(&job),
        Format::Glb => glb::write(&job),
        Format::Obj => obj::write(&job),
        Format::Stl => stl::write(&job),
    };
    let mut file = file?;
    file.notes.extend(left_out);
    Ok(file)
}

/// Collects the bound over the contours of a file.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Promise {
    bound: Option<f64>,
}

impl Promise {
    pub(crate) const EXACT: Self = Self { bound: None };

    pub(crate) fn add(&mut self, exactness: Exactness) {
        if let Exactness::Within(bound) = exactness {
            self.bound = Some(self.bound.map_or(bound, |b| b.max(bound)));
        }
    }

    /// The finished file under this promise.
    pub(crate) fn exported(self, bytes: Vec<u8>, notes: Vec<String>) -> Exported {
        self.exported_mesh(bytes, notes, MeshPlan::default())
    }

    /// The finished file of a mesh format.
    pub(crate) fn exported_mesh(self, bytes: Vec<u8>, notes: Vec<String>, mesh: MeshPlan) -> Exported {
        Exported {
            bytes,
            exact: self.bound.is_none(),
            bound: self.bound.unwrap_or(0.0),
            notes,
            mesh,
            lines: Vec::new(),
        }
    }
}

/// Smallest swept angle that drawings and polylines keep as an arc. Readers find the circle from the chord and a
/// radius or bulge: below, they would lose more digits than the arc's sagitta has.
const SMALLEST_SWEEP: f64 = 5e-8;

/// What is lost if the arc is written as its chord, for arcs that have to be; `None` for arcs that stay arcs.
pub(crate) fn straightened(arc: &Arc) -> Option<Exactness> {
    if arc.is_straight() {
        return Some(Exactness::Exact);
    }
    if arc.angle() >= SMALLEST_SWEEP {
        return None;
    }
    let sagitta = 0.5 * arc.chord().length() * arc.bulge_vector().length();
    let rounding = f64::EPSILON * arc.start().to_vec().max_abs().max(arc.end().to_vec().max_abs());
    Some(if sagitta > rounding { Exactness::Within(sagitta) } else { Exactness::Exact })
}
