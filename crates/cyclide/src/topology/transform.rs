//! Möbius maps of shells and bodies: patches, edges and vertices under the same map.

use super::{Body, Shell, ShellEdge, ShellFace};
use crate::base::range;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{Error, ErrorItem, Result};

impl Conformal for Shell {
    /// The image. Its outer side is the image of the outer side: a map that reverses orientation reverses
    /// `f_s × f_t` against it.
    ///
    /// # Errors
    /// `not-a-similarity` for rational faces; `point-at-infinity`; as the `transformed` of patches and arcs; `below-rounding-of-place`; `not-a-shell` if rounding takes the parameters of
    /// shared edges apart.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let lost = |index| Error::at_infinity(ErrorItem::Vertex, index);
        let vertices = self.vertices.iter().enumerate().map(|(k, v)| map.map_point(*v).ok_or_else(|| lost(k)));
        let vertices = vertices.collect::<Result<Vec<_>>>()?;
        range::check_place(ErrorItem::Surface, &vertices)?;
        let edge = |edge: &ShellEdge| {
            // The ends are the vertices bit for bit.
            let curve = edge.curve.image(map, vertices[edge.start], vertices[edge.end])?;
            Ok(ShellEdge { curve, ..*edge })
        };
        let reversed = map.determinant() < 0.0;
        let face = |face: &ShellFace| {
            let same_sense = face.same_sense != reversed;
            Ok(ShellFace { surface: face.surface.image(map)?, same_sense, sides: face.sides })
        };
        let edges = self.edges.iter().map(edge).collect::<Result<_>>()?;
        let faces = self.faces.iter().map(face).collect::<Result<_>>()?;
        Self::new(vertices, edges, faces)
    }
}

impl Conformal for Body {
    /// The image of a body that does not hold the point that goes to infinity. If a hollow holds it, that hollow becomes
    /// the outside, and the outer shell the wall of a hollow.
    ///
    /// # Errors
    /// As those of its shells; `point-at-infinity` if a solid holds the point that goes to infinity.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let mut shells = self.shells().map(|shell| shell.transformed(map)).collect::<Result<Vec<_>>>()?;
        if self.is_solid() {
            // The outer sides still point away from the material: one shell has it inside, unless it reaches infinity.
            let around: Vec<usize> = (0..shells.len()).filter(|&k| shells[k].volume() > 0.0).collect();
            let [outer] = around[..] else { return Err(Error::at_infinity(ErrorItem::Surface, 0)) };
            shells.swap(0, outer);
        }
        let outer = shells.remove(0);
        Ok(Self { outer, voids: shells })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::vector::{Point3, Vec3};
    use crate::surface::{CyclidicNet, NetFrame, ParamSurface as _, QuadGrid};

    #[test]
    fn a_thick_shell_keeps_its_outer_side_under_reflections_and_inversions() {
        let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [2.0, 2.0, 0.0]].map(Point3::from);
        let grid = QuadGrid::new(points.to_vec(), [2, 2], [false, false]).unwrap();
        let (v1, v2) = (Vec3::new(0.8, 0.0, 0.6), Vec3::new(0.0, 1.0, 0.0));
        let body = CyclidicNet::new(grid, NetFrame::First(v1, v2)).unwrap().thick(0.2).unwrap();
        let volume = body.outer.volume();
        assert!(volume > 0.0);
        let mirror = Mobius::reflection(Point3::new(3.0, 0.0, 1.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
        let mirrored = body.transformed(&mirror).unwrap();
        assert!((mirrored.outer.volume() / volume - 1.0).abs() < 1e-11);
        let far = Mobius::inversion(Point3::new(5.0, 1.0, 4.0), 3.0).unwrap();
        let inverted = body.transformed(&far).unwrap();
        assert!(inverted.is_solid() && inverted.outer.volume() > 0.0);
        // And back.
        let back = inverted.transformed(&far).unwrap();
        assert!((back.outer.volume() / volume - 1.0).abs() < 1e-10);
        // A center inside the solid would turn it inside out.
        let face = &body.outer.faces()[0];
        let inward = face.outer_normal(0.5, 0.5).unwrap() * -0.1;
        let inside = Mobius::inversion(face.surface.point(0.5, 0.5) + inward, 1.0).unwrap();
        assert!(body.transformed(&inside).is_err());
    }
}
