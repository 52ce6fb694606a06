//! PNG pictures: they show the model, whatever its size, and are the same every time.

use crate::models::{self, flat, mixed, space_chain, splines, tilted};
use cyclide::{
    Point3, Vec3,
    curve::Circle,
    model::{CurveObject, Item, Model, Units},
    surface::CyclidePatch,
};
use cyclide_io::{ExportOptions, Format, formats::export};
use tiny_skia::Pixmap;

fn model(surface: CyclidePatch) -> Model {
    Model::new(Units::Millimetre).with_surface("object", surface)
}

fn patch(corners: [[f64; 3]; 4], v1: [f64; 3], v2: [f64; 3]) -> CyclidePatch {
    let corners = corners.map(Point3::from);
    CyclidePatch::from_corners_and_frame(corners, Vec3::from(v1), Vec3::from(v2)).unwrap()
}

/// A vault over a square.
fn vault(size: f64) -> CyclidePatch {
    let s = size;
    patch([[0.0; 3], [s, 0.0, 0.0], [0.0, s, 0.0], [s, s, 0.0]], [0.6, 0.0, 0.8], [0.0, 1.0, 0.0])
}

/// An eighth of a sphere: one side is a point.
fn octant() -> CyclidePatch {
    patch([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])
}

fn bytes(model: &Model) -> Vec<u8> {
    export(model, Format::Png, &ExportOptions::default()).unwrap().bytes
}

/// The picture without title and scale bar, which say how large the model is.
fn picture(model: &Model) -> Pixmap {
    let options = ExportOptions { png_plain: true, ..ExportOptions::default() };
    let bytes = export(model, Format::Png, &options).unwrap().bytes;
    let picture = Pixmap::decode_png(&bytes).unwrap();
    assert_eq!((picture.width(), picture.height()), (1600, 1200));
    picture
}

/// Share of the pixels less red than the paper by a tenth of the scale: the model, which is blue, and the deep of its shadow.
fn ink(picture: &Pixmap) -> f64 {
    let paper = i32::from(picture.pixels()[0].red());
    let dark = picture.pixels().iter().filter(|p| paper - i32::from(p.red()) > 25).count();
    dark as f64 / picture.pixels().len() as f64
}

#[test]
fn pictures_do_not_depend_on_size_or_run() {
    let reference = picture(&model(vault(1.0)));
    assert!((0.2..0.7).contains(&ink(&reference)), "{}", ink(&reference));
    assert_eq!(bytes(&model(vault(1.0))), bytes(&model(vault(1.0))));
    for size in [1e-9, 0.3, 1e9] {
        let other = picture(&model(vault(size)));
        let difference = |(a, b): (&u8, &u8)| f64::from(a.abs_diff(*b));
        let sum: f64 = reference.data().iter().zip(other.data()).map(difference).sum();
        // Rounding moves a sample at an edge here and there.
        assert!(sum / (reference.data().len() as f64) < 0.01, "size {size}: {sum}");
    }
}

#[test]
fn awkward_surfaces_have_pictures() {
    let level = patch([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]], [0.6, 0.8, 0.0], [-0.8, 0.6, 0.0]);
    // In a plane through the usual eye, where another place is chosen to look from.
    let edge_on = patch(
        [[0.0; 3], [0.5, -0.8, 0.0], [0.0, 0.0, 1.0], [0.5, -0.8, 1.0]],
        [0.5 / 0.89f64.sqrt(), -0.8 / 0.89f64.sqrt(), 0.0],
        [0.0, 0.0, 1.0],
    );
    let sliver =
        patch([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1e-6, 0.0], [1.0, 1e-6, 0.0]], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    for (name, surface, least) in
        [("level", level, 0.3), ("edge on", edge_on, 0.1), ("octant", octant(), 0.1), ("sliver", sliver, 0.0)]
    {
        let share = ink(&picture(&model(surface)));
        assert!(share >= least && share < 0.9, "{name}: {share}");
    }
}

/// A ring under the vault is hidden by it, one above it is seen.
/// Blocks show surfaces of three families, the inner ones where a corner is cut away; cells move their lines.
#[test]
fn blocks_show_their_inside() {
    let corners: [Point3; 7] =
        std::array::from_fn(|k| Point3::new((k & 1) as f64, (k >> 1 & 1) as f64, (k >> 2) as f64));
    let cube = cyclide::volume::SphericalCube::new(corners).unwrap();
    let block = cyclide::volume::CyclideVolume::new(&cube, cyclide::volume::VolumeFrame::Auto).unwrap();
    let mut model = Model::new(Units::Millimetre);
    model.items.push(Item::new("box", vec![block]));
    let whole = picture(&model);
    // Hues apart: blue is bluest, sand reddest, green greenest.
    let share = |picture: &Pixmap, is: &dyn Fn(i32, i32, i32) -> bool| {
        let pixels = picture.pixels();
        let of = |p: &&tiny_skia::PremultipliedColorU8| is(p.red().into(), p.green().into(), p.blue().into());
        pixels.iter().filter(of).count() as f64 / pixels.len() as f64
    };
    let families = |picture: &Pixmap| {
        [
            share(picture, &|r, _, b| b > r + 25),
            share(picture, &|r, _, b| r > b + 25),
            share(picture, &|r, g, b| g > r + 15 && g > b + 8),
        ]
    };
    assert!(families(&whole).iter().all(|part| *part > 0.03), "{:?}", families(&whole));
    // The right face is seen at a slant; with the corner cut away the inner one is seen besides, at about the same.
    let halves = || vec![0.0, 0.5, 1.0];
    let one = || vec![0.0, 1.0];
    let divided = |places| {
        let given =
            [cyclide_io::export::Provenance { kind: "cyclide-volume", places: Some(places), ..Default::default() }];
        let options = ExportOptions { png_plain: true, ..ExportOptions::default() };
        let exporter = cyclide_io::Exporter::with_provenance(&model, &given).unwrap();
        Pixmap::decode_png(&exporter.export(Format::Png, &options).unwrap().bytes).unwrap()
    };
    let (cut, plain) = (divided([halves(), halves(), halves()]), divided([one(), one(), one()]));
    let area = |picture: &Pixmap| families(picture).iter().sum::<f64>();
    // A corner that is cut off towards the eye leaves the outline as it is, but for that corner.
    assert!((area(&cut) / area(&plain) - 1.0).abs() < 0.06, "{} {}", area(&cut), area(&plain));
    let differing = cut.pixels().iter().zip(plain.pixels()).filter(|(a, b)| a.red().abs_diff(b.red()) > 12).count();
    assert!(differing as f64 > 0.02 * cut.pixels().len() as f64, "{differing}");
}

#[test]
fn curves_are_hidden_by_surfaces() {
    // The ring is the first object, for the dark color.
    let vault_with = |contours: Vec<CurveObject>| {
        let ring = Model { items: vec![Item::new("ring", contours)], ..Model::default() };
        picture(&ring.with_surface("vault", vault(1.0)))
    };
    let ring =
        |y: f64, z: f64| vec![CurveObject::Circle(Circle::from_radius(Point3::new(0.5, y, z), Vec3::Z, 0.1).unwrap())];
    // Pixels of nearly full ink: the rings, and where the vault's borders are seen at a slant.
    let dark = |p: &Pixmap| p.pixels().iter().filter(|p| p.green() < 80).count();
    let alone = dark(&vault_with(vec![]));
    assert_eq!(dark(&vault_with(ring(0.8, 0.05))), alone, "the vault stands between the ring and the eye");
    assert!(dark(&vault_with(ring(0.5, 0.4))) > alone + 500);
}

/// Width, height and the share of pixels that differ from the paper in the corner.
fn measured(bytes: &[u8]) -> (u32, u32, f64) {
    let pixels = Pixmap::decode_png(bytes).unwrap();
    let paper = pixels.pixels()[0];
    let ink = pixels.pixels().iter().filter(|p| **p != paper).count();
    (pixels.width(), pixels.height(), ink as f64 / pixels.pixels().len() as f64)
}

#[test]
fn pictures_are_full_and_reproducible() {
    let space = models::model(vec![("s", vec![CurveObject::ArcPath(space_chain())])]);
    for m in [mixed(flat), mixed(tilted), space].into_iter().chain(splines().into_iter().map(|(_, m)| m)) {
        let bytes = || export(&m, Format::Png, &ExportOptions::default()).unwrap().bytes;
        let (width, height, ink) = measured(&bytes());
        assert!(width == 1600 && height <= 1200 || width <= 1600 && height == 1200, "{width} x {height}");
        assert!(ink > 0.01 && ink < 0.6, "{ink}");
        assert_eq!(bytes(), bytes());
    }
}

#[test]
fn a_straight_line_has_a_picture() {
    for end in [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 5.0], [1e-9, 0.0, 0.0], [1e9, 0.0, 0.0]] {
        let line = cyclide::curve::Arc::segment([0.0; 3].into(), end.into()).unwrap();
        let m = models::model(vec![("line", vec![CurveObject::Arc(line)])]);
        let (_, _, ink) = measured(&export(&m, Format::Png, &ExportOptions::default()).unwrap().bytes);
        assert!(ink > 0.001, "{end:?}");
    }
}
