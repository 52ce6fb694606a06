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

/// What the product's shape consists of, by the representation that each kind belongs to.
#[derive(Default)]
pub(super) struct Items {
    pub(super) curve_sets: Vec<usize>,
    pub(super) surfaces: Vec<usize>,
    pub(super) solids: Vec<usize>,
}

/// The product with its shape. Things of one kind are one representation; a mixture is an empty representation to
/// which one of each kind is related, since no kind may hold the things of another.
pub(super) fn product(data: &mut Data, title: &str, items: &Items, units: Units) {
    let context = representation_context(data, units);
    let origin = data.placement(Point3::ORIGIN, Vec3::Z, Vec3::X);
    let name = string(title);
    let mut representation = |kind: &str, items: &[usize]| {
        let items: Vec<usize> = std::iter::once(origin).chain(items.iter().copied()).collect();
        data.add(&format!("{kind}({name},{},#{context})", references(&items)))
    };
    let kinds = [
        ("ADVANCED_BREP_SHAPE_REPRESENTATION", &items.solids),
        ("MANIFOLD_SURFACE_SHAPE_REPRESENTATION", &items.surfaces),
        ("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION", &items.curve_sets),
    ];
    let parts: Vec<usize> =
        kinds.iter().filter(|k| !k.1.is_empty()).map(|(kind, items)| representation(kind, items)).collect();
    let shape = match parts[..] {
        [only] => only,
        _ => {
            let whole = representation("SHAPE_REPRESENTATION", &[]);
            for part in parts {
                data.add(&format!("SHAPE_REPRESENTATION_RELATIONSHIP('','',#{whole},#{part})"));
            }
            whole
        }
    };
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
