//! How far hexahedra with straight sides are from their cells of blocks, proved.
//!
//! At equal parameters the way from one to the other is `(n - g w)/w` with the triquadratic numerator n and weight w of the cell and the trilinear hexahedron
//! g: a rational tricubic. Where its 64 weights are positive it is a mean of the quotients of its coefficients, so that none of its places is farther than the
//! farthest of these. Parts of cells for which that says much more than was met at their places are halved in all directions.

use cyclide::{Point3, volume::CyclideVolume};

/// What is proved may be so many times the largest distance that was met.
const SLACK: f64 = 1.5;
/// Parts of one cell that are looked at, where weights are positive.
const MOST_PARTS: usize = 512;
/// Halvings of a cell at most: those after which blocks of a document have positive weights.
const MOST_HALVINGS: u32 = 16;
/// Distances of so many roundings of the coordinates are none.
const ROUNDINGS: f64 = 64.0;

const SQUARE: [f64; 3] = [1.0, 2.0, 1.0];
const CUBE: [f64; 4] = [1.0, 3.0, 3.0, 1.0];

/// The rows `[x, y, z, w]` of a tricubic, that of u fastest.
type Cubic = [[f64; 4]; 64];

/// The distances of the cells that were added.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct LinearDistance {
    /// The largest that was met.
    met: f64,
    /// None is larger.
    bound: f64,
}

impl LinearDistance {
    /// None of the cells is farther, rounding included.
    pub(super) fn bound(self) -> f64 {
        self.bound
    }

    /// Adds the cell of a right-handed block over these ranges of its parameters, and the hexahedron with these corners, binary order.
    pub(super) fn add(&mut self, block: &CyclideVolume, ranges: [[f64; 2]; 3], corners: &[Point3; 8]) {
        let Ok(cell) = block.restricted(ranges) else {
            self.bound = f64::INFINITY;
            return;
        };
        let place = cell.corners().iter().chain(corners).map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let rounding = ROUNDINGS * f64::EPSILON * place;
        let cubic = way_between(cell.to_rational().rows(), corners);
        let mut looked_at = 0;
        self.bound = self.bound.max(rounding);
        self.add_part(&cubic, rounding, MOST_HALVINGS, &mut looked_at);
    }

    fn add_part(&mut self, cubic: &Cubic, rounding: f64, halvings: u32, looked_at: &mut usize) {
        *looked_at += 1;
        // What is no number is nowhere near.
        let of_row = |row: &[f64; 4]| {
            let far = length(row) / row[3];
            if row[3] > 0.0 && far >= 0.0 { far } else { f64::INFINITY }
        };
        let positive = cubic.iter().all(|row| row[3] > 0.0);
        if positive {
            self.met = places_of(cubic).iter().map(of_row).fold(self.met, f64::max);
        }
        let bound = rounding + cubic.iter().map(of_row).fold(0.0, f64::max);
        let enough = self.bound.max(SLACK * self.met).max(2.0 * rounding);
        if bound <= enough || halvings == 0 || positive && *looked_at > MOST_PARTS {
            self.bound = self.bound.max(bound);
            return;
        }
        for part in eighths(cubic) {
            self.add_part(&part, rounding, halvings - 1, looked_at);
        }
    }
}

fn length([x, y, z, _]: &[f64; 4]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// The tricubic `n - g w` over w of the rows `[n, w]` of a triquadratic.
fn way_between(rows: &[[f64; 4]], corners: &[Point3; 8]) -> Cubic {
    let mut cubic = [[0.0; 4]; 64];
    for (index, [x, y, z, w]) in rows.iter().enumerate() {
        let own = [index / 9, index / 3 % 3, index % 3];
        for (corner, g) in corners.iter().enumerate() {
            let at: [usize; 3] = std::array::from_fn(|axis| own[axis] + (corner >> axis & 1));
            let share: f64 = (0..3).map(|axis| SQUARE[own[axis]] / CUBE[at[axis]]).product();
            let way = [x - g.x * w, y - g.y * w, z - g.z * w, *w];
            let sum = &mut cubic[16 * at[0] + 4 * at[1] + at[2]];
            sum.iter_mut().zip(way).for_each(|(sum, value)| *sum += share * value);
        }
    }
    cubic
}

/// The eight parts of halves in all directions.
fn eighths(cubic: &Cubic) -> [Cubic; 8] {
    let mut parts = [*cubic; 8];
    for (part, rows) in parts.iter_mut().enumerate() {
        for axis in 0..3 {
            for first in firsts(axis) {
                let [a, b, c, d] = std::array::from_fn(|k| rows[first + k * STRIDES[axis]]);
                let (ab, bc, cd) = (mean(a, b), mean(b, c), mean(c, d));
                let (abc, bcd) = (mean(ab, bc), mean(bc, cd));
                let middle = mean(abc, bcd);
                let half = if part >> axis & 1 == 0 { [a, ab, abc, middle] } else { [middle, bcd, cd, d] };
                half.into_iter().enumerate().for_each(|(k, row)| rows[first + k * STRIDES[axis]] = row);
            }
        }
    }
    parts
}

/// The values at the ends and in the middle of each direction.
fn places_of(cubic: &Cubic) -> [[f64; 4]; 27] {
    let mut rows = *cubic;
    for axis in 0..3 {
        for first in firsts(axis) {
            let [a, b, c, d] = std::array::from_fn(|k| rows[first + k * STRIDES[axis]]);
            let middle = mean(mean(mean(a, b), mean(b, c)), mean(mean(b, c), mean(c, d)));
            // Its values in place of its coefficients, the last one twice.
            [a, middle, d, d].into_iter().enumerate().for_each(|(k, row)| rows[first + k * STRIDES[axis]] = row);
        }
    }
    std::array::from_fn(|k| rows[16 * (k / 9) + 4 * (k / 3 % 3) + k % 3])
}

/// From one coefficient to the next along each direction.
const STRIDES: [usize; 3] = [16, 4, 1];

/// The first coefficients of all lines along a direction.
fn firsts(axis: usize) -> impl Iterator<Item = usize> {
    (0..64).filter(move |k| (k / STRIDES[axis]).is_multiple_of(4))
}

fn mean(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|d| 0.5 * (a[d] + b[d]))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use cyclide::{
        Vec3,
        conformal::{Conformal as _, Mobius},
        volume::{ParamVolume as _, SphericalCube, VolumeFrame},
    };

    /// A unit box beside the center of an inversion: its speed varies a hundred times and more.
    fn uneven(center: [f64; 3]) -> CyclideVolume {
        let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z]).unwrap();
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
        block.transformed(&Mobius::inversion(Point3::from(center), 1.0).unwrap()).unwrap().right_handed()
    }

    #[test]
    fn no_place_is_farther_and_one_is_nearly_as_far() {
        for center in [[0.1, 0.13, -0.03], [0.5, 0.4, -0.2], [-1.0, -2.0, -3.0]] {
            let block = uneven(center);
            for cells in [1_usize, 2, 5] {
                let mut distance = LinearDistance::default();
                let mut largest = 0.0_f64;
                for cell in 0..cells.pow(3) {
                    let at = [cell % cells, cell / cells % cells, cell / cells / cells];
                    let ranges = at.map(|k| [k as f64 / cells as f64, (k + 1) as f64 / cells as f64]);
                    let place = |own: [f64; 3]| {
                        block.point(std::array::from_fn(|d| ranges[d][0] + (ranges[d][1] - ranges[d][0]) * own[d]))
                    };
                    let corners: [Point3; 8] =
                        std::array::from_fn(|k| place(std::array::from_fn(|d| (k >> d & 1) as f64)));
                    distance.add(&block, ranges, &corners);
                    for k in 0..17_usize.pow(3) {
                        let own = [k % 17, k / 17 % 17, k / 17 / 17].map(|k| k as f64 / 16.0);
                        let share = |corner: usize| {
                            let along = |d: usize| if corner >> d & 1 == 0 { 1.0 - own[d] } else { own[d] };
                            (0..3).map(along).product::<f64>()
                        };
                        let straight = (0..8).fold(Vec3::ZERO, |sum, k| sum + corners[k].to_vec() * share(k));
                        largest = largest.max((straight - place(own).to_vec()).length());
                    }
                }
                // Beside the center of the inversion the 17 places per direction miss a sixth of the largest.
                assert!(
                    largest <= distance.bound() && distance.bound() <= 1.75 * largest,
                    "{center:?} {cells}: {largest} {distance:?}"
                );
            }
        }
    }

    #[test]
    fn boxes_are_off_by_rounding() {
        let cube = SphericalCube::cuboid(Point3::new(7.0, 0.1, 3.0), [Vec3::X * 0.3, Vec3::Y, Vec3::Z]).unwrap();
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
        let mut distance = LinearDistance::default();
        distance.add(&block, [[0.0, 1.0]; 3], &block.corners());
        assert!(distance.bound() < 1e-12, "{distance:?}");
    }
}
