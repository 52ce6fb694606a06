//! Third columns without a name that may be the bulges of a polyline, as exports of drawings write them, where heights are read.

use std::f64::consts::{PI, TAU};

use cyclide::Point3;

use super::point_table::PointList;

/// The reason of what is said of them.
pub(super) const BULGES_AS_Z: &str = "bulges-as-z";

/// Largest bulge of arcs up to half a circle; few are longer.
const LARGEST: f64 = 1.0;
/// Points that may have bulges at least.
const FEWEST: usize = 4;
/// A bulge of at least this turns its arc enough to see that no straight edge goes on there.
const TURNS: f64 = 0.05;
/// Directions that differ by less, in radians, are the same: coordinates are rounded.
const SAME_DIRECTION: f64 = 0.02;

/// What third columns are by their values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ThirdColumn {
    /// Bulges: the arcs go on where the edges before and behind them end. With the number of the first arc's point, of those arcs, and of all.
    Bulges { first: usize, tangent: usize, arcs: usize },
    /// Heights or bulges: most are 0, the others at most 1.
    Either { zeros: usize, count: usize },
    /// Heights.
    Heights,
}

impl ThirdColumn {
    /// Of points whose third coordinate it is.
    pub(super) fn of(lists: &[PointList]) -> Self {
        let all = || lists.iter().flat_map(|list| &list.points);
        let (count, zeros) = (all().count(), all().filter(|p| p.z.abs() <= 0.0).count());
        let are_small = all().all(|p| p.z.abs() <= LARGEST);
        let Some(first) = all().position(|p| p.z.abs() > 0.0) else { return Self::Heights };
        if !are_small || count < FEWEST || 2 * zeros < count {
            return Self::Heights;
        }
        let arcs = count - zeros;
        let tangent = lists.iter().map(|list| tangent_arcs(&list.points)).sum();
        if 2 * tangent > arcs { Self::Bulges { first, tangent, arcs } } else { Self::Either { zeros, count } }
    }

    /// What is said of them, with the columns that leave them out and that read them; nothing of heights.
    pub(super) fn message(self, plane: &str, space: &str) -> String {
        match self {
            Self::Bulges { tangent, arcs, .. } => format!(
                "the file has no header line, and its third column holds bulges by its values ({tangent} of {arcs} arcs are tangent to the pieces beside them), but only points are read. Put points on the arcs, or take the points as they are (`--columns {plane}`, in a document `columns`); `--columns {space}` takes the values as z"
            ),
            Self::Either { zeros, count } => format!(
                "the file has no header line, and its third column is taken as z: {zeros} of {count} values are 0 and the others at most 1, as bulges of arcs are; if they are bulges, put points on the arcs, or take the points as they are (`--columns {plane}`, in a document `columns`)"
            ),
            Self::Heights => String::new(),
        }
    }
}

/// The arcs that go on in the direction of what is before them and of what is behind them.
fn tangent_arcs(points: &[Point3]) -> usize {
    let n = points.len();
    // An open polyline has no arc behind its last point: there the closing edge counts, which is the usual one.
    let direction = |i: usize| {
        let edge = points[(i + 1) % n] - points[i];
        (edge.x.hypot(edge.y) > 0.0).then(|| edge.y.atan2(edge.x))
    };
    let half_turn = |i: usize| 2.0 * points[i].z.atan();
    let goes_on = |i: usize| {
        let after = (i + 1) % n;
        let (Some(from), Some(to)) = (direction(i), direction(after)) else { return false };
        let turn = (to - half_turn(after)) - (from + half_turn(i));
        ((turn + PI).rem_euclid(TAU) - PI).abs() < SAME_DIRECTION
    };
    (0..n).filter(|&i| points[i].z.abs() > TURNS && goes_on(i) && goes_on((i + n - 1) % n)).count()
}

#[cfg(test)]
mod tests {
    use super::super::{PointColumns, PointTable, read_points};

    fn read(text: &str, columns: &[&str]) -> Result<PointTable, String> {
        let coordinates = (!columns.is_empty()).then(|| columns.iter().map(|name| (*name).to_owned()).collect());
        let columns = PointColumns { coordinates, ..PointColumns::default() };
        read_points("p.csv", text.as_bytes(), &columns).map_err(|refused| refused.message)
    }

    fn is_said(text: &str) -> bool {
        read(text, &[]).unwrap().remarks.iter().any(|remark| remark.reason == "bulges-as-z")
    }

    #[test]
    fn bulges_of_tangent_arcs_are_refused_with_both_readings() {
        for text in [
            // Two rounded corners, a slot, a rounded rectangle clockwise with decimal commas.
            "0,0,0\n100,0,0.41421356\n120,20,0\n120,80,0.41421356\n100,100,0\n0,100,0\n",
            "0 0 0\n10 0 1\n10 5 0\n0 5 1\n",
            "0;10,5;0\n0;89,5;-0,4142\n10,5;100;0\n89,5;100;-0,4142\n100;89,5;0\n100;10,5;-0,4142\n89,5;0;0\n10,5;0;-0,4142\n",
        ] {
            let refused = read(text, &[]).unwrap_err();
            assert!(refused.contains("bulges") && refused.contains("`--columns 1,2`"), "{refused}");
            assert!(refused.contains("`--columns 1,2,3`"), "{refused}");
            assert!(read(text, &["1", "2"]).unwrap().contours[0].points.iter().all(|p| p.z.abs() <= 0.0));
            assert!(read(text, &["1", "2", "3"]).unwrap().contours[0].points.iter().any(|p| p.z.abs() > 0.0));
            // A name says what it is.
            let named = text.replace(',', if text.contains(';') { "," } else { ";" });
            let header = if text.contains(' ') { "x y z" } else { "x;y;z" };
            assert!(read(&format!("{header}\n{named}"), &[]).is_ok());
        }
    }

    #[test]
    fn heights_near_zero_are_read_and_said_where_most_are_zero() {
        // A straight line with a bump, a curb, and a sheet that is folded up at right angles.
        for text in [
            "0.5,0.5,0\n10.2,0.5,0\n20.3,0.5,0.005\n30.1,0.5,0\n40.7,0.5,0\n",
            "0.5,0,0\n5.2,0.2,0\n10.1,0.1,0.12\n15.4,0.3,0.12\n20.2,0,0\n25,0.5,0\n30,0.2,0\n",
            "0.5,0,0\n10,0,0\n10,10,1\n0,10,1\n",
        ] {
            assert!(is_said(text), "{text}");
            assert!(read(text, &[]).unwrap().contours[0].points.iter().any(|p| p.z > 0.0));
        }
        for text in [
            "0.5,0,0.1\n5.2,0,0.2\n10.1,1,0.1\n15.4,0,0\n20.2,3,-0.1\n",
            "0.5,0,0\n5.2,0,0\n10.1,1,0\n15.4,0,0\n20.2,3,0\n",
            "0.5,0.5,0\n5.2,0,0\n10.1,1,0\n15.4,0,0\n20.2,3,12.5\n",
        ] {
            assert!(!is_said(text), "{text}");
        }
    }
}
