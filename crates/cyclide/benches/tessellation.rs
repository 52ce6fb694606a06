//! How fast is tessellation, per vertex made?
#![allow(missing_docs, reason = "the macros of criterion make undocumented functions")]
#![allow(clippy::unwrap_used, reason = "the data are ours")]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use cyclide::{mesh::tessellate, surface::DupinCyclide, topology::Body};
use std::hint::black_box;

fn tessellation(c: &mut Criterion) {
    let ring = |a: f64, c: f64, mu: f64| DupinCyclide::new(a, c, mu).unwrap();
    let bodies = [
        ("torus, 16 patches", ring(2.0, 0.0, 0.5).to_bodies([4, 4]).unwrap()),
        ("ring, 1600 patches", ring(2.0, 0.7, 1.0).to_bodies([40, 40]).unwrap()),
    ];
    let mut group = c.benchmark_group("tessellation");
    group.sample_size(20);
    for (name, bodies) in &bodies {
        let body: &Body = &bodies[0];
        for tolerance in [1e-2, 1e-4] {
            let mesh = tessellate(body, tolerance).unwrap();
            group.throughput(Throughput::Elements(mesh.positions.len() as u64));
            group.bench_function(BenchmarkId::new(*name, tolerance), |b| {
                b.iter(|| tessellate(black_box(body), tolerance));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, tessellation);
criterion_main!(benches);
