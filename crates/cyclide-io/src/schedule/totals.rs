//! Totals of each net and of all: what material is ordered by.

use std::collections::BTreeMap;

use cyclide::{ShortNumber, curve::Arc, model::Units};
use serde::Serialize;

use super::net::{Net, kind_word};
use super::panels::{GroupTotals, PanelGroups};
use super::rows::{form_word, is_arc};

/// How many of a kind, and their area.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub(super) struct Areas {
    pub(super) count: usize,
    pub(super) area: f64,
}

/// How many of a kind, and their length.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
struct Lengths {
    count: usize,
    length: f64,
}

/// What a net, or all of them, consist of; lengths and areas in the model's unit.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(super) struct Totals {
    /// The object; of all together none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) object: Option<String>,
    /// Panels along s and along t.
    #[serde(skip_serializing_if = "Option::is_none")]
    columns_and_rows: Option<[usize; 2]>,
    /// The same for each of several nets that join.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pieces: Vec<[usize; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    thickness: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    beam_depth: Option<f64>,
    pub(super) panels: usize,
    /// Area of all panels: that of the report.
    pub(super) area: f64,
    /// Area of their other side, if they are thick.
    #[serde(skip_serializing_if = "Option::is_none")]
    offset_area: Option<f64>,
    pub(super) nodes: usize,
    pub(super) edges: usize,
    /// Length of all edges, each once.
    pub(super) edge_length: f64,
    /// Edges that have one panel, with their length.
    border: Lengths,
    creases: usize,
    /// Panels by what they lie on, with their area.
    panel_kinds: BTreeMap<&'static str, Areas>,
    /// Edges by their kind, with their length.
    edge_kinds: BTreeMap<&'static str, Lengths>,
    /// Beams by how they are bent, with their area.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    beam_forms: BTreeMap<&'static str, Areas>,
    /// Moulds by the surface that they are, with the number of panels and these panels' area.
    #[serde(flatten)]
    pub(super) groups: GroupTotals,
}

impl Areas {
    pub(super) fn add(&mut self, area: f64) {
        self.count += 1;
        self.area += area;
    }
}

impl Lengths {
    fn add(&mut self, length: f64) {
        self.count += 1;
        self.length += length;
    }
}

impl Totals {
    /// The totals of one net.
    pub(super) fn of_net(nets: &[Net], index: usize, groups: &PanelGroups) -> Self {
        let net = &nets[index];
        let mut totals = Self::of(std::slice::from_ref(net));
        totals.object = Some(net.name.clone());
        let sizes: Vec<[usize; 2]> = net.pieces.iter().map(|piece| piece.size).collect();
        match *sizes.as_slice() {
            [only] => totals.columns_and_rows = Some(only),
            _ => totals.pieces = sizes,
        }
        (totals.thickness, totals.beam_depth) = (net.thickness, net.beam_depth);
        totals.groups = groups.totals(nets, Some(index));
        totals
    }

    /// The totals of all nets.
    pub(super) fn of_all(nets: &[Net], groups: &PanelGroups) -> Self {
        let mut totals = Self::of(nets);
        totals.groups = groups.totals(nets, None);
        totals
    }

    fn of(nets: &[Net]) -> Self {
        let mut totals = Self::default();
        for net in nets {
            totals.panels += net.panels.len();
            totals.nodes += net.nodes.len();
            totals.edges += net.edges.len();
            totals.area += net.panels.iter().map(|panel| panel.measures.area).sum::<f64>();
            totals.edge_length += net.edge_length();
            if let Some(area) = net.panels.iter().map(|panel| panel.offset_area).sum::<Option<f64>>() {
                *totals.offset_area.get_or_insert(0.0) += area;
            }
            for panel in &net.panels {
                totals.panel_kinds.entry(kind_word(&panel.kind)).or_default().add(panel.measures.area);
            }
            for edge in &net.edges {
                let length = Arc::length(&edge.arc);
                let kind = if is_arc(&edge.arc) { "arc" } else { "line" };
                totals.edge_kinds.entry(kind).or_default().add(length);
                if edge.is_border() {
                    totals.border.add(length);
                }
                totals.creases += usize::from(edge.crease.is_some_and(|angle| angle > 0.0));
                if let Some(strip) = &edge.strip {
                    totals.beam_forms.entry(form_word(strip.form())).or_default().add(strip.area());
                }
            }
        }
        totals
    }

    /// The totals in lines.
    pub(super) fn text(&self, units: Units) -> String {
        let unit = units.symbol();
        let short = |value: f64| ShortNumber(value).to_string();
        let (area, length) = (format!("{unit}2"), unit);
        let areas = |kinds: &BTreeMap<&'static str, Areas>| {
            let each = kinds.iter().map(|(kind, all)| format!("{} {kind} ({} {area})", all.count, short(all.area)));
            each.collect::<Vec<_>>().join(", ")
        };
        let lengths = |kinds: &BTreeMap<&'static str, Lengths>| {
            let each = kinds.iter().map(|(kind, all)| format!("{} {kind} ({} {length})", all.count, short(all.length)));
            each.collect::<Vec<_>>().join(", ")
        };
        let head = match (&self.object, self.columns_and_rows) {
            (Some(name), Some([columns, rows])) => format!("{name}: {rows} rows of {columns} panels"),
            (Some(name), None) => format!("{name}: {} connected nets", self.pieces.len()),
            _ => "all nets".to_owned(),
        };
        let mut out = format!("{head}\n");
        let mut line = |name: &str, text: String| {
            if !text.is_empty() {
                out += &format!("  {name:11} {text}\n");
            }
        };
        let other = self.offset_area.map_or(String::new(), |other| format!(", other side {} {area}", short(other)));
        line("panels", format!("{}, area {} {area}{other}", self.panels, short(self.area)));
        line("", areas(&self.panel_kinds));
        for text in self.groups.lines(&area, short) {
            line(text.0, text.1);
        }
        let border = format!("{} of them at the border ({} {length})", self.border.count, short(self.border.length));
        line(
            "edges",
            format!("{}, length {} {length}; {border}; {} creases", self.edges, short(self.edge_length), self.creases),
        );
        line("", lengths(&self.edge_kinds));
        line("nodes", self.nodes.to_string());
        line("beams", areas(&self.beam_forms));
        out
    }
}
