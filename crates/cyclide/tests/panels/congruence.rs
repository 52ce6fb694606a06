use crate::shapes::{Random, exchanged, general, mirrored, renumbered, ring, torus};
use cyclide::{
    Point3, Vec3,
    conformal::Conformal,
    panel::Congruences,
    surface::{CyclidePatch, ParamSurface},
};

/// Classes as sets of panels.
fn sets(found: &Congruences, name: impl Fn(usize) -> usize) -> Vec<Vec<usize>> {
    let of = |class: &cyclide::panel::CongruenceClass| {
        let mut panels: Vec<usize> = class.panels.iter().map(|member| name(member.panel)).collect();
        panels.sort_unstable();
        panels
    };
    let mut all: Vec<Vec<usize>> = found.classes.iter().map(of).collect();
    all.sort();
    all
}

/// A panel in any place, from any corner on, with s and t exchanged or not.
fn anywhere(patch: &CyclidePatch, scale: f64, far: f64, random: &mut Random) -> CyclidePatch {
    let mut panel = *patch;
    for _ in 0..(4.0 * random.next()) as usize {
        panel = renumbered(&panel);
    }
    if random.next() < 0.5 {
        panel = exchanged(&panel);
    }
    panel.transformed(&random.similarity(scale, far)).unwrap()
}

#[test]
fn copies_are_found_in_any_place_and_order_of_corners() {
    let mut random = Random::new(8);
    let originals: Vec<CyclidePatch> = (0..12).map(|_| general(&mut random)).collect();
    for (scale, far, tolerance) in [(1.0, 5.0, 1e-9), (1e-6, 1e-6, 1e-15), (1e6, 1e6, 1e-3), (1.0, 1e5, 1e-8)] {
        let panels: Vec<CyclidePatch> =
            (0..120).map(|k| anywhere(&originals[k % 12], scale, far, &mut random)).collect();
        let found = Congruences::new(&panels, tolerance).unwrap();
        let expected: Vec<Vec<usize>> = (0..12).map(|k| (0..10).map(|j| k + 12 * j).collect()).collect();
        assert_eq!(sets(&found, |k| k), expected, "{scale} {far}");
        for class in &found.classes {
            assert!(class.mirror.is_none(), "no symmetry");
            let first = &panels[class.panels[0].panel];
            for member in &class.panels {
                assert!(member.deviation <= tolerance);
                // Corners that correspond have the same distances.
                let (a, b) = (first.corners(), member.corners.map(|k| panels[member.panel].corners()[k]));
                for (i, j) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
                    assert!((a[i].distance(a[j]) - b[i].distance(b[j])).abs() <= 2.0 * tolerance);
                }
            }
        }
        // The order of the panels does not matter.
        let shuffled: Vec<CyclidePatch> = (0..120).map(|k| panels[k * 77 % 120]).collect();
        assert_eq!(sets(&Congruences::new(&shuffled, tolerance).unwrap(), |k| k * 77 % 120), expected);
    }
}

#[test]
fn turned_over_and_mirrored_panels_are_told() {
    let mut random = Random::new(9);
    let patch = general(&mut random);
    let panels = [patch, renumbered(&patch), exchanged(&patch), mirrored(&patch), mirrored(&exchanged(&patch))];
    let found = Congruences::new(&panels, 1e-9).unwrap();
    assert_eq!(sets(&found, |k| k), vec![vec![0, 1, 2], vec![3, 4]]);
    assert_eq!(found.classes[0].mirror.map(|(class, _)| class), Some(1));
    assert_eq!(found.classes[1].mirror.map(|(class, _)| class), Some(0));
    for class in &found.classes {
        let first = class.panels[0].panel;
        for member in &class.panels {
            // Exchange turns the normal round; so does a reflection of a patch, which both have had or neither.
            let expected = [0, 0, 1, 0, 1][first] != [0, 0, 1, 0, 1][member.panel];
            assert_eq!(member.turned_over, expected, "{} from {first}", member.panel);
        }
    }
    // A part of a torus that is symmetric to a plane is its own mirror image.
    let own = Congruences::new(&[torus(-0.3)], 1e-9).unwrap();
    assert_eq!(own.classes[0].mirror.map(|(class, _)| class), Some(0));
}

#[test]
fn classes_are_those_of_all_pairs() {
    // Panels that differ by a little, so that some are within the tolerance and some are not.
    let mut random = Random::new(10);
    let originals: Vec<CyclidePatch> = (0..6).map(|_| general(&mut random)).collect();
    let panels: Vec<CyclidePatch> = (0..150)
        .map(|k| {
            let part =
                originals[k % 6].sub_patch([0.0, random.between(0.99, 1.0)], [random.between(0.0, 0.01), 1.0]).unwrap();
            anywhere(&part, 1.0, 5.0, &mut random)
        })
        .collect();
    for tolerance in [1e-3, 3e-3, 1e-2] {
        let found = Congruences::new(&panels, tolerance).unwrap();
        assert_eq!(sets(&found, |k| k).concat().len(), panels.len());
        let pair = |a: usize, b: usize| {
            let two = Congruences::new(&[panels[a], panels[b]], tolerance).unwrap();
            two.classes.len() == 1
        };
        // First panels are not within the tolerance of each other, members are of theirs: each pair by itself, without a table of many.
        let firsts: Vec<usize> = found.classes.iter().map(|class| class.panels[0].panel).collect();
        for (k, a) in firsts.iter().enumerate() {
            assert!(firsts[..k].iter().all(|b| !pair(*a, *b)), "{tolerance}");
        }
        for class in &found.classes {
            assert!(class.panels.iter().all(|member| pair(class.panels[0].panel, member.panel)));
        }
        assert!(found.classes.len() >= 6 && found.classes.len() < 140, "{}", found.classes.len());
    }
}

/// Rectangles laid middle on middle are half the difference of their sides apart, longer or shorter, wherever these are among all lengths.
#[test]
fn rectangles_within_the_tolerance_are_one_class_whatever_their_size() {
    let rectangle = |w: f64, h: f64| {
        let corners = [[0.0, 0.0], [w, 0.0], [0.0, h], [w, h]].map(|[x, y]| Point3::new(x, y, 0.0));
        CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).unwrap()
    };
    for k in 0..50 {
        let w = 2.0 + 1e-4 * f64::from(k);
        for h in [1.0 + 1e-4, 1.0 - 1e-4] {
            let apart = 0.5 * 1e-3_f64.hypot(1e-4);
            let panels = [rectangle(w, 1.0), rectangle(w + 1e-3, h)];
            let found = Congruences::new(&panels, 1e-3).unwrap();
            assert_eq!(sets(&found, |k| k), [[0, 1]], "{w} {h}");
            // Least to a percent or two.
            let deviation = found.classes[0].panels[1].deviation;
            assert!(deviation >= apart * (1.0 - 1e-9) && deviation < 1.02 * apart, "{w} {h}: {deviation} {apart}");
            assert_eq!(Congruences::new(&panels, 0.99 * apart).unwrap().classes.len(), 2, "{w} {h}");
        }
    }
}

#[test]
fn a_ring_has_the_classes_of_its_symmetries() {
    // A ring cyclide has two planes of symmetry: of its panels at most four are alike or mirror images.
    let panels = ring([12, 8]);
    let found = Congruences::new(&panels, 1e-9).unwrap();
    assert!(found.classes.iter().all(|class| class.panels.len() <= 2 && class.mirror.is_some()));
    assert_eq!(found.classes.iter().map(|class| class.panels.len()).sum::<usize>(), 96);
}

#[test]
fn many_panels_take_time_by_their_number() {
    // 200 panels, 25 times each, and 5,000 that are all different.
    let mut random = Random::new(11);
    let originals: Vec<CyclidePatch> = (0..200).map(|_| general(&mut random)).collect();
    let copies = (0..5000).map(|k| originals[k % 200]);
    let mut panels: Vec<CyclidePatch> = copies.collect();
    panels.extend((0..5000).map(|_| general(&mut random)));
    let found = Congruences::new(&panels, 1e-6).unwrap();
    assert_eq!(found.classes.len(), 5200);
    let point: Point3 = panels[0].point(0.5, 0.5);
    assert!(point.is_finite());
}
