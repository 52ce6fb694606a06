//! The DATA section as it grows: numbered instances, equal ones shared.

use crate::number::push_step;
use cyclide::{Point3, Vec3};
use std::collections::HashMap;
use std::fmt::Write as _;

/// Numbered instances of the DATA section.
#[derive(Default)]
pub(super) struct Data {
    text: String,
    count: usize,
    /// Points, directions and placements already written.
    shared: HashMap<String, usize>,
}

impl Data {
    /// The instances as text, one per line.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// Adds an instance and returns its number.
    pub(super) fn add(&mut self, body: &str) -> usize {
        self.count += 1;
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "#{}={body};", self.count);
        self.count
    }

    /// The number of an instance with this body, added if there is none yet.
    pub(super) fn share(&mut self, body: String) -> usize {
        if let Some(&number) = self.shared.get(&body) {
            return number;
        }
        let number = self.add(&body);
        self.shared.insert(body, number);
        number
    }

    pub(super) fn point(&mut self, p: Point3) -> usize {
        self.share(format!("CARTESIAN_POINT('',{})", reals(&p.to_array())))
    }

    pub(super) fn direction(&mut self, v: Vec3) -> usize {
        self.share(format!("DIRECTION('',{})", reals(&v.to_array())))
    }

    /// Placement with third axis `z` and first axis `x`, both unit and perpendicular.
    pub(super) fn placement(&mut self, origin: Point3, z: Vec3, x: Vec3) -> usize {
        let (origin, z, x) = (self.point(origin), self.direction(z), self.direction(x));
        self.share(format!("AXIS2_PLACEMENT_3D('',#{origin},#{z},#{x})"))
    }
}

/// One REAL.
pub(super) fn real(v: f64) -> String {
    let mut out = String::new();
    push_step(&mut out, v);
    out
}

/// A list of REALs.
pub(super) fn reals(values: &[f64]) -> String {
    list(values.iter().map(|&v| real(v)))
}

/// A list of references.
pub(super) fn references(numbers: &[usize]) -> String {
    list(numbers.iter().map(|n| format!("#{n}")))
}

/// A list of texts.
pub(super) fn list<I: IntoIterator<Item = String>>(items: I) -> String {
    let mut out = String::from("(");
    for (i, item) in items.into_iter().enumerate() {
        if i > 0 {
            out.push(',');
        }
        out.push_str(&item);
    }
    out.push(')');
    out
}

/// A quoted STRING: quotes and backslashes doubled, everything outside printable ASCII as `\X2\` (UTF-16 unit of
/// the basic plane) or `\X4\` (any character).
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
            '\'' => out.push_str("''"),
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
        assert_eq!(string("it's C:\\X2\\no"), "'it''s C:\\\\X2\\\\no'");
        assert_eq!(string("5°"), "'5\\X2\\00B0\\X0\\'");
        assert_eq!(string("円弧x"), "'\\X2\\51865F27\\X0\\x'");
        assert_eq!(string("é\u{1F600}"), "'\\X2\\00E9\\X0\\\\X4\\0001F600\\X0\\'");
        assert_eq!(string("a\nb"), "'a\\X2\\000A\\X0\\b'");
    }

    #[test]
    fn equal_instances_are_shared() {
        let mut data = Data::default();
        let a = data.point(Point3::new(0.0, -0.0, 1.0));
        assert_eq!(data.point(Point3::new(-0.0, 0.0, 1.0)), a);
        assert_eq!(data.text(), "#1=CARTESIAN_POINT('',(0.,0.,1.));\n");
    }
}
