//! One table for each subject of errors and warnings: a variant, its fields, its reason and the sentence about it, together.

use std::fmt;
use std::ops::Deref;

use crate::short_number::ShortNumber;

/// Makes an enum of a table. Behind each variant, written as in an enum, stand
///
/// - `reason`, its stable name, or `of` with the field that holds an error, whose reason is taken;
/// - `at` with the index of the item at fault, where there is one;
/// - `entry` with the field of the input whose list the index counts, or `field` with one that is at fault as a whole; neither where it
///   counts points, or there is none;
/// - any number of `when` with a condition and its sentence: the first that holds counts;
/// - `says` with the sentence otherwise.
///
/// Sentences name fields as `format!` does, and numbers are [`ShortNumber`]s in them; further arguments follow. All these expressions
/// see references to the fields, those of sentences in a [`Shown`].
macro_rules! table {
    (
        $(#[$about:meta])*
        pub enum $name:ident $(: $error:ident)? {
            $(
                $(#[$doc:meta])*
                $variant:ident $({ $($(#[$field_doc:meta])* $field:ident: $type:ty,)* })?
                $(reason $reason:literal;)?
                $(of $cause:ident;)?
                $(at $index:expr;)?
                $(entry $entry:expr;)?
                $(field $whole:expr;)?
                $(when $case:expr, says $special:literal $(, $special_argument:expr)*;)*
                says $sentence:literal $(, $argument:expr)*;
            )*
        }
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$doc])* $variant $({ $($(#[$field_doc])* $field: $type,)* })?,)*
        }

        impl $name {
            pub(crate) const REASONS: &'static [&'static str] = &[$($($reason,)?)*];

            /// The stable name of the reason.
            #[must_use]
            pub fn reason(&self) -> &'static str {
                match self {
                    $(Self::$variant { $($cause,)? .. } => $crate::table::table!(@reason $($reason)? $($cause)?),)*
                }
            }

            /// The index of the item that it is about, where there is one.
            #[must_use]
            #[allow(unused_variables, reason = "most fields are no index")]
            pub fn index(&self) -> Option<usize> {
                match self {
                    $(Self::$variant $({ $($field,)* })? => $crate::table::table!(@index $($index)?),)*
                }
            }

            /// The field of the input that it is about, where it names one, and whether the index counts its entries.
            #[allow(dead_code, unused_variables, reason = "warnings are about points; most fields say nothing of it")]
            pub(crate) fn field(&self) -> (Option<&'static str>, bool) {
                match self {
                    $(Self::$variant $({ $($field,)* })? => $crate::table::table!(@field $($entry, true)? $($whole, false)?),)*
                }
            }
        }

        impl std::fmt::Display for $name {
            #[allow(unused_variables, reason = "few sentences name all fields")]
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $(Self::$variant $({ $($field,)* })? => {
                        $($(let $field = $crate::table::Shown($field);)*)?
                        $(if $case {
                            return write!(f, $special $(, $special_argument)*);
                        })*
                        write!(f, $sentence $(, $argument)*)
                    })*
                }
            }
        }

        $(impl std::error::$error for $name {})?
    };
    (@reason $reason:literal) => { $reason };
    (@reason $cause:ident) => { $cause.reason() };
    (@field) => { (None, true) };
    (@field $field:expr, $is_list:literal) => { (Option::<&'static str>::from($field), $is_list) };
    (@index) => { None };
    (@index $index:expr) => { Option::<usize>::from($index) };
}

/// Makes the enum of all subjects, each of them a variant with the table of its name.
macro_rules! subjects {
    (
        $(#[$about:meta])*
        pub enum $name:ident {
            $($(#[$doc:meta])* $variant:ident($subject:ident),)*
        }
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$doc])* $variant($subject),)*
        }

        impl $name {
            /// All reasons there are, by subject.
            pub fn reasons() -> impl Iterator<Item = &'static str> {
                [$($subject::REASONS),*].into_iter().flatten().copied()
            }

            /// The stable name of the reason, as used in reference data and reports.
            #[must_use]
            pub fn reason(&self) -> &'static str {
                match self {
                    $(Self::$variant(subject) => subject.reason(),)*
                }
            }

            /// The index of the item that it is about (a point, tangent, span or segment), where there is one.
            #[must_use]
            pub fn index(&self) -> Option<usize> {
                match self {
                    $(Self::$variant(subject) => subject.index(),)*
                }
            }

            #[allow(dead_code, reason = "warnings are about points")]
            pub(crate) fn field(&self) -> (Option<&'static str>, bool) {
                match self {
                    $(Self::$variant(subject) => subject.field(),)*
                }
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $(Self::$variant(subject) => subject.fmt(f),)*
                }
            }
        }

        $(impl From<$subject> for $name {
            fn from(subject: $subject) -> Self {
                Self::$variant(subject)
            }
        })*
    };
}

pub(crate) use {subjects, table};

/// A field as sentences show it; all else goes through to the field.
pub(crate) struct Shown<'a, T>(pub(crate) &'a T);

impl<T> Deref for Shown<'_, T> {
    type Target = T;

    fn deref(&self) -> &T {
        self.0
    }
}

/// With [`ShortNumber`]'s digits.
impl fmt::Display for Shown<'_, f64> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        ShortNumber(*self.0).fmt(f)
    }
}

/// Coordinates with commas between.
impl fmt::Display for Shown<'_, [f64; 3]> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0.map(ShortNumber);
        write!(f, "{x}, {y}, {z}")
    }
}

/// Nothing where there is none.
impl<T> fmt::Display for Shown<'_, Option<T>>
where
    for<'b> Shown<'b, T>: fmt::Display,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.as_ref().map_or(Ok(()), |value| Shown(value).fmt(f))
    }
}

/// What is shown as it is.
macro_rules! shown_as_it_is {
    ($($type:ty),*) => {
        $(impl std::fmt::Display for $crate::table::Shown<'_, $type> {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.0.fmt(f)
            }
        })*
    };
}

pub(crate) use shown_as_it_is;

shown_as_it_is!(usize, u32, i32, &'static str);
