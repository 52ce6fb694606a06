//! How much of a surface's shape a construction changed, by numbers free of scale, and from where on that is too much.

use crate::short_number::ShortNumber;

/// A turn of the normals (rms, radians) below which nothing counts as lost: nearly flat inputs.
const LOST_TURN: f64 = 1.0 * DEGREE;
/// A turn below which nothing is worth a warning.
const CHANGED_TURN: f64 = 0.05 * DEGREE;
/// A turn that is worth a warning whatever the other numbers say.
const LARGE_TURN: f64 = 3.0 * DEGREE;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// What may become of a surface whose vertices are moved: the numbers of `docs/math/circular-meshes.md#guard`, and one
/// of relief. All are free of scale. A number is `None` where the surface as given has nothing to compare with: it is
/// flat.
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_grids::{CircularMeshOptions, make_circular};
/// let tube = (0..17 * 9).map(|k| (0.1 * f64::from(k % 17), 0.1 * f64::from(k / 17)));
/// let tube = tube.map(|(angle, z)| Point3::new(angle.cos(), angle.sin(), z)).collect();
/// let grid = QuadGrid::new(tube, [17, 9], [false; 2])?; // its quads have circles as they are
/// let made = make_circular(&grid, &CircularMeshOptions::default())?;
/// assert!(made.report.shape.is_some_and(|change| !change.is_lost() && change.turn < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct ShapeChange {
    /// Bending, after over before: squared differences of the normals over a fifth of the grid.
    pub bending: Option<f64>,
    /// Thickness, after over before: the least standard deviation of the vertices in any direction.
    pub thickness: Option<f64>,
    /// The turn of the normals over their spread in the input.
    pub normal_turn: Option<f64>,
    /// The turn of the normals, rms over the vertices, radians.
    pub turn: f64,
    /// The part of the surface, 0 to 1, in whose neighborhood less than half of the input's relief is left.
    pub lost_relief: f64,
    /// Mean angle of the input's grid lines to its curvature lines, in `[0, pi/4]`, radians, weighted by how much the
    /// principal curvatures differ; `None` for surfaces that are nearly flat, or flat but for noise.
    pub across: Option<f64>,
    /// The principal curvatures differ enough on the whole for clear curvature lines: the input is not nearly spherical.
    pub clear_lines: bool,
    /// What bends in the input is noise, over the strides that [`bending`](Self::bending) is measured over too: a plane,
    /// which has no curvature lines.
    pub noise: bool,
    /// The grid is closed in a direction: its vertices moved until the frame came back, too.
    pub closed: bool,
}

/// The values that a number may have.
#[derive(Clone, Copy)]
struct Limits {
    bending: [f64; 2],
    thickness: [f64; 2],
    normal_turn: f64,
    lost_relief: f64,
}

/// Outside these the shape is lost. Table and search of the constants: `docs/math/circular-meshes.md#guard`. Of the
/// relief: grids along curvature lines and those with noise up to a fifth of an edge lose it on 0.08 of the surface at
/// most, lost ones on 0.13 or more. Upper limits (own): ripples of three quads swell to 1.9 of the thickness, honest
/// grids stay below 1.05.
const LOST: Limits = Limits { bending: [0.5, 1.5], thickness: [0.5, 1.5], normal_turn: 0.35, lost_relief: 0.12 };
/// Grid lines nearer to the curvature lines than this are along them: another mesh would not be nearer.
const ALONG: f64 = 5.0 * DEGREE;
/// What may help grids between the two, whose border slides along a steep surface: fewer quads slide less.
const NEARER: &str = "mesh the surface more exactly along its curvature lines, or with fewer quads";
/// What may help grids that are along them.
const OPEN: &str = "which is close enough: the border slid along a steep surface, or edges are too uneven or too long for it; use \
                    fewer quads or more even ones, or let the border slide on curves";
const CLOSED: &str = "which is close enough: the vertices moved until the net closed; cut it open if the curvature lines are spirals, \
                      otherwise use more quads round it";
/// Outside these a person should look.
const CHANGED: Limits = Limits { bending: [0.9, 1.2], thickness: [0.8, 1.2], normal_turn: 0.12, lost_relief: 0.02 };

impl ShapeChange {
    /// Grid lines farther off the curvature lines than this on average, in radians, are across them.
    pub const ACROSS: f64 = 15.0 * DEGREE;

    /// The angle of the grid lines to the curvature lines, if these are clear and the angle is more than 15 degrees.
    pub fn runs_across(&self) -> Option<f64> {
        self.across.filter(|angle| *angle > Self::ACROSS && self.clear_lines)
    }

    /// True if a viewer would call the result another surface.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.turn > LOST_TURN && !self.beyond(&LOST).is_empty()
    }

    /// True if the result should be looked at.
    #[must_use]
    pub fn is_doubtful(&self) -> bool {
        self.turn > LARGE_TURN || (self.turn > CHANGED_TURN && !self.beyond(&CHANGED).is_empty())
    }

    /// What is outside the limits, each with its limit.
    fn beyond(&self, limits: &Limits) -> Vec<String> {
        let mut found = Vec::new();
        let [least, most] = limits.bending;
        if let Some(b) = self.bending.filter(|b| !(*b >= least)) {
            found.push(format!("{} % of the bending remains (minimum {} %)", percent(b), percent(least)));
        }
        if let Some(b) = self.bending.filter(|b| *b > most) {
            found.push(format!("the bending is {} % of the original (maximum {} %)", percent(b), percent(most)));
        }
        let [least, most] = limits.thickness;
        if let Some(t) = self.thickness.filter(|t| !(*t >= least)) {
            found.push(format!("{} % of the thickness remains (minimum {} %)", percent(t), percent(least)));
        }
        if let Some(t) = self.thickness.filter(|t| *t > most) {
            found.push(format!("the thickness is {} % of the original (maximum {} %)", percent(t), percent(most)));
        }
        if let Some(t) = self.normal_turn.filter(|t| !(*t <= limits.normal_turn)) {
            let (by, most) = (degrees(self.turn), percent(limits.normal_turn));
            let part = percent(t);
            found
                .push(format!("the normals turned by {by} degrees (rms), {part} % of their spread (maximum {most} %)"));
        }
        if !(self.lost_relief <= limits.lost_relief) {
            let (lost, most) = (percent(self.lost_relief), percent(limits.lost_relief));
            found.push(format!("humps or ripples are lost on {lost} % of the surface (maximum {most} %)"));
        }
        found
    }

    /// The sentence about a lost shape: measures, limits, cause and remedy.
    pub(crate) fn lost(&self) -> String {
        self.sentence(&LOST)
    }

    /// The sentence about a changed shape.
    pub(crate) fn changed(&self) -> String {
        self.sentence(&CHANGED)
    }

    fn sentence(&self, limits: &Limits) -> String {
        let mut facts = self.beyond(limits);
        if self.normal_turn.is_none_or(|t| t <= limits.normal_turn) {
            facts.push(format!("the normals turned by {} degrees (rms)", degrees(self.turn)));
        }
        format!("{}; {}", facts.join(", "), self.cause_and_remedy())
    }

    fn cause_and_remedy(&self) -> String {
        if self.noise {
            return "all bending of the grid is noise, without which it is flat: smooth it or make it planar first"
                .to_owned();
        }
        let Some(angle) = self.across else {
            return "mesh the surface along its curvature lines first".to_owned();
        };
        let off = format!("the grid lines are {} degrees off the curvature lines", degrees(angle));
        match angle {
            _ if angle > Self::ACROSS => format!("{off}: mesh the surface along its curvature lines first"),
            _ if angle > ALONG => format!("{off}: {NEARER}"),
            _ => format!("{off}, {}", if self.closed { CLOSED } else { OPEN }),
        }
    }
}

fn percent(part: f64) -> ShortNumber {
    rounded(100.0 * part)
}

/// An angle as messages give it: in degrees, to three digits at most.
pub(crate) fn degrees(angle: f64) -> ShortNumber {
    rounded(angle.to_degrees())
}

/// One decimal below ten, none above, and one digit of what is smaller than both: figures to judge by.
fn rounded(value: f64) -> ShortNumber {
    let size = value.abs();
    let steps = if size >= 10.0 {
        1.0
    } else if !(f64::MIN_POSITIVE..0.05).contains(&size) {
        10.0
    } else {
        10.0_f64.powi(-size.log10().floor() as i32)
    };
    ShortNumber((value * steps).round() / steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    const KEPT: ShapeChange = ShapeChange {
        bending: Some(1.0),
        thickness: Some(1.0),
        normal_turn: Some(0.0),
        turn: 0.03,
        lost_relief: 0.0,
        across: Some(0.5),
        clear_lines: true,
        noise: false,
        closed: false,
    };

    #[test]
    fn each_number_alone_refuses_and_warns() {
        assert!(!KEPT.is_lost() && !KEPT.is_doubtful());
        for (lost, doubtful, words) in [
            (Some(0.3), Some(0.8), "30 % of the bending remains (minimum 50 %)"),
            (Some(f64::NAN), Some(1.3), "the bending remains"),
        ] {
            let (lost, doubtful) = (ShapeChange { bending: lost, ..KEPT }, ShapeChange { bending: doubtful, ..KEPT });
            assert!(lost.is_lost() && doubtful.is_doubtful() && !doubtful.is_lost());
            assert!(lost.lost().contains(words), "{}", lost.lost());
        }
        let thin = ShapeChange { thickness: Some(0.4), ..KEPT };
        let turned = ShapeChange { normal_turn: Some(0.4), ..KEPT };
        let smoothed = ShapeChange { lost_relief: 0.13, ..KEPT };
        let swollen = ShapeChange { thickness: Some(1.89), ..KEPT };
        let bent = ShapeChange { bending: Some(1.6), ..KEPT };
        for lost in [thin, turned, smoothed, swollen, bent] {
            assert!(lost.is_lost() && lost.is_doubtful());
            // Nearly flat: whatever the ratios, nothing that could be seen has changed.
            let flat = ShapeChange { turn: 0.0005, ..lost };
            assert!(!flat.is_lost() && !flat.is_doubtful());
        }
        assert!(ShapeChange { turn: 0.06, ..KEPT }.is_doubtful());
    }

    #[test]
    fn the_sentence_has_measure_limit_cause_and_remedy() {
        let lost = ShapeChange { thickness: Some(0.021), ..KEPT };
        let words = "2.1 % of the thickness remains (minimum 50 %), the normals turned by 1.7 degrees (rms); \
                     the grid lines are 29 degrees off the curvature lines: mesh the surface along its curvature \
                     lines first";
        assert_eq!(lost.lost(), words);
        // The angle is said whatever it is, and noise has none.
        let along = ShapeChange { across: Some(0.0005), ..lost };
        let off = "are 0.03 degrees off the curvature lines, which is close enough: ";
        assert!(along.lost().contains(&format!("{off}the border slid")), "{}", along.lost());
        let closed = ShapeChange { closed: true, ..along };
        assert!(closed.lost().contains(&format!("{off}the vertices moved until the net closed")), "{}", closed.lost());
        let nearly = ShapeChange { across: Some(0.15), ..lost };
        assert!(nearly.lost().contains("are 8.6 degrees off the curvature lines: mesh"), "{}", nearly.lost());
        let flat = ShapeChange { noise: true, ..lost };
        assert!(flat.lost().contains("is noise") && !flat.lost().contains("curvature lines"), "{}", flat.lost());
    }

    #[test]
    fn small_figures_are_not_nothing() {
        let texts = [0.0, 12.3, 3.12, 0.06, 0.0224, 4e-9, -0.0037].map(|value| rounded(value).to_string());
        assert_eq!(texts, ["0", "12", "3.1", "0.1", "0.02", "4e-9", "-0.004"]);
    }
}
