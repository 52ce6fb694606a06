//! The maps of ARCHITECTURE.md: the rooms of each crate that has some, and what each room may use besides itself.

/// A crate with rooms: folders, or files beside them, below its `src`.
pub struct House {
    /// Where its sources are, from the root of the workspace.
    pub sources: &'static str,
    /// The rooms from the ground up: a room uses rooms before it only, and those that are named.
    pub rooms: &'static [Room],
    /// True of the kernel and its grids: no input or output, no clock, no `unsafe`, double precision only.
    pub is_kernel: bool,
}

/// A room and what it may use.
pub type Room = (&'static str, &'static [&'static str]);

impl House {
    /// What a room may use; `None` for one that is not in the map.
    pub fn allowed(&self, room: &str) -> Option<&'static [&'static str]> {
        self.rooms.iter().find(|(name, _)| *name == room).map(|(_, allowed)| *allowed)
    }
}

/// The crates with rooms.
pub const HOUSES: [&House; 4] = [&KERNEL, &GRIDS, &IO, &CLI];

/// `error`, `warning`, their tables, the numbers in their texts and `shape_change` stand beside `base`.
pub const KERNEL: House = House {
    sources: "crates/cyclide/src",
    rooms: &[
        ("short_number", &[]),
        ("shape_change", &["short_number"]),
        ("table", &["short_number"]),
        ("error", &["short_number", "shape_change", "table"]),
        ("warning", &["short_number", "shape_change", "table"]),
        ("base", &["error", "warning"]),
        ("conformal", &["base", "error", "warning"]),
        ("rational", &["base", "conformal", "error", "warning"]),
        ("batch", &["base", "conformal", "rational", "error", "warning"]),
        ("curve", &["base", "conformal", "rational", "batch", "error", "warning"]),
        ("motion", &["base", "conformal", "rational", "curve", "error", "warning"]),
        ("surface", &["base", "conformal", "rational", "batch", "curve", "error", "warning"]),
        ("volume", &["base", "conformal", "rational", "batch", "curve", "surface", "error", "warning"]),
        ("topology", &["base", "conformal", "rational", "batch", "curve", "surface", "volume", "error", "warning"]),
        ("panel", &["base", "conformal", "curve", "surface", "topology", "error"]),
        (
            "mesh",
            &["base", "conformal", "rational", "batch", "curve", "surface", "volume", "topology", "error", "warning"],
        ),
        (
            "construct",
            &[
                "base",
                "conformal",
                "rational",
                "batch",
                "curve",
                "surface",
                "volume",
                "motion",
                "topology",
                "error",
                "warning",
            ],
        ),
        (
            "model",
            &[
                "base",
                "conformal",
                "rational",
                "batch",
                "curve",
                "surface",
                "volume",
                "motion",
                "topology",
                "construct",
                "mesh",
                "error",
                "warning",
            ],
        ),
        ("workspace", &["base", "surface"]),
    ],
    is_kernel: true,
};

pub const GRIDS: House = House {
    sources: "crates/cyclide-grids/src",
    rooms: &[
        ("sparse_solver", &[]),
        ("principal_rules", &[]),
        ("circular_mesh", &["sparse_solver"]),
        ("principal", &["sparse_solver", "principal_rules", "circular_mesh"]),
    ],
    is_kernel: true,
};

pub const IO: House = House {
    sources: "crates/cyclide-io/src",
    rooms: &[
        ("text", &[]),
        ("error", &["text"]),
        ("input", &["text"]),
        ("file", &[]),
        ("measure", &[]),
        ("export", &[]),
        ("drawing", &["export"]),
        ("check", &["export", "drawing", "text"]),
        ("formats", &["export", "drawing", "check", "input", "text"]),
        ("document", &["export", "formats", "input", "measure", "text", "error"]),
        ("report", &["document", "formats", "check", "export", "measure", "text"]),
        ("manual", &["document", "formats"]),
        ("compare", &["document", "text"]),
        ("schedule", &["document", "formats", "text"]),
    ],
    is_kernel: false,
};

pub const CLI: House = House {
    sources: "crates/cyclide-cli/src",
    rooms: &[("output", &[]), ("arguments", &["output"]), ("commands", &["arguments", "output"])],
    is_kernel: false,
};
