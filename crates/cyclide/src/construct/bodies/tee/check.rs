//! What is refused of a tee: balls without a radius, blends that fold, pipes that end within a blend, branches that meet.

use super::arrangement::{self, Group, LEAST_REST};
use super::canal::Canal;
use super::crossing::Crossing;
use super::loop_piece::LoopPiece;
use super::partition::Partition;
use super::{PipeTee, Placed, TeeMain};
use crate::base::bernstein;
use crate::construct::bodies::tight_place::TightPlace;
use crate::error::{Error, ErrorItem, NumberError, PipeError, Result, TeeError};
use std::f64::consts::FRAC_PI_2;

/// Refuses a blend that folds. With centers m, radii R and the unit normal N of the canal towards the outside of the balls, the derivative along the loop
/// across the circles has, up to a positive factor, the part `|m'|² - R'² - R R'' - R N·m''`: it must stay positive.
///
/// # Errors
/// `tee-blend-folds`.
pub(super) fn check_folds(crossing: &Crossing, pieces: &[LoopPiece], depth: f64) -> Result<TightPlace> {
    let tightest = tightest(crossing, pieces, depth);
    if tightest.left > 0.0 {
        return Ok(tightest);
    }
    let is_of_wall = depth > 0.0 && self::tightest(crossing, pieces, 0.0).left > 0.0;
    let wall = is_of_wall.then_some(depth);
    Err(TeeError::BlendFolds { branch: crossing.branch, angle: tightest.angle, left: tightest.left, wall }.into())
}

/// Where the blend comes nearest to a fold, of the skin so deep.
fn tightest(crossing: &Crossing, pieces: &[LoopPiece], depth: f64) -> TightPlace {
    pieces.iter().fold(TightPlace::NONE, |tightest, piece| {
        // The larger balls of the inner skin fold first.
        let canal = Canal::new(crossing, piece, depth);
        let (centres, radii) = (canal.centres(), canal.radii());
        let canal = canal.into_patch();
        let left = |s: f64| {
            let (motion, growth) = (centres.jet(s).d1, radii.jet(s).d1.x);
            // The Jacobian is the part of the square of the motion.
            let square = motion.length_squared();
            canal.least_jacobian(s) * square / (square - growth * growth)
        };
        tightest.or_of_piece(left, |s| crossing.true_angle(piece.angle(s)))
    })
}

/// The places along the main pipe and the angles round it between which the contact of the blend is, from places of its pieces close together.
pub(super) fn reach_on_main(crossing: &Crossing, partition: &Partition) -> [[f64; 2]; 2] {
    let mut reach = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for piece in &partition.pieces {
        let forms = crossing.forms(piece);
        let places = quotients(&forms.along, &forms.weight).into_iter().map(|place| place + crossing.at);
        // A hole is less than half a turn to both sides.
        let [c, s] = &forms.on_main;
        let angles = quotients(s, c).into_iter().map(|slope| 2.0 * slope.atan());
        for (k, value) in places.map(|place| (0, place)).chain(angles.map(|angle| (1, angle))) {
            reach[k] = [reach[k][0].min(value), reach[k][1].max(value)];
        }
    }
    reach
}

/// The farthest contact along the branch, of a skin.
fn reach_up(crossing: &Crossing, partition: &Partition, depth: f64) -> f64 {
    let canals = partition.pieces.iter().map(|piece| Canal::new(crossing, piece, depth));
    canals.flat_map(|canal| quotients(&canal.height(), &canal.forms.weight)).fold(f64::NEG_INFINITY, f64::max)
}

/// Values of a quotient at places of a piece close together.
fn quotients(above: &crate::rational::Polynomial, below: &crate::rational::Polynomial) -> Vec<f64> {
    let row = |p: &crate::rational::Polynomial| p.coefficients().iter().map(|&c| [c]).collect::<Vec<[f64; 1]>>();
    let (above, below) = (row(above), row(below));
    let at = |k: usize| {
        let t = k as f64 / 32.0;
        bernstein::eval(&above, t)[0] / bernstein::eval(&below, t)[0]
    };
    (0..=32).map(at).collect()
}

impl PipeTee {
    /// Refuses a main pipe that comes to an end before its own.
    ///
    /// # Errors
    /// `parameter-out-of-range`, `radius-not-positive`.
    pub(super) fn check_main(&self) -> Result<()> {
        let TeeMain { radius, taper, ends } = self.main;
        if !(taper.abs() < FRAC_PI_2) {
            let (name, max) = (ErrorItem::Taper, FRAC_PI_2);
            let error = Error::from(NumberError::ParameterOutOfRange { name, value: taper, min: -max, max });
            return Err(error.in_field("main"));
        }
        let inside = radius - self.wall.unwrap_or(0.0) / taper.cos();
        match ends.into_iter().find(|end| !(inside - end * taper.tan() > 0.0)) {
            Some(reached) if inside > 0.0 => {
                let apex = inside / taper.tan();
                Err(PipeError::ConeReachesApex { pipe: 0, apex, reached }.into())
            }
            Some(_) => {
                Err(NumberError::RadiusNotPositive { what: ErrorItem::MainPipe, index: 0, radius: inside }.into())
            }
            None => Ok(()),
        }
    }

    /// Refuses pipes that end within a blend.
    ///
    /// # Errors
    /// `tee-pipe-too-short`.
    pub(super) fn check_room(&self, placed: &[Placed]) -> Result<()> {
        let short = if self.ends == super::TeeEnds::Closed { self.wall.unwrap_or(0.0) } else { 0.0 };
        let rest = LEAST_REST * self.main.radius;
        for (index, branch) in placed.iter().enumerate() {
            // With a branch that grows wider the contact inside is the farther one.
            let depths = [0.0, self.wall.unwrap_or(0.0)];
            let up = depths.map(|depth| reach_up(&branch.crossing, &branch.partition, depth));
            let needed = up[0].max(up[1]) + LEAST_REST * branch.crossing.radii[0] + short;
            if !(branch.length > needed) {
                return Err(TeeError::PipeTooShort {
                    what: ErrorItem::Branch,
                    branch: index,
                    end: branch.length,
                    needed,
                }
                .into());
            }
            // The hole of the inner skin is moved along a cone.
            let rest = rest + self.wall.unwrap_or(0.0) * self.main.taper.sin().abs();
            let [low, high] = [branch.reach[0] - rest - short, branch.reach[1] + rest + short];
            for (end, needed, fits) in
                [(self.main.ends[0], low, self.main.ends[0] < low), (self.main.ends[1], high, self.main.ends[1] > high)]
            {
                if !fits {
                    return Err(TeeError::PipeTooShort { what: ErrorItem::MainPipe, branch: index, end, needed }.into());
                }
            }
        }
        Ok(())
    }

    /// How the branches stand on the main pipe, in the order of their places.
    ///
    /// # Errors
    /// `tee-branches-meet`, `tee-no-free-line`.
    pub(super) fn groups(&self, placed: &[Placed]) -> Result<Vec<Group>> {
        let rest = LEAST_REST * self.main.radius;
        let groups = arrangement::groups(placed, rest)?;
        Self::check_apart(placed, rest)?;
        Ok(groups)
    }
}
