//! The elements that are integrated over faces: of area, and of the flux that the volume is; and what of an integral is rounding of the surface.

use super::{Cell, FaceSurface};
use crate::base::vector::Vec3;
use crate::rational::{FirstJets, RationalBezierSurface};
use crate::surface::CyclidePatch;

/// Rounding of an evaluation, in parts of the last digit of coordinates from the corner of the face: what two rules disagree by on a face far longer than wide,
/// whose width is a difference of such coordinates. It is not quartered away.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// What is integrated over faces. What a line along t needs is made once for all its places.
pub(super) trait Element {
    /// The element along the line at `s`, as a function of t.
    fn along(&self, face: usize, s: f64) -> impl Fn(f64) -> f64;

    /// What of the integral over a cell is rounding of the surface.
    fn rounding(&self, face: usize, cell: Cell) -> f64;
}

/// The element of area.
pub(super) struct AreaElement<'a>(pub(super) Vec<Local<'a>>);

impl Element for AreaElement<'_> {
    fn along(&self, face: usize, s: f64) -> impl Fn(f64) -> f64 {
        let line = self.0[face].line(s);
        move |t| line.area(t)
    }

    fn rounding(&self, face: usize, cell: Cell) -> f64 {
        self.0[face].rounding(cell).map_or(0.0, |Rounding { element, .. }| element)
    }
}

/// The element of the flux of a field, with the way of the first corner of each face from the tip, and the sign of its side.
pub(super) struct FluxElement<'a> {
    pub(super) faces: Vec<(Local<'a>, Vec3, f64)>,
    pub(super) field: [Vec3; 3],
}

impl Element for FluxElement<'_> {
    fn along(&self, face: usize, s: f64) -> impl Fn(f64) -> f64 {
        let (local, corner, sign) = &self.faces[face];
        let line = local.line(s);
        move |t| {
            let (way, across) = line.way_and_cross(t);
            let way = way + *corner;
            let [x, y, z] = self.field.map(|row| row.dot(way));
            sign * Vec3::new(x, y, z).dot(across)
        }
    }

    fn rounding(&self, face: usize, cell: Cell) -> f64 {
        let (local, corner, _) = &self.faces[face];
        let Some(Rounding { element, way, area }) = local.rounding(cell) else { return 0.0 };
        let way = way + *corner;
        let [x, y, z] = self.field.map(|row| row.dot(way));
        let stretch = self.field.iter().map(|row| row.length_squared()).sum::<f64>().sqrt();
        Vec3::new(x, y, z).length() * element + ROUNDING * stretch * way.length() * area
    }
}

/// The surface of a face made ready for many evaluations: a rational one with coordinates from its first corner, where they keep
/// their digits.
pub(super) enum Local<'a> {
    Cyclide(&'a CyclidePatch),
    /// With the largest distance of a control point from there.
    Rational(RationalBezierSurface, f64),
}

/// What is rounding over a cell: of the element of area, integrated; with the way of its middle from the corner of the face, and its area, nearly.
struct Rounding {
    element: f64,
    way: Vec3,
    area: f64,
}

impl<'a> Local<'a> {
    pub(super) fn of(surface: &'a FaceSurface) -> Self {
        match surface {
            FaceSurface::Cyclide(patch) => Self::Cyclide(patch),
            FaceSurface::Rational(surface) => {
                let local = surface.seen_from(surface.corners()[0]);
                let reach = local.rows().iter().map(|[x, y, z, w]| Vec3::new(*x, *y, *z).length() / w.abs());
                let reach = reach.fold(0.0, f64::max);
                Self::Rational(local, reach)
            }
        }
    }

    /// Rounding of both derivatives, each that of coordinates; none of patches, which have their element in closed form.
    fn rounding(&self, [[s0, s1], [t0, t1]]: Cell) -> Option<Rounding> {
        let Self::Rational(surface, reach) = self else { return None };
        let [way, ds, dt] = surface.first_jets_along(0.5 * (s0 + s1)).at(0.5 * (t0 + t1));
        let size = (s1 - s0) * (t1 - t0);
        let element = ROUNDING * reach * (ds.length() + dt.length()) * size;
        Some(Rounding { element, way, area: ds.cross(dt).length() * size })
    }

    /// Its line along t at `s`.
    fn line(&self, s: f64) -> LocalLine<'_> {
        match self {
            Self::Cyclide(patch) => LocalLine::Cyclide(patch, s),
            Self::Rational(surface, _) => LocalLine::Rational(surface.first_jets_along(s)),
        }
    }
}

/// A line along t of a face.
enum LocalLine<'a> {
    Cyclide(&'a CyclidePatch, f64),
    Rational(FirstJets),
}

impl LocalLine<'_> {
    /// The element of area.
    fn area(&self, t: f64) -> f64 {
        match self {
            Self::Cyclide(patch, s) => patch.element(*s, t).abs(),
            Self::Rational(_) => self.way_and_cross(t).1.length(),
        }
    }

    /// The way from the first corner, and `f_s × f_t` along the side of the unit normal.
    fn way_and_cross(&self, t: f64) -> (Vec3, Vec3) {
        match self {
            Self::Cyclide(patch, s) => {
                (patch.way_from_first_corner(*s, t), patch.unit_normal(*s, t) * patch.element(*s, t))
            }
            Self::Rational(line) => {
                let [way, ds, dt] = line.at(t);
                (way, ds.cross(dt))
            }
        }
    }
}
