//! Where the examples of the gallery are: in the package that is published, or beside the crates of the workspace.

use std::path::PathBuf;

fn main() {
    let package = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    // In the workspace `gallery` is a symbolic link, which a checkout on Windows may hold as a plain file.
    let examples =
        ["gallery", "../../examples"].map(|folder| package.join(folder)).into_iter().find(|folder| folder.is_dir());
    if let Some(folder) = examples {
        println!("cargo::rustc-env=CYCLIDE_EXAMPLES={}", folder.display());
    }
    println!("cargo::rerun-if-changed=build.rs");
}
