//! Spherical cubes: eight points with the four corners of each face on a circle.
//!
//! Three circles through `a0` give seven points; the eighth follows (A. Miquel), and all eight are on a sphere (`001`, section 4;
//! `docs/math/volumes.md#spherical-cubes`). With `b_x = (a_x - a0)^-1`
//!
//! ```text
//! W = -(b12 (b1 - b2) + b23 (b2 - b3) + b13 (b3 - b1)),   N = b1 W - (b1 - b2)(b13 - b12)(b1 - b3),   a123 = a0 + W N^-1
//! ```
//!
//! It is also where the planes of the three circles through it meet, which keeps the digits of a grid of cubes; the formula serves where
//! these planes are nearly the same (`docs/math/volumes.md#rounding-of-the-last-corner`).

use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PointError, Result, VolumeError};
use crate::surface::on_corner_circle;

/// Twice the area of the triangle of the inverted corners below this part of its largest side squared: they are on a line.
const FLAT: f64 = 1e-12;

/// The planes of the three circles give the last corner where rounding of the seven others moves it by no more than so many times itself: of a
/// box by 3, and of others with this limit by less than the pair does, or hardly more.
const MAGNIFIED: f64 = 30.0;

/// The circles through the last corner, each by the three other corners of its face, the neighbor of the first one in front.
const LAST_CIRCLES: [[usize; 3]; 3] = [[1, 3, 5], [2, 3, 6], [4, 5, 6]];

/// The faces at the first corner, as corners in binary order, with the axis across.
const FIRST_FACES: [([usize; 4], usize); 3] = [([0, 1, 2, 3], 2), ([0, 1, 4, 5], 1), ([0, 2, 4, 6], 0)];

/// Eight points of which the four of each face are on a circle, binary order, first parameter fastest: `a0` (000), `a1` (100), `a2` (010),
/// `a12` (110), `a3` (001), `a13` (101), `a23` (011), `a123` (111).
///
/// ```
/// use cyclide::{Point3, volume::SphericalCube};
/// let corners = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let cube = SphericalCube::from_positions(corners, [9.0 / 13.0, 0.2, 0.1])?; // the cuboid of these sides
/// assert!(cube.corners()[7].distance(Point3::new(2.0, 3.0, 1.0)) < 1e-14 && cube.is_embedded());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphericalCube {
    corners: [Point3; 8],
    /// Largest distance from the first corner: the unit of the pairs.
    scale: f64,
    /// `b = (a - a0)^-1` of corners 1 to 6 of the [order](SphericalCube), in units of the scale; the first is unused.
    inverses: [Vec3; 7],
    /// The pair of the last corner: `a123 - a0 = W N^-1`.
    last: [Quat; 2],
}

impl SphericalCube {
    /// The cube of seven points in binary order; the eighth is [computed](miquel_point). The corners of the three faces at the first point must be concircular (or
    /// collinear) in cyclic order, to 1e-9 of the face and rounding; they are moved onto their circles.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `below-rounding-of-place`; `coincident-points`, `not-concircular`, `crossing-quad` with the face;
    /// `concircular-cube` (the first corner and its neighbors are on one circle: no eighth point is determined), `point-at-infinity`.
    pub fn new(points: [Point3; 7]) -> Result<Self> {
        for (index, p) in points.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        range::check_place(ErrorItem::Volume, &points)?;
        let [a0, a1, a2, _, a3, ..] = points;
        check_determined(&inverted(&[a0, a1, a2, a3])?.0)?;
        let mut seven = points;
        for (face, axis) in FIRST_FACES {
            let corner = on_corner_circle(&face.map(|k| points[k]));
            seven[face[3]] = corner.map_err(|e| e.in_face_of_volume(axis, 0))?;
        }
        Self::of_concircular(seven)
    }

    /// As [`new`](Self::new), with faces that are concircular as far as the points are known: of a grid, last corners of other cubes. None is moved.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `below-rounding-of-place`, `coincident-points`, `concircular-cube`, `point-at-infinity`.
    pub(super) fn of_computed(seven: [Point3; 7]) -> Result<Self> {
        range::check_place(ErrorItem::Volume, &seven)?;
        let [a0, a1, a2, _, a3, ..] = seven;
        check_determined(&inverted(&[a0, a1, a2, a3])?.0)?;
        Self::of_concircular(seven)
    }

    /// As [`new`](Self::new), with faces that are known to be concircular.
    fn of_concircular(seven: [Point3; 7]) -> Result<Self> {
        let scale = seven.iter().map(|p| p.distance(seven[0])).fold(0.0, f64::max);
        range::check_distance(scale)?;
        let inverse = |x: Vec3| x / -x.length_squared();
        let inverses =
            std::array::from_fn(|k| if k == 0 { Vec3::ZERO } else { inverse((seven[k] - seven[0]) / scale) });
        let [way, weight] = last_pair(&inverses);
        // A power of two, which rounds nothing: boxes along the axes stay exact.
        let unit = 2f64.powi(scale.log2() as i32);
        let (corner, last) = match on_planes(&seven.map(|p| (p - seven[0]) / unit)) {
            // The weight follows from the point: they belong together.
            Some(x) => (Some(x * unit), [way, Quat::from(inverse(x * (unit / scale))) * way]),
            None => (weight.inverse().map(|inverse| (way * inverse).vector() * scale), [way, weight]),
        };
        let corner = corner.filter(|way| way.max_abs() <= range::MAX_COORDINATE);
        let corner = seven[0] + corner.ok_or_else(|| Error::at_infinity(ErrorItem::Corner, 7))?;
        // A neighbor that it is on up to rounding is its place: sides of one point have the same corner twice, bit for bit.
        let (corner, last) = match neighbor_at(&seven, corner, scale) {
            Some(k) => (seven[k], [way, Quat::from(inverses[k]) * way]),
            None => (corner, last),
        };
        let corners = std::array::from_fn(|k| if k == 7 { corner } else { seven[k] });
        Ok(Self { corners, scale, inverses, last })
    }

    /// The cube of the first corner, its three neighbors and the positions of `a12`, `a13`, `a23` on their circles:
    /// `a_ij = a0 + ((1 - x) b_i + x b_j)^-1`. Faces at the first corner are embedded if these are between 0 and 1; whether all are is told by
    /// [`is_embedded`](Self::is_embedded).
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `coincident-points`, `concircular-cube`, `point-at-infinity`.
    pub fn from_positions(corners: [Point3; 4], positions: [f64; 3]) -> Result<Self> {
        if let Some(index) = positions.iter().position(|x| !x.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Position, index }.into());
        }
        let (b, scale) = inverted(&corners)?;
        let [x12, x13, x23] = positions;
        let on = |i: usize, j: usize, x: f64| b[i] * (1.0 - x) + b[j] * x;
        Self::of_inverted(corners, b, scale, [on(0, 1, x12), on(0, 2, x13), on(1, 2, x23)])
    }

    /// A cube all of whose faces are embedded: with the last corner at the barycentric coordinates `inside` (all positive, of any sum)
    /// of the triangle of the three neighbors of the first corner, seen from that by inversion, and the other three corners turned by `turn`, from
    /// 0 to 1, within the range in which they stay between their neighbors; 0.5 is its middle. The range is never empty.
    /// Squared lengths of perpendicular sides as `inside`, and 0.5, give their cuboid.
    ///
    /// # Errors
    /// As [`new`](Self::new), and `parameter-out-of-range` unless the coordinates are positive and the turn is from 0 to 1.
    pub fn from_barycentric(corners: [Point3; 4], inside: [f64; 3], turn: f64) -> Result<Self> {
        let sum: f64 = inside.iter().sum();
        for value in inside {
            if !(value > 0.0 && sum.is_finite()) {
                return Err(NumberError::ParameterOutOfRange {
                    name: ErrorItem::Position,
                    value,
                    min: 0.0,
                    max: f64::MAX,
                }
                .into());
            }
        }
        if !(0.0..=1.0).contains(&turn) {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Turn, value: turn, min: 0.0, max: 1.0 }.into()
            );
        }
        let (b, scale) = inverted(&corners)?;
        let weights = inside.map(|weight| weight / sum);
        // The way to the last point from a vertex: of a vertex near to it in a few steps of its own size.
        let way_from = |i: usize| (0..3).fold(Vec3::ZERO, |way, k| way + (b[k] - b[i]) * weights[k]);
        // From the foot of the last point on a side, the height times the tangent of one angle along the side: the corners on the three
        // sides and the last one are then concircular with the vertices. Counted from the shorter end, which keeps its digits.
        let side = |(i, j): (usize, usize)| {
            let is_first = b[i].length_squared() <= b[j].length_squared();
            let (from, to) = if is_first { (i, j) } else { (j, i) };
            let (way, length) = (b[to] - b[from], (b[to] - b[from]).length());
            let foot = way_from(from).dot(way) / (length * length);
            let height = (way_from(from) - way * foot).length() / length;
            (is_first, b[from], way, foot, height)
        };
        // Cyclic sides 12, 23, 31.
        let sides = [(0, 1), (1, 2), (2, 0)].map(side);
        let bounds = sides.map(|(is_first, _, _, foot, height)| {
            let [low, high] = if is_first { [-foot, 1.0 - foot] } else { [foot - 1.0, foot] };
            [(low / height).atan(), (high / height).atan()]
        });
        let low = bounds.iter().map(|b| b[0]).fold(f64::NEG_INFINITY, f64::max);
        let high = bounds.iter().map(|b| b[1]).fold(f64::INFINITY, f64::min);
        let tangent = (low + (high - low) * (0.5 + (turn - 0.5) * INSIDE)).tan();
        let [b12, b23, b13] = sides.map(|(is_first, from, way, foot, height)| {
            from + way * (if is_first { foot + height * tangent } else { foot - height * tangent })
        });
        Self::of_inverted(corners, b, scale, [b12, b13, b23])
    }

    /// The cuboid with a corner at `origin` and these three sides, perpendicular to each other.
    ///
    /// # Errors
    /// As [`new`](Self::new): sides that are not perpendicular give faces whose corners are `not-concircular`.
    pub fn cuboid(origin: Point3, [s, t, u]: [Vec3; 3]) -> Result<Self> {
        Self::new([origin, origin + s, origin + t, origin + s + t, origin + u, origin + s + u, origin + t + u])
    }

    /// The cube of three more corners, given inverted.
    fn of_inverted(corners: [Point3; 4], b: [Vec3; 3], scale: f64, [b12, b13, b23]: [Vec3; 3]) -> Result<Self> {
        check_determined(&b)?;
        let [a0, a1, a2, a3] = corners;
        let largest = b.iter().map(|b| b.length()).fold(0.0, f64::max);
        let back = |corner: usize, b: Vec3| {
            let out = b.length() <= f64::EPSILON * largest;
            let p = a0 + b * (-scale / b.length_squared());
            if out || !(p.to_vec().max_abs() <= range::MAX_COORDINATE) {
                return Err(Error::at_infinity(ErrorItem::Corner, corner));
            }
            Ok(p)
        };
        let seven = [a0, a1, a2, back(3, b12)?, a3, back(5, b13)?, back(6, b23)?];
        range::check_place(ErrorItem::Volume, &seven)?;
        Self::of_concircular(seven)
    }

    /// The eight corners, binary order.
    #[must_use]
    pub fn corners(&self) -> [Point3; 8] {
        self.corners
    }

    /// True if no face crosses itself: inverted at the first corner, the corners opposite to it in its faces are between their neighbors,
    /// and the last one is inside the triangle of these, up to rounding.
    #[must_use]
    pub fn is_embedded(&self) -> bool {
        let [_, b1, b2, b12, b3, b13, b23] = self.inverses;
        let between = |p: Vec3, q: Vec3, b: Vec3| (b - p).dot(q - p) > 0.0 && (b - q).dot(p - q) > 0.0;
        if !(between(b1, b2, b12) && between(b1, b3, b13) && between(b2, b3, b23)) {
            return false;
        }
        let [way, weight] = self.last;
        let Some(b) = way.inverse().map(|inverse| (weight * inverse).vector()) else { return false };
        let normal = (b2 - b1).cross(b3 - b1);
        let area = normal.length_squared();
        [(b1, b2), (b2, b3), (b3, b1)].iter().all(|(p, q)| (*q - *p).cross(b - *p).dot(normal) > ROUNDING * area)
    }

    /// The unit of the pairs: the largest distance of one of the first seven corners from the first.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }

    /// `b` of the corners 1 to 6 (the first entry is unused), and the pair of the last.
    pub(super) fn inverted(&self) -> (&[Vec3; 7], [Quat; 2]) {
        (&self.inverses, self.last)
    }
}

/// Barycentric coordinates that are zero up to this are those of an edge.
const ROUNDING: f64 = 1e-12;
/// Points closer than this part of the largest distance coincide.
const COINCIDENT: f64 = 1e-12;
/// The same beside a side of one point: what the corners of a face may be off their circle.
const BESIDE_POINT: f64 = 1e-9;
/// Rounding of the last corner beside that, relative to the largest coordinate.
const POINT_ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Share of the range of turns that is used: at its ends a corner would fall onto its neighbor.
const INSIDE: f64 = 0.98;

/// `(a_i - a0)^-1` of the neighbors of the first corner, and the unit they are in.
///
/// # Errors
/// `not-finite`, `parameter-out-of-range`, `coincident-points`.
fn inverted(corners: &[Point3; 4]) -> Result<([Vec3; 3], f64)> {
    for (index, p) in corners.iter().enumerate() {
        range::check_point(index, p.to_vec())?;
    }
    let scale = corners.iter().map(|p| p.distance(corners[0])).fold(0.0, f64::max);
    range::check_distance(scale)?;
    for (second, p) in corners.iter().enumerate().skip(1) {
        let (distance, limit) = (p.distance(corners[0]), COINCIDENT * scale);
        if distance <= limit {
            return Err(PointError::CoincidentPoints { first: 0, second, distance, limit }.into());
        }
    }
    let inverse = |k: usize| {
        let x = (corners[k] - corners[0]) / scale;
        x / -x.length_squared()
    };
    Ok(([inverse(1), inverse(2), inverse(3)], scale))
}

/// The eighth point of a cube of seven points in binary order, as of [`SphericalCube::new`].
///
/// ```
/// use cyclide::{Point3, volume::miquel_point};
/// let seven = [[0., 0., 0.], [2., 0., 0.], [0., 3., 0.], [2., 3., 0.], [0., 0., 1.], [2., 0., 1.], [0., 3., 1.]];
/// // To the roundings of 3 by which corners are moved onto their circles.
/// assert!(miquel_point(seven.map(Point3::from))?.distance(Point3::new(2.0, 3.0, 1.0)) < 3e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// As [`SphericalCube::new`].
pub fn miquel_point(points: [Point3; 7]) -> Result<Point3> {
    SphericalCube::new(points).map(|cube| cube.corners[7])
}

/// Refuses neighbors of the first corner that are, inverted there, on a line: no sphere is theirs alone.
///
/// # Errors
/// `concircular-cube`.
fn check_determined([b1, b2, b3]: &[Vec3; 3]) -> Result<()> {
    let sides = [*b1 - *b2, *b2 - *b3, *b3 - *b1];
    let measured = sides[0].cross(sides[1]).length();
    let limit = FLAT * sides.iter().map(|side| side.length_squared()).fold(0.0, f64::max);
    if measured > limit { Ok(()) } else { Err(VolumeError::ConcircularCube { measured, limit }.into()) }
}

/// `W` and `N` of the module's formula: `|W|` is at least twice the area of the triangle of the neighbors. The corners may change places in
/// cyclic order, which changes neither: the farthest neighbor in the place of the first loses no digits of thin cubes.
fn last_pair(b: &[Vec3; 7]) -> [Quat; 2] {
    let [_, b1, b2, b12, b3, b13, b23] = *b;
    let q = Quat::from;
    let w = -(q(b12) * q(b1 - b2) + q(b23) * q(b2 - b3) + q(b13) * q(b3 - b1));
    let orders = [[b1, b2, b3, b12, b13], [b2, b3, b1, b23, b12], [b3, b1, b2, b13, b23]];
    let farthest = orders.into_iter().min_by(|x, y| x[0].length_squared().total_cmp(&y[0].length_squared()));
    let [b1, b2, b3, b12, b13] = farthest.unwrap_or(orders[0]);
    [w, q(b1) * w - q(b1 - b2) * q(b13 - b12) * q(b1 - b3)]
}

/// The neighbor that the last corner is on, up to rounding; where a side in the same direction is one point already, as at the axis of a wedge, within
/// what the faces that are given may be off their circles.
fn neighbor_at(seven: &[Point3; 7], last: Point3, scale: f64) -> Option<usize> {
    let place = seven.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    let is_point =
        |axis: usize| (1..7).any(|k| k >> axis & 1 == 0 && k != 7 ^ 1 << axis && seven[k] == seven[k | 1 << axis]);
    (0..3).map(|axis| (7 ^ 1 << axis, is_point(axis))).find_map(|(k, beside)| {
        let limit = if beside { BESIDE_POINT } else { COINCIDENT } * scale + POINT_ROUNDING * place;
        (seven[k].distance(last) <= limit).then_some(k)
    })
}

/// The last corner as the common point of the planes of its [circles](LAST_CIRCLES), from the ways of the seven others from the first; none where
/// they are too near to each other, or the three points of one too near to a line ([`MAGNIFIED`]).
fn on_planes(ways: &[Vec3; 7]) -> Option<Vec3> {
    let circles = LAST_CIRCLES.map(|circle| circle.map(|k| ways[k]));
    let mut normals = [Vec3::ZERO; 3];
    for (normal, [p, q, r]) in normals.iter_mut().zip(circles) {
        *normal = (q - p).cross(r - p).unit()?;
    }
    let [n1, n2, n3] = normals;
    let volume = n1.dot(n2.cross(n3));
    // Of a parallelepiped the place: heights are small from there.
    let place = ways[3] + ways[5] - ways[1];
    let height = |k: usize| normals[k].dot(circles[k][0] - place);
    let x = place + (n2.cross(n3) * height(0) + n3.cross(n1) * height(1) + n1.cross(n2) * height(2)) / volume;
    // Barycentric coordinates in the three points of each plane: what their heights are multiplied with.
    let magnified = |[p, q, r]: [Vec3; 3]| {
        let (along, across, way) = (q - p, r - p, x - p);
        let normal = along.cross(across);
        let (l, m) = (way.cross(across).dot(normal), along.cross(way).dot(normal));
        let whole = normal.length_squared();
        ((whole - l - m).abs() + l.abs() + m.abs()) / whole
    };
    let is_good = |circle: [Vec3; 3]| magnified(circle) <= MAGNIFIED * volume.abs();
    (circles.into_iter().all(is_good) && x.length_squared() > 0.0).then_some(x)
}
