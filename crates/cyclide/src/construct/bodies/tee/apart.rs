//! Branches that run into each other: the faces of both, blends, walls and ends, are proved apart by the boxes of their control points, in parts
//! as small as it takes.
//!
//! What two branches add to the main pipe meets only if its faces do: neither holds the other, as their holes in the main pipe are apart.

use super::arrangement::are_halves;
use super::canal::Canal;
use super::{PipeTee, Placed};
use crate::base::bounds::Aabb;
use crate::base::box_tree::BoxTree;
use crate::base::segments::nearest_of_segments;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Result, TeeError};
use crate::rational::{Polynomial, PolynomialRow, RationalBezierSurface};

/// Pairs of parts that are looked at before two branches are given up as too near to tell.
const MOST_PAIRS: usize = 4_000_000;

/// Boxes are grown by this part of the distance more than half of it: sums are rounded.
const ROUNDING: f64 = 1e-9;

/// A part of a face.
struct Part {
    surface: RationalBezierSurface,
    hull: Aabb,
    /// Whether it is of the wall.
    of_wall: bool,
}

impl Part {
    fn new(surface: RationalBezierSurface, of_wall: bool) -> Self {
        let hull = surface.hull_box();
        Self { surface, hull, of_wall }
    }

    /// Its halves across its longer way.
    fn halves(&self) -> [Self; 2] {
        let [a, b, c, d] = self.surface.corners();
        let along_s = a.distance(b).max(c.distance(d)).max(self.surface.point(0.5, 0.5).distance(a));
        let along_t = a.distance(c).max(b.distance(d));
        let all = [0.0, 1.0];
        [[0.0, 0.5], [0.5, 1.0]].map(|half| {
            let part = if along_s >= along_t { self.surface.part(half, all) } else { self.surface.part(all, half) };
            Self::new(part, self.of_wall)
        })
    }
}

/// The distance of two boxes.
fn gap(a: &Aabb, b: &Aabb) -> f64 {
    let along = |a: [f64; 2], b: [f64; 2]| (a[0] - b[1]).max(b[0] - a[1]).max(0.0);
    Vec3::new(
        along([a.min.x, a.max.x], [b.min.x, b.max.x]),
        along([a.min.y, a.max.y], [b.min.y, b.max.y]),
        along([a.min.z, a.max.z], [b.min.z, b.max.z]),
    )
    .length()
}

/// A branch outside the main pipe.
struct Outside {
    parts: Vec<Part>,
    /// The box of all of them.
    hull: Aabb,
    /// Their boxes, of which those of parts that are near enough meet.
    tree: BoxTree,
    /// The axis where it has walls, and the largest radius there.
    spine: [Point3; 2],
    radius: f64,
}

impl Outside {
    fn new(placed: &Placed, needed: f64) -> Result<Self> {
        let parts = parts(placed)?;
        let grown: Vec<Aabb> = parts.iter().map(|part| part.hull.grown((0.5 + ROUNDING) * needed)).collect();
        let whole = parts.iter().map(|part| part.hull).reduce(Aabb::union);
        let (spine, radius) = spine(placed);
        Ok(Self {
            hull: whole.unwrap_or(Aabb { min: spine[0], max: spine[0] }),
            parts,
            tree: BoxTree::new(&grown),
            spine,
            radius,
        })
    }
}

/// The faces of a branch outside the main pipe.
fn parts(placed: &Placed) -> Result<Vec<Part>> {
    let mut parts = Vec::new();
    for piece in &placed.partition.pieces {
        let canal = Canal::new(&placed.crossing, piece, 0.0);
        parts.push(Part::new(canal.surface()?, false));
        let ring = canal.beside_branch(placed.length);
        let axis = placed.end();
        let middle = PolynomialRow([axis.x, axis.y, axis.z, 1.0].map(|c| ring.weight() * c));
        parts.push(Part::new(RationalBezierSurface::from_polynomial_rows(&[canal.on_branch(), ring.clone()])?, true));
        parts.push(Part::new(RationalBezierSurface::from_polynomial_rows(&[ring, middle])?, false));
    }
    Ok(parts)
}

/// The axis of a branch where it has walls, and the largest radius there.
fn spine(placed: &Placed) -> ([Point3; 2], f64) {
    let crossing = &placed.crossing;
    let lowest = |piece| {
        let canal = Canal::new(crossing, piece, 0.0);
        let (height, weight): (Polynomial, _) = (canal.height(), &canal.forms.weight);
        let quotients = height.coefficients().iter().zip(weight.coefficients()).map(|(h, w)| h / w);
        quotients.fold(f64::INFINITY, f64::min)
    };
    let low = placed.partition.pieces.iter().map(lowest).fold(f64::INFINITY, f64::min);
    let radius = [low, placed.length].map(|height| crossing.branch_radius(0.0, height));
    ([crossing.foot + crossing.axes[2] * low, placed.end()], radius[0].max(radius[1]))
}

/// Whether all faces of two branches are proved to be farther apart than a distance; if not, where two small parts are that are not.
fn nearer_than(needed: f64, [first, second]: [&Outside; 2]) -> Option<Point3> {
    if gap(&first.hull, &second.hull) > needed {
        return None;
    }
    let (spines, _) = nearest_of_segments([first.spine, second.spine]);
    let walls_apart = spines > first.radius + second.radius + needed;
    let near = |a: &Part, b: &Part| gap(&a.hull, &b.hull) <= needed && !(walls_apart && a.of_wall && b.of_wall);
    let mut looked_at = 0;
    first.tree.find_between(&second.tree, |i, j| {
        let (a, b) = (&first.parts[i], &second.parts[j]);
        if !near(a, b) {
            return None;
        }
        let mut waiting = vec![(a.halves(), b.halves())];
        while let Some((a, b)) = waiting.pop() {
            for a in &a {
                for b in b.iter().filter(|b| near(a, b)) {
                    looked_at += 1;
                    let sizes = [a, b].map(|part| part.hull.diagonal());
                    if sizes[0] + sizes[1] <= needed || looked_at > MOST_PAIRS {
                        let [a, b] = [a, b].map(|part| part.hull.min.midpoint(part.hull.max));
                        return Some(a.midpoint(b));
                    }
                    waiting.push((a.halves(), b.halves()));
                }
            }
        }
        None
    })
}

impl PipeTee {
    /// Refuses branches that run into each other, blends included, or come nearer than a distance.
    ///
    /// # Errors
    /// `tee-branches-meet`.
    pub(super) fn check_apart(placed: &[Placed], needed: f64) -> Result<()> {
        let outside = placed.iter().map(|placed| Outside::new(placed, needed)).collect::<Result<Vec<_>>>()?;
        for second in 1..placed.len() {
            for first in 0..second {
                if are_halves(&placed[first], &placed[second]) {
                    continue;
                }
                if let Some(point) = nearer_than(needed, [&outside[first], &outside[second]]) {
                    let [first, second] = [first, second].map(|k| placed[k].crossing.branch);
                    let (first, second) = (first.min(second), first.max(second));
                    let point = point.to_array();
                    return Err(TeeError::BranchesTooNear { first, second, point, needed }.into());
                }
            }
        }
        Ok(())
    }
}
