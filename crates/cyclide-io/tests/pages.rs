//! The published pages of the kinds of object are those that the code makes.

use std::path::{Path, PathBuf};

use cyclide_io::{document::ObjectSpec, manual::KindPage};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/kinds")
}

fn check(name: &str, made: &str) {
    let committed = std::fs::read_to_string(folder().join(name)).unwrap_or_default();
    assert!(committed == made, "docs/kinds/{name} is out of date: cargo xtask pages");
}

#[test]
fn the_committed_pages_are_current() {
    check("README.md", &KindPage::index());
    for word in ObjectSpec::TYPES {
        let picture = format!("images/{word}.png");
        let picture = if folder().join(&picture).exists() { picture } else { String::new() };
        check(&format!("{word}.md"), &KindPage::of(word).map(|page| page.to_markdown(&picture)).unwrap_or_default());
    }
}

#[test]
fn there_are_no_other_pages() {
    for entry in std::fs::read_dir(folder()).into_iter().flatten().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        let known = name == "README.md" || ObjectSpec::TYPES.iter().any(|word| name == format!("{word}.md"));
        assert!(known || name == "images", "docs/kinds/{name} is the page of no kind");
    }
}
