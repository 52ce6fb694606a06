//! One reference case: typed access to its input.

use cyclide::{Point2, Point3, Quat, Vec3};
use serde_json::{Map, Value};

/// Why a case came to no result.
#[derive(Debug)]
pub enum Fault {
    /// The kernel refused the input.
    Refused(cyclide::Error),
    /// The case itself is not as its construct needs it.
    Malformed(String),
}

impl From<cyclide::Error> for Fault {
    fn from(error: cyclide::Error) -> Self {
        Self::Refused(error)
    }
}

/// One case of a reference file.
#[derive(Debug)]
pub struct Case<'a> {
    id: &'a str,
    construct: &'a str,
    input: &'a Map<String, Value>,
    expect: &'a Map<String, Value>,
    rtol: f64,
    scale: Option<f64>,
}

impl<'a> Case<'a> {
    /// Reads the frame of a case.
    ///
    /// # Errors
    /// A sentence naming the member that is missing.
    pub fn new(value: &'a Value) -> Result<Self, String> {
        let text = |name: &str| value[name].as_str().ok_or(format!("no text `{name}`"));
        let object = |name: &str| value[name].as_object().ok_or(format!("no object `{name}`"));
        Ok(Self {
            id: text("id")?,
            construct: text("construct")?,
            input: object("input")?,
            expect: object("expect")?,
            rtol: value["rtol"].as_f64().ok_or("no number `rtol`")?,
            scale: value["scale"].as_f64(),
        })
    }

    /// Identifier, unique in its file.
    #[must_use]
    pub fn id(&self) -> &'a str {
        self.id
    }

    /// Name of the construct.
    #[must_use]
    pub fn construct(&self) -> &'a str {
        self.construct
    }

    /// The expected fields.
    pub(super) fn expect(&self) -> &'a Map<String, Value> {
        self.expect
    }

    /// The reason of the expected refusal.
    pub(super) fn expected_error(&self) -> Option<&'a str> {
        self.expect.get("error").and_then(Value::as_str)
    }

    /// The tolerance of the case.
    pub(super) fn rtol(&self) -> f64 {
        self.rtol
    }

    /// The size that the tolerance refers to, where the case has one.
    pub(super) fn scale(&self) -> Result<f64, Fault> {
        self.scale.ok_or(Fault::Malformed("no number `scale`".into()))
    }

    /// A member of the input.
    pub(super) fn input(&self, name: &str) -> Result<&'a Value, Fault> {
        self.input.get(name).ok_or_else(|| malformed(name))
    }

    pub(super) fn number(&self, name: &str) -> Result<f64, Fault> {
        number(self.input(name)?).ok_or_else(|| malformed(name))
    }

    pub(super) fn count(&self, name: &str) -> Result<u64, Fault> {
        self.input(name)?.as_u64().ok_or_else(|| malformed(name))
    }

    pub(super) fn flag(&self, name: &str) -> Result<bool, Fault> {
        self.input(name)?.as_bool().ok_or_else(|| malformed(name))
    }

    pub(super) fn word(&self, name: &str) -> Result<&'a str, Fault> {
        self.input(name)?.as_str().ok_or_else(|| malformed(name))
    }

    fn array<const N: usize>(&self, name: &str) -> Result<[f64; N], Fault> {
        array(self.input(name)?).ok_or_else(|| malformed(name))
    }

    pub(super) fn point(&self, name: &str) -> Result<Point3, Fault> {
        self.array::<3>(name).map(Point3::from)
    }

    pub(super) fn vector(&self, name: &str) -> Result<Vec3, Fault> {
        self.array::<3>(name).map(Vec3::from)
    }

    pub(super) fn quat(&self, name: &str) -> Result<Quat, Fault> {
        self.array::<4>(name).map(Quat::from)
    }

    /// A list of numbers.
    pub(super) fn numbers(&self, name: &str) -> Result<Vec<f64>, Fault> {
        let list = self.input(name)?.as_array().ok_or_else(|| malformed(name))?;
        list.iter().map(|v| number(v).ok_or_else(|| malformed(name))).collect()
    }

    pub(super) fn quats(&self, name: &str) -> Result<Vec<Quat>, Fault> {
        Ok(self.arrays::<4>(name)?.into_iter().map(Quat::from).collect())
    }

    /// A pair: a point of the plane or a complex number.
    pub(super) fn pair(&self, name: &str) -> Result<[f64; 2], Fault> {
        self.array::<2>(name)
    }

    fn arrays<const N: usize>(&self, name: &str) -> Result<Vec<[f64; N]>, Fault> {
        let list = self.input(name)?.as_array().ok_or_else(|| malformed(name))?;
        list.iter().map(|v| array(v).ok_or_else(|| malformed(name))).collect()
    }

    pub(super) fn points(&self, name: &str) -> Result<Vec<Point3>, Fault> {
        Ok(self.arrays::<3>(name)?.into_iter().map(Point3::from).collect())
    }

    pub(super) fn vectors(&self, name: &str) -> Result<Vec<Vec3>, Fault> {
        Ok(self.arrays::<3>(name)?.into_iter().map(Vec3::from).collect())
    }

    pub(super) fn planar_points(&self, name: &str) -> Result<Vec<Point2>, Fault> {
        Ok(self.arrays::<2>(name)?.into_iter().map(Point2::from).collect())
    }
}

/// A number; those that JSON has not are words.
fn number(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("NaN") => Some(f64::NAN),
        Some("Infinity") => Some(f64::INFINITY),
        Some("-Infinity") => Some(f64::NEG_INFINITY),
        _ => value.as_f64(),
    }
}

pub(super) fn array<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let numbers: Vec<f64> = value.as_array()?.iter().map(number).collect::<Option<_>>()?;
    numbers.try_into().ok()
}

pub(super) fn malformed(name: &str) -> Fault {
    Fault::Malformed(format!("input `{name}` is missing or not of its type"))
}
