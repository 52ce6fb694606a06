//! Readers and writers of cyclide: model documents and point lists in, exchange files and reports out.
//!
//! Everything works on text and bytes; only the few functions documented to do so access the file system. Writers are pure functions from a
//! [`Model`](cyclide::model::Model) to bytes ([`formats::export`]). Each format has a reader for the files of this crate ([`formats::read_back`]), so every export
//! is checked from the bytes written ([`formats::file_deviation`]).
//!
//! # Modules
//!
//! | module | what is in it |
//! |---|---|
//! | here | a [`Document`], the [`ModelBuilder`] that makes its objects, the [`Report`] about them, the [`Format`]s and the [`Exporter`] with its [`ExportOptions`], [`Error`], [`Result`] |
//! | [`document`] | the kinds of object with the fields of each ([`document::kinds`]), numbers and points of documents, what was built, the schema |
//! | [`manual`] | the page of each kind |
//! | [`input`] | tables of points, and with the feature `files` the files and streams they come from |
//! | [`formats`] | every format: exporting, reading back, meshes as input |
//! | [`export`] | options, cameras and what an exported file promises |
//! | [`check`] | what a file holds when it is read back |
//! | [`report`] | what was made and what was written, measured; samples |
//! | [`compare`] | kinds of curve on one page |
//! | [`schedule`] | lists for a workshop |
//! | [`text`] | places in a text, spelling suggestions, control characters made visible |
//! | `file` | files written whole or not at all (feature `files`) |

pub mod check;
pub mod compare;
pub mod document;
mod drawing;
mod error;
pub mod export;
#[cfg(feature = "files")]
pub mod file;
pub mod formats;
pub mod input;
pub mod manual;
mod measure;
pub mod report;
pub mod schedule;
pub mod text;

pub use document::{Document, ModelBuilder};
pub use error::{Error, Result};
pub use export::ExportOptions;
pub use formats::{Exporter, Format};
pub use report::Report;

/// The examples of the README and of the book are compiled and run with the documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
#[doc = include_str!("../../../docs/guide/rust.md")]
struct Book;

/// So is the example of the package's page.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
