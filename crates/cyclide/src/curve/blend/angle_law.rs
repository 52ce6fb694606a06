//! How the start tangent moves along its great circle: the angle law of a blend.
//!
//! Both variants give the tangent as `t = (C t1 + S b)/q` with `C² + S² = q²`, so everything else is shared.

/// Largest blend order supported: joints are G1 up to G4.
pub(crate) const MAX_ORDER: u32 = 4;

/// The angle law of a blend.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BlendVariant {
    /// Angle `f_k(l) theta` with the smooth step `f_k`: the lowest extreme curvature, but no exact rational form.
    Trigonometric,
    /// Rational functions of `l` of degree `2k`: an exact rational curve of degree `2k + 2`, no trigonometry.
    #[default]
    Rational,
}

/// A number with its Taylor coefficients to third order.
pub(super) type Series = [f64; 4];

/// Coefficients of `f_k(l)/l^k` in rising powers of `l`, for `k = 1..=4` (`50`, section 4; `004`, (68) for `k = 2`).
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
    pub(super) variant: BlendVariant,
    pub(super) order: u32,
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
        match self.variant {
            BlendVariant::Trigonometric => {
                let (s, c) = (self.theta * smooth_step(self.order, l)).sin_cos();
                [c, s, 1.0]
            }
            BlendVariant::Rational => {
                // `50`, section 5: (A² t1 + 2AB h + B² t2)/(A² + 2AB cos(theta/2) + B²), A = m^k, B = l^k.
                let (a, b) = (power(1.0 - l, self.order), power(l, self.order));
                let ([ch, sh], [cf, sf]) = (self.half, self.full());
                let (aa, ab, bb) = (a * a, 2.0 * a * b, b * b);
                [aa + ab * ch + bb * cf, ab * sh + bb * sf, aa + ab * ch + bb]
            }
        }
    }

    /// Derivative by `l` of the angle between `t1` and the tangent.
    pub(super) fn rate(&self, l: f64) -> f64 {
        let k = self.order as usize - 1;
        // (l (1-l))^(k-1)
        let z = power(l * (1.0 - l), self.order - 1);
        match self.variant {
            BlendVariant::Trigonometric => self.theta * STEP_SLOPE[k] * z,
            // The angle is theta/2 + 2 atan((2g-1) tan(theta/4)), g = B/(A+B), with B'A - A'B = k z.
            BlendVariant::Rational => 2.0 * f64::from(self.order) * self.half[1] * z / self.at(l)[2],
        }
    }

    /// The angle between `t1` and the tangent at `l`, rising from 0 to the blend angle (`50`, section 5).
    pub(super) fn angle(&self, l: f64) -> f64 {
        match self.variant {
            BlendVariant::Trigonometric => self.theta * smooth_step(self.order, l),
            BlendVariant::Rational => {
                let (a, b) = (power(1.0 - l, self.order), power(l, self.order));
                0.5 * self.theta + 2.0 * ((b - a) / (a + b) * (0.25 * self.theta).tan()).atan()
            }
        }
    }

    /// Taylor coefficients at `l` of the cosine and sine of the angle between `t1` and the tangent.
    pub(super) fn series(&self, l: f64) -> (Series, Series) {
        match self.variant {
            BlendVariant::Trigonometric => {
                // `50`, section 4: recursion for the cosine and sine of a power series.
                let p = smooth_step_series(self.order, l).map(|f| f * self.theta);
                let (sin, cos) = p[0].sin_cos();
                let (mut c, mut s) = ([cos, 0.0, 0.0, 0.0], [sin, 0.0, 0.0, 0.0]);
                for j in 1..4 {
                    let sum = |x: &Series| (1..=j).map(|i| i as f64 * p[i] * x[j - i]).sum::<f64>() / j as f64;
                    (c[j], s[j]) = (-sum(&s), sum(&c));
                }
                (c, s)
            }
            BlendVariant::Rational => {
                let (a, b) = (power_series(1.0 - l, -1.0, self.order), power_series(l, 1.0, self.order));
                let ([ch, sh], [cf, sf]) = (self.half, self.full());
                let (aa, ab, bb) = (product(&a, &a), product(&a, &b), product(&b, &b));
                let c = std::array::from_fn(|j| aa[j] + 2.0 * ch * ab[j] + cf * bb[j]);
                let s = std::array::from_fn(|j| 2.0 * sh * ab[j] + sf * bb[j]);
                let q = std::array::from_fn(|j| aa[j] + 2.0 * ch * ab[j] + bb[j]);
                (quotient(&c, &q), quotient(&s, &q))
            }
        }
    }
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
        let variants = [BlendVariant::Trigonometric, BlendVariant::Rational];
        variants.into_iter().flat_map(move |variant| {
            (1..=MAX_ORDER).flat_map(move |order| {
                angles.map(|theta: f64| {
                    let (s, c) = (0.5 * theta).sin_cos();
                    AngleLaw { variant, order, theta, half: [c, s] }
                })
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
