//! Panels that are the same piece, wherever they are.

use super::unit_patch::UnitPatch;
use crate::base::svd3::nearest_rotation;
use crate::base::vector::Vec3;
use crate::error::{Result, check_tolerance};
use crate::surface::CyclidePatch;
use std::collections::HashMap;

/// Points of a comparison along each direction: corners, three points of each side, nine inside.
const POINTS: usize = 5;
const ALL: usize = POINTS * POINTS;
/// Cells of the table of classes are this much larger than they have to be, for rounding, relative to the tolerance and to lengths.
const ROUNDING: [f64; 2] = [1e-9, 1e-13];
/// Lengths of a panel that no motion changes, and how many of them the table is by.
const LENGTHS: usize = 14;
const KEYS: [usize; 3] = [3, 5, 9];
/// Rounds of weights at most, towards the least largest distance; it is within this factor of it, or below this part of the tolerance: done.
const ROUNDS: usize = 40;
const LEVEL: f64 = 1.003;
const NEGLIGIBLE: f64 = 1e-3;

/// A panel of a class.
///
/// ```
/// let patch = cyclide::surface::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let found = cyclide::panel::Congruences::new(&[patch, patch], 1e-9)?;
/// let second = found.classes[0].panels[1];
/// assert_eq!((second.panel, second.corners, second.turned_over), (1, [0, 1, 2, 3], false));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CongruentPanel {
    /// Its number among the panels given.
    pub panel: usize,
    /// Largest distance of its points from those of the first panel of the class, laid on it so that it is least; of 25 points, corners
    /// and sides among them.
    pub deviation: f64,
    /// The corners `a0, a1, a2, a3` of the first panel of the class as corners of this one.
    pub corners: [usize; 4],
    /// True if the motion lays its unit normals on the opposite ones: the same sheet, with the other side out.
    pub turned_over: bool,
}

/// Panels that are congruent: one is laid on any other by a motion, without a reflection.
///
/// ```
/// let patch = cyclide::surface::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let found = cyclide::panel::Congruences::new(&[patch], 1e-9)?;
/// assert_eq!(found.classes[0].panels.len(), 1);
/// // Between two parallels and two meridians a torus is symmetric: its own mirror image.
/// assert!(found.classes[0].mirror.is_some_and(|(class, _)| class == 0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CongruenceClass {
    /// The panels. The first is that to which the others were compared.
    pub panels: Vec<CongruentPanel>,
    /// The class of the mirror images of these panels, with its deviation; itself if they are symmetric. A mirror image is another
    /// panel, but a mould of a surface of revolution makes both: one of them turned over or from the other end.
    pub mirror: Option<(usize, f64)>,
}

/// Panels in classes of congruent ones.
///
/// Corners, sides and inside are compared at the same parameters, evened so that these do not depend on how the panel was made, in every order
/// of the corners that goes round the panel; the motion is that of the least largest distance, to a percent or two or a thousandth of the
/// tolerance, and never told as less than it is: all are really within the tolerance.
///
/// The first panel of a class, in the order of their lengths, takes all that are within the tolerance of it; each of the others goes to the
/// class it is nearest to. Panels are found by lengths that motions keep, so that time is that of the panels and the pairs within tolerance, not of all pairs.
///
/// ```
/// use cyclide::{panel::Congruences, surface::DupinCyclide};
/// let ring = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 6])?;
/// let panels: Vec<_> = ring[0].patches().collect();
/// let found = Congruences::new(&panels, 1e-9)?;
/// assert!(found.classes.len() < panels.len() && found.classes.iter().all(|class| class.panels[0].deviation < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Congruences {
    /// The classes, by the number of their lowest panel.
    pub classes: Vec<CongruenceClass>,
}

impl Congruences {
    /// The classes of panels. They do not depend on the order of the panels, as long as no panel is within the tolerance of two that are not within it of each other and alike in all lengths but for rounding.
    ///
    /// # Errors
    /// `tolerance-not-positive`.
    pub fn new(panels: &[CyclidePatch], tolerance: f64) -> Result<Self> {
        check_tolerance(tolerance)?;
        let lengths: Vec<[f64; LENGTHS]> = panels.iter().map(lengths).collect();
        let largest = lengths.iter().flatten().copied().fold(0.0, f64::max);
        // Points that are moved by a tolerance each change lengths by two.
        let reach = 2.0 * tolerance * (1.0 + ROUNDING[0]) + ROUNDING[1] * largest;
        let mut order: Vec<usize> = (0..panels.len()).collect();
        order.sort_by(|&a, &b| compare(&lengths[a], &lengths[b]).then(a.cmp(&b)));
        let mut table = Table { reach, cells: HashMap::new() };
        let mut classes: Vec<(usize, CongruenceClass)> = Vec::new();
        for panel in order {
            let mut best: Option<(usize, CongruentPanel)> = None;
            let own = points(&panels[panel]);
            for class in table.near(&lengths[panel]) {
                let leader = classes[class].0;
                if !are_near(&lengths[leader], &lengths[panel], reach) {
                    continue;
                }
                let Some(laid) = laid(&points(&panels[leader]), &own, tolerance, false) else { continue };
                if best.is_none_or(|(at, b)| (laid.deviation, class) < (b.deviation, at)) {
                    best = Some((class, CongruentPanel { panel, ..laid }));
                }
            }
            match best {
                Some((class, member)) => classes[class].1.panels.push(member),
                None => {
                    table.insert(&lengths[panel], classes.len());
                    let first = CongruentPanel { panel, deviation: 0.0, corners: [0, 1, 2, 3], turned_over: false };
                    classes.push((panel, CongruenceClass { panels: vec![first], mirror: None }));
                }
            }
        }
        let mirrors: Vec<Option<(usize, f64)>> = classes
            .iter()
            .map(|(leader, _)| {
                let own = points(&panels[*leader]);
                let near = table.near(&lengths[*leader]).into_iter();
                let mirrors = near.filter(|class| are_near(&lengths[classes[*class].0], &lengths[*leader], reach));
                let laid = mirrors.filter_map(|class| {
                    Some((class, laid(&points(&panels[classes[class].0]), &own, tolerance, true)?.deviation))
                });
                laid.min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)))
            })
            .collect();
        Ok(Self { classes: in_order(classes.into_iter().map(|(_, class)| class).collect(), mirrors) })
    }
}

/// Classes by their lowest panel, the members after the first by their numbers, with the numbers of the classes of mirror images.
fn in_order(mut classes: Vec<CongruenceClass>, mirrors: Vec<Option<(usize, f64)>>) -> Vec<CongruenceClass> {
    let lowest = |class: &CongruenceClass| class.panels.iter().map(|member| member.panel).min();
    let mut order: Vec<usize> = (0..classes.len()).collect();
    order.sort_by_key(|k| lowest(&classes[*k]));
    let mut place = vec![0; order.len()];
    for (new, old) in order.iter().enumerate() {
        place[*old] = new;
    }
    for (class, mirror) in classes.iter_mut().zip(mirrors) {
        class.mirror = mirror.map(|(at, deviation)| (place[at], deviation));
        class.panels[1..].sort_by_key(|member| member.panel);
    }
    classes.sort_by_key(lowest);
    classes
}

fn compare(a: &[f64], b: &[f64]) -> std::cmp::Ordering {
    let mut pairs = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
    pairs.find(|order| order.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
}

fn are_near(a: &[f64; LENGTHS], b: &[f64; LENGTHS], reach: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= reach)
}

/// The points of a panel, from its first corner, s fastest.
fn points(patch: &CyclidePatch) -> [Vec3; ALL] {
    let unit = UnitPatch::new(patch);
    let step = 1.0 / (POINTS - 1) as f64;
    std::array::from_fn(|k| unit.at(((k % POINTS) as f64 * step, (k / POINTS) as f64 * step)) * unit.size)
}

/// Lengths that no motion, reflection or order of the corners changes, each kind in ascending order: chords of the sides, diagonals, from the
/// middle to the middles of the sides, to the corners.
fn lengths(patch: &CyclidePatch) -> [f64; LENGTHS] {
    let unit = UnitPatch::new(patch);
    let at = |s: f64, t: f64| unit.at((s, t)) * unit.size;
    let [a, b, c, d] = [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0), at(1.0, 1.0)];
    let middle = at(0.5, 0.5);
    let from_middle = |p: Vec3| (p - middle).length();
    let sorted = |mut values: [f64; 4]| {
        values.sort_by(f64::total_cmp);
        values
    };
    let chords = sorted([(b - a).length(), (d - c).length(), (c - a).length(), (d - b).length()]);
    let (p, q) = ((d - a).length(), (c - b).length());
    let sides = sorted([at(0.5, 0.0), at(0.5, 1.0), at(0.0, 0.5), at(1.0, 0.5)].map(from_middle));
    let corners = sorted([a, b, c, d].map(from_middle));
    let mut all = [0.0; LENGTHS];
    all[..4].copy_from_slice(&chords);
    all[4..6].copy_from_slice(&[p.min(q), p.max(q)]);
    all[6..10].copy_from_slice(&sides);
    all[10..].copy_from_slice(&corners);
    all
}

/// Classes by cells of some of the lengths of their first panels.
struct Table {
    reach: f64,
    cells: HashMap<[i64; KEYS.len()], Vec<usize>>,
}

impl Table {
    fn cell(&self, lengths: &[f64; LENGTHS]) -> [i64; KEYS.len()] {
        // Beyond the range of integers all are in one cell: found, if slowly.
        KEYS.map(|key| (lengths[key] / self.reach).floor() as i64)
    }

    fn insert(&mut self, lengths: &[f64; LENGTHS], class: usize) {
        let cell = self.cell(lengths);
        self.cells.entry(cell).or_default().push(class);
    }

    /// Classes in the cells around, in ascending order.
    fn near(&self, lengths: &[f64; LENGTHS]) -> Vec<usize> {
        let [x, y, z] = self.cell(lengths);
        let around = |c: i64| [c.saturating_sub(1), c, c.saturating_add(1)];
        let mut found = Vec::new();
        for x in around(x) {
            for y in around(y) {
                for z in around(z) {
                    found.extend(self.cells.get(&[x, y, z]).into_iter().flatten());
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// The places of a grid of points in the eight orders of the corners; the first four go round the same way.
fn place(order: usize, k: usize) -> usize {
    let last = POINTS - 1;
    let (mut i, mut j) = (k % POINTS, k / POINTS);
    if order >= 4 {
        (i, j) = (j, i);
    }
    for _ in 0..order % 4 {
        (i, j) = (last - j, i);
    }
    i + POINTS * j
}

/// The corners as places of the grid.
const CORNERS: [usize; 4] = [0, POINTS - 1, POINTS * (POINTS - 1), ALL - 1];

/// The best way to lay the second panel, or its mirror image, on the first within a tolerance, with its number left open; one that
/// keeps the side if there is any.
fn laid(first: &[Vec3; ALL], second: &[Vec3; ALL], tolerance: f64, mirrored: bool) -> Option<CongruentPanel> {
    let image = |p: Vec3| if mirrored { Vec3::new(p.x, p.y, -p.z) } else { p };
    let second = second.map(image);
    let mut best: Option<CongruentPanel> = None;
    for order in 0..8 {
        let turned_over = order >= 4;
        if best.is_some_and(|best| best.turned_over != turned_over) {
            break;
        }
        let at = |k: usize| second[place(order, k)];
        let corners = CORNERS.map(|k| (first[k], at(k)));
        let far = |i: usize, j: usize| {
            let ((a, b), (c, d)) = (corners[i], corners[j]);
            ((a - c).length() - (b - d).length()).abs() > 2.0 * tolerance * (1.0 + ROUNDING[0])
        };
        if (1..4).any(|j| (0..j).any(|i| far(i, j))) {
            continue;
        }
        let Some(deviation) = deviation(first, &std::array::from_fn(at), tolerance) else { continue };
        if best.is_none_or(|best| deviation < best.deviation) {
            let corners = CORNERS.map(|k| CORNERS.iter().position(|c| *c == place(order, k)).unwrap_or(0));
            best = Some(CongruentPanel { panel: 0, deviation, corners, turned_over });
        }
    }
    best
}

/// The largest distance of points from others after the motion that makes it least, unless it is above the tolerance.
///
/// From the motion of least squares on, weights are multiplied by the distances, again and again (C. L. Lawson's rule; by their power
/// 1.5, which needs fewer rounds: of points moved at random 40 end at most 2 percent above the bound, half a percent in the mean). The weighted mean
/// distance of each round is the least there is, hence no larger than the largest distance of any motion: a bound that ends the rounds.
fn deviation(first: &[Vec3; ALL], second: &[Vec3; ALL], tolerance: f64) -> Option<f64> {
    let mut weights = [1.0 / ALL as f64; ALL];
    let (mut least, mut bound) = (f64::INFINITY, 0.0_f64);
    for _ in 0..ROUNDS {
        let Some(distances) = least_squares(first, second, &weights) else { break };
        let mean = distances.iter().zip(&weights).map(|(d, w)| w * d * d).sum::<f64>().sqrt();
        least = least.min(distances.iter().copied().fold(0.0, f64::max));
        bound = bound.max(mean);
        if bound > tolerance || least <= (LEVEL * bound).max(NEGLIGIBLE * tolerance) {
            break;
        }
        let weighed: [f64; ALL] = std::array::from_fn(|k| weights[k] * distances[k] * distances[k].sqrt());
        let sum: f64 = weighed.iter().sum();
        weights = weighed.map(|weight| weight / sum);
    }
    (least <= tolerance).then_some(least)
}

/// The distances of points from others after the motion of least weighted squares (W. Kabsch, Acta Cryst. A 32 (1976), 922); the
/// weights have the sum 1.
fn least_squares(first: &[Vec3; ALL], second: &[Vec3; ALL], weights: &[f64; ALL]) -> Option<[f64; ALL]> {
    let mean = |points: &[Vec3; ALL]| points.iter().zip(weights).fold(Vec3::ZERO, |sum, (p, w)| sum + *p * *w);
    let (center, other) = (mean(first), mean(second));
    let mut columns = [Vec3::ZERO; 3];
    for ((p, q), weight) in first.iter().zip(second).zip(weights) {
        let (p, q) = ((*p - center) * *weight, *q - other);
        columns = [columns[0] + p * q.x, columns[1] + p * q.y, columns[2] + p * q.z];
    }
    let [x, y, z] = nearest_rotation(columns).ok()?;
    Some(std::array::from_fn(|k| {
        let (p, q) = (first[k] - center, second[k] - other);
        (x * q.x + y * q.y + z * q.z - p).length()
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::quat::Quat;

    /// Numbers without a pattern from -1 to 1.
    fn next(state: &mut u64) -> f64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn turned(by: Vec3) -> Quat {
        by.unit().map_or(Quat::ONE, |axis| Quat::from_axis_angle(axis, by.length()))
    }

    #[test]
    fn no_motion_near_is_better() {
        let mut state = 7;
        for _ in 0..20 {
            let mut vector = |size: f64| Vec3::new(next(&mut state), next(&mut state), next(&mut state)) * size;
            let first: [Vec3; ALL] = std::array::from_fn(|_| vector(1.0));
            // A corner that is off by more than all others pulls least squares little.
            let other: [Vec3; ALL] = std::array::from_fn(|k| first[k] + vector(if k == 0 { 0.02 } else { 0.004 }));
            let turn = turned(vector(2.0));
            let found = deviation(&first, &other.map(|p| turn.rotate(p) + Vec3::X), 1.0).unwrap();
            let largest = |[turn, by]: [Vec3; 2]| {
                let turn = turned(turn);
                let distances = first.iter().zip(&other).map(|(p, q)| (turn.rotate(*q) + by - *p).length());
                distances.fold(0.0, f64::max)
            };
            // Steps of all kinds from a place near, each taken if it is better.
            let mut best = ([Vec3::ZERO; 2], largest([Vec3::ZERO; 2]));
            let mut size = 0.01;
            for _ in 0..20_000 {
                let place = [best.0[0] + vector(size), best.0[1] + vector(size)];
                let value = largest(place);
                if value < best.1 {
                    best = (place, value);
                }
                size = (size * 0.999).max(1e-7);
            }
            assert!(found <= 1.02 * best.1, "{found} {}", best.1);
            // Just below it there is no such motion, just above it there is.
            assert!(
                deviation(&first, &other, 0.97 * found).is_none() && deviation(&first, &other, found * 1.001).is_some()
            );
        }
    }
}
