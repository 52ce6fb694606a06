//! Faces as programs export them: some turned over, some there twice.

use std::collections::HashMap;

/// How many there are, and the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Counted {
    pub(crate) first: usize,
    pub(crate) count: usize,
}

impl Counted {
    pub(crate) fn add(&mut self, index: usize) {
        if self.count == 0 {
            self.first = index;
        }
        self.count += 1;
    }
}

/// Faces with the same vertices as one before them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Doubled {
    /// The first of them: the index of the earlier face, and its own.
    pub(crate) faces: [usize; 2],
    /// How many there are after it.
    pub(crate) more: usize,
}

impl Doubled {
    /// Finds them; vertices that are equal must have one index.
    pub(crate) fn among(faces: &[impl AsRef<[usize]>]) -> Option<Self> {
        let mut seen: HashMap<Vec<usize>, usize> = HashMap::with_capacity(faces.len());
        let mut found: Option<Self> = None;
        for (index, face) in faces.iter().enumerate() {
            let mut vertices = face.as_ref().to_vec();
            vertices.sort_unstable();
            let first = *seen.entry(vertices).or_insert(index);
            if first != index {
                let more = found.map_or(0, |found| found.more + 1);
                found = Some(Self { faces: found.map_or([first, index], |found| found.faces), more });
            }
        }
        found
    }

    /// What is said of the others, and the remedy.
    pub(crate) fn remedy(self) -> String {
        match self.more {
            0 => ": delete one of them".to_owned(),
            1 => ", and 1 more face has those of an earlier one: delete both repeated faces".to_owned(),
            more => {
                format!(", and {more} more faces have those of earlier ones: delete all {} repeated faces", more + 1)
            }
        }
    }
}

/// The faces whose corners run the other way than those of most faces that they are connected with.
///
/// Two faces agree if they run along their common edge in opposite directions. Of each connected part the smaller half is turned, of
/// two equal ones that without the first face. Parts without a side (Möbius strips), and edges of three faces, are left as they are:
/// they are refused elsewhere.
pub(crate) fn turned_over(faces: &[impl AsRef<[usize]>]) -> Vec<bool> {
    let neighbors = neighbors(faces);
    let mut turned = vec![false; faces.len()];
    let mut reached = vec![false; faces.len()];
    for start in 0..faces.len() {
        if std::mem::replace(&mut reached[start], true) {
            continue;
        }
        let (mut part, mut next, mut has_sides) = (vec![start], 0, true);
        while let Some(&face) = part.get(next) {
            next += 1;
            for &(other, agrees) in &neighbors[face] {
                let wanted = turned[face] == agrees;
                if !std::mem::replace(&mut reached[other], true) {
                    turned[other] = wanted;
                    part.push(other);
                }
                has_sides &= turned[other] == wanted;
            }
        }
        let count = part.iter().filter(|face| turned[**face]).count();
        let most_are = 2 * count > part.len();
        part.iter().for_each(|face| turned[*face] = has_sides && turned[*face] != most_are);
    }
    turned
}

/// Of each face those that share an edge with it, edges of two faces only, and whether they run along it in opposite directions.
fn neighbors(faces: &[impl AsRef<[usize]>]) -> Vec<Vec<(usize, bool)>> {
    let mut uses: HashMap<[usize; 2], Vec<(usize, bool)>> = HashMap::new();
    for (index, face) in faces.iter().enumerate() {
        let face = face.as_ref();
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            uses.entry([a.min(b), a.max(b)]).or_default().push((index, a < b));
        }
    }
    let mut neighbors = vec![Vec::new(); faces.len()];
    for (index, face) in faces.iter().enumerate() {
        let face = face.as_ref();
        for (k, &a) in face.iter().enumerate() {
            let b = face[(k + 1) % face.len()];
            if let [one, two] = uses[&[a.min(b), a.max(b)]][..] {
                let other = if one.0 == index { two.0 } else { one.0 };
                neighbors[index].push((other, one.1 != two.1));
            }
        }
    }
    neighbors
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two by two quads over nine vertices, and a quad apart.
    const QUADS: [[usize; 4]; 5] = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7], [10, 11, 12, 13]];

    fn reversed(mut faces: [[usize; 4]; 5], which: &[usize]) -> [[usize; 4]; 5] {
        which.iter().for_each(|k| faces[*k].reverse());
        faces
    }

    #[test]
    fn the_minority_of_each_part_is_turned() {
        for which in 0..32_usize {
            let reversed_ones: Vec<usize> = (0..5).filter(|k| which >> k & 1 == 1).collect();
            let connected = reversed_ones.iter().filter(|k| **k < 4).count();
            let first = reversed_ones.contains(&0);
            // Of two against two the first face stays.
            let flip = connected > 2 || (connected == 2 && first);
            let expected: Vec<bool> = (0..5).map(|k| k < 4 && reversed_ones.contains(&k) != flip).collect();
            assert_eq!(turned_over(&reversed(QUADS, &reversed_ones)), expected, "{reversed_ones:?}");
        }
    }

    #[test]
    fn one_sided_strips_and_edges_of_three_faces_stay() {
        let strip = [[0, 1, 3, 2], [2, 3, 5, 4], [4, 5, 0, 1]];
        assert_eq!(turned_over(&strip), [false; 3]);
        let book = [[0, 1, 2], [0, 1, 3], [0, 1, 4]];
        assert_eq!(turned_over(&book), [false; 3]);
    }

    #[test]
    fn faces_that_are_there_twice_are_found_however_they_start() {
        assert_eq!(Doubled::among(&QUADS), None);
        let faces = [[0, 1, 4, 3], [1, 2, 5, 4], [4, 1, 0, 3], [5, 1, 2, 4], [0, 1, 4, 3]];
        assert_eq!(Doubled::among(&faces[..3]), Some(Doubled { faces: [0, 2], more: 0 }));
        assert_eq!(Doubled::among(&faces), Some(Doubled { faces: [0, 2], more: 2 }));
    }
}
