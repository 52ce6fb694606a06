//! The comparison as one page: the table first, then a drawing and a plot for each kind. It needs no other file and no network.

use std::fmt::Write as _;

use cyclide::ShortNumber;

use super::drawing::Scale;
use super::measures::CurveMeasures;
use super::plot::plot;
use super::{ComparedKind, Comparison};

pub(super) fn html(comparison: &Comparison) -> String {
    let scale = Scale::new(comparison);
    let source = escaped(&comparison.source);
    let units = comparison.units;
    let shape = if comparison.closed { "closed" } else { "open" };
    let cards: String = comparison.kinds.iter().map(|kind| card(comparison, kind, &scale)).collect();
    format!(
        r#"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{source}: curves compared</title>
<style>{STYLE}</style>
</head>
<body>
<header>
<h1>Curves through {source}</h1>
<p>{points} points, {shape}; the length of their polygon is {polygon} {units}. Fits and arcs are within {tolerance} {units}.
All drawings have the same scale, as do all combs and all plots. The best value of each row is highlighted.</p>
</header>
<main>
<div class="wide"><table>
{table}</table></div>
{cards}<section class="words">
<h2>Terms</h2>
<dl>
{words}</dl>
</section>
</main>
</body>
</html>
"#,
        points = comparison.points,
        polygon = ShortNumber(comparison.polygon_length),
        tolerance = ShortNumber(comparison.tolerance),
        table = table(comparison),
        words = WORDS.map(|(word, text)| format!("<dt>{word}</dt><dd>{text}</dd>\n")).concat(),
    )
}

const STYLE: &str = "
:root { color-scheme: light dark; --ink: #1d242b; --soft: #5d6974; --line: #dfe4e8; --paper: #f5f6f7; --card: #ffffff; --accent: #0b66a8; --comb: #c2571a; --best: #e3f0fa; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6eaed; --soft: #9ba7b1; --line: #333c44; --paper: #14181c; --card: #1c2227; --accent: #6cb8f0; --comb: #f0995f; --best: #1d3547; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
header, main { max-width: 88rem; margin: 0 auto; padding: 0 1.5rem; }
header { padding-top: 2.5rem; padding-bottom: 1.25rem; }
h1 { margin: 0; font-size: 1.9rem; font-weight: 650; letter-spacing: -0.02em; overflow-wrap: anywhere; }
h2 { margin: 0; font-size: 1.15rem; font-weight: 620; }
header p { max-width: 52rem; margin: 0.5rem 0 0; color: var(--soft); }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(34rem, 100%), 1fr)); grid-auto-flow: dense; gap: 1.5rem; padding-bottom: 3rem; }
.wide, .words { grid-column: 1 / -1; }
article:not(:has(svg)) { grid-column: 1 / -1; }
.wide { overflow-x: auto; background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
table { border-collapse: collapse; width: 100%; font-size: 0.9rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.4rem 0.9rem; text-align: right; white-space: nowrap; border-top: 1px solid var(--line); }
thead th { border-top: 0; padding-top: 0.7rem; padding-bottom: 0.7rem; font-weight: 620; }
th:first-child { text-align: left; font-weight: 500; color: var(--soft); position: sticky; left: 0; background: var(--card); }
thead a { color: var(--accent); text-decoration: none; }
td.best { background: var(--best); font-weight: 620; }
td.none { color: var(--soft); }
article { display: flex; flex-direction: column; background: var(--card); border: 1px solid var(--line); border-radius: 10px; overflow: hidden; scroll-margin-top: 1rem; }
article h2, article p, article ul { padding: 0 1.1rem; }
article h2 { padding-top: 0.9rem; }
article p { margin: 0.15rem 0 0.4rem; color: var(--soft); font-size: 0.9rem; }
article ul { margin: 0 0 0.8rem; padding-left: 2.2rem; font-size: 0.85rem; color: var(--soft); }
svg { display: block; width: 100%; height: auto; }
svg path { fill: none; stroke-linejoin: round; vector-effect: non-scaling-stroke; }
svg text { fill: var(--soft); font: 11px system-ui, sans-serif; }
.curve { stroke: var(--accent); stroke-width: 1.8; }
.polygon { stroke: var(--soft); stroke-width: 0.7; stroke-dasharray: 2 3; opacity: 0.7; }
.drawing circle { fill: var(--ink); }
.teeth { stroke: var(--comb); stroke-width: 0.5; opacity: 0.35; }
.comb { stroke: var(--comb); stroke-width: 1; }
.plot { border-top: 1px solid var(--line); }
.course { stroke: var(--comb); stroke-width: 1.2; }
.axis { stroke: var(--soft); stroke-width: 0.8; }
.grid { stroke: var(--line); stroke-width: 0.8; }
.words dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.2rem 1.2rem; margin: 0.6rem 0 0; font-size: 0.9rem; }
.words dt { font-weight: 500; }
.words dd { margin: 0; color: var(--soft); max-width: 60rem; }
@media print { body { background: none; } article, .wide { break-inside: avoid; } }
";

const WORDS: [(&str, &str); 11] = [
    (
        "longer",
        "than the polygon of the points. A smooth curve is slightly longer; a much longer one has a detour or a loop, and a shorter one is a fit that cuts corners.",
    ),
    (
        "bending energy",
        "the integral of the squared curvature over the length, as stored in a thin elastic rod. Corners are not counted.",
    ),
    (
        "variation",
        "how much the curvature changes: the integral of its squared derivative over the length, times the cube of the length, which makes it independent of size. None where the curvature jumps.",
    ),
    (
        "total variation",
        "the sum of all rises and falls of the curvature, jumps included. It also compares curves whose curvature jumps. Less is smoother.",
    ),
    ("sign changes", "changes between left and right turns; no curve has fewer than its points require."),
    ("largest curvature", "one over the least radius, which limits machines, vehicles and the radius of pipes."),
    ("jumps", "joints where the curvature jumps: visible in reflections, felt as jerk."),
    ("corners", "joints where the direction changes, and cusps."),
    ("overshoot", "the largest distance of the curve from the polygon of the points, exact to rounding."),
    ("deviation", "the largest distance of a point from the curve: rounding for curves that pass through the points."),
    (
        "comb",
        "the orange teeth: the curvature, drawn normal to the curve on its outer side. A smooth comb means a smooth curve. Very long teeth are cut off.",
    ),
];

/// What a row shows, and whether less is better.
type Row = (&'static str, bool, fn(&CurveMeasures, &str) -> Option<(f64, String)>);

const ROWS: [Row; 13] = [
    ("length", false, |m, units| Some((m.length, format!("{} {units}", ShortNumber(m.length))))),
    // Neither more nor less is better: a fit that cuts corners is shorter than the polygon.
    ("longer", false, |m, _| Some((m.longer, format!("{} %", ShortNumber(100.0 * m.longer))))),
    ("bending energy", true, |m, units| with_unit(m.bending_energy, &format!("1/{units}"))),
    ("variation", true, |m, _| with_unit(m.variation?, "")),
    ("total variation", true, |m, units| with_unit(m.total_variation, &format!("1/{units}"))),
    ("sign changes", true, |m, _| m.sign_changes.map(|n| (n as f64, n.to_string()))),
    ("largest curvature", true, |m, units| with_unit(m.max_curvature, &format!("1/{units}"))),
    ("least radius", false, |m, units| with_unit(1.0 / m.max_curvature, units)),
    ("jumps", true, |m, _| Some((m.jumps as f64, m.jumps.to_string()))),
    ("corners", true, |m, _| Some((m.corners as f64, m.corners.to_string()))),
    ("overshoot", true, |m, units| with_unit(m.overshoot, units)),
    ("deviation", false, |m, units| with_unit(m.off_points, units)),
    ("pieces", false, |m, _| Some((m.pieces as f64, m.pieces.to_string()))),
];

fn with_unit(value: f64, unit: &str) -> Option<(f64, String)> {
    value.is_finite().then(|| (value, format!("{} {unit}", ShortNumber(value)).trim_end().to_owned()))
}

/// Values within this part of the best one are as good.
const AS_GOOD: f64 = 1e-6;

fn table(comparison: &Comparison) -> String {
    let heads: String =
        comparison.kinds.iter().map(|kind| format!("<th><a href=\"#{0}\">{0}</a></th>", escaped(&kind.kind))).collect();
    let mut out = format!("<thead><tr><th></th>{heads}</tr></thead>\n<tbody>\n");
    for (label, less_is_better, value) in ROWS {
        let values: Vec<Option<(f64, String)>> = comparison
            .kinds
            .iter()
            .map(|kind| kind.measures.as_ref().and_then(|m| value(m, comparison.units)))
            .collect();
        let known = || values.iter().flatten().map(|(v, _)| *v);
        let (least, most) = (known().fold(f64::INFINITY, f64::min), known().fold(f64::NEG_INFINITY, f64::max));
        // Where all are alike none is better.
        let tells = less_is_better && most > least + AS_GOOD * least.abs();
        let _never_fails = write!(out, "<tr><th>{label}</th>");
        for value in &values {
            out += &match value {
                Some((v, text)) if tells && *v <= least + AS_GOOD * least.abs() => {
                    format!("<td class=\"best\">{}</td>", escaped(text))
                }
                Some((_, text)) => format!("<td>{}</td>", escaped(text)),
                None => "<td class=\"none\">–</td>".to_owned(),
            };
        }
        out.push_str("</tr>\n");
    }
    for (label, word) in [("STEP", step_word as fn(&CurveMeasures, &Comparison) -> String), ("DXF, SVG", arcs_word)] {
        let cells = comparison.kinds.iter().map(|kind| match &kind.measures {
            Some(measures) => format!("<td>{}</td>", escaped(&word(measures, comparison))),
            None => "<td class=\"none\">–</td>".to_owned(),
        });
        let _never_fails = writeln!(out, "<tr><th>{label}</th>{}</tr>", cells.collect::<String>());
    }
    out + "</tbody>\n"
}

fn step_word(measures: &CurveMeasures, _: &Comparison) -> String {
    if measures.exact_in_step { "exact" } else { "within the tolerance" }.to_owned()
}

fn arcs_word(measures: &CurveMeasures, _: &Comparison) -> String {
    match measures.arcs {
        Some(n) if measures.exact_in_dxf => format!("exact, {n} arcs"),
        Some(n) => format!("{n} arcs"),
        None => "not within the tolerance".to_owned(),
    }
}

fn card(comparison: &Comparison, kind: &ComparedKind, scale: &Scale) -> String {
    let name = escaped(&kind.kind);
    let mut out = format!("<article id=\"{name}\">\n<h2>{name}</h2>\n");
    match &kind.measures {
        None => {
            let why = escaped(kind.refused.as_deref().unwrap_or_default());
            let _never_fails = write!(out, "<p>Not available: {why}</p>\n</article>\n");
            return out;
        }
        Some(m) => {
            let place = |p: [f64; 3]| p.map(|v| ShortNumber(v).to_string()).join(", ");
            let mut facts = Vec::new();
            if m.max_curvature > 0.0 && m.max_curvature.is_finite() {
                let radius = ShortNumber(1.0 / m.max_curvature);
                facts.push(format!("least radius {radius} {} at {}", comparison.units, place(m.max_curvature_point)));
            }
            if m.overshoot > 0.0 {
                facts.push(format!("farthest from the polygon at {}", place(m.overshoot_point)));
            }
            facts.push(scale.view().to_owned());
            let _never_fails = writeln!(out, "<p>{}</p>", escaped(&facts.join("; ")));
        }
    }
    out += &scale.draw(comparison, &kind.curves, &name);
    out += &plot(&kind.curves, scale.curvature, comparison.units, &name);
    if !kind.warnings.is_empty() {
        let shown = kind.warnings.iter().take(MOST_WARNINGS).map(|warning| format!("<li>{}</li>", escaped(warning)));
        let _never_fails = write!(out, "\n<ul>{}", shown.collect::<String>());
        if kind.warnings.len() > MOST_WARNINGS {
            let _never_fails = write!(out, "<li>and {} more</li>", kind.warnings.len() - MOST_WARNINGS);
        }
        out.push_str("</ul>");
    }
    out + "\n</article>\n"
}

/// Warnings shown of a kind.
const MOST_WARNINGS: usize = 5;

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
