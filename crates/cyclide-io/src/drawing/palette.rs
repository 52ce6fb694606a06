//! The colors of a model's objects, the same in every format that has colors.

/// Colors of the objects in turn, red, green and blue of a screen.
const OBJECTS: [u32; 6] = [0x1B2A41, 0x0B6E6E, 0x7A2E52, 0x3A5A98, 0x5B6B1F, 0x6B4A2B];
/// Colors of their surfaces: pale, so that shading has room and lines in the object's own color stand out.
const SURFACES: [u32; 6] = [0xC3D3E6, 0xB4DAD4, 0xE2C8D3, 0xC3CEE9, 0xD5D9BE, 0xE3D5C3];

/// Colors of the surfaces inside blocks on which s, t and u are constant: apart also for eyes that miss red or green.
#[cfg(feature = "png")]
const FAMILIES: [u32; 3] = [0xB6CCF0, 0xF6DAAE, 0xB2DEC6];
/// Colors of their lines.
#[cfg(feature = "png")]
const FAMILY_LINES: [u32; 3] = [0x1F3F73, 0x7A4A12, 0x14583F];

/// The color of the surfaces inside blocks on which parameter `axis` is constant, and of their lines.
#[cfg(feature = "png")]
pub(crate) const fn family(axis: usize) -> [u32; 2] {
    [FAMILIES[axis % 3], FAMILY_LINES[axis % 3]]
}

/// The color of an object.
pub(crate) const fn object(index: usize) -> u32 {
    OBJECTS[index % OBJECTS.len()]
}

/// The color of an object's surfaces.
pub(crate) const fn surface_on_screen(index: usize) -> u32 {
    SURFACES[index % SURFACES.len()]
}

#[cfg(feature = "png")]
/// The color of an object's curves in linear light.
pub(crate) fn linear(index: usize) -> [f64; 3] {
    to_linear(object(index))
}

#[cfg(feature = "png")]
/// The color of an object's surfaces in linear light.
pub(crate) fn surface(index: usize) -> [f64; 3] {
    to_linear(surface_on_screen(index))
}

/// Linear light of a color of the screen.
pub(crate) fn to_linear(rgb: u32) -> [f64; 3] {
    [16, 8, 0].map(|shift| {
        let v = f64::from(rgb >> shift & 0xFF) / 255.0;
        // IEC 61966-2-1.
        if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
    })
}

/// The color of the screen that is nearest to linear light.
pub(crate) fn on_screen(linear: [f64; 3]) -> u32 {
    linear.into_iter().fold(0, |rgb, v| {
        let v = if v <= 0.04045 / 12.92 { v * 12.92 } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
        // A float becomes the nearest integer that there is.
        (rgb << 8) | (v * 255.0).round().clamp(0.0, 255.0) as u32
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_come_back_from_linear_light() {
        for grey in 0..256 {
            let rgb = (grey << 16) | ((255 - grey) << 8) | (grey / 2);
            assert_eq!(on_screen(to_linear(rgb)), rgb);
        }
        assert_eq!(on_screen([f64::NAN, 2.0, -1.0]), 0x00FF00);
    }
}
