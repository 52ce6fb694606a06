//! The distance between the triangles of a file and the parts of a surface over triangles that they stand for, both ways, and which
//! way they look.
//!
//! The plan says which triangle of the surface a cell belongs to, and its barycentric coordinates: each corner of the file has its own place,
//! so nothing is searched. Corners are held against their places; from the middles of the sides, the center and three places between the distance goes both
//! ways, from the file's triangle to the surface with a few steps to the foot. Where lines of the surface bend within it, its places lie over
//! triangles next to their own: those that are far from their own are held against the nearest of all.

use super::facing::{NORMAL_LIMIT, facet_error};
use super::matching::larger;
use super::nearest::NearestTriangle;
use super::polygon::{MeshForm, Normals, Polygon};
use super::triangle::Triangle;
use crate::check::read_error::ReadError;
use crate::export::mesh_plan::{BodyPlan, Cell};
use crate::export::parts::BodyOf;
use crate::export::triangle_cells::{Part, TriangleCell};
use cyclide::{
    Point3, Vec3,
    surface::{TrianglePatch, TriangleSurface},
};

/// Steps to the foot of a point.
const STEPS: usize = 6;
/// Places of a triangle beside its corners, in sixths: middles of sides, the center, and between it and the corners.
const PLACES: [[f64; 3]; 7] = [
    [3.0, 3.0, 0.0],
    [0.0, 3.0, 3.0],
    [3.0, 0.0, 3.0],
    [2.0, 2.0, 2.0],
    [4.0, 1.0, 1.0],
    [1.0, 4.0, 1.0],
    [1.0, 1.0, 4.0],
];

/// Corners may be off their places by a little more than rounding has moved them, and by that of the arithmetic.
const MOVED: f64 = 1.01;
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Sides of cells on free sides of the surface.
pub(super) fn free_sides(surface: &TriangleSurface, cells: &[Cell]) -> usize {
    cells.first().map_or(0, |cell| TriangleCell::of(&cell.source).divisions) * surface.free_sides()
}

/// The largest distance between the polygons of one surface and its cells.
///
/// # Errors
/// [`ReadError::WrongSide`], [`ReadError::Vertex`], [`ReadError::Normal`]; [`ReadError::Geometry`] where the surface cannot be evaluated.
pub(super) fn deviation(
    form: MeshForm,
    body: &BodyOf<'_>,
    surface: &TriangleSurface,
    cells: &[Cell],
    polygons: &[Polygon<'_>],
    plan: &BodyPlan,
) -> Result<f64, ReadError> {
    let (mut rest, mut largest, mut check) = (polygons, 0.0_f64, None::<Check<'_>>);
    let mut all = AllTriangles { polygons, nearest: None };
    // Places of parts that have no polygon: rounding has made lines of them.
    let mut lost: Vec<Point3> = Vec::new();
    for cell in cells {
        let (own, after) = rest.split_at(cell.polygons);
        rest = after;
        let at = TriangleCell::of(&cell.source);
        if check.as_ref().is_none_or(|check| check.face != cell.source.face) {
            let Some(patch) = surface.patch(cell.source.face) else { continue };
            check = Some(Check::new(form, body, (cell.source.face, patch), at.divisions, plan.moved)?);
        }
        let Some(check) = &check else { continue };
        let mut parts: Vec<Part> = at.parts().collect();
        if let ([only], [_, _]) = (own, parts.as_slice()) {
            let k = check.nearer(only, &parts);
            largest = check.deviation(only, &parts.remove(k), &mut all, largest)?;
        } else if own.len() == parts.len() {
            for (polygon, part) in own.iter().zip(parts.drain(..)) {
                largest = check.deviation(polygon, &part, &mut all, largest)?;
            }
        } else if !own.is_empty() {
            return Err(ReadError::NotCovered { object: body.label(), face: cell.source.face });
        }
        for part in parts {
            for weights in PLACES {
                lost.push(check.point(place(&part, weights))?);
            }
        }
    }
    for p in lost {
        largest = larger(largest, all.distance(p, largest));
    }
    Ok(largest)
}

/// The polygons of the surface in a file.
struct AllTriangles<'a> {
    polygons: &'a [Polygon<'a>],
    /// Made when it is needed.
    nearest: Option<NearestTriangle>,
}

impl AllTriangles<'_> {
    /// Distance of a point from the nearest, or what is `enough` at most.
    fn distance(&mut self, p: Point3, enough: f64) -> f64 {
        let made = || NearestTriangle::new(self.polygons.iter().flat_map(Polygon::triangles).collect());
        self.nearest.get_or_insert_with(made).distance(p, enough)
    }
}

/// One triangle of the surface that polygons are held against.
struct Check<'a> {
    form: MeshForm,
    body: &'a BodyOf<'a>,
    face: usize,
    patch: TrianglePatch,
    /// Points and normals at the corners of all parts, row by row.
    corners: Vec<(Point3, Vec3)>,
    divisions: usize,
    /// How far rounding has moved a vertex at most.
    moved: f64,
}

impl<'a> Check<'a> {
    fn new(
        form: MeshForm,
        body: &'a BodyOf<'a>,
        (face, patch): (usize, TrianglePatch),
        divisions: usize,
        moved: f64,
    ) -> Result<Self, ReadError> {
        let n = divisions;
        let places = (0..=n).flat_map(|i| (0..=n - i).map(move |j| [i, j, n - i - j].map(|v| v as f64)));
        let failed = |source| ReadError::Geometry { place: format!("triangle {face}"), source };
        let corners = places.map(|at| patch.point_and_normal(at).map_err(failed)).collect::<Result<_, _>>()?;
        Ok(Self { form, body, face, patch, corners, divisions, moved })
    }

    /// Point and normal at a corner of a part.
    fn corner(&self, at: [f64; 3]) -> (Point3, Vec3) {
        let [i, j, _] = at.map(|v| v as usize);
        self.corners[i * (self.divisions + 1) - (i * i - i) / 2 + j]
    }

    fn point(&self, at: [f64; 3]) -> Result<Point3, ReadError> {
        let failed = |source| ReadError::Geometry { place: format!("triangle {}", self.face), source };
        self.patch.point(at).map_err(failed)
    }

    /// The part whose corners are nearer to those of a polygon.
    fn nearer(&self, polygon: &Polygon<'_>, parts: &[Part]) -> usize {
        let mut best = (0, f64::INFINITY);
        for (k, part) in parts.iter().enumerate() {
            let mut sum = 0.0;
            for (at, p) in part.iter().zip(polygon.corners()) {
                sum += self.corner(*at).0.distance(p);
            }
            if sum < best.1 {
                best = (k, sum);
            }
        }
        best.0
    }

    /// The largest of a distance that is known and those between a polygon and its part.
    fn deviation(
        &self,
        polygon: &Polygon<'_>,
        part: &Part,
        all: &mut AllTriangles<'_>,
        mut largest: f64,
    ) -> Result<f64, ReadError> {
        let (object, face) = (self.body.label(), self.face);
        let corners: Vec<Point3> = polygon.corners().collect();
        let Some(corners) = corners.first_chunk::<3>().filter(|_| corners.len() == 3) else {
            return Err(ReadError::NotCovered { object, face });
        };
        let places = part.map(|at| self.corner(at).0);
        let own_place = MOVED * self.moved + ROUNDING * self.body.body.bounds().max_abs();
        for (k, p) in corners.iter().enumerate() {
            let off = places[k].distance(*p);
            // Nearer to the place of another corner: the triangle is turned over, or another one.
            if off > own_place && places.iter().any(|place| place.distance(*p) < off) {
                return Err(ReadError::WrongSide { object, face });
            }
            if !(off <= own_place) {
                return Err(ReadError::Vertex { object, face, off, limit: own_place });
            }
            largest = larger(largest, off);
        }
        let triangle = Triangle::new(*corners);
        for weights in PLACES {
            let at = place(part, weights);
            let on_surface = self.point(at)?;
            let own = triangle.distance(on_surface);
            largest = larger(largest, if own <= largest { own } else { all.distance(on_surface, largest) });
            let sum = (0..3).fold(Vec3::ZERO, |sum, k| sum + (corners[k] - corners[0]) * (weights[k] / 6.0));
            let to_surface = self.to_surface(corners[0] + sum, (at, on_surface), (part, corners), largest)?;
            largest = larger(largest, to_surface);
        }
        let off = self.normal_error(polygon, part, corners);
        if !(off <= NORMAL_LIMIT) {
            return Err(ReadError::Normal { object, face, off, limit: NORMAL_LIMIT });
        }
        Ok(largest)
    }

    /// Distance of a point of a triangle from the surface; what is `enough` is not made smaller. From the place with the same
    /// coordinates, what is left to go is taken apart in the sides of the triangle, which are the derivatives but for the bend.
    fn to_surface(
        &self,
        p: Point3,
        (mut at, mut on_surface): ([f64; 3], Point3),
        (part, corners): (&Part, &[Point3; 3]),
        enough: f64,
    ) -> Result<f64, ReadError> {
        let mut best = on_surface.distance(p);
        let [a, b] = [corners[0] - corners[2], corners[1] - corners[2]];
        let (aa, ab, bb) = (a.length_squared(), a.dot(b), b.length_squared());
        let area = aa * bb - ab * ab;
        for _ in 0..STEPS {
            if best <= enough {
                break;
            }
            let left = p - on_surface;
            let (ta, tb) = (left.dot(a), left.dot(b));
            let [u, v] = [(bb * ta - ab * tb) / area, (aa * tb - ab * ta) / area].map(|x| 6.0 * x);
            // Also NaN, of a triangle without area.
            if !(u.is_finite() && v.is_finite()) {
                break;
            }
            at = [0, 1, 2].map(|c| (at[c] + u * (part[0][c] - part[2][c]) + v * (part[1][c] - part[2][c])).max(0.0));
            on_surface = self.point(at)?;
            best = best.min(on_surface.distance(p));
        }
        Ok(best)
    }

    /// How far the normals of a polygon are off: in STL that of the triangle, elsewhere those of the surface at the corners.
    fn normal_error(&self, polygon: &Polygon<'_>, part: &Part, corners: &[Point3; 3]) -> f64 {
        if self.form.normals == Normals::None {
            return 0.0;
        }
        let mut normals = polygon.normals();
        if self.form.normals == Normals::OfTriangles {
            return normals.next().map_or(f64::NAN, |facet| facet_error(corners, facet));
        }
        part.iter().zip(normals).map(|(at, normal)| (normal - self.corner(*at).1).length()).fold(0.0, larger)
    }
}

/// The coordinates of a place of a part, in sixths of its own.
fn place(part: &Part, weights: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|c| (0..3).map(|k| weights[k] * part[k][c]).sum())
}
