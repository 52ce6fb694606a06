//! Shells of nets, and what is no shell.

use crate::data::nets;
use cyclide::{
    surface::DupinCyclide,
    topology::{FaceGeometry as _, Shell, ShellEdge, Side},
};

#[test]
fn every_inner_edge_has_two_faces() {
    for (name, net) in nets() {
        let shell = net.to_shell().unwrap();
        let ([m, n], [p, q], closed) = (net.size(), net.grid().size(), net.grid().closed());
        assert_eq!(shell.faces().len(), m * n, "{name}");
        assert_eq!(shell.vertices().len(), p * q, "{name}");
        assert_eq!(shell.edges().len(), m * q + p * n, "{name}");
        let border = if closed[0] { 0 } else { 2 * n } + if closed[1] { 0 } else { 2 * m };
        assert_eq!(shell.edge_uses().iter().filter(|&&uses| uses == 1).count(), border, "{name}");
        assert_eq!(shell.is_closed(), closed == [true, true], "{name}");
        assert_eq!(net.support_arcs().unwrap().len(), shell.edges().len(), "{name}");
        if shell.is_closed() {
            assert!(shell.volume() > 0.0, "{name}");
        }
        // The public constructor accepts it.
        let (v, e, f) = (shell.vertices().to_vec(), shell.edges().to_vec(), shell.faces().to_vec());
        assert_eq!(Shell::new(v, e, f).unwrap(), shell, "{name}");
    }
}

#[test]
fn what_is_no_shell_is_refused() {
    let shell = nets()[0].1.to_shell().unwrap();
    let parts = || (shell.vertices().to_vec(), shell.edges().to_vec(), shell.faces().to_vec());
    let refused = |(v, e, f): (Vec<_>, Vec<_>, Vec<_>), item: &str, index: usize| {
        let error = Shell::new(v, e, f).unwrap_err();
        assert_eq!((error.reason(), error.index()), ("not-a-shell", Some(index)), "{error}");
        assert!(error.to_string().contains(item), "{error}");
    };
    let (mut v, e, f) = parts();
    v[0].x = v[0].x.next_up();
    refused((v, e, f), "edge", 0);
    let (v, mut e, f) = parts();
    e[3].end = 10_000;
    refused((v, e, f), "edge", 3);
    let (v, mut e, f) = parts();
    // Twice the speed ratio: the same points with another parameter.
    let ShellEdge { start, end, ref curve } = e[0];
    let arc = *curve.arc().unwrap();
    let arc = cyclide::curve::Arc::from_weight_ratio(arc.start(), arc.end(), arc.weight_ratio() * 2.0).unwrap();
    e[0] = ShellEdge { start, end, curve: arc.into() };
    refused((v, e, f), "face", 0);
    let (v, e, mut f) = parts();
    f[1].same_sense = false;
    let error = Shell::new(v, e, f).unwrap_err();
    assert!(error.to_string().contains("opposite orientations"), "{error}");
    let (v, e, mut f) = parts();
    let copy = f[9].clone();
    f.push(copy);
    let error = Shell::new(v, e, f).unwrap_err();
    assert!(error.to_string().contains("two faces"), "{error}");
    let (v, e, mut f) = parts();
    f[4].sides[0] = None;
    refused((v, e, f), "face", 4);
    let (v, e, mut f) = parts();
    f[4].sides[2] = f[4].sides[3];
    refused((v, e, f), "face", 4);
    let (v, e, _) = parts();
    assert_eq!(Shell::new(v, e, Vec::new()).unwrap_err().reason(), "not-a-shell");
}

/// Two vertices at the place of a pole, one for each of the sides that meet there: the face has a gap of no width.
#[test]
fn a_side_of_one_point_has_one_vertex() {
    let bodies = DupinCyclide::new(1.0, 0.5, 0.2).unwrap().to_bodies([4, 4]).unwrap();
    let faces = bodies.iter().flat_map(|body| body.outer.faces());
    let pointed: Vec<_> = faces.filter(|face| face.sides.contains(&None)).collect();
    assert!(!pointed.is_empty());
    for face in pointed {
        let shell = Shell::from_surface(face.surface.clone()).unwrap();
        let (mut v, mut e, f) = (shell.vertices().to_vec(), shell.edges().to_vec(), shell.faces().to_vec());
        assert_eq!((v.len(), e.len()), (3, 3));
        Shell::new(v.clone(), e.clone(), f.clone()).unwrap();
        let side = Side::ALL.into_iter().find(|side| face.side(*side).is_none()).unwrap();
        let pole = face.surface.corners()[side.corners()[0]];
        let at = v.iter().position(|vertex| *vertex == pole).unwrap();
        v.push(pole);
        let edge = e.iter_mut().find(|edge| edge.start == at || edge.end == at).unwrap();
        let end = if edge.start == at { &mut edge.start } else { &mut edge.end };
        *end = 3;
        let error = Shell::new(v, e, f).unwrap_err();
        assert_eq!((error.reason(), error.index()), ("not-a-shell", Some(0)), "{error}");
        assert!(error.to_string().contains("two vertices"), "{error}");
    }
}
