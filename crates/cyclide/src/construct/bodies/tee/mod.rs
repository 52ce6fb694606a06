//! Tees: branches on a main pipe, blended by balls that roll round them, exact (`docs/math/pipe-tees.md`).
//!
//! The branch is thinner than the main pipe, and their axes meet or pass nearer than the radii differ, at any angle: the case that
//! `docs/math/pipe-tees.md#balls` calls spacelike. The centers of balls that touch both from outside form a surface with rational curves of degree 4, on which
//! every law of the radius has its loop. The canal of a piece of the loop is rational of degree (12, 2), and so are, exactly, what is left of
//! both pipes: all faces have four sides and share edges.
//!
//! Both may be cones. A branch as wide as the main pipe, its axis meeting the other, has its balls on two half ellipses (`docs/math/pipe-tees.md#equal-pipes`).
//!
//! A wall has the same loop inside: radii of pipes less by its thickness, radii of balls larger by it, the centers stay.

mod apart;
mod arrangement;
mod blend;
mod boost;
mod canal;
mod check;
mod crossing;
mod equal;
mod loop_piece;
mod partition;
mod piece_forms;
mod radius_law;
mod sewn;
mod skin;

pub use blend::TeeBlend;
pub(super) use canal::Canal;
pub(super) use crossing::Crossing;
use loop_piece::Loop;
pub(super) use loop_piece::LoopPiece;

use super::ball_centers::{BallCenters, closed_path};
use crate::base::range;
use crate::base::vector::Point3;
use crate::error::{Error, ErrorItem, NumberError, PipeError, PointError, Result};
use crate::rational::NurbsCurve;
use crate::surface::CanalPatch;
use crate::topology::Body;
use partition::Partition;

/// Radii of branch and main pipe are one if they differ by no more than this part.
const ROUNDING_OF_RADII: f64 = 1e-12;

/// The main pipe of a tee, about the x axis.
///
/// ```
/// use cyclide::construct::TeeMain;
/// let main = TeeMain { radius: 30.0, taper: 0.0, ends: [-100.0, 100.0] };
/// assert!(main.ends[0] < main.ends[1]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TeeMain {
    /// Its outer radius; with a taper that where x is zero.
    pub radius: f64,
    /// Half the angle of the cone that it is: above zero it grows thinner along x, below wider, 0 is a cylinder.
    pub taper: f64,
    /// The places on the x axis where it ends.
    pub ends: [f64; 2],
}

/// A branch of a tee.
///
/// ```
/// use cyclide::construct::{TeeBlend, TeeBranch};
/// let lateral = TeeBranch { angle: 0.8, ..TeeBranch::upright(20.0, 100.0, 6.0) };
/// assert!(matches!(lateral.blend, TeeBlend::Radius { radius: 6.0, .. }));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TeeBranch {
    /// Its outer radius, below that of the main pipe there, or equal to it with no offset and no tapers; with a taper that at the place nearest to the axis of the main pipe.
    pub radius: f64,
    /// Half the angle of the cone that it is: above zero it grows thinner towards its end, below wider, 0 is a cylinder.
    pub taper: f64,
    /// Where it ends: distance along its axis from the place nearest to the axis of the main pipe.
    pub length: f64,
    /// Angle between its direction and that of the main pipe, the x axis.
    pub angle: f64,
    /// How far its axis passes beside that of the main pipe: towards +y for a branch that goes up, turned with the azimuth. Below the difference of the radii.
    pub offset: f64,
    /// The place on the x axis that its own axis is nearest to.
    pub at: f64,
    /// Its direction round the main pipe: 0 up, along z, a quarter turn -y.
    pub azimuth: f64,
    /// The blend.
    pub blend: TeeBlend,
}

impl TeeBranch {
    /// A branch straight up from the middle, with a blend of one radius.
    #[must_use]
    pub fn upright(radius: f64, length: f64, blend: f64) -> Self {
        Self {
            radius,
            taper: 0.0,
            length,
            angle: std::f64::consts::FRAC_PI_2,
            offset: 0.0,
            at: 0.0,
            azimuth: 0.0,
            blend: TeeBlend::Radius { radius: blend, tolerance: None },
        }
    }
}

/// How the pipes of a tee end.
///
/// ```
/// use cyclide::construct::{PipeTee, TeeBranch, TeeEnds, TeeMain};
/// let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
/// let tee = PipeTee::new(main, vec![TeeBranch::upright(2.0, 10.0, 0.5)])?.with_wall(0.2)?;
/// assert!(tee.made()?.body.voids.is_empty());
/// assert_eq!(tee.with_ends(TeeEnds::Closed).made()?.body.voids.len(), 1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline, description = "The ends of the pipes."))]
pub enum TeeEnds {
    /// Planar ends: disks, or with a wall rings around the bore.
    #[default]
    Flat,
    /// Planar ends and, with a wall, no opening: the hollow inside stops one wall thickness below the ends.
    Closed,
    /// No end faces: the surface only.
    Open,
}

/// A main pipe with branches, solid or with a wall.
///
/// ```
/// use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
/// let main = TeeMain { radius: 30.0, taper: 0.0, ends: [-100.0, 100.0] };
/// let tee = PipeTee::new(main, vec![TeeBranch::upright(20.0, 100.0, 6.0)])?.with_wall(3.0)?;
/// let made = tee.made()?;
/// assert!(made.body.is_solid() && (made.blends[0].radii[1] - 6.0).abs() < 0.006);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PipeTee {
    main: TeeMain,
    branches: Vec<TeeBranch>,
    wall: Option<f64>,
    ends: TeeEnds,
}

/// A tee as it was made.
///
/// ```
/// use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
/// let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
/// let made = PipeTee::new(main, vec![TeeBranch::upright(2.0, 10.0, 0.5)])?.made()?;
/// assert!(made.body.is_solid() && made.blends.len() == 1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MadeTee {
    /// The body.
    pub body: Body,
    /// What is known of the blends, in the order of the branches.
    pub blends: Vec<TeeBlendFacts>,
    /// Where the centers of their balls are, in the same order.
    pub centers: BallCenters,
}

/// What is known of a blend.
///
/// ```
/// use cyclide::construct::{PipeTee, TeeBranch, TeeMain};
/// let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
/// let facts = PipeTee::new(main, vec![TeeBranch::upright(2.0, 10.0, 0.5)])?.made()?.blends[0];
/// assert!(facts.radii[0] >= 0.4995 && facts.radii[1] <= 0.5005 && facts.tightest > 0.7);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TeeBlendFacts {
    /// The least and the largest radius of its balls, a proved bound.
    pub radii: [f64; 2],
    /// The largest difference from the radius or the law that was asked for: of one radius a proved bound, of a law looked at in places close together.
    pub deviation: f64,
    /// Pieces of its loop.
    pub pieces: usize,
    /// How near it comes to folding: what is left of its width where most of it is gone, 1 where it is straight and 0 where it folds.
    pub tightest: f64,
    /// The angle round the branch at which that is, in radians.
    pub tightest_at: f64,
}

/// A branch placed, with its loop.
struct Placed {
    crossing: Crossing,
    partition: Partition,
    length: f64,
    /// The places along the main pipe between which the blend is.
    reach: [f64; 2],
    /// The angles round the main pipe between which it is, in the axes of the branch.
    breadth: [f64; 2],
    facts: TeeBlendFacts,
}

impl Placed {
    /// The way of the centers of its balls.
    fn path(&self) -> Result<NurbsCurve> {
        let pieces = self.partition.pieces.iter().map(|piece| Canal::new(&self.crossing, piece, 0.0).into_patch());
        closed_path(pieces.collect::<Vec<_>>().iter().map(CanalPatch::center))
    }

    /// The middle of its end.
    fn end(&self) -> Point3 {
        self.crossing.foot + self.crossing.axes[2] * self.length
    }
}

impl PipeTee {
    /// A solid tee.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`, `too-few-points` (no branch), `pipe-ends-reversed`, `parameter-out-of-range` (coordinates beyond the range of the kernel's numbers).
    pub fn new(main: TeeMain, branches: Vec<TeeBranch>) -> Result<Self> {
        if branches.is_empty() {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        }
        range::check_radius(ErrorItem::MainPipe, 0, main.radius)?;
        if let Some(index) = main.ends.iter().position(|end| !end.is_finite()) {
            return Err(Error::from(NumberError::NotFinite { what: ErrorItem::Coordinate, index }).in_field("main"));
        }
        if !main.taper.is_finite() {
            return Err(Error::from(NumberError::NotFinite { what: ErrorItem::Taper, index: 0 }).in_field("main"));
        }
        if let [start, end] = main.ends
            && start >= end
        {
            return Err(PipeError::EndsReversed { pipe: 0, start, end }.into());
        }
        for (index, branch) in branches.iter().enumerate() {
            range::check_radius(ErrorItem::Radius, 0, branch.radius)
                .map_err(|error| error.in_branch(index, ErrorItem::Radius))?;
            let numbers = [
                (ErrorItem::Height, branch.length),
                (ErrorItem::Angle, branch.taper),
                (ErrorItem::Angle, branch.angle),
                (ErrorItem::Distance, branch.offset),
                (ErrorItem::Coordinate, branch.at),
                (ErrorItem::Angle, branch.azimuth),
            ];
            for (what, value) in numbers {
                if !value.is_finite() {
                    return Err(NumberError::NotFinite { what, index }.into());
                }
            }
        }
        Ok(Self { main, branches, wall: None, ends: TeeEnds::Flat })
    }

    /// The same with a bore in all pipes that leaves this thickness of the wall.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the wall is thinner than the thinnest pipe.
    pub fn with_wall(self, wall: f64) -> Result<Self> {
        let max = self.branches.iter().map(|branch| branch.radius).fold(self.main.radius, f64::min);
        if !(wall > 0.0 && wall < max) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max }.into());
        }
        Ok(Self { wall: Some(wall), ..self })
    }

    /// The same with other ends.
    #[must_use]
    pub fn with_ends(self, ends: TeeEnds) -> Self {
        Self { ends, ..self }
    }

    /// The body, with what is known of its blends.
    ///
    /// # Errors
    /// `parameter-out-of-range` and `radius-not-positive` (a main pipe that is no cone, or comes to an end before its own), `tee-branch-too-wide`, `angle-out-of-range`, as [`TeeBlend`] `radius-not-positive`, `tolerance-not-positive`, `tee-blend-too-large`, `tee-law-on-equal-pipes`, `too-many-pieces`, `coincident-points`, `below-rounding-of-place`;
    /// `tee-pipe-too-short`, `tee-blend-folds`, `tee-hole-folds`, `tee-branches-meet`, `tee-equal-branches-not-opposite`, `tee-no-free-line`.
    pub fn made(&self) -> Result<MadeTee> {
        self.check_main()?;
        let mut placed = self
            .branches
            .iter()
            .enumerate()
            .map(|(index, branch)| self.placed(index, &self.as_wide_as_main(branch)))
            .collect::<Result<Vec<_>>>()?;
        let blends = placed.iter().map(|branch| branch.facts).collect();
        let paths = placed.iter().map(Placed::path).collect::<Result<Vec<_>>>()?;
        let centers = BallCenters::new(paths, None);
        self.check_room(&placed)?;
        placed.sort_by(|a, b| a.reach[0].total_cmp(&b.reach[0]));
        let groups = self.groups(&placed)?;
        Ok(MadeTee { body: self.sewn(&placed, &groups)?, blends, centers })
    }

    /// A branch, of one radius with the main pipe where both are so but for rounding, as those of a conversion of units are: its blend is another one then.
    fn as_wide_as_main(&self, branch: &TeeBranch) -> TeeBranch {
        let off = (branch.radius - self.main.radius).abs();
        let are_cylinders = branch.taper == 0.0 && self.main.taper == 0.0;
        if are_cylinders && branch.offset == 0.0 && off <= ROUNDING_OF_RADII * self.main.radius {
            return TeeBranch { radius: self.main.radius, ..branch.clone() };
        }
        branch.clone()
    }

    fn placed(&self, index: usize, branch: &TeeBranch) -> Result<Placed> {
        let crossing = Crossing::new(index, &self.main, branch, self.wall.unwrap_or(0.0))?;
        let in_blend = |error: Error| error.in_branch(index, ErrorItem::Blend);
        let Loop { pieces, deviation } = branch.blend.pieces(&crossing).map_err(in_blend)?;
        let depth = self.wall.unwrap_or(0.0);
        let tight = check::check_folds(&crossing, &pieces, depth)?;
        let partition = Partition::new(&crossing, &pieces)?;
        let radii = pieces.iter().map(|piece| radius_law::radii_of(&crossing, piece));
        let radii = radii.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], [c, d]| [a.min(c), b.max(d)]);
        if !(radii[0] > 0.0) {
            return Err(in_blend(Error::Number(NumberError::RadiusNotPositive {
                what: ErrorItem::Blend,
                index: 0,
                radius: radii[0],
            })));
        }
        let place = self.main.ends.into_iter().fold(branch.at.abs() + branch.length, |most, end| most.max(end.abs()));
        let smallest = radii[0].min(branch.radius);
        range::check_size_in_place(ErrorItem::Radius, smallest, place, range::SMALLEST_IN_PLACE).map_err(in_blend)?;
        let [reach, breadth] = check::reach_on_main(&crossing, &partition);
        let facts = TeeBlendFacts {
            radii,
            deviation,
            pieces: partition.pieces.len(),
            tightest: tight.left,
            tightest_at: tight.angle,
        };
        Ok(Placed { crossing, partition, length: branch.length, reach, breadth, facts })
    }
}
