//! Where a text mentions terms of the glossary: the first mention of each in a step is marked.

use std::{collections::HashMap, ops::Range, sync::OnceLock};

use crate::text::Lang;

use super::{
    glossary::{Glossary, Word, glossary},
    markdown::{Block, Inline},
    problem::is_wide,
};

/// One language's forms by their first character, the longest first.
type Index = HashMap<char, Vec<(Vec<char>, &'static Word)>>;

fn index(lang: Lang) -> Option<&'static Index> {
    static INDICES: [OnceLock<Index>; Lang::ALL.len()] =
        [const { OnceLock::new() }; Lang::ALL.len()];
    let glossary = glossary(lang)?;
    Some(INDICES[lang as usize].get_or_init(|| of_glossary(glossary)))
}

fn of_glossary(glossary: &'static Glossary) -> Index {
    let mut index = Index::new();
    for word in glossary.values() {
        for form in &word.forms {
            let chars: Vec<char> = form.chars().map(lower).collect();
            if let Some(&first) = chars.first() {
                index.entry(first).or_default().push((chars, word));
            }
        }
    }
    for forms in index.values_mut() {
        forms.sort_by_key(|(form, _)| std::cmp::Reverse(form.len()));
    }
    index
}

/// Of what has several lower-case letters, the first.
fn lower(c: char) -> char {
    c.to_lowercase().next().unwrap_or(c)
}

/// Words of Chinese are not parted by spaces.
fn is_letter(c: char) -> bool {
    c.is_alphabetic() && !is_wide(c)
}

/// Where the text mentions terms: from which character to which, and the term. Longer forms go first, and none overlap.
fn mentions(text: &[char], lang: Lang) -> Vec<([usize; 2], &'static Word)> {
    let Some(index) = index(lang) else {
        return Vec::new();
    };
    let (mut found, mut at) = (Vec::new(), 0);
    while at < text.len() {
        let is_inner =
            |i: usize| i > 0 && i < text.len() && is_letter(text[i - 1]) && is_letter(text[i]);
        let fits = |form: &[char]| {
            let rest = &text[at..];
            rest.len() >= form.len()
                && rest
                    .iter()
                    .zip(form)
                    .all(|(&c, &wanted)| lower(c) == wanted)
                && !is_inner(at + form.len())
        };
        let forms = index.get(&lower(text[at])).filter(|_| !is_inner(at));
        match forms.into_iter().flatten().find(|(form, _)| fits(form)) {
            Some((form, word)) => {
                found.push(([at, at + form.len()], *word));
                at += form.len();
            }
            None => at += 1,
        }
    }
    found
}

/// Marks the first mention of each term in a step's text.
pub(super) fn mark(blocks: &mut [Block], lang: Lang) {
    mark_new(blocks, lang, &mut Vec::new());
}

fn mark_new(blocks: &mut [Block], lang: Lang, known: &mut Vec<&'static Word>) {
    for block in blocks {
        match block {
            Block::Paragraph(text) | Block::ListItem { text, .. } | Block::Goal { text, .. } => {
                *text = text
                    .drain(..)
                    .flat_map(|part| parts(part, lang, known))
                    .collect();
            }
            Block::Answer(inner) => mark_new(inner, lang, known),
            Block::Code(_) | Block::Note(_) | Block::Wait => {}
        }
    }
}

/// A piece of text, parted where it mentions a term for the first time.
fn parts(whole: Inline, lang: Lang, known: &mut Vec<&'static Word>) -> Vec<Inline> {
    if whole.code || whole.control.is_some() {
        return vec![whole];
    }
    let chars: Vec<char> = whole.text.chars().collect();
    let mut parts = Vec::new();
    let mut from = 0;
    let part = |range: Range<usize>, term| Inline {
        text: chars[range].iter().collect(),
        term,
        ..whole.clone()
    };
    for ([start, end], word) in mentions(&chars, lang) {
        if known.contains(&word) {
            continue;
        }
        known.push(word);
        if from < start {
            parts.push(part(from..start, None));
        }
        parts.push(part(start..end, Some(word)));
        from = end;
    }
    if from < chars.len() {
        parts.push(part(from..chars.len(), None));
    }
    parts
}
