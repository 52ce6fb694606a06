//! Samples of one object as CSV: parameter, point, unit tangent, curvature.

use cyclide::{ArcLength, Item};

use crate::csv_samples::push_sample;

/// Where the samples of a curve lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Spacing {
    /// Equal steps of the parameter.
    #[default]
    Parameter,
    /// Equal steps of arc length.
    Length,
}

/// `count` samples of every contour of an object, both ends included (of a closed contour the last repeats the
/// first). Columns `t,x,y,z,tx,ty,tz,curvature`, with a column `contour` (from 1) in front if there are several.
/// Tangent and curvature are empty where they do not exist.
#[must_use]
pub fn sample(item: &Item, count: usize, spacing: Spacing) -> String {
    let several = item.contours.len() > 1;
    let mut out = format!("{}t,x,y,z,tx,ty,tz,curvature\n", if several { "contour," } else { "" });
    for (contour, curve) in item.contours.iter().enumerate() {
        let curve = curve.as_curve();
        let ts = match spacing {
            Spacing::Parameter => (0..count).map(|i| i as f64 / count.saturating_sub(1).max(1) as f64).collect(),
            Spacing::Length => ArcLength::new(curve).uniform(count),
        };
        for t in ts {
            if several {
                out += &format!("{},", contour + 1);
            }
            push_sample(&mut out, t, curve.eval(t), &curve.jet(t));
        }
    }
    out
}
