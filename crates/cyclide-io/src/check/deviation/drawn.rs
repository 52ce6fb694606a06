//! The lines of surfaces in a drawing against the lines of the model that they stand for.
//!
//! Who draws hands over places: which body, which edge or parameter line of a face. The line is taken from the model
//! again, so that a wrong one is not compared with itself. Every edge that is not inside a plane has its place, once and in order; one that is a
//! point in the plan has no line in the file, and what is lost of it is measured.

use super::check_parts;
use super::matching::{apart, larger};
use crate::check::read_error::ReadError;
use crate::drawing::plane_regions::drawn_edges;
use crate::export::drawn_line::{LinePlace, ShellLine};
use crate::export::exported::DrawnLine;
use crate::export::parts::BodyOf;
use cyclide::{model::CurveChain, topology::EdgeCurve};

/// Points of a line that is not drawn.
const PLACES: u32 = 9;

/// The distance in the plan, both ways, between each line of a drawing and the line of the model that it stands for.
///
/// # Errors
/// [`ReadError::LineCount`], [`ReadError::Lines`], [`ReadError::PieceCount`], [`ReadError::CurveParts`], `Geometry` where
/// a line of the model has no form.
pub(crate) fn lines_deviation(
    bodies: &[BodyOf<'_>],
    written: &[DrawnLine],
    read: &[CurveChain],
) -> Result<Vec<f64>, ReadError> {
    let expected = written.iter().filter(|line| line.is_drawn()).count();
    if expected != read.len() {
        return Err(ReadError::LineCount { found: read.len(), expected });
    }
    check_places(bodies, written)?;
    let mut read = read.iter();
    let mut deviations = Vec::with_capacity(written.len());
    for (index, line) in written.iter().enumerate() {
        let curve =
            line.place.curve(bodies).ok_or(ReadError::Lines { detail: "one corresponds to no line of the model" })?;
        let curve =
            curve.map_err(|source| ReadError::Geometry { place: format!("line {index} of surfaces"), source })?;
        deviations.push(match if line.is_drawn() { read.next() } else { None } {
            Some(found) => {
                check_parts(&curve, found, &line.parts, index)?;
                apart(&curve, found, &line.parts, true)
            }
            None => extent_in_plan(&curve),
        });
    }
    Ok(deviations)
}

/// Every edge of every body that is drawn is there once and in order, and parameter lines are inner ones, no two of them the same.
fn check_places(bodies: &[BodyOf<'_>], written: &[DrawnLine]) -> Result<(), ReadError> {
    let (edges, circles): (Vec<LinePlace>, Vec<LinePlace>) =
        written.iter().map(|line| line.place).partition(|place| matches!(place.line, ShellLine::Edge(_)));
    let of_model = bodies.iter().enumerate().flat_map(|(body, of)| {
        let shells = of.body.shells().enumerate();
        let edge = move |shell| move |edge| LinePlace { body, shell, line: ShellLine::Edge(edge) };
        shells.flat_map(move |(shell, it)| {
            let drawn = drawn_edges(it).into_iter().enumerate().filter(|(_, drawn)| *drawn);
            drawn.map(|(edge, _)| edge).map(edge(shell))
        })
    });
    if !of_model.eq(edges) {
        return Err(ReadError::Lines { detail: "they are not the edges of the model, each once and in order" });
    }
    let ranks: Option<Vec<_>> = circles.iter().map(LinePlace::rank).collect();
    match ranks {
        Some(ranks) if ranks.windows(2).all(|pair| pair[0] < pair[1]) => Ok(()),
        _ => Err(ReadError::Lines { detail: "the parameter lines are not inner lines in order" }),
    }
}

/// The largest distance of a line from its start, as seen along the third axis.
fn extent_in_plan(curve: &EdgeCurve) -> f64 {
    let start = curve.start();
    let at = |x: f64| curve.arc().map_or_else(|| curve.point(x), |arc| arc.point_at_length(x));
    let points = (1..=PLACES).map(|i| at(f64::from(i) / f64::from(PLACES)));
    points.map(|p| (p.x - start.x).hypot(p.y - start.y)).fold(0.0, larger)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::exported::Promise;
    use cyclide::{
        Point3, Vec3,
        curve::{ArcPath, Correspondence},
        surface::CyclidePatch,
        topology::{Body, Shell},
    };

    #[test]
    fn lines_are_those_of_the_model() {
        let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
        let body = Body { outer: Shell::from_surface(patch).unwrap(), voids: Vec::new() };
        let bodies =
            [BodyOf { object: "octant", item: 0, surface: 0, index: 0, count: 1, name: None, body: body.into() }];
        let line = |line: ShellLine| DrawnLine {
            place: LinePlace { body: 0, shell: 0, line },
            parts: Correspondence::one_to_one(1),
            promise: Promise::EXACT,
        };
        let circles = [0.25, 0.5].map(|s| line(ShellLine::AlongT { face: 0, s }));
        let edges = (0..bodies[0].body.shells().flat_map(Shell::edges).count()).map(|edge| line(ShellLine::Edge(edge)));
        let right: Vec<DrawnLine> = circles.into_iter().chain(edges).collect();
        let arcs = right.iter().map(|line| *line.place.curve(&bodies).unwrap().unwrap().arc().unwrap());
        let read: Vec<CurveChain> = arcs.map(|arc| ArcPath::new(vec![arc], false).unwrap().into()).collect();
        let measured = |written: &[DrawnLine]| lines_deviation(&bodies, written, &read);
        let whole = measured(&right).unwrap();
        assert!(whole.iter().all(|d| *d < 1e-13), "{whole:?}"); // rounding
        let changed = |change: fn(&mut Vec<DrawnLine>)| {
            let mut wrong = right.clone();
            change(&mut wrong);
            measured(&wrong)
        };
        let refused = |result: Result<Vec<f64>, ReadError>| matches!(result, Err(ReadError::Lines { .. }));
        assert!(refused(changed(|lines| lines.swap(0, 1))));
        assert!(refused(changed(|lines| lines.swap(2, 3))));
        assert!(refused(changed(|lines| lines[1].place.line = ShellLine::AlongT { face: 0, s: 1.0 })));
        assert!(refused(changed(|lines| lines[1].place.line = ShellLine::AlongT { face: 7, s: 0.6 })));
        // Another line of the face: as far off as it is.
        let off = changed(|lines| lines[1].place.line = ShellLine::AlongT { face: 0, s: 0.6 }).unwrap();
        assert!(off[1] > 0.05, "{off:?}");
        // An edge that is said to be a point is as far off as it is long in the plan.
        let mut lost = right.clone();
        lost[2].parts = Correspondence::one_to_one(1).recounted([0]);
        let rest = [&read[..2], &read[3..]].concat();
        let off = lines_deviation(&bodies, &lost, &rest).unwrap();
        assert!(off[2] > 0.9, "{off:?}");
    }
}
