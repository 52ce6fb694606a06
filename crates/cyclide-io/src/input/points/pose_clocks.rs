//! Words of clocks in the names of columns: `elapsed_s`, `sim_time`, `Zeitstempel`, in English, German, French, Italian and Spanish.

use super::fields::Field;
use super::names::words_of;
use super::pose_names::{Meaning, TimeUnit, unit_of_time};
use super::table::Table;

/// Words that are times.
const CLOCKS: &str = "t time times timestamp timestamps stamp ts tstamp elapsed timecode clock epoch datetime unixtime gpstime simtime systime walltime \
    rostime runtime uptime zeit zeiten zeitstempel zeitpunkt uhrzeit laufzeit simulationszeit messzeit systemzeit temps heure horodatage instant tempo ora orario istante \
    tiempo hora instante";

/// Units that are times alone: `seconds`, `ms`. Others, as `s`, may be lengths of paths.
const ALONE: &str = "sec secs second seconds sek sekunde sekunden seconde secondes secondo secondi segundo segundos ms msec msecs millis millisecond \
    milliseconds millisekunde millisekunden milliseconde millisecondes millisecondi milisegundos usec usecs micros microsecond microseconds mikrosekunden \
    microsecondes microsecondi microsegundos ns nsec nsecs nanos nanosec nanosecs nanosecond nanoseconds nanosekunden nanosecondes nanosecondi nanosegundos";

/// Words beside them that change nothing.
const BESIDE: &str = "since start from begin beginning of the sim simulation simulated wall ros gps unix posix utc system sys abs absolute rel relative run video \
    host cpu mono monotonic in total seit beginn ab relativ absolut verstrichene vergangene depuis le debut du ecoule absolu simule dall inizio trascorso \
    relativo assoluto desde el inicio transcurrido absoluto de di";

/// True for a word of a list.
fn is_among(list: &str, word: &str) -> bool {
    list.split_whitespace().any(|own| own == word)
}

/// The unit of a time whose name is in the words of clocks; none of what may be no time, or has an unknown unit.
fn clock(name: &str) -> Option<TimeUnit> {
    let (words, _) = words_of(name);
    let is_unit = |word: &&String| unit_of_time(&[word.as_str()]).is_some();
    let (units, others): (Vec<&String>, Vec<&String>) = words.iter().partition(is_unit);
    let named = others.iter().any(|word| is_among(CLOCKS, word)) || units.iter().any(|word| is_among(ALONE, word));
    if !named || others.iter().any(|word| !is_among(CLOCKS, word) && !is_among(BESIDE, word)) {
        return None;
    }
    match units.as_slice() {
        [] => Some(TimeUnit::Unsaid),
        [unit] => unit_of_time(&[unit.as_str()]),
        _ => None,
    }
}

/// True if a word of a name is one of clocks: nobody may leave such a column out unasked.
pub(super) fn speaks_of_clocks(name: &str) -> bool {
    words_of(name).0.iter().any(|word| is_among(CLOCKS, word) || is_among(ALONE, word))
}

/// Takes columns in the words of clocks for the time where no other is: one of them, or seconds and nanoseconds beside each other.
pub(super) fn take_clocks(table: &Table<'_>, meanings: &mut [Option<Meaning>]) {
    if meanings.iter().any(|meaning| matches!(meaning, Some(Meaning::Time(_)))) {
        return;
    }
    let of = |(i, field): (usize, &Field<'_>)| clock(field.text).map(|own| (i, own));
    let free = |(i, _): &(usize, TimeUnit)| meanings[*i].is_none();
    let found: Vec<(usize, TimeUnit)> = table.header.iter().enumerate().filter_map(of).filter(free).collect();
    if found.len() == 1 || seconds_and_parts(&found).is_some() {
        found.into_iter().for_each(|(i, unit)| meanings[i] = Some(Meaning::Time(unit)));
    }
}

/// The columns of seconds and of nanoseconds, in either order.
pub(super) fn seconds_and_parts(times: &[(usize, TimeUnit)]) -> Option<[usize; 2]> {
    let [(one, of_one), (other, of_other)] = times else { return None };
    let per_second = |unit: &TimeUnit| if let TimeUnit::PerSecond(count) = unit { Some(*count) } else { None };
    match [per_second(of_one)?, per_second(of_other)?] {
        [1.0, 1e9] => Some([*one, *other]),
        [1e9, 1.0] => Some([*other, *one]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clocks_are_known_by_their_words() {
        let per = |count| Some(TimeUnit::PerSecond(count));
        for (name, expected) in [
            ("elapsed", Some(TimeUnit::Unsaid)),
            ("elapsed_s", per(1.0)),
            ("elapsed [s]", per(1.0)),
            ("Elapsed Time (ms)", per(1e3)),
            ("seconds", per(1.0)),
            ("secondsElapsed", per(1.0)),
            ("time_since_start_us", per(1e6)),
            ("sim_time", Some(TimeUnit::Unsaid)),
            ("Zeitstempel", Some(TimeUnit::Unsaid)),
            ("Zeit seit Beginn [Sek]", per(1.0)),
            ("Millisekunden", per(1e3)),
            ("temps \u{e9}coul\u{e9}", Some(TimeUnit::Unsaid)),
            ("tempo trascorso [s]", per(1.0)),
            ("tiempo", Some(TimeUnit::Unsaid)),
            // Lengths of paths, times that are no clock, units that are unknown.
            ("s", None),
            ("time_delta", None),
            ("compute_time_ms", None),
            ("elapsed [h]", None),
            ("temperature", None),
            ("", None),
        ] {
            assert_eq!(clock(name), expected, "{name}");
        }
    }
}
