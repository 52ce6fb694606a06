//! Bodies in STEP: the surfaces chosen, shared edges, positive weights, and what the comparison with the model finds.

use cyclide::{
    Point3, Vec3,
    model::{CurveObject, Item, Model, SurfaceObject},
    surface::CyclidePatch,
};
use cyclide_io::{
    ExportOptions, Format,
    check::{FileSurface, ReadError},
    export::{Exported, StepEdges, StepFaces, StepProducts},
    formats::{export, file_deviation, read_back},
};

fn model(items: Vec<(&str, SurfaceObject)>) -> Model {
    items.into_iter().fold(Model::default(), |model, (name, surface)| model.with_surface(name, surface))
}

/// Patch of revolution about the third axis over `[u0, u1]`, from its meridian's ends and start direction.
fn revolved(from: [f64; 2], to: [f64; 2], [dr, dz]: [f64; 2], [u0, u1]: [f64; 2]) -> SurfaceObject {
    let at = |[r, z]: [f64; 2], u: f64| Point3::new(r * u.cos(), r * u.sin(), z);
    let n = dr.hypot(dz);
    let (v1, v2) = (Vec3::new(-u0.sin(), u0.cos(), 0.0), Vec3::new(dr * u0.cos() / n, dr * u0.sin() / n, dz / n));
    let corners = [at(from, u0), at(from, u1), at(to, u0), at(to, u1)];
    SurfaceObject::Patch(CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap())
}

/// A patch of a general cyclide: corners on a circle of radius 3, an oblique frame.
fn general() -> SurfaceObject {
    oblique([0.1, 1.0, 3.0, 5.0])
}

/// The same from the angles of the corners round their circle.
fn oblique([a, b, c, d]: [f64; 4]) -> SurfaceObject {
    let at = |x: f64| Point3::new(3.0 * x.cos() + 1.0, 3.0 * x.sin() - 2.0, 0.5);
    let (v1, v2) = (Vec3::new(2.0, 3.0, 6.0) / 7.0, Vec3::new(-6.0, -2.0, 3.0) / 7.0);
    SurfaceObject::Patch(CyclidePatch::from_corners_and_frame([at(a), at(b), at(d), at(c)], v1, v2).unwrap())
}

fn patch(surface: &SurfaceObject) -> CyclidePatch {
    match surface {
        SurfaceObject::Patch(patch) => *patch,
        _ => unreachable!("the tests' surfaces are patches"),
    }
}

fn step(model: &Model, edges: StepEdges) -> (Exported, String) {
    let file = export(model, Format::Step, &ExportOptions { step_edges: edges, ..ExportOptions::default() }).unwrap();
    let text = crate::step::unfolded(&String::from_utf8(file.bytes.clone()).unwrap());
    (file, text)
}

/// The file is the model to rounding: 2e-14 of the size is some tens of roundings, magnified by the weights.
fn assert_exact(model: &Model, file: &Exported, size: f64) {
    let deviation = file_deviation(model, Format::Step, file).unwrap();
    assert!(file.exact && deviation <= 2e-14 * size, "{deviation:e} of {size}");
}

#[test]
fn each_surface_of_revolution_is_written_as_what_it_is() {
    let turn = [0.3, 2.0];
    let (low, high) = (0.3_f64, 1.1_f64);
    let on_sphere = |x: f64| [2.0 * x.cos(), 2.0 * x.sin()];
    let start = [-low.sin(), low.cos()];
    for (entity, sides, surface) in [
        ("PLANE", 4, revolved([1.0, 0.0], [2.0, 0.0], [1.0, 0.0], turn)),
        ("CYLINDRICAL_SURFACE", 4, revolved([2.0, -1.0], [2.0, 2.0], [0.0, 1.0], turn)),
        ("CONICAL_SURFACE", 4, revolved([2.0, -1.0], [1.0, 2.0], [-1.0, 3.0], turn)),
        ("CONICAL_SURFACE", 3, revolved([2.0, -1.0], [0.0, 2.0], [-2.0, 3.0], turn)),
        ("SPHERICAL_SURFACE", 4, revolved(on_sphere(low), on_sphere(high), start, turn)),
        ("SPHERICAL_SURFACE", 3, revolved(on_sphere(low), [0.0, 2.0], start, turn)),
        ("TOROIDAL_SURFACE", 4, revolved([3.0, 1.0], [2.0, 0.0], [-1.0, 0.0], turn)),
    ] {
        let m = model(vec![(entity, surface)]);
        let (file, text) = step(&m, StepEdges::Circles);
        assert_eq!(text.matches(&format!("={entity}(")).count(), 1, "{entity}");
        assert_eq!(text.matches("RATIONAL_B_SPLINE").count(), 0, "{entity}");
        assert_eq!(text.matches("=EDGE_CURVE(").count(), sides, "{entity}");
        assert_exact(&m, &file, 4.0);
        // Only in planes do rational edges have exact parameter curves: all else is rational with them.
        let (file, text) = step(&m, StepEdges::Rational);
        assert_exact(&m, &file, 4.0);
        assert_eq!(text.matches("=CIRCLE(").count(), 0, "{entity}");
        assert!(text.contains("RATIONAL_B_SPLINE_CURVE("), "{entity}");
        assert_eq!(text.contains(&format!("={entity}(")), entity == "PLANE", "{entity}");
    }
}

#[test]
fn spheres_with_other_circles_are_one_face_or_stay_rational() {
    let at = |x: f64| Point3::new(x.cos(), x.sin(), 1.0);
    // A frame tangent to the sphere about the origin at (1, 0, 1), turned against the circle of the corners.
    let (e1, e2) = (Vec3::new(0.0, 1.0, 0.0), Vec3::new(-(0.5_f64.sqrt()), 0.0, 0.5_f64.sqrt()));
    let (v1, v2) = (e1 * 0.8 + e2 * 0.6, e2 * 0.8 - e1 * 0.6);
    let corners = [at(0.0), at(0.6), at(-0.7), at(2.5)];
    let surface = SurfaceObject::Patch(CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap());
    assert!(matches!(patch(&surface).recognize(), cyclide::surface::PatchKind::Sphere { .. }));
    let m = model(vec![("sphere", surface)]);
    // As one face its circles carry their curves in the parameters; patches for themselves are exact without.
    let (file, text) = step(&m, StepEdges::Circles);
    assert_eq!(["=SPHERICAL_SURFACE(", "=ADVANCED_FACE("].map(|entity| text.matches(entity).count()), [1; 2]);
    assert!(text.matches("=PCURVE(").count() >= 1);
    assert_exact(&m, &file, 4.0);
    let split = ExportOptions { step_faces: StepFaces::Split, ..ExportOptions::default() };
    let file = export(&m, Format::Step, &split).unwrap();
    let text = String::from_utf8(file.bytes.clone()).unwrap();
    assert_eq!(text.matches("SPHERICAL_SURFACE").count(), 0);
    assert!(text.matches("RATIONAL_B_SPLINE_SURFACE").count() >= 1);
    assert_exact(&m, &file, 4.0);
}

#[test]
fn general_patches_are_rational_with_positive_weights_and_shared_edges() {
    let m = model(vec![("patch", general())]);
    let size = patch(&m.items[0].surfaces()[0]).size();
    for (edges, circles) in [(StepEdges::Circles, true), (StepEdges::Rational, false)] {
        let (file, text) = step(&m, edges);
        assert_exact(&m, &file, 20.0 * size);
        let content = read_back(Format::Step, &file.bytes).unwrap();
        let faces = &content.bodies[0].shells[0].faces;
        assert!(faces.len() > 1, "wide edges are halved");
        for face in faces {
            let FileSurface::Rational(surface) = &face.surface else { panic!("an analytic face") };
            assert!(surface.has_positive_weights());
        }
        let used: usize = faces.iter().map(|f| f.edges.len()).sum();
        let written = text.matches("=EDGE_CURVE(").count();
        assert!(written < used, "inner edges are shared");
        assert_eq!(text.matches("=CIRCLE(").count(), if circles { written } else { 0 });
        assert_eq!(text.matches("OPEN_SHELL(").count(), 1);
    }
}

#[test]
fn wide_rational_faces_are_halved_so_that_readers_integrate_them() {
    // Edges of 147 degrees along s: seven nodes, all that OpenCASCADE takes there, miss 6e-7 of the area; along t the
    // same edges do no harm. Weights are positive in both.
    let surface = oblique([0.0, 0.6, 3.5, 4.3]);
    let ([a0, a1, a2, a3], [v1, v2, _]) = (patch(&surface).corners(), patch(&surface).frame());
    let turned = CyclidePatch::from_corners_and_frame([a0, a2, a1, a3], v2, v1).unwrap();
    for (surface, faces) in [(surface, 2), (SurfaceObject::Patch(turned), 1)] {
        assert!(patch(&surface).real_weights().iter().flatten().all(|&w| w > 0.0));
        let m = model(vec![("patch", surface)]);
        let (file, text) = step(&m, StepEdges::Circles);
        assert_eq!(text.matches("=ADVANCED_FACE(").count(), faces);
        assert_exact(&m, &file, 20.0);
    }
    // Analytic surfaces are integrated by their kind.
    let m = model(vec![("torus", revolved([3.0, 1.0], [2.0, 0.0], [-1.0, 0.0], [0.0, 2.6]))]);
    assert_eq!(step(&m, StepEdges::Circles).1.matches("=ADVANCED_FACE(").count(), 1);
}

#[test]
fn tori_without_a_hole_are_rational() {
    // A torus whose radii are equal to rounding, and the inner part of one that crosses itself.
    let meridian = |major: f64, x: f64| [major + 2.0 * x.cos(), 2.0 * x.sin()];
    for (major, from, to, turn) in [(2.0, 0.5_f64, 1.9, 1.0), (2.0 + 1e-12, 0.5, 1.9, 1.0), (1.0, 2.3, 3.9, -1.0)] {
        let start = [-from.sin(), from.cos()];
        let u = [0.2, 0.2 + 1.1 * turn];
        let m = model(vec![("part", revolved(meridian(major, from), meridian(major, to), start, u))]);
        let (file, text) = step(&m, StepEdges::Circles);
        assert_eq!(text.matches("TOROIDAL_SURFACE").count(), 0, "{major}");
        assert_exact(&m, &file, 8.0);
    }
}

#[test]
fn the_same_model_gives_the_same_bytes() {
    let m = model(vec![("a", general()), ("b", revolved([2.0, -1.0], [1.0, 2.0], [-1.0, 3.0], [0.0, 6.0]))]);
    assert_eq!(step(&m, StepEdges::Circles).0, step(&m, StepEdges::Circles).0);
}

#[test]
fn a_mixture_is_one_representation() {
    let line = Item::new("line", vec![CurveObject::Arc(patch(&general()).s_line(0.5).unwrap())]);
    let mut m = model(vec![("patch", general())]);
    m.items.push(line.clone());
    let (file, text) = step(&m, StepEdges::Circles);
    // Curves and surfaces of one product; related representations of one kind each crash FreeCAD 0.20.
    let general: Vec<&str> = text.lines().filter(|l| l.contains("SHAPE_REPRESENTATION(")).collect();
    let [shape] = general[..] else { panic!("{general:?}") };
    let (items, kind) = (shape.matches('#').count() - 3, shape.split(['=', '(']).nth(1).unwrap());
    assert_eq!((kind, items), ("SHAPE_REPRESENTATION", 2), "{shape}");
    assert!(!text.contains("RELATIONSHIP"));
    assert!(file_deviation(&m, Format::Step, &file).unwrap() < 1e-11);
    // Of solids too, with a note; as an assembly each has the representation of its kind.
    let m = Model { items: vec![thick().items.remove(0), line], ..m };
    let (file, text) = step(&m, StepEdges::Circles);
    assert_eq!(text.matches("=PRODUCT(").count(), 1);
    assert!(file.notes[0].contains("--step-products assembly"), "{:?}", file.notes);
    assert!(file_deviation(&m, Format::Step, &file).unwrap() < 1e-11);
    let options = ExportOptions { step_products: StepProducts::Assembly, ..ExportOptions::default() };
    let file = export(&m, Format::Step, &options).unwrap();
    let text = crate::step::unfolded(&String::from_utf8(file.bytes.clone()).unwrap());
    assert_eq!((text.matches("=PRODUCT(").count(), &file.notes[..]), (3, &[][..]));
    for kind in ["ADVANCED_BREP", "GEOMETRICALLY_BOUNDED_WIREFRAME"] {
        assert_eq!(text.matches(&format!("={kind}_SHAPE_REPRESENTATION(")).count(), 1, "{kind}");
    }
    assert!(file_deviation(&m, Format::Step, &file).unwrap() < 1e-11);
}

#[test]
fn surfaces_have_the_colour_of_their_object() {
    let m = model(vec![("a", general()), ("b", general())]);
    let text = step(&m, StepEdges::Circles).1;
    assert_eq!(text.matches("=PRODUCT(").count(), 3);
    let options = ExportOptions { step_products: StepProducts::One, ..ExportOptions::default() };
    let one = String::from_utf8(export(&m, Format::Step, &options).unwrap().bytes).unwrap();
    assert_eq!((one.matches("=PRODUCT(").count(), one.matches("ASSEMBLY").count()), (1, 0));
    // The pale colors of the pictures, 0xC3D3E6 and 0xB4DAD4.
    for rgb in [[195.0, 211.0, 230.0], [180.0, 218.0, 212.0]] {
        let rgb = rgb.map(|v: f64| (v / 255.0).to_string()).join(",");
        assert_eq!(text.matches(&format!("=COLOUR_RGB('',{rgb})")).count(), 1, "{rgb}");
    }
    assert_eq!(text.matches("=STYLED_ITEM(").count(), 2);
}

#[test]
fn edges_too_short_for_readers_are_named() {
    let small = |p: [f64; 2]| p.map(|x| 1e-7 * x);
    let m = model(vec![("a", revolved(small([2.0, -1.0]), small([1.0, 2.0]), [-1.0, 3.0], [0.3, 2.0]))]);
    let (file, _) = step(&m, StepEdges::Circles);
    assert!(file.notes[0].contains("1e-7"), "{:?}", file.notes);
}

/// The patch of `general`, thick: rational faces beside cones.
fn thick() -> Model {
    model(vec![("thick", oblique([0.1, 1.0, 3.0, 4.2]).thick(0.2).unwrap().unwrap())])
}

/// Circles have curves in the parameters of rational faces, where readers would interpolate and miss their tolerance.
#[test]
fn circles_on_rational_faces_carry_their_parameter_curves() {
    let m = thick();
    let (file, text) = step(&m, StepEdges::Circles);
    assert_exact(&m, &file, 20.0);
    assert!(text.contains("=CONICAL_SURFACE("), "rims are analytic");
    let content = read_back(Format::Step, &file.bytes).unwrap();
    let mut counts = [0, 0];
    for face in content.bodies.iter().flat_map(|b| &b.shells).flat_map(|s| &s.faces) {
        let rational = matches!(face.surface, FileSurface::Rational(_));
        for edge in &face.edges {
            // Lines between rims are left to readers: parameters are proportional there, or analytic.
            assert_eq!(edge.parameter_curve.is_some(), rational, "{:?}", edge.curve);
            counts[usize::from(rational)] += 1;
        }
    }
    assert!(counts[0] >= 16 && counts[1] >= 8, "{counts:?}");
    assert_eq!(text.matches("=PCURVE(").count(), counts[1]);
    assert_eq!(step(&m, StepEdges::Rational).1.matches("=PCURVE(").count(), 0);
}

/// Faults that readers repair silently, made in the text.
#[test]
fn the_comparison_finds_what_readers_repair() {
    let m = model(vec![("patch", general())]);
    let (good, text) = step(&m, StepEdges::Circles);
    let line = |entity: &str| text.lines().find(|l| l.contains(&format!("={entity}("))).unwrap().to_owned();
    let flip = |entity: &str| {
        let line = line(entity);
        let (head, tail) = line.split_at(line.rfind(".T.").unwrap());
        text.replace(&line, &format!("{head}.F.{}", &tail[3..]))
    };
    let read = |text: String| {
        let mut file = good.clone();
        file.bytes = text.into_bytes();
        file_deviation(&m, Format::Step, &file)
    };
    let detail = |result: Result<f64, ReadError>| match result {
        Err(ReadError::Body { detail, .. }) => detail,
        other => panic!("{other:?}"),
    };
    assert_eq!(detail(read(flip("ADVANCED_FACE"))), "a face has the wrong orientation");
    assert_eq!(detail(read(flip("ORIENTED_EDGE"))), "the edges of a loop are not consecutive");
    assert!(matches!(read(flip("EDGE_CURVE")), Err(ReadError::Unsupported { .. })));
    // The complementary arc: the same circle about the opposite axis.
    let circle = line("CIRCLE");
    let placement = circle.split("'',").nth(1).unwrap().split(',').next().unwrap();
    let placement = text.lines().find(|l| l.starts_with(&format!("{placement}="))).unwrap();
    let axis = placement.split(',').nth(2).unwrap();
    let axis_line = text.lines().find(|l| l.starts_with(&format!("{axis}="))).unwrap();
    let numbers = axis_line.split("(").nth(2).unwrap().trim_end_matches(")));").trim_end_matches("));");
    let negated: Vec<String> =
        numbers.split(',').map(|v| v.strip_prefix('-').map_or(format!("-{v}"), str::to_owned)).collect();
    let wrong = text.replace(axis_line, &format!("{axis}=DIRECTION('',({}));", negated.join(",")));
    assert_ne!(wrong, text);
    assert_eq!(detail(read(wrong)), "the range of a parameter curve differs from that of its edge");
    // A parameter curve that leaves its edge by 1e-6, one of the other face's, and none at all.
    let parameters = |l: &&str| l.contains("=CARTESIAN_POINT('',(0.") && l.matches(',').count() == 2;
    let inner = text.lines().filter(parameters).nth(3).unwrap();
    let (head, x) = inner.split_once("(0.").unwrap();
    let moved = format!("{head}(0.{}", x.replacen(&x[..6], &format!("{:06}", x[..6].parse::<u32>().unwrap() ^ 1), 1));
    assert_eq!(
        detail(read(text.replace(inner, &moved))),
        "an edge and its curve on the face differ at equal parameters"
    );
    let pcurve = line("PCURVE");
    let surface = pcurve.split("'',").nth(1).unwrap().split(',').next().unwrap();
    let elsewhere = pcurve.replacen(&format!("'',{surface},"), "'',#1,", 1);
    assert_eq!(
        detail(read(text.replace(&pcurve, &elsewhere))),
        "an edge and its curve on the face differ at equal parameters"
    );
    let bare = line("SURFACE_CURVE");
    let (number, circle) =
        (bare.split('=').next().unwrap(), bare.split("'',").nth(1).unwrap().split(',').next().unwrap());
    let bare = text.replace(&format!(",{number},.T.);"), &format!(",{circle},.T.);"));
    assert_ne!(bare, text);
    assert_eq!(detail(read(bare)), "an edge and its curve on the face differ at equal parameters");
    // A vertex moved by 1e-6.
    let vertex = line("VERTEX_POINT");
    let point = vertex.split("'',").nth(1).unwrap().trim_end_matches(");");
    let point_line = text.lines().find(|l| l.starts_with(&format!("{point}="))).unwrap();
    let x: f64 = point_line.split('(').nth(2).unwrap().split(',').next().unwrap().parse().unwrap();
    let moved = point_line.replacen(&format!("(({x},"), &format!("(({},", x + 1e-6), 1);
    let moved = moved.replacen(&format!("({x},"), &format!("({},", x + 1e-6), 1);
    assert_ne!(moved, point_line);
    assert_eq!(
        detail(read(text.replace(point_line, &moved))),
        "the range of a parameter curve differs from that of its edge"
    );
}
