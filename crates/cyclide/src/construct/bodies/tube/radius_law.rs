//! Laws of the radius along a spine.

use crate::base::range;
use crate::error::{CurveError, ErrorItem, NumberError, PointError, Result, TubeError};

/// How the radius of a tube goes along its spine, over the fraction of the spine's length from 0 to 1: C1, and never beyond the values given
/// (cubics with the slopes of M. Steffen, 1990). Linear between two values.
///
/// ```
/// use cyclide::construct::RadiusLaw;
/// let bulge = RadiusLaw::new(&[[0.0, 2.0], [0.5, 3.0], [1.0, 2.0]])?;
/// assert_eq!(bulge.radius(0.5), 3.0);
/// assert!(bulge.radius(0.3) < 3.0 && RadiusLaw::constant(2.0)?.radius(0.3) == 2.0);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RadiusLaw {
    /// Places, from 0 to 1, radii and slopes.
    nodes: Vec<[f64; 3]>,
}

impl RadiusLaw {
    /// One radius.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn constant(radius: f64) -> Result<Self> {
        Self::new(&[[0.0, radius]])
    }

    /// From places and radii, places increasing from 0 to 1; before the first and behind the last one the radius stays.
    ///
    /// # Errors
    /// `too-few-points` (none), `not-finite`, `radius-not-positive`, `parameter-out-of-range` (places outside `[0, 1]`, radii beyond the range of the kernel's numbers), `empty-interval` (places not
    /// increasing).
    pub fn new(values: &[[f64; 2]]) -> Result<Self> {
        let (Some(&[_, first]), Some(&[_, last])) = (values.first(), values.last()) else {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        };
        for (index, &[at, radius]) in values.iter().enumerate() {
            if !(at.is_finite() && radius.is_finite()) {
                return Err(NumberError::NotFinite { what: ErrorItem::Radius, index }.into());
            }
            if radius <= 0.0 {
                return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index, radius }.into());
            }
            range::check_distance(radius)?;
            if !(0.0..=1.0).contains(&at) {
                return Err(NumberError::ParameterOutOfRange {
                    name: ErrorItem::Parameter,
                    value: at,
                    min: 0.0,
                    max: 1.0,
                }
                .into());
            }
        }
        for (index, pair) in values.windows(2).enumerate() {
            let length = pair[1][0] - pair[0][0];
            if !(length > 0.0) {
                return Err(CurveError::EmptyInterval { index, length, limit: 0.0 }.into());
            }
        }
        let mut nodes: Vec<[f64; 3]> = values.iter().map(|&[at, radius]| [at, radius, 0.0]).collect();
        if nodes[0][0] > 0.0 {
            nodes.insert(0, [0.0, first, 0.0]);
        }
        if nodes[nodes.len() - 1][0] < 1.0 {
            nodes.push([1.0, last, 0.0]);
        }
        let mut law = Self { nodes };
        law.take_slopes(false);
        Ok(law)
    }

    /// The same for a closed spine: the slopes at both ends are one.
    ///
    /// # Errors
    /// `radius-not-closed` unless the radii at both ends are equal.
    pub(super) fn closed(mut self) -> Result<Self> {
        let [first, last] = [self.radius(0.0), self.radius(1.0)];
        if (first - last).abs() > 0.0 {
            return Err(TubeError::RadiusNotClosed { first, last }.into());
        }
        self.take_slopes(true);
        Ok(self)
    }

    /// The radius at a fraction of the length.
    #[must_use]
    pub fn radius(&self, at: f64) -> f64 {
        self.jet(at, false)[0]
    }

    /// True if there is one radius.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.nodes.iter().all(|node| node[1].total_cmp(&self.nodes[0][1]).is_eq())
    }

    /// The largest size of its slope: of each cubic at its ends, or where the second derivative is zero.
    pub(super) fn steepest(&self) -> f64 {
        let slope = |at: f64, before: bool| self.jet(at, before)[1].abs();
        let of_cubic = |pair: &[[f64; 3]]| {
            let ends = [pair[0][0], pair[1][0]];
            let [from, to] = [self.jet(ends[0], false)[2], self.jet(ends[1], true)[2]];
            let inner = ends[0] + (ends[1] - ends[0]) * (from / (from - to)).clamp(0.0, 1.0);
            let inner = if inner.is_finite() { slope(inner, true) } else { 0.0 };
            slope(ends[0], false).max(slope(ends[1], true)).max(inner)
        };
        self.nodes.windows(2).map(of_cubic).fold(0.0, f64::max)
    }

    /// The places between which it is one cubic.
    pub(super) fn places(&self) -> impl Iterator<Item = f64> {
        self.nodes.iter().map(|node| node[0])
    }

    /// Radius, slope and second derivative; at a node those before it if `before`.
    pub(super) fn jet(&self, at: f64, before: bool) -> [f64; 3] {
        let behind = self.nodes.partition_point(|node| if before { node[0] < at } else { node[0] <= at });
        let k = behind.clamp(1, self.nodes.len() - 1);
        let ([from, r0, m0], [to, r1, m1]) = (self.nodes[k - 1], self.nodes[k]);
        let (h, slope) = (to - from, (r1 - r0) / (to - from));
        // From the straight line: what is linear stays it.
        let (a, b) = (m0 - slope, m1 - slope);
        let x = ((at - from) / h).clamp(0.0, 1.0);
        let y = 1.0 - x;
        let straight = if x <= 0.5 { r0 + (r1 - r0) * x } else { r1 - (r1 - r0) * y };
        let radius = straight + h * x * y * (a * y - b * x);
        let first = slope + a * y * (1.0 - 3.0 * x) + b * x * (3.0 * x - 2.0);
        [radius, first, (a * (6.0 * x - 4.0) + b * (6.0 * x - 2.0)) / h]
    }

    /// Slopes that make all monotone between the nodes.
    fn take_slopes(&mut self, closed: bool) {
        let steps: Vec<[f64; 2]> = self
            .nodes
            .windows(2)
            .map(|pair| [pair[1][0] - pair[0][0], (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0])])
            .collect();
        let last = steps.len();
        for k in 0..=last {
            let at_end = k == 0 || k == last;
            let pair = match at_end {
                true if closed => Some([steps[last - 1], steps[0]]),
                true => None,
                false => Some([steps[k - 1], steps[k]]),
            };
            self.nodes[k][2] = match pair {
                Some([[h0, d0], [h1, d1]]) => {
                    let parabola = (d0 * h1 + d1 * h0) / (h0 + h1);
                    let least = d0.abs().min(d1.abs()).min(0.5 * parabola.abs());
                    // Twice the sign where both agree, else none.
                    if d0 * d1 > 0.0 { 2.0 * d0.signum() * least } else { 0.0 }
                }
                None if last == 1 => steps[0][1],
                None => {
                    let ([h0, d0], [h1, d1]) =
                        if k == 0 { (steps[0], steps[1]) } else { (steps[last - 1], steps[last - 2]) };
                    let parabola = d0 + (d0 - d1) * h0 / (h0 + h1);
                    if parabola * d0 <= 0.0 { 0.0 } else { d0.signum() * parabola.abs().min(2.0 * d0.abs()) }
                }
            };
        }
    }
}
