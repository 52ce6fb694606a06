//! The `d` attribute of one connected curve.

use crate::export::exported::straightened;
use crate::text::number::push_plain;
use cyclide::{Aabb, Point3, curve::Arc, model::Exactness};

/// Largest angle of one `A` command: near half a turn readers find the center badly.
const LARGEST_SWEEP: f64 = 150.0 * std::f64::consts::PI / 180.0;

/// A path that grows piece by piece, in the drawing's axes (the second one down).
pub(super) struct Path {
    data: String,
    /// Length of the text when nothing is drawn yet.
    start_length: usize,
    start: Point3,
    at: Point3,
    /// End of a segment that is not written yet: the one that closes the path is left to `Z`.
    pending: Option<Point3>,
    closed: bool,
    bounds: Aabb,
}

impl Path {
    pub(super) fn new(start: Point3, closed: bool) -> Self {
        let start = on_page(start);
        let mut data = String::from("M");
        push_point(&mut data, start);
        Self { start_length: data.len(), data, start, at: start, pending: None, closed, bounds: Aabb::of_point(start) }
    }

    /// Box around the path.
    pub(super) fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// True if nothing was drawn: the curve is one point on the page.
    pub(super) fn is_point(&self) -> bool {
        self.data.len() == self.start_length && self.pending.is_none()
    }

    /// The finished attribute.
    pub(super) fn into_data(mut self) -> String {
        if self.closed && self.pending == Some(self.start) {
            self.pending = None;
        }
        self.flush();
        if self.closed {
            self.data.push_str(" Z");
        }
        self.data
    }

    fn flush(&mut self) {
        if let Some(end) = self.pending.take() {
            self.data.push_str(" L");
            push_point(&mut self.data, end);
        }
    }

    /// Adds a level arc or any segment; tells what was lost, and in how many pieces it was drawn.
    pub(super) fn arc(&mut self, arc: &Arc) -> (Exactness, usize) {
        let lost = straightened(arc);
        let (Some(radius), Some(normal), None) = (arc.radius(), arc.normal(), lost) else {
            let drawn = self.segment(arc.end());
            return (lost.unwrap_or(Exactness::Exact), drawn);
        };
        // 1e-9: exactly 150 degrees made in floats needs no second part.
        self.flush();
        let parts = (arc.angle() / LARGEST_SWEEP - 1e-9).ceil().max(1.0);
        // Counter-clockwise in the model is falling angle on a page whose second axis points down.
        let sweep = if normal.z > 0.0 { " 0 0 0 " } else { " 0 0 1 " };
        for i in 1..=parts as usize {
            let fraction = i as f64 / parts;
            let end = if fraction < 1.0 { arc.point_at_length(fraction) } else { arc.end() };
            self.data.push_str(" A");
            push_plain(&mut self.data, radius);
            self.data.push(' ');
            push_plain(&mut self.data, radius);
            self.data.push_str(sweep);
            self.at = on_page(end);
            push_point(&mut self.data, self.at);
        }
        let own = arc.bounds();
        self.bounds = self.bounds.including(on_page(own.min)).including(on_page(own.max));
        (Exactness::Exact, parts as usize)
    }

    /// Adds a segment, unless it has no length on the page; gives how many were drawn.
    pub(super) fn segment(&mut self, end: Point3) -> usize {
        let end = on_page(end);
        if end == self.at {
            return 0;
        }
        self.flush();
        self.pending = Some(end);
        self.at = end;
        self.bounds = self.bounds.including(end);
        1
    }
}

fn on_page(p: Point3) -> Point3 {
    Point3::new(p.x, -p.y, 0.0)
}

fn push_point(out: &mut String, p: Point3) {
    push_plain(out, p.x);
    out.push(' ');
    push_plain(out, p.y);
}
