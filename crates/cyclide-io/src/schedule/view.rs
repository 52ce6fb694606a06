//! Directions from which drawings look, and arcs as they are seen: true to the projection within a tolerance.

use cyclide::{
    Point3, Result, Vec3,
    curve::{Arc, ArcPath, DEFAULT_PIECE_ANGLE},
    model::Lower as _,
    rational::NurbsCurve,
};

/// An arc whose plane is seen within this angle of face on is drawn as the arc it is, and one seen within it of edge on as a
/// segment: both are below the rounding of the drawing.
const FACING: f64 = 1e-9;

/// A direction of view, with what is right and up in the drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    pub(super) name: &'static str,
    right: Vec3,
    up: Vec3,
    /// Toward the viewer.
    pub(super) toward: Vec3,
}

impl View {
    pub(super) const PLAN: Self = Self { name: "plan", right: Vec3::X, up: Vec3::Y, toward: Vec3::Z };

    /// Plan and elevations; what faces none of the first five is drawn as it is seen from below.
    pub(super) const ALL: [Self; 6] = [
        Self::PLAN,
        Self { name: "front", right: Vec3::X, up: Vec3::Z, toward: Vec3::new(0.0, -1.0, 0.0) },
        Self { name: "right", right: Vec3::Y, up: Vec3::Z, toward: Vec3::X },
        Self { name: "back", right: Vec3::new(-1.0, 0.0, 0.0), up: Vec3::Z, toward: Vec3::Y },
        Self { name: "left", right: Vec3::new(0.0, -1.0, 0.0), up: Vec3::Z, toward: Vec3::new(-1.0, 0.0, 0.0) },
        Self { name: "below", right: Vec3::X, up: Vec3::new(0.0, -1.0, 0.0), toward: Vec3::new(0.0, 0.0, -1.0) },
    ];

    /// Where a point is seen.
    pub(super) fn point(&self, p: Point3) -> Point3 {
        let v = p.to_vec();
        Point3::new(v.dot(self.right), v.dot(self.up), 0.0)
    }

    /// An arc as it is seen, in arcs within a tolerance; `None` for one that is seen as a point.
    pub(super) fn arc(&self, arc: &Arc, tolerance: f64) -> Result<Option<ArcPath>> {
        let (start, end) = (self.point(arc.start()), self.point(arc.end()));
        if start.distance(end) <= FACING * arc.length() {
            return Ok(None);
        }
        let Some(axis) = arc.normal().filter(|_| arc.angle() > FACING) else {
            return ArcPath::new(vec![Arc::segment(start, end)?], false).map(Some);
        };
        let facing = axis.dot(self.toward);
        if axis.cross(self.toward).length() <= FACING {
            let seen = Arc::from_bulge(start, end, Vec3::Z, (0.25 * arc.angle()).tan().copysign(facing))?;
            return ArcPath::new(vec![seen], false).map(Some);
        }
        if facing.abs() <= FACING {
            return ArcPath::new(vec![Arc::segment(start, end)?], false).map(Some);
        }
        let exact = arc.to_nurbs(DEFAULT_PIECE_ANGLE)?;
        let points = exact.control_points().iter().map(|p| self.point(*p)).collect();
        let seen = NurbsCurve::new(exact.degree(), exact.knots().to_vec(), points, exact.weights().to_vec())?;
        seen.to_arcs(tolerance).map(|(path, _)| Some(path))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arcs_are_seen_as_they_are() {
        let arc =
            Arc::from_three_points(Point3::new(1.0, 0.0, 0.0), Point3::new(0.4, 1.0, 0.8), Point3::new(-1.0, 0.3, 2.0))
                .unwrap();
        for view in View::ALL {
            assert!(view.right.cross(view.up) == view.toward, "{} is right-handed", view.name);
            let path = view.arc(&arc, 1e-4).unwrap().unwrap();
            for k in 0..=50 {
                let p = view.point(arc.point_at_length(f64::from(k) / 50.0));
                let near = path.arcs().iter().map(|a| a.closest_point(p).distance).fold(f64::INFINITY, f64::min);
                assert!(near <= 1e-4, "{} {near}", view.name);
            }
        }
        let flat = Arc::from_center(Point3::ORIGIN, Vec3::Z, Point3::new(2.0, 0.0, 0.0), 1.0).unwrap();
        for (k, view) in View::ALL.into_iter().enumerate() {
            let path = view.arc(&flat, 1e-4).unwrap().unwrap();
            assert_eq!(path.arcs().len(), 1);
            let turned = path.arcs()[0].curvature_binormal().z;
            let want = match k {
                0 => 0.5,
                5 => -0.5,
                _ => 0.0,
            };
            assert!((turned - want).abs() < 1e-12, "{}: {turned}", view.name);
        }
        let upright = Arc::segment(Point3::ORIGIN, Point3::new(0.0, 0.0, 3.0)).unwrap();
        assert!(View::PLAN.arc(&upright, 1e-4).unwrap().is_none());
    }
}
