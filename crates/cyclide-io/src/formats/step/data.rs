//! The DATA section as it grows: numbered instances, equal ones shared.

use crate::text::number::push_step;
use cyclide::{Point3, Vec3};
use std::collections::HashMap;
use std::fmt::Write as _;

/// Numbered instances of the DATA section.
#[derive(Default)]
pub(super) struct Data {
    text: String,
    count: usize,
    /// Points already written, by their coordinates.
    points: HashMap<[u64; 3], usize>,
    /// Points in the parameters of surfaces already written.
    parameter_points: HashMap<[u64; 2], usize>,
    /// The context of curves in the parameters of surfaces.
    parameter_space: Option<usize>,
    /// Directions already written, by their components.
    directions: HashMap<[u64; 3], usize>,
    /// Placements already written, by the numbers of origin, axis and first axis.
    placements: HashMap<[usize; 3], usize>,
    /// Vectors of length 1 already written, by the number of their direction.
    unit_vectors: HashMap<usize, usize>,
}

impl Data {
    /// The instances as text, each on lines of its own.
    pub(super) fn into_text(self) -> String {
        self.text
    }

    #[cfg(test)]
    fn text(&self) -> &str {
        &self.text
    }

    /// Adds an instance whose body is written by a function, and returns its number.
    pub(super) fn write(&mut self, body: impl FnOnce(&mut String)) -> usize {
        self.count += 1;
        let start = self.text.len();
        // Writing to a string cannot fail.
        let _ = write!(self.text, "#{}=", self.count);
        body(&mut self.text);
        self.text.push_str(";\n");
        fold(&mut self.text, start);
        self.count
    }

    /// Adds an instance and returns its number.
    pub(super) fn add(&mut self, body: &str) -> usize {
        self.write(|out| out.push_str(body))
    }

    pub(super) fn point(&mut self, p: Point3) -> usize {
        let key = bits(p.to_array());
        if let Some(&number) = self.points.get(&key) {
            return number;
        }
        let number = self.write(|out| triple(out, "CARTESIAN_POINT('',", p.to_array()));
        self.points.insert(key, number);
        number
    }

    /// A point in the parameters of a surface.
    pub(super) fn parameter_point(&mut self, p: [f64; 2]) -> usize {
        let key = p.map(|v| (v + 0.0).to_bits());
        if let Some(&number) = self.parameter_points.get(&key) {
            return number;
        }
        let number = self.write(|out| {
            out.push_str("CARTESIAN_POINT('',");
            push_list(out, p, push_step);
            out.push(')');
        });
        self.parameter_points.insert(key, number);
        number
    }

    /// A curve in the parameters of a surface, as part of an edge's curve.
    pub(super) fn parameter_curve(&mut self, surface: usize, curve: usize) -> usize {
        let context = if let Some(context) = self.parameter_space {
            context
        } else {
            self.add(
                "(GEOMETRIC_REPRESENTATION_CONTEXT(2) PARAMETRIC_REPRESENTATION_CONTEXT() \
                 REPRESENTATION_CONTEXT('2D SPACE',''))",
            )
        };
        self.parameter_space = Some(context);
        let definition = self.add(&format!("DEFINITIONAL_REPRESENTATION('',(#{curve}),#{context})"));
        self.add(&format!("PCURVE('',#{surface},#{definition})"))
    }

    pub(super) fn direction(&mut self, v: Vec3) -> usize {
        let key = bits(v.to_array());
        if let Some(&number) = self.directions.get(&key) {
            return number;
        }
        let number = self.write(|out| triple(out, "DIRECTION('',", v.to_array()));
        self.directions.insert(key, number);
        number
    }

    /// Placement with third axis `z` and first axis `x`, both unit and perpendicular.
    pub(super) fn placement(&mut self, origin: Point3, z: Vec3, x: Vec3) -> usize {
        let key = [self.point(origin), self.direction(z), self.direction(x)];
        if let Some(&number) = self.placements.get(&key) {
            return number;
        }
        let [origin, z, x] = key;
        let number = self.add(&format!("AXIS2_PLACEMENT_3D('',#{origin},#{z},#{x})"));
        self.placements.insert(key, number);
        number
    }

    /// The vector of length 1 in a direction.
    pub(super) fn unit_vector(&mut self, v: Vec3) -> usize {
        let direction = self.direction(v);
        if let Some(&number) = self.unit_vectors.get(&direction) {
            return number;
        }
        let number = self.add(&format!("VECTOR('',#{direction},1.)"));
        self.unit_vectors.insert(direction, number);
        number
    }
}

/// The bits of three numbers, those of 0 for -0, which is written as 0.
fn bits(values: [f64; 3]) -> [u64; 3] {
    values.map(|v| (v + 0.0).to_bits())
}

/// `head` and the three numbers as a list, closed by a parenthesis.
fn triple(out: &mut String, head: &str, values: [f64; 3]) {
    out.push_str(head);
    push_list(out, values, push_step);
    out.push(')');
}

/// A list of items, each written by a function.
pub(super) fn push_list<T>(out: &mut String, items: impl IntoIterator<Item = T>, mut push: impl FnMut(&mut String, T)) {
    out.push('(');
    for (i, item) in items.into_iter().enumerate() {
        if i > 0 {
            out.push(',');
        }
        push(out, item);
    }
    out.push(')');
}

/// A reference to an instance.
pub(super) fn push_reference(out: &mut String, number: usize) {
    let _ = write!(out, "#{number}");
}

/// `.T.` or `.F.`.
pub(super) fn logical(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}

/// One REAL.
pub(super) fn real(v: f64) -> String {
    let mut out = String::new();
    push_step(&mut out, v);
    out
}

/// A list of references.
pub(super) fn references(numbers: &[usize]) -> String {
    let mut out = String::new();
    push_list(&mut out, numbers, |out, &n| push_reference(out, n));
    out
}

/// Longest line, where no text is longer: Part 21 leaves it open, older readers take 80 columns.
const WIDTH: usize = 79;

/// Breaks the text from a place on, behind commas and parentheses and at blanks, outside of quotes, into lines of at most 79
/// characters.
pub(super) fn fold(text: &mut String, start: usize) {
    if text.len() - start <= WIDTH + 1 {
        return;
    }
    let long = text.split_off(start);
    let (mut line, mut end, mut quoted) = (0, 0, false);
    for (i, b) in long.bytes().enumerate() {
        // The text is ASCII: every byte is a character. `end` is behind the last place for a break.
        if i - line >= WIDTH && end > line {
            text.push_str(long[line..end].trim_end_matches(' '));
            text.push('\n');
            line = end;
        }
        quoted ^= b == b'\'';
        if !quoted && (b == b',' || b == b'(' || b == b' ') {
            end = i + 1;
        }
    }
    text.push_str(&long[line..]);
}

/// A quoted STRING: backslashes doubled, everything outside printable ASCII as `\X2\` (UTF-16 unit of the basic plane) or
/// `\X4\` (any character). A quote, which the standard doubles, is `\X\27`: readers exist that take the first of two
/// for the end, and OpenCASCADE, gmsh and FreeCAD know both.
pub(super) fn string(text: &str) -> String {
    let mut out = String::from("'");
    let mut open = 0; // digits per character of the run that is open, 0 if none
    for c in text.chars() {
        let digits = match c {
            ' '..='~' => 0,
            c if u32::from(c) <= 0xFFFF => 4,
            _ => 8,
        };
        if digits != open {
            if open > 0 {
                out.push_str("\\X0\\");
            }
            out.push_str(match digits {
                4 => "\\X2\\",
                8 => "\\X4\\",
                _ => "",
            });
            open = digits;
        }
        match c {
            '\'' => out.push_str("\\X\\27"),
            '\\' => out.push_str("\\\\"),
            ' '..='~' => out.push(c),
            _ => {
                let _ = write!(out, "{:0digits$X}", u32::from(c));
            }
        }
    }
    if open > 0 {
        out.push_str("\\X0\\");
    }
    out.push('\'');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_are_ascii_and_escaped() {
        assert_eq!(string("plain"), "'plain'");
        assert_eq!(string("it's C:\\X2\\no"), "'it\\X\\27s C:\\\\X2\\\\no'");
        assert_eq!(string("5°"), "'5\\X2\\00B0\\X0\\'");
        assert_eq!(string("円弧x"), "'\\X2\\51865F27\\X0\\x'");
        assert_eq!(string("é\u{1F600}"), "'\\X2\\00E9\\X0\\\\X4\\0001F600\\X0\\'");
        assert_eq!(string("a\nb"), "'a\\X2\\000A\\X0\\b'");
    }

    #[test]
    fn lines_are_broken_between_values_only() {
        let name = string(&"a, b ".repeat(30));
        let mut data = Data::default();
        data.add(&format!("PRODUCT({name},{})", references(&[123_456; 40])));
        let text = data.text().to_owned();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!((lines[0], lines[1]), ("#1=PRODUCT(", &*format!("{name},")), "no break in a text");
        let lines = &lines[1..];
        assert!(lines[1..].iter().all(|l| l.len() <= WIDTH && !l.is_empty()), "{lines:?}");
        assert!(lines[1..lines.len() - 1].iter().all(|l| l.len() > WIDTH - 9), "as few as possible");
        assert_eq!(data.text().replace('\n', ""), format!("#1=PRODUCT({name},{});", references(&[123_456; 40])));
        data.add(&format!("({} X())", ["B_SPLINE()"; 20].join(" ")));
        assert!(data.text().lines().skip(lines.len() + 1).all(|l| l.len() <= WIDTH && l == l.trim()));
    }

    #[test]
    fn equal_instances_are_shared() {
        let mut data = Data::default();
        let a = data.point(Point3::new(0.0, -0.0, 1.0));
        assert_eq!(data.point(Point3::new(-0.0, 0.0, 1.0)), a);
        assert_eq!(data.text(), "#1=CARTESIAN_POINT('',(0.,0.,1.));\n");
    }
}
