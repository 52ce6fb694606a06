//! Bodies as exact rational surfaces with positive weights: patches of degree (2, 2), rational faces of theirs.

use super::push_numbers;
use crate::export::error::ExportError;
use crate::export::face_plan::ShellPlan;
use crate::export::parts::BodyOf;
use crate::text::number::push_plain;
use cyclide::{
    rational::RationalBezierSurface,
    topology::{CutShell, FaceGeometry as _, Shell},
};

/// Writes a body as one element of the list `surfaces`: patches whose weights are not all positive are cut. Gives what its
/// patches stand for.
pub(super) fn push_body(out: &mut String, body: &BodyOf<'_>) -> Result<Vec<ShellPlan>, ExportError> {
    let cut = |shell: &Shell| CutShell::from(shell.clone()).with_positive_weights();
    let shells = body.body.shells().map(cut).collect::<cyclide::Result<Vec<_>>>();
    out.push_str(&format!("{{\"closed\": {}, \"exact\": true, \"shells\": [", body.body.is_solid()));
    let mut plans = Vec::new();
    for (i, cut) in shells.map_err(|source| body.unfit(source))?.iter().enumerate() {
        out.push_str(if i == 0 { "\n{\"patches\": [" } else { ",\n{\"patches\": [" });
        for (j, face) in cut.shell().faces().iter().enumerate() {
            out.push_str(if j == 0 { "\n" } else { ",\n" });
            out.push_str(&format!("{{\"outward\": {}, ", face.same_sense));
            push_surface(out, &face.surface.to_rational());
        }
        out.push_str("]}");
        plans.push(ShellPlan::of_parts(i, cut.parts()));
    }
    out.push_str("]}");
    Ok(plans)
}

fn push_surface(out: &mut String, surface: &RationalBezierSurface) {
    let degrees = surface.degrees();
    out.push_str(&format!("\"degrees\": [{}, {}], \"knots\": [", degrees[0], degrees[1]));
    for (i, degree) in degrees.into_iter().enumerate() {
        out.push_str(if i == 0 { "" } else { ", " });
        push_numbers(out, &[vec![0.0; degree + 1], vec![1.0; degree + 1]].concat());
    }
    out.push_str("], \"control_points\": [");
    for (i, [x, y, z, w]) in surface.rows().iter().enumerate() {
        out.push_str(if i == 0 { "" } else { ", " });
        push_numbers(out, &[x / w, y / w, z / w]);
    }
    out.push_str("], \"weights\": [");
    for (i, row) in surface.rows().iter().enumerate() {
        out.push_str(if i == 0 { "" } else { ", " });
        push_plain(out, row[3]);
    }
    out.push_str("]}");
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
mod tests {
    use crate::check::rational_patches::patches_deviation;
    use crate::export::face_plan::ShellPlan;
    use crate::export::options::ExportOptions;
    use crate::formats::json::read;
    use crate::formats::{Exporter, Format};
    use cyclide::{Point3, Vec3, model::Model, surface::CyclidePatch, topology::FacePart};

    /// Half of a plane ring, which is cut into two patches, after something was changed in what is told of them.
    fn checked(change: impl FnOnce(&mut Vec<FacePart>)) -> Result<f64, String> {
        let corners = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [-2.0, 0.0, 0.0]].map(Point3::from);
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::X).unwrap();
        let model = Model::default().with_surface("it", patch);
        let exporter = Exporter::new(&model).unwrap();
        let mut file = exporter.export(Format::Json, &ExportOptions::default()).unwrap();
        let plan = &mut file.written.shells[0][0];
        let mut parts: Vec<FacePart> = plan.parts().copied().collect();
        change(&mut parts);
        *plan = ShellPlan::of_parts(plan.shell, &parts);
        let patches = read(&file.bytes).unwrap().patches;
        assert_eq!(patches.len(), 2);
        let bodies: Vec<_> = exporter.ready.bodies.iter().collect();
        patches_deviation(&bodies, &file.written.shells, &patches).map(|off| off[0]).map_err(|e| e.to_string())
    }

    #[test]
    fn patches_are_held_against_the_uncut_face() {
        assert!(checked(|_| ()).unwrap() < 1e-14);
        assert!(checked(|parts| parts.swap(0, 1)).unwrap() > 1.0);
        let beside = checked(|parts| {
            let at = parts[0].s[1] + 1e-3;
            (parts[0].s[1], parts[1].s[0]) = (at, at);
        });
        assert!(beside.unwrap() > 1e-4);
        let refused = Err("body 0: its patches do not cover each part of its faces once".to_owned());
        // Too short by a millionth, and the first part twice.
        assert_eq!(checked(|parts| parts[1].s[1] -= 1e-6), refused);
        assert_eq!(checked(|parts| parts[1] = parts[0]), refused);
        assert_eq!(checked(|parts| parts[1].face = 1), Err("patch 1: the face does not exist".to_owned()));
        assert_eq!(checked(|parts| parts.truncate(1)), Err("2 patches in the file, 1 in the model".to_owned()));
    }
}
