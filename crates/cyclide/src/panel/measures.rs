//! Sides, area, turn, bends and size of a panel.

use crate::base::frame::Frame;
use crate::base::golden_section::GoldenSection;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;
use crate::error::Result;
use crate::surface::CyclidePatch;
use crate::topology::{Shell, Side};

/// Sides that depart from their chords by this part of the size of the panel are straight.
const STRAIGHT: f64 = 1e-12;
/// The same by the rounding of coordinates.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Directions of boxes round a quarter turn, and sections of the angle between them.
const DIRECTIONS: u32 = 12;
const SECTIONS: u32 = 16;

/// What a side of a panel is.
///
/// ```
/// let patch = cyclide::surface::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// let sides = cyclide::panel::PanelMeasures::new(&patch)?.sides;
/// assert!(sides.iter().all(|side| side.form == cyclide::panel::PanelSideForm::Arc));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PanelSideForm {
    /// The side is one point: the panel is a triangle.
    Point,
    /// A straight segment: it departs from its chord by 1e-12 of the size of the panel at most, or by the rounding of
    /// its coordinates.
    Straight,
    /// A circular arc.
    Arc,
}

/// One side of a panel: an arc, a segment or a point.
///
/// ```
/// use cyclide::{panel::{PanelMeasures, PanelSideForm}, surface::DupinCyclide};
/// let patch = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?[0].patch(0, 0);
/// let sides = PanelMeasures::new(&patch)?.sides;
/// assert!(sides.iter().all(|side| side.form == PanelSideForm::Arc));
/// assert!(sides.iter().all(|side| (side.sweep - std::f64::consts::FRAC_PI_2).abs() < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PanelSide {
    /// Which one.
    pub side: Side,
    /// What it is.
    pub form: PanelSideForm,
    /// The curve, with the parameter of the patch.
    pub arc: Arc,
    /// Length along it.
    pub length: f64,
    /// Distance between its ends.
    pub chord: f64,
    /// Angle swept, radians; 0 if it is straight.
    pub sweep: f64,
    /// Radius; none if it is straight or one point.
    pub radius: Option<f64>,
    /// Center of its circle.
    pub center: Option<Point3>,
    /// Unit normal of its plane, about which it turns right-handed with the growing parameter.
    pub normal: Option<Vec3>,
}

/// A largest or smallest principal curvature of a panel, with a place.
///
/// ```
/// let patch = cyclide::surface::DupinCyclide::new(3.0, 0.0, 1.0)?.nets([8, 8])?[0].patch(0, 0);
/// // The tube bends most, by 1 against the outward normal.
/// let [least, _] = cyclide::panel::PanelMeasures::new(&patch)?.curvatures;
/// assert!((least.value + 1.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvatureExtreme {
    /// Against [`CyclidePatch::unit_normal`]: positive where the center is on the side of the normal. Infinite at a
    /// parameter line that is one point.
    pub value: f64,
    /// A place where it is; it is the same along the whole line of `direction`.
    pub place: (f64, f64),
    /// 0 if it is the curvature of s-lines, constant along each of them; 1 for t-lines.
    pub direction: usize,
}

/// What a panel is made after.
///
/// ```
/// use cyclide::{Point3, Vec3, panel::PanelMeasures, surface::CyclidePatch};
/// let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [2.0, 1.0, 0.0]].map(Point3::from);
/// let sheet = PanelMeasures::new(&CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y)?)?;
/// assert!((sheet.area - 2.0).abs() < 1e-14 && sheet.sagitta < 1e-15 && sheet.turn < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PanelMeasures {
    /// Corners `a0, a1, a2, a3` at (0,0), (1,0), (0,1), (1,1).
    pub corners: [Point3; 4],
    /// The sides, by the index of [`Side`].
    pub sides: [PanelSide; 4],
    /// Area, to about 1e-12 of itself.
    pub area: f64,
    /// Distance of the last corner from the plane of the other three: rounding, as the corners of a patch are on one
    /// circle. A panel of four corners that are not is no patch.
    pub corner_lift: f64,
    /// The larger of the angles between the unit normals at opposite corners, radians. As along each side the frame
    /// moves by a reflection, a panel has no twist of the kind that support structures must not have: the normals at
    /// both ends of a side are in one plane. What turns is the normal, across the panel.
    pub turn: f64,
    /// Smallest and largest principal curvature over the panel, of both families of lines.
    pub curvatures: [CurvatureExtreme; 2],
    /// Largest distance of the panel from the plane of its corners.
    pub sagitta: f64,
    /// Length, width and height of the box that holds the panel, with its base parallel to the plane of the corners, whose
    /// base is least: within a thousandth of the least of all. Length is the larger of the first two.
    pub size: [f64; 3],
}

impl PanelMeasures {
    /// The measures of a patch.
    ///
    /// # Errors
    /// `too-many-pieces` if the area cannot be found to a millionth (corners near infinity); what
    /// [`s_line`](CyclidePatch::s_line) says of sides beyond the range of numbers.
    pub fn new(patch: &CyclidePatch) -> Result<Self> {
        let corners = patch.corners();
        let lines = [patch.s_line(0.0)?, patch.s_line(1.0)?, patch.t_line(0.0)?, patch.t_line(1.0)?];
        let limit = (STRAIGHT * patch.size()).max(ROUNDING * corners.map(|p| p.to_vec().max_abs())[0]);
        let sides = Side::ALL.map(|side| PanelSide::new(side, lines[side as usize], limit));
        let normal = |(s, t): (f64, f64)| patch.unit_normal(s, t);
        let turns = [[(0.0, 0.0), (1.0, 1.0)], [(1.0, 0.0), (0.0, 1.0)]];
        let plane = corner_normal(&corners);
        let (sagitta, size) = blank(patch, plane);
        Ok(Self {
            corners,
            sides,
            area: Shell::from_surface(*patch)?.known_area()?,
            corner_lift: (corners[3] - corners[0]).dot(plane).abs(),
            turn: turns.map(|[a, b]| normal(a).angle(normal(b))).into_iter().fold(0.0, f64::max),
            curvatures: curvatures(patch),
            sagitta,
            size,
        })
    }
}

impl PanelSide {
    fn new(side: Side, arc: Arc, limit: f64) -> Self {
        let chord = arc.chord().length();
        let bulge = 0.5 * chord * (0.25 * arc.angle()).tan();
        let form = if chord <= 0.0 {
            PanelSideForm::Point
        } else if bulge <= limit {
            PanelSideForm::Straight
        } else {
            PanelSideForm::Arc
        };
        let curved = form == PanelSideForm::Arc;
        Self {
            side,
            form,
            arc,
            length: arc.length(),
            chord,
            sweep: if curved { arc.angle() } else { 0.0 },
            radius: arc.radius().filter(|_| curved),
            center: arc.center().filter(|_| curved),
            normal: arc.normal().filter(|_| curved),
        }
    }
}

/// Smallest and largest principal curvature.
fn curvatures(patch: &CyclidePatch) -> [CurvatureExtreme; 2] {
    let of = |direction: usize| {
        move |(value, at): (f64, f64)| CurvatureExtreme {
            value,
            place: if direction == 0 { (0.5, at) } else { (at, 0.5) },
            direction,
        }
    };
    let ([a, b], [c, d]) = (patch.k1_extremes().map(of(0)), patch.k2_extremes().map(of(1)));
    [if c.value < a.value { c } else { a }, if d.value > b.value { d } else { b }]
}

/// Unit normal of the plane of the corners.
fn corner_normal([a, b, c, d]: &[Point3; 4]) -> Vec3 {
    // Of the triangles without one corner, that of the largest area: two corners may be one.
    let crosses =
        [(*b - *a).cross(*c - *a), (*b - *a).cross(*d - *a), (*d - *a).cross(*c - *a), (*b - *d).cross(*c - *d)];
    let largest = crosses.into_iter().fold(Vec3::ZERO, |best, v| if v.length() > best.length() { v } else { best });
    largest.unit().unwrap_or(Vec3::Z)
}

/// The largest distance from the plane of the corners, and the sizes of the least box on it, from boxes of the patch
/// turned into place, which are exact: of those along sides, diagonals and evenly round, and of angles towards the least base from the best of these.
fn blank(patch: &CyclidePatch, plane: Vec3) -> (f64, [f64; 3]) {
    let corners = patch.corners();
    let pairs = [(0, 1), (2, 3), (0, 2), (1, 3), (0, 3), (1, 2)];
    let chords: Vec<Vec3> = pairs.iter().filter_map(|&(i, j)| (corners[j] - corners[i]).unit()).collect();
    let Some(&x) = chords.first() else { return (0.0, [0.0; 3]) };
    let y = plane.cross(x);
    let extent = |angle: f64| {
        let frame = Frame::from_normal(corners[0], plane, x * angle.cos() + y * angle.sin()).ok()?;
        let turn = frame.rotation().conj();
        let placed = corners.map(|p| Point3::ORIGIN + turn.rotate(p - corners[0]));
        let [v1, v2, _] = patch.frame();
        let placed = CyclidePatch::from_weights_unchecked(placed, patch.weights().map(|w| turn * w), v1, v2);
        let bounds = placed.bounds();
        let extent = bounds.max - bounds.min;
        Some((bounds.max.z.abs().max(bounds.min.z.abs()), [extent.x.max(extent.y), extent.x.min(extent.y), extent.z]))
    };
    let base = |angle: f64| extent(angle).map_or(f64::INFINITY, |(_, size)| size[0] * size[1]);
    let step = std::f64::consts::FRAC_PI_2 / f64::from(DIRECTIONS);
    let along = chords.iter().map(|chord| chord.dot(y).atan2(chord.dot(x)));
    let round = (0..DIRECTIONS).map(|k| (f64::from(k) + 0.5) * step);
    let best = along.chain(round).map(|angle| (angle, base(angle)));
    let Some(best) = best.min_by(|a, b| a.1.total_cmp(&b.1)) else { return (0.0, [0.0; 3]) };
    let turned = GoldenSection::lowest(base, [best.0 - step, best.0 + step], SECTIONS);
    let angle = if base(turned) < best.1 { turned } else { best.0 };
    extent(angle).unwrap_or((0.0, [0.0; 3]))
}
