//! The kinds of object: one entry in one list for each, and the description of an object that is one of them.

mod arc;
mod arc_fit;
mod arc_spline;
mod ball_centers;
mod biarc;
mod center_surface;
mod circle;
mod circle_spline;
mod circular_surface;
mod contact_blend;
mod coordinate_surfaces;
mod cyclide;
mod cyclide_grid;
mod cyclide_patch;
mod cyclide_volume;
pub(in crate::document) mod cyclidic_net;
mod ellipse;
mod ellipse_bridge;
mod fair_fit;
mod fair_spline;
pub(in crate::document) mod fields;
mod helix;
mod layers;
mod moebius_spline;
mod motion;
mod nurbs;
mod offset;
mod pipe;
mod pipe_crossing;
mod pipe_tee;
mod plate_with_neck;
mod polyline;
mod principal_grid;
pub(in crate::document) mod qb_interpolation;
mod revolution;
mod ruled;
mod smooth_mesh;
mod smooth_polyhedron;
mod sphere_blend;
mod support_structure;
mod sweep;
mod swept_surface;
mod torus_circle;
mod torus_knot;
mod torus_quartic;
mod torus_seam;
mod torus_spline;
mod trajectory;
pub(in crate::document) mod transform;
mod tube;
mod unrolled;

use schemars::JsonSchema;

use crate::document::objects::kind::Kind;

pub use fields::*;

/// The list, by group: each kind with its module, its description, and the word of its type.
macro_rules! kinds {
    ($($group:literal {
        $($(#[$doc:meta])* $module:ident: $variant:ident($spec:ident) = $word:literal,)*
    })*) => {
        $($(pub use $module::*;)*)*

        /// One object of a document.
        ///
        /// ```
        /// use cyclide_io::Document;
        /// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
        /// let built = document.build()?;
        /// assert_eq!(document.objects[0].1.type_word(), "circle");
        /// assert!(built[0].bodies.is_empty());
        /// # Ok::<(), cyclide_io::Error>(())
        /// ```
        #[derive(Debug, Clone, PartialEq, JsonSchema)]
        #[schemars(untagged, rename = "Object")]
        #[non_exhaustive]
        pub enum ObjectSpec {
            $($($(#[$doc])* $variant($spec),)*)*
        }

        impl ObjectSpec {
            /// The words of the types, in the order of the documentation.
            pub const TYPES: &'static [&'static str] = &[$($($word,)*)*];

            /// The same by group, as manuals list them: the name of each group and the words of its types.
            ///
            /// ```
            /// use cyclide_io::document::ObjectSpec;
            /// let (name, words) = ObjectSpec::GROUPS[0];
            /// assert_eq!((name, words[0]), ("Curves", "arc"));
            /// ```
            pub const GROUPS: &'static [(&'static str, &'static [&'static str])] = &[$(($group, &[$($word,)*]),)*];

            /// The word of the object's type.
            #[must_use]
            pub fn type_word(&self) -> &'static str {
                match self {
                    $($(Self::$variant(_) => $word,)*)*
                }
            }

            /// True for construction geometry, which is built and reported but not written to files.
            #[must_use]
            pub fn is_construction(&self) -> bool {
                match self {
                    $($(Self::$variant(spec) => spec.construction,)*)*
                }
            }

            /// What it says of itself.
            pub(in crate::document) fn kind(&self) -> &dyn Kind {
                match self {
                    $($(Self::$variant(spec) => spec,)*)*
                }
            }

            /// A commented starter document with an object of this type; `None` if the type does not exist.
            #[must_use]
            pub fn starter(word: &str) -> Option<&'static str> {
                match word {
                    $($($word => Some(include_str!(concat!("../starters/", $word, ".json"))),)*)*
                    _ => None,
                }
            }

            /// Reads an object of the type `word`; `None` if there is no such type.
            pub(in crate::document) fn parse(word: &str, text: &str) -> Option<serde_json::Result<Self>> {
                match word {
                    $($($word => Some(serde_json::from_str(text).map(Self::$variant)),)*)*
                    _ => None,
                }
            }
        }
    };
}

kinds! {
    "Curves" {
        /// A circular arc or straight segment.
        arc: Arc(ArcSpec) = "arc",
        /// A full circle.
        circle: Circle(CircleSpec) = "circle",
        /// An ellipse or an elliptical arc.
        ellipse: Ellipse(EllipseSpec) = "ellipse",
        /// A helix.
        helix: Helix(HelixSpec) = "helix",
        /// Two arcs between two points with given directions.
        biarc: Biarc(BiarcSpec) = "biarc",
        /// Segments through points, with corners rounded by arcs.
        polyline: Polyline(PolylineSpec) = "polyline",
        /// Arcs through points, tangent-continuous.
        arc_spline: ArcSpline(ArcSplineSpec) = "arc-spline",
        /// The fewest arcs near points, tangent-continuous.
        arc_fit: ArcFit(ArcFitSpec) = "arc-fit",
        /// The fairest smooth curve through points.
        fair_spline: FairSpline(FairSplineSpec) = "fair-spline",
        /// The fairest smooth curve near points.
        fair_fit: FairFit(FairFitSpec) = "fair-fit",
        /// A smooth curve through points, blended from circles.
        circle_spline: CircleSpline(CircleSplineSpec) = "circle-spline",
        /// A rational B-spline curve.
        nurbs: Nurbs(NurbsSpec) = "nurbs",
        /// A local smooth curve through points, of a kind that Möbius maps preserve.
        moebius_spline: MoebiusSpline(MoebiusSplineSpec) = "moebius-spline",
        /// A rational curve of lowest degree through points.
        qb_interpolation: QbInterpolation(QbInterpolationSpec) = "qb-interpolation",
    }
    "Curves on a torus" {
        /// A smooth curve on a torus through points.
        torus_spline: TorusSpline(TorusSplineSpec) = "torus-spline",
        /// A curve that winds evenly around the axis and the tube of a torus.
        torus_knot: TorusKnot(TorusKnotSpec) = "torus-knot",
        /// A closed quartic of one type on a torus.
        torus_quartic: TorusQuartic(TorusQuarticSpec) = "torus-quartic",
        /// A circle on a torus.
        torus_circle: TorusCircle(TorusCircleSpec) = "torus-circle",
        /// A curve on a torus, laid flat.
        unrolled: Unrolled(UnrolledSpec) = "unrolled",
        /// A raised or sunk seam along a curve on a torus.
        torus_seam: TorusSeam(TorusSeamSpec) = "torus-seam",
    }
    "Surfaces" {
        /// One patch of a Dupin cyclide, bounded by four circular arcs.
        cyclide_patch: CyclidePatch(CyclidePatchSpec) = "cyclide-patch",
        /// A whole Dupin cyclide.
        cyclide: Cyclide(CyclideSpec) = "cyclide",
        /// A smooth surface of patches over a grid of points.
        cyclidic_net: CyclidicNet(CyclidicNetSpec) = "cyclidic-net",
        /// Regular grids along the lines of curvature of a surface.
        principal_grid: PrincipalGrid(PrincipalGridSpec) = "principal-grid",
    }
    "Volumes" {
        /// A block between cyclides that intersect at right angles.
        cyclide_volume: CyclideVolume(CyclideVolumeSpec) = "cyclide-volume",
        /// Blocks in a grid.
        cyclide_grid: CyclideGrid(CyclideGridSpec) = "cyclide-grid",
        /// Blocks in layers over a net.
        layers: Layers(LayersSpec) = "layers",
        /// Surfaces inside blocks.
        coordinate_surfaces: CoordinateSurfaces(CoordinateSurfacesSpec) = "coordinate-surfaces",
    }
    "Polyhedra and triangles" {
        /// A convex polyhedron with its edges and corners rounded.
        smooth_polyhedron: SmoothPolyhedron(SmoothPolyhedronSpec) = "smooth-polyhedron",
        /// A smooth surface through the vertices of a triangle mesh.
        smooth_mesh: SmoothMesh(SmoothMeshSpec) = "smooth-mesh",
        /// A smooth patch over one triangle, shaped by three spheres.
        sphere_blend: SphereBlend(SphereBlendSpec) = "sphere-blend",
    }
    "Surfaces from curves" {
        /// The surface or solid swept by a curve that turns about an axis.
        revolution: Revolution(RevolutionSpec) = "revolution",
        /// A tube of constant radius about a curve of arcs and segments.
        pipe: Pipe(PipeSpec) = "pipe",
        /// A tube of changing radius along a curve or through balls.
        tube: Tube(TubeSpec) = "tube",
        /// A plane section moved along a path.
        sweep: Sweep(SweepSpec) = "sweep",
        /// Arcs between two curves.
        circular_surface: CircularSurface(CircularSurfaceSpec) = "circular-surface",
        /// Straight lines between two curves.
        ruled: Ruled(RuledSpec) = "ruled",
    }
    "Pipes and blends" {
        /// A main pipe with branches, joined by rolling-ball fillets.
        pipe_tee: PipeTee(PipeTeeSpec) = "pipe-tee",
        /// Two pipes that pass each other, joined by a rolling-ball fillet.
        pipe_crossing: PipeCrossing(PipeCrossingSpec) = "pipe-crossing",
        /// A cylinder or cone joined to a sphere or a plate by a rolling-ball fillet.
        contact_blend: ContactBlend(ContactBlendSpec) = "contact-blend",
        /// The paths of the centers of the balls of blends.
        ball_centers: BallCenters(BallCentersSpec) = "ball-centers",
        /// The surface of the centers of all balls that touch two pipes.
        center_surface: CenterSurface(CenterSurfaceSpec) = "center-surface",
        /// A pipe on a plate with a rounded neck.
        plate_with_neck: PlateWithNeck(PlateWithNeckSpec) = "plate-with-neck",
        /// Half circles between two ellipses.
        ellipse_bridge: EllipseBridge(EllipseBridgeSpec) = "ellipse-bridge",
    }
    "Motions" {
        /// A motion of a body, through poses or along a curve.
        motion: Motion(MotionSpec) = "motion",
        /// The path of a point of a moving body.
        trajectory: Trajectory(TrajectorySpec) = "trajectory",
        /// The surface swept by a curve of a moving body.
        swept_surface: SweptSurface(SweptSurfaceSpec) = "swept-surface",
    }
    "Derived from other objects" {
        /// A parallel surface, or the solid between it and the original.
        offset: Offset(OffsetSpec) = "offset",
        /// The image of an object under a chain of maps.
        transform: Transform(TransformSpec) = "transform",
        /// The edges of a surface as arcs.
        support_structure: SupportStructure(SupportStructureSpec) = "support-structure",
    }
}

impl ObjectSpec {
    /// False for types of surfaces that STEP and JSON do not hold: there are meshes of them only.
    #[must_use]
    pub fn has_exact_form(word: &str) -> bool {
        !["smooth-mesh", "sphere-blend"].contains(&word)
    }
}
