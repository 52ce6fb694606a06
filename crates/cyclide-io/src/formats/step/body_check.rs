//! The distance between the bodies of a STEP file and those of the model, face by face, and their structure.
//!
//! Faces, sides and edges are compared in the order in which they are written: rational surfaces and edges at equal
//! parameters, analytic surfaces and circles by distance. Readers repair wrong orientations and unshared edges
//! silently, so that both are checked here: each face looks to the model's outer side, loops run head to tail and
//! counter-clockwise against it, faces use one edge where the model's faces share one, and solids have positive volume.

use super::topology::exported;
use crate::check::bodies::{FileBody, FileEdge, FileFace, FileShell, FileSurface};
use crate::check::deviation::larger;
use crate::check::file_content::ReadError;
use crate::export::options::StepEdges;
use crate::export::parts::BodyOf;
use cyclide::{
    Body, ChainPiece, FaceEdge, FaceSurface, ParamCurve as _, ParamSurface as _, PatchKind, Point3,
    RationalBezierSurface, Shell, Side, Vec3,
};
use std::collections::{HashMap, HashSet};

/// Places per parameter at which surfaces and edges are compared.
const PLACES: u32 = 9;
/// By so much of its length and of the model's size an edge may leave its face at equal parameters: far below readers' own
/// tolerance, above the rounding of parameters with very uneven weights.
const PARAMETER_LIMIT: (f64, f64) = (1e-9, 1e-12);
/// Edges below this part of the model's size are points for other programs; the kernel takes corners for concircular to it.
const SHORT_EDGE: f64 = 1e-9;
/// Rounding of a point of an edge or a face, or of the length of an edge, relative to the coordinates.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The largest distance between surfaces, edges and vertices of each body of the file and of the model, whose diagonal is
/// `size`.
///
/// # Errors
/// [`ReadError::BodyCount`], [`ReadError::Body`], `Geometry` where the model's faces cannot be cut.
pub(crate) fn bodies_deviation(expected: &[BodyOf<'_>], read: &[FileBody], size: f64) -> Result<Vec<f64>, ReadError> {
    if expected.len() != read.len() {
        return Err(ReadError::BodyCount { found: read.len(), expected: expected.len() });
    }
    let one = |(index, (body, file)): (usize, (&BodyOf<'_>, &FileBody))| {
        let no_faces = ReadError::Body { body: index, detail: "it has no faces" };
        let faces = body.body.faces().ok_or(no_faces)?;
        body_deviation(faces, file, size).map_err(|e| match e {
            Mismatch::Structure(detail) => ReadError::Body { body: index, detail },
            Mismatch::Kernel(source) => ReadError::Geometry { place: format!("body {index}"), source },
        })
    };
    expected.iter().zip(read).enumerate().map(one).collect()
}

/// Why a body is not the model's.
enum Mismatch {
    Structure(&'static str),
    Kernel(cyclide::Error),
}

impl From<cyclide::Error> for Mismatch {
    fn from(source: cyclide::Error) -> Self {
        Self::Kernel(source)
    }
}

fn require(holds: bool, detail: &'static str) -> Result<(), Mismatch> {
    if holds { Ok(()) } else { Err(Mismatch::Structure(detail)) }
}

fn body_deviation(body: &Body, file: &FileBody, size: f64) -> Result<f64, Mismatch> {
    let edges = edges_of(file);
    let shells = body.shells().map(|shell| exported(shell, size, edges)).collect::<cyclide::Result<Vec<Shell>>>()?;
    let parts: Vec<Vec<Vec<usize>>> = shells.iter().map(Shell::parts).collect();
    let solid = shells.iter().all(Shell::is_closed) && parts.iter().all(|p| p.len() == 1);
    require(file.solid == solid, "it is a solid in one of file and model only")?;
    require(file.shells.len() == parts.iter().map(Vec::len).sum::<usize>(), "another number of shells")?;
    let mut read = file.shells.iter();
    let mut largest = 0.0_f64;
    for (index, (shell, parts)) in shells.iter().zip(&parts).enumerate() {
        let void = solid && index > 0;
        for part in parts {
            let Some(file) = read.next() else { break };
            require(file.forward != void, "a shell is used from the wrong side")?;
            require(file.closed == shell.is_closed(), "a shell is closed in one of file and model only")?;
            largest = larger(largest, shell_deviation(shell, part, void, file, size)?);
        }
        // A hollow's faces look into it: away from the solid.
        require(!solid || (shell.volume() > 0.0) != void, "a solid is inside out")?;
    }
    Ok(largest)
}

/// How the file was written: with rational edges only planes are other surfaces than rational ones.
fn edges_of(file: &FileBody) -> StepEdges {
    let is_curved =
        |f: &FileFace| !matches!(f.surface, FileSurface::Rational(_) | FileSurface::Analytic(PatchKind::Plane { .. }));
    let curved = file.shells.iter().flat_map(|shell| &shell.faces).any(is_curved);
    if curved { StepEdges::Circles } else { StepEdges::Rational }
}

/// Faces of one shell, or of the part of it that hangs together; `flip` where the file has the other sides.
fn shell_deviation(shell: &Shell, part: &[usize], flip: bool, file: &FileShell, size: f64) -> Result<f64, Mismatch> {
    require(file.faces.len() == part.len(), "another number of faces")?;
    let mut largest = 0.0_f64;
    // The model's edge of each edge of the file, and the directions in which it is used.
    let mut edges: HashMap<u64, (usize, Vec<bool>)> = HashMap::new();
    for (&index, file) in part.iter().zip(&file.faces) {
        let face = &shell.faces()[index];
        let outer_side = face.same_sense != flip;
        largest = larger(largest, surface_deviation(&face.surface, file, outer_side)?);
        let sides = face.edge_loop(outer_side);
        require(sides.len() == file.edges.len(), "another number of edges round a face")?;
        for (i, ((side, place, forward), edge)) in sides.into_iter().zip(&file.edges).enumerate() {
            let next = &file.edges[(i + 1) % file.edges.len()];
            require(edge.oriented()[1] == next.oriented()[0], "a loop does not run head to tail")?;
            require(edge.forward == forward, "an edge runs the wrong way round a face")?;
            let used = edges.entry(edge.edge).or_insert((place.edge, Vec::new()));
            require(used.0 == place.edge, "faces share an edge in the file only")?;
            used.1.push(edge.forward);
            largest = larger(largest, edge_deviation(&face.surface, side, place, edge));
            if let FileSurface::Rational(surface) = &file.surface {
                check_parameters(surface, (side, place), edge, size)?;
            }
        }
    }
    let of_model: HashSet<usize> = edges.values().map(|(edge, _)| *edge).collect();
    require(of_model.len() == edges.len(), "faces share an edge in the model only")?;
    for (_, uses) in edges.values() {
        let paired = matches!(uses[..], [a, b] if a != b);
        require(paired || (uses.len() == 1 && !file.closed), "an edge is not used once in each direction")?;
    }
    Ok(largest)
}

fn surface_deviation(of_model: &FaceSurface, file: &FileFace, outer_side: bool) -> Result<f64, Mismatch> {
    let places = (0..PLACES * PLACES).map(|k| (parameter(k % PLACES), parameter(k / PLACES)));
    let (distance, outward) = match &file.surface {
        FileSurface::Rational(surface) => {
            let apart = places.map(|(s, t)| surface.point(s, t).distance(of_model.point(s, t)));
            (apart.fold(0.0, larger), true)
        }
        FileSurface::Analytic(kind) => {
            let apart = places.map(|(s, t)| kind.distance(of_model.point(s, t)).unwrap_or(f64::INFINITY));
            let (middle, normal) = (of_model.point(0.5, 0.5), of_model.normal(0.5, 0.5));
            let outward = normal.zip(outward(kind, middle)).is_some_and(|(n, out)| n.dot(out) > 0.0);
            (apart.fold(0.0, larger), outward)
        }
    };
    require(file.same_sense == (outward == outer_side), "a face looks to the wrong side")?;
    Ok(distance)
}

/// A vector on the side of the surface's own normal.
fn outward(kind: &PatchKind, p: Point3) -> Option<Vec3> {
    let from_axis = |frame: &cyclide::Frame| {
        let v = p - frame.origin();
        v - frame.z() * v.dot(frame.z())
    };
    match kind {
        PatchKind::Plane { frame } => Some(frame.z()),
        PatchKind::Sphere { frame, .. } => Some(p - frame.origin()),
        PatchKind::Cylinder { frame, .. } | PatchKind::Cone { frame, .. } => Some(from_axis(frame)),
        PatchKind::Torus { frame, major_radius, .. } => {
            Some(p - (frame.origin() + from_axis(frame).unit()? * *major_radius))
        }
        PatchKind::Cyclide => None,
    }
}

/// A side of a face against the file's edge.
fn edge_deviation(surface: &FaceSurface, side: Side, place: FaceEdge, edge: &FileEdge) -> f64 {
    let mut largest = 0.0_f64;
    for i in 0..PLACES {
        let x = parameter(i);
        let along = place.turned(x);
        let (s, t) = side.place(x);
        let p = surface.point(s, t);
        largest = largest.max(match &edge.curve {
            ChainPiece::Arc(arc) => arc.closest_point(p).distance,
            ChainPiece::Spline(curve) => curve.point(along).distance(p),
        });
        if i == 0 || i + 1 == PLACES {
            largest = largest.max(edge.ends[usize::from(along > 0.5)].distance(p));
        }
    }
    let (start, end) = match &edge.curve {
        ChainPiece::Arc(arc) => (arc.start(), arc.end()),
        ChainPiece::Spline(curve) => (curve.point(0.0), curve.point(1.0)),
    };
    largest.max(start.distance(edge.ends[0])).max(end.distance(edge.ends[1]))
}

/// Holds an edge against its face's surface at equal parameters of the edge, as readers do: on the curve that the file has
/// in the surface's parameters; without one they interpolate, which is exact where the parameters are proportional.
fn check_parameters(
    surface: &RationalBezierSurface,
    (side, place): (Side, FaceEdge),
    edge: &FileEdge,
    size: f64,
) -> Result<(), Mismatch> {
    let ChainPiece::Arc(arc) = &edge.curve else {
        return Ok(()); // in the parameter of its faces, and compared there
    };
    // Far from the origin the file's points are as coarse as their numbers.
    let rounding = ROUNDING * arc.start().to_vec().max_abs().max(arc.end().to_vec().max_abs());
    if let Some(curve) = &edge.parameter_curve {
        // Short edges carry the rounding of their place.
        let (range, unit) = arc.radius().map_or((arc.length(), 1.0), |radius| (arc.angle(), radius));
        let (from, to) = curve.domain();
        require(
            from == 0.0 && (to - range).abs() <= 1e-9 * range + rounding / unit,
            "a parameter curve has another range than its edge",
        )?;
    }
    let places = (0..PLACES).map(|i| {
        let x = parameter(i);
        let on_curve = edge.parameter_curve.as_ref().map(|curve| curve.point(x));
        let (u, v) = on_curve.map_or_else(|| side.place(place.turned(x)), |at| (at.x, at.y));
        surface.point(u, v).distance(arc.point_at_length(x))
    });
    let (of_length, of_size) = PARAMETER_LIMIT;
    let apart = places.fold(0.0, larger);
    let limit = of_length * arc.length() + of_size * size + rounding;
    // Corners of a net may be off their circle by so much: along a side as short as that the weights disagree.
    let short = arc.length() <= SHORT_EDGE * size;
    require(apart <= limit || (short && apart <= arc.length()), "an edge leaves its face at equal parameters")
}

fn parameter(i: u32) -> f64 {
    f64::from(i) / f64::from(PLACES - 1)
}
