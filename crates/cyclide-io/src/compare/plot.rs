//! Curvature over the length, plotted; all kinds at the same scales.

use std::fmt::Write as _;

use cyclide::{
    ShortNumber, Vec3,
    curve::{ArcLength, ParamCurve, plane_normal},
    model::CurveObject,
};

use super::drawing::push_path;

/// Size of a plot.
const SIZE: [f64; 2] = [640.0, 150.0];
/// Left and right of it, for the numbers, above and below.
const MARGINS: [f64; 4] = [64.0, 10.0, 12.0, 22.0];
/// Largest curvature shown, in parts of the largest one of the calmest kind.
const HIGHEST: f64 = 3.0;
/// Places of each curve.
const PLACES: usize = 2001;

/// The curvature of one kind's contours over their stations, one after the other; signed in a plane.
struct Course {
    /// Stations and curvatures; a break between contours.
    runs: Vec<Vec<[f64; 2]>>,
    length: f64,
    signed: bool,
    largest: f64,
}

impl Course {
    fn new(curves: &[CurveObject]) -> Self {
        let mut course = Self { runs: Vec::new(), length: 0.0, signed: true, largest: 0.0 };
        let normals: Vec<Option<Vec3>> = curves.iter().map(|curve| plane_normal(curve.as_curve())).collect();
        course.signed = normals.iter().all(Option::is_some);
        let places = PLACES / curves.len().max(1);
        for (curve, normal) in curves.iter().zip(normals) {
            course.push(curve.as_curve(), normal.filter(|_| course.signed), places.max(60));
        }
        course
    }

    fn push(&mut self, curve: &dyn ParamCurve, normal: Option<Vec3>, places: usize) {
        let lengths = ArcLength::new(curve);
        let value = |t: f64| match normal {
            Some(normal) => curve.jet(t).signed_curvature(normal),
            None => curve.jet(t).curvature(),
        };
        let start = self.length;
        let run = lengths.uniform(places).into_iter().filter_map(|t| {
            let station = start + lengths.station(t);
            value(t).filter(|k| k.is_finite()).map(|k| [station, k])
        });
        let run: Vec<[f64; 2]> = run.collect();
        self.largest = run.iter().fold(self.largest, |most, [_, k]| most.max(k.abs()));
        self.length += lengths.total();
        self.runs.push(run);
    }
}

/// The largest of 1, 2 and 5 times a power of ten that is not above a positive value.
fn round_below(value: f64) -> f64 {
    let power = 10.0_f64.powf(value.log10().floor());
    let steps = [5.0, 2.0, 1.0];
    steps.into_iter().map(|step| step * power).find(|v| *v <= value * (1.0 + 1e-12)).unwrap_or(value)
}

/// The plot of one kind; `calm` is the largest curvature of the calmest kind.
pub(super) fn plot(curves: &[CurveObject], calm: f64, units: &str, title: &str) -> String {
    let course = Course::new(curves);
    let [width, height] = SIZE;
    let [left, right, top, bottom] = MARGINS;
    let high = 1.08 * HIGHEST.min(course.largest.max(calm) / calm) * calm;
    let low = if course.signed && course.runs.iter().flatten().any(|[_, k]| *k < -1e-9 * high) { -high } else { 0.0 };
    let x = |station: f64| left + (width - left - right) * station / course.length.max(f64::MIN_POSITIVE);
    let y = |k: f64| top + (height - top - bottom) * (high - k.clamp(low, high)) / (high - low);
    let mut out = format!(
        "<svg class=\"plot\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{title}: curvature over the length\">"
    );
    let mark = round_below(calm);
    let marks: &[f64] = if low < 0.0 { &[mark, 0.0, -mark] } else { &[mark, 0.0] };
    for &k in marks {
        let (class, at) = (if k == 0.0 { "axis" } else { "grid" }, y(k));
        let _never_fails = write!(
            out,
            "<path class=\"{class}\" d=\"M{left} {at:.1}H{:.1}\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            width - right,
            left - 6.0,
            at + 4.0,
            ShortNumber(k)
        );
    }
    let foot = height - 6.0;
    let _never_fails = write!(
        out,
        "<text x=\"{left}\" y=\"{foot}\">0</text><text x=\"{:.1}\" y=\"{foot}\" text-anchor=\"end\">{} {units}</text><text x=\"{:.1}\" y=\"{foot}\" text-anchor=\"middle\">curvature in 1/{units} over the length</text>",
        width - right,
        ShortNumber(course.length),
        0.5 * (left + width - right),
    );
    out.push_str("<path class=\"course\" d=\"");
    for run in &course.runs {
        push_path(&mut out, run.iter().map(|[station, k]| [x(*station), y(*k)]));
    }
    out.push_str("\"/>");
    if course.largest > high {
        let _never_fails = write!(
            out,
            "<text class=\"cut\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">cut off: up to {}</text>",
            width - right,
            top + 2.0,
            ShortNumber(course.largest)
        );
    }
    out + "</svg>"
}
