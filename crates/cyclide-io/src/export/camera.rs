//! Where a picture is looked at from.

#[cfg(feature = "png")]
use cyclide::Vec3;
use std::str::FromStr;

/// A direction of view: a named view, or two angles.
///
/// The azimuth is 0 in front of the model (the eye is on the side of negative y) and grows to the right, so that the
/// right view (from the side of positive x) has a quarter turn; the elevation is a quarter turn from above.
///
/// ```
/// use cyclide_io::export::Camera;
/// assert_eq!("front".parse::<Camera>(), Ok(Camera::new(0.0, 0.0).unwrap_or_else(|| unreachable!("it is upright"))));
/// assert!("30,91".parse::<Camera>().is_err());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    azimuth: f64,
    elevation: f64,
}

/// Azimuth and elevation in degrees.
const NAMED: [(&str, f64, f64); 7] = [
    ("top", 0.0, 90.0),
    ("bottom", 0.0, -90.0),
    ("front", 0.0, 0.0),
    ("back", 180.0, 0.0),
    ("right", 90.0, 0.0),
    ("left", -90.0, 0.0),
    // The elevation at which all three axes look equally long.
    ("iso", 45.0, 35.264_389_682_754_654),
];

impl Camera {
    /// From an azimuth and an elevation in radians; `None` if the elevation exceeds a quarter turn.
    #[must_use]
    pub fn new(azimuth: f64, elevation: f64) -> Option<Self> {
        let upright = elevation.abs() <= std::f64::consts::FRAC_PI_2 && azimuth.is_finite();
        upright.then_some(Self { azimuth, elevation })
    }

    #[cfg(feature = "png")]
    /// Right, up and toward the eye: unit vectors.
    pub(crate) fn axes(self) -> [Vec3; 3] {
        let sin_cos = |angle: f64| {
            // Quarter turns are exact: views along an axis are.
            let quarters = angle / std::f64::consts::FRAC_PI_2;
            if (quarters - quarters.round()).abs() < 1e-15 {
                let table = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)];
                table[quarters.round().rem_euclid(4.0) as usize % 4]
            } else {
                angle.sin_cos()
            }
        };
        let ((sa, ca), (se, ce)) = (sin_cos(self.azimuth), sin_cos(self.elevation));
        let right = Vec3::new(ca, sa, 0.0);
        let toward = Vec3::new(sa * ce, -ca * ce, se);
        [right, toward.cross(right), toward]
    }

    #[cfg(feature = "png")]
    /// True for a view along one of the axes, where pictures are drawings: without perspective.
    pub(crate) fn is_along_axis(self) -> bool {
        self.axes()[2].to_array().iter().filter(|v| **v == 0.0).count() == 2
    }
}

impl FromStr for Camera {
    type Err = String;

    /// A name, or `AZIMUTH,ELEVATION` in degrees.
    fn from_str(text: &str) -> Result<Self, String> {
        let names = || NAMED.map(|(name, ..)| name).join(", ");
        let degrees = match NAMED.iter().find(|(name, ..)| *name == text) {
            Some(&(_, azimuth, elevation)) => Some((azimuth, elevation)),
            None => text.split_once(',').and_then(|(a, e)| Some((a.trim().parse().ok()?, e.trim().parse().ok()?))),
        };
        let (azimuth, elevation): (f64, f64) =
            degrees.ok_or_else(|| format!("must be one of {}, or AZIMUTH,ELEVATION in degrees", names()))?;
        Self::new(azimuth.to_radians(), elevation.to_radians())
            .ok_or_else(|| "the elevation must be between -90 and 90 degrees".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(feature = "png")]
    fn views_are_those_of_a_drawing_office() {
        for (text, right, toward) in [
            ("top", Vec3::X, Vec3::Z),
            ("bottom", Vec3::X, -Vec3::Z),
            ("front", Vec3::X, -Vec3::Y),
            ("back", -Vec3::X, Vec3::Y),
            ("right", Vec3::Y, Vec3::X),
            ("left", -Vec3::Y, -Vec3::X),
            ("90,0", Vec3::Y, Vec3::X),
        ] {
            let camera: Camera = text.parse().unwrap();
            let [r, u, t] = camera.axes();
            assert_eq!((r, t), (right, toward), "{text}");
            assert_eq!(u, t.cross(r));
            assert!(camera.is_along_axis());
        }
        let iso: Camera = "iso".parse().unwrap();
        let [_, up, toward] = iso.axes();
        // From the front right, all axes equally long.
        assert!((toward - Vec3::new(1.0, -1.0, 1.0).unit().unwrap()).length() < 1e-15 && up.z > 0.0);
        assert!(!iso.is_along_axis());
    }

    #[test]
    fn what_is_no_view_is_refused() {
        for wrong in ["", "up", "30", "30,91", "nan,0", "1,2,3"] {
            assert!(wrong.parse::<Camera>().is_err(), "{wrong}");
        }
    }
}
