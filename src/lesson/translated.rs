//! From which English each translation was made: `translated.toml` keeps a fingerprint of it, step by step.

use std::{collections::BTreeMap, fmt::Write as _};

use super::prelude::*;

/// What a lesson keeps beside its texts. A lesson without this file is not looked at.
pub const TRANSLATED_FILE: &str = "translated.toml";

/// Of each section of a text, by its step: its fingerprint, and where its heading stands.
fn sections(text: &str) -> BTreeMap<&str, (String, Range<usize>)> {
    let starts = text.match_indices("## ").filter(|&(at, _)| {
        let before = &text[..at];
        before.is_empty() || before.ends_with('\n')
    });
    let starts: Vec<usize> = starts.map(|(at, _)| at).collect();
    let ends = starts.iter().copied().skip(1).chain([text.len()]);
    let section = |(start, end): (&usize, usize)| {
        let section = &text[*start..end];
        let heading = section.lines().next().unwrap_or_default();
        let id = heading[3..].split([':', '：']).next()?.trim();
        let fingerprint = format!("{:08x}", fingerprint(section));
        Some((id, (fingerprint, *start..start + heading.len())))
    };
    starts.iter().zip(ends).filter_map(section).collect()
}

/// FNV-1a, whatever the white space is.
fn fingerprint(text: &str) -> u32 {
    let words = text
        .split_whitespace()
        .flat_map(|word| word.bytes().chain([b' ']));
    words.fold(0x811c_9dc5, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}

/// What `translated.toml` holds once these languages are translated from this English.
pub fn translated(english: &str, langs: &[Lang]) -> String {
    let mut file = String::new();
    for lang in langs {
        let _ = writeln!(file, "[{lang}]");
        for (id, (fingerprint, _)) in sections(english) {
            let _ = writeln!(file, "{id} = \"{fingerprint}\"");
        }
        file.push('\n');
    }
    file.truncate(file.trim_end().len());
    file + "\n"
}

type Known = BTreeMap<Lang, BTreeMap<String, String>>;

/// The sections of a translation of which the English has become another.
pub(super) fn stale(known: &[u8], english: &str, lang: Lang, sink: &Sink<'_>) {
    let known = str::from_utf8(known).ok();
    let known: Option<Known> = known.and_then(|text| toml::from_str(text).ok());
    let known = known.unwrap_or_default().remove(&lang).unwrap_or_default();
    let own = sections(&sink.source.text);
    for (id, (fingerprint, _)) in sections(english) {
        if known.get(id) == Some(&fingerprint) {
            continue;
        }
        if let Some((_, heading)) = own.get(id) {
            let message = Message::new("problem-stale-translation").with("name", clipped(id));
            let expected = Message::new("expect-translated");
            sink.warning(heading.clone(), Diagnostic::new(message).noting(expected));
        }
    }
}
