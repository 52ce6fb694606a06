//! Test helpers of cyclide (unpublished): generators of random input, patches and whole documents, files broken on
//! purpose, a set of closed curves, meshes with extraordinary vertices, the roof and the scan of the examples, the runner of reference files.

pub mod attack;
pub mod circuits;
pub mod generators;
pub mod layouts;
pub mod mutate;
pub mod patches;
pub mod rational_faces;
pub mod reference;
pub mod roof;
pub mod scan;
pub mod torus_splines;
pub mod volumes;
