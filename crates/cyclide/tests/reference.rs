//! The reference files (computed independently, at 50 digits) run through the public API by the runner of
//! `cargo xtask reference`. The copies here hold the constructs about curves, patches and
//! nets.

use cyclide_testkit::reference::{Report, run};

/// Runs a file and checks that exactly these constructs, with these numbers of cases, were run and passed.
fn all_pass(text: &str, expected: &[(&str, usize)]) {
    let names: Vec<String> = expected.iter().map(|(name, _)| (*name).to_owned()).collect();
    let mut report = Report::default();
    assert_eq!(run(text, Some(&names), &mut report), Ok(()));
    assert!(report.is_success(), "{report}");
    let got: Vec<(&str, usize)> = report.tallies().iter().map(|(n, t)| (n.as_str(), t.passed)).collect();
    assert_eq!(got, expected);
}

#[test]
fn arcs() {
    all_pass(
        include_str!("reference/10-arcs.json"),
        &[
            ("arc-three-points", 20),
            ("arc-point-tangent", 17),
            ("arc-weights", 10),
            ("arc-weights-4d", 3),
            ("arc-complex", 10),
            ("arc-angle-parameter", 11),
            ("arc-split", 11),
            ("arc-reverse", 11),
            ("arc-bbox", 11),
            ("arc-closest-point", 24),
            ("arc-subdivide", 11),
            ("arc-nurbs", 11),
            ("arc-bulge", 12),
            ("circle-nurbs", 4),
            ("biarc", 29),
            ("arc-spline", 11),
            ("fit-arc-spline", 2),
            ("revolution", 12),
            ("revolution-angle", 2),
            ("neck-blend", 12),
            ("ellipse-bridge", 5),
            ("sphere-polygon", 5),
            ("polyhedron-offset", 9),
        ],
    );
}

#[test]
fn circle_blends() {
    all_pass(
        include_str!("reference/50-blending.json"),
        &[
            ("circle-through-points", 8),
            ("sphere-through-points", 5),
            ("blend-angle", 20),
            ("circle-blend-curve", 26),
            ("rational-circle-blend-curve", 5),
            ("circle-blend-derivatives", 6),
            ("rational-circle-blend-bezier", 6),
            ("circle-blend-hermite", 6),
            ("blend-patch", 6),
            ("sphere-blend", 15),
        ],
    );
}

#[test]
fn fair_splines() {
    all_pass(
        include_str!("reference/65-fair-splines.json"),
        &[
            ("fair-spline", 25),
            ("fair-spline-bezier", 5),
            ("fair-spline-residual", 4),
            ("blend-segment-ends", 4),
            ("fair-spline-relaxation", 2),
        ],
    );
}

#[test]
fn arc_fits() {
    all_pass(
        include_str!("reference/60-arc-fitting.json"),
        &[("arc-fit-interval", 37), ("arc-certify", 18), ("g1-arc-interval", 16), ("g1-arc-spline", 5)],
    );
}

#[test]
fn tori_and_curves_on_them() {
    all_pass(
        include_str!("reference/30-torus.json"),
        &[
            ("torus-eval", 46),
            ("torus-inverse", 42),
            ("torus-circle", 40),
            ("type-switch", 40),
            ("rp1-biarc", 48),
            ("torus-quartic-biarc", 41),
            ("two-type-biarc", 20),
            ("torus-spline", 44),
            ("perp-cylinder-sphere", 45),
            ("canal-patch", 20),
            ("contact-ball", 42),
            ("constant-radius-curve", 21),
            ("quadric-pair-kind", 20),
        ],
    );
}

#[test]
fn patches_and_nets() {
    all_pass(
        include_str!("reference/20-cyclides.json"),
        &[
            ("qb-arc", 17),
            ("qb-arc-three-points", 10),
            ("cyclide-patch", 43),
            ("cyclide-offset", 10),
            ("cyclide-locate", 5),
            ("cyclide-implicit", 3),
            ("cyclide-moebius", 10),
            ("circular-net-frames", 2),
        ],
    );
}

#[test]
fn closed_nets() {
    all_pass(
        include_str!("reference/70-principal-nets.json"),
        &[("ring-closing", 5), ("strip-closing", 2), ("closed-circular-net", 10)],
    );
}

#[test]
fn spherical_cubes_and_volumes() {
    all_pass(
        include_str!("reference/20-cyclides.json"),
        &[("miquel-point", 9), ("cyclide-volume", 9), ("spherical-cube", 10)],
    );
}

#[test]
fn motions() {
    all_pass(
        include_str!("reference/40-interpolation.json"),
        &[
            ("study-point", 5),
            ("study-displacement-paper", 3),
            ("study-displacement", 4),
            ("motion-conic-three-poses", 14),
            ("motion-quartic-five-poses", 8),
            ("motion-cubic-cross-ratio", 8),
            ("motion-sclerp", 15),
            ("motion-spline-fibre", 9),
            ("qb-as-motion", 3),
        ],
    );
}

#[test]
fn qb_curves_interpolation_and_moebius_splines() {
    all_pass(
        include_str!("reference/40-interpolation.json"),
        &[
            ("qb-evaluate", 12),
            ("qb-to-rational-bezier", 12),
            ("qb-subdivide", 12),
            ("qb-elevate", 12),
            ("qb-moebius", 12),
            ("pole-report", 17),
            ("interpolate-points", 54),
            ("interpolate-hermite", 17),
            ("hermite-three-points-two-tangents", 25),
            ("invariant-span", 23),
            ("circle-tangents", 19),
            ("circle-tangent-spline", 18),
            ("g1-circle-spline", 25),
            ("spline-nurbs", 3),
        ],
    );
}

#[test]
fn closing_the_papers() {
    all_pass(
        include_str!("reference/80-closing.json"),
        &[
            ("qb-patch", 18),
            ("qb-patch-implicit", 5),
            ("qb-patch-locate", 5),
            ("qb-patch-arcs", 11),
            ("qb-patch-inversion", 5),
            ("qb-block", 8),
            ("surface-intersect", 16),
            ("circle-surface-intersect", 19),
            ("circle-angle", 14),
            ("point-distance", 9),
            ("moebius-three-points", 11),
        ],
    );
}
