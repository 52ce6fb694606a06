//! Numbers in messages: as many digits as a person reads.

use std::fmt;

/// A number as people write it: five digits, without an exponent from a thousandth to ten millions, else three digits and
/// an exponent; zeros at the end are left out. With `{:#}` all digits that tell it from its neighbors. For messages and
/// reports, not for files.
///
/// ```
/// use cyclide::ShortNumber;
/// let texts = [2.459, 0.72972559596, -123456.7, 1e-9, 4.4409e-16].map(|v| ShortNumber(v).to_string());
/// assert_eq!(texts, ["2.459", "0.72973", "-123457", "1e-9", "4.44e-16"]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShortNumber(pub f64);

/// More than a number may change where its digits are cut: five of them count, and three of very small and very large ones.
const CUT: f64 = 1e-4;
const CUT_OF_FEW: f64 = 1e-2;

impl ShortNumber {
    /// A number that is to be typed as a lower limit: what is shown is no less than the value.
    pub(crate) fn no_less(value: f64) -> Self {
        Self(value + cut(value))
    }

    /// A number that is to be typed as an upper limit: what is shown is no more than the value.
    pub(crate) fn no_more(value: f64) -> Self {
        Self(value - cut(value))
    }
}

impl fmt::Display for ShortNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        let size = value.abs();
        if value == 0.0 {
            return f.write_str("0");
        }
        if value.is_nan() {
            return f.write_str("not a number");
        }
        if size.is_infinite() {
            return f.write_str(if value > 0.0 { "infinite" } else { "-infinite" });
        }
        if f.alternate() {
            return if (1e-5..1e16).contains(&size) { write!(f, "{value}") } else { write!(f, "{value:e}") };
        }
        if (1e-3..1e7).contains(&size) {
            // Digits behind the point so that five count, but none invented for large numbers.
            let digits = (4 - size.log10().floor() as i32).clamp(0, 7) as usize;
            return f.write_str(trimmed(&format!("{value:.digits$}")));
        }
        let text = format!("{value:.2e}");
        let (mantissa, exponent) = text.split_at(text.find('e').unwrap_or(text.len()));
        write!(f, "{}{exponent}", trimmed(mantissa))
    }
}

fn cut(value: f64) -> f64 {
    let size = value.abs();
    size * if (2e-3..5e6).contains(&size) { CUT } else { CUT_OF_FEW }
}

/// Without zeros at the end of a fraction.
fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::ShortNumber;

    #[test]
    fn numbers_to_type_keep_to_their_side() {
        for value in [3.42148, 6.48194, 0.012_345_67, 9.999_99e-4, 123_456.789] {
            let shown = |number: ShortNumber| number.to_string().parse::<f64>().unwrap();
            assert!(shown(ShortNumber::no_less(value)) >= value && shown(ShortNumber::no_more(value)) <= value);
        }
    }

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (100.0, "100"),
            (5134.2671, "5134.3"),
            (0.08214567, "0.082146"),
            (0.001, "0.001"),
            (-0.5, "-0.5"),
            (123456.7, "123457"),
            (1.25e9, "1.25e9"),
            (1e300, "1e300"),
            (4.4e-16, "4.4e-16"),
            (-1e-9, "-1e-9"),
            (f64::INFINITY, "infinite"),
            (f64::NEG_INFINITY, "-infinite"),
            (f64::NAN, "not a number"),
        ] {
            assert_eq!(ShortNumber(value).to_string(), text);
        }
    }

    #[test]
    fn all_digits_where_they_matter() {
        for (value, text) in [(0.0, "0"), (0.123456789, "0.123456789"), (-1e150, "-1e150"), (4.5e-7, "4.5e-7")] {
            assert_eq!(format!("{:#}", ShortNumber(value)), text);
        }
    }
}
