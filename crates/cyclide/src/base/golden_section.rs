//! The lowest place between two others by sections in the golden ratio.
//!
//! Of a function that falls to one place and rises after it, each section leaves 0.618 of the interval and takes one value more: of both places inside
//! one is a place of the next interval, too (J. Kiefer, Proc. Amer. Math. Soc. 4 (1953), 502-506, in the limit of many sections).

/// An interval with two places inside.
pub(crate) struct GoldenSection<F> {
    value: F,
    ends: [f64; 2],
    inside: [f64; 2],
    values: [f64; 2],
}

impl<F: FnMut(f64) -> f64> GoldenSection<F> {
    pub(crate) fn new(mut value: F, [low, high]: [f64; 2]) -> Self {
        let step = ratio() * (high - low);
        let inside = [high - step, low + step];
        let values = inside.map(&mut value);
        Self { value, ends: [low, high], inside, values }
    }

    /// The middle after so many sections.
    pub(crate) fn lowest(value: F, ends: [f64; 2], sections: u32) -> f64 {
        let mut search = Self::new(value, ends);
        (0..sections).for_each(|_| search.section());
        0.5 * (search.ends[0] + search.ends[1])
    }

    /// Goes on with the part beside the lower one of both places inside.
    pub(crate) fn section(&mut self) {
        let ([x, y], [at_x, at_y]) = (self.inside, self.values);
        if at_x < at_y {
            self.ends[1] = y;
            let place = y - ratio() * (y - self.ends[0]);
            (self.inside, self.values) = ([place, x], [(self.value)(place), at_x]);
        } else {
            self.ends[0] = x;
            let place = x + ratio() * (self.ends[1] - x);
            (self.inside, self.values) = ([y, place], [at_y, (self.value)(place)]);
        }
    }

    /// Both places inside, with their values.
    pub(crate) fn inside(&self) -> [(f64, f64); 2] {
        [0, 1].map(|k| (self.inside[k], self.values[k]))
    }
}

fn ratio() -> f64 {
    0.5 * (5.0_f64.sqrt() - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_valley_is_found_with_one_value_for_each_section() {
        for lowest in [0.0, 0.3, 0.999, 1.0] {
            let mut count = 0;
            let valley = |x: f64| {
                count += 1;
                (x - lowest).abs()
            };
            assert!((GoldenSection::lowest(valley, [0.0, 1.0], 40) - lowest).abs() < 1e-8);
            assert_eq!(count, 42);
        }
    }
}
