//! The plate round a blend: its border opposite the contact, ray by ray from the place where the axis meets the plane
//! (`docs/math/contact-blends.md#plates`).

use super::setup::Setup;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::PlateShape;
use crate::construct::bodies::ellipse_ring::{Ellipse, Sector};
use crate::curve::Arc;
use crate::error::{BridgeError, Error, ErrorItem, PipeError, Result};
use crate::topology::EdgeCurve;
use std::f64::consts::TAU;

/// Places of a loop between which rays are looked for, and steps in which one is found.
const PLACES: u32 = 64;
const STEPS: u32 = 60;
/// Places of a face at which its lines are looked at.
const LINES: u32 = 16;

/// The angles at which a loop of contacts on a plane has nodes, and the points of the border opposite them, where these are known.
pub(super) struct PlateNodes {
    pub(super) angles: Vec<f64>,
    points: Vec<Option<Point3>>,
}

/// The contact of the ball with the plane at an angle round the tube.
pub(super) fn contact(setup: &Setup, angle: f64) -> Result<Point3> {
    let [height, _] = setup.height(angle)?;
    let (sin, cos) = angle.sin_cos();
    let from_axis = setup.center_at_origin() + height * setup.tan;
    let center = setup.point([from_axis * cos, from_axis * sin, height - setup.ball * setup.sigma * setup.sin]);
    Ok(Point3::new(center.x, center.y, 0.0))
}

/// Equal angles, from 0 on.
pub(super) fn equal_angles(count: usize) -> Vec<f64> {
    (0..count).map(|k| TAU * k as f64 / count as f64).collect()
}

impl PlateNodes {
    /// # Errors
    /// `plate-too-small`, `contact-loop-open`, `radius-not-positive`.
    pub(super) fn new(setup: &Setup, shape: PlateShape) -> Result<Self> {
        let turn = Turn::new(setup)?;
        check_around(setup, shape, &turn)?;
        let PlateShape::Rectangle([width, depth]) = shape else {
            let angles = equal_angles(8);
            return Ok(Self { points: vec![None; angles.len()], angles });
        };
        let (o, x, y) = (setup.frame.origin(), 0.5 * width, 0.5 * depth);
        let border = [(x, o.y), (x, y), (o.x, y), (-x, y), (-x, o.y), (-x, -y), (o.x, -y), (x, -y)];
        let mut nodes: Vec<(f64, Point3)> = Vec::new();
        for (x, y) in border {
            nodes.push((turn.angle_of(setup, (y - o.y).atan2(x - o.x))?, Point3::new(x, y, 0.0)));
        }
        nodes.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(Self {
            angles: nodes.iter().map(|node| node.0).collect(),
            points: nodes.iter().map(|node| Some(node.1)).collect(),
        })
    }

    /// The curves of the border at a height opposite pieces that start at these contacts, of which `starts` are those at the angles.
    ///
    /// # Errors
    /// As [`Arc::segment`].
    pub(super) fn border(
        &self,
        setup: &Setup,
        shape: PlateShape,
        contacts: &[Point3],
        starts: &[usize],
        z: f64,
    ) -> Result<Vec<EdgeCurve>> {
        let o = setup.frame.origin();
        let known = |k: usize| starts.iter().position(|start| *start == k).and_then(|at| self.points[at]);
        let azimuth = |p: Point3| (p.y - o.y).atan2(p.x - o.x);
        let points: Vec<Point3> = contacts
            .iter()
            .enumerate()
            .map(|(k, p)| known(k).unwrap_or_else(|| reach(shape, o, azimuth(*p))))
            .collect();
        let count = points.len();
        let piece = |k: usize| {
            let [from, to] = [k, (k + 1) % count].map(|k| Point3 { z, ..points[k] });
            match shape {
                PlateShape::Rectangle(_) => Ok(Arc::segment(from, to)?.into()),
                PlateShape::Disk(r) => {
                    let (u, v) = (Vec3::new(r, 0.0, 0.0), Vec3::new(0.0, r, 0.0));
                    let [start, end] = [from, to].map(|p| p.y.atan2(p.x));
                    let end = start + (end - start).rem_euclid(TAU);
                    Ellipse { center: Point3::new(0.0, 0.0, z), u, v }.curve(&Sector::new(start, end))
                }
            }
        };
        (0..count).map(piece).collect()
    }
}

/// The azimuths of the contacts about the foot of the axis at equal angles round the tube, rising all the way: the contact is an ellipse, and the foot is inside it
/// where the tube has a positive radius at its contact.
struct Turn {
    azimuths: Vec<f64>,
}

impl Turn {
    fn new(setup: &Setup) -> Result<Self> {
        let o = setup.frame.origin();
        let mut azimuths: Vec<f64> = Vec::new();
        for k in 0..=PLACES {
            let angle = TAU * f64::from(k) / f64::from(PLACES);
            let p = contact(setup, angle)?;
            let azimuth = (p.y - o.y).atan2(p.x - o.x);
            let Some(&before) = azimuths.last() else {
                azimuths.push(azimuth);
                continue;
            };
            let step = (azimuth - before + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            azimuths.push(before + step);
        }
        Ok(Self { azimuths })
    }

    /// The angle round the tube at which the contact has an azimuth.
    fn angle_of(&self, setup: &Setup, azimuth: f64) -> Result<f64> {
        let start = self.azimuths[0];
        let wanted = (azimuth - start).rem_euclid(TAU);
        let after = self.azimuths.iter().position(|a| a - start > wanted).unwrap_or(self.azimuths.len() - 1).max(1);
        let step = TAU / f64::from(PLACES);
        let [mut low, mut high] = [after - 1, after].map(|k| k as f64 * step);
        let o = setup.frame.origin();
        for _ in 0..STEPS {
            let middle = 0.5 * (low + high);
            let p = contact(setup, middle)?;
            let off = ((p.y - o.y).atan2(p.x - o.x) - start - wanted + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            if off < 0.0 { low = middle } else { high = middle }
        }
        Ok(0.5 * (low + high))
    }
}

/// The point of the border in a direction from a point within.
fn reach(shape: PlateShape, o: Point3, azimuth: f64) -> Point3 {
    let (sin, cos) = azimuth.sin_cos();
    let length = match shape {
        PlateShape::Rectangle([width, depth]) => {
            let side = |half: f64, at: f64, way: f64| {
                if way == 0.0 { f64::INFINITY } else { (half - at * way.signum()) / way.abs() }
            };
            side(0.5 * width, o.x, cos).min(side(0.5 * depth, o.y, sin))
        }
        PlateShape::Disk(r) => {
            let (along, across) = (o.x * cos + o.y * sin, o.x * sin - o.y * cos);
            ((r - across) * (r + across)).max(0.0).sqrt() - along
        }
    };
    Point3::new(o.x + cos * length, o.y + sin * length, 0.0)
}

/// Refuses a plate that does not reach beyond the blend.
fn check_around(setup: &Setup, shape: PlateShape, turn: &Turn) -> Result<()> {
    let o = setup.frame.origin();
    for (k, azimuth) in turn.azimuths.iter().enumerate() {
        let needed = contact(setup, TAU * k as f64 / f64::from(PLACES))?.distance(o);
        let inside = match shape {
            PlateShape::Rectangle([width, depth]) => o.x.abs() < 0.5 * width && o.y.abs() < 0.5 * depth,
            PlateShape::Disk(r) => o.x.hypot(o.y) < r,
        };
        let reach = if inside { reach(shape, o, *azimuth).distance(o) } else { 0.0 };
        if !(reach > needed && reach.is_finite()) {
            return Err(PipeError::PlateTooSmall { what: ErrorItem::Blend, reach, needed }.into());
        }
    }
    Ok(())
}

/// Refuses lines of the plate that cross their neighbors: between the contact and the border, at equal parameters.
///
/// # Errors
/// `rulings-cross`.
pub(super) fn check_lines(piece: usize, contact: &EdgeCurve, border: &EdgeCurve) -> Result<()> {
    let places: Vec<f64> = (0..=LINES).map(|k| f64::from(k) / f64::from(LINES)).collect();
    for pair in places.windows(2) {
        let [s, next] = [pair[0], pair[1]];
        let line = border.point(s) - contact.point(s);
        for (t, curve) in [(0.0, contact), (1.0, border)] {
            let step = curve.point(next) - curve.point(s);
            let normal = line.cross(step).z;
            if !(normal > 0.0) {
                let error = BridgeError::RulingsCross { piece, at: [s, t], normal: normal.max(0.0), limit: 0.0 };
                return Err(Error::from(error).in_field("plate"));
            }
        }
    }
    Ok(())
}
