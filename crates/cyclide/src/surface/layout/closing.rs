//! The equations of nets that close round extraordinary vertices (`docs/math/circular-meshes.md#extraordinary-vertices`).
//!
//! Round a vertex of n quads a frame that is carried along the ring comes back turned by n - 4 quarter turns about the normal. Carried from
//! the base to the ring by p edges, round it and back, the product P of the unit edges is
//!
//! ```text
//! P = (-1)^(n+1) (cos(n pi/4) - (-1)^p sin(n pi/4) N)
//! ```
//!
//! with the one normal N of the net at the base: four equations for each vertex, of which one follows, with two unknowns for all of them, which are
//! eliminated: N is the direction that suits the vector parts best. (The real part alone tells half turns: their vector part is stationary.) The sign matters: with the other one the frame would come
//! back the same, but turned once more on its way than the edges.

use super::QuadLayout;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::surface::RingClosing;
use std::f64::consts::FRAC_PI_4;

/// Directions that add up to less than this are none.
const NO_DIRECTION: f64 = 1e-6;

/// What must vanish where a net shall close round extraordinary vertices.
#[derive(Debug, Clone)]
pub struct RoundClosing {
    rings: Vec<Ring>,
}

#[derive(Debug, Clone)]
struct Ring {
    /// A closed walk from the base, round one vertex.
    walk: Vec<usize>,
    /// The real part of the product times the sign, and the factor of the normal in its vector part.
    turn: [f64; 2],
    /// The sign above.
    sign: f64,
}

impl RoundClosing {
    /// Of all extraordinary vertices of a layout.
    pub fn new(layout: &QuadLayout) -> Self {
        let ring = |(at, (walk, before)): (&super::RoundVertex, (Vec<usize>, usize))| {
            let quads = at.ring.len() / 2;
            let angle = quads as f64 * FRAC_PI_4;
            let turn = [angle.cos(), if before % 2 == 0 { -angle.sin() } else { angle.sin() }];
            Ring { walk, turn, sign: if quads % 2 == 0 { -1.0 } else { 1.0 } }
        };
        Self { rings: layout.round().iter().zip(layout.walks()).map(ring).collect() }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.rings.is_empty()
    }

    /// The products of the walks with their signs; `None` if an edge has no direction.
    fn products(&self, points: &[Point3]) -> Option<Vec<RingClosing>> {
        self.rings.iter().map(|ring| product(points, &ring.walk).ok()).collect()
    }

    /// The sum of the vector parts that has the direction of the normal at the base, or none if all vector parts shall vanish.
    fn sum(&self, products: &[RingClosing]) -> Vec3 {
        let along = |(ring, product): (&Ring, &RingClosing)| product.product().vector() * (ring.sign * ring.turn[1]);
        self.rings.iter().zip(products).map(along).fold(Vec3::ZERO, |sum, v| sum + v)
    }

    /// The normal at the base of the net, if extraordinary vertices tell it.
    pub fn normal(&self, points: &[Point3]) -> Option<Vec3> {
        let sum = self.sum(&self.products(points)?);
        (sum.length() > NO_DIRECTION).then(|| sum.unit()).flatten()
    }

    /// What must vanish, four numbers for each vertex; `None` if an edge has no direction.
    pub fn values(&self, points: &[Point3]) -> Option<Vec<f64>> {
        let products = self.products(points)?;
        let sum = self.sum(&products);
        let normal = if sum.length() > NO_DIRECTION { sum.unit()? } else { Vec3::ZERO };
        let value = |(ring, product): (&Ring, &RingClosing)| {
            let product = product.product() * ring.sign;
            let [x, y, z] = (product.vector() - normal * ring.turn[1]).to_array();
            [product.w - ring.turn[0], x, y, z]
        };
        Some(self.rings.iter().zip(&products).flat_map(value).collect())
    }

    /// Their gradients, by vertices of which some come more than once.
    pub fn gradients(&self, points: &[Point3]) -> Option<Vec<Vec<(usize, Vec3)>>> {
        let products = self.products(points)?;
        let sum = self.sum(&products);
        // The gradients of the parts of each product with its sign.
        let of_part = |ring: &Ring, row: Vec<Vec3>| -> Vec<(usize, Vec3)> {
            ring.walk.iter().copied().zip(row.into_iter().map(|g| g * ring.sign)).collect()
        };
        let of_parts: Vec<[Vec<(usize, Vec3)>; 4]> = (self.rings.iter().zip(&products))
            .map(|(ring, product)| product.product_gradients().map(|row| of_part(ring, row)))
            .collect();
        let normal = if sum.length() > NO_DIRECTION { sum.unit() } else { None };
        let mut rows = Vec::with_capacity(4 * self.rings.len());
        for (ring, parts) in self.rings.iter().zip(&of_parts) {
            rows.push(parts[0].clone());
            for (k, axis) in [Vec3::X, Vec3::Y, Vec3::Z].into_iter().enumerate() {
                let mut row = parts[k + 1].clone();
                if let Some(normal) = normal {
                    // dN = (I - N Nᵀ) dS/|S|, S the sum of the vector parts times their factors.
                    let across = (axis - normal * normal[k]) * (-ring.turn[1] / sum.length());
                    for (other, parts) in self.rings.iter().zip(&of_parts) {
                        for (l, part) in parts[1..].iter().enumerate() {
                            let factor = across[l] * other.turn[1];
                            row.extend(part.iter().map(|(v, g)| (*v, *g * factor)));
                        }
                    }
                }
                rows.push(row);
            }
        }
        Some(rows)
    }

    /// The largest angle (radians) by which a frame comes back turned besides its quarter turns, and the number of the vertex; 0 where there
    /// are none.
    pub fn angle(&self, points: &[Point3]) -> (f64, usize) {
        let Some(products) = self.products(points) else { return (std::f64::consts::PI, 0) };
        let sum = self.sum(&products);
        let normal = if sum.length() > NO_DIRECTION { sum.unit().unwrap_or(Vec3::ZERO) } else { Vec3::ZERO };
        if normal == Vec3::ZERO && self.rings.iter().any(|ring| ring.turn[1].abs() > NO_DIRECTION) {
            // As round the corner of a box: no normal suits any better than others.
            return (std::f64::consts::PI, 0);
        }
        let angle = |(ring, product): (&Ring, &RingClosing)| {
            let target = Quat::from(normal * ring.turn[1]) + Quat::ONE * ring.turn[0];
            let off = (product.product() * ring.sign - target).norm();
            // The chord of half the angle.
            4.0 * (0.5 * off.min(2.0)).asin()
        };
        let angles = self.rings.iter().zip(&products).map(angle).enumerate();
        angles.fold((0.0, 0), |most, (k, angle)| if angle > most.0 { (angle, k) } else { most })
    }
}

fn product(points: &[Point3], walk: &[usize]) -> Result<RingClosing> {
    RingClosing::new(&walk.iter().map(|v| points[*v]).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::super::tests::cap;
    use super::*;

    #[test]
    fn gradients_agree_with_differences() {
        for n in [3, 5, 6] {
            let layout = cap(n, 3, |x, y| 0.3 * x * x - 0.1 * y * y + 0.2 * x * y * x);
            let closing = RoundClosing::new(&layout);
            let rows = closing.gradients(layout.points()).unwrap();
            let step = 1e-6;
            for v in 0..layout.points().len() {
                for (axis, e) in [Vec3::X, Vec3::Y, Vec3::Z].into_iter().enumerate() {
                    let at = |h: f64| {
                        let mut points = layout.points().to_vec();
                        points[v] += e * h;
                        closing.values(&points).unwrap()
                    };
                    let (before, after) = (at(-step), at(step));
                    for (k, row) in rows.iter().enumerate() {
                        let exact: f64 = row.iter().filter(|(w, _)| *w == v).map(|(_, g)| g[axis]).sum();
                        // Truncation step² times third derivatives near 1/edge³ and rounding 1e-16/step.
                        assert!((exact - (after[k] - before[k]) / (2.0 * step)).abs() < 1e-8, "{n} {v} {k}");
                    }
                }
            }
        }
    }
}
