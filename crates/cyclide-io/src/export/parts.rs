//! The parts of a model as every format sees them, in the order in which every format writes them: connected curves and
//! bodies, each with the object that it belongs to.

use crate::export::error::ExportError;
use crate::export::provenance::Provenances;
use crate::export::shape::Shape;
use cyclide::{
    Aabb,
    curve::bounds,
    model::{CurveObject, Item, Model},
};

/// A body of a surface with the object it belongs to.
pub(crate) struct BodyOf<'a> {
    /// Name of the object.
    pub(crate) object: &'a str,
    /// Index of the object in the model.
    pub(crate) item: usize,
    /// Which of the object's surfaces it belongs to.
    pub(crate) surface: usize,
    /// Which of the object's bodies.
    pub(crate) index: usize,
    /// How many bodies the object has: one per surface, or more where one falls apart into lobes.
    pub(crate) count: usize,
    /// What it is called behind the name of the object; else it has its number there.
    pub(crate) name: Option<&'a str>,
    pub(crate) body: Shape<'a>,
}

impl BodyOf<'_> {
    /// The error of a surface that has no form as a format needs it.
    pub(crate) fn unfit(&self, source: cyclide::Error) -> ExportError {
        ExportError::Surface { object: self.object.to_owned(), surface: self.surface, source }
    }

    /// The object's name, with the body's own or its number from 0, as in reports, behind it where there are several.
    pub(crate) fn label(&self) -> String {
        match self.name {
            _ if self.count == 1 => self.object.to_owned(),
            Some(name) => format!("{} {name}", self.object),
            None => format!("{} {}", self.object, self.index),
        }
    }
}

/// One connected curve with the object it belongs to.
pub(crate) struct Contour<'a> {
    /// Name of the object.
    pub(crate) object: &'a str,
    /// Index of the object in the model.
    pub(crate) item: usize,
    /// Which of the object's contours.
    pub(crate) index: usize,
    /// How many contours the object has.
    pub(crate) count: usize,
    pub(crate) curve: &'a CurveObject,
}

impl Contour<'_> {
    /// The object's name, with the contour's number from 0, as in reports, behind it where there are several.
    pub(crate) fn label(&self) -> String {
        if self.count == 1 { self.object.to_owned() } else { format!("{} {}", self.object, self.index) }
    }

    /// A result of the kernel with the place it belongs to.
    pub(crate) fn lowered<T>(&self, result: cyclide::Result<T>) -> Result<T, ExportError> {
        result.map_err(|source| ExportError::Lowering { object: self.object.to_owned(), contour: self.index, source })
    }
}

/// The bodies of a model's surfaces and volumes in the order in which every format writes them.
pub(crate) fn bodies<'a>(model: &'a Model, provenances: Provenances<'a>) -> Result<Vec<BodyOf<'a>>, ExportError> {
    let mut bodies = Vec::new();
    for (item, it) in model.items.iter().enumerate() {
        let mut own: Vec<(usize, Shape<'_>)> = Vec::new();
        for (index, surface) in it.surfaces().iter().enumerate() {
            let lowered = |source| ExportError::Surface { object: it.name.clone(), surface: index, source };
            if let Some(triangles) = surface.as_triangles() {
                own.push((index, Shape::of_triangles(triangles).map_err(lowered)?));
            }
            own.extend(surface.to_bodies().map_err(lowered)?.into_iter().map(|body| (index, body.into())));
        }
        for (index, volume) in it.volumes().iter().enumerate() {
            let body = volume.to_body();
            let body =
                body.map_err(|source| ExportError::Surface { object: it.name.clone(), surface: index, source })?;
            own.push((index, body.into()));
        }
        let count = own.len();
        let numbers: Vec<usize> = own.iter().map(|(surface, _)| *surface).collect();
        let named = |(index, (surface, body))| {
            // A surface that falls apart has no name for each of its bodies.
            let name = provenances.name_of_surface(item, surface);
            let name = name.filter(|_| numbers.iter().filter(|number| **number == surface).count() == 1);
            BodyOf { object: &it.name, item, surface, index, count, name, body }
        };
        bodies.extend(own.into_iter().enumerate().map(named));
    }
    Ok(bodies)
}

/// The boxes round all curves and surfaces of a model, each with the name of its object.
pub(crate) fn boxes<'a>(model: &'a Model, bodies: &'a [BodyOf<'a>]) -> impl Iterator<Item = (&'a str, Aabb)> {
    let curves = contours(model).map(|contour| (contour.object, bounds(contour.curve.as_curve())));
    curves.chain(bodies.iter().map(|body| (body.object, body.body.bounds())))
}

/// The connected curves of a model in the order in which every format writes them.
pub(crate) fn contours(model: &Model) -> impl Iterator<Item = Contour<'_>> {
    model.items.iter().enumerate().flat_map(|(index, item)| contours_of(index, item))
}

/// The connected curves of one object, by its number in the model.
pub(crate) fn contours_of(item: usize, it: &Item) -> impl Iterator<Item = Contour<'_>> {
    let count = it.curves().len();
    let own = it.curves().iter().enumerate();
    own.map(move |(index, curve)| Contour { object: &it.name, item, index, count, curve })
}
