//! Slits from umbilics to the border that meet nowhere: what is between them has one sense of both directions.

use super::super::cross_field::SingularVertex;
use super::super::cuts::Ways;
use super::super::mesh_table::MeshTable;

/// A way from the border to an umbilic.
pub(super) struct Slit {
    pub(super) centre: SingularVertex,
    /// The half edges along it.
    pub(super) way: Vec<usize>,
}

/// A slit to each umbilic, the nearest to the border first; the vertex that no way is left to, if there is one.
pub(super) fn slits(table: &MeshTable, outer: usize, singular: &[SingularVertex]) -> Result<Vec<Slit>, usize> {
    let starts: Vec<usize> = table.borders[outer].iter().map(|half| table.ends(*half)[0]).collect();
    // Nothing passes through an umbilic, a hole's border or another slit.
    let mut closed: Vec<bool> = (0..table.points.len()).map(|v| table.is_on_border(v)).collect();
    singular.iter().for_each(|s| closed[s.vertex] = true);
    let mut slits = Vec::new();
    let mut used = vec![false; table.points.len()];
    let mut left = singular.to_vec();
    while !left.is_empty() {
        let ways = Ways::from(table, starts.iter().copied().filter(|v| !used[*v]), &closed);
        let nearest =
            (0..left.len()).min_by(|a, b| ways.distance(left[*a].vertex).total_cmp(&ways.distance(left[*b].vertex)));
        let Some(nearest) = nearest else { break };
        let centre = left.remove(nearest);
        let way = ways.to(centre.vertex, table);
        if way.is_empty() {
            return Err(centre.vertex);
        }
        for v in way.iter().flat_map(|half| table.ends(*half)) {
            (used[v], closed[v]) = (true, true);
        }
        slits.push(Slit { centre, way });
    }
    Ok(slits)
}
