//! What is refused of objects of blocks before any surface is made: surfaces that are there twice.

use super::Builder;
use crate::document::locate::Step;
use crate::document::spec::CoordinateSurfacesSpec;
use crate::error::Result;

impl Builder<'_> {
    /// Refuses values of a parameter that are given twice: two surfaces would be one.
    pub(super) fn check_surfaces_differ(&self, spec: &CoordinateSurfacesSpec) -> Result<()> {
        for (field, values) in [("s", &spec.s), ("t", &spec.t), ("u", &spec.u)] {
            let again = |k: usize| values[..k].iter().position(|x| x.total_cmp(&values[k]).is_eq());
            if let Some((k, before)) = (0..values.len()).find_map(|k| Some((k, again(k)?))) {
                let words = format!(
                    "{field}[{k}] = {} is {field}[{before}] again: the surfaces would lie on each other",
                    values[k]
                );
                let place = [Step::from(field), Step::from(k)];
                return Err(self.refused_in_words(place, "parameters-not-increasing", words));
            }
        }
        Ok(())
    }
}
