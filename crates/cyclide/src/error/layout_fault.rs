//! Why the quads of a mesh do not form grids that join.

/// What is wrong with a mesh of quads that must form regular grids round irregular vertices.
///
/// ```
/// use cyclide::{Error, Point3, error::{GridError, LayoutFault}, surface::QuadLayout};
/// let points: Vec<_> = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [5.0, 5.0]].map(|[x, y]| Point3::new(x, y, 0.0)).into();
/// let error = QuadLayout::new(points, &[[0, 1, 2, 9]]).unwrap_err();
/// assert_eq!(error, Error::Grid(GridError::NotAQuadLayout { fault: LayoutFault::NoSuchVertex, index: 0 }));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum LayoutFault {
    /// There is no quad.
    NoQuads,
    /// A quad has a corner that is not a point.
    NoSuchVertex,
    /// A quad has the same corner twice.
    RepeatedCorner,
    /// A quad is the third at an edge.
    ThirdQuad,
    /// A quad cannot be oriented: the mesh is one-sided.
    OneSided,
    /// A quad is not connected to the first one.
    Apart,
    /// Parts of the mesh touch only at a vertex.
    Touching,
    /// A vertex of the border has more than three quads.
    Border,
    /// The quads round an irregular vertex reach the border, or those of another one.
    Crowded,
    /// Rows of quads come back to a quad at another location.
    Overlapping,
    /// There are irregular vertices on a mesh that is neither a disc nor a sphere.
    Holes,
}

impl LayoutFault {
    /// The fault in words, with what helps.
    pub(super) fn words(self, index: usize) -> String {
        match self {
            Self::NoQuads => "the mesh has no quads".to_owned(),
            Self::NoSuchVertex => format!("quad {index} has a corner that is not a vertex"),
            Self::RepeatedCorner => format!("quad {index} has the same corner twice"),
            Self::ThirdQuad => format!("quad {index} is the third at an edge, maximum 2"),
            Self::OneSided => format!("quad {index} cannot be oriented: the mesh is one-sided"),
            Self::Apart => format!("quad {index} is not connected to the first one"),
            Self::Touching => format!("parts of the mesh touch only at vertex {index}"),
            Self::Border => format!("border vertex {index} has more than 3 quads: a grid allows 1 to 3"),
            Self::Crowded => format!(
                "the quads round irregular vertex {index} reach the border, or those of another irregular vertex: divide every quad into four or nine"
            ),
            Self::Overlapping => {
                format!(
                    "the rows through quad {index} come back at another location: the mesh closes with a shift, or overlaps itself"
                )
            }
            Self::Holes => format!(
                "vertex {index} is irregular, and irregular vertices need a disc or a sphere: fill the holes with quads and leave those out, or cut the tube open"
            ),
        }
    }
}
