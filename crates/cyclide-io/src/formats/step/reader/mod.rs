//! Our own STEP files back from the bytes, evaluated as a reader would: from circle, placement and parameters.

mod labels;
mod shapes;

use super::part21::{Instance, Instances, Value, parse};
use crate::check::file_content::FileContent;
use crate::check::read_error::ReadError;
use cyclide::{
    Point3, Vec3,
    curve::{Arc, Circle},
    model::{ChainPiece, CurveChain},
    rational::NurbsCurve,
};

/// Gap allowed between the pieces of a composite curve, relative to its largest coordinate or radius: the rounding
/// of center plus radius.
const GAP: f64 = 1e-9;

/// Reads the composite curves of all curve sets and all bodies, in file order.
pub(crate) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let (mut sets, mut bodies, mut labeled) = (Vec::new(), Vec::new(), labels::Labeled::default());
    let instances = parse(bytes, |number, name| {
        if name == "GEOMETRIC_CURVE_SET" {
            sets.push(number);
        } else if shapes::is_body(name) {
            bodies.push(number);
        } else {
            labeled.visit(number, name);
        }
    })?;
    let file = File { instances };
    let mut curves = Vec::new();
    for &number in &sets {
        let place = format!("#{number}");
        let values = file.simple(number, "GEOMETRIC_CURVE_SET")?;
        for curve in references(value(&values, 1, &place)?, &place)? {
            curves.push(file.composite(curve)?);
        }
    }
    let labels = file.labels(&labeled, &sets, &bodies)?;
    let bodies = bodies.into_iter().map(|number| file.body(number)).collect::<Result<_, _>>()?;
    Ok(FileContent { curves, bodies, labels, ..FileContent::default() })
}

struct File<'a> {
    instances: Instances<'a>,
}

/// A conic or line before trimming.
enum Basis {
    Line { origin: Point3, direction: Vec3 },
    Circle { center: Point3, z: Vec3, x: Vec3, radius: f64 },
}

impl<'a> File<'a> {
    fn instance(&self, number: u64) -> Result<Instance<'a>, ReadError> {
        self.instances.get(number).ok_or_else(|| ReadError::syntax(format!("#{number}"), "no such instance"))
    }

    /// The parameters of a simple instance of the given type.
    fn simple(&self, number: u64, name: &str) -> Result<Vec<Value<'a>>, ReadError> {
        let mut instance = self.instance(number)?;
        match instance.pop() {
            Some((found, values)) if found == name && instance.is_empty() => Ok(values),
            last => {
                let found: Vec<&str> = instance.iter().chain(&last).map(|e| e.0).collect();
                Err(ReadError::unsupported(found.join(" "), format!("#{number} (expected {name})")))
            }
        }
    }

    fn triple(&self, number: u64, name: &str) -> Result<[f64; 3], ReadError> {
        let place = format!("#{number}");
        let values = self.simple(number, name)?;
        let numbers = numbers(value(&values, 1, &place)?, &place)?;
        <[f64; 3]>::try_from(numbers).map_err(|_| ReadError::syntax(place, "expected three numbers"))
    }

    fn point(&self, number: u64) -> Result<Point3, ReadError> {
        Ok(self.triple(number, "CARTESIAN_POINT")?.into())
    }

    fn direction(&self, number: u64) -> Result<Vec3, ReadError> {
        let v: Vec3 = self.triple(number, "DIRECTION")?.into();
        v.unit().ok_or_else(|| ReadError::syntax(format!("#{number}"), "a direction is the zero vector"))
    }

    fn composite(&self, number: u64) -> Result<CurveChain, ReadError> {
        let place = format!("#{number}");
        let segments = references(value(&self.simple(number, "COMPOSITE_CURVE")?, 1, &place)?, &place)?;
        let mut pieces = Vec::new();
        let mut closed = true;
        for segment in segments {
            let values = self.simple(segment, "COMPOSITE_CURVE_SEGMENT")?;
            let place = format!("#{segment}");
            closed = enumeration(value(&values, 0, &place)?, &place)? == "CONTINUOUS";
            pieces.extend(self.bounded(reference(value(&values, 2, &place)?, &place)?)?);
        }
        let size = pieces.iter().map(extent).fold(0.0, f64::max);
        CurveChain::new(pieces, closed, GAP * size).map_err(|source| ReadError::Geometry { place, source })
    }

    fn bounded(&self, number: u64) -> Result<Vec<ChainPiece>, ReadError> {
        let place = format!("#{number}");
        let fail = |source| ReadError::Geometry { place: place.clone(), source };
        let instance = self.instance(number)?;
        if instance.len() > 1 {
            return Ok(vec![ChainPiece::Spline(self.b_spline(&instance, number)?)]);
        }
        if self.simple(number, "CIRCLE").is_ok() {
            let Basis::Circle { center, z, x, radius } = self.basis(number)? else {
                return Ok(Vec::new());
            };
            let circle = Circle::from_center(center, z, center + x * radius).map_err(fail)?;
            return Ok(circle.to_arcs().map(ChainPiece::Arc).to_vec());
        }
        let values = self.simple(number, "TRIMMED_CURVE")?;
        let basis = self.basis(reference(value(&values, 1, &place)?, &place)?)?;
        let (u0, u1) = (trim(value(&values, 2, &place)?, &place)?, trim(value(&values, 3, &place)?, &place)?);
        let arc = match basis {
            Basis::Line { origin, direction } => Arc::segment(origin + direction * u0, origin + direction * u1),
            Basis::Circle { center, z, x, radius } => {
                let (sin, cos) = u0.sin_cos();
                let start = center + (x * cos + z.cross(x) * sin) * radius;
                Arc::from_center(center, z, start, u1 - u0)
            }
        };
        Ok(vec![ChainPiece::Arc(arc.map_err(fail)?)])
    }

    fn basis(&self, number: u64) -> Result<Basis, ReadError> {
        let place = format!("#{number}");
        if let Ok(values) = self.simple(number, "LINE") {
            let origin = self.point(reference(value(&values, 1, &place)?, &place)?)?;
            let vector = reference(value(&values, 2, &place)?, &place)?;
            let vector = self.simple(vector, "VECTOR")?;
            let direction = self.direction(reference(value(&vector, 1, &place)?, &place)?)?;
            return Ok(Basis::Line { origin, direction });
        }
        let values = self.simple(number, "CIRCLE")?;
        let radius = number_of(value(&values, 2, &place)?, &place)?;
        let (center, z, x) = self.placement(reference(value(&values, 1, &place)?, &place)?)?;
        Ok(Basis::Circle { center, z, x, radius })
    }

    /// Origin, third axis and first axis.
    fn placement(&self, number: u64) -> Result<(Point3, Vec3, Vec3), ReadError> {
        let place = format!("#{number}");
        let placement = self.simple(number, "AXIS2_PLACEMENT_3D")?;
        let part = |i: usize| reference(value(&placement, i, &place)?, &place);
        Ok((self.point(part(1)?)?, self.direction(part(2)?)?, self.direction(part(3)?)?))
    }

    /// A spline in space, or in the parameters of a surface (the third coordinate is 0); weights are 1 unless they stand
    /// beside.
    fn b_spline(&self, instance: &Instance<'_>, number: u64) -> Result<NurbsCurve, ReadError> {
        let place = format!("#{number}");
        let (curve, knots, weights) = match instance.as_slice() {
            [("B_SPLINE_CURVE_WITH_KNOTS", values)] => {
                (values.get(1..6).unwrap_or(&[]), values.get(6..).unwrap_or(&[]), None)
            }
            _ => {
                let part = |name: &str| entity(instance, name, &place);
                let weights = numbers(value(part("RATIONAL_B_SPLINE_CURVE")?, 0, &place)?, &place)?;
                (part("B_SPLINE_CURVE")?, part("B_SPLINE_CURVE_WITH_KNOTS")?, Some(weights))
            }
        };
        let degree = number_of(value(curve, 0, &place)?, &place)?;
        let points = references(value(curve, 1, &place)?, &place)?;
        let points = points.into_iter().map(|p| self.any_point(p)).collect::<Result<Vec<_>, _>>()?;
        let weights = weights.unwrap_or_else(|| vec![1.0; points.len()]);
        let multiplicities = numbers(value(knots, 0, &place)?, &place)?;
        let breaks = numbers(value(knots, 1, &place)?, &place)?;
        let most = points.len() as f64 + degree + 1.0;
        let whole = multiplicities.iter().all(|m| (0.0..=most).contains(m));
        if !(degree >= 1.0 && degree < most && whole && multiplicities.iter().sum::<f64>() <= most) {
            return Err(ReadError::syntax(place, "degree, control points and knot multiplicities are inconsistent"));
        }
        let repeated = breaks.iter().zip(&multiplicities).flat_map(|(&k, &m)| std::iter::repeat_n(k, m as usize));
        NurbsCurve::new(degree as usize, repeated.collect(), points, weights)
            .map_err(|source| ReadError::Geometry { place, source })
    }

    /// A point in space, or one of two parameters with 0 beside them.
    fn any_point(&self, number: u64) -> Result<Point3, ReadError> {
        let place = format!("#{number}");
        let coordinates = numbers(value(&self.simple(number, "CARTESIAN_POINT")?, 1, &place)?, &place)?;
        match coordinates[..] {
            [u, v] => Ok(Point3::new(u, v, 0.0)),
            [x, y, z] => Ok(Point3::new(x, y, z)),
            _ => Err(ReadError::syntax(place, "expected two or three numbers")),
        }
    }
}

/// The parameters of one entity of a complex instance.
fn entity<'b, 'a>(instance: &'b Instance<'a>, name: &str, place: &str) -> Result<&'b [Value<'a>], ReadError> {
    let found = instance.iter().find(|e| e.0 == name).map(|e| e.1.as_slice());
    found.ok_or_else(|| ReadError::unsupported(format!("a complex instance without {name}"), place))
}

/// Largest coordinate or radius of a piece.
fn extent(piece: &ChainPiece) -> f64 {
    let ends = piece.start().to_vec().max_abs().max(piece.end().to_vec().max_abs());
    match piece {
        ChainPiece::Arc(arc) => ends.max(arc.radius().unwrap_or(0.0)),
        ChainPiece::Spline(_) => ends,
    }
}

/// The parameter among the trimming values.
fn trim(value: &Value<'_>, place: &str) -> Result<f64, ReadError> {
    let Value::List(values) = value else {
        return Err(ReadError::syntax(place, "expected a list"));
    };
    let parameter = values.iter().find_map(|v| match v {
        Value::Typed("PARAMETER_VALUE", values) => values.first(),
        _ => None,
    });
    number_of(parameter.unwrap_or(&Value::Absent), place)
}

fn value<'b, 'a>(values: &'b [Value<'a>], i: usize, place: &str) -> Result<&'b Value<'a>, ReadError> {
    values.get(i).ok_or_else(|| ReadError::syntax(place, format!("no parameter {i}")))
}

fn reference(value: &Value<'_>, place: &str) -> Result<u64, ReadError> {
    match value {
        Value::Reference(number) => Ok(*number),
        _ => Err(ReadError::syntax(place, "expected a reference")),
    }
}

fn references(value: &Value<'_>, place: &str) -> Result<Vec<u64>, ReadError> {
    match value {
        Value::List(values) => values.iter().map(|v| reference(v, place)).collect(),
        _ => Err(ReadError::syntax(place, "expected a list of references")),
    }
}

fn number_of(value: &Value<'_>, place: &str) -> Result<f64, ReadError> {
    match value {
        Value::Number(number) => Ok(*number),
        _ => Err(ReadError::syntax(place, "expected a number")),
    }
}

fn numbers(value: &Value<'_>, place: &str) -> Result<Vec<f64>, ReadError> {
    match value {
        Value::List(values) => values.iter().map(|v| number_of(v, place)).collect(),
        _ => Err(ReadError::syntax(place, "expected a list of numbers")),
    }
}

fn logical(value: &Value<'_>, place: &str) -> Result<bool, ReadError> {
    match enumeration(value, place)? {
        "T" => Ok(true),
        "F" => Ok(false),
        _ => Err(ReadError::syntax(place, "expected .T. or .F.")),
    }
}

fn list<'b, 'a>(value: &'b Value<'a>, place: &str) -> Result<&'b [Value<'a>], ReadError> {
    match value {
        Value::List(values) => Ok(values),
        _ => Err(ReadError::syntax(place, "expected a list")),
    }
}

fn text<'a>(value: &Value<'a>, place: &str) -> Result<&'a str, ReadError> {
    match value {
        Value::Text(text) => Ok(text),
        _ => Err(ReadError::syntax(place, "expected a text")),
    }
}

fn enumeration<'a>(value: &Value<'a>, place: &str) -> Result<&'a str, ReadError> {
    match value {
        Value::Enumeration(name) => Ok(name),
        _ => Err(ReadError::syntax(place, "expected an enumeration")),
    }
}
