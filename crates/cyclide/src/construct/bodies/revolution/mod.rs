//! Surfaces of revolution, exact (`docs/math/revolution-and-pipes.md#revolution`; source: `000`, section 7, where the
//! weights are those of a half turn).
//!
//! With the rotor `w = (cos Φ/2, sin Φ/2 h)` of the whole angle and the axis through `o`, the point that a profile point `P`
//! of weight `g` has turned to is `x (P - o) x^-1 + o`, `x(t) = (1-t) + w t`: in the parameter t quadratic, with the rows
//!
//! ```text
//! [g P, g],   g [r o + r y + p × y, r],   g [o + y + 2 p × (r y + p × y), 1],     y = P - o, r = cos Φ/2, p = sin Φ/2 h
//! ```
//!
//! So a rational profile of degree n gives a rational surface of degree (n, 2). An arc that lies in a plane with the axis
//! gives more: multiplying a quaternion form `N D^-1` by `x` from the left keeps it one, `(x N)(x D)^-1`, whose corners have
//! the weights `1, u, w, w u`: a principal patch of a torus, sphere, cone, cylinder or plane.

mod centre;
mod ends;
mod flat;
mod meridian;
mod profile;
mod sectors;
mod side;

use super::rotated_rows::rotated_rows;
use crate::base::bounds::Aabb;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, ProfileError, Result};
use crate::rational::{RationalBezier, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve, Shell};
use crate::warning::{BodyWarning, Warning};
use ends::Ends;
use profile::{Piece, Profile};
use std::f64::consts::TAU;

/// Places of a piece at which its side of the axis, and in a plane across it its way, are looked at.
const PLACES: u32 = 64;
/// A point of the axis this many times farther away than the profile is large is no place to count from.
const FAR: f64 = 16.0;

/// A turn about an axis.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::Revolution, curve::Arc};
/// let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, std::f64::consts::TAU)?;
/// let half = Arc::from_three_points(Point3::new(0.0, 0.0, -1.0), Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 0.0, 1.0))?;
/// let ball = turn.body(&[half.into()], false)?;
/// assert!((ball.outer.volume() - 4.0 / 3.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Revolution {
    /// The point of the axis that is counted from: the given one, or one beside a profile.
    origin: Point3,
    given: Point3,
    axis: Vec3,
    angle: f64,
}

impl Revolution {
    /// A turn by `angle` radians about the axis through a point along a direction of any length, right-handed for positive
    /// angles; up to a whole turn, which is closed.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates), `zero-axis`, `angle-out-of-range` (beyond a whole turn).
    pub fn new(origin: Point3, axis: Vec3, angle: f64) -> Result<Self> {
        range::check_point(0, origin.to_vec())?;
        if !axis.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Axis, index: 0 }.into());
        }
        let axis = axis.unit().ok_or(Error::zero_axis(ErrorItem::Axis))?;
        if !(angle.abs() <= TAU * (1.0 + f64::EPSILON)) {
            return Err(NumberError::AngleOutOfRange { name: ErrorItem::Angle, angle, min: -TAU, max: TAU }.into());
        }
        Ok(Self { origin, given: origin, axis, angle })
    }

    /// True for a whole turn.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.angle.abs() >= TAU * (1.0 - 4.0 * f64::EPSILON)
    }

    /// The point that a point has turned to after an angle.
    #[must_use]
    pub fn turned(&self, p: Point3, angle: f64) -> Point3 {
        let (sin, cos) = (0.5 * angle).sin_cos();
        let (y, h) = (p - self.origin, self.axis * sin);
        self.origin + y + h.cross(y * cos + h.cross(y)) * 2.0
    }

    /// The surface that a rational profile sweeps in one piece, of degree (n, 2). Beyond half a turn weights are negative.
    ///
    /// # Errors
    /// `angle-out-of-range` for a whole turn. An angle of 0 gives a surface that is constant in t.
    pub fn surface(&self, profile: &RationalBezier) -> Result<RationalBezierSurface> {
        if self.is_whole() {
            return Err(NumberError::AngleOutOfRange {
                name: ErrorItem::Angle,
                angle: self.angle,
                min: -TAU,
                max: TAU,
            }
            .into());
        }
        let (sin, r) = (0.5 * self.angle).sin_cos();
        let (o, rotor) = (self.origin.to_vec(), Quat::from_parts(r, self.axis * sin));
        let rows = profile.rows().iter().flat_map(|&[x, y, z, g]| {
            let [_, half, last] = rotated_rows(rotor, Vec3::new(x, y, z) - o * g);
            let (middle, last) = (o * (r * g) + half, o * g + last);
            [[x, y, z, g], [middle.x, middle.y, middle.z, r * g], [last.x, last.y, last.z, g]]
        });
        RationalBezierSurface::new([profile.degree(), 2], rows.collect())
    }

    /// The body that a profile sweeps, sewn: pieces that follow each other, each from the end of the last one, `closed` if
    /// the end is the start. Arcs in a plane with the axis become patches, all else rational faces, in sectors of a quarter
    /// turn at most. It is a solid, outside outwards, if the profile is closed or ends on the axis on both sides, and the turn is whole or
    /// the profile has end faces: it lies in one half plane of the axis and does not meet itself. Its curves are cut where planar faces along them
    /// need that, to 2,000 pieces at most. Pieces along the axis sweep nothing. Ends within a millionth of the profile's size of the axis are moved onto it, as are pieces
    /// along it: [`warnings`](Self::warnings) says how far. The normal of an open surface is that of the
    /// profile's direction × the turn's: to the axis where the profile runs up and the turn is positive.
    ///
    /// # Errors
    /// `angle-out-of-range` (0), `too-few-points` (no piece), `profile-on-axis` (none off the axis), `disconnected`, `crosses-axis` (a piece meets the axis inside, or two lie on
    /// different sides of it; an open profile touches it between its ends, or, in a whole turn, a closed one more than once), `folded-profile` (in a plane across the axis, other than straight away from it or towards it), `profile-meets-itself` (of what
    /// would be a solid), `weight-not-positive`; as [`CyclidePatch::from_weights`](crate::surface::CyclidePatch::from_weights).
    pub fn body(&self, profile: &[EdgeCurve], closed: bool) -> Result<Body> {
        let near = self.beside([profile]);
        near.one_body(profile, closed).map_err(|e| near.counted_from_given(e))
    }

    /// The bodies that several profiles sweep, each with whether it is closed: as [`body`](Self::body), but a solid inside another one is a hollow
    /// of it, one inside the hollow a solid again. In a part of a turn a hollow runs from end to end, a tunnel of one shell. Bodies stand in the order of the profiles of their outer shells.
    ///
    /// # Errors
    /// As [`body`](Self::body); `profile-meets-itself` also where the profiles of two solids meet, whose pieces are counted through.
    pub fn bodies(&self, profiles: &[(Vec<EdgeCurve>, bool)]) -> Result<Vec<Body>> {
        let near = self.beside(profiles.iter().map(|(pieces, _)| &pieces[..]));
        near.bodies_beside(profiles).map_err(|e| near.counted_from_given(e))
    }

    /// As [`body`](Self::body), counted from a point beside the profile.
    fn one_body(&self, profile: &[EdgeCurve], closed: bool) -> Result<Body> {
        let profile = self.profile(profile, closed)?;
        if self.is_whole() {
            return self.whole_shell(&profile).map(body_of);
        }
        let groups = ends::groups(self, std::slice::from_ref(&profile))?;
        self.part(&profile, groups.first().and_then(|group| group.ends.as_ref()))
    }

    /// As [`bodies`](Self::bodies), counted from a point beside the profiles.
    fn bodies_beside(&self, profiles: &[(Vec<EdgeCurve>, bool)]) -> Result<Vec<Body>> {
        let profiles =
            profiles.iter().map(|(pieces, closed)| self.profile(pieces, *closed)).collect::<Result<Vec<_>>>()?;
        if !self.is_whole() {
            let groups = ends::groups(self, &profiles)?;
            return groups.iter().map(|group| self.part(&profiles[group.profiles[0]], group.ends.as_ref())).collect();
        }
        let swept = profiles.iter().map(|profile| self.whole_shell(profile)).collect::<Result<Vec<_>>>()?;
        let solids: Vec<&[Piece]> = (swept.iter().zip(&profiles))
            .map(|(shell, profile)| if shell.is_closed() { &profile.pieces[..] } else { &[] })
            .collect();
        let size = profiles.iter().map(|profile| profile.size).fold(0.0, f64::max);
        meridian::check_apart(self, &solids, size)?;
        let around = meridian::all_around(self, &solids);
        let mut place = vec![None; swept.len()];
        let mut bodies = Vec::new();
        for (k, shell) in swept.iter().enumerate().filter(|(k, _)| around[*k].len().is_multiple_of(2)) {
            place[k] = Some(bodies.len());
            bodies.push(body_of(shell.clone()));
        }
        for (k, shell) in swept.into_iter().enumerate().filter(|(k, _)| !around[*k].len().is_multiple_of(2)) {
            // The one next to it is inside as many as there are but itself.
            let next = around[k].iter().find(|&&j| around[j].len() + 1 == around[k].len());
            if let Some(body) = next.and_then(|&j| place[j]) {
                bodies[body].voids.push(shell.flipped());
            }
        }
        Ok(bodies)
    }

    /// What should be known of that which profiles sweep, each with the number of the profile: ends that were moved onto the axis
    /// (`moved-to-axis`), a profile in a plane across the axis (`flat-revolution`), a closed profile that touches the axis (`pinched`), a surface that stays open although its profile
    /// goes round an area (a part of a turn without end faces: in no half plane of the axis, or meeting itself or another one), or although the turn is whole (`open-body`).
    ///
    /// # Errors
    /// As [`body`](Self::body), as far as profiles are refused for themselves.
    pub fn warnings(&self, profiles: &[(Vec<EdgeCurve>, bool)]) -> Result<Vec<(usize, Warning)>> {
        let near = self.beside(profiles.iter().map(|(pieces, _)| &pieces[..]));
        near.warnings_beside(profiles).map_err(|e| near.counted_from_given(e))
    }

    /// As [`warnings`](Self::warnings), counted from a point beside the profiles.
    fn warnings_beside(&self, profiles: &[(Vec<EdgeCurve>, bool)]) -> Result<Vec<(usize, Warning)>> {
        let made = profiles.iter().map(|(pieces, closed)| Profile::new(self, pieces, *closed));
        let profiles = made.collect::<Result<Vec<_>>>()?;
        let mut ended = vec![self.is_whole(); profiles.len()];
        if !self.is_whole() {
            for group in ends::groups(self, &profiles)?.iter().filter(|group| group.ends.is_some()) {
                group.profiles.iter().for_each(|&k| ended[k] = true);
            }
        }
        let warnings = profiles.iter().zip(ended).enumerate();
        Ok(warnings.flat_map(|(k, (profile, ended))| self.warnings_of(profile, ended).map(move |w| (k, w))).collect())
    }

    /// Warnings of a profile that has end faces, or needs none.
    fn warnings_of(&self, profile: &Profile, ended: bool) -> impl Iterator<Item = Warning> + use<> {
        let moved = profile.moved.map(|[distance, limit]| Warning::Body(BodyWarning::MovedToAxis { distance, limit }));
        let pinch = profile.pinches().first().copied();
        let pinched = pinch
            .filter(|_| self.is_whole() && !profile.flat)
            .map(|p| Warning::Body(BodyWarning::Pinched { height: self.height(p) }));
        let open = if profile.flat {
            Some(Warning::Body(BodyWarning::FlatRevolution))
        } else if profile.encloses() {
            (!ended).then_some(Warning::Body(BodyWarning::OpenPart { angle: self.angle }))
        } else {
            let [start, end] = profile.ends_off_axis(self);
            self.is_whole().then_some(Warning::Body(BodyWarning::OpenProfile { start, end }))
        };
        moved.into_iter().chain(pinched).chain(open)
    }

    fn profile(&self, pieces: &[EdgeCurve], closed: bool) -> Result<Profile> {
        if self.angle == 0.0 {
            return Err(NumberError::AngleOutOfRange { name: ErrorItem::Angle, angle: 0.0, min: -TAU, max: TAU }.into());
        }
        Profile::new(self, pieces, closed)
    }

    /// What a profile sweeps in a whole turn, outside outwards where it is closed.
    fn whole_shell(&self, profile: &Profile) -> Result<Shell> {
        if profile.pinches().len() > 1
            && let Some(error) = profile.touching()
        {
            return Err(error);
        }
        let shell = sectors::open_shell(self, profile)?;
        if !shell.is_closed() {
            return Ok(shell);
        }
        meridian::check(self, &profile.pieces, profile.size)?;
        Ok(shell.outside_out())
    }

    /// What profiles sweep in a part of a turn: a solid with end faces, without them an open surface of the first profile.
    fn part(&self, profile: &Profile, ends: Option<&Ends>) -> Result<Body> {
        let shell = match ends {
            Some(ends) => sectors::closed_shell(self, ends)?.outside_out(),
            None => sectors::open_shell(self, profile)?,
        };
        Ok(body_of(shell))
    }

    /// The way of a point from the axis.
    fn way_off_axis(&self, p: Point3) -> Vec3 {
        let v = p - self.origin;
        v - self.axis * v.dot(self.axis)
    }

    fn foot(&self, p: Point3) -> Point3 {
        p - self.way_off_axis(p)
    }

    /// The height of a point along the axis, from the point that is counted from.
    fn height(&self, p: Point3) -> f64 {
        (p - self.origin).dot(self.axis)
    }

    /// The same turn, counted from the axis beside profiles where the given point is far from them: what is on the axis, and
    /// the digits of what is made, do not depend on the point of the axis that was given.
    fn beside<'a>(&self, profiles: impl IntoIterator<Item = &'a [EdgeCurve]>) -> Self {
        let places = profiles.into_iter().flatten().flat_map(|piece| [0.0, 0.5, 1.0].map(|x| piece.point(x)));
        let Some(bounds) = Aabb::of_points(places.flat_map(|p| [p, self.foot(p)])) else { return *self };
        let middle = bounds.min + (bounds.max - bounds.min) * 0.5;
        let height = self.height(middle);
        let far = height.abs() > FAR * bounds.diagonal();
        if far { Self { origin: self.origin + self.axis * height, ..*self } } else { *self }
    }

    /// An error with the height from the given point.
    fn counted_from_given(&self, error: Error) -> Error {
        match error {
            Error::Profile(ProfileError::MeetsItself { first, second, radius, height }) => {
                let height = height + (self.origin - self.given).dot(self.axis);
                Error::Profile(ProfileError::MeetsItself { first, second, radius, height })
            }
            other => other,
        }
    }
}

fn body_of(outer: Shell) -> Body {
    Body { outer, voids: Vec::new() }
}
