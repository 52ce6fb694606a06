//! The formats: one entry in one list for each, and the doors that know all of them.

mod csv;
mod dxf;
mod entry;
mod exporter;
mod foreign;
mod format;
mod gismo;
mod glb;
mod input_kind;
mod json;
mod mesh_entry;
mod mesh_format;
mod mfem;
mod obj;
mod ply;
#[cfg(feature = "png")]
mod png;
mod read_back;
mod step;
mod stl;
mod svg;
mod three_mf;
mod vtu;

use entry::Entry;

pub(crate) use csv::push_sample;
pub(crate) use dxf::{Lettering, Sheet, SheetLine};
pub use exporter::{Exporter, export};
pub use input_kind::InputKind;
pub(crate) use mesh_entry::ReadMesh;
pub use mesh_format::MeshFormat;
pub use obj::{MendedQuads, ObjGrid, ObjLayout, ObjQuads, read_quad_grid, read_quads};
pub(crate) use read_back::deviations_of;
pub use read_back::{file_deviation, read_back};
pub use vtu::vtk_multi_block;

/// The list: each format with its module, which holds its entry.
macro_rules! formats {
    ($($(#[$doc:meta])* $format:ident: $module:ident $(if $feature:literal)?,)*) => {
        /// A file format.
        ///
        /// ```
        /// use cyclide_io::Format;
        /// assert_eq!(Format::from_path("model.stp".as_ref())?, Format::Step);
        /// # Ok::<(), cyclide_io::export::ExportError>(())
        /// ```
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Format {
            $($(#[cfg(feature = $feature)])? $(#[$doc])* $format,)*
        }

        impl Format {
            /// Every format.
            pub const ALL: &'static [Self] = &[$($(#[cfg(feature = $feature)])? Self::$format),*];

            /// What there is to know of it.
            pub(crate) const fn entry(self) -> &'static Entry {
                match self {
                    $($(#[cfg(feature = $feature)])? Self::$format => &$module::ENTRY,)*
                }
            }
        }
    };
}

formats! {
    /// STEP AP214 (ISO 10303-21): CAD systems.
    Step: step,
    /// AutoCAD DXF: laser cutters, 2D CAD.
    Dxf: dxf,
    /// Scalable Vector Graphics: browsers, laser cutters.
    Svg: svg,
    /// Comma-separated samples.
    Csv: csv,
    /// Exact rational B-splines as JSON.
    Json: json,
    /// A picture.
    Png: png if "png",
    /// Binary glTF 2.0: rendering, browsers.
    Glb: glb,
    /// Wavefront OBJ: meshes with quads.
    Obj: obj,
    /// Binary STL: 3D printing.
    Stl: stl,
    /// PLY: meshes with quads and normals.
    Ply: ply,
    /// 3MF: 3D printing, with the unit.
    ThreeMf: three_mf,
    /// VTK XML unstructured grid of rational Bézier cells: ParaView, analysis.
    Vtu: vtu,
    /// MFEM NURBS mesh: finite elements.
    Mfem: mfem,
    /// G+Smo XML: isogeometric analysis.
    Gismo: gismo,
}
