//! "Did you mean …?": the known name that a misspelt one is nearest to, and how names are quoted.

use super::message::Message;

/// The known name within a third of the given one's length, at least one edit, at most three; else the first with a word that
/// begins like it.
pub(crate) fn nearest<'n>(name: &str, known: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let given: Vec<char> = name.to_lowercase().chars().collect();
    // Longer than any name there is: not a slip of the finger.
    if given.len() > 64 {
        return None;
    }
    let allowed = (given.len() / 3).clamp(1, 3);
    let known: Vec<&str> = known.into_iter().collect();
    let near = known
        .iter()
        .map(|known| (distance(&given, &known.chars().collect::<Vec<_>>()), *known))
        .filter(|&(distance, _)| distance <= allowed)
        .min_by_key(|&(distance, _)| distance);
    let begun: String = given.into_iter().collect();
    let begins = |known: &str| known.split('-').any(|word| word.starts_with(&begun));
    let part = || known.iter().copied().find(|known| begins(known));
    near.map(|(_, known)| known)
        .or_else(|| part().filter(|_| begun.len() >= FEWEST_BEGUN))
}

/// Fewer letters begin too many words.
const FEWEST_BEGUN: usize = 3;

/// Insertions, deletions, replacements and swaps of neighbours (optimal string alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    rows[0] = (0..=b.len()).collect();
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

/// The most names that an error lists.
const MAX_NAMES: usize = 60;

/// What may have been meant, then all that is known.
pub(crate) fn suggestion(meant: Option<&str>, known: &[&str]) -> Vec<Message> {
    let meant = meant.map(|name| Message::new("expect-did-you-mean").with("name", clipped(name)));
    let mut names: Vec<String> = known.iter().take(MAX_NAMES).copied().map(clipped).collect();
    if known.len() > MAX_NAMES {
        names.push("…".to_owned());
    }
    let known =
        (!names.is_empty()).then(|| Message::new("expect-one-of").with("names", names.join(", ")));
    meant.into_iter().chain(known).collect()
}

/// A text without what could be an escape sequence: those of a file or an argument must not reach a terminal.
pub(crate) fn printable(text: &str) -> String {
    text.replace(|c: char| c.is_control() && c != '\n', "\u{fffd}")
}

/// A name from a file as a message quotes it: not longer than a line.
pub(crate) fn clipped(name: &str) -> String {
    const MAX_CHARS: usize = 60;
    match name.char_indices().nth(MAX_CHARS) {
        Some((end, _)) => format!("{}…", &name[..end]),
        None => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_recognised_and_other_words_are_not() {
        let known = ["window", "segments", "focus", "at"];
        for (given, expected) in [
            ("windw", Some("window")),
            ("Window", Some("window")),
            ("segmetns", Some("segments")),
            ("segment", Some("segments")),
            ("foucs", Some("focus")),
            ("colour", None),
            ("x", None),
            ("seg", Some("segments")),
        ] {
            assert_eq!(nearest(given, known), expected, "{given}");
        }
        let known = ["cohen-sutherland", "liang-barsky", "cohen-sutherland-3d"];
        for (given, expected) in [
            ("cohen", Some("cohen-sutherland")),
            ("Barsky", Some("liang-barsky")),
            ("ba", None),
            ("arsky", None),
        ] {
            assert_eq!(nearest(given, known), expected, "{given}");
        }
    }
}
