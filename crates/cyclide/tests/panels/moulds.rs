use crate::shapes::{Random, cone, cylinder, general, grid_distance, narrow_cone, plane, radii, ring, sphere, torus};
use cyclide::{
    conformal::Conformal,
    panel::{MouldShape, Moulds},
    surface::{CyclidePatch, PatchKind},
};

/// The numbers of a mould's form.
fn form(shape: &MouldShape) -> [f64; 2] {
    match *shape {
        MouldShape::Plane => [0.0, 0.0],
        MouldShape::Cylinder { radius } | MouldShape::Sphere { radius } => [radius, 0.0],
        MouldShape::Cone { half_angle } => [half_angle, 0.0],
        MouldShape::Torus { major_radius, minor_radius } => [major_radius, minor_radius],
    }
}

fn check(panels: &[CyclidePatch], moulds: &Moulds, tolerance: f64) {
    let mut seen = vec![0; panels.len()];
    for mould in &moulds.moulds {
        for member in &mould.members {
            seen[member.panel] += 1;
            let near = &member.near;
            assert!(near.max_distance <= tolerance);
            // By the form of the mould and the place of the surface alone.
            let (own, of_mould) = (radii(&near.surface), form(&mould.shape));
            for k in 0..2 {
                assert!((own[k] - of_mould[k]).abs() <= 1e-9 * (1e-6 + of_mould[k]), "{own:?} {of_mould:?}");
            }
            let patch = &panels[member.panel];
            let at_grid = grid_distance(patch, &near.surface);
            assert!(at_grid <= tolerance + 1e-9 * patch.size(), "{at_grid} {tolerance}");
            assert!(!matches!(near.surface, PatchKind::Cyclide));
        }
    }
    moulds.free.iter().for_each(|k| seen[*k] += 1);
    assert!(seen.iter().all(|n| *n == 1), "every panel has one mould");
}

/// The groups as sets of panels.
fn groups(moulds: &Moulds, name: impl Fn(usize) -> usize) -> Vec<Vec<usize>> {
    let of = |mould: &cyclide::panel::Mould| {
        let mut panels: Vec<usize> = mould.members.iter().map(|member| name(member.panel)).collect();
        panels.sort_unstable();
        panels
    };
    let mut all: Vec<Vec<usize>> = moulds.moulds.iter().map(of).collect();
    all.sort();
    all
}

#[test]
fn panels_of_one_surface_share_its_mould() {
    let mut random = Random::new(6);
    let pieces = [plane(), cylinder(), cone(), sphere(1.5), sphere(2.5), torus(0.0), torus(1.0), torus(2.8)];
    let panels: Vec<CyclidePatch> =
        (0..80).map(|k| pieces[k % 8].transformed(&random.similarity(1.0, 3.0)).unwrap()).collect();
    let moulds = Moulds::new(&panels, 1e-7).unwrap();
    check(&panels, &moulds, 1e-7);
    let sizes: Vec<usize> = moulds.moulds.iter().map(|mould| mould.members.len()).collect();
    assert_eq!((sizes, moulds.free.len()), (vec![10, 10, 10, 10, 10, 30], 0));
    for (mould, expected) in
        moulds.moulds.iter().zip([[0.0, 0.0], [2.0, 0.0], [0.4, 0.0], [1.5, 0.0], [2.5, 0.0], [3.0, 1.0]])
    {
        for (found, expected) in form(&mould.shape).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9, "{:?}", mould.shape);
        }
    }
}

#[test]
fn radii_are_compared_over_the_panel() {
    // Spheres of radii 10 and 10.1: panels 8 wide differ by 0.8²·... of the bulge, panels 0.8 wide by a hundredth of that.
    let (wide, small) = (
        [sphere(10.0), sphere(10.1)],
        [sphere(10.0), sphere(10.1)].map(|p| p.sub_patch([0.45, 0.55], [0.45, 0.55]).unwrap()),
    );
    for (panels, tolerance, expected) in [(&wide, 1e-4, 2), (&wide, 1e-2, 1), (&small, 1e-4, 1), (&small, 1e-7, 2)] {
        let moulds = Moulds::new(panels, tolerance).unwrap();
        check(panels, &moulds, tolerance);
        assert_eq!(moulds.count(), expected, "{tolerance}");
    }
}

/// A cylinder is within the tolerance of each, and the cone has no deviation: it is the mould unless there are more cones than cylinders.
#[test]
fn panels_on_a_cone_are_made_on_it_unless_cylinders_are_fewer() {
    let panels: Vec<CyclidePatch> = (0..4).map(|k| narrow_cone(f64::from(k))).collect();
    for tolerance in [1e-9, 1e-4, 1e-3, 3e-3] {
        let moulds = Moulds::new(&panels, tolerance).unwrap();
        check(&panels, &moulds, tolerance);
        assert_eq!(moulds.count(), 1, "{tolerance}");
        let MouldShape::Cone { half_angle } = moulds.moulds[0].shape else { panic!("{tolerance}: {moulds:?}") };
        assert!((half_angle - (1.0_f64 / 20.0).atan()).abs() < 1e-12);
        assert!(moulds.moulds[0].members.iter().all(|member| member.near.max_distance < 1e-13));
    }
    // A flat sheet needs no mould.
    assert_eq!(Moulds::new(&panels, 0.1).unwrap().moulds[0].shape, MouldShape::Plane);
    // The cylinder of one joins that of the other, which the cone does not.
    let with_cylinder = [narrow_cone(0.0), cylinder()];
    let moulds = Moulds::new(&with_cylinder, 3e-2).unwrap();
    assert_eq!(moulds.count(), 1);
    assert!(matches!(moulds.moulds[0].shape, MouldShape::Cylinder { .. }));
}

#[test]
fn spheres_need_no_more_moulds_than_their_ranges() {
    // Spheres with radii from 1 to 2: by brute force, the least number of radii out of a fine ladder that serve all.
    let panels: Vec<CyclidePatch> = (0..12).map(|k| sphere(1.0 + f64::from(k) / 11.0)).collect();
    let mut before = usize::MAX;
    for tolerance in [1e-6, 1e-4, 1e-3, 3e-3, 1e-2, 2e-2] {
        let moulds = Moulds::new(&panels, tolerance).unwrap();
        check(&panels, &moulds, tolerance);
        assert!(moulds.count() <= before, "{tolerance}: {} after {before}", moulds.count());
        before = moulds.count();
    }
    assert!(before < 6);
}

#[test]
fn moulds_of_a_ring_at_many_tolerances() {
    let panels = ring([10, 6]);
    let mut counts = Vec::new();
    for tolerance in [1e-6, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0] {
        let moulds = Moulds::new(&panels, tolerance).unwrap();
        check(&panels, &moulds, tolerance);
        counts.push(moulds.count());
    }
    assert!(counts.windows(2).all(|pair| pair[1] <= pair[0]), "{counts:?}");
    assert_eq!(counts.last(), Some(&1), "all flat: {counts:?}");
}

#[test]
fn order_place_and_scale_do_not_matter() {
    let mut random = Random::new(7);
    let mut panels = ring([8, 6]);
    panels.extend((0..12).map(|_| general(&mut random)));
    let tolerance = 4e-3;
    let own = Moulds::new(&panels, tolerance).unwrap();
    let n = panels.len();
    let shuffled: Vec<CyclidePatch> = (0..n).map(|k| panels[k * 37 % n]).collect();
    let again = Moulds::new(&shuffled, tolerance).unwrap();
    assert_eq!(groups(&own, |k| k).len(), groups(&again, |k| k * 37 % n).len());
    for scale in [1e-6, 1e6] {
        let map = random.similarity(scale, scale);
        let moved: Vec<CyclidePatch> = panels.iter().map(|p| p.transformed(&map).unwrap()).collect();
        let again = Moulds::new(&moved, tolerance * scale).unwrap();
        check(&moved, &again, tolerance * scale);
        assert_eq!(own.count(), again.count());
    }
    assert_eq!(Moulds::new(&[], 1.0).unwrap().count(), 0);
    assert_eq!(Moulds::new(&panels, f64::NAN).unwrap_err().reason(), "tolerance-not-positive");
}
