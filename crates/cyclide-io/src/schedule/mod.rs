//! Nets as a workshop's lists: panels, edges, nodes and beams as tables, plans and flat strips as drawings, and totals that
//! material is ordered by (`docs/schedule.md`). Everything is measured on the kernel's patches and arcs; every file is read
//! back before it is handed out.

mod choice;
mod error;
mod lettering;
mod net;
mod panels;
mod patterns;
mod plan;
mod rows;
mod shelf;
mod skin;
mod strips;
mod table;
mod totals;
mod view;

use cyclide::model::Units;
use serde::Serialize;

use crate::document::BuiltObject;
use crate::formats::Sheet;
pub use choice::{ListedApart, NotScheduled};
pub use error::ScheduleError;
use net::Net;
use panels::PanelGroups;
use table::Table;
use totals::Totals;

/// The word for the form of `schedule.json`.
const FORM: &str = "cyclide-schedule/1";
/// Tolerance of moulds and of panels that are alike, as part of the mean edge.
const TOLERANCE: f64 = 1e-3;
/// Curves of plans are drawn within this part of the net, as those of other drawings.
const DRAWN: f64 = 1e-5;
/// Areas of the panels together and of the whole net agree to this part of it: each is known to 1e-12.
const AREA_LIMIT: f64 = 1e-11;
/// Lengths of flat strips and of the edges of the parallel net agree to this part of them.
const LENGTH_LIMIT: f64 = 1e-9;

/// Options of a schedule.
///
/// ```
/// use cyclide_io::schedule::ScheduleOptions;
/// let options = ScheduleOptions { thickness: Some(0.02), ..ScheduleOptions::default() };
/// assert!(options.objects.is_empty() && options.beam_depth.is_none());
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScheduleOptions {
    /// Distance of the other side of all panels along the normals; default: that of the document's `offset` of each net.
    pub thickness: Option<f64>,
    /// Depth of the beams from the edges along the normals; default: the thickness.
    pub beam_depth: Option<f64>,
    /// Distance within which a panel is on a plane, sphere, cylinder or torus; default: a thousandth of the mean edge.
    pub tolerance: Option<f64>,
    /// Distance within which panels are congruent; default: the tolerance.
    pub congruent_within: Option<f64>,
    /// Names of the objects; if empty, all nets except construction geometry.
    pub objects: Vec<String>,
}

/// The schedule of the nets of a model.
///
/// ```
/// use cyclide_io::{Document, schedule::{ScheduleOptions, WorkshopSchedule}};
/// let text = r#"{"cyclide": 1, "units": "m", "objects": {"ring": {"type": "cyclide", "a": 3, "mu": 1, "segments": [8, 6]}}}"#;
/// let document: Document = text.parse()?;
/// let options = ScheduleOptions { thickness: Some(-0.1), ..ScheduleOptions::default() };
/// let schedule = WorkshopSchedule::new(document.units, &document.build()?, &options)?;
/// let files = schedule.files()?;
/// let panels = files.iter().find(|(name, _)| name == "panels.csv").map(|(_, bytes)| bytes.clone()).unwrap_or_default();
/// assert_eq!(String::from_utf8(panels)?.lines().count(), 1 + 48);
/// assert!(schedule.text().contains("48, area 118.4"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct WorkshopSchedule {
    units: Units,
    tolerance: f64,
    congruent_within: f64,
    nets: Vec<Net>,
    groups: PanelGroups,
    not_scheduled: Vec<NotScheduled>,
    listed_apart: Vec<ListedApart>,
}

/// What `schedule.json` holds before the tables.
#[derive(Serialize)]
struct Head<'a> {
    format: &'static str,
    units: &'static str,
    tolerance: f64,
    congruent_within: f64,
    totals: Totals,
    nets: Vec<Totals>,
    not_scheduled: &'a [NotScheduled],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    listed_apart: &'a [ListedApart],
}

impl WorkshopSchedule {
    /// Measures the nets of a model.
    ///
    /// # Errors
    /// [`ScheduleError::NoNet`]; [`ScheduleError::NameTaken`]; [`ScheduleError::Geometry`] for a thickness or depth that reaches a center of
    /// curvature, and for nets that are connected only at nodes.
    pub fn new(units: Units, objects: &[BuiltObject], options: &ScheduleOptions) -> Result<Self, ScheduleError> {
        let (chosen, not_scheduled) = choice::choose(objects, &options.objects, options.thickness);
        if chosen.is_empty() {
            let each = |other: &NotScheduled| format!("{}: {}", other.name, other.why);
            let why = not_scheduled.first().map_or("the model is empty".to_owned(), each);
            return Err(ScheduleError::NoNet { why });
        }
        choice::refuse_equal_names(&chosen)?;
        let listed_apart = choice::listed_apart(objects, &chosen);
        let mut nets = Vec::new();
        for chosen in chosen {
            for (name, skin) in chosen.nets() {
                let depth = options.beam_depth.or(chosen.thickness);
                let measured = Net::new(name, skin, chosen.thickness, depth);
                nets.push(measured.map_err(|source| refused(&chosen.name, source))?);
            }
        }
        let (length, count) =
            nets.iter().fold((0.0, 0), |(length, count), net| (length + net.edge_length(), count + net.edges.len()));
        let tolerance = options.tolerance.unwrap_or(TOLERANCE * length / count.max(1) as f64);
        let congruent_within = options.congruent_within.unwrap_or(tolerance);
        let groups = PanelGroups::new(&nets, tolerance, congruent_within);
        let groups = groups.map_err(|source| refused("the panels", source))?;
        Ok(Self { units, tolerance, congruent_within, nets, groups, not_scheduled, listed_apart })
    }

    /// The objects that are not scheduled, each with the reason.
    #[must_use]
    pub fn not_scheduled(&self) -> &[NotScheduled] {
        &self.not_scheduled
    }

    /// Nets with offsets at several distances, all of which are listed.
    #[must_use]
    pub fn listed_apart(&self) -> &[ListedApart] {
        &self.listed_apart
    }

    /// True if some net has beams.
    #[must_use]
    pub fn has_beams(&self) -> bool {
        self.nets.iter().any(|net| net.beam_depth.is_some())
    }

    /// Totals in lines for a terminal.
    #[must_use]
    pub fn text(&self) -> String {
        let several = (self.nets.len() > 1).then(|| Totals::of_all(&self.nets, &self.groups));
        self.totals().iter().chain(&several).map(|totals| totals.text(self.units)).collect()
    }

    /// Totals of each net.
    fn totals(&self) -> Vec<Totals> {
        (0..self.nets.len()).map(|index| Totals::of_net(&self.nets, index, &self.groups)).collect()
    }

    fn tables(&self) -> [Table; 4] {
        [
            rows::panels(&self.nets, &self.groups, self.units),
            rows::edges(&self.nets, self.units),
            rows::nodes(&self.nets, self.units),
            rows::beams(&self.nets, self.units),
        ]
    }

    /// The drawings with the names of their files.
    fn sheets(&self) -> Result<Vec<(&'static str, Sheet)>, ScheduleError> {
        let refused = |source| refused("the drawings", source);
        let size = |net: &Net| cyclide::Aabb::of_points(net.nodes.iter().map(|node| node.point));
        let size = self.nets.iter().filter_map(size).reduce(cyclide::Aabb::union);
        let tolerance = DRAWN * size.map_or(1.0, cyclide::Aabb::diagonal);
        let plan = plan::sheet(&self.nets, self.units, tolerance).map_err(refused)?;
        let patterns = patterns::sheet(&self.nets, &self.groups).map_err(refused)?;
        Ok(vec![
            ("plan.dxf", plan),
            ("beams.dxf", strips::sheet(&self.nets).map_err(refused)?),
            ("patterns.dxf", patterns),
        ])
    }

    /// `schedule.json`: totals, and the tables as columns and rows.
    fn json(&self, tables: &[Table]) -> String {
        let head = Head {
            format: FORM,
            units: self.units.symbol(),
            tolerance: self.tolerance,
            congruent_within: self.congruent_within,
            totals: Totals::of_all(&self.nets, &self.groups),
            nets: self.totals(),
            not_scheduled: &self.not_scheduled,
            listed_apart: &self.listed_apart,
        };
        // Numbers and words only: nothing that could fail.
        let head = serde_json::to_string_pretty(&head).unwrap_or_default();
        let mut out = head.trim_end().trim_end_matches('}').trim_end().to_owned();
        for table in tables {
            out += &format!(",\n  \"{}\": ", table.name);
            table.push_json(&mut out);
        }
        out + "\n}\n"
    }

    /// The files by name, each read back and compared with the nets.
    ///
    /// # Errors
    /// [`ScheduleError::Check`]; [`ScheduleError::Geometry`] only beyond the range of the kernel's numbers.
    pub fn files(&self) -> Result<Vec<(String, Vec<u8>)>, ScheduleError> {
        let fault = |file: &str, fault: String| ScheduleError::Check { file: file.to_owned(), fault };
        self.check_measures().map_err(|found| fault("schedule.json", found))?;
        let mut files = self.lists()?;
        for (name, sheet) in self.sheets()? {
            let bytes = sheet.write(self.units);
            sheet.check(self.units, &bytes).map_err(|error| fault(name, error.to_string()))?;
            files.push((name.to_owned(), bytes));
        }
        Ok(files)
    }

    /// The tables, each as CSV and all in `schedule.json`.
    fn lists(&self) -> Result<Vec<(String, Vec<u8>)>, ScheduleError> {
        let fault = |file: &str, fault: String| ScheduleError::Check { file: file.to_owned(), fault };
        let tables = self.tables();
        let mut files = Vec::new();
        for table in &tables {
            let (name, bytes) = (format!("{}.csv", table.name), table.csv().into_bytes());
            if let Some(found) = table.csv_differs(&bytes) {
                return Err(fault(&name, found));
            }
            files.push((name, bytes));
        }
        let json = self.json(&tables);
        let read: serde_json::Value =
            serde_json::from_str(&json).map_err(|error| fault("schedule.json", error.to_string()))?;
        for table in &tables {
            if let Some(found) = table.json_differs(&read[table.name]) {
                return Err(fault("schedule.json", format!("{}: {found}", table.name)));
            }
        }
        files.push(("schedule.json".to_owned(), json.into_bytes()));
        Ok(files)
    }

    /// What is measured in two ways agrees: areas by panel and of the whole, flat strips and parallel edges.
    fn check_measures(&self) -> Result<(), String> {
        for net in &self.nets {
            let sum: f64 = net.panels.iter().map(|panel| panel.measures.area).sum();
            if !((sum - net.area).abs() <= AREA_LIMIT * net.area) {
                return Err(format!(
                    "{}: the total area of the panels is {sum}, that of the net {}",
                    net.name, net.area
                ));
            }
            for (index, edge) in net.edges.iter().enumerate() {
                let (Some(strip), Some(offset), true) = (&edge.strip, &edge.offset, net.thickness == net.beam_depth)
                else {
                    continue;
                };
                let far = strip.lengths()[usize::from(strip.heights()[1] > 0.0)];
                let length = offset.length();
                if !((far - length).abs() <= LENGTH_LIMIT * edge.arc.length().max(length)) {
                    return Err(format!(
                        "{}: the length of the strip is {far}, that of the edge {length}",
                        net.edge_id(index)
                    ));
                }
            }
        }
        Ok(())
    }
}

fn refused(object: &str, source: cyclide::Error) -> ScheduleError {
    ScheduleError::Geometry { object: object.to_owned(), source }
}
