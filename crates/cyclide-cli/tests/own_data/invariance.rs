//! The same points by other weights, parameters, scales and orders have the same figures.
