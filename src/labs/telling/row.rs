//! A row of a method's table, and the table itself.

use crate::figure::{Decides, Tick};

/// A question that some steps answer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Question {
    /// What this method calls it.
    pub id: &'static str,
    /// What might be answered.
    pub options: Options,
}

/// What might be answered to a question.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Options {
    /// What the rows that answer it say.
    Rows,
    /// The entries of a list; the right one is the value of a name.
    Of {
        /// The name of the right answer.
        name: &'static str,
        /// The list of all answers.
        list: &'static str,
    },
}

/// Everything that is said of one kind of step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Row {
    /// The shape of its tick on the timeline.
    pub tick: Tick,
    /// Its line of pseudocode.
    pub line: usize,
    /// Catalogue key of the sentence; the sentence's variables are names.
    pub key: &'static str,
    /// Templates of the formulas after the sentence; one whose names are not all alive is left out.
    pub so: &'static [&'static str],
    /// The name of what the step is about.
    pub about: Option<&'static str>,
    /// What the step decides about that.
    pub decides: Decides,
    /// The question that the step answers.
    pub answers: Option<Question>,
    /// Catalogue key of the answer, where the sentence has names that are not alive before the answer is known.
    pub option: Option<&'static str>,
}

impl Row {
    /// A row that decides nothing and answers nothing.
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
        }
    }

    /// With formulas.
    pub const fn so(self, so: &'static [&'static str]) -> Self {
        Self { so, ..self }
    }

    /// About the thing of this name, and nothing is decided about it.
    pub const fn about(self, name: &'static str) -> Self {
        self.decides(name, Decides::Nothing)
    }

    /// What the name stands for stays.
    pub const fn keeps(self, name: &'static str) -> Self {
        self.decides(name, Decides::Keeps)
    }

    /// What the name stands for is cut.
    pub const fn cuts(self, name: &'static str) -> Self {
        self.decides(name, Decides::Cuts)
    }

    /// What the name stands for is left out.
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

    /// One of the answers to a question whose options are all rows that answer it.
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
}

/// The rows of a method and of its parts, in one table of `N`.
pub const fn all_rows<const N: usize>(tables: &[&[Row]]) -> [Row; N] {
    let mut all = [tables[0][0]; N];
    let (mut n, mut i) = (0, 0);
    while i < tables.len() {
        let mut k = 0;
        while k < tables[i].len() {
            all[n] = tables[i][k];
            (n, k) = (n + 1, k + 1);
        }
        i += 1;
    }
    all
}

/// The table of a method, as a constant `ROWS`, and the function `row` that finds the row of a step: every event must have a row,
/// or the table does not compile. Guards may look at the step, which is the one after the event.
///
/// ```text
/// rows! { [L: CullRules] |event, step: SphereCull<L>|
///     inside: Event::Plane { class: Inside, .. } => Row::new(Test, 1, "sphere-inside").keeps("plane");
///     last: Event::Done if step.held.class == Outside => Row::new(Reject, 4, "planes-done-outside");
/// }
/// ```
macro_rules! rows {
    ($([$($generics:tt)*])? |$event:ident, $step:ident: $M:ty| $($name:ident: $pattern:pat $(if $guard:expr)? => $row:expr;)+) => {
        #[derive(Clone, Copy)]
        #[allow(non_camel_case_types, reason = "the names of rows, which are written once")]
        enum Which { $($name),+ }

        const ROWS: &[$crate::labs::telling::Row] = &[$($row),+];

        fn row$(<$($generics)*>)?($step: &$crate::trace::Step<'_, $M>) -> &'static $crate::labs::telling::Row {
            let Some($event) = $step.event() else {
                // Only the opening has no event, and nobody asks for its row here.
                return &ROWS[0];
            };
            let which = match $event { $($pattern $(if $guard)? => Which::$name),+ };
            &ROWS[which as usize]
        }
    };
}

/// The same within `impl Telling`, of a method with type parameters: the rows may take their keys from these.
macro_rules! table {
    (|$event:ident, $step:ident| $($name:ident: $pattern:pat $(if $guard:expr)? => $row:expr;)+) => {
        const ROWS: &'static [$crate::labs::telling::Row] = &[$($row),+];

        fn row($step: &$crate::trace::Step<'_, Self>) -> &'static $crate::labs::telling::Row {
            #[derive(Clone, Copy)]
            #[allow(non_camel_case_types, reason = "the names of rows, which are written once")]
            enum Which { $($name),+ }

            let Some($event) = $step.event() else {
                // Only the opening has no event, and nobody asks for its row here.
                return &Self::ROWS[0];
            };
            let which = match $event { $($pattern $(if $guard)? => Which::$name),+ };
            &Self::ROWS[which as usize]
        }
    };
}

pub(crate) use rows;
pub(crate) use table;
