//! Named objects with units: what a document builds and what exporters read.

use super::chain::CurveChain;
use super::grid_object::GridObject;
use super::lower::{Lower, Lowered};
use super::surface_object::SurfaceObject;
use crate::curve::{Arc, ArcPath, Circle, CircleSpline, ParamCurve, QbSpline};
use crate::error::Result;
use crate::motion::MovingBody;
use crate::rational::NurbsCurve;
use crate::surface::TorusSpline;
use crate::volume::CyclideVolume;

/// What one unit of the coordinates means. Coordinates are never rescaled; units label them.
///
/// ```
/// use cyclide::model::Units;
/// assert_eq!((Units::Inch.symbol(), Units::Inch.in_millimetres()), ("in", 25.4));
/// assert_eq!(Units::from_symbol("m"), Some(Units::Metre));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(inline, description = "The units of a document.")
)]
pub enum Units {
    /// Millimeters.
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "mm"))]
    Millimetre,
    /// Centimeters.
    #[cfg_attr(feature = "serde", serde(rename = "cm"))]
    Centimetre,
    /// Meters.
    #[cfg_attr(feature = "serde", serde(rename = "m"))]
    Metre,
    /// Inches.
    #[cfg_attr(feature = "serde", serde(rename = "in"))]
    Inch,
    /// Feet.
    #[cfg_attr(feature = "serde", serde(rename = "ft"))]
    Foot,
    /// US survey feet, 1200/3937 m, 2 parts in a million longer than a foot: used on older maps of the United States.
    #[cfg_attr(feature = "serde", serde(rename = "us-ft"))]
    UsSurveyFoot,
}

impl Units {
    /// Every unit.
    pub const ALL: [Self; 6] =
        [Self::Millimetre, Self::Centimetre, Self::Metre, Self::Inch, Self::Foot, Self::UsSurveyFoot];

    /// The symbol used in documents and on the command line: `mm`, `cm`, `m`, `in`, `ft`, `us-ft`.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "in",
            Self::Foot => "ft",
            Self::UsSurveyFoot => "us-ft",
        }
    }

    /// Length of one unit in millimeters.
    #[must_use]
    pub const fn in_millimetres(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Centimetre => 10.0,
            Self::Metre => 1000.0,
            Self::Inch => 25.4,
            Self::Foot => 304.8,
            Self::UsSurveyFoot => 1_200_000.0 / 3937.0,
        }
    }

    /// The unit with this symbol.
    #[must_use]
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|u| u.symbol() == symbol)
    }
}

/// Any curve of the kernel.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, length}, model::CurveObject};
/// let object = CurveObject::from(Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?);
/// assert!((length(object.as_curve()) - std::f64::consts::TAU).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum CurveObject {
    /// One arc or segment.
    Arc(Arc),
    /// A full circle.
    Circle(Circle),
    /// Biarc, arc spline or fitted arcs.
    ArcPath(ArcPath),
    /// A circle spline of either variant.
    CircleSpline(CircleSpline),
    /// A spline on a torus.
    TorusSpline(TorusSpline),
    /// A rational B-spline curve.
    Nurbs(NurbsCurve),
    /// Quaternionic Bézier curves end to end, or one.
    QbSpline(QbSpline),
}

impl CurveObject {
    /// The curve behind the name.
    #[must_use]
    pub fn as_curve(&self) -> &dyn ParamCurve {
        match self {
            Self::Arc(c) => c,
            Self::Circle(c) => c,
            Self::ArcPath(c) => c,
            Self::CircleSpline(c) => c,
            Self::TorusSpline(c) => c,
            Self::Nurbs(c) => c,
            Self::QbSpline(c) => c,
        }
    }

    fn as_lower(&self) -> &dyn Lower {
        match self {
            Self::Arc(c) => c,
            Self::Circle(c) => c,
            Self::ArcPath(c) => c,
            Self::CircleSpline(c) => c,
            Self::TorusSpline(c) => c,
            Self::Nurbs(c) => c,
            Self::QbSpline(c) => c,
        }
    }
}

impl Lower for CurveObject {
    fn lower_to_chain(&self, tolerance: f64) -> Result<Lowered<CurveChain>> {
        self.as_lower().lower_to_chain(tolerance)
    }
    fn lower_to_arcs(&self, tolerance: f64) -> Result<Lowered<ArcPath>> {
        self.as_lower().lower_to_arcs(tolerance)
    }
}

/// What an object is made of: curves, grids, surfaces, volumes or a motion, never two of them. A construction that makes both makes two objects.
/// Grids are not the curves that are drawn of them: whoever writes curves takes their lines by [`Item::curves`], whoever makes nets the grids
/// by [`Item::grids`].
///
/// The list is closed on purpose: objects of another kind are a new variant, and the compiler then names
/// every writer, check and report that has to think of them.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle, model::{CurveObject, Geometry}};
/// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?;
/// let geometry = Geometry::from(vec![CurveObject::from(circle)]);
/// assert!(matches!(&geometry, Geometry::Curves(contours) if contours.len() == 1));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Geometry {
    /// Connected curves: contours.
    Curves(Vec<CurveObject>),
    /// Grids of quads, with their lines.
    Grids(Box<GridObject>),
    /// Surfaces, each one body, or several where it hangs together in points only.
    Surfaces(Vec<SurfaceObject>),
    /// Volumes: blocks.
    Volumes(Vec<CyclideVolume>),
    /// A moving body.
    Motion(Box<MovingBody>),
}

impl Default for Geometry {
    /// No curve.
    fn default() -> Self {
        Self::Curves(Vec::new())
    }
}

impl From<Vec<CurveObject>> for Geometry {
    fn from(contours: Vec<CurveObject>) -> Self {
        Self::Curves(contours)
    }
}

impl From<GridObject> for Geometry {
    fn from(grids: GridObject) -> Self {
        Self::Grids(Box::new(grids))
    }
}

impl From<Vec<SurfaceObject>> for Geometry {
    fn from(surfaces: Vec<SurfaceObject>) -> Self {
        Self::Surfaces(surfaces)
    }
}

impl From<Vec<CyclideVolume>> for Geometry {
    fn from(volumes: Vec<CyclideVolume>) -> Self {
        Self::Volumes(volumes)
    }
}

impl From<MovingBody> for Geometry {
    fn from(body: MovingBody) -> Self {
        Self::Motion(Box::new(body))
    }
}

/// A named object made by one construction. How it was made, what was said about it and what it was made from is known to
/// whoever ran the construction.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle, model::{CurveObject, Item}};
/// let ring = |radius| Circle::from_radius(Point3::ORIGIN, Vec3::Z, radius).map(CurveObject::from);
/// let item = Item::new("washer", vec![ring(6.0)?, ring(3.2)?]);
/// assert_eq!((item.name.as_str(), item.curves().len(), item.surfaces().len()), ("washer", 2, 0));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Item {
    /// Name, unique in the model.
    pub name: String,
    /// Its curves, its grids, its surfaces, its volumes or its motion.
    pub geometry: Geometry,
}

impl Item {
    /// An object of curves, of grids, of surfaces, of volumes or of a motion. Names tell objects apart in files: give each its own.
    #[must_use]
    pub fn new(name: impl Into<String>, geometry: impl Into<Geometry>) -> Self {
        Self { name: name.into(), geometry: geometry.into() }
    }

    /// Its connected curves, of grids their lines; none of an object of another kind.
    #[must_use]
    pub fn curves(&self) -> &[CurveObject] {
        match &self.geometry {
            Geometry::Curves(contours) => contours,
            Geometry::Grids(laid) => laid.lines(),
            Geometry::Surfaces(_) | Geometry::Volumes(_) | Geometry::Motion(_) => &[],
        }
    }

    /// Its grids, if it is made of these.
    #[must_use]
    pub fn grids(&self) -> Option<&GridObject> {
        if let Geometry::Grids(laid) = &self.geometry { Some(laid) } else { None }
    }

    /// Its motion, if it is one.
    #[must_use]
    pub fn motion(&self) -> Option<&MovingBody> {
        match &self.geometry {
            Geometry::Motion(body) => Some(body),
            _ => None,
        }
    }

    /// Its surfaces; none of an object of another kind.
    #[must_use]
    pub fn surfaces(&self) -> &[SurfaceObject] {
        match &self.geometry {
            Geometry::Surfaces(surfaces) => surfaces,
            Geometry::Curves(_) | Geometry::Grids(_) | Geometry::Volumes(_) | Geometry::Motion(_) => &[],
        }
    }

    /// Its blocks; none of an object of another kind.
    #[must_use]
    pub fn volumes(&self) -> &[CyclideVolume] {
        match &self.geometry {
            Geometry::Volumes(volumes) => volumes,
            Geometry::Curves(_) | Geometry::Grids(_) | Geometry::Surfaces(_) | Geometry::Motion(_) => &[],
        }
    }
}

/// Named objects and the unit of their coordinates.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle, model::{Model, Units}, surface::DupinCyclide};
/// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?;
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let model = Model::new(Units::Millimetre).with_curve("rim", circle).with_surface("ring", torus);
/// assert_eq!(model.items.len(), 2);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Model {
    /// Unit of all coordinates.
    pub units: Units,
    /// The objects, in the document's order.
    pub items: Vec<Item>,
}
