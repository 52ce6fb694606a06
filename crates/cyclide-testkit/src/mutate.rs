//! Files broken on purpose: small changes to the bytes of a right file, the same for the same seed.
//!
//! The changes are those that parsers stumble over: bits and bytes, pieces left out, doubled or exchanged, the end cut
//! off, numbers replaced by awkward ones, and words of the format in the wrong place. Of formats whose structure is known
//! most copies have their tokens and items exchanged for others of their kind: nearly all of the first sort are refused by
//! the tokenizer, and what is behind it would not be tried.

mod container;
mod exchange;

use exchange::Layout;
use std::ops::Range;

/// Numbers that parsers and geometry stumble over.
const NUMBERS: [&str; 20] = [
    "0",
    "-0.",
    "1",
    "-1",
    "2",
    "1E308",
    "-1E308",
    "1e-320",
    "nan",
    "inf",
    "1E999",
    "0.1",
    "255",
    "256",
    "65536",
    "2147483648",
    "4294967295",
    "18446744073709551615",
    "99999999999999999999",
    "1.7976931348623157e308",
];

/// Bytes that parsers stumble over.
const BYTES: [u8; 16] = *b"\0\n\r\"'#()[]{},;.\xff";

/// Longest piece that is left out, doubled or exchanged.
const PIECE: usize = 64;

/// Changes made to one copy at most.
const CHANGES: usize = 4;

/// What is known of the structure of a format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Nothing.
    Bytes,
    /// Lists in brackets, statements with semicolons: STEP, JSON.
    Lists,
    /// Lines in pairs: DXF.
    Pairs,
    /// A chunk of JSON and one of numbers: GLB.
    Container,
}

/// A source of broken copies.
#[derive(Debug, Clone)]
pub struct Mutator {
    state: u64,
    words: &'static [&'static str],
}

impl Mutator {
    /// Equal seeds give equal copies; `words` are those of the format.
    #[must_use]
    pub const fn new(seed: u64, words: &'static [&'static str]) -> Self {
        Self { state: seed ^ 0x9e37_79b9_7f4a_7c15, words }
    }

    /// A number below `count`; 0 if that is 0. The generator is SplitMix64.
    pub fn below(&mut self, count: usize) -> usize {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((z ^ (z >> 31)) % (count.max(1) as u64)).unwrap_or(0)
    }

    /// A copy of a file of this form: of most the structure stays, of one in eight not even that.
    #[must_use]
    pub fn copy(&mut self, bytes: &[u8], form: Form) -> Vec<u8> {
        match form {
            Form::Bytes => self.broken(bytes),
            _ if self.below(8) == 0 => self.broken(bytes),
            Form::Pairs => self.exchanged(bytes, Layout::Pairs),
            Form::Container => self.container(bytes).unwrap_or_else(|| self.broken(bytes)),
            Form::Lists => self.exchanged(bytes, Layout::Lists),
        }
    }

    /// A copy with one to four changes.
    #[must_use]
    pub fn broken(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut copy = bytes.to_vec();
        for _ in 0..=self.below(CHANGES) {
            match self.below(9) {
                0 => self.flip(&mut copy),
                1 => self.byte(&mut copy),
                2 => drop(copy.drain(self.piece(copy.len()))),
                3 => {
                    let (piece, at) = (copy[self.piece(copy.len())].to_vec(), self.below(copy.len() + 1));
                    drop(copy.splice(at..at, piece));
                }
                4 => {
                    // A piece in the place of another one.
                    let piece = copy[self.piece(copy.len())].to_vec();
                    let place = self.piece(copy.len());
                    drop(copy.splice(place, piece));
                }
                5 if self.below(8) == 0 => copy.truncate(self.below(copy.len() + 1)),
                6 if !self.words.is_empty() => {
                    let word = self.words[self.below(self.words.len())];
                    let at = self.below(copy.len() + 1);
                    drop(copy.splice(at..at, word.bytes()));
                }
                _ => self.number(&mut copy),
            }
        }
        copy
    }

    /// A copy of the same length: for formats whose lengths are written down.
    fn broken_in_place(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut copy = bytes.to_vec();
        for _ in 0..=self.below(CHANGES) {
            if self.below(2) == 0 { self.flip(&mut copy) } else { self.byte(&mut copy) }
        }
        copy
    }

    fn flip(&mut self, bytes: &mut [u8]) {
        let (at, bit) = (self.below(bytes.len()), self.below(8));
        bytes.get_mut(at).into_iter().for_each(|byte| *byte ^= 1 << bit);
    }

    fn byte(&mut self, bytes: &mut [u8]) {
        let (at, new) = (self.below(bytes.len()), BYTES[self.below(BYTES.len())]);
        bytes.get_mut(at).into_iter().for_each(|byte| *byte = new);
    }

    /// A place of a piece in so many bytes.
    fn piece(&mut self, length: usize) -> Range<usize> {
        let start = self.below(length);
        start..(start + self.below(PIECE)).min(length)
    }

    /// An awkward number in the place of a number at or behind a random place.
    fn number(&mut self, bytes: &mut Vec<u8>) {
        let from = self.below(bytes.len());
        let Some(start) = bytes[from..].iter().position(u8::is_ascii_digit).map(|at| from + at) else { return };
        let is_part = |byte: &&u8| byte.is_ascii_digit() || b".eE+-".contains(byte);
        let length = bytes[start..].iter().take_while(is_part).count();
        let number = NUMBERS[self.below(NUMBERS.len())];
        drop(bytes.splice(start..start + length, number.bytes()));
    }
}
