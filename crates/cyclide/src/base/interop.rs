//! Points, vectors and quaternions of other crates, both ways, each behind the feature of its name.
#![cfg(any(feature = "mint", feature = "glam", feature = "nalgebra"))]

use super::planar::{Point2, Vec2};
use super::quat::Quat;
use super::vector::{Point3, Vec3};

/// Both ways between one of ours and one of theirs.
macro_rules! both_ways {
    ($($own:ident, $other:ty, $into:expr, $from:expr;)*) => {$(
        impl From<$own> for $other {
            #[inline]
            fn from(value: $own) -> Self {
                let into: fn($own) -> $other = $into;
                into(value)
            }
        }
        impl From<$other> for $own {
            #[inline]
            fn from(value: $other) -> Self {
                let from: fn($other) -> $own = $from;
                from(value)
            }
        }
    )*};
}

/// Of the crate `mint`, through which graphics crates exchange them.
#[cfg(feature = "mint")]
mod with_mint {
    use super::{Point2, Point3, Quat, Vec2, Vec3};

    both_ways! {
        Vec3, mint::Vector3<f64>, |v| v.to_array().into(), |v| Vec3::new(v.x, v.y, v.z);
        Point3, mint::Point3<f64>, |p| p.to_array().into(), |p| Point3::new(p.x, p.y, p.z);
        Vec2, mint::Vector2<f64>, |v| [v.x, v.y].into(), |v| Vec2::new(v.x, v.y);
        Point2, mint::Point2<f64>, |p| [p.x, p.y].into(), |p| Point2::new(p.x, p.y);
        Quat, mint::Quaternion<f64>, |q| mint::Quaternion { s: q.w, v: [q.x, q.y, q.z].into() },
            |q| Quat::new(q.s, q.v.x, q.v.y, q.v.z);
    }
    impl mint::IntoMint for Vec3 {
        type MintType = mint::Vector3<f64>;
    }
    impl mint::IntoMint for Point3 {
        type MintType = mint::Point3<f64>;
    }
    impl mint::IntoMint for Vec2 {
        type MintType = mint::Vector2<f64>;
    }
    impl mint::IntoMint for Point2 {
        type MintType = mint::Point2<f64>;
    }
    impl mint::IntoMint for Quat {
        type MintType = mint::Quaternion<f64>;
    }
}

/// Of the crate `glam`, which has no points of their own and puts w last.
#[cfg(feature = "glam")]
mod with_glam {
    use super::{Point2, Point3, Quat, Vec2, Vec3};
    use glam::{DQuat, DVec2, DVec3};

    both_ways! {
        Vec3, DVec3, |v| DVec3::from_array(v.to_array()), |v| v.to_array().into();
        Point3, DVec3, |p| DVec3::from_array(p.to_array()), |p| p.to_array().into();
        Vec2, DVec2, |v| DVec2::new(v.x, v.y), |v| v.to_array().into();
        Point2, DVec2, |p| DVec2::new(p.x, p.y), |p| p.to_array().into();
        Quat, DQuat, |q| DQuat::from_xyzw(q.x, q.y, q.z, q.w), |q| Quat::new(q.w, q.x, q.y, q.z);
    }
}

/// Of the crate `nalgebra`.
#[cfg(feature = "nalgebra")]
mod with_nalgebra {
    use super::{Point2, Point3, Quat, Vec2, Vec3};
    use nalgebra as na;

    both_ways! {
        Vec3, na::Vector3<f64>, |v| v.to_array().into(), |v| Vec3::new(v.x, v.y, v.z);
        Point3, na::Point3<f64>, |p| p.to_array().into(), |p| Point3::new(p.x, p.y, p.z);
        Vec2, na::Vector2<f64>, |v| [v.x, v.y].into(), |v| Vec2::new(v.x, v.y);
        Point2, na::Point2<f64>, |p| [p.x, p.y].into(), |p| Point2::new(p.x, p.y);
        Quat, na::Quaternion<f64>, |q| na::Quaternion::new(q.w, q.x, q.y, q.z),
            |q| Quat::new(q.w, q.i, q.j, q.k);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// There and back nothing changes, and quaternions of both crates turn vectors alike.
    macro_rules! there_and_back {
        ($vec3:ty, $point3:ty, $vec2:ty, $point2:ty, $quat:ty) => {
            let (v, p) = (Vec3::new(1.0, 2.0, 3.0), Point3::new(4.0, 5.0, 6.0));
            let (v2, p2) = (Vec2::new(7.0, 8.0), Point2::new(9.0, 10.0));
            let q = Quat::new(0.5, -0.5, 0.5, 0.5);
            assert_eq!(Vec3::from(<$vec3>::from(v)), v);
            assert_eq!(Point3::from(<$point3>::from(p)), p);
            assert_eq!(Vec2::from(<$vec2>::from(v2)), v2);
            assert_eq!(Point2::from(<$point2>::from(p2)), p2);
            assert_eq!(Quat::from(<$quat>::from(q)), q);
        };
    }

    #[cfg(feature = "mint")]
    #[test]
    fn through_mint() {
        there_and_back!(
            mint::Vector3<f64>,
            mint::Point3<f64>,
            mint::Vector2<f64>,
            mint::Point2<f64>,
            mint::Quaternion<f64>
        );
        let q = mint::Quaternion::from(Quat::new(1.0, 2.0, 3.0, 4.0));
        assert_eq!((q.s, q.v.x, q.v.z), (1.0, 2.0, 4.0));
    }

    #[cfg(feature = "glam")]
    #[test]
    fn through_glam() {
        there_and_back!(glam::DVec3, glam::DVec3, glam::DVec2, glam::DVec2, glam::DQuat);
        let q = Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), 1.2);
        let (own, theirs) = (q.rotate(Vec3::X), glam::DQuat::from(q) * glam::DVec3::X);
        assert!((own - Vec3::from(theirs)).length() < 1e-15);
    }

    #[cfg(feature = "nalgebra")]
    #[test]
    fn through_nalgebra() {
        use nalgebra as na;
        there_and_back!(na::Vector3<f64>, na::Point3<f64>, na::Vector2<f64>, na::Point2<f64>, na::Quaternion<f64>);
        let q = Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), 1.2);
        let theirs = na::UnitQuaternion::from_quaternion(q.into()) * na::Vector3::x();
        assert!((q.rotate(Vec3::X) - Vec3::from(theirs)).length() < 1e-15);
    }
}
