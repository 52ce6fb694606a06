//! How fast is flattening, per vertex made?
#![allow(missing_docs, reason = "the macros of criterion make undocumented functions")]
#![allow(clippy::unwrap_used, reason = "the data are ours")]

mod data;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use cyclide::{
    curve::{BlendVariant, ParamCurve},
    mesh::{flatten, flatten_into},
    model::Lower,
};
use std::hint::black_box;

fn flattening(c: &mut Criterion) {
    let arcs = data::arcs(500);
    let rational = data::blends(1000, BlendVariant::Rational);
    let (chain, _) = rational.to_chain(1e-6).unwrap();
    let curves: [(&str, &dyn ParamCurve); 3] =
        [("1000 arcs", &arcs), ("circle spline, 1000 segments", &rational), ("the same as NURBS", &chain)];
    let mut group = c.benchmark_group("flattening");
    for (name, curve) in curves {
        for tolerance in [1e-2, 1e-5] {
            let mut vertices = flatten(curve, tolerance).unwrap();
            group.throughput(Throughput::Elements(vertices.len() as u64));
            group.bench_function(BenchmarkId::new(name, tolerance), |b| {
                b.iter(|| flatten_into(black_box(curve), tolerance, &mut vertices));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, flattening);
criterion_main!(benches);
