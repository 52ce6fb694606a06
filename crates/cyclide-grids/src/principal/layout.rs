//! How a surface is spread out: open, closed along one family of lines, or cut from its singular places to the border.

use super::cross_field::{CrossField, SingularVertex};
use super::cuts::{Ways, left_corners};
use super::mesh_table::MeshTable;

/// How often, in halves, lines turn round in what would fill a loop of the border: the outer border of a roof, the ends of a tube.
const OUTSIDE: i32 = 4;
const ROUND: i32 = 2;

pub(super) struct Layout {
    /// Half edges that are cut.
    pub(super) cuts: Vec<usize>,
    /// Corners on the left of the seam, of a surface that comes back to itself.
    pub(super) left: Option<Vec<bool>>,
    /// The longest loop of the border, and the halves of each.
    pub(super) outer: usize,
    pub(super) halves: Vec<i32>,
}

impl Layout {
    /// `closes` is false where a surface that comes back to itself shall be cut.
    pub(super) fn new(table: &MeshTable, field: &CrossField, singular: &[SingularVertex], closes: bool) -> Self {
        let halves: Vec<i32> = table.borders.iter().map(|b| field.halves_of_border(table, b)).collect();
        let length = |k: usize| table.borders[k].iter().map(|half| table.vector(*half).length()).sum::<f64>();
        let outer = (0..halves.len()).max_by(|a, b| length(*a).total_cmp(&length(*b))).unwrap_or(0);
        let mut layout = Self { cuts: Vec::new(), left: None, outer, halves };
        let with = |n: i32| (0..layout.halves.len()).filter(|k| layout.halves[*k] == n).collect::<Vec<_>>();
        let (round, outside, holes) = (with(ROUND), with(OUTSIDE), with(0));
        let counted = round.len() + outside.len() + holes.len() == layout.halves.len();
        if singular.is_empty() && counted && outside.len() == 1 && round.is_empty() {
            layout.outer = outside[0];
            return layout;
        }
        if let ([from, to], true, true, 0, true) = (&round[..], singular.is_empty(), counted, outside.len(), closes) {
            layout.left = seam(table, *from, *to);
            if layout.left.is_some() {
                return layout;
            }
        }
        layout.cut_to_outer_border(table, singular);
        layout
    }

    fn cut_to_outer_border(&mut self, table: &MeshTable, singular: &[SingularVertex]) {
        let starts = |k: usize| table.borders[k].iter().map(|half| table.ends(*half)[0]);
        let ways = Ways::from(table, starts(self.outer), &vec![false; table.points.len()]);
        for s in singular {
            self.cuts.extend(ways.to(s.vertex, table));
        }
        for k in (0..self.halves.len()).filter(|k| *k != self.outer && self.halves[*k] != 0) {
            let nearest = starts(k).min_by(|a, b| ways.distance(*a).total_cmp(&ways.distance(*b)));
            self.cuts.extend(nearest.into_iter().flat_map(|v| ways.to(v, table)));
        }
    }
}

/// The corners on the left of the shortest way between two loops of the border.
fn seam(table: &MeshTable, from: usize, to: usize) -> Option<Vec<bool>> {
    let starts = |k: usize| table.borders[k].iter().map(|half| table.ends(*half)[0]);
    let mut closed = vec![false; table.points.len()];
    table.borders.iter().flatten().for_each(|half| closed[table.ends(*half)[0]] = true);
    let ways = Ways::from(table, starts(from), &closed);
    let end = starts(to).min_by(|a, b| ways.distance(*a).total_cmp(&ways.distance(*b)))?;
    let way = ways.to(end, table);
    (!way.is_empty()).then(|| left_corners(table, &way))
}
