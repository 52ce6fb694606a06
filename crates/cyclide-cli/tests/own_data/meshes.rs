//! Meshes as exporters write them; how much of a surface a grid covers.
