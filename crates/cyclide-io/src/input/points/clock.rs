//! Times of tables: in the unit that their column names, or that the figures of a date tell, and in whole numbers too large for a
//! double exactly.

use cyclide::ShortNumber;

use super::civil_time::{CivilKind, CivilTime};
use super::decimals::Decimals;
use super::fields::Field;
use super::pose_names::TimeUnit;
use crate::text::place::{Diagnostic, Source, quoted};

/// Seconds between poses from which on another unit may be meant, and those where all are whole, of so many at least.
const LONG_STEP: f64 = 1000.0;
const WHOLE_STEP: f64 = 2.0;
const SOME: usize = 4;
/// Whole numbers from here on are not all doubles.
const NOT_ALL_DOUBLES: i128 = 1 << 53;

/// Reads the times of a table.
#[derive(Debug)]
pub(super) struct Clock {
    unit: TimeUnit,
    /// The first time, in whole units, where those are too large for a double: the others count from it.
    first: Option<i128>,
    begun: bool,
    /// What the texts of the times say, where they are no numbers.
    civil: Option<CivilKind>,
    /// The least and the most of the times in their unit, and how many there are.
    range: Option<[f64; 2]>,
    count: usize,
    /// All are whole numbers.
    whole: bool,
    /// What was chosen.
    pub(super) note: Option<String>,
}

impl Clock {
    pub(super) const fn new(unit: TimeUnit) -> Self {
        Self { unit, first: None, begun: false, civil: None, range: None, count: 0, whole: true, note: None }
    }

    /// The time of a row in seconds, with its whole nanoseconds, if they have a column of their own.
    ///
    /// # Errors
    /// As [`Decimals::read`] has them; of dates and times of the day that are none, or that are not all alike.
    pub(super) fn read(
        &mut self,
        source: Source<'_>,
        decimals: &mut Decimals,
        field: &Field<'_>,
        nanoseconds: Option<&Field<'_>>,
    ) -> Result<f64, Box<Diagnostic>> {
        if field.text.contains(':') || self.civil.is_some() {
            return self.read_civil(source, field);
        }
        let value = decimals.read(source, field)?;
        let [low, high] = self.range.unwrap_or([value; 2]);
        self.range = Some([low.min(value), high.max(value)]);
        self.count += 1;
        let whole = field.text.parse::<i128>().ok();
        self.whole &= whole.is_some();
        if let Some(parts) = nanoseconds {
            let parts_value = decimals.read(source, parts)?;
            if let (Some(seconds), Some(parts)) = (whole, parts.text.parse::<i128>().ok()) {
                return Ok(self.since_first(seconds.saturating_mul(1_000_000_000).saturating_add(parts), 1e9));
            }
            return Ok(value + parts_value / 1e9);
        }
        if !self.begun {
            self.begun = true;
            if let (TimeUnit::Unsaid, Some(whole)) = (self.unit, whole) {
                // Dates since 1970 from 2001 to 2286: ten figures in seconds.
                let found = match whole {
                    1_000_000_000_000..10_000_000_000_000 => Some((1e3, "milliseconds")),
                    1_000_000_000_000_000..10_000_000_000_000_000 => Some((1e6, "microseconds")),
                    1_000_000_000_000_000_000..10_000_000_000_000_000_000 => Some((1e9, "nanoseconds")),
                    _ => None,
                };
                if let Some((per_second, name)) = found {
                    self.unit = TimeUnit::PerSecond(per_second);
                    self.note = Some(format!("the times are read as dates in {name}, judging by their values"));
                }
            }
        }
        let per_second = match self.unit {
            TimeUnit::PerSecond(count) => count,
            TimeUnit::Unsaid => 1.0,
        };
        Ok(match whole {
            Some(whole) if self.first.is_some() || whole.abs() >= NOT_ALL_DOUBLES => {
                self.since_first(whole, per_second)
            }
            _ => value / per_second,
        })
    }

    /// The seconds of a text from the first.
    fn read_civil(&mut self, source: Source<'_>, field: &Field<'_>) -> Result<f64, Box<Diagnostic>> {
        let refused = |what: &str| Err(field.refused(source, format!("`{}` {what}", quoted(field.text))));
        let Some(CivilTime { kind, nanoseconds }) = CivilTime::parse(field.text) else {
            return refused(
                "is not a time: write seconds, or `10:00:00.25`, or `2026-11-28T10:00:00.25` with or without a zone (`Z`, `+01:00`), to nanoseconds",
            );
        };
        let fresh = !self.begun && self.count == 0;
        if self.civil != Some(kind) && !fresh {
            return refused("has another format than the times before it: write all times in one format");
        }
        self.civil = Some(kind);
        let first = *self.first.get_or_insert(nanoseconds);
        if fresh {
            self.begun = true;
            self.count = 1;
            let what = if kind == CivilKind::TimeOfDay { "times of the day" } else { "dates" };
            self.note = Some(format!("the times are {what}; seconds count from the first, {}", quoted(field.text)));
        }
        Ok(nanoseconds.saturating_sub(first) as f64 / 1e9)
    }

    /// What to do where times of the day do not rise; nothing of others.
    pub(super) const fn past_midnight(&self) -> &'static str {
        match self.civil {
            Some(CivilKind::TimeOfDay) => {
                "; where they pass midnight, write them with their dates, as `2026-11-28T23:59:59`"
            }
            _ => "",
        }
    }

    /// The sentence about times that are so far apart that they are hardly seconds, where nothing says their unit.
    pub(super) fn seconds_assumed(&self) -> Option<String> {
        let [low, high] = self.range.filter(|_| self.unit == TimeUnit::Unsaid && self.count > 1)?;
        let step = (high - low) / (self.count - 1) as f64;
        (step >= if self.whole && self.count >= SOME { WHOLE_STEP } else { LONG_STEP }).then(|| {
            format!(
                "the times have no unit and are taken as seconds, {} apart on average; for other units name the column time_ms, time_us or time_ns",
                ShortNumber(step)
            )
        })
    }

    /// Seconds from the first time, whose difference is exact.
    fn since_first(&mut self, whole: i128, per_second: f64) -> f64 {
        self.begun = true;
        if self.first.is_none() {
            let before = self.note.take().map(|note| format!("{note}; ")).unwrap_or_default();
            self.note = Some(format!("{before}times count from the first, {whole}, so that none is rounded"));
        }
        let first = *self.first.get_or_insert(whole);
        whole.saturating_sub(first) as f64 / per_second
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(unit: TimeUnit, times: &[&str]) -> (Vec<f64>, Option<String>) {
        let mut clock = Clock::new(unit);
        let (source, mut decimals) = (Source { name: "t", text: "" }, Decimals::default());
        let read = |text: &&str| clock.read(source, &mut decimals, &Field { text, start: 0 }, None).unwrap();
        let times = times.iter().map(read).collect();
        (times, clock.note)
    }

    #[test]
    fn times_are_seconds_whatever_their_unit() {
        let half = ["1403636580838555648", "1403636581338555648", "1403636581338555649"];
        for unit in [TimeUnit::PerSecond(1e9), TimeUnit::Unsaid] {
            let (times, note) = read(unit, &half);
            assert_eq!(times, [0.0, 0.5, 0.500_000_001]);
            assert!(
                note.unwrap().ends_with("times count from the first, 1403636580838555648, so that none is rounded")
            );
        }
        assert_eq!(read(TimeUnit::Unsaid, &["1700000000", "1700000002.5"]), (vec![1.7e9, 1_700_000_002.5], None));
        assert_eq!(read(TimeUnit::Unsaid, &["0", "2"]), (vec![0.0, 2.0], None));
        assert_eq!(read(TimeUnit::PerSecond(1e9), &["0", "2000000000"]), (vec![0.0, 2.0], None));
        assert_eq!(read(TimeUnit::Unsaid, &["1700000000000", "1700000000500"]).0, [1.7e9, 1_700_000_000.5]);
        for (unit, times, said) in [
            (TimeUnit::Unsaid, &["5000000", "5250000"][..], true),
            (TimeUnit::Unsaid, &["0", "900"], false),
            (TimeUnit::Unsaid, &["0", "8", "16", "24"], true),
            (TimeUnit::Unsaid, &["0", "1", "2", "3"], false),
            (TimeUnit::Unsaid, &["0", "8.5", "16", "24"], false),
            (TimeUnit::Unsaid, &["1700000000000000", "1700000000250000"], false),
            (TimeUnit::PerSecond(1.0), &["0", "5000"], false),
        ] {
            let mut clock = Clock::new(unit);
            let (source, mut decimals) = (Source { name: "t", text: "" }, Decimals::default());
            for text in times {
                clock.read(source, &mut decimals, &Field { text, start: 0 }, None).unwrap();
            }
            assert_eq!(clock.seconds_assumed().is_some(), said, "{times:?}");
        }
        let mut clock = Clock::new(TimeUnit::Unsaid);
        let (source, mut decimals) = (Source { name: "t", text: "" }, Decimals::default());
        let mut at = |text| clock.read(source, &mut decimals, &Field { text, start: 0 }, None);
        assert_eq!(at("2026-11-28T23:59:59.75Z").unwrap().to_bits(), 0.0_f64.to_bits());
        assert!(at("3.5").is_err());
        assert_eq!(at("2026-11-29T01:00:01+01:00").unwrap().to_bits(), 1.25_f64.to_bits());
        assert!(at("2026-11-29T00:00:02").unwrap_err().message.contains("write all times in one format"));
        assert!(clock.note.unwrap().contains("dates; seconds count from the first, 2026-11-28T23:59:59.75Z"));
        let mut clock = Clock::new(TimeUnit::PerSecond(1.0));
        let source = Source { name: "t", text: "" };
        let mut decimals = Decimals::default();
        let mut at = |seconds, parts| {
            let [seconds, parts] = [seconds, parts].map(|text| Field { text, start: 0 });
            clock.read(source, &mut decimals, &seconds, Some(&parts)).unwrap()
        };
        assert_eq!((at("1403636580", "999999999"), at("1403636581", "1")), (0.0, 2e-9));
    }
}
