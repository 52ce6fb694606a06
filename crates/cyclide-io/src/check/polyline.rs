//! Polylines as formats of vertices hold them: closed where they end with their first vertex.

use crate::check::read_error::ReadError;
use cyclide::{
    Point3,
    curve::Arc,
    model::{ChainPiece, CurveChain},
};

/// A polyline that was read, closed if it ends with its first vertex.
pub(crate) fn chain(points: &[Point3], place: impl Fn() -> String) -> Result<CurveChain, ReadError> {
    let mut polyline = Polyline::with_capacity(points.len());
    points.iter().try_for_each(|p| polyline.push(*p, &place))?;
    polyline.finish(place)
}

/// A polyline that is being read, vertex by vertex.
pub(crate) struct Polyline {
    /// Its first vertex and its last so far.
    ends: Option<[Point3; 2]>,
    segments: Vec<ChainPiece>,
}

impl Polyline {
    /// One of so many vertices, about.
    pub(crate) fn with_capacity(vertices: usize) -> Self {
        Self { ends: None, segments: Vec::with_capacity(vertices.saturating_sub(1)) }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.ends.is_none()
    }

    pub(crate) fn push(&mut self, p: Point3, place: impl Fn() -> String) -> Result<(), ReadError> {
        if let Some([_, last]) = self.ends {
            let segment = Arc::segment(last, p).map_err(|source| ReadError::Geometry { place: place(), source })?;
            self.segments.push(ChainPiece::Arc(segment));
        }
        self.ends = Some([self.ends.map_or(p, |[first, _]| first), p]);
        Ok(())
    }

    /// The chain; closed if it ends with its first vertex.
    pub(crate) fn finish(self, place: impl Fn() -> String) -> Result<CurveChain, ReadError> {
        let closed = !self.segments.is_empty() && self.ends.is_some_and(|[first, last]| first == last);
        CurveChain::new(self.segments, closed, 0.0).map_err(|source| ReadError::Geometry { place: place(), source })
    }
}
