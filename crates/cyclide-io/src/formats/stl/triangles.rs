//! Triangles of STL files of any program, binary or text.

use cyclide::{Point3, mesh::MeshFace};

use super::{HEAD, RECORD, read};
use crate::input::points::MOST_POINTS;
use crate::text::lines::lines;
use crate::text::place::{Diagnostic, Source, decode};

/// Reads the corners of the triangles, three by three; `name` is what messages call the file.
///
/// # Errors
/// A message with the file, of text with line and column.
pub(crate) fn read_triangles(name: &str, bytes: &[u8]) -> Result<Vec<Point3>, Box<Diagnostic>> {
    if is_binary(bytes) { of_binary(name, bytes) } else { of_text(name, bytes) }
}

/// By the length, which the head tells: the first word of binary files may be that of text.
fn is_binary(bytes: &[u8]) -> bool {
    let count = bytes.get(HEAD..).and_then(<[u8]>::first_chunk).map(|count| u32::from_le_bytes(*count) as usize);
    let whole = count.and_then(|count| count.checked_mul(RECORD)?.checked_add(HEAD + 4));
    whole == Some(bytes.len()) || !bytes.trim_ascii_start().starts_with(b"solid")
}

fn of_binary(name: &str, bytes: &[u8]) -> Result<Vec<Point3>, Box<Diagnostic>> {
    let refused = |message: String| Source { name, text: "" }.diagnostic(0..0, "", message);
    if bytes.len() / RECORD > MOST_POINTS / 3 {
        return Err(refused(format!("the file has more than {MOST_POINTS} points")));
    }
    let content = read(bytes).map_err(|error| refused(format!("not an STL file: {error}")))?;
    let corners = content.meshes.iter().flat_map(|mesh| {
        let faces = mesh.faces.iter().flat_map(MeshFace::corners);
        faces.map(|corner| mesh.positions[corner.position])
    });
    let corners: Vec<Point3> = corners.collect();
    if corners.is_empty() { Err(refused("the file contains no triangles".to_owned())) } else { Ok(corners) }
}

fn of_text(name: &str, bytes: &[u8]) -> Result<Vec<Point3>, Box<Diagnostic>> {
    let source = Source { name, text: decode(name, bytes)? };
    let mut corners = Vec::new();
    let mut in_loop = 0;
    for (start, line) in lines(source.text) {
        let refused = |message: String| Err(source.diagnostic(start..start + line.len(), "", message));
        let mut words = line.split_whitespace();
        match words.next() {
            Some("vertex") => {
                let numbers: Option<Vec<f64>> =
                    words.map(|word| word.parse().ok().filter(|x: &f64| x.is_finite())).collect();
                let Some(&[x, y, z]) = numbers.as_deref() else {
                    return refused("a vertex needs three coordinates".to_owned());
                };
                if corners.len() == MOST_POINTS {
                    return refused(format!("the file has more than {MOST_POINTS} points"));
                }
                in_loop += 1;
                corners.push(Point3::new(x, y, z));
            }
            Some("endloop") => {
                if in_loop != 3 {
                    return refused(format!("a facet has {in_loop} vertices instead of three"));
                }
                in_loop = 0;
            }
            _ => {}
        }
    }
    match (in_loop, corners.len()) {
        (0, 0) => Err(source.diagnostic(0..0, "", "the file contains no triangles")),
        (0, _) => Ok(corners),
        _ => Err(source.diagnostic(source.text.len()..source.text.len(), "", "the last facet is not closed")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "solid t\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1e0 -0.5\n endloop\nendfacet\nendsolid t\n";

    #[test]
    fn text_and_binary_give_the_same_triangles() {
        let corners = [Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, -0.5)];
        assert_eq!(read_triangles("t.stl", TEXT.as_bytes()).unwrap(), corners);
        // A head that starts as text does.
        let mut bytes = b"solid but binary".to_vec();
        bytes.resize(HEAD, b' ');
        bytes.extend(1_u32.to_le_bytes());
        bytes.extend([0; 12]);
        for p in corners {
            bytes.extend(p.to_array().iter().flat_map(|x| (*x as f32).to_le_bytes()));
        }
        bytes.extend([0; 2]);
        assert_eq!(read_triangles("t.stl", &bytes).unwrap(), corners);
        bytes.pop();
        assert!(read_triangles("t.stl", &bytes[16..]).is_err());
    }

    #[test]
    fn what_is_no_triangle_is_refused_at_its_line() {
        let message = |text: String| read_triangles("t.stl", text.as_bytes()).unwrap_err().to_string();
        assert!(message(TEXT.replace("1e0", "one")).starts_with("t.stl:6:1: a vertex needs three coordinates"));
        assert!(message(TEXT.replace("  vertex 1 0 0\n", "")).starts_with("t.stl:6:1: a facet has 2 vertices"));
        assert!(message(TEXT[..60].to_owned()).contains("the last facet is not closed"));
        assert!(message("solid\nendsolid\n".to_owned()).contains("no triangles"));
        assert!(message("v 0 0 0\n".to_owned()).contains("not an STL file"));
    }
}
