//! What the lines of surfaces in a drawing stand for: told by who draws them, held against the file by the check.

use crate::export::parts::BodyOf;
use cyclide::topology::{EdgeCurve, FaceGeometry as _};

/// Which line of a shell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ShellLine {
    Edge(usize),
    /// The s-line of a face at a parameter t.
    AlongS {
        face: usize,
        t: f64,
    },
    /// The t-line of a face at a parameter s.
    AlongT {
        face: usize,
        s: f64,
    },
}

/// Which line of a model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LinePlace {
    /// Index of the body in the model.
    pub(crate) body: usize,
    pub(crate) shell: usize,
    pub(crate) line: ShellLine,
}

impl LinePlace {
    /// The line; `None` if there is none at this place.
    pub(crate) fn curve(&self, bodies: &[BodyOf<'_>]) -> Option<cyclide::Result<EdgeCurve>> {
        let shell = bodies.get(self.body)?.body.shells().nth(self.shell)?;
        let surface = |face: usize| shell.faces().get(face).map(|face| &face.surface);
        match self.line {
            ShellLine::Edge(edge) => shell.edges().get(edge).map(|edge| Ok(edge.curve.clone())),
            ShellLine::AlongS { face, t } => surface(face).map(|surface| surface.s_line(t)),
            ShellLine::AlongT { face, s } => surface(face).map(|surface| surface.t_line(s)),
        }
    }

    /// Parameter lines in the order in which they are drawn; `None` for edges and for what is no inner line.
    pub(crate) fn rank(&self) -> Option<(usize, usize, usize, bool, f64)> {
        let (face, along_s, parameter) = match self.line {
            ShellLine::Edge(_) => return None,
            ShellLine::AlongS { face, t } => (face, true, t),
            ShellLine::AlongT { face, s } => (face, false, s),
        };
        (parameter > 0.0 && parameter < 1.0).then_some((self.body, self.shell, face, along_s, parameter))
    }
}
