//! The neck sewn to its pipe and its plate: an open surface, or a solid.
//!
//! All pieces are ruled between ellipses and straight edges, and exact: the pipe from the contact to its end, which is across
//! its axis, and the plate from the contact to its border. A rectangular plate meets the neck in eight faces, from the ends of the axes of
//! the ellipse straight out and from the places between to the corners; rulings do not cross then (the ellipse as unit circle, the
//! border through `(X, s Y)` beside the angle θ(s) up to a right angle: `X cos θ + s Y sin θ > 1` for X, Y > 1).

use super::{NeckBlend, NeckSide};
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::bands::{Bands, Ring};
use crate::construct::bodies::ellipse_ring::{Ellipse, Sector};
use crate::curve::Arc;
use crate::error::{ErrorItem, NumberError, PipeError, Result};
use crate::topology::{Body, EdgeCurve};

/// The border of a plate about the place where the axis of the pipe meets it.
///
/// ```
/// use cyclide::construct::{NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape};
/// let neck = NeckBlend::new(3.0, 0.8, 0.5, NeckSide::Outside, NeckVariant::Pipe)?;
/// let body = |plate| neck.body(&NeckBody::new(8.0).with_plate(plate).with_thickness(1.0));
/// assert!(body(PlateShape::Disk(9.0))?.is_solid() && body(PlateShape::Rectangle([20.0, 20.0]))?.is_solid());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlateShape {
    /// A rectangle with these sides along x and y.
    Rectangle([f64; 2]),
    /// A disk of this radius.
    Disk(f64),
}

/// What is made of a neck.
///
/// ```
/// use cyclide::construct::{NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape};
/// let neck = NeckBlend::new(3.0, 0.8, 0.5, NeckSide::Outside, NeckVariant::Pipe)?;
/// let open = NeckBody::new(8.0).with_plate(PlateShape::Disk(9.0));
/// assert!(!neck.body(&open)?.is_solid());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NeckBody {
    /// Height of the end of the pipe over the plate, along its axis.
    pub height: f64,
    /// The plate round an outer neck. An inner neck has the floor of its pipe.
    pub plate: Option<PlateShape>,
    /// Thickness of the plate or floor, downwards: a solid. Without it a surface with free edges.
    pub thickness: Option<f64>,
    /// Thickness of the wall of the pipe in a solid. Without it an outer neck stands on a filled pipe, an inner one in a pipe with a
    /// wall as thick as its floor; with it an outer one has a bore through the plate.
    pub wall: Option<f64>,
}

impl NeckBody {
    /// A pipe with its end at a height over the plate, without one: an open surface.
    #[must_use]
    pub const fn new(height: f64) -> Self {
        Self { height, plate: None, thickness: None, wall: None }
    }

    /// With a plate round an outer neck.
    #[must_use]
    pub const fn with_plate(self, plate: PlateShape) -> Self {
        Self { plate: Some(plate), ..self }
    }

    /// With a thickness of the plate or floor: a solid.
    #[must_use]
    pub const fn with_thickness(self, thickness: f64) -> Self {
        Self { thickness: Some(thickness), ..self }
    }

    /// With a wall of the pipe of this thickness, in a solid.
    #[must_use]
    pub const fn with_wall(self, wall: f64) -> Self {
        Self { wall: Some(wall), ..self }
    }
}

impl NeckBlend {
    /// The neck with its pipe and its plate, sewn: see [`NeckBody`].
    ///
    /// # Errors
    /// `parameter-out-of-range` (a height below the contact with the pipe, a thickness that is not positive, a wall as thick as the pipe);
    /// `plate-too-small` (it does not reach beyond the neck, or the bore); `neck-folds` (of a solid: see [`warnings`](Self::warnings)); `not-finite`; `not-a-shell` beyond the range of numbers.
    pub fn body(&self, made: &NeckBody) -> Result<Body> {
        for (name, length) in [(ErrorItem::Thickness, made.thickness), (ErrorItem::Wall, made.wall)] {
            check_positive(name, length)?;
        }
        if let (Some(_), Some(limit)) = (made.thickness, self.folds_beyond()) {
            return Err(PipeError::NeckFolds { radius: self.ball_radius, limit }.into());
        }
        match (self.side(), made.plate) {
            (NeckSide::Inside, _) => self.cup(made),
            (NeckSide::Outside, Some(plate)) => self.stand(made, plate),
            (NeckSide::Outside, None) => {
                Err(PipeError::PlateTooSmall { what: ErrorItem::Neck, reach: 0.0, needed: self.reach() }.into())
            }
        }
    }

    fn side(&self) -> NeckSide {
        if self.sign > 0.0 { NeckSide::Outside } else { NeckSide::Inside }
    }

    /// A pipe on a plate.
    fn stand(&self, made: &NeckBody, plate: PlateShape) -> Result<Body> {
        self.check_height(made.height, self.top())?;
        plate.check_around(ErrorItem::Neck, &self.on_plate())?;
        let sectors = Sector::turn(plate.sectors());
        let mut bands = Bands::default();
        let end = ring(&mut bands, &self.round_axis(made.height, self.pipe_radius), &sectors)?;
        let (_, on_plate) = self.neck(&mut bands, &end, &sectors)?;
        let border = bands.ring(plate.border(0.0, self.on_plate().center.y, &sectors)?, true);
        bands.ruled([&on_plate, &border])?;
        let Some(thickness) = made.thickness else { return bands.finish() };
        let bore = match made.wall {
            Some(wall) => {
                let radius = self.bore_radius(wall)?;
                let below = self.at_height(-thickness, radius);
                plate.check_around(ErrorItem::Bore, &below)?;
                Some((radius, below))
            }
            None => None,
        };
        let middle = bore.map_or(self.on_plate().center.y, |(_, below)| below.center.y);
        let lower = bands.ring(plate.border(-thickness, middle, &sectors)?, true);
        bands.ruled([&border, &lower])?;
        let Some((radius, below)) = bore else {
            let foot = bands.pole(Point3::new(0.0, middle, -thickness), &lower);
            bands.ruled([&lower, &foot])?;
            let cap = bands.pole(Point3::ORIGIN + self.axis() * made.height, &end);
            bands.ruled([&cap, &end])?;
            return bands.finish();
        };
        let below = ring(&mut bands, &below, &sectors)?;
        let above = ring(&mut bands, &self.round_axis(made.height, radius), &sectors)?;
        for pair in [[&lower, &below], [&below, &above], [&above, &end]] {
            bands.ruled(pair)?;
        }
        bands.finish()
    }

    /// A pipe with a floor inside.
    fn cup(&self, made: &NeckBody) -> Result<Body> {
        self.check_height(made.height, self.top())?;
        let sectors = Sector::turn(4);
        let mut bands = Bands::default();
        let end = ring(&mut bands, &self.round_axis(made.height, self.pipe_radius), &sectors)?;
        let (_, on_floor) = self.neck(&mut bands, &end, &sectors)?;
        let middle = bands.pole(self.on_plate().center, &on_floor);
        bands.ruled([&on_floor, &middle])?;
        let Some(thickness) = made.thickness else { return bands.finish() };
        let radius = self.pipe_radius + made.wall.unwrap_or(thickness);
        // The outer wall must reach above the lower plane on all sides.
        self.check_height(made.height, radius * self.sin.abs() / self.cos - thickness / self.cos)?;
        let rim = ring(&mut bands, &self.round_axis(made.height, radius), &sectors)?;
        let below = self.at_height(-thickness, radius);
        let foot = bands.pole(below.center, &rim);
        let below = ring(&mut bands, &below, &sectors)?;
        for pair in [[&foot, &below], [&below, &rim], [&rim, &end]] {
            bands.ruled(pair)?;
        }
        bands.finish()
    }

    /// The pipe from its end to the contact, and the neck from there to the plate.
    fn neck(&self, bands: &mut Bands, end: &Ring, sectors: &[Sector]) -> Result<(Ring, Ring)> {
        let on_pipe = ring(bands, &self.on_pipe(), sectors)?;
        let on_plate = ring(bands, &self.on_plate(), sectors)?;
        bands.ruled([end, &on_pipe])?;
        let arc = |i: usize, _| Ok(self.even_arc(sectors[i].from())?.into());
        bands.band([&on_pipe, &on_plate], arc, |_, i| self.even_over(&sectors[i]))?;
        Ok((on_pipe, on_plate))
    }

    fn check_height(&self, height: f64, least: f64) -> Result<()> {
        if height > least && height.is_finite() {
            return Ok(());
        }
        if !height.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Height, index: 0 }.into());
        }
        Err(NumberError::ParameterOutOfRange { name: ErrorItem::Height, value: height, min: least, max: f64::MAX }
            .into())
    }

    fn bore_radius(&self, wall: f64) -> Result<f64> {
        let max = self.pipe_radius;
        if wall >= max {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max }.into());
        }
        Ok(max - wall)
    }
}

/// Adds an ellipse.
fn ring(bands: &mut Bands, ellipse: &Ellipse, sectors: &[Sector]) -> Result<Ring> {
    Ok(bands.ring(ellipse.curves(sectors)?, true))
}

fn check_positive(name: ErrorItem, length: Option<f64>) -> Result<()> {
    match length {
        Some(value) if !value.is_finite() => Err(NumberError::NotFinite { what: name, index: 0 }.into()),
        Some(value) if !(value >= range::MIN_DISTANCE) => {
            Err(NumberError::ParameterOutOfRange { name, value, min: range::MIN_DISTANCE, max: f64::MAX }.into())
        }
        _ => Ok(()),
    }
}

impl PlateShape {
    /// A disk has four sectors, a rectangle eight: its sides are cut where they are nearest to the neck.
    fn sectors(self) -> usize {
        match self {
            Self::Rectangle(_) => 8,
            Self::Disk(_) => 4,
        }
    }

    /// Refuses a plate that does not reach beyond an ellipse in its plane, whose axes are along x and y.
    fn check_around(self, what: ErrorItem, hole: &Ellipse) -> Result<()> {
        let (x, y) = (hole.u.length(), hole.center.y.abs() + hole.v.length());
        // Ellipses here are longer along y: of all their points the end of that axis is farthest out.
        let pairs = match self {
            Self::Rectangle([width, depth]) => [(0.5 * width, x), (0.5 * depth, y)],
            Self::Disk(radius) => [(radius, y), (radius, y)],
        };
        match pairs.into_iter().find(|(reach, needed)| !(reach > needed && reach.is_finite())) {
            Some((reach, needed)) => Err(PipeError::PlateTooSmall { what, reach, needed }.into()),
            None => Ok(()),
        }
    }

    /// The border at a height, cut at `middle` on the sides along y.
    fn border(self, z: f64, middle: f64, sectors: &[Sector]) -> Result<Vec<EdgeCurve>> {
        let (x, y) = match self {
            Self::Disk(r) => {
                let (u, v) = (Vec3::new(r, 0.0, 0.0), Vec3::new(0.0, r, 0.0));
                return Ellipse { center: Point3::new(0.0, 0.0, z), u, v }.curves(sectors);
            }
            Self::Rectangle([width, depth]) => (0.5 * width, 0.5 * depth),
        };
        let corners = [(x, middle), (x, y), (0.0, y), (-x, y), (-x, middle), (-x, -y), (0.0, -y), (x, -y)];
        let corners = corners.map(|(x, y)| Point3::new(x, y, z));
        (0..8).map(|i| Ok(Arc::segment(corners[i], corners[(i + 1) % 8])?.into())).collect()
    }
}
