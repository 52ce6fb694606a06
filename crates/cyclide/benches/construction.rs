//! How fast are splines made from points, and lowered to exact rational splines?
#![allow(missing_docs, reason = "the macros of criterion make undocumented functions")]
#![allow(clippy::unwrap_used, reason = "the data are ours")]

mod data;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use cyclide::{
    construct::{ArcSplineOptions, FairSplineOptions},
    curve::{ArcPath, BlendVariant, CircleSpline, CircleSplineOptions},
    model::Lower,
};
use std::hint::black_box;

/// Points.
const COUNT: usize = 10_000;

fn construction(c: &mut Criterion) {
    let points = data::track(COUNT);
    let mut group = c.benchmark_group("construction");
    group.throughput(Throughput::Elements(COUNT as u64));
    let arcs = ArcSplineOptions { closed: true, ..Default::default() };
    group.bench_function("arc spline", |b| b.iter(|| ArcPath::spline(black_box(&points), &arcs)));
    for variant in [BlendVariant::Rational, BlendVariant::Trigonometric] {
        let options = CircleSplineOptions { closed: true, variant, ..Default::default() };
        group.bench_function(format!("circle spline, {variant:?}"), |b| {
            b.iter(|| CircleSpline::from_points(black_box(&points), &options));
        });
    }
    let options = FairSplineOptions { closed: true, ..Default::default() };
    group.bench_function("fair spline", |b| b.iter(|| CircleSpline::fair(black_box(&points), &options)));
    let spline = data::blends(COUNT, BlendVariant::Rational);
    group.bench_function("circle spline to exact NURBS", |b| b.iter(|| black_box(&spline).to_chain(1e-6)));
    group.finish();
}

criterion_group!(benches, construction);
criterion_main!(benches);
