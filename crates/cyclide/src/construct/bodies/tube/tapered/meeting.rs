//! Whether a tube of circles runs into itself or into another: pairs of parts, halved until they are apart, are neighbors, or are so short that their
//! disks are compared (`docs/math/tubes.md#disks-that-meet`).

use super::super::super::center_line::{CenterLine, Crossing};
use super::super::meeting::{MOST_PAIRS, SHORT, Section, TOUCHING};
use super::piece::Piece;
use crate::base::box_tree::BoxTree;
use crate::base::segments::nearest_of_segments;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ParamCurve as _};
use crate::error::{PipeError, Result};
use crate::rational::Polynomial;
use std::f64::consts::PI;

/// The disks of a tube, with those of its round ends.
pub(super) struct Course {
    stretches: Vec<Stretch>,
    /// Length before each, and of all.
    before: Vec<f64>,
    closed: bool,
    tree: BoxTree,
}

struct Stretch {
    arc: Arc,
    radius: Radius,
    most: f64,
    curvature: f64,
    length: f64,
    source: usize,
}

/// The radius over a stretch.
enum Radius {
    Law(Polynomial),
    /// A part of a ball: its radius, and the heights above its center at both ends.
    Ball(f64, [f64; 2]),
}

impl Stretch {
    fn of(piece: &Piece) -> Self {
        let (arc, most) = (piece.arc, piece.most);
        let radius = Radius::Law(piece.radius.clone());
        Self { radius, most, curvature: arc.curvature(), length: arc.length(), source: piece.source, arc }
    }

    /// A round end.
    fn cap(piece: &Piece, last: bool) -> Option<Self> {
        let (center, slope) =
            if last { (piece.arc.end(), piece.slopes[1]) } else { (piece.arc.start(), -piece.slopes[0]) };
        let outwards = if last { piece.arc.end_tangent()? } else { -piece.arc.start_tangent()? };
        let circle = piece.radius.value(f64::from(u8::from(last)));
        let (ball, foot) = (circle * 1.0_f64.hypot(slope), -circle * slope);
        let apex = center + outwards * (ball - foot);
        let (arc, heights) = if last { ((center, apex), [foot, ball]) } else { ((apex, center), [ball, foot]) };
        let arc = Arc::segment(arc.0, arc.1).ok()?;
        let radius = Radius::Ball(ball, heights);
        Some(Self { radius, most: ball, curvature: 0.0, length: arc.length(), source: piece.source, arc })
    }

    fn radius(&self, t: f64) -> f64 {
        match &self.radius {
            Radius::Law(law) => law.value(t),
            Radius::Ball(ball, [from, to]) => {
                let height = from + (to - from) * t;
                (ball * ball - height * height).max(0.0).sqrt()
            }
        }
    }

    /// The largest radius over a range: laws are monotone.
    fn most(&self, [from, to]: [f64; 2]) -> f64 {
        match self.radius {
            Radius::Law(_) => self.radius(from).max(self.radius(to)),
            Radius::Ball(..) => self.most,
        }
    }

    fn disk(&self, t: f64) -> Section {
        let axis = self.arc.piece_jet(0, t).d1.unit().unwrap_or(Vec3::X);
        Section { center: self.arc.point(t), axis, radius: self.radius(t) }
    }
}

/// A part of a stretch.
#[derive(Clone, Copy)]
struct Part {
    stretch: usize,
    range: [f64; 2],
    ends: [Point3; 2],
    /// No disk reaches farther than this from the chord.
    reach: f64,
    most: f64,
    /// Lengths along the tube.
    at: [f64; 2],
}

impl Part {
    fn steps(&self) -> f64 {
        self.ends[0].distance(self.ends[1]) / self.most
    }
}

/// Two disks that cross.
struct Meeting {
    sources: [usize; 2],
    centers: [Point3; 2],
    radii: [f64; 2],
}

/// Refuses a tube that runs into itself.
///
/// # Errors
/// `pipe-meets-itself`.
pub(super) fn check(course: &Course) -> Result<()> {
    let mut left = MOST_PAIRS;
    let found = course.tree.find_within(|_, _| false, |i, j| meeting([course, course], [i, j], true, &mut left));
    found.map_or(Ok(()), |Meeting { sources: [a, b], centers: [p, q], radii }| {
        let limit = radii[0] + radii[1];
        // Round ends are no part of it.
        let is_piece = |stretch: &&Stretch| matches!(stretch.radius, Radius::Law(_));
        let stretches: Vec<&Stretch> = course.stretches.iter().filter(is_piece).collect();
        let line = CenterLine {
            count: stretches.len(),
            closed: course.closed,
            point: &|stretch, t| stretches[stretch].arc.point(t),
            sagitta: &|stretch, [from, to]| {
                let own = stretches[stretch];
                0.125 * own.curvature * own.arc.piece_length(0, from, to).powi(2)
            },
        };
        // No thinner tube helps there: that is said first.
        let ([a, b], point, distance) = match line.crossing(limit) {
            Some(Crossing { pieces, point, distance }) => {
                (pieces.map(|stretch| stretches[stretch].source), point, distance)
            }
            None => ([a, b], p.midpoint(q), p.distance(q)),
        };
        let point = point.to_array();
        Err(PipeError::MeetsItself { first: a.min(b), second: a.max(b), point, distance, limit }.into())
    })
}

/// The first two of several tubes that run into each other, with the distance of the centers of disks that do.
pub(super) fn first(courses: &[Course]) -> Option<([usize; 2], f64)> {
    let mut left = MOST_PAIRS;
    courses.iter().enumerate().find_map(|(k, second)| {
        courses[..k].iter().enumerate().find_map(|(other, first)| {
            let found =
                first.tree.find_between(&second.tree, |i, j| meeting([first, second], [i, j], false, &mut left));
            found.map(|Meeting { centers: [p, q], .. }| ([other, k], p.distance(q)))
        })
    })
}

fn meeting(courses: [&Course; 2], [i, j]: [usize; 2], same: bool, left: &mut usize) -> Option<Meeting> {
    // Disks across one arc of less than a turn lie in half planes from its axis, those across a segment in parallel planes.
    if same && i == j {
        return None;
    }
    let mut waiting = vec![[courses[0].part(i, [0.0, 1.0]), courses[1].part(j, [0.0, 1.0])]];
    while let Some([a, b]) = waiting.pop() {
        *left = left.saturating_sub(1);
        if same && courses[0].are_neighbors(&a, &b) {
            continue;
        }
        let (distance, at) = nearest_of_segments([a.ends, b.ends]);
        if distance >= (a.reach + b.reach) * (1.0 - TOUCHING) {
            continue;
        }
        if a.steps().max(b.steps()) <= SHORT || *left == 0 {
            let found = compared(courses, [&a, &b], at, same);
            if found.is_some() {
                return found;
            }
        } else if a.steps() > b.steps() {
            waiting.extend(courses[0].halves(&a).map(|half| [half, b]));
        } else {
            waiting.extend(courses[1].halves(&b).map(|half| [a, half]));
        }
    }
    None
}

/// Compares disks of two short parts: at their ends, in their middles, and where their chords are nearest. Disks of strands beside each other do not cross; so it is also looked
/// whether the rim of one, where it is nearest to the other, is inside that.
fn compared(courses: [&Course; 2], parts: [&Part; 2], nearest: [f64; 2], same: bool) -> Option<Meeting> {
    let stretches = [0, 1].map(|k| &courses[k].stretches[parts[k].stretch]);
    let disks = [0, 1].map(|k| {
        let [from, to] = parts[k].range;
        [0.0, 0.5, 1.0, nearest[k]].map(|x| stretches[k].disk(from + (to - from) * x))
    });
    let meeting = |a: Section, b: Section| Meeting {
        sources: stretches.map(|stretch| stretch.source),
        centers: [a.center, b.center],
        radii: [a.radius, b.radius],
    };
    let adjoining = |a: &Section, b: &Section| same && a.center.distance(b.center) <= TOUCHING * a.radius.max(b.radius);
    let mut pairs = disks[0].iter().flat_map(|a| disks[1].iter().map(move |b| (a, b)));
    if let Some((a, b)) = pairs.find(|(a, b)| !adjoining(a, b) && a.meets(**b)) {
        return Some(meeting(*a, *b));
    }
    let inside = |k: usize| {
        let other = stretches[1 - k];
        disks[k].iter().find_map(|disk| {
            let center = other.arc.closest_point(disk.center).t;
            let way = other.arc.point(center) - disk.center;
            let towards = (way - disk.axis * way.dot(disk.axis)).unit()?;
            let rim = disk.center + towards * (disk.radius * (1.0 - TOUCHING)).min(way.length());
            let t = other.arc.closest_point(rim).t;
            let (found, off) = (other.disk(t), rim - other.arc.point(t));
            let across = (t > 0.0 && t < 1.0) || off.dot(found.axis).abs() <= TOUCHING * off.length();
            let is_inside = across && off.length() < found.radius * (1.0 - TOUCHING) && !adjoining(disk, &found);
            is_inside.then(|| meeting(*disk, found))
        })
    };
    inside(0).or_else(|| inside(1))
}

impl Course {
    pub(super) fn new(pieces: &[Piece], closed: bool, round: bool) -> Self {
        let ends = if closed || !round { [None, None] } else { [pieces.first(), pieces.last()] };
        let [first, last] = [0, 1].map(|k: usize| ends[k].and_then(|piece| Stretch::cap(piece, k == 1)));
        let stretches: Vec<Stretch> = first.into_iter().chain(pieces.iter().map(Stretch::of)).chain(last).collect();
        let mut before = vec![0.0];
        let mut length = 0.0;
        let mut boxes = Vec::with_capacity(stretches.len());
        for stretch in &stretches {
            length += stretch.length;
            before.push(length);
            boxes.push(stretch.arc.bounds().grown(stretch.most));
        }
        Self { stretches, before, closed, tree: BoxTree::new(&boxes) }
    }

    fn part(&self, stretch: usize, range: [f64; 2]) -> Part {
        let own = &self.stretches[stretch];
        let lengths = range.map(|t| own.arc.length_to(t));
        let sagitta = own.curvature * (lengths[1] - lengths[0]).powi(2) / 8.0;
        let most = own.most(range);
        let at = lengths.map(|length| self.before[stretch] + length);
        Part { stretch, range, ends: range.map(|t| own.arc.point(t)), reach: most + sagitta, most, at }
    }

    fn halves(&self, part: &Part) -> [Part; 2] {
        let [from, to] = part.range;
        let middle = 0.5 * (from + to);
        [[from, middle], [middle, to]].map(|range| self.part(part.stretch, range))
    }

    /// True if no disks between the start of the one part and the end of the other can meet, by all that is between them: with a curvature of at most k and radii of at
    /// most 1/k disks less than half a turn of that radius apart along the spine do not.
    fn are_neighbors(&self, a: &Part, b: &Part) -> bool {
        let n = self.stretches.len();
        let run_on = |first: &Part, second: &Part, length: f64| {
            let (mut curvature, mut most) = (0.0_f64, first.most.max(second.most));
            let mut at = first.stretch;
            loop {
                let stretch = &self.stretches[at];
                curvature = curvature.max(stretch.curvature);
                let range = match (at == first.stretch, at == second.stretch) {
                    (true, _) => [first.range[0], 1.0],
                    (_, true) => [0.0, second.range[1]],
                    _ => [0.0, 1.0],
                };
                most = most.max(stretch.most(range));
                if at == second.stretch {
                    return curvature * most <= 1.0 && curvature * length <= PI;
                }
                if curvature * most > 1.0 || curvature * length > PI {
                    return false;
                }
                at = (at + 1) % n;
            }
        };
        let (first, second) = if a.stretch < b.stretch { (a, b) } else { (b, a) };
        run_on(first, second, second.at[1] - first.at[0])
            || (self.closed && run_on(second, first, self.before[n] - second.at[0] + first.at[1]))
    }
}
