//! Objects from objects, whatever their kind: images under maps, parallel surfaces, solids between them.

use super::chain::ChainPiece;
use super::lower::{Exactness, Lower as _, Lowered};
use super::object::CurveObject;
use super::surface_object::SurfaceObject;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::construct::{Pipe, Revolution};
use crate::curve::{Arc, ArcPath, ParamCurve as _, QbSpline};
use crate::error::{CurveError, Error, NurbsError, PartError, Result};
use crate::surface::CyclidicNet;
use crate::topology::{Body, EdgeCurve, Shell};

impl Conformal for CurveObject {
    /// The image: of arcs, chains of arcs, rational B-splines and QB splines under any map, of circles, circle splines and splines
    /// on tori under similarities and reflections.
    ///
    /// # Errors
    /// As the curve's own `transformed` or `similar`; `not-a-similarity`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        match self {
            Self::Arc(c) => c.transformed(map).map(Self::Arc),
            Self::Circle(c) => c.similar(map).map(Self::Circle),
            Self::ArcPath(c) => c.transformed(map).map(Self::ArcPath),
            Self::CircleSpline(c) => c.similar(map).map(Self::CircleSpline),
            Self::TorusSpline(c) => c.similar(map).map(Self::TorusSpline),
            Self::Nurbs(c) => c.transformed(map).map(Self::Nurbs),
            Self::QbSpline(c) => c.transformed(map).map(Self::QbSpline),
        }
    }
}

impl Conformal for SurfaceObject {
    /// The image under any map that keeps the surface finite, of a surface over triangles under a similarity.
    ///
    /// # Errors
    /// As the surface's own `transformed` or `similar`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        match self {
            Self::Patch(patch) => patch.transformed(map).map(Self::Patch),
            Self::Net(net) => net.transformed(map).map(Self::Net),
            Self::Layout(layout) => layout.transformed(map).map(Self::Layout),
            Self::Body(body) => body.transformed(map).map(Self::Body),
            Self::Triangles(surface) => surface.similar(map).map(Self::Triangles),
        }
    }
}

impl CurveObject {
    /// The body that the curve sweeps when it turns about an axis, exact: see [`Revolution::body`].
    ///
    /// # Errors
    /// `not-a-spline` for a trigonometric circle spline, which has no rational form; as [`Revolution::body`].
    pub fn revolved(&self, turn: &Revolution) -> Result<SurfaceObject> {
        let (profile, closed) = self.exact_pieces()?;
        turn.body(&profile, closed).map(SurfaceObject::Body)
    }

    /// The pieces of the exact form, as [`Revolution`] and [`RailSurface`](crate::construct::RailSurface) take them, and whether the last one ends where the
    /// first begins.
    ///
    /// # Errors
    /// `not-a-spline` for a trigonometric circle spline, which has no rational form.
    pub fn exact_pieces(&self) -> Result<(Vec<EdgeCurve>, bool)> {
        // What is exact does not ask for the tolerance.
        let Lowered { form, exactness, .. } = self.lower_to_chain(1.0)?;
        if exactness != Exactness::Exact {
            let detail = "a trigonometric circle spline has no rational form: use the rational variant";
            return Err(NurbsError::NotASpline { detail }.into());
        }
        let closed = form.is_closed();
        let mut pieces: Vec<EdgeCurve> = Vec::new();
        for piece in form.into_pieces() {
            match piece {
                ChainPiece::Arc(arc) => pieces.push(arc.into()),
                ChainPiece::Spline(spline) => pieces.extend(spline.to_beziers().into_iter().map(EdgeCurve::from)),
            }
        }
        Ok((pieces, closed))
    }
}

impl CurveObject {
    /// The pipe about the curve: see [`Pipe::body`]. About what is not made of arcs and segments it follows arcs within the
    /// tolerance, if one is given.
    ///
    /// # Errors
    /// `not-of-arcs`, errors of the arcs that stand for the curve, and as [`Pipe::body`].
    pub fn piped(&self, pipe: &Pipe, tolerance: Option<f64>) -> Result<SurfaceObject> {
        pipe.body(&self.spine(tolerance)?).map(SurfaceObject::Body)
    }

    /// True of what is made of arcs and segments.
    #[must_use]
    pub fn is_of_arcs(&self) -> bool {
        match self {
            Self::Arc(_) | Self::Circle(_) | Self::ArcPath(_) => true,
            Self::CircleSpline(_) => false,
            Self::TorusSpline(spline) => spline.pieces().iter().all(|piece| piece.degree() == 2),
            Self::Nurbs(curve) => curve.degree() == 1,
            Self::QbSpline(spline) => spline.spans().iter().all(|span| span.degree() == 1),
        }
    }

    /// The chain of QB curves that it is, if it is one: of arcs and segments, a Möbius spline, an interpolant, or a circle spline of
    /// order 1 in its rational variant.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, curve::Circle, model::CurveObject};
    /// let circle = CurveObject::from(Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?);
    /// assert_eq!(circle.to_qb_spline().map(|chain| chain.degree()), Some(1));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn to_qb_spline(&self) -> Option<QbSpline> {
        match self {
            Self::QbSpline(spline) => Some(spline.clone()),
            Self::CircleSpline(spline) => QbSpline::from_circle_spline(spline),
            _ => self.spine(None).ok().map(|arcs| QbSpline::from_arcs(&arcs)),
        }
    }

    /// The arcs and segments that a pipe about the curve follows: its own, or those within the tolerance, if one is given.
    ///
    /// # Errors
    /// `not-of-arcs`, errors of the arcs that stand for the curve.
    pub fn spine(&self, tolerance: Option<f64>) -> Result<ArcPath> {
        let wanted = "polyline, arc-spline, arc-fit, circle";
        let of_arcs = self.is_of_arcs();
        // What is exact does not ask for the tolerance.
        let tolerance = tolerance.or_else(|| of_arcs.then_some(1.0)).ok_or(CurveError::NotOfArcs { wanted })?;
        Ok(self.lower_to_arcs(tolerance)?.form)
    }
}

impl SurfaceObject {
    /// The bodies that curves sweep when they turn about an axis, exact; solids inside others are hollows of these: see
    /// [`Revolution::bodies`].
    ///
    /// # Errors
    /// As [`CurveObject::revolved`] and [`Revolution::bodies`].
    pub fn revolved(curves: &[CurveObject], turn: &Revolution) -> Result<Vec<Self>> {
        let profiles = curves.iter().map(CurveObject::exact_pieces).collect::<Result<Vec<_>>>()?;
        Ok(turn.bodies(&profiles)?.into_iter().map(Self::Body).collect())
    }

    /// The parallel surface at a signed distance along the unit normal, exact; `None` for a solid, whose normal is not
    /// one along its creases, and for a surface over triangles.
    ///
    /// # Errors
    /// As the surface's own `offset`.
    #[must_use]
    pub fn offset(&self, distance: f64) -> Option<Result<Self>> {
        match self {
            Self::Patch(patch) => Some(patch.offset(distance).map(Self::Patch)),
            Self::Net(net) => Some(net.offset(distance).map(Self::Net)),
            Self::Layout(layout) => Some(layout.offset(distance).map(Self::Layout)),
            Self::Body(_) | Self::Triangles(_) => None,
        }
    }

    /// The solid between the surface and its parallel surface; `None` for what is a solid between two surfaces already,
    /// and for a surface over triangles.
    ///
    /// # Errors
    /// As [`CyclidicNet::thick`].
    #[must_use]
    pub fn thick(&self, distance: f64) -> Option<Result<Self>> {
        match self {
            Self::Patch(patch) => Some(CyclidicNet::from(*patch).thick(distance).map(Self::Body).map_err(of_one_quad)),
            Self::Net(net) => Some(net.thick(distance).map(Self::Body)),
            Self::Layout(layout) => Some(layout.thick(distance).map(Self::Body)),
            Self::Body(_) | Self::Triangles(_) => None,
        }
    }

    /// The edges of all patches as arcs, each once.
    ///
    /// # Errors
    /// As [`to_bodies`](Self::to_bodies).
    pub fn edge_arcs(&self) -> Result<Vec<Arc>> {
        if let Self::Net(net) = self {
            return net.support_arcs();
        }
        let bodies = self.to_bodies()?;
        Ok(bodies
            .iter()
            .flat_map(Body::shells)
            .flat_map(Shell::edges)
            .filter_map(|edge| edge.curve.arc().copied())
            .collect())
    }
}

/// The error about the only quad of a net as one about the patch.
fn of_one_quad(error: Error) -> Error {
    if let Error::Part(PartError::InQuad { cause, .. }) = error { *cause } else { error }
}
