//! Samples along curves: points, stations, curvatures and frames, as CSV or JSON.

use cyclide::{
    ShortNumber, Vec3,
    curve::{ArcLength, CurveFrame, CurveFrames, FrameRule, ParamCurve, plane_normal},
    model::CurveObject,
    surface::{Torus, TorusSpline},
};
use serde::Serialize;

use super::frame_turns::{Axes, FrameTurn};
use super::sampling::{SamplePlaces, Spacing, fractions, push_field};
use crate::check::file_sample::FileSample;
use crate::document::{BuiltObject, ContourFacts};
use crate::formats::push_sample;

/// The word of frames that look at a point.
const LOOK_AT: &str = "look-at";
/// A parallel curve is on its torus to rounding, which is far less than this part of the torus.
const NEAR: f64 = 1e-6;

impl SamplePlaces {
    /// The global parameters, in order.
    fn parameters(self, lengths: &ArcLength<'_>) -> Vec<f64> {
        match self {
            Self::Count { count, spacing: Spacing::Parameter } => fractions(count).collect(),
            Self::Count { count, spacing: Spacing::Length } => lengths.uniform(count),
            Self::Step(step) => {
                let total = lengths.total();
                // A rest that is rounding is no step of its own.
                let steps = (total / step * (1.0 - 1e-12)).ceil().max(1.0) as usize;
                let fraction = |i: usize| if i == steps { 1.0 } else { (i as f64 * step / total).min(1.0) };
                (0..=steps).map(|i| lengths.parameter_at(fraction(i))).collect()
            }
        }
    }
}

/// What to sample along curves.
///
/// ```
/// use cyclide_io::{Document, report::{CurveSamples, SampleOptions, SamplePlaces}};
/// let text = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#;
/// let built = text.parse::<Document>()?.build()?;
/// let options = SampleOptions { places: SamplePlaces::Step(1.0), frames: Some(cyclide::curve::FrameRule::Frenet) };
/// let samples = CurveSamples::new(&built[0], &options)?;
/// assert_eq!((samples.contours[0].samples.len(), samples.contours[0].samples[3].station), (14, 3.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleOptions {
    /// Where to sample.
    pub places: SamplePlaces,
    /// The frames, if any.
    pub frames: Option<FrameRule>,
}

/// The samples of the curves of an object.
///
/// ```
/// use cyclide_io::{Document, report::{CurveSamples, SampleOptions, SamplePlaces, Spacing}};
/// let text = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#;
/// let built = text.parse::<Document>()?.build()?;
/// let places = SamplePlaces::Count { count: 5, spacing: Spacing::Length };
/// let samples = CurveSamples::new(&built[0], &SampleOptions { places, frames: None })?;
/// assert_eq!(samples.contours[0].samples[2].curvature, Some(0.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveSamples {
    /// The object's name.
    pub object: String,
    /// The kind of its frames, if any: `up`, `toward`, `look-at`, `frenet`, `rotation-minimizing`, or `torus`, the normal of the torus on
    /// which the curve lies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frames: Option<&'static str>,
    /// Its contours.
    pub contours: Vec<ContourSamples>,
    /// What rotation-minimizing frames of closed curves come back turned by was spread over them.
    #[serde(skip)]
    spread: bool,
}

/// The samples of one connected curve.
///
/// ```
/// use cyclide_io::{Document, report::{CurveSamples, SampleOptions, SamplePlaces}};
/// let text = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#;
/// let built = text.parse::<Document>()?.build()?;
/// let frames = Some(cyclide::curve::FrameRule::rotation_minimizing());
/// let samples = CurveSamples::new(&built[0], &SampleOptions { places: SamplePlaces::Step(1.0), frames })?;
/// assert!(samples.contours[0].holonomy.expect("it is closed").abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContourSamples {
    /// Length.
    pub length: f64,
    /// True if the end joins the start; the last sample then coincides with the first.
    pub closed: bool,
    /// Unit normal of its plane, which determines the sign of curvatures; `None` in space.
    pub plane: Option<[f64; 3]>,
    /// For rotation-minimizing frames of a closed curve: the angle by which they are rotated about the tangent after one
    /// turn, in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub holonomy: Option<f64>,
    /// For rotation-minimizing frames: the measured bound on their error, in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frame_error: Option<f64>,
    /// Neighboring samples between which the frame turns by more than 90 degrees.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub frame_turns: Vec<FrameTurn>,
    /// The samples.
    pub samples: Vec<CurveSample>,
}

/// A sample of a curve; quantities that do not exist there are `None`.
///
/// ```
/// use cyclide_io::{Document, report::{CurveSamples, SampleOptions, SamplePlaces}};
/// let text = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#;
/// let built = text.parse::<Document>()?.build()?;
/// let samples = CurveSamples::new(&built[0], &SampleOptions { places: SamplePlaces::Step(1.0), frames: None })?;
/// let first = samples.contours[0].samples[0];
/// assert_eq!((first.signed_curvature, first.torsion, first.normal), (Some(0.5), Some(0.0), None));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CurveSample {
    /// Global parameter in `[0, 1]`.
    pub t: f64,
    /// Arc length from the start of the contour.
    pub station: f64,
    /// The point.
    pub point: [f64; 3],
    /// Unit tangent.
    pub tangent: Option<[f64; 3]>,
    /// Curvature, never negative.
    pub curvature: Option<f64>,
    /// Curvature, positive where the curve turns left seen against the normal of its plane; none in space.
    pub signed_curvature: Option<f64>,
    /// Torsion, positive for a right-handed helix; none where the curvature vanishes.
    pub torsion: Option<f64>,
    /// For a frame that looks at a point: the unit direction to that point, which is its first axis; for others the first
    /// axis is the tangent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub look: Option<[f64; 3]>,
    /// Unit normal of the frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal: Option<[f64; 3]>,
    /// Unit binormal of the frame, tangent × normal or look × normal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub binormal: Option<[f64; 3]>,
}

impl CurveSamples {
    /// Samples the contours of an object. Samples at which no frame exists have none; [`notes`](Self::notes) reports
    /// them.
    ///
    /// # Errors
    /// As [`CurveFrames::new`].
    pub fn new(built: &BuiltObject, options: &SampleOptions) -> cyclide::Result<Self> {
        let curves = built.item.curves();
        let normals = |(index, curve)| TorusNormals::new(curve, built.contours.get(index));
        let of_torus: Option<Vec<TorusNormals<'_>>> = curves.iter().enumerate().map(normals).collect();
        let of_torus = of_torus.filter(|_| options.frames.is_none());
        let on_torus = of_torus.is_some();
        let contour = |(index, curve): (usize, &CurveObject)| {
            let normals = of_torus.as_ref().map(|all| &all[index]);
            ContourSamples::new(curve.as_curve(), normals, options)
        };
        let frames = match options.frames {
            None => (on_torus && !curves.is_empty()).then_some("torus"),
            Some(FrameRule::Up(_)) => Some("up"),
            Some(FrameRule::Toward(_)) => Some("toward"),
            Some(FrameRule::LookAt { .. }) => Some(LOOK_AT),
            Some(FrameRule::Frenet) => Some("frenet"),
            Some(FrameRule::RotationMinimizing { .. }) => Some("rotation-minimizing"),
        };
        let contours = curves.iter().enumerate().map(contour).collect::<cyclide::Result<_>>()?;
        let spread = matches!(
            options.frames,
            Some(FrameRule::RotationMinimizing { closed: cyclide::curve::ClosedTwist::Spread, .. })
        );
        Ok(Self { object: built.item.name.clone(), frames, contours, spread })
    }

    /// As CSV: columns `t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion`, with frames
    /// `normal_x,normal_y,normal_z` and `binormal_x,binormal_y,binormal_z` too, before them of frames that look at a point `look_x,look_y,look_z`, and with a column `contour` (from 0) in front if there
    /// are several contours. Splines on a torus and curves parallel to them have the outward unit normal of the torus as their normal if no other frames are asked
    /// for: with the tangent it is the frame along a seam. Fields are empty where a value does not exist.
    #[must_use]
    pub fn csv(&self) -> String {
        let several = self.contours.len() > 1;
        let mut out = if several { "contour,".to_owned() } else { String::new() };
        out += "t,x,y,z,tangent_x,tangent_y,tangent_z,curvature,station,signed_curvature,torsion";
        let looks = self.frames == Some(LOOK_AT);
        if looks {
            out += ",look_x,look_y,look_z";
        }
        if self.frames.is_some() {
            out += ",normal_x,normal_y,normal_z,binormal_x,binormal_y,binormal_z";
        }
        out.push('\n');
        for (contour, samples) in self.contours.iter().enumerate() {
            for sample in &samples.samples {
                if several {
                    out += &format!("{contour},");
                }
                sample.push(&mut out, looks, self.frames.is_some());
            }
        }
        out
    }

    /// As JSON; quantities that do not exist are `null`, or omitted if no frames were requested.
    #[must_use]
    pub fn json(&self) -> String {
        // Numbers and words only: nothing that could fail.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Why spreading the twist of frames over closed curves has no effect; `None` if it has an effect, or was not requested.
    #[must_use]
    pub fn spread_without_effect(&self) -> Option<&'static str> {
        let mut turned = self.contours.iter().filter_map(|samples| samples.holonomy).peekable();
        if !self.spread {
            None
        } else if turned.peek().is_none() {
            Some("no curve is closed")
        } else {
            turned
                .all(|angle| angle.abs() <= 1e-6)
                .then_some("the frame returns to itself after one turn along the closed curve")
        }
    }

    /// Notes on the frames: samples without a frame, neighbors that differ by more than 90 degrees, and the rotation after one turn along a
    /// closed curve.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let Some(frames) = self.frames else { return Vec::new() };
        let mut notes = Vec::new();
        for (contour, samples) in self.contours.iter().enumerate() {
            let of = if self.contours.len() > 1 { format!("contour {contour}: ") } else { String::new() };
            let mut without = samples.samples.iter().filter(|sample| sample.normal.is_none()).peekable();
            if let Some(first) = without.peek() {
                let (t, station) = (ShortNumber(first.t), ShortNumber(first.station));
                let (count, all) = (without.clone().count(), samples.samples.len());
                notes.push(format!(
                    "{of}{count} of {all} samples have no {frames} frame, the first at station {station} (t = {t}): their normals are left out [no-frame]"
                ));
            }
            notes.extend(FrameTurn::note(&samples.frame_turns, frames).map(|note| of.clone() + &note));
            let turned = samples.holonomy.filter(|angle| angle.abs() > 1e-6);
            if let Some(angle) = turned {
                let (angle, degrees) = (ShortNumber(angle), ShortNumber(angle.to_degrees()));
                let what = if self.spread { ": the rotation was spread over the length" } else { " about the tangent" };
                notes.push(format!(
                    "{of}after one turn along the closed curve the frame is rotated by {angle} rad ({degrees} degrees){what}"
                ));
            }
        }
        notes
    }
}

/// Where the normals of a curve come from that has a torus.
enum TorusNormals<'a> {
    /// It lies on it.
    Along(&'a TorusSpline),
    /// It is parallel to one that does, on this one.
    Beside(Torus),
}

impl<'a> TorusNormals<'a> {
    fn new(curve: &'a CurveObject, facts: Option<&ContourFacts>) -> Option<Self> {
        match curve {
            CurveObject::TorusSpline(spline) => Some(Self::Along(spline)),
            _ => facts.and_then(|facts| facts.torus).map(Self::Beside),
        }
    }

    /// The outward normal of the torus.
    fn at(&self, curve: &dyn ParamCurve, t: f64) -> Option<Vec3> {
        match self {
            Self::Along(spline) => spline.seam_frame(t).map(|frame| frame.z()),
            Self::Beside(torus) => {
                let place = torus.locate(curve.point(t), NEAR * torus.major_radius());
                place.ok().map(|place| torus.unit_normal(place))
            }
        }
    }
}

impl ContourSamples {
    fn new(curve: &dyn ParamCurve, torus: Option<&TorusNormals<'_>>, options: &SampleOptions) -> cyclide::Result<Self> {
        let frames = options.frames.map(|rule| CurveFrames::new(curve, &rule)).transpose()?;
        let own;
        let lengths = match &frames {
            Some(frames) => frames.lengths(),
            None => {
                own = ArcLength::new(curve);
                &own
            }
        };
        let plane = plane_normal(curve);
        let frame_at = |t: f64| match (&frames, torus) {
            (Some(frames), _) => frames.at(t).ok(),
            _ => None,
        };
        let looks = matches!(options.frames, Some(FrameRule::LookAt { .. }));
        let sample = |t: f64| {
            let normal = torus.and_then(|normals| normals.at(curve, t));
            CurveSample::new(curve, t, lengths.station(t), plane, (looks, frame_at(t)), normal)
        };
        let places = options.places.parameters(lengths);
        let samples: Vec<CurveSample> = places.iter().map(|t| sample(*t)).collect();
        let axes: Vec<Option<Axes>> = samples.iter().map(CurveSample::axes).collect();
        let frame_turns = FrameTurn::find(&places, &axes, |t| sample(t).axes(), lengths, curve.is_closed());
        Ok(Self {
            length: lengths.total(),
            closed: curve.is_closed(),
            plane: plane.map(Vec3::to_array),
            holonomy: frames.as_ref().and_then(CurveFrames::holonomy),
            frame_error: frames.as_ref().and_then(CurveFrames::measured_error),
            frame_turns,
            samples,
        })
    }
}

impl CurveSample {
    fn new(
        curve: &dyn ParamCurve,
        t: f64,
        station: f64,
        plane: Option<Vec3>,
        (looks, frame): (bool, Option<CurveFrame>),
        normal: Option<Vec3>,
    ) -> Self {
        let jet = curve.jet(t);
        let plain = FileSample::new(t, &jet);
        let normal = normal.or_else(|| frame.map(|frame| frame.normal));
        let axis = frame.map(|frame| frame.axis);
        let binormal = normal.zip(axis.or(jet.tangent())).map(|(normal, axis)| axis.cross(normal));
        Self {
            t,
            station,
            point: curve.point(t).to_array(),
            tangent: plain.tangent.or(frame.map(|frame| frame.tangent.to_array())),
            curvature: plain.curvature,
            signed_curvature: plane.and_then(|n| jet.signed_curvature(n)).filter(|k| k.is_finite()),
            torsion: if plane.is_some() { jet.curvature().filter(|k| *k > 0.0).map(|_| 0.0) } else { jet.torsion() },
            look: axis.filter(|_| looks).map(Vec3::to_array),
            normal: normal.map(Vec3::to_array),
            binormal: binormal.map(Vec3::to_array),
        }
    }

    /// The axes of its frame, if it has one.
    fn axes(&self) -> Option<Axes> {
        let [axis, normal, binormal] = [self.look.or(self.tangent), self.normal, self.binormal];
        Some([axis?, normal?, binormal?].map(Vec3::from))
    }

    /// A line of the table.
    fn push(&self, out: &mut String, looks: bool, frames: bool) {
        let Self { t, tangent, curvature, .. } = *self;
        push_sample(out, self.point.into(), &FileSample { t, tangent, curvature });
        out.pop();
        for value in [Some(self.station), self.signed_curvature, self.torsion] {
            push_field(out, value);
        }
        let axes = [(looks, self.look), (frames, self.normal), (frames, self.binormal)];
        for (_, vector) in axes.into_iter().filter(|(asked, _)| *asked) {
            (0..3).for_each(|k| push_field(out, vector.map(|v| v[k])));
        }
        out.push('\n');
    }
}
