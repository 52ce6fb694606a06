//! What stands above the data of a table: `sep=`, titles, the names of the columns, a line of units.

use super::fields::{Delimiter, Field, LONGEST_LINE, about, is_number, split};
use super::names::Role;
use super::unit::{UnitWord, unit_alone};
use super::unit_said::unit_said_by;
use crate::text::lines::lines;
use crate::text::place::{Diagnostic, Source};

/// Lines that are looked at to find what separates the columns.
const LOOKED_AT: usize = 64;
/// Lines of text above the data at most.
const MOST_TITLES: usize = 32;

/// A text up to its first line of data.
pub(super) struct Preamble<'a> {
    pub(super) delimiter: Delimiter,
    /// Names of the columns; empty without any.
    pub(super) header: Vec<Field<'a>>,
    /// The units of a line of them, one for each column.
    pub(super) units: Vec<Option<UnitWord>>,
    /// The words of that line.
    pub(super) unit_words: Vec<Field<'a>>,
    /// Where the lines that are passed over start.
    pub(super) titles: Vec<usize>,
    /// The unit that a title or a remark says the coordinates are in, with that line.
    pub(super) said: Option<(UnitWord, &'a str)>,
    /// The first line of data, and where it starts.
    pub(super) first: Vec<Field<'a>>,
    pub(super) start: usize,
}

/// The message for a file of another format, by how it begins.
fn other_format(text: &str) -> Option<&'static str> {
    let first = text.lines().map(str::trim).find(|line| !line.is_empty())?;
    if ["<?xml", "<!DOCTYPE", "<LandXML", "<gpx", "<kml"].iter().any(|start| first.starts_with(start)) {
        return Some(
            "this is an XML file (LandXML, JobXML, GPX, KML, …), which is not supported for points: export the points as a table (CSV)",
        );
    }
    if first.starts_with("JB,") || first.starts_with("00NM") {
        return Some(
            "this is a file of a survey controller (RW5, SDR), which is not supported: export the coordinates of the points as a table (CSV)",
        );
    }
    is_gsi(first).then_some("this is a Leica GSI file, which is not supported: export the points as a table (CSV)")
}

/// True for a line of Leica instruments: words of a number, what it is, a sign, and 8 or 16 figures.
fn is_gsi(line: &str) -> bool {
    let is_word = |word: &str| {
        word.split_once(['+', '-']).is_some_and(|(what, data)| {
            what.starts_with(|c: char| c.is_ascii_digit())
                && what.len() == 6
                && matches!(data.len(), 8 | 16)
                && data.chars().all(|c| c.is_ascii_alphanumeric())
        })
    };
    let mut words = line.trim_start_matches('*').split_whitespace();
    words.next().is_some_and(is_word) && words.next().is_some_and(is_word)
}

/// A line of text above the data.
struct Line<'a> {
    start: usize,
    fields: Vec<Field<'a>>,
}

impl<'a> Preamble<'a> {
    /// Reads up to the first line of data. `wanted` are column names asked for: they help to tell a header behind a `#`
    /// from a remark.
    pub(super) fn read(
        source: Source<'a>,
        wanted: &[String],
        known: fn(&Field<'_>) -> bool,
    ) -> Result<Self, Box<Diagnostic>> {
        if let Some(message) = other_format(source.text) {
            return Err(source.diagnostic(0..0, "", message));
        }
        let empty = || no_points(source);
        let delimiter = delimiter(source)?.ok_or_else(empty)?;
        // The last remark before the data that could be a header.
        let mut remark: Vec<Field<'a>> = Vec::new();
        let mut text: Vec<Line<'a>> = Vec::new();
        let mut remarks: Vec<&'a str> = Vec::new();
        let mut fields = Vec::new();
        for (start, line) in lines(source.text) {
            if let Some(rest) = line.trim_start().strip_prefix('#') {
                if let Some(names) = numbered(delimiter, start, line, rest).filter(|_| !text.iter().any(is_names)) {
                    text.push(Line { start, fields: names });
                    continue;
                }
                remarks.push(rest);
                let mut names = Vec::new();
                if rest.len() <= LONGEST_LINE
                    && delimiter.split(rest, start + line.len() - rest.len(), &mut names).is_ok()
                    && is_header(&names, wanted, known)
                {
                    remark = names;
                }
                continue;
            }
            if separator_said(line).is_some() && text.is_empty() {
                continue;
            }
            split(source, delimiter, start, line, &mut fields)?;
            if fields.iter().all(|f| f.text.is_empty()) || is_ruled(&fields) {
                continue;
            }
            if text.len() < MOST_TITLES && is_text(&fields, source, delimiter, (start, line.len()), !text.is_empty()) {
                text.push(Line { start, fields: std::mem::take(&mut fields) });
                continue;
            }
            let mut preamble = Self {
                delimiter,
                header: Vec::new(),
                units: Vec::new(),
                unit_words: Vec::new(),
                titles: Vec::new(),
                said: None,
                first: fields,
                start,
            };
            preamble.take_text(source, text)?;
            if preamble.header.is_empty() && remark.len() == preamble.first.len() {
                preamble.header = remark;
            }
            let title = |start: &usize| lines(&source.text[*start..]).next().map(|(_, line)| line);
            remarks.extend(preamble.titles.iter().filter_map(title));
            preamble.said = unit_said_by(&remarks);
            return Ok(preamble);
        }
        Err(empty())
    }

    /// Finds the header among the lines of text above the data: the one that speaks of most columns.
    fn take_text(&mut self, source: Source<'a>, text: Vec<Line<'a>>) -> Result<(), Box<Diagnostic>> {
        let width = self.first.iter().filter(|field| !field.text.is_empty()).count();
        let known = |line: &Line<'_>| {
            let of_use = |field: &&Field<'_>| !field.text.is_empty() && Role::of(field).is_of_points();
            line.fields.iter().filter(of_use).count()
        };
        // A sentence has as many words as it likes.
        let fits = |line: &Line<'_>| self.delimiter != Delimiter::Blanks || line.fields.len() == self.first.len();
        let may_be = |line: &Line<'_>| (line.fields.len() > 1 || width < 2) && (known(line) > 0 || fits(line));
        let is_units = |line: &Line<'_>| units_of(&line.fields).is_some();
        let candidates = || text.iter().enumerate().filter(|(_, line)| may_be(line) && !is_units(line));
        // Of several that know as much the first one, so that nothing that stands below it is passed over; of those that
        // know nothing the one above the data.
        let best = candidates().map(|(_, line)| known(line)).max();
        let at = match best {
            Some(0) => candidates().next_back(),
            Some(best) => candidates().find(|(_, line)| known(line) == best),
            None => None,
        };
        let Some((at, _)) = at else {
            self.titles = text.iter().map(|line| line.start).collect();
            return Ok(());
        };
        for (k, line) in text.into_iter().enumerate() {
            if k < at {
                self.titles.push(line.start);
            } else if k == at {
                // Numbers with units would be lost as names.
                if line.fields.len() > 1 && line.fields.iter().all(begins_as_number) {
                    let message =
                        "neither column names nor numbers: write numbers without units and thousands separators";
                    return Err(about(source, &line.fields, message));
                }
                self.header = line.fields;
            } else if let Some(units) = units_of(&line.fields).filter(|_| k == at + 1) {
                (self.units, self.unit_words) = (units, line.fields);
            } else {
                // What stands below the names is data, and refused where it is no number.
                (self.first, self.start) = (line.fields, line.start);
                break;
            }
        }
        Ok(())
    }
}

/// True for a line that is drawn below names: `-----`, `---;---`, `|---|---|`, `+---+---+`.
fn is_ruled(fields: &[Field<'_>]) -> bool {
    let marks = || fields.iter().map(|field| field.text).filter(|text| !text.is_empty());
    let is_drawn = |text: &str| text.len() > 1 && text.chars().all(|c| "-=_+*~:|".contains(c));
    marks().all(is_drawn) && marks().any(|text| text.len() > 2)
}

/// The refusal of a file without points, with the first thing in it that is nearly one.
fn no_points(source: Source<'_>) -> Box<Diagnostic> {
    let has_digit = |line: &str| line.contains(|c: char| c.is_ascii_digit());
    let lines = || lines(source.text).filter(|(_, line)| line.len() <= LONGEST_LINE && has_digit(line));
    let plain = |(_, line): &(usize, &str)| !line.trim_start().starts_with('#');
    let Some((start, line)) = lines().find(plain).or_else(|| lines().next()) else {
        return source.diagnostic(0..0, "", "the file has no points");
    };
    let text = line.trim();
    let start = start + (line.len() - line.trim_start().len());
    let inner = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')).unwrap_or_default();
    let why = if text.starts_with('#') {
        "this line is a remark, since it begins with `#`: if it is a point, remove that"
    } else if !inner.contains('"') && inner.contains([',', ';', '\t', ' ']) {
        "this line is in quotes as a whole, so it is one text: remove the quotes"
    } else {
        "no line has two numbers alone in their columns: write each point in a line of its own, its coordinates as plain numbers without units, separated by commas, semicolons, tabs or blanks"
    };
    source.diagnostic(start..start + text.len(), "", format!("the file has no points; {why}"))
}

/// True for a line of names: of several columns it says what they are.
fn is_names(line: &Line<'_>) -> bool {
    line.fields.iter().filter(|field| !field.text.is_empty() && Role::of(field).is_of_points()).count() > 1
}

/// The names of a line whose first one is `#`, that of the numbers of the points: `#;N [m];E [m]`. `rest` is what stands behind the `#`.
fn numbered<'a>(delimiter: Delimiter, start: usize, line: &'a str, rest: &'a str) -> Option<Vec<Field<'a>>> {
    let Delimiter::Char(separator) = delimiter else { return None };
    if rest.len() > LONGEST_LINE || !rest.trim_start_matches(' ').starts_with(separator) {
        return None;
    }
    let at = line.len() - rest.len();
    let mut fields = Vec::new();
    delimiter.split(rest, start + at, &mut fields).ok()?;
    let sign = Field { text: &line[at - 1..at], start: start + at - 1 };
    if let Some(first) = fields.first_mut() {
        *first = sign;
    }
    let named = fields.iter().filter(|field| !field.text.is_empty()).count() > 2;
    (named && !fields.iter().any(is_number)).then_some(fields)
}

/// True for a line of text above the data: it has no number, or it is a title with some (`Project;17`, `Survey of 12 March`) over a
/// line of names.
fn is_text(
    fields: &[Field<'_>],
    source: Source<'_>,
    delimiter: Delimiter,
    (start, length): (usize, usize),
    below: bool,
) -> bool {
    let numbers = fields.iter().filter(|field| is_number(field)).count();
    let words = |fields: &[Field<'_>]| fields.iter().filter(|field| !field.text.is_empty()).count();
    let begins = fields.first().is_some_and(|field| !field.text.is_empty() && !is_number(field));
    if numbers == 0 || below || !begins {
        return numbers == 0;
    }
    let mut next = Vec::new();
    // A sentence has as many words as it likes, but none with as many numbers and words as a point.
    let is_title = |names: usize| match delimiter {
        Delimiter::Blanks => numbers == 1 || words(fields) != names,
        Delimiter::Char(_) => numbers == 1 && words(fields) < names,
    };
    lines(&source.text[start + length..]).take(MOST_TITLES).skip(1).any(|(at, line)| {
        next.clear();
        // Names may stand behind a `#`.
        let line = line.trim_start().trim_start_matches('#');
        delimiter.split(line, start + length + at, &mut next).is_ok()
            && !next.iter().any(is_number)
            && next.iter().filter(|field| Role::of(field).is_of_points()).count() > 1
            && is_title(words(&next))
    })
}

/// What separates the columns: what the first line says (`sep=;`), else what separates most of the lines that have numbers.
fn delimiter(source: Source<'_>) -> Result<Option<Delimiter>, Box<Diagnostic>> {
    let data = |line: &str| !line.split('#').next().unwrap_or_default().trim().is_empty();
    let mut votes: Vec<(Delimiter, usize)> = Vec::new();
    let mut first = None;
    let mut fields = Vec::new();
    let mut left = LOOKED_AT;
    for (start, line) in lines(source.text) {
        if line.len() > LONGEST_LINE && !line.starts_with('#') {
            split(source, Delimiter::Blanks, start, line, &mut fields)?;
        }
        if left == 0 {
            break;
        }
        if line.len() > LONGEST_LINE || !data(line) {
            continue;
        }
        left -= 1;
        if let (Some(said), None) = (separator_said(line), first) {
            return Ok(Some(Delimiter::Char(said)));
        }
        let own = Delimiter::of(line.split('#').next().unwrap_or_default());
        first = first.or(Some(own));
        fields.clear();
        if own.split(line, start, &mut fields).is_ok() && fields.iter().filter(|field| is_number(field)).count() > 1 {
            match votes.iter_mut().find(|(delimiter, _)| *delimiter == own) {
                Some((_, count)) => *count += 1,
                None => votes.push((own, 1)),
            }
        }
    }
    let most = votes.iter().map(|(_, count)| *count).max();
    Ok(votes.iter().find(|(_, count)| Some(*count) == most).map(|(delimiter, _)| *delimiter).or(first))
}

/// The separator that a line of spreadsheets names: `sep=;`.
fn separator_said(line: &str) -> Option<char> {
    let line = line.trim().trim_matches('"');
    let said = line.get(..4).filter(|start| start.eq_ignore_ascii_case("sep=")).map(|_| &line[4..])?;
    match said {
        "\\t" | "" => Some('\t'),
        other => {
            let mut letters = other.chars();
            letters.next().filter(|_| letters.next().is_none())
        }
    }
}

/// The units of a line that has nothing else: `[m];[m]`, `;m;m`, `-,(m),(m)`.
fn units_of(fields: &[Field<'_>]) -> Option<Vec<Option<UnitWord>>> {
    let mut found = Vec::with_capacity(fields.len());
    for field in fields {
        let word = field.text.trim_matches(['[', ']', '(', ')', ' ']).to_lowercase();
        match (word.as_str(), unit_alone(over_sea(&word))) {
            (_, Some(unit)) => found.push(Some(unit)),
            ("" | "-" | "--" | "s" | "ns" | "ms" | "deg" | "\u{b0}" | "rad" | "text" | "1" | "m/s" | "gon", None) => {
                found.push(None)
            }
            _ => return None,
        }
    }
    // Quaternions have none; angles and times alone may have one.
    let is_unit = |field: &Field<'_>| field.text.chars().any(char::is_alphabetic) || field.text.contains('\u{b0}');
    (found.iter().any(Option::is_some) || fields.iter().filter(|field| is_unit(field)).count() > 2).then_some(found)
}

/// The unit before the words for the level that heights are over: `m ü. NHN`, `m a.s.l.`. In small letters.
fn over_sea(word: &str) -> &str {
    const LEVELS: [&str; 24] = [
        "ü", "ue", "über", "nhn", "nn", "nap", "m", "a", "adria", "asl", "amsl", "msl", "slm", "snm", "snmm", "ngf",
        "ign69", "ln02", "rh2000", "dhhn92", "dhhn2016", "evrf2007", "navd88", "od",
    ];
    let Some((unit, rest)) = word.split_once(' ') else { return word };
    let is_level = |part: &str| {
        let letters: String = part.chars().filter(|c| c.is_alphanumeric()).collect();
        letters.is_empty() || LEVELS.contains(&letters.as_str())
    };
    if rest.split_whitespace().all(is_level) { unit } else { word }
}

/// True for what begins like a number.
fn begins_as_number(field: &Field<'_>) -> bool {
    field.text.trim_start_matches(['-', '+', '(', '[']).starts_with(|c: char| c.is_ascii_digit())
}

/// A remark is a header if it names a column we would look for and holds no numbers.
fn is_header(names: &[Field<'_>], wanted: &[String], known: fn(&Field<'_>) -> bool) -> bool {
    let of_points = |f: &Field<'_>| {
        let base = f.text.split(['_', ' ', '[', '(']).next().unwrap_or_default();
        ["x", "y", "z"].iter().any(|axis| base.eq_ignore_ascii_case(axis))
            || wanted.iter().any(|w| w.eq_ignore_ascii_case(f.text))
    };
    let paired = names.iter().filter(|name| Role::of(name).is_of_a_pair() || known(name)).count() > 1;
    names.len() > 1 && (paired || names.iter().any(of_points)) && !names.iter().any(is_number)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (Vec<&str>, Vec<bool>, usize, Vec<&str>) {
        let preamble = Preamble::read(Source { name: "t", text }, &[], |_| false).unwrap();
        let texts = |fields: &[Field<'_>]| -> Vec<&str> {
            fields.iter().map(|f| &text[f.start..f.start + f.text.len()]).collect()
        };
        let units = preamble.units.iter().map(Option::is_some).collect();
        (texts(&preamble.header), units, preamble.titles.len(), texts(&preamble.first))
    }

    #[test]
    fn files_of_other_formats_are_called_by_their_names() {
        for (text, name) in [
            ("*110001+0000000000000001 81..40+0000003456000000 82..40+0000005432000000\n", "Leica GSI"),
            (
                "110001+00000001 81..10+00456000 82..10+05432000\n110002+00000002 81..10+00456000 82..10+05432000\n",
                "Leica GSI",
            ),
            ("<?xml version=\"1.0\"?>\n<LandXML>\n", "XML"),
            ("JB,NMSITE,DT01-02-2024,TM10:11:12\nMO,AD0,UN1,SF1.0\n", "survey controller"),
            ("nothing but words\n", "the file has no points"),
        ] {
            let refused = Preamble::read(Source { name: "t", text }, &[], |_| false).err().unwrap();
            assert!(refused.message.contains(name), "{text}: {}", refused.message);
        }
    }

    #[test]
    fn titles_names_and_units_are_told_apart() {
        for (text, header, units, titles, first) in [
            ("x;y\n1;2\n", &["x", "y"][..], &[][..], 0, &["1", "2"][..]),
            ("sep=;\nx;y\n1,5;2\n", &["x", "y"], &[], 0, &["1,5", "2"]),
            ("Aufmaß, Werkhof Süd\nNr;X;Y\n1;1,5;2\n", &["Nr", "X", "Y"], &[], 1, &["1", "1,5", "2"]),
            ("Survey of 12 March\nx y z\n1 2 3\n", &["x", "y", "z"], &[], 1, &["1", "2", "3"]),
            ("Projekt;17;;\n\nNr;X;Y;Code\n1;1,5;2;A\n", &["Nr", "X", "Y", "Code"], &[], 1, &["1", "1,5", "2", "A"]),
            ("Nr;X;Y\n;[m];[m]\n1;1,5;2\n", &["Nr", "X", "Y"], &[false, true, true], 0, &["1", "1,5", "2"]),
            ("X,Y\nm,m\n1,2\n", &["X", "Y"], &[true, true], 0, &["1", "2"]),
            ("Survey of the yard\n1 2\n3 4\n", &[], &[], 1, &["1", "2"]),
            ("x,y\nn/a,n/a\n1,2\n", &["x", "y"], &[], 0, &["n/a", "n/a"]),
            ("Point #,Easting,Northing\nP1,1,2\n", &["Point #", "Easting", "Northing"], &[], 0, &["P1", "1", "2"]),
            ("#;N [m];E [m]\n100;1;2\n", &["#", "N [m]", "E [m]"], &[], 0, &["100", "1", "2"]),
            ("Survey\n #\tN\tE\n\t[m]\t[m]\n7\t1\t2\n", &["#", "N", "E"], &[false, true, true], 1, &["7", "1", "2"]),
            ("N;E\n#;---;---\n1;2\n", &["N", "E"], &[], 0, &["1", "2"]),
            ("#,x,y\n1,1.5,2.5\n", &["#", "x", "y"], &[], 0, &["1", "1.5", "2.5"]),
            ("P1 1,5 2,25\nP2 3,5 4\n", &[], &[], 0, &["P1", "1,5", "2,25"]),
        ] {
            let found = read(text);
            assert_eq!((&found.0[..], &found.1[..], found.2, &found.3[..]), (header, units, titles, first), "{text:?}");
        }
    }
}
