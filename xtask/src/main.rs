//! Developer tasks of cyclide.
fn main() {}
