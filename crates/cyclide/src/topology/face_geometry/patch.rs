//! Patches of cyclides as surfaces of faces.

use super::patch_cells::{PatchSpeeds, denominators, grid_distances};
use super::{CellDistances, FaceGeometry, LineBends};
use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::rational::RationalBezierSurface;
use crate::surface::CyclidePatch;
use crate::topology::EdgeCurve;

impl FaceGeometry for CyclidePatch {
    fn corners(&self) -> [Point3; 4] {
        Self::corners(self)
    }
    fn s_line(&self, t: f64) -> Result<EdgeCurve> {
        Ok(Self::s_line(self, t)?.into())
    }
    fn t_line(&self, s: f64) -> Result<EdgeCurve> {
        Ok(Self::t_line(self, s)?.into())
    }
    fn bounds(&self) -> Aabb {
        Self::bounds(self)
    }
    fn to_rational(&self) -> RationalBezierSurface {
        Self::to_rational(self)
    }
    fn unit_normal(&self, s: f64, t: f64) -> Vec3 {
        Self::unit_normal(self, s, t)
    }
    fn cell_distances(&self, s: &[f64], t: &[f64], tolerance: f64) -> CellDistances {
        grid_distances(self, s, t, tolerance)
    }
    /// In closed form: the sagitta of the s-line at t is `|q1| |m|/4` times `1/|D|⁴`.
    fn line_bends(&self, places: &[f64]) -> LineBends {
        let speeds = &PatchSpeeds::new(self);
        let square = |v: f64| v * v;
        let scale = denominators(self, places, places).iter().map(|d| 1.0 / square(d.norm_squared())).collect();
        let lines = |direction: usize| places.iter().map(move |&x| speeds.line(direction, x));
        let own = [0, 1].map(|direction| lines(direction).map(|line| 0.25 * line.q * line.m).collect());
        let normal = [0, 1].map(|direction| lines(direction).map(|line| line.normal).collect());
        LineBends::of_lines(scale, own, normal)
    }
    fn line_curvatures(&self, s: f64, t: f64) -> [f64; 2] {
        [self.k1(t), self.k2(s)]
    }
    /// The corners of a cell lie on a circle.
    fn has_flat_cells(&self) -> bool {
        true
    }
    fn singular_s(&self) -> Vec<f64> {
        Self::singular_s(self)
    }
    fn singular_t(&self) -> Vec<f64> {
        Self::singular_t(self)
    }
    fn is_regular(&self) -> bool {
        Self::is_regular(self)
    }
    fn side_of_normal(&self, s: f64, t: f64) -> f64 {
        Self::side_of_normal(self, s, t)
    }
}
