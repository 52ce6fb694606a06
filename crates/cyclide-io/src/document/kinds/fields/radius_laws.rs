//! One radius of a ball, or a law of it, as documents write them.

use std::fmt;
use std::marker::PhantomData;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};

/// A number, or an object.
pub(in crate::document) enum RadiusOr<L> {
    Radius(f64),
    Law(L),
}

/// Reads either, so that what is wrong in the object is said of its fields.
pub(in crate::document) fn radius_or<'de, L: Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
    expected: &'static str,
) -> Result<RadiusOr<L>, D::Error> {
    struct Either<L>(&'static str, PhantomData<L>);
    impl<'de, L: Deserialize<'de>> Visitor<'de> for Either<L> {
        type Value = RadiusOr<L>;
        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str(self.0)
        }
        fn visit_f64<E>(self, radius: f64) -> Result<Self::Value, E> {
            Ok(RadiusOr::Radius(radius))
        }
        fn visit_u64<E>(self, radius: u64) -> Result<Self::Value, E> {
            Ok(RadiusOr::Radius(radius as f64))
        }
        fn visit_i64<E>(self, radius: i64) -> Result<Self::Value, E> {
            Ok(RadiusOr::Radius(radius as f64))
        }
        fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
            L::deserialize(MapAccessDeserializer::new(map)).map(RadiusOr::Law)
        }
    }
    deserializer.deserialize_any(Either(expected, PhantomData))
}
