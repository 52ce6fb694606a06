//! How much of a surface's shape a construction changed, by numbers free of scale, and from where on that is too much.

use crate::short_number::ShortNumber;

/// A turn of the normals (rms, radians) below which nothing counts as lost: nearly flat inputs.
const LOST_TURN: f64 = 1.0 * DEGREE;
/// A turn below which nothing is worth a warning.
const CHANGED_TURN: f64 = 0.05 * DEGREE;
/// A turn that is worth a warning whatever the other numbers say.
const LARGE_TURN: f64 = 3.0 * DEGREE;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// What may become of a surface whose vertices are moved: the numbers of `70`, part C, and one of relief. All are free
/// of scale. A number is `None` where the surface as given has nothing to compare with: it is flat.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ShapeChange {
    /// Bending, after over before: squared differences of the normals over a fifth of the grid.
    pub bending: Option<f64>,
    /// Thickness, after over before: the least standard deviation of the vertices in any direction.
    pub thickness: Option<f64>,
    /// The turn of the normals over their spread in the input.
    pub normal_turn: Option<f64>,
    /// The turn of the normals, rms over the vertices, radians.
    pub turn: f64,
    /// The part of the surface, 0 to 1, in whose neighbourhood less than half of the input's relief is left.
    pub lost_relief: f64,
    /// Mean angle of the input's grid lines to its curvature lines, in `[0, pi/4]`, radians, weighted by how much the
    /// principal curvatures differ.
    pub across: Option<f64>,
}

/// The values that a number may have.
#[derive(Clone, Copy)]
struct Limits {
    bending: [f64; 2],
    thickness: f64,
    normal_turn: f64,
    lost_relief: f64,
}

/// Outside these the shape is lost. Table and search of the constants: `70`, part C. Of the relief: grids along curvature
/// lines and those with noise up to a fifth of an edge lose it on 0.08 of the surface at most, lost ones on 0.13 or more.
const LOST: Limits = Limits { bending: [0.5, f64::INFINITY], thickness: 0.5, normal_turn: 0.35, lost_relief: 0.12 };
/// Outside these a person should look.
const CHANGED: Limits = Limits { bending: [0.9, 1.2], thickness: 0.8, normal_turn: 0.12, lost_relief: 0.02 };

impl ShapeChange {
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
            found.push(format!("{} % of the bending is left (at least {} %)", percent(b), percent(least)));
        }
        if let Some(b) = self.bending.filter(|b| *b > most) {
            found.push(format!("the bending is {} % of that given (at most {} %)", percent(b), percent(most)));
        }
        if let Some(t) = self.thickness.filter(|t| !(*t >= limits.thickness)) {
            let least = percent(limits.thickness);
            found.push(format!("{} % of the thickness is left (at least {least} %)", percent(t)));
        }
        if let Some(t) = self.normal_turn.filter(|t| !(*t <= limits.normal_turn)) {
            let (by, most) = (degrees(self.turn), percent(limits.normal_turn));
            let part = percent(t);
            found
                .push(format!("the normals turned by {by} degrees (rms), {part} % of their spread (at most {most} %)"));
        }
        if !(self.lost_relief <= limits.lost_relief) {
            let (lost, most) = (percent(self.lost_relief), percent(limits.lost_relief));
            found.push(format!("humps or ripples are lost on {lost} % of the surface (at most {most} %)"));
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
        let cause = match self.across {
            Some(angle) => {
                format!("; the lines of the grid run {} degrees off the curvature lines", degrees(angle))
            }
            None => String::new(),
        };
        format!("{}{cause}: mesh the surface along its curvature lines first", facts.join(", "))
    }
}

fn percent(part: f64) -> ShortNumber {
    rounded(100.0 * part)
}

/// An angle as messages give it: in degrees, to three digits at most.
pub(crate) fn degrees(angle: f64) -> ShortNumber {
    rounded(angle.to_degrees())
}

/// One decimal below ten, else none: figures to judge by.
fn rounded(value: f64) -> ShortNumber {
    let steps = if value.abs() < 10.0 { 10.0 } else { 1.0 };
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
    };

    #[test]
    fn each_number_alone_refuses_and_warns() {
        assert!(!KEPT.is_lost() && !KEPT.is_doubtful());
        for (lost, doubtful, words) in [
            (Some(0.3), Some(0.8), "30 % of the bending is left (at least 50 %)"),
            (Some(f64::NAN), Some(1.3), "the bending is left"),
        ] {
            let (lost, doubtful) = (ShapeChange { bending: lost, ..KEPT }, ShapeChange { bending: doubtful, ..KEPT });
            assert!(lost.is_lost() && doubtful.is_doubtful() && !doubtful.is_lost());
            assert!(lost.lost().contains(words), "{}", lost.lost());
        }
        let thin = ShapeChange { thickness: Some(0.4), ..KEPT };
        let turned = ShapeChange { normal_turn: Some(0.4), ..KEPT };
        let smoothed = ShapeChange { lost_relief: 0.13, ..KEPT };
        for lost in [thin, turned, smoothed] {
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
        let words = "2.1 % of the thickness is left (at least 50 %), the normals turned by 1.7 degrees (rms); \
                     the lines of the grid run 29 degrees off the curvature lines: mesh the surface along its curvature \
                     lines first";
        assert_eq!(lost.lost(), words);
    }
}
