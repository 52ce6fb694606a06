//! Which rational surfaces are parts of planes and of cylinders and cones of revolution (`docs/math/patches.md#rational-surfaces`).

use super::patch::PatchKind;
use super::rational_cone::{ACROSS, ConeFit};
use crate::base::bernstein;
use crate::base::bounds::Aabb;
use crate::base::frame::Frame;
use crate::base::vector::{Point3, Vec3};
use crate::rational::RationalBezierSurface;

/// Places per parameter whose normals give the axis.
const PLACES: u32 = 5;
/// Sine of the angle between the normals that are farthest apart: below it the axis is undetermined.
const SMALLEST_TURN: f64 = 1e-3;
/// How far the surface may leave the cylinder: the first of its own size, the second, rounding, of coordinates and radius.
const LIMIT: (f64, f64) = (1e-13, 64.0 * f64::EPSILON);

impl RationalBezierSurface {
    /// The plane, or the cylinder or cone of revolution, on which the surface lies, proved by its coefficients: no point is farther
    /// from it than 1e-13 of the size of the surface and the rounding of coordinates and radius. [`PatchKind::Cyclide`] stands
    /// for all else, for weights that are not all positive, for strips that turn by less than 0.001, and for cones as far as their tip.
    /// Source: own, see `docs/math/patches.md#rational-surfaces`.
    ///
    /// ```
    /// use cyclide::{rational::RationalBezierSurface, surface::PatchKind};
    /// let h = 0.5_f64.sqrt();
    /// let rows = [[1.0, 0.0, 1.0], [h, h, h], [0.0, 1.0, 1.0]];
    /// let rows = rows.iter().flat_map(|[x, y, w]| [[*x, *y, 0.0, *w], [*x, *y, 3.0 * w, *w]]).collect();
    /// let quarter = RationalBezierSurface::new([2, 1], rows)?;
    /// let PatchKind::Cylinder { radius, .. } = quarter.recognize() else { panic!("a quarter of a cylinder") };
    /// assert!((radius - 1.0).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn recognize(&self) -> PatchKind {
        if !self.has_positive_weights() {
            return PatchKind::Cyclide;
        }
        if let Some(frame) = self.plane() {
            return PatchKind::Plane { frame };
        }
        let place = |i: u32| f64::from(i) / f64::from(PLACES - 1);
        let places = (0..PLACES * PLACES).map(|k| (place(k / PLACES), place(k % PLACES)));
        let (points, normals): (Vec<Point3>, Vec<Vec3>) =
            places.map(|(s, t)| (self.point(s, t), self.unit_normal(s, t))).unzip();
        let found = self.cylinder(&points, &normals).or_else(|| self.cone(&points, &normals));
        found.unwrap_or(PatchKind::Cyclide)
    }

    /// The center and the radius of the sphere on which the surface lies, proved likewise, with the same limits; `None` of all else. The radius is
    /// negative where the normal `f_s × f_t` points to the center. Source: as [`recognize`](Self::recognize).
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, surface::CyclidePatch};
    /// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    /// let eighth = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?.to_rational();
    /// let (center, radius) = eighth.sphere().expect("an eighth of the unit sphere");
    /// assert!(center.distance(Point3::ORIGIN) < 1e-14 && (radius - 1.0).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn sphere(&self) -> Option<(Point3, f64)> {
        if !self.has_positive_weights() {
            return None;
        }
        let place = |i: u32| f64::from(i) / f64::from(PLACES - 1);
        let places = (0..PLACES * PLACES).map(|k| (place(k / PLACES), place(k % PLACES)));
        let (points, normals): (Vec<Point3>, Vec<Vec3>) =
            places.map(|(s, t)| (self.point(s, t), self.unit_normal(s, t))).unzip();
        let turns = normals.iter().any(|n| n.cross(normals[0]).length() >= SMALLEST_TURN);
        let (radius, center) = radius_and_centre(&points, &normals);
        let limit = limit(&points, radius.abs())?;
        (turns && radius.is_finite() && self.is_on_sphere(center, radius.abs(), limit)).then_some((center, radius))
    }

    /// Whether no point is farther than the limit from the sphere, with positive weights: as for the cylinder, with three coordinates.
    fn is_on_sphere(&self, center: Point3, radius: f64, limit: f64) -> bool {
        let local = self.seen_from(center);
        let square = |k: usize| {
            let row: Vec<f64> = local.rows().iter().map(|row| row[k]).collect();
            bernstein::product_of_two((&row, self.degrees()), (&row, self.degrees())).0
        };
        let [xx, yy, zz, ww] = [0, 1, 2, 3].map(square);
        (0..ww.len()).all(|k| ((xx[k] + yy[k] + zz[k]) / ww[k] - radius * radius).abs() / radius <= limit)
    }

    /// The cylinder that points and normals of some places suggest, if the surface lies on it.
    fn cylinder(&self, points: &[Point3], normals: &[Vec3]) -> Option<PatchKind> {
        let axis = axis(normals)?;
        let (radius, origin) = radius_and_centre(points, normals);
        let middle = self.point(0.5, 0.5);
        let origin = origin + axis * (middle - origin).dot(axis);
        let frame = Frame::from_normal(origin, axis, origin - middle).ok()?;
        let limit = limit(points, radius.abs())?;
        let found = PatchKind::Cylinder { frame, radius: radius.abs(), outward: radius > 0.0 };
        self.is_on_cylinder(&frame, radius.abs(), limit).then_some(found)
    }

    /// The cone that they suggest, likewise.
    fn cone(&self, points: &[Point3], normals: &[Vec3]) -> Option<PatchKind> {
        let middle = points.len() / 2;
        let ConeFit { frame, radius, slope } = ConeFit::of(points, normals, middle)?;
        let (origin, axis) = (frame.origin(), frame.z());
        let frame = Frame::from_normal(origin, axis, origin - points[middle]).ok()?;
        let outward = normals[middle].dot(points[middle] - origin) > 0.0;
        let found = PatchKind::Cone { frame, radius, half_angle: slope.atan(), outward };
        self.is_on_cone(&frame, [radius, slope], limit(points, radius)?).then_some(found)
    }

    /// Whether no point is farther than the limit from the cone about the third axis, with positive weights: as for the cylinder, with
    /// `L = r W + z tan` in place of `r W`, which has to be positive, and `|ρ - L| cos` for the distance.
    fn is_on_cone(&self, frame: &Frame, [radius, slope]: [f64; 2], limit: f64) -> bool {
        let local = self.seen_from(frame.origin());
        let along = |v: Vec3| local.rows().iter().map(|[x, y, z, _]| Vec3::new(*x, *y, *z).dot(v)).collect::<Vec<_>>();
        let weights: Vec<f64> = local.rows().iter().map(|row| row[3]).collect();
        let from_axis: Vec<f64> =
            weights.iter().zip(along(frame.z())).map(|(w, height)| radius * w + slope * height).collect();
        let least = from_axis.iter().zip(&weights).map(|(l, w)| l / w).fold(f64::INFINITY, f64::min);
        if !(least > 0.0) {
            return false;
        }
        let square = |row: &[f64]| bernstein::product_of_two((row, self.degrees()), (row, self.degrees())).0;
        let (xx, yy) = (square(&along(frame.x())), square(&along(frame.y())));
        let (ll, ww) = (square(&from_axis), square(&weights));
        let cos = 1.0 / slope.hypot(1.0);
        let mut off = (0..ww.len()).map(|k| (xx[k] + yy[k] - ll[k]).abs() / ww[k] * (cos / least));
        off.all(|off| off <= limit)
    }

    /// Whether no point is farther than the limit from the cylinder about the third axis, with positive weights: with rows
    /// `(X, Y, W)` across the axis `(X² + Y² - r² W²)/W²` is between the quotients of the coefficients, and
    /// `|ρ - r| <= |ρ² - r²|/r`.
    fn is_on_cylinder(&self, frame: &Frame, radius: f64, limit: f64) -> bool {
        let local = self.seen_from(frame.origin());
        let across = |v: Vec3| local.rows().iter().map(|[x, y, z, _]| Vec3::new(*x, *y, *z).dot(v)).collect::<Vec<_>>();
        let weights: Vec<f64> = local.rows().iter().map(|row| row[3]).collect();
        let square = |row: &[f64]| bernstein::product_of_two((row, self.degrees()), (row, self.degrees())).0;
        let (xx, yy, ww) = (square(&across(frame.x())), square(&across(frame.y())), square(&weights));
        let mut off = xx.iter().zip(&yy).zip(&ww).map(|((x, y), w)| ((x + y) / w - radius * radius).abs() / radius);
        off.all(|off| off <= limit)
    }
}

/// How far a surface through these points may leave the one that it lies on.
fn limit(points: &[Point3], radius: f64) -> Option<f64> {
    let bounds = Aabb::of_points(points.iter().copied())?;
    Some(LIMIT.0 * bounds.diagonal() + LIMIT.1 * (bounds.max_abs() + radius))
}

/// The direction at right angles to all normals, from two that are far apart, up as far as it is decided.
fn axis(normals: &[Vec3]) -> Option<Vec3> {
    let turn = |from: Vec3| move |a: &&Vec3, b: &&Vec3| from.cross(**a).length().total_cmp(&from.cross(**b).length());
    let first = **normals.iter().max_by(turn(*normals.first()?)).as_ref()?;
    let second = **normals.iter().max_by(turn(first)).as_ref()?;
    let across = first.cross(second);
    // Not `<`: what is no number is refused too.
    if !(across.length() >= SMALLEST_TURN) {
        return None;
    }
    let axis = across.unit()?;
    let largest = [axis.x, axis.y, axis.z].into_iter().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    let axis = if largest < 0.0 { -axis } else { axis };
    normals.iter().all(|n| n.dot(axis).abs() <= ACROSS).then_some(axis)
}

/// The radius, negative where the normals point to the axis, and a point of this: least squares of `p - r n = c` across it.
fn radius_and_centre(points: &[Point3], normals: &[Vec3]) -> (f64, Point3) {
    let (p0, n0) = (points[0], normals[0]);
    let share = 1.0 / points.len() as f64;
    let sums =
        points.iter().zip(normals).fold((Vec3::ZERO, Vec3::ZERO), |(p, n), (q, m)| (p + (*q - p0), n + (*m - n0)));
    let (p_mean, n_mean) = (p0 + sums.0 * share, n0 + sums.1 * share);
    let (mut up, mut down) = (0.0, 0.0);
    for (p, n) in points.iter().zip(normals) {
        up += (*p - p_mean).dot(*n - n_mean);
        down += (*n - n_mean).dot(*n - n_mean);
    }
    let radius = up / down;
    (radius, p_mean - n_mean * radius)
}
