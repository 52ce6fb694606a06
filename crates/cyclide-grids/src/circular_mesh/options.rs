//! What the user can ask of [`make_circular`](super::make_circular).

use cyclide::curve::ParamCurve;
use cyclide::surface::QuadGrid;
use cyclide::{
    Result,
    error::{ErrorItem, GridCellFault, GridError, NumberError},
};

/// What the border vertices of an open direction may do.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// use cyclide_grids::Border;
/// let line = Arc::segment(Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0))?;
/// // The first row slides on a line, the other sides are free.
/// let border = Border::OnCurves([Some(&line), None, None, None]);
/// assert!(matches!(border, Border::OnCurves([Some(_), ..])));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub enum Border<'a> {
    /// They move like the others.
    #[default]
    Free,
    /// They stay where they are, bit for bit. The inner vertices alone must then make every quad circular. Each quad
    /// takes two conditions and each vertex has three freedoms, so fewer than 6 × 6 quads have more conditions than
    /// freedoms, and a border that was drawn without regard to circles may have no solution near at any size.
    Pinned,
    /// They slide on the curve of their side; the sides are t=0, t=1 (along s), s=0, s=1 (along t), and a side
    /// without a curve is free. The vertices are first moved to the nearest point of their curve and never leave its
    /// ends. A corner of the grid between two sides with curves is held where the curves meet, which must be within a
    /// median edge of the corner; a corner on both stays bit for bit. A side of a closed direction has no vertices: a
    /// curve there is refused.
    OnCurves([Option<&'a dyn ParamCurve>; 4]),
}

/// Options of [`make_circular`](super::make_circular).
///
/// ```
/// use cyclide_grids::{Border, CircularMeshOptions};
/// let options = CircularMeshOptions { border: Border::Pinned, ..Default::default() };
/// assert!(options.max_steps > 10 && !options.allow_shape_change);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct CircularMeshOptions<'a> {
    /// What the border may do.
    pub border: Border<'a>,
    /// Steps tried before the search is given up, at least 1. Grids of 8 × 8 to 40 × 40 quads take 6 to 70.
    pub max_steps: usize,
    /// Whether a result that has lost the shape of the input is returned all the same, with a warning.
    pub allow_shape_change: bool,
}

impl Default for CircularMeshOptions<'_> {
    fn default() -> Self {
        Self { border: Border::Free, max_steps: 500, allow_shape_change: false }
    }
}

impl CircularMeshOptions<'_> {
    /// # Errors
    /// `parameter-out-of-range`.
    pub(super) fn check(&self, grid: &QuadGrid) -> Result<()> {
        self.check_steps()?;
        if let Border::OnCurves(sides) = self.border {
            if !grid.is_whole() {
                return Err(GridError::CellsUnfit { fault: GridCellFault::Curves, index: 0 }.into());
            }
            for (side, curve) in sides.iter().enumerate() {
                // Sides 0 and 1 bound t, sides 2 and 3 bound s.
                if curve.is_some() && grid.closed()[1 - side / 2] {
                    let name = ErrorItem::BorderCurveSide;
                    return Err(
                        NumberError::ParameterOutOfRange { name, value: side as f64, min: 0.0, max: 3.0 }.into()
                    );
                }
            }
        }
        Ok(())
    }

    /// # Errors
    /// `parameter-out-of-range`.
    pub(super) fn check_steps(&self) -> Result<()> {
        if self.max_steps == 0 {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::MaxSteps,
                value: 0.0,
                min: 1.0,
                max: f64::MAX,
            }
            .into());
        }
        Ok(())
    }
}
