//! The solids between a net and its offset.

use super::sew::Skin;
use super::{Body, FaceEdge, Sewing};
use crate::base::range;
use crate::curve::Arc;
use crate::error::{Error, ErrorItem, NumberError, PatchError, Result};
use crate::surface::{CyclidePatch, CyclidicNet, NetLayout};
use std::collections::{BTreeMap, HashMap};

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
    /// center of curvature lies between, a patch is singular inside, or patches run against each other.
    pub fn thick(&self, h: f64) -> Result<Body> {
        check_thickness(h)?;
        if h.is_finite() {
            self.check_between(h)?;
        }
        let offset = self.offset(h)?;
        check_place(h, &[self, &offset])?;
        // The upper one is ahead along the normals, and outside is its f_s × f_t unless the patches are flipped.
        let [lower, upper] = if h > 0.0 { [self, &offset] } else { [&offset, self] };
        let along = !self.first_is_flipped();
        for (d, (below, above)) in lower.sides_of_one_point().into_iter().zip(upper.sides_of_one_point()).enumerate() {
            let names = [["s = 0", "s = 1"], ["t = 0", "t = 1"]][d];
            if let Some(k) = (0..2).find(|&k| self.grid().closed()[1 - d] && below[k] != above[k]) {
                let cannot = "the rim of a thick shell would be a cone that touches a skin with its tip only";
                return Err(PatchError::CollapsedSide { side: names[k], cannot }.into());
            }
        }
        let mut sewing = Sewing::default();
        let skins = [sewing.skin(lower, !along)?, sewing.skin(upper, along)?];
        let rims = Rims { nets: [lower, upper], skins: [&skins[0], &skins[1]], along };
        if rims.sew(&mut sewing, &mut BTreeMap::new(), |_| false)? == 0 {
            return between_closed([lower, upper], along);
        }
        Ok(Body { outer: sewing.finish()?, voids: Vec::new() })
    }

    /// Refuses distances beyond a curvature center, and nets whose patches do not all have `f_s × f_t` on the same side.
    fn check_between(&self, h: f64) -> Result<()> {
        let flipped = self.first_is_flipped();
        if let Some((quad, _)) = self.patches_with_quads().find(|(_, patch)| patch.is_flipped() != flipped) {
            return Err(
                Error::from(PatchError::OffsetNotRegular { distance: h, limit: 0.0 }).in_quad(self.number(quad))
            );
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

impl NetLayout {
    /// The solid between the nets and their offsets at the signed distance `h`, outside outwards, with rims over the border and round the
    /// openings at extraordinary vertices: see [`CyclidicNet::thick`].
    ///
    /// # Errors
    /// As [`CyclidicNet::thick`].
    pub fn thick(&self, h: f64) -> Result<Body> {
        check_thickness(h)?;
        if h.is_finite() {
            self.nets().iter().try_for_each(|net| net.check_between(h))?;
        }
        let offset = self.offset(h)?;
        check_place(h, &self.nets().iter().chain(offset.nets()).collect::<Vec<_>>())?;
        let [lower, upper] = if h > 0.0 { [self, &offset] } else { [&offset, self] };
        let along = !self.nets()[0].first_is_flipped();
        if let Some(net) = self.nets().iter().find(|net| net.first_is_flipped() == along) {
            // Nets that run against each other.
            net.check_between(h)?;
            return Err(PatchError::OffsetNotRegular { distance: h, limit: 0.0 }.into());
        }
        let mut sewing = Sewing::default();
        let skins = [sewing.skins(lower, !along)?, sewing.skins(upper, along)?];
        let mut faces: HashMap<usize, usize> = HashMap::new();
        let sides = sewing.faces.iter().flat_map(|face| face.sides).flatten();
        sides.for_each(|side| *faces.entry(side.edge).or_default() += 1);
        let mut rulings = BTreeMap::new();
        for (k, nets) in lower.nets().iter().zip(upper.nets()).enumerate() {
            let rims = Rims { nets: [nets.0, nets.1], skins: [&skins[0][k], &skins[1][k]], along };
            // On the other side of the edge is another net.
            rims.sew(&mut sewing, &mut rulings, |edge| faces.get(&edge) == Some(&2))?;
        }
        Ok(Body { outer: sewing.finish()?, voids: Vec::new() })
    }
}

fn check_thickness(h: f64) -> Result<()> {
    if h == 0.0 {
        let (min, max) = (range::MIN_DISTANCE, range::MAX_COORDINATE);
        return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Distance, value: h, min, max }.into());
    }
    Ok(())
}

/// Refuses a thickness that is below the rounding of the vertices.
fn check_place(h: f64, nets: &[&CyclidicNet]) -> Result<()> {
    let points = nets.iter().flat_map(|net| net.grid().points());
    let place = points.map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    range::check_size_in_place(ErrorItem::Thickness, h.abs(), place, range::SMALLEST_IN_PLACE)
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
    skins: [&'a Skin; 2],
    /// True if the normals are those of `f_s × f_t`.
    along: bool,
}

/// The edges along the normals that were made, by their vertices.
type Rulings = BTreeMap<[usize; 2], usize>;

impl Rims<'_> {
    /// Adds the rims, and says how many; none over edges of the lower skin that are `joined` to another net.
    fn sew(&self, sewing: &mut Sewing, rulings: &mut Rulings, joined: impl Fn(usize) -> bool) -> Result<usize> {
        let grid = self.nets[0].grid();
        let [m, n] = grid.size();
        let mut made = 0;
        // Over every edge with a patch on one side only, first those along s.
        let along_s = (0..m).flat_map(|i| (0..n).map(move |j| (0, [i, j])));
        let along_t = (0..n).flat_map(|j| (0..m).map(move |i| (1, [i, j])));
        for (d, [i, j]) in along_s.chain(along_t) {
            // Outwards where only the patch behind the edge is there.
            let outwards = if d == 0 { self.along } else { !self.along };
            let same_sense = match grid.patches_beside([i, j], d) {
                [false, true] => outwards,
                [true, false] => !outwards,
                _ => continue,
            };
            let edge = [&self.skins[0].along_s, &self.skins[0].along_t][d][grid.index(i, j)];
            if edge.is_some_and(|side| joined(side.edge)) {
                continue;
            }
            let end = if d == 0 { (i + 1, j) } else { (i, j + 1) };
            made += self.rim((sewing, rulings), d, [(i, j), end], same_sense)?;
        }
        Ok(made)
    }

    /// The rim over one edge in direction `d`; the number made, 0 over a pole. Its normal is `V1 × V3 = -V2` along s,
    /// outwards on the side t=0, and `V2 × V3 = V1` along t, outwards on the side s=1; the other way where the lines of
    /// one family run against the frame.
    fn rim(
        &self,
        (sewing, rulings): (&mut Sewing, &mut Rulings),
        d: usize,
        ends: [(usize, usize); 2],
        same_sense: bool,
    ) -> Result<usize> {
        let [lower, upper] = self.nets;
        let point = |net: &CyclidicNet, k: usize| net.grid().point(ends[k].0, ends[k].1);
        let corners = [point(lower, 0), point(lower, 1), point(upper, 0), point(upper, 1)];
        let [w0, w1] = ends.map(|(i, j)| lower.weight(i, j));
        let v = lower.frame();
        let patch = CyclidePatch::from_weights_unchecked(corners, [w0, w1, w0, w1], v[d], v[2]);
        let vertices = ends.map(|(i, j)| lower.grid().index(i, j));
        let skins = self.skins.map(|skin| [&skin.along_s, &skin.along_t][d][vertices[0]]);
        if skins == [None, None] {
            return Ok(0);
        }
        let mut ruling = |vertex| {
            self.ruling((&mut *sewing, &mut *rulings), vertex).map(|edge| Some(FaceEdge { edge, forward: true }))
        };
        let sides = [skins[0], skins[1], ruling(vertices[0])?, ruling(vertices[1])?];
        sewing.face_along(patch, sides, same_sense);
        Ok(1)
    }

    /// The edge along the normal at a vertex of the grid.
    fn ruling(&self, (sewing, rulings): (&mut Sewing, &mut Rulings), vertex: usize) -> Result<usize> {
        let [start, end] = self.skins.map(|skin| skin.vertices[vertex]);
        if let Some(edge) = rulings.get(&[start, end]) {
            return Ok(*edge);
        }
        let [from, to] = self.nets.map(|net| net.grid().points()[vertex]);
        let edge = sewing.edge(start, end, Arc::segment(from, to)?);
        rulings.insert([start, end], edge);
        Ok(edge)
    }
}
