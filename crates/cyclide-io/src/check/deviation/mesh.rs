//! The distance between the polygons of a file and the cells of the patches that they stand for, both ways, and their
//! structure.
//!
//! Every polygon is held against its own cell, not against the nearest part of the surface: swapped, missing and
//! doubled polygons are found out. On planes and cylinders a cell may lie over the polygons of its neighbors, and only what
//! leaves the surface counts: there the polygons of a face are held against the face. From the cell 5 × 5 points are taken to the polygon, from the polygon its corners,
//! the middles of its sides and its center to the cell; the middle of a cell, where the distance is largest, is among
//! them. Polygons look to the outer side of their face, normals are those of the surface (in STL of the triangle), and
//! polygons share the sides that they share in the kernel's mesh.

use super::cover::Cover;
use super::facing::{Facing, NORMAL_LIMIT, facet_error};
use super::matching::larger;
use super::nearest::NearestTriangle;
use super::polygon::{MeshForm, Normals, Polygon};
use super::triangle::Triangle;
use super::triangle_surface;
use crate::check::read_error::ReadError;
use crate::export::mesh_plan::{BodyPlan, Cell, MeshPlan};
use crate::export::parts::BodyOf;
use crate::export::side_use::{SideUse, side_use};
use crate::export::triangle_cells::are_whole;
use cyclide::{
    Point3, SurfaceJet, Vec3,
    mesh::{MeshCorner, MeshSource, SurfaceMesh},
    surface::{ParamSurface as _, PatchKind, TriangleSurface},
    topology::{FaceGeometry as _, FaceSurface, ShellFace},
};

/// Points of a cell in each direction.
const GRID: usize = 5;
/// Steps to the foot of a point on a patch.
const STEPS: usize = 16;
/// Parameter lines are orthogonal below this square of a cosine, and one line but for rounding below the square of a sine.
const ORTHOGONAL: f64 = 1e-6;
const ONE_LINE: f64 = 1e-22;
/// The largest distance between the polygons of each body and the body, both ways.
///
/// # Errors
/// [`ReadError::PolygonCount`], [`ReadError::NotCovered`], [`ReadError::NoPolygons`], [`ReadError::WrongSide`],
/// [`ReadError::Normal`], [`ReadError::SideUse`].
pub(crate) fn mesh_deviation(
    form: MeshForm,
    bodies: &[BodyOf<'_>],
    meshes: &[SurfaceMesh],
    plan: &MeshPlan,
) -> Result<Vec<f64>, ReadError> {
    check_cover(bodies, &plan.cells)?;
    let expected = plan.cells.iter().map(|cell| cell.polygons).sum();
    let found = meshes.iter().map(|mesh| mesh.faces.len()).sum();
    if found != expected {
        return Err(ReadError::PolygonCount { found, expected });
    }
    let mut polygons = meshes
        .iter()
        .enumerate()
        .flat_map(|(number, mesh)| mesh.faces.iter().map(move |face| Polygon { mesh, number, face }));
    let mut deviations = vec![0.0; bodies.len()];
    for (cells, plan) in plan.cells.chunk_by(|a, b| a.body == b.body).zip(&plan.bodies) {
        let Some((index, body)) = cells.first().and_then(|cell| Some((cell.body, bodies.get(cell.body)?))) else {
            continue;
        };
        let count = cells.iter().map(|cell| cell.polygons).sum();
        let own: Vec<Polygon<'_>> = polygons.by_ref().take(count).collect();
        if own.is_empty() {
            return Err(ReadError::NoPolygons { object: body.label() });
        }
        let own_deviation = match body.body.triangles() {
            None => body_deviation(form, body, cells, &own, plan)?,
            Some(surface) => triangle_surface::deviation(form, body, surface, cells, &own, plan)?,
        };
        deviations[index] = larger(deviations[index], own_deviation);
        check_sides(form, body, cells, &own, plan)?;
    }
    Ok(deviations)
}

/// The largest distance between the polygons of one body and its cells.
fn body_deviation(
    form: MeshForm,
    body: &BodyOf<'_>,
    cells: &[Cell],
    polygons: &[Polygon<'_>],
    plan: &BodyPlan,
) -> Result<f64, ReadError> {
    let mut rest = polygons;
    let mut triangles: Vec<Triangle> = Vec::new();
    let mut largest = 0.0_f64;
    let mut lost: Vec<&Cell> = Vec::new();
    for cells in cells.chunk_by(|a, b| (a.source.shell, a.source.face) == (b.source.shell, b.source.face)) {
        let (of_face, after) = rest.split_at(cells.iter().map(|cell| cell.polygons).sum());
        rest = after;
        let Some((index, face)) = cells.first().and_then(|cell| face(body, &cell.source)) else { continue };
        let mut whole = WholeFace::of(&face.surface, of_face);
        let mut of_cells = of_face;
        for cell in cells {
            let (own, after) = of_cells.split_at(cell.polygons);
            of_cells = after;
            triangles.clear();
            triangles.extend(own.iter().flat_map(Polygon::triangles));
            if own.is_empty() {
                lost.push(cell);
                continue;
            }
            let samples = samples(&face.surface, &cell.source);
            largest = cell_deviation(&face.surface, &cell.source, &samples, &triangles, whole.as_mut(), largest);
            let facing = Facing::new(face, &cell.source);
            if !triangles.iter().all(|triangle| facing.is_outward(&triangle.corners)) {
                return Err(ReadError::WrongSide { object: body.label(), face: index });
            }
            let off = own.iter().map(|polygon| normal_error(form, polygon, &facing, plan.moved)).fold(0.0, larger);
            if !(off <= NORMAL_LIMIT) {
                return Err(ReadError::Normal { object: body.label(), face: index, off, limit: NORMAL_LIMIT });
            }
        }
    }
    Ok(with_lost_cells(body, &lost, polygons, largest))
}

/// The largest distance with that of the cells of which rounding has left no polygon, for what it is without them: from
/// the nearest of all polygons.
fn with_lost_cells(body: &BodyOf<'_>, lost: &[&Cell], polygons: &[Polygon<'_>], mut largest: f64) -> f64 {
    if lost.is_empty() {
        return largest;
    }
    let mut nearest = NearestTriangle::new(polygons.iter().flat_map(Polygon::triangles).collect());
    for cell in lost {
        let Some((_, face)) = face(body, &cell.source) else { continue };
        for (_, _, p) in samples(&face.surface, &cell.source) {
            largest = larger(largest, nearest.distance(p, largest));
        }
    }
    largest
}

/// How far the normals of a polygon are off: in STL that of the triangle, elsewhere those of the surface at the corners.
fn normal_error(form: MeshForm, polygon: &Polygon<'_>, facing: &Facing<'_>, moved: f64) -> f64 {
    let corners = polygon.face.corners();
    let normal = |corner: &MeshCorner| polygon.mesh.normals[corner.normal];
    match form.normals {
        Normals::None => return 0.0,
        Normals::OfTriangles => {
            let facet = corners.first().map(normal).unwrap_or_default();
            return polygon.triangles().map(|triangle| facet_error(&triangle.corners, facet)).fold(0.0, larger);
        }
        Normals::OfSurface => {}
    }
    let errors = corners.iter().map(|corner| facing.normal_error(polygon.point(corner), normal(corner), moved));
    errors.fold(0.0, larger)
}

/// Polygons share the sides that cells share in the shell: all but those on edges of one face alone. In OBJ and 3MF vertices are
/// shared by number; GLB and PLY have one per normal and STL none, so that readers know them by equal bits.
///
/// Where rounding has made one of several vertices, sides vanish or lie on each other, and what is left of them is known
/// from the mesh that was written only.
fn check_sides(
    form: MeshForm,
    body: &BodyOf<'_>,
    cells: &[Cell],
    polygons: &[Polygon<'_>],
    plan: &BodyPlan,
) -> Result<(), ReadError> {
    let found = if form.numbers_vertices {
        side_use(polygons.iter().map(|p| p.face.corners().iter().map(|c| (p.number, c.position))))
    } else {
        let bits = |p: Point3| p.to_array().map(f64::to_bits);
        side_use(polygons.iter().map(|p| p.face.corners().iter().map(move |c| bits(p.point(c)))))
    };
    let expected = match body.body.triangles() {
        _ if plan.merged => plan.sides,
        Some(surface) => SideUse { free: triangle_surface::free_sides(surface, cells), repeated: 0 },
        None => shell_sides(body, cells),
    };
    if found == expected {
        return Ok(());
    }
    let (free, repeated) = ([found.free, expected.free], [found.repeated, expected.repeated]);
    Err(ReadError::SideUse { object: body.label(), free, repeated })
}

/// The sides of cells on edges that one face has alone.
fn shell_sides(body: &BodyOf<'_>, cells: &[Cell]) -> SideUse {
    let users = body.body.shells().map(|shell| {
        let mut users = vec![0_u32; shell.edges().len()];
        shell.faces().iter().flat_map(|face| &face.sides).flatten().for_each(|side| users[side.edge] += 1);
        users
    });
    let users: Vec<Vec<u32>> = users.collect();
    let mut free = 0;
    for Cell { source, .. } in cells {
        let Some((_, face)) = face(body, source) else { continue };
        // Cuts at the sides are these doubles.
        let ends = [source.t[0] <= 0.0, source.t[1] >= 1.0, source.s[0] <= 0.0, source.s[1] >= 1.0];
        let sides = ends.into_iter().zip(&face.sides).filter(|(at_side, _)| *at_side).filter_map(|(_, side)| *side);
        free += sides.filter(|side| users[source.shell][side.edge] == 1).count();
    }
    SideUse { free, repeated: 0 }
}

/// The face of a cell with its number, those of all shells counted through.
fn face<'a>(body: &'a BodyOf<'_>, source: &MeshSource) -> Option<(usize, &'a ShellFace)> {
    let before: usize = body.body.shells().take(source.shell).map(|shell| shell.faces().len()).sum();
    let face = body.body.shells().nth(source.shell)?.faces().get(source.face)?;
    Some((before + source.face, face))
}

/// Every face of every body is covered by its cells once.
fn check_cover(bodies: &[BodyOf<'_>], cells: &[Cell]) -> Result<(), ReadError> {
    let mut of_bodies: Vec<Vec<&MeshSource>> = bodies.iter().map(|_| Vec::new()).collect();
    for Cell { body, source, .. } in cells {
        if let Some(own) = of_bodies.get_mut(*body) {
            own.push(source);
        }
    }
    let mut cover = Cover::default();
    for (body, mut cells) in bodies.iter().zip(of_bodies) {
        cells.sort_by_key(|source| (source.shell, source.face));
        let mut rest = cells.as_slice();
        let triangles = body.body.triangles();
        let of_faces =
            body.body.shells().enumerate().flat_map(|(k, shell)| (0..shell.faces().len()).map(move |f| (k, f)));
        let of_triangles = (0..triangles.map_or(0, TriangleSurface::triangle_count)).map(|triangle| (0, triangle));
        for (number, place) in of_faces.chain(of_triangles).enumerate() {
            let count = rest.iter().take_while(|source| (source.shell, source.face) == place).count();
            let (own, after) = rest.split_at(count);
            rest = after;
            let whole = match triangles {
                None => cover.is_whole(own.iter().copied()),
                Some(_) => are_whole(own),
            };
            if !whole {
                return Err(ReadError::NotCovered { object: body.label(), face: number });
            }
        }
    }
    Ok(())
}

/// A point of a patch with its parameters.
type Sample = (f64, f64, Point3);

/// Points of a cell, evenly in both parameters.
fn samples(surface: &FaceSurface, source: &MeshSource) -> [Sample; GRID * GRID] {
    let within = |[from, to]: [f64; 2], i: usize| from + (to - from) * (i as f64 / (GRID - 1) as f64);
    std::array::from_fn(|k| {
        let (s, t) = (within(source.s, k % GRID), within(source.t, k / GRID));
        (s, t, surface.point(s, t))
    })
}

/// The largest of a distance that is known and those between a cell and its triangles, both ways. A point that is known to
/// be as near as that is not looked at any closer.
fn cell_deviation(
    surface: &FaceSurface,
    source: &MeshSource,
    samples: &[Sample],
    triangles: &[Triangle],
    mut whole: Option<&mut WholeFace<'_>>,
    mut largest: f64,
) -> f64 {
    for (_, _, p) in samples {
        let mut best = f64::INFINITY;
        for triangle in triangles {
            best = best.min(triangle.distance(*p));
            if best <= largest {
                break;
            }
        }
        if let Some(whole) = whole.as_mut().filter(|_| !(best <= largest)) {
            best = whole.distance(*p, largest);
        }
        largest = larger(largest, best);
    }
    let is_plane = surface.is_plane_quad();
    let reach = if whole.is_some() { MeshSource { s: [0.0, 1.0], t: [0.0, 1.0], ..*source } } else { *source };
    for Triangle { corners: [a, b, c], .. } in triangles {
        let center = Point3::ORIGIN + (a.to_vec() + b.to_vec() + c.to_vec()) / 3.0;
        for p in [*a, *b, *c, a.midpoint(*b), b.midpoint(*c), c.midpoint(*a), center] {
            // Parts of planes are the triangles between their samples.
            let apart =
                if is_plane { between_samples(samples, p).1 } else { to_cell(surface, &reach, samples, p, largest) };
            largest = larger(largest, apart);
        }
    }
    largest
}

/// The polygons of a face on a plane or a cylinder.
struct WholeFace<'a> {
    polygons: &'a [Polygon<'a>],
    /// Made when it is needed: most points are near the polygons of their own cell.
    nearest: Option<NearestTriangle>,
}

impl<'a> WholeFace<'a> {
    /// None of other surfaces, and of one cell.
    fn of(surface: &FaceSurface, polygons: &'a [Polygon<'a>]) -> Option<Self> {
        let FaceSurface::Rational(rational) = surface else { return None };
        let rolls_out = matches!(rational.recognize(), PatchKind::Plane { .. } | PatchKind::Cylinder { .. });
        (rolls_out && !surface.is_plane_quad() && polygons.len() > 2).then_some(Self { polygons, nearest: None })
    }

    /// Distance of a point from the nearest polygon, or what is `enough` at most.
    fn distance(&mut self, p: Point3, enough: f64) -> f64 {
        let made = || NearestTriangle::new(self.polygons.iter().flat_map(Polygon::triangles).collect());
        self.nearest.get_or_insert_with(made).distance(p, enough)
    }
}

/// Distance of a point from the cell. What is `enough` is not made smaller.
///
/// From the nearest sample the foot is a few steps away, unless parameter lines are nearly one line: then the nearest sample
/// may lie far from it in the parameters, and the triangles between the samples show the way.
fn to_cell(surface: &FaceSurface, source: &MeshSource, samples: &[Sample], p: Point3, enough: f64) -> f64 {
    let nearest = samples.iter().map(|&(s, t, q)| (s, t, q.distance(p))).min_by(|a, b| a.2.total_cmp(&b.2));
    let (s, t, distance) = nearest.unwrap_or((source.s[0], source.t[0], f64::INFINITY));
    if distance <= enough {
        return distance;
    }
    let found = down_to_foot(surface, source, [s, t], p, enough).min(distance);
    if found <= enough {
        return found;
    }
    down_to_foot(surface, source, between_samples(samples, p).0, p, enough).min(found)
}

/// The distance from the foot of a point that steps from a place lead to.
fn down_to_foot(surface: &FaceSurface, source: &MeshSource, from: [f64; 2], p: Point3, enough: f64) -> f64 {
    let ([mut s, mut t], mut best) = (from, f64::INFINITY);
    for _ in 0..STEPS {
        let jet = surface.jet(s, t);
        let offset = p - jet.point;
        best = best.min(offset.length());
        if best <= enough {
            return best;
        }
        let [ds, dt] = step(&jet, offset);
        s = (s + ds).clamp(source.s[0], source.s[1]);
        t = (t + dt).clamp(source.t[0], source.t[1]);
    }
    best.min(surface.point(s, t).distance(p))
}

/// The parameters of the place nearest to a point on the triangles between the samples, and its distance.
fn between_samples(samples: &[Sample], p: Point3) -> ([f64; 2], f64) {
    let mut best = ([0.0; 2], f64::INFINITY);
    let first_corners = (0..(GRID - 1) * GRID).filter(|k| k % GRID + 1 < GRID);
    for three in first_corners.flat_map(|k| [[k, k + 1, k + GRID], [k + GRID + 1, k + GRID, k + 1]]) {
        let corners = three.map(|k| samples[k]);
        let triangle = Triangle::new(corners.map(|(_, _, q)| q));
        let distance = triangle.distance(p);
        if distance < best.1 {
            let weights = triangle.nearest(p);
            let mean = |of: fn(&Sample) -> f64| corners.iter().zip(weights).map(|(c, w)| of(c) * w).sum();
            best = ([mean(|c| c.0), mean(|c| c.1)], distance);
        }
    }
    best
}

/// The step in both parameters that takes the tangent plane nearest to a point. Where parameter lines are orthogonal, as
/// on patches, it is two projections; so it is where they are one line. Quotients of derivatives neither vanish nor
/// overflow, their products would.
fn step(jet: &SurfaceJet, offset: Vec3) -> [f64; 2] {
    let [e, f, g] = jet.first_form();
    let part = |v: f64, square: f64| if square > 0.0 { v / square } else { 0.0 };
    let (a, b) = (part(offset.dot(jet.ds), e), part(offset.dot(jet.dt), g));
    if part(f, e) * part(f, g) < ORTHOGONAL {
        return [a, b];
    }
    let (Some(u), Some(v)) = (jet.ds.unit(), jet.dt.unit()) else { return [a, b] };
    // The sine by the normal: of lines that are nearly one the cosine has lost it.
    let across = u.cross(v);
    let sine_squared = across.length_squared();
    if !(sine_squared > ONE_LINE) {
        return [a, b];
    }
    let along = |way: Vec3, derivative: Vec3| way.dot(across) / sine_squared / derivative.length();
    [along(offset.cross(v), jet.ds), along(u.cross(offset), jet.dt)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{
        mesh::{MeshFace, tessellate},
        surface::CyclidePatch,
        topology::{Body, Shell},
    };

    /// The octant of the unit sphere as triangles and quads, with a plan.
    fn octant() -> (BodyOf<'static>, SurfaceMesh, MeshPlan) {
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
        let body = Body { outer: Shell::from_surface(patch).unwrap(), voids: Vec::new() };
        let mesh = tessellate(&body, 1e-2).unwrap();
        let cells = mesh.sources.iter().map(|source| Cell { body: 0, source: *source, polygons: 1 }).collect();
        let sides = side_use(mesh.faces.iter().map(|face| face.corners().iter().map(|corner| corner.position)));
        let plan = MeshPlan { cells, bodies: vec![BodyPlan { sides, merged: true, moved: 0.0 }] };
        (
            BodyOf { object: "octant", item: 0, surface: 0, index: 0, count: 1, name: None, body: body.into() },
            mesh,
            plan,
        )
    }

    fn measured(body: BodyOf<'_>, mesh: SurfaceMesh, plan: &MeshPlan) -> Result<f64, ReadError> {
        Ok(mesh_deviation(MeshForm { normals: Normals::OfSurface, numbers_vertices: true }, &[body], &[mesh], plan)?[0])
    }

    #[test]
    fn a_body_without_polygons_is_refused() {
        let (body, mesh, plan) = octant();
        let whole = measured(body, mesh, &plan).unwrap();
        assert!(whole > 3e-3 && whole <= 1e-2, "{whole:e}");
        let (body, mut mesh, mut plan) = octant();
        mesh.faces.clear();
        plan.cells.iter_mut().for_each(|cell| cell.polygons = 0);
        plan.bodies[0].sides = SideUse::default();
        assert_eq!(measured(body, mesh, &plan), Err(ReadError::NoPolygons { object: "octant".to_owned() }));
    }

    /// A cell that has no polygon is not passed over: it is as far from the mesh as the middle of the hole.
    #[test]
    fn a_cell_without_polygons_is_measured() {
        let (body, mut mesh, mut plan) = octant();
        let inner = |cell: &Cell| {
            let [s, t] = [cell.source.s, cell.source.t];
            s[0] > 0.0 && s[1] < 1.0 && t[0] > 0.0 && t[1] < 1.0
        };
        let k = plan.cells.iter().position(inner).unwrap();
        let corners: Vec<Point3> = mesh.faces[k].corners().iter().map(|c| mesh.positions[c.position]).collect();
        mesh.faces.remove(k);
        plan.cells[k].polygons = 0;
        plan.bodies[0].sides.free += 4;
        let hole = measured(body, mesh, &plan).unwrap();
        // From the middle of a quad to its sides: half of the shorter middle line, up to the sagitta.
        let side = |i: usize, j: usize| {
            corners[i].midpoint(corners[(i + 1) % 4]).distance(corners[j].midpoint(corners[(j + 1) % 4]))
        };
        let half = 0.5 * side(0, 2).min(side(1, 3));
        assert!(half > 5e-2 && hole > 0.95 * half && hole < 1.05 * half, "{hole:e} {half:e}");
    }

    /// A mesh that was written torn is found out although the file is what was written.
    #[test]
    fn sides_are_those_of_the_shell() {
        let (body, mut mesh, mut plan) = octant();
        plan.bodies[0].merged = false;
        let Ok(_) = measured(body, mesh.clone(), &plan) else { panic!("the mesh is whole") };
        let inner = |cell: &Cell| cell.source.s[0] > 0.0 && cell.source.t[0] > 0.0;
        let k = plan.cells.iter().position(inner).unwrap();
        let MeshFace::Quad(corners) = &mut mesh.faces[k] else { panic!("a quad") };
        mesh.positions.push(mesh.positions[corners[0].position]);
        corners[0].position = mesh.positions.len() - 1;
        let (body, ..) = octant();
        plan.bodies[0].sides.free += 4;
        assert!(matches!(measured(body, mesh, &plan), Err(ReadError::SideUse { .. })));
    }

    /// A cell that stands twice, one that is not there, and one as large elsewhere in its place.
    #[test]
    fn cells_cover_their_faces_once() {
        let refused = |change: fn(&mut Vec<Cell>)| {
            let (body, mesh, mut plan) = octant();
            change(&mut plan.cells);
            measured(body, mesh, &plan) == Err(ReadError::NotCovered { object: "octant".to_owned(), face: 0 })
        };
        assert!(refused(|cells| cells.push(cells[0])));
        assert!(refused(|cells| cells.truncate(cells.len() - 1)));
        assert!(refused(|cells| cells[0].source = cells[1].source));
        assert!(refused(|cells| cells[0].source.s[1] += 1e-15));
    }
}
