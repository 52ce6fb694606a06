//! Where a person goes on from what was said about a net: the cause, and what leads out of it.

use cyclide::{
    Error as KernelError, Point3, ShortNumber,
    error::{PartError, PatchError},
    model::Units,
    surface::{CyclidicNet, NetFrame, QuadGrid, Seam, SeamMeasure},
};

use crate::document::kinds::cyclidic_net::make_circular::MakeCircularSpec;

/// Fewer digits are short numbers, not rounded ones.
const FEWEST_DIGITS: usize = 4;

/// More digits are exact enough for every limit of a net.
const MOST_DIGITS: usize = 9;

/// The digits that suffice: rounding is then below the limits of a net by an order or two.
const ENOUGH_DIGITS: usize = 12;

/// What rounding of both ends of an edge may do, in units of the rounding over the edge: the factor by which the kernel
/// allows for that of doubles.
const ROUNDINGS: f64 = 8.0;

/// Borders this part of the net's size apart lie on each other.
const LYING: f64 = 1e-12;

/// The decimal digits that the coordinates of a grid carry.
struct Digits {
    count: usize,
    /// Half a unit of the last digit of the largest coordinate.
    rounding: f64,
}

impl Digits {
    /// `None` for coordinates that are not rounded to a few digits.
    fn of(grid: &QuadGrid) -> Option<Self> {
        let coordinates = || grid.points().iter().flat_map(|p| [p.x, p.y, p.z]);
        let largest = coordinates().fold(0.0_f64, |m, x| m.max(x.abs()));
        let count = coordinates().map(digits).max().unwrap_or(0);
        let exponent = largest.log10().floor() as i32 + 1 - count as i32;
        (FEWEST_DIGITS..=MOST_DIGITS).contains(&count).then(|| Self { count, rounding: 0.5 * 10.0_f64.powi(exponent) })
    }
}

impl Digits {
    /// How far rounding can turn an edge of some quads, radians, which is how far it can throw a corner of them off
    /// their circles, in their size.
    fn reach(&self, grid: &QuadGrid, quads: &[[usize; 2]]) -> f64 {
        let shortest = |[i, j]: &[usize; 2]| {
            let [a, b, c, d]: [Point3; 4] = grid.corners(*i, *j).map(|k| grid.points()[k]);
            a.distance(b).min(a.distance(c)).min(b.distance(d)).min(c.distance(d))
        };
        ROUNDINGS * self.rounding / quads.iter().map(shortest).fold(f64::INFINITY, f64::min)
    }

    fn words(&self) -> String {
        let count = self.count;
        format!("the cause is that the coordinates have only about {count} digits: use {ENOUGH_DIGITS} or more")
    }
}

/// Digits of the shortest decimal of a number.
fn digits(x: f64) -> usize {
    format!("{x:e}").split('e').next().unwrap_or_default().chars().filter(char::is_ascii_digit).count()
}

/// What leads on from an error of a net over a grid as given, whose vertices were moved or could have been.
pub(in crate::document) fn hint(error: &KernelError, given: &QuadGrid, spec: &MakeCircularSpec) -> Option<String> {
    match error {
        KernelError::Part(PartError::InQuad { quad, cause }) => {
            let KernelError::Patch(PatchError::NotConcircular { measured, .. }) = **cause else { return None };
            let columns = given.quads()[0];
            let digits = Digits::of(given).filter(|d| measured <= d.reach(given, &[[quad % columns, quad / columns]]));
            Some(match digits {
                None => "use `make_circular`, which moves the vertices until they do".to_owned(),
                Some(digits) => {
                    format!("{}; or use `make_circular`, which moves the vertices by as little", digits.words())
                }
            })
        }
        KernelError::Patch(PatchError::NetDoesNotClose { direction, angle, .. }) => {
            let [m, n] = given.quads();
            let strip: Vec<[usize; 2]> =
                if *direction == 0 { (0..m).map(|i| [i, 0]).collect() } else { (0..n).map(|j| [0, j]).collect() };
            let digits = Digits::of(given).filter(|d| *angle <= d.reach(given, &strip) * strip.len() as f64);
            let border = if *direction == 0 { "column" } else { "row" };
            let open = format!(
                "cut it open: repeat the first {border} as the last one and remove `closed` (in a mesh file, use \
                 separate points on both sides of the cut), which leaves a seam there"
            );
            let moves = if spec.options().is_none() {
                "use `make_circular`, which moves the vertices until it closes; or "
            } else if spec.border_is_pinned() {
                "a pinned border that rotates the frame cannot close: make it `free`, or let it slide on curves; or "
            } else {
                ""
            };
            let digits = digits.map_or(String::new(), |digits| format!("{}; or ", digits.words()));
            Some(format!("{digits}{moves}{open}"))
        }
        _ => None,
    }
}

/// True if the grid makes a net with its last border left out and the direction across closed.
fn closes(grid: &QuadGrid, seam: Seam) -> bool {
    let ([m, n], mut closed, mut size) = (grid.size(), grid.closed(), grid.size());
    closed[seam.direction] = true;
    size[seam.direction] -= 1;
    let kept = |k: &usize| if seam.direction == 0 { k % m < m - 1 } else { k / m < n - 1 };
    let points = (0..m * n).filter(kept).map(|k| grid.points()[k]).collect();
    let made = QuadGrid::new(points, size, closed).and_then(|grid| CyclidicNet::new(grid, NetFrame::Auto));
    !seam.reversed && made.is_ok()
}

/// The warning about borders that nearly coincide; `None` where the surface goes on over them.
pub(in crate::document) fn seam_words(
    seam: Seam,
    measure: SeamMeasure,
    grid: &QuadGrid,
    units: Units,
) -> Option<String> {
    let border = ["column", "row"][seam.direction];
    let size = grid.points().iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    let lying = measure.gap <= LYING * size;
    if lying && measure.angle <= cyclide::curve::CORNER_ANGLE {
        return None;
    }
    let angle = format!("an angle of up to {} degrees", ShortNumber(measure.angle.to_degrees()));
    let facts = if lying {
        let closed = if closes(grid, seam) {
            "close the grid with `closed`, or with common points in a mesh file"
        } else {
            "as given, the grid does not close: use `closed` with `make_circular`, which moves the vertices until it does"
        };
        format!("they are coincident, and the surface has {angle} there; {closed}")
    } else {
        let gap = ShortNumber(measure.gap);
        format!(
            "the surface has a gap of up to {gap} {} and {angle}; if it should close there, close the grid with \
             `closed`, or with common points in a mesh file, with `make_circular`, which moves the vertices until it \
             does",
            units.symbol()
        )
    };
    Some(format!(
        "the distance between the first and the last {border} of the grid is at most an edge length, but the net is open there: {facts}"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_those_of_the_shortest_decimal() {
        for (x, count) in [(0.0, 1), (2.0, 1), (1.931852, 7), (-0.00012, 2), (1200.5, 5), (0.1 + 0.2, 17)] {
            assert_eq!(digits(x), count, "{x}");
        }
    }
}
