//! Moves of robots and cameras: straight, closed, noisy.
