//! What the JSON parser says, in the words of people who write documents, and what they may have meant.

use super::schema::types_with_field;
use crate::text::place::quoted;
use crate::text::suggest::did_you_mean;

/// What the parser said without the names of its own types.
pub(super) fn in_plain_words(message: &str) -> String {
    let lengths = message.strip_prefix("invalid length ").and_then(|rest| rest.split_once(", expected "));
    if let Some((given, needed)) = lengths {
        let number = |text: &str| text.rsplit(' ').find_map(|word| word.parse::<usize>().ok());
        if let (Ok(given), Some(needed)) = (given.parse(), number(needed)) {
            return wrong_count(given, needed);
        }
    }
    if message == "expected ident" {
        return "expected `true`, `false` or `null`; a text stands in quotes".to_owned();
    }
    let plain = cut_quote(message);
    let plain = plain.replace("expected f64", "expected a number").replace("expected u32", "expected a whole number");
    plain + &suggestion(message)
}

/// The message with what it quotes of the input cut: that is the first thing in quotes.
fn cut_quote(message: &str) -> String {
    let Some(open) = message.find(['`', '"']) else { return message.to_owned() };
    let (before, rest) = message.split_at(open + 1);
    let quote = &message[open..=open];
    let close = rest.find(&format!("{quote}, expected ")).or_else(|| rest.rfind(quote)).unwrap_or(rest.len());
    let (inner, after) = rest.split_at(close);
    format!("{before}{}{after}", quoted(inner))
}

/// What may be meant by a field or word that the parser does not know: it names all it knows, in backquotes.
fn suggestion(message: &str) -> String {
    if !["unknown field `", "unknown variant `"].iter().any(|start| message.starts_with(start)) {
        return String::new();
    }
    let mut words = message.split('`').skip(1).step_by(2);
    let Some(word) = words.next() else { return String::new() };
    let known: Vec<&str> = words.collect();
    if let Some(symbol) = unit_by_name(word).filter(|symbol| known.contains(symbol)) {
        return format!("; did you mean `{symbol}`?");
    }
    let near = did_you_mean(word, known);
    if !near.is_empty() || !message.starts_with("unknown field") {
        return near;
    }
    match types_with_field(word).as_slice() {
        _ if word == "units" => "; `units` stands in the document, before its objects".to_owned(),
        types if (1..=3).contains(&types.len()) => format!("; `{word}` is a field of `{}`", types.join("` and `")),
        _ => String::new(),
    }
}

pub(super) fn wrong_count(given: usize, needed: usize) -> String {
    let verb = |count| if count == 1 { "value is" } else { "values are" };
    format!("{given} {} given, {needed} {} needed", verb(given), if needed == 1 { "is" } else { "are" })
}

/// What is wrong with the syntax at the character at byte `at` of the text.
pub(super) fn syntax_in_plain_words(text: &str, at: usize, message: &str) -> String {
    let (before, here) = text.split_at(at.min(text.len()));
    let found = here.chars().next().unwrap_or(' ');
    let comma_before = before.trim_end().ends_with(',');
    let plain = match message {
        _ if comma_before && matches!(found, '}' | ']') => return format!("trailing comma before `{found}`"),
        _ if found == '/' || (found == '#' && !message.starts_with("control")) => {
            "JSON has no comments: write them in a field `comment`"
        }
        "key must be a string" | "expected value" if found == '\'' => "names and texts stand in double quotes",
        "key must be a string" => "a name in double quotes is expected here",
        "expected value" => "a value is expected here",
        "EOF while parsing an object" => "the file ends inside an object: a `}` is missing",
        "EOF while parsing a list" => "the file ends inside a list: a `]` is missing",
        "EOF while parsing a string" => "the file ends inside a text: a closing quote is missing",
        "EOF while parsing a value" => "the file ends where a value is expected",
        "trailing characters" => "the document has ended before this",
        other => other,
    };
    plain.to_owned()
}

/// The symbol of a unit that a document knows, by its name in English.
fn unit_by_name(word: &str) -> Option<&'static str> {
    match word.to_lowercase().trim_end_matches('s') {
        "millimeter" | "millimetre" | "milli" => Some("mm"),
        "centimeter" | "centimetre" => Some("cm"),
        "meter" | "metre" => Some("m"),
        "inch" | "inche" | "\"" => Some("in"),
        "foot" | "feet" | "'" => Some("ft"),
        _ => None,
    }
}

/// The type that makes what other programs call by this word, as the end of a message.
pub(super) fn other_word_for(kind: &str) -> String {
    let answer = match kind.to_lowercase().as_str() {
        "line" | "segment" => "an `arc` with the bulge 0 is a straight segment",
        "catmull-rom" | "hermite-spline" | "möbius-spline" | "mobius-spline" => {
            "a local smooth curve through points is a `moebius-spline`"
        }
        "interpolation" | "lagrange" | "rational-interpolation" => {
            "a rational curve of lowest degree through points is a `qb-interpolation`"
        }
        "curve" | "spline" => "a smooth curve through points is a `fair-spline`",
        "bezier" | "bspline" | "b-spline" | "rational-bspline" | "nurbs-curve" => {
            "a spline by its control points is a `nurbs`"
        }
        "polygon" | "path" => {
            "segments through points are a `polyline`, arcs along points an `arc-fit` or an `arc-spline`"
        }
        "groove" | "bead" | "weld" | "weld-seam" => "a raised or sunk seam along a curve of a torus is a `torus-seam`",
        "villarceau" | "villarceau-circle" => "a circle of a torus is a `torus-circle`",
        "quartic" => "a closed quartic of one type is a `torus-quartic`",
        "spring" | "coil" | "thread" | "spiral" | "screw" => "a curve that rises as it turns is a `helix`",
        "extrude" | "extrusion" | "loft" | "linear-extrude" | "profile" | "follow-me" => {
            "a section along a path is a `sweep`, straight lines between two curves are `ruled`"
        }
        "knot" | "trefoil" | "winding" | "filament" => "a curve round a torus is a `torus-knot`",
        "unroll" | "flat" | "development" => "a curve of a torus laid flat is `unrolled`",
        "torus" | "ring" | "horn" | "spindle" => "a torus is a `cyclide` with the radii `a` and `mu`",
        "surface" | "mesh" | "grid" | "net" | "nurbs-surface" | "quads" => "a surface over a grid is a `cyclidic-net`",
        "remesh" | "quad-mesh" | "curvature-lines" | "curvature-grid" | "principal-mesh" => {
            "a grid along the lines of curvature of a mesh is a `principal-grid`"
        }
        "tube" | "hose" | "rod" | "wire" => "the tube about a curve is a `pipe`",
        "revolve" | "lathe" | "rotate-extrude" => "what a curve sweeps about an axis is a `revolution`",
        "thicken" | "thick" | "solid" | "shell" => "an `offset` with `thick` makes the solid",
        "polyhedron" | "hull" | "convex-hull" | "polytope" | "box" | "cube" => {
            "a convex polyhedron with rounded edges is a `smooth-polyhedron`"
        }
        "mirror" | "rotation" | "translation" | "scale" | "inversion" | "move" | "rotate" | "reverse" | "cut"
        | "trim" | "split" => "it is a step of a `transform`",
        "beams" | "edges" | "support" => "the edges of a surface are its `support-structure`",
        _ => return String::new(),
    };
    format!("; {answer}")
}
