//! Sphere blends over one triangle: laws of `docs/math/triangle-surfaces.md#sphere-blend`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Point3, Quat, Vec3, Warning,
    conformal::{Mobius, Sphere},
    curve::Circle,
    error::TriangleError,
    surface::{SideLine, SphereBlend, TriangleSurface},
    warning::MeshWarning,
};
use proptest::prelude::*;
use std::f64::consts::PI;

const CORNERS: [[f64; 3]; 3] = [[0.2, -0.1, 0.3], [2.1, 0.4, -0.2], [0.7, 1.9, 0.6]];
const CONTROL: [[f64; 3]; 3] = [[0.9, 0.6, 0.9], [1.1, 0.8, 1.9], [0.9, 0.9, -0.1]];

fn corners() -> [Point3; 3] {
    CORNERS.map(Point3::from)
}

fn patch() -> SphereBlend {
    SphereBlend::from_control_points(corners(), CONTROL.map(Point3::from)).unwrap()
}

/// Places inside, on sides and next to corners.
fn places() -> impl Iterator<Item = [f64; 3]> {
    let grid = (0..=8_i32).flat_map(|i| (0..=8 - i).map(move |j| [i, j, 8 - i - j].map(f64::from)));
    grid.chain([[1e-7, 1e-9, 1.0], [1.0, 1e-12, 0.0]])
}

#[test]
fn corners_come_out_to_the_bit_with_the_normals_of_their_spheres() {
    let patch = patch();
    for i in 0..3 {
        let mut at = [0.0; 3];
        at[i] = 7.0;
        assert_eq!(patch.point(at).unwrap(), corners()[i]);
        let [a, b, c] = corners();
        let sphere = Sphere::through_points([a, b, c, CONTROL[i].into()]).unwrap();
        let radial = (corners()[i] - sphere.center()).unit().unwrap();
        let normal = patch.normal(at).unwrap();
        // Rounding of the sphere: a few eps times its radius over the size.
        assert!(normal.cross(radial).length() < 1e-13, "{i}: {normal:?} {radial:?}");
        let tangent = Circle::through_points(corners()).unwrap().tangent_at(corners()[i]).unwrap();
        assert!(normal.dot(tangent).abs() < 1e-14);
    }
}

#[test]
fn data_on_one_sphere_give_that_sphere() {
    let centre = Point3::new(0.3, -0.4, 1e3);
    for (lift, radius) in [(0.2, 2.0), (-0.9, 3.0), (0.999, 1e-6)] {
        let on = |a: f64, z: f64| {
            centre + Vec3::new((1.0 - z * z).sqrt() * a.cos(), (1.0 - z * z).sqrt() * a.sin(), z) * radius
        };
        let corners = [0.1, 1.9, 4.0].map(|a| on(a, lift));
        let above = if lift < 0.0 { -0.99 } else { lift + 0.5 * (1.0 - lift) };
        let patch =
            SphereBlend::from_control_points(corners, [on(1.0, above), on(2.0, 0.5 * (above + lift)), on(5.0, above)])
                .unwrap();
        for at in places() {
            let (p, normal) = (patch.point(at).unwrap(), patch.normal(at).unwrap());
            // The rounding of the coordinates, 1e3, and of a cap that is 0.04 across for the last.
            assert!((p.distance(centre) - radius).abs() < 1e-12, "{lift} {radius} {at:?}");
            if radius > 1.0 {
                assert!(normal.cross((p - centre).unit().unwrap()).length() < 1e-11, "{lift} {at:?}");
            }
        }
    }
}

#[test]
fn control_points_in_the_plane_inside_the_circle_leave_it_flat() {
    let [a, b, c] = corners();
    let middle = a + ((b - a) + (c - a)) / 3.0;
    let patch = SphereBlend::from_control_points(corners(), [middle; 3]).unwrap();
    let up = (b - a).cross(c - a).unit().unwrap();
    for at in places() {
        let sum: f64 = at.iter().sum();
        let flat = a + ((b - a) * at[1] + (c - a) * at[2]) / sum;
        assert!(patch.point(at).unwrap().distance(flat) < 1e-15);
        assert!((patch.normal(at).unwrap() - up).length() < 1e-14);
    }
}

#[test]
fn normals_are_those_of_finite_differences() {
    let patch = patch();
    for at in [[0.2, 0.3, 0.5], [0.05, 0.9, 0.05], [0.6, 0.01, 0.39]] {
        let h = 1e-6;
        let moved = |k: usize| {
            let (mut plus, mut minus) = (at, at);
            plus[k] += h;
            plus[2] -= h;
            minus[k] -= h;
            minus[2] += h;
            (patch.point(plus).unwrap() - patch.point(minus).unwrap()) / (2.0 * h)
        };
        let want = moved(0).cross(moved(1)).unit().unwrap();
        // Truncation h² and rounding 1e-16/h.
        assert!((patch.normal(at).unwrap() - want).length() < 1e-9);
    }
}

#[test]
fn normals_as_data_are_met_as_nearly_as_spheres_can() {
    // Those of a sphere are met exactly, at any scale and place.
    for (scale, shift) in [(1.0, 0.0), (1e-6, 0.0), (1e6, 0.0), (1.0, 1e6)] {
        let centre = Point3::new(shift, -shift, 2.0 * shift);
        let spokes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.6, 0.0, 0.8]].map(Vec3::from);
        let corners = spokes.map(|v| centre + v * scale);
        let patch = SphereBlend::from_normals(corners, spokes.map(|v| v * 3.0)).unwrap();
        for at in places() {
            // The rounding of coordinates far out, 2e-10.
            let limit = scale * 1e-14 + shift * 1e-15;
            assert!((patch.point(at).unwrap().distance(centre) - scale).abs() < limit, "{scale} {shift} {at:?}");
        }
    }
    // Others are turned about the tangent of the circle.
    let given = [Vec3::new(0.3, 0.2, 1.0), Vec3::new(-0.4, 0.1, 1.0), Vec3::new(0.5, 0.5, 1.0)];
    let patch = SphereBlend::from_normals(corners(), given).unwrap();
    let circle = Circle::through_points(corners()).unwrap();
    for i in 0..3 {
        let mut at = [0.0; 3];
        at[i] = 1.0;
        let tangent = circle.tangent_at(corners()[i]).unwrap();
        let want = (given[i] - tangent * given[i].dot(tangent)).unit().unwrap();
        assert!((patch.normal(at).unwrap() - want).length() < 1e-13, "{i}");
    }
}

#[test]
fn similarities_map_the_patch_with_its_data() {
    let turn = Quat::new(0.4, -0.2, 0.7, 0.5);
    for scale in [1e-6, 1.0, 1e6] {
        let map = Mobius::similarity(turn, scale, Vec3::new(3.0, -2.0, 1.0) * scale).unwrap();
        let image = |p: Point3| map.map_point(p).unwrap();
        let (control, patch) = (CONTROL.map(Point3::from), patch());
        let moved = SphereBlend::from_control_points(corners().map(image), control.map(image)).unwrap();
        for at in places() {
            assert!(moved.point(at).unwrap().distance(image(patch.point(at).unwrap())) < 1e-14 * scale * 10.0);
        }
    }
}

#[test]
fn refusals_have_names() {
    let c = corners();
    let inside = [Point3::new(0.9, 0.6, 0.9); 3];
    let refused = |corners, control| {
        SphereBlend::from_control_points(corners, control).and_then(SphereBlend::whole).unwrap_err().reason()
    };
    assert_eq!(refused([c[0], c[1], c[0].lerp(c[1], 0.3)], inside), "degenerate-triangle");
    assert_eq!(refused([c[0], c[1], c[0]], inside), "degenerate-triangle");
    assert_eq!(refused(c, [inside[0], c[1], inside[2]]), "control-point-on-circumcircle");
    assert_eq!(refused(c, [inside[0], Point3::new(f64::NAN, 0.0, 0.0), inside[2]]), "not-finite");
    assert_eq!(refused([Point3::new(0.0, f64::INFINITY, 0.0), c[1], c[2]], inside), "not-finite");
    assert_eq!(refused([Point3::new(0.0, 1e200, 0.0), c[1], c[2]], inside), "parameter-out-of-range");
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::ZERO];
    assert_eq!(SphereBlend::from_normals(c, [x, y, z]).unwrap_err().reason(), "undefined-normal");
    assert_eq!(SphereBlend::from_normals(c, [x, y, x * f64::NAN]).unwrap_err().reason(), "not-finite");
    let error = SphereBlend::from_normals(c, [x, y, z]).unwrap_err().to_string();
    assert_eq!(error, "vertex 2 has no normal: the given one is zero");
    // Above and below: it is made, and said.
    let large = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0]].map(Point3::from);
    let control = [[5.0, 5.0, 50.0], [5.0, 5.0, -50.0], [3.0, 3.0, 1.0]].map(Point3::from);
    let wild = SphereBlend::from_control_points(large, control).and_then(SphereBlend::whole).unwrap();
    let [Warning::Mesh(MeshWarning::SpheresNearlyOpposite { length, limit })] = wild.warnings()[..] else {
        panic!("it is said")
    };
    assert!((length - 0.02558).abs() < 1e-5 && length < limit);
    let ball = SphereBlend::from_normals(c, c.map(Point3::to_vec)).unwrap();
    assert_eq!(ball.warnings(), []);
    // In the plane outside the circle: the plane turned over.
    let flat = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
    assert_eq!(refused(flat, [Point3::new(3.0, 0.0, 0.0); 3]), "patch-through-infinity");
    // One sphere above and one below cancel half way.
    let poles = [Point3::new(0.0, 0.0, 1.0), Point3::new(0.0, 0.0, -1.0), Point3::new(0.0, 0.0, 1.0)];
    assert_eq!(refused(flat, poles), "opposite-spheres");
    for wrong in [[0.0; 3], [-0.1, 0.5, 0.6], [f64::NAN, 1.0, 0.0], [f64::INFINITY, 1.0, 0.0]] {
        assert_eq!(patch().point(wrong).unwrap_err().reason(), "parameter-out-of-range");
    }
}

fn any_point() -> impl Strategy<Value = [f64; 3]> {
    let number = prop_oneof![-1.0..1.0, Just(0.0), Just(1.0), -1e-12..1e-12, -1e150..1e150, Just(1e-150), Just(1e200)];
    [number.clone(), number.clone(), number]
}

proptest! {
    /// Whatever the data, points are finite or refused by name.
    #[test]
    fn no_input_gives_points_that_are_no_points(
        corners in [any_point(), any_point(), any_point()],
        control in [any_point(), any_point(), any_point()],
        at in [0.0..1.0, 0.0..1.0, 0.0..1.0],
    ) {
        if let Ok(patch) = SphereBlend::from_control_points(corners.map(Point3::from), control.map(Point3::from)) {
            if let Ok(p) = patch.point(at) {
                prop_assert!(p.is_finite(), "{patch:?}");
            }
            if let Ok(n) = patch.normal(at) {
                prop_assert!((n.length() - 1.0).abs() < 1e-12, "{patch:?}");
            }
        }
    }
}

/// Of a piece of a sphere: every triangle is within the bound of it, and the area by quadrature is that of fine meshes.
#[test]
fn meshes_and_area_are_those_of_the_sphere() {
    // On the sphere of radius 5 about the origin.
    let corners = [[3.0, 4.0, 0.0], [-3.0, 4.0, 0.0], [0.0, 3.0, 4.0]].map(Point3::from);
    let control = [[0.0, 5.0, 0.0], [1.4, 4.8, 0.0], [0.0, 4.8, 1.4]].map(Point3::from);
    let patch = SphereBlend::from_control_points(corners, control).unwrap();
    let surface = TriangleSurface::from(patch);
    assert!(surface.free_sides() == 3 && surface.lines(0) == [SideLine::Free; 3] && surface.patch(1).is_none());
    let bounds = surface.sampled_bounds().unwrap();
    assert!(corners.iter().all(|p| bounds.distance(*p) == 0.0) && bounds.max.y > 4.9);
    let measure = patch.measure().unwrap();
    // What half as many nodes would change; how right the area is, the fine meshes below say.
    assert!(measure.volume.is_none() && measure.area_error <= 1e-6 * measure.area);
    for tolerance in [0.1, 1e-2, 1e-3] {
        let made = surface.tessellate_within(tolerance, 100_000).unwrap();
        assert!(made.mesh.bound <= tolerance && made.mesh.faces.len() == made.divisions * made.divisions);
        for face in &made.mesh.faces {
            let at = |k: usize| made.mesh.positions[face.corners()[k].position];
            let [a, b, c] = [at(0), at(1), at(2)];
            let middle = (a.to_vec() + b.to_vec() + c.to_vec()) / 3.0;
            let depth = |v: Vec3| 5.0 - v.length();
            assert!(depth(a.to_vec()).abs() < 1e-14);
            for v in [middle, a.midpoint(b).to_vec(), b.midpoint(c).to_vec(), c.midpoint(a).to_vec()] {
                assert!(depth(v) >= 0.0 && depth(v) <= made.mesh.bound);
            }
            let outward = (b - a).cross(c - a);
            assert!(face.corners().iter().all(|corner| made.mesh.normals[corner.normal].dot(outward) > 0.0));
        }
        // A triangle within the bound is smaller than its part of the sphere, by twice the bound over the radius at most.
        let lost = 1.0 - made.mesh.area() / measure.area;
        assert!(lost > 0.0 && lost < 4.0 * made.mesh.bound / 5.0 + 1e-9, "{lost:e}");
    }
    assert_eq!(surface.tessellate_within(1e-9, 100).unwrap_err().reason(), "too-many-pieces");
}

#[test]
fn similarities_map_the_patch_with_its_outer_side() {
    let surface = TriangleSurface::from(patch());
    let turn = Mobius::similarity(Quat::from_axis_angle(Vec3::Y, 0.7), 2.5, Vec3::new(1.0, -4.0, 2.0)).unwrap();
    let mirror = Mobius::reflection(Point3::new(0.3, 0.0, 1.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
    for (map, turned) in [(turn, false), (mirror, true), (mirror.after(&turn), true)] {
        let image = surface.similar(&map).unwrap();
        let [own, other] = [&surface, &image].map(|s| s.patch(0).unwrap());
        for at in [[1.0, 2.0, 3.0], [0.0, 1.0, 4.0], [5.0, 1.0, 1.0]] {
            let (p, n) = own.point_and_normal(at).unwrap();
            let there = if turned { [at[0], at[2], at[1]] } else { at };
            let (q, m) = other.point_and_normal(there).unwrap();
            assert!(
                map.map_point(p).unwrap().distance(q) < 1e-13
                    && (map.push_forward(p, n).unwrap().unit().unwrap() - m).length() < 1e-13
            );
        }
    }
    let inversion = Mobius::inversion(Point3::new(9.0, 0.0, 0.0), 1.0).unwrap();
    assert_eq!(surface.similar(&inversion).unwrap_err().reason(), "not-a-similarity");
}

/// The corners of a regular triangle in the unit circle.
fn regular() -> [Point3; 3] {
    [0.0, 1.0, 2.0].map(|k: f64| (k * std::f64::consts::TAU / 3.0).sin_cos()).map(|(y, x)| Point3::new(x, y, 0.0))
}

/// The patch over it whose normals lean outwards by these angles, degrees.
fn leaning(degrees: [f64; 3]) -> cyclide::Result<SphereBlend> {
    let corners = regular();
    let normal = |k: usize| {
        let (sin, cos) = degrees[k].to_radians().sin_cos();
        corners[k].to_vec() * sin + Vec3::Z * cos
    };
    SphereBlend::from_normals(corners, [normal(0), normal(1), normal(2)])?.whole()
}

/// `(a, b)` is linear: the patch is torn if the origin is in the triangle of the three angles, wherever places are looked at.
#[test]
fn spheres_cancel_if_the_origin_is_between_their_angles() {
    for torn in [[0.0, 90.0, -179.5], [0.0, 120.0, 240.0], [0.0, 1.0, 180.001], [0.0, 180.0, 0.0], [10.0, 100.0, 195.0]]
    {
        let error = leaning(torn).unwrap_err();
        assert_eq!(error.reason(), "opposite-spheres", "{torn:?}");
        let cyclide::Error::Triangle(TriangleError::OppositeSpheres { at: [s, t], .. }) = error else {
            panic!("{error}")
        };
        let vector = |k: usize| torn[k].to_radians().sin_cos();
        let (parts, sums) = ([s, t, 1.0 - s - t], [0, 1, 2].map(vector));
        let sum = |of: fn((f64, f64)) -> f64| (0..3).map(|k| parts[k] * of(sums[k])).sum::<f64>();
        // They do so where the error says, to the margin.
        assert!(sum(|v| v.0).hypot(sum(|v| v.1)) < 1e-4, "{torn:?}");
    }
    // Next to it no blend is torn: the normals of neighboring places differ by little.
    for whole in [[0.0, 90.0, 179.5], [0.0, 89.0, -90.0], [0.0, 100.0, 179.0]] {
        let patch = leaning(whole).unwrap();
        let n = 4000;
        for side in 0..3 {
            let mut last: Option<Vec3> = None;
            for k in 0..=n {
                let mut at = [0.0; 3];
                (at[side], at[(side + 1) % 3]) = (f64::from(k), f64::from(n - k));
                let normal = patch.normal(at).unwrap();
                assert!(last.is_none_or(|last| last.angle(normal) < 0.5), "{whole:?} {at:?}");
                last = Some(normal);
            }
        }
    }
}

/// The plane turned over goes to infinity in its circumcenter alone: across other places it is as smooth as elsewhere.
#[test]
fn only_the_circumcentre_goes_to_infinity() {
    assert_eq!(leaning([180.0; 3]).unwrap_err().reason(), "patch-through-infinity");
    assert_eq!(leaning([179.995; 3]).unwrap_err().reason(), "patch-through-infinity");
    let high = leaning([179.9; 3]).unwrap().point([1.0; 3]).unwrap();
    // tan(179.9/2 degrees).
    assert!((high.z / 89.95_f64.to_radians().tan() - 1.0).abs() < 1e-9 && high.z > 1e3);
    let across = leaning([170.0, 175.0, -175.0]).unwrap();
    let n = 1000;
    let mut last: Option<Point3> = None;
    for k in 0..=n {
        let at = [0.2 * f64::from(n), f64::from(k), f64::from(n - k)];
        let (p, normal) = (across.point(at).unwrap(), across.normal(at).unwrap());
        assert!(last.is_none_or(|last: Point3| last.distance(p) < 0.2), "{at:?}");
        last = Some(p);
        // The normal of differences, where the angle is half a turn too.
        let h = 1e-4 * f64::from(n);
        let moved = |i: usize, j: usize, h: f64| {
            let mut at = at;
            (at[i], at[j]) = (at[i] + h, at[j] - h);
            across.point(at).map(Point3::to_vec)
        };
        if let (Ok(a), Ok(b), Ok(c), Ok(d)) = (moved(0, 2, h), moved(0, 2, -h), moved(1, 2, h), moved(1, 2, -h)) {
            let differences = (a - b).cross(c - d).unit().unwrap();
            assert!(differences.angle(normal) < 1e-2, "{at:?}");
        }
    }
}

/// Areas of patches that reach far, found by finer quadrature elsewhere; the error that is told holds.
#[test]
fn areas_are_known_to_what_is_told() {
    // With one angle it is the image of the plane, which stretches by 1/(c² + s² r²): the integral over r is known.
    let stretched = |degrees: f64| {
        let (s, c) = (0.5 * degrees.to_radians()).sin_cos();
        let over = |t: f64| (1.0 / (c * c) - 1.0 / (c * c + s * s * 0.25 / t.cos().powi(2))) / (2.0 * s * s);
        let n = 20_000;
        (0..n).map(|k| over((f64::from(k) + 0.5) / f64::from(n) * PI / 3.0)).sum::<f64>() * 2.0 * PI / f64::from(n)
    };
    let [high, higher] = [179.0, 179.9].map(stretched);
    for (degrees, truth, digits) in
        [([179.0; 3], high, 1e-7), ([179.9; 3], higher, 1e-7), ([0.0, 90.0, 179.5], 11.18269, 1e-6)]
    {
        let measure = leaning(degrees).unwrap().measure().unwrap();
        assert!(measure.area_error <= 1e-6 * measure.area, "{degrees:?} {measure:?}");
        // As many digits as the truth has.
        assert!((measure.area - truth).abs() < measure.area_error + digits * truth, "{degrees:?} {truth} {measure:?}");
    }
}
