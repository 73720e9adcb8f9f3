//! Cases from a reader, answers to a writer, in order and in constant memory.

use std::{
    fmt,
    io::{self, BufWriter, Read, Write},
};

use crate::{input::Given, text::Catalog};

use super::{
    Case, CaseLines, Format, Refused, Refusing, Solvers, Style,
    read::{read, told},
    report::{Report, Sheet},
};

/// Written in pieces of this size: large enough that calls into the system cost nothing.
const CHUNK_BYTES: usize = 1 << 16;

/// How many cases there were.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Tally {
    /// Answered.
    pub answered: usize,
    /// Refused.
    pub refused: usize,
}

/// Why a stream of cases broke off.
#[derive(Debug)]
pub enum TraceError {
    /// The cases could not be read.
    Read(io::Error),
    /// The answers could not be written.
    Write(io::Error),
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read(error) => write!(f, "reading cases: {error}"),
            Self::Write(error) => write!(f, "writing answers: {error}"),
        }
    }
}

impl std::error::Error for TraceError {}

/// Answers every case by one of `solvers`, in order. `on_refusal` hears of each refusal.
///
/// Answers are written in large pieces, and whenever the next case has not come yet: who sends one case and
/// waits for its answer gets it.
///
/// # Errors
/// [`TraceError`] where reading or writing fails; what was answered by then is written.
pub fn trace(
    solvers: Solvers,
    cases: impl Read,
    answers: impl Write,
    style: Style,
    mut on_refusal: impl FnMut(Refusing<'_>),
) -> Result<Tally, TraceError> {
    let mut lines = CaseLines::new(cases);
    let mut tally = Tally::default();
    let mut out = BufWriter::with_capacity(CHUNK_BYTES, answers);
    loop {
        if !lines.is_ready() {
            out.flush().map_err(TraceError::Write)?;
        }
        let Some((line, text)) = lines.next_line().map_err(TraceError::Read)? else {
            return out.flush().map(|()| tally).map_err(TraceError::Write);
        };
        let case = read(solvers, text, style.detail);
        let number = tally.answered + tally.refused + 1;
        let told = || told(solvers, text, style.detail);
        let place = Place {
            line,
            number,
            n_answered: tally.answered,
        };
        write_answer(place, &case, told, style, &mut out).map_err(TraceError::Write)?;
        match &case {
            Ok(_) => tally.answered += 1,
            Err(refused) => {
                tally.refused += 1;
                on_refusal(Refusing {
                    line,
                    number,
                    refused,
                });
            }
        }
    }
}

/// Where a case stands.
#[derive(Clone, Copy)]
struct Place {
    line: usize,
    number: usize,
    /// How many before it have been answered.
    n_answered: usize,
}

/// Programs are told of a refused case in its place; people elsewhere, so that what they hand out holds none.
fn write_answer(
    place: Place,
    case: &Result<Case, Refused>,
    told: impl Fn() -> Vec<Given>,
    style: Style,
    out: &mut impl Write,
) -> io::Result<()> {
    let report = |case, sheet| {
        let wanted = (style.detail, sheet);
        Report::new(place.number, case, &told(), wanted, Catalog::of(style.lang))
    };
    let sheet = match (style.format, case) {
        (Format::Json, Ok(case)) => {
            case.write_json(style.detail, out)?;
            return out.write_all(b"\n");
        }
        (Format::Json, Err(refused)) => {
            refused.write_json(place.line, &mut *out)?;
            return out.write_all(b"\n");
        }
        (Format::Text, Ok(case)) => return report(case, Sheet::Answers).write_text(out),
        (Format::Markdown, Ok(case)) => report(case, Sheet::Answers),
        (Format::Worksheet, Ok(case)) => report(case, Sheet::Questions),
        (Format::Text | Format::Markdown | Format::Worksheet, Err(_)) => return Ok(()),
    };
    if place.n_answered == 0 {
        sheet.write_title(out)?;
    }
    sheet.write_markdown(out)
}
