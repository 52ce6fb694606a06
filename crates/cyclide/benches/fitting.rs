//! How fast are arc fits and fair fits, per point of the input?
#![allow(missing_docs, reason = "the macros of criterion make undocumented functions")]
#![allow(clippy::unwrap_used, reason = "the data are ours")]

mod data;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use cyclide::construct::{ArcFit, ArcFitOptions, Effort, FairFit, FairFitOptions};
use std::hint::black_box;

fn fitting(c: &mut Criterion) {
    let points = data::track(1000);
    let mut group = c.benchmark_group("fitting");
    group.sample_size(10);
    group.throughput(Throughput::Elements(points.len() as u64));
    for effort in [Effort::Fast, Effort::Default] {
        for tolerance in [0.5, 0.05] {
            let mut options = ArcFitOptions::new(tolerance);
            options.closed = true;
            options.effort = effort;
            group.bench_function(BenchmarkId::new(format!("{effort:?}"), tolerance), |b| {
                b.iter(|| ArcFit::new(black_box(&points), &options));
            });
        }
    }
    for tolerance in [0.5, 0.05] {
        let options = FairFitOptions { closed: true, ..FairFitOptions::new(tolerance) };
        group.bench_function(BenchmarkId::new("Fair", tolerance), |b| {
            b.iter(|| FairFit::new(black_box(&points), &options));
        });
    }
    group.finish();
}

criterion_group!(benches, fitting);
criterion_main!(benches);
