//! The models of the gallery: the documents of the folder `examples`, with what they show.

use cyclide_io::Format;

/// One model.
pub struct Entry {
    /// Name of its files.
    pub name: &'static str,
    /// Heading on the page.
    pub title: &'static str,
    /// What there is to see, in one or two sentences.
    pub text: &'static str,
    /// The model document.
    pub document: &'static str,
    /// The files it refers to.
    pub inputs: &'static [(&'static str, &'static [u8])],
    /// What is made of it.
    pub formats: &'static [Format],
}

/// A document of the folder of examples.
macro_rules! example {
    ($file:literal) => {
        include_str!(concat!("../../../../examples/", $file))
    };
}

/// A file that a document refers to, with its name.
macro_rules! input {
    ($file:literal) => {
        ($file, include_bytes!(concat!("../../../../examples/", $file)))
    };
}

const CURVES: &[Format] = &[Format::Step, Format::Svg, Format::Png];

/// All models, in the order of the page.
pub const ENTRIES: [Entry; 4] = [
    Entry {
        name: "track",
        title: "Race track",
        text: "A closed circle spline through 44 points, curvature without jumps; beside it the fewest arcs near 301 surveyed ones.",
        document: example!("track.json"),
        inputs: &[input!("track.csv"), input!("survey.csv")],
        formats: CURVES,
    },
    Entry {
        name: "logo",
        title: "Logo",
        text: "Three contours with corners, ready for a laser cutter.",
        document: example!("logo.json"),
        inputs: &[input!("logo.csv")],
        formats: CURVES,
    },
    Entry {
        name: "cable",
        title: "Cable in space",
        text: "A route through points with heights, with the directions at its ends given.",
        document: example!("cable.json"),
        inputs: &[input!("cable.csv")],
        formats: CURVES,
    },
    Entry {
        name: "gallery",
        title: "Every kind of curve",
        text: "Arcs, biarcs, arc splines, fits and circle splines: an object of every type.",
        document: example!("gallery.json"),
        inputs: &[],
        formats: CURVES,
    },
];
