//! End faces of a part of a turn, over the area between profiles that lie in one half plane of the axis.

use super::profile::{Piece, Profile};
use super::{PLACES, Revolution, centre, meridian};
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::planar_area::{Cover, Plane};
use crate::error::Result;
use crate::topology::EdgeCurve;

/// A profile is in one half plane of the axis if its control points leave it by less than this part of its size.
const PLANAR: f64 = 1e-12;

/// Profiles that bound one area, the one round all others first; alone without end faces.
pub(super) struct Group {
    pub(super) profiles: Vec<usize>,
    pub(super) ends: Option<Ends>,
}

/// What a solid is made of.
pub(super) struct Ends {
    /// The profiles with the area on one side, cut where faces needed it.
    pub(super) profiles: Vec<Profile>,
    /// Faces of the plane where the turn starts.
    pub(super) cover: Cover,
    /// What the sides of its contours are, contour by contour.
    pub(super) sides: Vec<EndSide>,
}

/// A side of the area where a turn starts or ends.
#[derive(Clone, Copy)]
pub(super) enum EndSide {
    /// Along a piece of a profile.
    Piece { profile: usize, piece: usize },
    /// Along the axis, from the end of one profile to the start of another.
    Axis { from: usize, to: usize },
}

/// Profiles of a part of a turn, grouped by the areas that they bound. Those that bound none, are not in a plane with the axis, or meet
/// themselves or others, have no end faces.
pub(super) fn groups(turn: &Revolution, profiles: &[Profile]) -> Result<Vec<Group>> {
    let bounds = |profile: &Profile| {
        profile.encloses()
            && !profile.flat
            && outwards(turn, profile).is_some_and(|outwards| is_in_plane(turn, profile, outwards))
            && meridian::check(turn, &profile.pieces, profile.size).is_ok()
    };
    let mut pieces: Vec<&[Piece]> =
        profiles.iter().map(|profile| if bounds(profile) { &profile.pieces[..] } else { &[] }).collect();
    let size = profiles.iter().map(|profile| profile.size).fold(0.0, f64::max);
    if meridian::check_apart(turn, &pieces, size).is_err() {
        pieces = vec![&[]; profiles.len()];
    }
    let around = meridian::all_around(turn, &pieces);
    let mut groups = Vec::new();
    for k in (0..profiles.len()).filter(|&k| around[k].len().is_multiple_of(2)) {
        let hole = |&j: &usize| around[j].len() == around[k].len() + 1 && around[j].contains(&k);
        let members: Vec<usize> = std::iter::once(k).chain((0..profiles.len()).filter(hole)).collect();
        let of_area: Vec<&Profile> = members.iter().map(|&j| &profiles[j]).collect();
        match if pieces[k].is_empty() { None } else { ends(turn, &of_area)? } {
            Some(ends) => groups.push(Group { profiles: members, ends: Some(ends) }),
            None => groups.extend(members.into_iter().map(|j| Group { profiles: vec![j], ends: None })),
        }
    }
    groups.sort_by_key(|group| group.profiles[0]);
    Ok(groups)
}

/// The end faces of profiles that bound an area, the first one round all others.
fn ends(turn: &Revolution, profiles: &[&Profile]) -> Result<Option<Ends>> {
    let (Some(outwards), Some(first)) = (outwards(turn, profiles[0]), profiles[0].joints.first()) else {
        return Ok(None);
    };
    if !profiles.iter().all(|profile| is_in_plane(turn, profile, outwards)) {
        return Ok(None);
    }
    // The area is to the left of the first profile as it runs, to the right of the others.
    let left = area(turn, profiles[0], outwards) > 0.0;
    let up = if left { turn.axis } else { -turn.axis };
    let mut oriented = vec![profiles[0].with_curves(turn, profiles[0].curves())];
    for profile in &profiles[1..] {
        let along = (area(turn, profile, outwards) > 0.0) != left;
        let curves = profile.curves();
        let back = || curves.iter().rev().map(EdgeCurve::reversed).collect();
        oriented.push(profile.with_curves(turn, if along { curves.clone() } else { back() }));
    }
    let Some(contours) = contours(&oriented, up) else { return Ok(None) };
    let curves = contours.iter().map(|sides| sides.iter().map(|side| side.curve(&oriented)).collect());
    let curves: Vec<Vec<EdgeCurve>> = curves.collect::<Result<_>>()?;
    let sides: Vec<EndSide> = contours.into_iter().flatten().collect();
    let plane = Plane { origin: first.point, axes: [outwards, up] };
    let seen = if let [profile] = &oriented[..] { centre::of(turn, profile, outwards) } else { None };
    let cover = match (seen, &curves[..]) {
        (Some(seen), [contour]) => Some(Cover::from_centre(seen, contour.clone())),
        _ => Cover::of_contours(&plane, curves)?,
    };
    Ok(cover.map(|cover| cut(turn, &oriented, cover, &sides)))
}

/// The profiles in the parts that a cover has cut their pieces to.
fn cut(turn: &Revolution, profiles: &[Profile], cover: Cover, sources: &[EndSide]) -> Ends {
    let mut curves: Vec<Vec<EdgeCurve>> = vec![Vec::new(); profiles.len()];
    let mut sides = Vec::new();
    for side in cover.contours.iter().flatten() {
        sides.push(match sources[side.source] {
            EndSide::Piece { profile, .. } => {
                curves[profile].push(side.curve.clone());
                EndSide::Piece { profile, piece: curves[profile].len() - 1 }
            }
            axis @ EndSide::Axis { .. } => axis,
        });
    }
    let profiles = profiles.iter().zip(curves).map(|(profile, curves)| profile.with_curves(turn, curves)).collect();
    Ends { profiles, cover, sides }
}

impl EndSide {
    fn curve(self, profiles: &[Profile]) -> Result<EdgeCurve> {
        match self {
            Self::Piece { profile, piece } => Ok(profiles[profile].pieces[piece].curve.clone()),
            Self::Axis { from, to } => {
                let [from, to] = [profiles[from].last_point(), profiles[to].first_point()];
                crate::curve::Arc::segment(from, to).map(EdgeCurve::from)
            }
        }
    }
}

/// The contours of the area: closed profiles, and those from the axis to the axis with the parts of it between them. Along the axis the
/// area is to the left of the way down: from the end of a profile to the next start of one below.
fn contours(profiles: &[Profile], up: Vec3) -> Option<Vec<Vec<EndSide>>> {
    let pieces =
        |profile: usize| (0..profiles[profile].pieces.len()).map(move |piece| EndSide::Piece { profile, piece });
    let (closed, open): (Vec<usize>, Vec<usize>) = (0..profiles.len()).partition(|&k| profiles[k].closed);
    let mut contours: Vec<Vec<EndSide>> = closed.into_iter().map(|k| pieces(k).collect()).collect();
    let mut left = open;
    while let Some(&first) = left.first() {
        let (mut sides, mut at) = (Vec::new(), first);
        loop {
            left.retain(|&k| k != at);
            sides.extend(pieces(at));
            let from = profiles[at].last_point();
            if from == profiles[at].first_point() {
                break;
            }
            let below = |k: &usize| (from - profiles[*k].first_point()).dot(up);
            let candidates = std::iter::once(first).chain(left.iter().copied()).filter(|k| below(k) > 0.0);
            let next = candidates.min_by(|a, b| below(a).total_cmp(&below(b)))?;
            sides.push(EndSide::Axis { from: at, to: next });
            if next == first {
                break;
            }
            at = next;
        }
        contours.push(sides);
    }
    Some(contours)
}

/// The direction off the axis of the place farthest from it.
fn outwards(turn: &Revolution, profile: &Profile) -> Option<Vec3> {
    let middles =
        profile.pieces.iter().flat_map(|piece| [0.0, 0.5, 1.0].map(|x| turn.way_off_axis(piece.curve.point(x))));
    middles.max_by(|a, b| a.length().total_cmp(&b.length()))?.unit()
}

/// Whether all control points of a profile lie in the half plane of a direction off the axis, and so the profile.
fn is_in_plane(turn: &Revolution, profile: &Profile, outwards: Vec3) -> bool {
    let across = turn.axis.cross(outwards);
    let rows = profile.pieces.iter().flat_map(|piece| piece.curve.bezier_rows());
    let points = rows.map(|[x, y, z, w]| Point3::new(x / w, y / w, z / w));
    points.into_iter().all(|p| {
        let limit = PLANAR * (profile.size + turn.way_off_axis(p).length() + p.to_vec().max_abs());
        (p - turn.origin).dot(across).abs() <= limit
    }) && turn.way_off_axis(profile.pieces[0].curve.point(0.5)).dot(outwards) > 0.0
}

/// Twice the area of the polygon through places of a profile, by distance from the axis and height.
fn area(turn: &Revolution, profile: &Profile, outwards: Vec3) -> f64 {
    let origin = profile.first_point();
    let place = |p: Point3| [(p - origin).dot(outwards), (p - origin).dot(turn.axis)];
    let at = |k: u32| f64::from(k) / f64::from(PLACES);
    let places: Vec<[f64; 2]> =
        profile.pieces.iter().flat_map(|piece| (0..PLACES).map(|k| place(piece.curve.point(at(k))))).collect();
    let places: Vec<[f64; 2]> = places.into_iter().chain([place(profile.last_point())]).collect();
    places.windows(2).map(|pair| pair[0][0] * pair[1][1] - pair[0][1] * pair[1][0]).sum()
}
