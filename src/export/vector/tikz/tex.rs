//! Words as TeX sets them: what is mathematics in mathematics.

use std::fmt::Write;

/// Signs that are set in mathematics, and how.
const SIGNS: [(char, &str); 43] = [
    ('−', "-"),
    ('=', "="),
    ('<', "<"),
    ('>', ">"),
    ('+', "+"),
    ('≤', "\\le "),
    ('≥', "\\ge "),
    ('≠', "\\ne "),
    ('≈', "\\approx "),
    ('·', "\\cdot "),
    ('×', "\\times "),
    ('∞', "\\infty "),
    ('→', "\\to "),
    ('←', "\\leftarrow "),
    ('∈', "\\in "),
    ('∧', "\\wedge "),
    ('∨', "\\vee "),
    ('∩', "\\cap "),
    ('∪', "\\cup "),
    ('√', "\\surd "),
    ('°', "^\\circ "),
    ('Δ', "\\Delta "),
    ('α', "\\alpha "),
    ('β', "\\beta "),
    ('′', "'"),
    ('²', "{}^2"),
    ('³', "{}^3"),
    ('⁰', "{}^0"),
    ('¹', "{}^1"),
    ('⁴', "{}^4"),
    ('⁵', "{}^5"),
    ('⁶', "{}^6"),
    ('⁷', "{}^7"),
    ('⁸', "{}^8"),
    ('⁹', "{}^9"),
    ('⁻', "{}^-"),
    ('½', "\\tfrac12 "),
    ('¼', "\\tfrac14 "),
    ('ₙ', "{}_n"),
    ('ᵢ', "{}_i"),
    ('±', "\\pm "),
    ('|', "|"),
    ('☐', "\\Box "),
];

/// Signs that stand between two parts of a formula, and make their own room.
const BETWEEN: &str = "−=<>+≤≥≠≈·×→←∈∧∨∩∪±/";

fn sign(c: char) -> Option<&'static str> {
    let known = SIGNS.iter().find(|(sign, _)| *sign == c);
    known.map(|(_, tex)| *tex)
}

fn subscript(c: char) -> Option<u32> {
    let digit = (c as u32).checked_sub('₀' as u32)?;
    (digit < 10).then_some(digit)
}

/// Text in which nothing is a command.
pub fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '^' => out.push_str("\\textasciicircum{}"),
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                out.push('\\');
                out.push(c);
            }
            '\n' => out.push_str("\\\\"),
            '\u{2003}' => out.push_str("\\quad "),
            '–' => out.push_str("--"),
            c => match (sign(c), subscript(c)) {
                (Some(tex), _) => {
                    let _ = write!(out, "$\\mathsf{{{tex}}}$");
                }
                (None, Some(digit)) => {
                    let _ = write!(out, "$_{digit}$");
                }
                (None, None) => out.push(c),
            },
        }
    }
    out
}

/// Running text: words that have signs or subscripts, single letters and numbers are mathematics, and neighbours of them are set as one
/// formula.
pub fn set(text: &str) -> String {
    let mut out = String::new();
    let (mut is_open, mut before) = (false, "");
    for (i, word) in text.split(' ').enumerate() {
        let (head, rest) = split_head(word);
        let (body, tail) = split_tail(rest);
        let is_formula = is_mathematics(body);
        let is_between = |word: &str| word.chars().count() == 1 && BETWEEN.contains(word);
        if is_formula && is_open && head.is_empty() {
            let makes_room = is_between(body) || is_between(before);
            out.push_str(if makes_room { " " } else { "\\ " });
        } else {
            if is_open {
                out.push('$');
            }
            if i > 0 {
                out.push(' ');
            }
            out.push_str(&escaped(head));
            if is_formula {
                out.push('$');
            }
        }
        (is_open, before) = (is_formula, body);
        if is_formula {
            out.push_str(&mathematics(body));
        } else {
            out.push_str(&escaped(body));
        }
        if !tail.is_empty() {
            if is_open {
                out.push('$');
                is_open = false;
            }
            out.push_str(&escaped(tail));
        }
    }
    if is_open {
        out.push('$');
    }
    out
}

fn split_head(word: &str) -> (&str, &str) {
    let at = word.find(|c| !matches!(c, '“' | '"' | '«' | '¿' | '¡'));
    word.split_at(at.unwrap_or(word.len()))
}

fn split_tail(word: &str) -> (&str, &str) {
    let body = word.trim_end_matches([',', '.', ':', ';', '?', '!', '”', '"', '»']);
    word.split_at(body.len())
}

fn is_mathematics(word: &str) -> bool {
    let is_sign = |c: char| sign(c).is_some() || subscript(c).is_some() || c == '_' || c == '/';
    let letters = word.chars().filter(|c| c.is_alphabetic()).count();
    let has_digit = word.contains(|c: char| c.is_ascii_digit());
    let bare = word.trim_matches(['(', ')', '[', ']']);
    let is_one = bare.chars().count() == 1 && bare.chars().all(|c| c.is_ascii_alphabetic());
    let is_word = letters > 3 && !word.contains(is_sign);
    !word.is_empty()
        && word.is_char_boundary(word.len())
        && !is_word
        && (word.contains(is_sign)
            || (has_digit && letters < 2)
            || (is_one && !matches!(bare, "a" | "A" | "e" | "o" | "O" | "y" | "I")))
}

fn mathematics(word: &str) -> String {
    if let Some((above, below)) = quotient(word) {
        let minus = if above.starts_with('−') { "-" } else { "" };
        let above = above.trim_start_matches('−');
        return format!("{minus}\\frac{{{}}}{{{}}}", row(above), row(below));
    }
    row(word)
}

/// Of a plain number by another, with a sign or without.
fn quotient(word: &str) -> Option<(&str, &str)> {
    let (above, below) = word.split_once('/')?;
    let is_name = |part: &str| {
        !part.is_empty()
            && part
                .chars()
                .all(|c| c.is_alphanumeric() || matches!(c, '−' | '_') || subscript(c).is_some())
    };
    (is_name(above) && is_name(below)).then_some((above, below))
}

fn row(word: &str) -> String {
    let mut out = String::new();
    let mut chars = word.chars().peekable();
    let mut is_sub = false;
    while let Some(c) = chars.next() {
        let was_sub = std::mem::replace(&mut is_sub, c == '_');
        match c {
            '_' => {
                if was_sub {
                    out.push_str("{}");
                }
                let mut name = String::new();
                while let Some(c) =
                    chars.next_if(|c| c.is_alphanumeric() && subscript(*c).is_none())
                {
                    name.push(c);
                }
                let _ = match &*name {
                    "" => write!(out, "\\_"),
                    "min" | "max" => write!(out, "_{{\\{name}}}"),
                    _ => write!(out, "_{{\\mathrm{{{name}}}}}"),
                };
            }
            c if c.is_alphabetic() && sign(c).is_none() => {
                let mut name = c.to_string();
                while let Some(c) = chars
                    .next_if(|c| c.is_alphabetic() && sign(*c).is_none() && subscript(*c).is_none())
                {
                    name.push(c);
                }
                let _ = match &*name {
                    "min" | "max" => write!(out, "\\{name}"),
                    name if name.chars().count() == 1 => write!(out, "{name}"),
                    name => write!(out, "\\mathrm{{{name}}}"),
                };
            }
            c => match (sign(c), subscript(c)) {
                (Some(tex), _) => out.push_str(tex),
                (None, Some(digit)) => {
                    let mut digits = digit.to_string();
                    while let Some(digit) = chars.peek().copied().and_then(subscript) {
                        digits.push_str(&digit.to_string());
                        chars.next();
                    }
                    // A letter may have one already.
                    let base = if was_sub { "{}" } else { "" };
                    is_sub = true;
                    let _ = match digits.len() {
                        1 => write!(out, "{base}_{digits}"),
                        _ => write!(out, "{base}_{{{digits}}}"),
                    };
                }
                (None, None) => out.push_str(&escaped(&c.to_string())),
            },
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_mathematics_and_words_are_words() {
        for (text, expected) in [
            ("left edge", "left edge"),
            ("P₁", "$P_1$"),
            ("u_min = 1/4", "$u_{\\min} = \\frac{1}{4}$"),
            ("x = −1 < 0, outside", "$x = -1 < 0$, outside"),
            ("−5/2", "$-\\frac{5}{2}$"),
            ("50 % & more_", "$50$ \\% \\& $\\mathrm{more}\\_$"),
            ("x₁₂", "$x_{12}$"),
            ("p_a₁", "$p_{\\mathrm{a}}{}_1$"),
            ("10⁻⁶", "$10{}^-{}^6$"),
            ("Q₁Q₂ does not lie", "$Q_1Q_2$ does not lie"),
            ("min(u_max, r)", "$\\min(u_{\\max}$, $r)$"),
        ] {
            assert_eq!(set(text), expected, "{text}");
        }
        assert_eq!(escaped("a_b {1}"), "a\\_b \\{1\\}");
    }
}
