//! Colors and layers: each object in the colors of the pictures, on a layer of its own name.

use super::data::{Data, real, references, string};
use super::part::Part;
use crate::drawing::palette;
use std::collections::HashMap;

/// Width of curves in file units; readers draw by their own settings.
const CURVE_WIDTH: f64 = 0.1;

/// Styles all items of the parts and puts each part on its layer.
pub(super) fn colours_and_layers(data: &mut Data, parts: &[Part], context: usize) {
    let mut styles = Styles::default();
    let mut styled = Vec::new();
    for part in parts {
        for &item in part.solids.iter().chain(&part.surfaces) {
            let style = styles.surface(data, palette::surface_on_screen(part.index));
            styled.push(data.add(&format!("STYLED_ITEM('color',(#{style}),#{item})")));
        }
        for &item in &part.curve_sets {
            let style = styles.curve(data, palette::object(part.index));
            styled.push(data.add(&format!("STYLED_ITEM('color',(#{style}),#{item})")));
        }
        let (name, items) = (string(&part.name), references(&part.items()));
        data.add(&format!("PRESENTATION_LAYER_ASSIGNMENT({name},'',{items})"));
    }
    let styled = references(&styled);
    data.add(&format!("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',{styled},#{context})"));
}

/// Style assignments by their color, red, green and blue of a screen.
#[derive(Default)]
struct Styles {
    surfaces: HashMap<u32, usize>,
    curves: HashMap<u32, usize>,
    font: Option<usize>,
}

impl Styles {
    fn surface(&mut self, data: &mut Data, rgb: u32) -> usize {
        *self.surfaces.entry(rgb).or_insert_with(|| {
            let colour = colour(data, rgb);
            let fill = data.add(&format!("FILL_AREA_STYLE_COLOUR('',#{colour})"));
            let fill = data.add(&format!("FILL_AREA_STYLE('',(#{fill}))"));
            let fill = data.add(&format!("SURFACE_STYLE_FILL_AREA(#{fill})"));
            let side = data.add(&format!("SURFACE_SIDE_STYLE('',(#{fill}))"));
            let usage = data.add(&format!("SURFACE_STYLE_USAGE(.BOTH.,#{side})"));
            data.add(&format!("PRESENTATION_STYLE_ASSIGNMENT((#{usage}))"))
        })
    }

    fn curve(&mut self, data: &mut Data, rgb: u32) -> usize {
        if let Some(&style) = self.curves.get(&rgb) {
            return style;
        }
        let font = *self.font.get_or_insert_with(|| data.add("DRAUGHTING_PRE_DEFINED_CURVE_FONT('continuous')"));
        let (colour, width) = (colour(data, rgb), real(CURVE_WIDTH));
        let style = data.add(&format!("CURVE_STYLE('',#{font},POSITIVE_LENGTH_MEASURE({width}),#{colour})"));
        let style = data.add(&format!("PRESENTATION_STYLE_ASSIGNMENT((#{style}))"));
        self.curves.insert(rgb, style);
        style
    }
}

fn colour(data: &mut Data, rgb: u32) -> usize {
    let [r, g, b] = [16, 8, 0].map(|shift| real(f64::from(rgb >> shift & 0xFF) / 255.0));
    data.add(&format!("COLOUR_RGB('',{r},{g},{b})"))
}
