//! Ordinary and awkward lists of points, and curves through or near them.

use super::objects::through;
use super::{Objects, Random};

pub(super) type Points = Vec<[f64; 3]>;

pub(super) fn object(random: &mut Random) -> Objects {
    let count = random.pick(&[2, 3, 3, 4, 5, 6, 8, 12, 20, 40]);
    let points = list(random, count);
    through(random, points)
}

/// A list of about `n` points, in a plane or in space.
pub(super) fn list(random: &mut Random, n: usize) -> Points {
    let mut points = family(random, n);
    if random.chance(0.5) {
        points.iter_mut().for_each(|p| p[2] = 0.0);
    }
    points
}

fn family(random: &mut Random, n: usize) -> Points {
    let turn = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
    match random.below(12) {
        0 => (0..n).map(|_| random.vector()).collect(),
        1 => (0..n).map(|_| [random.number(), random.number(), random.number()]).collect(),
        2 => walk(random, n),
        3 => {
            let h = random.decades(-3.0, 1.0);
            (0..n).map(|i| [i as f64 * h, (i % 2) as f64, 0.3 * ((i / 2) % 2) as f64]).collect()
        }
        4 => stairs(random, n),
        5 => (0..n).map(|i| [turn(i).cos(), turn(i).sin(), 0.0]).collect(),
        6 => (0..n).map(|i| [(0.5 * i as f64).cos(), (0.5 * i as f64).sin(), 0.1 * i as f64]).collect(),
        7 => (0..n).map(|i| [turn(i).sin(), (2.0 * turn(i)).sin(), 0.0]).collect(),
        8 => {
            let s = random.decades(-4.0, -1.0);
            let wave = |i: usize| [0.1 * i as f64, (0.1 * i as f64).sin(), 0.0];
            (0..n).map(|i| wave(i).map(|v| v + s * random.normal())).collect()
        }
        9 => {
            let e = random.decades(-16.0, -3.0);
            (0..n).map(|i| [i as f64, e * random.normal(), e * random.normal()]).collect()
        }
        10 => (0..n).map(|_| [0, 1, 2].map(|_| random.below(5) as f64)).collect(),
        _ => uneven(random, n),
    }
}

fn walk(random: &mut Random, n: usize) -> Points {
    let mut p = [0.0; 3];
    (0..n)
        .map(|_| {
            let step = random.vector();
            p = [p[0] + step[0], p[1] + step[1], p[2] + step[2]];
            p
        })
        .collect()
}

fn stairs(random: &mut Random, n: usize) -> Points {
    let mut p = [0.0; 3];
    (0..n)
        .map(|i| {
            p[i % 3] += random.pick(&[1.0, 1.0, 2.0, -1.0]);
            p
        })
        .collect()
}

/// Steps of very different lengths.
fn uneven(random: &mut Random, n: usize) -> Points {
    let (mut p, mut angle) = ([0.0; 3], 0.0_f64);
    let span = random.between(0.5, 6.0);
    (0..n)
        .map(|_| {
            let d = random.decades(-span, span);
            angle += 0.6 * random.normal();
            let here = p;
            p = [p[0] + d * angle.cos(), p[1] + d * angle.sin(), p[2] + 0.3 * d * random.normal()];
            here
        })
        .collect()
}
