//! From objects of a document to the kernel's curves and surfaces; what the kernel refuses is shown at its place.

pub(in crate::document) mod blocks;
pub(in crate::document) mod contours;
pub(in crate::document) mod curve_places;
pub(in crate::document) mod cusps;
pub(in crate::document) mod facts;
pub(in crate::document) mod idle;
pub(in crate::document) mod kind;
pub(in crate::document) mod points;
pub(in crate::document) mod polygon_mesh;
pub(in crate::document) mod rails;
pub(in crate::document) mod references;
pub(in crate::document) mod refuse;
pub(in crate::document) mod remark;
pub(in crate::document) mod sources;
pub(in crate::document) mod wavers;

use std::io;
use std::path::{Path, PathBuf};

use cyclide::{
    Point3,
    model::{CurveObject, Geometry, Item, SurfaceObject},
    topology::Body,
};

use super::Document;
use super::locate::{Step, path_text, span_of};
use crate::document::objects::facts::{Facts, InterpolationFacts, MeshNames, Unmapped};
use crate::error::{Error, Result};
use crate::export::given_surface::{GivenSurface, LaidField};
use crate::export::provenance::Provenance;
use crate::text::place::Diagnostic;
use contours::ContourFacts;
use kind::{Kind, OfPanels, Shape};
use references::{References, State};
use remark::Remark;

/// A built object, with facts about it besides its geometry.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!((built[0].item.name.as_str(), built[0].provenance.kind), ("c", "circle"));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BuiltObject {
    /// The object for the model.
    pub item: Item,
    /// How it came about, for files and pictures.
    pub provenance: Provenance,
    /// The bound the construction promised on the distance to its input (an arc fit's tolerance), if any.
    pub tolerance: Option<f64>,
    /// The surfaces as patches that share edges, in their order.
    pub bodies: Vec<Body>,
    /// What its construction knows of it besides.
    pub facts: Facts,
    /// Construction geometry: not for files.
    pub construction: bool,
    /// One entry per contour.
    pub contours: Vec<ContourFacts>,
    /// What the user should know: warnings of the kernel, and what reading and making the object remarked.
    pub remarks: Vec<Remark>,
    /// How files were read, where that was certain and is not plain: columns by words, encodings, times of clocks.
    pub notes: Vec<String>,
    /// Of images of curves under Möbius maps: of what, and by which.
    pub(crate) unmapped: Option<Unmapped>,
    /// What it is of the panels of another object.
    pub(crate) of_panels: Option<OfPanels>,
}

/// Builds the objects of a document, each once, however many others are made from it. What no other object needs is handed
/// out and not kept.
///
/// ```
/// use cyclide_io::{Document, ModelBuilder};
/// use std::path::Path;
/// let text = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": {"csv": "two.csv"}}}}"#;
/// let document: Document = text.parse()?;
/// let read = |_: &Path| Ok(b"x,y\n0,0\n3,4\n".to_vec());
/// let built = ModelBuilder::new(&document, Path::new(""), &read)?.build(0, &mut |_| ())?;
/// assert!((cyclide::curve::length(built.item.curves()[0].as_curve()) - 5.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
pub struct ModelBuilder<'a> {
    document: &'a Document,
    folder: &'a Path,
    read: Read<'a>,
    references: References,
    made: Vec<Option<BuiltObject>>,
    /// Which of these have been made.
    walked: Vec<State>,
}

impl std::fmt::Debug for ModelBuilder<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ModelBuilder").field("folder", &self.folder).field("made", &self.made).finish_non_exhaustive()
    }
}

/// Reads a file.
type Read<'a> = &'a dyn Fn(&Path) -> io::Result<Vec<u8>>;

impl<'a> ModelBuilder<'a> {
    /// Builder of a document's objects. Files are looked up relative to `folder` and read by `read`; the name `-`, for
    /// standard input, is passed on unchanged.
    ///
    /// # Errors
    /// [`Error::Input`] at a name that no object has, or that refers back to the object itself.
    pub fn new(document: &'a Document, folder: &'a Path, read: Read<'a>) -> Result<Self> {
        let references = References::new(document)?;
        let (made, walked) = (vec![None; document.objects.len()], references.nothing_made());
        Ok(Self { document, folder, read, references, made, walked })
    }

    /// Runs the construction of the object with this index, and before it those of the objects it is made from.
    /// `progress` hears what long constructions are doing.
    ///
    /// # Errors
    /// [`Error::Read`]; [`Error::Input`] at the point or field at fault; [`Error::Geometry`] if the document was not
    /// made from a text.
    ///
    /// # Panics
    /// If there is no object with this index.
    pub fn build(&mut self, index: usize, progress: &mut dyn FnMut(String)) -> Result<BuiltObject> {
        let result = self.build_needed(index, progress);
        if result.is_err() {
            // What was not made is visited again by the next object that needs it.
            References::forget(&mut self.walked, |k| self.made[k].is_none());
        }
        result
    }

    /// As [`build`](Self::build); after an error objects are visited that were not made.
    fn build_needed(&mut self, index: usize, progress: &mut dyn FnMut(String)) -> Result<BuiltObject> {
        for needed in self.references.needed_for(index, &mut self.walked) {
            if self.made[needed].is_none() {
                let (name, spec) = &self.document.objects[needed];
                if needed != index {
                    progress(format!("first {name}: {}", spec.type_word()));
                }
                let Self { document, folder, read, .. } = *self;
                let sources = self.references.of(needed).iter().filter_map(|&k| self.made[k].as_ref()).collect();
                let builder = Builder {
                    document,
                    name,
                    kind: spec.kind(),
                    type_word: spec.type_word(),
                    construction: spec.is_construction(),
                    sources,
                    folder,
                    read,
                    progress,
                    mesh: None,
                    mesh_name: None,
                    laid_of: None,
                    given: None,
                    field: None,
                    facts: Facts::None,
                    remarks: Vec::new(),
                    notes: Vec::new(),
                    point_names: Vec::new(),
                    data: Vec::new(),
                    names: Vec::new(),
                    unmapped: None,
                    bound: None,
                };
                self.made[needed] = Some(builder.build()?);
            }
        }
        // Of large objects a copy would be a good part of all memory.
        let made = &mut self.made[index];
        Ok(if self.references.is_source(index) { made.clone() } else { made.take() }.unwrap_or_default())
    }
}

impl Document {
    /// Builds all objects of a document that refers to no files, in its order. [`ModelBuilder`] reads files, and builds objects one by one.
    ///
    /// # Errors Like [`ModelBuilder::new`] and [`ModelBuilder::build`]; a referenced file is not found.
    pub fn build(&self) -> Result<Vec<BuiltObject>> {
        let no_files = |_: &Path| Err(io::ErrorKind::NotFound.into());
        let mut builder = ModelBuilder::new(self, Path::new(""), &no_files)?;
        (0..self.objects.len()).map(|index| builder.build(index, &mut |_| ())).collect()
    }

    /// The files the document refers to, as it writes them.
    pub fn input_files(&self) -> impl Iterator<Item = &str> {
        self.objects.iter().flat_map(|(_, spec)| spec.kind().files())
    }
}

/// The points through which curves were laid and that are no joints of theirs.
fn nodes_within(curves: &[CurveObject], contours: &[ContourFacts]) -> Vec<Point3> {
    let known = curves.iter().zip(contours).filter_map(|(curve, facts)| Some((curve, facts.interpolation.as_ref()?)));
    let inside = |found: &InterpolationFacts| {
        found.parameters.iter().copied().filter(|t| *t > 0.0 && *t < 1.0).collect::<Vec<_>>()
    };
    known.flat_map(|(curve, found)| inside(found).into_iter().map(move |t| curve.as_curve().point(t))).collect()
}

/// One construction.
pub(in crate::document) struct Builder<'a> {
    pub(in crate::document) document: &'a Document,
    pub(in crate::document) name: &'a str,
    /// What it is by its kind, and the word of that.
    pub(in crate::document) kind: &'a dyn Kind,
    pub(in crate::document) type_word: &'static str,
    pub(in crate::document) construction: bool,
    /// The objects it is made from, in the order of [`Kind::references`].
    pub(in crate::document) sources: Vec<&'a BuiltObject>,
    pub(in crate::document) folder: &'a Path,
    pub(in crate::document) read: Read<'a>,
    /// Hears what takes long.
    pub(in crate::document) progress: &'a mut dyn FnMut(String),
    /// The file that the grid of a net was read from.
    pub(in crate::document) mesh: Option<MeshNames>,
    /// The name of the file of a mesh of quads.
    pub(in crate::document) mesh_name: Option<String>,
    /// The object that laid a mesh of quads.
    pub(in crate::document) laid_of: Option<String>,
    /// The surface that it follows.
    pub(in crate::document) given: Option<GivenSurface>,
    /// The lines of curvature that were found.
    pub(in crate::document) field: Option<LaidField>,
    /// What is known of it besides.
    pub(in crate::document) facts: Facts,
    pub(in crate::document) remarks: Vec<Remark>,
    pub(in crate::document) notes: Vec<String>,
    /// What its points are called in their table.
    pub(in crate::document) point_names: Vec<(Point3, String)>,
    /// The points of a fit.
    pub(in crate::document) data: Vec<Point3>,
    /// The names of its surfaces, if they have some.
    pub(in crate::document) names: Vec<String>,
    /// What its curves are images of.
    pub(in crate::document) unmapped: Option<Unmapped>,
    /// How far what it makes may be from what is described, where it is not exact.
    pub(in crate::document) bound: Option<f64>,
}

impl Builder<'_> {
    fn build(mut self) -> Result<BuiltObject> {
        let (kind, source) = (self.kind, self.sources.first().copied());
        let shape = kind.build(&mut self)?;
        let bodies = match &shape {
            Shape::Curves(curves) => {
                for (contour, (curve, _)) in curves.iter().enumerate() {
                    self.check_place_of(curve, contour)?;
                }
                Vec::new()
            }
            Shape::Surfaces(surfaces) => {
                let bodies = surfaces.iter().map(SurfaceObject::to_bodies).collect::<cyclide::Result<Vec<_>>>();
                bodies.map_err(|e| self.refused(&e, None))?.into_iter().flatten().collect()
            }
            Shape::Blocks(volumes, _) => self.block_bodies(volumes)?,
            // Straight lines are what they are at any place.
            Shape::Grids(_) | Shape::Motion(_) => Vec::new(),
        };
        kind.remark_on(&mut self, &shape, &bodies);
        let tolerance = kind.tolerance().or(self.bound);
        let (mut contours, mut places) = (Vec::new(), None);
        let geometry = match shape {
            Shape::Curves(made) => {
                let (curves, facts) = made.into_iter().unzip();
                contours = facts;
                Geometry::Curves(curves)
            }
            Shape::Grids(laid) => {
                contours = vec![ContourFacts::default(); laid.lines().len()];
                Geometry::Grids(laid)
            }
            Shape::Surfaces(surfaces) => Geometry::Surfaces(surfaces),
            Shape::Blocks(volumes, parameters) => {
                places = parameters;
                Geometry::Volumes(volumes)
            }
            Shape::Motion(body) => Geometry::Motion(body),
        };
        let item = Item::new(self.name, geometry);
        let construction = self.construction;
        let (skin, panels, of_panels) = (kind.skin(source), kind.has_panels(source), kind.of_panels());
        let Self { data, given, field, facts, remarks, notes, point_names, names, unmapped, .. } = self;
        let nodes = nodes_within(item.curves(), &contours);
        let provenance =
            Provenance { kind: self.type_word, data, nodes, point_names, places, names, given, field, skin, panels };
        Ok(BuiltObject {
            item,
            provenance,
            tolerance,
            bodies,
            facts,
            construction,
            contours,
            remarks,
            notes,
            unmapped,
            of_panels,
        })
    }

    /// Path of this object, or of a value in it.
    pub(in crate::document) fn path(&self, steps: impl IntoIterator<Item = Step>) -> Vec<Step> {
        [Step::from("objects"), Step::from(self.name)].into_iter().chain(steps).collect()
    }

    /// The bytes of a file that a field names.
    pub(in crate::document) fn file<const N: usize>(&self, file: &str, steps: [&str; N]) -> Result<(String, Vec<u8>)> {
        let standard = file == "-";
        let path = if standard { PathBuf::from(file) } else { self.folder.join(file) };
        let name = if standard { "standard input".to_owned() } else { path.display().to_string() };
        let unread = |source: io::Error| {
            let message = format!("cannot read {name}: {source}");
            let place = (!self.document.text.is_empty()).then(|| self.diagnostic(steps.map(Step::from), &message));
            Error::Read { path: path.clone(), source, place }
        };
        let bytes = (self.read)(&path).map_err(unread)?;
        Ok((name, bytes))
    }

    /// A message about the value at a path below the object.
    pub(in crate::document) fn diagnostic(
        &self,
        steps: impl IntoIterator<Item = Step>,
        message: &str,
    ) -> Box<Diagnostic> {
        let path = self.path(steps);
        let span = span_of(&self.document.text, &path).unwrap_or(0..1);
        self.document.source().diagnostic(span, &path_text(&path), message)
    }

    /// The message that the object's fields do not fit together.
    pub(in crate::document) fn unfit(&self, message: &str) -> Error {
        let path = self.path([]);
        let span = span_of(&self.document.text, &path).map_or(0..0, |s| s.start..s.start + 1);
        Error::Input(self.document.source().diagnostic(span, &path_text(&path), message))
    }
}
