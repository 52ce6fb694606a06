//! The report on surfaces.

use std::collections::BTreeMap;

use cyclide::{
    ShapeChange,
    curve::CORNER_ANGLE,
    model::SurfaceObject,
    rational::RationalBezierSurface,
    surface::{CyclidePatch, ParamSurface as _},
    topology::{Body, FaceSurface, Shell, ShellFace, surface_joints},
};
use serde::Serialize;

use super::range::RangeReport;
use super::{
    ClosingReport, CurvatureRangeReport, PolyhedronReport, RoundReport, SeamReport, TeeBlendReport, TubeReport,
};
use crate::document::BuiltObject;
use crate::measure::joints::SurfaceJointReport;

/// Places per direction at which a patch is measured where there is no closed form.
const SAMPLES: usize = 5;

/// The report on the surfaces of an object; largest values are over all its patches.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.patches == 1 && (found.total_area - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SurfaceReport {
    /// Patches of all bodies together.
    pub patches: usize,
    /// Connected bodies.
    pub bodies: usize,
    /// True if no edge is free.
    pub closed: bool,
    /// Edges with one patch only.
    pub free_edges: usize,
    /// Area of a surface with one part; `None` if there are several: the sum of both skins of a shell and its rims is
    /// rarely useful.
    pub area: Option<f64>,
    /// Total area of all patches: what is painted.
    pub total_area: f64,
    /// The parts into which creases divide the bodies, the largest first: one part for a smooth surface; the skins and
    /// the rims of a thick shell.
    pub parts: Vec<PartReport>,
    /// Enclosed volume without voids; `None` if a body is open.
    pub volume: Option<f64>,
    /// Why an area or the volume is unknown: it is then NaN, in JSON null.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_known: Vec<String>,
    /// How the patches meet.
    pub joints: SurfaceJointReport,
    /// Principal curvatures along the s-lines, in 1/length: negative where the surface bends away from its outer
    /// side. Unbounded on one side or both if `singular` names parameters t.
    pub curvature_s: CurvatureRangeReport,
    /// Principal curvatures along the t-lines; unbounded if `singular` names parameters s.
    pub curvature_t: CurvatureRangeReport,
    /// The nine real weights of every patch, before patches are cut so that all are positive.
    pub weights: RangeReport,
    /// Largest real part of the quaternion quotient, a length: how far rounding moves patches of cyclides out of
    /// three-space. `None` without such patches.
    pub residual: Option<f64>,
    /// Largest cosine between the two directions of the parameter lines of patches of cyclides. `None` without these:
    /// lines of rational faces need not cross at right angles.
    pub orthogonality: Option<f64>,
    /// Patches with a singular point: a parameter line that shrinks to a point inside, or a side that is a node.
    pub singular: Vec<SingularPatchReport>,
    /// Patches whose `f_s × f_t` is opposite to the normal along which offsets are made: offsets beyond a focal set.
    /// Empty for a thick shell, which has no offset.
    pub flipped: Vec<PatchPlace>,
    /// Opposite borders of open nets that nearly coincide.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub seams: Vec<SeamReport>,
    /// The polyhedron whose edges and corners were rounded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub polyhedron: Option<Box<PolyhedronReport>>,
    /// Tubes of varying radius, one for each body.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tubes: Vec<TubeReport>,
    /// The blends of a tee, in the order of its branches.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub blends: Vec<TeeBlendReport>,
    /// The changes that made a net circular.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub circular: Option<Box<CircularReport>>,
}

/// Patches of one body that are connected without a crease.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 1, 0], [1, 1, 0], [3, 1, 0]], [[0, 0, 1], [1, 0, 1], [3, 0, 1]]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert_eq!((found.parts.len(), found.parts[0].patches), (1, 2));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PartReport {
    /// The body, from 0.
    pub body: usize,
    /// Its patches.
    pub patches: usize,
    /// Their area.
    pub area: f64,
}

impl PartReport {
    /// The parts of a shell.
    fn of_shell(body: usize, shell: &Shell, not_known: &mut Vec<String>) -> Vec<Self> {
        let faces = shell.faces();
        // A face of the same part before each, or itself.
        let mut before: Vec<usize> = (0..faces.len()).collect();
        for joint in surface_joints(shell).iter().filter(|joint| joint.angle <= CORNER_ANGLE) {
            let [a, b] = joint.faces.map(|face| first_of_part(&mut before, face));
            before[a.max(b)] = a.min(b);
        }
        let mut parts: BTreeMap<usize, Vec<&ShellFace>> = BTreeMap::new();
        for (index, face) in faces.iter().enumerate() {
            parts.entry(first_of_part(&mut before, index)).or_default().push(face);
        }
        if parts.len() == 1 {
            return vec![Self { body, patches: faces.len(), area: number(shell.known_area(), not_known) }];
        }
        let mut area = |face: &&ShellFace| {
            number(Shell::from_surface(face.surface.clone()).and_then(|alone| alone.known_area()), not_known)
        };
        let parts = parts.into_values();
        parts.map(|part| Self { body, patches: part.len(), area: part.iter().map(&mut area).sum() }).collect()
    }
}

/// What was measured; not a number if it is not known, with the reason noted once.
pub(super) fn number(measured: cyclide::Result<f64>, not_known: &mut Vec<String>) -> f64 {
    measured.unwrap_or_else(|error| {
        let reason = error.to_string();
        if !not_known.contains(&reason) {
            not_known.push(reason);
        }
        f64::NAN
    })
}

/// The first face of a part; the way to it gets shorter each time.
fn first_of_part(before: &mut [usize], mut face: usize) -> usize {
    while before[face] != face {
        before[face] = before[before[face]];
        face = before[face];
    }
    face
}

/// How the vertices of a net were moved so that every quad is circular; lengths in model units, angles in radians.
///
/// ```
/// let place = |i: i32, j: i32| [f64::from(i), f64::from(j), 0.002 * f64::from(10 * i * i + i * j + 20 * j * j)];
/// let grid: Vec<Vec<[f64; 3]>> = (-2..=2).map(|j| (-3..=3).map(|i| place(i, j)).collect()).collect();
/// let object = format!(r#"{{"type": "cyclidic-net", "make_circular": true, "grid": {grid:?}}}"#);
/// let document: cyclide_io::Document = format!(r#"{{"cyclide": 1, "objects": {{"roof": {object}}}}}"#).parse()?;
/// let report = cyclide_io::report::ObjectReport::new(&document.build()?[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// let made = found.circular.expect("it was asked for");
/// assert!(made.residual_after < 1e-9 && made.residual_after < made.residual_before && made.move_max < 0.5);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CircularReport {
    /// Steps of the search.
    pub steps: usize,
    /// Largest residual of a quad as given (0 if its corners are on a circle).
    pub residual_before: f64,
    /// Largest residual of a quad as made.
    pub residual_after: f64,
    /// Median length of the edges as given.
    pub median_edge: f64,
    /// Largest move of a vertex.
    pub move_max: f64,
    /// Mean move of a vertex.
    pub move_mean: f64,
    /// Index of the vertex that moved farthest, s fastest.
    pub farthest_vertex: usize,
    /// Largest distance of a vertex from the given surface.
    pub off_surface_max: f64,
    /// Median angle between grid lines and lines of curvature as given; `None` if there are none.
    pub angle_before: Option<f64>,
    /// The same as made.
    pub angle_after: Option<f64>,
    /// How far each closed direction was, and is, from closing; empty for an open grid.
    pub closing: Vec<ClosingReport>,
    /// How far a mesh was, and is, from closing around its extraordinary vertices; `None` without such vertices.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub round: Option<RoundReport>,
    /// How much of the shape remains; `None` for a flat grid.
    pub shape: Option<ShapeReport>,
    /// Indices, s fastest, of quads into which no patch fits: sides cross or have no length. A document with such quads
    /// is rejected, so reports on built objects have none.
    pub rejected_quads: Vec<usize>,
}

/// How much of its shape a net has kept when it was made circular: dimensionless numbers (see `ShapeChange` of the
/// kernel).
///
/// ```
/// let place = |i: i32, j: i32| [f64::from(i), f64::from(j), 0.002 * f64::from(10 * i * i + i * j + 20 * j * j)];
/// let grid: Vec<Vec<[f64; 3]>> = (-2..=2).map(|j| (-3..=3).map(|i| place(i, j)).collect()).collect();
/// let object = format!(r#"{{"type": "cyclidic-net", "make_circular": true, "grid": {grid:?}}}"#);
/// let document: cyclide_io::Document = format!(r#"{{"cyclide": 1, "objects": {{"roof": {object}}}}}"#).parse()?;
/// let report = cyclide_io::report::ObjectReport::new(&document.build()?[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// let shape = found.circular.and_then(|made| made.shape).expect("it is not flat");
/// assert!(shape.lost_relief < 0.5 && shape.bending > Some(0.5));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ShapeReport {
    /// Bending of the surface, after over before.
    pub bending: Option<f64>,
    /// Thickness of the surface, after over before.
    pub thickness: Option<f64>,
    /// Turn of the normals over their spread in the given grid.
    pub normal_turn: Option<f64>,
    /// Turn of the normals, rms, radians.
    pub turn: f64,
    /// Fraction of the surface (0 to 1) where less than half of the local humps and ripples remains.
    pub lost_relief: f64,
    /// Mean angle of the given lines to the lines of curvature, weighted by the difference of the curvatures, in
    /// radians; `None` for surfaces that are nearly flat, or flat except for noise.
    pub across: Option<f64>,
    /// True if the bending of the given grid is only noise: a plane.
    pub noise: bool,
}

impl From<&ShapeChange> for ShapeReport {
    fn from(change: &ShapeChange) -> Self {
        let ShapeChange { bending, thickness, normal_turn, turn, lost_relief, across, noise, .. } = *change;
        Self { bending, thickness, normal_turn, turn, lost_relief, across, noise }
    }
}

/// A patch of an object.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.flipped.iter().all(|place| place.patch < found.patches));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct PatchPlace {
    /// The body, from 0.
    pub body: usize,
    /// The patch of the body, from 0; in a net s fastest, in the lobes of an offset with nodes in the order of the cuts.
    pub patch: usize,
}

/// A patch with singular points.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Surface(found) = report.geometry else { unreachable!("by its type") };
/// assert!(found.singular.is_empty());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SingularPatchReport {
    /// The patch.
    #[serde(flatten)]
    pub place: PatchPlace,
    /// The parameters s whose t-line is one point; 0 or 1 for a side that is a node (not for the pole of a sphere).
    pub s: Vec<f64>,
    /// The parameters t whose s-line is one point.
    pub t: Vec<f64>,
    /// These points: first those of `s`, then those of `t`.
    pub points: Vec<[f64; 3]>,
}

impl SurfaceReport {
    /// Measures the bodies of an object.
    pub(super) fn new(built: &BuiltObject) -> Self {
        let bodies = &built.bodies;
        let shells = || bodies.iter().flat_map(Body::shells);
        let mut not_known = Vec::new();
        let volumes: Option<Vec<f64>> = bodies.iter().map(|body| volume(body, &mut not_known)).collect();
        let mut parts = Vec::new();
        for (body, it) in bodies.iter().enumerate() {
            it.shells().for_each(|shell| parts.extend(PartReport::of_shell(body, shell, &mut not_known)));
        }
        parts.sort_by(|a, b| b.area.total_cmp(&a.area));
        let nets = built.item.surfaces().iter().flat_map(SurfaceObject::nets);
        let blends = built.facts.blends().into_iter().flat_map(|facts| &facts.blends);
        let mut report = Self {
            patches: shells().map(|shell| shell.faces().len()).sum(),
            bodies: bodies.len(),
            closed: shells().all(Shell::is_closed),
            free_edges: shells().flat_map(Shell::edge_uses).filter(|&uses| uses == 1).count(),
            area: if let [only] = parts[..] { Some(only.area) } else { None },
            total_area: parts.iter().map(|part| part.area).sum(),
            parts,
            volume: volumes.map(|v| v.iter().sum()),
            not_known,
            joints: SurfaceJointReport::new(shells()),
            curvature_s: CurvatureRangeReport::EMPTY,
            curvature_t: CurvatureRangeReport::EMPTY,
            weights: RangeReport::EMPTY,
            residual: None,
            orthogonality: None,
            singular: Vec::new(),
            flipped: Vec::new(),
            seams: nets
                .flat_map(|net| SeamReport::all(net, built.facts.net().map_or(&[], |facts| &facts.seams)))
                .collect(),
            polyhedron: built.facts.rounded_polyhedron().map(|rounded| Box::new(PolyhedronReport::from(rounded))),
            tubes: built.facts.tubes().unwrap_or_default().iter().map(TubeReport::from).collect(),
            blends: blends.map(TeeBlendReport::from).collect(),
            circular: circular(built),
        };
        // An object has solids only, or none: a solid's rims have no normal of their own to be against.
        let thick = built.item.surfaces().iter().any(|surface| matches!(surface, SurfaceObject::Body(_)));
        for (body, it) in bodies.iter().enumerate() {
            for (patch, face) in it.shells().flat_map(Shell::faces).enumerate() {
                let place = PatchPlace { body, patch };
                let flipped = face.surface.patch().is_some_and(|patch| patch.is_flipped() && patch.is_regular());
                if !thick && flipped {
                    report.flipped.push(place);
                }
                report.add(place, face);
            }
        }
        report
    }

    fn add(&mut self, place: PatchPlace, face: &ShellFace) {
        let patch = match &face.surface {
            FaceSurface::Cyclide(patch) => patch,
            FaceSurface::Rational(surface) => return self.add_rational(surface, face),
        };
        self.singular.extend(SingularPatchReport::new(place, patch));
        // The curvatures are against D V3 D^-1; the outer side may be the other one.
        let against = face.outer_sign_of_unit_normal() < 0.0;
        let turned = |[a, b]: [f64; 2]| if against { [-b, -a] } else { [a, b] };
        self.curvature_s = self.curvature_s.with(turned(patch.k1_range()));
        self.curvature_t = self.curvature_t.with(turned(patch.k2_range()));
        for weight in patch.real_weights().as_flattened() {
            self.weights = self.weights.with(*weight, *weight);
        }
        let (residual, orthogonality) = (self.residual.get_or_insert(0.0), self.orthogonality.get_or_insert(0.0));
        for i in 0..SAMPLES * SAMPLES {
            let [s, t] = [i % SAMPLES, i / SAMPLES].map(|k| k as f64 / (SAMPLES - 1) as f64);
            *residual = residual.max(patch.real_residual(s, t));
            let jet = patch.jet(s, t);
            if let (Some(a), Some(b)) = (jet.ds.unit(), jet.dt.unit()) {
                *orthogonality = orthogonality.max(a.dot(b).abs());
            }
        }
    }
}

impl SurfaceReport {
    /// A rational face, whose parameter lines need not be lines of curvature: normal curvatures of these, by samples.
    fn add_rational(&mut self, surface: &RationalBezierSurface, face: &ShellFace) {
        let side = face.outer_sign();
        for row in surface.rows() {
            self.weights = self.weights.with(row[3], row[3]);
        }
        for i in 0..SAMPLES * SAMPLES {
            let [s, t] = [i % SAMPLES, i / SAMPLES].map(|k| k as f64 / (SAMPLES - 1) as f64);
            // On a side of one point there are no lines.
            let [bottom, top, left, right] = face.sides.map(|side| side.is_none());
            if s <= 0.0 && left || s >= 1.0 && right || t <= 0.0 && bottom || t >= 1.0 && top {
                continue;
            }
            let jet = surface.jet(s, t);
            if let Some([a, b]) = jet.normal_curvatures().filter(|k| k.iter().all(|k| k.is_finite())) {
                self.curvature_s = self.curvature_s.with([side * a; 2]);
                self.curvature_t = self.curvature_t.with([side * b; 2]);
            }
        }
    }
}

/// What it took to make the net circular.
fn circular(built: &BuiltObject) -> Option<Box<CircularReport>> {
    built.facts.net()?.circular.as_ref().map(|report| Box::new(CircularReport::from(report)))
}

impl From<&cyclide_grids::CircularMeshReport> for CircularReport {
    fn from(report: &cyclide_grids::CircularMeshReport) -> Self {
        Self {
            steps: report.steps,
            residual_before: report.residual_before,
            residual_after: report.residual_after,
            median_edge: report.median_edge,
            move_max: report.moves.max,
            move_mean: report.moves.mean,
            farthest_vertex: report.moves.farthest_vertex,
            off_surface_max: report.moves.max_off_surface,
            angle_before: report.angle_before.map(|angle| angle.median),
            angle_after: report.angle_after.map(|angle| angle.median),
            closing: ClosingReport::all(&report.closing),
            round: report.round.as_ref().map(RoundReport::from),
            shape: report.shape.as_ref().map(ShapeReport::from),
            rejected_quads: report.rejected_quads.clone(),
        }
    }
}

impl SingularPatchReport {
    /// The singular points of a patch, if it has some.
    fn new(place: PatchPlace, patch: &CyclidePatch) -> Option<Self> {
        let sorted = |inside: Vec<f64>, sides: Vec<f64>| {
            let mut all = [inside, sides].concat();
            all.sort_by(f64::total_cmp);
            all
        };
        let (s, t) = (sorted(patch.singular_s(), patch.node_s()), sorted(patch.singular_t(), patch.node_t()));
        let of_s = s.iter().map(|&s| patch.point(s, 0.5));
        let points = of_s.chain(t.iter().map(|&t| patch.point(0.5, t))).map(|p| p.to_array()).collect();
        (!(s.is_empty() && t.is_empty())).then_some(Self { place, s, t, points })
    }
}

fn volume(body: &Body, not_known: &mut Vec<String>) -> Option<f64> {
    // The shells of hollows are oriented into them: their volumes are negative.
    body.is_solid().then(|| body.shells().map(|shell| number(shell.known_volume(), not_known)).sum())
}
