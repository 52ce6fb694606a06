//! What there is to say of the fields of an object, and of the types that several of them have.

use std::collections::BTreeMap;

use serde_json::{Map, Value};

use super::phrases::{cases, choices, either, plain, reference, type_words};

/// The fields of every object: they come last.
const EVERYWHERE: [&str; 2] = ["comment", "construction"];

/// Types that are explained by themselves even if one field only has them.
const BASIC: [&str; 3] = ["Coordinates", "Angle", "Points"];

/// Whether a field has to be given.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Need {
    Required,
    Optional,
    /// It belongs to one of several sets of fields, or is no field.
    AsSaid,
    Default(String),
}

/// A field, a word or a type, with what is inside.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Entry {
    /// Its name as in a document: words in quotes.
    pub(super) label: String,
    /// Its type in words; empty of words.
    pub(super) kind: String,
    pub(super) need: Need,
    pub(super) text: String,
    pub(super) entries: Vec<Self>,
}

/// What a page says of an object.
pub(super) struct Said {
    pub(super) text: Vec<String>,
    pub(super) rules: Vec<String>,
    pub(super) entries: Vec<Entry>,
    pub(super) types: Vec<Entry>,
}

/// The definitions of a schema.
pub(super) struct Definitions<'a>(&'a Map<String, Value>);

impl<'a> Definitions<'a> {
    pub(super) fn of(schema: &'a Value) -> Option<Self> {
        schema.get("$defs")?.as_object().map(Self)
    }

    /// The definition of the objects whose type is `word`, and the sentence of that kind.
    pub(super) fn object(&self, word: &str) -> Option<(&'a Value, String)> {
        self.0.get("Object")?.get("anyOf")?.as_array()?.iter().find_map(|case| {
            let object = self.0.get(reference(case)?)?;
            (object.pointer("/properties/type/const")?.as_str()? == word).then(|| (object, said(case)))
        })
    }

    /// All that a page says of an object.
    pub(super) fn page(&self, object: &'a Value) -> Said {
        let mut uses = Uses::default();
        uses.count(self, object);
        let pages = Pages { definitions: self, uses };
        let shared = pages.uses.order.iter().filter(|name| pages.is_shared(name));
        let types = shared.filter_map(|name| Some(pages.entry(pages.called(name), self.0.get(*name)?, Need::AsSaid)));
        let mut entries = pages.fields(object);
        // A stable sort.
        entries.sort_by_key(|entry| EVERYWHERE.contains(&entry.label.as_str()));
        Said { text: paragraphs(object), rules: rules(object), entries, types: types.collect() }
    }
}

/// How often the definitions are referred to from a page, in the order in which they are met.
#[derive(Default)]
struct Uses<'a> {
    counts: BTreeMap<&'a str, usize>,
    order: Vec<&'a str>,
}

impl<'a> Uses<'a> {
    fn count(&mut self, definitions: &Definitions<'a>, schema: &'a Value) {
        if let Some(name) = reference(schema) {
            let count = self.counts.entry(name).or_insert(0);
            *count += 1;
            if *count == 1 {
                self.order.push(name);
                if let Some(target) = definitions.0.get(name) {
                    self.count(definitions, target);
                }
            }
        }
        match schema {
            Value::Object(members) => members.values().for_each(|member| self.count(definitions, member)),
            Value::Array(items) => items.iter().for_each(|item| self.count(definitions, item)),
            _ => {}
        }
    }
}

/// The definitions as one page uses them.
struct Pages<'a, 'b> {
    definitions: &'b Definitions<'a>,
    uses: Uses<'a>,
}

impl Pages<'_, '_> {
    /// True of types that are explained at the end of the page: several fields have them, or every user meets them.
    fn is_shared(&self, name: &str) -> bool {
        BASIC.contains(&name) || self.uses.counts.get(name).is_some_and(|count| *count > 1)
    }

    /// What a type is called: its title, or the words of its name.
    fn called(&self, name: &str) -> String {
        let title = self.definitions.0.get(name).and_then(|target| target.get("title")).and_then(Value::as_str);
        title.map_or_else(|| in_words(name), |title| format!("`{title}`"))
    }

    /// The type of a schema in words: shared types by their names, others as they are.
    fn kind(&self, schema: &Value) -> String {
        type_words(schema, &|name| self.choices_of(name))
    }

    /// The types in words that a definition stands for.
    fn choices_of(&self, name: &str) -> Vec<String> {
        match self.definitions.0.get(name) {
            Some(target) if !self.is_shared(name) => choices(target, &|inner| self.choices_of(inner)),
            _ => vec![self.called(name)],
        }
    }

    fn entry(&self, label: String, schema: &Value, need: Need) -> Entry {
        let rules = if schema.get("properties").is_some() { rules(schema) } else { self.inner_rules(schema) };
        let text = [vec![said(schema)], rules].concat().join(" ");
        Entry { label, kind: self.kind(schema), need, text: text.trim().to_owned(), entries: self.inside(schema) }
    }

    /// The rules about the fields of the one object that a schema refers to.
    fn inner_rules(&self, schema: &Value) -> Vec<String> {
        self.target(schema).map_or(Vec::new(), rules)
    }

    /// The definition that is explained where it is referred to.
    fn target(&self, schema: &Value) -> Option<&Value> {
        let item = schema.get("items").unwrap_or(schema);
        reference(item).filter(|name| !self.is_shared(name)).and_then(|name| self.definitions.0.get(name))
    }

    /// What a schema is made of: the fields of an object, the words of a choice, the cases of others.
    fn inside(&self, schema: &Value) -> Vec<Entry> {
        if let Some(target) = self.target(schema) {
            return self.inside(target);
        }
        if schema.get("properties").is_some() {
            return self.fields(schema);
        }
        match (cases(schema), schema.get("items")) {
            (Some(cases), _) => cases.iter().flat_map(|case| self.case(case, cases)).collect(),
            (None, Some(items)) => self.inside(items),
            (None, None) => Vec::new(),
        }
    }

    /// What there is to say of one case of a choice.
    fn case(&self, case: &Value, all: &[Value]) -> Vec<Entry> {
        if let Some(word) = case.get("const") {
            let text = said(case);
            let entry =
                Entry { label: word.to_string(), kind: String::new(), need: Need::AsSaid, text, entries: Vec::new() };
            return if entry.text.is_empty() { Vec::new() } else { vec![entry] };
        }
        let inside = self.inside(case);
        let one_field = case.get("properties").and_then(Value::as_object).is_some_and(|fields| fields.len() == 1);
        if one_field {
            // A choice among fields: what is said of the case is said of its field.
            let with_text = |entry: Entry| Entry { text: or(entry.text, || said(case)), need: Need::AsSaid, ..entry };
            return inside.into_iter().map(with_text).collect();
        }
        let words = self.target(case).unwrap_or(case);
        let only_words = cases(words).is_some_and(|cases| cases.iter().all(|case| case.get("const").is_some()));
        let alone = all.iter().filter(|case| !self.inside(case).is_empty()).count() < 2;
        let text = or(said(case), || self.target(case).map_or(String::new(), said));
        if only_words || (alone && text.is_empty()) || (text.is_empty() && inside.is_empty()) {
            return inside;
        }
        let text = [vec![text], self.inner_rules(case)].concat().join(" ");
        vec![Entry { label: self.kind(case), kind: String::new(), need: Need::AsSaid, text, entries: inside }]
    }

    /// The fields of an object but its type.
    fn fields(&self, object: &Value) -> Vec<Entry> {
        let required = object.get("required").map_or(Vec::new(), names);
        let chosen = sets(object).concat();
        let fields = object.get("properties").and_then(Value::as_object).into_iter().flatten();
        let fields = fields.filter(|(name, schema)| *name != "type" || schema.get("const").is_none());
        let need = |name: &String, schema: &Value| match schema.get("default") {
            _ if required.contains(name) => Need::Required,
            _ if chosen.contains(name) => Need::AsSaid,
            Some(Value::Array(items)) if items.is_empty() => Need::Optional,
            None | Some(Value::Null) => Need::Optional,
            Some(value) => Need::Default(plain(value)),
        };
        fields.map(|(name, schema)| self.entry(name.clone(), schema, need(name, schema))).collect()
    }
}

/// A text, or another one if it is empty.
fn or(text: String, other: impl FnOnce() -> String) -> String {
    if text.is_empty() { other() } else { text }
}

/// The description of an object, as paragraphs.
fn paragraphs(object: &Value) -> Vec<String> {
    let text = object.get("description").and_then(Value::as_str).unwrap_or_default();
    let line = |paragraph: &str| paragraph.split_whitespace().collect::<Vec<_>>().join(" ");
    text.split("\n\n").map(line).filter(|paragraph| !paragraph.is_empty()).collect()
}

/// The description of a schema as one line.
fn said(schema: &Value) -> String {
    schema
        .get("description")
        .and_then(Value::as_str)
        .unwrap_or_default()
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}

/// The sets of fields, or words, of which an object has exactly one.
fn sets(object: &Value) -> Vec<Vec<String>> {
    let inner = object.get("allOf").and_then(Value::as_array).into_iter().flatten();
    let cases = std::iter::once(object).chain(inner).filter_map(|part| part.get("oneOf")?.as_array()).flatten();
    let set = |case: &Value| match (case.get("required").map(names), case.get("const")) {
        (Some(fields), _) => Some(fields),
        (None, Some(word)) if object.get("properties").is_none() => Some(vec![word.to_string()]),
        _ => None,
    };
    let sets: Vec<Vec<String>> = cases.filter_map(set).collect();
    // Words alone are no fields.
    if sets.iter().flatten().all(|name| name.starts_with('"')) { Vec::new() } else { sets }
}

/// The names in a list of the schema.
fn names(list: &Value) -> Vec<String> {
    list.as_array().into_iter().flatten().filter_map(Value::as_str).map(str::to_owned).collect()
}

/// Which fields of an object go together, in sentences.
fn rules(object: &Value) -> Vec<String> {
    let all = |names: &Vec<String>| {
        let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        either(&names, ", ", " and ")
    };
    let sets = sets(object);
    let chosen = sets.concat();
    let sets: Vec<String> = sets.iter().map(all).collect();
    let one_of = (!sets.is_empty()).then(|| format!("Give exactly one of: {}.", either(&sets, "; ", "; or ")));
    let together = object.get("dependentRequired").and_then(Value::as_object).into_iter().flatten();
    // A set says already what goes with its own fields.
    let together = together.filter(|(name, _)| !chosen.contains(name));
    let together = together.map(|(name, needed)| format!("`{name}` needs {}.", all(&names(needed))));
    one_of.into_iter().chain(together).collect()
}

/// The words of a name in capitals: `TeeBranch`, `tee branch`.
fn in_words(name: &str) -> String {
    let mut words = String::new();
    for c in name.chars() {
        if c.is_uppercase() && !words.is_empty() {
            words.push(' ');
        }
        words.extend(c.to_lowercase());
    }
    words
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
mod tests {
    use super::*;
    use serde_json::json;

    fn schema() -> Value {
        json!({"$defs": {
            "Object": {"anyOf": [{"$ref": "#/$defs/Pot", "description": "A pot."}]},
            "Pot": {
                "description": "A pot with\n a lid.\n\nIt boils.",
                "properties": {
                    "type": {"const": "pot"},
                    "comment": {"type": "string", "description": "A remark."},
                    "lid": {"$ref": "#/$defs/Lid", "description": "Its lid."},
                    "height": {"$ref": "#/$defs/Length", "description": "How high."},
                    "width": {"$ref": "#/$defs/Length", "description": "How wide.", "default": 2},
                    "side": {"oneOf": [{"const": "in", "description": "Inside."}, {"const": "out", "description": "Outside."}]}
                },
                "required": ["type"],
                "oneOf": [{"required": ["lid"]}, {"required": ["height", "side"]}],
                "dependentRequired": {"width": ["height"]}
            },
            "Lid": {"type": "object", "properties": {"knob": {"type": "boolean", "description": "Has it one?"}}, "required": ["knob"]},
            "Length": {"type": "number", "description": "A length."}
        }})
    }

    #[test]
    fn a_page_says_each_field_and_each_shared_type_once() {
        let schema = schema();
        let definitions = Definitions::of(&schema).unwrap();
        assert!(definitions.object("pan").is_none());
        let (object, sentence) = definitions.object("pot").unwrap();
        assert_eq!(sentence, "A pot.");
        let page = definitions.page(object);
        assert_eq!(page.text, ["A pot with a lid.", "It boils."]);
        assert_eq!(page.rules, ["Give exactly one of: `lid`; or `height` and `side`.", "`width` needs `height`."]);
        let labels: Vec<&str> = page.entries.iter().map(|entry| entry.label.as_str()).collect();
        assert_eq!(labels, ["lid", "height", "width", "side", "comment"]);
        let [lid, height, width, side, _] = page.entries.as_slice() else { unreachable!("five fields") };
        assert_eq!((lid.kind.as_str(), &lid.need, lid.entries[0].label.as_str()), ("object", &Need::AsSaid, "knob"));
        assert_eq!(lid.entries[0].need, Need::Required);
        assert_eq!((height.kind.as_str(), height.entries.len()), ("length", 0));
        assert_eq!(width.need, Need::Default("2".to_owned()));
        assert_eq!((side.entries[1].label.as_str(), side.entries[1].text.as_str()), ("\"out\"", "Outside."));
        assert_eq!((page.types.len(), page.types[0].kind.as_str()), (1, "number"));
    }
}
