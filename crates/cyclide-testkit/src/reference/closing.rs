//! Closed nets: the constructs of `docs/math/reference-cases.md#closed-nets`.

use super::Handler;
use super::arc::triple;
use super::case::{Case, Fault, malformed};
use super::check::{Check, rows};
use cyclide::{
    Point3, Vec3,
    surface::{QuadGrid, RingClosing, StripClosing},
};
use cyclide::{
    curve::CORNER_ANGLE,
    surface::{CyclidicNet, NetFrame},
    topology::surface_joints,
};
use cyclide_grids::{CircularMeshOptions, make_circular};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "ring-closing" => ring,
        "strip-closing" => strips,
        "closed-circular-net" => net,
        _ => return None,
    })
}

/// Moves that the independent search found are matched up to this part of an edge besides their factor: different paths
/// end in different nets of one family.
const MOVE_MARGIN: f64 = 0.01;

fn ring(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (points, direction) = (case.points("points")?, case.vectors("direction")?);
    let ring = RingClosing::new(&points)?;
    let product = ring.product();
    let (rtol, size) = (case.rtol(), check.largest_expected("product", 0));
    let allowed = |_: &[f64]| rtol * size;
    check.vector("product", Some(&[product.w, product.x, product.y, product.z]), &allowed);
    check.vector("equations", Some(&ring.equations()), &allowed);
    check.number("angle", Some(ring.angle()), &allowed);
    check.vector("axis", ring.axis().map(triple).as_ref().map(<[f64; 3]>::as_slice), &allowed);
    let along = |gradient: Vec<Vec3>| gradient.iter().zip(&direction).map(|(g, d)| g.dot(*d)).sum::<f64>();
    let derivative: Vec<f64> = ring.gradients().into_iter().map(along).collect();
    let edges = (0..points.len()).map(|k| points[k].distance(points[(k + 1) % points.len()]));
    let speed = speed(direction.iter()) / edges.fold(f64::INFINITY, f64::min);
    check.vector("derivative", Some(&derivative), &|_| rtol * size * speed);
    Ok(())
}

/// The length of a move of all points.
fn speed<'a>(direction: impl Iterator<Item = &'a Vec3>) -> f64 {
    direction.map(|d| d.length_squared()).sum::<f64>().sqrt()
}

/// Rows along s of a table with s along its columns.
fn transposed(case: &Case, name: &str) -> Result<(Vec<[f64; 3]>, [usize; 2]), Fault> {
    let columns = case.input(name)?.as_array().ok_or_else(|| malformed(name))?;
    let columns: Vec<Vec<[f64; 3]>> =
        columns.iter().map(rows::<3>).collect::<Option<_>>().ok_or_else(|| malformed(name))?;
    let n = columns.first().map_or(0, Vec::len);
    if columns.iter().any(|column| column.len() != n) {
        return Err(malformed(name));
    }
    let all = (0..n).flat_map(|j| columns.iter().map(move |column| column[j]));
    Ok((all.collect(), [columns.len(), n]))
}

fn grid(case: &Case) -> Result<QuadGrid, Fault> {
    let (points, size) = transposed(case, "points")?;
    let flags = case.input("closed")?.as_array().ok_or_else(|| malformed("closed"))?;
    let flags: Vec<bool> = flags.iter().map(serde_json::Value::as_bool).collect::<Option<_>>().unwrap_or_default();
    let closed = flags.try_into().map_err(|_| malformed("closed"))?;
    Ok(QuadGrid::new(points.into_iter().map(Point3::from).collect(), size, closed)?)
}

fn strips(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let grid = grid(case)?;
    let direction: Vec<Vec3> = transposed(case, "direction")?.0.into_iter().map(Vec3::from).collect();
    let (mut equations, mut derivative, mut shortest) = (Vec::new(), Vec::new(), f64::INFINITY);
    for d in (0..2).filter(|d| grid.closed()[*d]) {
        for k in 0..grid.quads()[1 - d] {
            let quad = |i: usize| if d == 0 { grid.corners(i, k) } else { grid.corners(k, i) };
            let quads: Vec<[usize; 4]> = (0..grid.quads()[d]).map(quad).collect();
            let strip = StripClosing::new(quads.iter().map(|quad| quad.map(|v| grid.points()[v])).collect())?;
            equations.push(strip.equation());
            let along = |(quad, row): (&[usize; 4], [Vec3; 4])| {
                quad.iter().zip(row).map(|(v, g)| g.dot(direction[*v])).sum::<f64>()
            };
            derivative.push(quads.iter().zip(strip.gradients()).map(along).sum());
            let edges = quads.iter().flat_map(|&[a, b, c, e]| [[a, b], [a, c], [b, e], [c, e]]);
            let lengths = edges.map(|[a, b]| grid.points()[a].distance(grid.points()[b]));
            shortest = lengths.fold(shortest, f64::min);
        }
    }
    let rtol = case.rtol();
    check.vector("equations", Some(&equations), &|_| rtol);
    check.vector("derivative", Some(&derivative), &|_| rtol * speed(direction.iter()) / shortest);
    Ok(())
}

fn net(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let grid = grid(case)?;
    let options = CircularMeshOptions { allow_shape_change: true, ..Default::default() };
    let made = make_circular(&grid, &options)?;
    let report = &made.report;
    check.at_most("residual_max", report.residual_after);
    let closing = [made.grid.closing(0)?, made.grid.closing(1)?].into_iter().flatten();
    let [angle, stretch] = closing.fold([0.0_f64; 2], |most, c| [most[0].max(c.angle), most[1].max(c.stretch)]);
    check.at_most("angle_max", angle);
    check.at_most("stretch_max", stretch);
    let edge = check.number_expected("median_edge").unwrap_or(f64::NAN);
    let factor = check.number_expected("move_factor").unwrap_or(f64::NAN);
    for (field, got) in [("move_max", report.moves.max), ("move_mean", report.moves.mean)] {
        let most = factor * check.number_expected(field).unwrap_or(f64::NAN) + MOVE_MARGIN * edge;
        // Less is as good.
        check.number(field, Some(got), &|want| if got <= want[0] { want[0] } else { most - want[0] });
    }
    // Both are of the rule above; a median of an even number of edges may be another.
    check.agree("move_factor");
    check.agree("median_edge");
    if check.number_expected("steps_about") == Some(0.0) {
        // There is nothing to do: the grid comes back bit for bit.
        check.exact("steps_about", report.steps);
        if made.grid != grid {
            check.fail("steps_about", "the grid has changed".into());
        }
    } else {
        check.agree("steps_about");
    }
    let net = CyclidicNet::new(made.grid, NetFrame::Auto)?;
    check.exact("singular", net.singular_patches().len());
    let creases = surface_joints(&net.to_shell()?).iter().filter(|joint| joint.angle > CORNER_ANGLE).count();
    check.exact("creases", creases);
    Ok(())
}
