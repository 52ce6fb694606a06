//! The outcome of a run: per construct passed and failed, the worst error, every failure.

use super::case::Case;
use super::check::Check;
use std::fmt;

/// The cases of one construct.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tally {
    /// Cases that passed.
    pub passed: usize,
    /// Cases that failed.
    pub failed: usize,
    /// Largest error over allowed error, with case and field.
    pub worst: Option<(f64, String)>,
}

/// A case that failed.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// Identifier of the case.
    pub case: String,
    /// Its construct.
    pub construct: String,
    /// What failed, as sentences.
    pub reasons: Vec<String>,
}

/// The outcome of one or more files. Constructs are in the order of their first appearance.
#[derive(Debug, Default)]
pub struct Report {
    tallies: Vec<(String, Tally)>,
    unknown: Vec<(String, usize)>,
    /// Not asked for: number of cases, and whether the construct is known.
    skipped: Vec<(String, (usize, bool))>,
    failures: Vec<Failure>,
}

impl Report {
    /// Number of cases that passed.
    #[must_use]
    pub fn passed(&self) -> usize {
        self.tallies.iter().map(|(_, t)| t.passed).sum()
    }

    /// Number of cases that failed.
    #[must_use]
    pub fn failed(&self) -> usize {
        self.tallies.iter().map(|(_, t)| t.failed).sum()
    }

    /// The constructs that were run, with their tallies.
    #[must_use]
    pub fn tallies(&self) -> &[(String, Tally)] {
        &self.tallies
    }

    /// The failures.
    #[must_use]
    pub fn failures(&self) -> &[Failure] {
        &self.failures
    }

    /// Constructs without a handler, with the number of their cases.
    #[must_use]
    pub fn unknown(&self) -> &[(String, usize)] {
        &self.unknown
    }

    /// True if cases were run, none failed and no construct was unknown.
    #[must_use]
    pub fn is_success(&self) -> bool {
        self.passed() > 0 && self.failed() == 0 && self.unknown.is_empty()
    }

    pub(super) fn skip(&mut self, construct: &str, known: bool) {
        let (count, is_known) = entry(&mut self.skipped, construct);
        *count += 1;
        *is_known = known;
    }

    pub(super) fn add_unknown(&mut self, construct: &str) {
        *entry(&mut self.unknown, construct) += 1;
    }

    pub(super) fn add(&mut self, case: &Case, check: &Check) {
        let tally = entry(&mut self.tallies, case.construct());
        let (ratio, field) = check.worst();
        if tally.worst.as_ref().is_none_or(|(worst, _)| ratio > *worst) {
            tally.worst = Some((ratio, format!("{} {field}", case.id())));
        }
        if check.failures().is_empty() {
            tally.passed += 1;
        } else {
            tally.failed += 1;
            self.failures.push(Failure {
                case: case.id().into(),
                construct: case.construct().into(),
                reasons: check.failures().to_vec(),
            });
        }
    }
}

fn entry<'a, T: Default>(list: &'a mut Vec<(String, T)>, name: &str) -> &'a mut T {
    let i = list.iter().position(|(n, _)| n == name).unwrap_or_else(|| {
        list.push((name.into(), T::default()));
        list.len() - 1
    });
    &mut list[i].1
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 5;
        for failure in &self.failures {
            writeln!(f, "FAILED {} ({})", failure.case, failure.construct)?;
            for reason in failure.reasons.iter().take(SHOWN) {
                writeln!(f, "    {reason}")?;
            }
            if failure.reasons.len() > SHOWN {
                writeln!(f, "    and {} more", failure.reasons.len() - SHOWN)?;
            }
        }
        writeln!(f, "{:<30} {:>6} {:>6}  worst error / allowed", "construct", "passed", "failed")?;
        for (name, tally) in &self.tallies {
            write!(f, "{name:<30} {:>6} {:>6}", tally.passed, tally.failed)?;
            match &tally.worst {
                Some((ratio, place)) if *ratio > 0.0 => writeln!(f, "  {ratio:.2e} ({place})")?,
                _ => writeln!(f, "  0")?,
            }
        }
        for (name, (count, known)) in &self.skipped {
            let what = if *known { "" } else { ": UNKNOWN CONSTRUCT" };
            writeln!(f, "{name:<30} {count} skipped (not asked for){what}")?;
        }
        for (name, count) in &self.unknown {
            writeln!(f, "{name:<30} {count} not run: UNKNOWN CONSTRUCT")?;
        }
        let skipped: usize = self.skipped.iter().map(|(_, (n, _))| n).sum();
        let unknown: usize = self.unknown.iter().map(|(_, n)| n).sum();
        if skipped + unknown > 0 {
            writeln!(f, "{skipped} skipped, {unknown} of unknown constructs")?;
        }
        write!(f, "{} passed, {} failed", self.passed(), self.failed())
    }
}
