//! The beams laid flat, as a sheet for the cutter: strips in rows, each with its name.

use cyclide::{
    Aabb, Point3, Result, Vec3,
    curve::{Arc, ArcPath, ParamCurve as _},
};

use super::lettering::{height_in_box, shrunk};
use super::net::Net;
use super::shelf::Shelf;
use crate::formats::{Lettering, Sheet, SheetLine};

const CUT: usize = 0;
const LABEL: usize = 1;
const SCORE: usize = 2;
pub(super) const LAYERS: [&str; 3] = ["CUT", "LABEL", "SCORE"];

/// Part of the depth that lettering is high, at most.
const LETTERS: f64 = 0.4;
/// Part of the depth that the mark at the edge of the net is long.
const MARK: f64 = 0.15;
/// Part of the length that lettering may take.
const ALONG: f64 = 0.8;

/// A strip laid flat, before it has its place on the sheet.
struct Drawn {
    outline: ArcPath,
    /// Where the net's own edge is, in the middle.
    mark: ArcPath,
    letters: Lettering,
}

/// All strips, in the order of their table.
pub(super) fn sheet(nets: &[Net]) -> Result<Sheet> {
    let mut drawn: Vec<Drawn> = Vec::new();
    for net in nets {
        for (index, edge) in net.edges.iter().enumerate() {
            let Some(strip) = &edge.strip else { continue };
            let outline = strip.outline()?;
            let [low, high] = strip.heights();
            let (depth, middle) = (high - low, 0.5 * (low + high));
            // The net's own edge is at height 0; there the middle is marked.
            let inward = if high > 0.0 { MARK * depth } else { -MARK * depth };
            let mark = Arc::segment(Point3::ORIGIN, Point3::new(0.0, inward, 0.0))?;
            let text = net.edge_id(index);
            let shortest = strip.lengths().into_iter().fold(f64::INFINITY, f64::min);
            let curvature = strip.curvature().abs();
            let free = |half_width: f64, height: f64| {
                // What the long edges rise over half the text leaves less of the depth.
                let rise = 0.5 * curvature * half_width * half_width;
                0.5 * height + rise <= 0.5 * depth * (1.0 - 2.0 * MARK)
            };
            let height = height_in_box(&text, ALONG * shortest, LETTERS * depth);
            let letters = Lettering {
                layer: LABEL,
                height: shrunk(&text, height, free),
                text,
                at: Point3::new(0.0, middle, 0.0),
            };
            drawn.push(Drawn { outline, mark: ArcPath::new(vec![mark], false)?, letters });
        }
    }
    let bounds = |path: &ArcPath| path.arcs().iter().map(Arc::bounds).reduce(Aabb::union).unwrap_or(EMPTY);
    let boxes: Vec<Aabb> = drawn.iter().map(|strip| bounds(&strip.outline)).collect();
    let places = Shelf::of(&boxes);
    let mut sheet = Sheet { layers: LAYERS.to_vec(), ..Sheet::default() };
    for (Drawn { outline, mark, letters }, shift) in drawn.into_iter().zip(places) {
        sheet.lines.push(SheetLine { layer: CUT, path: moved(&outline, shift)? });
        sheet.lines.push(SheetLine { layer: SCORE, path: moved(&mark, shift)? });
        sheet.letters.push(Lettering { at: letters.at + shift, ..letters });
    }
    Ok(sheet)
}

const EMPTY: Aabb = Aabb { min: Point3::ORIGIN, max: Point3::ORIGIN };

/// A path somewhere else on the sheet; its joints stay joints, bit for bit.
pub(super) fn moved(path: &ArcPath, shift: Vec3) -> Result<ArcPath> {
    let arc = |arc: &Arc| Arc::from_weight_ratio(arc.start() + shift, arc.end() + shift, arc.weight_ratio());
    ArcPath::new(path.arcs().iter().map(arc).collect::<Result<_>>()?, path.is_closed())
}
