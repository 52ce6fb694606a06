//! Offsets of nets, and the solids between a net and its offset.

use super::CyclidicNet;
use super::sew::{Sewing, Skin};
use crate::base::range;
use crate::base::vector::Point3;
use crate::curve::Arc;
use crate::error::{Error, Result};
use crate::surface::patch::CyclidePatch;
use crate::surface::quad_grid::QuadGrid;
use crate::surface::shell::{Body, FaceEdge, ShellFace};

impl CyclidicNet {
    /// The net at the signed distance `h` along the normals: the same weights over the vertices `a + h w V3 w^-1`, so
    /// every patch is the exact offset of its patch (`20`, section 3). An offset beyond a curvature centre is made all
    /// the same: [`singular_patches`](Self::singular_patches) and [`flipped_patches`](Self::flipped_patches) tell.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates above 1e150).
    pub fn offset(&self, h: f64) -> Result<Self> {
        if !h.is_finite() {
            return Err(Error::NotFinite { what: "offset distance", index: 0 });
        }
        let [m, n] = self.grid.size();
        let places = (0..n).flat_map(|j| (0..m).map(move |i| (i, j)));
        let moved = |(i, j)| self.grid.point(i, j) + self.vertex_frame(i, j)[2] * h;
        let points: Vec<Point3> = places.map(moved).collect();
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        let grid = QuadGrid::new(points, self.grid.size(), self.grid.closed())?;
        Ok(Self::from_weights_unchecked(grid, self.weights.clone(), self.v, self.turn))
    }

    /// The solid between the net and its offset at the signed distance `h`, outside outwards. A net that is closed in
    /// both directions gives an outer shell and a void. Open sides get rims along the normals, which are exact: over
    /// the side with pairs `(n, w)` the normals are those of the pairs `(n, w)`, `(n + h w V3, w)`, whose bilinear
    /// form is
    /// ```text
    /// (n(s) + tau h D(s) V3) D(s)^-1 = f(s) + tau h N(s)
    /// ```
    /// a principal patch (part of a cone, cylinder or plane, since a line of curvature has a constant angle with the
    /// surface) with the constant frame `V1, V3` along s and `V2, V3` along t, and with the same parameter as both
    /// skins on the edges it shares with them.
    ///
    /// # Errors
    /// As [`offset`](Self::offset); `parameter-out-of-range` for `h = 0`; `collapsed-side` if an open side of the net
    /// or of its offset is one point; `offset-not-regular` if a centre of curvature lies between, or a patch is singular
    /// inside.
    pub fn thick(&self, h: f64) -> Result<Body> {
        if h == 0.0 {
            let (min, max) = (range::MIN_DISTANCE, range::MAX_COORDINATE);
            return Err(Error::ParameterOutOfRange { name: "thickness", value: h, min, max });
        }
        let offset = self.offset(h)?;
        // The upper one is ahead along the normals.
        let [lower, upper] = if h > 0.0 { [self, &offset] } else { [&offset, self] };
        for net in [lower, upper] {
            if let Some(side) = net.collapsed_side() {
                return Err(Error::CollapsedSide { side, cannot: "the rim of a thick shell needs an edge there" });
            }
        }
        if let Some(quad) = self.patches().position(|patch| !patch.offset_is_regular(h)) {
            return Err(Error::OffsetNotRegular { distance: h }.in_quad(quad));
        }
        if self.grid.closed() == [true, true] {
            return between_closed(lower, upper);
        }
        let mut sewing = Sewing::default();
        let skins = [sewing.skin(lower, false)?, sewing.skin(upper, true)?];
        Rims { nets: [lower, upper], skins, rulings: vec![None; self.weights.len()] }.sew(&mut sewing)?;
        Ok(Body { outer: sewing.finish()?, voids: Vec::new() })
    }

    /// The name of an open side that is one point.
    fn collapsed_side(&self) -> Option<&'static str> {
        let ([m, n], closed) = (self.grid.size(), self.grid.closed());
        let point = |i: usize, j: usize| self.grid.point(i, j);
        let s_side = |i: usize| !closed[0] && (1..n).all(|j| point(i, j) == point(i, 0));
        let t_side = |j: usize| !closed[1] && (1..m).all(|i| point(i, j) == point(0, j));
        let sides = [("s = 0", s_side(0)), ("s = 1", s_side(m - 1)), ("t = 0", t_side(0)), ("t = 1", t_side(n - 1))];
        sides.into_iter().find_map(|(name, is)| is.then_some(name))
    }
}

/// Two closed nets with the material between them: the shell that encloses more is the outer one.
fn between_closed(lower: &CyclidicNet, upper: &CyclidicNet) -> Result<Body> {
    let shell = |net, same_sense| {
        let mut sewing = Sewing::default();
        sewing.skin(net, same_sense)?;
        sewing.finish()
    };
    let (below, above) = (shell(lower, false)?, shell(upper, true)?);
    let (outer, void) = if above.is_inside_out() { (below, above) } else { (above, below) };
    Ok(Body { outer, voids: vec![void] })
}

/// The rims between the open sides of two skins, the second ahead of the first along the normals.
struct Rims<'a> {
    nets: [&'a CyclidicNet; 2],
    skins: [Skin; 2],
    /// The edge along the normal at each vertex, once it is made.
    rulings: Vec<Option<usize>>,
}

impl Rims<'_> {
    fn sew(mut self, sewing: &mut Sewing) -> Result<()> {
        let ([m, n], closed) = (self.nets[0].grid().size(), self.nets[0].grid().closed());
        let quads = self.nets[0].size();
        if !closed[1] {
            for i in 0..quads[0] {
                self.rim(sewing, 0, [(i, 0), (i + 1, 0)], true)?;
                self.rim(sewing, 0, [(i, n - 1), (i + 1, n - 1)], false)?;
            }
        }
        if !closed[0] {
            for j in 0..quads[1] {
                self.rim(sewing, 1, [(0, j), (0, j + 1)], false)?;
                self.rim(sewing, 1, [(m - 1, j), (m - 1, j + 1)], true)?;
            }
        }
        Ok(())
    }

    /// The rim over one edge in direction `d`. Its normal is `V1 × V3 = -V2` along s, outwards on the side t=0, and
    /// `V2 × V3 = V1` along t, outwards on the side s=1.
    fn rim(&mut self, sewing: &mut Sewing, d: usize, ends: [(usize, usize); 2], same_sense: bool) -> Result<()> {
        let [lower, upper] = self.nets;
        let point = |net: &CyclidicNet, k: usize| net.grid().point(ends[k].0, ends[k].1);
        let corners = [point(lower, 0), point(lower, 1), point(upper, 0), point(upper, 1)];
        let [w0, w1] = ends.map(|(i, j)| lower.weight(i, j));
        let v = lower.frame();
        let patch = CyclidePatch::from_weights_unchecked(corners, [w0, w1, w0, w1], v[d], v[2]);
        let vertices = ends.map(|(i, j)| lower.grid().index(i, j));
        let edge = |skin: &Skin| [&skin.along_s, &skin.along_t][d][vertices[0]];
        let skins = [edge(&self.skins[0]), edge(&self.skins[1])];
        let rulings = [self.ruling(sewing, vertices[0])?, self.ruling(sewing, vertices[1])?].map(Some);
        let side = |edge: Option<usize>| edge.map(|edge| FaceEdge { edge, forward: true });
        let sides = [skins[0], skins[1], rulings[0], rulings[1]].map(side);
        sewing.face(ShellFace { patch, sides, same_sense });
        Ok(())
    }

    fn ruling(&mut self, sewing: &mut Sewing, vertex: usize) -> Result<usize> {
        if let Some(edge) = self.rulings[vertex] {
            return Ok(edge);
        }
        let [from, to] = [0, 1].map(|k| self.nets[k].grid().points()[vertex]);
        let [start, end] = [0, 1].map(|k| self.skins[k].vertices[vertex]);
        let edge = sewing.edge(start, end, Arc::segment(from, to)?);
        self.rulings[vertex] = Some(edge);
        Ok(edge)
    }
}
