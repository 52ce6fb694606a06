//! Part 21 text to instances: enough of the syntax for any exchange file, without its meaning.
//!
//! The text is gone through once, every instance by the rules, and of each only its place is kept: the parameters of
//! all at once would take several times the memory of the file. An instance is read again when it is asked for.

use crate::check::read_error::ReadError;

/// Lists nest this deep at most.
const DEEPEST: usize = 16;

/// One parameter of an entity.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value<'a> {
    Reference(u64),
    Number(f64),
    /// A text without its quotes, escaped as it stands in the file; empty if it is not UTF-8.
    Text(&'a str),
    /// `.NAME.` without the dots.
    Enumeration(&'a str),
    List(Vec<Self>),
    /// `NAME(value)`: a value with its type.
    Typed(&'a str, Vec<Self>),
    /// `$` or `*`.
    Absent,
}

/// One instance: its entities (several for a complex one) with their parameters.
pub(super) type Instance<'a> = Vec<(&'a str, Vec<Value<'a>>)>;

/// The instances of a DATA section, by number.
pub(super) struct Instances<'a> {
    bytes: &'a [u8],
    /// Numbers and where the instances begin in the text, by number.
    places: Vec<(u64, usize)>,
}

impl<'a> Instances<'a> {
    /// The instance with a number, if there is one.
    pub(super) fn get(&self, number: u64) -> Option<Instance<'a>> {
        let index = self.places.binary_search_by_key(&number, |place| place.0).ok()?;
        // It was read before.
        Cursor { bytes: self.bytes, at: self.places[index].1 }.instance().ok()
    }
}

/// The instances of the DATA section; `visit` is given the number and the first name of each, in file order.
pub(super) fn parse<'a>(bytes: &'a [u8], mut visit: impl FnMut(u64, &'a str)) -> Result<Instances<'a>, ReadError> {
    let mut text = Cursor { bytes, at: 0 };
    text.skip_to(b"DATA;")?;
    let mut places: Vec<(u64, usize)> = Vec::new();
    loop {
        text.blank();
        if text.peek() != Some(b'#') {
            break;
        }
        text.at += 1;
        let number = text.integer()?;
        text.expect(b'=')?;
        places.push((number, text.at));
        let instance = text.instance()?;
        text.expect(b';')?;
        if let Some((name, _)) = instance.first() {
            visit(number, name);
        }
    }
    text.keyword("ENDSEC")?;
    // Stable and linear where they are in order, as ours are.
    places.sort_by_key(|place| place.0);
    if let Some(twice) = places.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        return Err(text.error(format!("instance #{} is defined twice", twice[0].0)));
    }
    Ok(Instances { bytes, places })
}

struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Cursor<'a> {
    fn error(&self, detail: impl Into<String>) -> ReadError {
        ReadError::syntax(format!("byte {}", self.at), detail)
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn blank(&mut self) {
        while self.peek().is_some_and(|b| b.is_ascii_whitespace()) {
            self.at += 1;
        }
    }

    fn expect(&mut self, byte: u8) -> Result<(), ReadError> {
        self.blank();
        if self.peek() == Some(byte) {
            self.at += 1;
            Ok(())
        } else {
            Err(self.error(format!("expected '{}'", char::from(byte))))
        }
    }

    fn skip_to(&mut self, mark: &[u8]) -> Result<(), ReadError> {
        let found = self.bytes.windows(mark.len()).position(|w| w == mark);
        self.at = found.ok_or_else(|| self.error("no DATA section"))? + mark.len();
        Ok(())
    }

    fn name(&mut self) -> Result<&'a str, ReadError> {
        self.blank();
        let bytes: &'a [u8] = self.bytes;
        let rest = &bytes[self.at..];
        let length = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
        if length == 0 {
            return Err(self.error("expected a name"));
        }
        self.at += length;
        // Letters and digits: always text.
        Ok(std::str::from_utf8(&rest[..length]).unwrap_or_default())
    }

    fn keyword(&mut self, keyword: &str) -> Result<(), ReadError> {
        if self.name()? == keyword { Ok(()) } else { Err(self.error(format!("expected {keyword}"))) }
    }

    fn integer(&mut self) -> Result<u64, ReadError> {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().take_while(|b| b.is_ascii_digit()).count();
        let digits = String::from_utf8_lossy(&rest[..length]);
        let number = digits.parse().map_err(|_| self.error("expected an instance number"))?;
        self.at += length;
        Ok(number)
    }

    fn instance(&mut self) -> Result<Instance<'a>, ReadError> {
        self.blank();
        if self.peek() != Some(b'(') {
            return Ok(vec![self.entity()?]);
        }
        self.at += 1;
        let mut entities = Vec::new();
        loop {
            self.blank();
            if self.peek() == Some(b')') {
                self.at += 1;
                return Ok(entities);
            }
            entities.push(self.entity()?);
        }
    }

    fn entity(&mut self) -> Result<(&'a str, Vec<Value<'a>>), ReadError> {
        let name = self.name()?;
        Ok((name, self.list(0)?))
    }

    fn list(&mut self, depth: usize) -> Result<Vec<Value<'a>>, ReadError> {
        if depth > DEEPEST {
            return Err(self.error(format!("lists are nested more than {DEEPEST} levels deep")));
        }
        self.expect(b'(')?;
        let mut values = Vec::new();
        self.blank();
        if self.peek() == Some(b')') {
            self.at += 1;
            return Ok(values);
        }
        loop {
            values.push(self.value(depth)?);
            self.blank();
            match self.peek() {
                Some(b',') => self.at += 1,
                Some(b')') => {
                    self.at += 1;
                    return Ok(values);
                }
                _ => return Err(self.error("expected ',' or ')'")),
            }
        }
    }

    fn value(&mut self, depth: usize) -> Result<Value<'a>, ReadError> {
        self.blank();
        match self.peek() {
            Some(b'#') => {
                self.at += 1;
                Ok(Value::Reference(self.integer()?))
            }
            Some(b'\'') => self.text(),
            Some(b'.') => {
                self.at += 1;
                let name = self.name()?;
                self.expect(b'.')?;
                Ok(Value::Enumeration(name))
            }
            Some(b'(') => Ok(Value::List(self.list(depth + 1)?)),
            Some(b'$' | b'*') => {
                self.at += 1;
                Ok(Value::Absent)
            }
            Some(b'+' | b'-' | b'0'..=b'9') => self.number(),
            Some(_) => {
                let name = self.name()?;
                Ok(Value::Typed(name, self.list(depth + 1)?))
            }
            None => Err(self.error("the file ends inside an instance")),
        }
    }

    fn number(&mut self) -> Result<Value<'a>, ReadError> {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().take_while(|b| b.is_ascii_digit() || b"+-.E".contains(b)).count();
        let digits = String::from_utf8_lossy(&rest[..length]);
        let number: f64 = digits.parse().map_err(|_| self.error(format!("'{digits}' is not a number")))?;
        if !number.is_finite() {
            return Err(self.error(format!("'{digits}' is too large")));
        }
        self.at += length;
        Ok(Value::Number(number))
    }

    fn text(&mut self) -> Result<Value<'a>, ReadError> {
        self.at += 1;
        let start = self.at;
        loop {
            match self.peek() {
                Some(b'\'') if self.bytes.get(self.at + 1) == Some(&b'\'') => self.at += 2,
                Some(b'\'') => break,
                Some(_) => self.at += 1,
                None => return Err(self.error("unterminated string")),
            }
        }
        self.at += 1;
        let bytes: &'a [u8] = self.bytes;
        Ok(Value::Text(std::str::from_utf8(&bytes[start..self.at - 1]).unwrap_or_default()))
    }
}
