//! Straight lines between two curves.

pub(in crate::document) mod remedies;
pub(in crate::document) mod sense;

use cyclide::{
    ShortNumber,
    construct::RailSurface,
    error::{BridgeError, PointError},
    model::SurfaceObject,
    topology::EdgeCurve,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::ruled::remedies::MOST_TRIED;
use crate::document::kinds::ruled::sense::Rulings;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Reference, Shape, main_field, rails};
use crate::error::Result;

/// Starts of a closed rail that are tried to see whether it runs the other way.
const MOST_SHIFTS: usize = 64;
/// Two outlines whose likeness from another start is larger by this are twisted: alike ones by more than 26 degrees.
const TWISTED: f64 = 0.1;
/// Curves that turn by more than this at a joint have a corner there, radians.
const CORNER: f64 = 0.3;

/// Straight lines between two curves. They connect points at equal parameters, piece by piece.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"a": {"type": "polyline", "points": [[0, 0], [5, 0]]}, "b": {"type": "polyline", "points": [[0, 2], [5, 2]]}, "s": {"type": "ruled", "rails": ["a", "b"]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[2].bodies[0].outer.area() - 10.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct RuledSpec {
    /// The word `ruled`.
    #[schemars(with = "String", extend("const" = "ruled"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Names of the two curves, which may be construction geometry. Each has one contour, and both have the same number
    /// of pieces; a whole circle is divided like the other closed curve.
    pub rails: [String; 2],
    /// For closed curves: number of pieces by which the start of the second curve is moved forward. Default 0.
    #[serde(default)]
    pub shift: usize,
}

impl Kind for RuledSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.ruled(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        rails(&self.rails)
    }

    fn fields(&self) -> FieldNames {
        main_field("rails")
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        let cyclide::Error::Point(PointError::CoincidentPoints { distance, limit, .. }) = error else { return None };
        Some(format!(
            "a piece of one curve coincides with that of the other (distance at most {}, tolerance {}): there is no surface between them",
            ShortNumber(*distance),
            ShortNumber(*limit)
        ))
    }
}

impl Builder<'_> {
    /// Straight lines between two curves.
    pub(in crate::document) fn ruled(&mut self, spec: &RuledSpec) -> Result<Vec<SurfaceObject>> {
        let ([first, second], closed) = self.pieces_of_rails()?;
        if spec.shift > 0 && !closed {
            return Err(self.unfit("`shift` requires closed curves"));
        }
        let second = rotated(&second, spec.shift);
        let made = RailSurface::ruled([&first, &second], closed).map_err(|e| match e {
            cyclide::Error::Bridge(BridgeError::RulingsCross { piece, .. }) if closed => {
                match self.start_of_rail([&first, &second], spec.shift) {
                    Some(remedy) => {
                        let words = format!("the straight lines between piece {piece} of both curves cross: {remedy}");
                        self.refused_in_words(["rails".into()], e.reason(), words)
                    }
                    None => self.refused(&e, None),
                }
            }
            e => self.refused(&e, None),
        })?;
        self.check_sense([&first, &second], closed, spec.shift)?;
        Ok(self.between(made))
    }

    /// Refuses a ruled surface that goes through itself because one curve runs the other way, and remarks curves that seem to.
    fn check_sense(&mut self, [first, second]: [&[EdgeCurve]; 2], closed: bool, shift: usize) -> Result<()> {
        if closed && let Some(remedy) = self.rail_to_reverse([first, second], shift) {
            let words = format!("the ruled surface intersects itself: {remedy}");
            return Err(self.refused_in_words(["rails".into()], "rulings-cross", words));
        }
        let given = Rulings::of([first, second], closed);
        let reversed: Vec<EdgeCurve> = second.iter().rev().map(EdgeCurve::reversed).collect();
        let shifts = if closed && given.opposite() { reversed.len().min(MOST_SHIFTS) } else { usize::from(!closed) };
        let other_way = |by: usize| Rulings::of([first, &rotated(&reversed, by)], closed);
        if (0..shifts).any(|by| given.are_longer_than(&other_way(by))) {
            let message = "the straight lines between the curves would be much shorter with the second curve reversed: \
                           if no twist is intended, list its points in reverse order, or use a `transform` of it with the steps \
                           `[\"reverse\"]`";
            self.remark("rails-opposite", None, None, self.place_of(["rails".into()]), message.to_owned());
        } else if closed && shift == 0 {
            self.remark_start([first, second], &given);
        }
        Ok(())
    }

    /// Remarks closed curves of which the second begins at another corner, so that the surface between them is twisted.
    fn remark_start(&mut self, [first, second]: [&[EdgeCurve]; 2], given: &Rulings) {
        let count = second.len();
        // Where smooth curves begin is nobody's choice, and how far they are turned is.
        if count > MOST_TRIED || given.opposite() || ![first, second].into_iter().all(has_corners) {
            return;
        }
        let likeness = |by: usize| (by, Rulings::of([first, &rotated(second, by)], true).likeness());
        let best = (1..count).map(likeness).max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((by, _)) = best.filter(|(_, best)| *best > given.likeness() + TWISTED) else { return };
        let [x, y, z] = second[by].start().to_array().map(ShortNumber);
        let message = format!(
            "the surface is twisted, since the second curve begins at another corner: if no twist is intended, let it begin {by} of its {count} pieces \
             later, at ({x}, {y}, {z}), with `\"shift\": {by}`"
        );
        self.remark("rails-twisted", None, None, self.place_of(["rails".into()]), message);
    }
}

/// Whether a closed curve turns at once somewhere.
fn has_corners(pieces: &[EdgeCurve]) -> bool {
    let ends = |before: usize| {
        let after = (before + 1) % pieces.len();
        let from = pieces[before].as_curve().piece_jet(0, 1.0).tangent();
        from.zip(pieces[after].as_curve().piece_jet(0, 0.0).tangent())
    };
    (0..pieces.len()).any(|k| ends(k).is_some_and(|(from, to)| from.angle(to) > CORNER))
}

/// The pieces of a closed curve from another one on.
pub(in crate::document) fn rotated(pieces: &[EdgeCurve], by: usize) -> Vec<EdgeCurve> {
    let mut pieces = pieces.to_vec();
    if !pieces.is_empty() {
        let count = pieces.len();
        pieces.rotate_left(by % count);
    }
    pieces
}
