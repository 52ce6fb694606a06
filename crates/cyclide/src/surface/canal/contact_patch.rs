//! The canal of balls told by their contacts with one surface (`docs/math/canal-blends.md#the-canal-of-a-family-of-contacts`; source: `002`, section 4,
//! whose balls are those between two cylinders).
//!
//! Contacts `P/w` with unit normals `ν/v` along any rational curve on any surface, and a plane or a sphere that the balls touch besides. With the centers
//! `[X m, X]`, the second normals `n2` and `M = (X m)' X - (X m) X'`, a characteristic circle is turned from the first contact to the second by
//! ```text
//! (1-t) g + t (al + be M),   al = 2 M·(n1 × n2),   be = |n1 - n2|²,   g constant: its sign is that of al where the arc is the shorter one
//! ```

use super::{CanalPatch, ContactPartner};
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::error::{Error, ErrorItem, NumberError, Result};
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial, RationalBezier};

/// Normals this near to the opposite of that in the middle of the curve, as 1 + the cosine, are refused: turns from it vanish there.
const OPPOSITE: f64 = 1e-6;
/// Places of a curve at which that, and the length of normals, are looked at.
const PLACES: u32 = 64;
/// Lengths of normals may differ from 1 by this much.
const UNIT: f64 = 1e-9;

impl CanalPatch {
    /// The patch of the balls that touch a surface along a curve, on the side of its unit normals (the points of a rational curve on the unit sphere,
    /// with the parameter of the contacts), and a plane or a sphere. The arc is the shorter one in the middle. For contacts and normals of degrees d and e the surface has, as it
    /// stands, a degree of up to `8 d + 12 e`.
    ///
    /// ```
    /// use cyclide::{Vec3, rational::RationalBezier, surface::{CanalPatch, ContactPartner}};
    /// // A quarter turn on the cylinder of radius 2 about the z axis, rising from 1 to 3.
    /// let contacts = RationalBezier::new(vec![[2.0, 0.0, 1.0, 1.0], [2.0, 2.0, 2.0, 1.0], [0.0, 4.0, 6.0, 2.0]])?;
    /// let normals = RationalBezier::new(vec![[1.0, 0.0, 0.0, 1.0], [1.0, 1.0, 0.0, 1.0], [0.0, 2.0, 0.0, 2.0]])?;
    /// let floor = ContactPartner::Plane { normal: Vec3::Z, offset: 0.0 };
    /// let patch = CanalPatch::at_contacts(&contacts, &normals, floor)?;
    /// let (center, radius) = patch.ball(0.4);
    /// assert!((center.x.hypot(center.y) - 2.0 - radius).abs() < 1e-14 && (center.z - radius).abs() < 1e-14);
    /// assert!(patch.point(0.4, 1.0).z.abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `zero-axis`, `parallel-contact`, `no-positive-radius`; `parameter-out-of-range` (a normal is not a unit vector, or turns to the opposite of that in the
    /// middle).
    pub fn at_contacts(contacts: &RationalBezier, normals: &RationalBezier, partner: ContactPartner) -> Result<Self> {
        check(contacts, normals, partner)?;
        let p = PolynomialRow::of_rows(contacts.rows());
        let PolynomialRow([x, y, z, v]) = PolynomialRow::of_rows(normals.rows());
        let n = [x, y, z];
        let family = match partner {
            ContactPartner::Plane { normal, offset } => {
                let length = normal.length();
                over_plane(&p, (&n, &v), normal * (1.0 / length), offset / length)
            }
            ContactPartner::Sphere { center, radius } => over_sphere(&p, (&n, &v), center.to_vec(), radius),
        };
        let Family { center, radius, second: (n2, v2) } = family;
        let motion = motion(&center);
        let cross = [
            &(&n[1] * &n2[2]) - &(&n[2] * &n2[1]),
            &(&n[2] * &n2[0]) - &(&n[0] * &n2[2]),
            &(&n[0] * &n2[1]) - &(&n[1] * &n2[0]),
        ];
        let al = &dot(&motion, &cross) * 2.0;
        let be = &(&(&v * &v2) - &dot(&n, &n2)) * 2.0;
        let [i, j, k] = motion.map(|entry| &entry * &be);
        // One factor of the second turn is free: it brings both to about one length.
        let turn = QuatPolynomial([al, i, j, k]);
        let size = turn.value(0.5).norm();
        let g = if turn.0[0].value(0.5) < 0.0 { -size } else { size };
        let start = normals.point(0.5).to_vec().unit().ok_or(Error::zero_axis(ErrorItem::Normal))?;
        let first = turn_to(&n, &v, start);
        Ok(Self::from_turns(center, radius, [&first * &Polynomial::constant(g), &turn * &first]))
    }

    /// From balls `[X m, X]`, `X R`, the turn of the axes into a frame of which the third is the normal at the first contact, the motion of the center along the first two up to one
    /// positive factor, and a turn `v·turn·i` with a vector `v` along the difference of both normals.
    pub(crate) fn from_contact_frames(
        center: PolynomialRow,
        radius: Polynomial,
        turn: &QuatPolynomial,
        [along, round]: [Polynomial; 2],
        opposite: QuatPolynomial,
    ) -> Self {
        let zero = || Polynomial::constant(0.0);
        let circle = QuatPolynomial([&round * -1.0, zero(), zero(), along]);
        Self::from_turns(center, radius, [turn * &circle, opposite])
    }

    /// The other arc of every circle.
    pub(crate) fn with_other_arcs(mut self) -> Self {
        self.turns[1] = &self.turns[1] * &Polynomial::constant(-1.0);
        self
    }

    /// The same run from the second contact to the first.
    pub(crate) fn backwards(mut self) -> Self {
        self.turns.swap(0, 1);
        self
    }
}

/// Balls, and the unit normals of the second contacts as a vector over a weight.
struct Family {
    center: PolynomialRow,
    radius: Polynomial,
    second: ([Polynomial; 3], Polynomial),
}

/// `R = (N·p - d)/(1 - N·n)`.
fn over_plane(p: &PolynomialRow, (n, v): (&[Polynomial; 3], &Polynomial), normal: Vec3, offset: f64) -> Family {
    let [x, y, z, w] = &p.0;
    let along = |[a, b, c]: [&Polynomial; 3]| &(&(a * normal.x) + &(b * normal.y)) + &(c * normal.z);
    let above = &along([x, y, z]) - &(w * offset);
    let apart = v - &along(n.each_ref());
    let center = [x, y, z].into_iter().zip(n).map(|(p, n)| &(p * &apart) + &(&above * n));
    let second = [normal.x, normal.y, normal.z].map(Polynomial::constant);
    Family { center: row(center, w * &apart), radius: &above * v, second: (second, Polynomial::constant(1.0)) }
}

/// `R = (r² - g²)/(2 (n·g - r))`.
fn over_sphere(p: &PolynomialRow, (n, v): (&[Polynomial; 3], &Polynomial), c: Vec3, r: f64) -> Family {
    let [x, y, z, w] = &p.0;
    let g = [x - &(w * c.x), y - &(w * c.y), z - &(w * c.z)];
    let apart = &dot(n, &g) - &(&(w * v) * r);
    let power = &(&(w * w) * (r * r)) - &dot(&g, &g);
    // The weight is positive for balls in finite numbers: so is the sign of all.
    let sign = if (&apart * w).value(0.5) < 0.0 { -1.0 } else { 1.0 };
    let from_center: Vec<Polynomial> =
        g.iter().zip(n).map(|(g, n)| &(&(&(g * &apart) * 2.0) + &(&power * n)) * sign).collect();
    let weight = &(w * &apart) * (2.0 * sign);
    let radius = &(&power * v) * sign;
    let both = &(&weight * r) + &radius;
    let center = from_center.iter().zip([c.x, c.y, c.z]).map(|(m, c)| m + &(&weight * c));
    let center = row(center, weight.clone());
    let entry = |k: usize| from_center.get(k).cloned().unwrap_or_else(|| Polynomial::constant(0.0));
    Family { center, radius, second: ([entry(0), entry(1), entry(2)], both) }
}

fn row(entries: impl Iterator<Item = Polynomial>, weight: Polynomial) -> PolynomialRow {
    let mut entries: Vec<Polynomial> = entries.collect();
    entries.resize(3, Polynomial::constant(0.0));
    let entry = |k: usize| entries[k].clone();
    PolynomialRow([entry(0), entry(1), entry(2), weight])
}

fn dot([a, b, c]: &[Polynomial; 3], [d, e, f]: &[Polynomial; 3]) -> Polynomial {
    &(&(a * d) + &(b * e)) + &(c * f)
}

/// `(X m)' X - (X m) X'`: the motion of the center times the square of the weight.
fn motion(PolynomialRow([x, y, z, w]): &PolynomialRow) -> [Polynomial; 3] {
    let slope = w.derivative();
    [x, y, z].map(|entry| &(&entry.derivative() * w) - &(entry * &slope))
}

/// Turns of the third axis to the normals, by way of a direction: `(v - n a)` turns `a` to `n`.
fn turn_to(n: &[Polynomial; 3], v: &Polynomial, a: Vec3) -> QuatPolynomial {
    let [x, y, z] = n;
    let normal = QuatPolynomial([Polynomial::constant(0.0), x.clone(), y.clone(), z.clone()]);
    let zero = || Polynomial::constant(0.0);
    let weight = QuatPolynomial([v.clone(), zero(), zero(), zero()]);
    let product = &normal * &QuatPolynomial::constant(Quat::from(a * -1.0));
    let to_a = Quat::new(1.0 + a.z, -a.y, a.x, 0.0);
    // Opposite to the third axis any half turn across it does.
    let to_a = if to_a.norm() > OPPOSITE { to_a * (1.0 / to_a.norm()) } else { Quat::new(0.0, 1.0, 0.0, 0.0) };
    &(&weight + &product) * &QuatPolynomial::constant(to_a)
}

fn check(contacts: &RationalBezier, normals: &RationalBezier, partner: ContactPartner) -> Result<()> {
    let middle = normals.point(0.5).to_vec();
    for k in 0..=PLACES {
        let s = f64::from(k) / f64::from(PLACES);
        let normal = normals.point(s).to_vec();
        let (length, turned) = (normal.length(), 1.0 + normal.dot(middle));
        if !((length - 1.0).abs() <= UNIT) {
            let (min, max) = (1.0 - UNIT, 1.0 + UNIT);
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Normal, value: length, min, max }.into());
        }
        if !(turned > OPPOSITE) {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::Normal,
                value: turned,
                min: OPPOSITE,
                max: 2.0,
            }
            .into());
        }
        super::RollingBall::at_contact(contacts.point(s), normal, partner)?;
    }
    Ok(())
}
