//! What the crates of this workspace share beside the public interface. Nobody else may count on it: it changes without notice.

pub use crate::base::range::{check_distance, check_point};
pub use crate::base::svd3::singular_values;
pub use crate::base::triangle::on_triangle;
pub use crate::surface::grid_cells::{beside, flooded};
pub use crate::surface::layout::RoundClosing;
pub use crate::surface::net::closing_limit;
