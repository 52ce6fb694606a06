//! Where spheres and planes meet each other, and circles and lines (source: `004`, (38), (39), (54), (55)).

use super::{CircleOrLine, LIMIT, SphereOrPlane};
use crate::base::vector::{Point3, Vec3};
use crate::conformal::{Line, Plane, Sphere};
use crate::curve::Circle;
use crate::error::{PointError, Result};

/// Where two spheres or planes meet.
///
/// ```
/// use cyclide::{Point3, Vec3, conformal::Sphere, curve::{SphereOrPlane, SurfaceMeeting}};
/// let ball = |x: f64| Sphere::new(Point3::new(x, 0.0, 0.0), 1.0).map(SphereOrPlane::Sphere);
/// assert_eq!(ball(0.0)?.meet(&ball(2.0)?)?, SurfaceMeeting::Point(Point3::new(1.0, 0.0, 0.0)));
/// assert_eq!(ball(0.0)?.meet(&ball(3.0)?)?, SurfaceMeeting::None);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SurfaceMeeting {
    /// In a circle or a line.
    Curve(CircleOrLine),
    /// They touch, to 1e-10 of their size.
    Point(Point3),
    /// Nowhere.
    None,
}

/// Where a circle or line meets a sphere or plane.
///
/// ```
/// use cyclide::{Point3, Vec3, conformal::{Line, Plane}, curve::{CircleOrLine, CurveMeeting, SphereOrPlane}};
/// let line = CircleOrLine::Line(Line::new(Point3::new(1.0, 2.0, 5.0), Vec3::Z)?);
/// let plane = SphereOrPlane::Plane(Plane::new(Point3::ORIGIN, Vec3::Z)?);
/// assert_eq!(line.meet(&plane)?, CurveMeeting::One(Point3::new(1.0, 2.0, 0.0)));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum CurveMeeting {
    /// In two points. The first is where the curve comes out: of the sphere, or to the side of the plane's normal (`004`, (55)). A line
    /// leaves a sphere there.
    Two([Point3; 2]),
    /// A line crosses a plane in one point; the other one is at infinity.
    One(Point3),
    /// They touch, to 1e-10 of their size.
    Tangent(Point3),
    /// Nowhere.
    None,
}

impl SphereOrPlane {
    /// Where this surface meets another one. The normal of a circle points from the center of the first sphere to that of the second, or along the
    /// normal of the plane; the direction of a line is the cross product of the normals.
    ///
    /// # Errors
    /// `same-surface`; those of [`Circle::from_radius`].
    pub fn meet(&self, other: &Self) -> Result<SurfaceMeeting> {
        match (self, other) {
            (Self::Sphere(a), Self::Sphere(b)) => spheres(a, b),
            (Self::Sphere(sphere), Self::Plane(plane)) | (Self::Plane(plane), Self::Sphere(sphere)) => {
                let (r, x) = (sphere.radius(), -plane.height(sphere.center()));
                section(sphere.center(), plane.normal(), r, x, r)
            }
            (Self::Plane(a), Self::Plane(b)) => planes(a, b),
        }
    }
}

fn spheres(a: &Sphere, b: &Sphere) -> Result<SurfaceMeeting> {
    let (r, s, way) = (a.radius(), b.radius(), b.center() - a.center());
    let (length, largest) = (way.length(), r.max(s));
    let Some(along) = way.unit().filter(|_| length > LIMIT * largest) else {
        let (distance, limit) = ((r - s).abs(), LIMIT * largest);
        return if distance <= limit {
            Err(PointError::SameSurface { distance, limit }.into())
        } else {
            Ok(SurfaceMeeting::None)
        };
    };
    let x = 0.5 * (length + (r - s) * (r + s) / length);
    section(a.center(), along, r, x, largest.max(length))
}

/// The section of a sphere at the distance x from its center.
fn section(center: Point3, along: Vec3, r: f64, x: f64, size: f64) -> Result<SurfaceMeeting> {
    if (x.abs() - r).abs() <= 0.5 * LIMIT * size {
        return Ok(SurfaceMeeting::Point(center + along * r.copysign(x)));
    }
    if x.abs() > r {
        return Ok(SurfaceMeeting::None);
    }
    let circle = Circle::from_radius(center + along * x, along, ((r - x) * (r + x)).sqrt())?;
    Ok(SurfaceMeeting::Curve(CircleOrLine::Circle(circle)))
}

fn planes(a: &Plane, b: &Plane) -> Result<SurfaceMeeting> {
    let way = b.point() - a.point();
    let g = a.normal().cross(b.normal());
    if g.length() <= LIMIT {
        let (distance, limit) = (way.dot(a.normal()).abs(), LIMIT * way.length());
        return if distance <= limit {
            Err(PointError::SameSurface { distance, limit }.into())
        } else {
            Ok(SurfaceMeeting::None)
        };
    }
    let point = a.point() + g.cross(a.normal()) * (way.dot(b.normal()) / g.length_squared());
    Ok(SurfaceMeeting::Curve(CircleOrLine::Line(Line::new(point, g)?)))
}

impl CircleOrLine {
    /// Where this curve meets a sphere or plane.
    ///
    /// # Errors
    /// `contained` where all of it is on the surface.
    pub fn meet(&self, surface: &SphereOrPlane) -> Result<CurveMeeting> {
        match (self, surface) {
            (Self::Circle(circle), SphereOrPlane::Plane(plane)) => {
                let way = plane.point() - circle.center();
                let (k, size) = (way.dot(plane.normal()), circle.radius().max(way.length()));
                on_circle(circle, plane.normal(), k, [1.0, size])
            }
            (Self::Circle(circle), SphereOrPlane::Sphere(sphere)) => {
                let (way, big, r) = (sphere.center() - circle.center(), sphere.radius(), circle.radius());
                let distance = way.length();
                let k = (big - distance) * (big + distance) - r * r;
                let size = big * big + distance * distance + r * r;
                on_circle(circle, way * -2.0, k, [size / r, size])
            }
            (Self::Line(line), SphereOrPlane::Sphere(sphere)) => {
                let (foot, r) = (line.foot(sphere.center()), sphere.radius());
                let h = foot.distance(sphere.center());
                if (h - r).abs() <= 0.5 * LIMIT * r {
                    return Ok(CurveMeeting::Tangent(foot));
                }
                if h > r {
                    return Ok(CurveMeeting::None);
                }
                let half = line.direction() * ((r - h) * (r + h)).sqrt();
                Ok(CurveMeeting::Two([foot + half, foot - half]))
            }
            (Self::Line(line), SphereOrPlane::Plane(plane)) => {
                let (height, slope) = (-plane.height(line.point()), line.direction().dot(plane.normal()));
                if slope.abs() > LIMIT {
                    return Ok(CurveMeeting::One(line.point() + line.direction() * (height / slope)));
                }
                let size = (plane.point() - line.point()).length();
                apart(height.abs(), LIMIT * size)
            }
        }
    }
}

/// The points of a circle at which `gradient·X = k`, `X` from its center: `sizes` of the gradient and of `k` tell what is rounding of zero.
fn on_circle(circle: &Circle, gradient: Vec3, k: f64, sizes: [f64; 2]) -> Result<CurveMeeting> {
    let (center, normal, r) = (circle.center(), circle.normal(), circle.radius());
    let inside = gradient - normal * gradient.dot(normal);
    let length = inside.length();
    let Some(along) = inside.unit().filter(|_| length > LIMIT * sizes[0]) else {
        return apart(k.abs(), LIMIT * sizes[1]);
    };
    let x = k / length;
    if (x.abs() - r).abs() <= 0.5 * LIMIT * r {
        return Ok(CurveMeeting::Tangent(center + along * r.copysign(x)));
    }
    if x.abs() > r {
        return Ok(CurveMeeting::None);
    }
    let (middle, half) = (center + along * x, normal.cross(along) * ((r - x) * (r + x)).sqrt());
    Ok(CurveMeeting::Two([middle - half, middle + half]))
}

/// A curve that is everywhere as far from a surface.
///
/// # Errors
/// `contained` where it is not apart.
fn apart(distance: f64, limit: f64) -> Result<CurveMeeting> {
    if distance <= limit { Err(PointError::Contained { distance, limit }.into()) } else { Ok(CurveMeeting::None) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(center: [f64; 3], normal: Vec3, radius: f64) -> CircleOrLine {
        CircleOrLine::Circle(Circle::from_radius(Point3::from(center), normal, radius).unwrap())
    }

    fn sphere(center: [f64; 3], radius: f64) -> SphereOrPlane {
        SphereOrPlane::Sphere(Sphere::new(Point3::from(center), radius).unwrap())
    }

    fn plane(point: [f64; 3], normal: Vec3) -> SphereOrPlane {
        SphereOrPlane::Plane(Plane::new(Point3::from(point), normal).unwrap())
    }

    /// The function of a surface, zero on it, positive outside and on the side of the normal.
    fn value(surface: &SphereOrPlane, p: Point3) -> f64 {
        match surface {
            SphereOrPlane::Sphere(sphere) => p.distance(sphere.center()) - sphere.radius(),
            SphereOrPlane::Plane(plane) => plane.height(p),
        }
    }

    #[test]
    fn both_points_are_on_both_and_the_first_is_the_way_out() {
        let tilted = Vec3::new(0.3, -0.5, 0.8);
        for surface in [sphere([1.0, 0.4, 0.2], 1.2), plane([0.2, 0.1, 0.3], Vec3::new(1.0, -2.0, 0.5))] {
            let CircleOrLine::Circle(round) = circle([0.1, 0.3, -0.2], tilted, 1.5) else { panic!("a circle") };
            let CurveMeeting::Two([out, back]) = CircleOrLine::Circle(round).meet(&surface).unwrap() else {
                panic!("two")
            };
            for (p, sign) in [(out, 1.0), (back, -1.0)] {
                assert!(value(&surface, p).abs() < 1e-15);
                assert!((p.distance(round.center()) - 1.5).abs() < 1e-15);
                assert!((p - round.center()).dot(round.normal()).abs() < 1e-15);
                let on = p + round.tangent_at(p).unwrap() * 1e-6;
                assert!(value(&surface, on) * sign > 0.0);
            }
        }
        let line = Line::new(Point3::new(-3.0, 0.2, 0.1), Vec3::X).unwrap();
        let CurveMeeting::Two([out, back]) = CircleOrLine::Line(line).meet(&sphere([0.0; 3], 2.0)).unwrap() else {
            panic!("two")
        };
        assert!(out.x > 0.0 && back.x < 0.0);
    }

    #[test]
    fn touching_and_what_lies_on_it() {
        let ball = sphere([0.0; 3], 2.0);
        assert_eq!(
            circle([3.0, 0.0, 0.0], Vec3::Z, 1.0).meet(&ball),
            Ok(CurveMeeting::Tangent(Point3::new(2.0, 0.0, 0.0)))
        );
        assert_eq!(circle([3.1, 0.0, 0.0], Vec3::Z, 1.0).meet(&ball), Ok(CurveMeeting::None));
        let great = circle([0.0; 3], Vec3::new(1.0, 2.0, 3.0), 2.0);
        assert_eq!(great.meet(&ball).unwrap_err().reason(), "contained");
        assert_eq!(
            circle([0.0; 3], Vec3::Z, 1.0).meet(&plane([4.0, 5.0, 0.0], Vec3::Z)).unwrap_err().reason(),
            "contained"
        );
        assert_eq!(circle([0.0; 3], Vec3::Z, 1.0).meet(&plane([4.0, 5.0, 1.0], Vec3::Z)), Ok(CurveMeeting::None));
    }

    /// A sphere and a plane, or two spheres, meet in points of both, in either order; far off and tiny too.
    #[test]
    fn circles_of_two_surfaces() {
        for unit in [1e-6, 1.0, 1e6] {
            let far = |p: [f64; 3]| p.map(|x| x * unit);
            let ball = sphere(far([0.3, 0.2, 0.1]), 2.0 * unit);
            for other in
                [sphere(far([1.5, -0.4, 0.8]), 1.1 * unit), plane(far([0.1, 0.5, 0.2]), Vec3::new(1.0, 2.0, 2.0))]
            {
                for (a, b) in [(ball, other), (other, ball)] {
                    let SurfaceMeeting::Curve(CircleOrLine::Circle(circle)) = a.meet(&b).unwrap() else {
                        panic!("a circle")
                    };
                    for t in [0.1, 0.6] {
                        let p = crate::curve::ParamCurve::point(&circle, t);
                        assert!(value(&a, p).abs().max(value(&b, p).abs()) < 4e-15 * unit);
                    }
                }
            }
        }
        assert_eq!(sphere([0.0; 3], 1.0).meet(&sphere([0.0; 3], 1.0)).unwrap_err().reason(), "same-surface");
        assert_eq!(sphere([0.0; 3], 1.0).meet(&sphere([0.0; 3], 2.0)), Ok(SurfaceMeeting::None));
    }
}
