//! The tables: what stands in each column of panels, edges, nodes and beams.

use cyclide::{curve::Arc, model::Units, surface::StripForm, topology::Side};

use super::net::{Net, kind_word};
use super::panels::PanelGroups;
use super::table::{Measure, Row, Table};

/// Arcs that turn by less are lines: their sagitta is below all rounding.
pub(super) const STRAIGHT: f64 = 1e-9;

/// The sides of a panel round its border, counter-clockwise seen against its normal.
const SIDES: [(Side, &str); 4] =
    [(Side::Bottom, "bottom"), (Side::Right, "right"), (Side::Top, "top"), (Side::Left, "left")];

/// The corners by their parameters s and t.
const CORNERS: [&str; 4] = ["00", "10", "01", "11"];

/// True of an arc that the schedule calls one, not a line.
pub(super) fn is_arc(arc: &Arc) -> bool {
    arc.angle() > STRAIGHT
}

fn arc_columns(row: &mut Row, prefix: &str, arc: Option<&Arc>) {
    let bent = arc.filter(|arc| is_arc(arc));
    row.text(format_args!("{prefix}kind"), arc.map(|arc| if is_arc(arc) { "arc" } else { "line" }));
    row.number(format_args!("{prefix}length"), Measure::Length, arc.map(Arc::length));
    row.number(format_args!("{prefix}chord"), Measure::Length, arc.map(|arc| arc.chord().length()));
    row.number(format_args!("{prefix}radius"), Measure::Length, bent.and_then(Arc::radius));
    row.number(format_args!("{prefix}sweep"), Measure::Angle, bent.map(Arc::angle));
    row.point(format_args!("{prefix}centre"), bent.and_then(Arc::center));
    row.direction(format_args!("{prefix}axis"), bent.and_then(Arc::normal));
}

/// The panels of all nets.
pub(super) fn panels(nets: &[Net], groups: &PanelGroups, units: Units) -> Table {
    let items = nets.iter().enumerate().flat_map(|(n, net)| (0..net.panels.len()).map(move |k| (n, net, k)));
    Table::of("panels", units, items, |row, item| {
        let net = item.map(|(_, net, _)| *net);
        let panel = item.map(|(_, net, k)| &net.panels[*k]);
        row.text(format_args!("id"), item.map(|(_, net, k)| net.panel_id(*k)));
        row.text(format_args!("object"), item.map(|(_, net, k)| net.piece_name(net.panels[*k].piece)));
        row.count(format_args!("row"), panel.map(|panel| panel.place[1]));
        row.count(format_args!("column"), panel.map(|panel| panel.place[0]));
        row.text(format_args!("kind"), panel.map(|panel| kind_word(&panel.kind)));
        row.number(format_args!("area"), Measure::Area, panel.map(|panel| panel.measures.area));
        row.number(format_args!("offset_area"), Measure::Area, panel.and_then(|panel| panel.offset_area));
        row.number(format_args!("sagitta"), Measure::Length, panel.map(|panel| panel.measures.sagitta));
        row.number(format_args!("twist"), Measure::Angle, panel.map(|panel| panel.patch.twist()));
        row.number(format_args!("turn"), Measure::Angle, panel.map(|panel| panel.measures.turn));
        for (index, name) in ["length", "width", "height"].into_iter().enumerate() {
            row.number(format_args!("blank_{name}"), Measure::Length, panel.map(|panel| panel.measures.size[index]));
        }
        groups.columns(row, item.map(|(n, _, k)| (*n, *k)));
        for (corner, name) in CORNERS.into_iter().enumerate() {
            row.text(format_args!("node_{name}"), item.map(|(_, net, k)| net.node_id(net.panels[*k].nodes[corner])));
            row.point(format_args!("corner_{name}"), panel.map(|panel| panel.patch.corners()[corner]));
        }
        for (side, name) in SIDES {
            let edge = panel.map(|panel| panel.sides[side as usize]);
            let id = |edge: usize| net.map(|net| net.edge_id(edge));
            row.text(format_args!("{name}_edge"), edge.flatten().and_then(|edge| id(edge.edge)));
            let along = edge.flatten().and_then(|use_of| {
                let arc = net?.edges[use_of.edge].arc;
                Some(if use_of.forward { arc } else { arc.reversed() })
            });
            arc_columns(row, &format!("{name}_"), along.as_ref());
        }
    })
}

/// The edges of all nets.
pub(super) fn edges(nets: &[Net], units: Units) -> Table {
    let items = nets.iter().flat_map(|net| (0..net.edges.len()).map(move |k| (net, k)));
    Table::of("edges", units, items, |row, item| {
        let edge = item.map(|(net, k)| &net.edges[*k]);
        row.text(format_args!("id"), item.map(|(net, k)| net.edge_id(*k)));
        row.text(format_args!("object"), item.map(|(net, k)| net.piece_name(net.edges[*k].piece)));
        row.text(format_args!("direction"), edge.map(|edge| ["s", "t"][edge.direction]));
        row.count(format_args!("row"), edge.map(|edge| edge.place[1]));
        row.count(format_args!("column"), edge.map(|edge| edge.place[0]));
        for side in 0..2 {
            let id = item.and_then(|(net, k)| net.edges[*k].panels[side].map(|panel| net.panel_id(panel)));
            row.text(format_args!("panel_{}", side + 1), id);
        }
        for (end, name) in ["start", "end"].into_iter().enumerate() {
            row.text(format_args!("{name}_node"), item.map(|(net, k)| net.node_id(net.edges[*k].nodes[end])));
        }
        arc_columns(row, "", edge.map(|edge| &edge.arc));
        row.number(format_args!("crease"), Measure::Angle, edge.and_then(|edge| edge.crease));
        let offset = edge.and_then(|edge| edge.offset.as_ref());
        row.number(format_args!("offset_length"), Measure::Length, offset.map(Arc::length));
        let radius = offset.filter(|arc| is_arc(arc)).and_then(Arc::radius);
        row.number(format_args!("offset_radius"), Measure::Length, radius);
    })
}

/// The nodes of all nets.
pub(super) fn nodes(nets: &[Net], units: Units) -> Table {
    let most = nets.iter().flat_map(|net| &net.nodes).map(|node| node.beams.len()).max().unwrap_or(0);
    let items = nets.iter().flat_map(|net| (0..net.nodes.len()).map(move |k| (net, k)));
    Table::of("nodes", units, items, |row, item| {
        let node = item.map(|(net, k)| &net.nodes[*k]);
        row.text(format_args!("id"), item.map(|(net, k)| net.node_id(*k)));
        row.text(format_args!("object"), item.map(|(net, k)| net.piece_name(net.nodes[*k].piece)));
        row.count(format_args!("row"), node.map(|node| node.place[1]));
        row.count(format_args!("column"), node.map(|node| node.place[0]));
        row.point(format_args!("position"), node.map(|node| node.point));
        row.direction(format_args!("normal"), node.map(|node| node.normal));
        row.point(format_args!("offset_position"), node.and_then(|node| node.offset));
        row.count(format_args!("valence"), node.map(|node| node.beams.len()));
        for index in 0..most {
            let beam = node.and_then(|node| node.beams.get(index));
            let name = index + 1;
            let id = item.zip(beam).map(|((net, _), beam)| net.edge_id(beam.edge));
            row.text(format_args!("beam{name}_edge"), id);
            row.direction(format_args!("beam{name}"), beam.map(|beam| beam.direction));
            row.number(format_args!("beam{name}_to_next"), Measure::Angle, beam.map(|beam| beam.to_next));
            row.number(format_args!("beam{name}_tilt"), Measure::Angle, beam.map(|beam| beam.tilt));
        }
    })
}

/// The word for how a strip is bent.
pub(super) const fn form_word(form: StripForm) -> &'static str {
    match form {
        StripForm::Cylinder { .. } => "cylinder",
        StripForm::Cone { .. } => "cone",
        _ => "flat",
    }
}

/// The beams of all nets that have some.
pub(super) fn beams(nets: &[Net], units: Units) -> Table {
    let items = nets.iter().flat_map(|net| (0..net.edges.len()).map(move |k| (net, k)));
    let items = items.filter(|(net, k)| net.edges[*k].strip.is_some());
    Table::of("beams", units, items, |row, item| {
        let edge = item.map(|(net, k)| &net.edges[*k]);
        let strip = edge.and_then(|edge| edge.strip.as_ref());
        row.text(format_args!("id"), item.map(|(net, k)| net.edge_id(*k)));
        row.text(format_args!("object"), item.map(|(net, k)| net.piece_name(net.edges[*k].piece)));
        for (end, name) in ["start", "end"].into_iter().enumerate() {
            row.text(format_args!("{name}_node"), item.map(|(net, k)| net.node_id(net.edges[*k].nodes[end])));
        }
        row.text(format_args!("form"), strip.map(|strip| form_word(strip.form())));
        row.number(format_args!("area"), Measure::Area, strip.map(|strip| strip.area()));
        let bent = strip.map(|strip| strip.form());
        let radius = |side: usize| match bent? {
            StripForm::Cylinder { radius } => Some(radius),
            StripForm::Cone { radii, .. } => Some(radii[side]),
            _ => None,
        };
        for (side, name) in ["lower", "upper"].into_iter().enumerate() {
            row.number(format_args!("{name}_height"), Measure::Length, strip.map(|strip| strip.heights()[side]));
            row.number(format_args!("{name}_length"), Measure::Length, strip.map(|strip| strip.lengths()[side]));
            let flat = strip.filter(|strip| strip.flat_angle() > STRAIGHT).and_then(|strip| strip.flat_radii());
            row.number(format_args!("{name}_flat_radius"), Measure::Length, flat.map(|radii| radii[side]));
            row.number(format_args!("{name}_bent_radius"), Measure::Length, radius(side));
        }
        row.number(format_args!("flat"), Measure::Angle, strip.map(|strip| strip.flat_angle()));
        let half_angle = bent.and_then(|form| match form {
            StripForm::Cone { half_angle, .. } => Some(half_angle),
            _ => None,
        });
        row.number(format_args!("cone_half_angle"), Measure::Angle, half_angle);
    })
}
