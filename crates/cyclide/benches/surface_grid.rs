//! How fast are points and unit normals of a patch on a grid?
#![allow(missing_docs, reason = "the macros of criterion make undocumented functions")]
#![allow(clippy::unwrap_used, reason = "the data are ours")]

#[path = "../examples/torus_grid/mod.rs"]
mod torus_grid;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use cyclide::surface::ParamSurface;
use std::hint::black_box;

/// Parameters in each direction.
const COUNT: usize = 1000;

fn surface_grid(c: &mut Criterion) {
    let patch = torus_grid::patch().unwrap();
    let s = torus_grid::parameters(COUNT);
    let mut group = c.benchmark_group("surface grid");
    group.throughput(Throughput::Elements((COUNT * COUNT) as u64)).sample_size(20);
    let mut kept = vec![0.0; 6 * COUNT * COUNT];
    group.bench_function("points, kept buffer", |b| {
        b.iter(|| torus_grid::points(&patch, black_box(&s), &mut kept[..3 * COUNT * COUNT]));
    });
    group.bench_function("points, fresh buffer", |b| {
        b.iter(|| torus_grid::fresh_points(&patch, black_box(&s)));
    });
    group.bench_function("points and normals, kept buffer", |b| {
        let (points, normals) = kept.split_at_mut(3 * COUNT * COUNT);
        b.iter(|| torus_grid::points_and_normals(&patch, black_box(&s), points, normals));
    });
    group.bench_function("points and normals, fresh buffers", |b| {
        b.iter(|| torus_grid::fresh_points_and_normals(&patch, black_box(&s)));
    });
    group.bench_function("points, one at a time", |b| {
        b.iter(|| s.iter().map(|t| s.iter().map(|s| patch.point(*s, *t).x).sum::<f64>()).sum::<f64>());
    });
    group.finish();
}

criterion_group!(benches, surface_grid);
criterion_main!(benches);
