//! Clipping by codes, told: in the plane and in space the same steps, said in each one's own words.

use crate::{
    algo::segment::{CodeClip, CodeEvent},
    figure::{
        Body,
        Tick::{Accept, Cut, Phase, Reject, Test},
        View,
    },
    labs::{
        CodeLine, code_line,
        telling::{At, Named, Row, Telling, Watched, table},
    },
    trace::Step,
};

use super::{
    code_step::{CodeLook, CodeStep},
    ends::{ENDS, is_point},
};

/// The view of the codes as bits.
const CODES_VIEW: &str = "codes";

const CODES: usize = 0;
const ACCEPT: usize = 2;
const REJECT: usize = 3;
const CHOOSE: usize = 4;
const CUT: usize = 6;
const RECODE: usize = 7;

/// A code that is found, first or after a cut.
const fn code_row(line: usize, key: &'static str) -> Row {
    Row::new(Test, line, key)
        .so(&["{x}", "{y}", "{z}"])
        .about("end")
}

impl<const N: usize, I: CodeLook<N>> Telling for CodeClip<N, I> {
    type Scenery = I::Scenery;

    const ID: &'static str = I::ID;
    const NAME_KEY: &'static str = I::NAME_KEY;
    const SOURCE: &'static str = I::SOURCE;
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-cs-codes", "words-cs-codes"),
        code_line(0, "code-cs-loop", "words-cs-loop"),
        code_line(1, "code-cs-accept", "words-cs-accept"),
        code_line(1, "code-cs-reject", "words-cs-reject"),
        code_line(1, "code-cs-choose", "words-cs-choose"),
        code_line(1, "code-cs-end", "words-cs-end"),
        code_line(1, "code-cs-cut", "words-cs-cut"),
        code_line(1, "code-cs-recode", "words-cs-recode"),
    ];
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
        reject: CodeEvent::Reject { .. } => Row::new(Reject, REJECT, I::KEYS.reject);
    }

    fn opening(_: &At<'_, Self>) -> &'static Row {
        const { &Row::new(Phase, CODES, I::KEYS.opening).so(ENDS) }
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        CodeStep::of(&at.step).named(name)
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        at.step.input.written().into_iter().map(I::side).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let shown = CodeStep::of(&at.step);
        let codes = View::new(CODES_VIEW, Body::Bits(shown.bits()));
        let drawing = I::drawing(&shown, at.scenery);
        drawing.into_iter().chain([codes]).collect()
    }
}

/// Is it one of the first two codes, before any cut? And how many bits are set, three at most.
fn found<const N: usize, I: CodeLook<N>>(
    step: &Step<'_, CodeClip<N, I>>,
    code: I::Code,
) -> (bool, usize) {
    let sides = step.input.written().into_iter();
    let n_beyond = sides.filter(|&side| step.input.has(code, side)).count();
    (step.past.len() <= 2, n_beyond.min(3))
}
