//! Meshes of one sphere blend: rows of places, none shared with another triangle.

use super::super::surface_mesh::{MeshCorner, MeshFace, SurfaceMesh};
use super::{Divided, Place, Worst, cells, check_divisions, deviation, lambda, source};
use crate::error::Result;
use crate::mesh::MOST_PIECES;
use crate::surface::SphereBlend;

impl Divided for SphereBlend {
    fn triangle_count(&self) -> usize {
        1
    }

    fn deviation(&self, divisions: usize, _: Worst, _: f64) -> Result<Worst> {
        deviation::of_patch(divisions, |at| self.point(at)).map(|farthest| Worst { triangle: 0, farthest })
    }

    fn halved(&self, worst: Worst) -> Result<Worst> {
        let farthest = deviation::of_halves(worst.farthest, |at| self.point(at))?;
        Ok(Worst { farthest, ..worst })
    }

    fn mesh(&self, n: usize) -> Result<SurfaceMesh> {
        check_divisions(1, n, MOST_PIECES)?;
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        for i in 0..=n {
            for j in 0..=n - i {
                let at = lambda([i, j, n - i - j]);
                positions.push(self.point(at)?);
                normals.push(self.normal(at)?);
            }
        }
        // Row i begins behind rows of n + 1, n, ... places.
        let corner = |[i, j, _]: Place| {
            let index = i * (n + 1) - (i * i - i) / 2 + j;
            MeshCorner { position: index, normal: index }
        };
        let faces = cells(n).map(|cell| MeshFace::Triangle(cell.map(corner))).collect();
        let sources = cells(n).map(|cell| source(0, cell, n)).collect();
        Ok(SurfaceMesh { positions, normals, faces, sources, lost: Vec::new(), bound: f64::INFINITY, gap: 0.0 })
    }
}
