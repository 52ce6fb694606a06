//! Errors about spherical cubes and volumes.
//!
//! # `concircular-cube`
//! The first corner and its three neighbors lie on one circle, so the eighth corner is not determined.
//! ```
//! use cyclide::{Error, Point3, error::VolumeError, volume::SphericalCube};
//! let flat = [[0., 0., 0.], [2., 0., 0.], [0., 3., 0.], [2., 3., 0.]].map(Point3::from);
//! let error = SphericalCube::from_positions(flat, [0.5; 3]).unwrap_err();
//! assert_eq!(error.reason(), "concircular-cube");
//! assert!(matches!(error, Error::Volume(VolumeError::ConcircularCube { measured, limit }) if measured <= limit));
//! ```
//!
//! # `degenerate-block`
//! Three faces of a block of circles leave its last corner open: here those of a box.
//! ```
//! use cyclide::{Point3, Vec3, surface::CornerTwist, volume::{BlockBranch, QbBlock}};
//! let corners = [[0., 0., 0.], [2., 0., 0.], [0., 3., 0.], [2., 3., 0.25], [0., 0., 1.], [2., 0.25, 1.], [0.25, 3., 1.]];
//! let twists = [0.3, 0.2, -0.4].map(CornerTwist::Twist);
//! let made = QbBlock::new(corners.map(Point3::from), [Vec3::X, Vec3::Y, Vec3::Z], twists, BlockBranch::Miquel);
//! assert_eq!(made.unwrap_err().reason(), "degenerate-block");
//! ```
//!
//! # `crossing-face`
//! A face of a volume self-intersects: here the last corner is outside the triangle of the neighbors of the first.
//! ```
//! use cyclide::{Error, Point3, error::VolumeError, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
//! let corners = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]].map(Point3::from);
//! let cube = SphericalCube::from_positions(corners, [0.9, 0.9, 0.5])?;
//! let error = CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap_err();
//! assert_eq!(error.reason(), "crossing-face");
//! assert!(matches!(error, Error::Volume(VolumeError::CrossingFace { speed, limit, .. }) if speed < limit));
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `volume-through-infinity`
//! An inversion about a point inside a block takes that point to infinity.
//! ```
//! use cyclide::{Point3, Vec3, conformal::{Conformal, Mobius}, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
//! let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z])?;
//! let block = CyclideVolume::new(&cube, VolumeFrame::Auto)?;
//! let map = Mobius::inversion(Point3::new(0.3, 0.4, 0.6), 1.0)?;
//! assert_eq!(block.transformed(&map).unwrap_err().reason(), "volume-through-infinity");
//! # Ok::<(), cyclide::Error>(())
//! ```
//!
//! # `folded-volume`
//! The outer boundary of a block folds because its frame is far from its sides.
//! ```
//! use cyclide::{Point3, Vec3, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
//! let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X * 2.0, Vec3::Y * 3.0, Vec3::Z])?;
//! let block = CyclideVolume::new(&cube, VolumeFrame::First(Vec3::Y, Vec3::Z))?;
//! assert_eq!(CyclideVolume::outer_bodies(&[block]).unwrap_err().reason(), "folded-volume");
//! # Ok::<(), cyclide::Error>(())
//! ```
