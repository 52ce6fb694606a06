//! Objects from objects, whatever their kind: images under maps, parallel surfaces, solids between them.

use super::chain::ChainPiece;
use super::lower::{Exactness, Lower as _, Lowered};
use super::object::CurveObject;
use super::surface_object::SurfaceObject;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::construct::Revolution;
use crate::curve::{Arc, ParamCurve as _};
use crate::error::{Error, Result};
use crate::surface::CyclidicNet;
use crate::topology::{Body, EdgeCurve, Shell};

impl Conformal for CurveObject {
    /// The image: of arcs and chains of arcs under any map, of circles and circle splines under similarities and
    /// reflections.
    ///
    /// # Errors
    /// As the curve's own `transformed` or `similar`; `not-a-similarity`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        match self {
            Self::Arc(c) => c.transformed(map).map(Self::Arc),
            Self::Circle(c) => c.similar(map).map(Self::Circle),
            Self::ArcPath(c) => c.transformed(map).map(Self::ArcPath),
            Self::CircleSpline(c) => c.similar(map).map(Self::CircleSpline),
        }
    }
}

impl Conformal for SurfaceObject {
    /// The image under any map that keeps the surface finite.
    ///
    /// # Errors
    /// As the surface's own `transformed`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        match self {
            Self::Patch(patch) => patch.transformed(map).map(Self::Patch),
            Self::Net(net) => net.transformed(map).map(Self::Net),
            Self::Body(body) => body.transformed(map).map(Self::Body),
        }
    }
}

impl CurveObject {
    /// The body that the curve sweeps when it turns about an axis, exact: see [`Revolution::body`].
    ///
    /// # Errors
    /// `not-a-spline` for a trigonometric circle spline, which has no rational form; as [`Revolution::body`].
    pub fn revolved(&self, turn: &Revolution) -> Result<SurfaceObject> {
        // What is exact does not ask for the tolerance.
        let Lowered { form, exactness, .. } = self.lower_to_chain(1.0)?;
        if exactness != Exactness::Exact {
            let detail = "a trigonometric circle spline has no rational form: take the rational one";
            return Err(Error::NotASpline { detail });
        }
        let closed = form.is_closed();
        let mut profile: Vec<EdgeCurve> = Vec::new();
        for piece in form.into_pieces() {
            match piece {
                ChainPiece::Arc(arc) => profile.push(arc.into()),
                ChainPiece::Spline(spline) => profile.extend(spline.to_beziers().into_iter().map(EdgeCurve::from)),
            }
        }
        turn.body(&profile, closed).map(SurfaceObject::Body)
    }
}

impl SurfaceObject {
    /// The parallel surface at a signed distance along the unit normal, exact; `None` for a solid, whose normal is not
    /// one along its creases.
    ///
    /// # Errors
    /// As the surface's own `offset`.
    #[must_use]
    pub fn offset(&self, distance: f64) -> Option<Result<Self>> {
        match self {
            Self::Patch(patch) => Some(patch.offset(distance).map(Self::Patch)),
            Self::Net(net) => Some(net.offset(distance).map(Self::Net)),
            Self::Body(_) => None,
        }
    }

    /// The solid between the surface and its parallel surface; `None` for what is a solid between two surfaces already.
    ///
    /// # Errors
    /// As [`CyclidicNet::thick`].
    #[must_use]
    pub fn thick(&self, distance: f64) -> Option<Result<Self>> {
        match self {
            Self::Patch(patch) => Some(CyclidicNet::from(*patch).thick(distance).map(Self::Body).map_err(of_one_quad)),
            Self::Net(net) => Some(net.thick(distance).map(Self::Body)),
            Self::Body(_) => None,
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
    if let Error::InQuad { cause, .. } = error { *cause } else { error }
}
