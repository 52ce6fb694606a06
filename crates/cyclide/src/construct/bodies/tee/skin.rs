//! The skin of a tee, outside or in the bore: the parts of both cylinders that the blend leaves, and the blend.
//!
//! The pipe has two rows of faces. One end of each is a circle, the other one goes along half of the contact and on round the back of the pipe in the plane of the
//! branch; sides lean out from the places where the contact has its smallest and largest angle, so that no face has a corner without an angle.

use super::PipeTee;
use super::cylinder_face::{CylinderCurve, Placed};
use crate::base::vector::Point3;
use crate::construct::bodies::bands::{Bands, Ring};
use crate::curve::Arc;
use crate::error::{Error, ErrorItem, Result};
use crate::rational::RationalBezierSurface;
use crate::topology::EdgeCurve;
use std::f64::consts::{PI, TAU};

/// Faces round the back of the pipe.
const BACK: usize = 3;

/// The angle by which sides lean out on the pipe, radians, at most, and as part of the angle behind.
const LEAN: [f64; 2] = [0.7, 0.25];

/// A tee where it stands along the pipe, with the height of the end of its branch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stand<'a> {
    pub(super) tee: &'a PipeTee,
    pub(super) position: f64,
    pub(super) height: f64,
}

/// A skin: the tee with other radii, the balls larger by what the cylinders are thinner.
pub(super) struct Skin<'a> {
    tee: &'a PipeTee,
    position: f64,
    height: f64,
    /// What the radii of the cylinders are less, and those of the balls more.
    thinner: f64,
    /// Coordinates of the ends along the pipe from the branch, negative first.
    ends: [f64; 2],
    /// Where the arcs of the ends beside the contact begin and end.
    fan: [f64; 2],
}

/// The three rings at which a skin ends: at both ends of the pipe, and of the branch.
pub(super) struct Ends {
    pub(super) pipe: [Ring; 2],
    pub(super) branch: Ring,
}

/// The angles about the pipe between which the contacts of all tees lie and lean out.
pub(super) fn fan(stands: &[Stand]) -> [f64; 2] {
    let [low, high] = stands.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], stand| {
        let [from, to] = stand.tee.contact_angles();
        [low.min(from), high.max(to)]
    });
    let lean = LEAN[0].min(LEAN[1] * (TAU - (high - low)));
    [low - lean, high + lean]
}

impl PipeTee {
    /// The angles about the pipe of the contact in the plane of both axes, before and behind.
    fn contact_angles(&self) -> [f64; 2] {
        [0, self.halves[0]].map(|i| {
            let half = &self.pieces[i % self.pieces.len()].half_angles[0];
            let [c, s] = half.each_ref().map(|entry| entry.value(0.0));
            (2.0 * s.atan2(c)).rem_euclid(TAU)
        })
    }
}

impl<'a> Skin<'a> {
    pub(super) fn new(stand: &Stand<'a>, thinner: f64, ends: [f64; 2], fan: [f64; 2]) -> Self {
        let Stand { tee, position, height } = *stand;
        Self { tee, position, height, thinner, ends: ends.map(|x| x - position), fan }
    }

    /// Adds the faces, outside outwards, or `inside` the hollow, from the ring `before` at the left end if there is one.
    pub(super) fn sew(&self, bands: &mut Bands, inside: bool, before: Option<Ring>) -> Result<Ends> {
        let (pipe, branch) = self.cylinders();
        let contacts = self.contacts();
        let curves = |side: usize, on: &Placed| -> Result<Vec<EdgeCurve>> {
            contacts.iter().map(|contact| Ok(contact[side].curve(on)?.into())).collect()
        };
        let on_pipe = bands.ring(curves(0, &pipe)?, true);
        let on_branch = bands.ring(curves(1, &branch)?, true);
        self.blend(bands, [&on_branch, &on_pipe], inside)?;
        let ends = self.pipe(bands, &pipe, &on_pipe, &contacts, (inside, before))?;
        let top: Vec<CylinderCurve> = self.branch_arcs();
        let arcs = top.iter().map(|arc| arc_of(arc, &branch)).collect::<Result<_>>()?;
        let top_ring = bands.ring(arcs, true);
        let segment = |_, [from, to]: [Point3; 2]| Ok(Arc::segment(from, to)?.into());
        let surface = |order: [usize; 2]| {
            let contacts = &contacts;
            let top = &top;
            move |_: &Bands, i: usize| {
                let pair = [&top[i], &contacts[i][1]];
                branch.ruled_face([pair[order[0]], pair[order[1]]])
            }
        };
        if inside {
            bands.band([&on_branch, &top_ring], segment, surface([1, 0]))?;
        } else {
            bands.band([&top_ring, &on_branch], segment, surface([0, 1]))?;
        }
        Ok(Ends { pipe: ends, branch: top_ring })
    }

    /// The canal patches.
    fn blend(&self, bands: &mut Bands, [on_branch, on_pipe]: [&Ring; 2], inside: bool) -> Result<()> {
        let patches: Vec<_> = self.tee.pieces.iter().map(|piece| piece.patch.offset(self.thinner)).collect();
        let across = |i: usize, [from, to]: [Point3; 2]| -> Result<EdgeCurve> {
            let middle = self.placed(patches[i].point(0.0, 0.5));
            Ok(Arc::from_three_points(from, middle, to)?.evened().into())
        };
        let surface = |i: usize| -> Result<RationalBezierSurface> {
            let surface = self.placed_surface(&patches[i].to_rational()?)?;
            if surface.has_positive_weights() {
                return Ok(if inside { surface } else { backwards(&surface) });
            }
            let weight = surface.rows().iter().map(|row| row[3]).fold(f64::INFINITY, f64::min);
            Err(Error::WeightNotPositive { index: i, weight })
        };
        let rings = if inside { [on_pipe, on_branch] } else { [on_branch, on_pipe] };
        bands.band(rings, across, |_, i| surface(i))
    }

    /// Both rows of faces of the pipe.
    fn pipe(
        &self,
        bands: &mut Bands,
        on: &Placed,
        on_pipe: &Ring,
        contacts: &[[CylinderCurve; 2]],
        (inside, mut before): (bool, Option<Ring>),
    ) -> Result<[Ring; 2]> {
        let (n, half) = (contacts.len(), self.tee.halves[0]);
        let [low, high] = self.tee.contact_angles();
        let behind = TAU - (high - low);
        // Round the back in the plane of the branch.
        let step = behind / BACK as f64;
        let back: Vec<CylinderCurve> =
            (0..BACK).map(|k| CylinderCurve::arc([0, 1].map(|j| high + step * (k + j) as f64), 0.0)).collect();
        let back_curves = back.iter().map(|arc| arc_of(arc, on)).collect::<Result<_>>()?;
        let right = on_pipe.part(0, half);
        let back_ring = bands.way_back(&right, back_curves);
        let left = on_pipe.part(half, n).reversed();
        let mut rings = Vec::with_capacity(2);
        for side in 0..2 {
            let part = if side == 1 { &right } else { &left };
            let mut near: Vec<CylinderCurve> = if side == 1 {
                contacts[..half].iter().map(|contact| contact[0].clone()).collect()
            } else {
                contacts[half..].iter().rev().map(|contact| contact[0].reversed()).collect()
            };
            let fan = self.fan_arcs(side);
            near.extend(back.iter().cloned());
            let ring = part.closed_by(&back_ring);
            let end = match before.take() {
                Some(ring) if side == 0 => ring,
                _ => bands.ring(fan.iter().map(|arc| arc_of(arc, on)).collect::<Result<_>>()?, true),
            };
            let reach = near.iter().map(|curve| curve.end(0.0).1.abs()).fold(0.0, f64::max);
            let bias = (1.5 * reach / self.ends[side].abs()).clamp(0.15, 0.5);
            let ends_of = |i: usize| [near[i].end(0.0), fan[i].end(0.0)];
            // Seen from outside, rows run round the pipe and then along it: from the left end to the right one.
            let inner_first = (side == 1) != inside;
            let across = |i: usize, _: [Point3; 2]| -> Result<EdgeCurve> {
                let curve = on.side(ends_of(i), bias)?;
                Ok(if inner_first { curve } else { curve.reversed() }.into())
            };
            let surface = |_: &Bands, i: usize| {
                let face = on.face([&near[i], &fan[i]], bias)?;
                Ok(if inner_first { face } else { backwards(&face) })
            };
            bands.band(if inner_first { [&ring, &end] } else { [&end, &ring] }, across, surface)?;
            rings.push(end);
        }
        match <[Ring; 2]>::try_from(rings) {
            Ok(rings) => Ok(rings),
            Err(_) => Err(Error::NotAShell { item: ErrorItem::Face, index: 0, detail: "a pipe has two ends" }),
        }
    }

    /// The arcs of the circle at an end of the pipe: `beside` the contact between two angles, spread as the angles about the branch are, then round the
    /// back.
    fn fan_arcs(&self, side: usize) -> Vec<CylinderCurve> {
        let ([low, high], behind) = (self.fan, [self.fan[1], self.fan[0] + TAU]);
        let (angles, n) = (&self.tee.angles, self.tee.angles.len());
        let half = self.tee.halves[0];
        // From the plane of both axes on the far side of the branch, 0 to pi.
        let turns: Vec<f64> = if side == 1 {
            angles[..half].iter().copied().chain([PI]).collect()
        } else {
            [0.0].into_iter().chain(angles[half..n].iter().rev().map(|angle| TAU - angle)).collect()
        };
        let place = |turn: f64| low + (high - low) * (turn / PI);
        let beside = turns.windows(2).map(|pair| CylinderCurve::arc([place(pair[0]), place(pair[1])], self.ends[side]));
        let step = (behind[1] - behind[0]) / BACK as f64;
        let back =
            (0..BACK).map(|k| CylinderCurve::arc([0, 1].map(|j| behind[0] + step * (k + j) as f64), self.ends[side]));
        beside.chain(back).collect()
    }

    /// The arcs of the circle at the end of the branch.
    fn branch_arcs(&self) -> Vec<CylinderCurve> {
        let (n, angles) = (self.tee.angles.len(), &self.tee.angles);
        let end = |i: usize| if i == n { TAU } else { angles[i] };
        (0..n).map(|i| CylinderCurve::arc([end(i), end(i + 1)], self.height)).collect()
    }

    /// The contacts of each piece on the pipe and on the branch.
    fn contacts(&self) -> Vec<[CylinderCurve; 2]> {
        let contact = |piece: &crate::surface::CrossingPiece| {
            [0, 1].map(|i| CylinderCurve::new(&piece.half_angles[i], &piece.along[i], &piece.weight))
        };
        self.tee.pieces.iter().map(contact).collect()
    }

    /// The pipe and the branch.
    fn cylinders(&self) -> (Placed, Placed) {
        let [r1, r2] = self.tee.pair.radii().map(|r| r - self.thinner);
        let offset = -2.0 * self.tee.pair.half_gap();
        // Angles of the pair are counted from its z, here -y, towards its y, here z, or its x.
        let (x, back, z) = ([1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]);
        (
            Placed { columns: [back, z, x], origin: [self.position, 0.0, 0.0], radius: r1 },
            Placed { columns: [back, x, z], origin: [self.position, offset, 0.0], radius: r2 },
        )
    }

    /// From the axes of the pair to those of the tee: y is up, z is -y, and the axis of the pipe is that of x.
    fn placed(&self, p: Point3) -> Point3 {
        Point3::new(p.x + self.position, -(p.z + self.tee.pair.half_gap()), p.y)
    }

    /// The same of homogeneous rows.
    fn placed_surface(&self, surface: &RationalBezierSurface) -> Result<RationalBezierSurface> {
        let (p, h) = (self.position, self.tee.pair.half_gap());
        let rows = surface.rows().iter().map(|&[x, y, z, w]| [x + p * w, -(z + h * w), y, w]).collect();
        RationalBezierSurface::new(surface.degrees(), rows)
    }
}

/// An arc on a cylinder as such.
fn arc_of(arc: &CylinderCurve, on: &Placed) -> Result<EdgeCurve> {
    let curve = arc.curve(on)?;
    Ok(Arc::from_three_points(curve.point(0.0), curve.point(0.5), curve.point(1.0))?.evened().into())
}

/// The same surface with t run backwards.
fn backwards(surface: &RationalBezierSurface) -> RationalBezierSurface {
    let q = surface.degrees()[1];
    let rows = surface.rows().chunks(q + 1).flat_map(|row| row.iter().rev().copied()).collect();
    RationalBezierSurface::from_rows_unchecked(surface.degrees(), rows)
}
