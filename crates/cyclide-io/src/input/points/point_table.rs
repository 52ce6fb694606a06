//! A table of points: which of its columns to read, and what is read.

use std::ops::Range;

use cyclide::{Point3, model::Units};

/// Which columns to read.
///
/// ```
/// use cyclide_io::input::{PointColumns, read_points};
/// let columns = PointColumns { coordinates: Some(vec!["b".to_owned(), "a".to_owned()]), ..PointColumns::default() };
/// let table = read_points("p.csv", b"a,b\n1,2\n", &columns)?;
/// assert_eq!(table.contours[0].points[0], cyclide::Point3::new(2.0, 1.0, 0.0));
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct PointColumns {
    /// Names (or numbers from 1) of the two or three coordinate columns; `None` finds them.
    pub coordinates: Option<Vec<String>>,
    /// Name (or number) of the column that says which contour a point belongs to; `None` takes `contour` if there
    /// is such a column, else blank lines separate contours.
    pub contour: Option<String>,
}

/// The points of a file.
///
/// ```
/// use cyclide_io::input::{PointColumns, read_points};
/// let table = read_points("p.csv", b"x,y\n0,0\n3,4\n\n5,5\n6,7\n", &PointColumns::default())?;
/// assert_eq!(table.contours.len(), 2);
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PointTable {
    /// The contours, in the file's order; none is empty, and there is at least one.
    pub contours: Vec<PointList>,
    /// Units that the names of the coordinate columns speak of (`x_m`, `y [mm]`), with the name.
    pub unit_hints: Vec<(String, Units)>,
    /// What could have been read another way.
    pub remarks: Vec<PointRemark>,
    /// What was chosen with certainty and is not plain: columns by words, what the points are called, the encoding.
    pub notes: Vec<String>,
}

/// What was read in one of several possible ways.
///
/// ```
/// use cyclide_io::input::{PointColumns, read_points};
/// let table = read_points("p.csv", b"1,2,3.5,4\n", &PointColumns::default())?;
/// assert_eq!(table.remarks[0].reason, "columns-taken");
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PointRemark {
    /// Stable kebab-case name: `columns-taken`, `northing-first`, `columns-not-read`, `unit-not-applied`, `numbers-as-x`, `decimal-commas`, `decimal-pairs`,
    /// `blank-lines`, `heights-missing`, `units-assumed`.
    pub reason: &'static str,
    /// The sentence.
    pub message: String,
}

/// One contour's points.
///
/// ```
/// use cyclide_io::input::{PointColumns, read_points};
/// let table = read_points("p.csv", b"x,y,corner\n0,0,0\n3,4,1\n5,5,0\n", &PointColumns::default())?;
/// assert_eq!(table.contours[0].corners, [1]);
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PointList {
    /// The points; height 0 where the file has two coordinates.
    pub points: Vec<Point3>,
    /// Indices of the points marked as corners.
    pub corners: Vec<usize>,
    /// Byte offset in the file's text of the first coordinate of each point; empty if they come from elsewhere.
    pub offsets: Vec<usize>,
    /// Byte range in the file's text of what each point is called there; empty if no column says so.
    pub labels: Vec<Range<usize>>,
}
