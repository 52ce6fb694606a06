//! A model made ready for its files: bodies sewn, size measured and held against the limits, curves lowered, once for all
//! formats.

use crate::export::error::ExportError;
use crate::export::lowered::LoweredCurves;
use crate::export::moving::MovingRoom;
use crate::export::parts::{BodyOf, bodies, boxes, contours};
use crate::export::provenance::{Provenance, Provenances};
use cyclide::{Aabb, Vec3, model::Model};

/// Largest coordinate that is written: products of two of them must not overflow.
const LARGEST_COORDINATE: f64 = 1e120;
/// Smallest size of a curve that is written: its shortest pieces are points that differ by no less than 1e-150.
const SMALLEST_CURVE: f64 = 1e-130;
/// The same of a body, whose faces are of one size.
const SMALLEST_BODY: f64 = 1e-140;

/// A model with what all its files need.
pub(crate) struct ReadyModel<'a> {
    pub(crate) model: &'a Model,
    /// How its objects came about.
    pub(crate) provenances: Provenances<'a>,
    /// The bodies of all surfaces, in the model's order.
    pub(crate) bodies: Vec<BodyOf<'a>>,
    /// The smallest box around all curves, surfaces and motions.
    pub(crate) bounds: Aabb,
    pub(crate) extents: Extents,
    /// The rooms of the motions, in the model's order.
    pub(crate) moving: Vec<MovingRoom>,
    /// The forms of its curves that files share.
    pub(crate) lowered: LoweredCurves,
}

/// Size of each part of a model and its distance from the origin, whichever is larger: rounding is relative to
/// coordinates.
#[derive(Default)]
pub(crate) struct Extents {
    pub(crate) curves: Vec<f64>,
    pub(crate) bodies: Vec<f64>,
}

impl<'a> ReadyModel<'a> {
    /// Makes a model ready, whose first objects came about as given.
    ///
    /// # Errors
    /// [`ExportError`] for a model without anything to write, beyond the largest coordinates, or with a surface that has
    /// no body.
    pub(crate) fn new(model: &'a Model, provenance: &'a [Provenance]) -> Result<Self, ExportError> {
        let provenances = Provenances::new(model, provenance);
        let bodies = bodies(model, provenances)?;
        let mut total: Option<Aabb> = None;
        let mut curves = Vec::new();
        let count = contours(model).count();
        for (index, (object, own)) in boxes(model, &bodies).enumerate() {
            curves.push(extent(own));
            if !(own.max_abs() <= LARGEST_COORDINATE) {
                let object = object.to_owned();
                return Err(ExportError::TooLarge { object, value: own.max_abs(), limit: LARGEST_COORDINATE });
            }
            let (size, limit) = (own.diagonal(), if index < count { SMALLEST_CURVE } else { SMALLEST_BODY });
            if size > 0.0 && size < limit {
                return Err(ExportError::TooSmall { object: object.to_owned(), size, limit });
            }
            total = Some(total.map_or(own, |b| b.union(own)));
        }
        let mut moving = Vec::new();
        for item in &model.items {
            let Some(room) = item.motion().map(MovingRoom::of) else { continue };
            moving.push(room);
            let own = grown(room.way, room.reach);
            if !(own.max_abs() <= LARGEST_COORDINATE) {
                let object = item.name.clone();
                return Err(ExportError::TooLarge { object, value: own.max_abs(), limit: LARGEST_COORDINATE });
            }
            total = Some(total.map_or(own, |b| b.union(own)));
        }
        // Those of the bodies stand behind those of the curves.
        let of_bodies = curves.split_off(count);
        let extents = Extents { curves, bodies: of_bodies };
        let bounds = total.ok_or(ExportError::Empty)?;
        Ok(Self { model, provenances, bodies, bounds, extents, moving, lowered: LoweredCurves::default() })
    }

    /// Size of the model and its distance from the origin, whichever is larger: rounding is relative to coordinates.
    pub(crate) fn extent(&self) -> f64 {
        extent(self.bounds)
    }
}

/// A box with a margin.
fn grown(bounds: Aabb, margin: f64) -> Aabb {
    let margin = Vec3::new(margin, margin, margin);
    Aabb { min: bounds.min - margin, max: bounds.max + margin }
}

fn extent(bounds: Aabb) -> f64 {
    bounds.diagonal().max(bounds.max_abs())
}
