//! Colors that show a quantity of a surface: curvatures, and the distance from the surface that was given.
//!
//! Each place is colored by the value there, from the exact jet; the scale holds the values of all of the surfaces, also where they are
//! not seen.

use super::light::Rgb;
use super::surface::{Surface, surfaces};
use crate::drawing::surface_distance::SurfaceDistance;
use crate::drawing::value_scale::ValueScale;
use crate::export::job::Job;
use crate::export::options::PictureColour;
use cyclide::{
    model::Units,
    surface::ParamSurface as _,
    topology::{Body, FaceGeometry as _},
};

/// Places of all faces together that the scale is made from, about, and of one along a side.
const PLACES: f64 = 200_000.0;
const SIDES: (f64, f64) = (3.0, 25.0);
/// Smaller values, in the unit of the quantity for a model of size 1, are rounding.
const ROUNDING: f64 = 1e-12;
/// A Gaussian or a mean curvature that is this part of what the larger curvature makes of it is rounding.
const ROUNDING_OF_PRODUCT: f64 = 1e-9;
/// Surfaces without the quantity: grey, darker than the middle of a scale.
pub(in crate::formats::png) const WITHOUT: u32 = 0xB4B8BC;
/// A place where a side is one point is looked at so far inside.
const INSIDE: f64 = 1e-5;

/// A quantity of the surfaces of a picture.
pub(in crate::formats::png) struct Coloured<'a> {
    colour: PictureColour,
    /// Of each item the surface that it follows, if its distance is shown.
    followed: Vec<Option<SurfaceDistance<'a>>>,
    /// Whether the surfaces of an item have the quantity.
    shown: Vec<bool>,
    pub(super) scale: ValueScale,
    /// True if some places have no value.
    gaps: bool,
}

impl<'a> Coloured<'a> {
    /// The quantity that is asked for; `None` if no surface has it.
    pub(super) fn new(job: &Job<'a>) -> Option<Self> {
        let colour = job.options.png_colour;
        if matches!(colour, PictureColour::Object | PictureColour::Field) {
            return None;
        }
        let deviation = colour == PictureColour::Deviation;
        let given = |item: usize| job.provenances.given(item).filter(|_| deviation).map(SurfaceDistance::new);
        let followed: Vec<_> = (0..job.model.items.len()).map(given).collect();
        // The inside of blocks has colors of its own, and a surface over triangles no curvatures.
        let faces = |item: usize| {
            let own = job.bodies.iter().filter(move |body| body.item == item);
            own.filter_map(|body| body.body.faces()).flat_map(Body::shells)
        };
        let can = |item: usize| !job.model.items[item].surfaces().is_empty() && faces(item).next().is_some();
        let shown: Vec<bool> =
            followed.iter().enumerate().map(|(item, given)| can(item) && (!deviation || given.is_some())).collect();
        let empty = ValueScale::new(vec![(0.0, 1.0)], 0.0)?;
        let mut coloured = Self { colour, followed, shown, scale: empty, gaps: false };
        let items = (0..coloured.shown.len()).filter(|item| coloured.shown[*item]);
        // The lines on them are not looked at.
        let own: Vec<(usize, Surface<'_>)> = items
            .flat_map(|item| {
                faces(item).flat_map(move |shell| surfaces(shell, item, f64::MAX, 1.0)).map(move |s| (item, s))
            })
            .collect();
        if own.is_empty() {
            return None;
        }
        let count = (PLACES / own.len().max(1) as f64).sqrt().clamp(SIDES.0, SIDES.1) as usize;
        let (mut values, mut bend, mut gaps) = (Vec::new(), 0.0_f64, false);
        for (item, surface) in own.iter().map(|(item, surface)| (*item, surface)) {
            for (i, j) in (0..count * count).map(|k| (k % count, k / count)) {
                let at = [i, j].map(|k| k as f64 / (count - 1) as f64);
                let area = surface.surface.jet(at[0], at[1]).area_element();
                // Ends of a row stand for half as much.
                let half = |k: usize| if k == 0 || k + 1 == count { 0.5 } else { 1.0 };
                match coloured.value(item, surface, at) {
                    Some(value) => values.push((value, area * half(i) * half(j))),
                    None => gaps = true,
                }
                if let Some([k1, k2]) = curvatures(surface, at).filter(|k| k.iter().all(|k| k.is_finite())) {
                    bend = bend.max(k1.abs()).max(k2.abs());
                }
            }
        }
        let size = job.size();
        let zero = match colour {
            PictureColour::Deviation => ROUNDING * size,
            PictureColour::Gaussian => (ROUNDING_OF_PRODUCT * bend * bend).max(ROUNDING / (size * size)),
            _ => (ROUNDING_OF_PRODUCT * bend).max(ROUNDING / size),
        };
        coloured.scale = ValueScale::new(values, zero)?;
        coloured.gaps = gaps;
        Some(coloured)
    }

    /// The quantity at a place of a surface.
    fn value(&self, item: usize, surface: &Surface<'_>, at: [f64; 2]) -> Option<f64> {
        match self.colour {
            PictureColour::Deviation => {
                let tree = self.followed.get(item)?.as_ref()?;
                let outward = surface.surface.normal(at[0], at[1])? * surface.outer;
                tree.signed(surface.surface.point(at[0], at[1]), outward)
            }
            PictureColour::Gaussian => curvatures(surface, at).map(|[k1, k2]| k1 * k2),
            PictureColour::Mean => curvatures(surface, at).map(|[k1, k2]| 0.5 * (k1 + k2)),
            PictureColour::K1 => curvatures(surface, at).map(|[k1, _]| k1),
            PictureColour::K2 => curvatures(surface, at).map(|[_, k2]| k2),
            PictureColour::Object | PictureColour::Field => None,
        }
        .filter(|value| !value.is_nan())
    }

    /// The color of a place; `None` if it has no value there.
    pub(super) fn tint(&self, item: usize, surface: &Surface<'_>, at: [f64; 2]) -> Option<Rgb> {
        if !self.shown.get(item).copied().unwrap_or(false) {
            return None;
        }
        self.value(item, surface, at).map(|value| self.scale.colour(value))
    }

    /// True if the surfaces of an object have the quantity.
    pub(in crate::formats::png) fn is_shown(&self, item: usize) -> bool {
        self.shown.get(item).copied().unwrap_or(false)
    }

    /// True if there are places without a value on surfaces that have the quantity.
    pub(in crate::formats::png) fn has_gaps(&self) -> bool {
        self.gaps
    }
}

/// The principal curvatures, the larger first, signed by the outer side.
fn curvatures(surface: &Surface<'_>, at: [f64; 2]) -> Option<[f64; 2]> {
    let face = surface.surface;
    if face.patch().is_some() {
        let both = face.line_curvatures(at[0], at[1]).map(|k| k * surface.bend);
        return both.iter().all(|k| !k.is_nan()).then(|| [both[0].max(both[1]), both[0].min(both[1])]);
    }
    let jet = |at: [f64; 2]| face.jet(at[0], at[1]).principal_curvatures();
    // At a pole the jet says nothing: beside it there is a value.
    let inside = || at.map(|v| v.clamp(INSIDE, 1.0 - INSIDE));
    let [k1, k2] = jet(at).or_else(|| jet(inside()))?;
    Some(if surface.outer < 0.0 { [-k2, -k1] } else { [k1, k2] })
}

/// What a quantity is called, with its unit.
pub(in crate::formats::png) fn name(colour: PictureColour, units: Units) -> String {
    let symbol = units.symbol();
    match colour {
        PictureColour::Gaussian => format!("Gaussian curvature, 1/{symbol}²"),
        PictureColour::Mean => format!("mean curvature, 1/{symbol}"),
        PictureColour::K1 => format!("larger principal curvature, 1/{symbol}"),
        PictureColour::K2 => format!("smaller principal curvature, 1/{symbol}"),
        PictureColour::Deviation => format!("distance from the given surface, {symbol}"),
        PictureColour::Object | PictureColour::Field => String::new(),
    }
}

/// What is said of places without a value.
pub(in crate::formats::png) fn gap(colour: PictureColour) -> &'static str {
    match colour {
        PictureColour::Deviation => "outside the border of the given surface",
        _ => "without curvature",
    }
}

/// What is said of surfaces without the quantity.
pub(in crate::formats::png) fn without(colour: PictureColour) -> &'static str {
    match colour {
        PictureColour::Deviation => "follows no given surface",
        _ => "no curvatures",
    }
}
