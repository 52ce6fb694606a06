//! Planes of DXF entities: the object coordinate system that belongs to an extrusion direction.

use cyclide::{Point3, Vec3, curve::Arc};

/// Points this close to a plane, relative to the model's size, lie in it: rounding of the construction.
const PLANE_LIMIT: f64 = 1e-12;

/// Below this the extrusion is so close to the third axis that the second one spans the plane (AutoCAD's arbitrary
/// axis algorithm).
const NEAR_Z: f64 = 1.0 / 64.0;

/// The axes of an object coordinate system; its origin is the world's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ocs {
    pub(super) x: Vec3,
    pub(super) y: Vec3,
    /// The extrusion direction, unit.
    pub(super) z: Vec3,
}

impl Ocs {
    /// The axes that every DXF reader derives from a unit extrusion direction.
    pub(super) fn new(z: Vec3) -> Self {
        let helper = if z.x.abs() < NEAR_Z && z.y.abs() < NEAR_Z { Vec3::Y } else { Vec3::Z };
        let x = helper.cross(z).unit().unwrap_or(Vec3::X);
        Self { x, y: z.cross(x), z }
    }

    pub(super) fn to_local(self, p: Point3) -> Point3 {
        let v = p.to_vec();
        Point3::new(v.dot(self.x), v.dot(self.y), v.dot(self.z))
    }

    pub(super) fn to_world(self, p: Point3) -> Point3 {
        Point3::ORIGIN + (self.x * p.x + self.y * p.y + self.z * p.z)
    }
}

/// The plane of some arcs, if they lie in one and it is theirs alone (a straight line in space has none); planes of
/// constant height look up. `size` is the model's diagonal.
pub(super) fn plane_of(arcs: &[Arc], size: f64) -> Option<Ocs> {
    let points: Vec<Point3> = arcs.iter().flat_map(|a| [a.start(), a.midpoint(), a.end()]).collect();
    let first = *points.first()?;
    let limit = PLANE_LIMIT * size;
    let fits = |n: Vec3| points.iter().all(|p| (*p - first).dot(n).abs() <= limit);
    if fits(Vec3::Z) {
        return Some(Ocs::new(Vec3::Z));
    }
    let farthest = |measure: &dyn Fn(Point3) -> f64| {
        points.iter().copied().max_by(|a, b| measure(*a).total_cmp(&measure(*b))).unwrap_or(first)
    };
    let across = farthest(&|p| p.distance(first)) - first;
    let third = farthest(&|p| (p - first).cross(across).length()) - first;
    let along = across.unit()?;
    let normal = along.cross(third);
    // A sliver of points: every plane through the line would do as well.
    if normal.length() <= limit {
        return None;
    }
    // Of a narrow figure the product has its rounding along the figure too, where it would lift the far end off the plane.
    let n = normal.unit()?;
    let n = (n - along * n.dot(along)).unit()?;
    let up = if n.z.abs() > 1e-9 {
        n.z
    } else if n.y.abs() > 1e-9 {
        n.y
    } else {
        n.x
    };
    let n = if up < 0.0 { -n } else { n };
    fits(n).then(|| Ocs::new(n))
}
