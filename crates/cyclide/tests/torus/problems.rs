//! Random awkward problems: all are solved, and every solution obeys every law.

use cyclide::SegmentMethod;
use cyclide_testkit::torus_splines::Problem;

/// Solves problems of one seed; returns how many segments each method joined, and the most pieces of a segment.
fn all_solved(seed: u64, count: u64) -> ([usize; 3], usize) {
    let (mut methods, mut most) = ([0; 3], 0);
    for case in 0..count {
        let problem = Problem::awkward(seed, case);
        let solved = problem.solve();
        assert!(solved.is_ok(), "{seed}/{case}: {solved:?} of {problem:?}");
        let spline = solved.unwrap();
        let faults = problem.faults(&spline);
        assert!(faults.is_empty(), "{seed}/{case}: {faults:?}\n{problem:?}");
        for segment in spline.segments() {
            let index = match segment.method {
                SegmentMethod::Direct => 0,
                SegmentMethod::Halved => 1,
                _ => 2,
            };
            methods[index] += 1;
            most = most.max(segment.pieces.len());
            assert!(segment.quality > 0.0 && segment.quality <= 1.0);
        }
    }
    (methods, most)
}

#[test]
fn awkward_problems_are_all_solved() {
    let (methods, most) = all_solved(30, 2_000);
    // Every way to join a segment is taken by many: the problems are what they should be.
    assert!(methods.iter().all(|count| *count > 1_000), "{methods:?}");
    assert!(most < 200, "{most}");
}

/// The long run: `cargo test --workspace --locked --test torus -- --ignored`.
#[test]
#[ignore = "minutes"]
fn ten_thousand_awkward_problems_are_all_solved() {
    // The figures of `docs/math/torus-splines.md#the-general-problem`.
    let (methods, most) = all_solved(32, 10_000);
    // Sines that differ in the last digit on another machine may change a choice.
    assert!(methods.iter().zip([5228, 19_722, 11_299]).all(|(got, want): (&i32, i32)| (got - want).abs() < 50));
    assert!((40..60).contains(&most));
}
