//! Where the examples of the gallery are: in the package that is published, or beside the crates of the workspace.

use std::path::Path;

fn main() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    // In the workspace `gallery` is a symbolic link, which a checkout on Windows may hold as a plain file.
    let examples =
        ["gallery", "../../examples"].map(|folder| package.join(folder)).into_iter().find(|folder| folder.is_dir());
    if let Some(folder) = examples {
        println!("cargo::rustc-env=CYCLIDE_EXAMPLES={}", folder.display());
    }
    println!("cargo::rerun-if-changed=build.rs");
}
