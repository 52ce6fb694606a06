//! The page of the gallery: one static HTML file beside the models.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use cyclide::ShortNumber;
use cyclide_io::{
    Format, Report,
    report::{GeometryReport, SurfaceReport},
};

use super::entries::Entry;

/// What turns the models in the page.
pub const VIEWER: &str = include_str!("viewer.js");

/// From where a picture without a camera of its own is looked at, mostly: azimuth and elevation in degrees.
const EYE: &str = "32,28";

/// An entry with what was made of it.
pub(super) struct Shown {
    pub(super) entry: &'static Entry,
    pub(super) report: Report,
    /// Names and bytes, those it is made from included.
    pub(super) files: Vec<(String, Vec<u8>)>,
}

/// The script beside the page that hands a GLB's bytes over: of a page that is opened as a file, browsers read scripts only.
pub fn handed_over(name: &str, glb: &[u8]) -> String {
    format!("cyclideModel(\"{name}\", \"{}\");\n", STANDARD.encode(glb))
}

/// The page with a card per model.
pub fn html(shown: &[Shown]) -> String {
    let cards: String = shown.iter().map(card).collect();
    let version = env!("CARGO_PKG_VERSION");
    format!(
        r#"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>cyclide gallery</title>
<style>{STYLE}</style>
</head>
<body>
<header>
<h1>cyclide</h1>
<p>Curves and surfaces made of circles. Every picture is a model that you can rotate here or open in CAD, and a
document that you can edit and build again. Measures are those of the models; deviations are those of the files, read back.</p>
</header>
<main>
{cards}</main>
<footer>Made by <code>cyclide gallery</code> {version}.</footer>
<script src="viewer.js"></script>
</body>
</html>
"#
    )
}

const STYLE: &str = "
:root { color-scheme: light dark; --ink: #1d242b; --soft: #5d6974; --line: #dfe4e8; --paper: #f5f6f7; --card: #ffffff; --accent: #0b66a8; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6eaed; --soft: #9ba7b1; --line: #333c44; --paper: #14181c; --card: #1c2227; --accent: #6cb8f0; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
header, main, footer { max-width: 84rem; margin: 0 auto; padding: 0 1.5rem; }
header { padding-top: 3rem; padding-bottom: 1.5rem; }
h1 { margin: 0; font-size: 2.25rem; font-weight: 650; letter-spacing: -0.02em; }
header p { max-width: 46rem; margin: 0.5rem 0 0; color: var(--soft); }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(32rem, 100%), 1fr)); gap: 1.5rem; }
article { display: flex; flex-direction: column; background: var(--card); border: 1px solid var(--line); border-radius: 10px; overflow: hidden; }
article:target { border-color: var(--accent); }
.stage { position: relative; background: #fbfbf9; border-bottom: 1px solid var(--line); }
img { display: block; width: 100%; aspect-ratio: 4 / 3; object-fit: contain; }
canvas { position: absolute; inset: 0; width: 100%; height: 100%; cursor: grab; touch-action: none; }
canvas:active { cursor: grabbing; }
canvas:focus-visible { outline: 2px solid #0b66a8; outline-offset: -2px; }
[data-state=loading] img { opacity: 0.5; }
[data-state=turning] img { visibility: hidden; }
.buttons { position: absolute; z-index: 1; right: 0.75rem; top: 0.75rem; display: flex; gap: 0.4rem; }
.stage button { display: none; padding: 0.2rem 0.7rem; border: 1px solid #cdd4da; border-radius: 6px; background: #ffffffd9; color: #0b66a8; font: inherit; font-size: 0.875rem; cursor: pointer; }
.stage button:hover, .stage button:focus-visible { border-color: #0b66a8; }
[data-state=picture] .turn, [data-state=turning] .back, [data-state=turning] .whole, [data-state=turning] .play:not([hidden]) { display: block; }
.note { position: absolute; left: 0.75rem; bottom: 0.6rem; margin: 0; color: #8a2b17; font-size: 0.875rem; }
.text { display: flex; flex-direction: column; flex: 1; gap: 0.75rem; padding: 1.1rem 1.25rem 1.25rem; }
h2 { margin: 0; font-size: 1.15rem; font-weight: 620; }
.text p { margin: 0; color: var(--soft); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.1rem 1rem; margin: 0; font-size: 0.875rem; font-variant-numeric: tabular-nums; }
dt { color: var(--soft); }
dd { margin: 0; }
nav { display: flex; flex-wrap: wrap; align-items: flex-start; gap: 0.4rem; margin-top: auto; }
nav a { padding: 0.15rem 0.6rem; border: 1px solid var(--line); border-radius: 6px; color: var(--accent); font-size: 0.875rem; text-decoration: none; }
nav a:hover, nav a:focus-visible { border-color: var(--accent); }
footer { padding-top: 2rem; padding-bottom: 3rem; color: var(--soft); font-size: 0.875rem; }
";

fn card(shown: &Shown) -> String {
    let Shown { entry, report, .. } = shown;
    let name = entry.name;
    let mut links = String::new();
    for file in &report.files {
        let _never_fails = write!(links, "<a href=\"{0}\">{1}</a>", escaped(&file.path), file.format.to_uppercase());
    }
    let _never_fails = write!(links, "<a href=\"{name}.json\">document</a>");
    for (input, _) in entry.inputs {
        let _never_fails = write!(links, "<a href=\"{0}\">{0}</a>", escaped(input));
    }
    let figures: String =
        figures(report).iter().map(|(label, value)| format!("<dt>{label}</dt><dd>{}</dd>\n", escaped(value))).collect();
    let title = escaped(entry.title);
    let turns = if entry.formats.contains(&Format::Glb) {
        let eye = if entry.camera.is_empty() { EYE } else { entry.camera };
        format!(" data-model=\"{name}\" data-eye=\"{eye}\" data-title=\"{title}\"")
    } else {
        String::new()
    };
    let buttons = if turns.is_empty() { "" } else { BUTTONS };
    format!(
        r#"<article id="{name}">
<div class="stage"{turns}>
<a href="{name}.png"><img src="{name}.png" alt="{title}" loading="lazy"></a>{buttons}
</div>
<div class="text">
<h2>{title}</h2>
<p>{text}</p>
<dl>
{figures}</dl>
<nav>{links}</nav>
</div>
</article>
"#,
        text = escaped(entry.text),
    )
}

/// Shown once the viewer runs.
const BUTTONS: &str = r#"
<div class="buttons">
<button type="button" class="play" hidden>Play</button><button type="button" class="whole">Whole</button>
<button type="button" class="back">Picture</button><button type="button" class="turn">Turn</button>
</div>
<p class="note" role="status"></p>"#;

/// What is said about a model: what it is made of, its measures, and how well its files keep it.
fn figures(report: &Report) -> Vec<(&'static str, String)> {
    let units = report.units;
    let mut figures = Vec::new();
    let shown = || report.objects.values().filter(|object| !object.construction);
    let named = report.objects.iter().filter(|(_, object)| !object.construction);
    let named = named.filter_map(|(name, object)| match &object.geometry {
        GeometryReport::Surface(surface) => Some((name.as_str(), surface)),
        GeometryReport::Curves(_)
        | GeometryReport::Smooth(_)
        | GeometryReport::Volume(_)
        | GeometryReport::Motion(_) => None,
    });
    let (names, surfaces): (Vec<&str>, Vec<&SurfaceReport>) = named.unzip();
    let curves = || {
        shown().filter_map(|object| match &object.geometry {
            GeometryReport::Curves(curves) => Some(curves),
            GeometryReport::Surface(_)
            | GeometryReport::Smooth(_)
            | GeometryReport::Volume(_)
            | GeometryReport::Motion(_) => None,
        })
    };
    for smooth in shown().filter_map(|object| match &object.geometry {
        GeometryReport::Smooth(smooth) => Some(smooth),
        GeometryReport::Surface(_)
        | GeometryReport::Curves(_)
        | GeometryReport::Volume(_)
        | GeometryReport::Motion(_) => None,
    }) {
        figures.push(("triangles", smooth.triangles.to_string()));
        figures.push(("area", format!("{} {units}²", ShortNumber(smooth.area))));
        figures.extend(smooth.volume.map(|volume| ("volume", format!("{} {units}³", ShortNumber(volume)))));
        if let Some(c) = &smooth.comparison {
            let [own, flat, pn] = [c.jump, c.flat_jump, c.pn_jump].map(ShortNumber);
            figures.push(("normals", format!("jump by {own} rad at edges; flat {flat}, PN triangles {pn} rad")));
        }
    }
    for object in shown() {
        if let GeometryReport::Volume(volume) = &object.geometry {
            figures.push(("blocks", volume.blocks.to_string()));
            figures.push(("volume", format!("{} {units}³", ShortNumber(volume.volume))));
            figures.push(("lines", format!("cross at right angles to {}", ShortNumber(volume.orthogonality))));
        }
        if let GeometryReport::Motion(motion) = &object.geometry {
            let [duration, most] = [motion.duration, motion.speed.max].map(ShortNumber);
            figures.push(("motion", format!("{duration} s, up to {most} {units}/s")));
        }
    }
    if !surfaces.is_empty() {
        let patches: usize = surfaces.iter().map(|s| s.patches).sum();
        let solids = surfaces.iter().filter(|s| s.volume.is_some()).count();
        let kind = if solids == surfaces.len() { "solid" } else { "surface" };
        let within = format!(" in {} {kind}{}", surfaces.len(), plural(surfaces.len()));
        figures.push(("patches", format!("{patches}{}", if patches == 1 { "" } else { &within })));
        // The skins of a thick shell are its largest parts.
        let areas = names.iter().zip(&surfaces).flat_map(|(name, surface)| match surface.parts.as_slice() {
            [one, two, ..] => vec![(format!("{name}, one side"), one.area), ("other side".to_owned(), two.area)],
            [one] => vec![((*name).to_owned(), one.area)],
            [] => Vec::new(),
        });
        figures.push(("area", each(&areas.collect::<Vec<_>>(), &format!("{units}²"))));
        let volumes = names.iter().zip(&surfaces).filter_map(|(name, s)| s.volume.map(|v| ((*name).to_owned(), v)));
        if solids > 0 {
            figures.push(("volume", each(&volumes.collect::<Vec<_>>(), &format!("{units}³"))));
        }
        let smooth: usize = surfaces.iter().map(|s| s.joints.count - s.joints.creases).sum();
        if smooth > 0 {
            let angle = surfaces.iter().map(|s| s.joints.angle).fold(0.0, f64::max);
            let normals =
                if angle > 0.0 { format!("within {} rad", ShortNumber(angle)) } else { "bitwise equal".to_owned() };
            figures.push(("joints", format!("{smooth}, normals {normals}")));
        }
    }
    let (count, pieces) = curves().fold((0, 0), |(n, p), c| (n + c.contours, p + c.pieces));
    if count > 0 {
        figures.push(("curves", format!("{count}, in {pieces} pieces")));
        let lengths = report.objects.iter().filter(|(_, object)| !object.construction);
        let lengths = lengths.filter_map(|(name, object)| match &object.geometry {
            GeometryReport::Curves(curves) => Some((name.clone(), curves.length)),
            GeometryReport::Surface(_)
            | GeometryReport::Smooth(_)
            | GeometryReport::Volume(_)
            | GeometryReport::Motion(_) => None,
        });
        figures.push(("length", each(&lengths.collect::<Vec<_>>(), units)));
        // How evenly the curves bend says something of each alone, and of those without jumps of the curvature.
        if let [only] = curves().collect::<Vec<_>>().as_slice() {
            let fairness = &only.fairness;
            if let (Some(changes), Some(_)) = (fairness.sign_changes, fairness.variation) {
                let change = format!("{changes} sign change{}", plural(changes));
                figures.push(("curvature", format!("{change}, {} extrema", fairness.extrema)));
            }
        }
    }
    let step = Format::Step.name();
    if let Some(file) = report.files.iter().find(|file| file.format == step) {
        let deviation = file.deviation.unwrap_or_default();
        let kept = if file.exact { "exact" } else { "approximated" };
        figures.push(("STEP", format!("{kept}, read back within {} {units}", ShortNumber(deviation))));
    }
    figures
}

/// Measures that are listed with their names; of more the range is given.
const LISTED: usize = 3;

/// The measures of several things, each for itself: of two skins nobody wants the sum.
fn each(measures: &[(String, f64)], units: &str) -> String {
    match measures {
        [(_, one)] => format!("{} {units}", ShortNumber(*one)),
        few if few.len() <= LISTED => {
            let few = few.iter().map(|(name, value)| format!("{name} {} {units}", ShortNumber(*value)));
            few.collect::<Vec<_>>().join(", ")
        }
        many => {
            let ends = |a: [f64; 2], (_, v): &(String, f64)| [a[0].min(*v), a[1].max(*v)];
            let [least, most] = many.iter().fold([f64::INFINITY, f64::NEG_INFINITY], ends);
            format!("{} of {} to {} {units}", many.len(), ShortNumber(least), ShortNumber(most))
        }
    }
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// Text for HTML, also inside of quotes.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
