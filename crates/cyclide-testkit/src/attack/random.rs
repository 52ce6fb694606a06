//! A small generator of random numbers, the same on every machine: `SplitMix64` (Steele, Lea, Flood 2014).

/// Random numbers.
#[derive(Debug, Clone)]
pub struct Random {
    state: u64,
}

impl Random {
    /// The numbers that belong to a seed and a case.
    #[must_use]
    pub fn new(seed: u64, case: u64) -> Self {
        let mut random =
            Self { state: seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ case.wrapping_mul(0xD134_2543_DE82_EF95) };
        random.next();
        random
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Evenly in `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Evenly in `[from, to)`.
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }

    /// An integer below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n.saturating_sub(1))
    }

    /// True in the given part of the cases.
    pub fn chance(&mut self, part: f64) -> bool {
        self.unit() < part
    }

    /// Normally distributed (Box, Muller).
    pub fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.unit(), self.unit());
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }

    /// Ten to a power between the two.
    pub fn decades(&mut self, from: f64, to: f64) -> f64 {
        10.0_f64.powf(self.between(from, to))
    }

    /// One of some values.
    pub fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// A number as people and programs write it: a small integer, a few digits, all digits.
    pub fn number(&mut self) -> f64 {
        match self.below(4) {
            0 => self.between(-10.0, 10.0).round(),
            1 => (self.between(-10.0, 10.0) * 100.0).round() / 100.0,
            2 => self.normal(),
            _ => self.decades(-4.0, 3.0) * if self.chance(0.5) { 1.0 } else { -1.0 },
        }
    }

    /// Three normally distributed numbers.
    pub fn vector(&mut self) -> [f64; 3] {
        [self.normal(), self.normal(), self.normal()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_and_cases_are_independent_and_repeat() {
        let first = |seed, case| Random::new(seed, case).unit();
        assert!((first(1, 2) - first(1, 2)).abs() < f64::MIN_POSITIVE);
        assert!((first(1, 2) - first(2, 1)).abs() > 1e-9 && (first(1, 2) - first(1, 3)).abs() > 1e-9);
        let mut random = Random::new(7, 7);
        let mean = (0..10_000).map(|_| random.unit()).sum::<f64>() / 1e4;
        // Five standard deviations of the mean of 10^4 even numbers: 5 * 0.29 / 100.
        assert!((mean - 0.5).abs() < 0.015, "{mean}");
    }
}
