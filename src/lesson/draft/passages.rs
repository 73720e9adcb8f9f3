//! The passages of a lesson's text: what stands under its title, under each step's heading, and on its card.

use std::ops::Range;

use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag};

use super::statements::line_break;

/// A heading and what follows it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Passage {
    /// The step's id; nothing of the lesson's title.
    pub id: String,
    pub whole: Range<usize>,
    /// The id, and what follows it, to the end of the line.
    pub name: Range<usize>,
    pub title: Range<usize>,
    /// Without the line that ends the heading, and the blank one before what follows.
    pub body: Range<usize>,
}

pub fn passages(text: &str) -> Vec<Passage> {
    let skipped = text.len() - text.trim_start_matches('\u{feff}').len();
    let parser = Parser::new_ext(&text[skipped..], Options::ENABLE_TASKLISTS);
    let heading = |(event, span): (Event<'_>, Range<usize>)| match event {
        Event::Start(Tag::Heading { level, .. }) if level <= HeadingLevel::H2 => {
            Some((level, span.start + skipped))
        }
        _ => None,
    };
    let headings: Vec<_> = parser.into_offset_iter().filter_map(heading).collect();
    let starts = headings.iter().map(|(_, start)| *start);
    let ends = starts.skip(1).chain([text.len()]);
    let of = |((level, start), end): (&(HeadingLevel, usize), usize)| of(text, *level, *start..end);
    headings.iter().zip(ends).map(of).collect()
}

fn of(text: &str, level: HeadingLevel, whole: Range<usize>) -> Passage {
    let line = whole.start
        + text[whole.clone()]
            .find(['\r', '\n'])
            .unwrap_or(whole.len());
    let past =
        |from: usize, signs: &[char]| line - text[from..line].trim_start_matches(signs).len();
    let name = past(whole.start, &['#', ' ', '\t']);
    let colon = text[name..line].find([':', '：']).map(|at| name + at);
    let (name, title) = match (level, colon) {
        (HeadingLevel::H2, Some(at)) => {
            let past_colon = past(at, &[':', '：']);
            let is_spaced = text[past_colon..line].starts_with(' ');
            (name..at, past_colon + usize::from(is_spaced)..line)
        }
        (HeadingLevel::H2, None) => (name..line, line..line),
        _ => (name..name, name..line),
    };
    let nl = line_break(text);
    let mut body = &text[line..whole.end];
    let n_after = if whole.end == text.len() { 1 } else { 2 };
    for _ in 0..2 {
        body = body.strip_prefix(nl).unwrap_or(body);
    }
    let start = whole.end - body.len();
    for _ in 0..n_after {
        body = body.strip_suffix(nl).unwrap_or(body);
    }
    Passage {
        id: text[name.clone()].trim().to_owned(),
        name,
        title,
        body: start..start + body.len(),
        whole,
    }
}

pub fn passage(text: &str, id: &str) -> Option<Passage> {
    passages(text).into_iter().find(|passage| passage.id == id)
}

/// The text with another title of a passage; `None` where that is more than a line.
pub fn with_title(text: &str, id: &str, title: &str) -> Option<String> {
    let mut new = text.to_owned();
    new.replace_range(passage(text, id)?.title, title);
    is_alike(text, &new).then_some(new)
}

/// The text with another body of a passage; `None` where that would begin a passage of its own.
pub fn with_body(text: &str, id: &str, body: &str) -> Option<String> {
    let (nl, old) = (line_break(text), passage(text, id)?);
    let body = body.replace("\r\n", "\n").replace('\n', nl);
    let blank = if old.whole.end == text.len() { "" } else { nl };
    let mut new = text.to_owned();
    new.replace_range(
        old.title.end..old.whole.end,
        &format!("{nl}{nl}{body}{nl}{blank}"),
    );
    is_alike(text, &new).then_some(new)
}

pub fn with_name(text: &str, id: &str, name: &str) -> Option<String> {
    let mut new = text.to_owned();
    new.replace_range(passage(text, id)?.name, name);
    Some(new)
}

/// The text with one passage more, after another one.
pub fn with_passage(text: &str, after: &str, [id, title, body]: [&str; 3]) -> Option<String> {
    let nl = line_break(text);
    let body = body.trim().replace('\n', nl);
    let at = passage(text, after)?.whole.end;
    Some(put(
        text,
        at,
        &format!("## {id}: {title}{nl}{nl}{body}{nl}"),
    ))
}

pub fn without(text: &str, id: &str) -> Option<String> {
    let mut text = text.to_owned();
    text.replace_range(passage(&text, id)?.whole, "");
    Some(text)
}

/// The text with a passage after another one.
pub fn moved(text: &str, id: &str, after: &str) -> Option<String> {
    let whole = passage(text, id)?.whole;
    let rest = without(text, id)?;
    let at = passage(&rest, after)?.whole.end;
    Some(put(&rest, at, &text[whole]))
}

/// The text with a line for each part of a goal, in place of those for its old parts; a part that stays keeps its words, and a new
/// one is put `in_words`.
pub fn with_parts(
    text: &str,
    id: &str,
    [old, new]: [&[String]; 2],
    in_words: impl Fn(&str) -> String,
) -> Option<String> {
    let (nl, body) = (line_break(text), passage(text, id)?.body);
    let mut lines: Vec<String> = Vec::new();
    let (mut nth, mut last) = (0, None);
    for line in text[body.clone()].lines() {
        if line.starts_with(PART) {
            nth += 1;
            if old.get(nth - 1).is_some_and(|part| !new.contains(part)) {
                continue;
            }
            last = Some(lines.len() + 1);
        }
        lines.push(line.to_owned());
    }
    let mut added: Vec<String> = new
        .iter()
        .filter(|part| !old.contains(part))
        .map(|part| format!("{PART} {}", in_words(part)))
        .collect();
    let answer = || {
        lines
            .iter()
            .position(|line| line.starts_with('>'))
            .unwrap_or(lines.len())
    };
    let at = last.unwrap_or_else(answer);
    if last.is_none() && !added.is_empty() {
        added.insert(0, String::new());
        added.push(String::new());
    }
    lines.splice(at..at, added);
    with_body(text, id, lines.join(nl).trim())
}

/// Begins the line of a part of a goal.
const PART: &str = "- [ ]";

/// Puts lines between others, with a blank line before and after them.
pub fn put(text: &str, at: usize, lines: &str) -> String {
    let nl = line_break(text);
    let (before, after) = text.split_at(at);
    let gap = |above: &str| {
        let blank = nl.repeat(2);
        let n = if above.is_empty() || above.ends_with(&blank) {
            0
        } else if above.ends_with(nl) {
            1
        } else {
            2
        };
        nl.repeat(n)
    };
    let between = if after.is_empty() {
        String::new()
    } else {
        gap(lines)
    };
    format!("{before}{}{lines}{between}{after}", gap(before))
}

/// Have both the same passages?
fn is_alike(a: &str, b: &str) -> bool {
    let ids = |text| passages(text).into_iter().map(|it| it.id);
    ids(a).eq(ids(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# Two cuts\n\n## one: First: a cut\n\nIt is *cut*.\n\n```\n## no: heading\n```\n\n## two： 第二\n> so\n\n## card\n\n- rule: cut\n";

    #[test]
    fn passages_are_found_and_code_has_none() {
        let found = passages(TEXT);
        let ids: Vec<&str> = found.iter().map(|it| &*it.id).collect();
        assert_eq!(ids, ["", "one", "two", "card"]);
        assert_eq!(&TEXT[found[0].title.clone()], "Two cuts");
        assert_eq!(&TEXT[found[1].title.clone()], "First: a cut");
        assert_eq!(&TEXT[found[2].title.clone()], "第二");
        assert_eq!(&TEXT[found[2].body.clone()], "> so");
    }

    #[test]
    fn a_passage_changes_and_all_others_stay() {
        let cut = with_title(TEXT, "one", "Cut").expect("a title");
        assert_eq!(cut, TEXT.replace("First: a cut", "Cut"));
        assert_eq!(with_title(TEXT, "one", "a\n\n## b: c"), None);
        assert_eq!(with_body(TEXT, "one", "a\n\n## three: b"), None);
        // What is written letter by letter is read as it was written.
        for (body, id) in [
            ("b\n\n", "two"),
            ("", "one"),
            ("\n b ", "card"),
            ("b\r\n", "two"),
        ] {
            let new = with_body(TEXT, id, body).expect("a body");
            let at = passage(&new, id).expect("it is there").body;
            assert_eq!(new[at], body.replace('\r', ""));
        }
        let added = with_passage(TEXT, "two", ["three", "T", "b"]).expect("one more");
        assert_eq!(
            added,
            TEXT.replace("## card", "## three: T\n\nb\n\n## card")
        );
        assert_eq!(without(&added, "three").as_deref(), Some(TEXT));
        let last = moved(TEXT, "one", "card").expect("moved");
        assert!(last.starts_with("# Two cuts\n\n## two") && last.contains("- rule: cut\n\n## one"));
        let parts = ["a = 1".to_owned(), "b = 2".to_owned()];
        let spelt = |part: &str| format!("`{part}`");
        let one = with_parts(TEXT, "two", [&[], &parts[..1]], spelt).expect("a goal");
        assert!(one.contains("第二\n\n- [ ] `a = 1`\n\n> so\n"), "{one}");
        let both = with_parts(&one, "two", [&parts[..1], &parts], spelt).expect("two parts");
        assert!(
            both.contains("- [ ] `a = 1`\n- [ ] `b = 2`\n\n> so\n"),
            "{both}"
        );
        let none = with_parts(&both, "two", [&parts, &[]], spelt).expect("no goal");
        assert!(!none.contains("- [ ]"));
        assert_eq!(
            with_name(TEXT, "one", "1"),
            Some(TEXT.replace("## one:", "## 1:"))
        );
    }
}
