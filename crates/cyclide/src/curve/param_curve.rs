//! The trait every curve implements.
//!
//! A curve is a chain of smooth (analytic) pieces. Piece `i` of `n` covers the global parameter interval
//! `[i/n, (i+1)/n]` by its own parameter `s` in `[0, 1]`, so `t = (i + s)/n`. Everything that is measured on curves
//! (length, closest point, flattening, continuity at the joints) works piece by piece on the required methods.

use super::piece_form::PieceForm;
use super::piece_hull::PieceHull;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::quadrature::integrate;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;

/// A parametric curve made of one or more smooth pieces; parameters run over `[0, 1]`.
///
/// Object-safe; the jet, the hull, the number of pieces and the closed flag are required.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Arc, Circle, ParamCurve, length}};
/// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?;
/// let segment = Arc::segment(Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0))?;
/// let curves: [&dyn ParamCurve; 2] = [&circle, &segment];
/// assert!(curves.iter().all(|curve| curve.point(0.0).distance(curve.jet(0.0).point) == 0.0 && length(*curve) > 2.9));
/// # Ok::<(), cyclide::Error>(())
/// ```
pub trait ParamCurve: std::fmt::Debug + Send + Sync {
    /// Number of smooth pieces, at least 1.
    fn piece_count(&self) -> usize;

    /// Point and derivatives of piece `piece` at its own parameter `s` in `[0, 1]`, derivatives by `s`.
    ///
    /// # Panics
    /// If `piece` is not below [`piece_count`](Self::piece_count).
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet;

    /// What proves how far the piece is from a chord: its rational parts, within `tolerance` of it at equal parameters
    /// where it has no exact ones. [`PieceHull::closed_form`] for arcs and circles.
    ///
    /// # Errors
    /// `too-many-pieces` if the tolerance asks for more rational parts than the cap.
    ///
    /// # Panics
    /// If `piece` is not below [`piece_count`](Self::piece_count).
    fn piece_hull(&self, piece: usize, tolerance: f64) -> Result<PieceHull>;

    /// True if the end joins the start: the joint of the last with the first piece is a joint like the others.
    fn is_closed(&self) -> bool;

    /// Point of a piece; override where the point alone is cheaper.
    fn piece_point(&self, piece: usize, s: f64) -> Point3 {
        self.piece_jet(piece, s).point
    }

    /// Speed `|x'|` of a piece by its own parameter; override where it is cheaper than a jet. Lengths need only this.
    fn piece_speed(&self, piece: usize, s: f64) -> f64 {
        self.piece_jet(piece, s).speed()
    }

    /// What the piece is where it has a closed form; override for arcs and circles, whose measures are then exact.
    fn piece_form(&self, _piece: usize) -> PieceForm {
        PieceForm::Free
    }

    /// Arc length of the part `[s0, s1]` of a piece, to the relative tolerance 1e-12 of the piece or better.
    fn piece_length(&self, piece: usize, s0: f64, s1: f64) -> f64 {
        integrate(&mut |s: f64| self.piece_speed(piece, s), s0, s1)
    }

    /// A box that contains the piece, not necessarily the smallest one.
    ///
    /// The default is the box of the ball about the middle of the ends with the piece's length as diameter.
    fn piece_bounds(&self, piece: usize) -> Aabb {
        let (a, b) = (self.piece_point(piece, 0.0), self.piece_point(piece, 1.0));
        let (m, r) = (a.midpoint(b), 0.5 * self.piece_length(piece, 0.0, 1.0) * (1.0 + 1e-9));
        let e = Vec3::new(r, r, r);
        Aabb { min: m - e, max: m + e }
    }

    /// The piece and its own parameter that belong to a global parameter (clamped to `[0, 1]`).
    fn locate(&self, t: f64) -> (usize, f64) {
        let n = self.piece_count();
        let x = t.clamp(0.0, 1.0) * n as f64;
        let piece = (x as usize).min(n - 1);
        (piece, x - piece as f64)
    }

    /// Point and derivatives at a global parameter in `[0, 1]`; at a joint those of the piece that starts there.
    fn jet(&self, t: f64) -> CurveJet {
        let (piece, s) = self.locate(t);
        self.piece_jet(piece, s).scaled(self.piece_count() as f64)
    }

    /// Point at a global parameter in `[0, 1]`.
    fn point(&self, t: f64) -> Point3 {
        let (piece, s) = self.locate(t);
        self.piece_point(piece, s)
    }

    /// Points at many global parameters, without allocation.
    ///
    /// # Panics
    /// If the slices differ in length.
    fn points_into(&self, ts: &[f64], out: &mut [Point3]) {
        assert_eq!(ts.len(), out.len(), "one output point per parameter");
        for (t, p) in ts.iter().zip(out) {
            *p = self.point(*t);
        }
    }

    /// Jets at many global parameters, without allocation.
    ///
    /// # Panics
    /// If the slices differ in length.
    fn jets_into(&self, ts: &[f64], out: &mut [CurveJet]) {
        assert_eq!(ts.len(), out.len(), "one output jet per parameter");
        for (t, j) in ts.iter().zip(out) {
            *j = self.jet(*t);
        }
    }
}
