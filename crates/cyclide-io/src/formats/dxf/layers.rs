//! Layer names: one layer per object, in letters that the version allows.

use crate::export::options::DxfVersion;
use std::collections::HashSet;
use std::fmt::Write as _;

/// One layer name per object, different from each other in any case of letters.
pub(super) fn layer_names<'a>(objects: impl Iterator<Item = &'a str>, version: DxfVersion) -> Vec<String> {
    let mut taken: HashSet<String> = ["0".to_owned(), "DEFPOINTS".to_owned()].into();
    let unique = |name: String| {
        let mut candidate = name.clone();
        let mut number = 2;
        while !taken.insert(candidate.to_uppercase()) {
            candidate = format!("{name}_{number}");
            number += 1;
        }
        candidate
    };
    objects.map(|o| allowed(o, version)).map(unique).map(|n| escaped(&n)).collect()
}

/// The name of the group of a curve, which is the `number`-th group of the file, from 0.
pub(super) fn group_name(curve: &str, number: usize) -> String {
    format!("{}_{}", escaped(&allowed(curve, DxfVersion::R2000)), number + 1)
}

/// Lettering as the file has it: no control characters, no blanks at its ends.
pub(super) fn allowed_lettering(text: &str) -> String {
    let plain: String = text.trim().chars().map(|c| if c.is_control() { '_' } else { c }).collect();
    escaped(&plain)
}

/// The name with every letter that is not allowed replaced, and cut to the length that is.
fn allowed(name: &str, version: DxfVersion) -> String {
    let (longest, allowed): (usize, fn(char) -> bool) = match version {
        DxfVersion::R2000 => (200, |c| !c.is_control() && !"<>/\\\":;?*|,=`".contains(c)),
        DxfVersion::R12 => (28, |c| c.is_ascii_alphanumeric() || "$-_".contains(c)),
    };
    let letter = |c: char| if allowed(c) { c } else { '_' };
    let name: String = name.trim().chars().map(letter).take(longest).collect();
    // Readers take no blank at the end of a line for a part of it.
    match (name.trim_end(), version) {
        ("", _) => "_".to_owned(),
        (name, DxfVersion::R12) => name.to_uppercase(),
        (name, DxfVersion::R2000) => name.to_owned(),
    }
}

/// ASCII with `\U+hhhh` for everything else (UTF-16 units), as files before R2007 have it.
pub(super) fn escaped(name: &str) -> String {
    let mut out = String::new();
    for c in name.chars() {
        if c.is_ascii() {
            out.push(c);
        } else {
            for unit in c.encode_utf16(&mut [0; 2]) {
                // Writing to a string cannot fail.
                let _ = write!(out, "\\U+{unit:04X}");
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_legal_and_different() {
        let objects = ["hull", "HULL", "a/b\"c", "0", "", "円"];
        let names = |v| layer_names(objects.into_iter(), v);
        assert_eq!(names(DxfVersion::R2000), ["hull", "HULL_2", "a_b_c", "0_2", "_", "\\U+5186"]);
        assert_eq!(names(DxfVersion::R12), ["HULL", "HULL_2", "A_B_C", "0_2", "_", "__2"]);
    }
}
