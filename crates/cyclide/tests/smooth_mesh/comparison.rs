//! Against flat triangles and curved PN triangles (A. Vlachos, J. Peters, C. Boyd and J. Mitchell, *Curved PN triangles*, 2001):
//! jumps of the normal across edges.

use crate::laws::smooth;
use crate::shapes;
use cyclide::{Point3, Vec3, surface::SmoothMesh};

/// The cubic Bézier triangle of the PN scheme: control points by the corners they belong to.
struct Pn([Point3; 3], [Vec3; 3]);

impl Pn {
    /// Derivatives along two directions that sum to nothing, `e0 - e2` and `e1 - e2`, crossed.
    fn normal(&self, at: [f64; 3]) -> Vec3 {
        let h = 1e-6;
        let moved = |k: usize| {
            let (mut plus, mut minus) = (at, at);
            (plus[k], plus[2]) = (at[k] + h, at[2] - h);
            (minus[k], minus[2]) = (at[k] - h, at[2] + h);
            self.point(plus) - self.point(minus)
        };
        moved(0).cross(moved(1)).unit().unwrap()
    }

    fn point(&self, l: [f64; 3]) -> Point3 {
        let Self(p, n) = self;
        let beside = |i: usize, j: usize| {
            let w = (p[j] - p[i]).dot(n[i]);
            (p[i].to_vec() * 2.0 + p[j].to_vec() - n[i] * w) / 3.0
        };
        let corners = p[0].to_vec() + p[1].to_vec() + p[2].to_vec();
        let pairs = [(0, 1), (1, 0), (1, 2), (2, 1), (2, 0), (0, 2)];
        let e = pairs.iter().fold(Vec3::ZERO, |sum, &(i, j)| sum + beside(i, j)) / 6.0;
        let middle = e + (e - corners / 3.0) * 0.5;
        let mut sum = middle * (6.0 * l[0] * l[1] * l[2]);
        for i in 0..3 {
            sum += p[i].to_vec() * l[i].powi(3);
        }
        for (i, j) in pairs {
            sum += beside(i, j) * (3.0 * l[i] * l[i] * l[j]);
        }
        Point3::ORIGIN + sum
    }
}

const PLACES: [f64; 5] = [0.02, 0.1, 0.3, 0.5, 0.8];

/// Largest jump over all edges of the normals that a rule gives on the two sides, in degrees.
fn jump(surface: &SmoothMesh, normal: impl Fn(usize, [f64; 3]) -> Vec3) -> f64 {
    let mut largest: f64 = 0.0;
    for edge in surface.edges() {
        let (first, Some(second)) = edge.triangles() else { continue };
        for mu in PLACES {
            let at = |triangle: usize| {
                let mut at = [0.0; 3];
                for (vertex, weight) in edge.vertices().into_iter().zip([1.0 - mu, mu]) {
                    at[surface.triangles()[triangle].iter().position(|v| *v == vertex).unwrap()] = weight;
                }
                normal(triangle, at)
            };
            largest = largest.max(at(first).angle(at(second)).to_degrees());
        }
    }
    largest
}

/// The table of `docs/math/triangle-surfaces.md#comparison-with-pn-triangles`.
#[test]
fn jumps_are_those_of_the_table() {
    for (name, mesh, flat, pn) in [
        ("icosahedron", shapes::icosahedron(), 41.8, 15.8),
        ("icosphere", shapes::icosphere(), 22.5, 2.6),
        ("torus", shapes::torus(16, 10), 36.5, 4.9),
        // Of other bumps than those of the table.
        ("bumpy", shapes::bumpy(), 44.1, 8.96),
    ] {
        let surface = smooth(&mesh);
        let corners = |t: usize| surface.triangles()[t].map(|v| surface.positions()[v]);
        let flat_jump = jump(&surface, |t, _| {
            let [a, b, c] = corners(t);
            (b - a).cross(c - a).unit().unwrap()
        });
        let normals = |t: usize| surface.corner_normals()[t].map(|n| surface.normals()[n]);
        let pn_jump = jump(&surface, |t, at| Pn(corners(t), normals(t)).normal(at));
        let compared = surface.comparison().unwrap();
        // The form here has its derivatives from differences of 1e-6: ten digits.
        assert!((compared.pn_jump.to_degrees() - pn_jump).abs() < 1e-7, "{name}");
        assert!((compared.flat_jump.to_degrees() - flat_jump).abs() < 1e-9, "{name}");
        // Both sides are derivatives, equal but for rounding.
        assert!(compared.jump < 1e-12, "{name}: {:e}", compared.jump);
        let from_pn = |t: usize| {
            let at = [0.25, 0.25, 0.5];
            Pn(corners(t), normals(t)).point(at).distance(surface.triangle(t).unwrap().point(at).unwrap())
        };
        let at_one_place = (0..surface.triangles().len()).map(from_pn).fold(0.0, f64::max);
        assert!(at_one_place <= compared.from_pn * (1.0 + 1e-12) && compared.from_pn < 2.0 * at_one_place, "{name}");
        // A little inside, where the normal is that of the derivatives and not the one that is shared.
        let own_jump = jump(&surface, |t, at| {
            let inside = at.map(|v| if v == 0.0 { 1e-10 } else { v });
            surface.triangle(t).unwrap().normal(inside).unwrap()
        });
        // The bend within 1e-10 of an edge, 2e-10 over 0.02, and rounding.
        assert!(own_jump < 1e-5 && pn_jump > 1e4 * own_jump && flat_jump > pn_jump, "{name}: {own_jump:e}");
        // The digits of the table, and its differences.
        assert!(
            (flat_jump / flat - 1.0).abs() < 0.01 && (pn_jump / pn - 1.0).abs() < 0.02,
            "{name}: {flat_jump} {pn_jump}"
        );
    }
}
