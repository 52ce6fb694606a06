//! Which part of a curve each part of another form of it stands for.
//!
//! Whoever makes the form knows it: the parts follow each other along both. Who checks the form against the curve then
//! has short parts to compare, each with its own, and need not search.

/// A place on a curve: a smooth piece and its own parameter in `[0, 1]`. On a closed curve the number of the piece may
/// run on beyond the last one: then it is taken modulo the number of pieces.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{CurvePlace, ParamCurve}};
/// let circle = cyclide::curve::Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?;
/// let place = CurvePlace::new(0, 0.25);
/// assert!(circle.piece_point(place.piece, place.s).distance(circle.point(0.25)) < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePlace {
    /// The smooth piece.
    pub piece: usize,
    /// Parameter of the piece.
    pub s: f64,
}

impl CurvePlace {
    /// The place.
    #[must_use]
    pub const fn new(piece: usize, s: f64) -> Self {
        Self { piece, s }
    }

    /// The end of a piece, as the start of the next one.
    #[must_use]
    pub const fn after(piece: usize) -> Self {
        Self { piece: piece + 1, s: 0.0 }
    }

    /// True if the place is not before another one.
    #[must_use]
    pub fn is_from(self, other: Self) -> bool {
        let ordered = |place: Self| if place.s < 1.0 { (place.piece, place.s) } else { (place.piece + 1, 0.0) };
        ordered(self) >= ordered(other)
    }
}

/// The next smooth pieces of the form, and where the part of the curve ends that they stand for.
///
/// ```
/// use cyclide::curve::{Correspondence, CurvePlace, Span};
/// // Two pieces of a file stand for the first piece of a curve.
/// let span = Span { pieces: 2, end: CurvePlace::after(0) };
/// let parts = Correspondence { start: CurvePlace::new(0, 0.0), spans: vec![span] };
/// assert_eq!(parts.piece_count(), 2);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// How many smooth pieces of the form; none where a part of the curve was too small to be kept.
    pub pieces: usize,
    /// Where the part of the curve ends; it begins where that of the span before ends.
    pub end: CurvePlace,
}

/// The parts of a curve in the order of the form's pieces.
///
/// ```
/// use cyclide::curve::Correspondence;
/// assert_eq!(Correspondence::one_to_one(3).piece_count(), 3);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Correspondence {
    /// Where the first part begins: the start of the curve, or of a closed one any place.
    pub start: CurvePlace,
    /// The parts.
    pub spans: Vec<Span>,
}

impl Correspondence {
    /// A form that begins where the curve begins, without parts yet.
    #[must_use]
    pub const fn from_start(capacity: Vec<Span>) -> Self {
        Self { start: CurvePlace::new(0, 0.0), spans: capacity }
    }

    /// Piece for piece.
    #[must_use]
    pub fn one_to_one(pieces: usize) -> Self {
        Self::from_start((0..pieces).map(|i| Span { pieces: 1, end: CurvePlace::after(i) }).collect())
    }

    /// The vertices of a polyline at these places, the first one included: a segment from each to the next.
    #[must_use]
    pub fn of_vertices(places: impl IntoIterator<Item = CurvePlace>) -> Self {
        let mut places = places.into_iter();
        let start = places.next().unwrap_or(CurvePlace::new(0, 0.0));
        let mut spans: Vec<Span> = places.map(|end| Span { pieces: 1, end }).collect();
        // It may be in the place of what it was made from, which was larger.
        spans.shrink_to_fit();
        Self { start, spans }
    }

    /// The correspondence after every piece of the form was replaced by others: `pieces` gives how many each has become,
    /// in order.
    #[must_use]
    pub fn recounted(mut self, pieces: impl IntoIterator<Item = usize>) -> Self {
        let mut pieces = pieces.into_iter();
        for span in &mut self.spans {
            span.pieces = pieces.by_ref().take(span.pieces).sum();
        }
        self
    }

    /// Smooth pieces of the form.
    #[must_use]
    pub fn piece_count(&self) -> usize {
        self.spans.iter().map(|span| span.pieces).sum()
    }
}
