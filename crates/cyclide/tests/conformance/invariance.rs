//! The same points, scaled by a power of two or run through backwards, have the same figures, for every curve type.

use crate::each;
use cyclide::{
    CurveJet, Point3,
    curve::{ParamCurve, PieceHull, extreme_curvature, fairness, length, plane_normal, wavering},
};

/// A curve times a power of two.
#[derive(Debug)]
struct Scaled<'a>(&'a dyn ParamCurve, f64);

impl ParamCurve for Scaled<'_> {
    fn piece_count(&self) -> usize {
        self.0.piece_count()
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        let CurveJet { point, d1, d2, d3 } = self.0.piece_jet(piece, s);
        let [d1, d2, d3] = [d1, d2, d3].map(|d| d * self.1);
        CurveJet { point: Point3::ORIGIN + point.to_vec() * self.1, d1, d2, d3 }
    }
    // None of the measures below asks for it.
    fn piece_hull(&self, piece: usize, tolerance: f64) -> cyclide::Result<PieceHull> {
        self.0.piece_hull(piece, tolerance)
    }
    fn is_closed(&self) -> bool {
        self.0.is_closed()
    }
}

/// A curve from its end to its start.
#[derive(Debug)]
struct Backwards<'a>(&'a dyn ParamCurve);

impl ParamCurve for Backwards<'_> {
    fn piece_count(&self) -> usize {
        self.0.piece_count()
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        let CurveJet { point, d1, d2, d3 } = self.0.piece_jet(self.0.piece_count() - 1 - piece, 1.0 - s);
        CurveJet { point, d1: -d1, d2, d3: -d3 }
    }
    fn piece_hull(&self, piece: usize, tolerance: f64) -> cyclide::Result<PieceHull> {
        self.0.piece_hull(piece, tolerance)
    }
    fn is_closed(&self) -> bool {
        self.0.is_closed()
    }
}

/// Lengths and curvatures to 1e-9 of themselves; the counts are the same.
fn check(name: &str, curve: &dyn ParamCurve, twin: &dyn ParamCurve, factor: f64) {
    let near = |what: &str, a: f64, b: f64, tolerance: f64| {
        assert!((a - b).abs() <= tolerance * a.abs(), "{name}, {what}: {a} and {b}");
    };
    near("length", length(curve), length(twin) / factor, 1e-9);
    near("curvature", extreme_curvature(curve).max, extreme_curvature(twin).max * factor, 1e-6);
    let (a, b) = (fairness(curve), fairness(twin));
    assert_eq!(
        (a.sign_changes, a.extrema, a.jumps, a.corners),
        (b.sign_changes, b.extrema, b.jumps, b.corners),
        "{name}"
    );
    let (a, b) = (wavering(curve), wavering(twin));
    assert_eq!((a.curve, a.data, a.explained, a.nodes), (b.curve, b.data, b.explained, b.nodes), "{name}");
    assert_eq!(plane_normal(curve).is_some(), plane_normal(twin).is_some(), "{name}");
}

#[test]
fn figures_scale_and_do_not_depend_on_the_direction() {
    each(|case, curve| {
        // The list has each curve at three sizes itself.
        if case.name.ends_with("e-6") || case.name.ends_with("e6") {
            return;
        }
        for power in [-120, -3, 200] {
            let factor = 2_f64.powi(power);
            check(&format!("{} times 2^{power}", case.name), curve, &Scaled(curve, factor), factor);
        }
        check(&format!("{} backwards", case.name), curve, &Backwards(curve), 1.0);
    });
}
