//! Columns of text for a terminal: wrapped between words, aligned, with wide characters counted as two.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

const GAP: usize = 2;

/// A cell: paragraphs that begin on a line of their own.
pub(super) type Cell = Vec<String>;

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Align {
    Left,
    Right,
}

/// Sets rows in columns, at most `width` wide where words allow it: line by line, each row given up when it is set.
pub(super) fn set<const N: usize>(
    rows: Vec<[Cell; N]>,
    align: [Align; N],
    width: usize,
) -> impl Iterator<Item = String> {
    let natural: [usize; N] = std::array::from_fn(|i| {
        let paragraphs = rows.iter().flat_map(|row| &row[i]);
        paragraphs.map(|p| p.width()).max().unwrap_or(0)
    });
    let widths = fit(natural, width.saturating_sub(GAP * N.saturating_sub(1)));
    rows.into_iter().flat_map(move |row| {
        let cells: [Vec<String>; N] = std::array::from_fn(|i| {
            let wrapped = row[i].iter().flat_map(|p| wrap(p, widths[i]));
            wrapped.collect()
        });
        let height = cells.iter().map(Vec::len).max().unwrap_or(0);
        (0..height).map(move |y| {
            let texts = cells
                .each_ref()
                .map(|lines| lines.get(y).map_or("", String::as_str));
            line(texts, align, widths)
        })
    })
}

fn line<const N: usize>(texts: [&str; N], align: [Align; N], widths: [usize; N]) -> String {
    let mut line = String::new();
    for i in 0..N {
        let pad = " ".repeat(widths[i].saturating_sub(texts[i].width()));
        let gap = " ".repeat(if i > 0 { GAP } else { 0 });
        let parts = match align[i] {
            Align::Left => [&gap, texts[i], &pad],
            Align::Right => [&gap, &pad, texts[i]],
        };
        line.extend(parts);
    }
    line.truncate(line.trim_end().len());
    line
}

/// Narrows the widest columns, and no others, until all fit.
fn fit<const N: usize>(mut widths: [usize; N], available: usize) -> [usize; N] {
    while widths.iter().sum::<usize>() > available {
        let Some(widest) = widths.iter_mut().max() else {
            break;
        };
        if *widest <= 1 {
            break;
        }
        *widest -= 1;
    }
    widths
}

/// Breaks a paragraph into lines of at most `width` columns: at spaces, beside wide characters (but not
/// before closing punctuation), and inside a word only where it is wider than a line.
fn wrap(paragraph: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut used = 0;
    for Unbroken { text, space } in pieces(paragraph) {
        let (n, gap) = (text.width(), usize::from(space && used > 0));
        if used > 0 && used + gap + n > width {
            lines.push(String::new());
            used = 0;
        } else if gap > 0 {
            push(&mut lines, " ");
            used += 1;
        }
        for c in text.chars() {
            let n = c.width().unwrap_or(0);
            if used > 0 && used + n > width {
                lines.push(String::new());
                used = 0;
            }
            push(&mut lines, c.encode_utf8(&mut [0; 4]));
            used += n;
        }
    }
    lines
}

fn push(lines: &mut [String], text: &str) {
    if let Some(line) = lines.last_mut() {
        line.push_str(text);
    }
}

struct Unbroken {
    text: String,
    space: bool,
}

fn pieces(paragraph: &str) -> Vec<Unbroken> {
    let mut pieces: Vec<Unbroken> = Vec::new();
    // Words of the clause so far, for `x = 1`; open parentheses, for `(1, 2)`.
    let (mut n_words, mut depth, mut last_word) = (0, 0, "");
    for word in paragraph.split_whitespace() {
        let joins = depth > 0
            || is_relation(last_word)
            || (is_relation(word) && n_words == 1 && last_word.width() < SHORT);
        for (i, part) in parts(word).into_iter().enumerate() {
            match pieces.last_mut() {
                Some(piece) if i == 0 && joins && piece.text.width() < LONG => {
                    piece.text.push(' ');
                    piece.text += &part;
                }
                _ => pieces.push(Unbroken {
                    text: part,
                    space: i == 0,
                }),
            }
        }
        n_words = if word.ends_with([',', ';', ':']) {
            0
        } else {
            n_words + 1
        };
        for c in word.chars() {
            match c {
                '(' => depth += 1,
                ')' => depth = i32::max(depth - 1, 0),
                _ => {}
            }
        }
        last_word = word;
    }
    pieces
}

/// The name before the first `=` stays beside it up to this width, a longer one may part from it.
const SHORT: usize = 8;
/// What belongs together is kept together up to this width.
const LONG: usize = 16;

/// `= −3/8` is not parted.
fn is_relation(word: &str) -> bool {
    matches!(word, "=" | "≈" | "≠" | "<" | ">" | "≤" | "≥")
}

/// A word, parted beside wide characters.
fn parts(word: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    let mut before = None::<char>;
    for c in word.chars() {
        let joins = before.is_some_and(|b| closes(c) || opens(b) || (is_narrow(b) && is_narrow(c)));
        match parts.last_mut() {
            Some(part) if joins => part.push(c),
            _ => parts.push(c.to_string()),
        }
        before = Some(c);
    }
    parts
}

fn is_narrow(c: char) -> bool {
    c.width() != Some(2)
}

fn closes(c: char) -> bool {
    "，。、；：？！）」』】》”’".contains(c)
}

fn opens(c: char) -> bool {
    "（「『【《“‘".contains(c)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stay_whole_and_no_line_is_too_wide() {
        assert_eq!(wrap("both ends lie above", 9), ["both ends", "lie above"]);
        assert_eq!(wrap("abcdefgh", 3), ["abc", "def", "gh"]);
        assert_eq!(wrap("", 3), [""]);
    }

    #[test]
    fn wide_characters_count_as_two_and_punctuation_does_not_begin_a_line() {
        assert_eq!(wrap("端点在左侧，接受", 10), ["端点在左", "侧，接受"]);
        assert_eq!(wrap("点 P₁ 在内", 6), ["点 P₁", "在内"]);
    }

    #[test]
    fn equations_and_points_stay_whole() {
        let row = "left edge: p = −4, q = −1, r = 1/4";
        assert_eq!(wrap(row, 30), ["left edge: p = −4, q = −1,", "r = 1/4"]);
        let formula = "y = (−1 · 3 + 1.5 · 1) / 4 = −3/8";
        assert_eq!(wrap(formula, 30), ["y = (−1 · 3 + 1.5 · 1) / 4", "= −3/8"]);
        let accept = "visible from (−1, −3/8) to";
        assert_eq!(wrap(accept, 18), ["visible from", "(−1, −3/8) to"]);
    }

    #[test]
    fn only_the_widest_columns_are_narrowed() {
        assert_eq!(fit([4, 50, 30], 60), [4, 28, 28]);
        assert_eq!(fit([4, 10, 10], 60), [4, 10, 10]);
    }
}
