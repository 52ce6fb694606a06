//! Where the arcs of a circular surface cross their neighbours.
//!
//! Along an arc in a plane with the normal `b` the neighbours are on the side of it that `v = S_s · b` says; where `v` is 0 they come
//! through the plane, above or below the arc as `u = S_s · (b × T)` says, T its direction. The surface has no normal where both
//! are 0: there its arcs cross, and it runs through itself beside the place. So `u` is followed along each zero of `v` from arc to
//! arc. The counterpart of `rulings`, where `u` and `v` are linear; sampled as that is.

use crate::base::vector::Vec3;
use crate::error::{Error, Result};
use crate::rational::RationalBezierSurface;

/// Places along the rails at which arcs are looked at, less one.
const ARCS: u32 = 32;
/// Places of an arc, less one.
const PLACES: u32 = 16;
/// Steps in which a place between two others is found.
const STEPS: u32 = 50;
/// Parts of what they could be that are zero.
const ZERO: f64 = 1e-9;
/// Zeros on neighbouring arcs are of one line if they are nearer than this.
const NEIGHBOURS: f64 = 0.25;
/// Arcs that turn by less than this are lines, without a plane.
const STRAIGHT: f64 = 1e-6;

/// A place of an arc where its neighbours come through its plane.
#[derive(Debug, Clone, Copy)]
struct Passing {
    t: f64,
    /// On which side of the arc they do, as a part of how fast the surface runs there.
    side: f64,
}

/// An arc, with the normal of its plane.
struct PlacedArc {
    s: f64,
    normal: Vec3,
    passings: Vec<Passing>,
}

/// Refuses a surface whose arcs cross between neighbours. `plane(s)` is a normal of the plane of an arc, whose length is the sine of half
/// the angle that it turns by; `part` the part of the piece as given that the surface is.
///
/// # Errors
/// `arcs-cross`.
pub(super) fn check_arcs(
    surface: &RationalBezierSurface,
    plane: impl Fn(f64) -> Vec3,
    (piece, part): (usize, [f64; 2]),
) -> Result<()> {
    let place = |s: f64, t: f64| [part[0] + (part[1] - part[0]) * s, t];
    let arcs: Vec<PlacedArc> =
        (0..=ARCS).filter_map(|k| placed(surface, &plane, f64::from(k) / f64::from(ARCS))).collect();
    for arc in &arcs {
        if let Some(passing) = arc.passings.iter().find(|passing| passing.side.abs() <= ZERO) {
            return Err(Error::ArcsCross { piece, at: place(arc.s, passing.t) });
        }
    }
    for pair in arcs.windows(2) {
        let [a, b] = [&pair[0], &pair[1]];
        if a.passings.len() != b.passings.len() || a.normal.dot(b.normal) <= 0.0 {
            continue;
        }
        for (from, to) in a.passings.iter().zip(&b.passings) {
            if from.side * to.side < 0.0 && (from.t - to.t).abs() < NEIGHBOURS {
                return Err(Error::ArcsCross { piece, at: place(0.5 * (a.s + b.s), 0.5 * (from.t + to.t)) });
            }
        }
    }
    Ok(())
}

/// The arc at a place of the rails; `None` for a line.
fn placed(surface: &RationalBezierSurface, plane: impl Fn(f64) -> Vec3, s: f64) -> Option<PlacedArc> {
    let normal = Some(plane(s)).filter(|n| n.length() > STRAIGHT)?.unit()?;
    let through = |t: f64| surface.jet(s, t).ds.dot(normal);
    let at = |k: u32| f64::from(k) / f64::from(PLACES);
    let values: Vec<f64> = (0..=PLACES).map(|k| through(at(k))).collect();
    let mut passings = Vec::new();
    for k in 0..PLACES {
        let [from, to] = [values[k as usize], values[k as usize + 1]];
        if from == 0.0 && k > 0 || from * to < 0.0 {
            passings.extend(passing(surface, s, normal, [at(k), at(k + 1)]));
        }
    }
    Some(PlacedArc { s, normal, passings })
}

/// Where the neighbours come through the plane between two places, if that is inside the arc.
fn passing(surface: &RationalBezierSurface, s: f64, normal: Vec3, [mut low, mut high]: [f64; 2]) -> Option<Passing> {
    let through = |t: f64| surface.jet(s, t).ds.dot(normal);
    let sign = through(low) < 0.0;
    for _ in 0..STEPS {
        let middle = 0.5 * (low + high);
        if (through(middle) < 0.0) == sign { low = middle } else { high = middle }
    }
    let t = 0.5 * (low + high);
    let jet = surface.jet(s, t);
    let along = jet.dt.unit()?;
    let speed = surface.jet(s, 0.0).ds.length().max(surface.jet(s, 1.0).ds.length());
    let side = jet.ds.dot(normal.cross(along)) / speed;
    (t > ZERO && t < 1.0 - ZERO && side.is_finite()).then_some(Passing { t, side })
}
