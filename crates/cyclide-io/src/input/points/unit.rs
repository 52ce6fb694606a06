//! The unit that the name of a column speaks of, by its words.

use cyclide::model::Units;

use super::words::by_capitals;

/// What a word in a column's name says about its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum UnitWord {
    /// One that models can have.
    Known(Units),
    /// A length that no model is measured in.
    Other,
}

impl UnitWord {
    /// The unit of a word in small letters: its symbol, or its name in one spelling or the other.
    pub(super) fn of(word: &str) -> Option<Self> {
        let unit = match word {
            "millimetre" | "millimetres" | "millimeter" | "millimeters" => Units::Millimetre,
            "centimetre" | "centimetres" | "centimeter" | "centimeters" => Units::Centimetre,
            "metre" | "metres" | "meter" | "meters" | "metern" | "m\u{e8}tre" | "m\u{e8}tres" | "metro" | "metri"
            | "metros" | "\u{43c}" => Units::Metre,
            "inch" | "inches" | "zoll" | "pouce" | "pouces" | "pulgada" | "pulgadas" | "pollice" | "pollici" | "\""
            | "''" => Units::Inch,
            "foot" | "feet" | "ift" | "intft" | "ftint" | "int-ft" | "intl-ft" | "ft-int" | "fuss" | "fu\u{df}"
            | "pied" | "pieds" | "pie" | "pies" | "piede" | "piedi" => Units::Foot,
            "usft" | "ftus" | "sft" | "usfeet" | "usfoot" | "us-foot" | "us-feet" | "ft-us" | "survey-ft"
            | "survey-foot" | "survey-feet" | "us-survey-ft" | "us-survey-foot" | "us-survey-feet" | "ussurveyft"
            | "ussurveyfoot" | "ussurveyfeet" => Units::UsSurveyFoot,
            "nm" | "nanometre" | "nanometres" | "nanometer" | "nanometers" | "um" | "\u{b5}m" | "\u{3bc}m"
            | "micron" | "microns" | "micrometre" | "micrometres" | "micrometer" | "micrometers" | "dm"
            | "decimetre" | "decimetres" | "decimeter" | "decimeters" | "km" | "kilometre" | "kilometres"
            | "kilometer" | "kilometers" | "mil" | "mils" | "thou" | "yd" | "yard" | "yards" | "mi" | "mile"
            | "miles" => return Some(Self::Other),
            symbol => Units::from_symbol(symbol)?,
        };
        Some(Self::Known(unit))
    }
}

/// The unit that positions have by convention in messages of ROS (`pose.position.x`) and records of Universal Robots (`actual_TCP_pose_0`).
pub(super) fn unit_of_convention(name: &str) -> Option<UnitWord> {
    let name = name.to_lowercase();
    let ros = name.contains("pose.position.") || name.contains("transform.translation.");
    (ros || name.contains("tcp_pose_")).then_some(UnitWord::Known(Units::Metre))
}

/// The unit a column's name speaks of: `x_m`, `x [mm]`, `x (inch)`, `x/ft`, `x (US survey feet)`, `x (ft (US survey))`, `eastUSft`.
pub(super) fn unit_in_name(name: &str) -> Option<UnitWord> {
    let mut words = parts(name);
    let words = by_capitals(words.next()?).into_iter().skip(1).chain(words);
    let words: Vec<String> = words.map(str::to_lowercase).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    unit_of_words(&words).map(|(unit, _)| unit)
}

/// The unit that a text in small letters is: `m`, `us survey feet`, `ft (us survey)`.
pub(super) fn unit_alone(text: &str) -> Option<UnitWord> {
    let words: Vec<&str> = parts(text).collect();
    let (unit, at) = unit_of_words(&words)?;
    words[..at].iter().all(|word| is_of_foot(word) || *word == "in").then_some(unit)
}

/// The parts of a name that blanks, brackets and strokes separate.
fn parts(text: &str) -> impl Iterator<Item = &str> {
    text.split(['_', ' ', '[', ']', '(', ')', '/', ',', ';', '\t', '\u{a0}']).filter(|word| !word.is_empty())
}

/// True for a word that says which foot is meant.
fn is_of_foot(word: &str) -> bool {
    is_of_survey(word) || matches!(word.trim_end_matches('.'), "international" | "intl" | "int")
}

/// True for a word of the survey foot.
fn is_of_survey(word: &str) -> bool {
    matches!(word, "us" | "u.s." | "u.s" | "usa" | "survey")
}

/// The unit that the last of several words is, and where it stands; words of the survey foot may stand before it or behind.
fn unit_of_words(words: &[&str]) -> Option<(UnitWord, usize)> {
    let behind = words.iter().rev().take_while(|word| is_of_foot(word)).count();
    let at = words.len().checked_sub(behind + 1)?;
    let of_survey = words.iter().any(|word| is_of_survey(word));
    match UnitWord::of(words[at])? {
        UnitWord::Known(Units::Foot) if of_survey => Some((UnitWord::Known(Units::UsSurveyFoot), at)),
        // No other unit has a word behind it.
        unit @ UnitWord::Known(Units::Foot | Units::UsSurveyFoot) => Some((unit, at)),
        unit => (behind == 0).then_some((unit, at)),
    }
}
