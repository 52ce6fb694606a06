//! A block between cyclides that intersect at right angles.

use cyclide::{
    Point3,
    error::{ErrorItem, NumberError, PointError},
    volume::{CyclideVolume, SphericalCube},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::cells::CellsSpec;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::frame::{FrameSpec, volume_frame};
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Shape};
use crate::error::{Error, Result};

/// How far a last corner that is given may be from the one that follows, relative to the size.
const LAST_CORNER: f64 = 1e-9;

/// Rounding of the eight corners together, relative to the largest coordinate: a side turns by that over its length, and what follows with it.
const CORNERS_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A block whose six faces are patches of Dupin cyclides, as are all surfaces on which one of its three parameters is
/// constant. These surfaces intersect at right angles everywhere.
///
/// ```
/// use cyclide_io::Document;
/// let corners = "[[0,0,0], [1,0.2,-0.1], [-0.2,1,0.1], [0.1,-0.1,0.9]]";
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"b": {{"type": "cyclide-volume", "corners": {corners}}}}}}}"#);
/// let built = text.parse::<Document>()?.build()?;
/// assert!(built[0].item.volumes().len() == 1 && built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CyclideVolumeSpec {
    /// The word `cyclide-volume`.
    #[schemars(with = "String", extend("const" = "cyclide-volume"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Eight corners at (s, t, u) = 000, 100, 010, 110, 001, 101, 011, 111, the four of each face on one circle; the
    /// last one follows from the others and may be omitted. Or four corners: the first and its neighbors along s, t
    /// and u; the others are then determined automatically.
    #[schemars(length(min = 4, max = 8))]
    pub corners: Vec<Coordinates>,
    /// With four corners: position of the last corner among the three neighbors of the first, as their positive
    /// weights. Default: the squared lengths of the three sides, which give a cuboid if the sides are perpendicular.
    #[schemars(inner(range(min = 0.0)))]
    pub inside: Option<[f64; 3]>,
    /// With four corners: how far the corners between the neighbors are turned within the possible range, from 0 to 1.
    /// Default 0.5.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub turn: Option<f64>,
    /// Directions of increasing s and t at the first corner, perpendicular and of any length; that of u is
    /// perpendicular to both, on the side of the third side. Default: `"auto"`, the frame nearest to the three sides,
    /// the more so the shorter they are, or one that makes more sides straight.
    #[serde(default)]
    pub frame: FrameSpec,
    /// How the block is divided into cells, for VTU cells, `report` and `sample`.
    pub cells: Option<CellsSpec>,
}

impl Kind for CyclideVolumeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let volumes = vec![at.block(self)?];
        at.divided(volumes, self.cells.as_ref(), "frame")
    }
}

impl Builder<'_> {
    /// An order of the corners of a block of which the first coincides with another, in which it is made.
    pub(in crate::document) fn order_of_corners(corners: &[Point3]) -> Option<String> {
        // Turns about the third direction, about the first, and about the second.
        const TURNS: [[usize; 8]; 6] = [
            [1, 3, 0, 2, 5, 7, 4, 6],
            [3, 2, 1, 0, 7, 6, 5, 4],
            [4, 5, 0, 1, 6, 7, 2, 3],
            [6, 7, 4, 5, 2, 3, 0, 1],
            [4, 0, 6, 2, 5, 1, 7, 3],
            [5, 4, 7, 6, 1, 0, 3, 2],
        ];
        let corners: [Point3; 8] = corners.try_into().ok()?;
        let builds = |turn: &[usize; 8]| {
            let [a, b, c, d, e, f, g, _] = turn.map(|k| corners[k]);
            SphericalCube::new([a, b, c, d, e, f, g]).is_ok()
        };
        let turn = TURNS.iter().find(|turn| builds(turn))?;
        let order = turn.map(|k| k.to_string()).join(", ");
        Some(format!(
            "; corners on the axis of a wedge are listed twice, but the first corner must not be one of them: list the corners in the order {order}"
        ))
    }

    /// The block.
    pub(in crate::document) fn block(&self, spec: &CyclideVolumeSpec) -> Result<CyclideVolume> {
        let corners: Vec<Point3> = spec.corners.iter().map(|c| c.point()).collect();
        let for_four = [("inside", spec.inside.is_some()), ("turn", spec.turn.is_some())];
        if let Some((field, _)) = for_four.into_iter().find(|(_, given)| *given && corners.len() != 4) {
            return Err(
                self.unfit(&format!("`{field}` requires four corners: seven or eight corners determine the block"))
            );
        }
        let refused = |e: cyclide::Error| self.refused(&e, None);
        let cube = match *corners.as_slice() {
            [a0, a1, a2, a3] => {
                // Those of the last corner of a cuboid, if the sides are those of one.
                let squared = |a: Point3| Some((a - a0).length_squared()).filter(|squared| *squared > 0.0);
                // Points that coincide are named by the constructor.
                let of_cuboid = || [a1, a2, a3].map(|a| squared(a).unwrap_or(1.0));
                let (inside, turn) = (spec.inside.unwrap_or_else(of_cuboid), spec.turn.unwrap_or(0.5));
                let made = SphericalCube::from_barycentric([a0, a1, a2, a3], inside, turn);
                made.map_err(|e| self.refused_inside(spec.inside, &e).unwrap_or_else(|| refused(e)))?
            }
            [a, b, c, d, e, f, g] => SphericalCube::new([a, b, c, d, e, f, g]).map_err(refused)?,
            [a, b, c, d, e, f, g, last] => {
                let cube = SphericalCube::new([a, b, c, d, e, f, g]).map_err(|e| match e {
                    cyclide::Error::Point(PointError::CoincidentPoints { .. }) => {
                        match Self::order_of_corners(&corners) {
                            Some(remedy) => {
                                self.refused_in_words([Step::from("corners")], e.reason(), format!("{e}{remedy}"))
                            }
                            None => refused(e),
                        }
                    }
                    e => refused(e),
                })?;
                let follows = cube.corners()[7];
                let size = cube.corners().iter().map(|p| p.distance(a)).fold(0.0, f64::max);
                let distance = follows.distance(last);
                if !(distance <= LAST_CORNER * size + rounding_of_last(&cube, size)) {
                    let [x, y, z] = follows.to_array();
                    let words = format!(
                        "the last corner is {distance:.3e} from ({x}, {y}, {z}), the only point on the circles of its three faces: remove it"
                    );
                    let place = [Step::from("corners"), Step::from(7)];
                    return Err(self.refused_in_words(place, "not-concircular", words));
                }
                cube
            }
            _ => return Err(self.unfit("`corners` must be 4, 7 or 8 points")),
        };
        let made = CyclideVolume::new(&cube, volume_frame(spec.frame));
        made.map_err(|e| self.refused_frame(spec.frame, &e).unwrap_or_else(|| refused(e)))
    }

    /// What is wrong with `inside`, if it is that.
    fn refused_inside(&self, inside: Option<[f64; 3]>, error: &cyclide::Error) -> Option<Error> {
        let (Some(inside), cyclide::Error::Number(NumberError::ParameterOutOfRange { name: ErrorItem::Position, .. })) =
            (inside, error)
        else {
            return None;
        };
        let field = Step::from("inside");
        let Some(k) = inside.iter().position(|weight| !(*weight > 0.0)) else {
            return Some(self.refused_in_words(
                [field],
                error.reason(),
                "the sum of the weights is too large".to_owned(),
            ));
        };
        let words = format!("the weights that determine the last corner must be positive, and {} is not", inside[k]);
        Some(self.refused_in_words([field, Step::from(k)], error.reason(), words))
    }
}

/// How far rounding of the corners moves the last one.
fn rounding_of_last(cube: &SphericalCube, size: f64) -> f64 {
    let corners = cube.corners();
    let place = corners.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    let sides = (0..3).flat_map(|axis| (0..8).filter(move |k| k >> axis & 1 == 0).map(move |k| (k, k | 1 << axis)));
    let lengths = sides.map(|(from, to)| corners[from].distance(corners[to]));
    // Sides of one point turn nothing.
    let shortest = lengths.filter(|length| *length > LAST_CORNER * size).fold(size, f64::min);
    CORNERS_ROUNDING * place * (size / shortest)
}
