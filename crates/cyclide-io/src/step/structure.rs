//! Header, product structure and units: without them nothing is imported.

use super::conversion;
use super::data::{Data, real, references, string};
use cyclide::{Point3, Units, Vec3};

/// The whole file around the instances.
pub(super) fn file(data: &Data, title: &str) -> String {
    let name = string(&format!("{title}.step"));
    let instances = data.text();
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n\
         FILE_NAME({name},'1970-01-01T00:00:00',(''),(''),'cyclide','cyclide','');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 3 1 1 }}'));\nENDSEC;\nDATA;\n\
         {instances}ENDSEC;\nEND-ISO-10303-21;\n"
    )
}

/// The product with the curve sets as its shape.
pub(super) fn product(data: &mut Data, title: &str, sets: &[usize], units: Units) {
    let context = representation_context(data, units);
    let origin = data.placement(Point3::ORIGIN, Vec3::Z, Vec3::X);
    let name = string(title);
    let items: Vec<usize> = std::iter::once(origin).chain(sets.iter().copied()).collect();
    let shape = data.add(&format!(
        "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION({name},{},#{context})",
        references(&items)
    ));
    let application = data.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
    data.add(&format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{application})"
    ));
    let product_context = data.add(&format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
    let product = data.add(&format!("PRODUCT({name},{name},'',(#{product_context}))"));
    data.add(&format!("PRODUCT_RELATED_PRODUCT_CATEGORY('part','',(#{product}))"));
    let formation = data.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
    let definition_context =
        data.add(&format!("PRODUCT_DEFINITION_CONTEXT('part definition',#{application},'design')"));
    let definition = data.add(&format!("PRODUCT_DEFINITION('design','',#{formation},#{definition_context})"));
    let definition_shape = data.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
    data.add(&format!("SHAPE_DEFINITION_REPRESENTATION(#{definition_shape},#{shape})"));
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
        Units::Millimetre | Units::Inch | Units::Foot => ".MILLI.",
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
