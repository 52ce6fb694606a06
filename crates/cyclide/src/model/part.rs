//! Curves of any kind run backwards and cut, exactly: by parameter, or by station.

use super::object::CurveObject;
use crate::base::cut::at_end;
use crate::curve::ArcLength;
use crate::error::{Error, ErrorItem, NumberError, Result};

/// Part of the length within which a station is that of a joint: stations are measured to that.
const AT_JOINT: f64 = 1e-12;

impl CurveObject {
    /// The same points run backwards; a closed curve still starts at the same point.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, curve::Circle, model::CurveObject};
    /// let circle = CurveObject::from(Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?);
    /// assert!(circle.reversed().as_curve().point(0.25).distance(circle.as_curve().point(0.75)) < 1e-15);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Arc(c) => Self::Arc(c.reversed()),
            Self::Circle(c) => Self::Circle(c.reversed()),
            Self::ArcPath(c) => Self::ArcPath(c.reversed()),
            Self::CircleSpline(c) => Self::CircleSpline(c.reversed()),
            Self::TorusSpline(c) => Self::TorusSpline(c.reversed()),
            Self::Nurbs(c) => Self::Nurbs(c.reversed()),
            Self::QbSpline(c) => Self::QbSpline(c.reversed()),
        }
    }

    /// The part from one global parameter to another, both in `[0, 1]`, as an open curve of the same points and kind (of a circle an arc).
    /// Of a closed curve the first may be the larger one: then the part leads past the start.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, curve::{Circle, length}, model::CurveObject};
    /// let circle = CurveObject::from(Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?);
    /// let (short, long) = (circle.restricted(0.25, 0.5)?, circle.restricted(0.5, 0.25)?);
    /// assert!((length(short.as_curve()) - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
    /// assert!((length(long.as_curve()) - 1.5 * std::f64::consts::PI).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `parameter-out-of-range`; `sweep-out-of-range` (the whole of a circle).
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Self> {
        let [t0, t1] = [t0, t1].map(at_end);
        if !(t1 < t0 && t1 >= 0.0 && t0 <= 1.0 && self.as_curve().is_closed()) {
            return self.inside(t0, t1);
        }
        // The end of a closed curve is its start.
        match (t0 < 1.0, t1 > 0.0) {
            (true, true) => self.past_start(t0, t1),
            (true, false) => self.inside(t0, 1.0),
            (false, _) => self.inside(0.0, t1),
        }
    }

    fn inside(&self, t0: f64, t1: f64) -> Result<Self> {
        match self {
            Self::Arc(c) => c.restricted(t0, t1).map(Self::Arc),
            Self::Circle(c) => c.restricted(t0, t1).map(Self::Arc),
            Self::ArcPath(c) => c.restricted(t0, t1).map(Self::ArcPath),
            Self::CircleSpline(c) => c.restricted(t0, t1).map(Self::CircleSpline),
            Self::TorusSpline(c) => c.restricted(t0, t1).map(Self::TorusSpline),
            Self::Nurbs(c) => c.restricted(t0, t1).map(Self::Nurbs),
            Self::QbSpline(c) => c.restricted(t0, t1).map(Self::QbSpline),
        }
    }

    fn past_start(&self, t0: f64, t1: f64) -> Result<Self> {
        match self {
            // It is never closed: refused as every other open curve.
            Self::Arc(c) => c.restricted(t0, t1).map(Self::Arc),
            Self::Circle(c) => c.restricted_past_start(t0, t1).map(Self::Arc),
            Self::ArcPath(c) => c.restricted_past_start(t0, t1).map(Self::ArcPath),
            Self::CircleSpline(c) => c.restricted_past_start(t0, t1).map(Self::CircleSpline),
            Self::TorusSpline(c) => c.restricted_past_start(t0, t1).map(Self::TorusSpline),
            Self::Nurbs(c) => c.restricted_past_start(t0, t1).map(Self::Nurbs),
            Self::QbSpline(c) => c.restricted_past_start(t0, t1).map(Self::QbSpline),
        }
    }

    /// The part from one station (arc length from the start) to another: see [`restricted`](Self::restricted). Ends are at their stations to
    /// about 1e-12 of the length; stations that near to a joint are the joint, and the curve is not cut beside it.
    ///
    /// ```
    /// use cyclide::{Point3, curve::{ArcPath, length}, model::CurveObject};
    /// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
    /// let path = CurveObject::from(ArcPath::rounded_polyline(&corner, false, &[0.0; 3])?);
    /// let part = path.restricted_to_stations(3.0, 6.0)?;
    /// assert_eq!((part.as_curve().point(0.5), part.as_curve().point(1.0)), (corner[1], Point3::new(4.0, 2.0, 0.0)));
    /// assert!((length(part.as_curve()) - 3.0).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `parameter-out-of-range` (`station`), and as [`restricted`](Self::restricted).
    pub fn restricted_to_stations(&self, from: f64, to: f64) -> Result<Self> {
        let curve = self.as_curve();
        let lengths = ArcLength::new(curve);
        let (total, pieces) = (lengths.total(), curve.piece_count() as f64);
        let limit = AT_JOINT * total;
        let parameter = |station: f64| {
            if !(station >= -limit && station <= total + limit) {
                return Err(Error::Number(NumberError::ParameterOutOfRange {
                    name: ErrorItem::Station,
                    value: station,
                    min: 0.0,
                    max: total,
                }));
            }
            let t = lengths.parameter_at(station / total);
            let joint = (t * pieces).round() / pieces;
            Ok(if (lengths.station(joint) - station).abs() <= limit { joint } else { t })
        };
        let [t0, t1] = [parameter(from)?, parameter(to)?];
        let none = Error::Number(NumberError::ParameterOutOfRange {
            name: ErrorItem::Station,
            value: to,
            min: from.max(0.0),
            max: total,
        });
        if !(t0 < t1 || (t0 > t1 && curve.is_closed())) {
            return Err(none);
        }
        self.restricted(t0, t1).map_err(|error| match error {
            Error::Number(NumberError::ParameterOutOfRange { .. }) => none,
            other => other,
        })
    }
}
