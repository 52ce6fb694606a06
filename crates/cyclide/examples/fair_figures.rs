//! The fairness of splines through the same points: sign changes and extrema of curvature, its variation, its largest value,
//! its total variation, and its largest jump at a joint.
//!
//! `cargo run --release --example fair_figures -- examples/track.csv,closed tracks/Austin.csv,closed,every=20` reads the first
//! columns of each file, contour by contour; the shapes `star` and `spiral` are built in. Curvature is signed in the plane `z = 0`,
//! where 64 samples per segment are taken; variation is that of curvature squared over arc length, times the cube of the length.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3,
    construct::{FairEnd, FairSplineOptions},
    curve::{CircleSpline, CircleSplineOptions, ParamCurve, joints},
};
use std::error::Error;

/// Samples per segment.
const SAMPLES: u32 = 64;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "{:22} {:16} {:>5} {:>5} {:>10} {:>8} {:>8} {:>9}",
        "data", "spline", "signs", "extr.", "variation", "largest", "total", "jump"
    );
    for argument in std::env::args().skip(1) {
        let mut words = argument.split(',');
        let name = words.next().unwrap_or_default();
        let (mut closed, mut every, mut most) = (false, 1, usize::MAX);
        for word in words {
            match word.split_once('=') {
                None if word == "closed" => closed = true,
                Some(("every", number)) => every = number.parse()?,
                Some(("most", number)) => most = number.parse()?,
                _ => return Err(format!("no option {word}").into()),
            }
        }
        for points in contours(name)? {
            let points: Vec<Point3> = points.into_iter().step_by(every).take(most).collect();
            let label = format!("{} ({})", name.rsplit('/').next().unwrap_or(name), points.len());
            compare(&label, &points, closed)?;
        }
    }
    Ok(())
}

/// A row for each spline through the points.
fn compare(name: &str, points: &[Point3], closed: bool) -> Result<(), Box<dyn Error>> {
    let fair = FairSplineOptions { closed, ..Default::default() };
    let arcs = FairSplineOptions { ends: [FairEnd::Arc; 2], straight_runs: false, ..fair.clone() };
    row(name, "fair", &CircleSpline::fair(points, &fair)?);
    row("", "fair, plain", &CircleSpline::fair(points, &arcs)?);
    let order2 = CircleSplineOptions { closed, ..Default::default() };
    row("", "circle, order 2", &CircleSpline::from_points(points, &order2)?);
    Ok(())
}

fn row(name: &str, kind: &str, spline: &CircleSpline) {
    let planar = spline.segments().iter().all(|s| s.start().z == 0.0 && s.end().z == 0.0);
    let (mut signs, mut extrema, mut variation, mut length, mut total, mut largest) = (0, 0, 0.0, 0.0, 0.0, 0.0_f64);
    let (mut last, mut slope): (Option<f64>, f64) = (None, 0.0);
    let mut first_sign = 0.0;
    for piece in 0..spline.piece_count() {
        let mut before: Option<(f64, Point3)> = None;
        for i in 0..=SAMPLES {
            let jet = spline.piece_jet(piece, f64::from(i) / f64::from(SAMPLES));
            let size = jet.curvature().unwrap_or(f64::NAN);
            let k = if planar { size.copysign(jet.d1.cross(jet.d2).z) } else { size };
            largest = largest.max(size);
            if let Some((k0, p0)) = before {
                let step = p0.distance(jet.point);
                length += step;
                variation += (k - k0) * (k - k0) / step;
                total += (k - k0).abs();
                // Changes that are rounding count for nothing.
                if (k - k0).abs() > 1e-12 * largest {
                    extrema += usize::from((k - k0) * slope < 0.0);
                    slope = k - k0;
                }
            }
            before = Some((k, jet.point));
            if k.abs() > 1e-9 * largest {
                signs += usize::from(last.is_some_and(|last: f64| last * k < 0.0));
                if last.is_none() {
                    first_sign = k;
                }
                last = Some(k);
            }
        }
    }
    if spline.is_closed() {
        signs += usize::from(last.is_some_and(|last| last * first_sign < 0.0));
        extrema += extrema % 2;
    }
    let jump = joints(spline).iter().map(|j| j.curvature_jump).fold(0.0, f64::max);
    println!(
        "{name:22} {kind:16} {signs:5} {extrema:5} {:10.3e} {largest:8.4} {total:8.3} {jump:9.1e}  {}",
        variation * length.powi(3),
        spline
            .warnings()
            .iter()
            .map(|w| w.reason())
            .collect::<std::collections::BTreeSet<_>>()
            .into_iter()
            .collect::<Vec<_>>()
            .join(" ")
    );
}

/// The contours of a file of points, or a shape.
fn contours(name: &str) -> Result<Vec<Vec<Point3>>, Box<dyn Error>> {
    let turn = std::f64::consts::TAU;
    if name == "star" {
        let at = |i: i32| {
            let (r, a) = (if i % 2 == 0 { 1.0 } else { 0.35 }, turn * f64::from(i) / 10.0);
            Point3::new(r * a.cos(), r * a.sin(), 0.0)
        };
        return Ok(vec![(0..10).map(at).collect()]);
    }
    if name == "spiral" {
        let at = |i: i32| {
            let a = turn * f64::from(i) / 8.0;
            let r = (0.35 * a).exp();
            Point3::new(r * a.cos(), r * a.sin(), 0.0)
        };
        return Ok(vec![(0..9).map(at).collect()]);
    }
    let mut contours = vec![Vec::new()];
    for line in std::fs::read_to_string(name)?.lines() {
        if line.trim().is_empty() {
            contours.push(Vec::new());
        }
        // A header is no row of numbers; the planar files have further columns.
        let numbers: Vec<f64> = line.split([',', ';', ' ']).map_while(|field| field.trim().parse().ok()).collect();
        let last = contours.len() - 1;
        match numbers[..] {
            [x, y, z] if !name.contains("logo") => contours[last].push(Point3::new(x, y, z)),
            [x, y, ..] => contours[last].push(Point3::new(x, y, 0.0)),
            _ => {}
        }
    }
    contours.retain(|c| c.len() > 2);
    Ok(contours)
}
