//! Panels of known surfaces, and the ways they are moved, renumbered and mirrored.

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    surface::{CyclidePatch, DupinCyclide, ParamSurface, PatchKind},
};

/// Numbers without a pattern in [0, 1).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }

    /// A motion and a scale: places up to `far` away.
    pub fn similarity(&mut self, scale: f64, far: f64) -> Mobius {
        let turn = Quat::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0), 0.3);
        Mobius::similarity(turn * (1.0 / turn.norm()), scale, self.vector() * far).unwrap()
    }
}

pub fn plane() -> CyclidePatch {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.7, 0.0], [1.0, 0.7, 0.0]].map(Point3::from);
    CyclidePatch::from_corners_and_frame(corners, Vec3::new(1.0, 0.5, 0.0), Vec3::new(-0.5, 1.0, 0.0)).unwrap()
}

/// A part of the cylinder of radius 2 about z.
pub fn cylinder() -> CyclidePatch {
    let at = |a: f64, z: f64| Point3::new(2.0 * a.cos(), 2.0 * a.sin(), z);
    let corners = [at(0.2, 0.0), at(1.0, 0.0), at(0.2, 1.5), at(1.0, 1.5)];
    CyclidePatch::from_corners_and_frame(corners, Vec3::new(-(0.2_f64.sin()), 0.2_f64.cos(), 0.0), Vec3::Z).unwrap()
}

/// A part of a cone of half angle 0.4 about z.
pub fn cone() -> CyclidePatch {
    let at = |a: f64, h: f64| Point3::new(h * 0.4_f64.tan() * a.cos(), h * 0.4_f64.tan() * a.sin(), h);
    let corners = [at(0.0, 2.0), at(0.9, 2.0), at(0.0, 3.0), at(0.9, 3.0)];
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::new(0.4_f64.sin(), 0.0, 0.4_f64.cos())).unwrap()
}

/// A part of the cone of radius `2 + z/20` about z, half a radian wide, from height `z`: near to a cylinder.
pub fn narrow_cone(z: f64) -> CyclidePatch {
    let at = |a: f64, z: f64| Point3::new((2.0 + z / 20.0) * a.cos(), (2.0 + z / 20.0) * a.sin(), z);
    let corners = [at(0.0, z), at(0.5, z), at(0.0, z + 1.0), at(0.5, z + 1.0)];
    let ruling = Vec3::new(1.0, 0.0, 20.0).unit().unwrap();
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, ruling).unwrap()
}

/// A part of the sphere of the given radius: from any four points of a circle on it, with any frame.
pub fn sphere(radius: f64) -> CyclidePatch {
    let at = |a: f64| Point3::new(0.4 * radius * a.cos(), 0.4 * radius * a.sin(), 0.84_f64.sqrt() * radius);
    let [p0, p1, p3, p2] = [0.0, 1.4, 3.0, 4.4].map(at);
    let normal = p0.to_vec().unit().unwrap();
    let v1 = normal.cross(Vec3::new(1.0, 0.3, 0.2)).unit().unwrap();
    CyclidePatch::from_corners_and_frame([p0, p1, p2, p3], v1, normal.cross(v1)).unwrap()
}

/// A part of the torus with radii 3 and 1: from angle `a` of the tube, 0 outside.
pub fn torus(a: f64) -> CyclidePatch {
    let at = |u: f64, v: f64| {
        let rho = 3.0 + v.cos();
        Point3::new(rho * u.cos(), rho * u.sin(), v.sin())
    };
    let corners = [at(0.0, a), at(0.5, a), at(0.0, a + 0.6), at(0.5, a + 0.6)];
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::new(-a.sin(), 0.0, a.cos())).unwrap()
}

/// The panels of a ring cyclide that is no torus.
pub fn ring(size: [usize; 2]) -> Vec<CyclidePatch> {
    let net = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets(size).unwrap().remove(0);
    net.patches().collect()
}

/// A patch without any symmetry: corners on a circle and some frame.
pub fn general(random: &mut Random) -> CyclidePatch {
    loop {
        let turn = random.between(0.0, 6.0);
        let at = |k: f64, r: f64| {
            let a = turn + std::f64::consts::FRAC_PI_2 * (k + 0.4 * r);
            Point3::new(a.cos(), a.sin(), 0.0)
        };
        let [p0, p1, p3, p2] =
            [at(0.0, random.next()), at(1.0, random.next()), at(2.0, random.next()), at(3.0, random.next())];
        let normal = (Vec3::Z + random.vector() * 0.5).unit().unwrap();
        let along = ((p1 - p0).unit().unwrap() + random.vector() * 0.2).unit().unwrap();
        let v2 = normal.cross(along).unit().unwrap();
        let made = CyclidePatch::from_corners_and_frame([p0, p1, p2, p3], v2.cross(normal), v2);
        if let Some(patch) = made.ok().filter(CyclidePatch::is_regular) {
            return patch;
        }
    }
}

/// The same panel from the next corner on.
pub fn renumbered(patch: &CyclidePatch) -> CyclidePatch {
    let [a0, a1, a2, a3] = patch.corners();
    let [e1, e2, _] = patch.moving_frame(1.0, 0.0);
    CyclidePatch::from_corners_and_frame([a1, a3, a0, a2], e2, -e1).unwrap()
}

/// The same panel with s and t exchanged.
pub fn exchanged(patch: &CyclidePatch) -> CyclidePatch {
    let [a0, a1, a2, a3] = patch.corners();
    let [e1, e2, _] = patch.moving_frame(0.0, 0.0);
    CyclidePatch::from_corners_and_frame([a0, a2, a1, a3], e2, e1).unwrap()
}

pub fn mirrored(patch: &CyclidePatch) -> CyclidePatch {
    patch.transformed(&Mobius::reflection(Point3::new(0.3, 0.1, -0.2), Vec3::new(1.0, 2.0, -2.0)).unwrap()).unwrap()
}

/// Largest distance of the patch from a surface at a fine grid.
pub fn grid_distance(patch: &CyclidePatch, kind: &PatchKind) -> f64 {
    let places = (0..31 * 31).map(|k| (f64::from(k % 31) / 30.0, f64::from(k / 31) / 30.0));
    places.map(|(s, t)| kind.distance(patch.point(s, t)).unwrap()).fold(0.0, f64::max)
}

/// The rank of a kind: later ones are less simple.
pub fn rank(kind: &PatchKind) -> usize {
    match kind {
        PatchKind::Plane { .. } => 0,
        PatchKind::Cylinder { .. } => 1,
        PatchKind::Cone { .. } => 2,
        PatchKind::Sphere { .. } => 3,
        PatchKind::Torus { .. } => 4,
        PatchKind::Cyclide => 5,
    }
}

/// Radii and angles of a kind.
pub fn radii(kind: &PatchKind) -> [f64; 2] {
    match *kind {
        PatchKind::Plane { .. } | PatchKind::Cyclide => [0.0, 0.0],
        PatchKind::Cylinder { radius, .. } | PatchKind::Sphere { radius, .. } => [radius, 0.0],
        PatchKind::Cone { half_angle, .. } => [half_angle, 0.0],
        PatchKind::Torus { major_radius, minor_radius, .. } => [major_radius, minor_radius],
    }
}
