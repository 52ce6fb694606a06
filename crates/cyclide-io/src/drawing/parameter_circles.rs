//! How many inner parameter circles a drawing of a shell shows.

use cyclide::topology::{FaceGeometry as _, Shell};

/// A patch is divided no finer than in two to this power.
const MOST_LEVELS: u32 = 5;

/// What is drawn on planes between straight lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Planes {
    /// Nothing.
    Plain,
    /// Parameter lines as on others.
    #[cfg_attr(not(feature = "png"), allow(dead_code, reason = "pictures show the insides of blocks so"))]
    Lined,
}

/// How often each patch is halved along s and along t so that its inner parameter circles are `spacing` apart, about;
/// the same across every common edge, so that circles continue.
pub(crate) fn halvings(shell: &Shell, spacing: f64, planes: Planes) -> Vec<[u32; 2]> {
    // Node 2 f is the division of face f along s, node 2 f + 1 that along t; an edge joins those of its two faces.
    let faces = shell.faces();
    let mut parent: Vec<usize> = (0..2 * faces.len()).collect();
    let mut on_edge: Vec<Option<usize>> = vec![None; shell.edges().len()];
    let is_plain: Vec<bool> =
        faces.iter().map(|face| planes == Planes::Plain && face.surface.is_plane_quad()).collect();
    for (f, face) in faces.iter().enumerate().filter(|(f, _)| !is_plain[*f]) {
        for (k, side) in face.sides.iter().enumerate() {
            let Some(side) = side else { continue };
            let node = 2 * f + k / 2;
            match on_edge[side.edge] {
                Some(other) => {
                    let (a, b) = (root(&mut parent, node), root(&mut parent, other));
                    parent[a.max(b)] = a.min(b);
                }
                None => on_edge[side.edge] = Some(node),
            }
        }
    }
    let mut longest = vec![0.0f64; parent.len()];
    for (f, face) in faces.iter().enumerate().filter(|(f, _)| !is_plain[*f]) {
        for (k, line) in [face.surface.s_line(0.5), face.surface.t_line(0.5)].into_iter().enumerate() {
            let node = root(&mut parent, 2 * f + k);
            longest[node] = longest[node].max(line.map_or(0.0, |curve| curve.length()));
        }
    }
    let level = |length: f64| (length / spacing).log2().round().clamp(0.0, f64::from(MOST_LEVELS)) as u32;
    (0..faces.len()).map(|f| [0, 1].map(|k| level(longest[root(&mut parent, 2 * f + k)]))).collect()
}

/// The representative of a node; the way to it is made short.
fn root(parent: &mut [usize], mut node: usize) -> usize {
    while parent[node] != node {
        parent[node] = parent[parent[node]];
        node = parent[node];
    }
    node
}
