//! Options that have no effect say so.
//!
//! What the command line alone tells is an error: an option of another kind of curve, of a format that is not written,
//! or one that contradicts another. What only the model tells is a warning, and the files are written: the reason is
//! [`NO_EFFECT`], as where a field of a document has none.

use std::path::PathBuf;

use cyclide::model::{CurveObject, Model, SurfaceObject};
use cyclide_io::{
    Format, Report,
    document::NO_EFFECT,
    document::kinds::MoebiusContinuity,
    export::{PictureColour, Provenance, StepEdges, StepFaces, StepProducts},
    report::GeometryReport,
};

use crate::arguments::curve::{CLOSED_KINDS, CurveArgs, Kind};
use crate::arguments::make::{MakePlan, OutputArgs};
use crate::output::failure::Failure;

/// The formats besides PNG that say what the model is called.
const TITLED: [Format; 5] = [Format::Step, Format::Glb, Format::Stl, Format::Svg, Format::ThreeMf];

/// Refuses options about formats that are not written.
pub fn refuse_formats_not_written(args: &OutputArgs, outputs: &[(PathBuf, Format)]) -> Result<(), Failure> {
    let given = [
        ("--dxf-splines", args.dxf_splines, Format::Dxf),
        ("--dxf-version", args.dxf_version.is_some(), Format::Dxf),
        ("--step-edges", args.step_edges.is_some(), Format::Step),
        ("--step-faces", args.step_faces.is_some(), Format::Step),
        ("--step-products", args.step_products.is_some(), Format::Step),
        ("--svg-comb", args.svg_comb, Format::Svg),
        ("--svg-points", args.svg_points, Format::Svg),
        ("--glb-edges", args.glb_edges, Format::Glb),
        ("--vtu-cells", args.vtu_cells.is_some(), Format::Vtu),
        ("--vtu-encoding", args.vtu_encoding.is_some(), Format::Vtu),
        ("--png-plain", args.png_plain, Format::Png),
        ("--width", args.width.is_some(), Format::Png),
        ("--height", args.height.is_some(), Format::Png),
        ("--colour", args.colour.is_some(), Format::Png),
        ("--labels", args.labels, Format::Png),
        ("--camera", args.camera.is_some(), Format::Png),
        ("--axes", args.axes, Format::Png),
    ];
    let written = |format: Format| outputs.iter().any(|(_, other)| *other == format);
    let titled = |format: &Format| match format {
        Format::Png => !args.png_plain,
        other => TITLED.contains(other),
    };
    if args.title.is_some() && !outputs.iter().any(|(_, format)| titled(format)) {
        let names = TITLED.map(|format| format.name().to_uppercase()).join(", ");
        let message =
            format!("--title would have no effect: only {names}, and PNG without --png-plain, contain a title");
        return Err(Failure::Usage(message));
    }
    match given.iter().find(|(_, given, format)| *given && !written(*format)) {
        None => Ok(()),
        Some((option, _, format)) => {
            let (title, suffix) = (format.name().to_uppercase(), format.name());
            let message = format!("{option} applies only to {title} output: add -o FILE.{suffix}");
            Err(Failure::Usage(message))
        }
    }
}

/// Refuses options that the kind of curve does not have, and those that another one leaves nothing to do.
pub fn refuse_options_of_other_kinds(args: &CurveArgs, kind: Kind) -> Result<(), Failure> {
    let given = [
        ("--closed", args.closed, &CLOSED_KINDS[..]),
        ("--tension", args.tension.is_some(), &[Kind::FairSpline]),
        ("--tight", args.tight.is_some(), &[Kind::FairSpline]),
        ("--ends", args.ends.is_some(), &[Kind::FairSpline]),
        ("--straight", args.straight.is_some(), &[Kind::FairSpline]),
        ("--order", args.order.is_some(), &[Kind::CircleSpline]),
        ("--variant", args.variant.is_some(), &[Kind::CircleSpline]),
        ("--continuity", args.continuity.is_some(), &[Kind::MoebiusSpline]),
        ("--knots", args.knots.is_some(), &[Kind::MoebiusSpline]),
        ("--parameters", args.parameters.is_some(), &[Kind::QbInterpolation]),
        ("--rule", args.rule.is_some(), &[Kind::ArcSpline]),
        ("--target", args.target.is_some(), &[Kind::ArcFit]),
        ("--effort", args.effort.is_some(), &[Kind::ArcFit]),
        ("--min-arc-length", args.min_arc_length.is_some(), &[Kind::ArcFit]),
        (
            "--corner-angle-deg",
            args.corner_angle_deg.is_some(),
            &[Kind::FairSpline, Kind::CircleSpline, Kind::MoebiusSpline, Kind::ArcFit, Kind::FairFit],
        ),
        ("--smooth", args.smooth.is_some(), &[Kind::FairFit]),
        ("--noise", args.noise.is_some(), &[Kind::FairFit]),
        ("--outliers", args.outliers.is_some(), &[Kind::FairFit]),
        ("--smooth-z", args.smooth_z.is_some(), &[Kind::FairFit]),
        ("--centre", args.centre.is_some(), &[Kind::FairFit]),
        ("--fix-ends", args.fix_ends, &[Kind::FairFit]),
        ("--max-fits", args.max_fits.is_some(), &[Kind::FairFit]),
        ("--fast", args.fast, &[Kind::FairFit]),
        ("--nodes", args.nodes.is_some(), &[Kind::FairFit]),
        ("--budget", args.budget.is_some(), &[Kind::FairFit]),
        ("--polyline", args.polyline.is_some(), &[Kind::FairFit]),
    ];
    if let Some((option, _, kinds)) = given.iter().find(|(_, given, kinds)| *given && !kinds.contains(&kind)) {
        let words: Vec<&str> = kinds.iter().map(|kind| kind.word()).collect();
        let message = format!("{option} requires --kind {}, not {}", words.join(" or "), kind.word());
        return Err(Failure::Usage(message));
    }
    let no_fits = args.max_fits == Some(0);
    let by_directions = args.continuity == Some(MoebiusContinuity::G1);
    let auto = args.smooth.is_some_and(|smooth| smooth.within().is_none());
    let auto_z = args.smooth_z.is_some_and(|smooth| smooth.within().is_none());
    if args.smooth_z.is_some() && auto_z != auto {
        return Err(Failure::Usage("--smooth and --smooth-z must both be numbers or both be auto".to_owned()));
    }
    let idle = [
        ("--noise", args.noise.is_some() && !auto, "it requires --smooth auto"),
        ("--centre", args.centre.is_some() && auto, "--smooth auto already follows the middle of the points"),
        ("--knots", args.knots.is_some() && by_directions, "with --continuity g1 the curve has no knots"),
        ("--ends", args.ends.is_some() && args.closed, "a --closed curve has no ends"),
        ("--fix-ends", args.fix_ends && args.closed, "a --closed curve has no ends"),
        ("--nodes", args.nodes.is_some() && no_fits, "--max-fits 0 removes no nodes"),
        ("--budget", args.budget.is_some() && no_fits, "--max-fits 0 removes no nodes"),
    ];
    match idle.iter().find(|(_, idle, _)| *idle) {
        None => Ok(()),
        Some((option, _, why)) => Err(Failure::Usage(format!("{option} would have no effect: {why}"))),
    }
}

/// The warnings about options that this model leaves without effect, after the files were made.
pub fn without_effect(plan: &MakePlan, model: &Model, provenance: &[Provenance], report: &Report) -> Vec<String> {
    let options = &plan.options;
    let curves = || model.items.iter().flat_map(|item| item.curves());
    let no_surface = model.items.iter().all(|item| item.surfaces().is_empty() && item.volumes().is_empty());
    let bent = |geometry: &GeometryReport| matches!(geometry, GeometryReport::Curves(c) if c.curvature.max > 0.0);
    // The trigonometric curve is no spline either: it becomes one within the tolerance.
    let no_spline = curves().all(CurveObject::is_of_arcs);
    let has_joints = |curve: &CurveObject| !matches!(curve, CurveObject::Circle(_));
    let all_exact = report.files.iter().all(|file| file.exact || file.deviation.is_none());
    let faces = model.items.iter().any(|item| item.surfaces().iter().any(|surface| surface.as_triangles().is_none()));
    let names = model.items.iter().filter(|item| item.motion().is_none()).count() > 1;
    let called = provenance.iter().any(|own| !own.point_names.is_empty());
    let of_nets = |surfaces: &[SurfaceObject]| matches!(surfaces, [one] if !one.nets().is_empty());
    let panels =
        model.items.iter().any(|item| of_nets(item.surfaces())) || provenance.iter().any(|own| of_nets(&own.skin));
    let colour = options.png_colour;
    let curvature = !matches!(colour, PictureColour::Object | PictureColour::Deviation | PictureColour::Field);
    let idle = [
        ("--colour", curvature && !faces, "there are no surfaces with curvature"),
        (
            "--colour",
            colour == PictureColour::Deviation && provenance.iter().all(|own| own.given.is_none()),
            "no object approximates a given surface, as a `cyclidic-net` does with `make_circular` or over a `principal-grid`",
        ),
        (
            "--colour",
            colour == PictureColour::Field && provenance.iter().all(|own| own.field.is_none()),
            "no drawn object is a `principal-grid` (remove its `construction`)",
        ),
        (
            "--labels",
            options.png_labels && colour == PictureColour::Field,
            "a picture of lines of curvature has neither names nor panels",
        ),
        (
            "--labels",
            options.png_labels && colour != PictureColour::Field && !names && !panels && !called,
            "a single object has its name as title, and there are no panels and no named points",
        ),
        (
            "--tolerance",
            options.tolerance.is_some() && !plan.fit_tolerance && all_exact,
            "no file needs an approximation",
        ),
        ("--dxf-splines", options.dxf_splines && no_spline, "all curves are arcs and lines, which DXF holds exactly"),
        ("--step-edges", options.step_edges == StepEdges::Rational && no_surface, "there are no surfaces"),
        ("--step-faces", options.step_faces == StepFaces::Split && no_surface, "there are no surfaces"),
        (
            "--step-products",
            options.step_products != StepProducts::Auto && model.items.len() == 1,
            "a single object is always one product",
        ),
        (
            "--svg-comb",
            options.svg_comb && !report.objects.values().any(|object| !object.construction && bent(&object.geometry)),
            "all curves are straight",
        ),
        ("--svg-points", options.svg_points && !curves().any(has_joints), "no curve has joints or ends"),
        ("--glb-edges", options.glb_edges && no_surface, "there are no surfaces"),
    ];
    let told = idle.iter().filter(|(_, idle, _)| *idle);
    told.map(|(option, _, why)| format!("{option} has no effect: {why} [{NO_EFFECT}]")).collect()
}
