//! Tori and curves on them: the constructs of `docs/math/reference-cases.md#tori`.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault};
use super::check::Check;
use crate::torus_splines::{faults, off_torus, winding};
use cyclide::{
    Frame, Point2, Vec2,
    construct::{ProjectiveBiarc, TorusSplineOptions, TorusTangent, TorusWinding, TwoTypeBiarc},
    curve::ParamCurve,
    surface::{CircleFamily, QuarticType, Torus, TorusClasses, TorusSpline},
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "torus-eval" => evaluation,
        "torus-inverse" => inverse,
        "torus-circle" => circle,
        "type-switch" => switch,
        "rp1-biarc" => projective_biarc,
        "torus-quartic-biarc" => quartic_biarc,
        "two-type-biarc" => two_type_biarc,
        "torus-spline" => spline,
        _ => return None,
    })
}

pub(super) fn malformed(what: &str) -> Fault {
    Fault::Malformed(format!("input `{what}` is not of its type"))
}

/// The rule of these constructs: `rtol` times the field `scale`, or times 1 plus the size of the expected numbers.
pub(super) fn allowed(case: &Case, check: &mut Check) -> impl Fn(&[f64]) -> f64 + use<> {
    let (rtol, scale) = (case.rtol(), check.number_expected("scale"));
    check.agree("scale");
    move |want| rtol * scale.unwrap_or_else(|| 1.0 + want.iter().fold(0.0, |sum: f64, x| sum.hypot(*x)))
}

fn torus(case: &Case) -> Result<Torus, Fault> {
    Ok(Torus::new(Frame::WORLD, case.number("a")?, case.number("b")?)?)
}

fn place(case: &Case, name: &str) -> Result<Point2, Fault> {
    case.pair(name).map(Point2::from)
}

fn rate(case: &Case, name: &str) -> Result<Vec2, Fault> {
    case.pair(name).map(|[a, b]| Vec2::new(a, b))
}

pub(super) fn kind(value: &Value) -> Result<QuarticType, Fault> {
    let family = |k: usize| {
        let index = value[k].as_u64().and_then(|i| usize::try_from(i).ok()).ok_or_else(|| malformed("type"))?;
        CircleFamily::ALL.get(index).copied().ok_or_else(|| malformed("type"))
    };
    QuarticType::between(family(0)?, family(1)?).ok_or_else(|| malformed("type"))
}

fn evaluation(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let torus = torus(case)?;
    let z = super::check::rows::<2>(case.input("z")?).ok_or_else(|| malformed("z"))?;
    let z = <[[f64; 2]; 4]>::try_from(z).map_err(|_| malformed("z"))?;
    let classes = TorusClasses::new(z)?;
    let (p, allowed) = (torus.point_of_classes(&classes), allowed(case, check));
    check.vector("point", Some(&xyz(p)), &allowed);
    // The angles of the classes lead to the same point.
    check.vector("point", Some(&xyz(torus.point(classes.place()))), &allowed);
    Ok(())
}

fn inverse(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let torus = torus(case)?;
    let p = case.point("point")?;
    let place = torus.locate(p, 1e-9 * torus.major_radius())?;
    let speed = torus.rate(place, case.vector("tangent")?);
    let allowed = allowed(case, check);
    let numbers = [
        ("cos2A", (2.0 * place.x).cos()),
        ("sin2A", (2.0 * place.x).sin()),
        ("cos2B", (2.0 * place.y).cos()),
        ("sin2B", (2.0 * place.y).sin()),
        ("dA", speed.x),
        ("dB", speed.y),
    ];
    for (field, got) in numbers {
        check.number(field, Some(got), &allowed);
    }
    let Some(rates) = check.want_raw("local_rates") else { return Ok(()) };
    check.nested("local_rates", "", rates, |inner| {
        for kind in QuarticType::ALL {
            let [i, j] = kind.families().map(CircleFamily::index);
            inner.vector(&format!("{i}{j}"), Some(&kind.local(speed)), &allowed);
        }
    });
    Ok(())
}

fn circle(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let torus = torus(case)?;
    let index = usize::try_from(case.count("family")?).unwrap_or(usize::MAX);
    let family = *CircleFamily::ALL.get(index).ok_or_else(|| malformed("family"))?;
    let at = Point2::new(case.number("A")?, case.number("B")?);
    let circle = torus.circle(family, at)?;
    let allowed = allowed(case, check);
    check.vector("centre", Some(&xyz(circle.center())), &allowed);
    check.number("radius", Some(circle.radius()), &allowed);
    let want = check.want_raw("normal_up_to_sign").and_then(super::check::numbers).unwrap_or_default();
    let normal = triple(circle.normal());
    let same_side = normal.iter().zip(&want).map(|(n, w)| n * w).sum::<f64>() >= 0.0;
    // A direction has no length: the size of the torus says nothing about its digits.
    let rtol = case.rtol();
    check.vector("normal_up_to_sign", Some(&normal.map(|n| if same_side { n } else { -n })), &|_| rtol);
    Ok(())
}

fn switch(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (from, to) = (kind(case.input("from")?)?, kind(case.input("to")?)?);
    let z = super::check::rows::<2>(case.input("z")?).ok_or_else(|| malformed("z"))?;
    let z = <[[f64; 2]; 2]>::try_from(z).map_err(|_| malformed("z"))?;
    let allowed = allowed(case, check);
    check.vector("rates", Some(&to.local(from.back(case.pair("rates")?))), &allowed);
    let doubled: Vec<f64> = from.switch(to, z)?.into_iter().flat_map(|[x, y]| [x * x - y * y, 2.0 * x * y]).collect();
    let solutions = check.want_raw("solutions_double_angle").and_then(Value::as_array).cloned().unwrap_or_default();
    let error = |want: &Value| {
        let want = super::check::rows::<2>(want).unwrap_or_default().concat();
        let square = |sum: f64, (a, b): (&f64, &f64)| sum.hypot(a - b);
        if want.len() == 4 { want.iter().zip(&doubled).fold(0.0, square) } else { f64::INFINITY }
    };
    let nearest = solutions.iter().map(error).fold(f64::INFINITY, f64::min);
    // Both numbers have length 1.
    check.measure("solutions_double_angle", "", nearest, 2.0 * case.rtol());
    Ok(())
}

fn projective_biarc(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let slopes = [case.number("m0")?, case.number("m1")?];
    let lengths = [case.number("h0")?, case.number("h1")?];
    let biarc = ProjectiveBiarc::new(case.number("alpha0")?, case.number("delta")?, slopes, lengths)?;
    let allowed = allowed(case, check);
    check.number("mid_offset", Some(biarc.mid_offset()), &allowed);
    let rtol = case.rtol();
    check.number("mid_slope", Some(biarc.mid_slope()), &|want| rtol * want[0].abs());
    check.samples("offset_samples", |u| vec![biarc.offset(u)], &allowed);
    Ok(())
}

fn quartic_biarc(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let torus = torus(case)?;
    let (start, end) = (place(case, "P0")?, place(case, "P1")?);
    let rates = [rate(case, "v0")?, rate(case, "v1")?];
    let lengths = [case.number("h0")?, case.number("h1")?];
    let kind = kind(case.input("type")?)?;
    let curve = TorusSpline::quartic_biarc(&torus, kind, start, end - start, rates, lengths)?;
    let rtol = case.rtol();
    let plane = move |want: &[f64]| rtol * (1.0 + want.iter().fold(0.0, |sum: f64, x| sum.hypot(*x)));
    let middle = curve.unrolled_place(1, 0.0);
    check.vector("mid", Some(&[middle.x, middle.y]), &plane);
    let speed = curve.unrolled_rate(0, 1.0);
    check.vector("mid_rate", Some(&[speed.x, speed.y]), &plane);
    let allowed = allowed(case, check);
    check.samples("samples", |u| xyz(curve.jet_at_knot(u).point), &allowed);
    check.vector("tangent_start", Some(&triple(curve.jet_at_knot(0.0).d1)), &allowed);
    check.vector("tangent_end", Some(&triple(curve.jet_at_knot(lengths[0] + lengths[1]).d1)), &allowed);
    let rows = curve.pieces().iter().flat_map(|piece| {
        let rows = torus.piece_to_rational(piece).rows().to_vec();
        let first = rows[0][3];
        rows.into_iter().map(move |[x, y, z, w]| vec![x / w, y / w, z / w, w / first])
    });
    if check.largest_expected("bezier_pieces_w0_is_1", 0) > 0.0 {
        check.table("bezier_pieces_w0_is_1", &rows.collect::<Vec<_>>(), &allowed);
    }
    Ok(())
}

fn two_type_biarc(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let kinds = [kind(case.input("type0")?)?, kind(case.input("type1")?)?];
    let (start, end) = (place(case, "P0")?, place(case, "P1")?);
    let rates = [rate(case, "v0")?, rate(case, "v1")?];
    let all = TwoTypeBiarc::all(kinds, start, end - start, rates, [case.number("h0")?, case.number("h1")?])?;
    let wanted = check.want_raw("solutions").and_then(Value::as_array).cloned().unwrap_or_default();
    if wanted.len() != all.len() || wanted.is_empty() {
        check.fail("solutions", format!("{} solutions, expected {}", all.len(), wanted.len()));
    }
    for want in &wanted {
        let numbers = ["mid", "mid_rate"].map(|name| super::check::numbers(&want[name]).unwrap_or_default()).concat();
        let error = |biarc: &TwoTypeBiarc| {
            let (middle, speed) = biarc.middle();
            let got = [middle.x, middle.y, speed.x, speed.y];
            let largest = |m: f64, (g, w): (&f64, &f64)| m.max((g - w).abs() / (1.0 + w.abs()));
            if numbers.len() == 4 { got.iter().zip(&numbers).fold(0.0, largest) } else { f64::INFINITY }
        };
        let nearest = all.iter().map(error).fold(f64::INFINITY, f64::min);
        check.measure("solutions", "", nearest, case.rtol());
    }
    Ok(())
}

/// Tangents that are null are free.
fn tangents(case: &Case) -> Result<Vec<TorusTangent>, Fault> {
    let list = case.input("tangents_AB")?.as_array().ok_or_else(|| malformed("tangents_AB"))?;
    let tangent = |value: &Value| match super::check::numbers(value).as_deref() {
        Some([a, b]) => Ok(TorusTangent::Rate(Vec2::new(*a, *b))),
        None if value.is_null() => Ok(TorusTangent::Free),
        _ => Err(malformed("tangents_AB")),
    };
    list.iter().map(tangent).collect()
}

fn spline(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let torus = torus(case)?;
    let places = case.planar_points("points_AB")?;
    let tangents = tangents(case)?;
    let asked = match case.input("winding")? {
        Value::Null => None,
        value => {
            let pair = super::check::numbers(value).ok_or_else(|| malformed("winding"))?;
            Some(<[f64; 2]>::try_from(pair).map_err(|_| malformed("winding"))?.map(|x| x as i32))
        }
    };
    let winding_option = asked.map_or(TorusWinding::Shortest, TorusWinding::Total);
    let closed = case.flag("closed")?;
    let options = TorusSplineOptions { closed, tangents, winding: winding_option, ..Default::default() };
    let spline = TorusSpline::through_places(&torus, &places, &options)?;
    let allowed = allowed(case, check);
    let jets: Vec<_> = (0..places.len()).map(|i| spline.jet_at_knot(i as f64)).collect();
    check.points("points", jets.iter().map(|jet| xyz(jet.point)), &allowed);
    check.points("tangents", jets.iter().map(|jet| triple(jet.d1)), &allowed);
    let found = faults(&spline);
    let winds = asked.is_none_or(|asked| winding(&spline) == asked.map(i64::from));
    for property in check.want_raw("properties").and_then(Value::as_array).cloned().unwrap_or_default() {
        match property.as_str() {
            // Compared above.
            Some("interpolates") => {}
            Some("C1" | "degree-4-pieces") if found.is_empty() => {}
            Some("on-torus")
                if (0..=1000).all(|k| {
                    off_torus(&torus, spline.point(f64::from(k) / 1000.0)) <= 1e-13 * (1.0 + torus.major_radius())
                }) => {}
            Some("winding") if winds => {}
            other => check.fail("properties", format!("{other:?} does not hold: {found:?}")),
        }
    }
    Ok(())
}
