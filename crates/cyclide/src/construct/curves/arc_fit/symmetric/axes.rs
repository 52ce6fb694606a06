//! The axes of symmetry of a trace (`docs/math/arc-fitting.md#symmetry`).

use super::Symmetric;
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::curvature_interval::JointFrame;
use crate::construct::curves::arc_fit::piece::Piece;
use std::f64::consts::PI;
use std::ops::Range;

/// Mirror images are this part of the tolerance off the points at most.
const ALIKE: f64 = 0.2;
/// A path is this part of it off its mirror image at most, where it is symmetric.
const SAME: f64 = 0.05;
/// Longer paths are not looked at.
const MOST: usize = 1000;

/// The part of a trace between two axes; places count half steps.
pub(super) struct Sector {
    pub places: Range<usize>,
    /// Unit normals of the axes, in the direction of the trace there.
    pub normals: [Vec2; 2],
}

/// The trace in its plane.
pub(super) struct Flat<'a> {
    pub points: &'a [Point2],
    pub center: Point2,
    pub symmetric: &'a Symmetric<'a>,
}

/// The normals of two axes, turned by as little as makes their mirror images a turn by one in so many of a full one: rounded points
/// have them a little off, and as many images would not meet.
fn at_a_part_of_a_turn(first: Vec2, second: Vec2, count: usize) -> [Vec2; 2] {
    let angle = first.cross(second).atan2(first.dot(second));
    let part = PI / count as f64;
    let (sin, cos) = (0.5 * ((angle / part).round() * part - angle)).sin_cos();
    let turned = |v: Vec2, sin: f64| Vec2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y);
    [turned(first, -sin), turned(second, sin)]
}

impl Flat<'_> {
    /// Sectors to try, the better ones first: those of all axes that the points have, then those of one of them. Of each kind there
    /// are two, which begin at either of their axes.
    pub(super) fn sectors(&self) -> Vec<Vec<Sector>> {
        let n = self.points.len();
        if n < 3 {
            return Vec::new();
        }
        if !self.symmetric.trace.closed {
            let middle = n - 1;
            let half = |normal: Vec2| {
                [0..middle, middle..2 * middle].map(|places| Sector { places, normals: [normal; 2] }).into()
            };
            return self.normal(middle).map(half).into_iter().collect();
        }
        let mut axes = (0..n).filter_map(|sum| Some((sum, self.normal(sum)?)));
        let Some(first) = axes.next() else { return Vec::new() };
        let next = axes.next();
        let opposite = (first.0 + n, self.normal_at(first.0 + n, first.1));
        let pair = |(from, normal): (usize, Vec2), (to, other): (usize, Vec2)| {
            let reach = to - from;
            let [normal, other] = at_a_part_of_a_turn(normal, other, n / reach);
            let image = normal - other * (2.0 * normal.dot(other));
            let beyond = self.normal_at(to + reach, image);
            vec![
                Sector { places: from..to, normals: [normal, other] },
                Sector { places: to..to + reach, normals: [other, beyond] },
            ]
        };
        next.into_iter().chain([opposite]).map(|to| pair(first, to)).collect()
    }

    /// The unit normal of the axis that takes each point to the one at the rest of the sum, if there is one, in the direction of the
    /// trace at half of the sum.
    fn normal(&self, sum: usize) -> Option<Vec2> {
        let n = self.points.len();
        let trace = self.symmetric.trace;
        let allowed = ALIKE * self.symmetric.tolerance;
        let image = |i: usize| (sum + n - i) % n;
        let out = |i: usize| (self.points[i] - self.center).length();
        let is_like = |i: usize| {
            let j = image(i);
            (out(i) - out(j)).abs() <= allowed
                && trace.vertex[i].is_some() == trace.vertex[j].is_some()
                && (trace.slack[i] - trace.slack[j]).abs() <= allowed
                && self.symmetric.is_corner(2 * i) == self.symmetric.is_corner(2 * j)
        };
        if !(0..n).all(is_like) {
            return None;
        }
        let across = |i: usize| self.points[image(i)] - self.points[i];
        let farthest = (0..n).max_by(|i, j| across(*i).length().total_cmp(&across(*j).length()))?;
        let along = across(farthest);
        let whole =
            (0..n).map(across).fold(Vec2::default(), |sum, v| if v.dot(along) < 0.0 { sum - v } else { sum + v });
        let normal = whole.unit()?;
        (0..n)
            .all(|i| self.mirrored(self.points[i], normal).distance(self.points[image(i)]) <= allowed)
            .then(|| self.normal_at(sum, normal))
    }

    /// A normal, or its opposite, as the trace runs at a place.
    fn normal_at(&self, half: usize, normal: Vec2) -> Vec2 {
        let n = self.points.len();
        let step = self.points[(half + 2) / 2 % n] - self.points[(half + 2 * n - 1) / 2 % n];
        if step.dot(normal) < 0.0 { -normal } else { normal }
    }

    pub(super) fn mirrored(&self, p: Point2, normal: Vec2) -> Point2 {
        p + normal * (-2.0 * (p - self.center).dot(normal))
    }

    /// Whether the middles of all pieces are on the path again when they are mirrored at the axes of sectors.
    pub(super) fn is_symmetric(&self, path: &[Piece], sectors: &[Sector]) -> bool {
        let Symmetric { frame, tolerance, .. } = self.symmetric;
        let is_on = |p: Point3| path.iter().any(|piece| piece.arc.closest_point(p).distance <= SAME * tolerance);
        let image =
            |piece: &Piece, normal: Vec2| frame.to_world(self.mirrored(frame.to_local(piece.arc.midpoint()).0, normal));
        let mut normals = sectors.iter().flat_map(|sector| sector.normals);
        path.len() <= MOST && normals.all(|normal| path.iter().all(|piece| is_on(image(piece, normal))))
    }

    /// The joint on an axis nearest to the trace there, and the tangent across it.
    pub(super) fn on_axis(&self, place: Point2, tangent: Vec2) -> JointFrame {
        JointFrame { joint: place + tangent * -(place - self.center).dot(tangent), tangent }
    }
}
