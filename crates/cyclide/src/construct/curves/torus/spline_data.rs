//! The input of a spline on a torus, checked: steps with the half turns asked for, tangents, lengths of the segments.

use super::projective_biarc::within;
use super::spline_options::{TorusSplineOptions, TorusTangent, TorusWinding};
use crate::base::planar::{Point2, Vec2};
use crate::error::{CurveError, Error, ErrorItem, NumberError, PointError, Result};
use crate::surface::{Torus, within_a_turn};
use std::f64::consts::PI;

/// Largest angle of a place, radians: as a number it is known to ten digits modulo pi. What is taken is reduced to a turn, so that the curve has all its own.
const MAX_ANGLE: f64 = 1e6;

/// Most half turns added to a step or asked for in all: far from the start places lose digits, a few with these.
const MOST_TURNS: f64 = 2_000.0;

/// Steps up to this part of `pi` and both angles are rounding of equal points.
const SAME_PLACE: f64 = 1e-15;

/// Tangents times the length of their span accepted, radians: outside, the speeds of neighboring pieces lose their digits.
const WAY_RANGE: [f64; 2] = [1e-12, 1e12];

/// Shortest span of the knot parameter as part of the whole.
const SHORTEST_SPAN: f64 = 1e-12;

/// Estimated tangents below this part of the speed of the neighboring chords are those of a cusp.
const CUSP: f64 = 0.05;

/// Speed at a cusp, across its longer chord, as part of the speed of that.
const CUSP_SPEED: f64 = 0.3;

/// Largest way of all segments together, radians: some hundred thousand pieces.
const MOST_WAY: f64 = 2.5e4;

/// Checked input, places within a turn: segment `i` goes from place `i` by step `i` within the knots `i` and `i + 1`.
#[derive(Debug)]
pub(super) struct Data {
    pub(super) places: Vec<Point2>,
    pub(super) steps: Vec<Vec2>,
    pub(super) knots: Vec<f64>,
    /// By the knot parameter, one for each place.
    pub(super) rates: Vec<Vec2>,
    pub(super) closed: bool,
}

impl Data {
    pub(super) fn new(torus: &Torus, given_places: &[Point2], options: &TorusSplineOptions) -> Result<Self> {
        let (n, closed) = (given_places.len(), options.closed);
        check_places(given_places, if closed { 1 } else { 2 })?;
        let mut places: Vec<Point2> = given_places.iter().copied().map(within_a_turn).collect();
        unite(&mut places, given_places, closed);
        let segments = if closed { n } else { n - 1 };
        let knots = knots(options, segments)?;
        let given = given_rates(torus, &places, options)?;
        let mut steps: Vec<Vec2> = (0..segments).map(|i| shortest_step(places[i], places[(i + 1) % n])).collect();
        wind(&mut steps, options)?;
        for (i, step) in steps.iter_mut().enumerate() {
            check_step(step, i, [given_places[i], given_places[(i + 1) % n]], (i + 1) % n, options.loops)?;
        }
        check_way(&steps)?;
        let mut data = Self { places, steps, knots, rates: Vec::new(), closed };
        data.rates = (0..n).map(|i| given[i].unwrap_or_else(|| data.estimate(i))).collect();
        data.check_ways()?;
        Ok(data)
    }

    /// Length of a segment in the knot parameter.
    pub(super) fn length(&self, segment: usize) -> f64 {
        self.knots[segment + 1] - self.knots[segment]
    }

    /// The places with their tangents at both ends of a segment, by the parameter of the segment, which has length 1.
    pub(super) fn ways(&self, segment: usize) -> [Vec2; 2] {
        let next = (segment + 1) % self.places.len();
        [self.rates[segment], self.rates[next]].map(|rate| rate * self.length(segment))
    }

    /// Bessel's estimate from the chords on both sides; at the ends the chord, at cusps across.
    fn estimate(&self, point: usize) -> Vec2 {
        let segments = self.steps.len();
        let before = if point > 0 { Some(point - 1) } else { self.closed.then(|| segments - 1) };
        let after = (point < segments).then_some(point);
        let chord = |segment: usize| self.steps[segment] * (1.0 / self.length(segment));
        let (estimate, longer) = match (before, after) {
            (Some(l), Some(r)) => {
                let (hl, hr) = (self.length(l), self.length(r));
                let (dl, dr) = (chord(l), chord(r));
                let longer = if dl.length() > dr.length() { dl } else { dr };
                (dl * (hr / (hl + hr)) + dr * (hl / (hl + hr)), longer)
            }
            (Some(only), None) | (None, Some(only)) => (chord(only), chord(only)),
            (None, None) => (Vec2::new(1.0, 0.0), Vec2::new(1.0, 0.0)),
        };
        if longer.length() == 0.0 {
            // Equal points on both sides, with loops between: along the parallel.
            return Vec2::new(1.0 / self.length(after.or(before).unwrap_or(0)), 0.0);
        }
        if estimate.length() < CUSP * longer.length() { longer.left() * CUSP_SPEED } else { estimate }
    }

    fn check_ways(&self) -> Result<()> {
        (0..self.steps.len())
            .flat_map(|segment| self.ways(segment))
            .try_for_each(|way| within(ErrorItem::TangentOverSpan, way.length(), WAY_RANGE))
    }
}

/// Refuses too few places, and angles that are not finite or have lost their digits modulo pi.
pub(super) fn check_places(places: &[Point2], needed: usize) -> Result<()> {
    if places.len() < needed {
        return Err(PointError::TooFewPoints { given: places.len(), needed }.into());
    }
    places.iter().enumerate().try_for_each(|(index, place)| check_angles(index, *place))
}

/// The same of one place.
pub(super) fn check_angles(index: usize, place: Point2) -> Result<()> {
    if !place.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Angle, index }.into());
    }
    within(ErrorItem::Angle, place.x.abs().max(place.y.abs()), [0.0, MAX_ANGLE])
}

/// Refuses a tangent, as the speed of its place, that is none.
pub(super) fn check_rate(index: usize, rate: Vec2) -> Result<()> {
    let speed = rate.length();
    if !speed.is_finite() {
        Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into())
    } else if speed == 0.0 {
        Err(PointError::ZeroTangent { index }.into())
    } else {
        Ok(())
    }
}

/// Refuses more half turns than work and memory allow.
fn check_way(steps: &[Vec2]) -> Result<()> {
    let needed: f64 = steps.iter().map(|step| step.length()).sum();
    if needed <= MOST_WAY {
        return Ok(());
    }
    let (what, remedy) = ("curve on the torus", "ask for fewer turns");
    let error = Error::from(NumberError::TooManyPieces { what, segment: None, needed, cap: MOST_WAY as usize, remedy });
    Err(error.in_field("winding"))
}

/// The step to the next place by the shortest way, each angle by half pi at most.
pub(super) fn shortest_step(from: Point2, to: Point2) -> Vec2 {
    let short = |x: f64| x - PI * (x / PI).round();
    let d = to - from;
    Vec2::new(short(d.x), short(d.y))
}

fn knots(options: &TorusSplineOptions, segments: usize) -> Result<Vec<f64>> {
    if options.knots.is_empty() {
        return Ok((0..=segments).map(|k| k as f64).collect());
    }
    if options.knots.len() != segments + 1 {
        return Err(NumberError::CountDiffers {
            what: ErrorItem::Knot,
            given: options.knots.len(),
            needed: segments + 1,
        }
        .into());
    }
    if let Some(index) = options.knots.iter().position(|k| !k.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::Knot, index }.into());
    }
    let whole = options.knots[segments] - options.knots[0];
    let limit = (SHORTEST_SPAN * whole).max(0.0);
    for (index, pair) in options.knots.windows(2).enumerate() {
        let length = pair[1] - pair[0];
        if !(length > limit && whole.is_finite()) {
            return Err(CurveError::EmptyInterval { index, length, limit }.into());
        }
    }
    Ok(options.knots.clone())
}

/// The tangents that are not free, as speeds of places.
fn given_rates(torus: &Torus, places: &[Point2], options: &TorusSplineOptions) -> Result<Vec<Option<Vec2>>> {
    let n = places.len();
    if options.tangents.is_empty() {
        return Ok(vec![None; n]);
    }
    if options.tangents.len() != n {
        return Err(
            NumberError::CountDiffers { what: ErrorItem::Tangent, given: options.tangents.len(), needed: n }.into()
        );
    }
    let rate = |(index, tangent): (usize, &TorusTangent)| {
        let rate = match tangent {
            TorusTangent::Free => return Ok(None),
            TorusTangent::Rate(rate) => *rate,
            TorusTangent::Velocity(v) if v.is_finite() => torus.rate(places[index], *v),
            TorusTangent::Velocity(_) => Vec2::new(f64::NAN, f64::NAN),
        };
        check_rate(index, rate).map(|()| Some(rate))
    };
    options.tangents.iter().enumerate().map(rate).collect()
}

/// Adds the half turns asked for.
fn wind(steps: &mut [Vec2], options: &TorusSplineOptions) -> Result<()> {
    let check = |turns: f64| within(ErrorItem::Winding, turns.abs(), [0.0, MOST_TURNS]);
    match &options.winding {
        TorusWinding::Shortest => Ok(()),
        TorusWinding::PerSegment(list) => {
            if list.len() != steps.len() {
                return Err(NumberError::CountDiffers {
                    what: ErrorItem::Winding,
                    given: list.len(),
                    needed: steps.len(),
                }
                .into());
            }
            for (step, turns) in steps.iter_mut().zip(list) {
                let [x, y] = turns.map(f64::from);
                check(x.abs().max(y.abs()))?;
                *step += Vec2::new(PI * x, PI * y);
            }
            Ok(())
        }
        TorusWinding::Total(turns) => {
            let [x, y] = turns.map(f64::from);
            check(x.abs().max(y.abs()))?;
            if options.closed {
                wind_component(steps, x, |step| &mut step.x);
                wind_component(steps, y, |step| &mut step.y);
            }
            Ok(())
        }
    }
}

/// Adds half turns where steps stay shortest, until all together are as many as asked for.
fn wind_component(steps: &mut [Vec2], asked: f64, component: impl Fn(&mut Vec2) -> &mut f64) {
    let sum: f64 = steps.iter_mut().map(|step| *component(step)).sum();
    let missing = asked - (sum / PI).round();
    let turn = PI.copysign(missing);
    let each = (missing.abs() / steps.len() as f64).floor();
    let rest = (missing.abs() - each * steps.len() as f64) as usize;
    // As many for each first; of the rest none gets two, as that would be longer than any other with one.
    let lengths: Vec<f64> = steps.iter_mut().map(|step| (*component(step) + (each + 1.0) * turn).abs()).collect();
    let mut order: Vec<usize> = (0..steps.len()).collect();
    order.sort_by(|i, j| lengths[*i].total_cmp(&lengths[*j]));
    for (rank, i) in order.into_iter().enumerate() {
        *component(&mut steps[i]) += turn * if rank < rest { each + 1.0 } else { each };
    }
}

/// Makes neighbors the same that are so but for the rounding of the angles as they were given: what starts at one ends at the other.
fn unite(places: &mut [Point2], given: &[Point2], closed: bool) {
    let n = places.len();
    // Once round is not enough where the last place is the first one.
    for i in 0..if closed { 2 * n } else { n - 1 } {
        let (first, second) = (i % n, (i + 1) % n);
        if is_none(shortest_step(places[first], places[second]), [given[first], given[second]]) {
            places[second] = places[first];
        }
    }
}

/// The largest step between two places that is the rounding of their angles.
fn rounding(ends: [Point2; 2]) -> Vec2 {
    let limit = |a: f64, b: f64| SAME_PLACE * (PI + a.abs() + b.abs());
    Vec2::new(limit(ends[0].x, ends[1].x), limit(ends[0].y, ends[1].y))
}

fn is_none(step: Vec2, ends: [Point2; 2]) -> bool {
    let limits = rounding(ends);
    step.x.abs() <= limits.x && step.y.abs() <= limits.y
}

/// Refuses a step between equal points; where loops are asked for it becomes exactly none.
fn check_step(step: &mut Vec2, first: usize, ends: [Point2; 2], second: usize, loops: bool) -> Result<()> {
    if !is_none(*step, ends) {
        return Ok(());
    }
    if loops {
        *step = Vec2::default();
        return Ok(());
    }
    if first == second {
        return Err(PointError::TooFewPoints { given: 1, needed: 2 }.into());
    }
    let (distance, limit) = (step.length(), rounding(ends).length());
    Err(PointError::CoincidentPoints { first, second, distance, limit }.into())
}
