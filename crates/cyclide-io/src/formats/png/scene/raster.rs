//! Which facet is seen where: a depth buffer with eight samples in a pixel.
//!
//! Corners are rounded to 1/256 of a pixel and edges are tested in integers with one rule for ties, so facets that
//! share an edge leave no gap and cover no sample twice. The picture is made in bands of rows to keep it in the cache.

use super::camera::Projected;

/// Steps of a pixel that corners are rounded to.
const GRID: f64 = 256.0;
const STEP: i64 = 256;
/// Where the samples lie in a pixel, from its middle in steps: no two in one row or column of a grid of eight by eight.
const SAMPLES: [(i64, i64); 8] =
    [(16, -48), (-16, 48), (80, 16), (-48, -80), (-80, 80), (-112, -16), (48, 112), (112, -112)];
/// How many samples a pixel has.
pub(super) const SAMPLE_COUNT: usize = SAMPLES.len();
/// Corners farther than this out of the picture, in steps, are left out: products must stay in range.
const FARTHEST: f64 = 1e9;
/// No facet: the ground or the paper is seen.
pub(super) const NOTHING: u32 = u32::MAX;
/// Rows of a band.
const ROWS: usize = 48;

/// Where a sample lies, in pixels from the picture's corner, given its pixel.
pub(super) fn sample_place(sample: usize, x: usize, y: usize) -> (f64, f64) {
    let (dx, dy) = SAMPLES[sample];
    (x as f64 + 0.5 + dx as f64 / GRID, y as f64 + 0.5 + dy as f64 / GRID)
}

/// A part of the picture with what is seen at its samples.
pub(super) struct Band {
    /// First row.
    pub(super) top: usize,
    pub(super) rows: usize,
    pub(super) width: usize,
    /// For each pixel and sample the index of the facet, or [`NOTHING`].
    seen: Vec<[u32; SAMPLE_COUNT]>,
    near: Vec<[f32; SAMPLE_COUNT]>,
}

impl Band {
    /// The facets seen in a pixel, by its column and its row in the band.
    pub(super) fn seen(&self, x: usize, row: usize) -> &[u32; SAMPLE_COUNT] {
        &self.seen[row * self.width + x]
    }

    fn clear(&mut self, top: usize, rows: usize) {
        (self.top, self.rows) = (top, rows);
        self.seen.fill([NOTHING; SAMPLE_COUNT]);
        self.near.fill([0.0; SAMPLE_COUNT]);
    }

    fn draw(&mut self, index: u32, facet: &Facet) {
        let first = (facet.top - self.top as i64).max(0);
        let last = (facet.bottom - self.top as i64).min(self.rows as i64 - 1);
        let offsets = facet.edges.map(|e| SAMPLES.map(|(dx, dy)| e.dx * dx + e.dy * dy));
        let depths = SAMPLES.map(|(dx, dy)| facet.near.dx * dx as f64 + facet.near.dy * dy as f64);
        for row in first..=last {
            let y = (self.top as i64 + row) * STEP + STEP / 2;
            let line = row as usize * self.width;
            for x in facet.left..=facet.right {
                let px = x * STEP + STEP / 2;
                let edge = facet.edges.map(|e| e.at(px, y));
                // All samples lie within half a pixel: most pixels of the box are wholly outside.
                if edge.iter().zip(&facet.edges).any(|(v, e)| v + e.reach < 0) {
                    continue;
                }
                let pixel = line + x as usize;
                let (seen, near) = (&mut self.seen[pixel], &mut self.near[pixel]);
                let middle = facet.near.at(px, y);
                let whole = edge.iter().zip(&facet.edges).all(|(v, e)| v - e.reach >= 0);
                for k in 0..SAMPLE_COUNT {
                    let inside = whole || edge.iter().zip(&offsets).all(|(v, o)| v + o[k] >= 0);
                    let depth = (middle + depths[k]) as f32;
                    if inside && depth > near[k] {
                        (near[k], seen[k]) = (depth, index);
                    }
                }
            }
        }
    }
}

/// Calls `finished` with every band of a picture from the top, in which the facets are drawn in order.
pub(super) fn bands(corners: &[[Projected; 3]], (width, height): (usize, usize), mut finished: impl FnMut(&Band)) {
    let facets: Vec<Option<Facet>> = corners.iter().map(|c| Facet::new(c, width, height)).collect();
    let count = height.div_ceil(ROWS);
    let mut bins: Vec<Vec<u32>> = vec![Vec::new(); count];
    for (index, facet) in facets.iter().enumerate() {
        if let Some(f) = facet {
            for bin in &mut bins[f.top as usize / ROWS..=f.bottom as usize / ROWS] {
                bin.push(index as u32);
            }
        }
    }
    let pixels = ROWS * width;
    let (seen, near) = (vec![[NOTHING; SAMPLE_COUNT]; pixels], vec![[0.0; SAMPLE_COUNT]; pixels]);
    let mut band = Band { top: 0, rows: 0, width, seen, near };
    for (i, bin) in bins.iter().enumerate() {
        band.clear(i * ROWS, ROWS.min(height - i * ROWS));
        for &index in bin {
            if let Some(facet) = &facets[index as usize] {
                band.draw(index, facet);
            }
        }
        finished(&band);
    }
}

/// A triangle of the picture, its corners turning so that the inside of each edge is positive.
struct Facet {
    edges: [Edge; 3],
    near: Plane,
    left: i64,
    right: i64,
    top: i64,
    bottom: i64,
}

/// `dx x + dy y + constant`, not negative inside, ties given to one of the two facets along an edge.
#[derive(Clone, Copy)]
struct Edge {
    dx: i64,
    dy: i64,
    constant: i64,
    /// Most that a sample adds to the value at the pixel's middle.
    reach: i64,
}

impl Edge {
    fn new(a: (i64, i64), b: (i64, i64)) -> Self {
        let (dx, dy) = (a.1 - b.1, b.0 - a.0);
        let owns = dx > 0 || dx == 0 && dy > 0;
        let constant = -(dx * a.0 + dy * a.1) - i64::from(!owns);
        Self { dx, dy, constant, reach: (dx.abs() + dy.abs()) * (STEP / 2) }
    }

    fn at(&self, x: i64, y: i64) -> i64 {
        self.dx * x + self.dy * y + self.constant
    }
}

/// A value that is linear in the picture, by steps.
struct Plane {
    dx: f64,
    dy: f64,
    origin: (i64, i64),
    value: f64,
}

impl Plane {
    fn at(&self, x: i64, y: i64) -> f64 {
        self.value + self.dx * (x - self.origin.0) as f64 + self.dy * (y - self.origin.1) as f64
    }
}

impl Facet {
    /// `None` if it covers no sample.
    fn new(corners: &[Projected; 3], width: usize, height: usize) -> Option<Self> {
        let step = |v: f64| (v * GRID).round();
        if corners.iter().any(|c| !(step(c.x).abs() <= FARTHEST && step(c.y).abs() <= FARTHEST && c.near > 0.0)) {
            return None;
        }
        let mut p = corners.map(|c| (step(c.x) as i64, step(c.y) as i64, c.near));
        let area =
            |p: &[(i64, i64, f64); 3]| (p[1].0 - p[0].0) * (p[2].1 - p[0].1) - (p[1].1 - p[0].1) * (p[2].0 - p[0].0);
        if area(&p) < 0 {
            p.swap(1, 2);
        }
        let area = area(&p) as f64;
        if area == 0.0 {
            return None;
        }
        let range = |f: fn(&(i64, i64, f64)) -> i64, size: usize| {
            let (least, most) = p.iter().map(f).fold((i64::MAX, i64::MIN), |(a, b), v| (a.min(v), b.max(v)));
            (least.div_euclid(STEP).max(0), most.div_euclid(STEP).min(size as i64 - 1))
        };
        let ((left, right), (top, bottom)) = (range(|c| c.0, width), range(|c| c.1, height));
        if left > right || top > bottom {
            return None;
        }
        let [a, b, c] = p.map(|c| (c.0, c.1));
        let (x1, y1) = ((b.0 - a.0) as f64, (b.1 - a.1) as f64);
        let (x2, y2) = ((c.0 - a.0) as f64, (c.1 - a.1) as f64);
        let (n1, n2) = (p[1].2 - p[0].2, p[2].2 - p[0].2);
        let near = Plane { dx: (n1 * y2 - n2 * y1) / area, dy: (n2 * x1 - n1 * x2) / area, origin: a, value: p[0].2 };
        Some(Self { edges: [Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)], near, left, right, top, bottom })
    }
}
