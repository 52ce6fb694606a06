//! Writes the page of each kind of object, and their index: `docs/kinds`. What they say is made by `cyclide-io`; the pictures are
//! made by `scripts/kind_pictures.py`.

use std::io;
use std::path::Path;
use std::process::ExitCode;

use cyclide_io::{document::ObjectSpec, manual::KindPage};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/kinds");

/// Writes them all.
pub fn main() -> ExitCode {
    match write() {
        Ok(count) => {
            println!("docs/kinds: {count} pages");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("docs/kinds: {error}");
            ExitCode::FAILURE
        }
    }
}

fn write() -> io::Result<usize> {
    let folder = Path::new(FOLDER);
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join("README.md"), KindPage::index())?;
    for word in ObjectSpec::TYPES {
        let picture = format!("images/{word}.png");
        let picture = if folder.join(&picture).exists() { picture } else { String::new() };
        let page = KindPage::of(word).map(|page| page.to_markdown(&picture));
        std::fs::write(folder.join(format!("{word}.md")), page.unwrap_or_default())?;
    }
    Ok(ObjectSpec::TYPES.len() + 1)
}
