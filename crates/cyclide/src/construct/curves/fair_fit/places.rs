//! Places along a curve kept when its nodes change: by length along the chords.

use super::feet::Place;

/// Lengths along the chords of an old curve and the nodes of a new one on it.
pub(super) struct Remap {
    /// Length to each old node, and the whole.
    old: Vec<f64>,
    /// Length to each new node, rising; closed curves repeat the first one after a turn.
    new: Vec<f64>,
    closed: bool,
}

impl Remap {
    /// `nodes`: positions `segment + fraction` of the new nodes on the old chords, rising; those of an open curve
    /// start at 0 and end at the last.
    pub fn new(chords: impl Iterator<Item = f64>, closed: bool, nodes: &[f64]) -> Self {
        let mut old = vec![0.0];
        for chord in chords {
            old.push(old[old.len() - 1] + chord);
        }
        let mut remap = Self { old, new: Vec::new(), closed };
        let mut new: Vec<f64> = nodes.iter().map(|p| remap.length(*p)).collect();
        if closed {
            new.push(new[0] + remap.old[remap.old.len() - 1]);
        }
        remap.new = new;
        remap
    }

    fn length(&self, position: f64) -> f64 {
        let j = (position as usize).min(self.old.len() - 2);
        self.old[j] + (position - j as f64) * (self.old[j + 1] - self.old[j])
    }

    /// The place on the new curve of a position `segment + fraction` on the old one.
    pub fn place(&self, position: f64) -> Place {
        let mut s = self.length(position);
        if self.closed && s < self.new[0] {
            s += self.old[self.old.len() - 1];
        }
        let segment = self.new.partition_point(|x| *x <= s).clamp(1, self.new.len() - 1) - 1;
        let chord = self.new[segment + 1] - self.new[segment];
        let u = if chord > 0.0 { ((s - self.new[segment]) / chord).clamp(0.0, 1.0) } else { 0.0 };
        Place { segment, u }
    }
}

impl Place {
    pub fn position(self) -> f64 {
        self.segment as f64 + self.u
    }
}
