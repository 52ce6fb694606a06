//! The edges of a surface as arcs.

use cyclide::model::{CurveObject, SurfaceObject};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, OfPanels, Reference, Shape, of};
use crate::error::Result;

/// The edges of another surface as arcs: the structure that carries a skin.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"p": {"type": "cyclide-patch", "corners": [[0, 0], [2, 0], [0, 1], [2, 1]], "frame": [[1, 0, 0], [0, 1, 0]]}, "e": {"type": "support-structure", "of": "p"}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[1].item.curves()[0].as_curve()) - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct SupportStructureSpec {
    /// The word `support-structure`.
    #[schemars(with = "String", extend("const" = "support-structure"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the surface.
    pub of: String,
}

impl Kind for SupportStructureSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.support_structure().map(Shape::plain)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn of_panels(&self) -> Option<OfPanels> {
        Some(OfPanels::Edges { of: self.of.clone() })
    }
}

impl Builder<'_> {
    /// The edges of a surface that are arcs, each once; says how many are not.
    pub(in crate::document) fn support_structure(&mut self) -> Result<Vec<CurveObject>> {
        let source = self.surface_source("only surfaces have a support structure")?;
        let (mut arcs, mut rational) = (Vec::new(), 0);
        for surface in source.item.surfaces() {
            arcs.extend(surface.edge_arcs().map_err(|e| self.refused(&e, None))?);
            if let SurfaceObject::Body(body) = surface {
                let shells = std::iter::once(&body.outer).chain(&body.voids);
                rational += shells.flat_map(|shell| shell.edges()).filter(|edge| edge.curve.arc().is_none()).count();
            }
        }
        if rational > 0 {
            let all = arcs.len() + rational;
            let message = format!(
                "{rational} of {all} edges are rational curves of higher degree and are left out: a support structure consists of arcs and segments"
            );
            self.remark("rational-edges-left-out", None, None, None, message);
        }
        Ok(arcs.into_iter().map(CurveObject::Arc).collect())
    }
}
