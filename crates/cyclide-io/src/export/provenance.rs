//! How objects came about, as far as files say it or pictures show it.

use crate::export::given_surface::{GivenSurface, LaidField};
use cyclide::{
    Point3,
    curve::BlendLaw,
    model::{CurveObject, Geometry, Item, Model, SurfaceObject},
    surface::TriangleSurface,
};

/// The origin of an object: its construction, as named in documents, and the points that it approximates.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle, model::{Model, Units}};
/// use cyclide_io::{ExportOptions, Exporter, Format, export::Provenance};
/// let rim = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 30.0)?;
/// let model = Model::new(Units::Millimetre).with_curve("rim", rim);
/// let mirrored = [Provenance { kind: "transform", ..Provenance::default() }];
/// let exporter = Exporter::with_provenance(&model, &mirrored)?;
/// let file = exporter.export(Format::Json, &ExportOptions::default())?;
/// assert!(String::from_utf8(file.bytes)?.contains(r#""type": "transform""#));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Provenance {
    /// The type word of documents: `arc`, `circle-spline`, `transform`, ….
    pub kind: &'static str,
    /// The data points of a fit; empty for curves that pass through their points.
    pub data: Vec<Point3>,
    /// Points of a curve inside its pieces, such as all those of a `qb-interpolation`: pictures show them like joints.
    pub nodes: Vec<Point3>,
    /// Points with names in its table, and the names, with which pictures label them.
    pub point_names: Vec<(Point3, String)>,
    /// The parameters along s, t and u of the cell boundaries, if blocks are divided into cells: those of a
    /// [`StructuredGrid`](cyclide::volume::StructuredGrid).
    pub places: Option<[Vec<f64>; 3]>,
    /// Suffixes that distinguish its surfaces in files after the name of the object, if not numbers: one for each,
    /// all different.
    pub names: Vec<String>,
    /// The surface that it approximates: pictures show the distance from it.
    pub given: Option<GivenSurface>,
    /// The field of the surface along whose lines of curvature its grids were laid.
    pub field: Option<LaidField>,
    /// The surface of which it is the solid, if it is the one between a surface and its offset: pictures number the panels of
    /// nets on it.
    pub skin: Vec<SurfaceObject>,
    /// True if its patches are panels, which are made one by one: files keep them separate.
    pub panels: bool,
}

/// The objects of a model with how they came about, where that is known.
#[derive(Clone, Copy)]
pub(crate) struct Provenances<'a> {
    model: &'a Model,
    given: &'a [Provenance],
}

impl<'a> Provenances<'a> {
    /// Of a model whose first objects came about as given.
    pub(crate) const fn new(model: &'a Model, given: &'a [Provenance]) -> Self {
        Self { model, given }
    }

    /// What files call the construction of an object: the word given, else that of the shortest document with such geometry.
    pub(crate) fn kind(&self, item: usize) -> &'static str {
        match (self.given.get(item), self.model.items.get(item)) {
            (Some(given), _) => given.kind,
            (None, Some(item)) => kind_of(item),
            (None, None) => "",
        }
    }

    /// The parameters of the cells of an object's blocks, if it divides them.
    pub(crate) fn places(&self, item: usize) -> Option<&'a [Vec<f64>; 3]> {
        self.given.get(item)?.places.as_ref()
    }

    /// The name of one of an object's surfaces, if it has one.
    pub(crate) fn name_of_surface(&self, item: usize, surface: usize) -> Option<&'a str> {
        self.given.get(item)?.names.get(surface).map(String::as_str)
    }

    /// The surface that an object was made to follow.
    #[cfg(feature = "png")]
    pub(crate) fn given(&self, item: usize) -> Option<&'a GivenSurface> {
        self.given.get(item)?.given.as_ref()
    }

    /// What was found on the surface along whose lines of curvature an object's grids were laid.
    #[cfg(feature = "png")]
    pub(crate) fn field(&self, item: usize) -> Option<&'a LaidField> {
        self.given.get(item)?.field.as_ref()
    }

    /// What an object is the solid over.
    #[cfg(feature = "png")]
    pub(crate) fn skin(&self, item: usize) -> &'a [SurfaceObject] {
        self.given.get(item).map_or(&[], |given| &given.skin)
    }

    /// Whether the patches of an object are panels.
    pub(crate) fn has_panels(&self, item: usize) -> bool {
        self.given.get(item).is_some_and(|given| given.panels)
    }

    /// The points that the objects were laid through besides their joints.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = Point3> + use<'a> {
        self.given.iter().flat_map(|given| given.nodes.iter().copied())
    }

    /// What the points of the objects are called.
    #[cfg(feature = "png")]
    pub(crate) fn point_names(&self) -> impl Iterator<Item = (Point3, &'a str)> + use<'a> {
        self.given.iter().flat_map(|given| given.point_names.iter().map(|(point, name)| (*point, name.as_str())))
    }

    /// The points that the objects were made near.
    #[cfg(any(feature = "png", test))]
    pub(crate) fn data(&self) -> impl Iterator<Item = Point3> + use<'a> {
        self.given.iter().flat_map(|given| given.data.iter().copied())
    }
}

/// The word for an object by its first curve or surface; none for an object without one.
fn kind_of(item: &Item) -> &'static str {
    match &item.geometry {
        Geometry::Curves(contours) => contours.first().map_or("", kind_of_curve),
        Geometry::Grids(_) => "principal-grid",
        Geometry::Surfaces(surfaces) => surfaces.first().map_or("", kind_of_surface),
        Geometry::Volumes(_) => "cyclide-volume",
        Geometry::Motion(_) => "motion",
    }
}

fn kind_of_curve(curve: &CurveObject) -> &'static str {
    match curve {
        CurveObject::Arc(_) => "arc",
        CurveObject::Circle(_) => "circle",
        CurveObject::ArcPath(_) => "arc-spline",
        CurveObject::CircleSpline(spline) => match spline.segments().first().map(cyclide::curve::BlendSegment::law) {
            Some(BlendLaw::Fair { .. }) => "fair-spline",
            _ => "circle-spline",
        },
        CurveObject::TorusSpline(_) => "torus-spline",
        CurveObject::Nurbs(_) => "nurbs",
        CurveObject::QbSpline(spline) if spline.spans().len() > 1 => "moebius-spline",
        CurveObject::QbSpline(_) => "qb-interpolation",
    }
}

fn kind_of_surface(surface: &SurfaceObject) -> &'static str {
    match surface {
        SurfaceObject::Patch(_) => "cyclide-patch",
        SurfaceObject::Net(_) | SurfaceObject::Layout(_) => "cyclidic-net",
        SurfaceObject::Body(_) => "body",
        SurfaceObject::Triangles(TriangleSurface::Mesh(_)) => "smooth-mesh",
        SurfaceObject::Triangles(TriangleSurface::Blend(_)) => "sphere-blend",
    }
}

#[cfg(test)]
mod tests {
    use super::{Provenance, Provenances};
    use cyclide::{
        Point3, Vec3,
        curve::Circle,
        model::{Geometry, Item, Model, Units},
    };

    #[test]
    fn what_is_not_given_is_called_by_its_geometry() {
        let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0).unwrap();
        let mut model = Model::new(Units::Metre).with_curve("a", circle).with_curve("b", circle);
        model.items.push(Item::new("c", Geometry::default()));
        let given = [Provenance { kind: "transform", data: vec![Point3::ORIGIN], ..Provenance::default() }];
        let known = Provenances::new(&model, &given);
        assert_eq!([0, 1, 2, 3].map(|item| known.kind(item)), ["transform", "circle", "", ""]);
        assert_eq!(known.data().collect::<Vec<_>>(), [Point3::ORIGIN]);
    }
}
