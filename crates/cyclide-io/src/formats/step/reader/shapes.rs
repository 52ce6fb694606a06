//! Bodies: shells, faces with their surfaces and loops, edges with their curves.

use super::{Basis, File, entity, enumeration, list, logical, number_of, numbers, reference, references, value};
use crate::check::bodies::{FileBody, FileCurve, FileEdge, FileFace, FileShell, FileSurface};
use crate::check::read_error::ReadError;
use cyclide::{
    Frame, Point3, Vec3,
    curve::{Arc, Circle},
    model::ChainPiece,
    rational::{NurbsCurve, RationalBezierSurface},
    surface::PatchKind,
};

/// Entities that are bodies.
const BODIES: [&str; 3] = ["MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "SHELL_BASED_SURFACE_MODEL"];

/// True for the names of bodies.
pub(super) fn is_body(name: &str) -> bool {
    BODIES.contains(&name)
}

impl File<'_> {
    pub(super) fn body(&self, number: u64) -> Result<FileBody, ReadError> {
        let name = self.instance(number)?.first().map_or("", |entity| entity.0);
        let place = format!("#{number}");
        let values = self.simple(number, name)?;
        if name == "SHELL_BASED_SURFACE_MODEL" {
            let shells = references(value(&values, 1, &place)?, &place)?;
            let shells = shells.into_iter().map(|s| self.shell(s, true)).collect::<Result<_, _>>()?;
            return Ok(FileBody { solid: false, shells });
        }
        let mut shells = vec![self.shell(reference(value(&values, 1, &place)?, &place)?, true)?];
        if name == "BREP_WITH_VOIDS" {
            for oriented in references(value(&values, 2, &place)?, &place)? {
                let place = format!("#{oriented}");
                let values = self.simple(oriented, "ORIENTED_CLOSED_SHELL")?;
                let forward = logical(value(&values, 3, &place)?, &place)?;
                shells.push(self.shell(reference(value(&values, 2, &place)?, &place)?, forward)?);
            }
        }
        Ok(FileBody { solid: true, shells })
    }

    fn shell(&self, number: u64, forward: bool) -> Result<FileShell, ReadError> {
        let place = format!("#{number}");
        let (values, closed) = match self.simple(number, "CLOSED_SHELL") {
            Ok(values) => (values, true),
            Err(_) => (self.simple(number, "OPEN_SHELL")?, false),
        };
        let faces = references(value(&values, 1, &place)?, &place)?;
        let faces = faces.into_iter().map(|f| self.face(f)).collect::<Result<_, _>>()?;
        Ok(FileShell { closed, forward, faces })
    }

    fn face(&self, number: u64) -> Result<FileFace, ReadError> {
        let place = format!("#{number}");
        let values = self.simple(number, "ADVANCED_FACE")?;
        let bounds = references(value(&values, 1, &place)?, &place)?;
        let surface_number = reference(value(&values, 2, &place)?, &place)?;
        let surface = self.surface(surface_number)?;
        let same_sense = logical(value(&values, 3, &place)?, &place)?;
        let mut loops = Vec::with_capacity(bounds.len());
        for (index, bound) in bounds.into_iter().enumerate() {
            // The outer loop is the first one.
            let name = if index == 0 { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
            loops.push(self.bound(bound, name, surface_number)?);
        }
        if loops.is_empty() {
            return Err(ReadError::unsupported("a face without bounds", place));
        }
        let holes = loops.split_off(1);
        Ok(FileFace { surface, same_sense, edges: loops.remove(0), holes })
    }

    fn bound(&self, number: u64, name: &str, surface: u64) -> Result<Vec<FileEdge>, ReadError> {
        let place = format!("#{number}");
        let bound = self.simple(number, name)?;
        if !logical(value(&bound, 2, &place)?, &place)? {
            return Err(ReadError::unsupported("a reversed bound", place));
        }
        let edges = reference(value(&bound, 1, &place)?, &place)?;
        let edges = references(value(&self.simple(edges, "EDGE_LOOP")?, 1, &place)?, &place)?;
        edges.into_iter().map(|e| self.oriented_edge(e, surface)).collect()
    }

    /// An edge as the loop of a face on this surface uses it.
    fn oriented_edge(&self, number: u64, surface: u64) -> Result<FileEdge, ReadError> {
        let place = format!("#{number}");
        let values = self.simple(number, "ORIENTED_EDGE")?;
        let edge = reference(value(&values, 3, &place)?, &place)?;
        let forward = logical(value(&values, 4, &place)?, &place)?;
        let place = format!("#{edge}");
        let values = self.simple(edge, "EDGE_CURVE")?;
        if !logical(value(&values, 4, &place)?, &place)? {
            return Err(ReadError::unsupported("an edge opposite to its curve", place));
        }
        let part = |i: usize| reference(value(&values, i, &place)?, &place);
        let vertices = [part(1)?, part(2)?];
        let mut ends = [Point3::ORIGIN; 2];
        for (end, &vertex) in ends.iter_mut().zip(&vertices) {
            let point = reference(value(&self.simple(vertex, "VERTEX_POINT")?, 1, &place)?, &place)?;
            *end = self.point(point)?;
        }
        let (curve, parameter_curve) = match self.simple(part(3)?, "SURFACE_CURVE") {
            Ok(values) => (reference(value(&values, 1, &place)?, &place)?, self.parameter_curve(part(3)?, surface)?),
            Err(_) => (part(3)?, None),
        };
        let curve =
            if vertices[0] == vertices[1] { self.whole_circle(curve, ends[0])? } else { self.edge_curve(curve, ends)? };
        Ok(FileEdge { edge, vertices, ends, forward, curve, parameter_curve })
    }

    /// Of a curve on surfaces the one in the parameters of this surface.
    fn parameter_curve(&self, number: u64, surface: u64) -> Result<Option<NurbsCurve>, ReadError> {
        let place = format!("#{number}");
        let values = self.simple(number, "SURFACE_CURVE")?;
        if enumeration(value(&values, 3, &place)?, &place)? != "CURVE_3D" {
            return Err(ReadError::unsupported("an edge whose master representation is not the space curve", place));
        }
        for curve in references(value(&values, 2, &place)?, &place)? {
            let place = format!("#{curve}");
            let values = self.simple(curve, "PCURVE")?;
            if reference(value(&values, 1, &place)?, &place)? == surface {
                let definition = reference(value(&values, 2, &place)?, &place)?;
                let items = self.simple(definition, "DEFINITIONAL_REPRESENTATION")?;
                let items = references(value(&items, 1, &place)?, &place)?;
                let [item] = items[..] else {
                    return Err(ReadError::unsupported("several parameter curves on one surface", place));
                };
                return self.b_spline(&self.instance(item)?, item).map(Some);
            }
        }
        Ok(None)
    }

    /// The circle from a vertex to itself, from the foot of that; a spline may be closed too.
    fn whole_circle(&self, number: u64, vertex: Point3) -> Result<FileCurve, ReadError> {
        let place = format!("#{number}");
        if self.instance(number)?.len() > 1 {
            return self.edge_curve(number, [vertex; 2]);
        }
        let Basis::Circle { center, z, x, radius } = self.basis(number)? else {
            return Err(ReadError::unsupported("a line from a vertex to itself", place));
        };
        let from = vertex - center;
        let spoke = (x * from.dot(x) + z.cross(x) * from.dot(z.cross(x))).unit().unwrap_or(x);
        let circle = Circle::from_center(center, z, center + spoke * radius);
        circle.map(FileCurve::Circle).map_err(|source| ReadError::Geometry { place, source })
    }

    /// The curve between two vertices: on a circle the way in its direction, from the foot of the first vertex.
    fn edge_curve(&self, number: u64, [start, end]: [Point3; 2]) -> Result<FileCurve, ReadError> {
        let place = format!("#{number}");
        let fail = |source| ReadError::Geometry { place: place.clone(), source };
        let instance = self.instance(number)?;
        if instance.len() > 1 {
            return Ok(FileCurve::Piece(ChainPiece::Spline(self.b_spline(&instance, number)?)));
        }
        let arc = match self.basis(number)? {
            Basis::Line { origin, direction } => {
                let foot = |p: Point3| origin + direction * (p - origin).dot(direction);
                Arc::segment(foot(start), foot(end))
            }
            Basis::Circle { center, z, x, radius } => {
                let angle = |p: Point3| (p - center).dot(z.cross(x)).atan2((p - center).dot(x));
                let (from, to) = (angle(start), angle(end));
                let (sin, cos) = from.sin_cos();
                let foot = center + (x * cos + z.cross(x) * sin) * radius;
                Arc::from_center(center, z, foot, (to - from).rem_euclid(std::f64::consts::TAU))
            }
        };
        Ok(FileCurve::Piece(ChainPiece::Arc(arc.map_err(fail)?)))
    }

    fn surface(&self, number: u64) -> Result<FileSurface, ReadError> {
        let place = format!("#{number}");
        let instance = self.instance(number)?;
        let [(name, values)] = instance.as_slice() else {
            return Ok(FileSurface::Rational(self.b_spline_surface(number)?));
        };
        let fail = |source| ReadError::Geometry { place: place.clone(), source };
        let (origin, z, x): (Point3, Vec3, Vec3) = self.placement(reference(value(values, 1, &place)?, &place)?)?;
        let frame = Frame::from_normal(origin, z, x).map_err(fail)?;
        let measure = |i: usize| number_of(value(values, i, &place)?, &place);
        let outward = true;
        Ok(FileSurface::Analytic(match *name {
            "PLANE" => PatchKind::Plane { frame },
            "SPHERICAL_SURFACE" => PatchKind::Sphere { frame, radius: measure(2)?, outward },
            "CYLINDRICAL_SURFACE" => PatchKind::Cylinder { frame, radius: measure(2)?, outward },
            "CONICAL_SURFACE" => PatchKind::Cone { frame, radius: measure(2)?, half_angle: measure(3)?, outward },
            "TOROIDAL_SURFACE" => {
                PatchKind::Torus { frame, major_radius: measure(2)?, minor_radius: measure(3)?, outward }
            }
            other => return Err(ReadError::unsupported(other, place)),
        }))
    }

    fn b_spline_surface(&self, number: u64) -> Result<RationalBezierSurface, ReadError> {
        let place = format!("#{number}");
        let instance = self.instance(number)?;
        let surface = entity(&instance, "B_SPLINE_SURFACE", &place)?;
        let weights = list(value(entity(&instance, "RATIONAL_B_SPLINE_SURFACE", &place)?, 0, &place)?, &place)?;
        let rows = list(value(surface, 2, &place)?, &place)?;
        let mut homogeneous = Vec::with_capacity(9);
        for (points, weights) in rows.iter().zip(weights) {
            let (points, weights) = (references(points, &place)?, numbers(weights, &place)?);
            for (point, w) in points.into_iter().zip(weights) {
                if !(w > 0.0) {
                    return Err(ReadError::unsupported("a weight that is not positive", place));
                }
                let p = self.point(point)?;
                homogeneous.push([p.x * w, p.y * w, p.z * w, w]);
            }
        }
        let degree = |i: usize| number_of(value(surface, i, &place)?, &place);
        // One Bézier span: the degrees are one less than the rows and columns.
        let degrees = [rows.len().saturating_sub(1), (homogeneous.len() / rows.len().max(1)).saturating_sub(1)];
        if [degree(0)?, degree(1)?].map(f64::to_bits) != degrees.map(|degree| (degree as f64).to_bits()) {
            return Err(ReadError::unsupported("a surface with several spans", place));
        }
        RationalBezierSurface::new(degrees, homogeneous).map_err(|source| ReadError::Geometry { place, source })
    }
}
