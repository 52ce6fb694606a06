//! One rational tensor-product Bézier surface in homogeneous rows `[wx, wy, wz, w]`.

use super::bezier_curve::{RationalBezier, moved_row};
use crate::base::bernstein;
use crate::base::bounds::Aabb;
use crate::base::frame::Frame;
use crate::base::jet::AT_REST;
use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{ErrorItem, NumberError, NurbsError, Result};

/// A rational Bézier surface of degrees `(p, q)`. Row `i (q+1) + j` belongs to `B_i(s) B_j(t)`; rows are homogeneous, so
/// one may be a direction (weight 0).
///
/// ```
/// use cyclide::rational::RationalBezierSurface;
/// let rows = vec![[0.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0], [1.0, 1.0, 1.0, 1.0]];
/// let saddle = RationalBezierSurface::new([1, 1], rows)?; // t runs fastest
/// assert_eq!(saddle.point(0.5, 0.5).to_array(), [0.5, 0.5, 0.25]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RationalBezierSurface {
    degrees: [usize; 2],
    rows: Vec<[f64; 4]>,
}

impl RationalBezierSurface {
    /// Surface from its degrees (at least 1) and homogeneous rows.
    ///
    /// # Errors
    /// `not-a-spline` (the count does not fit), `not-finite`.
    pub fn new(degrees: [usize; 2], rows: Vec<[f64; 4]>) -> Result<Self> {
        if degrees.contains(&0) || rows.len() != (degrees[0] + 1) * (degrees[1] + 1) {
            return Err(
                NurbsError::NotASpline { detail: "a Bézier surface of degrees (p, q) has (p+1)(q+1) rows" }.into()
            );
        }
        match rows.iter().position(|row| row.iter().any(|v| !v.is_finite())) {
            Some(index) => Err(NumberError::NotFinite { what: ErrorItem::Row, index }.into()),
            None => Ok(Self { degrees, rows }),
        }
    }

    /// As [`new`](Self::new) for rows that are finite by construction.
    pub(crate) fn from_rows_unchecked(degrees: [usize; 2], rows: Vec<[f64; 4]>) -> Self {
        Self { degrees, rows }
    }

    /// Degrees along s and t.
    #[must_use]
    pub fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    /// The rows `[wx, wy, wz, w]`, t fastest.
    #[must_use]
    pub fn rows(&self) -> &[[f64; 4]] {
        &self.rows
    }

    /// True if every weight is positive.
    #[must_use]
    pub fn has_positive_weights(&self) -> bool {
        self.rows.iter().all(|r| r[3] > 0.0)
    }

    /// The point at `(s, t)`.
    #[must_use]
    pub fn point(&self, s: f64, t: f64) -> Point3 {
        let [x, y, z, w] = self.row(s, t);
        Point3::new(x / w, y / w, z / w)
    }

    /// The homogeneous row at `(s, t)`.
    fn row(&self, s: f64, t: f64) -> [f64; 4] {
        self.across(|row| bernstein::eval(row, t), [0.0; 4], |rows| bernstein::eval(rows, s))
    }

    /// The point and its derivatives at `(s, t)`.
    #[must_use]
    pub fn jet(&self, s: f64, t: f64) -> SurfaceJet {
        // Value and derivatives by t of a row of the surface side by side, then the derivatives of these by s.
        let by_t = |row: &[[f64; 4]]| -> [f64; 12] {
            let derivatives: [[f64; 4]; 3] = bernstein::derivatives(row, t);
            std::array::from_fn(|k| derivatives[k / 4][k % 4])
        };
        let h: [[f64; 12]; 3] = self.across(by_t, [0.0; 12], |rows| bernstein::derivatives(rows, s));
        let vector =
            |by_s: usize, by_t: usize| Vec3::new(h[by_s][4 * by_t], h[by_s][4 * by_t + 1], h[by_s][4 * by_t + 2]);
        let weight = |by_s: usize, by_t: usize| h[by_s][4 * by_t + 3];
        let (w, ws, wt) = (weight(0, 0), weight(1, 0), weight(0, 1));
        let x = vector(0, 0) / w;
        let ds = (vector(1, 0) - x * ws) / w;
        let dt = (vector(0, 1) - x * wt) / w;
        let dss = (vector(2, 0) - ds * (2.0 * ws) - x * weight(2, 0)) / w;
        let dst = (vector(1, 1) - ds * wt - dt * ws - x * weight(1, 1)) / w;
        let dtt = (vector(0, 2) - dt * (2.0 * wt) - x * weight(0, 2)) / w;
        SurfaceJet { point: Point3::ORIGIN + x, ds, dt, dss, dst, dtt }
    }

    /// Points, as ways from the origin, and first derivatives along the line of t at `s`, for many places on it.
    pub(crate) fn first_jets_along(&self, s: f64) -> FirstJets {
        let [p, q] = self.degrees;
        let mut column = vec![[0.0; 4]; p + 1];
        let rows = (0..=q).map(|j| {
            column.iter_mut().zip(self.rows.iter().skip(j).step_by(q + 1)).for_each(|(to, from)| *to = *from);
            let [h, hs]: [[f64; 4]; 2] = bernstein::derivatives(&column, s);
            std::array::from_fn(|k| if k < 4 { h[k] } else { hs[k - 4] })
        });
        FirstJets(rows.collect())
    }

    /// What is made of the rows `f` of the lines along t, without allocation up to degree 15 along s.
    fn across<T: Copy, R>(&self, f: impl Fn(&[[f64; 4]]) -> T, zero: T, then: impl Fn(&[T]) -> R) -> R {
        let [p, q] = self.degrees;
        let (mut few, mut many) = ([zero; 16], Vec::new());
        let lines = match few.get_mut(..=p) {
            Some(lines) => lines,
            None => {
                many.resize(p + 1, zero);
                &mut many
            }
        };
        for (line, row) in lines.iter_mut().zip(self.rows.chunks(q + 1)) {
            *line = f(row);
        }
        then(lines)
    }

    /// Unit normal in the direction of `f_s × f_t`; on a side that is one point, and at a corner where two sides run on straight or come to a
    /// cusp, the limit from inside. Zero where there is none.
    #[must_use]
    pub fn unit_normal(&self, s: f64, t: f64) -> Vec3 {
        let SurfaceJet { point, ds, dt, dss, dst, dtt } = self.jet(s, t);
        // Of a derivative that vanishes on a side, what it is next to it: it grows with the way from the side.
        let inward = |x: f64| if x < 0.5 { 1.0 } else { -1.0 };
        let zero = VANISHED * ds.max_abs().max(dt.max_abs()) + ROUNDING * point.to_vec().max_abs();
        // Where all of the side stands, as that of a sweep at rest, it grows with the way across the side.
        let grows = |across: Vec3, along: Vec3| {
            if across.max_abs() <= AT_REST * along.max_abs() { along } else { across }
        };
        let (a, b) = match (ds.max_abs() <= zero, dt.max_abs() <= zero) {
            (true, false) => (grows(dst * inward(t), dss * inward(s)), dt),
            (false, true) => (ds, grows(dst * inward(s), dtt * inward(t))),
            _ => (ds, dt),
        };
        let Some((a, b)) = a.unit().zip(b.unit()) else { return Vec3::default() };
        let across = a.cross(b);
        if across.length() > PARALLEL {
            return across.unit().unwrap_or_default();
        }
        // Both directions are one. How their product grows on the way inside, unless that is rounding too.
        let way = [inward(s), inward(t)];
        let (first, second) = (dss * way[0] + dst * way[1], dst * way[0] + dtt * way[1]);
        let growth = first.cross(dt) + ds.cross(second);
        let size = first.length() * dt.length() + ds.length() * second.length();
        let known =
            if growth.length() > PARALLEL * size { growth.unit() } else { self.normal_from_inside([s, t], way) };
        known.or_else(|| across.unit()).unwrap_or_default()
    }

    /// The normal at a place of the border to which its neighborhood leads: that of the plane, or one drawn out from two places inside.
    fn normal_from_inside(&self, at: [f64; 2], way: [f64; 2]) -> Option<Vec3> {
        if at.into_iter().all(|x| x > 0.0 && x < 1.0) {
            return None;
        }
        if let Some(plane) = self.plane() {
            return Some(plane.z());
        }
        let inside = |step: f64| {
            let jet = self.jet(at[0] + way[0] * step, at[1] + way[1] * step);
            jet.normal()
        };
        let (near, far) = (inside(INSIDE)?, inside(2.0 * INSIDE)?);
        (near * 2.0 - far).unit()
    }

    /// The plane in which all control points lie, to 1e-13 of their size and the rounding of their coordinates: its third axis is
    /// the normal `f_s × f_t` in the middle. Weights are positive.
    #[must_use]
    pub fn plane(&self) -> Option<Frame> {
        let points = || self.rows.iter().map(|[x, y, z, w]| Point3::new(x / w, y / w, z / w));
        let bounds = Aabb::of_points(points())?;
        let origin = self.corners()[0];
        // A side may be a point.
        let along = points().map(|p| p - origin).max_by(|a, b| a.length().total_cmp(&b.length()))?;
        let frame = Frame::from_normal(origin, self.unit_normal(0.5, 0.5), along).ok()?;
        let limit = PLANAR * bounds.diagonal() + PLANE_ROUNDING * bounds.max_abs();
        points().all(|p| frame.to_local(p).1.abs() <= limit).then_some(frame)
    }

    /// True for a part of a plane whose parameter lines are straight.
    #[must_use]
    pub fn is_plane_quad(&self) -> bool {
        self.degrees == [1, 1] && self.has_positive_weights() && self.plane().is_some()
    }

    /// The same surface with coordinates from another origin.
    pub(crate) fn seen_from(&self, origin: Point3) -> Self {
        let o = origin.to_vec();
        let moved = |&[x, y, z, w]: &[f64; 4]| [x - o.x * w, y - o.y * w, z - o.z * w, w];
        Self { degrees: self.degrees, rows: self.rows.iter().map(moved).collect() }
    }

    /// The corners at (0,0), (1,0), (0,1), (1,1).
    #[must_use]
    pub fn corners(&self) -> [Point3; 4] {
        self.corner_rows().map(|k| {
            let [x, y, z, w] = self.rows[k];
            Point3::new(x / w, y / w, z / w)
        })
    }

    fn corner_rows(&self) -> [usize; 4] {
        let [p, q] = self.degrees;
        [0, p * (q + 1), q, p * (q + 1) + q]
    }

    /// The surface with corners that are known better than its rows.
    pub(crate) fn with_corners(mut self, corners: [Point3; 4]) -> Self {
        for (k, p) in self.corner_rows().into_iter().zip(corners) {
            let w = self.rows[k][3];
            self.rows[k] = [p.x * w, p.y * w, p.z * w, w];
        }
        self
    }

    /// The surface with a side `t = 1` that is a point, known better than its rows.
    pub(crate) fn with_end_point(mut self, p: Point3) -> Self {
        let q = self.degrees[1];
        for row in self.rows.iter_mut().skip(q).step_by(q + 1) {
            let w = row[3];
            *row = [p.x * w, p.y * w, p.z * w, w];
        }
        self
    }

    /// The s-line at `t`, with the same parameter s.
    #[must_use]
    pub fn s_line(&self, t: f64) -> RationalBezier {
        RationalBezier::from_rows_unchecked(self.along_s(t))
    }

    /// The t-line at `s`, with the same parameter t.
    #[must_use]
    pub fn t_line(&self, s: f64) -> RationalBezier {
        let q = self.degrees[1];
        let column = |j: usize| self.rows.iter().skip(j).step_by(q + 1).copied().collect::<Vec<_>>();
        RationalBezier::from_rows_unchecked((0..=q).map(|j| bernstein::eval(&column(j), s)).collect())
    }

    /// The rows of the s-line at `t`.
    fn along_s(&self, t: f64) -> Vec<[f64; 4]> {
        self.rows.chunks(self.degrees[1] + 1).map(|row| bernstein::eval(row, t)).collect()
    }

    /// The part over `[s0, s1] × [t0, t1]`, `0 <= s0 < s1 <= 1` and the same for t, as a surface of its own: exact.
    #[must_use]
    pub fn part(&self, s: [f64; 2], t: [f64; 2]) -> Self {
        let [p, q] = self.degrees;
        let mut rows: Vec<[f64; 4]> = self.rows.clone();
        for row in rows.chunks_mut(q + 1) {
            bernstein::restrict(row, t);
        }
        let mut column = Vec::with_capacity(p + 1);
        for j in 0..=q {
            column.clear();
            column.extend(rows.iter().skip(j).step_by(q + 1));
            bernstein::restrict(&mut column, s);
            for (i, row) in column.iter().enumerate() {
                rows[i * (q + 1) + j] = *row;
            }
        }
        Self { degrees: self.degrees, rows }
    }

    /// The image under a similarity or a reflection: control points move, weights stay.
    ///
    /// # Errors
    /// `not-a-similarity`; `not-finite` if a control point overflows.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        map.check_similarity()?;
        let rows = self.rows.iter().enumerate().map(|(index, row)| moved_row(map, row, index));
        Ok(Self { degrees: self.degrees, rows: rows.collect::<Result<_>>()? })
    }
}

/// Part of its size, and of the coordinates, by which control points may be off a plane.
const PLANAR: f64 = 1e-13;
const PLANE_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Sines of the angle between parameter lines up to which their product is rounding.
const PARALLEL: f64 = 1e-7;
/// From a place of the border to one from which its normal is drawn out, in parameters.
const INSIDE: f64 = 1e-3;
/// A derivative below this part of the other one is rounding of zero: the side is one point there.
const VANISHED: f64 = 1e-13;
/// So is one below this part of the coordinates, of whose differences it is made: faces are small, or far from the origin.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A line along t of a surface, with the derivatives across it: homogeneous rows of both.
pub(crate) struct FirstJets(Vec<[f64; 8]>);

impl FirstJets {
    /// The point as a way from the origin, and the derivatives along s and t.
    pub(crate) fn at(&self, t: f64) -> [Vec3; 3] {
        let [h, ht]: [[f64; 8]; 2] = bernstein::derivatives(&self.0, t);
        let vector = |h: [f64; 8], k: usize| Vec3::new(h[k], h[k + 1], h[k + 2]);
        let x = vector(h, 0) / h[3];
        [x, (vector(h, 4) - x * h[7]) / h[3], (vector(ht, 0) - x * ht[3]) / h[3]]
    }
}
