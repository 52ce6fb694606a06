//! The head of a PLY file: what elements follow, of what properties.

/// How the values are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Binary { big_endian: bool },
}

/// A type of number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Kind {
    fn of_word(word: &str) -> Option<Self> {
        Some(match word {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Whether numbers of it are whole.
    pub(super) fn is_whole(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

/// A number of an element, or a list of numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
    /// The type of the number that says how many follow.
    pub(super) list: Option<Kind>,
}

/// Elements of one name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
}

/// What the head says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
}

/// Longest head that is read, in bytes.
const LONGEST: usize = 1 << 20;

impl Header {
    /// Reads the head; gives the place of the byte behind it.
    ///
    /// # Errors
    /// A message.
    pub(super) fn read(bytes: &[u8]) -> Result<(Self, usize), String> {
        if !bytes.starts_with(b"ply") {
            return Err("not a PLY file: it does not start with `ply`".to_owned());
        }
        let (mut encoding, mut elements) = (None, Vec::<Element>::new());
        let mut at = 0;
        for number in 1.. {
            let rest = &bytes[at.min(LONGEST)..bytes.len().min(LONGEST)];
            let end = rest.iter().position(|byte| *byte == b'\n').ok_or("the header has no end_header line")?;
            let line = std::str::from_utf8(&rest[..end]).map_err(|_| format!("line {number}: not text"))?;
            at += end + 1;
            let words: Vec<&str> = line.split_whitespace().collect();
            let wrong = || format!("line {number}: unknown keyword `{}`", crate::text::place::quoted(line.trim()));
            match words.as_slice() {
                ["ply"] if number == 1 => {}
                [] | ["comment" | "obj_info", ..] => {}
                ["format", word, "1.0"] => {
                    encoding = Some(match *word {
                        "ascii" => Encoding::Text,
                        "binary_little_endian" => Encoding::Binary { big_endian: false },
                        "binary_big_endian" => Encoding::Binary { big_endian: true },
                        _ => {
                            return Err(format!(
                                "line {number}: unknown format `{}`",
                                crate::text::place::quoted(word)
                            ));
                        }
                    });
                }
                ["element", name, count] => {
                    let count = count.parse().map_err(|_| wrong())?;
                    elements.push(Element { name: (*name).to_owned(), count, properties: Vec::new() });
                }
                ["property", "list", counted, kind, name] => {
                    let (Some(counted), Some(kind)) = (Kind::of_word(counted), Kind::of_word(kind)) else {
                        return Err(wrong());
                    };
                    let element = elements.last_mut().ok_or_else(wrong)?;
                    if !counted.is_whole() {
                        return Err(wrong());
                    }
                    element.properties.push(Property { name: (*name).to_owned(), kind, list: Some(counted) });
                }
                ["property", kind, name] => {
                    let kind = Kind::of_word(kind).ok_or_else(wrong)?;
                    let element = elements.last_mut().ok_or_else(wrong)?;
                    element.properties.push(Property { name: (*name).to_owned(), kind, list: None });
                }
                ["end_header"] => break,
                _ => return Err(wrong()),
            }
        }
        let encoding = encoding.ok_or("the header does not state the format")?;
        Ok((Self { encoding, elements }, at))
    }
}
