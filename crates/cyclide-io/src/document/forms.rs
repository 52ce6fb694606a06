//! Values that documents write in one of several forms, as sums of these.

/// Reads an enum whose variants differ in the kind of JSON value: a `switch`, a `number`, a `word`, a `list` or an `object`, each with the
/// type that reads it and what becomes of that. What is wrong within a form is said of its own parts, where serde's `untagged` says that none fits.
macro_rules! forms {
    ($sum:ident: $expected:literal; $($form:ident $from:ty => $become:expr;)+) => {
        impl<'de> serde::Deserialize<'de> for $sum {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> ::std::result::Result<Self, D::Error> {
                struct Forms;
                impl<'de> serde::de::Visitor<'de> for Forms {
                    type Value = $sum;
                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str($expected)
                    }
                    $($crate::document::forms::forms! { @$form $from => $become })+
                }
                deserializer.deserialize_any(Forms)
            }
        }
    };
    (@switch $from:ty => $become:expr) => {
        fn visit_bool<E>(self, on: $from) -> ::std::result::Result<Self::Value, E> {
            Ok($become(on))
        }
    };
    (@number $from:ty => $become:expr) => {
        fn visit_f64<E>(self, number: f64) -> ::std::result::Result<Self::Value, E> {
            Ok($become(number))
        }
        fn visit_u64<E>(self, number: u64) -> ::std::result::Result<Self::Value, E> {
            Ok($become(number as $from))
        }
        fn visit_i64<E>(self, number: i64) -> ::std::result::Result<Self::Value, E> {
            Ok($become(number as $from))
        }
    };
    (@word $from:ty => $become:expr) => {
        fn visit_str<E: serde::de::Error>(self, word: &str) -> ::std::result::Result<Self::Value, E> {
            <$from as serde::Deserialize>::deserialize(serde::de::value::StrDeserializer::new(word)).map($become)
        }
    };
    (@list $from:ty => $become:expr) => {
        fn visit_seq<A: serde::de::SeqAccess<'de>>(self, list: A) -> ::std::result::Result<Self::Value, A::Error> {
            <$from as serde::Deserialize>::deserialize(serde::de::value::SeqAccessDeserializer::new(list)).map($become)
        }
    };
    (@object $from:ty => $become:expr) => {
        fn visit_map<A: serde::de::MapAccess<'de>>(self, object: A) -> ::std::result::Result<Self::Value, A::Error> {
            <$from as serde::Deserialize>::deserialize(serde::de::value::MapAccessDeserializer::new(object)).map($become)
        }
    };
}

pub(in crate::document) use forms;
