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
        return "expected `true`, `false` or `null`; strings need quotes".to_owned();
    }
    expected_in_plain_words(&cut_quote(message)) + &suggestion(message)
}

/// The message with the numbers that Rust has for what is expected as people have them.
fn expected_in_plain_words(message: &str) -> String {
    let Some((before, kind)) = message.rsplit_once("expected ") else { return message.to_owned() };
    let kind = match kind {
        "f64" | "f32" => "a number",
        "usize" | "u64" | "u32" | "u16" | "u8" => "a whole number that is not negative",
        "isize" | "i64" | "i32" | "i16" | "i8" => "a whole number",
        other => other,
    };
    format!("{before}expected {kind}")
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
        _ if word == "units" => "; `units` belongs to the document, before its objects".to_owned(),
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
            "JSON has no comments: use the field `comment`"
        }
        "key must be a string" | "expected value" if found == '\'' => "names and strings need double quotes",
        "key must be a string" => "a name in double quotes is expected here",
        "expected value" => "a value is expected here",
        "EOF while parsing an object" => "the file ends inside an object: a `}` is missing",
        "EOF while parsing a list" => "the file ends inside a list: a `]` is missing",
        "EOF while parsing a string" => "the file ends inside a string: a closing quote is missing",
        "EOF while parsing a value" => "the file ends where a value is expected",
        "trailing characters" => "the document ended before this",
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
        "line" | "segment" => "use an `arc` with bulge 0 for a straight segment",
        "catmull-rom" | "hermite-spline" | "möbius-spline" | "mobius-spline" => {
            "use a `moebius-spline` for a local smooth curve through points"
        }
        "interpolation" | "lagrange" | "rational-interpolation" => {
            "use a `qb-interpolation` for a rational curve of lowest degree through points"
        }
        "curve" | "spline" => "use a `fair-spline` for a smooth curve through points",
        "bezier" | "bspline" | "b-spline" | "rational-bspline" | "nurbs-curve" => {
            "use a `nurbs` for a spline with control points"
        }
        "polygon" | "path" => "use a `polyline` for segments through points, an `arc-fit` or an `arc-spline` for arcs",
        "groove" | "bead" | "weld" | "weld-seam" => {
            "use a `torus-seam` for a raised or sunken seam along a curve on a torus"
        }
        "villarceau" | "villarceau-circle" => "use a `torus-circle` for a circle on a torus",
        "quartic" => "use a `torus-quartic` for a closed quartic of one type",
        "spring" | "coil" | "thread" | "spiral" | "screw" => "use a `helix` for a helical curve",
        "extrude" | "extrusion" | "loft" | "linear-extrude" | "profile" | "follow-me" => {
            "use a `sweep` for a section along a path, `ruled` for straight lines between two curves"
        }
        "knot" | "trefoil" | "winding" | "filament" => "use a `torus-knot` for a curve that winds around a torus",
        "unroll" | "flat" | "development" => "use `unrolled` to unroll a curve on a torus",
        "torus" | "ring" | "horn" | "spindle" => "use a `cyclide` with the radii `a` and `mu` for a torus",
        "surface" | "mesh" | "grid" | "net" | "nurbs-surface" | "quads" => {
            "use a `cyclidic-net` for a surface over a grid"
        }
        "remesh" | "quad-mesh" | "curvature-lines" | "curvature-grid" | "principal-mesh" => {
            "use a `principal-grid` for a grid along the lines of curvature of a mesh"
        }
        "tube" | "hose" | "rod" | "wire" => "use a `pipe` for a tube around a curve",
        "revolve" | "lathe" | "rotate-extrude" => "use a `revolution` for a curve revolved about an axis",
        "thicken" | "thick" | "solid" | "shell" => "use an `offset` with `thick` for a solid",
        "polyhedron" | "hull" | "convex-hull" | "polytope" | "box" | "cube" => {
            "use a `smooth-polyhedron` for a convex polyhedron with rounded edges"
        }
        "mirror" | "rotation" | "translation" | "scale" | "inversion" | "move" | "rotate" | "reverse" | "cut"
        | "trim" | "split" => "use it as a step of a `transform`",
        "beams" | "edges" | "support" => "use a `support-structure` for the edges of a surface",
        _ => return String::new(),
    };
    format!("; {answer}")
}

#[cfg(test)]
mod tests {
    use super::in_plain_words;

    #[test]
    fn numbers_are_called_what_people_call_them() {
        for (rust, plain) in [
            ("usize", "a whole number that is not negative"),
            ("i32", "a whole number"),
            ("f64", "a number"),
            ("a list of f64s", "a list of f64s"),
        ] {
            let said = in_plain_words(&format!("invalid type: floating point `3.5`, expected {rust}"));
            assert_eq!(said, format!("invalid type: floating point `3.5`, expected {plain}"));
        }
    }
}
