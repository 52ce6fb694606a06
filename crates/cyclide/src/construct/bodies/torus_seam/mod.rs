//! Seams of a given width along curves of a torus: raised to be fused to it, sunk to be cut from it.
//!
//! With the unit tangent `t` of the curve and the outward normal `n` of the torus the section of a seam is the rectangle of width `w`
//! along `c = n × t`, between two heights along `n`. Its corners run along `p ± (w/2) c + h n`, whose derivatives follow from
//! ```text
//! n' = (p' - a longitude' around)/b,   t' = (p'' - t (t·p''))/|p'|,   c' = n' × t + n × t'
//! ```
//! They are polynomial cubics with these derivatives at both ends, halved until all four are within the tolerance (sampled), and the
//! faces are ruled between neighbors: their sections are the rectangles. A corner runs backwards where `w/2` is above the radius of
//! geodesic curvature, and such a width is refused (`docs/math/torus-splines.md#seams`).

mod cell;
mod meeting;
mod moving;

use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve as _;
use crate::error::{Error, ErrorItem, NumberError, Result, TorusError, check_tolerance};
use crate::rational::{RationalBezier, RationalBezierSurface};
use crate::surface::TorusSpline;
use crate::topology::{Body, FaceEdge, Sewing};
use meeting::Strip;
use moving::Moving;

/// Most halvings of a piece.
const HALVINGS: u32 = 12;

/// Places between the ends of a cubic at which its distance from the corner is looked at: its one lobe, two where curvature changes
/// sides.
const PLACES: u32 = 8;

/// The part of the tolerance that sampled distances may use.
const SAFETY: f64 = 0.95;

/// A seam: its width, and the heights of its lower and upper side along the outward normal of the torus.
///
/// ```
/// use cyclide::{Frame, construct::TorusSeam, surface::{Torus, TorusSpline}};
/// let torus = Torus::new(Frame::WORLD, 40.0, 15.0)?;
/// let trefoil = TorusSpline::knot(&torus, [2, 3], Default::default())?;
/// let seam = TorusSeam::new(4.0, [-1.0, 0.5])?.body(&trefoil, 0.01)?; // 4 wide, raised by a half, one deep
/// let section = seam.outer.volume() / cyclide::curve::length(&trefoil);
/// assert!((section - 6.0).abs() < 0.2);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorusSeam {
    width: f64,
    heights: [f64; 2],
}

/// A part of a seam over a part of a piece of the curve: the cubics of its corners, round the section.
struct Span {
    piece: usize,
    cubics: [[Point3; 4]; 4],
}

/// Parts of a span, and rounds of dividing two of them again, in which the place nearest to a point is looked for.
const NEAR: u32 = 16;
const ROUNDS: u32 = 12;

impl Span {
    /// The point of the curve in this span that is nearest to a point; the curve is at this part of the height.
    fn curve_near(&self, p: Point3, low: f64) -> Point3 {
        let at = |s: f64| {
            let [a, b, c, d] = self.cubics.map(|cubic| on_cubic(&cubic, s));
            a.midpoint(b).lerp(d.midpoint(c), low)
        };
        let (mut from, mut to) = (0.0, 1.0);
        for _ in 0..ROUNDS {
            let step = (to - from) / f64::from(NEAR);
            let distance = |k: u32| at(from + step * f64::from(k)).distance(p);
            let nearest = (0..=NEAR).min_by(|j, k| distance(*j).total_cmp(&distance(*k))).unwrap_or(0);
            let place = from + step * f64::from(nearest);
            (from, to) = ((place - step).max(0.0), (place + step).min(1.0));
        }
        at(0.5 * (from + to))
    }
}

/// The rectangle at a place: its corners round it, and their derivatives.
#[derive(Debug, Clone, Copy)]
struct Section {
    corners: [Point3; 4],
    derivatives: [Vec3; 4],
}

impl TorusSeam {
    /// A seam of this width between two heights along the outward normal, negative below the torus.
    ///
    /// # Errors
    /// `parameter-out-of-range` (a width that is not positive and finite; heights that are not finite, or the second not above the first).
    pub fn new(width: f64, heights: [f64; 2]) -> Result<Self> {
        let [low, high] = heights;
        if !(width > 0.0 && width.is_finite()) {
            return Err(out_of_range(ErrorItem::Width, width, [0.0, f64::MAX]));
        }
        if !low.is_finite() {
            return Err(out_of_range(ErrorItem::Height, low, [f64::MIN, f64::MAX]));
        }
        if !(high > low && high.is_finite()) {
            return Err(out_of_range(ErrorItem::Height, high, [low, f64::MAX]));
        }
        Ok(Self { width, heights })
    }

    /// The solid along a spline, closed round if the spline is; the ends of an open one are plane.
    ///
    /// # Errors
    /// `tolerance-not-positive`; `parameter-out-of-range` (a height that reaches the middle of the tube or the axis, or at which the seam folds); `seam-too-wide` (it folds in a bend, with the place and the largest width that does not);
    /// `seam-meets-itself` (parts of it that are no neighbors share space, by more than the
    /// tolerance, with the place: all others are proved apart); `too-many-pieces`, `zero-tangent` (a stop of the
    /// curve); as [`Shell::new`](crate::topology::Shell::new).
    pub fn body(&self, spline: &TorusSpline, tolerance: f64) -> Result<Body> {
        check_tolerance(tolerance)?;
        let (a, b) = (spline.torus().major_radius(), spline.torus().minor_radius());
        for height in self.heights {
            if !(height > -b && height < a - b) {
                return Err(out_of_range(ErrorItem::Height, height, [-b, a - b]));
            }
        }
        self.check_width(spline)?;
        let spans = self.spans(spline, tolerance)?;
        meeting::check(self, &spans, spline.is_closed(), tolerance)?;
        sewn(&spans, spline.is_closed())
    }

    fn spans(&self, spline: &TorusSpline, tolerance: f64) -> Result<Vec<Span>> {
        let mut spans = Vec::new();
        for piece in 0..spline.piece_count() {
            self.append_spans(spline, piece, SAFETY * tolerance, &mut spans)?;
        }
        Ok(spans)
    }

    /// The first two of the seams along several splines, by their numbers, that share space by more than the tolerance, with a point that
    /// they share; where there is none, all are proved to be apart but for the tolerance.
    ///
    /// ```
    /// use cyclide::{Frame, construct::TorusSeam, surface::{Torus, TorusSpline}};
    /// let torus = Torus::new(Frame::WORLD, 40.0, 15.0)?;
    /// let rings = [[1, 0], [0, 1]].map(|turns| TorusSpline::knot(&torus, turns, Default::default()));
    /// let [round, across] = rings;
    /// let shared = TorusSeam::new(4.0, [-1.0, 0.5])?.first_meeting(&[round?, across?], 0.01)?;
    /// assert!(shared.is_some_and(|(seams, _)| seams == [0, 1]));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`body`](Self::body) of each.
    pub fn first_meeting(&self, splines: &[TorusSpline], tolerance: f64) -> Result<Option<([usize; 2], Point3)>> {
        check_tolerance(tolerance)?;
        let spans = splines.iter().map(|spline| self.spans(spline, tolerance)).collect::<Result<Vec<_>>>()?;
        let strips: Vec<Strip<'_>> = spans.iter().map(|spans| Strip::new(self, spans, tolerance)).collect();
        Ok(strips.iter().enumerate().find_map(|(second, strip)| {
            let meeting = |(first, other): (usize, &Strip<'_>)| {
                other.first_meeting(strip).map(|meeting| ([first, second], meeting.point))
            };
            strips[..second].iter().enumerate().find_map(meeting)
        }))
    }

    /// Appends the cubics of the corners over a piece, span by span.
    fn append_spans(&self, spline: &TorusSpline, piece: usize, limit: f64, spans: &mut Vec<Span>) -> Result<()> {
        let mut ahead = vec![([0.0, 1.0], HALVINGS)];
        while let Some(([from, to], halvings)) = ahead.pop() {
            let ends = [self.section(spline, piece, from)?, self.section(spline, piece, to)?];
            let span: [[Point3; 4]; 4] = std::array::from_fn(|corner| cubic(&ends, corner, to - from));
            if self.is_within(spline, piece, [from, to], &span, limit)? {
                spans.push(Span { piece, cubics: span });
                continue;
            }
            let Some(halvings) = halvings.checked_sub(1) else {
                let cap = 1_usize << HALVINGS;
                let (needed, remedy) = ((cap + 1) as f64, "use a larger tolerance");
                let error = NumberError::TooManyPieces { what: "piece", segment: Some(piece), needed, cap, remedy };
                return Err(Error::from(error).in_field("tolerance"));
            };
            let middle = 0.5 * (from + to);
            ahead.extend([([middle, to], halvings), ([from, middle], halvings)]);
        }
        Ok(())
    }

    fn is_within(
        &self,
        spline: &TorusSpline,
        piece: usize,
        [from, to]: [f64; 2],
        span: &[[Point3; 4]; 4],
        limit: f64,
    ) -> Result<bool> {
        for k in 1..PLACES {
            let x = f64::from(k) / f64::from(PLACES);
            let section = self.section(spline, piece, from + (to - from) * x)?;
            if (0..4).any(|corner| !(on_cubic(&span[corner], x).distance(section.corners[corner]) <= limit)) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Refuses a height or a width with which the seam folds at one of many places of the curve, with the limits within which it folds at none.
    fn check_width(&self, spline: &TorusSpline) -> Result<()> {
        let (a, b) = (spline.torus().major_radius(), spline.torus().minor_radius());
        let (mut narrowest, mut range): (Option<(f64, usize, Point3)>, _) = (None, [-b, a - b]);
        for piece in 0..spline.piece_count() {
            for k in 0..=2 * PLACES {
                let moving = Moving::at(spline, piece, f64::from(k) / f64::from(2 * PLACES))?;
                let limit = moving.widest(self.heights);
                if narrowest.is_none_or(|(least, ..)| limit < least) {
                    narrowest = Some((limit, piece, moving.point));
                }
                let [low, high] = moving.heights();
                range = [range[0].max(low), range[1].min(high)];
            }
        }
        if let Some(height) = self.heights.into_iter().find(|height| !(*height > range[0] && *height < range[1])) {
            return Err(out_of_range(ErrorItem::Height, height, range));
        }
        match narrowest {
            Some((limit, piece, point)) if !(self.width <= limit) => Err(self.too_wide(piece, point, limit)),
            _ => Ok(()),
        }
    }

    fn too_wide(&self, piece: usize, point: Point3, limit: f64) -> Error {
        Error::Torus(TorusError::SeamTooWide { piece, point: point.to_array(), width: self.width, limit })
    }

    /// The rectangle at a place of the curve.
    ///
    /// # Errors
    /// `zero-tangent`, `seam-too-wide`.
    fn section(&self, spline: &TorusSpline, piece: usize, s: f64) -> Result<Section> {
        let moving = Moving::at(spline, piece, s)?;
        let widest = moving.widest(self.heights);
        if self.width > widest {
            return Err(self.too_wide(piece, moving.point, widest));
        }
        let [low, high] = self.heights;
        let half = 0.5 * self.width;
        let places = [[-half, low], [half, low], [half, high], [-half, high]];
        let Moving { point, velocity, normal, normal_rate, across, across_rate, .. } = moving;
        Ok(Section {
            corners: places.map(|[side, height]| point + across * side + normal * height),
            derivatives: places.map(|[side, height]| velocity + across_rate * side + normal_rate * height),
        })
    }
}

fn out_of_range(name: ErrorItem, value: f64, [min, max]: [f64; 2]) -> Error {
    Error::Number(NumberError::ParameterOutOfRange { name, value, min, max })
}

/// The cubic of a corner between two sections, by a parameter of this length.
fn cubic([start, end]: &[Section; 2], corner: usize, length: f64) -> [Point3; 4] {
    let (p, q) = (start.corners[corner], end.corners[corner]);
    let third = length / 3.0;
    [p, p + start.derivatives[corner] * third, q + end.derivatives[corner] * -third, q]
}

fn on_cubic([a, b, c, d]: &[Point3; 4], x: f64) -> Point3 {
    let y = 1.0 - x;
    let weights = [y * y * y, 3.0 * y * y * x, 3.0 * y * x * x, x * x * x];
    let sum = [a, b, c, d].into_iter().zip(weights).fold(Vec3::ZERO, |sum, (p, w)| sum + p.to_vec() * w);
    Point3::ORIGIN + sum
}

fn row(p: Point3) -> [f64; 4] {
    [p.x, p.y, p.z, 1.0]
}

/// The body of the spans: four bands of faces ruled from corner to corner, and two plane ends if they do not close.
fn sewn(spans: &[Span], closed: bool) -> Result<Body> {
    let mut sewing = Sewing::default();
    let last = spans.last().filter(|_| !closed);
    let starts = spans.iter().map(|span| span.cubics.map(|cubic| cubic[0]));
    let rings = starts.chain(last.map(|span| span.cubics.map(|cubic| cubic[3])));
    let vertices: Vec<[usize; 4]> = rings.map(|corners| corners.map(|p| sewing.vertex(p))).collect();
    let across = vertices.iter().map(|ring| {
        let segments: [Result<usize>; 4] = std::array::from_fn(|k| sewing.segment(ring[k], ring[(k + 1) % 4]));
        let [a, b, c, d] = segments;
        Ok([a?, b?, c?, d?])
    });
    let across = across.collect::<Result<Vec<[usize; 4]>>>()?;
    for (i, span) in spans.iter().enumerate() {
        let next = (i + 1) % vertices.len();
        // Where a closed seam comes back its end is its start to the bit.
        let cubics: [[Point3; 4]; 4] = std::array::from_fn(|k| {
            let [_, b, c, _] = span.cubics[k];
            [sewing.vertices[vertices[i][k]], b, c, sewing.vertices[vertices[next][k]]]
        });
        let along = cubics.map(|cubic| RationalBezier::new(cubic.map(row).to_vec()));
        let [a, b, c, d] = along;
        let curves = [a?, b?, c?, d?];
        let mut edges = [0; 4];
        for (k, curve) in curves.into_iter().enumerate() {
            edges[k] = sewing.edge(vertices[i][k], vertices[next][k], curve);
        }
        for k in 0..4 {
            let beside = (k + 1) % 4;
            let rows = (0..4).flat_map(|j| [row(cubics[k][j]), row(cubics[beside][j])]).collect();
            let sides = [edges[k], edges[beside], across[i][k], across[next][k]].map(Some);
            sewing.face(RationalBezierSurface::new([3, 1], rows)?, sides, true);
        }
    }
    if let (false, Some(first), Some(end)) = (closed, vertices.first(), vertices.last()) {
        for (ring, edges, same_sense) in [(first, across[0], true), (end, across[across.len() - 1], false)] {
            let corners = ring.map(|vertex| row(sewing.vertices[vertex]));
            let surface = RationalBezierSurface::new([1, 1], vec![corners[0], corners[3], corners[1], corners[2]])?;
            let side = |edge: usize, forward: bool| Some(FaceEdge { edge, forward });
            let sides = [side(edges[0], true), side(edges[2], false), side(edges[3], false), side(edges[1], true)];
            sewing.face_along(surface, sides, same_sense);
        }
    }
    sewing.finish_body()
}
