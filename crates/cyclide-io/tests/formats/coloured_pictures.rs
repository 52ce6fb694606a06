//! Pictures that show a quantity of surfaces as colors: the colors at known places, their scale, labels, and fields of directions.

use cyclide::{
    Point3, Vec3,
    model::{GridObject, Item, Model, SurfaceObject, Units},
    surface::{CyclidePatch, CyclidicNet, DupinCyclide, NetFrame, QuadGrid},
};
use cyclide_io::{
    ExportOptions, Exporter, Format,
    export::{Exported, GivenSurface, LaidField, PictureColour, Provenance},
};
use tiny_skia::Pixmap;

fn options(colour: PictureColour, plain: bool) -> ExportOptions {
    ExportOptions {
        png_colour: colour,
        png_plain: plain,
        png_width: Some(800),
        camera: "top".parse().ok(),
        ..ExportOptions::default()
    }
}

fn drawn(model: &Model, provenance: &[Provenance], options: &ExportOptions) -> (Pixmap, Exported) {
    let file = Exporter::with_provenance(model, provenance).unwrap().export(Format::Png, options).unwrap();
    (Pixmap::decode_png(&file.bytes).unwrap(), file)
}

fn at(picture: &Pixmap, x: f64, y: f64) -> [i32; 3] {
    let pixel = picture.pixel(x as u32, y as u32).unwrap();
    [pixel.red(), pixel.green(), pixel.blue()].map(i32::from)
}

/// The middle of a plain picture of [`options`] from above, and half of the model's extent along the shorter side, which it fills to 0.92:
/// all of these models are as wide as deep.
const MIDDLE: (f64, f64, f64) = (400.0, 300.0, 0.92 * 300.0);

fn linear(v: i32) -> f64 {
    let v = f64::from(v) / 255.0;
    if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

/// A net over a grid of 5 by 5 vertices in a plane `z = slope x + height`, x and y from -2 to 2.
fn plane(slope: f64, height: f64) -> CyclidicNet {
    let at = |k: usize| ((k % 5) as f64 - 2.0, (k / 5) as f64 - 2.0);
    let points = (0..25).map(at).map(|(x, y)| Point3::new(x, y, slope * x + height)).collect();
    CyclidicNet::new(QuadGrid::new(points, [5, 5], [false; 2]).unwrap(), NetFrame::Auto).unwrap()
}

fn following(net: &CyclidicNet) -> Provenance {
    Provenance { kind: "cyclidic-net", given: Some(GivenSurface::from_grid(net.grid())), ..Provenance::default() }
}

#[test]
fn a_sphere_has_one_colour_of_gaussian_curvature() {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    let octant = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
    let model = Model::new(Units::Metre).with_surface("octant", octant);
    for colour in [PictureColour::Gaussian, PictureColour::Mean, PictureColour::K1, PictureColour::K2] {
        let picture = drawn(&model, &[], &options(colour, true)).0;
        // Light and lines change how bright a color is, not which it is: red, green and blue keep their shares. Pixels of the shadow are
        // grey, those of the outline mixed.
        let (x, y, half) = MIDDLE;
        let share = |[r, g, b]: [i32; 3]| linear(g) / (linear(r) + linear(g) + linear(b));
        // The octant is the quarter of a disc, whose corner is at the lower left.
        let own = share(at(&picture, x, y));
        let places = (0..400).map(|k| (0.05 * f64::from(k % 20) - 0.95, 0.05 * f64::from(k / 20) - 0.95));
        let inside = places.filter(|(u, v)| (u + 1.0).hypot(v + 1.0) < 1.9);
        let near = inside.map(|(u, v)| share(at(&picture, x + half * u, y - half * v)));
        let off = near.map(|other| (other - own).abs()).fold(0.0, f64::max);
        // A step of the screen in dark lines is a fiftieth.
        assert!(off < 0.02, "{colour:?}: {off}");
        assert!((own - 1.0 / 3.0).abs() > 0.02, "{colour:?} is no grey: {own}");
    }
}

#[test]
fn a_torus_changes_the_sign_of_its_gaussian_curvature_on_top() {
    let ring = DupinCyclide::new(3.0, 0.0, 1.0).unwrap().nets([8, 8]).unwrap().remove(0);
    let model = Model::new(Units::Metre).with_surface("ring", ring);
    let picture = drawn(&model, &[], &options(PictureColour::Gaussian, true)).0;
    // The outline is a circle of radius 4.
    let (x, y, half) = MIDDLE;
    let unit = half / 4.0;
    // In a direction between lines.
    let place = |radius: f64| at(&picture, x + unit * radius * 0.21_f64.cos(), y - unit * radius * 0.21_f64.sin());
    let red = |radius: f64| place(radius)[0] - place(radius)[2];
    assert!(red(3.75) > 25, "bowls are red: {:?}", place(3.75));
    assert!(red(2.25) < -40, "saddles are blue: {:?}", place(2.25));
    // Where the angle of the tube is 87 and 93 degrees the curvature is a fortieth and less of the largest.
    assert!(red(3.04).abs() < 25 && red(2.96).abs() < 25, "zero is pale: {:?}", place(3.0));
    // Inside: the hole is paper, or shadow.
    assert!(red(0.5).abs() < 12);
    // The mean curvature is negative all over, seen from outside, -1/4 in the hole and -5/8 outside: one ramp, dark far from zero.
    let mean = drawn(&model, &[], &options(PictureColour::Mean, true)).0;
    let green = |radius: f64| at(&mean, x + unit * radius * 0.21_f64.cos(), y - unit * radius * 0.21_f64.sin())[1];
    assert!(green(2.25) > green(3.75) + 40, "{} {}", green(2.25), green(3.75));
}

#[test]
fn distances_have_the_sign_of_the_side_and_zero_is_pale() {
    let (given, skin) = (plane(0.0, 0.0), plane(0.1, 0.0));
    let model = Model::new(Units::Metre).with_surface("skin", skin.clone());
    let picture = drawn(&model, &[following(&given)], &options(PictureColour::Deviation, true)).0;
    let (x, y, half) = MIDDLE;
    // Off the lines on the skin.
    let place = |u: f64| at(&picture, x + half * u, y + half * 0.06);
    let red = |u: f64| place(u)[0] - place(u)[2];
    let up = skin.patch(0, 0).unit_normal(0.5, 0.5).z;
    assert!(
        red(0.9) * up.signum() as i32 > 60 && red(-0.9) * (up.signum() as i32) < -60,
        "{:?} {:?}",
        place(0.9),
        place(-0.9)
    );
    assert!(red(0.03).abs() < 22, "{:?}", place(0.03));
    // A skin that follows its surface everywhere is pale all over.
    let same = drawn(&model, &[following(&skin)], &options(PictureColour::Deviation, true)).0;
    for u in [-0.9, -0.4, 0.1, 0.6] {
        let [r, _, b] = at(&same, x + half * u, y + half * 0.06);
        assert!((r - b).abs() < 14, "{r} {b}");
    }
}

/// Rows of a picture, in its lower part, with a long line of pixels of saturated colors.
fn bars(picture: &Pixmap) -> Vec<usize> {
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let vivid = |x: usize, y: usize| {
        let [r, g, b] = at(picture, x as f64, y as f64);
        r.max(g).max(b) - r.min(g).min(b) > 30
    };
    (height * 82 / 100..height).filter(|y| (0..width).filter(|x| vivid(*x, *y)).count() > width / 4).collect()
}

#[test]
fn pictures_of_a_quantity_have_one_scale_and_name_what_lacks_it() {
    let (given, skin) = (plane(0.0, 0.0), plane(0.1, 0.0));
    let other = plane(0.0, -3.0);
    let mut model = Model::new(Units::Metre).with_surface("skin", skin);
    model = model.with_surface("plate", other);
    let provenance = [following(&given), Provenance { kind: "cyclidic-net", ..Provenance::default() }];
    let front = |colour| ExportOptions { camera: "20,40".parse().ok(), ..options(colour, false) };
    let (picture, _) = drawn(&model, &provenance, &front(PictureColour::Deviation));
    let rows = bars(&picture);
    // Without a gap: one bar, 20 pixels high in a picture of the usual width.
    let scale = 0.5_f64.sqrt();
    assert_eq!(rows.len(), rows.last().unwrap() - rows[0] + 1);
    assert!((rows.len() as f64 - 20.0 * scale).abs() <= 3.0, "{rows:?}");
    // The plate, below, is grey, which nothing else is.
    let grey = |picture: &Pixmap| {
        picture.pixels().iter().filter(|p| p.red().abs_diff(p.blue()) < 14 && (120..186).contains(&p.red())).count()
    };
    let plain = drawn(&model, &provenance, &front(PictureColour::Object)).0;
    assert!(grey(&picture) > 10_000 + grey(&plain), "{} {}", grey(&picture), grey(&plain));
    assert!(bars(&plain).is_empty());
    // Both have curvatures, of the value 0: no grey, and a bar of one pale color.
    let flat = drawn(&model, &provenance, &front(PictureColour::Mean)).0;
    assert!(bars(&flat).is_empty() && grey(&flat) < 10_000 + grey(&plain));
    // What no object has leaves the picture as it is.
    let none = drawn(&model, &[], &front(PictureColour::Deviation)).0;
    assert!(none == plain);
}

#[test]
fn pictures_are_as_high_as_asked_for() {
    let ring = DupinCyclide::new(3.0, 0.0, 1.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let circle = cyclide::curve::Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0).unwrap();
    let surface = Model::new(Units::Metre).with_surface("ring", ring);
    let curve = Model::new(Units::Metre).with_curve("round", circle);
    for model in [&surface, &curve] {
        for (width, height) in [(400, 260), (400, 900), (900, 250), (1600, 300)] {
            let sized = ExportOptions { png_width: Some(width), png_height: Some(height), ..ExportOptions::default() };
            let picture = drawn(model, &[], &sized).0;
            assert_eq!((picture.width(), picture.height()), (width, height));
        }
        for (height, message) in
            [(149, "150 to 10000"), (10_001, "150 to 10000"), (170, "leaves no room for the drawing")]
        {
            let sized = ExportOptions { png_height: Some(height), ..ExportOptions::default() };
            let error = Exporter::new(model).unwrap().export(Format::Png, &sized).unwrap_err();
            assert!(error.to_string().contains(message) && error.reason() == "picture", "{error}");
        }
    }
}

#[test]
fn panels_in_sight_are_numbered() {
    let labeled = |width, camera: &str| ExportOptions {
        png_labels: true,
        png_width: Some(width),
        camera: camera.parse().ok(),
        ..ExportOptions::default()
    };
    let model = Model::new(Units::Metre).with_surface("plate", plane(0.0, 0.0));
    let note = |model: &Model, options: &ExportOptions| drawn(model, &[], options).1.notes.join("\n");
    assert_eq!(
        note(&model, &labeled(1600, "top")),
        "r03-c07 is row 3, column 7; 16 of 16 panels are numbered, 16 are visible"
    );
    // Seen edge on there is no room.
    assert!(note(&model, &labeled(1600, "front")).contains("no panel is numbered"));
    let ring = DupinCyclide::new(3.0, 0.0, 1.0).unwrap().nets([24, 16]).unwrap().remove(0);
    let two = model.clone().with_surface("ring", ring);
    let said = note(&two, &labeled(1600, "40,50"));
    assert!(said.contains(" of 400 panels are numbered, "), "{said}");
    // Text is drawn where there was none.
    let dark = |options: &ExportOptions| drawn(&model, &[], options).0.pixels().iter().filter(|p| p.red() < 60).count();
    let plain = ExportOptions { png_labels: false, ..labeled(1600, "top") };
    assert!(dark(&labeled(1600, "top")) > dark(&plain) + 1000);
}

#[test]
fn fields_show_mesh_directions_umbilics_and_grids() {
    // A grid of squares on a plane, the directions along x, and an umbilic in the middle.
    let net = plane(0.0, 0.0);
    let surface = GivenSurface::from_grid(net.grid());
    let along = vec![Vec3::X; surface.triangles.len()];
    let field = LaidField { surface, along, umbilics: vec![(Point3::new(0.5, 0.5, 0.0), 1)] };
    let mut model = Model::new(Units::Metre);
    model.items.push(Item::new("lattice", GridObject::apart(vec![net.grid().clone()]).unwrap()));
    model.items.push(Item::new("skin", vec![SurfaceObject::Net(net)]));
    let given = [Provenance { kind: "principal-grid", field: Some(field), ..Provenance::default() }];
    let (picture, file) = drawn(&model, &given, &options(PictureColour::Field, true));
    assert_eq!(file.notes, ["omitted from the picture of the lines of curvature: skin"]);
    let (x, y, half) = MIDDLE;
    let place = |u: f64, v: f64| at(&picture, x + 0.5 * half * u, y - 0.5 * half * v);
    let [r, g, b] = place(0.5, 0.5);
    assert!(r > 150 && r > b + 40 && b > g + 20, "an umbilic: {r} {g} {b}");
    // Lines along s, of constant y, are blue, those across red; between them is the mesh.
    let blue = |u: f64, v: f64| place(u, v)[2] - place(u, v)[0];
    let near = |u: f64, v: f64, d: [f64; 2]| {
        (-8..=8).map(|k| blue(u + 0.004 * f64::from(k) * d[0], v + 0.004 * f64::from(k) * d[1])).collect::<Vec<_>>()
    };
    assert!(near(0.25, 1.0, [0.0, 1.0]).iter().any(|v| *v > 45), "{:?}", near(0.25, 1.0, [0.0, 1.0]));
    assert!(near(-1.0, -0.25, [1.0, 0.0]).iter().any(|v| *v < -45), "{:?}", near(-1.0, -0.25, [1.0, 0.0]));
    // Without a field the picture is that of the objects.
    let (plain, with) = (options(PictureColour::Object, true), options(PictureColour::Field, true));
    assert!(drawn(&model, &[], &plain).0 == drawn(&model, &[], &with).0);
}
