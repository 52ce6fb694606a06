//! The exact certificate of one planar arc against a polyline (`docs/math/arc-fitting.md#certificate-of-one-arc`).
//!
//! Piece `P_0..P_m`, arc from `P_0` to `P_m` with center `C` and radius `R`, `u_k = P_k - C`, direction `s = ±1`:
//!
//! ```text
//! M  s (u_k x u_{k+1}) >= 0 for every edge       W  the angles of the edges sum to the sweep itself
//! V  | |u_k| - R |                               E  R - |u_k x u_{k+1}|/|e_k| where the foot of C is inside the edge
//! ```
//! Theorem: under M and W, Fréchet distance = Hausdorff distance = the largest V or E. No sampling is needed.
//!
//! In chord coordinates, with `sigma = sin(sweep/2)`, `c = cos(sweep/2)` and lengths in half chords, everything is
//! finite also for the line: `R = 1/sigma`, center `(0, c/sigma)`,
//! `|u| - R = (sigma (x²+y²-1) - 2 c y)/(hypot(sigma x, sigma y - c) + 1)`, step `sigma (p x q) + c (q_x - p_x)`.

use super::chord::{ChordFrame, mirrored};
use crate::base::planar::{Point2, Vec2};
use crate::error::{ErrorItem, NumberError, PointError, Result};
use std::f64::consts::TAU;

/// Bulges below this are lines: their squares would underflow, their sagitta is far below any coordinate's rounding.
const LINE_BULGE: f64 = 1e-150;

/// What [`certify_arc`] proves about one arc over one polyline.
///
/// ```
/// use cyclide::{Point2, construct::certify_arc};
/// let points = [[-1.0, 0.0], [0.0, -1.01], [1.0, 0.0]].map(|[x, y]| Point2::new(x, y));
/// let certificate = certify_arc(&points, 1.0, None)?;
/// assert!((certificate.vertex_deviation - 0.01).abs() < 1e-12 && certificate.monotone);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ArcCertificate {
    /// Largest distance of a vertex from the circle (V).
    pub vertex_deviation: f64,
    /// Largest of V and E: the Fréchet and Hausdorff distance of polyline and arc if [`proves`](Self::proves) holds.
    pub deviation: f64,
    /// M: no edge runs against the arc as seen from its center.
    pub monotone: bool,
    /// W: full turns the polyline makes about the center beyond the arc's own sweep; must be 0.
    pub extra_turns: i32,
    /// Radius; infinite for the line.
    pub radius: f64,
    /// Length of the arc.
    pub length: f64,
    /// Largest deviation of the heights from a helix (height linear in the angle); `None` without heights or if the
    /// polyline is not monotone.
    pub z_deviation: Option<f64>,
}

impl ArcCertificate {
    /// True if the theorem applies (M and W), so that [`deviation`](Self::deviation) is the Fréchet distance.
    #[must_use]
    pub fn proves(&self) -> bool {
        self.monotone && self.extra_turns == 0
    }
}

/// Certifies the arc with DXF bulge `tan(sweep/4)` from the first to the last point against the polyline, exactly
/// and in one pass (`docs/math/arc-fitting.md#certificate-of-one-arc`). Positive bulge: counter-clockwise. `heights`,
/// one per point, are compared with a helix.
///
/// ```
/// use cyclide::Point2;
/// // A quarter of the unit circle: its bulge is the tangent of a quarter of its angle.
/// let point = |k: i32| (0.25 * std::f64::consts::FRAC_PI_2 * f64::from(k)).sin_cos();
/// let points: Vec<Point2> = (0..=4).map(point).map(|(sin, cos)| Point2::new(cos, sin)).collect();
/// let proof = cyclide::construct::certify_arc(&points, (0.25 * std::f64::consts::FRAC_PI_2).tan(), None)?;
/// assert!(proof.proves() && proof.vertex_deviation < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `too-few-points` (fewer than 2, or another number of heights), `not-finite`, `coincident-points` (first and last
/// equal: a full circle is not one arc).
pub fn certify_arc(points: &[Point2], bulge: f64, heights: Option<&[f64]>) -> Result<ArcCertificate> {
    let frame = ChordFrame::new(points)?;
    if !bulge.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Bulge, index: 0 }.into());
    }
    if let Some(z) = heights {
        if z.len() != points.len() {
            return Err(PointError::TooFewPoints { given: z.len(), needed: points.len() }.into());
        }
        if let Some(index) = z.iter().position(|z| !z.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Height, index }.into());
        }
    }
    let b = if bulge.abs() < LINE_BULGE { 0.0 } else { bulge.abs() };
    let local = |p: &Point2| if bulge < 0.0 { mirrored(frame.local(*p)) } else { frame.local(*p) };
    let arc = UnitChordArc::new(b);

    let (mut vertex_deviation, mut deviation, mut monotone) = (0.0_f64, 0.0_f64, true);
    let mut turned = 0.0;
    let mut fractions = heights.map(|_| Vec::with_capacity(points.len()));
    let mut p = local(&points[0]);
    for (k, q) in points.iter().map(local).enumerate() {
        if k > 0 {
            monotone &= arc.step(p, q) >= 0.0;
            turned += arc.angle_fraction(p, q);
            deviation = deviation.max(arc.edge_deviation(p, q));
        }
        vertex_deviation = vertex_deviation.max(arc.radial(q).abs());
        if let Some(f) = &mut fractions {
            f.push(turned);
        }
        p = q;
    }
    let z_deviation = match (heights, fractions) {
        (Some(z), Some(f)) if monotone => {
            let (z0, rise) = (z[0], z[z.len() - 1] - z[0]);
            Some(z.iter().zip(f).map(|(z, f)| (z - z0 - rise * f).abs()).fold(0.0, f64::max))
        }
        _ => None,
    };
    Ok(ArcCertificate {
        vertex_deviation: vertex_deviation * frame.half,
        deviation: deviation.max(vertex_deviation) * frame.half,
        monotone,
        extra_turns: if b > 0.0 { ((turned - 1.0) * arc.sweep / TAU).round() as i32 } else { 0 },
        radius: frame.half / arc.sine,
        length: frame.half * if b > 0.0 { arc.sweep / arc.sine } else { 2.0 },
        z_deviation,
    })
}

/// A counter-clockwise arc from (-1, 0) to (1, 0), by the sine and cosine of half its sweep.
struct UnitChordArc {
    sine: f64,
    cosine: f64,
    sweep: f64,
}

impl UnitChordArc {
    fn new(b: f64) -> Self {
        // (1-b²)/(1+b²) and 2b/(1+b²), with 1/b for large bulges so that nothing overflows.
        let m = b.min(1.0 / b);
        let d = 1.0 + m * m;
        let cosine = (1.0 - m) * (1.0 + m) / d;
        Self { sine: 2.0 * m / d, cosine: if b > 1.0 { -cosine } else { cosine }, sweep: 4.0 * b.atan() }
    }

    /// `|u| - R` without cancellation; minus the height over the line for the line.
    fn radial(&self, p: Vec2) -> f64 {
        (self.sine * (p.dot(p) - 1.0) - 2.0 * self.cosine * p.y)
            / ((self.sine * p.x).hypot(self.sine * p.y - self.cosine) + 1.0)
    }

    /// `(u_p x u_q)/R`: nonnegative if the step runs with the arc.
    fn step(&self, p: Vec2, q: Vec2) -> f64 {
        self.sine * p.cross(q) + self.cosine * (q.x - p.x)
    }

    /// Angle of a step about the center as a fraction of the sweep; for the line the fraction of the chord.
    fn angle_fraction(&self, p: Vec2, q: Vec2) -> f64 {
        if self.sine == 0.0 {
            return 0.5 * (q.x - p.x);
        }
        let (s, c) = (self.sine, self.cosine);
        let dot = s * (s * p.dot(q) - c * (p.y + q.y)) + c * c;
        (s * self.step(p, q)).atan2(dot) / self.sweep
    }

    /// How far the edge dips inside the circle at the foot of the center, if the foot is inside the edge; else 0.
    fn edge_deviation(&self, p: Vec2, q: Vec2) -> f64 {
        let Some(e) = (q - p).unit() else { return 0.0 };
        let foot = self.cosine * e.y;
        let inside = self.sine > 0.0 && self.sine * e.dot(p) <= foot && foot <= self.sine * e.dot(q);
        if inside { -self.radial(p + e * (foot / self.sine - e.dot(p))) } else { 0.0 }
    }
}
