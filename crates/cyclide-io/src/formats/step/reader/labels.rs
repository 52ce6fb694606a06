//! What a STEP file says besides its geometry: names, layers, products and the unit of lengths.

use super::{File, Value, entity, enumeration, number_of, reference, references, text, value};
use crate::check::labels::{FileLabels, FileName};
use crate::check::read_error::ReadError;
use crate::formats::step::conversion;
use crate::formats::step::labels::{ASSEMBLY, BODY, CURVE, LAYER, OCCURRENCE, PRODUCT, SET};
use cyclide::model::Units;
use std::collections::HashMap;

/// The instances that carry labels, in file order.
#[derive(Default)]
pub(super) struct Labeled {
    /// Assignments of items to layers.
    layers: Vec<u64>,
    /// Products with their shapes.
    shapes: Vec<u64>,
    /// Products in a product.
    occurrences: Vec<u64>,
    /// Places of products in a product.
    places: Vec<u64>,
}

impl Labeled {
    /// Notes an instance by its first name.
    pub(super) fn visit(&mut self, number: u64, name: &str) {
        match name {
            "PRESENTATION_LAYER_ASSIGNMENT" => self.layers.push(number),
            "SHAPE_DEFINITION_REPRESENTATION" => self.shapes.push(number),
            "NEXT_ASSEMBLY_USAGE_OCCURRENCE" => self.occurrences.push(number),
            "ITEM_DEFINED_TRANSFORMATION" => self.places.push(number),
            _ => {}
        }
    }
}

impl File<'_> {
    /// The labels of a file with these curve sets and bodies.
    pub(super) fn labels(&self, found: &Labeled, sets: &[u64], bodies: &[u64]) -> Result<FileLabels, ReadError> {
        let mut labels = FileLabels::default();
        let mut layer_of: HashMap<u64, &str> = HashMap::new();
        for &number in &found.layers {
            let place = format!("#{number}");
            let values = self.simple(number, "PRESENTATION_LAYER_ASSIGNMENT")?;
            let name = text(value(&values, 0, &place)?, &place)?;
            layer_of.extend(references(value(&values, 2, &place)?, &place)?.into_iter().map(|item| (item, name)));
        }
        let mut product_of: HashMap<u64, &str> = HashMap::new();
        for &number in &found.shapes {
            let place = format!("#{number}");
            let values = self.simple(number, "SHAPE_DEFINITION_REPRESENTATION")?;
            let definition =
                self.part(reference(value(&values, 0, &place)?, &place)?, "PRODUCT_DEFINITION_SHAPE", 2)?;
            let product = self.product(definition)?;
            let shape = reference(value(&values, 1, &place)?, &place)?;
            let place = format!("#{shape}");
            let shape = self.instance(shape)?;
            let values = shape.first().map_or(&[][..], |entity| entity.1.as_slice());
            let items = references(value(values, 1, &place)?, &place)?;
            product_of.extend(items.into_iter().map(|item| (item, product)));
            let unit = self.unit(reference(value(values, 2, &place)?, &place)?)?;
            if labels.unit.get_or_insert(unit).to_bits() != unit.to_bits() {
                return Err(ReadError::unsupported("a shape whose unit differs from that of the first one", place));
            }
        }
        let mut item = |number: u64, of: &'static str, index: usize, count: usize| -> Result<(), ReadError> {
            let place = format!("#{number}");
            let instance = self.instance(number)?;
            let values = instance.first().map_or(&[][..], |entity| entity.1.as_slice());
            labels.names.push(FileName::new(of, text(value(values, index, &place)?, &place)?, count));
            for (of, names) in [(LAYER, &layer_of), (PRODUCT, &product_of)] {
                labels.names.extend(names.get(&number).map(|name| FileName::new(of, *name, 1)));
            }
            Ok(())
        };
        for &set in sets {
            let place = format!("#{set}");
            let values = self.simple(set, "GEOMETRIC_CURVE_SET")?;
            let curves = references(value(&values, 1, &place)?, &place)?;
            item(set, SET, 0, curves.len())?;
        }
        for &body in bodies {
            item(body, BODY, 0, 1)?;
        }
        for &set in sets {
            let place = format!("#{set}");
            for curve in references(value(&self.simple(set, "GEOMETRIC_CURVE_SET")?, 1, &place)?, &place)? {
                labels.names.push(FileName::new(CURVE, self.name_of(curve, "COMPOSITE_CURVE")?, 1));
            }
        }
        self.assembly(found, &mut labels)?;
        Ok(labels)
    }

    /// The products in a product, each where it stands.
    fn assembly(&self, found: &Labeled, labels: &mut FileLabels) -> Result<(), ReadError> {
        for &number in &found.occurrences {
            let place = format!("#{number}");
            let values = self.simple(number, "NEXT_ASSEMBLY_USAGE_OCCURRENCE")?;
            let definition = |i: usize| self.product(reference(value(&values, i, &place)?, &place)?);
            let name = text(value(&values, 1, &place)?, &place)?;
            let names = [(OCCURRENCE, name), (ASSEMBLY, definition(3)?), (PRODUCT, definition(4)?)];
            labels.names.extend(names.map(|(of, name)| FileName::new(of, name, 1)));
        }
        for &number in &found.places {
            let place = format!("#{number}");
            let values = self.simple(number, "ITEM_DEFINED_TRANSFORMATION")?;
            if value(&values, 2, &place)? != value(&values, 3, &place)? {
                return Err(ReadError::unsupported("a product that is placed with a transformation", place));
            }
        }
        Ok(())
    }

    /// What a parameter of an instance refers to.
    fn part(&self, number: u64, name: &str, index: usize) -> Result<u64, ReadError> {
        let place = format!("#{number}");
        reference(value(&self.simple(number, name)?, index, &place)?, &place)
    }

    /// The first parameter of an instance, its name.
    fn name_of(&self, number: u64, name: &str) -> Result<&str, ReadError> {
        let place = format!("#{number}");
        text(value(&self.simple(number, name)?, 0, &place)?, &place)
    }

    /// The name of the product of a definition; its number is the same text.
    fn product(&self, definition: u64) -> Result<&str, ReadError> {
        let formation = self.part(definition, "PRODUCT_DEFINITION", 2)?;
        let product = self.part(formation, "PRODUCT_DEFINITION_FORMATION", 2)?;
        let place = format!("#{product}");
        let values = self.simple(product, "PRODUCT")?;
        let name = text(value(&values, 1, &place)?, &place)?;
        if text(value(&values, 0, &place)?, &place)? != name {
            return Err(ReadError::unsupported("a product whose number differs from its name", place));
        }
        Ok(name)
    }

    /// Length of the unit of a context, millimeters; angles are in radians.
    fn unit(&self, context: u64) -> Result<f64, ReadError> {
        let place = format!("#{context}");
        let instance = self.instance(context)?;
        let units = value(entity(&instance, "GLOBAL_UNIT_ASSIGNED_CONTEXT", &place)?, 0, &place)?;
        let mut length = None;
        for unit in references(units, &place)? {
            let place = format!("#{unit}");
            let instance = self.instance(unit)?;
            let is = |name: &str| instance.iter().any(|entity| entity.0 == name);
            if is("LENGTH_UNIT") {
                length = Some(self.length_unit(unit)?);
            } else if is("PLANE_ANGLE_UNIT") {
                let name = value(entity(&instance, "SI_UNIT", &place)?, 1, &place)?;
                if enumeration(name, &place)? != "RADIAN" {
                    return Err(ReadError::unsupported("angles not in radians", place));
                }
            }
        }
        length.ok_or_else(|| ReadError::syntax(place, "a context without a length unit"))
    }

    /// A metric unit, or one that is said in a metric one.
    fn length_unit(&self, number: u64) -> Result<f64, ReadError> {
        let place = format!("#{number}");
        let instance = self.instance(number)?;
        if let Ok(metric) = entity(&instance, "SI_UNIT", &place) {
            let name = enumeration(value(metric, 1, &place)?, &place)?;
            let prefix = value(metric, 0, &place)?;
            let prefix = enumeration(prefix, &place).unwrap_or("");
            return match (prefix, name) {
                ("", "METRE") => Ok(1000.0),
                ("CENTI", "METRE") => Ok(10.0),
                ("MILLI", "METRE") => Ok(1.0),
                _ => Err(ReadError::unsupported(format!("the unit {prefix} {name}"), place)),
            };
        }
        let values = entity(&instance, "CONVERSION_BASED_UNIT", &place)?;
        let name = text(value(values, 0, &place)?, &place)?;
        let factor = reference(value(values, 1, &place)?, &place)?;
        let place = format!("#{factor}");
        let values = self.simple(factor, "LENGTH_MEASURE_WITH_UNIT")?;
        let Value::Typed("LENGTH_MEASURE", measure) = value(&values, 0, &place)? else {
            return Err(ReadError::syntax(place, "expected a LENGTH_MEASURE"));
        };
        let factor = number_of(value(measure, 0, &place)?, &place)?;
        let metric = reference(value(&values, 1, &place)?, &place)?;
        // One more step at most: a chain of units would not end.
        let instance = self.instance(metric)?;
        entity(&instance, "SI_UNIT", &place)?;
        let unit = factor * self.length_unit(metric)?;
        let known = Units::ALL.into_iter().find(|unit| conversion(*unit) == Some(name));
        match known {
            Some(known) if (known.in_millimetres() - unit).abs() <= 1e-9 * unit => Ok(unit),
            _ => Err(ReadError::unsupported(format!("the unit {name} of {unit} mm"), place)),
        }
    }
}
