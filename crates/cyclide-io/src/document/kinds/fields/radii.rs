//! One radius for all corners of a polyline, or one for each.

use std::fmt;

use schemars::JsonSchema;
use serde::de::{Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};

/// The radius of all corners, or a list of one per point.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": [[0, 0], [10, 0], [10, 10]], "radius": [0, 2, 0]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::length(built[0].item.curves()[0].as_curve()) - (16.0 + std::f64::consts::PI)).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(untagged, rename = "Radii")]
#[serde(untagged)]
#[non_exhaustive]
pub enum RadiiSpec {
    /// The same for all corners.
    All(f64),
    /// One per point; the values at the ends of an open polyline have no effect.
    Each(Vec<f64>),
}

impl Default for RadiiSpec {
    fn default() -> Self {
        Self::All(0.0)
    }
}

impl<'de> Deserialize<'de> for RadiiSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(RadiiVisitor)
    }
}

struct RadiiVisitor;

impl<'de> Visitor<'de> for RadiiVisitor {
    type Value = RadiiSpec;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a radius, or a list of radii, one per point")
    }

    fn visit_f64<E>(self, radius: f64) -> Result<RadiiSpec, E> {
        Ok(RadiiSpec::All(radius))
    }

    fn visit_u64<E>(self, radius: u64) -> Result<RadiiSpec, E> {
        Ok(RadiiSpec::All(radius as f64))
    }

    fn visit_i64<E>(self, radius: i64) -> Result<RadiiSpec, E> {
        Ok(RadiiSpec::All(radius as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<RadiiSpec, A::Error> {
        let mut radii = Vec::new();
        while let Some(radius) = list.next_element()? {
            radii.push(radius);
        }
        Ok(RadiiSpec::Each(radii))
    }
}
