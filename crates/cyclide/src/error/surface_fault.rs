//! Why triangles are not one connected surface with a border.

/// What is wrong with triangles that must form one connected surface with a border.
///
/// ```
/// use cyclide::{Error, Point3, error::{PrincipalGridError, SurfaceFault}};
/// use cyclide_grids::{PrincipalGridOptions, principal_grids};
/// let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [5.0, 0.0], [6.0, 0.0], [5.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
/// let error = principal_grids(&points, &[[0, 1, 2], [3, 4, 5]], &PrincipalGridOptions::new(0.1));
/// assert_eq!(error.unwrap_err(), Error::PrincipalGrid(PrincipalGridError::NotASurface { fault: SurfaceFault::Apart, index: 1 }));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SurfaceFault {
    /// The corners of a triangle are on a line, or two of them coincide.
    NoArea,
    /// More than two triangles share an edge.
    EdgeOfMany,
    /// A triangle is oriented opposite to its neighbor.
    TurnedOver,
    /// Triangles meet only at a vertex.
    Pinched,
    /// A triangle is not connected to the first one.
    Apart,
    /// The surface is closed.
    NoBorder,
    /// The surface has handles.
    Handles,
}

impl SurfaceFault {
    /// The fault of a triangle in words, with what helps.
    pub(super) fn words(self, triangle: usize) -> String {
        match self {
            Self::NoArea => format!("triangle {triangle} has no area: leave it out"),
            Self::EdgeOfMany => {
                format!("triangle {triangle} shares an edge with more than one other: leave out what branches off")
            }
            Self::TurnedOver => {
                format!(
                    "triangle {triangle} is oriented opposite to its neighbor: reverse it (or remove it, if it is a duplicate)"
                )
            }
            Self::Pinched => {
                format!("triangle {triangle} meets others only at a vertex: give each a vertex of its own")
            }
            Self::Apart => {
                format!(
                    "triangle {triangle} is not connected to the first one: make each piece a separate mesh, and weld coincident points"
                )
            }
            Self::NoBorder => "it has no border: cut it open, for example with a hole round a pole".to_owned(),
            Self::Handles => "it has handles: cut them open".to_owned(),
        }
    }
}
