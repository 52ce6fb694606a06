//! "Did you mean": the known words that a mistyped one is near to.

/// Words suggested at most.
const MOST: usize = 3;

/// Longest word that can be a slip of the keyboard; the search takes the product of the lengths.
const LONGEST: usize = 64;

/// Shortest word that counts as a part of a longer one.
const SHORTEST_PART: usize = 3;

/// The known words that `word` may stand for, nearest first: those that are a few letters away (inserted, left out,
/// replaced or swapped: at most one in three), else those that share a whole word with it (`spline`, `arc-spline`), else
/// those that begin alike (`tol`, `tolerance`; `rotate`, `rotation`). Capitals and the kind of dash do not count.
///
/// ```
/// assert_eq!(cyclide_io::text::similar("circel", ["circle", "arc"]), ["circle"]);
/// ```
#[must_use]
pub fn similar<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    if word.len() > LONGEST {
        return Vec::new();
    }
    let typed = plain(word);
    let known: Vec<(&str, String)> = known.into_iter().map(|k| (k, plain(k))).collect();
    let limit = (typed.chars().count() / 3).max(1);
    let distance = |k: &str| strsim::osa_distance(&typed, k);
    // A single letter is near to every other one.
    let near = known
        .iter()
        .map(|(k, plain)| (distance(plain), *k))
        .filter(|(d, k)| *d <= limit && *d < k.len().min(typed.len()));
    let mut near: Vec<(usize, &str)> = near.collect();
    near.sort_by_key(|(distance, _)| *distance);
    if let Some(&(best, _)) = near.first() {
        return near.into_iter().take_while(|(d, _)| *d == best).map(|(_, k)| k).take(MOST).collect();
    }
    let parts = |text: &str| -> Vec<String> {
        text.split('-').filter(|part| part.len() >= SHORTEST_PART).map(str::to_owned).collect()
    };
    let typed_parts = parts(&typed);
    let shares = |k: &str| parts(k).iter().any(|part| typed_parts.contains(part));
    // Two thirds of the word typed, and not of a short one.
    let alike = |k: &str| typed.bytes().zip(k.bytes()).take_while(|(a, b)| a == b).count();
    let begins = |k: &str| typed.len() >= SHORTEST_PART && alike(k) >= SHORTEST_PART && 3 * alike(k) >= 2 * typed.len();
    let pick = |fits: &dyn Fn(&str) -> bool| -> Vec<&'a str> {
        known.iter().filter(|(_, plain)| fits(plain)).map(|(k, _)| *k).take(MOST).collect()
    };
    Some(pick(&shares)).filter(|found| !found.is_empty()).unwrap_or_else(|| pick(&begins))
}

/// The end of a message about an unknown word: `; did you mean `radius`?`, or nothing.
///
/// ```
/// assert_eq!(cyclide_io::text::did_you_mean("circel", ["circle", "arc"]), "; did you mean `circle`?");
/// ```
#[must_use]
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    match similar(word, known).as_slice() {
        [] => String::new(),
        words => format!("; did you mean `{}`?", words.join("` or `")),
    }
}

/// Lower case, one kind of dash.
fn plain(word: &str) -> String {
    word.trim().to_lowercase().replace(['_', ' '], "-")
}

#[cfg(test)]
mod tests {
    use super::*;

    const TYPES: [&str; 5] = ["arc", "circle", "arc-spline", "circle-spline", "cyclide-patch"];

    #[test]
    fn slips_of_the_keyboard_are_found() {
        for (typed, meant) in [
            ("cirlce", &["circle"][..]),
            ("Circle", &["circle"]),
            ("arc_spline", &["arc-spline"]),
            ("arcspline", &["arc-spline"]),
            ("spline", &["arc-spline", "circle-spline"]),
            ("patch", &["cyclide-patch"]),
            ("cyc", &["cyclide-patch"]),
        ] {
            assert_eq!(similar(typed, TYPES), meant, "{typed}");
        }
        assert_eq!(similar("centre", ["center", "radius"]), ["center"]);
        assert_eq!(similar("tol", ["tolerance", "target"]), ["tolerance"]);
        assert_eq!(similar("rotate", ["translation", "rotation", "scale"]), ["rotation"]);
    }

    #[test]
    fn other_words_are_not() {
        for typed in ["", "a", "sphere", "polygon", "é", "--"] {
            assert!(similar(typed, TYPES).is_empty(), "{typed}");
        }
        assert!(similar("x", ["y", "z"]).is_empty());
        assert_eq!(did_you_mean("sphere", TYPES), "");
        assert_eq!(did_you_mean("arcc", TYPES), "; did you mean `arc`?");
    }
}
