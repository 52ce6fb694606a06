//! Nets and whole cyclides: from grids and parameters to the kernel's surfaces.

use std::collections::BTreeSet;

use cyclide::{
    Error as KernelError, Point3, ShortNumber, Warning,
    error::{ErrorItem, GridCellFault, GridError, NumberError, PartError, PatchError, PointError},
    model::{GridObject, SurfaceObject},
    surface::{CyclidicNet, GridCell, NetFrame, NetLayout, QuadGrid, QuadLayout},
    topology::Body,
    warning::NetWarning,
};

use crate::document::coordinates::Coordinates;
use crate::document::kinds::cyclidic_net::hints::{hint, seam_words};
use crate::document::kinds::cyclidic_net::{CyclidicNetSpec, GridSource, LaidGrid, MeshFile};
use crate::document::kinds::fields::frame::{FrameSpec, direction, frame_words};
use crate::document::kinds::smooth_mesh::{merged_vertices, turned_faces};
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::facts::{Facts, MeshNames, NetFacts};
use crate::document::objects::remark::Remark;
use crate::error::{Error, Result};
use crate::export::given_surface::GivenSurface;
use crate::formats::{InputKind, ObjGrid, ObjLayout, ObjQuads, read_quads};
use crate::measure::joints::SurfaceJointReport;
use crate::measure::seams::measured_seams;

/// What crossing sides often come from.
pub(in crate::document) const ROW_BY_ROW: &str =
    "points must be listed row by row, with all rows in the same direction";

/// What is said where such a grid is told whether it is closed.
const CLOSED_OF_ITSELF: &str = "`closed` requires an inline grid: a `principal-grid` determines itself what is closed";

impl<'a> Builder<'a> {
    /// The net over a grid.
    pub(in crate::document) fn net(&mut self, spec: &CyclidicNetSpec) -> Result<Vec<SurfaceObject>> {
        if let GridSource::File(file) = &spec.grid {
            if spec.closed.is_some() {
                return Err(
                    self.unfit("`closed` requires an inline grid: a mesh in a file determines itself what is closed")
                );
            }
            if let Some(layout) = self.mesh_file(file)? {
                return self.net_layout(spec, layout);
            }
        }
        if let Some(layout) = self.joined_grids(spec)? {
            return self.net_layout(spec, layout);
        }
        let given = self.grid(spec)?;
        self.facts = Facts::Net(Box::new(NetFacts::as_given(given.seams())));
        let grid = match spec.make_circular.options() {
            Some(options) => self.circular(spec, &options, &given)?,
            None => given.clone(),
        };
        self.given = match self.followed(spec) {
            Some(surface) => Some(surface),
            None => spec.make_circular.options().map(|_| GivenSurface::from_grid(&given)),
        };
        let frame = match spec.frame {
            FrameSpec::Auto => NetFrame::Auto,
            FrameSpec::First(given) => {
                let [v1, v2] = given.map(direction);
                NetFrame::First(v1, v2)
            }
        };
        let net = CyclidicNet::new(grid, frame).map_err(|e| self.refused_in_grid(spec, &given, &e))?;
        Ok(vec![SurfaceObject::Net(net)])
    }

    /// The grid with the openings.
    fn grid(&mut self, spec: &CyclidicNetSpec) -> Result<QuadGrid> {
        let grid = self.grid_as_given(spec)?;
        if spec.openings.is_empty() {
            return Ok(grid);
        }
        let [columns, rows] = grid.quads();
        for (index, [i, j]) in spec.openings.iter().enumerate() {
            let [i, j] = [*i, *j].map(|k| k as usize);
            if i >= columns || j >= rows || grid.cell(i, j) == GridCell::Outside {
                let message = format!("there is no quad in column {i}, row {j}: the grid has {columns} x {rows} quads");
                return Err(Error::Input(self.diagnostic(["openings".into(), index.into()], &message)));
            }
        }
        let open: BTreeSet<[usize; 2]> = spec.openings.iter().map(|at| at.map(|k| k as usize)).collect();
        let given = grid.clone();
        let cell = |i, j| if open.contains(&[i, j]) { GridCell::Opening } else { given.cell(i, j) };
        grid.with_cells(cell).map_err(|e| self.refused_at([Step::from("openings")], &e))
    }

    fn grid_as_given(&mut self, spec: &CyclidicNetSpec) -> Result<QuadGrid> {
        let rows = match &spec.grid {
            GridSource::Rows(rows) => rows,
            GridSource::File(_) => {
                let read = self.mesh.as_ref().map(|mesh| mesh.grid.clone());
                return read.ok_or_else(|| self.unfit("`grid` names no mesh"));
            }
            GridSource::Laid(laid) => {
                if spec.closed.is_some() {
                    return Err(self.unfit(CLOSED_OF_ITSELF));
                }
                return self.laid_grid(laid);
            }
        };
        let columns = rows.first().map_or(0, Vec::len);
        if let Some(row) = rows.iter().position(|row| row.len() != columns) {
            let message = format!("row {row} has {} points, the first has {columns}", rows[row].len());
            return Err(Error::Input(self.diagnostic(["grid".into(), row.into()], &message)));
        }
        let points: Vec<Option<Point3>> = rows.iter().flatten().map(|p| p.map(Coordinates::point)).collect();
        let (size, closed) = ([columns, rows.len()], spec.closed.unwrap_or_default());
        let made = if let Some(points) = points.iter().copied().collect::<Option<Vec<_>>>() {
            QuadGrid::new(points, size, closed)
        } else if closed == [false; 2] {
            let has = |i: usize, j: usize| points[i + j * columns].is_some();
            let cell = |i, j| {
                let whole = has(i, j) && has(i + 1, j) && has(i, j + 1) && has(i + 1, j + 1);
                if whole { GridCell::Patch } else { GridCell::Outside }
            };
            QuadGrid::of_cells(&points, size, cell)
        } else {
            return Err(self.unfit("a closed grid requires all its points: `null` is for open grids"));
        };
        made.map_err(|e| self.refused_at([Step::from("grid")], &e))
    }

    /// The surface that the grid follows: one that was laid follows a mesh; one that stays as it is, nothing but itself.
    pub(in crate::document) fn followed(&self, spec: &CyclidicNetSpec) -> Option<GivenSurface> {
        let GridSource::Laid(_) = &spec.grid else { return None };
        let field = self.sources.last()?.provenance.field.as_ref()?;
        Some(field.surface.clone())
    }

    /// All grids of another object, if they are joined and none of them is named.
    fn joined_grids(&mut self, spec: &CyclidicNetSpec) -> Result<Option<QuadLayout>> {
        let GridSource::Laid(LaidGrid { of, piece: None }) = &spec.grid else { return Ok(None) };
        let Some(layout) = self.sources.last().and_then(|source| source.item.grids()?.layout().cloned()) else {
            return Ok(None);
        };
        if spec.closed.is_some() {
            return Err(self.unfit(CLOSED_OF_ITSELF));
        }
        self.laid_of = Some(of.clone());
        Ok(Some(layout))
    }

    /// One of the grids of another object.
    fn laid_grid(&self, laid: &LaidGrid) -> Result<QuadGrid> {
        let Some(source) = self.sources.last() else { return Err(self.unfit("`grid` names no object")) };
        let (of, piece) = (&laid.of, laid.piece.unwrap_or_default());
        let Some(grids) = source.item.grids().map(GridObject::grids) else {
            let kind = source.provenance.kind;
            let message = format!("`{of}` is of type `{kind}`: grids come from a `principal-grid`");
            return Err(Error::Input(self.diagnostic(["grid".into(), "of".into()], &message)));
        };
        grids.get(piece as usize).cloned().ok_or_else(|| {
            let count = grids.len();
            let message = format!("there is no grid {piece}: `{of}` has {count} grid(s), numbered from 0");
            Error::Input(self.diagnostic(["grid".into(), "piece".into()], &message))
        })
    }

    /// Reads the mesh in a file of its own: the grids of one with extraordinary vertices, else none, and the grid is at hand.
    fn mesh_file(&mut self, file: &MeshFile) -> Result<Option<QuadLayout>> {
        let (name, bytes) = self.file(&file.obj, ["grid", "obj"])?;
        let mesh = read_quads(&name, &bytes).map_err(|message| match InputKind::of_bytes(&bytes) {
            None | Some(InputKind::Mesh) => Error::Input(message),
            Some(found) => {
                let other = if found == InputKind::PolygonMesh { "a mesh in another format" } else { found.name() };
                let text = format!("{name} is {other}, not a mesh (OBJ)");
                Error::Input(self.diagnostic(["grid".into(), "obj".into()], &text))
            }
        })?;
        let (ObjQuads::Grid(ObjGrid { unused, .. }) | ObjQuads::Layout(ObjLayout { unused, .. })) = &mesh;
        if let Some(first) = unused.first() {
            let message =
                format!("{} point(s) not used by any face are ignored; the first is number {first}", unused.len());
            self.remark("points-unused", None, None, Some(name.clone()), message);
        }
        let (ObjQuads::Grid(ObjGrid { mended, .. }) | ObjQuads::Layout(ObjLayout { mended, .. })) = &mesh;
        if mended.merged > 0 {
            self.remark("vertices-merged", None, None, Some(name.clone()), merged_vertices(mended.merged));
        }
        if let Some(line) = mended.turned.first() {
            let message = turned_faces(mended.turned.len(), &format!("in line {line}"));
            self.remark("faces-turned", None, None, Some(name.clone()), message);
        }
        self.mesh_name = Some(name.clone());
        match mesh {
            ObjQuads::Layout(mesh) => Ok(Some(mesh.layout)),
            ObjQuads::Grid(ObjGrid { grid, numbers, .. }) => {
                self.mesh = Some(MeshNames { name, grid, numbers });
                Ok(None)
            }
        }
    }

    /// Vertices of a mesh of quads: by their numbers in its file, or by the place of the first where it was laid.
    pub(in crate::document) fn named_points(&self, layout: &QuadLayout, vertices: &[usize]) -> String {
        if let (Some(of), Some(first)) = (&self.laid_of, vertices.first()) {
            let [x, y, z] = layout.points()[*first].to_array().map(ShortNumber);
            return format!("the point of `{of}` at {x}, {y}, {z}");
        }
        let numbers: Vec<String> = vertices.iter().map(|v| (v + 1).to_string()).collect();
        let plural = if numbers.len() == 1 { "" } else { "s" };
        format!("point{plural} {} of {}", numbers.join(", "), self.mesh_name())
    }

    /// The file of the mesh.
    pub(in crate::document) fn mesh_name(&self) -> &str {
        self.mesh_name.as_deref().unwrap_or("the mesh")
    }

    /// Warns of a net that its frame folded.
    pub(in crate::document) fn warn_of_folds(
        &mut self,
        spec: &CyclidicNetSpec,
        surfaces: &[SurfaceObject],
        bodies: &[Body],
    ) {
        let nets = surfaces.iter().flat_map(SurfaceObject::nets);
        let singular: Vec<[usize; 2]> = nets.flat_map(|net| net.singular_patches()).map(|patch| patch.quad).collect();
        let joints = SurfaceJointReport::new(bodies.iter().flat_map(Body::shells));
        if singular.is_empty() && joints.creases == 0 {
            return;
        }
        let first = match surfaces {
            [SurfaceObject::Layout(layout), ..] => first_singular(layout),
            [SurfaceObject::Net(net), ..] => singular.first().map(|[i, j]| j * net.size()[0] + i),
            _ => None,
        };
        let warning = Warning::Net(NetWarning::Folded {
            singular: singular.len(),
            first,
            creases: joints.creases,
            angle: joints.crease_angle,
        });
        let hint = match spec.frame {
            FrameSpec::Auto if matches!(surfaces, [SurfaceObject::Layout(_), ..]) => "smooth the mesh",
            FrameSpec::Auto => "smooth the grid, or set a frame",
            FrameSpec::First(_) => "use the frame \"auto\" or another one",
        };
        self.remarks.push(Remark { message: format!("{warning}; {hint}"), ..warning.into() });
    }

    /// Warns of borders of the grid, as given or as made, that nearly coincide: the net is open there.
    pub(in crate::document) fn warn_of_seams(&mut self, surfaces: &[SurfaceObject]) {
        for net in surfaces.iter().filter_map(SurfaceObject::as_net) {
            for (seam, measure) in measured_seams(net, self.facts.net().map_or(&[], |facts| &facts.seams)) {
                let border = ["column", "row"][seam.direction];
                let Some(message) = seam_words(seam, measure, net.grid(), self.document.units) else { continue };
                let warning = Warning::Net(NetWarning::OpenSeam { border, gap: measure.gap, angle: measure.angle });
                self.remarks.push(Remark { message, ..warning.into() });
            }
        }
    }

    /// The message for what the kernel said about a quad, a vertex or the frame of a net.
    pub(in crate::document) fn refused_in_grid(
        &self,
        net: &CyclidicNetSpec,
        grid: &QuadGrid,
        error: &KernelError,
    ) -> Error {
        match error {
            KernelError::Patch(PatchError::FrameNotOrthonormal { .. }) => {
                let words = match net.frame {
                    FrameSpec::First(frame) => frame_words(frame),
                    FrameSpec::Auto => error.to_string(),
                };
                return self.refused_in_words([Step::from("frame")], error.reason(), words);
            }
            KernelError::Number(NumberError::NotFinite { what: ErrorItem::FrameVector, .. }) => {
                return self.refused_at([Step::from("frame")], error);
            }
            _ => {}
        }
        if let KernelError::Grid(GridError::NotConverged { .. }) = error {
            let hint = "a border that may move gives more freedom: `free`, or sides on curves";
            let bound = !net.make_circular.border_is_free();
            let words = if bound { format!("{error}; {hint}") } else { error.to_string() };
            return self.refused_in_words([Step::from("make_circular")], error.reason(), words);
        }
        if let KernelError::Grid(GridError::ShapeLost { .. }) = error {
            let laid = matches!(net.grid, GridSource::Laid(_));
            let lays = if laid { "" } else { " (a `principal-grid` computes such a grid on a mesh)" };
            let words = format!(
                "{error}{lays}; or accept the net as it is with `\"allow_shape_change\": true` in `make_circular`"
            );
            return self.refused_in_words([Step::from("make_circular")], error.reason(), words);
        }
        if let KernelError::Grid(
            GridError::CollapsedOnCurve { .. } | GridError::CellsUnfit { fault: GridCellFault::Curves, .. },
        ) = error
        {
            return self.refused_at(["make_circular".into(), "border".into()], error);
        }
        if let KernelError::Number(NumberError::ParameterOutOfRange { name: ErrorItem::MaxSteps, .. }) = error {
            return self.refused_at(["make_circular".into(), "max_steps".into()], error);
        }
        let words = hint(error, grid, &net.make_circular).map_or(error.to_string(), |hint| format!("{error}; {hint}"));
        match (error, error.index()) {
            (KernelError::Point(PointError::CoincidentPoints { first, second, .. }), _) => {
                self.refused_at_vertices(net, grid, &[*second, *first], error.reason(), error.to_string())
            }
            (KernelError::Part(PartError::InQuad { quad, cause }), _)
                if matches!(**cause, KernelError::Patch(PatchError::CrossingQuad { .. })) =>
            {
                self.refused_at_quad(net, grid, *quad, error.reason(), format!("{error}; {ROW_BY_ROW}"))
            }
            (_, Some(quad)) => self.refused_at_quad(net, grid, quad, error.reason(), words),
            (_, None) => self.refused_in_words([Step::from("grid")], error.reason(), words),
        }
    }

    /// The message at a quad: where its first corner stands.
    pub(in crate::document) fn refused_at_quad(
        &self,
        net: &CyclidicNetSpec,
        grid: &QuadGrid,
        quad: usize,
        reason: &'static str,
        words: String,
    ) -> Error {
        let columns = grid.quads()[0];
        self.refused_at_vertices(net, grid, &grid.corners(quad % columns, quad / columns), reason, words)
    }

    /// The message at the first of some vertices; of a mesh in a file with the numbers of all of them.
    fn refused_at_vertices(
        &self,
        net: &CyclidicNetSpec,
        grid: &QuadGrid,
        vertices: &[usize],
        reason: &'static str,
        words: String,
    ) -> Error {
        if let Some(mesh) = &self.mesh {
            let numbers: Vec<String> = vertices.iter().map(|&v| mesh.numbers[v].to_string()).collect();
            let words = format!("{words} (points {} of {})", numbers.join(", "), mesh.name);
            return self.refused_in_words([Step::from("grid")], reason, words);
        }
        let columns = grid.size()[0];
        let [row, column] = [vertices[0] / columns, vertices[0] % columns];
        if let GridSource::Laid(laid) = &net.grid {
            let words = format!(
                "{words} (at row {row}, column {column} of grid {} of `{}`)",
                laid.piece.unwrap_or_default(),
                laid.of
            );
            return self.refused_in_words([Step::from("grid")], reason, words);
        }
        self.refused_in_words(["grid".into(), row.into(), column.into()], reason, words)
    }
}

/// The first quad of the mesh whose patch is singular.
fn first_singular(layout: &NetLayout) -> Option<usize> {
    let pieces = layout.layout().pieces().iter().zip(layout.nets());
    let quads = pieces.flat_map(|(piece, net)| {
        let columns = net.size()[0];
        net.singular_patches().into_iter().filter_map(move |patch| piece.quads[patch.quad[0] + patch.quad[1] * columns])
    });
    quads.min()
}
