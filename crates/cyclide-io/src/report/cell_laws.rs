//! What is reported of the laws by which blocks are divided into cells.

use super::figures::short;
use cyclide::volume::{FineEnd, Grading};
use serde::Serialize;

/// How a direction of blocks is divided into cells, with the parameter found for the length of the first cell.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let corners = "[[0,0,0], [1,0,0], [0,1,0], [0,0,1]]";
/// let cells = r#"[4, 4, {"count": 2, "first": 0.25}]"#;
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"b": {{"type": "cyclide-volume", "corners": {corners}, "cells": {cells}}}}}}}"#);
/// let document: Document = text.parse()?;
/// let GeometryReport::Volume(found) = ObjectReport::new(&document.build()?[0], None).geometry else { unreachable!("by its type") };
/// let laws = found.cells.ok_or("it has cells")?.laws;
/// assert!(laws[2].law == "geometric" && laws[2].ratio.is_some_and(|ratio| (ratio - 3.0).abs() < 1e-9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CellLawReport {
    /// `uniform`, `geometric` or `tanh`.
    pub law: &'static str,
    /// For the geometric law: the ratio of the lengths of consecutive cells, from the fine end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// For the law of hyperbolic tangents.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stretch: Option<f64>,
    /// The end from which cells grow: `start`, `end` or `both`; none for equal cells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fine: Option<&'static str>,
}

impl CellLawReport {
    pub(super) fn new(law: &Grading) -> Self {
        let word = |fine: FineEnd| match fine {
            FineEnd::Start => "start",
            FineEnd::End => "end",
            FineEnd::Both => "both",
        };
        match *law {
            Grading::Geometric { ratio, fine } => {
                Self { law: "geometric", ratio: Some(ratio), stretch: None, fine: Some(word(fine)) }
            }
            Grading::Tanh { stretch, fine } => {
                Self { law: "tanh", ratio: None, stretch: Some(stretch), fine: Some(word(fine)) }
            }
            _ => Self { law: "uniform", ratio: None, stretch: None, fine: None },
        }
    }

    /// The laws of s, t and u in words; none where all are uniform.
    pub(super) fn text(laws: &[Self]) -> Option<String> {
        let of = |(name, law): (&str, &Self)| {
            let number = match (law.ratio, law.stretch) {
                (Some(ratio), _) => format!(" with ratio {}", short(ratio)),
                (None, Some(stretch)) => format!(" with stretch {}", short(stretch)),
                (None, None) => String::new(),
            };
            let fine = match law.fine {
                None => "",
                Some("both") => ", refined at both ends",
                Some("end") => ", refined at the end",
                Some(_) => ", refined at the start",
            };
            format!("{name} {}{number}{fine}", law.law)
        };
        let graded = laws.iter().any(|law| law.fine.is_some());
        graded.then(|| ["s", "t", "u"].into_iter().zip(laws).map(of).collect::<Vec<_>>().join("; "))
    }
}
