//! How fast are points and Jacobians of a block on a grid, and the nodes and the quality of its cells?
#![allow(missing_docs, reason = "the macros of criterion make undocumented functions")]
#![allow(clippy::unwrap_used, reason = "the data are ours")]

#[path = "../examples/volume_rows/mod.rs"]
mod volume_rows;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use cyclide::{
    surface::DupinCyclide,
    volume::{CyclideGrid, CyclideVolume, Grading, StructuredGrid},
};
use std::hint::black_box;

/// Parameters in each direction.
const COUNT: usize = 100;

fn volume_grid(c: &mut Criterion) {
    let block = volume_rows::block().unwrap();
    let s = volume_rows::parameters(COUNT);
    let mut group = c.benchmark_group("volume grid");
    group.throughput(Throughput::Elements(COUNT.pow(3) as u64)).sample_size(20);
    let mut kept = vec![0.0; 4 * COUNT.pow(3)];
    group.bench_function("points and Jacobians, kept buffer", |b| {
        b.iter(|| volume_rows::rows(&block, black_box(&s), &mut kept));
    });
    group.bench_function("points and Jacobians, one at a time", |b| {
        b.iter(|| volume_rows::one_by_one(&block, black_box(&s)));
    });
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap();
    let wall: Vec<CyclideVolume> = CyclideGrid::of_cyclide(&ring, [8, 8], &[-0.5, 0.0]).unwrap().blocks().collect();
    let cells = [16, 16, 16];
    group.throughput(Throughput::Elements((64 * 4096) as u64));
    group.bench_function("nodes of cells of a wall", |b| {
        b.iter(|| StructuredGrid::graded(black_box(&wall), cells, [Grading::Uniform; 3]).unwrap().nodes().len());
    });
    let grid = StructuredGrid::graded(&wall, cells, [Grading::Uniform; 3]).unwrap();
    group.bench_function("quality of these cells", |b| b.iter(|| black_box(&grid).quality().aspect_ratio));
    group.finish();
}

criterion_group!(benches, volume_grid);
criterion_main!(benches);
