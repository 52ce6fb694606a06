//! Parts of a seam, ruled between four cubics of its corners: apart where a plane parts their control points, free of themselves where their derivatives hardly change
//! (`docs/math/torus-splines.md#seams`).

use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};

/// A block of a seam between two parameters, two places across and two heights.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// The cubics of the corners round the section: low, low across, high across, high.
    cubics: [[Point3; 4]; 4],
    /// How often it was halved along the curve.
    pub(super) halvings: u32,
}

/// Derivatives along the curve, across and in height, in units of the speed in the middle of a part.
struct Derivatives {
    along: Vec<Vec3>,
    across: Vec<Vec3>,
    up: Vec<Vec3>,
}

/// The planes that are tried between two cells have these normals: of the sections at both ends, and the directions in their middle.
struct Directions {
    ends: [Vec3; 2],
    frame: [Vec3; 3],
}

impl Cell {
    /// The block less a margin on all four sides.
    pub(super) fn inside(cubics: &[[Point3; 4]; 4], [across, up]: [f64; 2]) -> Self {
        let [a, b, c, d] = *cubics;
        let place = |k: usize, u: f64, v: f64| a[k].lerp(b[k], u).lerp(d[k].lerp(c[k], u), v);
        let corners = [[across, up], [1.0 - across, up], [1.0 - across, 1.0 - up], [across, 1.0 - up]];
        Self { cubics: corners.map(|[u, v]| std::array::from_fn(|k| place(k, u, v))), halvings: 0 }
    }

    fn points(&self) -> impl Iterator<Item = Point3> {
        self.cubics.iter().flatten().copied()
    }

    pub(super) fn hull(&self) -> Aabb {
        self.points().fold(Aabb::of_point(self.cubics[0][0]), Aabb::including)
    }

    /// Lengths along the curve, across and in height, at most.
    pub(super) fn sizes(&self) -> [f64; 3] {
        let [a, b, c, d] = &self.cubics;
        let longest = |one: &[Point3; 4], other: &[Point3; 4]| {
            one.iter().zip(other).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max)
        };
        let length = |cubic: &[Point3; 4]| cubic.windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>();
        let along = self.cubics.iter().map(length).fold(0.0, f64::max);
        [along, longest(a, b).max(longest(d, c)), longest(a, d).max(longest(b, c))]
    }

    /// Its middle.
    pub(super) fn middle(&self) -> Point3 {
        let sum =
            self.cubics.iter().map(|[a, b, c, d]| (a.to_vec() + d.to_vec() + (b.to_vec() + c.to_vec()) * 3.0) / 8.0);
        Point3::ORIGIN + sum.fold(Vec3::ZERO, |sum, p| sum + p) / 4.0
    }

    /// Its halves: along the curve (0), across (1) or in height (2).
    pub(super) fn halves(&self, direction: usize) -> [Self; 2] {
        let [a, b, c, d] = self.cubics;
        let between = |one: [Point3; 4], other: [Point3; 4]| std::array::from_fn(|k| one[k].midpoint(other[k]));
        let same = |cubics| Self { cubics, ..*self };
        match direction {
            0 => {
                let parts = self.cubics.map(halves_of_cubic);
                [0, 1].map(|half| Self { cubics: parts.map(|part| part[half]), halvings: self.halvings + 1 })
            }
            1 => {
                let (low, high) = (between(a, b), between(d, c));
                [same([a, low, high, d]), same([low, b, c, high])]
            }
            _ => {
                let (first, second) = (between(a, d), between(b, c));
                [same([a, b, second, first]), same([first, second, c, d])]
            }
        }
    }

    fn directions(&self) -> Directions {
        let section = |k: usize| [self.cubics[1][k] - self.cubics[0][k], self.cubics[3][k] - self.cubics[0][k]];
        let normal = |[across, up]: [Vec3; 2]| across.cross(up);
        let [one, other] = [section(0), section(3)];
        let middle = [one[0] + other[0], one[1] + other[1]];
        Directions { ends: [normal(one), normal(other)], frame: [normal(middle), middle[0], middle[1]] }
    }

    /// True if a plane parts the control points of both.
    pub(super) fn is_apart(&self, other: &Self) -> bool {
        let (own, others) = (self.directions(), other.directions());
        let crossed = own.frame.into_iter().flat_map(|u| others.frame.map(|v| u.cross(v)));
        let between = other.middle() - self.middle();
        let single = [own.ends, others.ends].into_iter().flatten().chain(own.frame).chain(others.frame);
        let mut all = std::iter::once(between).chain(single).chain(crossed);
        all.any(|axis| {
            let range = |cell: &Self| {
                let along = cell.points().map(|p| (p - self.cubics[0][0]).dot(axis));
                along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
            };
            let ([low, high], [other_low, other_high]) = (range(self), range(other));
            high < other_low || other_high < low
        })
    }

    fn derivatives(&self) -> Option<Derivatives> {
        let [a, b, c, d] = &self.cubics;
        let along: Vec<Vec3> =
            self.cubics.iter().flat_map(|cubic| [0, 1, 2].map(|k| cubic[k + 1] - cubic[k])).collect();
        let speed = (along.iter().fold(Vec3::ZERO, |sum, v| sum + *v) / along.len() as f64).length();
        let between = |one: &[Point3; 4], other: &[Point3; 4]| (0..4).map(|k| other[k] - one[k]).collect::<Vec<_>>();
        let pair = |one: Vec<Vec3>, other: Vec<Vec3>| one.into_iter().chain(other).collect();
        (speed > 0.0).then(|| Derivatives {
            along: along.into_iter().map(|v| v / speed).collect(),
            across: pair(between(a, b), between(d, c)),
            up: pair(between(a, d), between(b, c)),
        })
    }
}

fn halves_of_cubic([a, b, c, d]: [Point3; 4]) -> [[Point3; 4]; 2] {
    let (ab, bc, cd) = (a.midpoint(b), b.midpoint(c), c.midpoint(d));
    let (abc, bcd) = (ab.midpoint(bc), bc.midpoint(cd));
    let middle = abc.midpoint(bcd);
    [[a, ab, abc, middle], [middle, bcd, cd, d]]
}

/// True if cells, one behind the other, are one-to-one: after the inverse of the middle derivatives all derivatives are off the unit matrix by less than 1, which sums of them are
/// then too, and none of these is singular. The speed may be measured in another unit than what is across it: the best one is taken.
pub(super) fn are_free(cells: &[&Cell]) -> bool {
    let Some(all) = cells.iter().map(|cell| cell.derivatives()).collect::<Option<Vec<_>>>() else { return false };
    let columns: [Vec<Vec3>; 3] = [
        all.iter().flat_map(|one| one.along.iter().copied()).collect(),
        all.iter().flat_map(|one| one.across.iter().copied()).collect(),
        all.iter().flat_map(|one| one.up.iter().copied()).collect(),
    ];
    let [x, y, z] = [0, 1, 2].map(|k| columns[k].iter().fold(Vec3::ZERO, |sum, v| sum + *v) / columns[k].len() as f64);
    // In lengths: a section may be many times as high as wide.
    let units = [x, y, z].map(Vec3::length);
    let (rows, det) = ([y.cross(z), z.cross(x), x.cross(y)], x.dot(y.cross(z)));
    if !(det.abs() > 0.0) {
        return false;
    }
    let most = |column: usize, row: &[usize]| {
        let off = |v: &Vec3| {
            let square = |k: &usize| {
                (rows[*k].dot(*v) / det * (units[*k] / units[column]) - if *k == column { 1.0 } else { 0.0 }).powi(2)
            };
            row.iter().map(square).sum::<f64>()
        };
        columns[column].iter().map(off).fold(0.0, f64::max)
    };
    let same = most(0, &[0]) + most(1, &[1, 2]) + most(2, &[1, 2]);
    let (of_speed, of_section) = (most(0, &[1, 2]), most(1, &[0]) + most(2, &[0]));
    same + 2.0 * (of_speed * of_section).sqrt() < 1.0
}
