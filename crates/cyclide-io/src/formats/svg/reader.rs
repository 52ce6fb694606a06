//! Our own SVG back from the bytes: the contours' paths, and the lines of surfaces.

use crate::check::file_content::FileContent;
use crate::check::labels::{FileLabels, FileName};
use crate::check::read_error::ReadError;
use cyclide::{
    Point3, ShortNumber, Vec3,
    curve::{Arc, ArcPath},
    model::{CurveChain, Units},
};

/// How the element of a contour starts.
pub(super) const CONTOUR: &str = "<path class=\"contour\" d=\"";
/// Names of the groups in the order in which they are drawn: inner circles, edges.
pub(super) const GROUPS: [&str; 2] = ["circles", "edges"];
/// How the group of the lines of surfaces starts, before its name, and each line in it.
pub(super) const GROUP: &str = "<g id=\"";
pub(super) const LINE: &str = "<path d=\"";
/// What stands round a title, and round the meaning of a user unit; what stands before the scale in it.
pub(super) const TITLE: (&str, &str) = ("<title>", "</title>");
pub(super) const DESCRIPTION: (&str, &str) = ("<desc>1 user unit = 1 ", "</desc>");
pub(super) const SCALE: &str = "to the scale 1:";
/// What the names are those of.
pub(super) const TITLE_OF_ALL: &str = "title of the drawing";
pub(super) const TITLE_OF: &str = "title of group";
pub(super) const ID_OF: &str = "group";
/// Rounding of the decimals of width, height and viewBox.
const DIGITS: f64 = 1e-12;

/// Reads the contours and the lines of surfaces in file order, in the plane.
pub(crate) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let text = std::str::from_utf8(bytes).map_err(|e| ReadError::syntax("the text", e.to_string()))?;
    let labels = FileLabels { unit: unit(text)?, names: names(text) };
    let mut content = FileContent { labels, ..FileContent::from(paths(text, CONTOUR, "contour")?) };
    for name in GROUPS {
        if let Some((_, rest)) = text.split_once(&format!("{GROUP}{name}\" ")) {
            let group = rest.split_once("</g>").ok_or_else(|| ReadError::syntax(name, "the group is not closed"))?.0;
            content.lines.extend(paths(group, LINE, name)?);
        }
    }
    Ok(content)
}

/// The text between two others, the first time.
fn between<'a>(text: &'a str, before: &str, after: &str) -> Option<&'a str> {
    Some(text.split_once(before)?.1.split_once(after)?.0)
}

/// Length of a user unit in the model, millimeters: its size on paper times the scale of the drawing, which must be what
/// the description says.
fn unit(text: &str) -> Result<Option<f64>, ReadError> {
    let Some(root) = between(text, "<svg ", ">") else { return Ok(None) };
    let wrong = |detail: &str| ReadError::syntax("the svg element", detail);
    let side = |name: &str| between(root, &format!("{name}=\""), "mm\"")?.parse::<f64>().ok();
    let area = between(root, "viewBox=\"", "\"").and_then(|area| {
        let numbers: Option<Vec<f64>> = area.split(' ').map(|v| v.parse().ok()).collect();
        <[f64; 4]>::try_from(numbers?).ok()
    });
    let (Some(width), Some(height), Some([_, _, w, h])) = (side("width"), side("height"), area) else {
        return Err(wrong("expected a width and a height in mm and a viewBox of four numbers"));
    };
    let description = between(text, DESCRIPTION.0, DESCRIPTION.1);
    let description = description.ok_or_else(|| wrong("the description does not state the user unit"))?;
    let (symbol, scale) = description.split_once(SCALE).unwrap_or((description, "1"));
    let unit = Units::from_symbol(symbol.split(';').next().unwrap_or_default()).map(Units::in_millimetres);
    let (Some(unit), Ok(scale)) = (unit, scale.parse::<f64>()) else {
        return Err(wrong("the description does not state the user unit"));
    };
    let measured = width / w * scale;
    let near = |a: f64, b: f64| (a - b).abs() <= DIGITS * b;
    if !(near(measured, unit) && near(height / h * scale, unit)) {
        let detail = format!(
            "a user unit is {} mm by width and height, but {} mm by the description",
            ShortNumber(measured),
            ShortNumber(unit)
        );
        return Err(wrong(&detail));
    }
    Ok(Some(unit))
}

/// The title, and for each object with contours the id and the title of its group.
fn names(text: &str) -> Vec<FileName> {
    let mut names: Vec<FileName> = Vec::new();
    for line in text.lines() {
        if let Some((id, rest)) = line.strip_prefix(GROUP).and_then(|rest| rest.split_once('"')) {
            // The drawing's own groups have no title.
            if let Some(title) = between(rest, TITLE.0, TITLE.1) {
                names.extend([FileName::new(TITLE_OF, title, 1), FileName::new(ID_OF, id, 0)]);
            }
        } else if line.starts_with(CONTOUR) {
            if let Some(last) = names.last_mut().filter(|last| last.of == ID_OF) {
                last.count += 1;
            }
        } else if let Some(title) = line.strip_prefix(TITLE.0).and_then(|rest| rest.strip_suffix(TITLE.1)) {
            names.push(FileName::new(TITLE_OF_ALL, title, 1));
        }
    }
    names
}

/// The paths whose elements start in this way.
fn paths(text: &str, start: &str, what: &str) -> Result<Vec<CurveChain>, ReadError> {
    let mut chains = Vec::new();
    for (i, rest) in text.split(start).skip(1).enumerate() {
        let place = format!("{what} {i}");
        let data = rest.split_once('"').ok_or_else(|| ReadError::syntax(&place, "the path is not closed"))?.0;
        let (arcs, closed) = Reader { rest: data, place: &place }.path()?;
        let path = ArcPath::new(arcs, closed);
        chains.push(path.map_err(|source| ReadError::Geometry { place, source })?.into());
    }
    Ok(chains)
}

struct Reader<'a> {
    rest: &'a str,
    place: &'a str,
}

impl Reader<'_> {
    fn path(mut self) -> Result<(Vec<Arc>, bool), ReadError> {
        let mut arcs = Vec::new();
        if self.command() != Some('M') {
            return Err(ReadError::syntax(self.place, "a path must start with M"));
        }
        let start = self.point()?;
        let mut at = start;
        while let Some(command) = self.command() {
            match command {
                'L' => {
                    let end = self.point()?;
                    arcs.push(self.checked(Arc::segment(at, end))?);
                    at = end;
                }
                'A' => {
                    let (radius, _, _) = (self.number()?, self.number()?, self.number()?);
                    let (_, sweep, end) = (self.number()?, self.number()?, self.point()?);
                    arcs.push(self.checked(arc(at, end, radius, sweep > 0.5))?);
                    at = end;
                }
                'Z' => {
                    if at != start {
                        arcs.push(self.checked(Arc::segment(at, start))?);
                    }
                    return Ok((arcs, true));
                }
                other => return Err(ReadError::unsupported(format!("command {other}"), self.place)),
            }
        }
        Ok((arcs, false))
    }

    fn command(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        let command = self.rest.chars().next()?;
        self.rest = &self.rest[command.len_utf8()..];
        Some(command)
    }

    fn number(&mut self) -> Result<f64, ReadError> {
        self.rest = self.rest.trim_start();
        let length = self.rest.bytes().take_while(|b| b.is_ascii_digit() || b"+-.e".contains(b)).count();
        let (digits, rest) = self.rest.split_at(length);
        self.rest = rest;
        let number: Option<f64> = digits.parse().ok().filter(|v: &f64| v.is_finite());
        number.ok_or_else(|| ReadError::syntax(self.place, format!("'{digits}' is not a number")))
    }

    fn point(&mut self) -> Result<Point3, ReadError> {
        Ok(Point3::new(self.number()?, -self.number()?, 0.0))
    }

    fn checked(&self, arc: cyclide::Result<Arc>) -> Result<Arc, ReadError> {
        arc.map_err(|source| ReadError::Geometry { place: self.place.to_owned(), source })
    }
}

/// The short arc of a radius between two points, clockwise on the page if `sweep`; a radius that is too small for
/// the chord counts as half the chord, as renderers do.
fn arc(start: Point3, end: Point3, radius: f64, sweep: bool) -> cyclide::Result<Arc> {
    let sine = 0.5 * start.distance(end) / radius;
    let bulge = (0.5 * sine.min(1.0).asin()).tan();
    Arc::from_bulge(start, end, Vec3::Z, if sweep { -bulge } else { bulge })
}
