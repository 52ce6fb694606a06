//! What an error is about: a kind of number, of point, or of thing.

use crate::table::shown_as_it_is;

/// Kinds of things with the word for each.
macro_rules! items {
    ($($item:ident => $word:literal,)*) => {
        /// What an error is about: which number, point or thing of the input.
        ///
        /// ```
        /// use cyclide::{Error, Point3, Vec3, curve::Arc, error::{ErrorItem, NumberError}};
        /// let [a, b] = [Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)];
        /// let error = Arc::from_bulge(a, b, Vec3::Z, f64::NAN).unwrap_err();
        /// assert_eq!(error, Error::Number(NumberError::NotFinite { what: ErrorItem::Bulge, index: 0 }));
        /// assert_eq!(ErrorItem::Bulge.word(), "bulge");
        /// ```
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum ErrorItem {
            $(#[doc = concat!("\"", $word, "\"")] $item,)*
        }

        impl ErrorItem {
            /// The word for it in messages; of an option its name.
            #[must_use]
            pub const fn word(self) -> &'static str {
                match self {
                    $(Self::$item => $word,)*
                }
            }
        }
    };
}

items! {
    Angle => "angle",
    Arm => "arm",
    Axis => "axis",
    Ball => "ball",
    BallRadius => "ball_radius",
    BarycentricCoordinate => "barycentric coordinate",
    Blend => "blend",
    BorderCurveSide => "side of a border curve (the direction is closed)",
    Bore => "bore",
    Branch => "branch",
    Bridge => "bridge",
    Budget => "budget",
    Bulge => "bulge",
    Center => "center",
    Cells => "number of cells",
    CentreWeight => "centre",
    ToleranceZ => "tolerance_z",
    Chord => "chord",
    Circle => "circle",
    Columns => "columns",
    ControlPoint => "control point",
    Coordinate => "coordinate",
    Corner => "corner",
    CornerAngle => "corner_angle",
    CreaseAngle => "crease_angle",
    Curve => "curve",
    Cyclide => "cyclide",
    Degree => "degree",
    Depth => "depth",
    Direction => "direction",
    Distance => "distance",
    DistanceFromPoint => "distance from point",
    Divisions => "divisions",
    Duration => "duration",
    Edge => "edge",
    EdgeLength => "edge_length",
    EdgePoints => "edge_points",
    Ellipse => "ellipse",
    Face => "face",
    FirstCell => "first cell",
    Flatness => "flatness",
    Frame => "frame",
    FrameCorner => "frame_corner",
    FrameVector => "frame vector",
    HalfAxisA => "a",
    HalfAxisC => "c",
    Height => "height",
    Knot => "knot",
    L1 => "l1",
    LargestBarycentricCoordinate => "largest barycentric coordinate",
    Layer => "layer",
    Levels => "levels",
    MainPipe => "main pipe",
    Margin => "margin",
    MatrixEntry => "matrix entry",
    MaxAngle => "max_angle",
    MaxSteps => "max_steps",
    MinArcLength => "min_arc_length",
    MinRadius => "min_radius",
    MostPieces => "most_pieces",
    Mu => "mu",
    NarrowestPart => "narrowest part",
    Neck => "neck",
    Nodes => "nodes",
    Normal => "normal",
    OffsetDistance => "offset distance",
    Pair => "pair",
    Parameter => "parameter",
    Patch => "patch",
    Pipe => "pipe",
    PipeRadius => "pipe_radius",
    Plane => "plane",
    Plate => "plate",
    Point => "point",
    Polyhedron => "polyhedron",
    Pose => "pose",
    Position => "position",
    Radius => "radius",
    RadiusOfCircle => "radius of the circle",
    Ratio => "ratio",
    Ring => "ring",
    Rotation => "rotation",
    Row => "row",
    S => "s",
    SegmentsAlongS => "segments along s",
    SegmentsAlongT => "segments along t",
    Side => "side",
    Similarity => "similarity",
    Slope => "slope",
    Sphere => "sphere",
    Start => "start",
    Station => "station",
    Stretch => "stretch",
    Surface => "surface",
    T => "t",
    T1 => "t1",
    Tangent => "tangent",
    TangentOverSpan => "tangent times the length of its span",
    Taper => "taper",
    Tension => "tension",
    Thickness => "thickness",
    Tight => "tight",
    Time => "time",
    Tolerance => "tolerance",
    Torus => "torus",
    Translation => "translation",
    Tube => "tube",
    Turn => "turn",
    From => "from",
    To => "to",
    Twist => "twist",
    U => "u",
    Vertex => "vertex",
    Volume => "volume",
    Wall => "wall",
    Weight => "weight",
    WeightRatio => "length of the weight ratio",
    Width => "width",
    Winding => "winding",
}

impl ErrorItem {
    /// The field of the input that holds such items, one or a list of them; none for points.
    pub(crate) const fn list(self) -> Option<&'static str> {
        Some(match self {
            Self::Ball => "balls",
            Self::Branch => "branches",
            Self::ControlPoint => "control_points",
            Self::Ellipse => "ellipses",
            Self::FrameVector => "frame",
            Self::Knot => "knots",
            Self::MainPipe => "main",
            Self::Parameter => "parameters",
            Self::Pipe => "pipes",
            Self::Tangent => "tangents",
            Self::Weight => "weights",
            Self::Angle
            | Self::BallRadius
            | Self::Blend
            | Self::Bulge
            | Self::PipeRadius
            | Self::Plate
            | Self::Radius
            | Self::Ring
            | Self::Sphere
            | Self::Tolerance
            | Self::Tube
            | Self::Width
            | Self::Winding => self.word(),
            _ => return None,
        })
    }
}

impl ErrorItem {
    /// The field of the input that holds the parameter.
    pub(crate) fn field(self) -> &'static str {
        match self {
            Self::SegmentsAlongS | Self::SegmentsAlongT => "segments",
            Self::TangentOverSpan => "tangents",
            _ => self.list().unwrap_or(self.word()),
        }
    }

    /// Which entry of that field it is.
    pub(crate) const fn entry(self) -> Option<usize> {
        match self {
            Self::SegmentsAlongS => Some(0),
            Self::SegmentsAlongT => Some(1),
            _ => None,
        }
    }
}

impl std::fmt::Display for ErrorItem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.word())
    }
}

shown_as_it_is!(ErrorItem, Box<super::Error>);
