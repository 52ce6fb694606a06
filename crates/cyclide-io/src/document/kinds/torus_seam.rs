//! A raised or sunk seam along a curve on a torus.

use cyclide::{ShortNumber, construct::TorusSeam, model::SurfaceObject, topology::Body};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape, main_field, of};
use crate::error::Result;

/// Distance within which the edges of a seam follow its curve where nothing is said, as part of its width.
const SEAM: f64 = 1e-3;

/// A solid with a rectangular section along a curve on a torus: a raised seam to be fused to the torus, or a sunk one
/// to be cut from it.
///
/// Let it reach into the torus by more than `width²/(8 b)`, with the radius `b` of the tube: that is how far the tube
/// curves away. The seam has small creases where the curvature of the curve jumps.
///
/// Where the curve bends more sharply than half the width the seam would fold: it is rejected with the largest width
/// and the location (`seam-too-wide`). A seam is also rejected if parts of it that are not neighbors overlap
/// (`seam-meets-itself`, with the location); all others are proved disjoint, up to the tolerance. Seams of different
/// contours that overlap are reported by a warning (`seams-meet`).
///
/// For a round bead use a `pipe` about the curve, with a `tolerance`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [1, 1]}, "s": {"type": "torus-seam", "of": "k", "width": 3, "height": [-1, 1], "tolerance": 0.1}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[1].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct TorusSeamSpec {
    /// The word `torus-seam`.
    #[schemars(with = "String", extend("const" = "torus-seam"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `torus-spline`, `torus-knot`, `torus-quartic` or `torus-circle`, which may be construction geometry.
    pub of: String,
    /// Width across the curve.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub width: f64,
    /// The two limits of the seam along the outward normal of the torus: negative below the surface.
    pub height: [f64; 2],
    /// Distance within which the edges follow the curve. Default: a thousandth of the width.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

impl Kind for TorusSeamSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.torus_seam(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn fields(&self) -> FieldNames {
        main_field("of")
    }
}

impl Builder<'_> {
    /// Raised or sunk seams.
    pub(in crate::document) fn torus_seam(&mut self, spec: &TorusSeamSpec) -> Result<Vec<SurfaceObject>> {
        let splines = self.splines_of_source("has a seam along it")?;
        let tolerance = spec.tolerance.unwrap_or(SEAM * spec.width);
        let refused = |e: cyclide::Error| self.refused(&e, None);
        let seam = TorusSeam::new(spec.width, spec.height).map_err(refused)?;
        let bodies: cyclide::Result<Vec<Body>> = splines.iter().map(|spline| seam.body(spline, tolerance)).collect();
        let bodies = bodies.map_err(refused)?;
        if let Some(([first, second], point)) = seam.first_meeting(&splines, tolerance).map_err(refused)? {
            let [x, y, z] = point.to_array().map(ShortNumber);
            let message = format!(
                "the seams of contours {first} and {second} intersect at {x}, {y}, {z}: they are separate bodies, and volume and area count their intersection twice; fuse them in CAD"
            );
            let place = self.place_of([Step::from("width")]);
            self.remark("seams-meet", Some(second), None, place, message);
        }
        Ok(bodies.into_iter().map(SurfaceObject::Body).collect())
    }
}
