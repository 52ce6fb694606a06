//! One face of the file against the parts of faces of the model that it is made of.

use super::border::{Border, Line};
use super::distance::{Piece, check_on_analytic, check_parameters};
use super::{Mismatch, require};
use crate::check::bodies::{FileCurve, FileEdge, FileFace, FileSurface};
use crate::check::deviation::larger;
use crate::export::face_plan::FacePlan;
use cyclide::{
    Point3,
    curve::Circle,
    model::ChainPiece,
    topology::{Shell, Side},
};
use std::collections::{HashMap, HashSet};

/// A line inside a face without an edge in the file is no wider than this part of the model's size; how wide it is counts as
/// a deviation.
const NARROW: f64 = 1e-6;
/// The turn of a whole circle of several arcs is a full one to this.
const FULL_TURN: f64 = 1e-6;

/// A side of a part, and what it borders on.
type InnerSide = ((usize, Side), Border);

/// A face of the file as the writer tells it.
pub(super) struct FaceCheck<'a> {
    shell: &'a Shell,
    plan: &'a FacePlan,
    size: f64,
    /// The parts, each with whether its outer side is that of `f_s × f_t`.
    pieces: Vec<(Piece<'a>, bool)>,
}

impl<'a> FaceCheck<'a> {
    pub(super) fn new(shell: &'a Shell, plan: &'a FacePlan, flip: bool, size: f64) -> Result<Self, Mismatch> {
        let piece = |part: &'a cyclide::topology::FacePart| {
            let face = shell.faces().get(part.face).ok_or(Mismatch("there is no such face"))?;
            Ok((Piece { surface: &face.surface, part }, face.same_sense != flip))
        };
        let pieces = plan.parts.iter().map(piece).collect::<Result<Vec<_>, Mismatch>>()?;
        Ok(Self { shell, plan, size, pieces })
    }

    /// The surface of the file's face against all parts.
    pub(super) fn surface_deviation(&self, file: &FileFace) -> Result<f64, Mismatch> {
        let is_one = self.pieces.len() == 1 || matches!(file.surface, FileSurface::Analytic(_));
        require(is_one, "a rational face corresponds to several faces of the model")?;
        let mut largest = 0.0_f64;
        for (piece, outer_side) in &self.pieces {
            largest = larger(largest, piece.surface_deviation(file, *outer_side)?);
        }
        Ok(largest)
    }

    fn border(&self, (part, side): (usize, Side)) -> Option<Border> {
        Border::of(self.shell, self.plan.parts.get(part)?, side)
    }

    /// Whether the loop round a part runs along the line of a border of it.
    fn runs_forward(&self, (part, side): (usize, Side), border: Border) -> bool {
        self.pieces.get(part).is_some_and(|(_, outer_side)| border.runs_forward(side, *outer_side))
    }

    /// Each side of a part is an edge, or meets another one inside the face, or is one point: how far those are from it that are none in the
    /// model.
    pub(super) fn sides_deviation(&self) -> Result<f64, Mismatch> {
        let mut with_edges: HashSet<(usize, Side)> = HashSet::new();
        for &side in self.plan.loops.iter().flatten().flatten() {
            require(with_edges.insert(side), "a side of a face corresponds to two edges")?;
        }
        // Sides of parts that meet inside the face, by the line they share.
        let mut inside: HashMap<(usize, usize), Vec<InnerSide>> = HashMap::new();
        for part in 0..self.pieces.len() {
            for side in Side::ALL {
                let own = (part, side);
                match self.border(own) {
                    Some(border) if !with_edges.contains(&own) => {
                        inside.entry(border.key()).or_default().push((own, border));
                    }
                    None if with_edges.contains(&own) => {
                        return Err(Mismatch("a face has a different number of edges"));
                    }
                    _ => {}
                }
            }
        }
        let mut largest = 0.0_f64;
        for sides in inside.into_values() {
            for &(own, border) in &sides {
                let forward = self.runs_forward(own, border);
                let meets = |(other, at): &((usize, Side), Border)| {
                    *other != own && at.is_same(&border) && self.runs_forward(*other, *at) != forward
                };
                if sides.iter().filter(|other| meets(other)).count() == 1 {
                    continue;
                }
                let width = self.pieces[own.0].0.width(own.1);
                let is_narrow = matches!(border.line, Line::Inside { .. }) && width <= NARROW * self.size;
                require(is_narrow, "a face has a different number of edges")?;
                largest = larger(largest, width);
            }
        }
        Ok(largest)
    }

    /// The borders that an edge of the file stands for, in its own direction, and how far it is from them.
    pub(super) fn edge_deviation(
        &self,
        file: &FileFace,
        edge: &FileEdge,
        sides: &[(usize, Side)],
    ) -> Result<(Vec<Border>, f64), Mismatch> {
        let borders = sides.iter().map(|&side| self.border(side)).collect::<Option<Vec<_>>>();
        let mut borders = borders.ok_or(Mismatch("a face has a different number of edges"))?;
        let off = match (sides, &borders[..]) {
            ([], _) => self.seam_deviation(file, edge)?,
            ([own], [border]) => {
                let piece = &self.pieces[own.0].0;
                require(edge.forward == self.runs_forward(*own, *border), "an edge of a face has the wrong direction")?;
                match &file.surface {
                    FileSurface::Rational(surface) => check_parameters(surface, (own.1, *border), edge, self.size)?,
                    FileSurface::Analytic(kind) => check_on_analytic(kind, edge, self.size)?,
                }
                piece.edge_deviation(own.1, *border, edge)
            }
            _ => {
                let is_analytic = matches!(file.surface, FileSurface::Analytic(_));
                require(
                    is_analytic && edge.parameter_curve.is_none(),
                    "an edge of a rational face corresponds to several edges",
                )?;
                self.chain_deviation(edge, sides)?
            }
        };
        if !edge.forward {
            borders.reverse();
        }
        Ok((borders, off))
    }

    /// A seam across the faces of the model: on the surface, from vertex to vertex, and with this face on both sides.
    fn seam_deviation(&self, file: &FileFace, edge: &FileEdge) -> Result<f64, Mismatch> {
        let (FileSurface::Analytic(kind), FileCurve::Piece(ChainPiece::Arc(arc))) = (&file.surface, &edge.curve) else {
            return Err(Mismatch("a face has a different number of edges"));
        };
        let uses: Vec<bool> = file.edges.iter().filter(|own| own.edge == edge.edge).map(|own| own.forward).collect();
        require(matches!(uses[..], [a, b] if a != b), "a seam is not traversed in both directions")?;
        let points = (0..=8).map(|i| arc.point(f64::from(i) / 8.0));
        let off = points.map(|p| kind.distance(p).unwrap_or(f64::INFINITY)).fold(0.0, larger);
        let at_ends = larger(arc.start().distance(edge.ends[0]), arc.end().distance(edge.ends[1]));
        Ok(larger(off, at_ends))
    }

    /// An edge against several sides one behind the other.
    fn chain_deviation(&self, edge: &FileEdge, sides: &[(usize, Side)]) -> Result<f64, Mismatch> {
        let mut largest = 0.0_f64;
        let mut points: Vec<Point3> = Vec::new();
        for &(part, side) in sides {
            let (piece, outer_side) = &self.pieces[part];
            let mut own: Vec<Point3> = piece.along(side).collect();
            if side.runs_with_loop() != *outer_side {
                own.reverse();
            }
            if let (Some(last), Some(first)) = (points.last(), own.first()) {
                largest = larger(largest, last.distance(*first));
            }
            points.extend(own);
        }
        if !edge.forward {
            points.reverse();
        }
        let distance = |p: &Point3| match &edge.curve {
            FileCurve::Piece(ChainPiece::Arc(arc)) => arc.closest_point(*p).distance,
            FileCurve::Circle(circle) => circle.closest_point(*p).distance,
            FileCurve::Piece(ChainPiece::Spline(_)) => f64::INFINITY,
        };
        largest = larger(largest, points.iter().map(distance).fold(0.0, larger));
        match &edge.curve {
            FileCurve::Circle(circle) => {
                // Its vertex may be anywhere on it.
                largest = larger(largest, circle.closest_point(edge.ends[0]).distance);
                if let (Some(last), Some(first)) = (points.last(), points.first()) {
                    largest = larger(largest, last.distance(*first));
                }
                require(
                    (turn(circle, &points) - std::f64::consts::TAU).abs() <= FULL_TURN,
                    "a circle is not traversed exactly once",
                )?;
            }
            FileCurve::Piece(ChainPiece::Arc(arc)) => {
                // On an arc the same points may be run in the other direction.
                let places: Vec<f64> = points.iter().map(|p| arc.closest_point(*p).t).collect();
                let goes_on = places.windows(2).all(|pair| pair[1] >= pair[0] - FULL_TURN);
                require(goes_on, "an edge of a face has the wrong direction")?;
                for (p, end) in [points.first(), points.last()].into_iter().flatten().zip(edge.ends) {
                    largest = larger(largest, p.distance(end));
                }
                largest =
                    larger(largest, larger(arc.start().distance(edge.ends[0]), arc.point(1.0).distance(edge.ends[1])));
            }
            FileCurve::Piece(ChainPiece::Spline(_)) => {}
        }
        Ok(largest)
    }
}

/// The angle about a circle's axis through which points run, none of which is half a turn from the one before it.
fn turn(circle: &Circle, points: &[Point3]) -> f64 {
    let (center, normal) = (circle.center(), circle.normal());
    let step = |pair: &[Point3]| {
        let [a, b] = [pair[0], pair[1]].map(|p| p - center);
        a.cross(b).dot(normal).atan2(a.dot(b))
    };
    points.windows(2).map(step).sum()
}
