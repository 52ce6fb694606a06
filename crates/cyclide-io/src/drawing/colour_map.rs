//! Colors for numbers. Equal steps of a number are equal steps to the eye: the colors run along straight lines of Oklab (B. Ottosson,
//! 2020) with lightness falling all the way, so that they are told apart without hue too, in print and by eyes that miss red or green.

/// Which colors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ramp {
    /// From pale yellow over green to dark violet.
    Sequential,
    /// From blue over pale grey, in the middle, to red.
    Diverging,
}

/// Lightness, chroma, and hue in degrees, of the colors that a ramp runs through.
const SEQUENTIAL: [[f64; 3]; 4] = [[0.95, 0.075, 105.0], [0.79, 0.12, 148.0], [0.59, 0.09, 222.0], [0.39, 0.13, 290.0]];
const DIVERGING: [[f64; 3]; 3] = [[0.47, 0.13, 255.0], [0.955, 0.006, 100.0], [0.47, 0.13, 35.0]];

impl Ramp {
    /// The color at a place from 0 to 1, in linear light.
    pub(crate) fn linear(self, place: f64) -> [f64; 3] {
        let stops: Vec<[f64; 3]> = match self {
            Self::Sequential => SEQUENTIAL.map(lab).to_vec(),
            Self::Diverging => DIVERGING.map(lab).to_vec(),
        };
        // By length, so that steps are equal from line to line.
        let lengths: Vec<f64> = stops.windows(2).map(|ends| distance(ends[0], ends[1])).collect();
        let mut rest = place.clamp(0.0, 1.0) * lengths.iter().sum::<f64>();
        let last = lengths.len() - 1;
        for (k, length) in lengths.iter().enumerate() {
            if rest <= *length || k == last {
                let part = (rest / length).min(1.0);
                return light(std::array::from_fn(|i| stops[k][i] + (stops[k + 1][i] - stops[k][i]) * part));
            }
            rest -= length;
        }
        light(stops[0])
    }

    /// The colors at so many even places from 0 to 1, in linear light.
    pub(crate) fn table(self, count: usize) -> Vec<[f64; 3]> {
        (0..count).map(|k| self.linear(k as f64 / (count - 1) as f64)).collect()
    }
}

fn lab([lightness, chroma, hue]: [f64; 3]) -> [f64; 3] {
    let (sine, cosine) = hue.to_radians().sin_cos();
    [lightness, chroma * cosine, chroma * sine]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt()
}

/// Linear light of a color in Oklab.
fn light([l, a, b]: [f64; 3]) -> [f64; 3] {
    let cones = [
        l + 0.396_337_777_4 * a + 0.215_803_757_3 * b,
        l - 0.105_561_345_8 * a - 0.063_854_172_8 * b,
        l - 0.089_484_177_5 * a - 1.291_485_548_0 * b,
    ]
    .map(|v| v * v * v);
    let row = |m: [f64; 3]| m.iter().zip(cones).map(|(m, c)| m * c).sum::<f64>();
    [
        row([4.076_741_662_1, -3.307_711_591_3, 0.230_969_929_2]),
        row([-1.268_438_004_6, 2.609_757_401_1, -0.341_319_396_5]),
        row([-0.004_196_086_3, -0.703_418_614_7, 1.707_614_701_0]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ramps_stay_within_the_colours_of_a_screen_and_step_evenly() {
        for ramp in [Ramp::Sequential, Ramp::Diverging] {
            let colours = ramp.table(101);
            assert!(colours.iter().flatten().all(|v| (0.0..=1.0).contains(v)), "{ramp:?}");
            // Luminance falls all along, or to both ends.
            let y: Vec<f64> = colours.iter().map(|[r, g, b]| 0.2126 * r + 0.7152 * g + 0.0722 * b).collect();
            let falls = |y: &[f64]| y.windows(2).all(|pair| pair[1] < pair[0]);
            match ramp {
                Ramp::Sequential => assert!(falls(&y)),
                Ramp::Diverging => {
                    let back: Vec<f64> = y[..=50].iter().rev().copied().collect();
                    assert!(falls(&y[50..]) && falls(&back));
                    // Both ends are equally dark: neither sign is favored.
                    assert!((y[0] / y[100] - 1.0).abs() < 0.25, "{} {}", y[0], y[100]);
                }
            }
        }
    }
}
