//! VTK XML unstructured grids: curves, faces and blocks as exact rational Bézier cells, for ParaView and analysis programs.
//!
//! Curves are cells of type 75, faces of type 77, blocks of type 79. The weights are point data that the attribute `RationalWeights` names, without
//! which readers leave them aside; `HigherOrderDegrees` says the degrees of each cell. Cells share no nodes, since weights are theirs alone. What
//! each cell belongs to is cell data, as is the quality of blocks; the names of the objects and the unit are field data.

mod arrays;
mod linear;
mod linear_distance;
mod multi_block;
mod order;
mod quality;
mod reader;

use crate::check::deviation::{Deviations, View};
use crate::check::labels::{FileLabels, FileName};
use crate::check::made::Made;
use crate::check::rational_cells::bodies_deviation;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, PieceNotes, Promise, Written, WrittenCurve};
use crate::export::job::Job;
use crate::export::lowered::Forms;
use crate::export::options::VtuCells;
use crate::export::parts::Contour;
use crate::export::rational_cells::{Halving, Node, RationalCell, Tags, push_bodies};
use crate::export::ready::ReadyModel;
use crate::formats::entry::{Entry, Reading};
use arrays::{Arrays, Number};
use cyclide::{
    curve::{DEFAULT_PIECE_ANGLE, ParamCurve as _},
    model::{ChainPiece, CurveChain, Lowered},
    rational::{NurbsCurve, RationalBezier},
};
pub use multi_block::vtk_multi_block;
use order::nodes;
use quality::{NAMES, Quality, qualities};
use reader::{Cells, TAGS, read};

/// VTK's numbers for Bézier curves, quadrilaterals and hexahedra.
const KINDS: [u8; 3] = [75, 77, 79];

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
    reading: Some(Reading { read: |bytes| Ok(read(bytes)?.0), compare, rounds_by_model: false }),
};

/// Writes the model.
fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    if job.options.vtu_cells == VtuCells::Linear {
        return linear::write(job);
    }
    let (mut written, mut cells) = (Written::default(), Vec::new());
    for contour in job.contours() {
        let lowered = job.chain(&contour)?;
        written.curves.push(contour.lowered(push_contour(&mut cells, &contour, lowered))?);
    }
    push_bodies(job, None, Halving::WhereNeeded, &mut cells, &mut written)?;
    // Cells share no nodes: each has a scale of its own.
    let cells: Vec<RationalCell> = cells.into_iter().map(RationalCell::with_scaled_weights).collect();
    let mut arrays = Arrays::new(job.options.vtu_encoding);
    let of_blocks = qualities(job.model, job.bodies, &written.volumes);
    let head = text(&mut arrays, &cells, &of_blocks, job);
    // They depend on the model alone: measured once, for the file and for its check.
    written.qualities = of_blocks;
    Ok(written.exported(arrays.finish(head), Vec::new()))
}

fn push_contour(
    cells: &mut Vec<RationalCell>,
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
        notes.knots.extend(std::iter::repeat_n([0.0, 1.0], spans.len()).flatten());
        cells.extend(spans.iter().map(|span| RationalCell::of_curve(span, tags)));
    }
    Ok(notes.of(promise, correspondence))
}

/// The file up to its arrays.
fn head(job: &Job<'_>, points: usize, cells: usize) -> String {
    let mut out = "<?xml version=\"1.0\"?>\n".to_owned();
    // Before version 2.1 readers permute the nodes of hexahedra.
    out.push_str(
        "<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n",
    );
    out.push_str("<UnstructuredGrid>\n<FieldData>\n");
    let names: Vec<&str> = job.model.items.iter().map(|item| item.name.as_str()).collect();
    arrays::push_strings(&mut out, reader::UNITS, &[job.units().symbol()]);
    arrays::push_strings(&mut out, reader::OBJECTS, &names);
    out.push_str(&format!("</FieldData>\n<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">\n"));
    out
}

/// The file but for what is appended.
fn text(arrays: &mut Arrays, cells: &[RationalCell], of_blocks: &[Quality], job: &Job<'_>) -> String {
    let points: usize = cells.iter().map(|cell| cell.nodes.len()).sum();
    let mut out = head(job, points, cells.len());
    out.reserve(arrays.text_of(points));
    let ordered = |cell: &RationalCell| nodes(cell.degrees).into_iter().map(|at| cell.node(at)).collect::<Vec<_>>();
    let all: Vec<Node> = cells.iter().flat_map(ordered).collect();
    out.push_str("<PointData RationalWeights=\"RationalWeights\">\n");
    arrays.push(&mut out, Number::Float64, reader::WEIGHTS, 1, all.iter().map(|(_, w)| *w));
    out.push_str("</PointData>\n<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n");
    let degrees = cells.iter().flat_map(|cell| cell.degrees).map(|d| d as f64);
    arrays.push(&mut out, Number::Float64, reader::DEGREES, 3, degrees);
    for (name, of) in TAGS {
        arrays.push(&mut out, Number::Int32, name, 1, cells.iter().map(|cell| of(&cell.tags) as f64));
    }
    if !of_blocks.is_empty() {
        for (k, name) in NAMES.into_iter().enumerate() {
            let mut own = of_blocks.iter();
            let value = |cell: &RationalCell| {
                if cell.dimension() == 3 { own.next().map_or(0.0, |quality| quality[k]) } else { 0.0 }
            };
            arrays.push(&mut out, Number::Float64, name, 1, cells.iter().map(value));
        }
    }
    out.push_str("</CellData>\n<Points>\n");
    arrays.push(&mut out, Number::Float64, reader::POINTS, 3, all.iter().flat_map(|(p, _)| *p));
    out.push_str("</Points>\n<Cells>\n");
    arrays.push(&mut out, Number::Int64, reader::CONNECTIVITY, 1, (0..points).map(|k| k as f64));
    let ends = cells.iter().scan(0, |sum, cell| {
        *sum += cell.nodes.len();
        Some(*sum as f64)
    });
    arrays.push(&mut out, Number::Int64, reader::OFFSETS, 1, ends);
    let kind = |cell: &RationalCell| f64::from(KINDS[cell.dimension() - 1]);
    arrays.push(&mut out, Number::UInt8, reader::TYPES, 1, cells.iter().map(kind));
    out.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n");
    out
}

/// Reads a file of a model and holds it against this.
fn compare(made: &Made<'_>) -> Result<Deviations, ReadError> {
    let (content, cells) = read(&made.file.bytes)?;
    let ReadyModel { model, .. } = made.ready;
    let names = model.items.iter().map(|item| FileName::new(reader::OBJECTS, item.name.as_str(), 1)).collect();
    content.labels.check(&FileLabels::new(model.units, names))?;
    let written = &made.file.written;
    match cells {
        Cells::Plain(plain) if written.plain_cells => {
            Ok(Deviations { bodies: linear::deviations(made, &content, &plain)?, ..Deviations::default() })
        }
        Cells::Bezier(of_blocks) if !written.plain_cells => {
            if of_blocks != written.qualities {
                return Err(ReadError::syntax("CellData", "the quality of a cell does not match its block"));
            }
            let curves = made.curves(&content, View::Space)?;
            let bodies = bodies_deviation(made, &content, None)?;
            Ok(Deviations { curves, bodies, ..Deviations::default() })
        }
        _ => Err(ReadError::syntax(reader::TYPES, "an unexpected kind of cells")),
    }
}

/// A span as a curve over [0, 1].
fn spline_of(span: RationalBezier) -> cyclide::Result<NurbsCurve> {
    NurbsCurve::from_beziers(&[span], &[1.0])
}
