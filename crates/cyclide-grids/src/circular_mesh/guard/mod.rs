//! Whether a grid made circular is still the surface that was given (`docs/math/circular-meshes.md#guard`).
//!
//! Distances do not tell: they are as large for a hypar pressed flat as for a good steep saddle whose border slid. What
//! tells is how the normals stand, over strides of a fifth of the grid so that noise of a few hundredths of an edge
//! does not count ([`stride`]), and how much of the relief is left around each vertex ([`relief`]).
//!
//! Known limits: ripples of two and of about four quads; a relief without mean curvature (`x y` on a dome) is left to
//! the turn of the normals; below a turn of one degree nothing is refused, whatever part of a shallow relief is lost.

mod noise;
mod relief;
mod stride;

use super::curvature::{Curvature, angle_to};
use super::input_surface::{Foot, foot, normals};
use super::neighbors::{pair, vertices};
use cyclide::ShapeChange;
use cyclide::surface::QuadGrid;
use cyclide::workspace::singular_values;
use cyclide::{Point3, Vec3};
use noise::is_noise;
use relief::lost_relief;
use stride::{bending, coarse, lowered, spread};

/// A surface thinner than this part of its size, or with normals within this angle (radians), is flat.
const FLAT: f64 = 1e-6;
/// A moved vertex is beyond the border if its foot is on the border and the cosine between the way there and the
/// normal is below this.
const BEYOND: f64 = 0.9;
/// Stride for the directions of the curvature lines: smooth enough for noise, local enough for the lines.
const LINES: usize = 2;
/// Normals that spread by less than this (radians) have no lines worth following.
const SPREAD: f64 = 0.0175;
/// Mean relative difference of the principal curvatures below which the surface is nearly spherical: any lines will do.
const UMBILIC: f64 = 0.2;

/// The points of a grid before and after, in units near the edge, and the median edge in them.
pub(super) struct Guard<'a> {
    pub(super) grid: &'a QuadGrid,
    pub(super) before: &'a [Point3],
    pub(super) after: &'a [Point3],
    pub(super) edge: f64,
}

/// Each moved vertex on the input: its foot; `None` for vertices beyond the border of the input, and for those of no quad.
type Feet = Vec<Option<Foot>>;

impl Guard<'_> {
    /// The numbers; `None` if the input is flat.
    pub(super) fn shape_change(&self) -> Option<ShapeChange> {
        let (grid, stride) = (self.grid, coarse(self.grid));
        let [before, after] = [self.before, self.after].map(|points| {
            let unit = normals(points, grid, stride).into_iter().map(Option::unwrap_or_default);
            unit.collect::<Vec<Vec3>>()
        });
        let used = grid.used_vertices();
        let of_quads = |points: &[Point3]| -> Vec<Point3> {
            points.iter().zip(&used).filter(|(_, used)| **used).map(|(p, _)| *p).collect()
        };
        let [thin, thinner] = [self.before, self.after].map(|points| thickness(&of_quads(points)));
        let (size, spread) = (extent(&of_quads(self.before)), spread(grid, &before));
        if !(thin > FLAT * size && spread > FLAT) {
            return None;
        }
        let feet = self.feet(&before, &used);
        let turn = turn(&feet, &before, &after);
        let bent = bending(grid, &before, stride);
        let noise = is_noise(grid, self.before, &before, stride);
        let lines = lines(grid, self.before).filter(|_| !noise);
        let mut change = ShapeChange::default();
        change.bending = (bent > 0.0).then(|| bending(grid, &after, stride) / bent);
        change.thickness = Some(thinner / thin);
        change.normal_turn = Some(turn / spread);
        change.turn = turn;
        change.lost_relief = lost_relief(self, &feet);
        change.across = lines.map(|lines| lines.across);
        change.clear_lines = lines.is_some_and(|lines| lines.clear);
        change.noise = noise;
        change.closed = grid.closed() != [false; 2];
        Some(change)
    }

    fn feet(&self, normals: &[Vec3], used: &[bool]) -> Feet {
        let within = |(v, p): (usize, &Point3)| {
            if !used[v] {
                return None;
            }
            let foot = foot(*p, v, self.before, self.grid)?;
            let away = *p - foot.point(self.before);
            let normal = foot.vector(normals).unit()?;
            let beyond = foot.is_on_border(self.grid) && away.dot(normal).abs() < BEYOND * away.length();
            (!beyond).then_some(foot)
        };
        self.after.iter().enumerate().map(within).collect()
    }
}

/// The numbers of a whole mesh of several grids, by the normals at its vertices: what each grid is too flat for, as the faces of a box, and the
/// angles between them. `None` if it is flat.
pub(super) fn whole_change(points: [&[Point3]; 2], normals: [&[Option<Vec3>]; 2]) -> Option<ShapeChange> {
    let both = normals[0].iter().zip(normals[1]).enumerate();
    let known: Vec<(usize, Vec3, Vec3)> = both.filter_map(|(v, (a, b))| Some((v, (*a)?, (*b)?))).collect();
    let count = known.len().max(1) as f64;
    let mean = known.iter().fold(Vec3::ZERO, |sum, (_, normal, _)| sum + *normal) / count;
    let rms = |squares: f64| (squares / count).sqrt();
    let spread = rms(known.iter().map(|(_, normal, _)| (*normal - mean).length_squared()).sum());
    let [thin, thinner] = points.map(|points| thickness(&known.iter().map(|(v, ..)| points[*v]).collect::<Vec<_>>()));
    let size = extent(&known.iter().map(|(v, ..)| points[0][*v]).collect::<Vec<_>>());
    if !(thin > FLAT * size && spread > FLAT) {
        return None;
    }
    let turn = rms(known.iter().map(|(_, before, after)| before.angle(*after).powi(2)).sum());
    let mut change = ShapeChange::default();
    change.thickness = Some(thinner / thin);
    change.normal_turn = Some(turn / spread);
    change.turn = turn;
    Some(change)
}

/// Root mean square of the angles between the new normals and those of the input at the feet.
fn turn(feet: &Feet, before: &[Vec3], after: &[Vec3]) -> f64 {
    let (mut squares, mut count) = (0.0, 0usize);
    for (foot, normal) in feet.iter().zip(after) {
        if let Some(foot) = foot {
            squares += foot.vector(before).angle(*normal).powi(2);
            count += 1;
        }
    }
    if count == 0 { 0.0 } else { (squares / count as f64).sqrt() }
}

/// How a grid runs to the curvature lines of its surface.
#[derive(Clone, Copy)]
struct Lines {
    /// The mean angle to them, each vertex weighted by the difference of its principal curvatures.
    across: f64,
    /// False for surfaces that are nearly spherical on the whole.
    clear: bool,
}

/// `None` for surfaces that are nearly flat on the whole.
fn lines(grid: &QuadGrid, points: &[Point3]) -> Option<Lines> {
    let stride = lowered(grid, LINES);
    let unit: Vec<Vec3> = normals(points, grid, stride).into_iter().map(Option::unwrap_or_default).collect();
    let (mut angles, mut weights, mut curvatures) = (0.0, 0.0, 0.0);
    for at in vertices(grid) {
        let Some(curvature) = Curvature::at(points, grid, at, stride, 1.0) else { continue };
        let half = curvature.half_difference();
        curvatures += curvature.mean().abs() + half;
        let Some(lines) = curvature.directions() else { continue };
        for (direction, stride) in stride.into_iter().enumerate() {
            let [before, after] = pair(grid, at, direction, stride);
            angles += 0.5 * half * angle_to(points[after] - points[before], lines);
        }
        weights += half;
    }
    let bends = spread(grid, &unit) > SPREAD && weights > 0.0;
    bends.then(|| Lines { across: angles / weights, clear: weights > UMBILIC * curvatures })
}

/// The least standard deviation of the points in any direction: the root of the smallest eigenvalue of their
/// covariance.
fn thickness(points: &[Point3]) -> f64 {
    let share = 1.0 / points.len() as f64;
    let mean = points.iter().fold(Vec3::ZERO, |sum, p| sum + p.to_vec() * share);
    let mut columns = [Vec3::ZERO; 3];
    for d in points.iter().map(|p| p.to_vec() - mean) {
        for (k, column) in columns.iter_mut().enumerate() {
            *column += d * (d[k] * share);
        }
    }
    singular_values(columns)[2].sqrt()
}

/// Size of the points' bounds.
fn extent(points: &[Point3]) -> f64 {
    cyclide::Aabb::of_points(points.iter().copied()).map_or(0.0, |bounds| bounds.diagonal())
}
