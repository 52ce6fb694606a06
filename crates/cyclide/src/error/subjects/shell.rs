//! Why faces do not form a shell, or not one that files can store.

use crate::error::ErrorItem;
use crate::table::table;

table! {
    /// Why faces do not form a shell, or not one that files can store.
    ///
    /// ```
    /// use cyclide::{Error, error::ShellError};
    /// let error: Error = ShellError::ShortEdge { edge: 2, length: 0.5, limit: 1e-9 }.into();
    /// assert_eq!(error.reason(), "short-edge");
    /// ```
    pub enum ShellError: Error {
        /// Vertices, edges and faces do not form a valid shell.
        NotAShell {
            /// The kind of item: vertex, edge or face.
            item: ErrorItem,
            /// Which one, from 0.
            index: usize,
            /// What is wrong with it.
            detail: &'static str,
        }
        reason "not-a-shell";
        at *index;
        says "not a valid shell: {item} {index}: {detail}";

        /// An edge is so short that other programs would merge its ends.
        ShortEdge {
            /// Which edge, from 0, after faces were cut.
            edge: usize,
            /// Distance of its ends.
            length: f64,
            /// Shortest length accepted.
            limit: f64,
        }
        reason "short-edge";
        says "edge {edge} of the faces for a file is {length} long, minimum {limit}: the surface is nearly singular \
            there; move its points or its radii apart, or leave out the thin part";
    }
}
