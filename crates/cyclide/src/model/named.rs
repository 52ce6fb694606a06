//! Models made step by step, and what curves and surfaces become in them.

use super::object::{CurveObject, Item, Model, Units};
use super::surface_object::SurfaceObject;
use crate::construct::Biarc;
use crate::curve::{Arc, ArcPath, Circle, CircleSpline, QbSpline};
use crate::motion::MovingBody;
use crate::rational::NurbsCurve;
use crate::surface::{CyclidePatch, CyclidicNet, NetLayout, SmoothMesh, SphereBlend, TorusSpline, TriangleSurface};
use crate::topology::{Body, Shell};
use crate::volume::CyclideVolume;

impl Model {
    /// A model without objects.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, curve::Circle, model::{Model, Units}};
    /// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 30.0)?;
    /// let model = Model::new(Units::Millimetre).with_curve("rim", circle);
    /// assert_eq!(model.items[0].name, "rim");
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn new(units: Units) -> Self {
        Self { units, items: Vec::new() }
    }

    /// The model with one more object, a curve. Names tell objects apart in files: give each its own.
    #[must_use]
    pub fn with_curve(self, name: impl Into<String>, curve: impl Into<CurveObject>) -> Self {
        self.with(Item::new(name, vec![curve.into()]))
    }

    /// The model with one more object, a surface or a solid.
    #[must_use]
    pub fn with_surface(self, name: impl Into<String>, surface: impl Into<SurfaceObject>) -> Self {
        self.with(Item::new(name, vec![surface.into()]))
    }

    /// The model with one more object, a block.
    #[must_use]
    pub fn with_volume(self, name: impl Into<String>, volume: impl Into<CyclideVolume>) -> Self {
        self.with(Item::new(name, vec![volume.into()]))
    }

    /// The model with one more object, a moving body.
    #[must_use]
    pub fn with_motion(self, name: impl Into<String>, body: impl Into<MovingBody>) -> Self {
        self.with(Item::new(name, body.into()))
    }

    fn with(mut self, item: Item) -> Self {
        self.items.push(item);
        self
    }
}

/// Each as the variant of its name.
macro_rules! becomes {
    ($object:ident: $($source:ident => $variant:ident),*) => {
        $(impl From<$source> for $object {
            fn from(value: $source) -> Self {
                Self::$variant(value)
            }
        })*
    };
}

becomes!(CurveObject: Arc => Arc, Circle => Circle, ArcPath => ArcPath, CircleSpline => CircleSpline, TorusSpline => TorusSpline, QbSpline => QbSpline, NurbsCurve => Nurbs);
becomes!(SurfaceObject: CyclidePatch => Patch, CyclidicNet => Net, NetLayout => Layout, Body => Body, TriangleSurface => Triangles);

impl From<Biarc> for CurveObject {
    fn from(biarc: Biarc) -> Self {
        Self::ArcPath(biarc.to_path())
    }
}

impl From<SmoothMesh> for SurfaceObject {
    fn from(mesh: SmoothMesh) -> Self {
        Self::Triangles(mesh.into())
    }
}

impl From<SphereBlend> for SurfaceObject {
    fn from(blend: SphereBlend) -> Self {
        Self::Triangles(blend.into())
    }
}

impl From<Shell> for SurfaceObject {
    fn from(outer: Shell) -> Self {
        Self::Body(Body { outer, voids: Vec::new() })
    }
}
