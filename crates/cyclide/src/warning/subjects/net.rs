//! Warnings about nets of patches, their offsets, and swept surfaces.

use crate::shape_change::degrees;
use crate::short_number::ShortNumber;
use crate::table::table;

table! {
    /// Warnings about nets of patches, their offsets, and swept surfaces.
    ///
    /// ```
    /// use cyclide::{Warning, warning::NetWarning};
    /// let warning: Warning = NetWarning::SweptSurfaceFolds { count: 2, face: 2, borders: 2 }.into();
    /// assert_eq!(warning.reason(), "swept-surface-folds");
    /// ```
    pub enum NetWarning {
        /// Opposite borders of an open net nearly coincide, as on a tube that was cut open.
        OpenSeam {
            /// What the borders are: `column` (s = 0 and s = 1) or `row` (t = 0 and t = 1).
            border: &'static str,
            /// Largest distance of a point of one border from the other one.
            gap: f64,
            /// Largest angle between the normals there, radians.
            angle: f64,
        }
        reason "open-seam";
        says "the first and the last {border} of the grid are at most an edge apart, but the net is open there: the \
            surface has a gap of up to {gap} and an angle of up to {} degrees", degrees(*angle);

        /// An offset beyond centers of curvature of its surface: lines run backwards there.
        BeyondFocalSet {
            /// The distance of the offset.
            distance: f64,
            /// The smallest radius of curvature towards that side.
            radius: f64,
            /// The first patch with a smaller radius than the distance.
            first: usize,
            /// How many there are.
            count: usize,
        }
        reason "beyond-focal-set";
        at *first;
        says "the offset by {distance} goes beyond the focal set on {count} patch(es), the first is patch {first}: \
            the surface has radii of curvature down to {} on that side, and its lines run backwards beyond them; use \
            a smaller distance", ShortNumber(rounded_down(*radius));

        /// The frame of a net does not suit its grid: lines shrink to a point inside patches, or neighbors fold over.
        Folded {
            /// Patches inside which a parameter line shrinks to a point.
            singular: usize,
            /// The first of them, s fastest.
            first: Option<usize>,
            /// Inner edges at which the normals differ by more than a thousandth of a radian.
            creases: usize,
            /// Largest angle there, radians.
            angle: f64,
        }
        reason "folded-net";
        at *first;
        says "{}: the frame does not suit the grid; use another frame", folds(*singular, *first, *creases, *angle);

        /// The curve of a swept surface moves along itself: the surface folds back there, with an edge at the fold.
        SweptSurfaceFolds {
            /// Faces in which it folds, or at whose border to the previous face.
            count: usize,
            /// The first of them.
            face: usize,
            /// How many of them fold only at their border.
            borders: usize,
        }
        reason "swept-surface-folds";
        at *face;
        when *borders == 0, says "the surface folds back in {count} face(s), the first is face {face}: the curve \
            moves along itself there";
        says "the surface folds back in {count} face(s), {borders} of them at the border to the previous face, the \
            first is face {face}: the curve moves along itself or back there, and the surface overlaps itself";
    }
}

/// Four digits of a positive value, not more than it is: so that the limit as shown can be kept.
fn rounded_down(value: f64) -> f64 {
    let unit = 10.0_f64.powf(value.log10().floor() - 3.0);
    let down = (value / unit).floor() * unit;
    if down.is_finite() && down > 0.0 { down } else { value }
}

/// The singular patches and the creases of a net.
fn folds(singular: usize, first: Option<usize>, creases: usize, angle: f64) -> String {
    let patches = first.map(|first| format!("{singular} singular patch(es), the first is quad {first}"));
    let joints =
        (creases > 0).then(|| format!("{creases} joint(s) with a crease of up to {:.1} degrees", angle.to_degrees()));
    [patches, joints].into_iter().flatten().collect::<Vec<_>>().join("; ")
}
