//! One mesh of quads over a surface with umbilics: they are extraordinary vertices of it, with six quads or with two
//! (`docs/math/principal-grids.md#joined`).

mod completion;
mod quad_borders;
mod quad_walk;
mod rounding;
mod slits;
mod umbilic_quads;

use super::coordinates::Coordinates;
use super::cross_field::{CrossField, SingularVertex};
use super::jets::VertexJet;
use super::mesh_table::MeshTable;
use super::pieces::{far_from, seeds};
use super::sheet::Sheet;
use super::walker::Walker;
use cyclide::Point3;
use cyclide::surface::QuadLayout;
use cyclide::{
    Error,
    error::{GridError, JoinFault, LayoutFault},
};
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
/// Lines farther off the principal directions are off them: 15 degrees, where the difference of the curvatures is more than this part of
/// the usual one, and farther than this many edges from umbilics.
pub(super) const OFF: f64 = std::f64::consts::PI / 12.0;
const CLEAR: f64 = 0.3;
const BESIDE: f64 = 2.0;
/// Umbilics nearer than this many edges of the surface's mesh are one that the mesh splits.
const ONE_UMBILIC: f64 = 5.0;
/// Umbilics nearer than this many edges to each other, or half as many to the border, have no room for their quads.
const CROWDED: f64 = 6.0;

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

/// One mesh.
pub(super) struct Joined {
    pub(super) layout: QuadLayout,
    /// The umbilics that it does not go round.
    pub(super) left_out: Vec<usize>,
    /// The part of the surface where lines of the mesh are far off the lines of curvature.
    pub(super) off_lines: f64,
    /// Quads that were made up beyond those at the umbilics.
    made_up: usize,
}

impl Surface<'_> {
    /// Quads with edges of a length in the mean, with umbilics as vertices.
    pub(super) fn joined(&self, edge: f64) -> Result<Joined, NotJoined> {
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
        let mut best: Option<Joined> = None;
        let mut fault = NotJoined { vertex: slits[0].centre.vertex, fault: JoinFault::Folded };
        for evenness in EVENNESS {
            match self.attempt(&slits, edge, evenness) {
                // Nothing was made up and nothing left out: the least spreading that does is best.
                Ok(found) if found.cost() == (0, 0) => return Ok(found),
                Ok(found) => best = best.filter(|best| best.cost() <= found.cost()).or(Some(found)),
                Err(refused) => fault = refused,
            }
        }
        best.ok_or(fault)
    }

    fn attempt(&self, slits: &[Slit], edge: f64, evenness: f64) -> Result<Joined, NotJoined> {
        let refused = |fault| NotJoined { vertex: slits[0].centre.vertex, fault };
        let cuts: Vec<usize> = slits.iter().flat_map(|slit| slit.way.iter().copied()).collect();
        let mut sheet = Sheet::new(self.table, self.field, vec![true; self.table.triangles.len()], &cuts);
        let found = rounding::rounded(&sheet, self.weights, slits, edge, evenness).ok_or(refused(JoinFault::Folded))?;
        sheet.glue(&cuts);
        let off_lines = self.off_lines(&sheet, &found.coordinates, edge);
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
        let (mut made_up, mut left_out) = (0, Vec::new());
        let mut umbilics: Vec<(usize, usize)> = Vec::new();
        for umbilic in slits.iter().map(|slit| slit.centre) {
            match mesh.fill_round(umbilic, self, edge) {
                Some((vertex, more)) => {
                    umbilics.push((vertex, umbilic.vertex));
                    made_up += more;
                }
                None => left_out.push(umbilic.vertex),
            }
        }
        if umbilics.is_empty() {
            return Err(self.tightest(edge));
        }
        let mesh = mesh.of_used(&mut umbilics);
        if mesh.is_folded(&umbilics, self, edge) {
            return Err(refused(JoinFault::Folded));
        }
        match QuadLayout::new(mesh.points, &mesh.quads) {
            Ok(layout) => Ok(Joined { layout, left_out, off_lines, made_up }),
            Err(Error::Grid(
                GridError::NotAQuadLayout { fault: LayoutFault::Crowded, .. } | GridError::CellsUnfit { .. },
            )) => Err(self.tightest(edge)),
            Err(_) => Err(refused(JoinFault::Folded)),
        }
    }

    /// The part of the area, where the principal curvatures differ clearly and away from umbilics, on which coordinate lines are far off
    /// the principal directions.
    fn off_lines(&self, sheet: &Sheet<'_>, coordinates: &Coordinates, edge: f64) -> f64 {
        let umbilics: Vec<Point3> = self.singular.iter().map(|s| self.table.points[s.vertex]).collect();
        let far = far_from(self.table, &umbilics, BESIDE * edge);
        let (mut all, mut off) = (0.0, 0.0);
        for f in (0..far.len()).filter(|f| far[*f] && self.weights[*f] >= CLEAR) {
            let area = self.table.areas[f];
            all += area;
            if coordinates.angle_off(sheet, f) > OFF {
                off += area;
            }
        }
        off / f64::max(all, f64::MIN_POSITIVE)
    }

    /// The umbilic with the least room, and what it is too near to, if it is.
    fn tightest(&self, edge: f64) -> NotJoined {
        let table = self.table;
        let spacing = (table.areas.iter().sum::<f64>() / table.points.len() as f64).sqrt();
        let border = || table.borders.iter().flatten().map(|half| table.points[table.ends(*half)[0]]);
        let room = |s: &SingularVertex| {
            let p = table.points[s.vertex];
            let others = self.singular.iter().filter(|other| other.vertex != s.vertex);
            let nearest = |same: bool| {
                let alike = others.clone().filter(|other| !same || other.halves == s.halves);
                alike.map(|other| table.points[other.vertex].distance(p)).fold(f64::INFINITY, f64::min)
            };
            let to_border = border().map(|q| q.distance(p)).fold(f64::INFINITY, f64::min);
            let fault = if nearest(true) < ONE_UMBILIC * spacing {
                JoinFault::Turns
            } else if nearest(false).min(2.0 * to_border) < CROWDED * edge {
                JoinFault::Crowded
            } else {
                JoinFault::Folded
            };
            (nearest(false).min(2.0 * to_border), NotJoined { vertex: s.vertex, fault })
        };
        let rooms = self.singular.iter().map(room);
        let least = rooms.reduce(|least, room| if room.0 < least.0 { room } else { least });
        least.map_or(NotJoined { vertex: 0, fault: JoinFault::Folded }, |(_, refused)| refused)
    }
}

impl Joined {
    /// What is better less.
    fn cost(&self) -> (usize, usize) {
        (self.left_out.len(), self.made_up)
    }
}
