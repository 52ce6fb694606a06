//! Smooth offsets of convex polyhedra: planes, cylinders along the edges, parts of spheres round the vertices, exact
//! (`docs/math/polyhedron-offsets.md#pieces`; source: `000`, section 7, Fig. 9).
//!
//! Every face moves along its normal; the rows of its side and of the neighbor's side span a part of a cylinder, a patch with the
//! weights `1, w, 1, w`, `w` the rotor of half the angle between the normals; the circles at its ends bound the polygon on the
//! sphere about the vertex, whose corners are the normals of the faces there. Sides so long that a face of that polygon would have
//! weights that are not positive are halved, and so is the cylinder along them. Polygons become quads between their own
//! corners, and a triangle where these are odd in number: no other face has a vertex inside one of their sides.

use super::ConvexPolyhedron;
use super::convex::edge_axis;
use super::faces::FaceSide;
use super::spherical_polygon::{placed, sector};
use crate::base::bounds::Aabb;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::LARGEST_ARC;
use crate::error::{ErrorItem, NumberError, Result};
use crate::rational::RationalBezierSurface;
use crate::surface::CyclidePatch;
use crate::topology::{Body, FaceEdge, FaceGeometry as _, FaceSurface, Sewing, ShellFace};

/// The inner weights along a side of a face of a sphere are at least this part of the smaller end weight.
const SMALLEST_WEIGHT: f64 = 0.25;
/// An edge is cut lengthwise into so many faces at most: halving makes the weights positive long before.
const MOST_PIECES: usize = 64;

impl ConvexPolyhedron {
    /// The body of all points within a distance of the polyhedron: one closed shell, outside outwards, G1 everywhere, of planes,
    /// cylinders and parts of spheres.
    ///
    /// # Errors
    /// `radius-not-positive`, `parameter-out-of-range` (the radius), `below-rounding-of-place` (the radius at these coordinates, or
    /// the polyhedron on that radius), `too-many-pieces` (an edge whose faces nearly coincide); as [`CyclidePatch::from_weights`]
    /// and [`Shell::new`](crate::topology::Shell::new) where edges are so short that their directions are rounding.
    pub fn offset(&self, radius: f64) -> Result<Body> {
        self.check_radius(radius)?;
        let mut rounding = Rounding::new(self, radius);
        let strips = rounding.strips()?;
        let cylinders = rounding.sewing.faces.len();
        rounding.sides(&strips)?;
        rounding.planes_first(cylinders);
        rounding.vertices(&strips)?;
        Ok(Body { outer: rounding.sewing.finish()?, voids: Vec::new() })
    }

    /// The polyhedron itself: one closed shell of planes, outside outwards.
    ///
    /// ```
    /// use cyclide::{Point3, construct::ConvexPolyhedron};
    /// let corners = (0..8).map(|k| Point3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)));
    /// let cube = ConvexPolyhedron::hull(&corners.collect::<Vec<_>>())?.body()?;
    /// assert!(cube.is_solid() && cube.outer.faces().len() == 6 && cube.outer.edges().len() == 12);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `below-rounding-of-place`; as [`Shell::new`](crate::topology::Shell::new) where edges are so short that their directions are rounding.
    pub fn body(&self) -> Result<Body> {
        self.check_size(0.0)?;
        let mut sewing = Sewing::default();
        let mut numbers = vec![None; self.vertices().len()];
        let mut rails: Vec<Vec<Option<FaceEdge>>> = self.faces().iter().map(|face| vec![None; face.len()]).collect();
        for at in self.faces.edges() {
            let [start, end] = self.faces.ends(at).map(|v| match numbers[v] {
                Some(number) => number,
                None => *numbers[v].insert(sewing.vertex(self.vertices[v])),
            });
            let edge = sewing.segment(start, end)?;
            let beyond = self.faces.across(at);
            rails[at.face][at.side] = Some(FaceEdge { edge, forward: true });
            rails[beyond.face][beyond.side] = Some(FaceEdge { edge, forward: false });
        }
        for (face, rails) in self.faces().iter().zip(rails) {
            let corners: Vec<usize> = face.iter().filter_map(|&v| numbers[v]).collect();
            let rails: Vec<FaceEdge> = rails.into_iter().flatten().collect();
            plane(&mut sewing, &corners, &rails)?;
        }
        largest_first(&mut sewing.faces);
        Ok(Body { outer: sewing.finish()?, voids: Vec::new() })
    }

    fn check_radius(&self, radius: f64) -> Result<()> {
        if !(radius > 0.0) {
            return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius }.into());
        }
        if !(radius <= range::MAX_COORDINATE) {
            let (min, max) = (0.0, range::MAX_COORDINATE);
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Radius, value: radius, min, max }.into());
        }
        let (_, place) = self.size_and_place();
        range::check_size_in_place(ErrorItem::Radius, radius, place, range::SMALLEST_IN_PLACE)?;
        self.check_size(radius)
    }

    fn check_size(&self, radius: f64) -> Result<()> {
        let (size, place) = self.size_and_place();
        range::check_size_in_place(ErrorItem::Polyhedron, size, place + radius, range::SMALLEST_IN_PLACE)
    }

    /// The diagonal of its box, and its largest coordinate.
    fn size_and_place(&self) -> (f64, f64) {
        let corners = self.faces().iter().flatten().map(|&v| self.vertices()[v]);
        Aabb::of_points(corners).map_or((0.0, 0.0), |b| (b.diagonal(), b.max_abs()))
    }
}

/// The cylinder along an edge, in one face or several beside each other.
struct Strip {
    /// The normals between the faces: of the first one, those of the cuts, of the second one.
    normals: Vec<Vec3>,
    /// The vertices of each of these at the start and at the end of the edge.
    corners: Vec<[usize; 2]>,
    /// The straight edge of each.
    rails: Vec<usize>,
    /// The arcs between neighbors at the start and at the end.
    arcs: Vec<[usize; 2]>,
}

/// The rounded polyhedron in the making.
struct Rounding<'a> {
    polyhedron: &'a ConvexPolyhedron,
    radius: f64,
    /// The strip along each side of each face, and whether the side runs as the strip does, which is so in the first face.
    strip_of: Vec<Vec<(usize, bool)>>,
    sewing: Sewing,
}

impl<'a> Rounding<'a> {
    /// With the corners of the moved faces as the first vertices, face by face.
    fn new(polyhedron: &'a ConvexPolyhedron, radius: f64) -> Self {
        let loops = polyhedron.faces();
        let moved = |(corners, normal): (&Vec<usize>, &Vec3)| {
            let way = *normal * radius;
            corners.iter().map(move |&v| polyhedron.vertices[v] + way).collect::<Vec<_>>()
        };
        let vertices = loops.iter().zip(&polyhedron.normals).flat_map(moved).collect();
        let strip_of = loops.iter().map(|corners| vec![(0, true); corners.len()]).collect();
        Self { polyhedron, radius, strip_of, sewing: Sewing { vertices, ..Sewing::default() } }
    }

    /// The cylinders along all edges.
    fn strips(&mut self) -> Result<Vec<Strip>> {
        let polyhedron = self.polyhedron;
        let mut first_corner = Vec::with_capacity(polyhedron.faces().len());
        let mut next = 0;
        for corners in polyhedron.faces() {
            first_corner.push(next);
            next += corners.len();
        }
        let corner =
            |at: FaceSide, ahead: usize| first_corner[at.face] + (at.side + ahead) % polyhedron.faces()[at.face].len();
        let mut strips = Vec::new();
        for at in polyhedron.faces.edges() {
            let beyond = polyhedron.faces.across(at);
            let ends = [[corner(at, 0), corner(at, 1)], [corner(beyond, 1), corner(beyond, 0)]];
            self.strip_of[at.face][at.side] = (strips.len(), true);
            self.strip_of[beyond.face][beyond.side] = (strips.len(), false);
            strips.push(self.strip(at, beyond, ends)?);
        }
        Ok(strips)
    }

    /// The cylinder along one edge, between the corners of its two faces.
    fn strip(&mut self, at: FaceSide, beyond: FaceSide, [first, last]: [[usize; 2]; 2]) -> Result<Strip> {
        let polyhedron = self.polyhedron;
        let ends = polyhedron.faces.ends(at);
        let points = ends.map(|v| polyhedron.vertices[v]);
        let pair = [at.face, beyond.face].map(|face| polyhedron.normals[face]);
        let axis = edge_axis(pair, points[1] - points[0]);
        let apexes = ends.map(|v| polyhedron.cones[v].as_ref().map_or(axis, super::SphericalPolygon::apex));
        let normals = cut(pair, axis, apexes)?;
        let mut corners = vec![first];
        for normal in &normals[1..normals.len() - 1] {
            let k = self.sewing.vertices.len();
            self.sewing.vertices.extend(points.map(|p| p + *normal * self.radius));
            corners.push([k, k + 1]);
        }
        corners.push(last);
        let rails = corners.iter().map(|&[from, to]| self.sewing.segment(from, to)).collect::<Result<Vec<_>>>()?;
        let mut arcs = Vec::with_capacity(normals.len() - 1);
        for k in 1..normals.len() {
            let [n, m] = [normals[k - 1], normals[k]];
            let cosine = 0.5 * (n + m).length();
            let ratio = Quat::from_parts(cosine, axis * (0.5 * n.cross(m).length() / cosine));
            let [low, high] = [corners[k - 1], corners[k]];
            let ends = [self.sewing.arc(low[0], high[0], ratio)?, self.sewing.arc(low[1], high[1], ratio)?];
            let points = [low[0], high[0], low[1], high[1]].map(|v| self.sewing.vertices[v]);
            let weights = [Quat::ONE, ratio, Quat::ONE, ratio];
            let patch = CyclidePatch::from_weights(points, weights, axis.cross(n), axis)?;
            self.sewing.face(patch, [ends[0], ends[1], rails[k - 1], rails[k]].map(Some), true);
            arcs.push(ends);
        }
        Ok(Strip { normals, corners, rails, arcs })
    }

    /// The moved faces in quads.
    fn sides(&mut self, strips: &[Strip]) -> Result<()> {
        let mut first = 0;
        for face in 0..self.polyhedron.faces().len() {
            let n = self.polyhedron.faces()[face].len();
            let rail = |side: usize| {
                let (strip, forward) = self.strip_of[face][side];
                let rails = &strips[strip].rails;
                FaceEdge { edge: rails[if forward { 0 } else { rails.len() - 1 }], forward }
            };
            let rails: Vec<FaceEdge> = (0..n).map(rail).collect();
            let corners: Vec<usize> = (first..first + n).collect();
            plane(&mut self.sewing, &corners, &rails)?;
            first += n;
        }
        Ok(())
    }

    /// Puts the planes before the cylinders.
    fn planes_first(&mut self, cylinders: usize) {
        let faces = &mut self.sewing.faces;
        faces.rotate_left(cylinders);
        let planes = faces.len() - cylinders;
        largest_first(&mut faces[..planes]);
    }

    /// The parts of spheres round all vertices.
    fn vertices(&mut self, strips: &[Strip]) -> Result<()> {
        let polyhedron = self.polyhedron;
        for (vertex, fan) in polyhedron.fans.iter().enumerate() {
            let Some(cone) = &polyhedron.cones[vertex] else { continue };
            let (center, apex) = (polyhedron.vertices[vertex], cone.apex());
            let top = self.sewing.vertex(center + apex * self.radius);
            let around: Vec<Part> = fan.iter().flat_map(|&at| self.parts(strips, at)).collect();
            let mut spokes = Vec::with_capacity(around.len());
            for part in &around {
                let n = part.normals[0];
                let ratio = Quat::from_parts(1.0 + n.dot(apex), apex.cross(n));
                spokes.push(self.sewing.arc(top, part.corners[0], ratio)?);
            }
            for (k, part) in around.iter().enumerate() {
                let rows = placed(&sector(apex, part.normals), center, self.radius);
                let corners = [top, part.corners[0], top, part.corners[1]].map(|v| self.sewing.vertices[v]);
                let surface = RationalBezierSurface::new([2, 4], rows)?.with_corners(corners);
                let spoke = |k: usize| Some(FaceEdge { edge: spokes[k % spokes.len()], forward: true });
                let sides = [spoke(k), spoke(k + 1), None, Some(part.arc)];
                self.sewing.face_along(surface, sides, true);
            }
        }
        Ok(())
    }

    /// The arcs round a vertex from a face to the next one, over the edge that ends where this side starts.
    fn parts(&self, strips: &[Strip], at: FaceSide) -> Vec<Part> {
        let (strip, forward) = self.strip_of[at.face][self.polyhedron.faces.before(at).side];
        let strip = &strips[strip];
        let end = usize::from(forward);
        let part = |k: usize| {
            let k = if forward { k } else { strip.arcs.len() - 1 - k };
            let (from, to) = if forward { (k, k + 1) } else { (k + 1, k) };
            Part {
                normals: [strip.normals[from], strip.normals[to]],
                corners: [strip.corners[from][end], strip.corners[to][end]],
                arc: FaceEdge { edge: strip.arcs[k][end], forward },
            }
        };
        (0..strip.arcs.len()).map(part).collect()
    }
}

/// The faces of a plane polygon in quads, and a triangle where its corners are odd in number; `rails` are its sides, from corner to corner.
fn plane(sewing: &mut Sewing, corners: &[usize], rails: &[FaceEdge]) -> Result<()> {
    let n = corners.len();
    let turned = |edge: FaceEdge| FaceEdge { forward: !edge.forward, ..edge };
    // From the last side to the one opposite: quads between the sides i and n - 2 - i.
    let (mut i, mut left) = (0, turned(rails[n - 1]));
    loop {
        let j = n - 1 - i;
        let [a, b, c, d] = [i, i + 1, j, j - 1].map(|k| corners[k]);
        let points = [a, b, c, d].map(|v| sewing.vertices[v]);
        let right = match j - 1 - (i + 1) {
            0 => None,
            1 => Some(rails[i + 1]),
            _ => Some(FaceEdge { edge: sewing.segment(b, d)?, forward: true }),
        };
        let sides = [Some(rails[i]), Some(turned(rails[j - 1])), Some(left), right];
        sewing.face_along(bilinear(points)?, sides, true);
        match right {
            Some(right) if j - 1 > i + 2 => left = right,
            _ => return Ok(()),
        }
        i += 1;
    }
}

/// Puts the largest of plane faces first: readers tell inside from outside on the first face, and on a thin one they are wrong.
fn largest_first(planes: &mut [ShellFace]) {
    let area = |face: &ShellFace| {
        let surface = face.surface.to_rational();
        let [a, b, c, d] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|[s, t]| surface.point(s, t));
        (d - a).cross(c - b).length()
    };
    let areas: Vec<f64> = planes.iter().map(area).collect();
    if let Some(largest) = (0..planes.len()).max_by(|&i, &j| areas[i].total_cmp(&areas[j])) {
        planes.swap(0, largest);
    }
}

/// A side of the polygon round a vertex, or a part of one.
struct Part {
    normals: [Vec3; 2],
    corners: [usize; 2],
    arc: FaceEdge,
}

/// The normals between two faces at which the cylinder of their edge is cut, halved until all faces that end on it have positive
/// weights.
fn cut([n, m]: [Vec3; 2], axis: Vec3, apexes: [Vec3; 2]) -> Result<Vec<Vec3>> {
    let angle = n.cross(m).length().atan2(n.dot(m));
    let quarter = axis.cross(n);
    let mut pieces = 1;
    loop {
        let inner = |k: usize| {
            let (sin, cos) = (angle * k as f64 / pieces as f64).sin_cos();
            n * cos + quarter * sin
        };
        let mut normals = vec![n];
        normals.extend((1..pieces).map(inner));
        normals.push(m);
        let is_good = |pair: &[Vec3]| apexes.iter().all(|&apex| has_good_weights(apex, [pair[0], pair[1]]));
        if angle <= LARGEST_ARC * pieces as f64 && normals.windows(2).all(is_good) {
            return Ok(normals);
        }
        if pieces == MOST_PIECES {
            return Err(NumberError::TooManyPieces {
                what: "the rounding of an edge",
                segment: None,
                needed: f64::INFINITY,
                cap: MOST_PIECES,
                remedy: "its faces nearly coincide, with opposite orientation",
            }
            .into());
        }
        pieces *= 2;
    }
}

/// True if no weight of the face between an apex and an arc is far below those at its ends.
fn has_good_weights(apex: Vec3, normals: [Vec3; 2]) -> bool {
    let rows = sector(apex, normals);
    [0, 5].iter().all(|&row| {
        let weight = |k: usize| rows[row + k][3];
        let least = SMALLEST_WEIGHT * weight(0).min(weight(4));
        least > 0.0 && (1..4).all(|k| weight(k) >= least)
    })
}

/// The plane quad of four points, of which the last two may be one.
fn bilinear([a, b, c, d]: [Point3; 4]) -> Result<FaceSurface> {
    let row = |p: Point3| [p.x, p.y, p.z, 1.0];
    Ok(RationalBezierSurface::new([1, 1], vec![row(a), row(c), row(b), row(d)])?.into())
}
