//! Grids whose vertices are moved until every quad has a circle.

use cyclide::{
    curve::ParamCurve,
    model::CurveObject,
    surface::{QuadGrid, QuadLayout},
};
use cyclide_grids::{
    Border, CircularMeshOptions, CircularMeshReport, CircularMeshStep, make_circular_watched,
    make_layout_circular_watched,
};

use super::build::ROW_BY_ROW;
use crate::document::kinds::cyclidic_net::CyclidicNetSpec;
use crate::document::kinds::cyclidic_net::make_circular::{BorderSpec, BorderWord, MakeCircularOptions};
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::facts::{Facts, NetFacts};
use crate::document::objects::remark::Remark;
use crate::error::{CROSSING_QUAD, Error, Result, rejected_quads};

impl<'a> Builder<'a> {
    /// Moves the vertices so that every quad has a circle.
    pub(in crate::document) fn circular(
        &mut self,
        spec: &CyclidicNetSpec,
        given: &MakeCircularOptions,
        grid: &QuadGrid,
    ) -> Result<QuadGrid> {
        let curves = self.border_curves(spec)?;
        let options = options(given, curves);
        let progress = &mut *self.progress;
        let mesh = make_circular_watched(grid, &options, &mut |step| progress(words(step)));
        let mesh = mesh.map_err(|e| self.refused_in_grid(spec, grid, &e))?;
        self.remarks.extend(mesh.warnings().iter().cloned().map(Remark::from));
        if let [first, ..] = mesh.report.rejected_quads[..] {
            return Err(self.rejected_quads(spec, grid, first, &mesh.report));
        }
        let facts = NetFacts { seams: grid.seams(), circular: Some(mesh.report) };
        self.facts = Facts::Net(Box::new(facts));
        Ok(mesh.grid)
    }

    /// The same for all grids of a mesh, round its extraordinary vertices.
    pub(in crate::document) fn circular_layout(
        &mut self,
        spec: &CyclidicNetSpec,
        given: &MakeCircularOptions,
        layout: &QuadLayout,
    ) -> Result<QuadLayout> {
        let options = options(given, [None; 4]);
        let progress = &mut *self.progress;
        let made = make_layout_circular_watched(layout, &options, &mut |step| progress(words(step)));
        let made = made.map_err(|e| self.refused_in_layout(spec, layout, &e))?;
        for warning in made.warnings() {
            let mut remark = Remark::from(warning.clone());
            if let Some(vertex) = warning.index() {
                remark.message += &format!(" ({})", self.named_points(layout, &[vertex]));
            }
            self.remarks.push(remark);
        }
        if let [first, ..] = made.report.rejected_quads[..] {
            let (quads, steps, moved) = (&made.report.rejected_quads, made.report.steps, made.report.moves.max);
            let corners = layout.corners(first).unwrap_or_default();
            let words = format!(
                "{} (the first has the {})",
                rejected_quads(quads, steps, moved),
                self.named_points(layout, &corners).trim_start_matches("the ")
            );
            return Err(self.refused_in_words([Step::from("grid")], CROSSING_QUAD, words));
        }
        let facts = NetFacts { seams: Vec::new(), circular: Some(made.report) };
        self.facts = Facts::Net(Box::new(facts));
        Ok(made.layout)
    }

    /// The curves of the sides, in the kernel's order.
    fn border_curves(&self, spec: &CyclidicNetSpec) -> Result<[Option<&'a dyn ParamCurve>; 4]> {
        let mut curves = [None; 4];
        let Some(given) = spec.make_circular.border_curves() else { return Ok(curves) };
        let named = given.sides().into_iter().enumerate().filter(|(_, (_, name))| name.is_some());
        for ((side, (field, _)), source) in named.zip(&self.sources) {
            let [curve] = source.item.curves() else {
                let message = format!("`{}` is not one connected curve", source.item.name);
                let steps = ["make_circular".into(), "border".into(), field.into()];
                return Err(Error::Input(self.diagnostic(steps, &message)));
            };
            curves[side] = Some(CurveObject::as_curve(curve));
        }
        Ok(curves)
    }

    /// The message about quads of the circular grid that no patch fits into, at the first of them.
    fn rejected_quads(
        &self,
        net: &CyclidicNetSpec,
        grid: &QuadGrid,
        first: usize,
        report: &CircularMeshReport,
    ) -> Error {
        let (quads, steps, moved) = (&report.rejected_quads, report.steps, report.moves.max);
        if self.document.text.is_empty() {
            return Error::RejectedQuads { object: self.name.to_owned(), quads: quads.clone(), steps, moved };
        }
        let words = format!("{}; {ROW_BY_ROW}", rejected_quads(quads, steps, moved));
        self.refused_at_quad(net, grid, first, CROSSING_QUAD, words)
    }
}

/// The kernel's options.
pub(in crate::document) fn options<'a>(
    given: &MakeCircularOptions,
    curves: [Option<&'a dyn ParamCurve>; 4],
) -> CircularMeshOptions<'a> {
    let border = match &given.border {
        BorderSpec::Word(BorderWord::Free) => Border::Free,
        BorderSpec::Word(BorderWord::Pinned) => Border::Pinned,
        BorderSpec::Curves(_) => Border::OnCurves(curves),
    };
    let max_steps = given.max_steps.map_or(CircularMeshOptions::default().max_steps, |n| n as usize);
    CircularMeshOptions { border, max_steps, allow_shape_change: given.allow_shape_change }
}

/// A step, for a line of progress.
pub(in crate::document) fn words(step: &CircularMeshStep) -> String {
    format!("circular quads: step {}, residual {}", step.step, cyclide::ShortNumber(step.residual))
}
