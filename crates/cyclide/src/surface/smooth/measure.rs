//! Area and volume of a smooth mesh by quadrature, with error control by quartering.

use super::SmoothMesh;
use super::triangle::Jet;
use crate::base::bounds::Aabb;
use crate::base::quadrature::{unit_rule2, unit_rule4};
use crate::base::vector::{Point3, Vec3};
use crate::error::{NumberError, Result};
use crate::surface::SphereBlend;
use crate::surface::barycentric::Barycentric;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Measures of a surface over triangles with the estimate of their errors, from how much a rule with half as many nodes in each direction
/// differs, part by part.
///
/// ```
/// use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
/// let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]].map(Point3::from);
/// let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
/// let measure = SmoothMesh::new(&corners, &faces, VertexNormals::AngleWeighted)?.measure()?;
/// assert!(measure.volume.is_some_and(|volume| volume > 8.0 / 3.0)); // rounder than the tetrahedron
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SmoothMeasure {
    /// Area.
    pub area: f64,
    /// Estimated error of it.
    pub area_error: f64,
    /// Volume enclosed by a closed mesh, positive if its triangles are counter-clockwise seen from outside; `None` for an open one.
    pub volume: Option<f64>,
    /// Estimated error of it; 0 for an open mesh.
    pub volume_error: f64,
}

impl SmoothMesh {
    /// Area and volume. The patches are smooth in polar coordinates about their corners, so each is cut into six triangles with one corner of
    /// the patch each, and a Gauss-Legendre rule of 4 x 4 nodes is taken there in such coordinates. The parts with the largest
    /// errors, estimated from the differences from the rule of 2 x 2 nodes, are quartered until all errors together are below a millionth, or
    /// the cap on work is spent.
    ///
    /// # Errors
    /// `too-many-pieces` where more than a thousandth is left uncertain then; as [`SmoothTriangle::point`](crate::surface::SmoothTriangle::point),
    /// with the number of the triangle.
    pub fn measure(&self) -> Result<SmoothMeasure> {
        let count = self.triangles().len();
        let jet = |triangle: usize, at: &Barycentric| self.patch(triangle).jet(at).map_err(|e| e.in_triangle(triangle));
        Quadrature::new(jet, count, self.middle(), self.is_closed())?.refined()?.known()
    }

    /// The middle of the box of its vertices: seen from there no digits of the volume are lost.
    fn middle(&self) -> Point3 {
        let used = self.triangles().iter().flatten().map(|&v| self.positions()[v]);
        Aabb::of_points(used).map_or(Point3::ORIGIN, |b| b.min.midpoint(b.max))
    }
}

impl SphereBlend {
    /// Area, as [`SmoothMesh::measure`].
    ///
    /// # Errors
    /// `too-many-pieces` where more than a thousandth is left uncertain.
    pub fn measure(&self) -> Result<SmoothMeasure> {
        Quadrature::new(|_, at| self.jet(at), 1, self.corners()[0], false)?.refined()?.known()
    }
}

/// Errors above this part of the area, and of the sum of the absolute volumes of parts, are refined.
const AGREEMENT: f64 = 1e-6;
/// What is left uncertain beyond this part is not known: reports say how much is.
const UNKNOWN: f64 = 1e-3;
/// What a difference of the rules, as a part of the integral, is multiplied by when it is squared.
const SQUARE: f64 = 16.0;
/// Quarterings at most, and one more for so many parts.
const QUARTERINGS: [usize; 2] = [4096, 16];
/// Triangles from which on their parts are not cut at first, and the most parts of each coordinate: some thousand places are looked at in
/// any mesh.
const ENOUGH: usize = 512;
const MOST_PANELS: f64 = 8.0;

/// A part of one of the six triangles of a patch in polar coordinates about its corner.
#[derive(Debug, Clone, Copy)]
struct Part {
    triangle: usize,
    corner: usize,
    cell: usize,
    /// Where it starts in the radius and in the turn, and how long it is in both.
    start: [f64; 2],
    length: f64,
}

/// The integrals over a part: area, and volume over the apex.
#[derive(Debug, Clone, Copy)]
struct Measured {
    part: Part,
    sums: [f64; 2],
    /// Of the absolute values.
    sizes: [f64; 2],
    /// What is estimated from the difference of the coarse rule.
    errors: [f64; 2],
    /// The larger error as a part of what is measured.
    uncertain: f64,
}

impl PartialEq for Measured {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Measured {}

impl PartialOrd for Measured {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Measured {
    fn cmp(&self, other: &Self) -> Ordering {
        self.uncertain.total_cmp(&other.uncertain)
    }
}

/// Quadrature over patches, part by part.
struct Quadrature<F> {
    jet: F,
    apex: Point3,
    closed: bool,
    parts: BinaryHeap<Measured>,
    /// Area, and sum of the absolute volumes of parts, by which errors are weighed.
    scale: [f64; 2],
}

impl<F: Fn(usize, &Barycentric) -> Result<Jet>> Quadrature<F> {
    fn new(jet: F, triangles: usize, apex: Point3, closed: bool) -> Result<Self> {
        let panels = ((ENOUGH / triangles.max(1)) as f64).sqrt().clamp(1.0, MOST_PANELS) as usize;
        let mut made = Self { jet, apex, closed, parts: BinaryHeap::new(), scale: [0.0; 2] };
        let length = 1.0 / panels as f64;
        let mut first = Vec::with_capacity(6 * panels * panels * triangles);
        for triangle in 0..triangles {
            for (corner, cell) in (0..3).flat_map(|corner| [(corner, 0), (corner, 1)]) {
                for (i, j) in (0..panels).flat_map(|i| (0..panels).map(move |j| (i, j))) {
                    let start = [i as f64 * length, j as f64 * length];
                    first.push(made.measured(Part { triangle, corner, cell, start, length })?);
                }
            }
        }
        for measured in &first {
            (0..2).for_each(|k| made.scale[k] += measured.sizes[k]);
        }
        first.iter_mut().for_each(|measured| measured.uncertain = made.weighed(measured.errors));
        made.parts = first.into();
        Ok(made)
    }

    /// Errors as parts of what is measured, the larger one.
    fn weighed(&self, errors: [f64; 2]) -> f64 {
        let of = |k: usize| if self.scale[k] > 0.0 { errors[k] / self.scale[k] } else { 0.0 };
        if self.closed { of(0).max(of(1)) } else { of(0) }
    }

    /// Quarters the most uncertain part until all is certain enough or the work is done.
    fn refined(mut self) -> Result<Self> {
        let most = QUARTERINGS[0] + self.parts.len() / QUARTERINGS[1];
        let mut uncertain: f64 = self.parts.iter().map(|part| part.uncertain).sum();
        for _ in 0..most {
            if !(uncertain > AGREEMENT) {
                break;
            }
            let Some(worst) = self.parts.pop() else { break };
            uncertain -= worst.uncertain;
            let Part { start, length, .. } = worst.part;
            let half = 0.5 * length;
            for (i, j) in [(0.0, 0.0), (0.0, half), (half, 0.0), (half, half)] {
                let part = Part { start: [start[0] + i, start[1] + j], length: half, ..worst.part };
                let mut measured = self.measured(part)?;
                measured.uncertain = self.weighed(measured.errors);
                uncertain += measured.uncertain;
                self.parts.push(measured);
            }
        }
        Ok(self)
    }

    /// The sums, unless too much of them is uncertain.
    ///
    /// # Errors
    /// `too-many-pieces`.
    fn known(self) -> Result<SmoothMeasure> {
        let (mut sums, mut errors, mut absolute) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        // What rounding lost of the sums: there are thousands of parts.
        let mut lost = [0.0; 2];
        for measured in self.parts.iter() {
            for k in 0..2 {
                let part = measured.sums[k] - lost[k];
                let sum = sums[k] + part;
                lost[k] = (sum - sums[k]) - part;
                sums[k] = sum;
                errors[k] += measured.errors[k];
                absolute[k] += measured.sizes[k];
            }
        }
        for (k, what) in [(0, "an area by quadrature"), (1, "a volume by quadrature")] {
            if (k == 0 || self.closed) && !(errors[k] <= UNKNOWN * absolute[k]) {
                let remedy = "the surface extends too far, or folds: check its normals";
                return Err(NumberError::TooManyPieces {
                    what,
                    segment: None,
                    needed: f64::INFINITY,
                    cap: self.parts.len(),
                    remedy,
                }
                .into());
            }
        }
        let [area, volume] = sums;
        let closed = self.closed;
        let volume_error = if closed { errors[1] } else { 0.0 };
        Ok(SmoothMeasure { area, area_error: errors[0], volume: closed.then_some(volume), volume_error })
    }

    /// The integrals over a part by the fine rule, with what the coarse one differs.
    fn measured(&self, part: Part) -> Result<Measured> {
        let [sums, sizes] = self.sums(&part, &unit_rule4())?;
        let [coarse, _] = self.sums(&part, &unit_rule2())?;
        let errors = [0, 1].map(|k| {
            let difference = (sums[k] - coarse[k]).abs();
            // Of half as many nodes the error is the root of the error, as a part: where it is small, that of the fine rule is far below it.
            let part = if sizes[k] > 0.0 { difference / sizes[k] } else { 1.0 };
            difference * (SQUARE * part).min(1.0)
        });
        Ok(Measured { part, sums, sizes, errors, uncertain: 0.0 })
    }

    /// The sums of a rule, and those of the absolute values.
    fn sums(&self, part: &Part, rule: &[(f64, f64)]) -> Result<[[f64; 2]; 2]> {
        let [a, b] = CELLS[part.cell];
        let [mut sums, mut sizes] = [[0.0; 2]; 2];
        for (radius, radius_weight) in rule.iter().map(|(x, w)| (part.start[0] + part.length * x, part.length * w)) {
            for (turn, turn_weight) in rule.iter().map(|(x, w)| (part.start[1] + part.length * x, part.length * w)) {
                let mut lambda = [0.0; 3];
                for k in 0..3 {
                    let own = if k == 0 { 1.0 - radius } else { 0.0 };
                    lambda[(part.corner + k) % 3] = own + radius * ((1.0 - turn) * a[k] + turn * b[k]);
                }
                let jet = (self.jet)(part.triangle, &Barycentric::new(lambda)?)?;
                let element: Vec3 = jet.derivatives[0].cross(jet.derivatives[1]);
                // A cell is a sixth of the triangle, which is half of the unit square of its coordinates.
                let weight = radius * radius_weight * turn_weight / 6.0;
                let values = [weight * element.length(), weight * (jet.point - self.apex).dot(element) / 3.0];
                for k in 0..2 {
                    sums[k] += values[k];
                    sizes[k] += values[k].abs();
                }
            }
        }
        Ok([sums, sizes])
    }
}

/// The middles of the sides and of the triangle, as barycentric coordinates from a corner on.
const CELLS: [[[f64; 3]; 2]; 2] = {
    let third = 1.0 / 3.0;
    [[[0.5, 0.5, 0.0], [third; 3]], [[third; 3], [0.5, 0.0, 0.5]]]
};
