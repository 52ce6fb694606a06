//! Points off a surface that continue those on it as smoothly as third differences say.

use crate::sparse_solver::SymmetricSum;
use cyclide::{Point3, Vec3};

/// Coefficients of third differences: along s, along t, and both mixed ones, by their places.
const THIRD: [f64; 4] = [-1.0, 3.0, -3.0, 1.0];
const SECOND: [f64; 3] = [1.0, -2.0, 1.0];
const FIRST: [f64; 2] = [-1.0, 1.0];

/// Gives the wanted points that are not known places, by least third differences over what is known or wanted; `None` if there is no
/// memory for it, or no solution in doubles.
pub(super) fn continued(points: &mut [Option<Point3>], wanted: &[bool], size: [usize; 2], closed: bool) -> Option<()> {
    let known = points.to_vec();
    let mut number = vec![None; known.len()];
    let mut count = 0;
    for k in (0..known.len()).filter(|k| known[*k].is_none() && wanted[*k]) {
        number[k] = Some(count);
        count += 1;
    }
    let mut sum = SymmetricSum::new(count);
    let mut right = vec![0.0; 3 * count];
    let at = |i: usize, j: usize| {
        let i = if closed { i % size[0] } else { i };
        let k = i + j * size[0];
        (i < size[0] && j < size[1] && (known[k].is_some() || wanted[k])).then_some(k)
    };
    let stencils: [(&[f64], &[f64]); 4] = [(&THIRD, &[1.0]), (&[1.0], &THIRD), (&SECOND, &FIRST), (&FIRST, &SECOND)];
    for (j, i) in (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| (j, i))) {
        for (along, across) in stencils {
            let places = across
                .iter()
                .enumerate()
                .flat_map(|(dj, b)| along.iter().enumerate().map(move |(di, a)| (at(i + di, j + dj), a * b)));
            let Some(terms) = places.map(|(k, a)| k.map(|k| (k, a))).collect::<Option<Vec<_>>>() else { continue };
            let fixed =
                terms.iter().fold(Vec3::ZERO, |v, (k, a)| v + known[*k].map_or(Vec3::ZERO, |p| p.to_vec() * *a));
            let free: Vec<(usize, f64)> = terms.iter().filter_map(|(k, a)| Some((number[*k]?, *a))).collect();
            sum.add_square(&free, 1.0);
            for (k, a) in free {
                (0..3).for_each(|c| right[c * count + k] -= a * fixed[c]);
            }
        }
    }
    if count == 0 {
        return Some(());
    }
    // Points that no difference reaches would have no equation.
    let mean = sum.mean_diagonal();
    (0..count).for_each(|k| sum.add(k, k, 1e-12 * mean));
    sum.factor()?.solve(&mut right)?;
    for (point, k) in points.iter_mut().zip(number) {
        if let Some(k) = k {
            *point = Some(Point3::new(right[k], right[count + k], right[2 * count + k]));
        }
    }
    Some(())
}
