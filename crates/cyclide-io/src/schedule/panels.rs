//! Panels that one mould makes, and panels that are alike.

use serde::Serialize;

use super::net::Net;
use super::table::Row;

/// What the panels have in common.
#[derive(Debug, Default)]
pub(super) struct PanelGroups;

/// How many moulds there are, and how many kinds of panel.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(super) struct GroupTotals {}

impl PanelGroups {
    pub(super) fn columns(&self, _row: &mut Row, _panel: Option<(usize, usize)>) {}

    pub(super) fn totals(&self, _nets: &[Net], _net: Option<usize>) -> GroupTotals {
        GroupTotals::default()
    }
}

impl GroupTotals {
    pub(super) fn lines(&self, _area: &str, _short: impl Fn(f64) -> String) -> Vec<(&'static str, String)> {
        Vec::new()
    }
}
