//! The warnings by subject: a table each, with everything about every one of them.

mod body;
mod circular;
mod curve;
mod fit;
mod mesh;
mod motion;
mod net;
mod noise;
mod point;
mod polyhedron;
mod pose_fit;
mod principal_grid;
mod volume;

pub use body::BodyWarning;
pub use circular::CircularWarning;
pub use curve::CurveWarning;
pub use fit::FitWarning;
pub use mesh::MeshWarning;
pub use motion::MotionWarning;
pub use net::NetWarning;
pub use noise::NoiseWarning;
pub use point::PointWarning;
pub use polyhedron::PolyhedronWarning;
pub use pose_fit::PoseFitWarning;
pub use principal_grid::PrincipalGridWarning;
pub use volume::VolumeWarning;

use crate::table::subjects;

subjects! {
    /// A remark on a result that is valid but may not be what was meant, by subject.
    ///
    /// ```
    /// use cyclide::{Point3, Warning, curve::{CircleSpline, CircleSplineOptions}, warning::CurveWarning};
    /// let back = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
    /// let spline = CircleSpline::from_points(&back, &CircleSplineOptions::default())?;
    /// assert_eq!(spline.warnings()[0], Warning::Curve(CurveWarning::Cusp { node: 1 }));
    /// assert_eq!(spline.warnings()[0].reason(), "cusp");
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    pub enum Warning {
        /// Points that a curve was made from.
        Point(PointWarning),
        /// Curves through points.
        Curve(CurveWarning),
        /// Curves near points.
        Fit(FitWarning),
        /// Noise of points.
        Noise(NoiseWarning),
        /// Motions and their time laws.
        Motion(MotionWarning),
        /// Motions that smooth their poses.
        PoseFit(PoseFitWarning),
        /// Grids along lines of curvature.
        PrincipalGrid(PrincipalGridWarning),
        /// Grids made circular.
        Circular(CircularWarning),
        /// Nets, offsets and swept surfaces.
        Net(NetWarning),
        /// Smooth surfaces over triangles.
        Mesh(MeshWarning),
        /// Polyhedra.
        Polyhedron(PolyhedronWarning),
        /// Bodies that were turned, or laid between two curves.
        Body(BodyWarning),
        /// Blocks and their cells.
        Volume(VolumeWarning),
    }
}
