//! Blocks over a grid of vertices: neighbors share faces, vertices and weights bit for bit.
//!
//! A vertex with point `a` and weight `w` stands for the pair `(a w, w)`, as of a [net](crate::surface::CyclidicNet); a block is that of its eight pairs
//! (`docs/math/volumes.md#grids`).

use super::cyclide_volume::{CyclideVolume, VolumeFrame, frame_at, runs_against};
use super::spherical_cube::SphericalCube;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, PointError, PoseError, Result};
use crate::surface::{CyclidicNet, DupinCyclide, GridCell, NetLayout, check_following_quad, on_corner_circle};

/// Blocks in a regular grid, whose coordinate surfaces run on smoothly from block to block.
///
/// ```
/// use cyclide::{surface::DupinCyclide, volume::{CyclideGrid, FoldVerdict}};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// let wall = CyclideGrid::layers(&torus, &[-0.5, -0.1, 0.0])?; // two layers below the skin of the tube
/// assert_eq!(wall.size(), [4, 4, 2]);
/// let volume: f64 = wall.blocks().map(|block| block.measure().volume).sum();
/// assert!((volume - 1.5 * std::f64::consts::PI.powi(2) * 3.0).abs() < 1e-9); // 2 pi R (pi - pi/4)
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CyclideGrid {
    /// Blocks along s, t and u.
    size: [usize; 3],
    /// Vertices, one more than blocks in every direction, s fastest; closed directions repeat their first ones.
    points: Vec<Point3>,
    weights: Vec<Quat>,
    v: [Vec3; 3],
    /// Which columns of blocks are left out, s fastest; empty if none is.
    left_out: Vec<bool>,
}

impl CyclideGrid {
    /// Layers over a net: the blocks between its offsets at these distances along its normals, which rise. All lines across are straight and
    /// normal to all layers. Of a closed net they close. Over quads without a patch there are no blocks.
    ///
    /// # Errors
    /// `too-few-points` (fewer than two distances), `not-finite`, `parameters-not-increasing`; with the quad `offset-on-focal-set` where an offset shrinks
    /// to a curve or a point, and `offset-not-regular` where layers reach a center of curvature, at which they would fold, with the nearest and its distance;
    /// `below-rounding-of-place` of a layer thinner than 1.5e-11 of the coordinates; `volume-through-infinity`.
    pub fn layers(net: &CyclidicNet, distances: &[f64]) -> Result<Self> {
        check_distances(distances)?;
        net.check_layers_regular(distances)?;
        let skins = distances.iter().map(|&h| net.offset(h)).collect::<Result<Vec<_>>>()?;
        Self::between(&skins.iter().collect::<Vec<_>>(), distances)
    }

    /// Layers over nets that join, one grid for each: where two of them join they share vertices bit for bit, and parameters, of which those along s
    /// and t are exchanged or run the other way where the pieces are turned.
    ///
    /// ```
    /// use cyclide::{Point3, surface::{NetLayout, QuadLayout}, volume::CyclideGrid};
    /// let points: Vec<_> = (0..6).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
    /// let net = NetLayout::new(QuadLayout::new(points, &[[0, 1, 4, 3], [1, 2, 5, 4]])?)?;
    /// let grids = CyclideGrid::layers_of_layout(&net, &[0.0, 0.1, 0.3])?;
    /// assert_eq!(grids.iter().map(|grid| grid.blocks().count()).sum::<usize>(), 4);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`layers`](Self::layers), quads counted in their piece.
    pub fn layers_of_layout(layout: &NetLayout, distances: &[f64]) -> Result<Vec<Self>> {
        check_distances(distances)?;
        layout.nets().iter().try_for_each(|net| net.check_layers_regular(distances))?;
        let skins = distances.iter().map(|&h| layout.offset(h)).collect::<Result<Vec<_>>>()?;
        let of_piece =
            |piece: usize| Self::between(&skins.iter().map(|skin| &skin.nets()[piece]).collect::<Vec<_>>(), distances);
        (0..layout.nets().len()).map(of_piece).collect()
    }

    /// The blocks between the offsets of a net at these distances.
    fn between(skins: &[&CyclidicNet], distances: &[f64]) -> Result<Self> {
        let net = skins[0];
        let [m, n] = net.size();
        let vertices = || (0..=n).flat_map(|j| (0..=m).map(move |i| (i, j)));
        let points: Vec<Point3> =
            skins.iter().flat_map(|skin| vertices().map(|(i, j)| skin.grid().point(i, j))).collect();
        let place = points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        for height in distances.windows(2).map(|pair| pair[1] - pair[0]) {
            range::check_size_in_place(ErrorItem::Layer, height, place, range::SMALLEST_IN_PLACE)?;
        }
        // Offsets have the weights of their net.
        let weights = skins.iter().flat_map(|_| vertices().map(|(i, j)| net.weight(i, j))).collect();
        let left_out = if net.grid().is_whole() {
            Vec::new()
        } else {
            (0..m * n).map(|k| net.grid().cell(k % m, k / m) != GridCell::Patch).collect()
        };
        Self { size: [m, n, distances.len() - 1], points, weights, v: net.frame(), left_out }.checked()
    }

    /// Layers over a whole cyclide between parallel ones: one grid, closed in both directions, of a ring; of a horn or a spindle one over its outer
    /// part, closed round the tube or round the hole, from node to node. With one distance below 0 and 0 it is the wall of the tube.
    ///
    /// ```
    /// use cyclide::{surface::DupinCyclide, volume::CyclideGrid};
    /// let ring = DupinCyclide::new(4.0, 1.0, 2.0)?;
    /// let wall = CyclideGrid::of_cyclide(&ring, [8, 6], &[-0.5, 0.0])?; // between mu = 1.5 and mu = 2
    /// assert_eq!(wall.size(), [8, 6, 1]);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`DupinCyclide::nets`] and [`layers`](Self::layers).
    pub fn of_cyclide(cyclide: &DupinCyclide, segments: [usize; 2], distances: &[f64]) -> Result<Self> {
        let nets = cyclide.nets(segments)?;
        // Of two parts the outer one is the last.
        let Some(net) = nets.last() else { return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into()) };
        Self::layers(net, distances)
    }

    /// The grid of its three coordinate planes and the frame at its first vertex: `point(i, j, k)` is asked where one of the indices is 0, from 0 to
    /// `size` in each direction, and there quads have circles; all other vertices follow, each as the last corner of a [cube](crate::volume::SphericalCube).
    /// [`VolumeFrame::Auto`] is that of the first block; the third direction of [`VolumeFrame::First`] is turned round where the third side runs against
    /// it, unless the grid would be refused then.
    ///
    /// # Errors
    /// `too-few-points` (a direction without a block), `not-finite`, `frame-not-orthonormal`, `ambiguous-frame`; what [`SphericalCube::new`](crate::volume::SphericalCube::new) refuses,
    /// with the block; `crossing-face`, `volume-through-infinity`.
    pub fn from_coordinate_planes(
        size: [usize; 3],
        point: impl Fn([usize; 3]) -> Point3,
        frame: VolumeFrame,
    ) -> Result<Self> {
        if let Some(&given) = size.iter().find(|n| **n == 0) {
            return Err(PointError::TooFewPoints { given: given + 1, needed: 2 }.into());
        }
        let mut grid = Self { size, points: Vec::new(), weights: Vec::new(), v: [Vec3::ZERO; 3], left_out: Vec::new() };
        for at in grid.vertices() {
            let made = if at.contains(&0) { point(at) } else { grid.last_of_cube(at)?.corners()[7] };
            range::check_point(grid.points.len(), made.to_vec())?;
            grid.points.push(made);
            if at.contains(&0) {
                grid.check_given(at)?;
            }
        }
        grid.check_following()?;
        let first = SphericalCube::new(grid.before([1; 3])).map_err(|e| e.in_block(0))?;
        let v = frame_at(&first, frame)?;
        if runs_against(&first, frame, v)
            && let Ok(turned) = grid.with_frame([v[0], v[1], -v[2]])
        {
            return Ok(turned);
        }
        grid.with_frame(v)
    }

    /// The grid with its points and this frame at the first one.
    fn with_frame(&self, v: [Vec3; 3]) -> Result<Self> {
        let mut grid = Self { weights: Vec::with_capacity(self.points.len()), v, ..self.clone() };
        for at in grid.vertices() {
            let weight = grid.next_weight(at)?;
            grid.weights.push(weight);
        }
        for (index, block) in grid.blocks().enumerate() {
            block.check_sides().map_err(|e| e.in_block(index))?;
        }
        grid.checked()
    }

    /// The seven vertices before one, in binary order.
    fn before(&self, at: [usize; 3]) -> [Point3; 7] {
        std::array::from_fn(|bits| self.points[self.index(std::array::from_fn(|d| at[d] - 1 + (bits >> d & 1)))])
    }

    /// The cube whose last corner is this vertex.
    fn last_of_cube(&self, at: [usize; 3]) -> Result<SphericalCube> {
        SphericalCube::of_computed(self.before(at)).map_err(|e| e.in_block(self.block_index(at.map(|x| x - 1))))
    }

    /// Refuses the given quad that ends at a vertex of the coordinate planes, if there is one.
    fn check_given(&self, at: [usize; 3]) -> Result<()> {
        for axis in (0..3).filter(|&axis| at[axis] == 0) {
            let Some(quad) = self.quad_before(at, axis) else { continue };
            let block = self.block_index(at.map(|x| x.saturating_sub(1)));
            on_corner_circle(&quad).map_err(|e| e.in_face_of_volume(axis, 0).in_block(block))?;
        }
        Ok(())
    }

    /// Refuses vertices that follow from given ones, but not as those of a grid: their faces are on circles as well as the given ones are.
    fn check_following(&self) -> Result<()> {
        let whole = self.points.iter().map(|p| p.distance(self.points[0])).fold(0.0, f64::max);
        for at in self.vertices().filter(|at| !at.contains(&0)) {
            let [i, j, k] = at;
            let given = i * j + i * k + j * k;
            for axis in 0..3 {
                let Some(quad) = self.quad_before(at, axis) else { continue };
                let block = self.block_index(at.map(|x| x - 1));
                check_following_quad(&quad, given, whole).map_err(|e| e.in_face_of_volume(axis, 1).in_block(block))?;
            }
        }
        Ok(())
    }

    /// The four vertices of the face across a direction that ends at this one, in binary order.
    fn quad_before(&self, at: [usize; 3], axis: usize) -> Option<[Point3; 4]> {
        let others: Vec<usize> = (0..3).filter(|&other| other != axis).collect();
        let corner = |k: usize| {
            let mut place = at;
            for (bit, &other) in others.iter().enumerate() {
                place[other] = (at[other] + (k >> bit & 1)).checked_sub(1)?;
            }
            Some(self.points[self.index(place)])
        };
        Some([corner(0)?, corner(1)?, corner(2)?, corner(3)?])
    }

    /// The weight of a vertex from those before it: along a side for the direction, over a face for the length.
    fn next_weight(&self, at: [usize; 3]) -> Result<Quat> {
        let back = |axis: usize| {
            let mut before = at;
            before[axis] -= 1;
            before
        };
        let known = |at: [usize; 3]| (self.points[self.index(at)], self.weights[self.index(at)]);
        let here = self.points[self.index(at)];
        // The longest side has its direction to the most digits.
        let mut axes: Vec<usize> = (0..3).filter(|&axis| at[axis] > 0).collect();
        axes.sort_by(|&x, &y| here.distance(known(back(y)).0).total_cmp(&here.distance(known(back(x)).0)));
        let [axis, ..] = *axes else { return Ok(Quat::ONE) };
        let (a1, w1) = known(back(axis));
        let chord = (here - a1).unit().ok_or(PointError::CoincidentPoints {
            first: self.index(back(axis)),
            second: self.index(at),
            distance: 0.0,
            limit: 0.0,
        })?;
        let turned = Quat::from(-chord) * w1 * Quat::from(self.v[axis]);
        let Some(&other) = axes.get(1) else { return Ok(turned * (w1.norm() / turned.norm())) };
        // The face of this vertex, its two neighbors and the one opposite.
        let (a2, w2) = known(back(other));
        let mut opposite = back(axis);
        opposite[other] -= 1;
        let (a0, w0) = known(opposite);
        let length = w1.norm() * w2.norm() / w0.norm() * (a1.distance(a2) / a0.distance(here));
        range::check_weight_ratio(length)?;
        Ok(turned * (length / turned.norm()))
    }

    fn checked(self) -> Result<Self> {
        for (index, block) in self.blocks().enumerate() {
            block.check_no_pole().map_err(|e| e.in_block(index))?;
        }
        Ok(self)
    }

    /// Blocks along s, t and u, those left out as well.
    #[must_use]
    pub fn size(&self) -> [usize; 3] {
        self.size
    }

    /// All vertices, s fastest, one more than blocks in every direction; no block is at those between columns that are left out.
    #[must_use]
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// Whether there is a block with these indices.
    #[must_use]
    pub fn has_block(&self, at: [usize; 3]) -> bool {
        let left_out = || self.left_out.get(at[0] + at[1] * self.size[0]).is_some_and(|left_out| *left_out);
        (0..3).all(|d| at[d] < self.size[d]) && !left_out()
    }

    /// The block with these indices.
    ///
    /// # Panics
    /// If there is no such block.
    #[must_use]
    pub fn block(&self, at: [usize; 3]) -> CyclideVolume {
        assert!(self.has_block(at), "block {at:?} of a grid of {:?}", self.size);
        let corner = |bits: usize| self.index(std::array::from_fn(|d| at[d] + (bits >> d & 1)));
        let corners: [usize; 8] = std::array::from_fn(corner);
        CyclideVolume::from_weights_unchecked(corners.map(|k| self.points[k]), corners.map(|k| self.weights[k]), self.v)
    }

    /// All blocks that are not left out, s fastest.
    pub fn blocks(&self) -> impl Iterator<Item = CyclideVolume> {
        let [m, n, l] = self.size;
        let all = (0..m * n * l).map(move |k| [k % m, k / m % n, k / m / n]);
        all.filter(|at| self.has_block(*at)).map(|at| self.block(at))
    }

    fn vertices(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [m, n, l] = self.size.map(|n| n + 1);
        (0..m * n * l).map(move |k| [k % m, k / m % n, k / m / n])
    }

    fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        let [m, n, _] = self.size;
        i + (j + k * (n + 1)) * (m + 1)
    }

    fn block_index(&self, [i, j, k]: [usize; 3]) -> usize {
        let [m, n, _] = self.size;
        i + (j + k * n) * m
    }
}

/// Refuses distances of which there are too few or which do not rise.
fn check_distances(distances: &[f64]) -> Result<()> {
    if distances.len() < 2 {
        return Err(PointError::TooFewPoints { given: distances.len(), needed: 2 }.into());
    }
    if let Some(index) = distances.iter().position(|h| !h.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::OffsetDistance, index }.into());
    }
    if let Some(k) = (1..distances.len()).find(|&k| !(distances[k] > distances[k - 1])) {
        return Err(
            PoseError::ParametersNotIncreasing { index: k, value: distances[k], before: distances[k - 1] }.into()
        );
    }
    Ok(())
}

impl CyclidicNet {
    /// Refuses layers that reach a center of curvature: what is regular as far as the outermost skins is so between.
    fn check_layers_regular(&self, distances: &[f64]) -> Result<()> {
        let ends = distances.first().into_iter().chain(distances.last());
        ends.filter(|h| **h != 0.0).try_for_each(|h| self.check_offset_regular(*h))
    }
}
