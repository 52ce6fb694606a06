//! Sheets: drawings in the plane that are made for people and machines besides the model itself, as plans and patterns.
//! Lines of arcs and segments, and lettering, on layers by name.

use super::layers::{allowed_lettering, layer_names};
use super::plane::Ocs;
use super::reader::parsed;
use super::skeleton::{self, Content, FIRST_FREE};
use super::tags::Tags;
use super::{Entities, LAYER, at_most_half_turns};
use crate::check::read_error::ReadError;
use crate::export::exported::{Promise, Written};
use crate::export::options::DxfVersion;
use cyclide::{
    Aabb, Point3, Vec3,
    curve::{Arc, ArcPath, ParamCurve as _},
    model::{ChainPiece, Units},
};

/// What is read may differ from what was drawn by this part of the largest coordinate: arcs that turn by less than 5e-8 are
/// straight in the file, which is a hundred-millionth of their length.
const READ_LIMIT: f64 = 1e-8;

/// A drawing in the plane `z = 0`.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Sheet {
    /// The layers.
    pub(crate) layers: Vec<&'static str>,
    pub(crate) lines: Vec<SheetLine>,
    pub(crate) letters: Vec<Lettering>,
}

/// Arcs and segments one after the other.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SheetLine {
    /// Index of the layer.
    pub(crate) layer: usize,
    pub(crate) path: ArcPath,
}

/// One line of lettering.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lettering {
    /// Index of the layer.
    pub(crate) layer: usize,
    pub(crate) text: String,
    /// Height of capitals.
    pub(crate) height: f64,
    /// The middle of the text.
    pub(crate) at: Point3,
}

impl Sheet {
    /// The box around it; around the origin if nothing is on it.
    pub(crate) fn bounds(&self) -> Aabb {
        let lines = self.lines.iter().flat_map(|line| line.path.arcs()).map(Arc::bounds);
        let letters = self.letters.iter().map(|letters| Aabb { min: letters.at, max: letters.at });
        lines.chain(letters).reduce(Aabb::union).unwrap_or(Aabb { min: Point3::ORIGIN, max: Point3::ORIGIN })
    }

    /// The file, R2000.
    pub(crate) fn write(&self, units: Units) -> Vec<u8> {
        let version = DxfVersion::R2000;
        let layers = layer_names(self.layers.iter().copied(), version);
        let mut file = Entities {
            tags: Tags::default(),
            version,
            next_handle: FIRST_FREE + layers.len(),
            groups: Vec::new(),
            promise: Promise::EXACT,
            written: Written::default(),
            in_space: false,
            splines: false,
        };
        for line in &self.lines {
            file.polyline(&line.path, Ocs::new(Vec3::Z), &layers[line.layer]);
        }
        for letters in &self.letters {
            file.lettering(letters, &layers[letters.layer]);
        }
        let Entities { tags: entities, groups, next_handle, .. } = file;
        let bounds = self.bounds();
        let content = Content { version, units, bounds, layers: &layers, groups: &groups, next_handle };
        let mut tags = Tags::default();
        skeleton::opening(&mut tags, &content);
        tags.append(entities);
        skeleton::closing(&mut tags, &content);
        tags.into_bytes()
    }

    /// Reads a file and holds it against the sheet: unit, layers, lines point by point, lettering word by word.
    ///
    /// # Errors
    /// What is not as it was drawn.
    pub(crate) fn check(&self, units: Units, bytes: &[u8]) -> Result<(), ReadError> {
        let drawing = parsed(bytes)?;
        let expected = units.in_millimetres();
        if drawing.unit != Some(expected) {
            return Err(ReadError::Unit { found: drawing.unit, expected });
        }
        let layers = layer_names(self.layers.iter().copied(), DxfVersion::R2000);
        let named = std::iter::once("0").chain(layers.iter().map(String::as_str));
        if !drawing.layers.iter().map(String::as_str).eq(named.clone()) {
            let (number, pair) = drawing
                .layers
                .iter()
                .map(|n| Some(n.as_str()))
                .chain([None])
                .zip(named.map(Some).chain([None]))
                .enumerate()
                .find(|(_, (a, b))| a != b)
                .unwrap_or((0, (None, None)));
            let (found, expected) = (pair.0.map(str::to_owned), pair.1.map(str::to_owned));
            return Err(ReadError::Name { of: LAYER, number, found, expected });
        }
        let other =
            |what: &str, index: usize| ReadError::syntax(format!("{what} {index}"), "it differs from what was drawn");
        if drawing.curves.len() != self.lines.len() {
            return Err(other("line", drawing.curves.len().min(self.lines.len())));
        }
        let bounds = self.bounds();
        let limit = READ_LIMIT * bounds.min.to_vec().max_abs().max(bounds.max.to_vec().max_abs());
        for (index, (found, drawn)) in drawing.curves.iter().zip(&self.lines).enumerate() {
            let arcs: Vec<Arc> = drawn.path.arcs().iter().flat_map(at_most_half_turns).collect();
            let pieces = found.chain.pieces();
            let near = |(piece, arc): (&ChainPiece, &Arc)| {
                [0.0, 0.5, 1.0].into_iter().all(|x| match piece {
                    ChainPiece::Arc(found) => found.point_at_length(x).distance(arc.point_at_length(x)) <= limit,
                    ChainPiece::Spline(_) => false,
                })
            };
            let alike = found.layer == layers[drawn.layer] && found.chain.is_closed() == drawn.path.is_closed();
            if !(alike && pieces.len() == arcs.len() && pieces.iter().zip(&arcs).all(near)) {
                return Err(other("line", index));
            }
        }
        if drawing.letters.len() != self.letters.len() {
            return Err(other("text", drawing.letters.len().min(self.letters.len())));
        }
        for (index, (found, drawn)) in drawing.letters.iter().zip(&self.letters).enumerate() {
            let same = found.text == allowed_lettering(&drawn.text)
                && found.layer == layers[drawn.layer]
                && found.height.to_bits() == drawn.height.to_bits()
                && found.at.distance(drawn.at) <= limit;
            if !same {
                return Err(other("text", index));
            }
        }
        Ok(())
    }
}

impl Entities {
    /// A TEXT about its middle.
    fn lettering(&mut self, letters: &Lettering, layer: &str) {
        let at = Point3::new(letters.at.x, letters.at.y, 0.0);
        self.entity("TEXT", None, layer);
        self.class("AcDbText");
        self.tags.point(10, at).real(40, letters.height).text(1, &allowed_lettering(&letters.text)).real(50, 0.0);
        self.tags.int(72, 1).point(11, at);
        self.class("AcDbText");
        self.tags.int(73, 2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet() -> Sheet {
        let [a, b, c] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        let arcs = vec![
            Arc::segment(a, b).unwrap(),
            Arc::segment(b, c).unwrap(),
            Arc::from_bulge(c, a, Vec3::Z, 0.2).unwrap(),
        ];
        let path = ArcPath::new(arcs, true).unwrap();
        let letters =
            Lettering { layer: 1, text: "Dach ü r0-c1".to_owned(), height: 0.25, at: Point3::new(1.0, 0.5, 0.0) };
        Sheet { layers: vec!["CUT", "LABEL"], lines: vec![SheetLine { layer: 0, path }], letters: vec![letters] }
    }

    #[test]
    fn a_sheet_is_read_as_it_was_drawn() {
        let sheet = sheet();
        let bytes = sheet.write(Units::Metre);
        sheet.check(Units::Metre, &bytes).unwrap();
        assert!(sheet.check(Units::Inch, &bytes).is_err(), "another unit");
        let text = String::from_utf8(bytes).unwrap();
        assert!(text.contains("Dach \\U+00FC r0-c1"), "lettering is ASCII");
        for (from, to) in [
            ("r0-c1", "r0-c2"),
            ("LABEL\n100\nAcDbText", "CUT\n100\nAcDbText"),
            ("\n2.0\n 20\n1.0\n", "\n2.0\n 20\n1.1\n"),
        ] {
            assert!(text.contains(from), "{from}");
            assert!(sheet.check(Units::Metre, text.replace(from, to).as_bytes()).is_err(), "{from} became {to}");
        }
    }

    #[test]
    fn an_empty_sheet_is_a_file_too() {
        let sheet = Sheet { layers: vec!["CUT"], ..Sheet::default() };
        sheet.check(Units::Foot, &sheet.write(Units::Foot)).unwrap();
    }
}
