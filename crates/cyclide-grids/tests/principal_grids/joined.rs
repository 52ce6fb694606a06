//! One mesh of quads round umbilics.

use super::{edge, laid, reasons, surfaces};
use cyclide::{
    Error, Point3,
    error::{JoinFault, PrincipalGridError},
    surface::{NetLayout, QuadLayout},
    topology::surface_joints,
};
use cyclide_grids::{CircularMeshOptions, GridBorder, PrincipalGridOptions, UmbilicRule, make_layout_circular};
use surfaces::Mesh;

fn joined(length: f64) -> PrincipalGridOptions {
    PrincipalGridOptions { umbilics: UmbilicRule::Joined, ..edge(length) }
}

/// A roof round one umbilic of index -1/2, at the origin.
fn monkey(size: usize) -> Mesh {
    Mesh::roof([-6.0, 6.0], [-6.0, 6.0], [size; 2], |x, y| {
        0.01 * (x * x * x - 3.0 * x * y * y) + 0.02 * (x * x + y * y)
    })
}

/// A cap of an ellipsoid with two umbilics of index 1/2.
fn cap() -> Mesh {
    let [a, b, c] = [4.0, 3.6, 2.0];
    Mesh::roof([-2.8, 2.8], [-2.2, 2.2], [56, 44], |x, y| c * (1.0 - x * x / (a * a) - y * y / (b * b)).sqrt())
}

/// The vertices that two grids share lie on the borders of both, and every grid shares some.
fn shared_borders(layout: &QuadLayout) -> usize {
    let mut owners: Vec<Vec<usize>> = vec![Vec::new(); layout.points().len()];
    for (k, piece) in layout.pieces().iter().enumerate() {
        piece.vertices.iter().flatten().for_each(|v| owners[*v].push(k));
    }
    let shared = owners.iter().filter(|owners| owners.len() > 1);
    let with_others: std::collections::BTreeSet<usize> = shared.clone().flatten().copied().collect();
    assert_eq!(with_others.len(), layout.pieces().len());
    shared.count()
}

/// What the mathematics accept of pieces, of one mesh over nearly all of the surface; smooth across the borders of its grids.
#[test]
fn grids_round_umbilics_share_borders() {
    for (name, mesh, length, quads, halves, grids) in [
        ("monkey", monkey(60), 0.5, 6, vec![-1], 6),
        ("nurbs", surfaces::nurbs(2, 40), 0.8, 12, vec![-1, -1], 13),
        ("cap", cap(), 0.4, 4, vec![1, 1], 2),
    ] {
        let found = laid(&mesh, &joined(length)).unwrap();
        assert_eq!(found.report.umbilics.iter().map(|u| u.halves).collect::<Vec<_>>(), halves, "{name}");
        assert!(!reasons(&found).contains(&"pieces"), "{name}");
        let layout = found.joined.as_ref().unwrap();
        assert_eq!(layout.round().iter().map(|at| at.quads.len()).sum::<usize>(), quads, "{name}");
        assert_eq!((layout.pieces().len(), found.grids.len()), (grids, grids), "{name}");
        assert!(shared_borders(layout) > 10, "{name}");
        // The vertex is the umbilic's.
        for at in layout.round() {
            let off = found.report.umbilics.iter().map(|u| u.point.distance(layout.points()[at.vertex]));
            assert!(off.fold(f64::INFINITY, f64::min) < 1e-9, "{name}");
        }
        let coverage = found.report.coverage;
        assert!(coverage > 0.75 && coverage < 1.0, "{name}: covers {coverage}");
        let made = make_layout_circular(layout, &CircularMeshOptions::default()).unwrap();
        let (report, shape) = (&made.report, made.report.shape.unwrap());
        let (moves, bending) = (report.moves.max / report.median_edge, shape.bending.unwrap());
        assert!(moves <= 0.3 && (0.97..=1.03).contains(&bending), "{name}: {moves} {bending}");
        assert!(shape.normal_turn.is_none_or(|turn| turn <= 0.06), "{name}: {:?}", shape.normal_turn);
        let net = NetLayout::new(made.layout).unwrap();
        let joints = surface_joints(&net.to_shell().unwrap());
        // Normals that agree to rounding.
        assert!(joints.iter().all(|joint| joint.angle < 1e-7), "{name}");
    }
}

/// Points lie on the surface, also those round the umbilic: the sag of a chord would be a hundredth.
#[test]
fn points_of_one_mesh_lie_on_the_surface() {
    let found = laid(&monkey(60), &joined(0.5)).unwrap();
    let height = |p: &Point3| 0.01 * (p.x.powi(3) - 3.0 * p.x * p.y * p.y) + 0.02 * (p.x * p.x + p.y * p.y);
    let off = found.joined.unwrap().points().iter().map(|p| (p.z - height(p)).abs()).fold(0.0, f64::max);
    assert!(off < 1e-3, "{off}");
}

/// Twice the surface and twice the edge is twice the mesh, to the bit; a quarter turn is one too, but for rounding.
#[test]
fn one_mesh_goes_with_the_surface() {
    let mesh = monkey(40);
    let twice =
        Mesh { points: mesh.points.iter().map(|p| Point3::ORIGIN + p.to_vec() * 2.0).collect(), ..mesh.clone() };
    let [once, twice] =
        [laid(&mesh, &joined(0.6)), laid(&twice, &joined(1.2))].map(|found| found.unwrap().joined.unwrap());
    let of_twice: Vec<Point3> = once.points().iter().map(|p| Point3::ORIGIN + p.to_vec() * 2.0).collect();
    assert_eq!(twice.points(), of_twice);
    let turned = Mesh { points: mesh.points.iter().map(|p| Point3::new(-p.y, p.x, p.z)).collect(), ..mesh };
    let turned = laid(&turned, &joined(0.6)).unwrap().joined.unwrap();
    assert_eq!(turned.quads().len(), once.quads().len());
}

/// Without umbilics it is the grid with a border in steps.
#[test]
fn joining_needs_umbilics() {
    let saddle = surfaces::saddle();
    let steps = PrincipalGridOptions { border: GridBorder::Staircase, ..edge(0.5) };
    let [one, other] = [joined(0.5), steps].map(|options| laid(&saddle, &options).unwrap());
    assert!(one.joined.is_none());
    assert_eq!(one.grids, other.grids);
}

#[test]
fn what_cannot_be_joined_is_named() {
    let fault = |mesh: &Mesh, length: f64| match laid(mesh, &joined(length)) {
        Err(Error::PrincipalGrid(PrincipalGridError::UmbilicsNotJoined { fault, .. })) => fault,
        other => panic!("{:?}", other.map(|found| found.report)),
    };
    let hole = monkey(40).without(|p| (p.x - 3.0).hypot(p.y - 3.0) < 0.7);
    assert_eq!(fault(&hole, 0.6), JoinFault::Holes);
    // Edges longer than a third of the way from one umbilic to the other.
    assert_eq!(fault(&cap(), 1.2), JoinFault::Crowded);
}
