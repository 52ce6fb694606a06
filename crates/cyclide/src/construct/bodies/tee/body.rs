//! The body of a tee: solid, or hollow with a blend of the same balls inside.

use super::skin::{Ends, Skin, Stand, fan};
use super::{PLACES, PipeTee, check_finite};
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
        let [left, right] = made.reach;
        check_finite(ErrorItem::Reach, left)?;
        check_finite(ErrorItem::Reach, right)?;
        body_of(&[Stand { tee: self, position: 0.0, height: made.height }], [-left, right], made.wall)
    }

    /// How far contacts reach along the pipe, both ways, and up the branch.
    pub(super) fn reach(&self) -> [f64; 3] {
        let mut reach = [0.0_f64, 0.0, f64::NEG_INFINITY];
        for patch in self.patches() {
            for k in 0..=PLACES {
                let (center, _) = patch.ball(f64::from(k) / f64::from(PLACES));
                reach = [reach[0].min(center.x), reach[1].max(center.x), reach[2].max(center.y)];
            }
        }
        reach
    }
}

/// The solid of a pipe between two ends with the branches of tees, in order.
pub(super) fn body_of(stands: &[Stand], ends: [f64; 2], wall: Option<f64>) -> Result<Body> {
    let borders = borders(stands, ends)?;
    let mut bands = Bands::default();
    let outer = sew(stands, &borders, 0.0, &mut bands, false)?;
    match wall {
        None => cap(&mut bands, stands, &outer, ends)?,
        Some(wall) => {
            check_wall(stands, wall)?;
            let inner = sew(stands, &borders, wall, &mut bands, true)?;
            let ([left, right], [left_bore, right_bore]) = (&outer.0, &inner.0);
            bands.ruled([left_bore, left])?;
            bands.ruled([right, right_bore])?;
            for (bore, branch) in inner.1.iter().zip(&outer.1) {
                bands.ruled([bore, branch])?;
            }
        }
    }
    bands.finish()
}

/// The places along the pipe where the parts of the tees begin and end: both ends, and between.
fn borders(stands: &[Stand], [first, last]: [f64; 2]) -> Result<Vec<f64>> {
    let mut borders = vec![first];
    let mut from = first;
    for (i, stand) in stands.iter().enumerate() {
        let [left, right, top] = stand.tee.reach();
        check_finite(ErrorItem::Height, stand.height)?;
        let end = stand.position + right;
        let next = stands.get(i + 1).map_or(last, |next| next.position + next.tee.reach()[0]);
        for (name, value, least) in [
            (ErrorItem::Height, stand.height, top),
            (ErrorItem::Reach, stand.position - from, -left),
            (ErrorItem::Reach, next - stand.position, right),
        ] {
            if !(value > least) {
                return Err(Error::ParameterOutOfRange { name, value, min: least, max: f64::MAX });
            }
        }
        from = end;
        borders.push(if i + 1 == stands.len() { last } else { 0.5 * (end + next) });
    }
    Ok(borders)
}

fn check_wall(stands: &[Stand], wall: f64) -> Result<()> {
    check_finite(ErrorItem::Wall, wall)?;
    for stand in stands {
        let max = stand.tee.pair.radii()[1];
        if !(wall > 0.0 && wall < max) {
            return Err(Error::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max });
        }
        stand.tee.check_folds(wall)?;
    }
    Ok(())
}

/// The skins of all tees, one joined to the next: the rings at the ends of the pipe, and of all branches.
fn sew(
    stands: &[Stand],
    borders: &[f64],
    thinner: f64,
    bands: &mut Bands,
    inside: bool,
) -> Result<([Ring; 2], Vec<Ring>)> {
    let fan = fan(stands);
    let (mut pipe, mut branches): (Option<[Ring; 2]>, Vec<Ring>) = (None, Vec::new());
    for (stand, ends) in stands.iter().zip(borders.windows(2)) {
        let skin = Skin::new(stand, thinner, [ends[0], ends[1]], fan);
        let before = pipe.as_ref().map(|[_, right]| right.clone());
        let Ends { pipe: [left, right], branch } = skin.sew(bands, inside, before)?;
        let first = pipe.map_or(left, |[first, _]| first);
        pipe = Some([first, right]);
        branches.push(branch);
    }
    pipe.map(|pipe| (pipe, branches)).ok_or(Error::TooFewPoints { given: 0, needed: 1 })
}

/// Disks at all ends.
fn cap(
    bands: &mut Bands,
    stands: &[Stand],
    ([left, right], branches): &([Ring; 2], Vec<Ring>),
    [first, last]: [f64; 2],
) -> Result<()> {
    let mut disk = |center: Point3, ring: &Ring, outward: bool| {
        let pole = bands.pole(center, ring);
        bands.ruled(if outward { [ring, &pole] } else { [&pole, ring] })
    };
    disk(Point3::new(first, 0.0, 0.0), left, false)?;
    disk(Point3::new(last, 0.0, 0.0), right, true)?;
    stands.iter().zip(branches).try_for_each(|(stand, ring)| {
        let offset = -2.0 * stand.tee.pair.half_gap();
        disk(Point3::new(stand.position, offset, stand.height), ring, false)
    })
}
