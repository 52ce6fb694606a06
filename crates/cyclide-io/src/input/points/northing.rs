//! Whether coordinates of a map stand with the northing first, by their figures: taken as x and y they are the mirror image.

use std::ops::RangeInclusive;

use cyclide::Units;

use super::sampled::Sampled;
use super::table::Table;
use super::unit::UnitWord;

/// Which of two coordinates of a map stands first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// The northing, certainly.
    Certain,
    /// It may be the northing, or an easting of a grid that begins far in the west.
    Possible,
    /// Nothing says so.
    Plain,
}

/// Metres from the equator to a pole, and from where eastings in feet of state planes are met no more.
const NORTHINGS: RangeInclusive<f64> = 1e6..=1e7;
const FAR_NORTH: f64 = 3.5e6;
/// Eastings of UTM and other grids whose middle is at 500 km.
const EASTINGS: RangeInclusive<f64> = 1e5..=9e5;
/// Zones of six degrees as they stand before such eastings.
const ZONES: RangeInclusive<f64> = 10.0..=61.0;
/// Gauss-Krüger zones of three degrees west of where their eastings can be northings there, the eastings behind them, and the northings they go with.
const GAUSS_ZONES: RangeInclusive<f64> = 2.0..=4.0;
const GAUSS_EASTINGS: RangeInclusive<f64> = 3.5e5..=6.5e5;
const GAUSS_NORTHINGS: RangeInclusive<f64> = 5e6..=6.3e6;
/// The grid of Switzerland (LV95).
const SWISS: [RangeInclusive<f64>; 2] = [1.07e6..=1.3e6, 2.48e6..=2.84e6];
/// Before the easting.
const ZONE: f64 = 1e6;

/// Which of two columns that are to be x and y stands first.
pub(super) fn northing_first(table: &Table<'_>, sampled: &Sampled, [first, second]: [usize; 2]) -> Order {
    let in_metres =
        [first, second].iter().all(|i| table.unit(*i).is_none_or(|unit| unit == UnitWord::Known(Units::Metre)));
    let (Some(first), Some(second)) = (sampled.range(first), sampled.range(second)) else { return Order::Plain };
    if in_metres { order(first, second) } else { Order::Plain }
}

/// The same by the least and the most of each.
fn order(first: [f64; 2], second: [f64; 2]) -> Order {
    let within = |range: [f64; 2], bounds: &RangeInclusive<f64>| range.iter().all(|value| bounds.contains(value));
    let zone = (second[0] / ZONE).floor();
    let behind_zone = second.map(|value| value - ZONE * zone);
    let with_zone = |zones: &RangeInclusive<f64>, eastings| zones.contains(&zone) && within(behind_zone, eastings);
    let certain = within(first, &SWISS[0]) && within(second, &SWISS[1])
        || within(first, &NORTHINGS) && with_zone(&ZONES, &EASTINGS)
        || within(first, &GAUSS_NORTHINGS) && with_zone(&GAUSS_ZONES, &GAUSS_EASTINGS)
        || within(first, &(FAR_NORTH..=*NORTHINGS.end())) && within(second, &EASTINGS);
    if certain {
        Order::Certain
    } else if within(first, &NORTHINGS) && within(second, &EASTINGS) {
        Order::Possible
    } else {
        Order::Plain
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The order of coordinates that are given easting first, and turned.
    fn both(east: f64, north: f64) -> [Order; 2] {
        let range = |value: f64| [value, value + 100.0];
        [order(range(east), range(north)), order(range(north), range(east))]
    }

    #[test]
    fn northings_that_stand_first_are_told_by_their_figures() {
        for (grid, east, north, turned) in [
            ("UTM", 456_000.0, 5_432_000.0, Order::Certain),
            ("UTM with its zone", 32_456_000.0, 5_432_000.0, Order::Certain),
            ("UTM, far south", 456_000.0, 1_900_000.0, Order::Possible),
            ("Gauss-Krüger, zone 3", 3_456_000.0, 5_432_000.0, Order::Certain),
            ("Gauss-Krüger, zone 5", 5_456_000.0, 5_650_000.0, Order::Plain),
            ("Gauss-Krüger, Adriatic", 5_518_000.0, 4_886_000.0, Order::Plain),
            ("Lambert 93", 652_000.0, 6_862_000.0, Order::Certain),
            ("LV95", 2_600_000.0, 1_200_000.0, Order::Certain),
            ("British grid", 530_000.0, 180_000.0, Order::Plain),
            ("SWEREF 99 TM", 674_000.0, 6_580_000.0, Order::Certain),
            ("NZTM", 1_750_000.0, 5_430_000.0, Order::Plain),
            ("MGA", 334_000.0, 6_252_000.0, Order::Certain),
            ("a yard", 40.0, 25.0, Order::Plain),
        ] {
            assert_eq!(both(east, north), [Order::Plain, turned], "{grid}");
        }
        // A state plane in feet, easting first, is read and said.
        assert_eq!(both(1_000_000.0, 200_000.0)[0], Order::Possible);
    }
}
