//! The block of a volume as a solid: six patches with shared edges; the outer boundary of many, and of parts of them; their coordinate surfaces.

use super::block_faces::{BlockFace, BlockFaces, FaceAt, Meeting};
use super::{Body, Shell};
use crate::error::{Error, ErrorItem, Result, ShellError, VolumeError};
use crate::volume::{CyclideVolume, FoldVerdict};
use std::collections::{HashMap, HashSet};

/// A shell of faces of blocks, with the place of each of them.
///
/// ```
/// use cyclide::{surface::DupinCyclide, volume::{CyclideGrid, CyclideVolume}};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?;
/// let wall: Vec<_> = CyclideGrid::of_cyclide(&torus, [4, 4], &[-0.5, 0.0])?.blocks().collect();
/// let whole = || vec![0.0, 1.0];
/// let half = CyclideVolume::boundary_of_parts(&wall, [whole(), whole(), whole()], |block, _| block % 4 < 2)?.remove(0);
/// assert!(half.faces.iter().all(|face| face.block % 4 < 2) && half.faces.len() == half.shell.faces().len());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BlockShell {
    /// The shell.
    pub shell: Shell,
    /// Where its faces are, in their order.
    pub faces: Vec<BlockFace>,
}

impl CyclideVolume {
    /// The block as a solid of its six [faces](Self::faces): s = 0, s = 1, t = 0, t = 1, u = 0, u = 1, outside outwards. Faces that are a line, of a wedge,
    /// are none of it.
    ///
    /// # Errors
    /// As [`Shell::new`](super::Shell::new).
    pub fn to_body(&self) -> Result<Body> {
        let faces = BlockFaces::new(std::slice::from_ref(self), whole())?;
        let own: Vec<FaceAt> = faces_of_part(0, [0; 3]).filter(|face| !faces.is_line(face)).collect();
        faces.sewn(&own, Meeting::Refused)?.finish_body()
    }

    /// The outer boundary of blocks that share faces, as bodies: the faces that belong to one block only, sewn along their sides. A solid for everything
    /// that hangs together, with the hollows inside it.
    ///
    /// ```
    /// use cyclide::{surface::DupinCyclide, volume::{CyclideGrid, CyclideVolume}};
    /// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?;
    /// let wall: Vec<_> = CyclideGrid::of_cyclide(&torus, [4, 4], &[-0.5, -0.2, 0.0])?.blocks().collect();
    /// let skin = CyclideVolume::outer_bodies(&wall)?.remove(0);
    /// assert_eq!((skin.outer.faces().len(), skin.voids.len()), (16, 1)); // of 192 faces
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Shell::new`]; `too-few-points` if there is no block, `folded-volume` with the block if one [folds](Self::folds).
    pub fn outer_bodies(blocks: &[Self]) -> Result<Vec<Body>> {
        for (index, block) in blocks.iter().enumerate() {
            if let FoldVerdict::Folded { at } = block.folds() {
                return Err(Error::from(VolumeError::Folded { at }).in_block(index));
            }
        }
        let faces = BlockFaces::new(blocks, whole())?;
        let alone = faces_alone(&faces, (0..blocks.len()).map(|block| (block, [0; 3])));
        let shells = faces.sewn(&alone, Meeting::Refused)?.finish_apart()?;
        solids(shells.into_iter().map(|(shell, _)| shell).collect())
    }

    /// The boundary of parts of blocks that share faces: blocks are cut at these parameters along s, t and u, rising, from 0 to 1, and of the parts those are
    /// taken that `is_there` says, by block and place among the cuts. Faces between two of them are left out; where the boundary touches itself in a
    /// side its faces have edges of their own there. A shell for everything that hangs together, outside outwards, voids as well.
    ///
    /// # Errors
    /// As [`StructuredGrid::new`](crate::volume::StructuredGrid::new) and [`Shell::new`].
    pub fn boundary_of_parts(
        blocks: &[Self],
        cuts: [Vec<f64>; 3],
        is_there: impl Fn(usize, [usize; 3]) -> bool,
    ) -> Result<Vec<BlockShell>> {
        let faces = BlockFaces::new(blocks, cuts)?;
        let all = (0..blocks.len()).flat_map(|block| faces.all_parts().map(move |part| (block, part)));
        let parts: Vec<(usize, [usize; 3])> = all.filter(|(block, part)| is_there(*block, *part)).collect();
        let alone = faces_alone(&faces, parts.into_iter());
        let shells = faces.sewn(&alone, Meeting::Apart)?.finish_apart()?;
        let placed = |(shell, own): (Shell, Vec<usize>)| BlockShell {
            shell,
            faces: own.into_iter().map(|face| faces.place(&alone[face])).collect(),
        };
        Ok(shells.into_iter().map(placed).collect())
    }

    /// The surfaces on which parameter `axis` (0, 1, 2 for s, t, u) has one of these values in a block, of all blocks: sewn to one open or closed body
    /// wherever they run on from block to block, in the order of the values and then of the blocks, each with its value. A face that two blocks have in common
    /// is there once. The outer side of open ones is that of the growing parameter. Surfaces that are a line are left out.
    ///
    /// ```
    /// use cyclide::{surface::DupinCyclide, volume::{CyclideGrid, CyclideVolume}};
    /// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?;
    /// let wall: Vec<_> = CyclideGrid::of_cyclide(&torus, [4, 4], &[-0.5, -0.2, 0.0])?.blocks().collect();
    /// let skins = CyclideVolume::coordinate_bodies(&wall, 2, &[0.0, 1.0])?; // of two layers
    /// assert!(skins.len() == 3 && skins.iter().all(|(_, skin)| skin.is_solid()));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`surface`](Self::surface), [`StructuredGrid::new`](crate::volume::StructuredGrid::new) and [`Shell::new`].
    ///
    /// # Panics
    /// If `axis` is above 2.
    pub fn coordinate_bodies(blocks: &[Self], axis: usize, values: &[f64]) -> Result<Vec<(f64, Body)>> {
        for x in values {
            Self::check_parameter(axis, *x)?;
        }
        let mut cuts = whole();
        // A zero has one sign.
        cuts[axis].extend(values.iter().map(|x| x + 0.0));
        cuts[axis].sort_by(f64::total_cmp);
        cuts[axis].dedup_by(|a, b| a.total_cmp(b).is_eq());
        let faces = BlockFaces::new(blocks, cuts.clone())?;
        let mut met = HashSet::new();
        let mut own = Vec::new();
        for x in values {
            let cut = cuts[axis].partition_point(|cut| cut < x);
            for block in 0..blocks.len() {
                let face = FaceAt { block, axis, cut, part: [0; 2], along: true };
                if !faces.is_line(&face) && met.insert(faces.middle(&face)) {
                    own.push(face);
                }
            }
        }
        let shells = faces.sewn(&own, Meeting::Apart)?.finish_apart()?;
        let body = |(shell, numbers): (Shell, Vec<usize>)| {
            let outer = if shell.is_closed() { shell.outside_out() } else { shell };
            let place = numbers.first().map_or(0.0, |first| faces.place(&own[*first]).place);
            (place, Body { outer, voids: Vec::new() })
        };
        Ok(shells.into_iter().map(body).collect())
    }
}

/// No cuts: blocks are their only parts.
fn whole() -> [Vec<f64>; 3] {
    std::array::from_fn(|_| vec![0.0, 1.0])
}

/// The six faces of a part, outside outwards.
fn faces_of_part(block: usize, part: [usize; 3]) -> impl Iterator<Item = FaceAt> {
    (0..6).map(move |face| {
        let (axis, end) = (face / 2, face % 2);
        let across = [[part[1], part[2]], [part[0], part[2]], [part[0], part[1]]][axis];
        FaceAt { block, axis, cut: part[axis] + end, part: across, along: end == 1 }
    })
}

/// The faces that one of these parts has alone, but for those that are lines.
fn faces_alone(faces: &BlockFaces<'_>, parts: impl Iterator<Item = (usize, [usize; 3])>) -> Vec<FaceAt> {
    let all: Vec<FaceAt> = parts.flat_map(|(block, part)| faces_of_part(block, part)).collect();
    let mut count: HashMap<usize, usize> = HashMap::new();
    for face in &all {
        *count.entry(faces.middle(face)).or_default() += 1;
    }
    all.into_iter().filter(|face| count.get(&faces.middle(face)) == Some(&1) && !faces.is_line(face)).collect()
}

/// Shells as bodies: faces are outward of the blocks, so those with a negative volume are hollows, each of the smallest solid around it.
fn solids(shells: Vec<Shell>) -> Result<Vec<Body>> {
    let (hollows, outers): (Vec<Shell>, Vec<Shell>) =
        shells.into_iter().partition(|shell| shell.is_closed() && shell.volume() < 0.0);
    let mut bodies: Vec<Body> = outers.into_iter().map(|outer| Body { outer, voids: Vec::new() }).collect();
    for hollow in hollows {
        let inside = hollow.bounds();
        let around = bodies
            .iter_mut()
            .filter(|body| body.outer.bounds().contains(inside))
            .min_by(|a, b| a.outer.volume().total_cmp(&b.outer.volume()));
        let detail = "its faces point inwards, and no shell encloses it";
        let body = around.ok_or(ShellError::NotAShell { item: ErrorItem::Face, index: 0, detail })?;
        body.voids.push(hollow);
    }
    Ok(bodies)
}
