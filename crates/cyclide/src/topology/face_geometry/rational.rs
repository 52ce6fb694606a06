//! Rational Bézier surfaces as surfaces of faces.

use super::developable_cells::Developable;
use super::rational_cells::grid_distances;
use super::{CellDistances, FaceGeometry, LineBends};
use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::rational::RationalBezierSurface;
use crate::topology::EdgeCurve;

impl FaceGeometry for RationalBezierSurface {
    fn corners(&self) -> [Point3; 4] {
        Self::corners(self)
    }
    fn s_line(&self, t: f64) -> Result<EdgeCurve> {
        Ok(Self::s_line(self, t).into())
    }
    fn t_line(&self, s: f64) -> Result<EdgeCurve> {
        Ok(Self::t_line(self, s).into())
    }
    fn bounds(&self) -> Aabb {
        Self::bounds(self)
    }
    fn bounds_with(&self, known: Aabb) -> Aabb {
        Self::bounds_with(self, known)
    }
    fn to_rational(&self) -> RationalBezierSurface {
        self.clone()
    }
    fn unit_normal(&self, s: f64, t: f64) -> Vec3 {
        Self::unit_normal(self, s, t)
    }
    fn cell_distances(&self, s: &[f64], t: &[f64], tolerance: f64) -> CellDistances {
        grid_distances(self, s, t, tolerance)
    }
    fn line_bends(&self, places: &[f64]) -> LineBends {
        let Some(developable) = Developable::of(self) else {
            return LineBends::of_places(places, |s, t| self.jet(s, t));
        };
        // What runs on the surface is no bend.
        LineBends::of_places(places, |s, t| {
            let mut jet = self.jet(s, t);
            let normal = developable.normal(jet.point);
            (jet.dss, jet.dtt) = (normal * jet.dss.dot(normal), normal * jet.dtt.dot(normal));
            jet
        })
    }
    fn is_plane_quad(&self) -> bool {
        Self::is_plane_quad(self)
    }
}
