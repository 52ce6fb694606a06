//! Tubes and swept sections as solids.
