//! Nodes of a glTF scene with their maps.

use std::collections::HashSet;

use serde_json::Value;

use super::accessor::{entry, list};

/// Nodes may stand in each other this deep.
const DEEPEST: usize = 256;
/// Nodes of a scene, each counted as often as it is met.
const MOST_NODES: usize = 100_000;

/// A map of space that keeps lines: three columns and the image of the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Affine([[f64; 3]; 4]);

impl Affine {
    const IDENTITY: Self = Self([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]]);

    /// The map of a node: its matrix, or scale, rotation and translation.
    fn of_node(node: &Value) -> Result<Self, String> {
        if let Some(matrix) = node.get("matrix") {
            let m = numbers::<16>(matrix).ok_or("the matrix of a node is not 16 numbers")?;
            let last = [m[3], m[7], m[11], m[15] - 1.0];
            if !last.iter().all(|v| *v == 0.0) {
                return Err("the matrix of a node is not affine".to_owned());
            }
            return Ok(Self([0, 4, 8, 12].map(|k| [m[k], m[k + 1], m[k + 2]])));
        }
        let given = |key: &str| node.get(key);
        let triple = |key: &str, rest: f64| match given(key) {
            Some(value) => numbers::<3>(value).ok_or(format!("the {key} of a node is not three numbers")),
            None => Ok([rest; 3]),
        };
        let (scale, shift) = (triple("scale", 1.0)?, triple("translation", 0.0)?);
        let [x, y, z, w] = match given("rotation") {
            Some(value) => numbers::<4>(value).ok_or("the rotation of a node is not four numbers")?,
            None => [0.0, 0.0, 0.0, 1.0],
        };
        let square = x * x + y * y + z * z + w * w;
        // Numbers of single precision.
        if !((square - 1.0).abs() < 1e-3) {
            return Err("the rotation of a node is not a unit quaternion".to_owned());
        }
        let f = 2.0 / square;
        let columns = [
            [1.0 - f * (y * y + z * z), f * (x * y + z * w), f * (x * z - y * w)],
            [f * (x * y - z * w), 1.0 - f * (x * x + z * z), f * (y * z + x * w)],
            [f * (x * z + y * w), f * (y * z - x * w), 1.0 - f * (x * x + y * y)],
        ];
        let [a, b, c] = [0, 1, 2].map(|k| columns[k].map(|v| v * scale[k]));
        Ok(Self([a, b, c, shift]))
    }

    fn direction(&self, v: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|row| (0..3).map(|k| self.0[k][row] * v[k]).sum())
    }

    /// The image of a point.
    pub(super) fn point(&self, p: [f64; 3]) -> [f64; 3] {
        let image = self.direction(p);
        [0, 1, 2].map(|k| image[k] + self.0[3][k])
    }

    /// The direction that is a normal of the image, of any length: across the images of two directions across it.
    pub(super) fn normal(&self, n: [f64; 3]) -> [f64; 3] {
        let [a, b, c] = [self.0[0], self.0[1], self.0[2]];
        let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
        let sign = if self.determinant() < 0.0 { -1.0 } else { 1.0 };
        [0, 1, 2].map(|k| sign * (bc[k] * n[0] + ca[k] * n[1] + ab[k] * n[2]))
    }

    /// Negative for a map that turns triangles over.
    pub(super) fn determinant(&self) -> f64 {
        let [x, y, z] = cross(self.0[0], self.0[1]);
        let c = self.0[2];
        x * c[0] + y * c[1] + z * c[2]
    }

    /// The map after this one has been done in the space of another.
    fn in_space_of(&self, outer: &Self) -> Self {
        let [a, b, c, origin] = self.0;
        Self([outer.direction(a), outer.direction(b), outer.direction(c), outer.point(origin)])
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    <[f64; N]>::try_from(numbers?).ok()
}

/// The nodes of the scene that is shown.
pub(super) struct Walk<'a> {
    document: &'a Value,
    roots: Vec<&'a Value>,
}

impl<'a> Walk<'a> {
    /// From the roots of the scene that the file names, else of its first; without a scene, all nodes that are no children.
    pub(super) fn new(document: &'a Value) -> Result<Self, String> {
        let nodes = list(document, "nodes");
        let node = |index: &Value| entry(document, "nodes", Some(index));
        let scene = match document.get("scene") {
            Some(scene) => Some(entry(document, "scenes", Some(scene))?),
            None => list(document, "scenes").first(),
        };
        let roots = match scene {
            Some(scene) => list(scene, "nodes").iter().map(node).collect::<Result<_, _>>()?,
            None => {
                let children: HashSet<u64> =
                    nodes.iter().flat_map(|n| list(n, "children")).filter_map(Value::as_u64).collect();
                let is_root = |(index, _): &(usize, &Value)| !children.contains(&(*index as u64));
                nodes.iter().enumerate().filter(is_root).map(|(_, n)| n).collect()
            }
        };
        Ok(Self { document, roots })
    }

    /// All nodes with their maps.
    pub(super) fn nodes(&self) -> Result<Vec<(Affine, &'a Value)>, String> {
        let mut found = Vec::new();
        let mut open: Vec<(Affine, &Value, usize)> =
            self.roots.iter().rev().map(|root| (Affine::IDENTITY, *root, 0)).collect();
        while let Some((outer, node, depth)) = open.pop() {
            if depth > DEEPEST || found.len() == MOST_NODES || open.len() > MOST_NODES {
                return Err(format!(
                    "nodes are nested more than {DEEPEST} levels deep, or there are more than {MOST_NODES}"
                ));
            }
            let map = Affine::of_node(node)?.in_space_of(&outer);
            for child in list(node, "children").iter().rev() {
                open.push((map, entry(self.document, "nodes", Some(child))?, depth + 1));
            }
            found.push((map, node));
        }
        Ok(found)
    }
}
