//! Where the arcs of a circular surface cross their neighbors.
//!
//! Along an arc in a plane with the normal `b` the neighbors are on the side of it that `v = S_s · b` says, and above or below the arc as
//! `u = S_s · (b × T)` says, T its direction. The surface has no normal where both are 0: there its arcs cross, and it runs through
//! itself beside the place. So the zeros of each of the two are looked for along arcs: the other one must not be 0 there, nor change its sign along
//! them from arc to arc. The counterpart of `rulings`, where `u` and `v` are linear; sampled as that is. Surfaces in a plane, where `v` is 0
//! everywhere, are judged by `planar_folds`.

use crate::base::vector::Vec3;
use crate::rational::RationalBezierSurface;

/// Places along the rails at which arcs are looked at, less one.
const ARCS: u32 = 32;
/// Places of an arc, less one.
const PLACES: u32 = 16;
/// Steps in which a place between two others is found.
const STEPS: u32 = 50;
/// Parts of what they could be that are zero.
const ZERO: f64 = 1e-9;
/// Zeros nearer to the ends of an arc than this are of a rail that arcs touch.
const END: f64 = 1e-6;
/// Zeros on neighboring arcs are of one line if they are nearer than this.
const NEIGHBORS: f64 = 0.25;
/// Arcs that turn by less than this are lines, without a plane.
const STRAIGHT: f64 = 1e-6;

/// A place of an arc where one of both is zero, with the other one there.
#[derive(Debug, Clone, Copy)]
struct Passing {
    t: f64,
    other: f64,
}

/// An arc, with the normal of its plane.
struct PlacedArc {
    s: f64,
    normal: Vec3,
    /// Of `v`, where neighbors come through the plane, and of `u`, where they come through the cylinder over the arc.
    passings: [Vec<Passing>; 2],
}

/// Parameters near which neighboring arcs cross. `plane(s)` is a normal of the plane of an arc, whose length is the sine of half
/// the angle that it turns by.
pub(super) fn crossing_arcs(surface: &RationalBezierSurface, plane: impl Fn(f64) -> Vec3) -> Option<[f64; 2]> {
    let arcs: Vec<PlacedArc> =
        (0..=ARCS).filter_map(|k| placed(surface, &plane, f64::from(k) / f64::from(ARCS))).collect();
    let pinched = arcs.iter().find_map(|arc| {
        let passing = arc.passings.iter().flatten().find(|passing| passing.other.abs() <= ZERO)?;
        Some([arc.s, passing.t])
    });
    pinched.or_else(|| arcs.windows(2).find_map(|pair| crossing_between(&pair[0], &pair[1])))
}

/// Where one of both changes its sign along a line of zeros of the other, between two arcs.
fn crossing_between(a: &PlacedArc, b: &PlacedArc) -> Option<[f64; 2]> {
    if a.normal.dot(b.normal) <= 0.0 {
        return None;
    }
    let lines = a.passings.iter().zip(&b.passings).filter(|(from, to)| from.len() == to.len());
    let mut pairs = lines.flat_map(|(from, to)| from.iter().zip(to));
    let changes = |(from, to): &(&Passing, &Passing)| from.other * to.other < 0.0 && (from.t - to.t).abs() < NEIGHBORS;
    pairs.find(changes).map(|(from, to)| [0.5 * (a.s + b.s), 0.5 * (from.t + to.t)])
}

/// The arc at a place of the rails; `None` for a line.
fn placed(surface: &RationalBezierSurface, plane: impl Fn(f64) -> Vec3, s: f64) -> Option<PlacedArc> {
    let normal = Some(plane(s)).filter(|n| n.length() > STRAIGHT)?.unit()?;
    let speed = [0.0, 1.0].map(|t| surface.jet(s, t).ds.length()).into_iter().fold(0.0, f64::max);
    // `v` and `u` as parts of how fast the surface runs there.
    let both = |t: f64| {
        let jet = surface.jet(s, t);
        let above = jet.dt.unit().map_or(f64::NAN, |along| jet.ds.dot(normal.cross(along)));
        [jet.ds.dot(normal) / speed, above / speed]
    };
    let at = |k: u32| f64::from(k) / f64::from(PLACES);
    let values: Vec<[f64; 2]> = (0..=PLACES).map(|k| both(at(k))).collect();
    let mut passings = [Vec::new(), Vec::new()];
    for k in 0..PLACES {
        let [from, to] = [values[k as usize], values[k as usize + 1]];
        for (which, passings) in passings.iter_mut().enumerate() {
            let [from, to] = [from[which], to[which]];
            if from == 0.0 && k > 0 {
                passings.extend(passing(both, which, [at(k); 2]));
            } else if from * to < 0.0 {
                passings.extend(passing(both, which, [at(k), at(k + 1)]));
            }
        }
    }
    Some(PlacedArc { s, normal, passings })
}

/// Where one of both is zero between two places, if that is inside the arc.
fn passing(both: impl Fn(f64) -> [f64; 2], which: usize, [mut low, mut high]: [f64; 2]) -> Option<Passing> {
    let negative = |t: f64| both(t)[which] < 0.0;
    let sign = negative(low);
    for _ in 0..STEPS {
        let middle = 0.5 * (low + high);
        if negative(middle) == sign { low = middle } else { high = middle }
    }
    let t = 0.5 * (low + high);
    let other = both(t)[1 - which];
    (t > END && t < 1.0 - END && other.is_finite()).then_some(Passing { t, other })
}
