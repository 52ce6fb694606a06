//! Curves that bend to and fro more often than their data: one rule for every kind.

use cyclide::{CurveObject, Point3, RoundedTurns, Warning, WaverRemedy, Wavering, wavering, wavering_against};

use crate::document::spec::ObjectSpec;

/// What a curve is held against.
enum Data {
    /// The nodes at which its pieces meet: it passes through all of them.
    Nodes,
    /// Its points, through which it passes.
    Points,
    /// Points within a tolerance.
    Fitted,
    /// Points of it, one per control point.
    ControlPoints,
}

/// Warns of a curve that bends to and fro between its data, of data that do, and of corners that it goes round. Curves that
/// are given by their shape, as lines with rounded corners, say what they are.
pub(super) fn wavers(spec: &ObjectSpec, curve: &CurveObject, points: &[Point3]) -> Vec<Warning> {
    let (data, remedy) = match spec {
        ObjectSpec::CircleSpline(_) | ObjectSpec::MoebiusSpline(_) => (Data::Nodes, WaverRemedy::FairSpline),
        ObjectSpec::FairSpline(_) | ObjectSpec::TorusSpline(_) => (Data::Nodes, WaverRemedy::Points),
        ObjectSpec::ArcSpline(_) | ObjectSpec::QbInterpolation(_) => (Data::Points, WaverRemedy::FairSpline),
        ObjectSpec::ArcFit(_) | ObjectSpec::FairFit(_) => (Data::Fitted, WaverRemedy::Tolerance),
        ObjectSpec::Nurbs(_) => (Data::ControlPoints, WaverRemedy::Source),
        _ => return Vec::new(),
    };
    let shape = curve.as_curve();
    let found = match (&data, curve) {
        (Data::Nodes, _) => wavering(shape),
        (Data::ControlPoints, CurveObject::Nurbs(nurbs)) => wavering_against(shape, &nurbs.greville_points()),
        _ => wavering_against(shape, points),
    };
    let Wavering { curve, data: of_data, explained, nodes, .. } = found;
    let wavers = found.curve_wavers.then_some(Warning::Wavers { curve, data: of_data, explained, remedy });
    // A fit does not pass through its points, and a spline on a torus may wind.
    let through = !matches!(data, Data::Fitted) && !matches!(spec, ObjectSpec::TorusSpline(_));
    let data_waver = || (through && found.data_waver).then_some(Warning::DataWaver { changes: of_data, nodes });
    let corner = |RoundedTurns { first, count, angle, distance, .. }| Warning::CornerNotMarked {
        node: first,
        count,
        angle,
        distance,
    };
    let rounded = found.rounded.filter(|_| matches!(spec, ObjectSpec::FairSpline(_) | ObjectSpec::CircleSpline(_)));
    wavers.or_else(data_waver).into_iter().chain(rounded.map(corner)).collect()
}
