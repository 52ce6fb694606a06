//! Laws by which a range is divided into cells: equal ones, by a constant ratio, by hyperbolic tangents.
//!
//! With `n` cells, `k` from 0 and `x = k/n`:
//!
//! ```text
//! uniform     x
//! geometric   (r^k - 1)/(r^n - 1)
//! tanh        1 + tanh(d (x - 1))/tanh d = sinh(d x)/(cosh(d (1 - x)) sinh d)
//! tanh, both  (1 + tanh(d (2x - 1))/tanh d)/2
//! ```
//! (`docs/math/volumes.md#grading`; the law of tangents is that of M. Vinokur, J. Comput. Phys. 50 (1983), 215-234, for one slope.)

use crate::error::{ErrorItem, NumberError, PoseError, Result};

/// Ratios of neighboring cells, and stretches, are found and taken up to these.
const MAX_RATIO: f64 = 1e3;
const MAX_STRETCH: f64 = 20.0;
/// Stretches below this are uniform to rounding.
const MIN_STRETCH: f64 = 1e-6;
/// Halvings of a range of doubles until nothing is left between its ends.
const HALVINGS: usize = 200;
/// Most cells along a range.
const MOST: usize = 1 << 16;

/// The end of a range at which its small cells are.
///
/// ```
/// use cyclide::volume::{FineEnd, Grading};
/// let places = Grading::Geometric { ratio: 3.0, fine: FineEnd::Both }.places(4)?;
/// assert!(places.iter().zip([0.0, 0.125, 0.5, 0.875, 1.0]).all(|(x, wanted)| (x - wanted).abs() < 1e-15));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum FineEnd {
    /// At the start.
    #[default]
    Start,
    /// At the end.
    End,
    /// At both ends equally.
    Both,
}

/// How a range is divided into cells.
///
/// ```
/// use cyclide::volume::{FineEnd, Grading};
/// assert_eq!(Grading::Uniform.places(4)?, [0.0, 0.25, 0.5, 0.75, 1.0]);
/// let wall = Grading::geometric_from_first(0.01, 20, FineEnd::Start)?;
/// assert!((wall.places(20)?[1] - 0.01).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum Grading {
    /// Equal cells.
    #[default]
    Uniform,
    /// Each cell is so many times as long as the one before, counted from the fine end. Of a ratio below 1 the cells there are the long ones.
    Geometric {
        /// The ratio of a cell to the one before, 0.001 to 1000.
        ratio: f64,
        /// From where cells grow.
        fine: FineEnd,
    },
    /// By hyperbolic tangents: cells change slowly at the fine end and where they are longest.
    Tanh {
        /// How uneven cells are, from 0 (equal) to 20: at one end their lengths differ by about the square of its hyperbolic cosine.
        stretch: f64,
        /// From where cells grow.
        fine: FineEnd,
    },
}

impl Grading {
    /// The geometric law of so many cells whose first one, at the fine end, is this part of the range.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (no ratio from 0.001 to 1000 gives it; the number of cells).
    pub fn geometric_from_first(first: f64, cells: usize, fine: FineEnd) -> Result<Self> {
        check_cells(cells)?;
        let of = |logarithm: f64| Self::Geometric { ratio: logarithm.exp(), fine };
        let most = MAX_RATIO.ln();
        let logarithm = solve(first, [-most, most], |x| of(x).first(cells))?;
        Ok(of(logarithm))
    }

    /// The law of tangents of so many cells whose first one, at the fine end, is this part of the range.
    ///
    /// # Errors
    /// As [`geometric_from_first`](Self::geometric_from_first): first cells are not longer than equal ones.
    pub fn tanh_from_first(first: f64, cells: usize, fine: FineEnd) -> Result<Self> {
        check_cells(cells)?;
        let of = |stretch: f64| Self::Tanh { stretch, fine };
        solve(first, [0.0, MAX_STRETCH], |x| of(x).first(cells)).map(of)
    }

    /// The ends of the cells: from 0 to 1, rising, one more than cells.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (no cell or more than 65536; ratio or stretch out of range), `parameters-not-increasing` where cells are
    /// below the rounding of the range.
    pub fn places(&self, cells: usize) -> Result<Vec<f64>> {
        check_cells(cells)?;
        let (name, value, min, max) = match *self {
            Self::Uniform => (ErrorItem::Ratio, 1.0, 0.0, 1.0),
            Self::Geometric { ratio, .. } => (ErrorItem::Ratio, ratio, 1.0 / MAX_RATIO, MAX_RATIO),
            Self::Tanh { stretch, .. } => (ErrorItem::Stretch, stretch, 0.0, MAX_STRETCH),
        };
        if !value.is_finite() {
            return Err(NumberError::NotFinite { what: name, index: 0 }.into());
        }
        // The ends of the range that is searched have a rounding.
        if !(min * (1.0 - 1e-12)..=max * (1.0 + 1e-12)).contains(&value) {
            return Err(NumberError::ParameterOutOfRange { name, value, min, max }.into());
        }
        let places: Vec<f64> = (0..=cells).map(|k| self.place(k, cells)).collect();
        match (1..=cells).find(|&k| !(places[k] > places[k - 1])) {
            Some(k) => {
                Err(PoseError::ParametersNotIncreasing { index: k, value: places[k], before: places[k - 1] }.into())
            }
            None => Ok(places),
        }
    }

    /// The end of cell `k` of `n`, counted from 1; 0 is the start.
    fn place(&self, k: usize, n: usize) -> f64 {
        let even = k as f64 / n as f64;
        if k == 0 || k == n {
            return even;
        }
        let (fine, law): (FineEnd, &dyn Fn(usize) -> f64) = match *self {
            Self::Uniform => return even,
            Self::Geometric { ratio, fine } => (fine, &move |k| geometric(ratio, fine, k, n)),
            Self::Tanh { stretch, .. } if stretch < MIN_STRETCH => return even,
            Self::Tanh { stretch, fine } => (fine, &move |k| tanh(stretch, fine, k as f64 / n as f64)),
        };
        match fine {
            FineEnd::Start => law(k),
            FineEnd::End => 1.0 - law(n - k),
            FineEnd::Both if 2 * k == n => 0.5,
            FineEnd::Both if 2 * k > n => 1.0 - law(n - k),
            FineEnd::Both => law(k),
        }
    }

    /// The length of the cell at the fine end.
    fn first(&self, n: usize) -> f64 {
        match *self {
            Self::Geometric { ratio, fine } => geometric(ratio, fine, 1, n),
            Self::Tanh { stretch, fine } if stretch >= MIN_STRETCH => tanh(stretch, fine, 1.0 / n as f64),
            _ => 1.0 / n as f64,
        }
    }
}

/// Sum of the first `k` cells from the fine end; with two of these `k` is at most half of `n`.
fn geometric(ratio: f64, fine: FineEnd, k: usize, n: usize) -> f64 {
    // 1 + r + … + r^(k-1)
    let sum = |k: usize| {
        let (x, last) = (ratio.ln(), k as f64);
        if (x * last).abs() < 1e-8 {
            last * (1.0 + 0.5 * x * (last - 1.0))
        } else if x.abs() < 0.5 {
            (x * last).exp_m1() / x.exp_m1()
        } else {
            // Nothing cancels: exact for small whole ratios.
            (ratio.powi(k as i32) - 1.0) / (ratio - 1.0)
        }
    };
    match fine {
        FineEnd::Both => {
            let half = n / 2;
            let middle = if n % 2 == 1 { ratio.powi(half as i32) } else { 0.0 };
            part_of(sum(k), 2.0 * sum(half) + middle)
        }
        _ => part_of(sum(k), sum(n)),
    }
}

/// The part, 0 where the whole overflows.
fn part_of(part: f64, whole: f64) -> f64 {
    if whole.is_finite() { part / whole } else { 0.0 }
}

/// The law of tangents, without cancellation; with two fine ends up to the middle.
fn tanh(d: f64, fine: FineEnd, x: f64) -> f64 {
    match fine {
        FineEnd::Both => 0.5 * (2.0 * d * x).sinh() / (d.sinh() * (d * (1.0 - 2.0 * x)).cosh()),
        _ => (d * x).sinh() / ((d * (1.0 - x)).cosh() * d.sinh()),
    }
}

/// Where a falling function has a value.
fn solve(wanted: f64, range: [f64; 2], value: impl Fn(f64) -> f64) -> Result<f64> {
    if !wanted.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::FirstCell, index: 0 }.into());
    }
    let [mut low, mut high] = range;
    let (max, min) = (value(low), value(high));
    // Equal cells are found where all that is left of them is rounding.
    if !(wanted > 0.0 && wanted >= min && wanted <= max * (1.0 + 1e-12)) {
        return Err(NumberError::ParameterOutOfRange { name: ErrorItem::FirstCell, value: wanted, min, max }.into());
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if !(middle > low && middle < high) {
            break;
        }
        if value(middle) > wanted { low = middle } else { high = middle }
    }
    Ok(low)
}

fn check_cells(cells: usize) -> Result<()> {
    if (1..=MOST).contains(&cells) {
        return Ok(());
    }
    Err(NumberError::ParameterOutOfRange { name: ErrorItem::Cells, value: cells as f64, min: 1.0, max: MOST as f64 }
        .into())
}

#[cfg(test)]
mod tests {
    use super::*;

    const ENDS: [FineEnd; 3] = [FineEnd::Start, FineEnd::End, FineEnd::Both];

    fn lengths(grading: Grading, cells: usize) -> Vec<f64> {
        grading.places(cells).unwrap().windows(2).map(|w| w[1] - w[0]).collect()
    }

    #[test]
    fn neighbors_have_the_ratio() {
        for fine in ENDS {
            for n in [2, 7, 8, 30] {
                let l = lengths(Grading::Geometric { ratio: 1.3, fine }, n);
                for k in 1..n {
                    let wanted = match fine {
                        FineEnd::Start => 1.3,
                        FineEnd::End => 1.0 / 1.3,
                        FineEnd::Both if 2 * k < n => 1.3,
                        FineEnd::Both if 2 * k == n => 1.0,
                        FineEnd::Both => 1.0 / 1.3,
                    };
                    // Differences of places up to 1.
                    assert!((l[k] / l[k - 1] - wanted).abs() < 1e-15 / l[k].min(l[k - 1]), "{fine:?} {n} {k}: {l:?}");
                }
                let sum: f64 = l.iter().sum();
                assert!((sum - 1.0).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn tangents_are_their_formula() {
        for d in [1e-7, 0.3, 2.0, 9.0] {
            for k in 1..10 {
                let x = f64::from(k) / 10.0;
                let place = |fine| Grading::Tanh { stretch: d, fine }.place(k as usize, 10);
                let one = 1.0 + (d * (x - 1.0)).tanh() / d.tanh();
                let two = 0.5 * (1.0 + (d * (2.0 * x - 1.0)).tanh() / d.tanh());
                assert!((place(FineEnd::Start) - one).abs() < 1e-13); // 2e-13 below 1e-3 of cancellation in the formula
                assert!((place(FineEnd::Both) - two).abs() < 1e-13);
                assert!((place(FineEnd::End) - (d * x).tanh() / d.tanh()).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn first_cells_are_found() {
        for fine in ENDS {
            for (n, first) in [(12, 1e-4), (12, 1.0 / 12.0), (5, 0.01), (40, 1e-3)] {
                let end = |l: Vec<f64>| if fine == FineEnd::End { l[n - 1] } else { l[0] };
                let geometric = end(lengths(Grading::geometric_from_first(first, n, fine).unwrap(), n));
                let tanh = end(lengths(Grading::tanh_from_first(first, n, fine).unwrap(), n));
                // One rounding of a place near 1, and that of equal cells.
                assert!((geometric - first).abs() < 1e-15 + 1e-12 * first, "{geometric} {first}");
                assert!((tanh - first).abs() < 1e-15 + 1e-9 * first, "{tanh} {first}");
            }
        }
        let long = Grading::geometric_from_first(0.5, 5, FineEnd::Start).unwrap();
        assert!(matches!(long, Grading::Geometric { ratio, .. } if ratio < 1.0));
        let reason = |grading: Result<Grading>| grading.unwrap_err().reason();
        assert_eq!(reason(Grading::tanh_from_first(0.5, 5, FineEnd::Start)), "parameter-out-of-range");
        assert_eq!(reason(Grading::geometric_from_first(0.0, 5, FineEnd::Start)), "parameter-out-of-range");
        assert_eq!(reason(Grading::geometric_from_first(f64::NAN, 5, FineEnd::Start)), "not-finite");
        assert_eq!(reason(Grading::geometric_from_first(0.1, 0, FineEnd::Start)), "parameter-out-of-range");
    }

    #[test]
    fn cells_below_rounding_are_refused() {
        let grading = Grading::Geometric { ratio: 1000.0, fine: FineEnd::End };
        assert_eq!(grading.places(12).unwrap_err().reason(), "parameters-not-increasing");
        let grading = Grading::Geometric { ratio: 1000.0, fine: FineEnd::Start };
        assert!(grading.places(12).is_ok());
        assert_eq!(grading.places(300).unwrap_err().reason(), "parameters-not-increasing");
        assert_eq!(
            Grading::Tanh { stretch: 21.0, fine: FineEnd::Both }.places(3).unwrap_err().reason(),
            "parameter-out-of-range"
        );
        assert_eq!(Grading::Uniform.places(0).unwrap_err().reason(), "parameter-out-of-range");
    }
}
