//! How fast are points and jets of each kind of curve?
#![allow(missing_docs, reason = "the macros of criterion make undocumented functions")]
#![allow(clippy::unwrap_used, reason = "the data are ours")]

mod data;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use cyclide::{
    CurveJet, Point3,
    curve::{BlendVariant, ParamCurve},
    model::Lower,
};
use std::hint::black_box;

/// Parameters per call.
const COUNT: usize = 10_000;

fn evaluation(c: &mut Criterion) {
    let arcs = data::arcs(500);
    let rational = data::blends(1000, BlendVariant::Rational);
    let trigonometric = data::blends(1000, BlendVariant::Trigonometric);
    let (chain, _) = rational.to_chain(1e-6).unwrap();
    let curves: [(&str, &dyn ParamCurve); 5] = [
        ("arc", &arcs.arcs()[0]),
        ("1000 arcs", &arcs),
        ("circle spline, rational", &rational),
        ("circle spline, trigonometric", &trigonometric),
        ("the rational one as NURBS", &chain),
    ];
    let ts: Vec<f64> = (0..COUNT).map(|i| i as f64 / COUNT as f64).collect();
    let (mut points, mut jets) = (vec![Point3::ORIGIN; COUNT], vec![CurveJet::default(); COUNT]);
    let mut group = c.benchmark_group("evaluation");
    group.throughput(Throughput::Elements(COUNT as u64));
    for (name, curve) in curves {
        group.bench_function(BenchmarkId::new("points", name), |b| {
            b.iter(|| curve.points_into(black_box(&ts), &mut points));
        });
        group.bench_function(BenchmarkId::new("jets", name), |b| {
            b.iter(|| curve.jets_into(black_box(&ts), &mut jets));
        });
    }
    group.finish();
}

criterion_group!(benches, evaluation);
criterion_main!(benches);
