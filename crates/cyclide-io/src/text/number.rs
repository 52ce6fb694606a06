//! Numbers as text: the shortest digits that read back to the same double, negative zero as zero.

use std::fmt::Write as _;
use std::num::FpCategory;

/// Magnitudes in this range are written without an exponent.
const PLAIN: std::ops::Range<f64> = 1e-5..1e16;

/// Shortest text: `0.1`, `-3`, `1e-7`. For SVG, CSV and anything that reads C-style numbers.
pub(crate) fn push_plain(out: &mut String, v: f64) {
    // Writing to a string cannot fail.
    let _ = if v == 0.0 {
        out.push('0');
        Ok(())
    } else if PLAIN.contains(&v.abs()) {
        write!(out, "{v}")
    } else {
        write!(out, "{v:e}")
    };
}

/// Shortest texts with blanks between them.
pub(crate) fn push_spaced(out: &mut String, numbers: impl IntoIterator<Item = f64>) {
    for (k, number) in numbers.into_iter().enumerate() {
        if k > 0 {
            out.push(' ');
        }
        push_plain(out, number);
    }
}

/// What is said of a number that [`vanishes`].
pub(crate) const NEARER_TO_ZERO: &str = "is nearer to 0 than any number that can be read: write 0 if that is meant";

/// True for a number that was read as 0 and is written with a figure other than 0.
pub(crate) fn vanishes(text: &str, read: f64) -> bool {
    let figures = text.split(['e', 'E']).next().unwrap_or_default();
    read.classify() == FpCategory::Zero && figures.contains(|c| matches!(c, '1'..='9'))
}

/// Part 21 REAL: a decimal point always, a capital E: `0.`, `0.1`, `-3.`, `1.E-7`.
pub(crate) fn push_step(out: &mut String, v: f64) {
    push_pointed(out, v, "");
}

/// DXF real: a decimal point always, with a digit behind it: `0.0`, `-3.0`, `1.0E-7`.
pub(crate) fn push_dxf(out: &mut String, v: f64) {
    push_pointed(out, v, "0");
}

/// A number with a decimal point; `fill` follows a point that has no digits of its own.
fn push_pointed(out: &mut String, v: f64, fill: &str) {
    if v == 0.0 {
        out.push_str("0.");
        out.push_str(fill);
        return;
    }
    // Writing to a string cannot fail.
    let start = out.len();
    if PLAIN.contains(&v.abs()) {
        let _ = write!(out, "{v}");
        if !out[start..].contains('.') {
            out.push('.');
            out.push_str(fill);
        }
        return;
    }
    let text = format!("{v:E}");
    let (digits, exponent) = text.find('E').map_or((text.as_str(), ""), |i| text.split_at(i));
    out.push_str(digits);
    if !digits.contains('.') {
        out.push('.');
        out.push_str(fill);
    }
    out.push_str(exponent);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(push: fn(&mut String, f64), v: f64) -> String {
        let mut out = String::new();
        push(&mut out, v);
        out
    }

    #[test]
    fn forms() {
        let cases = [
            (0.0, "0", "0.", "0.0"),
            (-0.0, "0", "0.", "0.0"),
            (-3.0, "-3", "-3.", "-3.0"),
            (0.1, "0.1", "0.1", "0.1"),
            (1e-7, "1e-7", "1.E-7", "1.0E-7"),
            (1.5e22, "1.5e22", "1.5E22", "1.5E22"),
        ];
        for (v, plain, step, dxf) in cases {
            assert_eq!(text(push_plain, v), plain);
            assert_eq!(text(push_step, v), step);
            assert_eq!(text(push_dxf, v), dxf);
        }
    }

    #[test]
    fn every_form_reads_back_to_the_same_double() {
        let mut state = 1_u64;
        for _ in 0..20_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let v = f64::from_bits(state);
            if !v.is_finite() {
                continue;
            }
            for push in [push_plain, push_step, push_dxf] {
                let back: f64 = text(push, v).parse().unwrap();
                assert!(back.to_bits() == v.to_bits() || v == 0.0, "{v:e}");
            }
        }
    }
}
