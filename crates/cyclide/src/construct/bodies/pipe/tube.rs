//! The shell of a tube: its faces along the spine, and those that close its ends.

use super::PipeEnds;
use super::frame::{Piece, Spine, Station};
use super::ring::{Ring, quarter};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::rotated_rows::rotated_rows;
use crate::error::Result;
use crate::rational::RationalBezierSurface;
use crate::surface::CyclidePatch;
use crate::topology::{EdgeCurve, FaceSurface, Sewing, Shell};
use std::f64::consts::FRAC_1_SQRT_2;

/// A tube on its way to a shell, outside away from the spine.
pub(super) struct Tube<'a> {
    spine: &'a Spine,
    radius: f64,
    sewing: Sewing,
    /// Of each station: the first of its four vertices, and the first of its quarters, which follow each other.
    rings: Vec<[usize; 2]>,
}

/// One of both ends of an open tube.
struct End {
    station: usize,
    /// The direction out of it.
    out: Vec3,
    is_last: bool,
}

impl<'a> Tube<'a> {
    /// The faces along the spine.
    pub(super) fn new(spine: &'a Spine, radius: f64) -> Result<Self> {
        let mut tube = Self { spine, radius, sewing: Sewing::default(), rings: Vec::new() };
        let rings: Vec<Ring> =
            spine.stations.iter().map(|station| Ring::new(station, radius)).collect::<Result<_>>()?;
        for ring in &rings {
            let first = tube.sewing.vertices.len();
            tube.sewing.vertices.extend(ring.corners);
            tube.rings.push([first, tube.sewing.edges.len()]);
            for (k, curve) in ring.quarters.iter().enumerate() {
                tube.sewing.edge(first + k, first + (k + 1) % 4, curve.clone());
            }
        }
        for piece in 0..spine.pieces.len() {
            tube.add_piece(piece, &rings)?;
        }
        Ok(tube)
    }

    /// The four faces over a piece and the four lines between them.
    fn add_piece(&mut self, index: usize, rings: &[Ring]) -> Result<()> {
        let spine = self.spine;
        let (piece, (next, renumbered)) = (&spine.pieces[index], spine.behind(index));
        let station = &spine.stations[index];
        let [from, to] = [&rings[index], &rings[next]];
        let at = |k: usize| (k + renumbered) % 4;
        let twist = spine.twist.filter(|twist| twist.piece == index && twist.angle != 0.0).map(|twist| twist.angle);
        let surfaces: Vec<FaceSurface> = (0..4)
            .map(|k| {
                let sections = [&from.quarters[k], &to.quarters[at(k)]];
                let corners = [from.corners[k], from.corners[(k + 1) % 4], to.corners[at(k)], to.corners[at(k + 1)]];
                match twist {
                    Some(angle) => twisted(piece, station, sections, angle, corners),
                    None if station.mitred || spine.stations[next].mitred => ruled(sections, corners),
                    None => {
                        let (u, w) = (quarter(station), piece.rotor);
                        let along = piece.along.cross(station.directions()[k]);
                        let weights = [Quat::ONE, u, w, w * u];
                        CyclidePatch::from_weights(corners, weights, along, piece.along).map(FaceSurface::from)
                    }
                }
            })
            .collect::<Result<_>>()?;
        let first_line = self.sewing.edges.len();
        for (k, surface) in surfaces.iter().enumerate() {
            let (start, end) = (self.rings[index][0] + k, self.rings[next][0] + at(k));
            match surface {
                FaceSurface::Cyclide(_) => self.sewing.arc(start, end, piece.rotor)?,
                FaceSurface::Rational(surface) => {
                    let [p, q] = [start, end].map(|vertex| self.sewing.vertices[vertex]);
                    self.sewing.edge(start, end, surface.t_line(0.0).with_ends(Some(p), Some(q)))
                }
            };
        }
        for (k, surface) in surfaces.into_iter().enumerate() {
            let quarters = [self.rings[index][1] + k, self.rings[next][1] + at(k)];
            let lines = [first_line + k, first_line + (k + 1) % 4];
            let edges = [quarters[0], quarters[1], lines[0], lines[1]];
            self.sewing.face(surface, edges.map(Some), true);
        }
        Ok(())
    }

    fn ends(&self) -> Vec<End> {
        if self.spine.closed {
            return Vec::new();
        }
        let last = self.spine.stations.len() - 1;
        let end = |station: usize, is_last: bool| {
            let way = self.spine.stations[station].ways[1];
            End { station, out: if is_last { way } else { -way }, is_last }
        };
        vec![end(0, false), end(last, true)]
    }

    /// The shell with its ends closed by themselves.
    pub(super) fn closed(mut self, ends: PipeEnds) -> Result<Shell> {
        for end in self.ends() {
            match ends {
                PipeEnds::Open => {}
                PipeEnds::Flat => self.add_disk(&end)?,
                PipeEnds::Round => self.add_cap(&end)?,
            }
        }
        self.sewing.finish()
    }

    /// A disk of four sectors.
    fn add_disk(&mut self, end: &End) -> Result<()> {
        let center = self.sewing.vertex(self.spine.stations[end.station].point);
        self.add_plane_end(end, [center; 4], None)
    }

    /// Both shells as one, rings between their ends.
    pub(super) fn with_bore(mut self, bore: Self) -> Result<Shell> {
        let (vertices, edges) = (self.sewing.vertices.len(), self.sewing.edges.len());
        self.sewing.vertices.extend(bore.sewing.vertices);
        for edge in bore.sewing.edges {
            self.sewing.edge(edge.start + vertices, edge.end + vertices, edge.curve);
        }
        for mut face in bore.sewing.faces {
            face.sides.iter_mut().flatten().for_each(|side| side.edge += edges);
            self.sewing.face_along(face.surface, face.sides, false);
        }
        for end in self.ends() {
            let [vertex, quarter] = bore.rings[end.station];
            self.add_plane_end(&end, [0, 1, 2, 3].map(|k| vertices + vertex + k), Some(edges + quarter))?;
        }
        self.sewing.finish()
    }

    /// Four plane faces between vertices inside, with their first quarter, and the ring of an end.
    fn add_plane_end(&mut self, end: &End, inside: [usize; 4], inner: Option<usize>) -> Result<()> {
        let station = &self.spine.stations[end.station];
        let [vertex, quarters] = self.rings[end.station];
        let (ways, u) = (station.directions(), quarter(station));
        let radial = self.sewing.edges.len();
        for (k, &start) in inside.iter().enumerate() {
            self.sewing.segment(start, vertex + k)?;
        }
        for k in 0..4 {
            let next = (k + 1) % 4;
            let corners = [inside[k], vertex + k, inside[next], vertex + next].map(|v| self.sewing.vertices[v]);
            let weights = [Quat::ONE, Quat::ONE, u, u];
            let patch = CyclidePatch::from_weights(corners, weights, ways[k], ways[next])?;
            let edges = [Some(radial + k), Some(radial + next), inner.map(|first| first + k), Some(quarters + k)];
            self.sewing.face(patch, edges, end.is_last);
        }
        Ok(())
    }

    /// A hemisphere of four faces that meet in its pole.
    fn add_cap(&mut self, end: &End) -> Result<()> {
        let station = &self.spine.stations[end.station];
        let [vertex, quarters] = self.rings[end.station];
        let (ways, u) = (station.directions(), quarter(station));
        let pole = self.sewing.vertex(station.point + end.out * self.radius);
        let ratio = |k: usize| Quat::from_parts(FRAC_1_SQRT_2, ways[k].cross(end.out) * FRAC_1_SQRT_2);
        let meridian = self.sewing.edges.len();
        for k in 0..4 {
            self.sewing.arc(vertex + k, pole, ratio(k))?;
        }
        for k in 0..4 {
            let next = (k + 1) % 4;
            let corners = [vertex + k, pole, vertex + next, pole].map(|v| self.sewing.vertices[v]);
            let weights = [Quat::ONE, ratio(k), u, u * ratio(k)];
            let patch = CyclidePatch::from_weights(corners, weights, end.out, ways[next])?;
            let edges = [Some(meridian + k), Some(meridian + next), Some(quarters + k), None];
            self.sewing.face(patch, edges, !end.is_last);
        }
        Ok(())
    }
}

/// The part of a cylinder between two sections, ruled by its lines: of degree (2, 1).
fn ruled(sections: [&EdgeCurve; 2], corners: [Point3; 4]) -> Result<FaceSurface> {
    let rows = sections[0].bezier_rows().into_iter().zip(sections[1].bezier_rows()).flat_map(|(a, b)| [a, b]).collect();
    Ok(RationalBezierSurface::new([2, 1], rows)?.with_corners(corners).into())
}

/// The part of the tube over a piece whose section turns about the spine on the way.
fn twisted(
    piece: &Piece,
    station: &Station,
    sections: [&EdgeCurve; 2],
    angle: f64,
    corners: [Point3; 4],
) -> Result<FaceSurface> {
    let spin = Quat::from_axis_angle(piece.along, angle);
    let (first, last) = (sections[0].bezier_rows(), sections[1].bezier_rows());
    let from = station.point.to_vec();
    let off = |row: &[f64; 4]| Vec3::new(row[0], row[1], row[2]) - from * row[3];
    let row = |v: Vec3, w: f64| [v.x, v.y, v.z, w];
    let mut rows = Vec::new();
    if piece.arc.is_straight() {
        for (a, b) in first.iter().zip(&last) {
            // Across the spine it turns, along it the way is linear in the control points: of degree (2, 2).
            let (height, weight) = (0.5 * (off(a) + off(b)).dot(piece.along), spin.w * a[3]);
            let across = off(a) - piece.along * off(a).dot(piece.along);
            let [_, half, _] = rotated_rows(spin, across);
            rows.extend([*a, row(from * weight + half + piece.along * (height * spin.w), weight), *b]);
        }
        return Ok(RationalBezierSurface::new([2, 2], rows)?.with_corners(corners).into());
    }
    // Twice a rotation: the product of two quadratics in t.
    let spine = piece.arc.bezier_rows();
    for a in &first {
        let mut product = [[0.0; 4]; 5];
        for (i, (y, weight)) in rotated_rows(spin, off(a)).into_iter().zip([1.0, spin.w, 1.0]).enumerate() {
            for (j, (v, center)) in rotated_rows(piece.rotor, y).into_iter().zip(spine).enumerate() {
                let share = [1.0, 2.0, 1.0][i] * [1.0, 2.0, 1.0][j] / [1.0, 4.0, 6.0, 4.0, 1.0][i + j];
                let g = weight * a[3];
                let at = Vec3::new(center[0], center[1], center[2]) * g + v;
                for (sum, value) in product[i + j].iter_mut().zip(row(at, g * center[3])) {
                    *sum += share * value;
                }
            }
        }
        rows.extend(product);
    }
    Ok(RationalBezierSurface::new([2, 4], rows)?.with_corners(corners).into())
}
