//! One mesh of quads over a surface with umbilics: they are extraordinary vertices of it, with six quads or with two
//! (`docs/math/principal-grids.md#joined`).

mod completion;
mod quad_borders;
mod quad_walk;
mod rounding;
mod slits;
mod umbilic_quads;

use super::cross_field::{CrossField, SingularVertex};
use super::jets::VertexJet;
use super::mesh_table::MeshTable;
use super::pieces::seeds;
use super::sheet::Sheet;
use super::walker::Walker;
use crate::base::vector::Point3;
use crate::error::{Error, JoinFault, LayoutFault};
use crate::surface::QuadLayout;
use quad_walk::{Centre, QuadWalk};
use slits::Slit;
use umbilic_quads::QuadMesh;

/// How much spreading weighs at least, against where the principal curvatures differ as usual: the first is best where it will do.
const EVENNESS: [f64; 3] = [0.3, 1.0, 4.0];
/// Umbilics at most: each has its slit, and its rounding.
const MOST_UMBILICS: usize = 64;
/// Triangles from which walks start.
const SEEDS: usize = 4;
/// Points at most.
const MOST_POINTS: usize = 2_000_000;

/// What the quads are laid on.
pub(super) struct Surface<'a> {
    pub(super) table: &'a MeshTable,
    pub(super) field: &'a CrossField,
    pub(super) singular: &'a [SingularVertex],
    /// The outer border.
    pub(super) outer: usize,
    pub(super) jets: &'a [VertexJet],
    /// Of the triangles.
    pub(super) weights: &'a [f64],
}

/// What stands against one mesh, and the umbilic concerned.
pub(super) struct NotJoined {
    pub(super) vertex: usize,
    pub(super) fault: JoinFault,
}

impl Surface<'_> {
    /// Quads with edges of a length in the mean, and the vertex of each umbilic that is one of their vertices.
    pub(super) fn joined(&self, edge: f64) -> Result<QuadLayout, NotJoined> {
        let refused = |vertex, fault| Err(NotJoined { vertex, fault });
        if let Some(other) = self.singular.iter().find(|s| s.halves.abs() != 1) {
            return refused(other.vertex, JoinFault::Turns);
        }
        if self.singular.len() > MOST_UMBILICS {
            return refused(self.singular[0].vertex, JoinFault::Many);
        }
        if self.table.borders.len() > 1 {
            return refused(self.singular[0].vertex, JoinFault::Holes);
        }
        let slits = match slits::slits(self.table, self.outer, self.singular) {
            Ok(slits) => slits,
            Err(vertex) => return refused(vertex, JoinFault::Coarse),
        };
        let mut best: Option<(usize, QuadLayout)> = None;
        let mut fault = JoinFault::Folded;
        let mut vertex = slits[0].centre.vertex;
        for evenness in EVENNESS {
            match self.attempt(&slits, edge, evenness) {
                // Nothing was made up: the least spreading that does is best.
                Ok((0, layout)) => return Ok(layout),
                Ok((made_up, layout)) => {
                    best = best.filter(|(least, _)| *least <= made_up).or(Some((made_up, layout)));
                }
                Err(refused) => (vertex, fault) = (refused.vertex, refused.fault),
            }
        }
        best.map(|(_, layout)| layout).ok_or(NotJoined { vertex, fault })
    }

    /// How many quads were made up beyond those round the umbilics, and the mesh.
    fn attempt(&self, slits: &[Slit], edge: f64, evenness: f64) -> Result<(usize, QuadLayout), NotJoined> {
        let refused = |fault| NotJoined { vertex: slits[0].centre.vertex, fault };
        let cuts: Vec<usize> = slits.iter().flat_map(|slit| slit.way.iter().copied()).collect();
        let mut sheet = Sheet::new(self.table, self.field, vec![true; self.table.triangles.len()], &cuts);
        let found = rounding::rounded(&sheet, self.weights, slits, edge, evenness).ok_or(refused(JoinFault::Folded))?;
        sheet.glue(&cuts);
        found.coordinates.leave_out_folded(&mut sheet);
        let open = sheet.active.clone();
        let walker = Walker { sheet: &sheet, coordinates: &found.coordinates, passages: &found.passages, open: &open };
        let centre = |(slit, at): (&Slit, &[f64; 2])| Centre { point: self.table.points[slit.centre.vertex], at: *at };
        let centres: Vec<Centre> = slits.iter().zip(&found.centres).map(centre).collect();
        let walks = seeds(&walker, SEEDS)
            .into_iter()
            .filter_map(|seed| QuadWalk::new(&walker, seed, found.steps, &centres, MOST_POINTS))
            .map(|walk| walk.quads());
        // Of several the first.
        let most = walks.reduce(|most, found| if found.1.len() > most.1.len() { found } else { most });
        let (places, quads) = most.ok_or(refused(JoinFault::Folded))?;
        let points: Vec<Point3> = places.iter().map(|place| walker.point(*place, self.jets)).collect();
        let mut mesh = QuadMesh::new(points, quads);
        let mut made_up = 0;
        let mut umbilics: Vec<(usize, usize)> = Vec::new();
        for slit in slits {
            if let Some((vertex, more)) = mesh.fill_round(slit.centre, self, edge) {
                umbilics.push((vertex, slit.centre.vertex));
                made_up += more;
            }
        }
        if umbilics.is_empty() {
            return Err(refused(JoinFault::Crowded));
        }
        let mesh = mesh.of_used(&mut umbilics);
        match QuadLayout::new(mesh.points, &mesh.quads) {
            Ok(layout) => Ok((made_up, layout)),
            Err(error) => {
                let (fault, index) = match error {
                    Error::NotAQuadLayout { fault: LayoutFault::Crowded, index } => (JoinFault::Crowded, Some(index)),
                    Error::CellsUnfit { .. } => (JoinFault::Crowded, None),
                    _ => (JoinFault::Folded, None),
                };
                let vertex = umbilics.iter().find(|(vertex, _)| Some(*vertex) == index).map(|(_, centre)| *centre);
                Err(NotJoined { vertex: vertex.unwrap_or(slits[0].centre.vertex), fault })
            }
        }
    }
}
