//! What a kind of object says of itself: all that the rest of the program asks about it.

use cyclide::{
    model::{CurveObject, GridObject, SurfaceObject},
    motion::MovingBody,
    surface::{Torus, TorusSpline},
    topology::Body,
    volume::CyclideVolume,
};

use crate::document::angle::Angle;
use crate::document::coordinates::PointSource;
use crate::document::locate::Step;
use crate::document::objects::contours::{Contour, ContourFacts};
use crate::document::objects::idle::Idle;
use crate::document::objects::wavers::WaverRule;
use crate::document::objects::{Builder, BuiltObject};
use crate::error::Result;

/// The path of a field below the object, and the name of another object in it.
pub(in crate::document) type Reference<'a> = (Vec<Step>, &'a str);

/// A kind of object. Only its construction has to be said; the rest is what most kinds have.
pub(in crate::document) trait Kind {
    /// Runs the construction.
    ///
    /// # Errors
    /// What the kernel refuses, and fields that do not fit together, at their places.
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape>;

    /// The names of the objects it is made from.
    fn references(&self) -> Vec<Reference<'_>> {
        Vec::new()
    }

    /// The points that a curve is made from.
    fn points(&self) -> Option<&PointSource> {
        None
    }

    /// The files that it is made from, as the document writes them.
    fn files(&self) -> Vec<&str> {
        match self.points() {
            Some(PointSource::File(file)) => vec![file.csv.as_str()],
            _ => Vec::new(),
        }
    }

    /// True where equal neighboring points are meant as they are.
    fn keeps_repeated_points(&self) -> bool {
        false
    }

    /// True where points that are marked as corners stay corners.
    fn keeps_corners(&self) -> bool {
        true
    }

    /// The angle above which turns of the points are corners, if one is given.
    fn corner_angle(&self) -> Option<Angle> {
        None
    }

    /// The fields that make no difference to one of its contours.
    fn idle_fields(&self, _: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        Vec::new()
    }

    /// How a curve is looked at that bends to and fro; `None` where that is its shape.
    fn wavers(&self) -> Option<WaverRule> {
        None
    }

    /// What its document calls the fields of the kernel's paths, where that is something else.
    fn fields(&self) -> FieldNames {
        Vec::new()
    }

    /// What an error of the kernel is called for this kind, if that is other than what it is called in general.
    fn words(&self, _: &cyclide::Error) -> Option<String> {
        None
    }

    /// The bound that is promised on the distance to what it is made from, if it is a field.
    fn tolerance(&self) -> Option<f64> {
        None
    }

    /// The torus that it is, by the name that it has; `None` of what is none by its kind.
    fn torus(&self, _: &Builder<'_>, _name: &str) -> Option<Result<Torus>> {
        None
    }

    /// The spline of arcs on a torus that it is, if it is one circle of that.
    fn circle_of_torus(&self, _: &Builder<'_>) -> Option<Result<TorusSpline>> {
        None
    }

    /// True for the image of another object.
    fn is_image(&self) -> bool {
        false
    }

    /// Whether its patches are panels, as those of nets.
    fn has_panels(&self, _source: Option<&BuiltObject>) -> bool {
        false
    }

    /// What it is the solid over.
    fn skin(&self, _source: Option<&BuiltObject>) -> Vec<SurfaceObject> {
        Vec::new()
    }

    /// What it is of the panels of another object.
    fn of_panels(&self) -> Option<OfPanels> {
        None
    }

    /// Remarks on what was made.
    fn remark_on(&self, _: &mut Builder<'_>, _: &Shape, _: &[Body]) {}
}

/// What an object is of the panels of another, whose name it has.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum OfPanels {
    /// Their other side at a distance, or the solid between both.
    OtherSide { of: String, distance: f64, solid: bool },
    /// Their edges.
    Edges { of: String },
}

/// Pairs of a path of the kernel and the field that it is in a document: `tangents` with any entry or none, which is kept;
/// `tangents[0]` with this entry and `tangents[]` with any or none, which is not kept. The main list is the path without a name.
pub(in crate::document) type FieldNames = Vec<(&'static str, &'static str)>;

/// The field for everything that the kernel names no field for.
pub(in crate::document) fn main_field(name: &'static str) -> FieldNames {
    vec![("[]", name)]
}

/// What a construction makes: curves, grids, surfaces, blocks or a motion.
pub(in crate::document) enum Shape {
    Curves(Vec<(CurveObject, ContourFacts)>),
    Grids(Box<GridObject>),
    Surfaces(Vec<SurfaceObject>),
    /// With the parameters of their cells, if they are divided.
    Blocks(Vec<CyclideVolume>, Option<[Vec<f64>; 3]>),
    Motion(Box<MovingBody>),
}

impl Shape {
    /// Curves of which there is no more to be said.
    pub(in crate::document) fn plain(curves: Vec<CurveObject>) -> Self {
        Self::Curves(curves.into_iter().map(|curve| (curve, ContourFacts::default())).collect())
    }
}

impl From<CurveObject> for Shape {
    fn from(curve: CurveObject) -> Self {
        Self::plain(vec![curve])
    }
}

impl From<SurfaceObject> for Shape {
    fn from(surface: SurfaceObject) -> Self {
        Self::Surfaces(vec![surface])
    }
}

/// The name of another object in the field `of`.
pub(in crate::document) fn of(name: &str) -> Vec<Reference<'_>> {
    vec![(vec![Step::from("of")], name)]
}

/// The names of two curves.
pub(in crate::document) fn rails(names: &[String; 2]) -> Vec<Reference<'_>> {
    names.iter().enumerate().map(|(k, name)| (vec![Step::from("rails"), Step::from(k)], name.as_str())).collect()
}
