//! The comparison as a table.

use cyclide::ShortNumber;

use super::{ComparedKind, Comparison};
use crate::text::csv::quoted;
use crate::text::number::push_plain;

/// The columns, as they are called in JSON too.
const COLUMNS: &str = "kind,length,longer,bending_energy,variation,total_variation,sign_changes,extrema,jumps,corners,\
max_curvature,overshoot,off_points,pieces,exact_in_step,arcs,exact_in_dxf,refused";

/// A line for each kind; fields are empty where there is no value.
pub(super) fn csv(comparison: &Comparison) -> String {
    let mut out = format!("{COLUMNS}\n");
    for kind in &comparison.kinds {
        out += &kind.kind;
        match &kind.measures {
            None => out += &format!("{},{}", ",".repeat(16), quoted(kind.refused.as_deref().unwrap_or_default())),
            Some(m) => {
                let count = |n: usize| Some(n as f64);
                let flag = |is: bool| Some(f64::from(u8::from(is)));
                let values = [
                    Some(m.length),
                    Some(m.longer),
                    Some(m.bending_energy),
                    m.variation,
                    Some(m.total_variation),
                    m.sign_changes.and_then(count),
                    count(m.extrema),
                    count(m.jumps),
                    count(m.corners),
                    Some(m.max_curvature),
                    Some(m.overshoot),
                    Some(m.off_points),
                    count(m.pieces),
                    flag(m.exact_in_step),
                    m.arcs.and_then(count),
                    flag(m.exact_in_dxf),
                ];
                for value in values {
                    out.push(',');
                    if let Some(value) = value.filter(|v| v.is_finite()) {
                        push_plain(&mut out, value);
                    }
                }
                out.push(',');
            }
        }
        out.push('\n');
    }
    out
}

/// The most telling columns, aligned; of what could not be made the reason.
pub(super) fn text(comparison: &Comparison) -> String {
    let units = comparison.units;
    let heads =
        ["", "length", "bending", "variation", "sign changes", "largest curvature", "jumps", "overshoot", "pieces"];
    let measured = comparison.kinds.iter().map(|kind| {
        let m = kind.measures.as_ref()?;
        let variation = m.variation.map_or("none".to_owned(), short);
        Some([
            kind.kind.clone(),
            format!("{} {units}", short(m.length)),
            format!("{} 1/{units}", short(m.bending_energy)),
            variation,
            // In space a curve has no sides.
            m.sign_changes.map_or("–".to_owned(), |changes| changes.to_string()),
            format!("{} 1/{units}", short(m.max_curvature)),
            m.jumps.to_string(),
            format!("{} {units}", short(m.overshoot)),
            m.pieces.to_string(),
        ])
    });
    let rows: Vec<Option<[String; 9]>> = measured.collect();
    let heads = heads.map(str::to_owned);
    let shown = || rows.iter().flatten().chain([&heads]);
    let width = |column: usize| {
        let refused = comparison.kinds.iter().map(|kind| &kind.kind).filter(|_| column == 0);
        let cells = shown().map(|row| &row[column]).chain(refused);
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: [usize; 9] = std::array::from_fn(width);
    let line = |row: &[String; 9]| {
        let cells = row.iter().zip(&widths).enumerate();
        let cells =
            cells.map(|(i, (cell, &width))| if i == 0 { format!("{cell:width$}") } else { format!("{cell:>width$}") });
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    let of_kind = |(kind, row): (&ComparedKind, &Option<[String; 9]>)| match row {
        Some(row) => line(row),
        None => {
            let why = kind.refused.as_deref().unwrap_or_default().replace(['\n', '\r'], " ");
            format!("{:width$}  refused: {why}\n", kind.kind, width = widths[0])
        }
    };
    line(&heads) + &comparison.kinds.iter().zip(&rows).map(of_kind).collect::<String>()
}

fn short(value: f64) -> String {
    ShortNumber(value).to_string()
}
