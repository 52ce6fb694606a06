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
    /// Where its picture is looked at from, as `--camera` has it; from the front and above if empty.
    pub camera: &'static str,
}

/// A document of the folder of examples.
macro_rules! example {
    ($file:literal) => {
        include_str!(concat!("../../../../../examples/", $file))
    };
}

/// A file that a document refers to, with its name.
macro_rules! input {
    ($file:literal) => {
        ($file, include_bytes!(concat!("../../../../../examples/", $file)))
    };
}

const CURVES: &[Format] = &[Format::Step, Format::Svg, Format::Png];
const SURFACES: &[Format] = &[Format::Step, Format::Glb, Format::Png];
/// Of blocks.
const VOLUMES: &[Format] = &[Format::Vtu, Format::Step, Format::Png];
/// Of surfaces without an exact form.
const MESHES: &[Format] = &[Format::Glb, Format::Stl, Format::Png];

/// Of motions, with what is made of them.
const MOVING: &[Format] = &[Format::Glb, Format::Step, Format::Png];

/// Of fine scans, whose meshes are large.
const RENDERED: &[Format] = &[Format::Glb, Format::Png];

/// All models, in the order of the page.
pub const ENTRIES: &[Entry] = &[
    Entry {
        name: "roof",
        title: "Free-form roof with two skins",
        text: "A mesh of 20 by 20 quads on a roof 66 m long, whose vertices move by half a metre on average so that every quad has a circle, and a second skin at an exact distance.",
        document: example!("roof.json"),
        inputs: &[input!("roof-20.obj")],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "patch",
        title: "A patch with its parameter circles",
        text: "Four corners on one circle and one frame: every parameter line is a circular arc and a line of curvature.",
        document: example!("patch.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "ring",
        title: "Ring cyclide",
        text: "A whole Dupin cyclide from three numbers, as a closed solid of patches that share their circles.",
        document: example!("ring.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "inverted_torus",
        title: "Inverted torus",
        text: "Inversion in a sphere takes circles to circles and a torus to a Dupin cyclide, patch by patch, exactly.",
        document: example!("inverted_torus.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "handle",
        title: "Triply curved handle",
        text: "A grip that swells and tapers, bent in three planes: 12 patches of three Dupin cyclides, made thick to a closed solid.",
        document: example!("handle.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "vase",
        title: "Vase",
        text: "A fair profile through twelve points turned about its axis: a closed solid of exact rational faces, its foot and lip plane.",
        document: example!("vase.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "dodecahedron",
        title: "Rounded dodecahedron",
        text: "The convex hull of twenty points, and the same with a radius of 4 mm on all edges and corners: planes, cylinders and parts of spheres.",
        document: example!("dodecahedron.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "hull",
        title: "A cut stone of two hundred corners",
        text: "The convex hull of 200 points on an egg, nearly 400 triangles, with a radius of 1.2 mm on all edges and corners.",
        document: example!("hull.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "pipe",
        title: "Pipe with eight bends",
        text: "A run of segments and arcs with a wall, of cylinders and tori alone, and a closed frame of rods with mitred corners.",
        document: example!("pipe.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "roof_pipe",
        title: "A pipe through a roof",
        text: "A rolling ball rounds the corner between a pipe and a plate at 35 degrees: an exact rational neck, sewn with pipe and plate to one solid.",
        document: example!("roof_pipe.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "tubes",
        title: "Tubes of changing radius",
        text: "A cable that thins, a horn with a wall, a knot of changing width and a handle through four balls: chains of Dupin cyclides that are tangent all round.",
        document: example!("tubes.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "20,45",
    },
    Entry {
        name: "pick_and_place",
        title: "Pick and place",
        text: "A gripper takes parts from a tray and puts them down turned over: one smooth rational motion through nine poses, as an animation; the path of its tip and what its fingers run over are exact.",
        document: example!("pick_and_place.json"),
        inputs: &[],
        formats: MOVING,
        camera: "60,35",
    },
    Entry {
        name: "tee",
        title: "Tees of pipes",
        text: "Branches blended with a main pipe by balls that roll round them: an upright one whose ball is larger in the crotches, a lateral at 45 degrees, three branches on one hollow pipe, three round it at one place, and an equal cross, whose blends meet in points. Exact rational faces, one solid each.",
        document: example!("tee.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "25,50",
    },
    Entry {
        name: "crossing",
        title: "Pipes that pass each other",
        text: "Blended by a ball of one radius: two hollow pipes with one bore, the same askew, a rail that lies on a bar, and two pipes that do not touch, which the blend joins as a bridge. Exact envelopes of balls, one solid each.",
        document: example!("crossing.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "0,28",
    },
    Entry {
        name: "crossing_laws",
        title: "Balls that change as they roll",
        text: "A bridge of two pipes by balls of a closed spline through four of them, two bores with a ball that is larger at the sides, a notch with a rounded edge, and what two pipes have in common.",
        document: example!("crossing_laws.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "0,35",
    },
    Entry {
        name: "ball_centers",
        title: "Centres of balls",
        text: "The surface of the centres of all balls that touch two pipes, a closed spline on it, and the blend that its balls make. Exact: a patch of degree (2, 2), a curve of degree 4, canals of degree (12, 2).",
        document: example!("ball_centers.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "35,45",
    },
    Entry {
        name: "contact_blend",
        title: "Tubes and a ring on a sphere and on plates",
        text: "Blended by a ball of one radius: a hollow strut off the centre of a spherical node, a cone that leans on a plate, a ring on a round plate, and a dished head with its knuckle, whose rim is rounded inside. Exact envelopes of balls, one solid each.",
        document: example!("contact_blend.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "ellipse_bridge",
        title: "Bridge of two ellipses",
        text: "Half circles upright on the chords between two ellipses, and walls tangent to them: a solid ring. Beside it whole circles on the same chords.",
        document: example!("ellipse_bridge.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "ruled",
        title: "Surfaces of lines and of circles",
        text: "A hyperboloid, turned from a segment and ruled between two circles; a vault of arcs over two rails; the neck of a leaning pipe with arcs in planes along it. All exact.",
        document: example!("ruled.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "circles_in_space",
        title: "Circles, spheres and planes",
        text: "The null cone with its points of one scale; circles on a sphere that turn into each other about two points; a circle spline through points of a sphere, which stays on it; a circle that meets a plane.",
        document: example!("circles_in_space.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "spherical_cube",
        title: "A spherical and a cyclidic cube",
        text: "Eight points of a sphere, the four of every face of a cube on a circle: the last one follows from the others, by a theorem of Miquel. Beside it the block of these corners, whose faces are patches of Dupin cyclides.",
        document: example!("spherical_cube.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "volume_faces",
        title: "Faces of a cyclidic cube",
        text: "Six patches that meet at right angles along their common circles.",
        document: example!("volume_faces.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "block",
        title: "Three families in a block",
        text: "A block of four corners: its coordinate surfaces are patches of Dupin cyclides, cross at right angles everywhere, and all lines are circles.",
        document: example!("block.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "boundary_layers",
        title: "Layers over a wall",
        text: "Eight blocks between offsets of a patch, each higher than the one below: an orthogonal grid for flow or heat, exact in VTU.",
        document: example!("boundary_layers.json"),
        inputs: &[],
        formats: VOLUMES,
        camera: "20,16",
    },
    Entry {
        name: "tube_grid",
        title: "A grid in the wall of a bent tube",
        text: "The inner skin and the walls between 96 blocks, which fill the space between two Dupin cyclides without a gap: all of them cross at right angles. Each has 160 cells for solvers.",
        document: example!("tube_grid.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "20,30",
    },
    Entry {
        name: "trefoil",
        title: "A trefoil on a torus",
        text: "The torus knot of two turns round the axis and three round the tube, exactly on the torus, with a rod about it, and a thicker rod alone; two Villarceau circles through one point.",
        document: example!("trefoil.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "0,70",
    },
    Entry {
        name: "torus_circles",
        title: "The circles of a torus",
        text: "Round the axis and round the tube, and the two families of Villarceau circles, whose radius is that of the middle circle: four through every point.",
        document: example!("torus_circles.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "0,50",
    },
    Entry {
        name: "torus_quartics",
        title: "Quartics of six types",
        text: "Closed curves of degree 4, each along two of the four families of circles at once, exactly on the torus.",
        document: example!("torus_quartics.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "0,60",
    },
    Entry {
        name: "four_point_loop",
        title: "A loop through four points",
        text: "Four points with directions, along parallels and meridians in turn, and two quartics of two types for each quarter; beside it four points and the spline that chooses its directions and types. Both lie on the torus exactly.",
        document: example!("four_point_loop.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "0,32",
    },
    Entry {
        name: "winding",
        title: "Filament on a core",
        text: "One closed thread, 5 times round the axis and 87 times round the tube: 7.7 m of it, exactly on the torus.",
        document: example!("winding.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "o_ring",
        title: "Marks on a moulded ring",
        text: "A raised mark and a sunk line along curves of a torus, each a solid of a given width between two heights, to be fused to the ring or cut from it.",
        document: example!("o_ring.json"),
        inputs: &[],
        formats: SURFACES,
        camera: "",
    },
    Entry {
        name: "o_ring_pattern",
        title: "The marks laid flat",
        text: "The same curves with their torus unrolled to a rectangle: longitude by meridian angle, each as a length.",
        document: example!("o_ring_pattern.json"),
        inputs: &[],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "stone",
        title: "A scan made smooth",
        text: "A smooth surface through the vertices of a scan of 500 triangles: the tangent plane is continuous, and its meshes are closed to the bit.",
        document: example!("stone.json"),
        inputs: &[input!("stone.ply")],
        formats: MESHES,
        camera: "",
    },
    Entry {
        name: "scan",
        title: "The same stone scanned finely",
        text: "A smooth surface through the 2,502 vertices of 5,000 triangles.",
        document: example!("scan.json"),
        inputs: &[input!("stone-5000.ply")],
        formats: RENDERED,
        camera: "",
    },
    Entry {
        name: "sphere_blend",
        title: "A blend of spheres over a triangle",
        text: "Spheres through the corners of a triangle, one for each of them, and the patch that leaves each corner along the sphere of that.",
        document: example!("sphere_blend.json"),
        inputs: &[],
        formats: MESHES,
        camera: "",
    },
    Entry {
        name: "track",
        title: "Race track",
        text: "A closed fair spline through 44 points, curvature without jumps or needless swings; beside it the fewest arcs near 301 surveyed ones.",
        document: example!("track.json"),
        inputs: &[input!("track.csv"), input!("survey.csv")],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "survey",
        title: "Surveyed line, fair",
        text: "The fairest smooth curve within 20 cm of 301 surveyed points, with continuous curvature and a node for every eight of them.",
        document: example!("survey.json"),
        inputs: &[input!("survey.csv")],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "logo",
        title: "Logo",
        text: "Three contours with corners, ready for a laser cutter.",
        document: example!("logo.json"),
        inputs: &[input!("logo.csv")],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "cable",
        title: "Cable in space",
        text: "A route through points with heights, with the directions at its ends given.",
        document: example!("cable.json"),
        inputs: &[input!("cable.csv")],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "gallery",
        title: "Every kind of curve",
        text: "Arcs, bends, biarcs, splines and fits of arcs, fair, circle and Möbius splines, NURBS, quotients of quaternions: every type but those on a torus, which have pictures of their own; one wave as a circle spline, which wavers, and fair; a spline and its inversion.",
        document: example!("gallery.json"),
        inputs: &[],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "arcs",
        title: "Arcs from weights",
        text: "Two points and two quaternion weights are an arc; its centre; two arcs with one tangent; and the subdivision of an arc, one square root a point, into 3, 5, 9 and 33 points at equal distances.",
        document: example!("arcs.json"),
        inputs: &[],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "qb_curves",
        title: "Quotients of quaternion polynomials",
        text: "The rational curve of degree 4 through five points, at parameters of three kinds; three points with tangents at both ends; a Möbius spline and its image under an inversion, which is the Möbius spline of the mapped points.",
        document: example!("qb_curves.json"),
        inputs: &[],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "circle_blends",
        title: "Curves of blended circles",
        text: "A circle spline and its points, the same of order 1 and 2, inversions that are not wanted beside the fair spline that has none, and four points of one circle in crossing order.",
        document: example!("circle_blends.json"),
        inputs: &[],
        formats: CURVES,
        camera: "",
    },
    Entry {
        name: "inverted_spline",
        title: "A NURBS curve turned inside out",
        text: "A closed rational cubic as another program would have it, its knots not clamped, and its image under an inversion: exact, of degree 6, with positive weights.",
        document: example!("inverted_spline.json"),
        inputs: &[],
        formats: CURVES,
        camera: "",
    },
];
