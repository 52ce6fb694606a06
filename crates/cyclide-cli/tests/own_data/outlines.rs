//! Outlines whose points are corners: rectangles, slots, combs, printed layers.
