//! Copies in which tokens and items stand in for others of their kind: they get past the tokenizers, so that what is
//! behind these is tried.

use super::Mutator;
use std::ops::Range;

/// Whole numbers that counts and indices stumble over.
const INTEGERS: [&str; 9] = ["0", "1", "2", "3", "255", "65536", "2147483648", "4294967295", "18446744073709551615"];
/// Numbers with a point as all formats write them.
const REALS: [&str; 11] = [
    "0.0",
    "-0.0",
    "1.0",
    "-1.0",
    "0.5",
    "1.0E-320",
    "1.0E308",
    "-1.0E308",
    "1.0E-16",
    "1.0E15",
    "1.7976931348623157E308",
];

/// Longest text whose tokens and items are looked for; more is left as it is.
const WINDOW: usize = 1 << 14;

/// What the parts of a text hang together by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// Items between commas in brackets, and statements between semicolons.
    Lists,
    /// Lines in pairs: what it is, and its value.
    Pairs,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// `#12`, where it is not the one that is defined.
    Reference,
    Integer,
    Real,
    Word,
    /// `.T.`
    Choice,
    /// Between quotes.
    Text,
}

type Token = (Kind, Range<usize>);

impl Mutator {
    /// A copy with one to three tokens or items exchanged.
    pub(super) fn exchanged(&mut self, bytes: &[u8], layout: Layout) -> Vec<u8> {
        let start = self.below(bytes.len().saturating_sub(WINDOW) + 1);
        let end = (start + WINDOW).min(bytes.len());
        let mut window = bytes[start..end].to_vec();
        for _ in 0..=self.below(3) {
            let changed = match (self.below(3), layout) {
                (0, Layout::Lists) => self.item(&window),
                (0, Layout::Pairs) => self.pair(&window),
                _ => self.token(&window),
            };
            window = changed.unwrap_or(window);
        }
        [&bytes[..start], &window, &bytes[end..]].concat()
    }

    /// A token replaced by another one of its kind, of the text or an awkward one.
    fn token(&mut self, text: &[u8]) -> Option<Vec<u8>> {
        let tokens = tokens(text);
        let (kind, place) = tokens.get(self.below(tokens.len()))?.clone();
        let awkward: &[&str] = match kind {
            Kind::Integer => &INTEGERS,
            Kind::Real => &REALS,
            _ => &[],
        };
        let new = if !awkward.is_empty() && self.below(2) == 0 {
            awkward[self.below(awkward.len())].as_bytes().to_vec()
        } else {
            let same: Vec<&Token> = tokens.iter().filter(|token| token.0 == kind).collect();
            text[same[self.below(same.len())].1.clone()].to_vec()
        };
        Some([&text[..place.start], &new, &text[place.end..]].concat())
    }

    /// An item of a list or a statement left out, doubled, or exchanged with the next one.
    fn item(&mut self, text: &[u8]) -> Option<Vec<u8>> {
        let statement = text.contains(&b';') && self.below(3) == 0;
        let from = self.below(text.len());
        let start = if statement {
            from + text[from..].iter().position(|b| *b == b';')? + 1
        } else {
            from + text[from..].iter().position(|b| b",([{".contains(b))? + 1
        };
        let first = start..item_end(text, start, statement)?;
        let separator = text[first.end];
        let second = (separator == b',' || statement)
            .then(|| item_end(text, first.end + 1, statement).map(|end| first.end + 1..end))
            .flatten();
        let own = &text[first.clone()];
        // Of statements few are doubled: their number is then there twice, which is seen at once.
        Some(match (self.below(if statement { 2 } else { 3 }), second) {
            (0, Some(second)) => [&text[..first.start], &text[second.start..]].concat(),
            (1, Some(second)) => {
                let rest = &text[second.end..];
                [&text[..first.start], &text[second.clone()], &[separator], own, rest].concat()
            }
            (0 | 1, None) => {
                // With the comma before it.
                let before = first.start - usize::from(text[first.start - 1] == b',');
                [&text[..before], &text[first.end..]].concat()
            }
            _ => [&text[..first.end], if statement { b";" } else { b"," }, own, &text[first.end..]].concat(),
        })
    }

    /// A pair of lines left out, doubled, or with the value of another one.
    fn pair(&mut self, text: &[u8]) -> Option<Vec<u8>> {
        // From any line on: the window need not begin with a pair, but whole pairs of lines keep the order of the rest.
        let ends: Vec<usize> = text.iter().enumerate().filter(|(_, b)| **b == b'\n').map(|(i, _)| i + 1).collect();
        let line = |i: usize| Some(*ends.get(i)?..*ends.get(i + 1)?);
        let [one, other] = [self.below(ends.len()), self.below(ends.len())];
        let (first, second) = (line(one)?, line(one + 1)?);
        let pair = first.start..second.end;
        Some(match self.below(3) {
            0 => [&text[..pair.start], &text[pair.end..]].concat(),
            1 => [&text[..pair.end], &text[pair.clone()], &text[pair.end..]].concat(),
            _ => {
                // Lines that are as far apart as pairs are both codes or both values.
                let value = line(other - other % 2 + one % 2)?;
                [&text[..first.start], &text[value], &text[first.end..]].concat()
            }
        })
    }
}

/// Where an item ends that starts at a place: before the comma or bracket behind it, or the semicolon.
fn item_end(text: &[u8], start: usize, statement: bool) -> Option<usize> {
    let mut depth = 0_usize;
    let mut quote = None;
    for (i, &b) in text.iter().enumerate().skip(start) {
        match (b, quote) {
            (b, Some(open)) => quote = (b != open).then_some(open),
            (b'\'' | b'"', None) => quote = Some(b),
            (b';', None) if statement => return Some(i),
            (b',' | b')' | b']' | b'}', None) if depth == 0 && !statement => return Some(i),
            (b'(' | b'[' | b'{', None) => depth += 1,
            (b')' | b']' | b'}', None) => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    None
}

/// The tokens of a text, but for brackets and signs between them.
fn tokens(text: &[u8]) -> Vec<Token> {
    let at = |i: usize| text.get(i).copied().unwrap_or_default();
    let run = |from: usize, is: fn(u8) -> bool| (from..text.len()).find(|i| !is(text[*i])).unwrap_or(text.len());
    let is_digit = |b: u8| b.is_ascii_digit();
    let mut found = Vec::new();
    let mut i = 0;
    while i < text.len() {
        let (kind, end) = match at(i) {
            b'#' if is_digit(at(i + 1)) => {
                let end = run(i + 1, |b| b.is_ascii_digit());
                if at(end) == b'=' {
                    i = end;
                    continue;
                }
                (Kind::Reference, end)
            }
            quote @ (b'\'' | b'"') => {
                let close = text[i + 1..].iter().position(|b| *b == quote);
                (Kind::Text, close.map_or(text.len(), |close| i + close + 2))
            }
            b if is_digit(b) || b == b'-' && is_digit(at(i + 1)) => {
                let end = run(i + 1, |b| b.is_ascii_digit() || b == b'.');
                let signed = end + 1 + usize::from(matches!(at(end + 1), b'-' | b'+'));
                let exponent = matches!(at(end), b'e' | b'E') && is_digit(at(signed));
                let end = if exponent { run(signed, |b| b.is_ascii_digit()) } else { end };
                let real = text[i..end].iter().any(|b| b".eE".contains(b));
                (if real { Kind::Real } else { Kind::Integer }, end)
            }
            b'.' if at(i + 1).is_ascii_alphabetic() => {
                (Kind::Choice, run(i + 1, |b| b.is_ascii_alphanumeric() || b"_.".contains(&b)))
            }
            b if b.is_ascii_alphabetic() => (Kind::Word, run(i + 1, |b| b.is_ascii_alphanumeric() || b == b'_')),
            _ => {
                i += 1;
                continue;
            }
        };
        found.push((kind, i..end));
        i = end;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_of_every_kind() {
        let text = b"#3=(#12,LINE,'a b',.T.,-1.5E-3,7,\"x\",$);";
        let found: Vec<(Kind, &str)> =
            tokens(text).into_iter().map(|(kind, place)| (kind, std::str::from_utf8(&text[place]).unwrap())).collect();
        assert_eq!(
            found,
            [
                (Kind::Reference, "#12"),
                (Kind::Word, "LINE"),
                (Kind::Text, "'a b'"),
                (Kind::Choice, ".T."),
                (Kind::Real, "-1.5E-3"),
                (Kind::Integer, "7"),
                (Kind::Text, "\"x\""),
            ]
        );
    }

    #[test]
    fn items_keep_their_brackets() {
        let depth =
            |text: &[u8]| text.iter().filter(|b| **b == b'(').count().cmp(&text.iter().filter(|b| **b == b')').count());
        let mut mutator = Mutator::new(3, &[]);
        for _ in 0..200 {
            let copy = mutator.item(b"#1=A((1,2),(3,(4,5)));#2=B(6,7);#3=C();").unwrap_or_default();
            assert!(depth(&copy).is_eq(), "{}", String::from_utf8_lossy(&copy));
        }
    }

    #[test]
    fn pairs_stay_pairs() {
        let mut mutator = Mutator::new(3, &[]);
        for _ in 0..200 {
            let copy = mutator.pair(b"  0\nLINE\n 10\n1.0\n 20\n2.0\n  0\nEOF\n").unwrap_or_default();
            assert!(copy.iter().filter(|b| **b == b'\n').count().is_multiple_of(2));
        }
    }
}
