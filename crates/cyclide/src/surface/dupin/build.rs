//! Nets of patches in closed form (`docs/math/cyclides-and-nets.md#weights-of-a-whole-cyclide`).
//!
//! With half angles `cc = cos(th/2) cos(ps/2)`, `sc = sin(th/2) cos(ps/2)`, `cs`, `ss` and `al = sqrt(a-c)`,
//! `be = sqrt(a+c)`:
//! ```text
//! w = al (cc + i ss) + be (k sc - j cs),   |w|² = den = a - c cos th cos ps,   V1 = j, V2 = -k
//! p = (mu (c - a cos th cos ps) + b² cos th,  b sin th (a - mu cos ps),  b sin ps (c cos th - mu)) / den
//! ```
//! The parameter lines `th` = const shrink to points where `mu = c cos th`, the lines `ps` = const where
//! `a = mu cos ps`: these angles are breakpoints. So are 0 and pi, which makes all nine real weights of every patch
//! positive: they are `a ka ka' - c ga ga'` with `ka = (1, cos(d/2), 1)` and `ga = (cos th_0, cos th_mid, cos th_1)`,
//! and `|cos th_mid| <= cos(d/2)` for a step `d` inside `[0, pi]`.
//!
//! With these `V1, V2` the speeds are `q1 ~ a - mu cos ps` and `q2 ~ mu - c cos th`, and `V3 = -i` gives the normal
//! `N`: outward on a ring, on both parts of a spindle and on the larger part of a horn. Between the nodes of a spindle
//! `q1 < 0`: there s runs the other way. Between those of a horn `q2 < 0` and `N` is inward: `V2` is turned round, and
//! `V3` with it. So the normals of all nets are `f_s × f_t` and outward.

use super::{CyclideKind, DupinCyclide, NODE_LIMIT};
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::Vec3;
use crate::error::{ErrorItem, NumberError, Result};
use crate::surface::net::CyclidicNet;
use crate::surface::quad_grid::QuadGrid;
use std::f64::consts::{PI, TAU};

/// Most segments of a turn.
const MAX_SEGMENTS: usize = 4096;
/// Most patches of a cyclide: with their edges and vertices they take two kilobytes each, a gigabyte together.
const MOST_PATCHES: usize = 500_000;

/// Narrowest part relative to the coordinates: some tens of their roundings.
const NARROWEST_IN_PLACE: f64 = 64.0 * f64::EPSILON;

/// Angles from one node to the next, or all round.
struct Range {
    angles: Vec<f64>,
    closed: bool,
    /// The part that contains the angle 0, of two.
    between_nodes: bool,
}

impl Range {
    /// How many steps it has.
    fn steps(&self) -> usize {
        self.angles.len() - usize::from(!self.closed)
    }
}

impl DupinCyclide {
    /// The cyclide as nets of patches: s runs round the long way (`th`), t round the tube (`ps`), in steps of at most
    /// `TAU/segments`, with 0, pi and the nodes among the breakpoints, from 0 (or from the node below it). A ring is
    /// one net, closed in both directions. A horn is two nets, closed along t, with the nodes for sides `s = 0` and
    /// `s = 1`; a spindle is two nets, closed along s, with the nodes for sides `t = 0` and `t = 1`: first the part
    /// that contains the angle 0 (of the spindle: the inner surface, round which s runs the other way), then the other.
    /// If both nodes are one, the part between them is missing. `f_s × f_t` and the normals are outward everywhere. The
    /// weights of the rational forms are all positive.
    ///
    /// # Errors
    /// `parameter-out-of-range` (segments outside 3 to 4096, coordinates above 1e150); `too-many-pieces` (more than half a
    /// million patches together); `below-rounding-of-place` (a net is below 1.5e-11 of its coordinates, or its hole, tube
    /// or part between the nodes narrower than 1.4e-14 of them).
    pub fn nets(&self, segments: [usize; 2]) -> Result<Vec<CyclidicNet>> {
        for (name, value) in [(ErrorItem::SegmentsAlongS, segments[0]), (ErrorItem::SegmentsAlongT, segments[1])] {
            if !(3..=MAX_SEGMENTS).contains(&value) {
                let (value, max) = (value as f64, MAX_SEGMENTS as f64);
                return Err(NumberError::ParameterOutOfRange { name, value, min: 3.0, max }.into());
            }
        }
        let (node_s, node_t) = match self.kind() {
            CyclideKind::Ring => (None, None),
            CyclideKind::Horn => (Some(self.node_angle(self.mu, self.c)), None),
            CyclideKind::Spindle => (None, Some(self.node_angle(self.a, self.mu))),
        };
        let (along_s, along_t) = (ranges(segments[0], node_s), ranges(segments[1], node_t));
        let steps = |ranges: &[Range]| ranges.iter().map(Range::steps).sum::<usize>();
        let patches = steps(&along_s) * steps(&along_t);
        if patches > MOST_PATCHES {
            return Err(NumberError::TooManyPieces {
                what: "the cyclide",
                segment: None,
                needed: patches as f64,
                cap: MOST_PATCHES,
                remedy: "use fewer segments",
            }
            .into());
        }
        let parts = along_s.iter().flat_map(|s| along_t.iter().map(move |t| (s, t)));
        let nets = parts.map(|(s, t)| self.net(s, t)).collect::<Result<_>>()?;
        self.check_narrowest()?;
        Ok(nets)
    }

    /// Refuses a cyclide of which the rounding of its place decides whether it is a ring, a horn or a spindle: a hole, a tube
    /// or a part between nodes that is narrower than that.
    fn check_narrowest(&self) -> Result<()> {
        let place = self.frame.origin().to_vec().max_abs() + self.a + self.mu + self.c;
        for half in [(self.a - self.mu).abs(), (self.mu - self.c).abs()] {
            // Nothing is narrow where both nodes are one.
            if half > NODE_LIMIT * self.a {
                range::check_size_in_place(ErrorItem::NarrowestPart, 2.0 * half, place, NARROWEST_IN_PLACE)?;
            }
        }
        Ok(())
    }

    /// The angle in [0, pi/2] with cosine `x/y`, 0 if these are equal to rounding.
    fn node_angle(&self, x: f64, y: f64) -> f64 {
        if y - x <= NODE_LIMIT * self.a { 0.0 } else { (x / y).acos() }
    }

    fn net(&self, s: &Range, t: &Range) -> Result<CyclidicNet> {
        let Self { a, c, mu, frame } = *self;
        let (al, be, b) = ((a - c).sqrt(), (a + c).sqrt(), ((a - c) * (a + c)).sqrt());
        let turn = frame.rotation();
        let (mut points, mut weights) = (Vec::new(), Vec::new());
        // Speeds and normals as at the top.
        let way = if t.between_nodes { -1.0 } else { 1.0 };
        let v2 = if s.between_nodes { Vec3::Z } else { -Vec3::Z };
        for &ps in &t.angles {
            for th in s.angles.iter().map(|th| way * th) {
                let ((sin_s, cos_s), (sin_t, cos_t)) = (sin_cos(0.5 * th), sin_cos(0.5 * ps));
                let w = Quat::new(al * cos_s * cos_t, al * sin_s * sin_t, -be * cos_s * sin_t, be * sin_s * cos_t);
                weights.push(turn * w * (1.0 / a.sqrt()));
                let ((st, ct), (sp, cp)) = (sin_cos(th), sin_cos(ps));
                let p = Vec3::new(mu * (c - a * ct * cp) + b * b * ct, b * st * (a - mu * cp), b * sp * (c * ct - mu))
                    / (a - c * ct * cp);
                points.push(frame.origin() + frame.x() * p.x + frame.y() * p.y + frame.z() * p.z);
            }
        }
        let size = [s.angles.len(), t.angles.len()];
        // The nodes are one point each.
        let [m, n] = size;
        if !s.closed {
            for i in [0, m - 1] {
                (1..n).for_each(|j| points[i + j * m] = points[i]);
            }
        }
        if !t.closed {
            for j in [0, n - 1] {
                (1..m).for_each(|i| points[i + j * m] = points[j * m]);
            }
        }
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        let grid = QuadGrid::new(points, size, [s.closed, t.closed])?;
        grid.check_place()?;
        // After a full turn the half angles are half a turn further.
        Ok(CyclidicNet::from_weights_unchecked(grid, weights, [Vec3::Y, v2], [-1.0, -1.0]))
    }
}

/// Sine and cosine, exactly 0 where they are zero up to the rounding of pi.
fn sin_cos(angle: f64) -> (f64, f64) {
    let settle = |x: f64| if x.abs() <= 4.0 * f64::EPSILON { 0.0 } else { x };
    let (sin, cos) = angle.sin_cos();
    (settle(sin), settle(cos))
}

/// The whole turn, or its two parts between the angles `-node` and `node` (only the second if node is 0).
fn ranges(segments: usize, node: Option<f64>) -> Vec<Range> {
    let step = TAU / segments as f64;
    let chain = |fixed: &[f64]| {
        let mut angles = vec![fixed[0]];
        for ends in fixed.windows(2) {
            let (from, to) = (ends[0], ends[1]);
            // A span that is a whole number of steps up to rounding has that number.
            let parts = (((to - from) / step) * (1.0 - 1e-12)).ceil().max(1.0) as usize;
            angles.extend(
                (1..=parts).map(|k| if k == parts { to } else { from + (to - from) * k as f64 / parts as f64 }),
            );
        }
        angles
    };
    match node {
        None => {
            let mut angles = chain(&[0.0, PI, TAU]);
            angles.pop(); // the first again
            vec![Range { angles, closed: true, between_nodes: false }]
        }
        Some(node) => {
            let outer = Range { angles: chain(&[node, PI, TAU - node]), closed: false, between_nodes: false };
            if node == 0.0 {
                return vec![outer];
            }
            vec![Range { angles: chain(&[-node, 0.0, node]), closed: false, between_nodes: true }, outer]
        }
    }
}
