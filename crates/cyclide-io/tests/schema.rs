//! The published schema is the one the program prints.

#[test]
fn the_committed_schema_is_current() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/schema/cyclide-1.schema.json");
    let committed = std::fs::read_to_string(path).unwrap_or_default();
    assert!(
        committed == cyclide_io::document::document_schema(),
        "docs/schema/cyclide-1.schema.json is out of date: cyclide schema > docs/schema/cyclide-1.schema.json"
    );
}
