//! A point of a surface with its derivatives, and what follows from them alone.

use super::vector::{Point3, Vec3};

/// A speed whose square is below this part of that of the other line is rounding of zero.
const ONE_POINT: f64 = 1e-24;

/// A point of a surface with its first and second partial derivatives.
///
/// ```
/// use cyclide::surface::{DupinCyclide, ParamSurface};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?;
/// let jet = torus[0].patch(0, 0).jet(0.3, 0.6);
/// assert!(jet.ds.dot(jet.dt).abs() < 1e-12 && jet.normal().is_some()); // lines of curvature are perpendicular
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SurfaceJet {
    /// The point.
    pub point: Point3,
    /// Derivative by the first parameter.
    pub ds: Vec3,
    /// Derivative by the second parameter.
    pub dt: Vec3,
    /// Second derivative by the first parameter.
    pub dss: Vec3,
    /// Mixed second derivative.
    pub dst: Vec3,
    /// Second derivative by the second parameter.
    pub dtt: Vec3,
}

impl SurfaceJet {
    /// Unit normal `ds × dt`; `None` where it vanishes.
    #[must_use]
    #[inline]
    pub fn normal(&self) -> Option<Vec3> {
        // Directions first: the product of two tiny derivatives would underflow.
        self.ds.unit()?.cross(self.dt.unit()?).unit()
    }

    /// Coefficients `[E, F, G]` of the first fundamental form.
    #[must_use]
    #[inline]
    pub fn first_form(&self) -> [f64; 3] {
        [self.ds.dot(self.ds), self.ds.dot(self.dt), self.dt.dot(self.dt)]
    }

    /// Coefficients `[L, M, N]` of the second fundamental form against [`normal`](Self::normal); `None` where there
    /// is no normal.
    #[must_use]
    #[inline]
    pub fn second_form(&self) -> Option<[f64; 3]> {
        let n = self.normal()?;
        Some([self.dss.dot(n), self.dst.dot(n), self.dtt.dot(n)])
    }

    /// Normal curvatures of the s-line and of the t-line against [`normal`](Self::normal), the principal ones where the lines
    /// are lines of curvature; `None` where there is no normal, or one of the lines is a point.
    #[must_use]
    #[inline]
    pub fn normal_curvatures(&self) -> Option<[f64; 2]> {
        let ([e, _, g], [l, _, n]) = (self.first_form(), self.second_form()?);
        (e.min(g) > ONE_POINT * e.max(g)).then_some([l / e, n / g])
    }

    /// The principal curvatures against [`normal`](Self::normal), the larger first, whatever the parameter lines are; `None` where
    /// there is no normal, or one of the lines is a point.
    ///
    /// The second form in an orthonormal frame of the tangent plane, whose first vector is along `ds`, and its eigenvalues.
    ///
    /// ```
    /// use cyclide::{SurfaceJet, Vec3};
    /// // z = x y, which bends by 1 and by -1 along the diagonals of its straight lines.
    /// let jet = SurfaceJet { ds: Vec3::X, dt: Vec3::Y, dst: Vec3::Z, ..SurfaceJet::default() };
    /// assert_eq!(jet.principal_curvatures(), Some([1.0, -1.0]));
    /// ```
    #[must_use]
    #[inline]
    pub fn principal_curvatures(&self) -> Option<[f64; 2]> {
        let normal = self.normal()?;
        let along = self.ds.unit()?;
        let (a, b, c) = (self.ds.length(), self.dt.dot(along), self.dt.dot(normal.cross(along)));
        if !(c * c > ONE_POINT * a * a && a * a > ONE_POINT * (b * b + c * c)) {
            return None;
        }
        let ([l, m, n], slant) = (self.second_form()?, b / a);
        let (xx, xy, yy) = (l / (a * a), (m - slant * l) / (a * c), (n - slant * (2.0 * m - slant * l)) / (c * c));
        let (mean, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
        Some([mean + half, mean - half])
    }

    /// Element of area `|ds × dt|`.
    #[must_use]
    #[inline]
    pub fn area_element(&self) -> f64 {
        self.ds.cross(self.dt).length()
    }
}
