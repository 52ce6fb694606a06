//! Places that are tighter than a radius asked for.

use cyclide::{ShortNumber, curve::tight_places, model::CurveObject};
use serde::Serialize;

use super::warning::WarningReport;
use crate::document::BuiltObject;

/// The reason of warnings about parts of curves that are tighter than a given radius.
///
/// ```
/// assert_eq!(cyclide_io::report::TIGHTER_THAN_RADIUS, "tighter-than-radius");
/// ```
pub const TIGHTER_THAN_RADIUS: &str = "tighter-than-radius";

/// A part of a curve that is tighter than a given radius, with its tightest point.
///
/// ```
/// use cyclide_io::{Document, Report, report::GeometryReport};
/// let text = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [9, 0], [9, 9]], "radius": 2}}}"#;
/// let document: Document = text.parse()?;
/// let built = document.build()?;
/// let report = Report::new(document.units, &built, None).with_min_radius(&built, 3.0)?;
/// let GeometryReport::Curves(found) = &report.objects["p"].geometry else { unreachable!("by its type") };
/// let place = &found.tight.as_ref().expect("it was asked for").places[0];
/// assert!((place.radius - 2.0).abs() < 1e-12 && (place.from - 7.0).abs() < 1e-12);
/// assert_eq!(report.objects["p"].warnings[0].reason, "tighter-than-radius");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TightPlaceReport {
    /// Smallest radius of curvature of the part; 0 at a corner.
    pub radius: f64,
    /// Station of the tightest point: arc length from the start of the contour.
    pub station: f64,
    /// The point.
    pub point: [f64; 3],
    /// Its global parameter.
    pub t: f64,
    /// The contour, from 0.
    pub contour: usize,
    /// Station where the part begins; on a closed contour larger than `to` if the part contains the start.
    pub from: f64,
    /// Station where it ends.
    pub to: f64,
}

/// The parts of the curves of an object that are tighter than a radius.
///
/// ```
/// use cyclide_io::{Document, Report, report::GeometryReport};
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// let report = Report::new(document.units, &built, None).with_min_radius(&built, 1.0)?;
/// let GeometryReport::Curves(found) = &report.objects["c"].geometry else { unreachable!("by its type") };
/// assert!(found.tight.as_ref().is_some_and(|tight| tight.places.is_empty() && tight.radius == 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TightReport {
    /// The given radius.
    pub radius: f64,
    /// The parts, along each contour.
    pub places: Vec<TightPlaceReport>,
}

impl TightReport {
    /// Looks along the curves of an object.
    pub(super) fn new(built: &BuiltObject, radius: f64) -> cyclide::Result<Self> {
        let mut places = Vec::new();
        for (contour, curve) in built.item.curves().iter().map(CurveObject::as_curve).enumerate() {
            places.extend(tight_places(curve, radius)?.into_iter().map(|place| TightPlaceReport {
                radius: place.radius,
                station: place.station,
                point: place.point.to_array(),
                t: place.t,
                contour,
                from: place.from,
                to: place.to,
            }));
        }
        Ok(Self { radius, places })
    }

    /// A warning for each place.
    pub(super) fn warnings(&self, several: bool, units: &str) -> Vec<WarningReport> {
        let warning = |place: &TightPlaceReport| WarningReport {
            reason: TIGHTER_THAN_RADIUS,
            message: format!("{}, tighter than {} {units}", place.words(units), ShortNumber(self.radius)),
            contour: several.then_some(place.contour),
            index: None,
            place: None,
        };
        self.places.iter().map(warning).collect()
    }
}

impl TightPlaceReport {
    /// Radius and place.
    pub(super) fn words(&self, units: &str) -> String {
        let point = self.point.map(|v| ShortNumber(v).to_string()).join(", ");
        let [radius, station, from, to] = [self.radius, self.station, self.from, self.to].map(ShortNumber);
        if self.radius == 0.0 && self.to <= self.from {
            return format!("a corner at station {station} {units}, point {point}");
        }
        format!("radius {radius} {units} at station {station} {units}, point {point} (from {from} to {to})")
    }
}
