//! What is to be set, character by character: where each belongs, and whether a line may break before it.

use crate::text::Piece;

use super::span::Span;

/// One character.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Char {
    /// Which it is.
    pub c: char,
    /// Index of its span.
    pub span: usize,
    /// Is it set, and how?
    pub form: Form,
    /// Which quotient it belongs to, counted from the start, and on which side of the line it stands.
    pub quotient: Option<(usize, Half)>,
    /// May a line begin with it?
    pub gap: Gap,
    /// How many pieces that are kept whole it is in.
    depth: usize,
}

/// How a character is set.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    /// In full size.
    Full,
    /// Lowered and smaller.
    Sub,
    /// Not at all: it is there for those who read or copy plain text.
    Unset,
}

/// Of a quotient.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Half {
    /// Above the line.
    Num,
    /// Below it.
    Den,
}

/// What stands before a character: the first kinds are better places to break a line at.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Gap {
    /// Between words of a sentence.
    Words,
    /// Before a relation in a formula.
    Relation,
    /// Before a term of a sum.
    Term,
    /// Any other space, and any two ideographs.
    Any,
    /// None.
    Closed,
}

/// Spans as characters.
pub struct Script<'a> {
    /// Faces and colours.
    pub spans: &'a [Span],
    /// In the order of plain text.
    pub chars: Vec<Char>,
    n_quotients: usize,
}

impl<'a> Script<'a> {
    pub fn new(spans: &'a [Span]) -> Self {
        let mut script = Self {
            spans,
            chars: Vec::new(),
            n_quotients: 0,
        };
        for (i, span) in spans.iter().enumerate() {
            script.pieces(&span.pieces, i, 0, None);
        }
        script
    }

    fn pieces(
        &mut self,
        pieces: &[Piece],
        span: usize,
        depth: usize,
        quotient: Option<(usize, Half)>,
    ) {
        for piece in pieces {
            let (text, form) = match piece {
                Piece::Text(text) => (&text[..], Form::Full),
                Piece::Sub(text) => (&text[..], Form::Sub),
                Piece::Unset(text) => (*text, Form::Unset),
                Piece::Kept(inner) => {
                    self.pieces(inner, span, depth + 1, quotient);
                    continue;
                }
                Piece::Over { num, den } => {
                    let nth = self.n_quotients;
                    self.n_quotients += 1;
                    self.pieces(num, span, depth + 1, Some((nth, Half::Num)));
                    self.pieces(den, span, depth + 1, Some((nth, Half::Den)));
                    continue;
                }
            };
            for c in text.chars() {
                let char = Char {
                    c,
                    span,
                    form,
                    quotient,
                    gap: Gap::Closed,
                    depth,
                };
                let gap = gap(&self.chars, &char);
                self.chars.push(Char { gap, ..char });
            }
        }
    }
}

/// What stands between these and the next character.
fn gap(chars: &[Char], char: &Char) -> Gap {
    let Some(before) = chars.last() else {
        return Gap::Closed;
    };
    let nth = |char: &Char| char.quotient.map(|(nth, _)| nth);
    let is_in_quotient = char.quotient.is_some() && nth(before) == nth(char);
    if is_in_quotient || char.form != Form::Full || !is_open(before.c, char.c) {
        return Gap::Closed;
    }
    // Formulas are in sentences, too.
    let is_after = chars.iter().rev().nth(1).is_some_and(|char| {
        let is_sign = OPERATORS.contains(char.c) || Piece::RELATIONS.contains(&char.c);
        is_sign && before.c == ' '
    });
    match before.depth.min(char.depth) {
        0 | 1 if !is_after && TERMS.contains(char.c) => Gap::Term,
        0 | 1 if is_after || OPERATORS.contains(char.c) => Gap::Any,
        0 | 1 if Piece::RELATIONS.contains(&char.c) => Gap::Relation,
        0 => Gap::Words,
        _ => Gap::Any,
    }
}

const TERMS: &str = "+−";
const OPERATORS: &str = "+−·/×←";
/// No line begins with these,
const CLOSING: &str = "，。、；：！？）》」』”’…";
/// and none ends with these.
const OPENING: &str = "（《「『“‘";

/// After a space, and on either side of an ideograph.
fn is_open(before: char, c: char) -> bool {
    if before == ' ' || c == ' ' {
        return before == ' ' && c != ' ';
    }
    let is_wide = |c| matches!(c, '\u{2e80}'..='\u{9fff}' | '\u{f900}'..='\u{faff}' | '\u{ff00}'..='\u{ffef}');
    (is_wide(before) || is_wide(c)) && !CLOSING.contains(c) && !OPENING.contains(before)
}
