//! The colours of a model's objects, the same in every format that has colours.

/// Colours of the objects in turn, red, green and blue of a screen.
const OBJECTS: [u32; 6] = [0x1B2A41, 0x0B6E6E, 0x7A2E52, 0x3A5A98, 0x5B6B1F, 0x6B4A2B];
/// How much of a surface's colour is pale grey, in linear light: shading needs room for light and dark.
const PALE: f64 = 0.62;
const GREY: f64 = 0.86;

/// The colour of an object.
pub(crate) const fn object(index: usize) -> u32 {
    OBJECTS[index % OBJECTS.len()]
}

/// The colour of an object's curves in linear light.
pub(crate) fn linear(index: usize) -> [f64; 3] {
    [16, 8, 0].map(|shift| {
        let v = f64::from(object(index) >> shift & 0xFF) / 255.0;
        // IEC 61966-2-1.
        if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
    })
}

/// The colour of an object's surfaces in linear light.
pub(crate) fn surface(index: usize) -> [f64; 3] {
    linear(index).map(|v| v + (GREY - v) * PALE)
}
