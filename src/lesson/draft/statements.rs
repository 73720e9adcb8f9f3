//! The statements of a TOML file and the lines that each takes: one is changed, and every other byte stays as it is. The file has
//! been read by a parser before; here it is only found where what it says is written.

use std::ops::Range;

use toml::de::DeValue;

#[derive(Clone, PartialEq, Debug)]
struct Statement<'a> {
    /// Whole lines, with what follows on the last one.
    lines: Range<usize>,
    what: What<'a>,
}

#[derive(Clone, PartialEq, Debug)]
enum What<'a> {
    /// `[scenes.two-cuts]`: its name; `[[step]]` is one of a list.
    Header(&'a str),
    Field {
        key: &'a str,
        value: Range<usize>,
    },
}

/// A header with what belongs to it: the comment right above it, its fields, and the tables in it.
#[derive(Clone, PartialEq, Debug)]
pub struct Block {
    pub lines: Range<usize>,
    /// Where a field of its own would be added.
    end: usize,
    /// Its own fields: key, lines and value.
    fields: Vec<(String, Range<usize>, Range<usize>)>,
}

impl Block {
    /// The value of a field, as it is written.
    pub fn value<'a>(&self, text: &'a str, key: &str) -> Option<&'a str> {
        let mut fields = self.fields.iter();
        let (_, _, value) = fields.find(|(known, ..)| known == key)?;
        Some(&text[value.clone()])
    }

    /// The text with another value of a field, or without it. What belongs to the field by a longer key, `segments.0.1`, goes.
    pub fn with(&self, text: &str, key: &str, value: Option<&str>) -> String {
        let mut text = text.to_owned();
        let mut is_set = false;
        let mut end = self.end;
        for (known, lines, at) in self.fields.iter().rev() {
            match value {
                Some(value) if known == key => {
                    text.replace_range(at.clone(), value);
                    is_set = true;
                }
                _ if first_of(known) == key => {
                    text.replace_range(lines.clone(), "");
                    end -= lines.len();
                }
                _ => {}
            }
        }
        if let Some(value) = value.filter(|_| !is_set) {
            let nl = line_break(&text);
            let before = if text[..end].ends_with('\n') { "" } else { nl };
            text.insert_str(end, &format!("{before}{key} = {value}{nl}"));
        }
        text
    }

    /// The text with these lines in place of all its fields.
    pub fn filled(&self, text: &str, fields: &str) -> String {
        let start = self
            .fields
            .first()
            .map_or(self.end, |(_, lines, _)| lines.start);
        let mut filled = text.to_owned();
        filled.replace_range(start..self.end, fields);
        filled
    }
}

/// The blocks whose headers have this name, in the file's order; with no name what stands over all headers. A table in one of them
/// is a part of it.
pub fn blocks(text: &str, name: &str) -> Vec<Block> {
    let statements = statements(text);
    let mut all: Vec<Block> = Vec::new();
    // Is the statement one of a block, or even one of its own fields?
    let (mut is_in, mut is_own) = (name.is_empty(), name.is_empty());
    if is_in {
        all.push(Block {
            lines: 0..0,
            end: text.len() - text.trim_start_matches('\u{feff}').len(),
            fields: Vec::new(),
        });
    }
    for statement in &statements {
        match &statement.what {
            What::Header(header) => {
                let header = plain(header);
                is_own = header == name;
                is_in = is_own
                    || (is_in
                        && header
                            .strip_prefix(name)
                            .is_some_and(|it| it.starts_with('.')));
                if is_own {
                    all.push(Block {
                        lines: above(text, statement.lines.start)..statement.lines.end,
                        end: statement.lines.end,
                        fields: Vec::new(),
                    });
                }
            }
            What::Field { key, value } => {
                if let Some(block) = all.last_mut().filter(|_| is_own) {
                    let (lines, value) = (statement.lines.clone(), value.clone());
                    block.end = lines.end;
                    block.fields.push((plain(key), lines, value));
                }
            }
        }
        if let Some(block) = all.last_mut().filter(|_| is_in) {
            block.lines.end = statement.lines.end;
        }
    }
    // What follows up to the next header, blank lines and comments, goes with a block.
    let headers = statements
        .iter()
        .filter(|it| matches!(it.what, What::Header(_)));
    let starts: Vec<usize> = headers.map(|it| above(text, it.lines.start)).collect();
    for block in &mut all {
        let next = starts
            .iter()
            .copied()
            .find(|&start| start >= block.lines.end);
        block.lines.end = next.unwrap_or(text.len());
    }
    all
}

/// Key and value of each statement of a text without headers.
pub fn fields(text: &str) -> Vec<(&str, &str)> {
    let statements = statements(text).into_iter();
    let field = |it: Statement<'_>| match it.what {
        What::Header(_) => None,
        What::Field { value, .. } => {
            let key = text[it.lines.start..value.start].split('=').next()?;
            Some((key.trim(), &text[value]))
        }
    };
    statements.filter_map(field).collect()
}

/// The text with the entries of a list that stands over all headers, `step = [{…}, …]`, as tables at its end, `[[step]]`; comments
/// between them stand over the next one. `None` where there is no such list.
pub fn in_tables(text: &str, name: &str) -> Option<String> {
    let head = blocks(text, "").into_iter().next()?;
    let (_, lines, value) = head.fields.iter().find(|(key, ..)| key == name)?;
    let list = &text[value.clone()];
    let entries = DeValue::parse(list).ok()?;
    let nl = line_break(text);
    let (mut tables, mut from) = (String::new(), 1);
    for entry in entries.get_ref().as_array()? {
        entry.get_ref().as_table()?;
        let span = entry.span();
        tables += &comments(list.get(from..span.start)?, nl);
        tables.extend(["[[", name, "]]", nl]);
        from = span.end;
        let mut rest = list.get(span.start + 1..span.end - 1)?;
        while !rest.trim().is_empty() {
            let end = end_of(rest, |c| c == ',');
            tables.extend([rest[..end].trim(), nl]);
            rest = rest.get(end + 1..).unwrap_or_default();
        }
        tables += nl;
    }
    tables += &comments(list.get(from..list.len() - 1)?, nl);
    let mut text = text.to_owned();
    text.replace_range(lines.clone(), "");
    let gap = if text.ends_with('\n') {
        nl.to_owned()
    } else {
        nl.repeat(2)
    };
    Some(format!("{text}{gap}{}{nl}", tables.trim_end()))
}

/// The comments of what stands between the entries of a list, each in its line.
fn comments(between: &str, nl: &str) -> String {
    let lines = between.lines();
    let comments = lines.filter_map(|line| line.find('#').map(|at| line[at..].trim_end()));
    comments.flat_map(|line| [line, nl]).collect()
}

/// How its lines end.
pub fn line_break(text: &str) -> &'static str {
    if text.contains("\r\n") { "\r\n" } else { "\n" }
}

/// `scenes.two-cuts` of ` scenes . "two-cuts" `.
fn plain(name: &str) -> String {
    let parts = name
        .split('.')
        .map(|part| part.trim().trim_matches(['"', '\'']));
    parts.collect::<Vec<_>>().join(".")
}

fn first_of(key: &str) -> &str {
    key.split('.').next().unwrap_or_default()
}

/// Where the comment that stands right above a line begins.
fn above(text: &str, start: usize) -> usize {
    let mut start = start;
    while let Some(before) = text[..start].strip_suffix('\n') {
        let line = before.rfind('\n').map_or(0, |at| at + 1);
        if !before[line..].trim_start().starts_with('#') {
            break;
        }
        start = line;
    }
    start
}

fn statements(text: &str) -> Vec<Statement<'_>> {
    let mut all = Vec::new();
    let mut at = text.len() - text.trim_start_matches('\u{feff}').len();
    while at < text.len() {
        let line = at;
        let first = at + blanks(&text[at..]);
        let rest = &text[first..];
        if rest.is_empty() || rest.starts_with(['\n', '\r', '#']) {
            at = end_of_line(text, first);
            continue;
        }
        let what = if rest.starts_with('[') {
            at = end_of_line(text, first);
            let header = text[first..at].trim_start_matches('[');
            What::Header(header.split(']').next().unwrap_or_default())
        } else {
            let equals = first + end_of(rest, |c| c == '=');
            let start = (equals + 1).min(text.len());
            let start = start + blanks(&text[start..]);
            let end = start + end_of(&text[start..], |c| c == '\n' || c == '#');
            let value = start..start + text[start..end].trim_end().len();
            at = end_of_line(text, end);
            What::Field {
                key: text[first..equals].trim(),
                value,
            }
        };
        all.push(Statement {
            lines: line..at,
            what,
        });
    }
    all
}

fn blanks(text: &str) -> usize {
    text.len() - text.trim_start_matches([' ', '\t']).len()
}

fn end_of_line(text: &str, at: usize) -> usize {
    text[at..].find('\n').map_or(text.len(), |by| at + by + 1)
}

/// How far it is to the first such character that is in no quotes and in no brackets.
fn end_of(text: &str, is_end: impl Fn(char) -> bool) -> usize {
    let (mut at, mut depth) = (0, 0_usize);
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        if depth == 0 && is_end(c) {
            return at;
        }
        let quote = ["\"\"\"", "'''", "\"", "'"];
        if let Some(quote) = quote.into_iter().find(|quote| rest.starts_with(quote)) {
            at += quoted(rest, quote);
            continue;
        }
        match c {
            '[' | '{' => depth += 1,
            ']' | '}' => depth = depth.saturating_sub(1),
            '#' => at += rest.find('\n').unwrap_or(rest.len()).saturating_sub(1),
            _ => {}
        }
        at += text[at..].chars().next().map_or(0, char::len_utf8);
    }
    text.len()
}

/// How long a text in quotes is that begins here.
fn quoted(text: &str, quote: &str) -> usize {
    let mut at = quote.len();
    while at < text.len() {
        let rest = &text[at..];
        if rest.starts_with(quote) {
            // Up to two more quotes belong to what is quoted.
            let more = rest.len() - rest.trim_start_matches(&quote[..1]).len();
            return at + if quote.len() == 3 { more.min(5) } else { 1 };
        }
        let is_escape = rest.starts_with('\\') && quote.starts_with('"');
        let chars = rest.chars().take(if is_escape { 2 } else { 1 });
        at += chars.map(char::len_utf8).sum::<usize>();
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "lab = \"lines\" # a comment\n\n# about a\n[scenes.a]\nsegments = [\n    [1, 2], # ]\n    [3, 4],\n]\n\n[[step]]\nid = \"one # [[step]]\"\nnote = '''\n[[step]]\n'''\n\n[step.drawn]\nat = \"end\"\n\n# for two\n[[ \"step\" ]]\nid = 'two'\nscene.x = 1";

    #[test]
    fn what_is_quoted_or_in_brackets_is_no_statement() {
        let steps = blocks(TEXT, "step");
        assert_eq!(steps.len(), 2);
        assert_eq!(steps[0].value(TEXT, "id"), Some("\"one # [[step]]\""));
        assert!(TEXT[steps[0].lines.clone()].ends_with("at = \"end\"\n\n"));
        assert!(TEXT[steps[1].lines.clone()].starts_with("# for two\n"));
        let [scene] = &blocks(TEXT, "scenes.a")[..] else {
            panic!("one scene");
        };
        let list = "[\n    [1, 2], # ]\n    [3, 4],\n]";
        assert_eq!(scene.value(TEXT, "segments"), Some(list));
        assert_eq!(fields(TEXT)[0], ("lab", "\"lines\""));
    }

    #[test]
    fn a_list_of_steps_becomes_a_header_for_each() {
        let text = "lab = \"lines\"\nstep = [ # the first\n  {id = \"a\", at = \"end, [1]\"},\n  # the second\n  {id = \"b\", lock = [\"p1\", \"p2\"]},\n]\n\n[scenes.x]\nwindow = [0, 0, 1, 1]\n";
        let tables = in_tables(text, "step").expect("a list");
        let expected = "lab = \"lines\"\n\n[scenes.x]\nwindow = [0, 0, 1, 1]\n\n# the first\n[[step]]\nid = \"a\"\nat = \"end, [1]\"\n\n# the second\n[[step]]\nid = \"b\"\nlock = [\"p1\", \"p2\"]\n";
        assert_eq!(tables, expected);
        assert_eq!(in_tables(&tables, "step"), None);
        assert_eq!(in_tables(TEXT, "step"), None);
    }

    #[test]
    fn a_field_is_changed_where_it_stands_and_all_else_stays() {
        let step = |text: &str| blocks(text, "step").swap_remove(0);
        let changed = step(TEXT).with(TEXT, "id", Some("\"1\""));
        assert_eq!(changed, TEXT.replace("\"one # [[step]]\"", "\"1\""));
        let added = step(TEXT).with(TEXT, "code", Some("\"words\""));
        assert_eq!(
            added,
            TEXT.replacen("'''\n\n", "'''\ncode = \"words\"\n\n", 1)
        );
        assert_eq!(step(&added).with(&added, "code", None), TEXT);
        let last = &blocks(TEXT, "step")[1];
        assert!(
            last.with(TEXT, "at", Some("1"))
                .ends_with("scene.x = 1\nat = 1\n")
        );
        let set = last.with(TEXT, "scene", Some("2"));
        assert!(set.ends_with("id = 'two'\nscene = 2\n"), "{set}");
    }
}
