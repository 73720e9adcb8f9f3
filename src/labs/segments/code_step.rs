//! Clipping by codes, told: in the plane and in space the same steps, said in each one's own words.

use crate::{
    algo::segment::{CodeClip, CodeEvent, CodeRules, Coded},
    figure::{BitRow, Bits, Glimpse},
};

use super::{
    ends::{ENDS, is_point, left_in, place},
    line_step::LineVariant,
    prelude::*,
};

const CODE_SYMBOLS: [&str; 2] = ["code₁", "code₂"];

#[derive(Debug)]
pub struct CodeKeys {
    pub opening: &'static str,
    /// A code with no bit set, with one, two and three.
    pub codes: [&'static str; 4],
    /// The OR is 0, and not.
    pub or: [&'static str; 2],
    /// The AND is 0, and not.
    pub and: [&'static str; 2],
    pub choose: &'static str,
    pub reject: &'static str,
    /// The end, where one point is left, and where one was given.
    pub one_point: [&'static str; 2],
}

pub type EventOf<const N: usize, I> = CodeEvent<N, <I as Coded<N>>::Code, <I as Coded<N>>::Side>;

pub trait CodeLook<const N: usize>: Coded<N, Output: Answer> {
    type Scenery: Send + Sync + 'static;
    const SOURCE: &'static str;
    const KEYS: CodeKeys;

    fn written(&self) -> Vec<Self::Side>;

    fn side(side: Self::Side) -> Named;

    fn column(side: Self::Side) -> Value;

    /// Of several sides that both ends lie beyond, the one that is named.
    fn shared(&self, and: Self::Code) -> Option<Self::Side>;

    fn named(&self, code: Self::Code, name: &str) -> Option<Value>;

    /// Where a point lies along an axis: `x = −2 < −1`.
    fn position(&self, axis: usize, at: [f64; N], code: Self::Code) -> Formula;

    fn border(&self, side: Self::Side) -> Formula;

    fn crossing_formulas(&self, side: Self::Side, at: [f64; N]) -> Vec<Formula>;

    /// The watch table's word on a code: of an end, or of the OR and the AND.
    fn note(&self, code: Self::Code, is_of_end: bool) -> Option<Value>;

    /// What stands under the bits while nothing is made of them; the code is that which is found at this step.
    fn rule(&self, code: Option<Self::Code>) -> Message;

    /// What stands in place of the bits.
    fn rows(_: &CodeStep<'_, N, Self>) -> Option<Table> {
        None
    }

    /// What lies beyond a side, where that is drawn.
    fn beyond(&self, _: Self::Side) -> Option<Mark> {
        None
    }

    fn drawing(shown: &CodeStep<'_, N, Self>, scenery: Option<&Self::Scenery>) -> Option<View>;
}

pub struct CodeStep<'a, const N: usize, I: Coded<N>> {
    pub input: &'a I,
    pub event: Option<EventOf<N, I>>,
    pub ends: [[f64; N]; 2],
    pub codes: [Option<I::Code>; 2],
    /// The last OR, until a code changes.
    or: Option<I::Code>,
    and: Option<I::Code>,
    pub cuts: Vec<[f64; N]>,
    n_cuts: [usize; 2],
    /// The answer, once known: a bit in common rejects as soon as it is seen.
    pub verdict: Option<VisibleLine<N>>,
}

impl<'a, const N: usize, I: CodeLook<N>> CodeStep<'a, N, I> {
    pub fn of<L: CodeRules<N, I>>(step: &Step<'a, CodeClip<N, I, L>>) -> Self {
        let mut shown = Self {
            input: step.input,
            event: step.event(),
            ends: step.held.ends,
            codes: [None; 2],
            or: None,
            and: None,
            cuts: Vec::new(),
            n_cuts: [0; 2],
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
                self.n_cuts[end.idx()] += 1;
            }
            CodeEvent::Accept { ends } => self.verdict = Some(Some(ends)),
            CodeEvent::Reject { .. } => self.verdict = Some(None),
            CodeEvent::Choose { .. } => {}
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

    pub fn bits(&self) -> Bits {
        let (input, written) = (self.input, self.input.written());
        let bits = |code| written.iter().map(|&side| input.has(code, side)).collect();
        let (found, found_at) = match self.event {
            Some(CodeEvent::Code { code, end, .. }) => (Some(code), Some(end)),
            _ => (None, None),
        };
        let role = |is_now| if is_now { Role::Signal } else { Role::Ink };
        let row = |end: End| BitRow {
            name: end_name_now(end, self.ends[end.idx()] != input.ends()[end.idx()]),
            bits: self.codes[end.idx()].map_or_else(Vec::new, bits),
            role: role(found_at == Some(end)),
            link: Some(end_link(end)),
        };
        let combined = self.combined();
        let is_now = |event| matches!(event, CodeEvent::Or { .. } | CodeEvent::And { .. });
        let result = |(symbol, _, code)| BitRow {
            name: name(symbol),
            bits: bits(code),
            role: role(self.event.is_some_and(is_now)),
            link: None,
        };
        let note = combined.map(|(_, note, _)| Message::new(note));
        let column = |side| written.iter().position(|&of| of == side);
        Bits {
            columns: written.iter().map(|&side| I::column(side)).collect(),
            links: written
                .iter()
                .filter_map(|&side| I::side(side).link)
                .collect(),
            rows: End::BOTH.map(row).to_vec(),
            note: note.or_else(|| Some(input.rule(found))),
            result: combined.map(result),
            deciding: self.deciding().and_then(column),
        }
    }

    /// Of OR and AND the one that the step is about: its name, what is said of it, and what it gives.
    fn combined(&self) -> Option<(&'static str, &'static str, I::Code)> {
        match self.event? {
            CodeEvent::Code { .. } | CodeEvent::Cut { .. } => None,
            CodeEvent::And { .. } | CodeEvent::Reject { .. } => {
                Some(("AND", "cs-note-and", self.and?))
            }
            _ => Some(("OR", "cs-note-or", self.or?)),
        }
    }

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
            _ => None,
        }
    }

    /// What has been cut has a name of its own; what is being cut is what was there before.
    fn told_end(&self, end: End) -> Named {
        let is_cut = matches!(self.event, Some(CodeEvent::Cut { .. }));
        let n_before = self.n_cuts[end.idx()] - usize::from(is_cut);
        Named::from(end_name_now(end, n_before > 0)).linked(end_link(end))
    }

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
                Some(CodeEvent::Cut { u, .. }) => value_of(u).into(),
                _ => Named::empty(),
            },
            "code₁" => self.watched(self.codes[0], true),
            "code₂" => self.watched(self.codes[1], true),
            "OR" => self.watched(self.or, false),
            "AND" => self.watched(self.and, false),
            "end" => self.told_end(self.end_now()?),
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

const CODES_VIEW: &str = "codes";

pseudocode! {
    CODES: 0, "code-cs-codes", "words-cs-codes";
    LOOP: 0, "code-cs-loop", "words-cs-loop";
    ACCEPT: 1, "code-cs-accept", "words-cs-accept";
    REJECT: 1, "code-cs-reject", "words-cs-reject";
    CHOOSE: 1, "code-cs-choose", "words-cs-choose";
    END: 1, "code-cs-end", "words-cs-end";
    CUT: 1, "code-cs-cut", "words-cs-cut";
    RECODE: 1, "code-cs-recode", "words-cs-recode";
}

const fn code_row(line: usize, key: &'static str) -> Row {
    Row::new(Test, line, key)
        .so(&["{x}", "{y}", "{z}"])
        .about("end")
}

impl<const N: usize, I, L> Telling for CodeClip<N, I, L>
where
    I: CodeLook<N>,
    L: CodeRules<N, I> + LineVariant<N, I>,
{
    type Scenery = I::Scenery;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = I::SOURCE;
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[
        Watched::Names(&["P₁", "P₂", "t"]),
        Watched::Seen(&["code₁", "code₂", "OR", "AND"], CODES_VIEW),
    ];

    table! { |event, step|
        inside: CodeEvent::Code { code, .. } if found(step, code) == (true, 0) =>
            code_row(CODES, I::KEYS.codes[0]);
        one: CodeEvent::Code { code, .. } if found(step, code) == (true, 1) =>
            code_row(CODES, I::KEYS.codes[1]);
        two: CodeEvent::Code { code, .. } if found(step, code) == (true, 2) =>
            code_row(CODES, I::KEYS.codes[2]);
        three: CodeEvent::Code { code, .. } if found(step, code) == (true, 3) =>
            code_row(CODES, I::KEYS.codes[3]);
        inside_now: CodeEvent::Code { code, .. } if found(step, code) == (false, 0) =>
            code_row(RECODE, I::KEYS.codes[0]);
        one_now: CodeEvent::Code { code, .. } if found(step, code) == (false, 1) =>
            code_row(RECODE, I::KEYS.codes[1]);
        two_now: CodeEvent::Code { code, .. } if found(step, code) == (false, 2) =>
            code_row(RECODE, I::KEYS.codes[2]);
        three_now: CodeEvent::Code { .. } => code_row(RECODE, I::KEYS.codes[3]);
        both_inside: CodeEvent::Or { or } if or == I::Code::default() =>
            Row::new(Test, ACCEPT, I::KEYS.or[0]).so(&["{code₁} OR {code₂} = {OR}"])
                .answers_as("or", "cs-option-inside").keeps("segment");
        not_inside: CodeEvent::Or { .. } =>
            Row::new(Test, ACCEPT, I::KEYS.or[1]).so(&["{code₁} OR {code₂} = {OR}"])
                .answers_as("or", "cs-option-not-inside");
        undecided: CodeEvent::And { and } if and == I::Code::default() =>
            Row::new(Test, REJECT, I::KEYS.and[0]).so(&["{code₁} AND {code₂} = {AND}"])
                .answers_as("and", "cs-option-undecided");
        both_beyond: CodeEvent::And { .. } =>
            Row::new(Test, REJECT, I::KEYS.and[1]).so(&["{code₁} AND {code₂} = {AND}"])
                .answers_as("and", "cs-option-beyond").drops("segment");
        choose: CodeEvent::Choose { .. } =>
            Row::new(Phase, CHOOSE, I::KEYS.choose).so(&["code₁ OR code₂ = {OR}"])
                .about("plane").picks("plane", "planes");
        cut: CodeEvent::Cut { .. } =>
            Row::new(Cut, CUT, "cs-cut").so(&["{1st}", "{2nd}", "{3rd}", "{4th}"]).cuts("end");
        point: CodeEvent::Accept { .. } if is_point(step.input.ends()) =>
            Row::new(Accept, ACCEPT, I::KEYS.one_point[1]);
        touch: CodeEvent::Accept { ends } if is_point(ends) =>
            Row::new(Accept, ACCEPT, I::KEYS.one_point[0]);
        accept: CodeEvent::Accept { .. } => Row::new(Accept, ACCEPT, "line-accept");
        reject_two: CodeEvent::Reject { and } if and == I::Code::default() =>
            Row::new(Reject, REJECT, "cs-reject-two")
                .so(&["code₁ = {code₁} ≠ 0", "code₂ = {code₂} ≠ 0"]);
        reject: CodeEvent::Reject { .. } => Row::new(Reject, REJECT, I::KEYS.reject);
    }

    const OPENING: Row = Row::new(Phase, CODES, I::KEYS.opening).so(ENDS);

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        CodeStep::of(&at.step).named(name)
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        at.step.input.written().into_iter().map(I::side).collect()
    }

    fn glimpse(at: &At<'_, Self>, _: &Row, link: Option<Link>) -> Glimpse {
        let mut sides = at.step.input.written().into_iter();
        let side = link.and_then(|link| sides.find(|&side| I::side(side).link == Some(link)));
        let beyond = side.and_then(|side| at.step.input.beyond(side));
        beyond.map_or(Glimpse::Nothing, Glimpse::Mark)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let shown = CodeStep::of(&at.step);
        let rows = I::rows(&shown).map(Body::Table);
        let codes = View::new(CODES_VIEW, rows.unwrap_or_else(|| Body::Bits(shown.bits())));
        let drawing = I::drawing(&shown, at.scenery);
        drawing.into_iter().chain([codes]).collect()
    }
}

/// Is it one of the first two codes, before any cut? And how many bits are set, three at most.
fn found<const N: usize, I: CodeLook<N>, L: CodeRules<N, I>>(
    step: &Step<'_, CodeClip<N, I, L>>,
    code: I::Code,
) -> (bool, usize) {
    let sides = step.input.written().into_iter();
    let n_beyond = sides.filter(|&side| step.input.has(code, side)).count();
    (step.past.len() <= 2, n_beyond.min(3))
}
