//! A row of a method's table, and the table itself.

use crate::figure::{Decides, Tick};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Question {
    pub id: &'static str,
    /// What might be answered.
    pub options: Options,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Options {
    /// What the rows that answer it say.
    Rows,
    /// The entries of a list; the right one is the value of a name.
    Of {
        name: &'static str,
        list: &'static str,
    },
}

impl Options {
    pub const fn list(self) -> Option<&'static str> {
        match self {
            Self::Rows => None,
            Self::Of { list, .. } => Some(list),
        }
    }
}

/// Everything that is said of one kind of step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Row {
    pub tick: Tick,
    /// Its line of pseudocode.
    pub line: usize,
    /// Catalogue key of the sentence; the sentence's variables are names.
    pub key: &'static str,
    /// Templates of the formulas after the sentence; one whose names are not all alive is left out.
    pub so: &'static [&'static str],
    pub about: Option<&'static str>,
    pub decides: Decides,
    pub answers: Option<Question>,
    /// Catalogue key of the answer, where the sentence has names that are not alive before the answer is known.
    pub option: Option<&'static str>,
    /// Do all steps since the last phase began lead to the answer?
    pub is_of_phase: bool,
}

impl Row {
    pub const fn new(tick: Tick, line: usize, key: &'static str) -> Self {
        Self {
            tick,
            line,
            key,
            so: &[],
            about: None,
            decides: Decides::Nothing,
            answers: None,
            option: None,
            is_of_phase: false,
        }
    }

    pub const fn so(self, so: &'static [&'static str]) -> Self {
        Self { so, ..self }
    }

    /// About the thing of this name, and nothing is decided about it.
    pub const fn about(self, name: &'static str) -> Self {
        self.decides(name, Decides::Nothing)
    }

    pub const fn keeps(self, name: &'static str) -> Self {
        self.decides(name, Decides::Keeps)
    }

    pub const fn cuts(self, name: &'static str) -> Self {
        self.decides(name, Decides::Cuts)
    }

    pub const fn drops(self, name: &'static str) -> Self {
        self.decides(name, Decides::Drops)
    }

    const fn decides(self, name: &'static str, decides: Decides) -> Self {
        let about = Some(name);
        Self {
            about,
            decides,
            ..self
        }
    }

    /// One of the answers to a question whose options are all rows that answer it, and the entries of a list where another row
    /// picks one of these.
    pub const fn answers(self, id: &'static str) -> Self {
        let options = Options::Rows;
        let answers = Some(Question { id, options });
        Self { answers, ..self }
    }

    /// The same; as an option it is said by a message of its own.
    pub const fn answers_as(self, id: &'static str, option: &'static str) -> Self {
        let option = Some(option);
        Self {
            option,
            ..self.answers(id)
        }
    }

    /// Answers which entry of `list` it is: the one that `name` stands for.
    pub const fn picks(self, name: &'static str, list: &'static str) -> Self {
        let options = Options::Of { name, list };
        let answers = Some(Question { id: name, options });
        Self { answers, ..self }
    }

    /// The same; each entry is said within a message of its own, as its variable `option`.
    pub const fn picks_as(
        self,
        name: &'static str,
        list: &'static str,
        option: &'static str,
    ) -> Self {
        let option = Some(option);
        Self {
            option,
            ..self.picks(name, list)
        }
    }

    /// The steps since the last phase began lead to the answer: whoever asks nothing on the way asks before them.
    pub const fn before_its_phase(self) -> Self {
        Self {
            is_of_phase: true,
            ..self
        }
    }
}

/// The table of a method within its `impl Telling`: every event must have a row, or the table does not compile. Guards may look
/// at the step, which is the one after the event; rows may take their keys from the method's type parameters.
///
/// ```text
/// table! { |event, step|
///     inside: Event::Plane { class: Inside, .. } => Row::new(Test, 1, "sphere-inside").keeps("plane");
///     last: Event::Done if step.held.class == Outside => Row::new(Reject, 4, "planes-done-outside");
/// }
/// ```
#[doc(hidden)]
#[macro_export]
macro_rules! table {
    (|$event:ident, $step:ident| $($name:ident: $pattern:pat $(if $guard:expr)? => $row:expr;)+) => {
        const ROWS: &'static [$crate::labs::telling::Row] = &[$($row),+];

        fn row_idx($step: &$crate::trace::Step<'_, Self>) -> usize {
            #[derive(Clone, Copy)]
            #[allow(non_camel_case_types, reason = "the names of rows, which are written once")]
            enum Which { $($name),+ }

            let Some($event) = $step.event() else {
                // Only the opening has no event, and nobody asks for its row here.
                return 0;
            };
            let which = match $event { $($pattern $(if $guard)? => Which::$name),+ };
            which as usize
        }
    };
}

pub use table;
