//! Sweeps: a plane section led across a path of arcs and segments, by frames that do not turn about it, by an up vector, or with a twist; mitered at corners between
//! segments, and closed by plane faces where the path ends (`docs/math/sweeps.md`).
//!
//! Over an arc the frame turns with the arc, which is parallel transport: a section of degree m makes faces of degree (m, 2), over a segment (m, 1). A turn about the
//! path is a rational rotation over each leg, of degree (m, 4) and (m, 3) at most: its ends are exact, and legs are halved until it is near enough to the law between.

mod legs;
mod meeting;

use super::bands::{Bands, Ring, rows_of};
use super::carried::{Carrier, surface_of};
use super::section::{Section, sections};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ArcPath, ParamCurve as _};
use crate::error::{ErrorItem, NumberError, PointError, Result};
use crate::rational::{Polynomial, RationalBezier, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve};
use legs::{Leg, Legs, Station};

/// How a section is turned about its path.
///
/// ```
/// assert_eq!(cyclide::construct::SweepFrame::default(), cyclide::construct::SweepFrame::RotationMinimizing);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(inline, description = "How a section is turned about its path.")
)]
#[non_exhaustive]
pub enum SweepFrame {
    /// The section does not rotate about the path.
    #[default]
    RotationMinimizing,
    /// The y axis of the section points up as far as the path allows.
    Up,
}

/// How a section is swept.
///
/// ```
/// use cyclide::construct::{SweepFrame, SweepOptions};
/// let options = SweepOptions { frame: SweepFrame::Up, ..SweepOptions::default() };
/// assert!(options.capped && options.twist == 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepOptions {
    /// How it is turned about the path.
    pub frame: SweepFrame,
    /// Where the y axis of the section points at the start (with [`SweepFrame::Up`] everywhere), of any length. Where the path runs along it, the x axis of the section
    /// is that of space.
    pub up: Vec3,
    /// Turn about the path over its whole length, radians, right-handed, in proportion to the length; on a closed path the nearest number of whole turns.
    pub twist: f64,
    /// Whether closed sections are closed by plane faces at the ends of an open path.
    pub capped: bool,
    /// No point may be farther than this from that of the law of the turn; of no matter where nothing turns about the path.
    pub tolerance: f64,
}

impl Default for SweepOptions {
    /// Without a turn about the path, y of the section up (z), capped; tolerance 1e-3.
    fn default() -> Self {
        Self { frame: SweepFrame::RotationMinimizing, up: Vec3::Z, twist: 0.0, capped: true, tolerance: 1e-3 }
    }
}

/// What a plane section makes when it is led along a path.
///
/// ```
/// use cyclide::{Point3, construct::{Sweep, SweepOptions}, curve::{Arc, ArcPath}, topology::EdgeCurve};
/// let corners = [[-1.0, -2.0, 0.0], [1.0, -2.0, 0.0], [1.0, 2.0, 0.0], [-1.0, 2.0, 0.0]].map(Point3::from);
/// let side = |k: usize| Arc::segment(corners[k], corners[(k + 1) % 4]).map(EdgeCurve::from);
/// let bar = vec![side(0)?, side(1)?, side(2)?, side(3)?];
/// let path = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 20.0, 0.0]].map(Point3::from);
/// let path = ArcPath::rounded_polyline(&path, false, &[0.0; 3])?; // a corner, which is mitred
/// let sweep = Sweep::new(&[(bar, true)], &path, &SweepOptions::default())?;
/// assert!(sweep.bound() == 0.0 && (sweep.bodies()[0].outer.volume() - 8.0 * 30.0).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    bodies: Vec<Body>,
    bound: f64,
    meeting: Option<([f64; 2], Point3)>,
}

impl Sweep {
    /// Leads a section, its contours in the plane z = 0 with whether each is closed, along a path: the origin runs on it, x and y stay across it, and z points
    /// along it. Contours inside others are holes. Open contours, and closed ones that are not capped, make surfaces.
    ///
    /// # Errors
    /// `too-few-points` (no contour or an empty one), `disconnected`, `section-not-plane`, `section-meets-itself`, `weight-not-positive`; `corner-not-mitred` (a corner beside an arc, or that
    /// turns back), `mitre-does-not-fit` (a segment is too short for the section in its miters), `tube-folds` (a bend narrower than the section), `no-frame` (the path runs along the
    /// up vector, or that turns the section at a corner), `too-many-pieces`, `parameter-out-of-range`, `not-finite`.
    pub fn new(section: &[(Vec<EdgeCurve>, bool)], path: &ArcPath, options: &SweepOptions) -> Result<Self> {
        if section.is_empty() {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        }
        if !options.twist.is_finite() || !options.up.to_array().iter().all(|x| x.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index: 0 }.into());
        }
        let (value, max) = (options.tolerance, f64::INFINITY);
        if !(value > 0.0 && value.is_finite()) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Tolerance, value, min: 0.0, max }.into());
        }
        let capped = options.capped && !path.is_closed();
        let sections = sections(section, capped)?;
        let points: Vec<Point3> =
            sections.iter().flat_map(|section| section.contours.iter().flatten()).flat_map(places).collect();
        let legs = Legs::new(path, &points, options)?;
        let bodies = sections.iter().map(|section| legs.body(section)).collect::<Result<_>>()?;
        let meeting = meeting::meeting(&legs.legs, &legs.stations, legs.closed, &points);
        Ok(Self { bodies, bound: legs.bound, meeting })
    }

    /// A section that is drawn in space, across the path at its start, as [`new`](Self::new) takes it.
    ///
    /// # Errors
    /// `zero-tangent`; as [`RationalBezier::similar`].
    pub fn section_in_place(
        section: &[(Vec<EdgeCurve>, bool)],
        path: &ArcPath,
        options: &SweepOptions,
    ) -> Result<Vec<(Vec<EdgeCurve>, bool)>> {
        let first = &path.arcs()[0];
        let along = first.start_tangent().ok_or(PointError::ZeroTangent { index: 0 })?;
        let x = legs::start(along, options.up);
        let axes = [x, along.cross(x), along];
        let local = |p: Point3| {
            Point3::ORIGIN
                + axes
                    .iter()
                    .zip([Vec3::X, Vec3::Y, Vec3::Z])
                    .fold(Vec3::ZERO, |sum, (axis, unit)| sum + unit * (p - first.start()).dot(*axis))
        };
        let moved = |curve: &EdgeCurve| -> Result<EdgeCurve> {
            let (start, end) = (local(curve.start()), local(curve.end()));
            match curve {
                EdgeCurve::Arc(arc) => {
                    let ratio = arc.weight_ratio();
                    let p = ratio.vector();
                    let p = Vec3::new(p.dot(axes[0]), p.dot(axes[1]), p.dot(axes[2]));
                    Ok(Arc::from_ratio_across(start, end, Quat::from_parts(ratio.w, p))?.into())
                }
                EdgeCurve::Rational(curve) => {
                    let row = |&[x, y, z, w]: &[f64; 4]| {
                        let p = local(Point3::new(x / w, y / w, z / w)).to_vec() * w;
                        [p.x, p.y, p.z, w]
                    };
                    Ok(EdgeCurve::Rational(RationalBezier::new(curve.rows().iter().map(row).collect())?))
                }
            }
        };
        section.iter().map(|(curves, closed)| Ok((curves.iter().map(moved).collect::<Result<_>>()?, *closed))).collect()
    }

    /// The bodies, one for each area of the section and each open contour.
    #[must_use]
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The bodies, without a copy.
    #[must_use]
    pub fn into_bodies(self) -> Vec<Body> {
        self.bodies
    }

    /// Where it may run into itself: the lengths of the path before two places, and a point between, at which rectangles about the section overlap. Looked at a quarter of the
    /// reach of the section apart, beyond half a turn of it along the path.
    #[must_use]
    pub fn meeting(&self) -> Option<([f64; 2], Point3)> {
        self.meeting
    }

    /// No point is farther than this from that of the law of the turn; 0 if nothing turns about the path. Looked at in places of each leg.
    #[must_use]
    pub fn bound(&self) -> f64 {
        self.bound
    }
}

/// Points of a piece of a section by which its extents are known.
fn places(curve: &EdgeCurve) -> Vec<Point3> {
    let count = if curve.arc().is_some_and(Arc::is_straight) { 1 } else { 16 };
    (0..=count).map(|k| curve.point(f64::from(k) / f64::from(count))).collect()
}

impl Legs {
    fn body(&self, section: &Section) -> Result<Body> {
        if self.closed && section.closed && section.contours.len() > 1 {
            // Each contour is a shell of its own, those of holes inside.
            let mut shells = section.contours.iter().map(|contour| -> Result<_> {
                let mut bands = Bands::default();
                self.sides(&mut bands, contour, true)?;
                Ok(bands.finish()?.outer)
            });
            let outer = shells.next().ok_or(PointError::TooFewPoints { given: 0, needed: 1 })??;
            return Ok(Body { outer, voids: shells.map(|shell| Ok(shell?.flipped())).collect::<Result<_>>()? });
        }
        let mut bands = Bands::default();
        let rings: Vec<[Ring; 2]> = section
            .contours
            .iter()
            .map(|contour| self.sides(&mut bands, contour, section.closed))
            .collect::<Result<_>>()?;
        if let (Some(cover), false, Some(last)) = (&section.cover, self.closed, self.stations.last()) {
            let first: Vec<&Ring> = rings.iter().map(|[first, _]| first).collect();
            let end: Vec<&Ring> = rings.iter().map(|[_, end]| end).collect();
            bands.cover(cover, &first, |p| self.stations[0].place(p), false)?;
            bands.cover(cover, &end, |p| last.place(p), true)?;
        }
        bands.finish()
    }

    /// The faces that a contour makes, with its first and its last ring.
    fn sides(&self, bands: &mut Bands, contour: &[EdgeCurve], closed: bool) -> Result<[Ring; 2]> {
        let sections: Vec<Vec<[f64; 4]>> = contour.iter().map(rows_of).collect();
        let mut vertices: Vec<Point3> = contour.iter().map(EdgeCurve::start).collect();
        vertices.extend(contour.last().filter(|_| !closed).map(EdgeCurve::end));
        let mut rings: Vec<Ring> = Vec::with_capacity(self.stations.len() + 1);
        for station in &self.stations {
            let curves = contour.iter().zip(&sections).map(|(curve, rows)| station.image(curve, rows));
            rings.push(bands.ring(curves.collect::<Result<_>>()?, closed));
        }
        if self.closed {
            rings.push(rings[0].clone());
        }
        for (k, leg) in self.legs.iter().enumerate() {
            let [from, to] = [&self.stations[k], &self.stations[(k + 1) % self.stations.len()]];
            let carrier = Carrier::new(leg.arc, from.axis, leg.roll);
            let across = |i: usize, ends: [Point3; 2]| leg.line(&carrier, from.offset(vertices[i]), ends);
            let surface = |_: &Bands, i: usize| leg.face(&carrier, [from, to], &sections[i]);
            bands.band([&rings[k], &rings[k + 1]], across, surface)?;
        }
        let last = rings.len() - 1;
        Ok([rings[0].clone(), rings[last].clone()])
    }
}

impl Leg {
    fn line(&self, carrier: &Carrier, offset: Vec3, [start, end]: [Point3; 2]) -> Result<EdgeCurve> {
        if carrier.is_straight() {
            return Ok(Arc::segment(start, end)?.into());
        }
        if let Some(ratio) = carrier.ratio() {
            return Ok(Arc::from_ratio_across(start, end, ratio)?.into());
        }
        let row = carrier.row((offset, 1.0), &Polynomial::constant(1.0));
        Ok(EdgeCurve::Rational(RationalBezier::from_polynomial_row(&row)))
    }

    fn face(&self, carrier: &Carrier, ends: [&Station; 2], rows: &[[f64; 4]]) -> Result<RationalBezierSurface> {
        if carrier.is_straight() {
            let rows = rows.iter().flat_map(|&row| ends.map(|station| station.row(row)));
            return RationalBezierSurface::new([rows.clone().count() / 2 - 1, 1], rows.collect());
        }
        let one = Polynomial::constant(1.0);
        let row = |&[x, y, _, w]: &[f64; 4]| carrier.row((ends[0].across(x, y), w), &one);
        surface_of(rows.iter().map(row).collect(), false)
    }
}

impl Station {
    /// A vector of the section, across the path behind.
    fn across(&self, x: f64, y: f64) -> Vec3 {
        let [u, v] = self.directions();
        u * x + v * y
    }

    fn offset(&self, p: Point3) -> Vec3 {
        self.slanted(self.across(p.x, p.y))
    }

    fn place(&self, p: Point3) -> Point3 {
        self.center + self.offset(p)
    }

    /// A homogeneous row of the section, in space.
    fn row(&self, [x, y, _, w]: [f64; 4]) -> [f64; 4] {
        let p = self.center.to_vec() * w + self.slanted(self.across(x, y));
        [p.x, p.y, p.z, w]
    }

    /// A piece of the section, in space.
    fn image(&self, curve: &EdgeCurve, rows: &[[f64; 4]]) -> Result<EdgeCurve> {
        let (start, end) = (self.place(curve.start()), self.place(curve.end()));
        match curve {
            EdgeCurve::Arc(arc) if arc.is_straight() && rows.len() == 2 => Ok(Arc::segment(start, end)?.into()),
            EdgeCurve::Arc(arc) if !self.is_mitred() => {
                let ratio = arc.weight_ratio();
                let [u, v] = self.directions();
                let p = u * ratio.x + v * ratio.y + self.axis * ratio.z;
                Ok(Arc::from_ratio_across(start, end, Quat::from_parts(ratio.w, p))?.into())
            }
            _ => Ok(EdgeCurve::Rational(RationalBezier::new(rows.iter().map(|&row| self.row(row)).collect())?)),
        }
    }
}
