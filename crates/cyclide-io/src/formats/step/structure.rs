//! Header, product structure and units: without them nothing is imported.
//!
//! A product has one representation of its shape. Several objects are an assembly: a product without shape of its own,
//! in which each object occurs once where it stands, so that readers show the objects by their names; or one product
//! of all items.

use super::conversion;
use super::data::{Data, fold, real, references, string};
use super::part::Part;
use super::styles;
use cyclide::{Point3, Vec3, model::Units};

/// The whole file around the instances, in whose text it is put.
pub(super) fn file(data: Data, title: &str) -> String {
    let name = string(&format!("{title}.step"));
    let mut header = String::from("ISO-10303-21;\nHEADER;\n");
    for entry in [
        "FILE_DESCRIPTION(('Curves and surfaces made of circles, exact'),'2;1')".to_owned(),
        format!("FILE_NAME({name},'1970-01-01T00:00:00',(''),(''),'cyclide','cyclide','')"),
        "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 3 1 1 }'))".to_owned(),
    ] {
        let start = header.len();
        header.push_str(&entry);
        header.push_str(";\n");
        fold(&mut header, start);
    }
    header.push_str("ENDSEC;\nDATA;\n");
    let mut text = data.into_text();
    text.insert_str(0, &header);
    text.push_str("ENDSEC;\nEND-ISO-10303-21;\n");
    text
}

/// The representation that holds things of one kind only, or the general one for a mixture: representations of one kind
/// each, related to each other, make FreeCAD 0.20 crash.
fn representation(parts: &[Part]) -> &'static str {
    let none = |items: fn(&Part) -> &[usize]| parts.iter().all(|part| items(part).is_empty());
    match (none(|p| &p.solids), none(|p| &p.surfaces), none(|p| &p.curve_sets)) {
        (false, true, true) => "ADVANCED_BREP_SHAPE_REPRESENTATION",
        (true, false, true) => "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
        (true, true, false) => "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION",
        _ => "SHAPE_REPRESENTATION",
    }
}

/// The products of all parts, or one product of them, colors and layers; `title` names the whole.
pub(super) fn products(data: &mut Data, title: &str, parts: &[Part], one: bool, units: Units) {
    let context = representation_context(data, units);
    let origin = data.placement(Point3::ORIGIN, Vec3::Z, Vec3::X);
    let mut products = Products::new(data);
    let mut occurrences = Vec::new();
    for own in parts.chunks(if one { parts.len().max(1) } else { 1 }) {
        let name = string(if one { title } else { &own[0].name });
        let items = std::iter::once(origin).chain(own.iter().flat_map(Part::items)).collect::<Vec<_>>();
        let kind = representation(own);
        let shape = data.add(&format!("{kind}({name},{},#{context})", references(&items)));
        let definition = products.add(data, &name, shape);
        occurrences.push((name, definition, shape));
    }
    if !one {
        let name = string(title);
        let whole = data.add(&format!("SHAPE_REPRESENTATION({name},(#{origin}),#{context})"));
        let definition = products.add(data, &name, whole);
        let place = data.add(&format!("ITEM_DEFINED_TRANSFORMATION('','',#{origin},#{origin})"));
        for (index, (name, part, shape)) in occurrences.iter().enumerate() {
            let id = index + 1;
            let usage = data.add(&format!("NEXT_ASSEMBLY_USAGE_OCCURRENCE('{id}',{name},'',#{definition},#{part},$)"));
            let placed = data.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{usage})"));
            let relation = data.add(&format!(
                "(REPRESENTATION_RELATIONSHIP('','',#{shape},#{whole}) \
                 REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{place}) SHAPE_REPRESENTATION_RELATIONSHIP())"
            ));
            data.add(&format!("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{relation},#{placed})"));
        }
    }
    data.add(&format!("PRODUCT_RELATED_PRODUCT_CATEGORY('part','',{})", references(&products.all)));
    styles::colours_and_layers(data, parts, context);
}

/// The contexts that all products share, and the products so far.
struct Products {
    product_context: usize,
    definition_context: usize,
    all: Vec<usize>,
}

impl Products {
    fn new(data: &mut Data) -> Self {
        let application = data.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        data.add(&format!(
            "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{application})"
        ));
        let product_context = data.add(&format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
        let definition_context =
            data.add(&format!("PRODUCT_DEFINITION_CONTEXT('part definition',#{application},'design')"));
        Self { product_context, definition_context, all: Vec::new() }
    }

    /// A product with its shape; returns its definition.
    fn add(&mut self, data: &mut Data, name: &str, shape: usize) -> usize {
        let (product_context, definition_context) = (self.product_context, self.definition_context);
        let product = data.add(&format!("PRODUCT({name},{name},'',(#{product_context}))"));
        let formation = data.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
        let definition = data.add(&format!("PRODUCT_DEFINITION('design','',#{formation},#{definition_context})"));
        let definition_shape = data.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
        data.add(&format!("SHAPE_DEFINITION_REPRESENTATION(#{definition_shape},#{shape})"));
        self.all.push(product);
        definition
    }
}

/// Units (radians for angles) and the uncertainty, in file units.
fn representation_context(data: &mut Data, units: Units) -> usize {
    let length = length_unit(data, units);
    let angle = data.add("(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))");
    let solid = data.add("(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())");
    let uncertainty = data.add(&format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),#{length},'distance_accuracy_value','confusion accuracy')",
        real(1e-7)
    ));
    data.add(&format!(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{uncertainty})) \
         GLOBAL_UNIT_ASSIGNED_CONTEXT((#{length},#{angle},#{solid})) REPRESENTATION_CONTEXT('',''))"
    ))
}

fn length_unit(data: &mut Data, units: Units) -> usize {
    let prefix = match units {
        Units::Metre => "$",
        Units::Centimetre => ".CENTI.",
        Units::Millimetre | Units::Inch | Units::Foot | Units::UsSurveyFoot => ".MILLI.",
    };
    let metric = data.add(&format!("(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT({prefix},.METRE.))"));
    let Some(name) = conversion(units) else {
        return metric;
    };
    let factor =
        data.add(&format!("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),#{metric})", real(units.in_millimetres())));
    let exponents = data.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
    data.add(&format!("(CONVERSION_BASED_UNIT('{name}',#{factor}) LENGTH_UNIT() NAMED_UNIT(#{exponents}))"))
}
