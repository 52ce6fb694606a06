//! The content of a file with the promises that hold for it.

use crate::deviation::MeshPlan;
use cyclide::{Arc, Exactness};

/// A file's content with the promises that hold for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// True if the file's curves are the objects' curves up to the rounding of the numbers.
    pub exact: bool,
    /// Promised bound on the distance between the file's curve and the object, model units; 0 if exact.
    pub bound: f64,
    /// True if the bound of a part of the file is sampled, not proved.
    pub sampled: bool,
    /// Remarks for the user, one sentence each.
    pub notes: Vec<String>,
    /// What the polygons of a mesh stand for: what the file is checked against.
    pub(crate) mesh: MeshPlan,
    /// What the lines of surfaces in a drawing stand for, in file order: what the file is checked against.
    pub(crate) lines: Vec<Arc>,
}

/// Collects the bound over the contours of a file.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Promise {
    bound: Option<f64>,
    sampled: bool,
}

impl Promise {
    pub(crate) const EXACT: Self = Self { bound: None, sampled: false };

    pub(crate) fn add(&mut self, exactness: Exactness) {
        self.sampled |= matches!(exactness, Exactness::Sampled(_));
        if let Exactness::Proved(bound) | Exactness::Sampled(bound) = exactness {
            self.bound = Some(self.bound.map_or(bound, |b| b.max(bound)));
        }
    }

    /// The finished file under this promise.
    pub(crate) fn exported(self, bytes: Vec<u8>, notes: Vec<String>) -> Exported {
        self.exported_mesh(bytes, notes, MeshPlan::default())
    }

    /// The finished file of a mesh format.
    pub(crate) fn exported_mesh(self, bytes: Vec<u8>, notes: Vec<String>, mesh: MeshPlan) -> Exported {
        Exported {
            bytes,
            exact: self.bound.is_none(),
            bound: self.bound.unwrap_or(0.0),
            sampled: self.sampled,
            notes,
            mesh,
            lines: Vec::new(),
        }
    }
}

/// Smallest swept angle that drawings and polylines keep as an arc. Readers find the circle from the chord and a
/// radius or bulge: below, they would lose more digits than the arc's sagitta has.
const SMALLEST_SWEEP: f64 = 5e-8;

/// What is lost if the arc is written as its chord, for arcs that have to be; `None` for arcs that stay arcs.
pub(crate) fn straightened(arc: &Arc) -> Option<Exactness> {
    if arc.is_straight() {
        return Some(Exactness::Exact);
    }
    if arc.angle() >= SMALLEST_SWEEP {
        return None;
    }
    let sagitta = 0.5 * arc.chord().length() * arc.bulge_vector().length();
    let rounding = f64::EPSILON * arc.start().to_vec().max_abs().max(arc.end().to_vec().max_abs());
    Some(if sagitta > rounding { Exactness::Proved(sagitta) } else { Exactness::Exact })
}
