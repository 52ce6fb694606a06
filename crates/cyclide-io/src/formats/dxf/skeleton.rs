//! Everything around the entities: header, tables, blocks and objects as AutoCAD wants them.

use super::tags::Tags;
use crate::export::options::DxfVersion;
use cyclide::{Aabb, Point3, model::Units};

/// Handles of the fixed records; entities get theirs from [`FIRST_FREE`] on.
mod handles {
    pub(super) const LAYER_TABLE: usize = 0x1;
    pub(super) const LINETYPE_TABLE: usize = 0x2;
    pub(super) const APPID_TABLE: usize = 0x3;
    pub(super) const DIMSTYLE_TABLE: usize = 0x4;
    pub(super) const STYLE_TABLE: usize = 0x5;
    pub(super) const UCS_TABLE: usize = 0x6;
    pub(super) const VIEW_TABLE: usize = 0x7;
    pub(super) const VIEWPORT_TABLE: usize = 0x8;
    pub(super) const BLOCK_TABLE: usize = 0x9;
    pub(super) const ROOT: usize = 0xA;
    pub(super) const LAYOUTS: usize = 0xC;
    pub(super) const PLOT_STYLES: usize = 0xD;
    pub(super) const PLOT_STYLE: usize = 0xE;
    pub(super) const MODEL_LAYOUT: usize = 0x10;
    pub(super) const PAPER_LAYOUT: usize = 0x11;
    pub(super) const VIEWPORT: usize = 0x12;
    pub(super) const LINETYPES: [usize; 3] = [0x13, 0x14, 0x15];
    pub(super) const STYLE: usize = 0x16;
    pub(super) const APPID: usize = 0x18;
    pub(super) const DIMSTYLE: usize = 0x19;
    pub(super) const LAYER_ZERO: usize = 0x1A;
    pub(super) const MODEL_BLOCK: [usize; 2] = [0x1B, 0x1C];
    pub(super) const PAPER_BLOCK: [usize; 2] = [0x1D, 0x1E];
    pub(super) const PAPER_SPACE: usize = 0x20;
}

/// The dictionary of groups.
pub(super) const GROUPS: usize = 0xB;
/// Owner of all entities.
pub(super) const MODEL_SPACE: usize = 0x1F;
/// First handle for layers, entities and groups.
pub(super) const FIRST_FREE: usize = 0x100;

/// A group of entities: name and handles.
pub(super) struct Group {
    pub(super) handle: usize,
    pub(super) name: String,
    pub(super) members: Vec<usize>,
}

/// What the entities need around them.
pub(super) struct Content<'a> {
    pub(super) version: DxfVersion,
    pub(super) units: Units,
    /// The box around them.
    pub(super) bounds: Aabb,
    pub(super) layers: &'a [String],
    pub(super) groups: &'a [Group],
    /// First handle not used.
    pub(super) next_handle: usize,
}

/// Colors of the layers in turn: black/white, red, blue, green, magenta, orange, cyan.
const COLOURS: [usize; 7] = [7, 1, 5, 3, 6, 30, 4];

/// The file up to the first entity.
pub(super) fn opening(tags: &mut Tags, content: &Content<'_>) {
    header(tags, content);
    match content.version {
        DxfVersion::R2000 => {
            classes(tags);
            tables(tags, content);
            blocks(tags);
        }
        DxfVersion::R12 => r12_tables(tags, content.layers),
    }
    tags.begin("SECTION").text(2, "ENTITIES");
}

/// The file from behind the last entity.
pub(super) fn closing(tags: &mut Tags, content: &Content<'_>) {
    tags.begin("ENDSEC");
    if content.version == DxfVersion::R2000 {
        objects(tags, content.groups);
    }
    tags.begin("EOF");
}

/// `$INSUNITS` and `$MEASUREMENT`.
pub(super) fn unit_codes(units: Units) -> [usize; 2] {
    match units {
        Units::Inch => [1, 0],
        Units::Foot => [2, 0],
        Units::UsSurveyFoot => [21, 0],
        Units::Millimetre => [4, 1],
        Units::Centimetre => [5, 1],
        Units::Metre => [6, 1],
    }
}

/// `$ACADVER`.
pub(super) fn version_code(version: DxfVersion) -> &'static str {
    match version {
        DxfVersion::R2000 => "AC1015",
        DxfVersion::R12 => "AC1009",
    }
}

fn header(tags: &mut Tags, content: &Content<'_>) {
    let [unit, metric] = unit_codes(content.units);
    tags.begin("SECTION").text(2, "HEADER");
    tags.text(9, "$ACADVER").text(1, version_code(content.version));
    if content.version == DxfVersion::R2000 {
        tags.raw("9 $DWGCODEPAGE 3 ANSI_1252");
    }
    tags.text(9, "$EXTMIN").point(10, content.bounds.min);
    tags.text(9, "$EXTMAX").point(10, content.bounds.max);
    tags.text(9, "$INSUNITS").int(70, unit);
    tags.text(9, "$MEASUREMENT").int(70, metric);
    if content.version == DxfVersion::R2000 {
        tags.text(9, "$HANDSEED").handle(5, content.next_handle);
    }
    tags.begin("ENDSEC");
}

fn classes(tags: &mut Tags) {
    tags.begin("SECTION").text(2, "CLASSES");
    for (name, class) in [
        ("ACDBDICTIONARYWDFLT", "AcDbDictionaryWithDefault"),
        ("ACDBPLACEHOLDER", "AcDbPlaceHolder"),
        ("LAYOUT", "AcDbLayout"),
    ] {
        tags.begin("CLASS").text(1, name).text(2, class).text(3, "ObjectDBX Classes").raw("90 0 280 0 281 0");
    }
    tags.begin("ENDSEC");
}

fn table(tags: &mut Tags, name: &str, handle: usize, count: usize) {
    tags.begin("TABLE").text(2, name).handle(5, handle).handle(330, 0);
    tags.text(100, "AcDbSymbolTable").int(70, count);
}

fn record(tags: &mut Tags, name: &str, handle: usize, owner: usize, class: &str) {
    // A dimension style is the one record whose own code for the handle is not 5.
    let code = if name == "DIMSTYLE" { 105 } else { 5 };
    tags.begin(name).handle(code, handle).handle(330, owner);
    tags.text(100, "AcDbSymbolTableRecord").text(100, class);
}

fn tables(tags: &mut Tags, content: &Content<'_>) {
    let layers = content.layers;
    tags.begin("SECTION").text(2, "TABLES");
    viewport(tags, content);
    table(tags, "LTYPE", handles::LINETYPE_TABLE, 3);
    for (handle, name) in handles::LINETYPES.into_iter().zip(["ByBlock", "ByLayer", "Continuous"]) {
        record(tags, "LTYPE", handle, handles::LINETYPE_TABLE, "AcDbLinetypeTableRecord");
        tags.text(2, name).raw("70 0 3 _ 72 65 73 0 40 0.0");
    }
    tags.begin("ENDTAB");
    table(tags, "LAYER", handles::LAYER_TABLE, layers.len() + 1);
    let own = layers.iter().enumerate().map(|(i, name)| (FIRST_FREE + i, name.as_str(), COLOURS[i % COLOURS.len()]));
    for (handle, name, colour) in std::iter::once((handles::LAYER_ZERO, "0", 7)).chain(own) {
        record(tags, "LAYER", handle, handles::LAYER_TABLE, "AcDbLayerTableRecord");
        tags.text(2, name).int(70, 0).int(62, colour).raw("6 Continuous 370 -3").handle(390, handles::PLOT_STYLE);
    }
    tags.begin("ENDTAB");
    table(tags, "STYLE", handles::STYLE_TABLE, 1);
    record(tags, "STYLE", handles::STYLE, handles::STYLE_TABLE, "AcDbTextStyleTableRecord");
    tags.raw("2 Standard 70 0 40 0.0 41 1.0 50 0.0 71 0 42 2.5 3 txt 4 _").begin("ENDTAB");
    for (name, handle) in [("VIEW", handles::VIEW_TABLE), ("UCS", handles::UCS_TABLE)] {
        table(tags, name, handle, 0);
        tags.begin("ENDTAB");
    }
    table(tags, "APPID", handles::APPID_TABLE, 1);
    record(tags, "APPID", handles::APPID, handles::APPID_TABLE, "AcDbRegAppTableRecord");
    tags.raw("2 ACAD 70 0").begin("ENDTAB");
    table(tags, "DIMSTYLE", handles::DIMSTYLE_TABLE, 1);
    tags.text(100, "AcDbDimStyleTable");
    record(tags, "DIMSTYLE", handles::DIMSTYLE, handles::DIMSTYLE_TABLE, "AcDbDimStyleTableRecord");
    tags.raw("2 Standard 70 0").begin("ENDTAB");
    table(tags, "BLOCK_RECORD", handles::BLOCK_TABLE, 2);
    for (handle, name, layout) in [
        (MODEL_SPACE, "*Model_Space", handles::MODEL_LAYOUT),
        (handles::PAPER_SPACE, "*Paper_Space", handles::PAPER_LAYOUT),
    ] {
        record(tags, "BLOCK_RECORD", handle, handles::BLOCK_TABLE, "AcDbBlockTableRecord");
        tags.text(2, name).handle(340, layout);
    }
    tags.begin("ENDTAB").begin("ENDSEC");
}

/// The view that opens: the whole drawing.
fn viewport(tags: &mut Tags, content: &Content<'_>) {
    const ASPECT: f64 = 1.6;
    let (min, max) = (content.bounds.min, content.bounds.max);
    let middle = min.midpoint(max);
    let height = 1.1 * (max.y - min.y).max((max.x - min.x) / ASPECT).max(f64::MIN_POSITIVE);
    table(tags, "VPORT", handles::VIEWPORT_TABLE, 1);
    record(tags, "VPORT", handles::VIEWPORT, handles::VIEWPORT_TABLE, "AcDbViewportTableRecord");
    tags.raw("2 *Active 70 0 10 0.0 20 0.0 11 1.0 21 1.0").real(12, middle.x).real(22, middle.y);
    tags.raw("13 0.0 23 0.0 14 0.5 24 0.5 15 0.5 25 0.5 16 0.0 26 0.0 36 1.0 17 0.0 27 0.0 37 0.0");
    tags.real(40, height).real(41, ASPECT);
    tags.raw("42 50.0 43 0.0 44 0.0 50 0.0 51 0.0 71 0 72 1000 73 1 74 3 75 0 76 0 77 0 78 0 281 0 65 0 146 0.0");
    tags.begin("ENDTAB");
}

fn blocks(tags: &mut Tags) {
    tags.begin("SECTION").text(2, "BLOCKS");
    for (name, owner, [begin, end]) in [
        ("*Model_Space", MODEL_SPACE, handles::MODEL_BLOCK),
        ("*Paper_Space", handles::PAPER_SPACE, handles::PAPER_BLOCK),
    ] {
        tags.begin("BLOCK").handle(5, begin).handle(330, owner).raw("100 AcDbEntity 8 0 100 AcDbBlockBegin");
        tags.text(2, name).int(70, 0).point(10, Point3::ORIGIN).text(3, name).text(1, "");
        tags.begin("ENDBLK").handle(5, end).handle(330, owner).raw("100 AcDbEntity 8 0 100 AcDbBlockEnd");
    }
    tags.begin("ENDSEC");
}

fn dictionary(tags: &mut Tags, handle: usize, owner: usize, entries: &[(&str, usize)]) {
    tags.begin("DICTIONARY").handle(5, handle).handle(330, owner).text(100, "AcDbDictionary").int(281, 1);
    for (name, entry) in entries {
        tags.text(3, name).handle(350, *entry);
    }
}

fn objects(tags: &mut Tags, groups: &[Group]) {
    use handles::{LAYOUTS, MODEL_LAYOUT, PAPER_LAYOUT, PAPER_SPACE, PLOT_STYLE, PLOT_STYLES, ROOT};
    tags.begin("SECTION").text(2, "OBJECTS");
    let root = [("ACAD_GROUP", GROUPS), ("ACAD_LAYOUT", LAYOUTS), ("ACAD_PLOTSTYLENAME", PLOT_STYLES)];
    dictionary(tags, ROOT, 0, &root);
    let entries: Vec<(&str, usize)> = groups.iter().map(|g| (g.name.as_str(), g.handle)).collect();
    dictionary(tags, GROUPS, ROOT, &entries);
    dictionary(tags, LAYOUTS, ROOT, &[("Layout1", PAPER_LAYOUT), ("Model", MODEL_LAYOUT)]);
    tags.begin("ACDBDICTIONARYWDFLT").handle(5, PLOT_STYLES).handle(330, ROOT).raw("100 AcDbDictionary 281 1");
    tags.text(3, "Normal").handle(350, PLOT_STYLE);
    tags.text(100, "AcDbDictionaryWithDefault").handle(340, PLOT_STYLE);
    tags.begin("ACDBPLACEHOLDER").handle(5, PLOT_STYLE).handle(330, PLOT_STYLES);
    for (handle, name, flags, tab, block) in
        [(MODEL_LAYOUT, "Model", 1024, 0, MODEL_SPACE), (PAPER_LAYOUT, "Layout1", 0, 1, PAPER_SPACE)]
    {
        tags.begin("LAYOUT").handle(5, handle).handle(330, LAYOUTS);
        tags.raw(
            "100 AcDbPlotSettings 1 _ 4 A3 6 _ 40 7.5 41 20.0 42 7.5 43 20.0 44 420.0 45 297.0 46 0.0 47 0.0 48 0.0 \
             49 0.0 140 0.0 141 0.0 142 1.0 143 1.0",
        );
        tags.int(70, flags).raw("72 1 73 0 74 5 7 _ 75 16 147 1.0 148 0.0 149 0.0");
        tags.text(100, "AcDbLayout").text(1, name).int(70, 1).int(71, tab);
        tags.raw(
            "10 0.0 20 0.0 11 420.0 21 297.0 12 0.0 22 0.0 32 0.0 14 1.0E20 24 1.0E20 34 1.0E20 15 -1.0E20 \
             25 -1.0E20 35 -1.0E20 146 0.0 13 0.0 23 0.0 33 0.0 16 1.0 26 0.0 36 0.0 17 0.0 27 1.0 37 0.0 76 0",
        );
        tags.handle(330, block);
    }
    for group in groups {
        tags.begin("GROUP").handle(5, group.handle).raw("102 {ACAD_REACTORS").handle(330, GROUPS).raw("102 }");
        tags.handle(330, GROUPS).text(100, "AcDbGroup").text(300, "").int(70, 0).int(71, 1);
        for member in &group.members {
            tags.handle(340, *member);
        }
    }
    tags.begin("ENDSEC");
}

fn r12_tables(tags: &mut Tags, layers: &[String]) {
    tags.begin("SECTION").text(2, "TABLES");
    tags.raw("0 TABLE 2 LTYPE 70 1 0 LTYPE 2 CONTINUOUS 70 0").text(3, "Solid line").raw("72 65 73 0 40 0.0 0 ENDTAB");
    tags.begin("TABLE").text(2, "LAYER").int(70, layers.len() + 1);
    let own = layers.iter().enumerate().map(|(i, name)| (name.as_str(), COLOURS[i % COLOURS.len()]));
    for (name, colour) in std::iter::once(("0", 7)).chain(own) {
        tags.begin("LAYER").text(2, name).int(70, 0).int(62, colour).raw("6 CONTINUOUS");
    }
    tags.begin("ENDTAB").begin("ENDSEC");
}
