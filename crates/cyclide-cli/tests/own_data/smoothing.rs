//! Measured points: noise, outliers, stops.
