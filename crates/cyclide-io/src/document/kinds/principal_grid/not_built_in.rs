//! What stands for grids along lines of curvature where they are not built in.

use cyclide::CurveObject;

use crate::document::kinds::principal_grid::PrincipalGridSpec;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::error::Result;

impl Builder<'_> {
    /// Refuses to lay a grid.
    ///
    /// # Errors
    /// `not-built-in`, always.
    pub(in crate::document) fn principal_grid(&self, _: &PrincipalGridSpec) -> Result<Vec<CurveObject>> {
        let words = "this program is built without the feature `circular-mesh`, which lays the grid".to_owned();
        Err(self.refused_in_words([Step::from("type")], "not-built-in", words))
    }
}
