//! Blocks with a part of them cut away along coordinate surfaces, so that a picture shows the inside of all three families.
//!
//! Of blocks in rows the half towards the eye is taken away in each open direction, and a quarter of each closed one, together a corner of a block or a
//! notch in a ring: what bounds it are inner surfaces of each family. Cells that blocks are divided into are cut nowhere: cuts lie between them.

use super::block_directions::others;
use super::lattice::Lattice;
use cyclide::{
    Point3, Vec3,
    curve::Arc,
    topology::BlockShell,
    volume::{CyclideVolume, ParamVolume as _},
};

/// Places at which the notch of a closed direction is tried.
const TRIES: usize = 24;
/// Rows of at least so many blocks are cut between blocks only.
const MANY: usize = 8;
/// The part of a closed direction that is taken away.
const NOTCH: f64 = 0.25;

/// What is left of the blocks of an object.
pub(crate) struct CutAway {
    /// The boundary of what is left.
    pub(crate) shells: Vec<BlockShell>,
    /// The sides of what was taken away that have no part on it.
    pub(crate) taken: Vec<Arc>,
}

/// A range of each direction, in blocks.
type Ranges = [[f64; 2]; 3];

impl CutAway {
    /// Blocks divided at these places, if they are, seen from a direction.
    ///
    /// # Errors
    /// As [`CyclideVolume::boundary_of_parts`].
    pub(crate) fn new(blocks: &[CyclideVolume], places: Option<&[Vec<f64>; 3]>, toward: Vec3) -> cyclide::Result<Self> {
        let inner: [Option<f64>; 3] = std::array::from_fn(|axis| {
            let Some(places) = places else { return Some(0.5) };
            let inside = places[axis].iter().copied().filter(|x| (0.0..1.0).contains(x) && *x > 0.0);
            inside.min_by(|a, b| (a - 0.5).abs().total_cmp(&(b - 0.5).abs()))
        });
        let mut gone: Vec<Option<(usize, [usize; 3])>> = vec![None; blocks.len()];
        let mut notches = Vec::new();
        let mut taken = Vec::new();
        for lattice in Lattice::all(blocks)?.into_iter().flatten() {
            let Some(notch) = Notch::new(blocks, lattice, inner, toward) else { continue };
            for (place, block) in &notch.lattice.blocks {
                gone[*block] = Some((notches.len(), *place));
            }
            taken.extend(notch.outline(blocks)?);
            notches.push(notch);
        }
        let cuts: [Vec<f64>; 3] = std::array::from_fn(|axis| {
            let inside = |notch: &Notch| notch.ranges[axis].into_iter().any(|x| x.fract() > 0.0);
            let cut = inner[axis].filter(|_| notches.iter().any(inside));
            [0.0].into_iter().chain(cut).chain([1.0]).collect()
        });
        let is_there = |block: usize, part: [usize; 3]| {
            gone[block].is_none_or(|(notch, place)| {
                let middle = |axis: usize| 0.5 * (cuts[axis][part[axis]] + cuts[axis][part[axis] + 1]);
                !notches[notch].has(std::array::from_fn(|axis| place[axis] as f64 + middle(axis)))
            })
        };
        let shells = CyclideVolume::boundary_of_parts(blocks, cuts.clone(), is_there)?;
        Ok(Self { shells, taken })
    }

    /// Blocks one by one, nothing cut away.
    ///
    /// # Errors
    /// As [`CyclideVolume::boundary_of_parts`].
    pub(crate) fn of_single_blocks(blocks: &[CyclideVolume]) -> cyclide::Result<Self> {
        let mut shells = Vec::new();
        for (index, block) in blocks.iter().enumerate() {
            let whole = std::array::from_fn(|_| vec![0.0, 1.0]);
            let mut own = CyclideVolume::boundary_of_parts(std::slice::from_ref(block), whole, |_, _| true)?;
            own.iter_mut().flat_map(|shell| &mut shell.faces).for_each(|face| face.block = index);
            shells.extend(own);
        }
        Ok(Self { shells, taken: Vec::new() })
    }
}

/// What is taken away of blocks in rows.
struct Notch {
    lattice: Lattice,
    ranges: Ranges,
}

impl Notch {
    /// The one that shows the most; `None` where blocks have no place to be cut.
    fn new(blocks: &[CyclideVolume], lattice: Lattice, inner: [Option<f64>; 3], toward: Vec3) -> Option<Self> {
        let along: [Vec<[f64; 2]>; 3] = std::array::from_fn(|axis| ranges(&lattice, axis, inner[axis]));
        let uncut = |axis: usize, range: [f64; 2]| range[1] - range[0] >= lattice.size[axis] as f64;
        let all = along[0].iter().flat_map(|s| along[1].iter().map(move |t| (s, t)));
        let all = all.flat_map(|(s, t)| along[2].iter().map(move |u| [*s, *t, *u]));
        let cut = all.filter(|ranges| (0..3).any(|axis| !uncut(axis, ranges[axis])));
        let (_, best) = cut
            .map(|ranges| (shown(blocks, &lattice, ranges, toward), ranges))
            .max_by(|(a, _), (b, _)| a.total_cmp(b))?;
        Some(Self { lattice, ranges: best })
    }

    /// Whether a place, in blocks, is taken away.
    fn has(&self, at: [f64; 3]) -> bool {
        (0..3).all(|axis| {
            let [from, to] = self.ranges[axis];
            let again = if self.lattice.closed[axis] { self.lattice.size[axis] as f64 } else { 0.0 };
            [at[axis], at[axis] + again].into_iter().any(|x| from < x && x < to)
        })
    }

    /// The sides of what is taken away that run along sides of all blocks together and leave nothing there.
    fn outline(&self, blocks: &[CyclideVolume]) -> cyclide::Result<Vec<Arc>> {
        let mut arcs = Vec::new();
        for axis in 0..3 {
            let others = others(axis);
            // The ends of open directions that are taken away.
            let ends = others.map(|k| {
                let (last, [from, to]) = (self.lattice.size[k], self.ranges[k]);
                let open = !self.lattice.closed[k];
                [(0, open && from <= 0.0), (last, open && to >= last as f64)]
                    .into_iter()
                    .filter(|(_, taken)| *taken)
                    .map(|(end, _)| end)
                    .collect::<Vec<usize>>()
            });
            for (x, y) in ends[0].iter().flat_map(|x| ends[1].iter().map(move |y| (*x, *y))) {
                let [from, to] = self.ranges[axis];
                for k in from as usize..to.ceil() as usize {
                    let mut place = [0; 3];
                    place[axis] = self.lattice.wrapped(axis, k);
                    (place[others[0]], place[others[1]]) = (x.saturating_sub(1), y.saturating_sub(1));
                    let Some(block) = self.lattice.blocks.get(&place) else { continue };
                    let at = [x, y].map(|end| if end == 0 { 0.0 } else { 1.0 });
                    let range = [(from - k as f64).max(0.0), (to - k as f64).min(1.0)];
                    // A side of one point is not seen.
                    if let Ok(line) = blocks[*block].line(axis, at) {
                        arcs.push(line.restricted(range[0], range[1])?);
                    }
                }
            }
        }
        Ok(arcs)
    }
}

/// The ranges of a direction that may be taken away: all of it where it cannot be cut.
fn ranges(lattice: &Lattice, axis: usize, inner: Option<f64>) -> Vec<[f64; 2]> {
    let count = lattice.size[axis];
    let all = [0.0, count as f64];
    if !lattice.closed[axis] {
        let middle = match (count % 2, inner) {
            (0, _) => (count / 2) as f64,
            (_, Some(inner)) if count < MANY => (count / 2) as f64 + inner,
            _ if count > 1 => count.div_ceil(2) as f64,
            _ => return vec![all],
        };
        return vec![[0.0, middle], [middle, count as f64]];
    }
    let inner = inner.filter(|_| count < MANY);
    let cuts: Vec<f64> = (0..2 * count).flat_map(|k| [Some(k as f64), inner.map(|x| k as f64 + x)]).flatten().collect();
    // As many for each turn.
    let turn = cuts.len() / 2;
    let width = ((NOTCH * turn as f64).round() as usize).max(1);
    if width >= turn {
        return vec![all];
    }
    (0..turn).step_by(turn.div_ceil(TRIES)).map(|k| [cuts[k], cuts[k + width]]).collect()
}

/// How well what is taken away opens the inside to the eye: how much the surfaces that bound it face the eye, and how near it is.
fn shown(blocks: &[CyclideVolume], lattice: &Lattice, ranges: Ranges, toward: Vec3) -> f64 {
    let middle = ranges.map(|[from, to]| 0.5 * (from + to));
    let Some((centre, _)) = place(blocks, lattice, middle) else { return f64::NEG_INFINITY };
    let mut score = 0.0;
    for axis in 0..3 {
        for (end, sign) in [(0, 1.0), (1, -1.0)] {
            let x = ranges[axis][end];
            if !lattice.closed[axis] && (x <= 0.0 || x >= lattice.size[axis] as f64) {
                continue;
            }
            let mut at = middle;
            at[axis] = x;
            let facing = place(blocks, lattice, at).and_then(|(_, along)| along[axis].unit());
            score += facing.map_or(0.0, |along| (sign * along.dot(toward)).max(0.0));
        }
    }
    let corners = || lattice.blocks.values().flat_map(|block| blocks[*block].corners());
    let depths = corners().map(|p| p.to_vec().dot(toward));
    let (far, near) = depths.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
    let depth = (centre.to_vec().dot(toward) - far) / (near - far);
    score + if depth.is_finite() { depth } else { 0.0 }
}

/// The point at a place, in blocks, with the directions of growing parameters.
fn place(blocks: &[CyclideVolume], lattice: &Lattice, at: [f64; 3]) -> Option<(Point3, [Vec3; 3])> {
    let index = std::array::from_fn(|axis| lattice.wrapped(axis, at[axis] as usize));
    let block = lattice.blocks.get(&index)?;
    let within = |axis: usize| {
        let x = at[axis] - at[axis].floor();
        // The end of an open direction is that of its last block.
        if !lattice.closed[axis] && at[axis] >= lattice.size[axis] as f64 { 1.0 } else { x }
    };
    let jet = blocks[*block].jet(std::array::from_fn(within));
    Some((jet.point, jet.first))
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{
        surface::DupinCyclide,
        volume::{CyclideGrid, SphericalCube, VolumeFrame},
    };

    fn areas(cut: &CutAway, inner: impl Fn(&cyclide::topology::BlockFace) -> bool) -> f64 {
        let shells = cut.shells.iter().flat_map(|shell| shell.shell.faces().iter().zip(&shell.faces));
        let patches = shells.filter(|(_, face)| inner(face)).filter_map(|(face, _)| face.surface.patch().copied());
        patches.map(|patch| cyclide::topology::Shell::from_surface(patch).unwrap().area()).sum()
    }

    /// An uneven box from the front right and above loses its upper right front eighth.
    #[test]
    fn the_corner_towards_the_eye_is_taken() {
        let corners: [Point3; 7] =
            std::array::from_fn(|k| Point3::new((k & 1) as f64, 2.0 * (k >> 1 & 1) as f64, 3.0 * (k >> 2) as f64));
        let block = CyclideVolume::new(&SphericalCube::new(corners).unwrap(), VolumeFrame::Auto).unwrap();
        let toward = Vec3::new(0.5, -0.8, 0.5);
        let cut = CutAway::new(&[block], None, toward).unwrap();
        let [shell] = &cut.shells[..] else { panic!("{} shells", cut.shells.len()) };
        assert!(shell.shell.is_closed() && (shell.shell.volume() - 6.0 * 7.0 / 8.0).abs() < 1e-12);
        let inner = |face: &cyclide::topology::BlockFace| (0.1..0.9).contains(&face.place);
        assert!((areas(&cut, inner) - (6.0 + 3.0 + 2.0) / 4.0).abs() < 1e-12);
        assert!(!shell.shell.vertices().contains(&Point3::new(1.0, 0.0, 3.0)));
        assert_eq!(cut.taken.len(), 3);
        // Cells of thirds are cut between them.
        let thirds = || vec![0.0, 0.3, 0.6, 1.0];
        let cut = CutAway::new(&[block], Some(&[thirds(), thirds(), thirds()]), toward).unwrap();
        let volume: f64 = cut.shells.iter().map(|shell| shell.shell.volume()).sum();
        assert!((volume - 6.0 * (1.0 - 0.4 * 0.6 * 0.4)).abs() < 1e-12, "{volume}");
        // One cell in all directions has no inside; one in two of them loses a layer.
        let one = || vec![0.0, 1.0];
        let cut = CutAway::new(&[block], Some(&[one(), one(), one()]), toward).unwrap();
        assert!((cut.shells[0].shell.volume() - 6.0).abs() < 1e-12 && cut.taken.is_empty());
        let cut = CutAway::new(&[block], Some(&[one(), one(), vec![0.0, 0.5, 1.0]]), toward).unwrap();
        assert!((cut.shells[0].shell.volume() - 3.0).abs() < 1e-12);
    }

    /// The wall of a tube closed both ways, in blocks that are cut nowhere: a notch of a quarter by a quarter in the outer one of two layers.
    #[test]
    fn a_ring_has_a_notch_outside() {
        let torus = DupinCyclide::new(3.0, 0.0, 1.0).unwrap();
        let grid = CyclideGrid::of_cyclide(&torus, [8, 8], &[-0.5, -0.2, 0.0]).unwrap();
        let blocks: Vec<CyclideVolume> = grid.blocks().collect();
        let cut = CutAway::new(&blocks, None, Vec3::new(0.5, -0.8, 0.5)).unwrap();
        let volume: f64 = cut.shells.iter().map(|shell| shell.shell.volume()).sum();
        let all: f64 = blocks.iter().map(|block| block.measure().volume).sum();
        assert!(cut.shells.iter().all(|shell| shell.shell.is_closed()));
        // The outer layer is about a half of it, of which the upper, outer side of the ring is more than a sixteenth.
        let part = 1.0 - volume / all;
        assert!((0.5 / 16.0 * 0.9..0.5 / 16.0 * 1.6).contains(&part), "{part}");
        let on = |axis: usize| areas(&cut, |face| face.axis == axis);
        assert!((0..3).all(|axis| on(axis) > 0.0));
    }
}
