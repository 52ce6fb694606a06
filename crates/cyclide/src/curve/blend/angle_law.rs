//! How the start tangent moves along its great circle: the angle law of a blend.
//!
//! All laws give the tangent as `t = (C t1 + S b)/q` with `C² + S² = q²`, so everything else is shared.

/// Largest blend order supported: joints are G1 up to G4.
pub(crate) const MAX_ORDER: u32 = 4;

/// The angle law of a blend.
///
/// The rational one has rational functions of `l` of degree `2k`: an exact rational curve of degree `2k + 2`, no trigonometry. The
/// trigonometric one has the angle `f_k(l) theta` with the smooth step `f_k`: the lowest extreme curvature, but no exact rational form.
///
/// ```
/// use cyclide::{Point3, curve::{BlendVariant, CircleSpline, CircleSplineOptions}, model::{Exactness, Lower}};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 1.0]].map(Point3::from);
/// let options = |variant| CircleSplineOptions { variant, ..Default::default() };
/// let exactness = |variant| CircleSpline::from_points(&points, &options(variant)).and_then(|spline| spline.to_chain(1e-4));
/// assert_eq!(exactness(BlendVariant::Rational)?.1, Exactness::Exact);
/// assert_ne!(exactness(BlendVariant::Trigonometric)?.1, Exactness::Exact);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Variant", description = "How the circles of a circle spline are blended.")
)]
pub enum BlendVariant {
    /// An exact rational curve.
    #[default]
    Rational,
    /// Sines of a blended angle; files contain it within a tolerance.
    Trigonometric,
}

/// The angle law of a segment with its parameter.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::BlendSegment};
/// let (a, b) = (Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
/// let fair = BlendSegment::fair(a, Vec3::Y, b, Vec3::new(1.0, 1.0, 1.0), 1.0)?;
/// assert!(fair.law().order() >= 1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BlendLaw {
    /// The angle follows the smooth step of the blend order.
    Trigonometric {
        /// Order of contact with the circles at the ends.
        order: u32,
    },
    /// Rational functions `A = m^k`, `B = l^k` of the blend order `k`.
    Rational {
        /// Order of contact with the circles at the ends.
        order: u32,
    },
    /// Rational functions `A = m (m + e l)`, `B = l (l + e m)`: fair with `e = 1`, which is the rational law of order 1
    /// (degree 4), and with `e = 0` the rational law of order 2 (`docs/math/fair-splines.md#law-and-end-curvature`).
    Fair {
        /// The blend `e`, 0 to 1.
        blend: f64,
    },
}

impl BlendLaw {
    /// The law of a variant and order.
    pub(crate) fn of(variant: BlendVariant, order: u32) -> Self {
        match variant {
            BlendVariant::Trigonometric => Self::Trigonometric { order },
            BlendVariant::Rational => Self::Rational { order },
        }
    }

    /// Order of contact with the circles at the ends.
    #[must_use]
    pub fn order(self) -> u32 {
        match self {
            Self::Trigonometric { order } | Self::Rational { order } => order,
            Self::Fair { blend } => 1 + u32::from(blend == 0.0),
        }
    }
}

/// A number with its Taylor coefficients to third order.
pub(super) type Series = [f64; 4];

/// Coefficients of `f_k(l)/l^k` in rising powers of `l`, for `k = 1..=4` (`docs/math/circle-blends.md#angle-laws`;
/// `004`, (68) for `k = 2`).
const SMOOTH_STEP: [[f64; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [3.0, -2.0, 0.0, 0.0], [10.0, -15.0, 6.0, 0.0], [35.0, -84.0, 70.0, -20.0]];

/// `(2k-1)!/((k-1)!)²`: `f_k' = STEP_SLOPE[k-1] (l (1-l))^(k-1)`.
const STEP_SLOPE: [f64; 4] = [1.0, 6.0, 30.0, 140.0];

/// The smooth step `f_k(l) = l^k sum_j C(k-1+j, j) (1-l)^j` of degree `2k - 1`, exact at 0 and 1.
pub(crate) fn smooth_step(order: u32, l: f64) -> f64 {
    let [a, b, c, d] = SMOOTH_STEP[order as usize - 1];
    power(l, order) * (a + l * (b + l * (c + l * d)))
}

/// `base^order` for orders 0 to 4 by multiplication alone.
fn power(base: f64, order: u32) -> f64 {
    match order {
        0 => 1.0,
        1 => base,
        2 => base * base,
        3 => base * base * base,
        _ => (base * base) * (base * base),
    }
}

/// Taylor coefficients of the smooth step at `l`, from `f' = c z^n` with `z = l(1-l)`, `z' = 1-2l`, `z'' = -2`.
fn smooth_step_series(order: u32, l: f64) -> Series {
    let (n, c) = (f64::from(order - 1), STEP_SLOPE[order as usize - 1]);
    let (z, v) = (l * (1.0 - l), 1.0 - 2.0 * l);
    // z^(n-j); terms with a negative exponent carry the factor 0.
    let zn = |j: i32| if order as i32 > j { z.powi(order as i32 - 1 - j) } else { 0.0 };
    let d1 = c * zn(0);
    let d2 = c * n * zn(1) * v;
    let d3 = c * n * ((n - 1.0) * zn(2) * v * v - 2.0 * zn(1));
    [smooth_step(order, l), d1, d2 / 2.0, d3 / 6.0]
}

/// The angle law of one segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct AngleLaw {
    pub(super) law: BlendLaw,
    /// Blend angle, in `[0, 2 pi)`.
    pub(super) theta: f64,
    /// Cosine and sine of half the blend angle.
    pub(super) half: [f64; 2],
}

impl AngleLaw {
    /// Cosine and sine of the blend angle.
    pub(super) fn full(&self) -> [f64; 2] {
        let [c, s] = self.half;
        [(c - s) * (c + s), 2.0 * c * s]
    }

    /// `[C, S, q]` at `l`: the tangent is `(C t1 + S b)/q`.
    pub(super) fn at(&self, l: f64) -> [f64; 3] {
        match self.law {
            BlendLaw::Trigonometric { order } => {
                let (s, c) = (self.theta * smooth_step(order, l)).sin_cos();
                [c, s, 1.0]
            }
            BlendLaw::Rational { order } => self.blended(power(1.0 - l, order), power(l, order)),
            BlendLaw::Fair { blend } => {
                let [a, b] = fair_factors(blend, l);
                self.blended(a, b)
            }
        }
    }

    /// `1 - |cos(theta/2)|`, to the last digits.
    pub(super) fn versine(&self) -> f64 {
        let [c, s] = self.half;
        s * s / (1.0 + c.abs())
    }

    /// `[C, S, q]` of `(A² t1 + 2AB h + B² t2)/(A² + 2AB cos(theta/2) + B²)` (`docs/math/circle-blends.md#angle-laws`).
    /// Beyond half a turn by the differences from a full one, where the sums would cancel: with `v = 1 + cos(theta/2)`
    ///
    /// ```text
    /// q = (A-B)² + 2AB v,  C = q - 2 B² sin²(theta/2),  S = 2 B sin(theta/2) (A - B + B v)
    /// ```
    fn blended(&self, a: f64, b: f64) -> [f64; 3] {
        let ([ch, sh], [cf, sf]) = (self.half, self.full());
        if ch < 0.0 {
            let (d, v) = (a - b, self.versine());
            let q = d * d + 2.0 * a * b * v;
            return [q - 2.0 * b * b * sh * sh, 2.0 * b * sh * (d + b * v), q];
        }
        let (aa, ab, bb) = (a * a, 2.0 * a * b, b * b);
        [aa + ab * ch + bb * cf, ab * sh + bb * sf, aa + ab * ch + bb]
    }

    /// Derivative by `l` of the angle between `t1` and the tangent.
    ///
    /// The rational angle is `theta/2 + 2 atan((2g-1) tan(theta/4))`, `g = B/(A+B)`, with the rate
    /// `2 sin(theta/2) (B'A - A'B)/q`.
    pub(super) fn rate(&self, l: f64) -> f64 {
        let z = l * (1.0 - l);
        match self.law {
            BlendLaw::Trigonometric { order } => self.theta * STEP_SLOPE[order as usize - 1] * power(z, order - 1),
            BlendLaw::Rational { order } => 2.0 * f64::from(order) * self.half[1] * power(z, order - 1) / self.at(l)[2],
            BlendLaw::Fair { blend } => 2.0 * self.half[1] * (blend + 2.0 * z * (1.0 - blend)) / self.at(l)[2],
        }
    }

    /// The angle between `t1` and the tangent at `l`, rising from 0 to the blend angle
    /// (`docs/math/circle-blends.md#angle-laws`).
    pub(super) fn angle(&self, l: f64) -> f64 {
        let rational = |a: f64, b: f64| 0.5 * self.theta + 2.0 * ((b - a) / (a + b) * (0.25 * self.theta).tan()).atan();
        match self.law {
            BlendLaw::Trigonometric { order } => self.theta * smooth_step(order, l),
            BlendLaw::Rational { order } => rational(power(1.0 - l, order), power(l, order)),
            BlendLaw::Fair { blend } => {
                let [a, b] = fair_factors(blend, l);
                rational(a, b)
            }
        }
    }

    /// Derivative of [`angle`](Self::angle) by the blend angle, from 0 to 1 where that is less than half a turn.
    pub(super) fn share(&self, l: f64) -> f64 {
        let (sin, cos) = (0.25 * self.theta).sin_cos();
        let rational = |a: f64, b: f64| {
            let h = (b - a) / (a + b);
            0.5 + 0.5 * h / (cos * cos + (h * sin) * (h * sin))
        };
        match self.law {
            BlendLaw::Trigonometric { order } => smooth_step(order, l),
            BlendLaw::Rational { order } => rational(power(1.0 - l, order), power(l, order)),
            BlendLaw::Fair { blend } => {
                let [a, b] = fair_factors(blend, l);
                rational(a, b)
            }
        }
    }

    /// `p` and `q` of the angle `p l + q l² + ...` near the start; near the end it is the same, seen from there.
    pub(super) fn end_rates(&self) -> [f64; 2] {
        let chord = 2.0 * self.half[1];
        let fair = |e: f64| [e * chord, chord * (1.0 + e - e * e * (1.0 + self.half[0]))];
        match self.law {
            BlendLaw::Trigonometric { order: 1 } => [self.theta, 0.0],
            BlendLaw::Trigonometric { order: 2 } => [0.0, 3.0 * self.theta],
            BlendLaw::Rational { order: 1 } => fair(1.0),
            BlendLaw::Rational { order: 2 } => fair(0.0),
            BlendLaw::Fair { blend } => fair(blend),
            _ => [0.0; 2],
        }
    }

    /// Taylor coefficients at `l` of the cosine and sine of the angle between `t1` and the tangent.
    pub(super) fn series(&self, l: f64) -> (Series, Series) {
        match self.law {
            BlendLaw::Trigonometric { order } => {
                // `docs/math/circle-blends.md#derivatives`: recursion for the cosine and sine of a power series.
                let p = smooth_step_series(order, l).map(|f| f * self.theta);
                let (sin, cos) = p[0].sin_cos();
                let (mut c, mut s) = ([cos, 0.0, 0.0, 0.0], [sin, 0.0, 0.0, 0.0]);
                for j in 1..4 {
                    let sum = |x: &Series| (1..=j).map(|i| i as f64 * p[i] * x[j - i]).sum::<f64>() / j as f64;
                    (c[j], s[j]) = (-sum(&s), sum(&c));
                }
                (c, s)
            }
            BlendLaw::Rational { order } => {
                self.blended_series(&power_series(1.0 - l, -1.0, order), &power_series(l, 1.0, order))
            }
            BlendLaw::Fair { blend } => {
                let ([a, b], m) = (fair_factors(blend, l), 1.0 - l);
                let (twist, bend) = (blend * (m - l), 1.0 - blend);
                self.blended_series(&[a, twist - 2.0 * m, bend, 0.0], &[b, twist + 2.0 * l, bend, 0.0])
            }
        }
    }

    fn blended_series(&self, a: &Series, b: &Series) -> (Series, Series) {
        let ([ch, sh], [cf, sf]) = (self.half, self.full());
        let (aa, ab, bb) = (product(a, a), product(a, b), product(b, b));
        if ch < 0.0 {
            let (d, v): (Series, f64) = (std::array::from_fn(|j| a[j] - b[j]), self.versine());
            let (dd, db) = (product(&d, &d), product(&d, b));
            let q: Series = std::array::from_fn(|j| dd[j] + 2.0 * v * ab[j]);
            let c = std::array::from_fn(|j| q[j] - 2.0 * sh * sh * bb[j]);
            let s = std::array::from_fn(|j| 2.0 * sh * (db[j] + v * bb[j]));
            return (quotient(&c, &q), quotient(&s, &q));
        }
        let c = std::array::from_fn(|j| aa[j] + 2.0 * ch * ab[j] + cf * bb[j]);
        let s = std::array::from_fn(|j| 2.0 * sh * ab[j] + sf * bb[j]);
        let q = std::array::from_fn(|j| aa[j] + 2.0 * ch * ab[j] + bb[j]);
        (quotient(&c, &q), quotient(&s, &q))
    }
}

/// `A = m (m + e l)` and `B = l (l + e m)` (`docs/math/fair-splines.md#law-and-end-curvature`).
fn fair_factors(blend: f64, l: f64) -> [f64; 2] {
    let m = 1.0 - l;
    [m * (m + blend * l), l * (l + blend * m)]
}

/// Taylor coefficients of `(x + slope h)^order` in `h`, `slope` being 1 or -1.
fn power_series(x: f64, slope: f64, order: u32) -> Series {
    let (mut out, mut choose) = ([0.0; 4], 1.0);
    for (j, c) in (0..=order).zip(&mut out) {
        *c = choose * x.powi((order - j) as i32);
        choose *= slope * f64::from(order - j) / f64::from(j + 1);
    }
    out
}

fn product(a: &Series, b: &Series) -> Series {
    std::array::from_fn(|j| (0..=j).map(|i| a[i] * b[j - i]).sum())
}

fn quotient(a: &Series, b: &Series) -> Series {
    let mut out = [0.0; 4];
    for j in 0..4 {
        out[j] = (a[j] - (1..=j).map(|i| b[i] * out[j - i]).sum::<f64>()) / b[0];
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laws() -> impl Iterator<Item = AngleLaw> {
        let angles = [0.0, 1e-9, 0.7, 3.0, std::f64::consts::PI, 5.5];
        let orders =
            (1..=MAX_ORDER).flat_map(|order| [BlendLaw::Trigonometric { order }, BlendLaw::Rational { order }]);
        let fair = [0.0, 0.3, 1.0].map(|blend| BlendLaw::Fair { blend });
        orders.chain(fair).flat_map(move |law| {
            angles.map(|theta: f64| {
                let (s, c) = (0.5 * theta).sin_cos();
                AngleLaw { law, theta, half: [c, s] }
            })
        })
    }

    #[test]
    fn the_tangent_stays_on_the_unit_circle_and_runs_from_end_to_end() {
        for law in laws() {
            for i in 0..=20 {
                let [c, s, q] = law.at(f64::from(i) / 20.0);
                assert!((c.hypot(s) - q).abs() < 1e-15 * (1.0 + q), "{law:?}");
            }
            assert!(
                law.at(0.0).iter().zip([1.0, 0.0, 1.0]).all(|(x, y)| x.total_cmp(&y).is_eq()),
                "exact at the start"
            );
            let [c, s, q] = law.at(1.0);
            // The full angle from the half angle by doubling: two roundings.
            assert!((c / q - law.theta.cos()).abs() < 1e-15 && (s / q - law.theta.sin()).abs() < 1e-15, "{law:?}");
        }
    }

    #[test]
    fn series_are_the_taylor_coefficients() {
        // The sum of the series at a step h differs from the value by the fourth term. The angle moves fastest in the
        // middle of the rational law of order 4: by 4 k tan(5.5/4) < 100 per unit, so the term is below (100 h)^4.
        let h = 1e-4;
        for law in laws() {
            for l in [0.0, 0.2, 0.5, 0.9, 1.0 - h] {
                let (c, s) = law.series(l);
                let [cw, sw, q] = law.at(l + h);
                let sum = |x: Series| x[0] + h * (x[1] + h * (x[2] + h * x[3]));
                assert!((sum(c) - cw / q).abs() < (100.0 * h).powi(4), "{law:?} {l}");
                assert!((sum(s) - sw / q).abs() < (100.0 * h).powi(4), "{law:?} {l}");
            }
        }
    }

    #[test]
    fn rates_are_the_derivatives_of_the_angle() {
        let h = 1e-6;
        for law in laws() {
            for l in [0.1, 0.5, 0.8] {
                let difference = (law.angle(l + h) - law.angle(l - h)) / (2.0 * h);
                // Rounding of angles up to 2 pi over the step, and its square times the third derivative (100³).
                assert!((law.rate(l) - difference).abs() < 1e-8 * (1.0 + law.rate(l)) + 1e6 * h * h, "{law:?} {l}");
            }
            let [p, q] = law.end_rates();
            let ahead = law.angle(h);
            assert!((ahead - h * (p + q * h)).abs() < 1e-14 + 1e4 * h * h * h, "{law:?}");
        }
    }

    #[test]
    fn the_fair_law_ends_in_the_rational_laws_of_order_1_and_2() {
        let of = |law| AngleLaw { law, theta: 2.0, half: [1.0_f64.cos(), 1.0_f64.sin()] };
        for (blend, order) in [(1.0, 1), (0.0, 2)] {
            let (fair, rational) = (of(BlendLaw::Fair { blend }), of(BlendLaw::Rational { order }));
            for l in [0.0, 0.2, 0.5, 0.9, 1.0] {
                // A few roundings of angles up to 2.
                assert!((fair.angle(l) - rational.angle(l)).abs() < 2e-15);
                assert!((fair.rate(l) - rational.rate(l)).abs() < 4e-15);
            }
        }
    }

    #[test]
    fn smooth_step_is_the_published_sum() {
        for order in 1..=MAX_ORDER {
            let k = u64::from(order);
            for i in 0..=16 {
                let l = f64::from(i) / 16.0;
                let choose = |n: u64, r: u64| (0..r).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64);
                let sum: f64 = (0..k).map(|j| choose(k - 1 + j, j) * (1.0 - l).powi(j as i32)).sum();
                // Alternating powers with coefficients up to 84: at most 200 roundings of 1e-16.
                assert!((smooth_step(order, l) - l.powi(order as i32) * sum).abs() < 2e-14);
            }
        }
    }
}
