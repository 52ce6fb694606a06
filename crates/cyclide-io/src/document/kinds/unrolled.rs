//! A curve on a torus, laid flat.

use cyclide::{
    construct::{TorusMap, UnrollOptions},
    curve::ArcPath,
    model::CurveObject,
    surface::Torus,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::facts::{Facts, UnrolledPlane};
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape, of};
use crate::error::Result;

/// Distance within which arcs stand for a curve that is laid flat where nothing is said, as part of the width of the plane.
const FLAT: f64 = 1e-5;

/// A curve on a torus, laid flat: the torus is cut along a parallel and a meridian and unrolled to a rectangle in the
/// plane z = 0. Lines end where the curve crosses the cuts.
///
/// A torus cannot be laid flat without stretching: the report gives the least and the largest factor along the curve,
/// and both lengths. The result consists of arcs, so DXF and SVG are exact.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"k": {"type": "torus-knot", "torus": {"major_radius": 40, "minor_radius": 15}, "turns": [1, 1]}, "u": {"type": "unrolled", "of": "k"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[1].item.curves()[0].as_curve().point(0.4).z == 0.0);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct UnrolledSpec {
    /// The word `unrolled`.
    #[schemars(with = "String", extend("const" = "unrolled"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `torus-spline`, `torus-knot`, `torus-quartic` or `torus-circle`, which may be construction geometry.
    pub of: String,
    /// How the torus is laid flat.
    #[serde(default)]
    pub map: TorusMap,
    /// Longitude and meridian angle of the cuts. Default: longitude 0, and the inner side (half a turn).
    pub seam: Option<[Angle; 2]>,
    /// Distance within which arcs replace the curve in the plane. Default: a hundred-thousandth of the width of the
    /// plane.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// Adds the rectangle of the unrolled torus. Lines end at its sides where the curve crosses the cuts
    /// (`cut-at-seam`).
    #[serde(default)]
    pub border: bool,
}

impl Kind for UnrolledSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.unrolled(self).map(Shape::plain)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn fields(&self) -> FieldNames {
        vec![("angle[]", "seam")]
    }
}

impl Builder<'_> {
    /// Curves of a torus laid flat.
    pub(in crate::document) fn unrolled(&mut self, spec: &UnrolledSpec) -> Result<Vec<CurveObject>> {
        let splines = self.splines_of_source("can be unrolled with its torus")?;
        let torus = *splines[0].torus();
        let size = spec.map.size(&torus);
        let mut options = UnrollOptions::new(spec.tolerance.unwrap_or(FLAT * size[0]));
        options.map = spec.map;
        options.seam = spec.seam.map_or(options.seam, |seam| seam.map(Angle::turn));
        let mut plane = UnrolledPlane {
            map: spec.map,
            size,
            cuts: 0,
            stretch: [f64::INFINITY, 0.0],
            lengths: [0.0; 2],
            tolerance: options.tolerance,
        };
        let mut curves = Vec::new();
        for spline in &splines {
            let flat = spline.unroll(&options).map_err(|e| self.refused(&e, None))?;
            plane.cuts += flat.cuts;
            plane.stretch = [plane.stretch[0].min(flat.stretch[0]), plane.stretch[1].max(flat.stretch[1])];
            plane.lengths = [plane.lengths[0] + flat.lengths[0], plane.lengths[1] + flat.lengths[1]];
            curves.extend(flat.lines.into_iter().map(CurveObject::ArcPath));
        }
        if plane.cuts > 0 {
            let (cuts, lines) = (plane.cuts, curves.len());
            let counted = |count: usize, one: &str, more: &str| {
                if count == 1 { one.to_owned() } else { format!("{count} {more}") }
            };
            let message = format!(
                "the curve crosses the cuts of the torus {} and is {} in the plane: lines end at the border",
                counted(cuts, "once", "times"),
                counted(lines, "one line", "lines")
            );
            self.remark("cut-at-seam", None, None, None, message);
        }
        if spec.border {
            curves.push(CurveObject::ArcPath(border(&torus, &options).map_err(|e| self.refused(&e, None))?));
        }
        self.facts = Facts::Unrolled(plane);
        Ok(curves)
    }
}

/// The rectangle of the unrolled torus: longitudes from the cut on, meridian angles up to it.
fn border(torus: &Torus, options: &UnrollOptions) -> cyclide::Result<ArcPath> {
    let [width, height] = options.map.size(torus);
    let corner = options.map.point(torus, torus.place_of_angles(options.seam[0], options.seam[1]));
    let corners = [[0.0, -height], [width, -height], [width, 0.0], [0.0, 0.0]];
    let points = corners.map(|[x, y]| cyclide::Point3::new(corner.x + x, corner.y + y, 0.0));
    ArcPath::rounded_polyline(&points, true, &[0.0; 4])
}
