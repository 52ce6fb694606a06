//! What stands for grids made circular where that is not built in.

use cyclide::{QuadGrid, QuadLayout};

use crate::document::kinds::cyclidic_net::CyclidicNetSpec;
use crate::document::kinds::cyclidic_net::make_circular::MakeCircularOptions;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::error::Result;

impl Builder<'_> {
    /// Refuses to move vertices.
    ///
    /// # Errors
    /// `not-built-in`, always.
    pub(in crate::document) fn circular(
        &self,
        _: &CyclidicNetSpec,
        _: &MakeCircularOptions,
        _: &QuadGrid,
    ) -> Result<QuadGrid> {
        Err(self.not_built_in())
    }

    /// The same for grids that join.
    ///
    /// # Errors
    /// `not-built-in`, always.
    pub(in crate::document) fn circular_layout(
        &self,
        _: &CyclidicNetSpec,
        _: &MakeCircularOptions,
        _: &QuadLayout,
    ) -> Result<QuadLayout> {
        Err(self.not_built_in())
    }

    fn not_built_in(&self) -> crate::error::Error {
        let words = "this program is built without the feature `circular-mesh`, which moves the vertices".to_owned();
        self.refused_in_words([Step::from("make_circular")], "not-built-in", words)
    }
}

#[cfg(test)]
mod tests {
    use crate::document::{Document, ModelBuilder};
    use std::path::Path;

    #[test]
    fn nets_are_not_made_circular_and_others_are_made() {
        let net = |field: &str| {
            let grid = "[[[0,0,0],[1,0,0]],[[0,1,0],[1,1,0]]]";
            let text =
                format!(r#"{{"cyclide": 1, "objects": {{"n": {{"type": "cyclidic-net", "grid": {grid}{field}}}}}}}"#);
            let document = Document::parse("n.json", text.as_bytes()).unwrap();
            let read = |_: &Path| Err(std::io::ErrorKind::NotFound.into());
            let built = ModelBuilder::new(&document, Path::new(""), &read).and_then(|mut b| b.build(0, &mut |_| {}));
            built.map(|built| built.bodies.len()).map_err(|error| error.to_string())
        };
        assert_eq!(net(""), Ok(1));
        assert_eq!(net(r#", "make_circular": false"#), Ok(1));
        let message = net(r#", "make_circular": true"#).unwrap_err();
        assert!(message.contains("objects.n.make_circular: ") && message.contains("[not-built-in]"), "{message}");
    }
}
