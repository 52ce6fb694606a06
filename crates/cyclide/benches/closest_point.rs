//! How fast are closest points: near the curve, far from it, and the making of the index?
#![allow(missing_docs, reason = "the macros of criterion make undocumented functions")]
#![allow(clippy::unwrap_used, reason = "the data are ours")]

mod data;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use cyclide::{
    Point3, Vec3,
    curve::{BlendVariant, CurveIndex, ParamCurve},
    model::Lower,
};
use std::hint::black_box;

/// Queries per call.
const COUNT: usize = 1000;

fn closest_point(c: &mut Criterion) {
    let arcs = data::arcs(500);
    let rational = data::blends(1000, BlendVariant::Rational);
    let (chain, _) = rational.to_chain(1e-6).unwrap();
    let curves: [(&str, &dyn ParamCurve); 3] =
        [("1000 arcs", &arcs), ("circle spline, 1000 segments", &rational), ("the same as NURBS", &chain)];
    let mut group = c.benchmark_group("closest point");
    for (name, curve) in curves {
        let index = CurveIndex::new(curve);
        group.throughput(Throughput::Elements(curve.piece_count() as u64));
        group.bench_function(BenchmarkId::new("make the index", name), |b| {
            b.iter(|| CurveIndex::new(black_box(curve)));
        });
        group.throughput(Throughput::Elements(COUNT as u64));
        // On the curve but for 1e-9 of its size, a curve's width off, and all over its box.
        for (place, offset) in [("on", 1e-6), ("near", 5.0), ("far", 200.0)] {
            let queries: Vec<Point3> = (0..COUNT)
                .map(|i| {
                    let t = (i as f64 * 0.618_033_988_7).fract();
                    let angle = i as f64 * 2.4;
                    curve.point(t) + Vec3::new(angle.cos(), angle.sin(), 0.3) * offset
                })
                .collect();
            group.bench_function(BenchmarkId::new(place, name), |b| {
                b.iter(|| queries.iter().map(|p| index.closest_point(black_box(*p)).distance).sum::<f64>());
            });
        }
    }
    group.finish();
}

criterion_group!(benches, closest_point);
criterion_main!(benches);
