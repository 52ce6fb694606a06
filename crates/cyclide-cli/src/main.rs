//! The `cyclide` command.
fn main() {}
