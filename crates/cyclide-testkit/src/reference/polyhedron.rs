//! Smooth offsets of convex polyhedra, and the polygons of spheres of which they are made:
//! `docs/math/reference-cases.md#surfaces-of-arcs`.

use super::Handler;
use super::arc::{Rules, xyz};
use super::case::{Case, Fault};
use super::check::{Check, numbers};
use cyclide::{
    Vec3,
    construct::{ConvexPolyhedron, SphericalPolygon},
    rational::RationalBezierSurface,
    surface::PatchKind,
    topology::{Body, FaceSurface},
};
use std::collections::HashMap;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "polyhedron-offset" => offset,
        "sphere-polygon" => polygon,
        _ => return None,
    })
}

fn polygon(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let (center, radius) = (case.point("center")?, case.number("radius")?);
    let polygon = SphericalPolygon::new(&case.vectors("normals")?)?;
    let apex = xyz(center + polygon.apex() * radius);
    check.vector("apex", Some(&apex), &rules.point());
    let sides = (0..polygon.corners().len()).map(|side| polygon.fan(center, radius, side));
    let sides: Vec<RationalBezierSurface> = sides.collect::<cyclide::Result<_>>()?;
    check.rows("samples", 3, |at| sides.get(at[0] as usize).map(|side| xyz(side.point(at[1], at[2]))), &rules.point());
    Ok(())
}

fn offset(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let radius = case.number("radius")?;
    let polyhedron = ConvexPolyhedron::new(&case.points("vertices")?, &faces(case)?)?;
    let body = polyhedron.offset(radius)?;
    counts(&polyhedron, &body, check);
    let angles: HashMap<[usize; 2], f64> = polyhedron
        .edges()
        .map(|edge| {
            let [a, b] = edge.ends;
            ([a.min(b), a.max(b)], edge.angle)
        })
        .collect();
    // Edges inside a side of several faces have no angle.
    let angle = |at: &[f64]| Some(vec![*angles.get(&[at[0] as usize, at[1] as usize]).unwrap_or(&0.0)]);
    check.rows("edge_angles", 2, angle, &rules.unit());
    let solid = |k| polyhedron.normal_cone(k).map_or(0.0, SphericalPolygon::solid_angle);
    let solid: Vec<_> = (0..polyhedron.vertices().len()).map(|k| Some(vec![solid(k)])).collect();
    check.list("vertex_solid_angles", &solid, &rules.unit());
    // Both by Steiner's formulas and measured on the body.
    check.number("volume", Some(polyhedron.offset_volume(radius)), &rules.relative());
    check.number("volume", Some(body.outer.known_volume()?), &rules.relative());
    check.number("area", Some(polyhedron.offset_area(radius)), &rules.relative());
    check.number("area", Some(body.outer.known_area()?), &rules.relative());
    let support = |d: &[f64]| {
        let direction = Vec3::new(d[0], d[1], d[2]);
        Some(vec![polyhedron.support(direction) + radius * direction.length()])
    };
    check.rows("support", 3, support, &rules.point());
    Ok(())
}

/// Faces of the polyhedron, and what the body has for edges and vertices.
fn counts(polyhedron: &ConvexPolyhedron, body: &Body, check: &mut Check) {
    check.exact("plane_faces", polyhedron.faces().len());
    check.exact("cylinders", polyhedron.edges().count());
    check.exact("sphere_patches", polyhedron.corner_count());
    let cylinder = |surface: &FaceSurface| {
        surface.patch().is_some_and(|patch| matches!(patch.recognize(), PatchKind::Cylinder { outward: true, .. }))
    };
    let strips: Vec<_> = body.outer.faces().iter().filter(|face| face.surface.patch().is_some()).collect();
    if strips.len() < polyhedron.edges().count() || !strips.iter().all(|face| cylinder(&face.surface)) {
        check.fail("cylinders", "an edge has a face that is no cylinder".into());
    }
}

fn faces(case: &Case) -> Result<Vec<Vec<usize>>, Fault> {
    let malformed = || Fault::Malformed("faces are lists of vertices".into());
    let list = case.input("faces")?.as_array().ok_or_else(malformed)?;
    let face = |value| Some(numbers(value)?.into_iter().map(|v| v as usize).collect());
    list.iter().map(face).collect::<Option<_>>().ok_or_else(malformed)
}
