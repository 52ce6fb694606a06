//! The faces of a tee: skins with what closes them.

use super::arrangement::{Group, Stand};
use super::skin::{Branch, known_flanks};
use super::{PipeTee, Placed, TeeEnds};
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::pierced::{HoleRow, Pairing, Ring, Skin};
use crate::error::{Error, Result};
use crate::topology::{Body, Sewing};

impl PipeTee {
    /// The faces of all skins.
    pub(super) fn sewn(&self, placed: &[Placed], groups: &[Group]) -> Result<Body> {
        let mut sewing = Sewing::default();
        let outer = self.skin(&mut sewing, placed, groups, 0.0, 0.0)?;
        let Some(wall) = self.wall else {
            if self.ends == TeeEnds::Open {
                return Ok(Body { outer: sewing.finish()?, voids: Vec::new() });
            }
            self.disks(&mut sewing, placed, &outer, 0.0)?;
            return Ok(Body { outer: sewing.finish()?, voids: Vec::new() });
        };
        if self.ends == TeeEnds::Closed {
            self.disks(&mut sewing, placed, &outer, 0.0)?;
            let mut inside = Sewing::default();
            let inner = self.skin(&mut inside, placed, groups, wall, wall)?;
            self.disks(&mut inside, placed, &inner, wall)?;
            return Ok(Body { outer: sewing.finish()?, voids: vec![inside.finish()?] });
        }
        let inner = self.skin(&mut sewing, placed, groups, wall, 0.0)?;
        let mut skin = Skin { sewing: &mut sewing, depth: 0.0, inner: false };
        for ((outer, inner), (_, outwards)) in outer.iter().zip(&inner).zip(self.openings(placed, 0.0)) {
            skin.between_rings(outer, inner, outwards)?;
        }
        Ok(Body { outer: sewing.finish()?, voids: Vec::new() })
    }

    /// The centers of all ends and the directions out of them, as rings of skins are ordered: both ends of the main pipe, then the branches.
    fn openings(&self, placed: &[Placed], short: f64) -> Vec<(Point3, Vec3)> {
        let main = [(self.main.ends[0] + short, -1.0), (self.main.ends[1] - short, 1.0)];
        let branches = placed.iter().map(|branch| {
            let axis = branch.crossing.axes[2];
            (branch.crossing.foot + axis * (branch.length - short), axis)
        });
        main.into_iter().map(|(at, way)| (Point3::new(at, 0.0, 0.0), Vec3::X * way)).chain(branches).collect()
    }

    fn disks(&self, sewing: &mut Sewing, placed: &[Placed], rings: &[Ring], depth: f64) -> Result<()> {
        let mut skin = Skin { sewing, depth, inner: depth > 0.0 };
        for (ring, (centre, outwards)) in rings.iter().zip(self.openings(placed, depth)) {
            skin.disk(ring, centre, if depth > 0.0 { -outwards } else { outwards })?;
        }
        Ok(())
    }

    /// The faces of a skin, and its rings in the order of [`openings`](Self::openings).
    fn skin(
        &self,
        sewing: &mut Sewing,
        placed: &[Placed],
        groups: &[Group],
        depth: f64,
        short: f64,
    ) -> Result<Vec<Ring>> {
        // Places on a skin of a cone below are counted from a moved origin.
        let ends = self.main.ends.map(|end| end + depth * self.main.taper.sin());
        let mut skin = Skin { sewing, depth, inner: depth > 0.0 };
        let mut branches: Vec<Option<Ring>> = placed.iter().map(|_| None).collect();
        let mut stretches: Vec<(usize, [Ring; 2])> = Vec::new();
        for (k, group) in groups.iter().enumerate() {
            // Between two groups a third of the way is left for what joins their rings.
            let start = match k.checked_sub(1).and_then(|j| groups.get(j)) {
                Some(before) => between(before.reach[1], group.reach[0])[1],
                None => ends[0] + short,
            };
            let end = match groups.get(k + 1) {
                Some(next) => between(group.reach[1], next.reach[0])[0],
                None => ends[1] - short,
            };
            let mut branch = |skin: &mut Skin, k: usize, stretch: [f64; 2], flanks: Option<[usize; 2]>| {
                let Placed { crossing, partition, length, .. } = &placed[k];
                let branch = Branch { crossing, partition, length: length - short, stretch, flanks };
                let (hole, ring) = skin.branch(&branch)?;
                branches[k] = Some(ring);
                Ok::<_, Error>(hole)
            };
            let (first, rings) = match &group.stand {
                Stand::Alone(k) => {
                    let hole = branch(&mut skin, *k, [start, end], None)?;
                    (*k, skin.stretch(hole)?)
                }
                Stand::Rows(rows) => {
                    let first = rows[0].members[0];
                    let mut holes = Vec::new();
                    for row in rows {
                        let mut in_row = Vec::new();
                        for (j, &(k, turn)) in row.members.iter().enumerate() {
                            let reach = |j: usize| placed[row.members[j].0].reach;
                            let from = if j == 0 { start } else { between(reach(j - 1)[1], reach(j)[0])[1] };
                            let last = j + 1 == row.members.len();
                            let to = if last { end } else { between(reach(j)[1], reach(j + 1)[0])[0] };
                            // In the axes of the first one.
                            in_row.push((branch(&mut skin, k, [from, to], None)?, turn - first.1));
                        }
                        holes.push(HoleRow { holes: in_row, lines: row.lines.map(|angle| angle - first.1) });
                    }
                    let mantle = placed[first.0].crossing.main_pipe(depth);
                    (first.0, skin.rows(&mantle, &holes, Pairing::Nearest)?)
                }
                Stand::Halves([a, b]) => {
                    let one = branch(&mut skin, *a, [start, end], None)?;
                    let other = branch(&mut skin, *b, [start, end], Some(known_flanks(&one)))?;
                    (*a, skin.between_halves([&one, &other])?)
                }
            };
            stretches.push((first, rings));
        }
        for pair in stretches.windows(2) {
            let [(first, [_, end]), (second, [start, _])] = pair else { continue };
            let mantle = placed[*first].crossing.main_pipe(depth);
            let turn = mantle.angle_of(placed[*second].crossing.up);
            skin.join(&mantle, end, start, turn)?;
        }
        let (mut first, mut last) = (None, None);
        for (_, [start, end]) in stretches {
            first = first.or(Some(start));
            last = Some(end);
        }
        Ok(first.into_iter().chain(last).chain(branches.into_iter().flatten()).collect())
    }
}

/// The ends of two stretches between places, a third of the way from both.
fn between(from: f64, to: f64) -> [f64; 2] {
    [from + (to - from) / 3.0, to - (to - from) / 3.0]
}
