//! Which objects of a model are scheduled, with which thickness, and why the others are not.

use std::collections::HashMap;

use cyclide::{model::SurfaceObject, surface::CyclidicNet};
use serde::Serialize;

use super::error::ScheduleError;
use super::skin::Skin;
use crate::document::{BuiltObject, OfPanels};

/// An object that is not in a schedule.
///
/// ```
/// use cyclide_io::{Document, schedule::{ScheduleOptions, WorkshopSchedule}};
/// let text = r#"{"cyclide": 1, "objects": {
///     "p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]},
///     "c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#;
/// let document: Document = text.parse()?;
/// let schedule = WorkshopSchedule::new(document.units, &document.build()?, &ScheduleOptions::default())?;
/// assert_eq!(schedule.not_scheduled()[0].name, "c");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct NotScheduled {
    /// Its name.
    pub name: String,
    /// The document's word for its construction.
    pub r#type: String,
    /// Why it is not scheduled, or where its figures are listed.
    pub why: String,
}

/// Offsets of a scheduled net at several distances: which of them is the other side of its panels is not known, so each is listed as
/// a skin of its own.
///
/// ```
/// use cyclide_io::{Document, schedule::{ScheduleOptions, WorkshopSchedule}};
/// let text = r#"{"cyclide": 1, "objects": {"skin": {"type": "cyclide", "a": 3, "mu": 1, "segments": [8, 6]},
///     "out": {"type": "offset", "of": "skin", "distance": 0.1}, "in": {"type": "offset", "of": "skin", "distance": -0.1}}}"#;
/// let document: Document = text.parse()?;
/// let schedule = WorkshopSchedule::new(document.units, &document.build()?, &ScheduleOptions::default())?;
/// assert_eq!(schedule.listed_apart()[0].offsets, ["out", "in"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct ListedApart {
    /// The name of the net.
    pub of: String,
    /// Names of its offsets, of which each is listed.
    pub offsets: Vec<String>,
}

/// An object that is scheduled.
pub(super) struct Chosen {
    /// What its parts are named after.
    pub(super) name: String,
    /// Its nets, one or several; those that join are one.
    pub(super) skins: Vec<Skin>,
    /// The distance of the other side of its panels.
    pub(super) thickness: Option<f64>,
}

impl Chosen {
    /// Its nets with their names.
    pub(super) fn nets(&self) -> impl Iterator<Item = (String, &Skin)> {
        let name = |index| if self.skins.len() > 1 { format!("{}.{index}", self.name) } else { self.name.clone() };
        self.skins.iter().enumerate().map(move |(index, skin)| (name(index), skin))
    }
}

/// Refuses objects that would give one name to parts of theirs: `skin.0`, and the first piece of `skin`.
pub(super) fn refuse_equal_names(chosen: &[Chosen]) -> Result<(), ScheduleError> {
    let mut taken: HashMap<String, &str> = HashMap::new();
    for object in chosen {
        for (net, skin) in object.nets() {
            for name in skin.piece_names(&net).into_iter().chain([net]) {
                let first = *taken.entry(name.clone()).or_insert(&object.name);
                if first != object.name {
                    return Err(ScheduleError::NameTaken {
                        name,
                        first: first.to_owned(),
                        second: object.name.clone(),
                    });
                }
            }
        }
    }
    Ok(())
}

/// The offsets that are listed beside the net from which they are made, where it has several.
pub(super) fn listed_apart(objects: &[BuiltObject], chosen: &[Chosen]) -> Vec<ListedApart> {
    let of_net = |net: &Chosen| {
        let is_chosen = |name: &str| chosen.iter().any(|chosen| chosen.name == name);
        let offset = |built: &BuiltObject| match &built.of_panels {
            Some(OfPanels::OtherSide { of, .. }) if *of == net.name => Some(built.item.name.clone()),
            _ => None,
        };
        let offsets: Vec<String> = objects.iter().filter_map(offset).filter(|name| is_chosen(name)).collect();
        (net.thickness.is_none() && offsets.len() > 1).then(|| ListedApart { of: net.name.clone(), offsets })
    };
    chosen.iter().filter_map(of_net).collect()
}

/// The nets of an object, a single patch as one of one panel.
fn skins_of(built: &BuiltObject) -> Vec<Skin> {
    let skin = |surface: &SurfaceObject| match surface {
        SurfaceObject::Patch(patch) => Some(Skin::Net(CyclidicNet::from(*patch))),
        SurfaceObject::Net(net) => Some(Skin::Net(net.clone())),
        SurfaceObject::Layout(layout) => Some(Skin::Layout(layout.clone())),
        SurfaceObject::Body(_) | SurfaceObject::Triangles(_) => None,
    };
    built.item.surfaces().iter().filter_map(skin).collect()
}

/// The objects of a model that are scheduled: those of these names, or all with nets that are no construction geometry.
pub(super) fn choose(
    objects: &[BuiltObject],
    only: &[String],
    thickness: Option<f64>,
) -> (Vec<Chosen>, Vec<NotScheduled>) {
    let wanted = |built: &BuiltObject| {
        if only.is_empty() { !built.construction } else { only.contains(&built.item.name) }
    };
    let by_name = |name: &str| objects.iter().find(|built| built.item.name == name);
    let offsets = || {
        objects.iter().filter_map(|built| match &built.of_panels {
            Some(OfPanels::OtherSide { of, distance, .. }) => Some((of, *distance)),
            _ => None,
        })
    };
    let own_thickness = |name: &str| {
        let mut distances = offsets().filter(|(of, _)| *of == name).map(|(_, distance)| distance);
        let first = distances.next()?;
        distances.all(|other| other.to_bits() == first.to_bits()).then_some(first)
    };
    let (mut chosen, mut others) = (Vec::new(), Vec::new());
    for built in objects {
        let (name, kind) = (&built.item.name, built.provenance.kind);
        let no_net = || format!("`{kind}` is not a net of panels");
        let mut leave = |why: String| others.push(NotScheduled { name: name.clone(), r#type: kind.to_owned(), why });
        if !wanted(built) {
            leave(if only.is_empty() { "construction geometry" } else { "not selected by --object" }.to_owned());
            continue;
        }
        let skins = skins_of(built);
        if !skins.is_empty() {
            let thickness_of = |name: &str| thickness.or_else(|| own_thickness(name));
            if let Some(OfPanels::OtherSide { of, distance, .. }) = &built.of_panels
                && only.is_empty()
                && own_thickness(name).is_none()
                && by_name(of).is_some_and(|source| wanted(source) && !skins_of(source).is_empty())
                && thickness_of(of).is_some_and(|thickness| thickness.to_bits() == distance.to_bits())
            {
                leave(format!("the other side of the panels of `{of}`, which are scheduled"));
                continue;
            }
            let thickness = thickness_of(name);
            chosen.push(Chosen { name: name.clone(), skins, thickness });
            continue;
        }
        match &built.of_panels {
            Some(OfPanels::OtherSide { of, distance, solid: true }) => match by_name(of) {
                Some(source) if wanted(source) => {
                    leave(format!(
                        "the solid between `{of}` and its offset: its figures are listed with the panels of `{of}`"
                    ));
                }
                // The skin is construction geometry: the solid is what is built.
                Some(source) => {
                    let thickness = Some(thickness.unwrap_or(*distance));
                    match skins_of(source) {
                        skins if skins.is_empty() => leave(no_net()),
                        skins => chosen.push(Chosen { name: name.clone(), skins, thickness }),
                    }
                }
                None => leave(no_net()),
            },
            Some(OfPanels::Edges { of }) => {
                leave(if by_name(of).is_some_and(|source| wanted(source) && !skins_of(source).is_empty()) {
                    format!("its arcs are the edges of `{of}`")
                } else {
                    format!("its arcs are the edges of `{of}`, which is not scheduled: add --object {of}")
                });
            }
            _ => leave(no_net()),
        }
    }
    (chosen, others)
}
