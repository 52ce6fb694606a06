//! The front door of the writers: a model in, the bytes of a file out, with what was kept and what was promised.

use crate::format::Format;
use crate::{csv_samples, dxf, glb, nurbs_json, obj, png, step, stl, svg};
use cyclide::{
    Aabb, Arc, ArcPath, Body, ChainPiece, CurveChain, CurveObject, Exactness, Lower, Model, ParamCurve as _, Units,
    bounds,
};
use std::path::PathBuf;

/// Tolerance when none is asked for: this part of the model's diagonal.
const DEFAULT_RELATIVE_TOLERANCE: f64 = 1e-5;

/// Largest coordinate that is written: products of two of them must not overflow.
const LARGEST_COORDINATE: f64 = 1e120;

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
    /// The model has no curve.
    #[error("there is no curve to write")]
    Empty,
    /// The tolerance is not a positive number.
    #[error("the tolerance {tolerance:e} is not positive")]
    ToleranceNotPositive {
        /// The tolerance given.
        tolerance: f64,
    },
    /// Coordinates are too large for the formats' arithmetic.
    #[error("object {object}: coordinate {value:e} is beyond {limit:e}")]
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
    #[error("object {object}: {format} cannot hold this curve: {detail}")]
    NotInFormat {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
        /// What cannot be expressed.
        detail: &'static str,
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

/// What may be chosen about a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ExportOptions {
    /// Largest distance between the file's curve and the object where the format needs an approximation, in model
    /// units; `None` is 1e-5 of the model's diagonal.
    pub tolerance: Option<f64>,
    /// Name of the model, for formats that have a place for it; `None` is the name of the only object, or
    /// `cyclide`.
    pub title: Option<String>,
    /// DXF: rational curves as exact SPLINE entities instead of arcs within the tolerance. Many readers that cut
    /// or draw ignore the weights of a SPLINE; CAD systems do not.
    pub dxf_splines: bool,
    /// DXF: the version.
    pub dxf_version: DxfVersion,
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
}

/// Makes the content of a file. The same model and options give the same bytes.
///
/// # Errors
/// [`ExportError`], naming the object and contour at fault.
pub fn export(model: &Model, format: Format, options: &ExportOptions) -> Result<Exported, ExportError> {
    let job = Job::new(model, options)?;
    match format {
        Format::Step => step::write(&job),
        Format::Dxf => dxf::write(&job),
        Format::Svg => svg::write(&job),
        Format::Csv => csv_samples::write(&job),
        Format::Json => nurbs_json::write(&job),
        Format::Png => png::write(&job),
        Format::Glb => glb::write(&job),
        Format::Obj => obj::write(&job),
        Format::Stl => stl::write(&job),
    }
}

/// The body of one surface with the object it belongs to.
pub(crate) struct BodyOf<'a> {
    /// Name of the object.
    pub(crate) object: &'a str,
    /// Index of the object in the model.
    pub(crate) item: usize,
    /// Which of the object's surfaces.
    pub(crate) index: usize,
    /// How many surfaces the object has.
    pub(crate) count: usize,
    pub(crate) body: Body,
}

impl BodyOf<'_> {
    /// The object's name, with the surface's number from 1 behind it where there are several.
    pub(crate) fn label(&self) -> String {
        if self.count == 1 { self.object.to_owned() } else { format!("{} {}", self.object, self.index + 1) }
    }
}

/// A checked request: the model, the options with the defaults filled in, and the model's size.
pub(crate) struct Job<'a> {
    pub(crate) model: &'a Model,
    pub(crate) options: &'a ExportOptions,
    pub(crate) tolerance: f64,
    /// The smallest box around all curves.
    pub(crate) bounds: Aabb,
    /// The bodies of all surfaces, in the model's order.
    pub(crate) bodies: Vec<BodyOf<'a>>,
}

/// One connected curve with the object it belongs to.
pub(crate) struct Contour<'a> {
    /// Name of the object.
    pub(crate) object: &'a str,
    /// Index of the object in the model.
    pub(crate) item: usize,
    /// Which of the object's contours.
    pub(crate) index: usize,
    /// How many contours the object has.
    pub(crate) count: usize,
    pub(crate) curve: &'a CurveObject,
}

impl Contour<'_> {
    /// The object's name, with the contour's number from 1 behind it where there are several.
    pub(crate) fn label(&self) -> String {
        if self.count == 1 { self.object.to_owned() } else { format!("{} {}", self.object, self.index + 1) }
    }

    /// A result of the kernel with the place it belongs to.
    pub(crate) fn lowered<T>(&self, result: cyclide::Result<T>) -> Result<T, ExportError> {
        result.map_err(|source| ExportError::Lowering { object: self.object.to_owned(), contour: self.index, source })
    }
}

impl<'a> Job<'a> {
    fn new(model: &'a Model, options: &'a ExportOptions) -> Result<Self, ExportError> {
        let mut total: Option<Aabb> = None;
        for contour in contours(model) {
            let own = bounds(contour.curve.as_curve());
            if !(own.max_abs() <= LARGEST_COORDINATE) {
                let object = contour.object.to_owned();
                return Err(ExportError::TooLarge { object, value: own.max_abs(), limit: LARGEST_COORDINATE });
            }
            total = Some(total.map_or(own, |b| b.union(own)));
        }
        let bodies = bodies(model)?;
        for body in &bodies {
            let vertices = body.body.shells().flat_map(|s| s.vertices().iter().copied());
            if let Some(own) = Aabb::of_points(vertices) {
                if !(own.max_abs() <= LARGEST_COORDINATE) {
                    let object = body.object.to_owned();
                    return Err(ExportError::TooLarge { object, value: own.max_abs(), limit: LARGEST_COORDINATE });
                }
                total = Some(total.map_or(own, |b| b.union(own)));
            }
        }
        let bounds = total.ok_or(ExportError::Empty)?;
        let tolerance = options.tolerance.unwrap_or_else(|| default_tolerance(bounds));
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(ExportError::ToleranceNotPositive { tolerance });
        }
        Ok(Self { model, options, tolerance, bounds, bodies })
    }

    pub(crate) fn units(&self) -> Units {
        self.model.units
    }

    /// Diagonal of the model, never zero.
    pub(crate) fn size(&self) -> f64 {
        self.bounds.diagonal().max(f64::MIN_POSITIVE)
    }

    /// The model's name: asked for, or that of the only object.
    pub(crate) fn title(&self) -> &str {
        match (&self.options.title, self.model.items.as_slice()) {
            (Some(title), _) => title,
            (None, [only]) => &only.name,
            _ => "cyclide",
        }
    }

    pub(crate) fn contours(&self) -> impl Iterator<Item = Contour<'a>> {
        contours(self.model)
    }

    /// The contour as arcs and rational splines, without pieces of no length, which no format wants.
    pub(crate) fn chain(&self, contour: &Contour<'_>) -> Result<(CurveChain, Exactness), ExportError> {
        let (chain, exactness) = contour.lowered(contour.curve.to_chain(self.tolerance))?;
        let is_point = |p: &ChainPiece| matches!(p, ChainPiece::Arc(arc) if arc.start() == arc.end());
        if !chain.pieces().iter().any(is_point) {
            return Ok((chain, exactness));
        }
        let pieces = chain.pieces().iter().filter(|p| !is_point(p)).cloned().collect();
        let chain = CurveChain::new(pieces, chain.is_closed(), 0.0);
        Ok((contour.lowered(chain)?, exactness))
    }

    /// The contour as arcs and segments, without those of no length.
    pub(crate) fn arcs(&self, contour: &Contour<'_>) -> Result<(ArcPath, Exactness), ExportError> {
        let (path, exactness) = contour.lowered(contour.curve.to_arcs(self.tolerance))?;
        if path.arcs().iter().all(|a| a.start() != a.end()) {
            return Ok((path, exactness));
        }
        let arcs = path.arcs().iter().filter(|a| a.start() != a.end()).copied().collect();
        let path = ArcPath::new(arcs, path.is_closed());
        Ok((contour.lowered(path)?, exactness))
    }
}

/// The bodies of a model's surfaces in the order in which every format writes them.
fn bodies(model: &Model) -> Result<Vec<BodyOf<'_>>, ExportError> {
    let mut bodies = Vec::new();
    for (item, it) in model.items.iter().enumerate() {
        for (index, surface) in it.surfaces.iter().enumerate() {
            let lowered = |source| ExportError::Lowering { object: it.name.clone(), contour: index, source };
            let body = surface.to_body().map_err(lowered)?;
            bodies.push(BodyOf { object: &it.name, item, index, count: it.surfaces.len(), body });
        }
    }
    Ok(bodies)
}

/// The connected curves of a model in the order in which every format writes them.
pub(crate) fn contours(model: &Model) -> impl Iterator<Item = Contour<'_>> {
    model.items.iter().enumerate().flat_map(|(item, it)| {
        let count = it.contours.len();
        let own = it.contours.iter().enumerate();
        own.map(move |(index, curve)| Contour { object: &it.name, item, index, count, curve })
    })
}

/// The tolerance that applies when none is asked for; for a model without extent that of a model of size 1.
pub(crate) fn default_tolerance(bounds: Aabb) -> f64 {
    let size = bounds.diagonal();
    DEFAULT_RELATIVE_TOLERANCE * if size > 0.0 { size } else { 1.0 }
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
        Exported { bytes, exact: self.bound.is_none(), bound: self.bound.unwrap_or(0.0), notes }
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
