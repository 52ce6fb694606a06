//! Curves that bend to and fro more often than their data: one rule for every kind.

use cyclide::{
    Point3, Warning,
    curve::{RoundedTurns, Wavering, wavering, wavering_against},
    model::CurveObject,
    warning::{CurveWarning, WaverRemedy},
};

use crate::document::objects::Builder;
use crate::document::objects::contours::ContourFacts;

/// What a curve is held against.
#[derive(Clone, Copy, PartialEq)]
pub(in crate::document) enum WaverData {
    /// The nodes at which its pieces meet: it passes through all of them.
    Nodes,
    /// Its points, through which it passes.
    Points,
    /// Points within a tolerance.
    Fitted,
    /// Points of it, one per control point.
    ControlPoints,
}

/// How a kind of curve is looked at.
#[derive(Clone, Copy)]
pub(in crate::document) struct WaverRule {
    pub data: WaverData,
    pub remedy: WaverRemedy,
    /// It passes through its data as they are: they may waver themselves.
    pub through: bool,
    /// It may have corners, and goes round those that are not marked.
    pub rounds_corners: bool,
}

impl WaverRule {
    /// Of most curves. A fit does not pass through its points.
    pub(in crate::document) fn of(data: WaverData, remedy: WaverRemedy) -> Self {
        Self { data, remedy, through: data != WaverData::Fitted, rounds_corners: false }
    }

    /// Warns of a curve that bends to and fro between its data, of data that do, and of corners that it goes round.
    pub(in crate::document) fn warnings(self, curve: &CurveObject, points: &[Point3]) -> Vec<Warning> {
        let shape = curve.as_curve();
        let found = match (self.data, curve) {
            (WaverData::Nodes, _) => wavering(shape),
            (WaverData::ControlPoints, CurveObject::Nurbs(nurbs)) => wavering_against(shape, &nurbs.greville_points()),
            _ => wavering_against(shape, points),
        };
        let Wavering { curve, data, explained, nodes, .. } = found;
        let wavers = found.curve_wavers.then_some(Warning::Curve(CurveWarning::Wavers {
            curve,
            data,
            explained,
            remedy: self.remedy,
        }));
        let data_waver = || {
            (self.through && found.data_waver)
                .then_some(Warning::Curve(CurveWarning::DataWaver { changes: data, nodes }))
        };
        let corner = |RoundedTurns { first, count, angle, distance, .. }| {
            Warning::Curve(CurveWarning::CornerNotMarked { node: first, count, angle, distance })
        };
        let rounded = found.rounded.filter(|_| self.rounds_corners);
        wavers.or_else(data_waver).into_iter().chain(rounded.map(corner)).collect()
    }
}

impl Builder<'_> {
    /// Warns of a curve that was not made from points, at a field.
    pub(in crate::document) fn warn_of_wavers(&mut self, field: &str, curve: &CurveObject) {
        self.warn_of_wavers_of(field, None, curve);
    }

    /// The same of several.
    pub(in crate::document) fn warn_of_wavers_in(&mut self, field: &str, made: &[(CurveObject, ContourFacts)]) {
        for (contour, (curve, _)) in made.iter().enumerate() {
            self.warn_of_wavers_of(field, (made.len() > 1).then_some(contour), curve);
        }
    }

    fn warn_of_wavers_of(&mut self, field: &str, contour: Option<usize>, curve: &CurveObject) {
        let rule = self.kind.wavers();
        for warning in rule.into_iter().flat_map(|rule| rule.warnings(curve, &[])) {
            self.warn_at(field, contour, warning);
        }
    }
}
