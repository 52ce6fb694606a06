//! Every reason for which the kernel refuses input, with the shortest input that is refused for it.
//!
//! A reason is the stable word of an [`Error`](crate::Error), which [`Error::reason`](crate::Error::reason) gives: messages may be
//! worded anew, reasons stay. What was measured and what was allowed stands in the fields of the variant.
//!
//! | page | what is refused there |
//! |---|---|
//! | [`numbers`] | numbers, points, directions and lists as such; maps |
//! | [`curves`] | arcs, circles, splines and fits |
//! | [`patches`] | patches, nets, their offsets and shells; quads made circular |
//! | [`bodies`] | revolutions, pipes, necks, bridges, surfaces between two curves, polyhedra |
//! | [`meshes`] | triangles and meshes of them |
//! | [`tori`] | tori, points and curves on them |
//! | [`volumes`] | cubes with concircular faces and the blocks in them |
//! | [`motions`] | displacements, motions and what is made of them |

pub mod bodies;
pub mod curves;
pub mod meshes;
pub mod motions;
pub mod numbers;
pub mod patches;
pub mod tori;
pub mod volumes;

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use crate::error::Error;

    #[test]
    fn every_reason_has_an_example_and_every_example_a_reason() {
        let pages = [
            include_str!("numbers.rs"),
            include_str!("curves.rs"),
            include_str!("patches.rs"),
            include_str!("bodies.rs"),
            include_str!("meshes.rs"),
            include_str!("tori.rs"),
            include_str!("motions.rs"),
            include_str!("volumes.rs"),
        ];
        let reasons: BTreeSet<&str> = Error::reasons().collect();
        for reason in &reasons {
            let (heading, example) = (format!("//! # `{reason}`\n"), format!(".reason(), \"{reason}\");"));
            let found = |what: &str| pages.iter().map(|page| page.matches(what).count()).sum::<usize>();
            assert_eq!((found(&heading), found(&example)), (1, 1), "{reason}");
        }
        let headings = pages.iter().flat_map(|page| page.lines()).filter(|line| line.starts_with("//! # `"));
        assert_eq!(headings.count(), reasons.len());
    }
}
