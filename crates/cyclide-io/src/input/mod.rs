//! What is read of users: files and standard input as bytes, lists of points.

pub(crate) mod file;
pub(crate) mod points;
