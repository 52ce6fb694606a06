//! What is measured on surfaces for the warnings of those who build them and for the report alike.

pub(crate) mod joints;
pub(crate) mod seams;
