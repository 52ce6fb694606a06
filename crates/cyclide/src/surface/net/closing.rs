//! Whether the closed lines and strips of a grid bring the frame and the speeds of a net back
//! (`docs/math/cyclides-and-nets.md#frames-and-weights-of-a-net`).
//!
//! Round a closed line of m vertices with the unit edges `d_k` the frame comes back iff `P = d_0 d_1 ... d_{m-1}` times
//! `V1^m` is real: `Im P = 0` for even m, three equations; `Re P = 0` for odd m, one, and `V1 = ±Im P` then. Round a
//! strip of quads the lines across come back at their speed iff `sum ln(delta_12/delta_03) = 0`. The derivatives, with
//! the product `L_k` of the edges before an edge and `R_k` of those after it, are
//!
//! ```text
//! dP = sum_k L_k (I - d_k d_k^T)(dx_{k+1} - dx_k)/delta_k R_k
//! d ln(delta_12/delta_03) = <x2 - x1, dx2 - dx1>/delta_12² - <x3 - x0, dx3 - dx0>/delta_03²
//! ```

use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, PointError, Result};
use crate::surface::quad_grid::QuadGrid;

/// A closed line of points, as of a grid: what it does to a frame that is carried round.
///
/// ```
/// use cyclide::{Point3, surface::RingClosing};
/// let corner = |k: i32| Point3::new((0.4 * f64::from(k * k)).cos(), f64::from(k), 0.3 * f64::from(k % 2));
/// let odd = RingClosing::new(&(0..5).map(corner).collect::<Vec<_>>())?;
/// assert!(odd.angle() > 0.1 && odd.equations().len() == 1 && odd.axis().is_some());
/// let planar = [[0.0, 0.0], [3.0, 0.0], [2.0, 2.0]].map(|[x, y]| Point3::new(x, y, 0.0));
/// assert!(RingClosing::new(&planar)?.angle() < 1e-15); // an odd number of edges in one plane
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RingClosing {
    /// Unit edges with their lengths, the last one back to the first point.
    edges: Vec<(Vec3, f64)>,
    product: Quat,
}

impl RingClosing {
    /// Of at least three points, neighbors apart.
    ///
    /// # Errors
    /// `too-few-points`, `coincident-points`.
    pub fn new(points: &[Point3]) -> Result<Self> {
        let m = points.len();
        if m < 3 {
            return Err(PointError::TooFewPoints { given: m, needed: 3 }.into());
        }
        let edge = |k: usize| {
            let (first, second) = (k, (k + 1) % m);
            let chord = points[second] - points[first];
            let apart =
                || Error::Point(PointError::CoincidentPoints { first, second, distance: chord.length(), limit: 0.0 });
            Ok((chord.unit().ok_or_else(apart)?, chord.length()))
        };
        let edges: Vec<(Vec3, f64)> = (0..m).map(edge).collect::<Result<_>>()?;
        let product = edges.iter().fold(Quat::ONE, |product, (d, _)| product * Quat::from(*d));
        Ok(Self { edges, product })
    }

    fn is_even(&self) -> bool {
        self.edges.len().is_multiple_of(2)
    }

    /// The product of the unit edges in order.
    #[must_use]
    pub fn product(&self) -> Quat {
        self.product
    }

    /// The angle by which a frame comes back turned, radians, from 0 to pi; of an odd number of edges that of the best
    /// frame.
    #[must_use]
    pub fn angle(&self) -> f64 {
        let [across, along] = [self.product.vector().length(), self.product.w.abs()];
        2.0 * if self.is_even() { across.atan2(along) } else { along.atan2(across) }
    }

    /// The direction along the line, up to its sign, of the only frames that an odd number of edges may bring back;
    /// `None` of an even number, which brings all frames back or none.
    #[must_use]
    pub fn axis(&self) -> Option<Vec3> {
        if self.is_even() { None } else { self.product.vector().unit() }
    }

    /// What must vanish: the vector part of the product of an even number of edges, the real part of an odd one.
    #[must_use]
    pub fn equations(&self) -> Vec<f64> {
        if self.is_even() { self.product.vector().to_array().to_vec() } else { vec![self.product.w] }
    }

    /// The gradient of each equation by each point.
    #[must_use]
    pub fn gradients(&self) -> Vec<Vec<Vec3>> {
        let [real, x, y, z] = self.product_gradients();
        if self.is_even() { vec![x, y, z] } else { vec![real] }
    }

    /// The gradients of the parts w, x, y, z of the product by each point.
    pub(in crate::surface) fn product_gradients(&self) -> [Vec<Vec3>; 4] {
        let m = self.edges.len();
        let mut after = vec![Quat::ONE; m];
        for k in (1..m).rev() {
            after[k - 1] = Quat::from(self.edges[k].0) * after[k];
        }
        let mut gradients = [0; 4].map(|_| vec![Vec3::ZERO; m]);
        let mut before = Quat::ONE;
        for (k, &(d, length)) in self.edges.iter().enumerate() {
            // The derivatives by the axes, as columns: part[axis] of each equation.
            let along = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| before * Quat::from(axis) * after[k]);
            for (part, gradient) in gradients.iter_mut().enumerate() {
                let by_edge = Vec3::from(along.map(|q| if part == 0 { q.w } else { q.vector()[part - 1] }));
                let by_chord = (by_edge - d * d.dot(by_edge)) / length;
                gradient[(k + 1) % m] += by_chord;
                gradient[k] -= by_chord;
            }
            before *= Quat::from(d);
        }
        gradients
    }
}

/// A closed strip of quads: what it does to the speed of the lines across.
///
/// ```
/// use cyclide::{Point3, surface::StripClosing};
/// let at = |k: usize, z: f64, twist: f64| {
///     let a = std::f64::consts::TAU * (k % 5) as f64 / 5.0 + twist * z;
///     Point3::new(a.cos(), a.sin(), z)
/// };
/// let strip = |twist: f64| (0..5).map(move |k| [(0, 0.0), (1, 0.0), (0, 1.0), (1, 1.0)].map(|(next, z)| at(k + next, z, twist)));
/// assert!(StripClosing::new(strip(0.0).collect())?.equation().abs() < 1e-15);
/// assert!(StripClosing::new(strip(0.2).collect())?.equation().abs() > 0.1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct StripClosing {
    quads: Vec<[Point3; 4]>,
}

impl StripClosing {
    /// Of the corners of its quads in binary order, with diagonals of some length.
    ///
    /// # Errors
    /// `coincident-points` within the quad.
    pub fn new(quads: Vec<[Point3; 4]>) -> Result<Self> {
        for (quad, a) in quads.iter().enumerate() {
            for [first, second] in [[1, 2], [0, 3]] {
                let distance = a[first].distance(a[second]);
                if !(distance > 0.0) {
                    return Err(
                        Error::from(PointError::CoincidentPoints { first, second, distance, limit: 0.0 }).in_quad(quad)
                    );
                }
            }
        }
        Ok(Self { quads })
    }

    /// What must vanish: the logarithm of the ratio of the speeds after and before a turn.
    #[must_use]
    pub fn equation(&self) -> f64 {
        self.quads.iter().map(|a| (a[1].distance(a[2]) / a[0].distance(a[3])).ln()).sum()
    }

    /// Its gradient by the corners of each quad.
    #[must_use]
    pub fn gradients(&self) -> Vec<[Vec3; 4]> {
        let gradient = |a: &[Point3; 4]| {
            let [first, second] = [a[2] - a[1], a[3] - a[0]].map(|chord| chord / chord.length_squared());
            [second, -first, first, -second]
        };
        self.quads.iter().map(gradient).collect()
    }
}

/// How far a closed direction of a grid is from bringing frames and speeds back.
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// let at = |k: usize| {
///     let (a, z) = (std::f64::consts::TAU * (k % 8) as f64 / 8.0, (k / 8) as f64);
///     Point3::new(3.0 * a.cos(), 2.0 * a.sin(), z)
/// };
/// let grid = QuadGrid::new((0..16).map(at).collect(), [8, 2], [true, false])?;
/// let closing = grid.closing(0)?.expect("it is closed along s");
/// assert!(closing.angle > 1e-3 && closing.stretch < 1e-15); // rectangles of unequal widths
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct GridClosing {
    /// The largest angle by which a frame comes back turned, of all lines along the direction, radians. In a circular
    /// grid it is the same for all.
    pub angle: f64,
    /// The largest difference from 1 of the ratio of speeds after and before a turn, of all strips along the direction.
    pub stretch: f64,
}

impl QuadGrid {
    /// How far a direction (0 for s, 1 for t) is from closing as a net; `None` if it is open.
    ///
    /// # Errors
    /// `coincident-points`.
    pub fn closing(&self, direction: usize) -> Result<Option<GridClosing>> {
        if !self.closed()[direction] {
            return Ok(None);
        }
        let mut closing = GridClosing { angle: 0.0, stretch: 0.0 };
        for line in 0..self.size()[1 - direction] {
            let points: Vec<Point3> = self.line(direction, line).into_iter().map(|v| self.points()[v]).collect();
            closing.angle = closing.angle.max(RingClosing::new(&points)?.angle());
        }
        for strip in 0..self.quads()[1 - direction] {
            let quads = self.strip(direction, strip).into_iter().map(|quad| quad.map(|v| self.points()[v]));
            let ratio = StripClosing::new(quads.collect())?.equation().exp_m1();
            closing.stretch = closing.stretch.max(ratio.abs());
        }
        Ok(Some(closing))
    }

    /// Indices of the vertices of a grid line along a direction.
    pub fn line(&self, direction: usize, k: usize) -> Vec<usize> {
        (0..self.size()[direction]).map(|i| if direction == 0 { self.index(i, k) } else { self.index(k, i) }).collect()
    }

    /// Indices of the corners of the quads between a grid line along a direction and the next one.
    pub fn strip(&self, direction: usize, k: usize) -> Vec<[usize; 4]> {
        let quad = |i: usize| if direction == 0 { self.corners(i, k) } else { self.corners(k, i) };
        (0..self.quads()[direction]).map(quad).collect()
    }
}
