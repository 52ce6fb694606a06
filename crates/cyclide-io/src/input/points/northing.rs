//! Whether coordinates of a map stand with the northing first, by their figures: taken as x and y they are the mirror image.

use std::ops::RangeInclusive;

use cyclide::model::Units;

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

/// Meters from the equator to a pole, and from where eastings in feet of state planes are met no more.
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
/// The grids of Switzerland, LV95 and LV03, northing first. The figures of the older one may be those of others too.
const SWISS: [RangeInclusive<f64>; 2] = [1.07e6..=1.3e6, 2.48e6..=2.84e6];
const OLD_SWISS: [RangeInclusive<f64>; 2] = [7e4..=3e5, 4.8e5..=8.4e5];
/// Before the easting.
const ZONE: f64 = 1e6;
/// Eastings from a meridian; and the radius of the earth, with the middle of a zone and half its width in radians, somewhat more than that of six
/// degrees, all in meters.
const FROM_MERIDIAN: RangeInclusive<f64> = -9e5..=9e5;
const RADIUS: f64 = 6.37e6;
const MIDDLE: f64 = 5e5;
const HALF_ZONE: f64 = 3.5 * std::f64::consts::PI / 180.0;
/// Zones with one figure are in Europe and Russia, and so are their northings.
const NORTHINGS_OF_EUROPE: RangeInclusive<f64> = 3.9e6..=8e6;
/// Coordinates of state planes in feet look like a northing above this before an easting below that.
const STATE_PLANES: [f64; 2] = [5.5e6, 3e6];

/// Which of two columns that are to be x and y stands first.
pub(super) fn northing_first(table: &Table<'_>, sampled: &Sampled, [first, second]: [usize; 2]) -> Order {
    // From the center of the earth.
    let is_geocentric = |i: &usize| {
        let name = table.header.get(*i).map(|field| field.text.to_lowercase()).unwrap_or_default();
        name.contains("ecef") || name.contains("geocentric")
    };
    if [first, second].iter().any(is_geocentric) {
        return Order::Plain;
    }
    let in_metres =
        [first, second].iter().all(|i| table.unit(*i).is_none_or(|unit| unit == UnitWord::Known(Units::Metre)));
    let (Some(first), Some(second)) = (sampled.range(first), sampled.range(second)) else { return Order::Plain };
    if in_metres { order(first, second) } else { Order::Plain }
}

/// The same by the least and the most of each.
fn order(first: [f64; 2], second: [f64; 2]) -> Order {
    if is_known_grid(first, second) {
        return Order::Certain;
    }
    let is_plain = is_known_grid(second, first) || !is_of_map(second, first);
    if is_plain || is_of_map(first, second) {
        let is_possible = !is_plain || within(first, &OLD_SWISS[0]) && within(second, &OLD_SWISS[1]);
        return if is_possible { Order::Possible } else { Order::Plain };
    }
    let in_feet = first[0] > STATE_PLANES[0] && second[0] > ZONE && second[1] < STATE_PLANES[1];
    if first[0] >= FAR_NORTH && !in_feet { Order::Certain } else { Order::Possible }
}

fn within(range: [f64; 2], bounds: &RangeInclusive<f64>) -> bool {
    range.iter().all(|value| bounds.contains(value))
}

/// The zone before an easting, and what is behind it.
fn zoned(east: [f64; 2]) -> (f64, [f64; 2]) {
    let zone = (east[0] / ZONE).floor();
    (zone, east.map(|value| value - ZONE * zone))
}

/// A northing and an easting of a grid that has such figures, and no other has them the other way round.
fn is_known_grid(north: [f64; 2], east: [f64; 2]) -> bool {
    let (zone, behind) = zoned(east);
    let with_zone = |zones: &RangeInclusive<f64>, eastings| zones.contains(&zone) && within(behind, eastings);
    within(north, &SWISS[0]) && within(east, &SWISS[1])
        || within(north, &NORTHINGS) && with_zone(&ZONES, &EASTINGS)
        || within(north, &GAUSS_NORTHINGS) && with_zone(&GAUSS_ZONES, &GAUSS_EASTINGS)
        || within(north, &(FAR_NORTH..=*NORTHINGS.end())) && within(east, &EASTINGS)
}

/// An easting and a northing may be those of a map: counted from a meridian, or behind the number of a zone.
fn is_of_map(east: [f64; 2], north: [f64; 2]) -> bool {
    let (zone, behind) = zoned(east);
    // Zones get narrow to the north.
    let width = HALF_ZONE * RADIUS * (north[0] / RADIUS).cos();
    let with_zone =
        zone >= 1.0 && within(behind, &(MIDDLE - width..=MIDDLE + width)) && within(north, &NORTHINGS_OF_EUROPE);
    within(north, &NORTHINGS) && (within(east, &FROM_MERIDIAN) || with_zone)
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
            ("Gauss-Krüger, Adriatic", 5_518_000.0, 4_886_000.0, Order::Certain),
            ("Gauss-Krüger, Austria", -15_000.0, 5_340_000.0, Order::Certain),
            ("Gauss-Krüger, Austria, east", 70_000.0, 5_210_000.0, Order::Certain),
            ("Poland 2000, zone 7", 7_450_000.0, 5_780_000.0, Order::Certain),
            ("Gauss-Boaga, west", 1_520_000.0, 4_980_000.0, Order::Certain),
            ("Gauss-Boaga, east", 2_520_000.0, 4_980_000.0, Order::Certain),
            ("Finland, zone 2", 2_510_000.0, 6_700_000.0, Order::Possible),
            ("Russia, zone 7", 7_412_000.0, 6_180_000.0, Order::Certain),
            ("Lambert 93", 652_000.0, 6_862_000.0, Order::Certain),
            ("LV95", 2_600_000.0, 1_200_000.0, Order::Certain),
            ("LV03", 600_000.0, 200_000.0, Order::Possible),
            ("British grid", 530_000.0, 180_000.0, Order::Possible),
            ("SWEREF 99 TM", 674_000.0, 6_580_000.0, Order::Certain),
            ("NZTM", 1_750_000.0, 5_430_000.0, Order::Certain),
            ("MGA", 334_000.0, 6_252_000.0, Order::Certain),
            ("a yard", 40.0, 25.0, Order::Plain),
        ] {
            assert_eq!(both(east, north), [Order::Plain, turned], "{grid}");
        }
        // State planes in feet, easting first, are read, and said where they look like a northing.
        assert_eq!(both(1_000_000.0, 200_000.0)[0], Order::Possible);
        assert_eq!(both(6_500_000.0, 2_300_000.0)[0], Order::Possible);
        assert_eq!(both(6_050_000.0, 2_110_000.0)[0], Order::Plain);
        // Both figures may be either: that is said.
        assert_eq!(both(5_456_000.0, 5_650_000.0), [Order::Possible; 2]);
    }
}
