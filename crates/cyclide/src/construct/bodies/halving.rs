//! Spans halved until what is made over each keeps to a tolerance.

use crate::error::{NumberError, Result};

/// Where halving ends.
pub(super) struct Halving {
    /// What is made, for the error.
    pub(super) what: &'static str,
    /// Pieces at most.
    pub(super) cap: usize,
    /// Spans shorter than this are not halved.
    pub(super) least: f64,
    /// What to do against too many, for the error.
    pub(super) remedy: &'static str,
}

impl Halving {
    /// Adds the pieces over a span, in order: `pieces` makes those of a part of it, none where they are not near enough and the part is to be halved.
    ///
    /// # Errors
    /// `too-many-pieces`; what `pieces` fails with.
    pub(super) fn extend<P>(
        &self,
        made: &mut Vec<P>,
        span: [f64; 2],
        mut pieces: impl FnMut([f64; 2]) -> Result<Option<Vec<P>>>,
    ) -> Result<()> {
        let mut left = vec![span];
        while let Some([from, to]) = left.pop() {
            if let Some(near) = pieces([from, to])? {
                made.extend(near);
                continue;
            }
            let middle = 0.5 * (from + to);
            // Each span left has two pieces or more.
            let needed = made.len() + 2 * left.len() + 4;
            let is_leap = !(from < middle && middle < to) || to - from < self.least;
            if needed > self.cap || is_leap {
                return Err(NumberError::TooManyPieces {
                    what: self.what,
                    segment: None,
                    needed: if is_leap { f64::INFINITY } else { needed as f64 },
                    cap: self.cap,
                    remedy: self.remedy,
                }
                .into());
            }
            left.extend([[middle, to], [from, middle]]);
        }
        Ok(())
    }
}
