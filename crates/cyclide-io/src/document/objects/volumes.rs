//! Volumes: from corners and a frame to the kernel's blocks.

use cyclide::{
    Body, Conformal as _, CyclideGrid, CyclideVolume, CyclidicNet, ErrorItem, Point3, SphericalCube, SurfaceObject,
    VolumeFrame,
};

use super::Builder;
use super::idle::NO_EFFECT;
use super::refuse::frame_words;
use super::surfaces::direction;
use super::transform::map_of;
use crate::document::kinds::Shape;
use crate::document::locate::Step;
use crate::document::spec::{
    CellsSpec, CoordinateSurfacesSpec, CyclideVolumeSpec, FrameSpec, LayersSpec, StepSpec, TransformSpec,
};
use crate::error::{Error, Result};

/// How far a last corner that is given may be from the one that follows, relative to the size.
const LAST_CORNER: f64 = 1e-9;
/// Rounding of the eight corners together, relative to the largest coordinate: a side turns by that over its length, and what follows with it.
const CORNERS_ROUNDING: f64 = 8.0 * f64::EPSILON;

impl Builder<'_> {
    /// Blocks with the parameters of their cells. Of many blocks that fold one is enough to know, at a field.
    pub(in crate::document) fn divided(
        &mut self,
        volumes: Vec<CyclideVolume>,
        cells: Option<&CellsSpec>,
        field: &str,
    ) -> Result<Shape> {
        self.warn_of_folded_blocks(&volumes, field);
        let places = self.places(&volumes, cells)?;
        Ok(Shape::Blocks(volumes, places))
    }

    /// Warns of the first of some blocks that fold.
    pub(in crate::document) fn warn_of_folded_blocks(&mut self, volumes: &[CyclideVolume], field: &str) {
        if let Some(warning) = volumes.iter().find_map(|volume| volume.warnings().into_iter().next()) {
            self.warn_at(field, None, warning);
        }
    }

    /// The block.
    pub(in crate::document) fn block(&self, spec: &CyclideVolumeSpec) -> Result<CyclideVolume> {
        let corners: Vec<Point3> = spec.corners.iter().map(|c| c.point()).collect();
        let for_four = [("inside", spec.inside.is_some()), ("turn", spec.turn.is_some())];
        if let Some((field, _)) = for_four.into_iter().find(|(_, given)| *given && corners.len() != 4) {
            return Err(self.unfit(&format!("`{field}` goes with four corners: others determine the block")));
        }
        let refused = |e: cyclide::Error| self.refused(&e, None);
        let cube = match *corners.as_slice() {
            [a0, a1, a2, a3] => {
                // Those of the last corner of a cuboid, if the sides are those of one.
                let squared = |a: Point3| Some((a - a0).length_squared()).filter(|squared| *squared > 0.0);
                // Points that coincide are named by the constructor.
                let of_cuboid = || [a1, a2, a3].map(|a| squared(a).unwrap_or(1.0));
                let (inside, turn) = (spec.inside.unwrap_or_else(of_cuboid), spec.turn.unwrap_or(0.5));
                let made = SphericalCube::from_barycentric([a0, a1, a2, a3], inside, turn);
                made.map_err(|e| self.refused_inside(spec.inside, &e).unwrap_or_else(|| refused(e)))?
            }
            [a, b, c, d, e, f, g] => SphericalCube::new([a, b, c, d, e, f, g]).map_err(refused)?,
            [a, b, c, d, e, f, g, last] => {
                let cube = SphericalCube::new([a, b, c, d, e, f, g]).map_err(|e| match e {
                    cyclide::Error::CoincidentPoints { .. } => match Self::order_of_corners(&corners) {
                        Some(remedy) => {
                            self.refused_in_words([Step::from("corners")], e.reason(), format!("{e}{remedy}"))
                        }
                        None => refused(e),
                    },
                    e => refused(e),
                })?;
                let follows = cube.corners()[7];
                let size = cube.corners().iter().map(|p| p.distance(a)).fold(0.0, f64::max);
                let distance = follows.distance(last);
                if !(distance <= LAST_CORNER * size + rounding_of_last(&cube, size)) {
                    let [x, y, z] = follows.to_array();
                    let words = format!(
                        "the last corner is {distance:.3e} from ({x}, {y}, {z}), the only one that is on the circles of its three faces: leave it out"
                    );
                    let place = [Step::from("corners"), Step::from(7)];
                    return Err(self.refused_in_words(place, "not-concircular", words));
                }
                cube
            }
            _ => return Err(self.unfit("`corners` are 4, 7 or 8")),
        };
        let made = CyclideVolume::new(&cube, volume_frame(spec.frame));
        made.map_err(|e| self.refused_frame(spec.frame, &e).unwrap_or_else(|| refused(e)))
    }

    /// What is wrong with the directions of a frame, if it is these.
    pub(in crate::document) fn refused_frame(&self, frame: FrameSpec, error: &cyclide::Error) -> Option<Error> {
        let (FrameSpec::First(given), cyclide::Error::FrameNotOrthonormal { .. }) = (frame, error) else { return None };
        Some(self.refused_in_words([Step::from("frame")], error.reason(), frame_words(given)))
    }

    /// What is wrong with `inside`, if it is that.
    fn refused_inside(&self, inside: Option<[f64; 3]>, error: &cyclide::Error) -> Option<Error> {
        let (Some(inside), cyclide::Error::ParameterOutOfRange { name: ErrorItem::Position, .. }) = (inside, error)
        else {
            return None;
        };
        let field = Step::from("inside");
        let Some(k) = inside.iter().position(|weight| !(*weight > 0.0)) else {
            return Some(self.refused_in_words(
                [field],
                error.reason(),
                "the weights are too large together".to_owned(),
            ));
        };
        let words = format!("the last corner is where three positive weights put it, and {} is none", inside[k]);
        Some(self.refused_in_words([field, Step::from(k)], error.reason(), words))
    }

    /// The solids of blocks.
    pub(in crate::document) fn block_bodies(&self, volumes: &[CyclideVolume]) -> Result<Vec<Body>> {
        let body = |(index, volume): (usize, &CyclideVolume)| {
            volume.to_body().map_err(|e| {
                let which = if volumes.len() > 1 { format!("block {index}: ") } else { String::new() };
                let words =
                    format!("{which}{e}: the block is flat up to rounding, or its corners are nearly on one circle");
                match e.reason() {
                    "not-a-shell" => self.refused_in_words([], e.reason(), words),
                    _ => self.refused(&e, None),
                }
            })
        };
        volumes.iter().enumerate().map(body).collect()
    }

    /// Blocks between the offsets of nets.
    pub(in crate::document) fn layers(&self, spec: &LayersSpec) -> Result<Vec<CyclideVolume>> {
        let distances = match (&spec.distances, spec.first, spec.count) {
            (Some(distances), None, None) if spec.growth.is_none() => distances.clone(),
            (None, Some(first), Some(count)) => {
                let growth = spec.growth.unwrap_or(1.0);
                if !(growth > 0.0 && growth.is_finite()) {
                    return Err(self.unfit("`growth` is above 0"));
                }
                let mut distances = vec![0.0];
                let (mut sum, mut height) = (0.0, first);
                for _ in 0..count {
                    sum += height;
                    height *= growth;
                    distances.push(sum);
                }
                // Layers on the other side, from the farthest to the surface.
                if first < 0.0 {
                    distances.reverse();
                }
                distances
            }
            _ => return Err(self.unfit("give either `distances`, or `first` and `count` with or without `growth`")),
        };
        self.check_layers_rise(spec, &distances)?;
        let field = if spec.distances.is_some() { "distances" } else { "first" };
        let source = self.surface_source("only surfaces have layers")?;
        let mut volumes = Vec::new();
        for surface in source.item.surfaces() {
            let grids = match surface {
                SurfaceObject::Patch(patch) => {
                    CyclideGrid::layers(&CyclidicNet::from(*patch), &distances).map(|grid| vec![grid])
                }
                SurfaceObject::Net(net) => CyclideGrid::layers(net, &distances).map(|grid| vec![grid]),
                SurfaceObject::Layout(layout) => CyclideGrid::layers_of_layout(layout, &distances),
                SurfaceObject::Body(_) | SurfaceObject::Triangles(_) => {
                    let solid = matches!(surface, SurfaceObject::Body(_)) && source.provenance.kind == "offset";
                    let remedy = if solid { "; the offset itself has, without `thick`" } else { "" };
                    return Err(self.wrong_source(&format!(
                        "only a `cyclide-patch`, a `cyclidic-net` or a `cyclide` has layers{remedy}"
                    )));
                }
            };
            let grids = grids.map_err(|e| self.refused_at([Step::from(field)], &e))?;
            volumes.extend(grids.iter().flat_map(CyclideGrid::blocks));
        }
        Ok(volumes)
    }

    /// Refuses layers without a height.
    fn check_layers_rise(&self, spec: &LayersSpec, distances: &[f64]) -> Result<()> {
        let is_finite = distances.iter().all(|h| h.is_finite());
        let Some(k) = (1..distances.len()).find(|&k| is_finite && !(distances[k] > distances[k - 1])) else {
            return Ok(());
        };
        let (here, before) = (distances[k], distances[k - 1]);
        let (place, words) = match spec.first {
            None => (
                vec![Step::from("distances"), Step::from(k)],
                format!("{here} is not above {before}: distances rise, from the lowest surface to the highest"),
            ),
            Some(0.0) => (vec![Step::from("first")], "a layer has a height: it is not 0".to_owned()),
            Some(_) => {
                let number = if here > 0.0 { k - 1 } else { distances.len() - 1 - k };
                (
                    vec![Step::from("growth")],
                    format!("layer {number} is so thin that the distance {before} is not changed by it"),
                )
            }
        };
        Err(self.refused_in_words(place, "parameters-not-increasing", words))
    }

    /// Surfaces inside blocks on which one parameter is constant.
    pub(in crate::document) fn coordinate_surfaces(
        &mut self,
        spec: &CoordinateSurfacesSpec,
    ) -> Result<Vec<SurfaceObject>> {
        let volumes = self.sources.first().map_or(&[][..], |source| source.item.volumes());
        if volumes.is_empty() {
            return Err(self.wrong_source(
                "only a `cyclide-volume`, a `cyclide-grid`, `layers` and their images have coordinate surfaces",
            ));
        }
        if spec.outer {
            if ![&spec.s, &spec.t, &spec.u].into_iter().all(Vec::is_empty) {
                return Err(self.unfit("`outer` is the boundary of all blocks: leave out `s`, `t` and `u`"));
            }
            let bodies = CyclideVolume::outer_bodies(volumes).map_err(|e| self.refused(&e, None))?;
            return Ok(bodies.into_iter().map(SurfaceObject::Body).collect());
        }
        let lists = [("s", &spec.s), ("t", &spec.t), ("u", &spec.u)];
        if lists.iter().all(|(_, values)| values.is_empty()) {
            return Err(self.unfit("`s`, `t` or `u` says which surfaces, `outer` asks for the boundary"));
        }
        let (mut surfaces, mut names) = (Vec::new(), Vec::new());
        for (axis, (field, values)) in lists.iter().enumerate().filter(|(_, (_, values))| !values.is_empty()) {
            for (index, x) in values.iter().enumerate().filter(|(_, x)| !(0.0..=1.0).contains(*x)) {
                let error = volumes[0].surface(axis, *x).err();
                let refused = |e| self.refused_at([Step::from(*field), Step::from(index)], &e);
                error.map_or(Ok(()), |e| Err(refused(e)))?;
            }
            let made = CyclideVolume::coordinate_bodies(volumes, axis, values);
            // Of lines there are no bodies; where all surfaces are lines the kernel has none at all.
            let has_body = |x: f64| {
                made.as_ref().is_ok_and(|made| made.iter().any(|(value, _)| value.total_cmp(&(x + 0.0)).is_eq()))
            };
            let no_surface = |x: f64| !has_body(x) && volumes.iter().all(|volume| is_line(volume, axis, x));
            let lines: Vec<usize> = (0..values.len()).filter(|k| no_surface(values[*k])).collect();
            for index in &lines {
                let x = values[*index];
                let words =
                    format!("{field} = {x} is a line or a point of every block, at an axis or a pole: no surface");
                let place = [Step::from(*field), Step::from(*index)];
                if lines.len() == values.len() {
                    return Err(self.refused_in_words(place, "collapsed-side", words));
                }
                let place = self.place_of(place);
                self.remark(NO_EFFECT, None, None, place, words);
            }
            let made = made.map_err(|e| self.refused_at([Step::from(*field)], &e))?;
            for (number, (value, body)) in made.iter().enumerate() {
                let same = |(other, _): &&(f64, Body)| other.total_cmp(value).is_eq();
                let name = format!("{field}={value}");
                names.push(match made.iter().filter(same).count() {
                    1 => name,
                    _ => format!("{name} {}", made[..number].iter().filter(same).count()),
                });
                surfaces.push(surface_of(body.clone()));
            }
        }
        self.names = names;
        Ok(surfaces)
    }

    /// The images of blocks.
    pub(in crate::document) fn mapped_volumes(&self, spec: &TransformSpec) -> Result<Vec<CyclideVolume>> {
        let volumes = self.sources.first().map_or(&[][..], |source| source.item.volumes());
        let of_curves = |step: &StepSpec| matches!(step, StepSpec::Reverse | StepSpec::Cut(_));
        if let Some(index) = spec.steps.iter().position(of_curves).filter(|_| !volumes.is_empty()) {
            return Err(
                self.wrong_source_at([Step::from("steps"), Step::from(index)], "only curves are run backwards or cut")
            );
        }
        self.mapped(spec, 0..spec.steps.len(), volumes, |volume, step| volume.transformed(&map_of(step)?), "")
    }
}

/// The frame of a document as the kernel's.
pub(in crate::document) fn volume_frame(frame: FrameSpec) -> VolumeFrame {
    match frame {
        FrameSpec::Auto => VolumeFrame::Auto,
        FrameSpec::First(given) => {
            let [v1, v2] = given.map(direction);
            VolumeFrame::First(v1, v2)
        }
    }
}

/// Whether opposite sides of the surface on which a parameter is constant are one point each.
fn is_line(volume: &CyclideVolume, axis: usize, x: f64) -> bool {
    volume.surface(axis, x).is_ok_and(|face| {
        let [a, b, c, d] = face.corners();
        (a == b && c == d) || (a == c && b == d)
    })
}

/// A body as a surface: a single patch is one, which has offsets and layers.
fn surface_of(body: Body) -> SurfaceObject {
    match body.outer.faces() {
        [only] => only.surface.patch().map(|patch| SurfaceObject::Patch(*patch)),
        _ => None,
    }
    .unwrap_or(SurfaceObject::Body(body))
}

/// How far rounding of the corners moves the last one.
fn rounding_of_last(cube: &SphericalCube, size: f64) -> f64 {
    let corners = cube.corners();
    let place = corners.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    let sides = (0..3).flat_map(|axis| (0..8).filter(move |k| k >> axis & 1 == 0).map(move |k| (k, k | 1 << axis)));
    let lengths = sides.map(|(from, to)| corners[from].distance(corners[to]));
    // Sides of one point turn nothing.
    let shortest = lengths.filter(|length| *length > LAST_CORNER * size).fold(size, f64::min);
    CORNERS_ROUNDING * place * (size / shortest)
}
