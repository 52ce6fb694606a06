//! Which way the polygons of a cell and their normals look, against `f_s × f_t` of the patch and the sense of its face.

use cyclide::{
    Point3, Vec3,
    mesh::MeshSource,
    surface::ParamSurface as _,
    topology::{FaceGeometry as _, FaceSurface, ShellFace},
};

/// Normals of faces that meet within 1e-6 radians are one in the mesh; the rest is their rounding to single precision.
pub(super) const NORMAL_LIMIT: f64 = 1.2e-6;
/// Rounding of the points of a patch, in units of the largest coordinate of its corners.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// A triangle may be turned over if its height is at most this many times what its corners were moved by: two of
/// them to one side, the third to the other, and as much for the direction of its base.
const HEIGHTS: f64 = 4.0;
/// A corner of a triangle is that of the cell which is so many times nearer than the others.
const NEARER: f64 = 4.0;

/// A cell of a face, seen from the outer side.
pub(super) struct Facing<'a> {
    surface: &'a FaceSurface,
    /// Parameters of the corners, counter-clockwise in (s, t), and their points.
    parameters: [(f64, f64); 4],
    corners: [Point3; 4],
    /// Vector area of the corners on the outer side, of any length; that of `f_s × f_t`, in the mean over the cell.
    area: Vec3,
    /// True if the outer side is that of `f_s × f_t`.
    same_sense: bool,
    /// Sign of the patch's own normal on the outer side. It does not change within a cell.
    sign: f64,
    /// Rounding of the points.
    rounding: f64,
}

impl<'a> Facing<'a> {
    pub(super) fn new(face: &'a ShellFace, source: &MeshSource) -> Self {
        let ([s0, s1], [t0, t1], surface) = (source.s, source.t, &face.surface);
        let parameters = [(s0, t0), (s1, t0), (s1, t1), (s0, t1)];
        let corners = parameters.map(|(s, t)| surface.point(s, t));
        let outer = face.outer_sign();
        let diagonals = [corners[2] - corners[0], corners[3] - corners[1]];
        let [u, v] = diagonals.map(|d| d.unit().unwrap_or_default());
        let middle = (0.5 * (s0 + s1), 0.5 * (t0 + t1));
        let rounding = ROUNDING * surface.corners().iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let sign = outer * surface.side_of_normal(middle.0, middle.1);
        Self { surface, parameters, corners, area: u.cross(v) * outer, same_sense: face.same_sense, sign, rounding }
    }

    /// True if a triangle looks to the outer side, or is too flat for the places of its corners to tell.
    pub(super) fn is_outward(&self, triangle: &[Point3; 3]) -> bool {
        if let Some(outward) = self.by_corners(triangle) {
            return outward;
        }
        let (normal, longest) = area_vector(triangle);
        if normal.dot(self.area) > 0.0 {
            return true;
        }
        let moved = triangle.iter().map(|p| self.to_corner(*p)).fold(0.0, f64::max) + self.rounding;
        normal.length() * longest <= HEIGHTS * moved
    }

    /// Whether the corners of a triangle follow each other round the cell as its outer side asks for; `None` if one of
    /// them is not much nearer to one corner of the cell than to the others. Where a patch folds within a cell, near a
    /// side that is nearly a point, the directions of its triangles say nothing.
    fn by_corners(&self, triangle: &[Point3; 3]) -> Option<bool> {
        let mut at = [0; 3];
        for (at, p) in at.iter_mut().zip(triangle) {
            let distances = self.corners.map(|q| q.distance(*p));
            let (nearest, distance) = distances.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
            let clear = NEARER * distance + self.rounding;
            if !(0..4).all(|k| k == nearest || distances[k] > clear) {
                return None;
            }
            *at = nearest;
        }
        let [second, third] = [at[1], at[2]].map(|k| (k + 4 - at[0]) % 4);
        let distinct = second != 0 && third != 0 && second != third;
        distinct.then_some((second < third) == self.same_sense)
    }

    /// Distance of a point from the nearest corner.
    fn to_corner(&self, p: Point3) -> f64 {
        self.corners.iter().map(|q| q.distance(p)).fold(f64::INFINITY, f64::min)
    }

    /// How far a normal is off that of the surface at a corner, whose point was moved by `moved` at most. Where corners
    /// are one, at the point to which a parameter line shrinks, the normal is that in the middle between them.
    pub(super) fn normal_error(&self, p: Point3, normal: Vec3, moved: f64) -> f64 {
        let reach = self.to_corner(p) + 2.0 * moved + self.rounding;
        let near = |k: &usize| self.corners[*k].distance(p) <= reach;
        let error = |k: usize, l: usize| {
            let ((s0, t0), (s1, t1)) = (self.parameters[k], self.parameters[l]);
            let own = self.surface.unit_normal(0.5 * (s0 + s1), 0.5 * (t0 + t1)) * self.sign;
            (normal - own).length()
        };
        let pairs = (0..4).filter(near).flat_map(|k| (k..4).filter(near).map(move |l| (k, l)));
        pairs.map(|(k, l)| error(k, l)).fold(f64::INFINITY, f64::min)
    }
}

/// How far a normal is off that of a triangle; 0 for a triangle on a line, which has none.
pub(super) fn facet_error(triangle: &[Point3; 3], normal: Vec3) -> f64 {
    let (area, _) = area_vector(triangle);
    // The direction of a sliver's normal is known to the rounding of its area only.
    let rounding = f64::EPSILON / area.length();
    match area.unit() {
        Some(own) if rounding < NORMAL_LIMIT => (normal - own).length() - rounding,
        _ => 0.0,
    }
}

/// Twice the vector area of a triangle in units of its longest side, which is the second value.
fn area_vector(&[a, b, c]: &[Point3; 3]) -> (Vec3, f64) {
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    if longest > 0.0 { (((b - a) / longest).cross((c - a) / longest), longest) } else { (Vec3::default(), 0.0) }
}
