//! Arcs that their points do not tell from lines become lines: noise bends every straight run a little
//! (`docs/math/arc-fitting.md#least-deviation`).

use super::{BESIDE, HOPELESS, LARGEST_BOUND, Polish, Spanned, WHOLE, WHOLE_STEPS};
use crate::construct::curves::arc_fit::bends::{Bends, Ends, Hold, Sum};

/// Arcs with at most this sagitta are tried, in tolerances.
const FLAT: f64 = 2.0;
/// A curvature that differs from 0 by less than this many of its standard deviations is none.
const SIGNIFICANT: f64 = 3.0;
/// With fewer points to a piece distances of samples change as fast as noise: they go to and fro twice along each.
const FEWEST_OF_EACH: usize = 16;
/// A line that meets an end of the data, one point with noise of its own, may add this part of the squares.
const AT_END: f64 = 1.0;

impl Polish<'_> {
    /// Makes lines of the arcs whose points are off a line by hardly more than off the arc, the flattest first.
    pub(super) fn straighten(&self, chain: &mut Spanned) {
        let sagitta = |chain: &Spanned, i: usize| {
            let bend = &chain.bends.pieces[i];
            bend.curvature.abs() * bend.length * bend.length / 8.0
        };
        let mut flat: Vec<usize> = (0..chain.spans.len())
            .filter(|i| !chain.bends.pieces[*i].straight && sagitta(chain, *i) <= FLAT * self.tolerance)
            .collect();
        flat.sort_by(|i, j| sagitta(chain, *i).total_cmp(&sagitta(chain, *j)));
        let count = chain.spans.len();
        for at in flat {
            // Two lines that meet smoothly would be one.
            let beside = [at.checked_sub(1), Some(at + 1).filter(|next| *next < count)];
            let beside =
                beside.map(|next| next.or_else(|| chain.is_loop().then_some(if at == 0 { count - 1 } else { 0 })));
            if beside.into_iter().flatten().any(|next| chain.bends.pieces[next].straight) {
                continue;
            }
            let range = if count <= WHOLE { 0..count } else { at.saturating_sub(BESIDE)..(at + 1 + BESIDE).min(count) };
            let part = if count <= WHOLE { chain.clone() } else { chain.part(range.clone()) };
            match self.with_line(&part, at - range.start) {
                Some(found) if count <= WHOLE => *chain = found,
                Some(found) => chain.put(range, found),
                None => {}
            }
        }
    }

    /// The chain with a piece as a line, if the squares of the distances do not grow by more than by chance.
    fn with_line(&self, chain: &Spanned, at: usize) -> Option<Spanned> {
        let (points, pieces) = (chain.bends.distances().len(), chain.spans.len());
        // Samples of something smooth say by how much it bends.
        if points < FEWEST_OF_EACH * pieces || !chain.bends.are_rough() {
            return None;
        }
        let mut bends = chain.bends.clone();
        (bends.pieces[at].straight, bends.pieces[at].curvature) = (true, 0.0);
        let mut bends = bends.closed()?.refined(Sum::SQUARES, WHOLE_STEPS, f64::INFINITY);
        if (self.tolerance..HOPELESS * self.tolerance).contains(&bends.deviation()) {
            bends = bends.refined(LARGEST_BOUND, WHOLE_STEPS, f64::INFINITY);
        }
        let by_chance = SIGNIFICANT * SIGNIFICANT / (points - 2 * pieces) as f64;
        let meets_end = matches!(chain.bends.ends, Ends::Held { start: Hold::Place, .. } if at == 0)
            || matches!(chain.bends.ends, Ends::Held { end: Hold::Place, .. } if at + 1 == chain.spans.len());
        let may_add = if meets_end { AT_END.max(by_chance) } else { by_chance };
        let most = chain.bends.squares() * (1.0 + may_add);
        if bends.squares() > most { None } else { self.certified(Spanned { bends, spans: chain.spans.clone() }) }
    }
}

impl Bends {
    /// Whether distances from one point to the next change as those of noise do: by their own size, where those of samples of something
    /// smooth go on.
    fn are_rough(&self) -> bool {
        let distances = self.distances();
        distances.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum::<f64>() > self.squares()
    }
}
