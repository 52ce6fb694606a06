//! Panels that one mould makes, panels that are alike, and what is bent from flat sheets.

use std::collections::BTreeMap;

use cyclide::{
    Point3, Result, Vec3,
    panel::{Congruences, FlatPattern, MouldShape, Moulds, NearSurface},
    surface::{CyclidePatch, PatchKind},
};
use serde::Serialize;

use super::net::{Net, kind_word};
use super::table::{Measure, Row};

/// The word for panels that are near no simple surface, and for their moulds.
const OWN: &str = "own";

/// What the panels of all nets have in common, by their numbers over all nets.
#[derive(Debug)]
pub(super) struct PanelGroups {
    /// The number of the first panel of each net.
    first: Vec<usize>,
    panels: Vec<Grouped>,
    /// Panels of each class.
    classes: Vec<usize>,
}

/// What is known of one panel.
#[derive(Debug)]
struct Grouped {
    area: f64,
    /// The mould: its name and kind.
    mould: String,
    mould_kind: &'static str,
    /// The mould in the place of the panel; `None` if that has a mould of its own.
    near: Option<NearSurface>,
    class: usize,
    /// Distance from the first panel of the class, laid on it.
    deviation: f64,
    turned_over: bool,
    /// The class of its mirror image.
    mirror: Option<usize>,
    pattern: Option<FlatPattern>,
}

/// How many moulds make how many panels.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub(super) struct MouldShare {
    moulds: usize,
    panels: usize,
    /// Area of these panels.
    area: f64,
}

/// How many moulds there are, and how many kinds of panel.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(super) struct GroupTotals {
    /// Moulds of all kinds, flat sheets among them.
    moulds: usize,
    mould_kinds: BTreeMap<&'static str, MouldShare>,
    /// Panels that are not alike.
    classes: usize,
    /// Panels with a flat pattern, and the area of their patterns.
    patterns: usize,
    pattern_area: f64,
}

impl PanelGroups {
    /// Groups the panels of all nets.
    ///
    /// # Errors
    /// Those of the kernel's groups.
    pub(super) fn new(nets: &[Net], tolerance: f64, congruent_within: f64) -> Result<Self> {
        let mut first = Vec::with_capacity(nets.len());
        let mut patches: Vec<CyclidePatch> = Vec::new();
        for net in nets {
            first.push(patches.len());
            patches.extend(net.panels.iter().map(|panel| panel.patch));
        }
        let areas = nets.iter().flat_map(|net| &net.panels).map(|panel| panel.measures.area);
        let mut panels: Vec<Grouped> = areas.map(Grouped::alone).collect();
        let found = Congruences::new(&patches, congruent_within)?;
        for (index, class) in found.classes.iter().enumerate() {
            for member in &class.panels {
                let panel = &mut panels[member.panel];
                (panel.class, panel.deviation, panel.turned_over) = (index, member.deviation, member.turned_over);
                panel.mirror = class.mirror.map(|(mirror, _)| mirror);
            }
        }
        let moulds = Moulds::new(&patches, tolerance)?;
        let mut numbers: BTreeMap<&'static str, usize> = BTreeMap::new();
        for mould in &moulds.moulds {
            let kind = shape_word(&mould.shape);
            let number = numbers.entry(kind).or_default();
            *number += 1;
            for member in &mould.members {
                let panel = &mut panels[member.panel];
                panel.mould = format!("{kind}-{number}");
                (panel.mould_kind, panel.near) = (kind, Some(member.near));
                if matches!(kind, "plane" | "cylinder" | "cone") {
                    panel.pattern = FlatPattern::new(&patches[member.panel], tolerance)?;
                }
            }
        }
        for index in moulds.free {
            // Those that are alike come from one mould.
            panels[index].mould = format!("{OWN}-{}", class_id(panels[index].class));
        }
        let classes = found.classes.iter().map(|class| class.panels.len()).collect();
        Ok(Self { first, panels, classes })
    }

    fn of(&self, (net, panel): (usize, usize)) -> &Grouped {
        &self.panels[self.first[net] + panel]
    }

    /// The pattern of a panel, if it is bent from a flat sheet.
    pub(super) fn pattern(&self, place: (usize, usize)) -> Option<&FlatPattern> {
        self.of(place).pattern.as_ref()
    }

    /// The columns of a panel.
    pub(super) fn columns(&self, row: &mut Row, place: Option<(usize, usize)>) {
        let panel = place.map(|place| self.of(place));
        row.text(format_args!("mould"), panel.map(|panel| panel.mould.as_str()));
        let near = panel.and_then(|panel| panel.near);
        let surface = near.map(|near| Placed::of(&near.surface));
        row.text(format_args!("near_kind"), near.map(|near| kind_word(&near.surface)));
        row.number(format_args!("near_distance"), Measure::Length, near.map(|near| near.max_distance));
        row.number(format_args!("near_radius"), Measure::Length, surface.as_ref().and_then(|s| s.radius));
        row.number(format_args!("near_major_radius"), Measure::Length, surface.as_ref().and_then(|s| s.major_radius));
        row.number(format_args!("near_half_angle"), Measure::Angle, surface.as_ref().and_then(|s| s.half_angle));
        row.point(format_args!("near_origin"), surface.as_ref().map(|s| s.origin));
        row.direction(format_args!("near_axis"), surface.as_ref().and_then(|s| s.axis));
        row.text(format_args!("class"), panel.map(|panel| class_id(panel.class)));
        row.count(format_args!("class_size"), panel.map(|panel| self.classes[panel.class]));
        row.number(format_args!("class_deviation"), Measure::Length, panel.map(|panel| panel.deviation));
        row.count(format_args!("class_turned_over"), panel.map(|panel| usize::from(panel.turned_over)));
        row.text(format_args!("mirror_class"), panel.and_then(|panel| panel.mirror).map(class_id));
        let pattern = panel.and_then(|panel| panel.pattern.as_ref());
        row.number(format_args!("pattern_area"), Measure::Area, pattern.map(|pattern| pattern.area));
        let change = pattern.map(|pattern| pattern.length_change);
        row.number(format_args!("pattern_length_change"), Measure::Plain, change);
    }

    /// The totals of a net, or of all.
    pub(super) fn totals(&self, nets: &[Net], net: Option<usize>) -> GroupTotals {
        let range = match net {
            Some(net) => self.first[net]..self.first[net] + nets[net].panels.len(),
            None => 0..self.panels.len(),
        };
        let mut totals = GroupTotals::default();
        let mut moulds: BTreeMap<&str, &'static str> = BTreeMap::new();
        let mut classes: Vec<usize> = Vec::new();
        for panel in &self.panels[range] {
            let share = totals.mould_kinds.entry(panel.mould_kind).or_default();
            share.panels += 1;
            share.area += panel.area;
            moulds.insert(&panel.mould, panel.mould_kind);
            classes.push(panel.class);
            if let Some(pattern) = &panel.pattern {
                totals.patterns += 1;
                totals.pattern_area += pattern.area;
            }
        }
        totals.moulds = moulds.len();
        for kind in moulds.into_values() {
            totals.mould_kinds.entry(kind).or_default().moulds += 1;
        }
        classes.sort_unstable();
        classes.dedup();
        totals.classes = classes.len();
        totals
    }
}

impl Grouped {
    /// A panel that is like no other.
    fn alone(area: f64) -> Self {
        Self {
            area,
            mould: String::new(),
            mould_kind: OWN,
            near: None,
            class: 0,
            deviation: 0.0,
            turned_over: false,
            mirror: None,
            pattern: None,
        }
    }
}

fn class_id(class: usize) -> String {
    format!("k{:04}", class + 1)
}

const fn shape_word(shape: &MouldShape) -> &'static str {
    match shape {
        MouldShape::Plane => "plane",
        MouldShape::Cylinder { .. } => "cylinder",
        MouldShape::Cone { .. } => "cone",
        MouldShape::Sphere { .. } => "sphere",
        MouldShape::Torus { .. } => "torus",
    }
}

/// The numbers of a surface in its place.
struct Placed {
    origin: Point3,
    /// Normal of a plane, axis of what turns about one.
    axis: Option<Vec3>,
    radius: Option<f64>,
    major_radius: Option<f64>,
    half_angle: Option<f64>,
}

impl Placed {
    fn of(kind: &PatchKind) -> Self {
        let none = Self { origin: Point3::ORIGIN, axis: None, radius: None, major_radius: None, half_angle: None };
        let at = |frame: &cyclide::Frame| Self { origin: frame.origin(), axis: Some(frame.z()), ..none };
        match kind {
            PatchKind::Plane { frame } => at(frame),
            PatchKind::Sphere { frame, radius, .. } => Self { origin: frame.origin(), radius: Some(*radius), ..none },
            PatchKind::Cylinder { frame, radius, .. } => Self { radius: Some(*radius), ..at(frame) },
            PatchKind::Cone { frame, radius, half_angle, .. } => {
                Self { radius: Some(*radius), half_angle: Some(*half_angle), ..at(frame) }
            }
            PatchKind::Torus { frame, major_radius, minor_radius, .. } => {
                Self { radius: Some(*minor_radius), major_radius: Some(*major_radius), ..at(frame) }
            }
            PatchKind::Cyclide => none,
        }
    }
}

impl GroupTotals {
    /// Moulds and classes in lines.
    pub(super) fn lines(&self, area: &str, short: impl Fn(f64) -> String) -> Vec<(&'static str, String)> {
        let each = self.mould_kinds.iter().map(|(kind, share)| {
            let (moulds, panels) = (share.moulds, share.panels);
            format!("{moulds} {kind} for {panels} panels ({} {area})", short(share.area))
        });
        let mut lines = vec![
            ("moulds", format!("{}: {}", self.moulds, each.collect::<Vec<_>>().join(", "))),
            ("classes", format!("{} of congruent panels", self.classes)),
        ];
        if self.patterns > 0 {
            let text = format!("{} panels from flat sheets ({} {area})", self.patterns, short(self.pattern_area));
            lines.push(("patterns", text));
        }
        lines
    }
}
