//! The body of a tee: solid, or hollow with a blend of the same balls inside.

use super::skin::{Ends, Skin};
use super::{PipeTee, check_finite};
use crate::base::vector::Point3;
use crate::construct::bodies::bands::{Bands, Ring};
use crate::error::{Error, ErrorItem, Result};
use crate::topology::Body;

/// What is made of a tee.
///
/// ```
/// use cyclide::{PipeTee, PipeTeeBody};
/// let tee = PipeTee::new([2.0, 1.0], 0.0, &[[0.0, 0.4]], 1e-3)?;
/// let made = PipeTeeBody { reach: [5.0, 5.0], height: 5.0, wall: Some(0.2) };
/// let solid = tee.body(&PipeTeeBody { wall: None, ..made })?;
/// assert!(tee.body(&made)?.outer.volume() < 0.5 * solid.outer.volume());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PipeTeeBody {
    /// From the axis of the branch to the ends of the pipe, in negative and in positive direction of x.
    pub reach: [f64; 2],
    /// From the axis of the pipe to the end of the branch.
    pub height: f64,
    /// Thickness of the wall, the same everywhere: the bore has a blend of balls about the same centres. Solid without it.
    pub wall: Option<f64>,
}

impl PipeTee {
    /// The tee as a solid, its ends plane.
    ///
    /// # Errors
    /// `not-finite`; `parameter-out-of-range` (ends within the blend, a wall as thick as the branch); `blend-folds` (in the bore, where balls are
    /// larger by the wall); `weight-not-positive` (arcs of half a circle).
    pub fn body(&self, made: &PipeTeeBody) -> Result<Body> {
        let [left, right, top] = Skin::reach(self);
        for (name, value, least) in [
            (ErrorItem::Reach, made.reach[0], -left),
            (ErrorItem::Reach, made.reach[1], right),
            (ErrorItem::Height, made.height, top),
        ] {
            check_finite(name, value)?;
            if !(value > least) {
                return Err(Error::ParameterOutOfRange { name, value, min: least, max: f64::MAX });
            }
        }
        let ends = [-made.reach[0], made.reach[1]];
        let mut bands = Bands::default();
        let outer = Skin::new(self, 0.0, ends, made.height).sew(&mut bands, false)?;
        match made.wall {
            None => self.cap(&mut bands, &outer, made)?,
            Some(wall) => {
                let max = self.pair.radii()[1];
                check_finite(ErrorItem::Wall, wall)?;
                if !(wall > 0.0 && wall < max) {
                    return Err(Error::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max });
                }
                self.check_folds(wall)?;
                let inner = Skin::new(self, wall, ends, made.height).sew(&mut bands, true)?;
                let [[left, right], [left_bore, right_bore]] = [&outer.pipe, &inner.pipe].map(|[a, b]| [a, b]);
                for rings in [[left_bore, left], [right, right_bore], [&inner.branch, &outer.branch]] {
                    bands.ruled(rings)?;
                }
            }
        }
        bands.finish()
    }

    /// Disks at all ends.
    fn cap(&self, bands: &mut Bands, ends: &Ends, made: &PipeTeeBody) -> Result<()> {
        let offset = -2.0 * self.pair.half_gap();
        let mut disk = |center: Point3, ring: &Ring, outward: bool| {
            let pole = bands.pole(center, ring);
            bands.ruled(if outward { [ring, &pole] } else { [&pole, ring] })
        };
        disk(Point3::new(-made.reach[0], 0.0, 0.0), &ends.pipe[0], false)?;
        disk(Point3::new(made.reach[1], 0.0, 0.0), &ends.pipe[1], true)?;
        disk(Point3::new(0.0, offset, made.height), &ends.branch, false)
    }
}
