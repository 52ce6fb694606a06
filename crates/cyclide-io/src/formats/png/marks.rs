//! The marks of a legend: what the colors and lines of a picture look like.

use super::canvas::{Canvas, Ink, Pixel};
use crate::drawing::palette;

/// Radius of a data point in a picture of the usual width.
pub(super) const DATA: f64 = 4.4;

/// What stands before the text.
#[derive(Debug, Clone, Copy)]
pub(super) enum Mark {
    /// A curve, and whether it is drawn in dashes.
    Line(Ink, bool),
    /// A surface: its color and that of its lines.
    Field(Ink, Ink),
    /// Blocks: surfaces of three families.
    Families,
    Comb,
    /// Data points of a fit.
    Data,
    /// The two directions of curvature.
    Cross(Ink, Ink),
    Umbilic,
    /// None: more than there is room for.
    More,
}

impl Mark {
    /// The color of a number beside it.
    pub(super) fn ink(self) -> Ink {
        match self {
            Self::Line(ink, _) | Self::Field(_, ink) => ink,
            Self::Families | Self::Comb | Self::Data | Self::Cross(..) | Self::Umbilic | Self::More => Ink::TEXT,
        }
    }

    /// Draws it from its left end.
    pub(super) fn draw(self, canvas: &mut Canvas, (x, y): (f64, f64), s: f64) {
        let at = |dx: f64, dy: f64| -> Pixel { ((x + dx * s) as f32, (y + dy * s) as f32) };
        match self {
            Self::Line(ink, false) => canvas.stroke(&[at(2.0, 0.0), at(42.0, 0.0)], false, 3.4 * s, ink),
            Self::Line(ink, true) => canvas.dashes(&[at(2.0, 0.0), at(46.0, 0.0)], false, 3.4 * s, 9.0 * s, ink),
            Self::Field(field, line) => {
                let corners = [at(4.0, 8.0), at(40.0, 8.0), at(40.0, -8.0), at(4.0, -8.0)];
                canvas.fill(&corners, field);
                canvas.stroke(&corners, true, 1.5 * s, line);
            }
            Self::Families => {
                for axis in 0..3 {
                    let [field, line] = family(axis);
                    let x = 4.0 + 12.0 * axis as f64;
                    let corners = [at(x, 8.0), at(x + 12.0, 8.0), at(x + 12.0, -8.0), at(x, -8.0)];
                    canvas.fill(&corners, field);
                    canvas.stroke(&corners, true, 1.5 * s, line);
                }
            }
            Self::Comb => {
                let arch = |i: u32| -0.5 * (f64::from(i) - 4.0).powi(2);
                let tips: Vec<Pixel> = (0..9).map(|i| at(2.0 + 5.0 * f64::from(i), -2.0 + arch(i) - 2.0)).collect();
                let feet: Vec<Pixel> = (0..9).map(|i| at(2.0 + 5.0 * f64::from(i), 8.0)).collect();
                let teeth: Vec<[Pixel; 2]> = feet.iter().zip(&tips).map(|(a, b)| [*a, *b]).collect();
                canvas.strokes(teeth.iter().map(<[_; 2]>::as_slice), s, Ink::COMB);
                canvas.stroke(&tips, false, 1.3 * s, Ink::COMB_EDGE);
                canvas.stroke(&feet, false, 2.4 * s, Ink::object(0));
            }
            Self::Data => {
                for (dx, dy) in [(5.0, -1.5), (13.0, 1.5), (31.0, -1.0), (39.0, 1.5)] {
                    canvas.spot(at(dx, dy), DATA * s);
                }
                canvas.stroke(&[at(2.0, 0.0), at(42.0, 0.0)], false, 2.4 * s, Ink::object(0));
                canvas.dot(at(22.0, 0.0), 4.0 * s);
            }
            Self::Cross(along, across) => {
                canvas.stroke(&[at(12.0, 0.0), at(32.0, 0.0)], false, 1.6 * s, along);
                canvas.stroke(&[at(22.0, 10.0), at(22.0, -10.0)], false, 1.6 * s, across);
            }
            Self::Umbilic => canvas.disc(at(22.0, 0.0), 3.0 * s, 6.0 * s, Ink::UMBILIC),
            Self::More => {}
        }
    }
}

/// The colors of the surfaces inside blocks on which a parameter is constant, and of their lines.
pub(super) fn family(axis: usize) -> [Ink; 2] {
    palette::family(axis).map(Ink::of_screen)
}
