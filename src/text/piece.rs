//! Text for setting: words, subscripts and quotients, before anything is measured.

#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Piece {
    Text(String),
    Sub(String),
    Over {
        num: Vec<Piece>,
        den: Vec<Piece>,
    },
    /// What plain text needs, and set text does not: a quotient's slash and parentheses, the `_` before a subscript.
    Unset(&'static str),
    /// A coordinate, a formula, a term: stays on one line as long as it fits on one.
    Kept(Vec<Piece>),
}

impl Piece {
    /// Words with the subscripts that are in them: a letter by itself, `_`, and a run of letters and digits.
    pub fn words(text: &str) -> Vec<Self> {
        let mut pieces = Vec::new();
        let mut rest = text;
        while let Some((base_end, sub_end)) = subscript(rest) {
            pieces.push(Self::Text(rest[..base_end].to_owned()));
            pieces.push(Self::Unset("_"));
            pieces.push(Self::Sub(rest[base_end + 1..sub_end].to_owned()));
            rest = &rest[sub_end..];
        }
        if !rest.is_empty() {
            pieces.push(Self::Text(rest.to_owned()));
        }
        pieces
    }

    pub const RELATIONS: [char; 7] = ['=', '≈', '≠', '<', '>', '≤', '≥'];

    pub fn steps(formula: &[Self]) -> Vec<Vec<Self>> {
        let (mut steps, mut step) = (Vec::new(), Vec::new());
        let words = |text: &str| (!text.is_empty()).then(|| Self::Text(text.to_owned()));
        for piece in formula {
            let Self::Text(text) = piece else {
                step.push(piece.clone());
                continue;
            };
            let mut from = 0;
            for (at, _) in text.match_indices(Self::RELATIONS) {
                step.extend(words(&text[from..at]));
                steps.push(std::mem::take(&mut step));
                from = at;
            }
            step.extend(words(&text[from..]));
        }
        steps.push(step);
        steps
    }

    pub fn plain(pieces: &[Self]) -> String {
        let mut text = String::new();
        write_plain(pieces, &mut text);
        text
    }
}

fn write_plain(pieces: &[Piece], text: &mut String) {
    for piece in pieces {
        match piece {
            Piece::Text(part) | Piece::Sub(part) => text.push_str(part),
            Piece::Unset(part) => text.push_str(part),
            Piece::Kept(inner) => write_plain(inner, text),
            Piece::Over { num, den } => {
                write_plain(num, text);
                write_plain(den, text);
            }
        }
    }
}

fn subscript(text: &str) -> Option<(usize, usize)> {
    text.match_indices('_').map(|(at, _)| at).find_map(|at| {
        let mut before = text[..at].chars().rev();
        let is_letter = before.next().is_some_and(char::is_alphabetic);
        let is_inner = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let is_symbol = is_letter && !before.next().is_some_and(is_inner);
        let run = &text[at + 1..];
        let end = run.find(|c: char| !c.is_ascii_alphanumeric());
        let n = end.unwrap_or(run.len());
        (is_symbol && n > 0).then_some((at, at + 1 + n))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_an_underscore_and_a_run_are_a_symbol_with_its_subscript() {
        for (text, subs) in [
            ("u_min ← max(u_min, q/p)", vec!["min", "min"]),
            ("d_S = 3, d_P2", vec!["S", "P2"]),
            ("从u_max到1", vec!["max"]),
            ("P₁ − E", vec![]),
            ("path/to_file, _x, a_, n_edges_left", vec!["edges"]),
        ] {
            let pieces = Piece::words(text);
            let found = pieces.iter().filter_map(|piece| match piece {
                Piece::Sub(sub) => Some(&sub[..]),
                _ => None,
            });
            assert_eq!(found.collect::<Vec<_>>(), subs, "{text}");
            assert_eq!(Piece::plain(&pieces), text);
        }
    }

    #[test]
    fn a_formula_has_a_step_for_each_relation() {
        let text = |text: &str| Piece::Text(text.to_owned());
        let over = Piece::Over {
            num: vec![text("q")],
            den: vec![text("p")],
        };
        let end = [" = (1 + 2)", " ", "≈ 3"].map(text);
        let formula = [vec![text("t = "), over], end.to_vec()].concat();
        let steps = Piece::steps(&formula);
        let steps: Vec<String> = steps.iter().map(|step| Piece::plain(step)).collect();
        assert_eq!(steps, ["t ", "= qp ", "= (1 + 2) ", "≈ 3"]);
    }
}
