//! Just enough of Rust's grammar to see paths, macro calls and keywords outside comments and literals.

/// A path with its place: `["crate", "curve", "Arc"]`, groups and globs written out.
#[derive(Debug, PartialEq)]
pub struct Finding {
    pub line: usize,
    pub path: Vec<String>,
}

/// What a file mentions.
pub struct Source {
    tokens: Vec<(usize, Token)>,
    paths: Vec<Finding>,
    macros: Vec<(usize, String)>,
}

#[derive(Debug, Clone, PartialEq)]
enum Token {
    Word(String),
    /// `::`
    Separator,
    Mark(char),
}

impl Source {
    /// Reads a file.
    pub fn parse(text: &str) -> Self {
        let tokens = tokens(text);
        let (mut paths, mut macros) = (Vec::new(), Vec::new());
        let mut i = 0;
        while let Some((line, token)) = tokens.get(i) {
            match token {
                Token::Word(_) if is(&tokens, i + 1, &Token::Separator) => {
                    i = written_out(&tokens, i, &mut Vec::new(), &mut paths);
                    continue;
                }
                Token::Word(word) if is(&tokens, i + 1, &Token::Mark('!')) => macros.push((*line, word.clone())),
                _ => {}
            }
            i += 1;
        }
        Self { tokens, paths, macros }
    }

    /// Paths of two or more names.
    pub fn paths(&self) -> &[Finding] {
        &self.paths
    }

    /// Names followed by `!`.
    pub fn macros(&self) -> &[(usize, String)] {
        &self.macros
    }

    /// Lines with a keyword.
    pub fn keyword<'a>(&'a self, keyword: &'a str) -> impl Iterator<Item = usize> + 'a {
        self.tokens.iter().filter(move |(_, t)| matches!(t, Token::Word(w) if w == keyword)).map(|(line, _)| *line)
    }
}

fn is(tokens: &[(usize, Token)], i: usize, wanted: &Token) -> bool {
    tokens.get(i).is_some_and(|(_, token)| token == wanted)
}

/// Follows a path from token `i`, writing out groups; returns the token after it.
fn written_out(tokens: &[(usize, Token)], mut i: usize, prefix: &mut Vec<String>, paths: &mut Vec<Finding>) -> usize {
    let depth = prefix.len();
    let line = tokens.get(i).map_or(0, |(line, _)| *line);
    loop {
        match tokens.get(i).map(|(_, token)| token) {
            Some(Token::Word(word)) => {
                prefix.push(word.clone());
                i += 1;
                if is(tokens, i, &Token::Separator) {
                    i += 1;
                    continue;
                }
            }
            Some(Token::Mark('*')) => {
                prefix.push("*".into());
                i += 1;
            }
            Some(Token::Mark('{')) => {
                i += 1;
                while i < tokens.len() && !is(tokens, i, &Token::Mark('}')) {
                    let before = i;
                    i = written_out(tokens, i, prefix, paths);
                    // Past `as name` and commas to the next member.
                    while i < tokens.len() && !is(tokens, i, &Token::Mark(',')) && !is(tokens, i, &Token::Mark('}')) {
                        i += 1;
                    }
                    i += usize::from(is(tokens, i, &Token::Mark(',')));
                    if i == before {
                        break;
                    }
                }
                prefix.truncate(depth);
                return i + 1;
            }
            _ => {}
        }
        if prefix.len() > 1 {
            paths.push(Finding { line, path: prefix.clone() });
        }
        prefix.truncate(depth);
        return i;
    }
}

/// Words and marks outside comments and literals, with their lines.
fn tokens(text: &str) -> Vec<(usize, Token)> {
    let chars: Vec<char> = text.chars().collect();
    let at = |i: usize| chars.get(i).copied().unwrap_or('\0');
    let (mut tokens, mut i, mut line) = (Vec::new(), 0, 1);
    while i < chars.len() {
        let start = i;
        let c = chars[i];
        match c {
            '/' if at(i + 1) == '/' => i = (i..chars.len()).find(|&k| chars[k] == '\n').unwrap_or(chars.len()),
            '/' if at(i + 1) == '*' => i = after_comment(&chars, i),
            '"' => i = after_string(&chars, i),
            'r' | 'b' | 'c' if starts_raw(&chars, i).is_some() => i = after_raw(&chars, i),
            '\'' => i = after_quote(&chars, i),
            c if c.is_alphanumeric() || c == '_' => {
                i = (i..chars.len()).find(|&k| !(chars[k].is_alphanumeric() || chars[k] == '_')).unwrap_or(chars.len());
                tokens.push((line, Token::Word(chars[start..i].iter().collect())));
            }
            ':' if at(i + 1) == ':' => {
                tokens.push((line, Token::Separator));
                i += 2;
            }
            c => {
                if !c.is_whitespace() {
                    tokens.push((line, Token::Mark(c)));
                }
                i += 1;
            }
        }
        line += chars[start..i].iter().filter(|c| **c == '\n').count();
    }
    tokens
}

/// After a block comment, which may hold others.
fn after_comment(chars: &[char], mut i: usize) -> usize {
    let mut depth = 0;
    while i < chars.len() {
        let two: String = chars[i..chars.len().min(i + 2)].iter().collect();
        match two.as_str() {
            "/*" => depth += 1,
            "*/" => depth -= 1,
            _ => {
                i += 1;
                continue;
            }
        }
        i += 2;
        if depth == 0 {
            break;
        }
    }
    i
}

fn after_string(chars: &[char], open: usize) -> usize {
    let mut i = open + 1;
    while i < chars.len() && chars[i] != '"' {
        i += if chars[i] == '\\' { 2 } else { 1 };
    }
    chars.len().min(i + 1)
}

/// Number of hashes of a raw string that starts here (`r"`, `r#"`, `br"`, `cr"`, …).
fn starts_raw(chars: &[char], i: usize) -> Option<usize> {
    let word_before = i > 0 && (chars[i - 1].is_alphanumeric() || chars[i - 1] == '_');
    let r = if chars[i] == 'r' { i } else { i + 1 };
    if word_before || chars.get(r) != Some(&'r') {
        return None;
    }
    let hashes = chars[r + 1..].iter().take_while(|c| **c == '#').count();
    (chars.get(r + 1 + hashes) == Some(&'"')).then_some(hashes)
}

fn after_raw(chars: &[char], start: usize) -> usize {
    let hashes = starts_raw(chars, start).unwrap_or(0);
    let open = (start..chars.len()).find(|&k| chars[k] == '"').unwrap_or(chars.len());
    let closes = |k: usize| chars[k] == '"' && chars[k + 1..].iter().take_while(|c| **c == '#').count() >= hashes;
    (open + 1..chars.len()).find(|&k| closes(k)).map_or(chars.len(), |k| k + 1 + hashes)
}

/// After a character literal, or just after the quote of a lifetime.
fn after_quote(chars: &[char], i: usize) -> usize {
    match (chars.get(i + 1), chars.get(i + 2)) {
        (Some('\\'), _) => (i + 3..chars.len()).find(|&k| chars[k] == '\'').map_or(chars.len(), |k| k + 1),
        (Some(_), Some('\'')) => i + 3,
        _ => i + 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paths(text: &str) -> Vec<String> {
        Source::parse(text).paths().iter().map(|f| format!("{}:{}", f.line, f.path.join("::"))).collect()
    }

    #[test]
    fn groups_are_written_out() {
        assert_eq!(
            paths("use a::{b, c::{d as x, self},\n e::*, };\nf(g::h);"),
            ["1:a::b", "1:a::c::d", "1:a::c::self", "2:a::e::*", "3:g::h"]
        );
    }

    #[test]
    fn literals_and_comments_are_not_read() {
        assert_eq!(paths("/* a::b /* c::d */ e::f */ '\\'' b'x' \"g::\\\"h::i\" r\"j::k\" 'l: m::n"), ["1:m::n"]);
        assert_eq!(paths("for r in b::c {}"), ["1:b::c"]);
    }
}
