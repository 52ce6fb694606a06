//! Places on a curve through those of the poses, turns on a spline of their own.

use super::span::PlaceSpan;
use super::turns::smooth_turns;
use super::{DecoupledMotion, Given};
use crate::base::vector::{Point3, Vec3};
use crate::curve::{CircleSpline, ParamCurve};
use crate::error::{CurveError, Result};
use crate::motion::timed_pose::TimedPose;

/// A piece of a curve starts and ends where its poses are, to this part of the coordinates.
const SAME_PLACE: f64 = 1e-9;
/// A cubic from 0 to 1 is monotone if its slopes at both ends are not above this.
const MONOTONE: f64 = 3.0;

impl DecoupledMotion {
    /// The places of poses of which each differs from the one before: what [`on_curve`](Self::on_curve) wants a curve through. A closed curve does not
    /// repeat the first of them.
    #[must_use]
    pub fn places_of_curve(poses: &[TimedPose], closed: bool) -> Vec<Point3> {
        let mut places: Vec<Point3> = Vec::with_capacity(poses.len());
        for pose in poses {
            let place = Point3::ORIGIN + pose.pose.translation();
            if places.last().is_none_or(|before| before.distance(place) > same(*before, place)) {
                places.push(place);
            }
        }
        if closed && places.len() > 1 && places[0].distance(places[places.len() - 1]) <= same(places[0], places[0]) {
            places.pop();
        }
        places
    }

    /// A C1 motion through poses with the origin on a curve, a piece from each pose to the next, and turns on a C1 spline of rotations that runs beyond no pose.
    /// Between poses at one place the body stays there, and the curve has no piece. It stops at corners and cusps of the curve. `closing` as in
    /// [`linear`](Self::linear), of a closed curve.
    ///
    /// ```
    /// use cyclide::{Quat, Vec3, construct::FairSplineOptions, curve::CircleSpline, motion::{DecoupledMotion, Pose, TimedPose}};
    /// let at = |time: f64, place: [f64; 3], turn: f64| TimedPose {
    ///     time,
    ///     pose: Pose::new(Quat::from_axis_angle(Vec3::Z, turn), Vec3::from(place)).unwrap(),
    /// };
    /// let poses = [at(0.0, [0.0, 0.0, 0.0], 0.0), at(1.0, [10.0, 0.0, 0.0], 1.0), at(2.0, [10.0, 10.0, 0.0], 1.0)];
    /// let curve = CircleSpline::fair(&DecoupledMotion::places_of_curve(&poses, false), &FairSplineOptions::default())?;
    /// let motion = DecoupledMotion::on_curve(&poses, None, curve)?;
    /// assert!((motion.pose(1.0).translation() - Vec3::X * 10.0).length() < 1e-12);
    /// assert!(motion.pose(1.5).angle_to(poses[1].pose) < 1e-15); // it does not turn where the poses do not
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`linear`](Self::linear); `disconnected` if the curve does not have a piece for each pair of poses with different places, from one to the other.
    pub fn on_curve(poses: &[TimedPose], closing: Option<f64>, curve: CircleSpline) -> Result<Self> {
        let given = Given::new(poses, closing)?;
        let points: Vec<Point3> = given.places.iter().map(|place| Point3::ORIGIN + *place).collect();
        // The pieces of the spans; none where the body stays.
        let mut pieces: Vec<Option<usize>> = Vec::with_capacity(given.spans());
        let mut next = 0;
        for pair in points.windows(2) {
            let moves = pair[0].distance(pair[1]) > same(pair[0], pair[1]);
            pieces.push(moves.then_some(next));
            next += usize::from(moves);
        }
        for (span, piece) in pieces.iter().enumerate() {
            let Some(piece) = *piece else { continue };
            let gap = if piece < curve.piece_count() {
                let ends = [0.0, 1.0].map(|s| curve.piece_point(piece, s));
                ends[0].distance(points[span]).max(ends[1].distance(points[span + 1]))
            } else {
                f64::INFINITY
            };
            let limit = SAME_PLACE * points[span].to_vec().max_abs().max(points[span + 1].to_vec().max_abs());
            if !(gap <= limit) {
                return Err(CurveError::Disconnected { piece, next: piece + 1, gap, limit }.into());
            }
        }
        let laws = laws(&given, &pieces, &curve);
        let places = (0..given.spans()).map(|span| match (pieces[span], laws[span]) {
            (Some(piece), law) => PlaceSpan::OnCurve { piece, law },
            (None, _) => PlaceSpan::line([given.places[span]; 2]),
        });
        let places = places.collect();
        let turns = smooth_turns(&given);
        let motion = given.into_motion(places, turns);
        Ok(Self { curve: Some(curve), ..motion })
    }
}

/// Places up to this apart are one.
fn same(a: Point3, b: Point3) -> f64 {
    1e-12 * a.to_vec().max_abs().max(b.to_vec().max_abs())
}

/// The parameter of each piece by the part of its span, as Bernstein coefficients: rising, and with one speed of the body where two pieces meet, the harmonic
/// mean of those over both.
fn laws(given: &Given, pieces: &[Option<usize>], curve: &CircleSpline) -> Vec<[f64; 4]> {
    let last = pieces.len();
    let average =
        |span: usize| pieces[span].map_or(0.0, |piece| curve.piece_length(piece, 0.0, 1.0) / given.step(span));
    // Speeds along one line.
    let averages: Vec<Vec3> = (0..last).map(|span| Vec3::X * average(span)).collect();
    let mut speeds: Vec<f64> =
        super::turns::node_velocities(&averages, given.closed).into_iter().map(|v| v.x).collect();
    // The speed of the curve at an end of a span, by the part of it.
    let own = |span: usize, s: f64| pieces[span].map(|piece| curve.piece_speed(piece, s));
    for (node, speed) in speeds.iter_mut().enumerate() {
        let before = if node > 0 { Some(node - 1) } else { given.closed.then_some(last - 1) };
        let after = if node < last { Some(node) } else { given.closed.then_some(0) };
        let kink = match (before, after) {
            (Some(_), Some(after)) => pieces[after].is_some_and(|piece| curve.kinks().contains(&piece)),
            _ => false,
        };
        let ends = [before.map(|span| (span, 1.0)), after.map(|span| (span, 0.0))];
        for (span, s) in ends.into_iter().flatten() {
            let most = own(span, s).map_or(0.0, |own| MONOTONE * own / given.step(span));
            *speed = speed.clamp(0.0, most);
        }
        if kink {
            *speed = 0.0;
        }
    }
    (0..last)
        .map(|span| {
            let slope = |node: usize, s: f64| {
                let own = own(span, s).filter(|own| *own > 0.0);
                own.map_or(0.0, |own| (speeds[node] * given.step(span) / own).clamp(0.0, MONOTONE))
            };
            [0.0, slope(span, 0.0) / 3.0, 1.0 - slope(span + 1, 1.0) / 3.0, 1.0]
        })
        .collect()
}
