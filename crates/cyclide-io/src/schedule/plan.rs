//! Drawings of the nets with the numbers of their panels: a plan where it shows all of them, else elevations too, each panel
//! in the drawing that faces it.

use std::collections::HashMap;

use cyclide::{Aabb, Point3, Result, Vec3, curve::Arc, model::Units, surface::ParamSurface as _, topology::Side};

use super::lettering::{height_in_box, height_in_circle};
use super::net::{Net, kind_word};
use super::strips::moved;
use super::view::View;
use crate::formats::{Lettering, Sheet, SheetLine};

/// Layers: edges between panels, edges of one panel, what is drawn, and the numbers by what the panels lie on.
pub(super) const LAYERS: [&str; 9] =
    ["EDGES", "BORDER", "TITLE", "PLANE", "SPHERE", "CYLINDER", "CONE", "TORUS", "CYCLIDE"];
const EDGES: usize = 0;
const BORDER: usize = 1;
const TITLE: usize = 2;

/// A plan shows all panels if their normals rise from it by this sine at least: it is steeper than a church roof.
const SHOWN: f64 = 0.2;
/// Part of the room about its middle that the number of a panel takes.
const LETTERS: f64 = 0.85;
/// Height of titles, and room before a drawing, as parts of it.
const TITLES: f64 = 0.025;
const ROOM: f64 = 0.1;
/// Places along a side at which its distance from the middle of the panel is taken.
const PLACES: u32 = 8;

/// All nets, one beside the other; the first one at its place.
pub(super) fn sheet(nets: &[Net], units: Units, tolerance: f64) -> Result<Sheet> {
    let mut sheet = Sheet { layers: LAYERS.to_vec(), ..Sheet::default() };
    for net in nets {
        for (view, part, panels) in views(net) {
            let title = if part > 0 { format!("{} {}", view.name, part + 1) } else { view.name.to_owned() };
            let drawing = drawn(net, &view, &format!("{}, {title}, {}", net.name, units.symbol()), &panels, tolerance)?;
            let shift = if sheet.lines.is_empty() {
                Vec3::ZERO
            } else {
                let (all, own) = (sheet.bounds(), drawing.bounds());
                Vec3::new(all.max.x + ROOM * own.diagonal() - own.min.x, all.min.y - own.min.y, 0.0)
            };
            for line in drawing.lines {
                sheet.lines.push(SheetLine { path: moved(&line.path, shift)?, ..line });
            }
            let letters = drawing.letters.into_iter();
            sheet.letters.extend(letters.map(|letters| Lettering { at: letters.at + shift, ..letters }));
        }
    }
    Ok(sheet)
}

/// The views of a net, each with the panels that are drawn in it: every panel in one.
fn views(net: &Net) -> Vec<(View, usize, Vec<usize>)> {
    let places = [[0.5, 0.5], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let rise = |k: usize| places.map(|[s, t]| net.panels[k].patch.unit_normal(s, t).z);
    let all = 0..net.panels.len();
    let up = all.clone().flat_map(rise).fold(f64::INFINITY, f64::min);
    let down = all.clone().flat_map(rise).fold(f64::NEG_INFINITY, f64::max);
    if up >= SHOWN || down <= -SHOWN {
        return vec![(View::PLAN, 0, all.collect())];
    }
    // Drawings show the outside: seen from the middle of the net it is away from it.
    let middle = net.nodes.iter().fold(Vec3::ZERO, |sum, node| sum + node.point.to_vec()) / net.nodes.len() as f64;
    let way = |k: usize| {
        let panel = &net.panels[k];
        panel.measures.area * panel.patch.unit_normal(0.5, 0.5).dot(panel.patch.point(0.5, 0.5).to_vec() - middle)
    };
    let outward = if all.clone().map(way).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
    let facing = |k: usize, view: &View| outward * net.panels[k].patch.unit_normal(0.5, 0.5).dot(view.toward);
    let mut views = View::ALL.map(|view| (view, Vec::new()));
    for k in all {
        let best = (0..views.len()).max_by(|a, b| facing(k, &views[*a].0).total_cmp(&facing(k, &views[*b].0)));
        views[best.unwrap_or(0)].1.push(k);
    }
    // Parts that hang together nowhere may be seen one behind the other, as both walls of a ring: each is drawn by itself.
    let parts = views.into_iter().flat_map(|(view, panels)| {
        let parts = connected(net, &panels);
        parts.into_iter().enumerate().map(move |(part, panels)| (view, part, panels))
    });
    parts.collect()
}

/// Some panels of a net, in parts that hang together by edges.
fn connected(net: &Net, panels: &[usize]) -> Vec<Vec<usize>> {
    let mut part: HashMap<usize, Option<usize>> = panels.iter().map(|&k| (k, None)).collect();
    let mut parts: Vec<Vec<usize>> = Vec::new();
    for &first in panels {
        let mut waiting = vec![first];
        let number = parts.len();
        let mut found = Vec::new();
        while let Some(k) = waiting.pop() {
            match part.get_mut(&k) {
                Some(own @ None) => *own = Some(number),
                _ => continue,
            }
            found.push(k);
            let edges = net.panels[k].sides.iter().flatten().map(|side| &net.edges[side.edge]);
            waiting.extend(edges.flat_map(|edge| edge.panels).flatten());
        }
        if !found.is_empty() {
            found.sort_unstable();
            parts.push(found);
        }
    }
    parts
}

/// A view of some panels of a net.
fn drawn(net: &Net, view: &View, title: &str, panels: &[usize], tolerance: f64) -> Result<Sheet> {
    let mut sheet = Sheet { layers: LAYERS.to_vec(), ..Sheet::default() };
    let mut wanted = vec![false; net.edges.len()];
    for side in panels.iter().flat_map(|&k| net.panels[k].sides).flatten() {
        wanted[side.edge] = true;
    }
    for edge in net.edges.iter().zip(&wanted).filter(|(_, wanted)| **wanted).map(|(edge, _)| edge) {
        let layer = if edge.is_border() { BORDER } else { EDGES };
        if let Some(path) = view.arc(&edge.arc, tolerance)? {
            sheet.lines.push(SheetLine { layer, path });
        }
    }
    let bounds = sheet.lines.iter().flat_map(|line| line.path.arcs()).map(Arc::bounds).reduce(Aabb::union);
    for &k in panels {
        let panel = &net.panels[k];
        let at = view.point(panel.patch.point(0.5, 0.5));
        let away = |p: Point3| view.point(p).distance(at);
        let border = Side::ALL.into_iter().flat_map(|side| {
            (0..=PLACES).map(move |i| {
                let (s, t) = side.place(f64::from(i) / f64::from(PLACES));
                panel.patch.point(s, t)
            })
        });
        let room = LETTERS * border.map(away).fold(f64::INFINITY, f64::min);
        let text = net.panel_number(k);
        let kind = kind_word(&panel.kind).to_uppercase();
        let layer = LAYERS.iter().position(|name| *name == kind).unwrap_or(TITLE);
        sheet.letters.push(Lettering { layer, height: height_in_circle(&text, room), text, at });
    }
    if let Some(bounds) = bounds {
        let size = bounds.max - bounds.min;
        let height = height_in_box(title, size.x, TITLES * bounds.diagonal());
        let at = Point3::new(bounds.min.midpoint(bounds.max).x, bounds.max.y + 2.0 * height, 0.0);
        sheet.letters.push(Lettering { layer: TITLE, text: title.to_owned(), height, at });
    }
    Ok(sheet)
}
