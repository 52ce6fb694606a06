//! The solids between a net and its offset.

use super::Body;
use super::Sewing;
use super::sew::Skin;
use crate::base::range;
use crate::curve::Arc;
use crate::error::{Error, ErrorItem, Result};
use crate::surface::{CyclidePatch, CyclidicNet};
use std::collections::BTreeMap;

impl CyclidicNet {
    /// The solid between the net and its offset at the signed distance `h`, outside outwards. A net without open sides
    /// gives an outer shell and a void. Open sides get rims along the normals, which are exact: over
    /// the side with pairs `(n, w)` the normals are those of the pairs `(n, w)`, `(n + h w V3, w)`, whose bilinear
    /// form is
    /// ```text
    /// (n(s) + tau h D(s) V3) D(s)^-1 = f(s) + tau h N(s)
    /// ```
    /// a principal patch (part of a cone, cylinder or plane, since a line of curvature has a constant angle with the
    /// surface) with the constant frame `V1, V3` along s and `V2, V3` along t, and with the same parameter as both
    /// skins on the edges it shares with them. Over a side of one point the rim has three sides, and there is none
    /// where the side of the offset is one point too (a pole).
    ///
    /// # Errors
    /// As [`offset`](Self::offset), `below-rounding-of-place` also for a thickness below 1.5e-11 of the coordinates;
    /// `parameter-out-of-range` for `h = 0`; `collapsed-side` if the open side of a net
    /// that is closed in the other direction is one point (a node) in only one of both nets; `offset-not-regular` if a
    /// centre of curvature lies between, a patch is singular inside, or patches run against each other.
    pub fn thick(&self, h: f64) -> Result<Body> {
        if h == 0.0 {
            let (min, max) = (range::MIN_DISTANCE, range::MAX_COORDINATE);
            return Err(Error::ParameterOutOfRange { name: ErrorItem::Distance, value: h, min, max });
        }
        if h.is_finite() {
            self.check_between(h)?;
        }
        let offset = self.offset(h)?;
        let largest = |net: &Self| net.grid().points().iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let place = largest(self).max(largest(&offset));
        range::check_size_in_place(ErrorItem::Thickness, h.abs(), place, range::SMALLEST_IN_PLACE)?;
        // The upper one is ahead along the normals, and outside is its f_s × f_t unless the patches are flipped.
        let [lower, upper] = if h > 0.0 { [self, &offset] } else { [&offset, self] };
        let along = !self.first_is_flipped();
        for (d, (below, above)) in lower.sides_of_one_point().into_iter().zip(upper.sides_of_one_point()).enumerate() {
            let names = [["s = 0", "s = 1"], ["t = 0", "t = 1"]][d];
            if let Some(k) = (0..2).find(|&k| self.grid().closed()[1 - d] && below[k] != above[k]) {
                let cannot = "the rim of a thick shell would be a cone that touches a skin with its tip only";
                return Err(Error::CollapsedSide { side: names[k], cannot });
            }
        }
        let mut sewing = Sewing::default();
        let skins = [sewing.skin(lower, !along)?, sewing.skin(upper, along)?];
        let rims = Rims { nets: [lower, upper], skins, along, rulings: BTreeMap::new() };
        if rims.sew(&mut sewing)? == 0 {
            return between_closed([lower, upper], along);
        }
        Ok(Body { outer: sewing.finish()?, voids: Vec::new() })
    }

    /// Refuses distances beyond a curvature centre, and nets whose patches do not all have `f_s × f_t` on the same side.
    fn check_between(&self, h: f64) -> Result<()> {
        let flipped = self.first_is_flipped();
        if let Some((quad, _)) = self.patches_with_quads().find(|(_, patch)| patch.is_flipped() != flipped) {
            return Err(Error::OffsetNotRegular { distance: h, limit: 0.0 }.in_quad(self.number(quad)));
        }
        self.check_offset_regular(h)
    }

    fn first_is_flipped(&self) -> bool {
        self.patches().next().is_some_and(|patch| patch.is_flipped())
    }

    /// Which of the open sides s = 0, s = 1 and t = 0, t = 1 are one point.
    fn sides_of_one_point(&self) -> [[bool; 2]; 2] {
        let ([m, n], closed) = (self.grid().size(), self.grid().closed());
        let point = |i: usize, j: usize| self.grid().point(i, j);
        let closed = if self.grid().is_whole() { closed } else { [true; 2] };
        let s_side = |i: usize| !closed[0] && (1..n).all(|j| point(i, j) == point(i, 0));
        let t_side = |j: usize| !closed[1] && (1..m).all(|i| point(i, j) == point(0, j));
        [[s_side(0), s_side(m - 1)], [t_side(0), t_side(n - 1)]]
    }
}

/// Two closed nets with the material between them, outside on `f_s × f_t` of the second if `along`: the shell that
/// encloses more is the outer one.
fn between_closed([lower, upper]: [&CyclidicNet; 2], along: bool) -> Result<Body> {
    let shell = |net, same_sense| {
        let mut sewing = Sewing::default();
        sewing.skin(net, same_sense)?;
        sewing.finish()
    };
    let (below, above) = (shell(lower, !along)?, shell(upper, along)?);
    let (outer, void) = if above.is_inside_out() { (below, above) } else { (above, below) };
    Ok(Body { outer, voids: vec![void] })
}

/// The rims between the open sides of two skins, the second ahead of the first along the normals.
struct Rims<'a> {
    nets: [&'a CyclidicNet; 2],
    skins: [Skin; 2],
    /// True if the normals are those of `f_s × f_t`.
    along: bool,
    /// The edges along the normals that were made, by their vertices.
    rulings: BTreeMap<[usize; 2], usize>,
}

impl Rims<'_> {
    /// Adds the rims, and says how many.
    fn sew(mut self, sewing: &mut Sewing) -> Result<usize> {
        let grid = self.nets[0].grid();
        let [m, n] = grid.size();
        let mut made = 0;
        // Over every edge with a patch on one side only.
        for (i, j) in (0..m).flat_map(|i| (0..n).map(move |j| (i, j))) {
            match grid.patches_beside([i, j], 0) {
                [false, true] => made += self.rim(sewing, 0, [(i, j), (i + 1, j)], self.along)?,
                [true, false] => made += self.rim(sewing, 0, [(i, j), (i + 1, j)], !self.along)?,
                _ => {}
            }
        }
        for (i, j) in (0..n).flat_map(|j| (0..m).map(move |i| (i, j))) {
            match grid.patches_beside([i, j], 1) {
                [false, true] => made += self.rim(sewing, 1, [(i, j), (i, j + 1)], !self.along)?,
                [true, false] => made += self.rim(sewing, 1, [(i, j), (i, j + 1)], self.along)?,
                _ => {}
            }
        }
        Ok(made)
    }

    /// The rim over one edge in direction `d`; the number made, 0 over a pole. Its normal is `V1 × V3 = -V2` along s,
    /// outwards on the side t=0, and `V2 × V3 = V1` along t, outwards on the side s=1; the other way where the lines of
    /// one family run against the frame.
    fn rim(&mut self, sewing: &mut Sewing, d: usize, ends: [(usize, usize); 2], same_sense: bool) -> Result<usize> {
        let [lower, upper] = self.nets;
        let point = |net: &CyclidicNet, k: usize| net.grid().point(ends[k].0, ends[k].1);
        let corners = [point(lower, 0), point(lower, 1), point(upper, 0), point(upper, 1)];
        let [w0, w1] = ends.map(|(i, j)| lower.weight(i, j));
        let v = lower.frame();
        let patch = CyclidePatch::from_weights_unchecked(corners, [w0, w1, w0, w1], v[d], v[2]);
        let vertices = ends.map(|(i, j)| lower.grid().index(i, j));
        let edge = |skin: &Skin| [&skin.along_s, &skin.along_t][d][vertices[0]];
        let skins = [edge(&self.skins[0]), edge(&self.skins[1])];
        if skins == [None, None] {
            return Ok(0);
        }
        let rulings = [self.ruling(sewing, vertices[0])?, self.ruling(sewing, vertices[1])?].map(Some);
        sewing.face(patch, [skins[0], skins[1], rulings[0], rulings[1]], same_sense);
        Ok(1)
    }

    /// The edge along the normal at a vertex of the grid.
    fn ruling(&mut self, sewing: &mut Sewing, vertex: usize) -> Result<usize> {
        let [start, end] = [0, 1].map(|k| self.skins[k].vertices[vertex]);
        if let Some(edge) = self.rulings.get(&[start, end]) {
            return Ok(*edge);
        }
        let [from, to] = [0, 1].map(|k| self.nets[k].grid().points()[vertex]);
        let edge = sewing.edge(start, end, Arc::segment(from, to)?);
        self.rulings.insert([start, end], edge);
        Ok(edge)
    }
}
