//! Exact patches and cells for analysis programs: VTU, MFEM, G+Smo.

use crate::damage::Damage;
use crate::models::{annulus, curve_and_surfaces, mixed, octant, space_chain, splines, surfaces, tilted, torus_part};
use cyclide::{
    Point3, Vec3,
    conformal::{Conformal as _, Mobius},
    model::{CurveObject, Geometry, Item, Model, Units},
    rational::RationalBezierSurface,
    surface::{CyclidePatch, CyclidicNet, DupinCyclide},
    topology::Shell,
    volume::{CyclideGrid, CyclideVolume, Grading, SphericalCube, VolumeFrame},
};
use cyclide_io::{
    ExportOptions, Exporter, Format,
    export::{Provenance, VtuCells, VtuEncoding},
    formats::{export, file_deviation, read_back},
};

const FORMATS: [Format; 3] = [Format::Vtu, Format::Mfem, Format::Gismo];

/// Layers round a whole torus: every block has neighbors on four sides.
fn layers() -> Model {
    let torus = DupinCyclide::new(3.0, 0.0, 1.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let wall = CyclideGrid::layers(&torus, &[-0.5, -0.1, 0.0]).unwrap();
    let blocks = Geometry::Volumes(wall.blocks().collect());
    Model { items: vec![Item::new("wall", blocks)], units: Units::Inch }
}

/// A block over half a ring, whose weights are not all positive: it is cut.
fn half_ring() -> CyclideVolume {
    let at = |x: f64, z: f64| Point3::new(x, 0.0, z);
    let corners =
        [at(10.0, 0.0), at(-10.0, 0.0), at(10.0, 5.0), at(-10.0, 5.0), at(20.0, 0.0), at(-20.0, 0.0), at(20.0, 5.0)];
    CyclideVolume::new(&SphericalCube::new(corners).unwrap(), VolumeFrame::First(Vec3::Y, Vec3::Z)).unwrap()
}

fn of_block(block: CyclideVolume) -> Model {
    Model::default().with_volume("block", block)
}

fn box_of(origin: Point3) -> CyclideVolume {
    let cube = SphericalCube::cuboid(origin, [Vec3::X, Vec3::Y * 2.0, Vec3::Z]).unwrap();
    CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap()
}

fn models() -> Vec<Model> {
    let mut models = vec![
        surfaces(&[octant(), annulus(), torus_part(Point3::new(5.0, -3.0, 9.0))]),
        mixed(tilted),
        crate::models::model(vec![("s", vec![CurveObject::ArcPath(space_chain())])]),
        layers(),
        Model::default().with_volume("half", half_ring()),
    ];
    models.extend(splines().into_iter().map(|(_, model)| model));
    models
}

#[test]
fn files_are_exact_and_the_same_every_time() {
    for model in models() {
        for format in FORMATS {
            // Circle splines of the trigonometric kind have no exact form: their promise is the tolerance.
            let file = match export(&model, format, &ExportOptions::default()) {
                // Splines of the trigonometric kind may have a higher degree than MFEM takes.
                Err(error) if format == Format::Mfem && error.reason() == "not-in-format" => continue,
                other => other.unwrap(),
            };
            let off = file_deviation(&model, format, &file).unwrap();
            // Rounding of coordinates up to 100.
            assert!(off <= file.bound + 1e-12, "{format:?}: {off:e} of {:e}", file.bound);
            assert_eq!(file.bytes, export(&model, format, &ExportOptions::default()).unwrap().bytes);
        }
    }
}

/// A contour of arcs is one patch, not one for each.
#[test]
fn arcs_that_follow_each_other_are_one_curve() {
    let model = crate::models::model(vec![("s", vec![CurveObject::ArcPath(space_chain())])]);
    for format in [Format::Mfem, Format::Gismo] {
        let content = read_back(format, &export(&model, format, &ExportOptions::default()).unwrap().bytes).unwrap();
        assert_eq!(content.curves[0].pieces().len(), 1, "{format:?}");
    }
}

#[test]
fn neighbors_are_joined_and_what_differs_is_said() {
    let text = |model: &Model, format| {
        let file = export(model, format, &ExportOptions::default()).unwrap();
        (String::from_utf8(file.bytes).unwrap(), file.notes.join(" "))
    };
    // 4 by 4 by 2 blocks: 16 by 3 corners; only the inner skin and the outer one are free.
    let (mesh, note) = text(&layers(), Format::Mfem);
    assert!(
        mesh.contains("\nelements\n32\n") && mesh.contains("\nboundary\n32\n") && mesh.contains("\nvertices\n48\n")
    );
    assert!(note.is_empty());
    let (xml, _) = text(&layers(), Format::Gismo);
    let inside =
        |name: &str| xml.split_once(&format!("<{name}>")).unwrap().1.split_once('<').unwrap().0.lines().count();
    // A line end before each line.
    assert_eq!((inside("interfaces") - 1, inside("boundary") - 1), (80, 32));
    // Two boxes that touch: whole faces are joined over objects. Of the half ring all parts are halved alike.
    let two =
        Model::default().with_volume("a", box_of(Point3::ORIGIN)).with_volume("b", box_of(Point3::new(1.0, 0.0, 0.0)));
    assert!(text(&two, Format::Mfem).0.contains("\nvertices\n12\n"));
    let half = Model::default().with_volume("half", half_ring());
    let (mesh, note) = text(&half, Format::Mfem);
    assert!(mesh.contains("\nelements\n8\n") && mesh.contains("\nvertices\n27\n") && note.is_empty());
    // A box upside down: its parameters run another way on the face that is shared.
    let mut turned = two;
    let flipped = box_of(Point3::new(1.0, 0.0, 0.0)).permuted([0, 2, 1]).unwrap().reversed(1);
    turned.items[1].geometry = Geometry::Volumes(vec![flipped]);
    for (format, words) in [(Format::Mfem, "without being joined to them"), (Format::Gismo, "without being interfaces")]
    {
        let (_, note) = text(&turned, format);
        assert!(note.starts_with("2 patch sides touch others") && note.contains(words), "{note}");
    }
}

/// A unit box beside the center of an inversion, in units of whose distance it reaches far.
fn inverted(center: [f64; 3]) -> CyclideVolume {
    let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z]).unwrap();
    let block = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap();
    block.transformed(&Mobius::inversion(Point3::from(center), 1.0).unwrap()).unwrap()
}

/// Where a block comes near infinity its parts are small there only, and share whole faces all the same.
#[test]
fn uneven_blocks_have_no_cracks() {
    for distance in [0.2, 0.02, 0.005] {
        let model = of_block(inverted([0.37, 0.61, -distance]));
        let file = export(&model, Format::Mfem, &ExportOptions::default()).unwrap();
        assert!(file.notes.is_empty(), "{:?}", file.notes);
        let text = String::from_utf8(file.bytes).unwrap();
        let count = |word: &str| -> usize {
            text.split_once(&format!("\n{word}\n")).unwrap().1.lines().next().unwrap().parse().unwrap()
        };
        let (parts, sides, corners) = (count("elements"), count("boundary"), count("vertices"));
        let sizes = (1..60_usize).flat_map(|m| (1..60_usize).map(move |n| [m, n]));
        let is_box = |[m, n]: [usize; 2]| {
            let l = parts / (m * n);
            l * m * n == parts && sides == 2 * (m * n + m * l + n * l) && corners == (m + 1) * (n + 1) * (l + 1)
        };
        assert!(parts < 10_000 && sizes.into_iter().any(is_box), "{distance}: {parts} {sides} {corners}");
        let cells = export(&model, Format::Gismo, &ExportOptions::default()).unwrap();
        assert!(file_deviation(&model, Format::Gismo, &cells).unwrap() < 1e-9 / distance);
    }
    // What builds is exact in VTU, and in few parts; of many blocks there would be too many.
    let near = inverted([0.37, 0.61, -1e-5]);
    assert!(export(&of_block(near), Format::Vtu, &ExportOptions::default()).unwrap().exact);
    let many = Item::new("many", Geometry::Volumes(vec![near; 16]));
    let many = Model { items: vec![many], units: Units::Inch };
    let error = export(&many, Format::Mfem, &ExportOptions::default()).map(|file| file.bytes.len()).unwrap_err();
    assert_eq!(error.reason(), "too-many-pieces", "{error}");
}

/// A wedge, as at the pole of a sphere: the corners where its lines are points are left out of the quality.
#[test]
fn collapsed_corners_have_no_quality() {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    let octant = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
    let layers = CyclideGrid::layers(&CyclidicNet::from(octant), &[0.0, 0.1]).unwrap();
    let model = of_block(layers.block([0, 0, 0]));
    let places = Grading::Uniform.places(4).unwrap();
    let places = Some([places.clone(), places.clone(), places]);
    let divided = [Provenance { kind: "layers", places, ..Provenance::default() }];
    let exporter = Exporter::with_provenance(&model, &divided).unwrap();
    for (cells, points) in [(VtuCells::Linear, "\"105\""), (VtuCells::Bezier, "\"1728\"")] {
        let options = ExportOptions { vtu_cells: cells, ..ExportOptions::default() };
        let text = String::from_utf8(exporter.export(Format::Vtu, &options).unwrap().bytes).unwrap();
        assert!(text.contains(&format!("NumberOfPoints={points}")), "{}", &text[..400]);
        let values = |name: &str| -> Vec<f64> {
            let rest = text.split_once(&format!("Name=\"{name}\"")).unwrap().1.split_once('>').unwrap().1;
            rest.split_once('<').unwrap().0.split_whitespace().map(|word| word.parse().unwrap()).collect()
        };
        assert!(values("scaled_jacobian").iter().all(|v| *v > 0.95), "{cells:?}");
        // A cell is an eighth of a quarter turn long at least and a fortieth high.
        assert!(values("aspect_ratio").iter().all(|v| *v < 30.0), "{cells:?} {:?}", values("aspect_ratio"));
    }
}

#[test]
fn a_mesh_has_one_dimension_and_names_what_is_left_out() {
    let file = export(&curve_and_surfaces(), Format::Mfem, &ExportOptions::default()).unwrap();
    let note = "only surfaces are written, since an MFEM mesh has one dimension; left out: slot";
    assert_eq!(file.notes, [note]);
    assert!(String::from_utf8(file.bytes).unwrap().contains("\ndimension\n2\n"));
    let mut model = curve_and_surfaces().with_volume("block", box_of(Point3::ORIGIN));
    model.items.rotate_right(1);
    let file = export(&model, Format::Mfem, &ExportOptions::default()).unwrap();
    assert!(file.notes[0].starts_with("only volumes") && file.notes[0].ends_with("left out: slot, s0, s1"));
    assert!(file_deviation(&model, Format::Mfem, &file).unwrap() < 1e-14);
    // G+Smo and VTU hold all of them, G+Smo the volume first.
    let content =
        read_back(Format::Gismo, &export(&model, Format::Gismo, &ExportOptions::default()).unwrap().bytes).unwrap();
    assert_eq!((content.volumes.len(), content.patches.len(), content.curves.len()), (1, 2, 1));
}

#[test]
fn degrees_that_mfem_reads_wrongly_are_refused() {
    let face = |degree: usize| {
        let rows = (0..=degree).flat_map(|i| (0..2).map(move |j| [i as f64, j as f64, 0.1 * (i * i) as f64, 1.0]));
        let surface = RationalBezierSurface::new([degree, 1], rows.collect()).unwrap();
        Model::default().with_surface("face", Shell::from_surface(surface).unwrap())
    };
    assert!(export(&face(10), Format::Mfem, &ExportOptions::default()).is_ok());
    let error = export(&face(11), Format::Mfem, &ExportOptions::default()).unwrap_err();
    assert_eq!(error.reason(), "not-in-format");
    let start = "object face: MFEM cannot represent this: a degree above 10, which MFEM silently misreads";
    assert!(error.to_string().starts_with(start), "{error}");
    for format in [Format::Vtu, Format::Gismo] {
        let file = export(&face(11), format, &ExportOptions::default()).unwrap();
        assert!(file_deviation(&face(11), format, &file).unwrap() < 1e-13);
    }
}

/// Weights of faces are the exact multiples by a power of two of which the largest is from 1 to 2, and so are those of edges in STEP: those of the blend of a thin branch go up to 57 000.
#[test]
fn weights_are_of_the_size_of_one() {
    let document = r#"{"cyclide": 1, "objects": {"t": {"type": "pipe-tee", "main": {"radius": 30, "ends": [-120, 120]}, "branches": [{"radius": 0.5, "length": 120, "blend": 0.2}]}}}"#;
    let document: cyclide_io::Document = document.parse().unwrap();
    let model = Model { items: vec![document.build().unwrap().remove(0).item], units: Units::Millimetre };
    let file = export(&model, Format::Vtu, &ExportOptions::default()).unwrap();
    let text = String::from_utf8(file.bytes.clone()).unwrap();
    let array = |name: &str| -> Vec<f64> {
        let from = text.find(&format!("Name=\"{name}\"")).unwrap();
        let list = &text[from + text[from..].find('>').unwrap() + 1..];
        list[..list.find('<').unwrap()].split_whitespace().map(|x| x.parse().unwrap()).collect()
    };
    let (weights, offsets) = (array("RationalWeights"), array("offsets"));
    let mut from = 0;
    for end in offsets {
        let most = weights[from..end as usize].iter().copied().fold(0.0, f64::max);
        assert!((1.0..2.0).contains(&most), "{most}");
        from = end as usize;
    }
    // Neighbors still meet: the shape read back is the model's.
    assert!(file_deviation(&model, Format::Vtu, &file).unwrap() < 1e-12);
    let step = export(&model, Format::Step, &ExportOptions::default()).unwrap();
    let text = String::from_utf8(step.bytes.clone()).unwrap();
    let curves = text.split("RATIONAL_B_SPLINE_CURVE((").skip(1);
    for list in curves {
        let list = list[..list.find(')').unwrap()].split(',').map(|x| x.trim().parse::<f64>().unwrap());
        let most = list.fold(0.0, f64::max);
        assert!((1.0..2.0).contains(&most), "{most}");
    }
    assert!(file_deviation(&model, Format::Step, &step).unwrap() < 1e-9);
}

/// The bytes of the numbers in place of their digits: the same content.
#[test]
fn appended_bytes_hold_what_digits_hold() {
    let appended = ExportOptions { vtu_encoding: VtuEncoding::Base64, ..ExportOptions::default() };
    for model in [layers(), curve_and_surfaces()] {
        let [digits, bytes] =
            [&ExportOptions::default(), &appended].map(|options| export(&model, Format::Vtu, options).unwrap());
        assert!(bytes.bytes != digits.bytes);
        assert!(file_deviation(&model, Format::Vtu, &bytes).unwrap() < 1e-13);
        assert_eq!(read_back(Format::Vtu, &bytes.bytes), read_back(Format::Vtu, &digits.bytes));
    }
    let damage = Damage::with(layers(), Format::Vtu, &appended);
    let lost = damage.bytes(|bytes| bytes.truncate(bytes.len() / 2));
    assert!(lost.unwrap_err().to_string().contains("appended"));
}

#[test]
fn qualities_are_those_of_the_blocks() {
    let file = export(&layers(), Format::Vtu, &ExportOptions::default()).unwrap();
    let text = String::from_utf8(file.bytes).unwrap();
    let values = |name: &str| -> Vec<f64> {
        let rest = text.split_once(&format!("Name=\"{name}\"")).unwrap().1;
        let (_, rest) = rest.split_once('>').unwrap();
        rest.split_once('<').unwrap().0.split_whitespace().map(|word| word.parse().unwrap()).collect()
    };
    // Lines cross at right angles, to rounding.
    assert!(values("orthogonality").iter().all(|v| *v < 1e-14));
    assert!(values("scaled_jacobian").iter().all(|v| (v - 1.0).abs() < 1e-14));
    // The upper layer is 0.1 high; round the axis a block is a quarter of up to 2 pi 4 long, in its parameter up to twice as fast as even.
    let ratios = values("aspect_ratio");
    assert!(
        ratios.len() == 32 && ratios.iter().all(|v| *v > 1.0) && ratios[16..].iter().any(|v| *v > 40.0),
        "{ratios:?}"
    );
    // Layers of 0.4 and 0.1; sides round the axis are a quarter of 2 pi (3 - 1) and more.
    let sides = values("shortest_side");
    assert!(
        sides.iter().enumerate().all(|(k, side)| (side - if k < 16 { 0.4 } else { 0.1 }).abs() < 1e-14),
        "{sides:?}"
    );
    assert!(values("jacobian").iter().all(|v| *v > 0.0));
    // Faces and curves have none.
    let mixed = curve_and_surfaces().with_volume("block", box_of(Point3::ORIGIN));
    let text = String::from_utf8(export(&mixed, Format::Vtu, &ExportOptions::default()).unwrap().bytes).unwrap();
    let row = text.split_once("Name=\"aspect_ratio\"").unwrap().1.split_once(">\n").unwrap().1;
    let numbers: Vec<f64> = row.split_once('\n').unwrap().0.split(' ').map(|word| word.parse().unwrap()).collect();
    // Sides of 1 and 2, to rounding.
    let (last, others) = numbers.split_last().unwrap();
    assert!((last - 2.0).abs() < 1e-14 && others.iter().all(|v| *v == 0.0), "{row}");
    let damage = Damage::new(layers(), Format::Vtu);
    let one = format!("{}", values("aspect_ratio")[0]);
    assert!(damage.refused(&[(one.as_str(), "7")]).contains("quality"));
}

#[test]
fn damage_is_found_out() {
    let unit = "the unit of the file is 1 mm, that of the model 25.4 mm";
    let mesh = Damage::new(layers(), Format::Mfem);
    assert_eq!(mesh.refused(&[("units in", "units mm")]), unit);
    assert_eq!(
        mesh.refused(&[("attribute 1: wall", "attribute 1: roof")]),
        "attribute 0 is `roof` in the file, `wall` in the model"
    );
    // Corners that are not those of the patches, and a side of the boundary with the attribute of another.
    assert!(
        mesh.refused(&[("\n1 5 0 1 3 2 4 5 7 6\n", "\n1 5 1 0 3 2 4 5 7 6\n")]).contains("do not match the patches")
    );
    assert!(mesh.refused(&[("\n5 3 ", "\n6 3 ")]).contains("do not match the patches"));
    assert!(
        mesh.refused(&[("\nknotvectors\n3\n2 3 0 0 0 1 1 1\n", "\nknotvectors\n3\n2 3 0 0 0 2 2 2\n")])
            .contains("knots")
    );
    let xml = Damage::new(layers(), Format::Gismo);
    assert_eq!(xml.refused(&[("units in", "units mm")]), unit);
    assert_eq!(
        xml.refused(&[("object 0: wall", "object 0: roof")]),
        "object 0 is `roof` in the file, `wall` in the model"
    );
    assert!(xml.refused(&[("10 2 11 1 0 1 2 1 1 1", "10 2 11 1 1 0 2 1 1 1")]).contains("interfaces and boundary"));
    for damage in [mesh, xml] {
        // A control point moved by a tenth: no longer that of its neighbor, or off.
        let text = String::from_utf8(damage.file.bytes.clone()).unwrap();
        let moved = damage.bytes(|bytes| {
            let number = text
                .split_ascii_whitespace()
                .rev()
                .find(|word| word.len() > 15 && !word.contains('e') && word.contains('.'))
                .unwrap();
            let at = text.rfind(number).unwrap();
            let digit = at + number.find('.').unwrap() + 1;
            bytes[digit] = if bytes[digit] == b'1' { b'2' } else { b'1' };
        });
        assert!(moved.is_err() || moved.is_ok_and(|off| off > 1e-3));
    }
}

/// Every cell of divided blocks is an exact cell, or stands between knots: the same blocks, whatever else they are cut for.
#[test]
fn divided_blocks_are_exact_cells() {
    let [s, t, u] = [vec![0.0, 0.2, 0.5, 1.0], vec![0.0, 0.7, 1.0], vec![0.0, 0.1, 0.3, 0.6, 1.0]];
    let mirrored = half_ring().permuted([1, 0, 2]).unwrap();
    assert_ne!(mirrored.is_right_handed(), half_ring().is_right_handed());
    let models = [layers(), of_block(half_ring()), of_block(mirrored)];
    for (number, model) in models.iter().enumerate() {
        let places = Some([s.clone(), t.clone(), u.clone()]);
        let divided = [Provenance { kind: "layers", places, ..Provenance::default() }];
        let exporter = Exporter::with_provenance(model, &divided).unwrap();
        let blocks = model.items[0].volumes().len();
        for format in FORMATS {
            let file = exporter.export(format, &ExportOptions::default()).unwrap();
            // Rounding of coordinates up to 20.
            assert!(file.exact && exporter.deviation(format, &file).unwrap() < 1e-13, "{number} {format:?}");
            let content = read_back(format, &file.bytes).unwrap();
            assert!(content.volumes.iter().all(|own| own.volume.degrees() == [2; 3]));
            // 3 by 2 by 4 cells; those of the half ring are cut in halves besides, where their weights ask for it or all of them.
            let cells = content.volumes.len();
            match (number, format) {
                (0, _) => assert_eq!(cells, 24 * blocks),
                // Cuts at 0.5, which one list of knots has already.
                (_, Format::Mfem | Format::Gismo) => assert_eq!(cells, 3 * 3 * 5),
                (_, _) => assert!(cells >= 24, "{cells}"),
            }
        }
        let mesh = String::from_utf8(exporter.export(Format::Mfem, &ExportOptions::default()).unwrap().bytes).unwrap();
        if number == 0 {
            // As many patches as blocks, joined as they were; knots along s and t of each ring are the same on both sides.
            assert!(mesh.contains("\nelements\n32\n") && mesh.contains("\nvertices\n48\n"));
            assert!(mesh.contains("\n2 5 0 0 0 0.2 0.5 1 1 1\n") && mesh.contains("\n2 6 0 0 0 0.1 0.3 0.6 1 1 1\n"));
        }
        let mut wrong = exporter.export(Format::Mfem, &ExportOptions::default()).unwrap();
        wrong.bytes =
            mesh.replacen(" 0.7 1 1 1\n", " 0.75 1 1 1\n", 1).replacen(" 0.6 1 1 1\n", " 0.65 1 1 1\n", 1).into_bytes();
        assert!(
            wrong.bytes != mesh.as_bytes() && exporter.deviation(Format::Mfem, &wrong).map_or(true, |off| off > 1e-3)
        );
    }
}

/// Cells of a grid whose nodes neighbors share, in place of blocks: off by less, the more there are.
#[test]
fn divided_blocks_are_plain_hexahedra() {
    let (model, options) = (layers(), ExportOptions { vtu_cells: VtuCells::Linear, ..ExportOptions::default() });
    let mut before = f64::INFINITY;
    for n in [2, 4] {
        let places = Grading::Uniform.places(n).unwrap();
        let places = Some([places.clone(), places, vec![0.0, 0.25, 1.0]]);
        let divided = [Provenance { kind: "layers", places, ..Provenance::default() }];
        let exporter = Exporter::with_provenance(&model, &divided).unwrap();
        let file = exporter.export(Format::Vtu, &options).unwrap();
        let text = String::from_utf8(file.bytes.clone()).unwrap();
        // 4 n cells round and round, 2 through each of 2 layers.
        let counts =
            format!("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", (4 * n) * (4 * n) * 5, (4 * n) * (4 * n) * 4);
        assert!(text.contains(&counts), "{}", &text[..600]);
        let off = exporter.deviation(Format::Vtu, &file).unwrap();
        assert!(
            !file.exact && !file.sampled && off <= file.bound && off > 0.5 * file.bound,
            "{off:e} of {:e}",
            file.bound
        );
        // Halves are off by a quarter.
        assert!(off < 0.35 * before);
        before = off;
        let content = read_back(Format::Vtu, &file.bytes).unwrap();
        assert!(content.volumes.iter().all(|own| own.volume.degrees() == [1; 3]));
        let mut wrong = file.clone();
        wrong.bytes = text.replacen(" 0 1 ", " 1 0 ", 1).into_bytes();
        assert!(wrong.bytes != file.bytes && exporter.deviation(Format::Vtu, &wrong).is_err());
    }
    let message = |model: &Model| export(model, Format::Vtu, &options).unwrap_err().to_string();
    assert!(message(&layers()).contains("its blocks are not divided into cells: set `cells`"));
    assert!(message(&curve_and_surfaces()).contains("linear cells require blocks"));
}
