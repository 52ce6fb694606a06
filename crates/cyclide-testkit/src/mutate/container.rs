//! Copies of GLB: its chunks broken, and the lengths mended, or nobody would look into them.

use super::Mutator;
use super::exchange::Layout;

/// Words of the binary chunk that readers of numbers and indices stumble over.
const WORDS: [u32; 10] =
    [0, 1, 2, 0xFFFF_FFFF, 0x7F80_0000, 0x7FC0_0000, 0x7F7F_FFFF, 0x8000_0000, 0x0000_0001, 0x3F80_0000];

impl Mutator {
    /// A copy of a GLB file; `None` if it has no chunks.
    pub(super) fn container(&mut self, bytes: &[u8]) -> Option<Vec<u8>> {
        let length = |at: usize| Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?) as usize);
        let (text, rest) = bytes.get(20..)?.split_at_checked(length(12)?)?;
        let binary = rest.get(8..)?;
        let part = self.below(8);
        let text = match part {
            0 => self.broken(text),
            1..5 => self.exchanged(text, Layout::Lists),
            _ => text.to_vec(),
        };
        let binary = match part {
            0..5 => binary.to_vec(),
            5 => self.broken_in_place(binary),
            _ => self.words_changed(binary),
        };
        let size = |bytes: &[u8]| u32::try_from(bytes.len()).unwrap_or(u32::MAX).to_le_bytes();
        let body = [&size(&text)[..], b"JSON", &text, &size(&binary), b"BIN\0", &binary].concat();
        let total = u32::try_from(12 + body.len()).unwrap_or(u32::MAX).to_le_bytes();
        Some([b"glTF", &2_u32.to_le_bytes()[..], &total, &body].concat())
    }

    /// A copy with some words of four bytes exchanged for awkward ones or for others.
    fn words_changed(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut copy = bytes.to_vec();
        for _ in 0..=self.below(4) {
            let [at, other] = [self.below(copy.len() / 4), self.below(copy.len() / 4)].map(|word| 4 * word);
            let awkward = WORDS[self.below(WORDS.len())].to_le_bytes();
            let new = if self.below(2) == 0 { Some(awkward) } else { copy[other..].first_chunk().copied() };
            if let (Some(new), Some(place)) = (new, copy.get_mut(at..at + 4)) {
                place.copy_from_slice(&new);
            }
        }
        copy
    }
}
