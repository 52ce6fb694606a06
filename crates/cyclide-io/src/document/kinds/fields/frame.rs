//! Frames of patches and nets.

use cyclide::{Frame, ShortNumber, Vec3, volume::VolumeFrame};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::forms::forms;

/// The frame of a net: `auto`, or two directions.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 1, 0], [1, 1, 0], [3, 1, 0]], [[0, 0, 1], [1, 0, 1], [3, 0, 1]]], "frame": "auto"}}}"#.parse()?;
/// let built = document.build()?;
/// let shell = &built[0].bodies[0].outer;
/// assert!(shell.faces().len() == 2 && cyclide::topology::surface_joints(shell).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, JsonSchema)]
#[schemars(untagged, rename = "Frame")]
#[non_exhaustive]
pub enum FrameSpec {
    /// Chosen automatically: the frame that follows the edges best.
    #[default]
    #[schemars(with = "AutoWord")]
    Auto,
    /// Directions of increasing s and t at the first vertex: perpendicular, of any length.
    First([Coordinates; 2]),
}

/// The word for a frame that is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(inline)]
enum AutoWord {
    /// Chosen automatically: the frame that follows the edges best.
    #[serde(rename = "auto")]
    Auto,
}

forms! {
    FrameSpec: "\"auto\" or two directions `[[x, y, z], [x, y, z]]`";
    word AutoWord => |_| FrameSpec::Auto;
    list [Coordinates; 2] => FrameSpec::First;
}

/// The frame of a cyclide or a torus; what is left out is at the origin, upright, and from x.
pub(in crate::document) fn frame_of_axes(
    center: Option<Coordinates>,
    axis: Option<Coordinates>,
    x_direction: Option<Coordinates>,
) -> cyclide::Result<Frame> {
    let center = center.unwrap_or_default().point();
    let axis = axis.map_or(Vec3::Z, Coordinates::vector);
    let x = x_direction.map(Coordinates::vector);
    // Where the axis itself is that of x, the ring's long axis is that of y.
    Frame::from_normal(center, axis, x.unwrap_or(Vec3::X))
        .or_else(|e| if x.is_none() { Frame::from_normal(center, axis, Vec3::Y) } else { Err(e) })
}

/// The directions of a frame may have any length; only the angle between them can be wrong.
pub(in crate::document) fn frame_words(frame: [Coordinates; 2]) -> String {
    let [a, b] = frame.map(|direction| direction.vector().unit());
    match (a, b) {
        (Some(a), Some(b)) => {
            let off = (90.0 - a.dot(b).clamp(-1.0, 1.0).acos().to_degrees()).abs();
            format!("the directions of the frame must be perpendicular; the deviation is {} degrees", ShortNumber(off))
        }
        _ => "the directions of the frame must not be zero".to_owned(),
    }
}

/// A direction of any length as a unit vector; one that has none stays what it is, for the kernel to refuse.
pub(in crate::document) fn direction(given: Coordinates) -> Vec3 {
    let v = given.vector();
    v.unit().unwrap_or(v)
}

/// The frame of a document as the kernel's.
pub(in crate::document) fn volume_frame(frame: FrameSpec) -> VolumeFrame {
    match frame {
        FrameSpec::Auto => VolumeFrame::Auto,
        FrameSpec::First(given) => {
            let [v1, v2] = given.map(direction);
            VolumeFrame::First(v1, v2)
        }
    }
}
