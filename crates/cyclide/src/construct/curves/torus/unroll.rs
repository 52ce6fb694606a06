//! Splines on a torus in the plane: the torus cut open along a parallel and a meridian and laid flat, which stretches it.
//!
//! Both maps take longitudes to lengths on the core circle, `x = a longitude`, so that lengths along parallels are multiplied by
//! `a/radius`. They differ round the tube (`docs/math/torus-splines.md#unrolled`):
//! ```text
//! belt       y = b meridian       lengths round the tube are true
//! conformal  y = 2 a b B / c      angles are true, and every circle of the four families is a straight line
//! ```

use crate::base::planar::{Point2, Vec2};
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::biarc_cover::{SmoothPiece, append_biarcs};
use crate::curve::{Arc, ArcPath, ParamCurve as _, length};
use crate::error::{ErrorItem, NumberError, Result, check_tolerance};
use crate::surface::{PlaceAngle, Torus, TorusSpline};
use std::f64::consts::PI;

/// Cuts this near the end of a piece, by its parameter, are at its end.
const AT_END: f64 = 1e-9;

/// Angles so near the cut, in half turns, are on it.
const ON_CUT: f64 = 1e-12;

/// Samples of the stretch on each piece.
const SAMPLES: u32 = 16;

/// How a torus is laid flat.
///
/// ```
/// use cyclide::{Frame, construct::TorusMap, surface::Torus};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// let top = torus.place_of_angles(1.0, std::f64::consts::FRAC_PI_2);
/// let flat = TorusMap::Belt.point(&torus, top);
/// assert!((flat.x - 3.0).abs() < 1e-15 && (flat.y - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(description = "How a torus is laid flat."))]
pub enum TorusMap {
    /// x is the longitude times the major radius `a`, y the meridian angle times the minor radius `b`: lengths around
    /// the tube are true. Lengths around the axis are multiplied by `a/r` at the distance `r` from the axis: they are
    /// true on the top and the bottom of the tube, times `a/(a+b)` outside and times `a/(a-b)` inside.
    #[default]
    Belt,
    /// x is the longitude times the major radius `a`, y the second angle of the torus times `2ab/c`, with `c² = a² -
    /// b²`. Angles are true, and circles around the axis, circles around the tube and Villarceau circles are straight
    /// lines; all lengths are multiplied by `a/r` at the distance `r` from the axis, so they are true on the top and
    /// the bottom of the tube.
    Conformal,
}

impl TorusMap {
    /// The point of the plane for a place, whole turns of both angles counted.
    #[must_use]
    pub fn point(self, torus: &Torus, place: Point2) -> Point2 {
        let [longitude, meridian] = torus.angles_of_place(place);
        let [a, b] = [torus.major_radius(), torus.minor_radius()];
        match self {
            Self::Belt => Point2::new(a * longitude, b * meridian),
            Self::Conformal => Point2::new(a * longitude, Self::conformal_height(torus) * place.y),
        }
    }

    /// Width and height of the plane of the whole torus.
    #[must_use]
    pub fn size(self, torus: &Torus) -> [f64; 2] {
        let height = match self {
            Self::Belt => 2.0 * torus.minor_radius(),
            Self::Conformal => Self::conformal_height(torus),
        };
        [2.0 * PI * torus.major_radius(), PI * height]
    }

    /// The velocity in the plane of a curve that passes a place at the speed `rate`.
    fn velocity(self, torus: &Torus, place: Point2, rate: Vec2) -> Vec2 {
        let [a, b] = [torus.major_radius(), torus.minor_radius()];
        let [longitude, meridian] = torus.angle_rates(place, rate);
        match self {
            Self::Belt => Vec2::new(a * longitude, b * meridian),
            Self::Conformal => Vec2::new(a * longitude, Self::conformal_height(torus) * rate.y),
        }
    }

    /// `2 a b/c`.
    fn conformal_height(torus: &Torus) -> f64 {
        let [a, b] = [torus.major_radius(), torus.minor_radius()];
        // The difference of the radii is exact where they are near each other, that of 1 and their ratio is not.
        2.0 * b / (((a - b) / a) * (1.0 + b / a)).sqrt()
    }
}

/// How [`TorusSpline::unroll`] lays a curve flat.
///
/// ```
/// use cyclide::construct::{TorusMap, UnrollOptions};
/// let options = UnrollOptions::new(0.01);
/// assert_eq!((options.map, options.seam), (TorusMap::Belt, [0.0, std::f64::consts::PI]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnrollOptions {
    /// The map.
    pub map: TorusMap,
    /// Where the torus is cut: longitude and meridian angle, radians. The plane has the longitudes from there on and the meridian angles
    /// up to there.
    pub seam: [f64; 2],
    /// Distance within which arcs stand for the curve in the plane, sampled.
    pub tolerance: f64,
}

impl UnrollOptions {
    /// A belt cut at the longitude 0 and along its inner side.
    #[must_use]
    pub const fn new(tolerance: f64) -> Self {
        Self { map: TorusMap::Belt, seam: [0.0, PI], tolerance }
    }
}

/// A curve on a torus, laid flat.
///
/// ```
/// use cyclide::{Frame, construct::UnrollOptions, surface::{Torus, TorusSpline}};
/// let trefoil = TorusSpline::knot(&Torus::new(Frame::WORLD, 3.0, 1.0)?, [2, 3], Default::default())?;
/// let flat = trefoil.unroll(&UnrollOptions::new(1e-3))?;
/// assert_eq!(flat.lines.len(), 4); // cut twice at the longitude 0 and three times on the inner side, once of these at both
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct UnrolledSpline {
    /// The lines in the plane z = 0, in the order of the curve: arcs and segments, G1 where the curve is.
    pub lines: Vec<ArcPath>,
    /// How often the curve was cut.
    pub cuts: usize,
    /// The least and the largest factor by which the map multiplies lengths along parallels, on the curve (sampled). Round the tube
    /// it is 1 on a belt, and the same in the conformal map.
    pub stretch: [f64; 2],
    /// Length of the curve on the torus, and of all lines in the plane.
    pub lengths: [f64; 2],
}

/// A part of a piece in one copy of the plane.
#[derive(Debug, Clone, Copy)]
struct Part {
    piece: usize,
    range: [f64; 2],
    copy: [f64; 2],
}

impl TorusSpline {
    /// The curve laid flat, cut where it crosses the seam of the plane.
    ///
    /// # Errors
    /// `tolerance-not-positive`, `not-finite` (the seam), `parameter-out-of-range` (a seam above 1e6), `too-many-pieces`.
    pub fn unroll(&self, options: &UnrollOptions) -> Result<UnrolledSpline> {
        check_tolerance(options.tolerance)?;
        if let Some(index) = options.seam.iter().position(|angle| !angle.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index }.into());
        }
        let seam = self.torus().place_of_angles(options.seam[0], options.seam[1]);
        super::spline_data::check_angles(0, seam)?;
        let runs = self.runs_between_cuts(seam);
        // A single run that goes round is cut where it meets itself.
        let whole = runs.len() == 1 && self.winding() == Some([0, 0]);
        let cuts = runs.len() - usize::from(whole || !self.is_closed());
        let flat = Flat { spline: self, map: options.map, size: options.map.size(self.torus()) };
        let lines =
            runs.iter().map(|run| flat.line(run, options.tolerance, whole)).collect::<Result<Vec<ArcPath>>>()?;
        let drawn = lines.iter().map(ArcPath::length).sum();
        Ok(UnrolledSpline { cuts, stretch: self.stretch(), lengths: [length(self), drawn], lines })
    }

    /// The parts between crossings of the seam, in their order; each run is in one copy of the plane.
    fn runs_between_cuts(&self, seam: Point2) -> Vec<Vec<Part>> {
        let mut runs: Vec<Vec<Part>> = Vec::new();
        for part in (0..self.pieces().len()).flat_map(|piece| self.parts(piece, seam)) {
            match runs.last_mut() {
                Some(run) if run.last().is_some_and(|last| same_copy(last.copy, part.copy)) => run.push(part),
                _ => runs.push(vec![part]),
            }
        }
        self.joined_over_start(runs)
    }

    /// A closed curve that does not start on the seam runs on from its last run into its first one.
    fn joined_over_start(&self, mut runs: Vec<Vec<Part>>) -> Vec<Vec<Part>> {
        let turns = self.winding().map(|turns| turns.map(|n| n as f64));
        let copies = |runs: &[Vec<Part>]| Some((runs.first()?.first()?.copy, runs.last()?.last()?.copy));
        if let (Some([n, m]), Some((first, last))) = (turns, copies(&runs))
            && runs.len() > 1
            && same_copy(last, [first[0] + n, first[1] + m])
        {
            let start = runs.remove(0);
            if let Some(run) = runs.last_mut() {
                run.extend(start);
            }
        }
        runs
    }

    fn parts(&self, piece: usize, seam: Point2) -> Vec<Part> {
        let quartic = &self.pieces()[piece];
        let mut cuts: Vec<f64> = [(PlaceAngle::Around, seam.x), (PlaceAngle::Tube, seam.y)]
            .into_iter()
            .flat_map(|(angle, value)| quartic.crossings(angle, value))
            .filter(|s| *s > AT_END && *s < 1.0 - AT_END)
            .collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|b, a| *b - *a <= AT_END);
        let ends = [0.0].into_iter().chain(cuts.iter().copied()).zip(cuts.iter().copied().chain([1.0]));
        ends.map(|(from, to)| {
            let away = self.unrolled_place(piece, 0.5 * (from + to)) - seam;
            // Longitudes from the seam on, meridian angles up to it.
            let copy = [(away.x / PI + ON_CUT).floor(), (away.y / PI - ON_CUT).ceil()];
            Part { piece, range: [from, to], copy }
        })
        .collect()
    }

    fn stretch(&self) -> [f64; 2] {
        let at = |piece: usize, k: u32| {
            let place = self.unrolled_place(piece, f64::from(k) / f64::from(SAMPLES));
            self.torus().major_radius() / self.torus().distance_from_axis(place)
        };
        (0..self.pieces().len())
            .flat_map(|piece| (0..=SAMPLES).map(move |k| at(piece, k)))
            .fold([f64::INFINITY, 0.0], |[least, most]: [f64; 2], x| [least.min(x), most.max(x)])
    }
}

/// The curve laid flat, without cuts.
struct Flat<'a> {
    spline: &'a TorusSpline,
    map: TorusMap,
    size: [f64; 2],
}

/// A part of it, moved to the plane.
struct FlatPart<'a> {
    flat: &'a Flat<'a>,
    part: Part,
}

impl Flat<'_> {
    /// The line of a run; `whole` if it is a closed curve without a cut.
    fn line(&self, run: &[Part], tolerance: f64, whole: bool) -> Result<ArcPath> {
        let mut arcs: Vec<Arc> = Vec::new();
        for part in run {
            let (before, end) = (arcs.len(), arcs.last().map(Arc::end));
            append_biarcs(&FlatPart { flat: self, part: *part }, part.piece, part.range, tolerance, &mut arcs)?;
            // Over the start of a closed curve places agree to rounding.
            if let (Some(end), Some(first)) = (end, arcs.get_mut(before)) {
                *first = first.with_start(end);
            }
        }
        if whole && let (Some(first), Some(last)) = (arcs.first().copied(), arcs.last_mut()) {
            *last = last.with_end(first.start());
        }
        ArcPath::new(arcs, whole)
    }
}

impl FlatPart<'_> {
    /// The place in the unrolled plane; that at the end of a piece is that at the start of the next.
    fn place(&self, s: f64) -> Point2 {
        let (spline, Part { piece, .. }) = (self.flat.spline, self.part);
        if s >= 1.0 && piece + 1 < spline.pieces().len() {
            spline.unrolled_place(piece + 1, 0.0)
        } else {
            spline.unrolled_place(piece, s)
        }
    }
}

impl SmoothPiece for FlatPart<'_> {
    fn point(&self, s: f64) -> Point3 {
        let Part { copy, .. } = self.part;
        let p = self.flat.map.point(self.flat.spline.torus(), self.place(s));
        Point3::new(p.x - copy[0] * self.flat.size[0], p.y - copy[1] * self.flat.size[1], 0.0)
    }

    fn moving(&self, s: f64) -> (Point3, Vec3) {
        let (spline, piece) = (self.flat.spline, self.part.piece);
        let velocity = self.flat.map.velocity(spline.torus(), self.place(s), spline.pieces()[piece].rate(s));
        (self.point(s), Vec3::new(velocity.x, velocity.y, 0.0))
    }
}

/// Whether two copies of the plane, counted along both of its sides, are one.
fn same_copy([a, b]: [f64; 2], [c, d]: [f64; 2]) -> bool {
    (a - c).abs() < 0.5 && (b - d).abs() < 0.5
}
