//! A step of a clipper by codes, with what the picture needs of those before it; and what is particular to the plane and to space.

use crate::{
    algo::{
        parameter::End,
        segment::{CodeClip, CodeEvent, Coded, VisibleLine},
    },
    figure::{BitRow, Bits, Role, View},
    labs::{
        Answer,
        operator::Operator,
        telling::Named,
        words::{end_link, end_name, end_name_now, name},
    },
    text::{Formula, Message, Value},
    trace::Step,
};

use super::ends::{left_in, place};

const CODE_SYMBOLS: [&str; 2] = ["code₁", "code₂"];

/// Catalogue keys of what is said.
#[derive(Debug)]
pub struct CodeKeys {
    /// What is asked.
    pub opening: &'static str,
    /// A code with no bit set, with one, two and three.
    pub codes: [&'static str; 4],
    /// The OR is 0, and not.
    pub or: [&'static str; 2],
    /// The AND is 0, and not.
    pub and: [&'static str; 2],
    /// The side that is cut at.
    pub choose: &'static str,
    /// The end, where nothing is visible.
    pub reject: &'static str,
    /// The end, where one point is left, and where one was given.
    pub one_point: [&'static str; 2],
}

/// An event of clipping inputs of the kind `I`.
pub type EventOf<const N: usize, I> = CodeEvent<N, <I as Coded<N>>::Code, <I as Coded<N>>::Side>;

/// An input whose clipping can be shown.
pub trait CodeLook<const N: usize>: Coded<N, Output: Answer> {
    /// What is drawn around a run.
    type Scenery: 'static;
    /// As JSON spells the method.
    const ID: &'static str;
    /// Catalogue key of its name.
    const NAME_KEY: &'static str;
    /// Author and year.
    const SOURCE: &'static str;
    /// What is said.
    const KEYS: CodeKeys;

    /// The sides in the order in which their bits are written.
    fn written(&self) -> Vec<Self::Side>;

    /// A side's name in a sentence, with its link.
    fn side(side: Self::Side) -> Named;

    /// Its name over its bits.
    fn column(side: Self::Side) -> Value;

    /// Of several sides that both ends lie beyond, the one that is named.
    fn shared(&self, and: Self::Code) -> Option<Self::Side>;

    /// What else a sentence names of a code.
    fn named(&self, code: Self::Code, name: &str) -> Option<Value>;

    /// Where a point lies along an axis: `x = −2 < −1`.
    fn position(&self, axis: usize, at: [f64; N], code: Self::Code) -> Formula;

    /// The equation of a side.
    fn border(&self, side: Self::Side) -> Formula;

    /// How the crossing with a side is worked out.
    fn crossing_formulas(&self, side: Self::Side, at: [f64; N]) -> Vec<Formula>;

    /// The watch table's word on a code: of an end, or of the OR and the AND.
    fn note(&self, code: Self::Code, is_of_end: bool) -> Option<Value>;

    /// What stands under the bits while nothing is made of them; the code is that which is found at this step.
    fn rule(&self, code: Option<Self::Code>) -> Message;

    /// The drawing.
    fn drawing(shown: &CodeStep<'_, N, Self>, scenery: Option<&Self::Scenery>) -> Option<View>;
}

/// A step, with what the picture needs of those before it.
pub struct CodeStep<'a, const N: usize, I: Coded<N>> {
    /// What the method runs on.
    pub input: &'a I,
    /// The event that led to the step.
    pub event: Option<EventOf<N, I>>,
    /// The ends of what is left.
    pub ends: [[f64; N]; 2],
    /// Their codes, once known.
    pub codes: [Option<I::Code>; 2],
    /// The last OR, until a code changes.
    or: Option<I::Code>,
    /// The last AND, until a code changes.
    and: Option<I::Code>,
    /// Where the segment was cut, in the order of the cuts.
    pub cuts: Vec<[f64; N]>,
    /// The answer, once known: a bit in common rejects as soon as it is seen.
    pub verdict: Option<VisibleLine<N>>,
}

impl<'a, const N: usize, I: CodeLook<N>> CodeStep<'a, N, I> {
    pub fn of(step: &Step<'a, CodeClip<N, I>>) -> Self {
        let mut shown = Self {
            input: step.input,
            event: step.event(),
            ends: step.held.ends,
            codes: [None; 2],
            or: None,
            and: None,
            cuts: Vec::new(),
            verdict: None,
        };
        for event in step.past {
            shown.see(event);
        }
        shown
    }

    fn see(&mut self, event: &EventOf<N, I>) {
        match *event {
            CodeEvent::Code { end, code, .. } => {
                self.codes[end.idx()] = Some(code);
                (self.or, self.and) = (None, None);
            }
            CodeEvent::Or { or } => self.or = Some(or),
            CodeEvent::And { and } => {
                self.and = Some(and);
                self.verdict = (and != I::Code::default()).then_some(None);
            }
            CodeEvent::Cut { end, to, .. } => {
                self.codes[end.idx()] = None;
                self.cuts.push(to);
            }
            CodeEvent::Accept { ends } => self.verdict = Some(Some(ends)),
            CodeEvent::Choose { .. } | CodeEvent::Reject { .. } => {}
        }
    }

    /// The side whose bit decides at this step: that both ends lie beyond, or that is cut at.
    pub fn deciding(&self) -> Option<I::Side> {
        match self.event? {
            CodeEvent::And { and } | CodeEvent::Reject { and } => self.input.shared(and),
            CodeEvent::Choose { side, .. } | CodeEvent::Cut { side, .. } => Some(side),
            CodeEvent::Code { .. } | CodeEvent::Or { .. } | CodeEvent::Accept { .. } => None,
        }
    }

    /// Both codes as bits, and what an operator makes of them once it is asked.
    pub fn bits(&self) -> Bits {
        let (input, written) = (self.input, self.input.written());
        let bits = |code| written.iter().map(|&side| input.has(code, side)).collect();
        let (found, found_at) = match self.event {
            Some(CodeEvent::Code { code, end, .. }) => (Some(code), Some(end)),
            _ => (None, None),
        };
        let row = |end: End| BitRow {
            name: end_name_now(end, self.ends[end.idx()] != input.ends()[end.idx()]),
            bits: self.codes[end.idx()].map_or_else(Vec::new, bits),
            role: if found_at == Some(end) {
                Role::Signal
            } else {
                Role::Ink
            },
            link: Some(end_link(end)),
        };
        let combined = self.combined();
        let is_now = matches!(
            self.event,
            Some(CodeEvent::Or { .. } | CodeEvent::And { .. })
        );
        let column = |side| written.iter().position(|&of| of == side);
        Bits {
            columns: written.iter().map(|&side| I::column(side)).collect(),
            rows: End::BOTH.map(row).to_vec(),
            note: Some(combined.map_or_else(|| input.rule(found), |(operator, _)| operator.note())),
            result: combined.map(|(operator, code)| operator.row(bits(code), is_now)),
            deciding: self.deciding().and_then(column),
        }
    }

    /// The operator that the step is about, and what it gives.
    fn combined(&self) -> Option<(Operator, I::Code)> {
        let operator = match self.event? {
            CodeEvent::Code { .. } | CodeEvent::Cut { .. } => return None,
            CodeEvent::Or { .. } | CodeEvent::Accept { .. } | CodeEvent::Choose { .. } => {
                Operator::Or
            }
            CodeEvent::And { .. } | CodeEvent::Reject { .. } => Operator::And,
        };
        operator.of([self.or, self.and])
    }

    /// What is made of both codes, or the code of an end.
    fn bits_now(&self) -> Option<I::Code> {
        match self.event? {
            CodeEvent::Code { code, .. } => Some(code),
            CodeEvent::Or { or } => Some(or),
            CodeEvent::And { and } | CodeEvent::Reject { and } => Some(and),
            CodeEvent::Choose { .. } | CodeEvent::Cut { .. } | CodeEvent::Accept { .. } => None,
        }
    }

    fn end_now(&self) -> Option<End> {
        match self.event? {
            CodeEvent::Code { end, .. }
            | CodeEvent::Choose { end, .. }
            | CodeEvent::Cut { end, .. } => Some(end),
            CodeEvent::Or { .. }
            | CodeEvent::And { .. }
            | CodeEvent::Accept { .. }
            | CodeEvent::Reject { .. } => None,
        }
    }

    /// A code in the watch table, if it is known.
    fn watched(&self, code: Option<I::Code>, is_of_end: bool) -> Named {
        let shown = Named::maybe(code.map(|code| name(code.to_string())));
        let note = code.and_then(|code| self.input.note(code, is_of_end));
        Named { note, ..shown }
    }

    pub fn named(&self, of: &str) -> Option<Named> {
        Some(match of {
            "P₁" => Named::from(place(&self.ends[0])).linked(end_link(End::P1)),
            "P₂" => Named::from(place(&self.ends[1])).linked(end_link(End::P2)),
            "t" => match self.event {
                Some(CodeEvent::Cut { u, .. }) => Value::Ratio {
                    num: u.num,
                    den: u.den,
                }
                .into(),
                _ => Named::empty(),
            },
            "code₁" => self.watched(self.codes[0], true),
            "code₂" => self.watched(self.codes[1], true),
            "OR" => self.watched(self.or, false),
            "AND" => self.watched(self.and, false),
            "end" => Named::from(end_name(self.end_now()?)).linked(end_link(self.end_now()?)),
            "code" => name(CODE_SYMBOLS[self.end_now()?.idx()]).into(),
            "bits" | "and" => name(self.bits_now()?.to_string()).into(),
            "segment" => Named::empty().linked("segment"),
            "edge" | "plane" | "rejects" => I::side(self.deciding()?),
            "border" => self.input.border(self.deciding()?).into(),
            "x" => self.position(0)?.into(),
            "y" => self.position(1)?.into(),
            "z" => self.position(2)?.into(),
            "1st" => self.worked_out(0)?.into(),
            "2nd" => self.worked_out(1)?.into(),
            "3rd" => self.worked_out(2)?.into(),
            "4th" => self.worked_out(3)?.into(),
            _ => {
                let own = self.bits_now().and_then(|code| self.input.named(code, of));
                return own.map(Named::from).or_else(|| left_in(self.verdict?, of));
            }
        })
    }

    fn position(&self, axis: usize) -> Option<Formula> {
        match self.event? {
            CodeEvent::Code { at, code, .. } if axis < N => {
                Some(self.input.position(axis, at, code))
            }
            _ => None,
        }
    }

    fn worked_out(&self, nth: usize) -> Option<Formula> {
        match self.event? {
            CodeEvent::Cut { side, to, .. } => {
                self.input.crossing_formulas(side, to).into_iter().nth(nth)
            }
            _ => None,
        }
    }
}
