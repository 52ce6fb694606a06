//! The parameters of a point: Newton steps along three orthogonal lines (`docs/math/volumes.md#location`).

use super::CyclideVolume;
use crate::base::vector::Point3;
use crate::volume::ParamVolume as _;

/// Steps from one start.
const STEPS: usize = 60;
/// Starts along each direction.
const STARTS: usize = 5;
/// Starts from which steps are made: the nearest ones.
const TRIED: usize = 4;
/// Steps below this change nothing.
const STILL: f64 = 1e-15;

/// The place of a volume nearest to a point.
///
/// ```
/// use cyclide::{Point3, Vec3, volume::{CyclideVolume, SphericalCube, VolumeFrame}};
/// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z])?;
/// let found = CyclideVolume::new(&cube, VolumeFrame::Auto)?.locate(Point3::new(0.25, 0.5, 2.0));
/// assert!((found.at[0] - 0.25).abs() < 1e-15 && (found.distance - 1.0).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeLocation {
    /// Parameters s, t, u in `[0, 1]`.
    pub at: [f64; 3],
    /// Distance of the point there: zero, up to rounding, for points inside.
    pub distance: f64,
}

impl CyclideVolume {
    /// The place nearest to a point, by Newton steps from the nearest four of 5 x 5 x 5 places: inside a block without folds the place
    /// of the point itself, outside a place of the border from which no small step comes nearer.
    #[must_use]
    pub fn locate(&self, p: Point3) -> VolumeLocation {
        let at = |k: usize| {
            let step = |k: usize| k as f64 / (STARTS - 1) as f64;
            [step(k % STARTS), step(k / STARTS % STARTS), step(k / STARTS / STARTS)]
        };
        let mut starts: Vec<([f64; 3], f64)> =
            (0..STARTS.pow(3)).map(|k| (at(k), self.point(at(k)).distance(p))).collect();
        starts.sort_by(|x, y| x.1.total_cmp(&y.1));
        let found = starts.iter().take(TRIED).map(|(at, _)| self.descend(p, *at));
        let nearest = found.min_by(|x, y| x.distance.total_cmp(&y.distance));
        nearest.unwrap_or(VolumeLocation { at: [0.0; 3], distance: p.distance(self.corners[0]) })
    }

    /// Steps to the foot along each parameter line, which are orthogonal, halved while they lead away.
    fn descend(&self, p: Point3, start: [f64; 3]) -> VolumeLocation {
        let mut at = start;
        let mut distance = self.point(at).distance(p);
        for _ in 0..STEPS {
            let jet = self.jet(at);
            let way = p - jet.point;
            let step = jet.first.map(|d| {
                let squared = d.length_squared();
                if squared > 0.0 { way.dot(d) / squared } else { 0.0 }
            });
            let to = |part: f64| std::array::from_fn(|k| (at[k] + part * step[k]).clamp(0.0, 1.0));
            let tried = [1.0, 0.5, 0.25, 0.0625, 0.001].into_iter().map(to);
            let Some((next, nearer)) = tried.map(|to| (to, self.point(to).distance(p))).find(|(_, d)| *d < distance)
            else {
                break;
            };
            let moved = (0..3).map(|k| (next[k] - at[k]).abs()).fold(0.0, f64::max);
            (at, distance) = (next, nearer);
            if moved <= STILL {
                break;
            }
        }
        VolumeLocation { at, distance }
    }
}
