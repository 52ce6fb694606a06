//! The faces of a skin of a blend: tube, blend strip, and what is left of the sphere or the plane.

use super::ball_loop::{BallLoop, part};
use super::piece::Piece;
use super::setup::Setup;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::bands::{Bands, Ring};
use crate::construct::bodies::ellipse_ring::{Ellipse, Sector};
use crate::construct::bodies::rails::evened;
use crate::curve::Arc;
use crate::error::Result;
use crate::rational::RationalBezierSurface;
use crate::surface::CanalPatch;
use crate::topology::EdgeCurve;

/// Rings of a skin at a depth, from the end of the tube to the base.
pub(super) struct SkinRings {
    pub(super) end: Ring,
    on_tube: Ring,
    pub(super) on_base: Ring,
}

/// A skin at a depth below the outer one.
pub(super) struct Skin<'a> {
    pub(super) setup: &'a Setup,
    pub(super) balls: &'a BallLoop,
    pub(super) depth: f64,
    /// Whether its faces are counted from the base to the end of the tube.
    pub(super) back: bool,
}

impl Skin<'_> {
    /// The rings, the tube ending at a height.
    pub(super) fn rings(&self, bands: &mut Bands, height: f64) -> Result<SkinRings> {
        let setup = self.setup;
        let radius = setup.radius_at(self.depth, height);
        let circle = |height: f64, radius: f64| {
            let (u, v) = (setup.frame.x() * radius, setup.frame.y() * radius);
            let circle = Ellipse { center: setup.point([0.0, 0.0, height]), u, v };
            move |piece: &Piece| circle.curve(&Sector::new(piece.ends[0], piece.ends[1]))
        };
        let pieces = || self.balls.pieces.iter();
        let end = pieces().map(circle(height, radius)).collect::<Result<Vec<_>>>()?;
        let on_tube: Vec<EdgeCurve> = if setup.is_level() {
            let at = self.balls.pieces[0].height_at(setup, self.depth, 0.0);
            pieces().map(circle(at, setup.radius_at(self.depth, at))).collect::<Result<_>>()?
        } else {
            pieces().map(|piece| evened(&piece.on_tube(setup, self.depth).into())).collect()
        };
        let on_base = self.on_base()?;
        Ok(SkinRings {
            end: bands.ring(end, true),
            on_tube: bands.ring(on_tube, true),
            on_base: bands.ring(on_base, true),
        })
    }

    /// The contacts with the base.
    pub(super) fn on_base(&self) -> Result<Vec<EdgeCurve>> {
        let setup = self.setup;
        let pieces = self.balls.pieces.iter();
        if !setup.is_level() {
            return Ok(pieces.map(|piece| evened(&piece.on_base(setup, self.depth).into())).collect());
        }
        // All have one height and one distance from the axis.
        self.circles_through(self.balls.pieces[0].on_base(setup, self.depth).point(0.0))
    }

    /// Parts of the circle about the axis through a point, over the pieces.
    fn circles_through(&self, p: Point3) -> Result<Vec<EdgeCurve>> {
        let setup = self.setup;
        let from = p - setup.frame.origin();
        let height = from.dot(setup.frame.z());
        let radius = (from - setup.frame.z() * height).length();
        let (u, v) = (setup.frame.x() * radius, setup.frame.y() * radius);
        let circle = Ellipse { center: setup.point([0.0, 0.0, height]), u, v };
        let sector = |piece: &Piece| Sector::new(piece.ends[0], piece.ends[1]);
        self.balls.pieces.iter().map(|piece| circle.curve(&sector(piece))).collect()
    }

    /// The tube and the blend.
    pub(super) fn tube_and_blend(&self, bands: &mut Bands, rings: &SkinRings) -> Result<()> {
        bands.ruled(if self.back { [&rings.on_tube, &rings.end] } else { [&rings.end, &rings.on_tube] })?;
        let canals: Vec<CanalPatch> =
            self.balls.pieces.iter().map(|piece| piece.canal.offset(self.setup.sigma * self.depth)).collect();
        self.arcs(bands, [&rings.on_tube, &rings.on_base], &canals, self.balls.bands)
    }

    /// The sphere from the contact to a pole, by the turn of the third axis to the normal there.
    pub(super) fn to_pole(&self, bands: &mut Bands, on_base: &Ring, sphere: [f64; 2], pole: Quat) -> Result<()> {
        let [e, r] = sphere;
        let canals: Vec<CanalPatch> =
            self.balls.pieces.iter().map(|piece| piece.to_pole(self.setup, sphere, self.depth, pole)).collect();
        let top = self.setup.point([e, 0.0, 0.0]) + pole.rotate(Vec3::Z) * self.setup.sphere_at(r, self.depth);
        let end = bands.pole(top, on_base);
        let angle = |canal: &CanalPatch| canal.arc_ratio(0.0).map_or(0.0, |q| 2.0 * q.vector().length().atan2(q.w));
        let widest = canals.iter().map(angle).fold(0.0, f64::max);
        self.arcs(bands, [on_base, &end], &canals, (widest / super::super::LARGEST_ARC).ceil().max(1.0) as usize)
    }

    /// The plane inside the contact.
    pub(super) fn to_middle(&self, bands: &mut Bands, on_base: &Ring, middle: Point3) -> Result<()> {
        let middle = bands.pole(middle, on_base);
        bands.ruled(if self.back { [&middle, on_base] } else { [on_base, &middle] })
    }

    /// Faces with arcs from a ring to another, in bands.
    fn arcs(&self, bands: &mut Bands, [from, to]: [&Ring; 2], canals: &[CanalPatch], count: usize) -> Result<()> {
        let surfaces = canals.iter().map(CanalPatch::to_rational).collect::<Result<Vec<_>>>()?;
        let mut first = from.clone();
        for k in 0..count {
            let t = part(k, count);
            let second = if k + 1 == count {
                to.clone()
            } else {
                let line = |surface: &RationalBezierSurface| evened(&surface.s_line(t[1]).into());
                let level = self.setup.is_level();
                let through = |i: usize| self.circles_through(canals[i].point(0.0, t[1]));
                bands.ring(if level { through(0)? } else { surfaces.iter().map(line).collect() }, true)
            };
            let arc = |i: usize, ends: [Point3; 2]| -> Result<EdgeCurve> {
                let ends = if self.back { [ends[1], ends[0]] } else { ends };
                let ratio = canals[i].arc_ratio(0.0).unwrap_or(Quat::ONE);
                let arc = if count == 1 {
                    Arc::from_ratio_across(ends[0], ends[1], ratio)?
                } else {
                    let [a, b] = [0.0, 1.0].map(|t| canals[i].point(0.0, t));
                    Arc::from_ratio_across(a, b, ratio)?.restricted(t[0], t[1])?
                };
                Ok(EdgeCurve::Arc(if self.back { arc.reversed() } else { arc }))
            };
            if self.back {
                let backwards =
                    canals.iter().map(|canal| canal.clone().backwards().to_rational()).collect::<Result<Vec<_>>>()?;
                bands
                    .band([&second, &first], arc, |_, i| Ok(backwards[i].part([0.0, 1.0], [1.0 - t[1], 1.0 - t[0]])))?;
            } else {
                bands.band([&first, &second], arc, |_, i| Ok(surfaces[i].part([0.0, 1.0], t)))?;
            }
            first = second;
        }
        Ok(())
    }
}
