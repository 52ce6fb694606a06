//! The flat patterns of panels that are bent from flat sheets, as a sheet for the cutter.

use cyclide::{
    Aabb, Point3, Result,
    curve::{Arc, ArcPath},
    panel::FlatPattern,
    topology::Side,
};

use super::lettering::height_in_circle;
use super::net::Net;
use super::panels::PanelGroups;
use super::shelf::Shelf;
use super::strips::moved;
use crate::formats::{Lettering, Sheet, SheetLine};

const CUT: usize = 0;
const LABEL: usize = 1;
pub(super) const LAYERS: [&str; 2] = ["CUT", "LABEL"];

/// Part of the room about the middle that the name of a panel takes.
const LETTERS: f64 = 0.8;

/// All patterns, in the order of the table of panels.
pub(super) fn sheet(nets: &[Net], groups: &PanelGroups) -> Result<Sheet> {
    let mut drawn: Vec<(ArcPath, String)> = Vec::new();
    for (n, net) in nets.iter().enumerate() {
        for k in 0..net.panels.len() {
            if let Some(pattern) = groups.pattern((n, k)) {
                drawn.push((outline(pattern)?, net.panel_id(k)));
            }
        }
    }
    let bounds = |path: &ArcPath| path.arcs().iter().map(Arc::bounds).reduce(Aabb::union);
    let boxes: Vec<Aabb> = drawn.iter().filter_map(|(outline, _)| bounds(outline)).collect();
    let mut sheet = Sheet { layers: LAYERS.to_vec(), ..Sheet::default() };
    for ((outline, text), shift) in drawn.into_iter().zip(Shelf::of(&boxes)) {
        let count = outline.arcs().len() as f64;
        let sum = outline.arcs().iter().map(|arc| arc.midpoint().to_vec()).reduce(|a, b| a + b).unwrap_or_default();
        let middle = Point3::ORIGIN + sum / count;
        let away = outline.arcs().iter().map(|arc| arc.closest_point(middle).distance).fold(f64::INFINITY, f64::min);
        let height = height_in_circle(&text, LETTERS * away);
        sheet.lines.push(SheetLine { layer: CUT, path: moved(&outline, shift)? });
        sheet.letters.push(Lettering { layer: LABEL, text, height, at: middle + shift });
    }
    Ok(sheet)
}

/// The sides of a pattern one after the other, counter-clockwise.
fn outline(pattern: &FlatPattern) -> Result<ArcPath> {
    let mut arcs = Vec::new();
    for side in Side::LOOP {
        let own = pattern.sides[side as usize].arcs();
        if side.runs_with_loop() {
            arcs.extend_from_slice(own);
        } else {
            arcs.extend(own.iter().rev().map(Arc::reversed));
        }
    }
    // A side of one point is no line.
    arcs.retain(|arc| arc.start() != arc.end());
    ArcPath::new(arcs, true)
}
