//! What points, vectors and quaternions have in common with numbers and arrays: assignment, sums, text, arrays both ways, and with
//! the feature `serde` the form of an array.

use super::planar::{Point2, Vec2};
use super::quat::Quat;
use super::vector::{Point3, Vec3};
use std::fmt;
use std::iter::Sum;
use std::ops::{AddAssign, Div, DivAssign, Mul, MulAssign, Sub, SubAssign};

/// Text as `(1, 2.5, 3)`, each number with the precision that is asked for; and the array of its numbers.
macro_rules! as_array {
    ($($name:ident, $count:literal, [$($field:ident),*];)*) => {$(
        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let mut separator = "(";
                for value in <[f64; $count]>::from(*self) {
                    f.write_str(separator)?;
                    fmt::Display::fmt(&value, f)?;
                    separator = ", ";
                }
                f.write_str(")")
            }
        }
        impl From<$name> for [f64; $count] {
            #[inline]
            fn from(value: $name) -> Self {
                [$(value.$field),*]
            }
        }
        #[cfg(feature = "serde")]
        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                <[f64; $count]>::from(*self).serialize(serializer)
            }
        }
        #[cfg(feature = "serde")]
        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                <[f64; $count]>::deserialize(deserializer).map(Self::from)
            }
        }
    )*};
}
as_array! {
    Vec3, 3, [x, y, z];
    Point3, 3, [x, y, z];
    Vec2, 2, [x, y];
    Point2, 2, [x, y];
    Quat, 4, [w, x, y, z];
}

/// Sums, and the operators that change their left side.
macro_rules! adds {
    ($($name:ident, $zero:expr;)*) => {$(
        impl Sum for $name {
            fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
                iter.fold($zero, |sum, value| sum + value)
            }
        }
        impl<'a> Sum<&'a Self> for $name {
            fn sum<I: Iterator<Item = &'a Self>>(iter: I) -> Self {
                iter.copied().sum()
            }
        }
        impl MulAssign<f64> for $name {
            #[inline]
            fn mul_assign(&mut self, s: f64) {
                *self = *self * s;
            }
        }
        impl DivAssign<f64> for $name {
            #[inline]
            fn div_assign(&mut self, s: f64) {
                *self = *self / s;
            }
        }
    )*};
}
adds! {
    Vec3, Vec3::ZERO;
    Vec2, Vec2::new(0.0, 0.0);
    Quat, Quat::new(0.0, 0.0, 0.0, 0.0);
}

/// The left side moved by the right one.
macro_rules! moves {
    ($($name:ident, $by:ident;)*) => {$(
        impl AddAssign<$by> for $name {
            #[inline]
            fn add_assign(&mut self, by: $by) {
                *self = *self + by;
            }
        }
        impl SubAssign<$by> for $name {
            #[inline]
            fn sub_assign(&mut self, by: $by) {
                *self = *self - by;
            }
        }
    )*};
}
moves! {
    Vec3, Vec3;
    Point3, Vec3;
    Vec2, Vec2;
    Point2, Vec2;
    Quat, Quat;
}

impl From<[f64; 2]> for Vec2 {
    #[inline]
    fn from(a: [f64; 2]) -> Self {
        Self::new(a[0], a[1])
    }
}
impl Sub<Vec2> for Point2 {
    type Output = Self;
    #[inline]
    fn sub(self, v: Vec2) -> Self {
        Self::new(self.x - v.x, self.y - v.y)
    }
}
impl Mul<Vec2> for f64 {
    type Output = Vec2;
    #[inline]
    fn mul(self, v: Vec2) -> Vec2 {
        v * self
    }
}
impl Div<f64> for Vec2 {
    type Output = Self;
    #[inline]
    fn div(self, s: f64) -> Self {
        Self::new(self.x / s, self.y / s)
    }
}
impl Mul<Quat> for f64 {
    type Output = Quat;
    #[inline]
    fn mul(self, q: Quat) -> Quat {
        q * self
    }
}
impl Div<f64> for Quat {
    type Output = Self;
    #[inline]
    fn div(self, s: f64) -> Self {
        Self::new(self.w / s, self.x / s, self.y / s, self.z / s)
    }
}
impl MulAssign for Quat {
    /// `q *= r` is `q = q · r`.
    #[inline]
    fn mul_assign(&mut self, o: Self) {
        *self = *self * o;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn assignment_is_what_the_operator_gives() {
        let (v, q) = (Vec3::new(1.0, 2.0, 4.0), Quat::new(1.0, 2.0, 3.0, 4.0));
        let mut point = Point3::new(0.5, 0.5, 0.5);
        point += v;
        point -= Vec3::X;
        assert_eq!(point, Point3::new(0.5, 2.5, 4.5));
        let mut vector = v;
        vector += v;
        vector -= Vec3::Z;
        vector *= 2.0;
        vector /= 4.0;
        assert_eq!(vector, Vec3::new(1.0, 2.0, 3.5));
        let mut product = q;
        product *= Quat::new(0.0, 0.0, 0.0, 1.0);
        assert_eq!(product, q * Quat::new(0.0, 0.0, 0.0, 1.0)); // from the right
        product *= 2.0;
        product += q;
        product -= q / 2.0;
        assert_eq!(product, 2.0 * (q * Quat::new(0.0, 0.0, 0.0, 1.0)) + q * 0.5);
        let mut flat = Point2::new(1.0, 1.0);
        flat += Vec2::new(1.0, 0.0);
        flat -= 2.0 * Vec2::new(0.0, 1.0) / 4.0;
        assert_eq!(flat - Vec2::from([0.0, 0.5]), Point2::new(2.0, 0.0));
    }

    #[test]
    fn sums_arrays_and_text() {
        let all = [Vec3::X, Vec3::Y, Vec3::Y];
        assert_eq!(all.iter().sum::<Vec3>(), Vec3::new(1.0, 2.0, 0.0));
        assert_eq!(all.into_iter().map(Quat::from).sum::<Quat>(), Quat::new(0.0, 1.0, 2.0, 0.0));
        assert_eq!([Vec2::new(1.0, 2.0); 3].iter().sum::<Vec2>(), Vec2::new(3.0, 6.0));
        let back: ([f64; 4], [f64; 3], [f64; 2]) = (
            Quat::new(1.0, 2.0, 3.0, 4.0).into(),
            Point3::from([5.0, 6.0, 7.0]).into(),
            Point2::from([8.0, 9.0]).into(),
        );
        assert_eq!(format!("{back:?}"), "([1.0, 2.0, 3.0, 4.0], [5.0, 6.0, 7.0], [8.0, 9.0])");
        assert_eq!(Point3::new(1.0, 2.5, -1e-9).to_string(), "(1, 2.5, -0.000000001)");
        assert_eq!(format!("{:.2}", Quat::new(1.0, 0.0, 0.125, 3.0)), "(1.00, 0.00, 0.12, 3.00)");
        assert_eq!(format!("{}", Vec2::new(0.1, 7.0)), "(0.1, 7)");
    }
}
