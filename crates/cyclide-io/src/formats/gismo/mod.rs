//! G+Smo XML: patches of B-splines with weights, for isogeometric analysis, of any degree.
//!
//! Each patch is a `Geometry`; those of one dimension are a `MultiPatch` with their interfaces and boundary, volumes first. Curves are called `Nurbs`, as the
//! readers want it. What a patch belongs to stands in attributes of ours, which readers pass over, the names and the unit in comments.

mod reader;

use crate::check::deviation::{Deviations, View};
use crate::check::labels::{FileLabels, FileName};
use crate::check::made::Made;
use crate::check::rational_cells::bodies_deviation;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Written};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::patch_joints::Joints;
use crate::export::rational_cells::Tags;
use crate::export::ready::ReadyModel;
use crate::export::spline_patches::{Knots, SplinePatch, push_curves, push_surfaces_and_volumes};
use crate::formats::entry::{Entry, Reading};
use crate::text::number::{push_plain, push_spaced};
use crate::text::xml::escaped_in_comment;
use reader::read;
use std::fmt::Write as _;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "xml",
    title: "G+Smo XML",
    suffixes: &["xml"],
    lacks: None,
    animates: false,
    holds_exact_only: true,
    forms: |_| Forms::CHAINS,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: false }),
};

/// What stands before the unit, and before the names.
const UNITS: &str = "cyclide, units ";
const OBJECT: &str = "object ";
/// The number of the first patch: multi-patches have those before it.
const FIRST: usize = 10;
/// A patch and a control point in the file, about: a text that grows is twice there while it moves.
const PATCH: usize = 700;
const CONTROL_POINT: usize = 80;

/// Writes the model.
fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let (mut written, mut patches) = (Written::default(), Vec::new());
    push_curves(job, &mut patches, &mut written)?;
    push_surfaces_and_volumes(job, None, &mut patches, &mut written)?;
    // Readers that take one multi-patch take the first: that of the highest dimension.
    patches.sort_by_key(|patch| std::cmp::Reverse(patch.dimension()));
    let multi_patches = MultiPatch::all(&patches);
    // Curves often begin where others do.
    let touching: usize = multi_patches.iter().filter(|multi| multi.dimension > 1).map(|multi| multi.touching).sum();
    let note = (touching > 0).then(|| {
        format!(
            "{touching} patch sides touch others without being interfaces: weights or parameters differ there, or more than two sides meet"
        )
    });
    let names: Vec<&str> = job.model.items.iter().map(|item| item.name.as_str()).collect();
    let text = text(&patches, &multi_patches, job.units().symbol(), &names);
    Ok(written.exported(text.into_bytes(), note.into_iter().collect()))
}

/// The patches of one dimension.
#[derive(Debug, Clone, PartialEq, Eq)]
struct MultiPatch {
    dimension: usize,
    /// Numbers of the first patch and the last.
    range: [usize; 2],
    /// Interfaces: the numbers of two patches and of their sides, from 1.
    interfaces: Vec<[usize; 4]>,
    /// Sides without an interface: patch and side.
    boundary: Vec<[usize; 2]>,
    touching: usize,
}

impl MultiPatch {
    /// Those of patches that are ordered by their dimension.
    fn all(patches: &[SplinePatch]) -> Vec<Self> {
        let mut first = FIRST;
        let one = |own: &[SplinePatch]| {
            let (from, dimension) = (first, own[0].dimension());
            first += own.len();
            let joints = Joints::of(own);
            let mut joined = vec![vec![false; 2 * dimension]; own.len()];
            joints.pairs.iter().flatten().for_each(|(patch, side)| joined[*patch][*side] = true);
            let free = |(patch, sides): (usize, &Vec<bool>)| {
                let free = sides.iter().enumerate().filter(|(_, joined)| !**joined);
                free.map(|(side, _)| [from + patch, side + 1]).collect::<Vec<_>>()
            };
            Self {
                dimension,
                range: [from, first - 1],
                interfaces: joints.pairs.iter().map(|[a, b]| [from + a.0, a.1 + 1, from + b.0, b.1 + 1]).collect(),
                boundary: joined.iter().enumerate().flat_map(free).collect(),
                touching: joints.touching,
            }
        };
        patches.chunk_by(|a, b| a.dimension() == b.dimension()).map(one).collect()
    }

    /// The directions of the second patch for those of the first at an interface, and whether they run the same way: that across runs on where
    /// one side is at the end of its parameter and the other at the start.
    fn interface(&self, [a, side_a, b, side_b]: [usize; 4]) -> Vec<usize> {
        let axis = |side: usize| (side - 1) / 2;
        let others = |side: usize| (0..self.dimension).filter(move |k| *k != axis(side));
        let mut directions = vec![axis(side_b); self.dimension];
        others(side_a).zip(others(side_b)).for_each(|(k, l)| directions[k] = l);
        let mut same_way = vec![1; self.dimension];
        same_way[axis(side_a)] = usize::from(side_a % 2 != side_b % 2);
        [vec![a, side_a, b, side_b], directions, same_way].concat()
    }
}

/// The file.
fn text(patches: &[SplinePatch], multi_patches: &[MultiPatch], units: &str, names: &[&str]) -> String {
    let points: usize = patches.iter().map(|patch| patch.net.nodes.len()).sum();
    let mut out = String::with_capacity(patches.len() * PATCH + points * CONTROL_POINT);
    // Writing to a string cannot fail.
    let _ = write!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n<!-- {UNITS}{units} -->\n");
    for (number, name) in names.iter().enumerate() {
        let _ = writeln!(out, "<!-- {OBJECT}{number}: {} -->", escaped_in_comment(name));
    }
    for (number, multi) in multi_patches.iter().enumerate() {
        let MultiPatch { dimension, range: [first, last], interfaces, boundary, .. } = multi;
        let _ = write!(
            out,
            "<MultiPatch parDim=\"{dimension}\" id=\"{number}\">\n<patches type=\"id_range\">{first} {last}</patches>\n"
        );
        // Where there are none the element has no text at all: readers take a line end for a list.
        let lines = |rows: Vec<Vec<usize>>| {
            let mut text = String::new();
            for row in rows {
                text.push('\n');
                push_spaced(&mut text, row.into_iter().map(|k| k as f64));
            }
            text
        };
        let interfaces = lines(interfaces.iter().map(|own| multi.interface(*own)).collect());
        let boundary = lines(boundary.iter().map(|own| own.to_vec()).collect());
        let _ = write!(out, "<interfaces>{interfaces}</interfaces>\n<boundary>{boundary}</boundary>\n</MultiPatch>\n");
    }
    for (number, patch) in patches.iter().enumerate() {
        push_patch(&mut out, patch, FIRST + number);
    }
    out.push_str("</xml>\n");
    out
}

fn push_patch(out: &mut String, SplinePatch { knots, net }: &SplinePatch, number: usize) {
    let Tags { object, part, shell, flag } = net.tags;
    let kind = match knots.len() {
        1 => String::new(),
        d => d.to_string(),
    };
    let tensor = if knots.len() > 1 { "Tensor" } else { "" };
    let _ = writeln!(
        out,
        "<Geometry type=\"{tensor}Nurbs{kind}\" id=\"{number}\" object=\"{object}\" part=\"{part}\" shell=\"{shell}\" flag=\"{flag}\">"
    );
    let _ = writeln!(out, "<Basis type=\"{tensor}NurbsBasis{kind}\">");
    if let [only] = knots.as_slice() {
        out.push_str("<Basis type=\"BSplineBasis\">\n");
        push_knots(out, only);
    } else {
        let _ = writeln!(out, "<Basis type=\"TensorBSplineBasis{kind}\">");
        for (axis, knots) in knots.iter().enumerate() {
            let _ = writeln!(out, "<Basis type=\"BSplineBasis\" index=\"{axis}\">");
            push_knots(out, knots);
            out.push_str("</Basis>\n");
        }
    }
    out.push_str("</Basis>\n<weights>\n");
    for index in net.first_fastest() {
        push_plain(out, net.node(index).1);
        out.push('\n');
    }
    out.push_str("</weights>\n</Basis>\n<coefs geoDim=\"3\">\n");
    for index in net.first_fastest() {
        push_spaced(out, net.node(index).0);
        out.push('\n');
    }
    out.push_str("</coefs>\n</Geometry>\n");
}

fn push_knots(out: &mut String, Knots { degree, knots }: &Knots) {
    let _ = write!(out, "<KnotVector degree=\"{degree}\">");
    push_spaced(out, knots.iter().copied());
    out.push_str("</KnotVector>\n");
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let ReadyModel { model, .. } = made.ready;
    let name = |name: &str| escaped_in_comment(name).trim().to_owned();
    let names = model.items.iter().map(|item| FileName::new(reader::NAME, name(&item.name), 1)).collect();
    content.labels.check(&FileLabels::new(model.units, names))?;
    let curves = made.curves(&content, View::Space)?;
    let bodies = bodies_deviation(made, &content, None)?;
    Ok(Deviations { curves, bodies, ..Deviations::default() })
}
