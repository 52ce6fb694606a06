//! Fields of a curve through or near points that have no effect.
//!
//! Where it is cheap the curve is made again without the field and compared; so the answer needs no rule of its own for what
//! a construction does with a field.

use cyclide::{BiarcRule, CurveObject, PipeEnds, bounds, corners_by_angle};

use super::Builder;
use crate::document::angle::Angle;
use crate::document::construct::{Contour, arc_spline, fair_spline};
use crate::document::coordinates::{PointFile, PointSource};
use crate::document::locate::Step;
#[cfg(feature = "circular-mesh")]
use crate::document::spec::PrincipalGridSpec;
use crate::document::spec::{
    ArcSplineSpec, CircleSplineSpec, Comment, EndsSpec, FairEndsSpec, FairFitSpec, FairSplineSpec, MoebiusContinuity,
    MoebiusSplineSpec, ParametersSpec, PipeSpec, StraightWord, TorusSplineSpec, TubeSpec, TypeWord,
};
use crate::input::points::merge_repeated;
#[cfg(feature = "circular-mesh")]
use cyclide::GridBorder;

/// The reason of warnings about fields and options without effect.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "fair-spline", "ends": "free", "points": [[1, 0], [0, 1], [-1, 0], [0, -1]], "closed": true}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].remarks[0].reason, cyclide_io::NO_EFFECT);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
pub const NO_EFFECT: &str = "no-effect";

/// A field, and why it has no effect.
pub(in crate::document) type Idle = (&'static str, &'static str);

const NO_ENDS: &str = "a closed curve has no ends";
const NO_CORNER: &str = "no point turns by more";

pub(in crate::document) fn in_fair_spline(spec: &FairSplineSpec, at: &Contour<'_>, made: &CurveObject) -> Vec<Idle> {
    let same = |change: &dyn Fn(&mut FairSplineSpec)| {
        // The points are in the contour.
        let mut other = FairSplineSpec {
            r#type: TypeWord,
            comment: Comment,
            construction: false,
            points: PointSource::File(PointFile::default()),
            ..*spec
        };
        change(&mut other);
        fair_spline(&other, at).is_ok_and(|(curve, ..)| is_same(&curve, made))
    };
    let ends = spec.ends != FairEndsSpec::default();
    let tests = [
        ("tension", spec.tension != 0.0 && same(&|s| s.tension = 0.0), "with 0 the curve is the same"),
        ("tight", spec.tight.is_some() && same(&|s| s.tight = None), "no corner stands beside a straight run"),
        (
            "straight",
            spec.straight != StraightWord::Auto && same(&|s| s.straight = StraightWord::Auto),
            "no run of points on a line stands beside a corner",
        ),
        ("ends", ends && spec.closed, NO_ENDS),
        (
            "ends",
            ends && !spec.closed && same(&|s| s.ends = FairEndsSpec::default()),
            "with `circle` the curve is the same",
        ),
        ("corner_angle", has_no_corner(spec.corner_angle, spec.closed, at), NO_CORNER),
    ];
    found(&tests)
}

pub(in crate::document) fn in_circle_spline(spec: &CircleSplineSpec, at: &Contour<'_>) -> Vec<Idle> {
    found(&[
        ("ends", spec.closed && spec.ends != EndsSpec::Natural, NO_ENDS),
        ("corner_angle", has_no_corner(spec.corner_angle, spec.closed, at), NO_CORNER),
    ])
}

pub(in crate::document) fn in_arc_spline(spec: &ArcSplineSpec, at: &Contour<'_>, made: &CurveObject) -> Vec<Idle> {
    let same = || {
        let other = ArcSplineSpec { rule: BiarcRule::EqualD, ..spec.clone() };
        arc_spline(&other, at).is_ok_and(|(curve, ..)| is_same(&curve, made))
    };
    found(&[("rule", spec.rule == BiarcRule::EqualChord && same(), "with `equal-d` the arcs are the same")])
}

pub(in crate::document) fn in_fair_fit(spec: &FairFitSpec, at: &Contour<'_>) -> Vec<Idle> {
    let no_fits = spec.max_fits == Some(0);
    let none_taken_out = "with `max_fits` 0 no nodes are taken out";
    let auto = spec.tolerance.within().is_none();
    found(&[
        ("centre", spec.centre != 0.0 && auto, "with the tolerance `auto` the curve keeps to the middle of the points"),
        ("fix_ends", spec.fix_ends && spec.closed, NO_ENDS),
        ("nodes", spec.nodes.is_some() && no_fits, none_taken_out),
        ("budget", spec.budget.is_some() && no_fits, none_taken_out),
        ("corner_angle", has_no_corner(spec.corner_angle, spec.closed, at), NO_CORNER),
    ])
}

pub(in crate::document) fn in_torus_spline(spec: &TorusSplineSpec, at: &Contour<'_>) -> Vec<Idle> {
    let none_repeated = || merge_repeated(&mut at.list.clone(), spec.closed).kept.len() == at.kept.len();
    found(&[("loops", spec.loops && none_repeated(), "no point repeats its neighbour")])
}

pub(in crate::document) fn in_moebius_spline(spec: &MoebiusSplineSpec, at: &Contour<'_>) -> Vec<Idle> {
    let by_directions = spec.continuity == MoebiusContinuity::G1;
    let no_knots = "with `g1` the curve has no knots";
    found(&[
        ("knots", by_directions && spec.knots != ParametersSpec::default(), no_knots),
        (
            "tangents",
            by_directions && spec.tangents.is_some(),
            "with `g1` the curve takes the directions of its circles",
        ),
        ("corner_angle", has_no_corner(spec.corner_angle, spec.closed, at), NO_CORNER),
    ])
}

/// The fields of a pipe that make no difference; `closed` if all curves are.
pub(in crate::document) fn idle_in_pipe(spec: &PipeSpec, curves: &[CurveObject], closed: bool) -> Vec<Idle> {
    let of_arcs = curves.iter().all(CurveObject::is_of_arcs);
    found(&[
        ("ends", closed && spec.ends != PipeEnds::Flat, NO_ENDS),
        (
            "ends",
            !closed && spec.ends == PipeEnds::Open && spec.wall.is_some(),
            "a wall ends in rings; without `wall` the tube is open",
        ),
        ("tolerance", of_arcs && spec.tolerance.is_some(), "the curve is made of arcs and segments already"),
    ])
}

/// What a tube does not look at; `closed` if all are.
pub(in crate::document) fn idle_in_tube(spec: &TubeSpec, closed: bool) -> Vec<Idle> {
    let values = spec.radius.as_ref().map_or(&[][..], |law| &law.values);
    let constant = values.windows(2).all(|pair| pair[0][1].total_cmp(&pair[1][1]).is_eq());
    found(&[
        ("radius_of", constant && spec.radius_of.is_some(), "sections and balls of one radius are the same tube"),
        ("ends", closed && spec.ends != PipeEnds::Flat, NO_ENDS),
        (
            "ends",
            !closed && spec.ends == PipeEnds::Open && spec.wall.is_some(),
            "a wall ends in rings; without `wall` the tube is open",
        ),
    ])
}

/// What the grids of a surface do not look at; `closed` if one of them is.
#[cfg(feature = "circular-mesh")]
pub(in crate::document) fn idle_in_principal_grid(spec: &PrincipalGridSpec, closed: bool, joined: bool) -> Vec<Idle> {
    let several = spec.most_pieces.is_some_and(|most| most > 1);
    found(&[
        ("columns", !closed && spec.columns.is_some(), "no grid is closed"),
        ("closed", !closed && spec.closed == Some(true), "the surface is no tube whose lines of curvature come back"),
        ("most_pieces", several && spec.border == Some(GridBorder::Cover), "one grid covers the surface"),
        ("most_pieces", joined && spec.most_pieces.is_some(), "joined grids are all laid"),
    ])
}

impl Builder<'_> {
    /// Says which fields have no effect.
    pub(in crate::document) fn remark_on_idle(&mut self, idle: Vec<Idle>) {
        for (field, why) in idle {
            let place = self.place_of([Step::from(field)]);
            self.remark(NO_EFFECT, None, None, place, format!("`{field}` has no effect: {why}"));
        }
    }
}

/// Part of a curve's size that rounding may move it by.
const ROUNDING: f64 = 1e-12;

/// True if two curves of one construction are the same, piece by piece and parameter by parameter.
fn is_same(a: &CurveObject, b: &CurveObject) -> bool {
    let (a, b) = (a.as_curve(), b.as_curve());
    let limit = ROUNDING * bounds(b).diagonal();
    let near = |piece: usize, s: f64| a.piece_point(piece, s).distance(b.piece_point(piece, s)) <= limit;
    a.piece_count() == b.piece_count()
        && (0..a.piece_count()).all(|piece| [0.0, 0.2, 0.5, 0.8, 1.0].into_iter().all(|s| near(piece, s)))
}

fn found(tests: &[(&'static str, bool, &'static str)]) -> Vec<Idle> {
    tests.iter().filter(|(_, idle, _)| *idle).map(|(field, _, why)| (*field, *why)).collect()
}

fn has_no_corner(angle: Option<Angle>, closed: bool, at: &Contour<'_>) -> bool {
    angle.is_some_and(|angle| corners_by_angle(&at.list.points, closed, angle.radians()).is_empty())
}
