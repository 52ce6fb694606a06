//! Parts of a pipe between two borders: rulings, arcs and what is between, all exact.
//!
//! A half direction `V` with the angle g is turned to the point at g by `(C² - S², 2 S C)/(C² + S²)`; between two half directions it runs linearly, and the
//! place along the pipe too. So the part is rational, of degree 2 across where the borders are at equal places, of degree 3 otherwise; of a cone no
//! more, since its radius is linear in the place.

use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezierSurface};
use crate::topology::EdgeCurve;

/// The half direction of an angle.
pub(super) fn half(angle: f64) -> [f64; 2] {
    let (s, c) = (0.5 * angle).sin_cos();
    [c, s]
}

/// From one half direction to another, of degree 0 where they are one.
pub(super) fn between([from, to]: [[f64; 2]; 2]) -> [Polynomial; 2] {
    let one = (0..2).all(|d: usize| from[d] - to[d] == 0.0);
    [0, 1].map(|d: usize| Polynomial::new(if one { vec![from[d]] } else { vec![from[d], to[d]] }))
}

/// A border on a pipe: half direction, and the place along it times the weight.
pub(in crate::construct::bodies) struct Border {
    pub(in crate::construct::bodies) half: [Polynomial; 2],
    pub(in crate::construct::bodies) along: Polynomial,
}

/// A skin of a pipe, a cylinder or a cone. Angles are counted from `up` towards `sideways`, places along the axis from the origin; the three directions are a
/// right-handed frame in the order along, sideways, up.
#[derive(Debug, Clone, Copy)]
pub(in crate::construct::bodies) struct Mantle {
    /// At the origin.
    pub(in crate::construct::bodies) radius: f64,
    /// Half the angle of the cone: above zero it grows thinner along it.
    pub(in crate::construct::bodies) taper: f64,
    pub(in crate::construct::bodies) origin: Point3,
    pub(in crate::construct::bodies) along: Vec3,
    pub(in crate::construct::bodies) sideways: Vec3,
    pub(in crate::construct::bodies) up: Vec3,
}

impl Mantle {
    /// What a point is off the axis.
    pub(in crate::construct::bodies) fn off_axis(&self, p: Point3) -> Vec3 {
        let way = p - self.origin;
        way - self.along * way.dot(self.along)
    }

    /// The place of a point.
    pub(in crate::construct::bodies) fn place(&self, p: Point3) -> f64 {
        (p - self.origin).dot(self.along)
    }

    /// The angle of a direction.
    pub(in crate::construct::bodies) fn angle_of(&self, direction: Vec3) -> f64 {
        direction.dot(self.sideways).atan2(direction.dot(self.up))
    }

    /// The radius at a place.
    pub(in crate::construct::bodies) fn radius_at(&self, along: f64) -> f64 {
        self.radius - self.taper.tan() * along
    }

    /// Each point of it this far below, against its normal, at the same angle and the same place, which is counted from a moved origin.
    pub(in crate::construct::bodies) fn below(&self, depth: f64) -> Self {
        let (sin, cos) = self.taper.sin_cos();
        Self { radius: self.radius - depth * cos, origin: self.origin - self.along * (depth * sin), ..*self }
    }

    /// The center of its circle at a place.
    pub(in crate::construct::bodies) fn centre(&self, along: f64) -> Point3 {
        self.origin + self.along * along
    }

    /// The direction off the axis at a half direction.
    pub(in crate::construct::bodies) fn direction(&self, [c, s]: [f64; 2]) -> Vec3 {
        (self.up * ((c - s) * (c + s)) + self.sideways * (2.0 * c * s)) / (c * c + s * s)
    }

    pub(in crate::construct::bodies) fn point(&self, half: [f64; 2], along: f64) -> Point3 {
        self.centre(along) + self.direction(half) * self.radius_at(along)
    }

    /// A circle at a place, of degree twice that of its half direction.
    pub(in crate::construct::bodies) fn circle(&self, [c, s]: &[Polynomial; 2], along: f64) -> PolynomialRow {
        let (cc, ss, sc) = (c * c, s * s, c * s);
        let (radius, norm) = (self.radius_at(along), &cc + &ss);
        self.row(&(&(&cc + &(&ss * -1.0)) * radius), &(&sc * (2.0 * radius)), &norm, &(&norm * along))
    }

    /// The curve of a border, with its weight.
    pub(in crate::construct::bodies) fn border(
        &self,
        [c, s]: &[Polynomial; 2],
        along: &Polynomial,
        weight: &Polynomial,
    ) -> PolynomialRow {
        let (cc, ss, sc) = (c * c, s * s, c * s);
        let norm = &cc + &ss;
        let reach = self.reach(weight, along);
        let (up, side) = (&(&cc + &(&ss * -1.0)) * &reach, &(&sc * 2.0) * &reach);
        self.row(&up, &side, &(&norm * weight), &(&norm * along))
    }

    /// The radius at a place along, times the weight as that is.
    fn reach(&self, weight: &Polynomial, along: &Polynomial) -> Polynomial {
        // A cylinder takes no terms that only add rounding.
        if self.taper == 0.0 { weight * self.radius } else { &(weight * self.radius) + &(along * -self.taper.tan()) }
    }

    fn row(&self, cos: &Polynomial, sin: &Polynomial, weight: &Polynomial, along: &Polynomial) -> PolynomialRow {
        let (o, u, v, w) = (self.origin, self.up, self.sideways, self.along);
        let entry = |u: f64, v: f64, w: f64, o: f64| &(&(cos * u) + &(sin * v)) + &(&(along * w) + &(weight * o));
        let [x, y, z] =
            [(u.x, v.x, w.x, o.x), (u.y, v.y, w.y, o.y), (u.z, v.z, w.z, o.z)].map(|(u, v, w, o)| entry(u, v, w, o));
        PolynomialRow([x, y, z, weight.clone()])
    }

    /// The arc across from one half direction of length 1 to another, at one place.
    ///
    /// # Errors
    /// As [`Arc::from_weight_ratio`].
    pub(in crate::construct::bodies) fn arc(&self, ends: [Point3; 2], from: [f64; 2], to: [f64; 2]) -> Result<Arc> {
        // What turns `up` towards `sideways`.
        let axis = self.up.cross(self.sideways);
        let [from, to] = [from, to].map(|[c, s]| Quat::from_parts(c, axis * s));
        Arc::from_ratio_across(ends[0], ends[1], to * from.inverse().unwrap_or(Quat::ONE))
    }

    /// The part between two borders with one weight: s along them, t across.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`].
    pub(in crate::construct::bodies) fn between(
        &self,
        weight: &Polynomial,
        first: &Border,
        second: &Border,
    ) -> Result<RationalBezierSurface> {
        let ([c0, s0], [c1, s1]) = (&first.half, &second.half);
        let minus = |p: Polynomial, q: Polynomial| &p + &(&q * -1.0);
        let cos = [minus(c0 * c0, s0 * s0), minus(c0 * c1, s0 * s1), minus(c1 * c1, s1 * s1)];
        let sin = [&(c0 * s0) * 2.0, &(c0 * s1) + &(s0 * c1), &(c1 * s1) * 2.0];
        let norm = [&(c0 * c0) + &(s0 * s0), &(c0 * c1) + &(s0 * s1), &(c1 * c1) + &(s1 * s1)];
        let rows: Vec<PolynomialRow> = if first.along == second.along {
            let reach = self.reach(weight, &first.along);
            (0..3)
                .map(|k| {
                    self.row(&(&cos[k] * &reach), &(&sin[k] * &reach), &(&norm[k] * weight), &(&norm[k] * &first.along))
                })
                .collect()
        } else {
            // Products with a polynomial of degree 1 across.
            let raised = |a: &[Polynomial; 3], b: [&Polynomial; 2]| -> [Polynomial; 4] {
                let third = 1.0 / 3.0;
                [
                    &a[0] * b[0],
                    &(&(&a[0] * b[1]) * third) + &(&(&a[1] * b[0]) * (2.0 * third)),
                    &(&(&a[1] * b[1]) * (2.0 * third)) + &(&(&a[2] * b[0]) * third),
                    &a[2] * b[1],
                ]
            };
            let [reach, far] = [first, second].map(|border| self.reach(weight, &border.along));
            let [cos, sin] = [&cos, &sin].map(|a| raised(a, [&reach, &far]));
            let weights = raised(&norm, [weight, weight]);
            let along = raised(&norm, [&first.along, &second.along]);
            (0..4).map(|k| self.row(&cos[k], &sin[k], &weights[k], &along[k])).collect()
        };
        RationalBezierSurface::from_polynomial_rows(&rows)
    }

    /// The edge across between two half directions of length 1 at two places: an arc where these are one.
    ///
    /// # Errors
    /// As [`arc`](Self::arc).
    pub(in crate::construct::bodies) fn across(
        &self,
        ends: [Point3; 2],
        halves: [[f64; 2]; 2],
        along: [f64; 2],
    ) -> Result<EdgeCurve> {
        if along[0] - along[1] == 0.0 {
            return Ok(self.arc(ends, halves[0], halves[1])?.into());
        }
        let constant = |half: [f64; 2], at: f64| Border {
            half: half.map(Polynomial::constant),
            along: Polynomial::new(vec![at, at]),
        };
        let one = Polynomial::constant(1.0);
        let strip = self.between(&one, &constant(halves[0], along[0]), &constant(halves[1], along[1]))?;
        Ok(EdgeCurve::from(strip.t_line(0.0)).with_ends(Some(ends[0]), Some(ends[1])))
    }
}
