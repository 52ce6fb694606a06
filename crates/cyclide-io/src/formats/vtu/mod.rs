//! VTK XML unstructured grids: curves, faces and blocks as exact rational Bézier cells, for ParaView and analysis programs.
//!
//! Curves are cells of type 75, faces of type 77, blocks of type 79. The weights are point data that the attribute `RationalWeights` names, without
//! which readers leave them aside; `HigherOrderDegrees` says the degrees of each cell. Cells share no nodes, since weights are theirs alone. What
//! each cell belongs to is cell data, the names of the objects and the unit are field data.

mod cells;
mod order;
mod reader;

use crate::check::deviation::{Deviations, View};
use crate::check::file_content::ReadError;
use crate::check::labels::{FileLabels, FileName};
use crate::check::made::Made;
use crate::check::rational_patches::patches_deviation;
use crate::check::rational_volumes::volume_deviation;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, PieceNotes, Promise, Written, WrittenCurve};
use crate::export::face_plan::ShellPlan;
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::parts::{BodyOf, Contour};
use crate::export::ready::ReadyModel;
use crate::formats::entry::{Entry, Reading};
use crate::text::number::push_plain;
use cells::{CURVE, Cell, HEXAHEDRON, QUADRILATERAL, Tags};
use cyclide::{
    ChainPiece, CurveChain, CutShell, CyclideVolume, DEFAULT_PIECE_ANGLE, FaceGeometry as _, Lowered, Model,
    NurbsCurve, ParamCurve as _, RationalBezier, Shell,
};
use reader::read;

/// What there is to know of the format.
pub(super) static ENTRY: Entry = Entry {
    name: "vtu",
    title: "VTU",
    suffixes: &["vtu"],
    lacks: None,
    animates: false,
    holds_exact_only: true,
    forms: |_| Forms::CHAINS,
    write,
    reading: Some(Reading { read, compare, rounds_by_model: false }),
};

/// Writes the model.
fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let (mut written, mut cells) = (Written::default(), Vec::new());
    for contour in job.contours() {
        let lowered = job.chain(&contour)?;
        written.curves.push(contour.lowered(push_contour(&mut cells, &contour, lowered))?);
    }
    for body in job.bodies {
        match block_of(job.model, body) {
            Some(block) => {
                written.volumes.push(push_block(&mut cells, body, block).map_err(|source| body.unfit(source))?);
                written.shells.push(Vec::new());
            }
            None => {
                written.shells.push(push_faces(&mut cells, body).map_err(|source| body.unfit(source))?);
                written.volumes.push(Vec::new());
            }
        }
        written.bodies.push(Promise::EXACT);
    }
    let names: Vec<&str> = job.model.items.iter().map(|item| item.name.as_str()).collect();
    Ok(written.exported(text(&cells, job.units().symbol(), &names).into_bytes(), Vec::new()))
}

/// The block whose body it is, if it is one's.
fn block_of<'a>(model: &'a Model, body: &BodyOf<'_>) -> Option<&'a CyclideVolume> {
    model.items.get(body.item)?.volumes().get(body.surface)
}

fn push_contour(
    cells: &mut Vec<Cell>,
    contour: &Contour<'_>,
    lowered: Lowered<CurveChain>,
) -> cyclide::Result<WrittenCurve> {
    let promise = Promise::of_chain(&lowered);
    let Lowered { form: chain, correspondence, .. } = lowered;
    let flag = usize::from(chain.is_closed());
    let tags = Tags { object: contour.item, part: contour.index, shell: 0, flag };
    let mut notes = PieceNotes::default();
    for piece in chain.into_pieces() {
        let spans = match piece {
            ChainPiece::Arc(arc) => {
                let spans = arc.to_nurbs(DEFAULT_PIECE_ANGLE)?.to_beziers();
                notes.counts.push(spans.len());
                spans
            }
            ChainPiece::Spline(curve) => {
                notes.counts.extend(std::iter::repeat_n(1, curve.piece_count()));
                curve.to_beziers()
            }
        };
        for span in spans {
            notes.knots.extend([0.0, 1.0]);
            cells.push(curve_cell(&span, tags));
        }
    }
    Ok(notes.of(promise, correspondence))
}

fn curve_cell(span: &RationalBezier, tags: Tags) -> Cell {
    let rows = span.rows();
    Cell::new(CURVE, [rows.len() - 1, 0, 0], |[i, ..]| rows[i], tags)
}

fn push_faces(cells: &mut Vec<Cell>, body: &BodyOf<'_>) -> cyclide::Result<Vec<ShellPlan>> {
    let mut plans = Vec::new();
    for (index, shell) in body.body.shells().enumerate() {
        let cut = CutShell::from(Shell::clone(shell)).with_positive_weights()?;
        for face in cut.shell().faces() {
            let surface = face.surface.to_rational();
            let [p, q] = surface.degrees();
            let flag = usize::from(face.same_sense);
            let tags = Tags { object: body.item, part: body.index, shell: index, flag };
            cells.push(Cell::new(QUADRILATERAL, [p, q, 0], |[i, j, _]| surface.rows()[i * (q + 1) + j], tags));
        }
        plans.push(ShellPlan { shell: index, faces: cut.parts().to_vec() });
    }
    Ok(plans)
}

/// Adds a block, right-handed, in parts with positive weights.
fn push_block(cells: &mut Vec<Cell>, body: &BodyOf<'_>, block: &CyclideVolume) -> cyclide::Result<Vec<[[f64; 2]; 3]>> {
    let tags = Tags { object: body.item, part: body.index, shell: 0, flag: 1 };
    let mut places = Vec::new();
    for (place, part) in block.right_handed().to_rational_parts()? {
        cells.push(Cell::new(HEXAHEDRON, part.degrees(), |at| part.row(at), tags));
        places.push(place);
    }
    Ok(places)
}

/// The file.
fn text(cells: &[Cell], units: &str, names: &[&str]) -> String {
    let points: usize = cells.iter().map(|cell| cell.nodes.len()).sum();
    let mut out = String::with_capacity(points * POINT);
    out.push_str("<?xml version=\"1.0\"?>\n");
    // Before version 2.1 readers permute the nodes of hexahedra.
    out.push_str(
        "<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n",
    );
    out.push_str("<UnstructuredGrid>\n<FieldData>\n");
    push_strings(&mut out, reader::UNITS, &[units]);
    push_strings(&mut out, reader::OBJECTS, names);
    out.push_str(&format!("</FieldData>\n<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{}\">\n", cells.len()));
    let all = || cells.iter().flat_map(|cell| &cell.nodes);
    out.push_str("<PointData RationalWeights=\"RationalWeights\">\n");
    push_array(&mut out, "Float64", reader::WEIGHTS, 1, all().map(|(_, w)| *w));
    out.push_str("</PointData>\n<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n");
    let degrees = cells.iter().flat_map(|cell| cell.degrees).map(|d| d as f64);
    push_array(&mut out, "Float64", reader::DEGREES, 3, degrees);
    for (name, of) in reader::TAGS {
        push_array(&mut out, "Int32", name, 1, cells.iter().map(|cell| of(&cell.tags) as f64));
    }
    out.push_str("</CellData>\n<Points>\n");
    push_array(&mut out, "Float64", reader::POINTS, 3, all().flat_map(|(p, _)| *p));
    out.push_str("</Points>\n<Cells>\n");
    push_array(&mut out, "Int64", reader::CONNECTIVITY, 1, (0..points).map(|k| k as f64));
    let ends = cells.iter().scan(0, |sum, cell| {
        *sum += cell.nodes.len();
        Some(*sum as f64)
    });
    push_array(&mut out, "Int64", reader::OFFSETS, 1, ends);
    push_array(&mut out, "UInt8", reader::TYPES, 1, cells.iter().map(|cell| f64::from(cell.kind)));
    out.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    out
}

/// Length of a point with its weight, about: a text that grows is twice there while it moves.
const POINT: usize = 110;

fn push_array(out: &mut String, kind: &str, name: &str, components: usize, values: impl Iterator<Item = f64>) {
    out.push_str(&format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">"
    ));
    for (k, value) in values.enumerate() {
        out.push(if k % (4 * components.max(3)) == 0 { '\n' } else { ' ' });
        push_plain(out, value);
    }
    out.push_str("\n</DataArray>\n");
}

/// Strings are lists of their bytes, each with a zero at its end.
fn push_strings(out: &mut String, name: &str, strings: &[&str]) {
    out.push_str(&format!(
        "<DataArray type=\"String\" Name=\"{name}\" NumberOfTuples=\"{}\" format=\"ascii\">",
        strings.len()
    ));
    for string in strings {
        out.push('\n');
        string.bytes().for_each(|byte| out.push_str(&format!("{byte} ")));
        out.push('0');
    }
    out.push_str("\n</DataArray>\n");
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let content = read(&made.file.bytes)?;
    let ReadyModel { model, bodies, .. } = made.ready;
    let names = model.items.iter().map(|item| FileName::new(reader::OBJECTS, item.name.as_str(), 1)).collect();
    content.labels.check(&FileLabels::new(model.units, names))?;
    let curves = made.curves(&content, View::Space)?;
    let written = &made.file.written;
    let (mut own, mut plans, mut deviations) = (Vec::new(), Vec::new(), vec![0.0; bodies.len()]);
    let mut first = 0;
    for (index, body) in bodies.iter().enumerate() {
        let parts = written.volumes.get(index).map_or(&[][..], Vec::as_slice);
        if let Some(block) = block_of(model, body) {
            let read = content.volumes.get(first..first + parts.len());
            let read = read.ok_or(ReadError::Volume { volume: first, detail: "it is not there" })?;
            deviations[index] = volume_deviation(&block.right_handed(), parts, read, first)?;
            first += parts.len();
        } else {
            own.push(body);
            plans.extend(written.shells.get(index).cloned());
        }
    }
    if first != content.volumes.len() {
        return Err(ReadError::Volume { volume: first, detail: "the model has no more" });
    }
    let of_faces = patches_deviation(&own, &plans, &content.patches)?;
    let faces = bodies.iter().enumerate().filter(|(_, body)| block_of(model, body).is_none());
    for ((index, _), deviation) in faces.zip(of_faces) {
        deviations[index] = deviation;
    }
    Ok(Deviations { curves, bodies: deviations, ..Deviations::default() })
}

/// A span as a curve over [0, 1].
fn spline_of(span: RationalBezier) -> cyclide::Result<NurbsCurve> {
    NurbsCurve::from_beziers(&[span], &[1.0])
}
