//! How a table of points is read: its unit and its columns.

use std::path::Path;

use clap::Args as ClapArgs;
use cyclide::model::Units;
use cyclide_io::{
    Document,
    document::{ObjectSpec, PointFile, PointSource},
    input::PointColumns,
};

use super::files::Input;
use super::words::word;
use crate::output::failure::Failure;

#[derive(Debug, Clone, Default, ClapArgs)]
pub struct TableArgs {
    /// Unit of the coordinates, which are labeled and never rescaled [default: the unit in the column names, as in
    /// x_m, otherwise mm].
    #[arg(long, value_parser = word::<Units>())]
    pub units: Option<Units>,
    /// The two or three coordinate columns, x first, by name or by number from 1 [default: columns named x, y and z, or
    /// easting, northing and height; never those with numbers or names of points].
    #[arg(long, value_name = "A,B", value_delimiter = ',', num_args = 1)]
    pub columns: Option<Vec<String>>,
    /// The column that separates contours [default: 'contour', otherwise blank lines].
    #[arg(long, value_name = "NAME")]
    pub contour_column: Option<String>,
}

impl TableArgs {
    /// The points of a file.
    pub fn source(&self, points: &Path) -> Result<PointSource, Failure> {
        let Some(csv) = points.to_str().map(str::to_owned) else {
            return Err(Failure::Usage(format!("{}: the path is not Unicode", points.display())));
        };
        Ok(PointSource::File(PointFile { csv, columns: self.columns.clone(), contour: self.contour_column.clone() }))
    }

    /// A document of one object made of them; without a unit it may have that of its columns.
    pub fn input(self, points: &Path, object: (String, ObjectSpec)) -> Input {
        let title = points.display().to_string();
        let document = Document::from_objects(&title, self.units.unwrap_or_default(), vec![object]);
        let document = if self.units.is_some() { document } else { document.assuming_units() };
        let columns = PointColumns { coordinates: self.columns, contour: self.contour_column };
        Input::Made { document: Box::new(document), columns, unit_of_columns: self.units.is_none() }
    }
}
