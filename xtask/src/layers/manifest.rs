//! Just enough of Cargo manifests to see the dependencies of a crate.

/// Name and dependencies of a crate.
#[derive(Debug, Default, PartialEq)]
pub struct Manifest {
    pub name: String,
    pub dependencies: Vec<Dependency>,
}

/// One dependency.
#[derive(Debug, PartialEq)]
pub struct Dependency {
    pub name: String,
    /// From `dev-dependencies`.
    pub for_tests: bool,
}

/// Reads a manifest written in the usual way: one dependency per line or per section.
pub fn parse(text: &str) -> Manifest {
    let mut manifest = Manifest::default();
    let mut section = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(header) = line.strip_prefix('[') {
            let header = header.split(']').next().unwrap_or_default();
            section = header.split('.').map(|part| part.trim_matches(['"', '\'', ' ']).to_owned()).collect();
            // A section of its own: `[dependencies.NAME]`.
            if let [.., kind, name] = section.as_slice()
                && let Some(for_tests) = dependency_kind(kind)
            {
                manifest.dependencies.push(Dependency { name: name.clone(), for_tests });
            }
            continue;
        }
        let Some((key, value)) = line.split_once('=') else { continue };
        let key = key.split('.').next().unwrap_or_default().trim().trim_matches(['"', '\'']);
        match section.last().map(String::as_str) {
            Some("package") if section.len() == 1 && key == "name" => manifest.name = quoted(value).unwrap_or_default(),
            Some(kind) => {
                if let Some(for_tests) = dependency_kind(kind) {
                    let renamed = value.split_once("package").and_then(|(_, rest)| quoted(rest));
                    manifest.dependencies.push(Dependency { name: renamed.unwrap_or(key.into()), for_tests });
                }
            }
            None => {}
        }
    }
    manifest
}

/// Whether a section lists dependencies, and if so whether only those of tests.
fn dependency_kind(section: &str) -> Option<bool> {
    match section {
        "dependencies" | "build-dependencies" => Some(false),
        "dev-dependencies" => Some(true),
        _ => None,
    }
}

/// The first quoted text.
fn quoted(text: &str) -> Option<String> {
    text.split('"').nth(1).map(str::to_owned)
}
