//! The unknowns that coordinates of corners are made of: one for each place, and what is added where lines come back.

use super::sheet::Sheet;

/// The coordinate of a corner: a multiple of the unknown of its place, and of one other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub(super) place: usize,
    pub(super) factor: f64,
    pub(super) also: Option<(usize, f64)>,
}

/// The unknowns of a sheet.
pub(super) struct Unknowns {
    /// Of each corner.
    pub(super) places: Vec<Corner>,
    pub(super) count: usize,
    /// The connected part of each triangle.
    pub(super) parts: Vec<usize>,
    pub(super) part_count: usize,
}

impl Unknowns {
    /// One for each place: corners round a vertex between which there is a way.
    pub(super) fn new(sheet: &Sheet<'_>) -> Self {
        let (places, count) = sheet.places();
        let (parts, part_count) = sheet.parts();
        let places = places.into_iter().map(|place| Corner { place, factor: 1.0, also: None }).collect();
        Self { places, count, parts, part_count }
    }

    /// The number of an unknown that is added on the left of a seam.
    pub(super) fn add_period(&mut self, left: &[bool]) -> usize {
        let period = self.count;
        self.count += 1;
        self.places.iter_mut().zip(left).filter(|(_, left)| **left).for_each(|(corner, _)| {
            corner.also = Some((period, 1.0));
        });
        period
    }

    /// A corner by its unknowns.
    pub(super) fn terms(&self, corner: usize) -> impl Iterator<Item = (usize, f64)> {
        let corner = self.places[corner];
        std::iter::once((corner.place, corner.factor)).chain(corner.also)
    }
}
