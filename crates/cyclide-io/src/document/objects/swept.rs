//! Necks, bridges, and surfaces between two curves.

use cyclide::{
    CurveObject, EdgeCurve, EllipseBridge, NeckBlend, NeckBody, NeckSide, PlateShape, RailSurface, SurfaceObject, Vec3,
};

use super::rail_sense::Rulings;
use super::{Builder, BuiltObject};
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::spec::{
    BridgeArcs, CircularSurfaceSpec, EllipseBridgeSpec, PlateSpec, PlateWithNeckSpec, RuledSpec,
};
use crate::error::{Error, Result};

/// Starts of a closed rail that are tried to see whether it runs the other way.
const MOST_SHIFTS: usize = 64;

impl Builder<'_> {
    /// A pipe on a plate, or with a floor.
    pub(in crate::document) fn plate_with_neck(&mut self, spec: &PlateWithNeckSpec) -> Result<Vec<SurfaceObject>> {
        let side = spec.side;
        if side == NeckSide::Inside && spec.plate.is_some() {
            return Err(self.unfit("a neck inside a pipe has the floor of the pipe for its plate: leave out `plate`"));
        }
        if side == NeckSide::Outside && spec.plate.is_none() {
            return Err(self.unfit("a neck outside a pipe needs a `plate`: `[80, 60]` or `{\"radius\": 40}`"));
        }
        if spec.wall.is_some() && spec.thickness.is_none() {
            return Err(self.unfit("`wall` goes with `thickness`, which makes a solid"));
        }
        let slope = spec.slope.map_or(0.0, Angle::radians);
        let neck = NeckBlend::new(spec.pipe_radius, spec.ball_radius, slope, side, spec.variant);
        let neck = neck.map_err(|e| self.refused(&e, None))?;
        let plate = spec.plate.map(|plate| match plate {
            PlateSpec::Rectangle(sides) => PlateShape::Rectangle(sides),
            PlateSpec::Disk(disk) => PlateShape::Disk(disk.radius),
        });
        let mut made = NeckBody::new(spec.height);
        (made.plate, made.thickness, made.wall) = (plate, spec.thickness, spec.wall);
        let body = neck.body(&made).map_err(|e| self.refused(&e, None))?;
        for warning in neck.warnings() {
            self.warn_at("ball_radius", None, warning);
        }
        Ok(vec![SurfaceObject::Body(body)])
    }

    /// The bridge between two ellipses.
    pub(in crate::document) fn ellipse_bridge(&mut self, spec: &EllipseBridgeSpec) -> Result<Vec<SurfaceObject>> {
        let [first, second] = spec.ellipses;
        if spec.arcs == BridgeArcs::Full && spec.depth.is_some() {
            return Err(self.unfit("whole circles are a solid by themselves: `depth` goes with half circles"));
        }
        let bridge = EllipseBridge::new(first, second).map_err(|e| self.refused(&e, None))?;
        let body = match spec.arcs {
            BridgeArcs::Half => bridge.body(spec.depth),
            BridgeArcs::Full => bridge.whole_circles(),
        };
        let body = body.map_err(|e| self.refused(&e, None))?;
        for warning in bridge.warnings() {
            self.warn_at("ellipses", None, warning);
        }
        Ok(vec![SurfaceObject::Body(body)])
    }

    /// Arcs between two curves.
    pub(in crate::document) fn circular_surface(&mut self, spec: &CircularSurfaceSpec) -> Result<Vec<SurfaceObject>> {
        let tangents: Vec<Vec3> = spec.tangent.0.iter().copied().map(Coordinates::vector).collect();
        self.between_rails(|rails, closed| RailSurface::circular(rails, &tangents, closed))
    }

    /// Straight lines between two curves.
    pub(in crate::document) fn ruled(&mut self, spec: &RuledSpec) -> Result<Vec<SurfaceObject>> {
        let ([first, second], closed) = self.pieces_of_rails()?;
        if spec.shift > 0 && !closed {
            return Err(self.unfit("`shift` goes with closed curves: open ones start where they are drawn"));
        }
        let second = rotated(&second, spec.shift);
        let made = RailSurface::ruled([&first, &second], closed).map_err(|e| match e {
            cyclide::Error::RulingsCross { piece, .. } if closed => {
                match self.start_of_rail([&first, &second], spec.shift) {
                    Some(remedy) => {
                        let words = format!("the straight lines between piece {piece} of both curves cross: {remedy}");
                        self.refused_in_words(["rails".into()], e.reason(), words)
                    }
                    None => self.refused(&e, None),
                }
            }
            e => self.refused(&e, None),
        })?;
        self.check_sense([&first, &second], closed, spec.shift)?;
        Ok(self.between(made))
    }

    /// Refuses a ruled surface that goes through itself because one curve runs the other way, and remarks curves that seem to.
    fn check_sense(&mut self, [first, second]: [&[EdgeCurve]; 2], closed: bool, shift: usize) -> Result<()> {
        if closed && let Some(remedy) = self.rail_to_reverse([first, second], shift) {
            let words = format!("the surface of straight lines goes through itself: {remedy}");
            return Err(self.refused_in_words(["rails".into()], "rulings-cross", words));
        }
        let given = Rulings::of([first, second], closed);
        let reversed: Vec<EdgeCurve> = second.iter().rev().map(EdgeCurve::reversed).collect();
        let shifts = if closed && given.opposite() { reversed.len().min(MOST_SHIFTS) } else { usize::from(!closed) };
        let other_way = |by: usize| Rulings::of([first, &rotated(&reversed, by)], closed);
        if (0..shifts).any(|by| given.are_longer_than(&other_way(by))) {
            let message = "the straight lines between both curves are much shorter where the second one is taken the other way: if no twist is meant, take its points in reverse order, \
                           or a `transform` of it with the steps `[\"reverse\"]`";
            self.remark("rails-opposite", None, None, self.place_of(["rails".into()]), message.to_owned());
        }
        Ok(())
    }

    /// A surface between the pieces of two curves, closed round if both are.
    fn between_rails(
        &mut self,
        construct: impl Fn([&[EdgeCurve]; 2], bool) -> cyclide::Result<RailSurface>,
    ) -> Result<Vec<SurfaceObject>> {
        let ([first, second], closed) = self.pieces_of_rails()?;
        let made = construct([&first, &second], closed).map_err(|e| self.refused(&e, None))?;
        Ok(self.between(made))
    }

    fn between(&mut self, made: RailSurface) -> Vec<SurfaceObject> {
        for warning in made.warnings() {
            self.warn_at("rails", None, warning.clone());
        }
        vec![SurfaceObject::Body(made.into_body())]
    }

    /// The pieces of the two curves, and whether both are closed.
    fn pieces_of_rails(&self) -> Result<([Vec<EdgeCurve>; 2], bool)> {
        let [first, second] = self.rails()?.map(|curve| curve.exact_pieces().map_err(|e| self.refused(&e, None)));
        let ((first, a), (second, b)) = (first?, second?);
        Ok(([first, second], a && b))
    }

    /// The two curves that an object is spanned between.
    fn rails(&self) -> Result<[&CurveObject; 2]> {
        let rail = |k: usize| match self.sources[k].item.curves() {
            [curve] => Ok(curve),
            contours => {
                let BuiltObject { item, provenance, .. } = self.sources[k];
                let (name, kind, count) = (&item.name, provenance.kind, contours.len());
                let what = if count == 0 { "is no curve".to_owned() } else { format!("has {count} contours") };
                let message = format!("`{name}` is of type `{kind}` and {what}: a rail is one curve");
                Err(Error::Input(self.diagnostic(["rails".into(), k.into()], &message)))
            }
        };
        Ok([rail(0)?, rail(1)?])
    }
}

/// The pieces of a closed curve from another one on.
pub(in crate::document) fn rotated(pieces: &[EdgeCurve], by: usize) -> Vec<EdgeCurve> {
    let mut pieces = pieces.to_vec();
    if !pieces.is_empty() {
        let count = pieces.len();
        pieces.rotate_left(by % count);
    }
    pieces
}
