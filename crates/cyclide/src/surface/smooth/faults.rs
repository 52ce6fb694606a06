//! What should be known of a smooth mesh: normals that fit no surface, folds, edges that were smoothed away
//! (`docs/math/triangle-surfaces.md#what-is-warned-of`).

use super::{SmoothEdge, SmoothMesh, SmoothTriangle};
use crate::surface::barycentric::Barycentric;
use crate::warning::{MeshWarning, Warning};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Places of an edge at which it is looked for folds.
const ALONG: [f64; 7] = [0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98];
/// Edges with larger angles between their triangles were not meant to be smooth, radians: 45 degrees.
const SHARP: f64 = FRAC_PI_4;

impl SmoothMesh {
    /// What should be known of the surface: `normal-faces-backward`, `folds-back`, `sharp-edges-smoothed`, `open-seam`. Looks along all
    /// edges, which takes about as long as making the surface.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let found = [self.backward.clone(), self.folds(), self.smoothed_edges(), self.loose_borders()];
        found.into_iter().flatten().collect()
    }

    /// Edges at which a triangle runs backwards: the normal of its derivatives is against that of the surface.
    fn folds(&self) -> Option<Warning> {
        let mut count = 0;
        let mut worst: Option<(&SmoothEdge, usize, f64)> = None;
        for edge in &self.edges {
            let sides = [Some(edge.first), edge.second].into_iter().flatten();
            let turned = sides.map(|side| {
                let ends = side.ends();
                (side.triangle, self.patch(side.triangle).largest_turn(ends))
            });
            let Some((triangle, angle)) = turned.max_by(|a, b| a.1.total_cmp(&b.1)) else { continue };
            if angle > FRAC_PI_2 {
                count += 1;
                if worst.is_none_or(|(_, _, largest)| angle > largest) {
                    worst = Some((edge, triangle, angle));
                }
            }
        }
        let (edge, triangle, angle) = worst?;
        Some(Warning::Mesh(MeshWarning::FoldsBack { vertices: edge.vertices, triangle, angle, count }))
    }

    /// Sharp edges that means of normals made smooth.
    fn smoothed_edges(&self) -> Option<Warning> {
        if !self.averaged {
            return None;
        }
        let flat = |triangle: usize| {
            let [a, b, c] = self.triangles[triangle].map(|v| self.positions[v]);
            let directions = (b - a).unit().zip((c - a).unit());
            directions.and_then(|(u, v)| u.cross(v).unit()).unwrap_or_default()
        };
        let angles = self.edges.iter().filter_map(|edge| {
            let angle = flat(edge.first.triangle).angle(flat(edge.second?.triangle));
            (angle > SHARP).then_some((edge.vertices, angle))
        });
        let mut count = 0;
        let mut worst: Option<([usize; 2], f64)> = None;
        for (vertices, angle) in angles {
            count += 1;
            if worst.is_none_or(|(_, largest)| angle > largest) {
                worst = Some((vertices, angle));
            }
        }
        let (vertices, angle) = worst?;
        Some(Warning::Mesh(MeshWarning::SharpEdgesSmoothed { vertices, angle, count, limit: SHARP }))
    }
}

impl SmoothTriangle {
    /// The largest angle between the normal of the derivatives and that of the surface along the side between two corners. Where either is not
    /// defined nothing is said.
    fn largest_turn(&self, [from, to]: [usize; 2]) -> f64 {
        let turn = |mu: f64| {
            let mut place = [0.0; 3];
            (place[from], place[to]) = (1.0 - mu, mu);
            let jet = Barycentric::new(place).and_then(|at| self.jet(&at)).ok()?;
            let own = jet.derivatives[0].cross(jet.derivatives[1]).unit()?;
            Some(own.angle(self.normal(place).ok()?))
        };
        ALONG.into_iter().filter_map(turn).fold(0.0, f64::max)
    }
}
