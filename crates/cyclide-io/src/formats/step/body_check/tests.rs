//! Files whose bodies were cut in a wrong way, and right files of which something wrong is told, held against the uncut model.

#![allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]

use super::*;
use crate::check::bodies::{FileCurve, FileSurface};
use crate::export::exported::Exported;
use crate::export::face_plan::FacePlan;
use crate::export::options::{ExportOptions, StepFaces};
use crate::formats::step::reader::read;
use crate::formats::{Exporter, Format};
use cyclide::{
    Point3, Vec3,
    construct::{PipeTee, TeeBranch, TeeMain},
    curve::Circle,
    model::{Model, SurfaceObject},
    rational::NurbsCurve,
    surface::{CyclidePatch, CyclidicNet, DupinCyclide, NetFrame, PatchKind, QuadGrid},
    topology::{FaceGeometry as _, FacePart},
};

/// More than rounding leaves of models of this size, less than anything below is wrong by.
const SMALL: f64 = 1e-12;

fn model(surface: impl Into<SurfaceObject>) -> Model {
    Model::default().with_surface("it", surface)
}

/// Most of a plane ring, which is cut into four faces one behind the other.
fn ring() -> Model {
    let at = |r: f64, u: f64| Point3::new(r * u.cos(), r * u.sin(), 0.0);
    let corners = [at(1.0, 0.0), at(1.0, 5.5), at(2.0, 0.0), at(2.0, 5.5)];
    model(SurfaceObject::Patch(CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::X).unwrap()))
}

/// A ring cyclide moved inwards until it is a horn, as one closed shell that touches itself in two nodes inside its faces.
fn horn() -> Model {
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let outer = ring.offset(-1.3).unwrap().to_shell().unwrap();
    assert!(outer.is_closed() && outer.faces().iter().any(|face| !face.surface.is_regular()));
    model(SurfaceObject::Body(Body { outer, voids: Vec::new() }))
}

/// What the check says of the file of a model after something was changed in it, or in what is told of it.
fn checked(model: &Model, change: impl FnOnce(&mut Exported, &mut Vec<FileBody>)) -> Result<f64, String> {
    checked_as(StepFaces::Split, model, change)
}

fn checked_as(
    step_faces: StepFaces,
    model: &Model,
    change: impl FnOnce(&mut Exported, &mut Vec<FileBody>),
) -> Result<f64, String> {
    let exporter = Exporter::new(model).unwrap();
    let mut file = exporter.export(Format::Step, &ExportOptions { step_faces, ..ExportOptions::default() }).unwrap();
    let mut bodies = read(&file.bytes).unwrap().bodies;
    change(&mut file, &mut bodies);
    let deviations = bodies_deviation(&Made { ready: &exporter.ready, file: &file }, &bodies);
    deviations.map(|off| off[0]).map_err(|error| error.to_string())
}

/// The same, of which faces the writer tells.
fn told(model: &Model, change: impl FnOnce(&mut Vec<FacePart>)) -> Result<f64, String> {
    checked(model, |file, _| {
        let faces = &mut file.written.shells[0][0].faces;
        let mut parts: Vec<FacePart> = faces.iter().map(|face| face.parts[0]).collect();
        change(&mut parts);
        let loops = faces.iter().map(|face| face.loops.clone()).collect::<Vec<_>>();
        let told = parts.into_iter().zip(loops).map(|(part, loops)| FacePlan { parts: vec![part], loops });
        *faces = told.collect();
    })
}

#[test]
fn right_files_are_right() {
    for model in [ring(), horn()] {
        assert!(checked(&model, |_, _| ()).unwrap() < SMALL);
    }
}

/// A whole torus of sixteen patches as one face, after something was changed.
fn merged(change: impl FnOnce(&mut Vec<FacePlan>, &mut Vec<FileFace>)) -> Result<f64, String> {
    let ring = DupinCyclide::new(3.0, 0.0, 1.0).unwrap().nets([4, 4]).unwrap().remove(0);
    checked_as(StepFaces::Merged, &model(SurfaceObject::Net(ring)), |file, bodies| {
        change(&mut file.written.shells[0][0].faces, &mut bodies[0].shells[0].faces);
    })
}

#[test]
fn faces_that_are_several_are_held_against_all_of_them() {
    assert!(merged(|plans, faces| assert_eq!((plans[0].parts.len(), faces[0].edges.len()), (16, 4))).unwrap() < SMALL);
    let refused = |detail: &str| Err(format!("body 0: {detail}"));
    // A part that is missing, and a side that is not told.
    let missing = merged(|plans, _| plans[0].parts.truncate(15));
    assert_eq!(missing, refused("its faces do not cover each face of the model once"));
    assert_eq!(merged(|plans, _| plans[0].loops[0][0].truncate(3)), refused("a face has a different number of edges"));
    assert_eq!(merged(|plans, _| drop(plans[0].loops[0].pop())), refused("a face has a different number of edges"));
    let twice = merged(|plans, _| plans[0].loops[0][0] = plans[0].loops[0][1].clone());
    assert_eq!(twice, refused("a side of a face corresponds to two edges"));
    // The surface and a circle of another size.
    let larger = merged(|_, faces| {
        let FileSurface::Analytic(PatchKind::Torus { minor_radius, .. }) = &mut faces[0].surface else {
            unreachable!()
        };
        *minor_radius += 1e-6;
    });
    assert!((larger.unwrap() - 1e-6).abs() < 1e-9);
    let wider = merged(|_, faces| {
        let FileCurve::Circle(circle) = &mut faces[0].edges[0].curve else { unreachable!() };
        *circle = Circle::from_radius(circle.center(), circle.normal(), circle.radius() + 1e-6).unwrap();
    });
    assert!(wider.unwrap() > 0.9e-6);
    // A circle the other way round, and a seam that is run in one direction only.
    let reversed = merged(|_, faces| {
        let FileCurve::Circle(circle) = &mut faces[0].edges[0].curve else { unreachable!() };
        *circle = circle.reversed();
    });
    assert_eq!(reversed, refused("a circle is not traversed exactly once"));
    let once = merged(|_, faces| {
        let edge = faces[0].edges[0].edge;
        faces[0].edges.iter_mut().filter(|own| own.edge == edge).for_each(|own| own.forward = true);
    });
    assert!(once.is_err(), "{once:?}");
}

#[test]
fn parts_that_do_not_tile_the_faces_are_refused() {
    let refused = Err("body 0: its faces do not cover each face of the model once".to_owned());
    let shifted = |by: f64| told(&ring(), |parts| parts[1].s[0] += by);
    assert_eq!([shifted(0.01), shifted(-0.01), shifted(f64::NAN)], [(); 3].map(|()| refused.clone()));
    assert_eq!(told(&ring(), |parts| parts[3].t[1] = 0.5), refused);
    assert_eq!(told(&ring(), |parts| parts[2].face = 1), refused);
    // A part that is missing in the file as well, and one that is there twice.
    let both = |change: fn(&mut Vec<FacePlan>, &mut Vec<FileFace>)| {
        checked(&ring(), |file, bodies| {
            change(&mut file.written.shells[0][0].faces, &mut bodies[0].shells[0].faces);
        })
    };
    let missing = both(|parts, faces| drop((parts.pop(), faces.pop())));
    let doubled = both(|parts, faces| {
        parts.push(parts[0].clone());
        faces.push(faces[0].clone());
    });
    let replaced = both(|parts, faces| (parts[1], faces[1]) = (parts[0].clone(), faces[0].clone()));
    assert_eq!([missing, doubled, replaced], [(); 3].map(|()| refused.clone()));
    assert_eq!(told(&ring(), |parts| parts.truncate(3)), refused);
}

#[test]
fn parts_of_other_places_are_found() {
    // Neighbors exchanged: all lies in one plane, but an edge of one of them is on the border, of the other inside.
    let swapped = told(&ring(), |parts| parts.swap(0, 1));
    assert!(swapped.as_ref().map_or(true, |off| *off > 0.1), "{swapped:?}");
    // A cut told a thousandth beside its place, on both sides of it.
    let beside = told(&ring(), |parts| {
        let at = parts[0].s[1] + 1e-3;
        (parts[0].s[1], parts[1].s[0]) = (at, at);
    });
    assert!(beside.unwrap() > 1e-4);
}

/// A strip of two squares whose middle line is lifted, and the flat one of one face.
#[test]
fn a_wrong_middle_is_found() {
    let strip = |xs: &[f64], height: f64| {
        let at = |y: f64, (i, x): (usize, &f64)| Point3::new(*x, y, if i == 1 { height } else { 0.0 });
        let points = [0.0, 1.0].into_iter().flat_map(|y| xs.iter().enumerate().map(move |place| at(y, place)));
        let grid = QuadGrid::new(points.collect(), [xs.len(), 2], [false, false]).unwrap();
        let slope = Vec3::new(1.0, 0.0, height).unit().unwrap();
        CyclidicNet::new(grid, NetFrame::First(slope, Vec3::Y)).unwrap()
    };
    let whole = model(SurfaceObject::Patch(strip(&[0.0, 2.0], 0.0).patch(0, 0)));
    let off = |height: f64| {
        let cut = model(SurfaceObject::Net(strip(&[0.0, 1.0, 2.0], height)));
        let split = ExportOptions { step_faces: StepFaces::Split, ..ExportOptions::default() };
        let mut file = Exporter::new(&cut).unwrap().export(Format::Step, &split).unwrap();
        // Told as halves of the one face.
        for (face, s) in file.written.shells[0][0].faces.iter_mut().zip([[0.0, 0.5], [0.5, 1.0]]) {
            face.parts = vec![FacePart { face: 0, s, t: [0.0, 1.0] }];
        }
        let bodies = read(&file.bytes).unwrap().bodies;
        let ready = Exporter::new(&whole).unwrap().ready;
        bodies_deviation(&Made { ready: &ready, file: &file }, &bodies).unwrap()[0]
    };
    assert!(off(0.0) < SMALL);
    let lifted = off(1e-6);
    assert!((1e-6..1e-5).contains(&lifted), "{lifted}");
}

#[test]
fn edges_are_shared_where_parts_have_a_common_border() {
    let number = |bodies: &mut Vec<FileBody>, face: usize, edge: usize, to: Option<u64>| {
        let own = &mut bodies[0].shells[0].faces[face].edges;
        let from = own[edge].edge;
        own[edge].edge = to.unwrap_or(from);
        from
    };
    // The edge between the first two faces: the second of one, the last of the other.
    let unshared = checked(&ring(), |_, bodies| {
        assert_eq!(number(bodies, 0, 1, None), number(bodies, 1, 3, None));
        number(bodies, 0, 1, Some(u64::MAX));
    });
    assert_eq!(unshared, Err("body 0: faces share an edge only in the model".to_owned()));
    let shared = checked(&ring(), |_, bodies| {
        let first = number(bodies, 0, 1, None);
        number(bodies, 2, 3, Some(first));
    });
    assert_eq!(shared, Err("body 0: faces share an edge only in the file".to_owned()));
}

#[test]
fn lobes_are_shells_of_their_own() {
    let shells = |file: &Exported| file.written.shells[0].iter().map(|plan| plan.shell).collect::<Vec<_>>();
    let right = checked(&horn(), |file, _| assert_eq!(shells(file), [0, 0]));
    assert!(right.unwrap() < SMALL);
    let merged = checked(&horn(), |file, bodies| {
        let [faces, more] = [0, 1].map(|k| std::mem::take(&mut file.written.shells[0][k].faces));
        file.written.shells[0] = vec![ShellPlan { shell: 0, faces: [faces, more].concat() }];
        let more = bodies[0].shells.remove(1).faces;
        bodies[0].shells[0].faces.extend(more);
        bodies[0].solid = true;
    });
    assert_eq!(merged, Err("body 0: the faces of a shell are not connected".to_owned()));
    // A face that went over to the other lobe.
    let parted = checked(&horn(), |file, bodies| {
        let part = file.written.shells[0][0].faces.pop().unwrap();
        file.written.shells[0][1].faces.push(part);
        let face = bodies[0].shells[0].faces.pop().unwrap();
        bodies[0].shells[1].faces.push(face);
    });
    assert_eq!(parted, Err("body 0: faces share an edge only in the model".to_owned()));
    let solid = checked(&horn(), |_, bodies| bodies[0].solid = true);
    assert_eq!(solid, Err("body 0: it is a solid only in the file or only in the model".to_owned()));
}

/// Rational edges on cylinders and cones: their curves in the parameters, of which readers take the one that is told.
#[test]
fn curves_on_cylinders_and_cones_are_held_against_their_edges() {
    for taper in [0.0, 0.1, -0.1] {
        let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-10.0, 10.0] };
        let branch = TeeBranch { taper, ..TeeBranch::upright(2.0, 9.0, 0.5) };
        let tee = PipeTee::new(main, vec![branch]).unwrap().made().unwrap();
        let model = model(SurfaceObject::Body(tee.body));
        let is_branch = |face: &&mut FileFace| match face.surface {
            FileSurface::Analytic(PatchKind::Cylinder { radius, .. }) => taper == 0.0 && radius < 2.5,
            FileSurface::Analytic(PatchKind::Cone { half_angle, .. }) => (half_angle - taper.abs()).abs() < 1e-10,
            _ => false,
        };
        let on_branch = |bodies: &mut Vec<FileBody>, change: fn(Point3) -> Point3| {
            let edges = bodies[0].shells[0].faces.iter_mut().filter(is_branch).flat_map(|face| &mut face.edges);
            let curve = edges.filter_map(|edge| edge.parameter_curve.as_mut()).next().unwrap();
            let points = curve.control_points().iter().map(|&p| change(p)).collect();
            *curve = NurbsCurve::new(curve.degree(), curve.knots().to_vec(), points, curve.weights().to_vec()).unwrap();
        };
        assert!(checked(&model, |_, bodies| on_branch(bodies, |p| p)).unwrap() < SMALL);
        // A hundred-millionth of a turn, and of the height.
        for change in [|p| p + Vec3::X * 1e-8, |p| p + Vec3::Y * 1e-8] as [fn(Point3) -> Point3; 2] {
            let moved = checked(&model, |_, bodies| on_branch(bodies, change));
            assert_eq!(moved, Err("body 0: an edge and its curve on the face differ at equal parameters".to_owned()));
        }
    }
}
