//! Twice continuously differentiable cubics over the chords, in B-splines: to first order the displacements of a
//! fair spline whose nodes move (`docs/math/fair-fits.md#linear-model`; `docs/math/fair-splines.md#why-free-tangents`:
//! for small angles the fair spline is that cubic).
//!
//! One function belongs to each node, and on a segment at most four are not zero: those of the nodes from the one
//! before the segment to the one after it. Open ends have no third derivative, as the arcs that end a fair spline
//! have none; the first function is then the value at the first node, and the last one that at the last.

/// A polynomial of a segment's own parameter in `[0, 1]`, rising powers.
pub(super) type Cubic = [f64; 4];

/// On each segment the four functions of the nodes `segment - 1` to `segment + 2`.
pub(super) fn functions(chords: &[f64], closed: bool) -> Vec<[Cubic; 4]> {
    let m = chords.len();
    match (closed, m) {
        (true, _) => (0..m).map(|j| bsplines(std::array::from_fn(|i| chords[(j + i + m - 2) % m]))).collect(),
        // One function for each node is a polynomial over all of the curve here.
        (false, 0..=2) => low_degree(chords),
        (false, _) => open(chords),
    }
}

/// The four cubic B-splines on the middle one of five knot intervals, of which the outer ones may be empty.
fn bsplines([h0, h1, h, h3, h4]: [f64; 5]) -> [Cubic; 4] {
    let (t, tt) = (h1 + h, h1 + h + h3);
    let m00 = h * h / (t * (h0 + t));
    let m02 = h1 * h1 / (tt * t);
    let m12 = 3.0 * h * h1 / (tt * t);
    let m22 = 3.0 * h * h / (tt * t);
    let m33 = h * h / ((h + h3 + h4) * (h + h3));
    let m32 = -m22 / 3.0 - m33 - h * h / ((h + h3) * tt);
    [
        [m00, -3.0 * m00, 3.0 * m00, -m00],
        [1.0 - m00 - m02, 3.0 * m00 - m12, -3.0 * m00 - m22, m00 - m32 - m33],
        [m02, m12, m22, m32],
        [0.0, 0.0, 0.0, m33],
    ]
}

/// Four nodes or more. Of the functions for clamped knots the second and the last but one are written by the others
/// so that the third derivative vanishes on the end segments.
fn open(chords: &[f64]) -> Vec<[Cubic; 4]> {
    let m = chords.len();
    let chord = |j: usize| if (2..m + 2).contains(&j) { chords[j - 2] } else { 0.0 };
    let mut all: Vec<[Cubic; 4]> = (0..m).map(|j| bsplines(std::array::from_fn(|i| chord(j + i)))).collect();
    let start = all[0].map(|f| f[3]);
    let end = all[m - 1].map(|f| f[3]);
    // Node `i` keeps the function `i + 1`, the end nodes keep the first and the last.
    let first = [-start[0] / start[1], -start[2] / start[1], -start[3] / start[1]];
    let last = [-end[0] / end[2], -end[1] / end[2], -end[3] / end[2]];
    for (j, functions) in all.iter_mut().enumerate() {
        // Function `f` of the clamped ones is `functions[f - j]` here.
        let mut nodes = [[0.0; 4]; 4];
        for (local, cubic) in functions.iter().enumerate() {
            let f = j + local;
            let mut give = |node: usize, weight: f64| add(&mut nodes[node + 1 - j], cubic, weight);
            if f == 0 {
                give(0, 1.0);
            } else if f == 1 {
                (0..3).for_each(|node| give(node, first[node]));
            } else if f == m + 1 {
                (0..3).for_each(|node| give(m - 2 + node, last[node]));
            } else if f == m + 2 {
                give(m, 1.0);
            } else {
                give(f - 1, 1.0);
            }
        }
        *functions = nodes;
    }
    all
}

/// Two or three nodes: a straight line or one parabola for all of the curve, in Bernstein form.
fn low_degree(chords: &[f64]) -> Vec<[Cubic; 4]> {
    let total: f64 = chords.iter().sum();
    let mut from = 0.0;
    let mut all = Vec::with_capacity(chords.len());
    for (j, h) in chords.iter().enumerate() {
        let s = [from / total, h / total];
        let r = [1.0 - s[0], -s[1]];
        let product = |a: [f64; 2], b: [f64; 2]| [a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[1] * b[1], 0.0];
        let line = |a: [f64; 2]| [a[0], a[1], 0.0, 0.0];
        let mut nodes = [[0.0; 4]; 4];
        if chords.len() == 1 {
            nodes[1] = line(r);
            nodes[2] = line(s);
        } else {
            nodes[1 - j] = product(r, r);
            nodes[2 - j] = product(s, r).map(|c| 2.0 * c);
            nodes[3 - j] = product(s, s);
        }
        all.push(nodes);
        from += h;
    }
    all
}

fn add(sum: &mut Cubic, cubic: &Cubic, weight: f64) {
    for (s, c) in sum.iter_mut().zip(cubic) {
        *s += weight * c;
    }
}

/// Value of a polynomial.
pub(super) fn value(c: &Cubic, u: f64) -> f64 {
    c[0] + u * (c[1] + u * (c[2] + u * c[3]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHORDS: [f64; 7] = [1.0, 0.5, 2.0, 2.5, 0.25, 1.5, 3.0];

    /// Value and three derivatives by length.
    fn jet(c: &Cubic, u: f64, h: f64) -> [f64; 4] {
        [
            value(c, u),
            (c[1] + u * (2.0 * c[2] + 3.0 * u * c[3])) / h,
            (2.0 * c[2] + 6.0 * u * c[3]) / (h * h),
            6.0 * c[3] / (h * h * h),
        ]
    }

    #[test]
    fn joints_keep_value_slope_and_second_derivative() {
        for (closed, count) in [(false, 1), (false, 2), (false, 3), (false, 4), (false, 7), (true, 4), (true, 7)] {
            let chords = &CHORDS[..count];
            let all = functions(chords, closed);
            let nodes = if closed { count } else { count + 1 };
            // The spline with one coefficient per node, as jets at both ends of each segment.
            for node in 0..nodes {
                let at = |j: usize, u: f64| {
                    (0..4).fold([0.0; 4], |mut sum, slot| {
                        let k = j as isize + slot as isize - 1;
                        let k = if closed { k.rem_euclid(nodes as isize) } else { k };
                        if k == node as isize {
                            for (s, x) in sum.iter_mut().zip(jet(&all[j][slot], u, chords[j])) {
                                *s += x;
                            }
                        }
                        sum
                    })
                };
                let joints = if closed { count } else { count - 1 };
                for j in 0..joints {
                    let (a, b) = (at(j, 1.0), at((j + 1) % count, 0.0));
                    for d in 0..3 {
                        // Coefficients up to 1/h³ = 64 and cancellation among a few of them.
                        assert!((a[d] - b[d]).abs() < 1e-12, "{closed} {count} node {node} joint {j}: {a:?} {b:?}");
                    }
                }
                if !closed {
                    assert!(at(0, 0.0)[3].abs() < 1e-12 && at(count - 1, 1.0)[3].abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn constants_are_reproduced_and_open_ends_have_the_value_of_their_node() {
        for (closed, count) in [(false, 1), (false, 2), (false, 3), (false, 7), (true, 4), (true, 7)] {
            for (j, f) in functions(&CHORDS[..count], closed).iter().enumerate() {
                for u in [0.0, 0.3, 1.0] {
                    let sum: f64 = f.iter().map(|c| value(c, u)).sum();
                    assert!((sum - 1.0).abs() < 1e-13, "{closed} {count} segment {j}");
                }
                if !closed && j == 0 {
                    assert!((value(&f[1], 0.0) - 1.0).abs() < 1e-15);
                }
                if !closed && j == count - 1 {
                    assert!((value(&f[2], 1.0) - 1.0).abs() < 1e-15);
                }
            }
        }
    }
}
