//! Random documents of every type of object, tame and wild, for attacks on the whole program: by the task
//! `cargo xtask attack` and in the tests.
//!
//! One file per class of trouble. A class makes lists of points, or whole objects; [`document`] puts them together, and
//! the same seed and number give the same document on every machine.

mod contact_blends;
mod crossings;
mod ends;
mod hairpins;
mod inversions;
mod maps;
mod motions;
mod near_degenerate;
mod nets;
mod nurbs;
mod objects;
mod patches;
mod pipes;
mod planar;
mod points;
mod polyhedra;
mod quotients;
mod random;
mod revolutions;
pub mod runner;
mod scales;
mod swept;
mod tees;
mod tori;
mod triangles;
mod tubes;
mod volumes;

pub use random::Random;

use serde_json::{Value, json};

/// A document of an attack.
#[derive(Debug, Clone, PartialEq)]
pub struct Attack {
    /// The class that made it, and the type of its object: where to look when it fails.
    pub class: &'static str,
    /// The document.
    pub document: Value,
    /// True if it has surfaces.
    pub has_surfaces: bool,
    /// The tolerance to ask for, if any.
    pub tolerance: Option<f64>,
    /// The area that the report has to give, if it is known.
    pub area: Option<f64>,
}

/// One class: how often it is taken, and its objects by name, the last one to be written.
type Class = (&'static str, u32, fn(&mut Random) -> Objects);

/// Objects by name.
pub(crate) struct Objects {
    objects: Vec<(&'static str, Value)>,
    has_surfaces: bool,
    /// The tolerance that it needs, where others make too much work.
    tolerance: Option<f64>,
    /// The area of the last object, if it is known.
    area: Option<f64>,
}

impl Objects {
    fn curve(object: Value) -> Self {
        Self { objects: vec![("a", object)], has_surfaces: false, tolerance: None, area: None }
    }

    fn surface(object: Value) -> Self {
        Self { objects: vec![("a", object)], has_surfaces: true, tolerance: None, area: None }
    }

    /// The first object as construction geometry, and a second one made from it.
    fn derived(mut base: Self, name: &'static str, object: Value, has_surfaces: bool) -> Self {
        if let Some((_, first)) = base.objects.last_mut() {
            first["construction"] = json!(true);
        }
        base.objects.push((name, object));
        Self { objects: base.objects, has_surfaces, tolerance: base.tolerance, area: None }
    }
}

const CLASSES: &[Class] = &[
    ("points", 5, points::object),
    ("hairpins", 3, hairpins::object),
    ("ends", 3, ends::object),
    ("scales", 3, scales::object),
    ("single curves", 2, objects::single),
    ("inversions", 3, inversions::curve),
    ("maps", 2, maps::curve),
    ("near-degenerate cyclides", 3, near_degenerate::cyclide),
    ("splines", 3, nurbs::curve),
    ("support structures", 2, near_degenerate::support),
    ("patches", 3, patches::object),
    ("offsets", 2, patches::offset),
    ("nets", 3, nets::object),
    ("inverted surfaces", 2, inversions::surface),
    ("revolutions", 2, revolutions::surface),
    ("polyhedra", 1, polyhedra::surface),
    ("pipes", 2, pipes::surface),
    ("tubes", 2, tubes::surface),
    ("tees", 1, tees::surface),
    ("contact blends", 1, contact_blends::surface),
    ("crossings", 1, crossings::surface),
    ("necks", 2, swept::neck),
    ("bridges", 1, swept::bridge),
    ("rails", 2, swept::between_rails),
    ("planar", 2, planar::surface),
    ("triangles", 1, triangles::surface),
    ("tori", 2, tori::curve),
    ("seams", 1, tori::seam),
    ("trajectories", 2, motions::trajectory),
    ("swept surfaces", 2, motions::swept),
    ("quotients", 3, quotients::curve),
];

/// Classes of blocks.
const BLOCKS: &[Class] =
    &[("volumes", 1, volumes::block), ("layers", 1, volumes::layers), ("in volumes", 1, volumes::derived)];

/// Document `number` of the attack with this seed.
#[must_use]
pub fn document(seed: u64, number: u64) -> Attack {
    let mut random = Random::new(seed, number);
    // Every sixteenth document is of blocks: so the others are what they were before there were any.
    let classes = if number % 16 == 7 { BLOCKS } else { CLASSES };
    let total: u32 = classes.iter().map(|class| class.1).sum();
    let mut pick = random.below(total as usize) as u32;
    let mut chosen = classes[0];
    for &class in classes {
        if pick < class.1 {
            chosen = class;
            break;
        }
        pick -= class.1;
    }
    let made = chosen.2(&mut random);
    let objects: serde_json::Map<String, Value> =
        made.objects.into_iter().map(|(name, object)| (name.to_owned(), object)).collect();
    let drawn = random.chance(0.3).then(|| random.decades(-9.0, 1.0));
    let tolerance = made.tolerance.or(drawn);
    let document = json!({"cyclide": 1, "units": "mm", "objects": objects});
    Attack { class: chosen.0, document, has_surfaces: made.has_surfaces, tolerance, area: made.area }
}
