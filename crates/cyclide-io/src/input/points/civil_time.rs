//! Dates and times of the day as texts: `2026-11-28T10:00:00.25Z`, `2026-11-28 10:00:00+01:00`, `10:00:00.25`.

/// Nanoseconds of a second.
pub(super) const PER_SECOND: i128 = 1_000_000_000;
const SECONDS_OF_DAY: i64 = 86_400;

/// How much a text says of a time: those of one table agree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CivilKind {
    TimeOfDay,
    /// A date without a zone.
    Local,
    /// A date with one.
    Zoned,
}

/// A time that a text says, in whole nanoseconds from midnight or from 1970.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct CivilTime {
    pub(super) kind: CivilKind,
    pub(super) nanoseconds: i128,
}

impl CivilTime {
    /// None of what is not such a text, of dates that are none, and of more than nine decimals.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let Some((date, time)) = text.split_once(['T', 't', ' ']) else {
            return Some(Self { kind: CivilKind::TimeOfDay, nanoseconds: time_of_day(text)? });
        };
        let days = days_from_1970(date)?;
        let (time, zone) = zone(time.trim_start())?;
        let kind = if zone.is_some() { CivilKind::Zoned } else { CivilKind::Local };
        let seconds = days * SECONDS_OF_DAY - zone.unwrap_or(0);
        Some(Self { kind, nanoseconds: i128::from(seconds) * PER_SECOND + time_of_day(time)? })
    }
}

/// Whole digits, as many as these.
fn digits(text: &str, count: usize) -> Option<i64> {
    let all = text.len() == count && text.bytes().all(|byte| byte.is_ascii_digit());
    all.then(|| text.parse().ok()).flatten()
}

/// `hh:mm:ss` with decimals or without, in nanoseconds.
fn time_of_day(text: &str) -> Option<i128> {
    let (whole, fraction) = text.split_once(['.', ',']).unwrap_or((text, "0"));
    let mut parts = whole.split(':');
    let [hours, minutes, seconds] = [parts.next()?, parts.next()?, parts.next()?].map(|part| digits(part, 2));
    let (hours, minutes, seconds) = (hours?, minutes?, seconds?);
    let fraction = if fraction.len() > 9 { fraction.trim_end_matches('0') } else { fraction };
    if parts.next().is_some() || hours > 23 || minutes > 59 || seconds > 59 || fraction.len() > 9 {
        return None;
    }
    let fraction = digits(&format!("{fraction:0<9}"), 9)?;
    Some(i128::from(hours * 3600 + minutes * 60 + seconds) * PER_SECOND + i128::from(fraction))
}

/// A time without its zone, and the seconds that the zone is ahead.
fn zone(text: &str) -> Option<(&str, Option<i64>)> {
    if let Some(time) = text.strip_suffix(['Z', 'z']) {
        return Some((time, Some(0)));
    }
    let Some(at) = text.find(['+', '-']) else { return Some((text, None)) };
    let (time, offset) = text.split_at(at);
    let numbers = offset[1..].replace(':', "");
    let numbers = if numbers.len() == 2 { format!("{numbers}00") } else { numbers };
    let number = digits(&numbers, 4)?;
    let ahead = (number / 100 * 60 + number % 100) * 60;
    Some((time, Some(if offset.starts_with('-') { -ahead } else { ahead })))
}

/// The days from 1970 to a date `2026-11-28` of the Gregorian calendar.
fn days_from_1970(date: &str) -> Option<i64> {
    let mut parts = date.split('-');
    let (year, month, day) = (digits(parts.next()?, 4)?, digits(parts.next()?, 2)?, digits(parts.next()?, 2)?);
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let lengths = [31, 28 + i64::from(leap), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let months = lengths.get(..usize::try_from(month - 1).ok()?)?;
    if parts.next().is_some() || day < 1 || day > *lengths.get(months.len())? {
        return None;
    }
    let before = year - 1;
    let leaps = |year: i64| year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400);
    Some(365 * (year - 1970) + leaps(before) - leaps(1969) + months.iter().sum::<i64>() + day - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_times_to_the_nanosecond() {
        let of = |text| CivilTime::parse(text).map(|time| (time.kind, time.nanoseconds));
        for (text, kind, seconds, nanoseconds) in [
            ("10:00:00.25", CivilKind::TimeOfDay, 36_000, 250_000_000),
            ("23:59:59,999999999", CivilKind::TimeOfDay, 86_399, 999_999_999),
            ("1970-01-01T00:00:00Z", CivilKind::Zoned, 0, 0),
            ("2000-03-01 00:00:00", CivilKind::Local, 951_868_800, 0),
            ("2026-11-28T10:00:00.25Z", CivilKind::Zoned, 1_795_860_000, 250_000_000),
            ("2026-11-28T11:00:00.250000000000+01:00", CivilKind::Zoned, 1_795_860_000, 250_000_000),
            ("2026-11-28T05:30:00-0430", CivilKind::Zoned, 1_795_860_000, 0),
        ] {
            assert_eq!(of(text), Some((kind, seconds * PER_SECOND + nanoseconds)), "{text}");
        }
        for text in [
            "",
            "10:00",
            "24:00:00",
            "10:60:00",
            "1:2:3",
            "10:00:00.0000000001",
            "2026-02-29T00:00:00",
            "2026-13-01T00:00:00",
            "2026-00-01T00:00:00",
            "2026-01-00T00:00:00",
            "2026-11-28",
            "2026-11-28Tx",
            "28.11.2026 10:00:00",
            "3.5",
        ] {
            assert_eq!(of(text), None, "{text}");
        }
    }
}
