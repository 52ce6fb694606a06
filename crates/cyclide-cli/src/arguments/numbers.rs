//! Numbers of options, refused out of their range while the arguments are read.

/// A positive, finite number.
pub fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        Ok(_) => Err("must be positive and finite".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

/// A positive number of degrees, at most 180.
pub fn up_to_half_a_turn(text: &str) -> Result<f64, String> {
    match positive(text) {
        Ok(value) if value > 180.0 => Err("must be at most 180 degrees".to_owned()),
        other => other,
    }
}
