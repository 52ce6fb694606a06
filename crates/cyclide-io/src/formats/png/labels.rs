//! Many objects told apart in the drawing: by names beside them if every name finds a free place that is nearest to its own
//! object, else by numbers on them.

use super::canvas::{Canvas, Ink, Pixel};
use super::legend::{balloon, balloon_radius};
use super::lettering;
use super::sheet::Sheet;
use std::collections::HashMap;

/// Cells in which the drawing is remembered, and distances of names from their object, pixels of a usual picture.
const CELL: f64 = 6.0;
const GAPS: [f64; 3] = [16.0, 26.0, 44.0];
/// Places tried along each side.
const SHIFTS: [f64; 5] = [0.5, 0.0, 1.0, 0.25, 0.75];
/// Distances of the name of a point from it, and its size beside that of other texts.
const POINT_GAPS: [f64; 3] = [9.0, 16.0, 28.0];
pub(super) const POINT_NAME: f64 = 0.7;
/// A name must be nearer to its own object than to others by this factor.
const NEARER: f64 = 0.85;
/// More objects than this are numbered: names would be a text to read, not a drawing.
const MOST_NAMES: usize = 30;
/// Places along an object that are tried for its number, and the distance of the samples, in cells.
const PLACES: usize = 160;
const SAMPLES: f64 = 1.5;
/// An object smaller than so many radii of its number has it beside it, on a leader.
const SMALL: f64 = 5.0;
/// Distances of such a number from the middle of its object, in radii, and directions.
const LEADERS: [f64; 5] = [2.2, 3.2, 4.4, 6.0, 8.0];
const DIRECTIONS: usize = 16;

/// Where a drawing has ink, and whose.
pub(super) struct Labels {
    sheet: Sheet,
    cell: f64,
    /// Left, upper and lower end of the room for labels.
    room: [f64; 3],
    /// Cells with joints, combs and names; true for joints.
    taken: HashMap<(i64, i64), bool>,
    /// Cells with the curves of objects.
    owners: HashMap<(i64, i64), Vec<usize>>,
    /// Places along each object, about evenly.
    samples: Vec<Vec<(f64, f64)>>,
}

/// A rectangle in pixels.
#[derive(Debug, Clone, Copy)]
struct Place {
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
}

/// A name with its place.
pub(super) struct Name {
    object: usize,
    text: String,
    start: (f64, f64),
}

/// The place of an object's number, and where its leader ends.
struct Number {
    object: usize,
    at: (f64, f64),
    leader: Option<(f64, f64)>,
}

impl Labels {
    pub(super) fn new(sheet: Sheet, room: [f64; 3], objects: usize) -> Self {
        let (taken, owners, samples) = (HashMap::new(), HashMap::new(), vec![Vec::new(); objects]);
        Self { sheet, cell: CELL * sheet.scale, room, taken, owners, samples }
    }

    /// Lines of the drawing that are no object.
    pub(super) fn avoid(&mut self, points: &[Pixel]) {
        let cell = self.cell;
        for (x, y) in along(points, cell) {
            self.taken.entry(((x / cell).floor() as i64, (y / cell).floor() as i64)).or_insert(false);
        }
    }

    /// A joint, by its diagonal.
    pub(super) fn add_joint(&mut self, points: &[Pixel]) {
        let cell = self.cell;
        for (x, y) in along(points, cell) {
            self.taken.insert(((x / cell).floor() as i64, (y / cell).floor() as i64), true);
        }
    }

    /// A curve of an object.
    pub(super) fn add(&mut self, object: usize, points: &[Pixel]) {
        let cell = self.cell;
        let mut last: Option<(f64, f64)> = None;
        for (x, y) in along(points, cell) {
            let owners = self.owners.entry(((x / cell).floor() as i64, (y / cell).floor() as i64)).or_default();
            if !owners.contains(&object) {
                owners.push(object);
            }
            if last.is_none_or(|(a, b)| (x - a).hypot(y - b) >= SAMPLES * cell) {
                self.samples[object].push((x, y));
                last = Some((x, y));
            }
        }
    }

    /// The objects of which more than half lies on others before them.
    pub(super) fn covering(&self) -> Vec<usize> {
        let (mut own, mut on_others) = (vec![0; self.samples.len()], vec![0; self.samples.len()]);
        for owners in self.owners.values() {
            let first = owners.iter().min();
            for &object in owners {
                own[object] += 1;
                on_others[object] += usize::from(first < Some(&object));
            }
        }
        (0..own.len()).filter(|&object| 2 * on_others[object] > own[object]).collect()
    }

    /// Places for all names; `None` if one has none.
    pub(super) fn names(&mut self, names: &[String]) -> Option<Vec<Name>> {
        if names.len() > MOST_NAMES {
            return None;
        }
        let touching = self.touching();
        let mut placed = Vec::new();
        for (object, name) in names.iter().enumerate() {
            if self.samples[object].is_empty() {
                continue;
            }
            let size = 0.93 * self.sheet.text_size();
            let text = lettering::fitted(name, size, 0.4 * self.sheet.width);
            let place = self.free_place(object, lettering::width(&text, size), size, &touching[object])?;
            for cell in self.cells(place) {
                self.taken.insert(cell, false);
            }
            placed.push(Name { object, text, start: (place.left, place.bottom) });
        }
        Some(placed)
    }

    /// Draws names in the colors of their objects.
    pub(super) fn draw(&self, canvas: &mut Canvas, names: &[Name]) {
        for Name { object, text, start } in names {
            canvas.label(text, *start, 0.93 * self.sheet.text_size(), Ink::object(*object));
        }
    }

    /// Places beside points for what they are called, as far as there is room: texts and where they start.
    pub(super) fn point_names(&mut self, points: &[(Pixel, String)]) -> Vec<(String, (f64, f64))> {
        let size = POINT_NAME * self.sheet.text_size();
        let mut placed = Vec::new();
        for ((x, y), name) in points {
            let (x, y) = (f64::from(*x), f64::from(*y));
            let text = lettering::fitted(name, size, 0.2 * self.sheet.width);
            let (wide, [left, top, bottom]) = (lettering::width(&text, size), self.room);
            let gaps = POINT_GAPS.map(|gap| gap * self.sheet.scale);
            let places = gaps.into_iter().flat_map(|gap| {
                let (behind, before, middle) = (x + gap, x - gap - wide, x - 0.5 * wide);
                let (above, below, level) = (y - gap - size, y + gap, y - 0.5 * size);
                [
                    (behind, above),
                    (behind, below),
                    (before, above),
                    (before, below),
                    (behind, level),
                    (before, level),
                    (middle, above),
                    (middle, below),
                ]
            });
            let mut places = places.map(|(left, top)| Place { left, top, right: left + wide, bottom: top + size });
            let inside =
                |p: &Place| p.left >= left && p.right <= self.sheet.width && p.top >= top && p.bottom <= bottom;
            let is_free = |place: &Place| {
                inside(place)
                    && !self.cells(*place).any(|cell| self.taken.contains_key(&cell) || self.owners.contains_key(&cell))
            };
            let Some(place) = places.find(is_free) else { continue };
            for cell in self.cells(place).collect::<Vec<_>>() {
                self.taken.insert(cell, false);
            }
            placed.push((text, (place.left, place.bottom)));
        }
        placed
    }

    /// For each object the others that share a place with it: a name is near to all of them.
    fn touching(&self) -> Vec<Vec<usize>> {
        let mut touching = vec![Vec::new(); self.samples.len()];
        for owners in self.owners.values().filter(|owners| owners.len() > 1) {
            for (a, b) in owners.iter().flat_map(|a| owners.iter().map(move |b| (*a, *b))) {
                if !touching[a].contains(&b) {
                    touching[a].push(b);
                }
            }
        }
        touching
    }

    fn free_place(&self, object: usize, wide: f64, size: f64, touching: &[usize]) -> Option<Place> {
        let own = box_of(&self.samples[object]);
        let (x, y) = (0.5 * (own.left + own.right - wide), 0.5 * (own.top + own.bottom - size));
        for gap in GAPS.map(|gap| gap * self.sheet.scale) {
            let (below, above) = (own.bottom + gap, own.top - gap - size);
            let (before, behind) = (own.left - gap - wide, own.right + gap);
            let beside = SHIFTS.map(|part| {
                let x = own.left + part * (own.right - own.left - wide);
                let y = own.top + part * (own.bottom - own.top - size);
                [(x, below), (x, above), (behind, y), (before, y)]
            });
            let starts = beside.into_iter().flatten().chain([(x, y)]);
            let mut places = starts.map(|(left, top)| Place { left, top, right: left + wide, bottom: top + size });
            if let Some(place) = places.find(|place| self.is_free(*place, object, touching)) {
                return Some(place);
            }
        }
        None
    }

    /// True if nothing lies under a name, and its own object is nearest to it.
    fn is_free(&self, place: Place, object: usize, touching: &[usize]) -> bool {
        let [left, top, bottom] = self.room;
        let right = self.sheet.width - 0.4 * self.sheet.margin();
        if place.left < left || place.right > right || place.top < top || place.bottom > bottom {
            return false;
        }
        if self.cells(place).any(|cell| self.taken.contains_key(&cell) || self.owners.contains_key(&cell)) {
            return false;
        }
        let nearest = |samples: &[(f64, f64)]| samples.iter().map(|p| place.distance(*p)).fold(f64::MAX, f64::min);
        let own = nearest(&self.samples[object]);
        let others = self.samples.iter().enumerate().filter(|(k, _)| *k != object && !touching.contains(k));
        others.into_iter().all(|(_, samples)| own < NEARER * nearest(samples))
    }

    /// The cells of a place and a rim round it.
    fn cells(&self, place: Place) -> impl Iterator<Item = (i64, i64)> + use<> {
        let rim = self.cell;
        let at = |v: f64| (v / self.cell).floor() as i64;
        let (left, right) = (at(place.left - rim), at(place.right + rim));
        let (top, bottom) = (at(place.top - rim), at(place.bottom + 1.3 * rim));
        (top..=bottom).flat_map(move |y| (left..=right).map(move |x| (x, y)))
    }

    /// Draws the numbers of the first `count` objects, counted from 1, on them or, where they are small, beside them.
    pub(super) fn draw_numbers(&self, canvas: &mut Canvas, count: usize) {
        for Number { object, at, leader } in self.numbers(count) {
            if let Some((x, y)) = leader {
                let line = [(at.0 as f32, at.1 as f32), (x as f32, y as f32)];
                canvas.stroke(&line, false, 1.2 * self.sheet.scale, Ink::object(object));
            }
            balloon(canvas, at, object + 1, self.sheet, Ink::object(object));
        }
    }

    fn numbers(&self, count: usize) -> Vec<Number> {
        let mut set: Vec<(f64, f64, f64)> = Vec::new();
        let mut numbers = Vec::new();
        for (object, samples) in self.samples.iter().enumerate().take(count).filter(|(_, s)| !s.is_empty()) {
            let radius = balloon_radius(object + 1, self.sheet);
            let own = box_of(samples);
            let small = (own.right - own.left).hypot(own.bottom - own.top) < SMALL * radius;
            let on_curve = || samples.iter().step_by(samples.len().div_ceil(PLACES)).copied();
            let places: Vec<(f64, f64)> = if small { around(own, radius).collect() } else { on_curve().collect() };
            let cost = |(index, at): (usize, &(f64, f64))| {
                // The middle of a curve, and the nearest place beside a small one, if there is a choice.
                let order = if small { index } else { index.abs_diff(places.len() / 2) };
                (self.hidden(*at, radius, object, &set), order)
            };
            let Some((_, &at)) = places.iter().enumerate().min_by_key(|place| cost(*place)) else { continue };
            let near = |p: &(f64, f64)| (p.0 - at.0).hypot(p.1 - at.1);
            let nearest = samples.iter().min_by(|p, q| near(p).total_cmp(&near(q)));
            numbers.push(Number { object, at, leader: nearest.copied().filter(|_| small) });
            set.push((at.0, at.1, radius));
        }
        numbers
    }

    /// How much a number would hide: other numbers first, then other objects, then joints. A comb is not hidden by so little.
    fn hidden(&self, (x, y): (f64, f64), radius: f64, object: usize, set: &[(f64, f64, f64)]) -> usize {
        let [left, top, bottom] = self.room;
        let outside = x - radius < left || x + radius > self.sheet.width || y - radius < top || y + radius > bottom;
        let on_number = set.iter().any(|(a, b, r)| (x - a).hypot(y - b) < radius + r + 0.5 * self.cell);
        let cells = self.cells(Place { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius });
        let cost = |cell: (i64, i64)| {
            let others = self.owners.get(&cell).is_some_and(|owners| owners.iter().any(|o| *o != object));
            3 * usize::from(others) + usize::from(self.taken.get(&cell) == Some(&true))
        };
        cells.map(cost).sum::<usize>() + 10_000 * (usize::from(outside) + usize::from(on_number))
    }
}

impl Place {
    fn distance(self, (x, y): (f64, f64)) -> f64 {
        let dx = (self.left - x).max(x - self.right).max(0.0);
        let dy = (self.top - y).max(y - self.bottom).max(0.0);
        dx.hypot(dy)
    }
}

/// Places along a line, not farther apart than `step` pixels.
fn along(points: &[Pixel], step: f64) -> impl Iterator<Item = (f64, f64)> {
    let first = points.first().map(|(x, y)| (f64::from(*x), f64::from(*y)));
    let rest = points.windows(2).flat_map(move |pair| {
        let [a, b] = [pair[0], pair[1]].map(|(x, y)| (f64::from(x), f64::from(y)));
        let steps = ((b.0 - a.0).hypot(b.1 - a.1) / step).ceil().clamp(1.0, 1e5);
        (1..=steps as usize).map(move |i| {
            let part = i as f64 / steps;
            (a.0 + (b.0 - a.0) * part, a.1 + (b.1 - a.1) * part)
        })
    });
    first.into_iter().chain(rest)
}

fn box_of(points: &[(f64, f64)]) -> Place {
    let first = Place { left: f64::MAX, top: f64::MAX, right: f64::MIN, bottom: f64::MIN };
    points.iter().fold(first, |b, &(x, y)| Place {
        left: b.left.min(x),
        top: b.top.min(y),
        right: b.right.max(x),
        bottom: b.bottom.max(y),
    })
}

/// Places for a number around a small object, the nearest ones first.
fn around(own: Place, radius: f64) -> impl Iterator<Item = (f64, f64)> {
    let (x, y) = (0.5 * (own.left + own.right), 0.5 * (own.top + own.bottom));
    let (wide, high) = (0.5 * (own.right - own.left), 0.5 * (own.bottom - own.top));
    LEADERS.into_iter().flat_map(move |distance| {
        (0..DIRECTIONS).map(move |k| {
            let (sine, cosine) = (std::f64::consts::TAU * (k as f64 + 0.5) / DIRECTIONS as f64).sin_cos();
            (x + (wide + distance * radius) * cosine, y + (high + distance * radius) * sine)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHEET: Sheet = Sheet { width: 1600.0, height: 1200.0, fixed: false, scale: 1.0 };

    fn circle((x, y): (f64, f64), radius: f64) -> Vec<Pixel> {
        let at = |i: usize| (std::f64::consts::TAU * i as f64 / 100.0).sin_cos();
        (0..=100).map(|i| ((x + radius * at(i).1) as f32, (y + radius * at(i).0) as f32)).collect()
    }

    fn labels(objects: &[Vec<Pixel>]) -> Labels {
        let mut labels = Labels::new(SHEET, [20.0, 80.0, 1100.0], objects.len());
        objects.iter().enumerate().for_each(|(index, points)| labels.add(index, points));
        labels
    }

    #[test]
    fn names_stand_free_and_nearest_to_their_own_object() {
        let row: Vec<_> = (0..4).map(|i| circle((200.0 + 400.0 * f64::from(i), 500.0), 60.0)).collect();
        let names: Vec<String> = (0..4).map(|i| format!("circle {i}")).collect();
        let mut labels = labels(&row);
        let placed = labels.names(&names).unwrap();
        for (name, circle) in placed.iter().zip(&row) {
            let size = 0.93 * SHEET.text_size();
            let right = name.start.0 + lettering::width(&name.text, size);
            for (x, y) in row.iter().flatten().map(|(x, y)| (f64::from(*x), f64::from(*y))) {
                let inside = x > name.start.0 && x < right && y < name.start.1 && y > name.start.1 - size;
                assert!(!inside, "{} lies on a curve", name.text);
            }
            let nearest = |points: &[Pixel]| {
                let distance = |(x, y): &Pixel| (f64::from(*x) - name.start.0).hypot(f64::from(*y) - name.start.1);
                points.iter().map(distance).fold(f64::MAX, f64::min)
            };
            assert!(row.iter().all(|other| nearest(circle) <= nearest(other)), "{}", name.text);
        }
    }

    #[test]
    fn where_names_have_no_room_numbers_stand_apart_on_their_objects() {
        let rings: Vec<_> = (0..20).map(|i| circle((800.0, 600.0), 60.0 + 20.0 * f64::from(i))).collect();
        let names: Vec<String> = (0..20).map(|i| format!("concentric ring number {i} with a long name")).collect();
        let mut labels = labels(&rings);
        assert!(labels.names(&names).is_none());
        let numbers = labels.numbers(20);
        assert_eq!(numbers.len(), 20);
        for (k, number) in numbers.iter().enumerate() {
            let radius = (number.at.0 - 800.0).hypot(number.at.1 - 600.0);
            assert!((radius - 60.0 - 20.0 * k as f64).abs() < 1.0 && number.leader.is_none(), "{radius}");
            for other in &numbers[..k] {
                let distance = (number.at.0 - other.at.0).hypot(number.at.1 - other.at.1);
                assert!(distance > 2.0 * balloon_radius(1, SHEET), "{distance}");
            }
        }
    }

    #[test]
    fn numbers_of_small_objects_stand_beside_them_on_leaders() {
        let dots: Vec<_> = (0..6).map(|i| circle((300.0 + 40.0 * f64::from(i), 500.0), 6.0)).collect();
        for (k, number) in labels(&dots).numbers(6).iter().enumerate() {
            let (x, y) = number.leader.unwrap();
            assert!((x - 300.0 - 40.0 * k as f64).hypot(y - 500.0) < 7.0);
            let covered = dots.iter().flatten().any(|p| {
                (f64::from(p.0) - number.at.0).hypot(f64::from(p.1) - number.at.1) < balloon_radius(k + 1, SHEET)
            });
            assert!(!covered, "number {} hides an object", k + 1);
        }
    }

    #[test]
    fn a_curve_on_another_is_found() {
        let twice = [circle((500.0, 500.0), 200.0), circle((501.0, 500.0), 200.0), circle((900.0, 500.0), 220.0)];
        assert_eq!(labels(&twice).covering(), [1]);
    }
}
