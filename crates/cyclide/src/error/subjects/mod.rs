//! The errors by subject: a table each, with everything about every one of them.

mod arc;
mod ball;
mod bridge;
mod contact;
mod crossing;
mod curve;
mod fit;
mod grid;
mod interpolation;
mod mesh;
mod motion;
mod number;
mod nurbs;
mod part;
mod patch;
mod pipe;
mod point;
mod polyhedron;
mod pose;
mod principal_grid;
mod profile;
mod shell;
mod tee;
mod torus;
mod triangle;
mod tube;
mod volume;

pub use arc::ArcError;
pub use ball::BallError;
pub use bridge::BridgeError;
pub use contact::ContactError;
pub use crossing::CrossingError;
pub use curve::CurveError;
pub use fit::FitError;
pub use grid::GridError;
pub use interpolation::InterpolationError;
pub use mesh::MeshError;
pub use motion::MotionError;
pub use number::NumberError;
pub use nurbs::NurbsError;
pub use part::PartError;
pub use patch::PatchError;
pub use pipe::PipeError;
pub use point::PointError;
pub use polyhedron::PolyhedronError;
pub use pose::PoseError;
pub use principal_grid::PrincipalGridError;
pub use profile::ProfileError;
pub use shell::ShellError;
pub use tee::TeeError;
pub use torus::TorusError;
pub use triangle::TriangleError;
pub use tube::TubeError;
pub use volume::VolumeError;

use crate::table::subjects;

subjects! {
    /// Why a piece of input was refused, by subject: the item at fault, what was measured of it, and the limit that it broke.
    ///
    /// A variant of a subject without a field for the limit names it in its sentence, where it could be no other: finite, positive,
    /// not zero, not the same point. Or nothing is measured, because what is wrong is how things are connected (a loop that is no
    /// face, a side that is one point, a curve that comes back to itself): the fields say where.
    ///
    /// ```
    /// use cyclide::{Error, Point3, Vec3, curve::Arc, error::PointError};
    /// let error = Arc::from_start_tangent(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Vec3::ZERO).unwrap_err();
    /// assert_eq!((error.reason(), error.index()), ("zero-tangent", Some(0)));
    /// assert_eq!(error, Error::Point(PointError::ZeroTangent { index: 0 }));
    /// assert!(Error::reasons().any(|reason| reason == "zero-tangent"));
    /// ```
    pub enum Error {
        /// Numbers as such.
        Number(NumberError),
        /// Points, directions and maps of them.
        Point(PointError),
        /// Arcs, circles, spheres and blends of circles.
        Arc(ArcError),
        /// Curves as such.
        Curve(CurveError),
        /// Curves through points.
        Interpolation(InterpolationError),
        /// Rational curves and surfaces.
        Nurbs(NurbsError),
        /// Curves near points.
        Fit(FitError),
        /// Patches, nets and their offsets.
        Patch(PatchError),
        /// Grids and layouts of quads, and what makes them circular.
        Grid(GridError),
        /// Grids along lines of curvature.
        PrincipalGrid(PrincipalGridError),
        /// Shells and their faces.
        Shell(ShellError),
        /// Profiles that turn about an axis, sections that are swept.
        Profile(ProfileError),
        /// Pipes, necks and cones.
        Pipe(PipeError),
        /// Tubes along curves and through balls.
        Tube(TubeError),
        /// Tees of pipes.
        Tee(TeeError),
        /// Crossings of pipes.
        Crossing(CrossingError),
        /// Blends of a tube with a plane or a sphere.
        Contact(ContactError),
        /// Balls that roll between two surfaces.
        Ball(BallError),
        /// Surfaces between two curves.
        Bridge(BridgeError),
        /// Polyhedra, and polygons of the sphere.
        Polyhedron(PolyhedronError),
        /// Triangles and patches over them.
        Triangle(TriangleError),
        /// Meshes of triangles.
        Mesh(MeshError),
        /// Tori, and points, curves and seams on them.
        Torus(TorusError),
        /// Poses and lists of them.
        Pose(PoseError),
        /// Motions and their time laws.
        Motion(MotionError),
        /// Spherical cubes and blocks.
        Volume(VolumeError),
        /// What failed in a part of the input.
        Part(PartError),
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Part(part) => part.source(),
            _ => None,
        }
    }
}
