//! Why an answer is not right, and how that is said.

use serde_json::{Value as Json, json};

use crate::{
    case::{Code, short},
    text::Message,
};

use super::{compare::Difference, truth::kind_of, whole::Whole};

/// What kind of mistake, as reports spell it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// The answer's `output` differs.
    Output,
    /// A step differs.
    Event,
    /// There is no answer.
    Missing,
    /// An answer to no case.
    Extra,
    /// A line that cannot be read.
    BadJson,
    /// One of the two refuses the case.
    Refused,
}

impl Kind {
    /// Every kind as JSON spells it, in the order of the variants.
    pub(super) const IDS: [&'static str; 6] =
        ["output", "event", "missing", "extra", "bad-json", "refused"];

    /// As JSON spells it.
    #[must_use]
    pub const fn id(self) -> &'static str {
        Self::IDS[self as usize]
    }
}

/// How an answer differs.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Fault {
    Output {
        said: Json,
        truth: Json,
        difference: Difference,
    },
    Event(EventFault),
    Missing,
    Extra {
        line: usize,
    },
    BadJson {
        line: usize,
        problem: Message,
    },
    /// The program refuses what has an answer.
    Refuses {
        truth: Json,
    },
    /// The program answers what is refused.
    Refusable {
        said: Json,
        code: Code,
    },
}

/// A step that differs.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct EventFault {
    /// Of the program's own, from 1.
    pub step: usize,
    /// None where it has ended.
    pub said: Option<Json>,
    pub truth: Option<Json>,
    /// Does it change places with the next?
    pub is_swapped: bool,
    /// Of the true run, from 1.
    pub true_step: Option<usize>,
    /// Where in the step, if it is of the same kind.
    pub difference: Option<Difference>,
}

impl Fault {
    pub(super) const fn kind(&self) -> Kind {
        match self {
            Self::Output { .. } => Kind::Output,
            Self::Event(_) => Kind::Event,
            Self::Missing => Kind::Missing,
            Self::Extra { .. } => Kind::Extra,
            Self::BadJson { .. } => Kind::BadJson,
            Self::Refuses { .. } | Self::Refusable { .. } => Kind::Refused,
        }
    }

    const fn event(&self) -> Option<&EventFault> {
        match self {
            Self::Event(fault) => Some(fault),
            Self::Output { .. }
            | Self::Missing
            | Self::Extra { .. }
            | Self::BadJson { .. }
            | Self::Refuses { .. }
            | Self::Refusable { .. } => None,
        }
    }

    pub(super) fn step(&self) -> Option<usize> {
        self.event().map(|fault| fault.step)
    }

    /// What the program said and what is true, null where there is nothing; cut where it is long.
    pub(super) fn said_and_true(&self) -> [Json; 2] {
        self.both().map(of_moderate_length)
    }

    /// Where no answer can be read, the true one stands for what was expected.
    pub(super) fn whole(&self, answer: Option<&Json>) -> Whole {
        let [said, truth] = match (self, answer) {
            (Self::Missing | Self::BadJson { .. }, Some(answer)) => [Json::Null, answer.clone()],
            _ => self.both(),
        };
        let step = self.event().and_then(|fault| fault.true_step);
        let difference = match self {
            Self::Output { difference, .. } => Some(difference),
            Self::Event(fault) => fault.difference.as_ref(),
            Self::Missing
            | Self::Extra { .. }
            | Self::BadJson { .. }
            | Self::Refuses { .. }
            | Self::Refusable { .. } => None,
        };
        let parts =
            difference.map(|it| [&it.truth, &it.said].map(|part| part.clone().unwrap_or_default()));
        Whole {
            said,
            truth,
            path: difference.map(|it| it.path.clone()).unwrap_or_default(),
            parts: parts.unwrap_or_default(),
            step,
        }
    }

    fn both(&self) -> [Json; 2] {
        match self {
            Self::Output { said, truth, .. } => [said.clone(), truth.clone()],
            Self::Event(EventFault { said, truth, .. }) => {
                [said, truth].map(|event| event.clone().unwrap_or(Json::Null))
            }
            Self::Missing | Self::Extra { .. } | Self::BadJson { .. } => [Json::Null, Json::Null],
            Self::Refuses { truth } => [json!({ "error": true }), truth.clone()],
            Self::Refusable { said, code } => {
                [said.clone(), json!({ "error": { "code": code.id() } })]
            }
        }
    }

    pub(super) fn message(&self) -> Message {
        match self {
            Self::Output { difference, .. } => difference.message("grade-output"),
            Self::Event(fault) => fault.message(),
            Self::Missing => Message::new("grade-missing"),
            Self::Extra { line } => Message::new("grade-extra").with("line", *line),
            Self::BadJson { line, problem } => Message::new("grade-bad-json")
                .with("line", *line)
                .with("problem", problem.clone()),
            Self::Refuses { .. } => Message::new("grade-refuses"),
            Self::Refusable { code, .. } => {
                Message::new("grade-refusable").with("code", code.id().to_owned())
            }
        }
    }
}

impl EventFault {
    fn message(&self) -> Message {
        let kind = |event: &Option<Json>| {
            let kind = event.as_ref().and_then(kind_of);
            kind.map(short)
        };
        let [said, truth] = [kind(&self.said), kind(&self.truth)];
        let named = |key| Message::new(key).with("step", self.step);
        match (&self.said, said, truth) {
            (None, _, truth) => Message::new("grade-step-missing")
                .with("step", self.step - 1)
                .with("truth", truth.unwrap_or_default()),
            (Some(_), None, _) => named("grade-step-unreadable"),
            (Some(_), Some(said), None) => named("grade-step-extra").with("said", said),
            (Some(_), Some(said), Some(truth)) if self.is_swapped => named("grade-steps-swapped")
                .with("next", self.step + 1)
                .with("said", said)
                .with("truth", truth),
            (Some(_), Some(said), Some(truth)) => match &self.difference {
                Some(difference) => {
                    let what = difference.message("grade-field");
                    named("grade-step-differs")
                        .with("said", said)
                        .with("what", what)
                }
                None => named("grade-step-other")
                    .with("said", said)
                    .with("truth", truth),
            },
        }
    }
}

impl Difference {
    /// By the keys of this name: of a value that differs, is missing, or is one too many, or of all of it.
    fn message(&self, key: &'static str) -> Message {
        let [plain, missing, spare] = match key {
            "grade-output" => ["grade-output", "grade-output-missing", "grade-output-spare"],
            _ => ["grade-field", "grade-field-missing", "grade-field-spare"],
        };
        let place = if self.path.is_empty() {
            "output".to_owned()
        } else {
            short(&self.path)
        };
        let text = |json: &Json| short(&json.to_string());
        match (&self.said, &self.truth) {
            (Some(said), Some(truth)) => Message::new(plain)
                .with("place", place)
                .with("said", text(said))
                .with("truth", text(truth)),
            (None, truth) => {
                let truth = truth.as_ref().map(text).unwrap_or_default();
                Message::new(missing)
                    .with("place", place)
                    .with("truth", truth)
            }
            (Some(said), None) => Message::new(spare)
                .with("place", place)
                .with("said", text(said)),
        }
    }
}

/// Longer values stand in no report.
const MOST_BYTES: usize = 4_096;

fn of_moderate_length(value: Json) -> Json {
    let text = value.to_string();
    if text.len() <= MOST_BYTES {
        value
    } else {
        Json::String(short(&text))
    }
}
