//! Similar surfaces over triangles.

use super::{SharpEdges, SmoothMesh, VertexNormals};
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{Error, ErrorItem, PointError, Result};
use crate::surface::{SphereBlend, TriangleSurface};

/// The corner that becomes a corner, of triangles that a reflection turns over.
const TURNED: [usize; 3] = [0, 2, 1];

impl TriangleSurface {
    /// The image under a similarity, reflections among them: its outer side is the image of the outer side.
    ///
    /// # Errors
    /// `not-a-similarity`; as [`SmoothMesh::new`], where the image is too small or too large for numbers.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        map.check_similarity()?;
        match self {
            Self::Mesh(mesh) => mesh.similar(map).map(Self::Mesh),
            Self::Blend(blend) => blend.similar(map).map(Self::Blend),
        }
    }
}

impl SmoothMesh {
    fn similar(&self, map: &Mobius) -> Result<Self> {
        let turned = map.determinant() < 0.0;
        let order = if turned { TURNED } else { [0, 1, 2] };
        let triangles: Vec<[usize; 3]> = self.triangles.iter().map(|t| order.map(|k| t[k])).collect();
        // Vertices without a triangle may be anything.
        let positions: Vec<Point3> = self
            .positions
            .iter()
            .map(|p| map.map_point(*p).unwrap_or(Point3::new(f64::NAN, f64::NAN, f64::NAN)))
            .collect();
        let normal = |triangle: usize, k: usize| {
            let at = self.positions[self.triangles[triangle][k]];
            let pushed = map.push_forward(at, self.normals[self.corner_normals[triangle][k]]);
            pushed.and_then(Vec3::unit).ok_or(Error::Point(PointError::AtInfinity {
                what: ErrorItem::Normal,
                index: self.triangles[triangle][k],
                distance: 0.0,
                limit: 0.0,
            }))
        };
        let at_corners = |t: usize| Ok([normal(t, order[0])?, normal(t, order[1])?, normal(t, order[2])?]);
        let normals = (0..triangles.len()).map(at_corners).collect::<Result<Vec<[Vec3; 3]>>>()?;
        let given = VertexNormals::GivenAtCorners(&normals);
        Self::with_creases(&positions, &triangles, &given, &SharpEdges::Like(self, turned))
    }
}

impl SphereBlend {
    fn similar(&self, map: &Mobius) -> Result<Self> {
        let order = if map.determinant() < 0.0 { TURNED } else { [0, 1, 2] };
        let corner = |k: usize| {
            map.map_point(self.corners()[order[k]]).ok_or(Error::Point(PointError::AtInfinity {
                what: ErrorItem::Point,
                index: k,
                distance: 0.0,
                limit: 0.0,
            }))
        };
        self.over_similar([corner(0)?, corner(1)?, corner(2)?], order)
    }
}
