//! Our own SVG back from the bytes: the contours' paths, and the lines of surfaces.

use super::plan;
use crate::file_content::{FileContent, ReadError};
use cyclide::{Arc, ArcPath, CurveChain, Point3, Vec3};

/// How the element of a contour starts.
pub(super) const CONTOUR: &str = "<path class=\"contour\" d=\"";
/// How the group of the lines of surfaces starts, before its name, and each line in it.
pub(super) const GROUP: &str = "<g id=\"";
pub(super) const LINE: &str = "<path d=\"";

/// Reads the contours and the lines of surfaces in file order, in the plane.
pub(crate) fn read(bytes: &[u8]) -> Result<FileContent, ReadError> {
    let text = std::str::from_utf8(bytes).map_err(|e| ReadError::syntax("the text", e.to_string()))?;
    let mut content = FileContent::from(paths(text, CONTOUR, "contour")?);
    for name in plan::GROUPS {
        if let Some((_, rest)) = text.split_once(&format!("{GROUP}{name}\" ")) {
            let group = rest.split_once("</g>").ok_or_else(|| ReadError::syntax(name, "the group has no end"))?.0;
            content.lines.extend(paths(group, LINE, name)?);
        }
    }
    Ok(content)
}

/// The paths whose elements start in this way.
fn paths(text: &str, start: &str, what: &str) -> Result<Vec<CurveChain>, ReadError> {
    let mut chains = Vec::new();
    for (i, rest) in text.split(start).skip(1).enumerate() {
        let place = format!("{what} {i}");
        let data = rest.split_once('"').ok_or_else(|| ReadError::syntax(&place, "the path has no end"))?.0;
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
            return Err(ReadError::syntax(self.place, "a path starts with M"));
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
