//! What is to be set, character by character: where each belongs, and where lines break.

use std::ops::Range;

use egui::{Color32, FontId};

use crate::text::{Catalog, Piece, Value};

#[derive(Clone, Debug)]
pub struct Span {
    pub pieces: Vec<Piece>,
    pub font: FontId,
    pub colour: Color32,
    pub italics: bool,
}

impl Span {
    pub const fn slanted(mut self, italics: bool) -> Self {
        self.italics = italics;
        self
    }

    pub const fn upright(pieces: Vec<Piece>, font: FontId, colour: Color32) -> Self {
        Self {
            pieces,
            font,
            colour,
            italics: false,
        }
    }

    pub fn value(catalog: &Catalog, value: &Value, font: FontId, colour: Color32) -> Self {
        Self::upright(catalog.value_pieces(value), font, colour)
    }

    pub fn text(text: &str, font: FontId, colour: Color32) -> Self {
        Self::upright(Piece::words(text), font, colour)
    }
}

impl Span {
    /// How many characters are set of it.
    pub fn n_chars(&self) -> usize {
        fn count(pieces: &[Piece]) -> usize {
            let of_piece = |piece: &Piece| match piece {
                Piece::Text(text) | Piece::Sub(text) => text.chars().filter(|c| *c != '\n').count(),
                Piece::Over { num, den } => count(num) + count(den),
                Piece::Kept(inner) => count(inner),
                Piece::Unset(_) => 0,
            };
            pieces.iter().map(of_piece).sum()
        }
        count(&self.pieces)
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Char {
    pub c: char,
    pub span: usize,
    pub form: Form,
    /// Which quotient it belongs to, counted from the start, and on which side of the line it stands.
    pub quotient: Option<(usize, Half)>,
    pub gap: Gap,
    depth: usize,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Form {
    Full,
    Sub,
    Unset,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Half {
    Num,
    Den,
}

/// What stands before a character: the first kinds are better places to break a line at.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Gap {
    Words,
    Relation,
    Term,
    /// Any other space, and any two ideographs.
    Any,
    Closed,
}

pub struct Script<'a> {
    pub spans: &'a [Span],
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
const CLOSING: &str = "，。、；：！？）》」』”’…";
const OPENING: &str = "（《「『“‘";

/// After a space, and on either side of an ideograph.
fn is_open(before: char, c: char) -> bool {
    if before == ' ' || c == ' ' {
        return before == ' ' && c != ' ';
    }
    let is_wide = |c| matches!(c, '\u{2e80}'..='\u{9fff}' | '\u{f900}'..='\u{faff}' | '\u{ff00}'..='\u{ffef}');
    (is_wide(before) || is_wide(c)) && !CLOSING.contains(c) && !OPENING.contains(before)
}

/// Characters in lines of at most `width`, given where on one long line each begins and ends.
pub fn break_rows(chars: &[Char], places: &[[f32; 2]], width: f32) -> Vec<Range<usize>> {
    let mut lines = Lines {
        chars,
        places,
        width,
        done: Vec::new(),
        line: 0..0,
    };
    lines.fill(0..chars.len(), Gap::Words);
    lines.done.push(lines.line.clone());
    lines.done
}

struct Lines<'a> {
    chars: &'a [Char],
    places: &'a [[f32; 2]],
    width: f32,
    done: Vec<Range<usize>>,
    line: Range<usize>,
}

impl Lines<'_> {
    /// Goes on with these characters, breaking at no worse gaps than these unless it must.
    fn fill(&mut self, range: Range<usize>, gap: Gap) {
        let worse = match gap {
            Gap::Words => Some(Gap::Relation),
            Gap::Relation => Some(Gap::Term),
            Gap::Term => Some(Gap::Any),
            Gap::Any | Gap::Closed => None,
        };
        let mut start = range.start;
        while start < range.end {
            let next = (start + 1..range.end).find(|&i| self.chars[i].gap <= gap);
            let chunk = start..next.unwrap_or(range.end);
            start = chunk.end;
            let fits = self.fits(self.line.start..chunk.end);
            match worse {
                _ if fits => self.line.end = chunk.end,
                Some(worse) if !self.fits(chunk.clone()) => self.fill(chunk, worse),
                _ => {
                    if !self.line.is_empty() {
                        self.done.push(self.line.clone());
                    }
                    self.line = chunk;
                }
            }
        }
    }

    /// A space at the end of a line takes no room.
    fn fits(&self, range: Range<usize>) -> bool {
        let last = range.clone().rev().find(|&i| self.chars[i].c != ' ');
        last.is_none_or(|last| self.places[last][1] - self.places[range.start][0] <= self.width)
    }
}
