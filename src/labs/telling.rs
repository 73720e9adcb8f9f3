//! How a method tells its steps: one table of rows, one resolver of names, and its views.
//!
//! A [`Row`] says everything about one kind of step; its sentence and its formulas take their values by name from
//! [`Telling::named`], and so does the watch table. A step is never told anywhere else.

mod row;
mod teller;
mod template;

use serde::{Serialize, Serializer};

use crate::{
    figure::{Glimpse, Link, View, Watch, WatchRow},
    text::{Catalog, Value},
    trace::{Method, Step},
};

use super::{CodeLine, MethodCard};

pub use row::{Options, Question, Row, table};

/// An answer that can be written down: the fields of `output`.
pub trait Answer {
    /// Written as it is serialised, number by number: of a large answer nothing else is made.
    fn told(&self) -> impl Serialize;
}

/// One that is written down as it serialises.
pub trait AnswerAsItIs: Serialize {}

impl<A: AnswerAsItIs> Answer for A {
    fn told(&self) -> impl Serialize {
        self
    }
}

/// A list whose entries are made while it is written.
pub struct Each<F>(pub F);

impl<F: Fn() -> I, I: Iterator<Item: Serialize>> Serialize for Each<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq((self.0)())
    }
}

pub trait Telling:
    Method<Input: Send, Held: Send, Output: Answer, Event: Serialize + Send> + 'static
{
    /// What is drawn around a run: the space of a scene; `()` in the plane.
    type Scenery: Send + Sync + 'static;

    const ID: &'static str;
    const NAME_KEY: &'static str;
    /// Author and year.
    const SOURCE: &'static str;
    const CODE: &'static [CodeLine];
    /// Of a method that is wrong on purpose: what is said at the first step that the right one does not do.
    const DIFFERS_KEY: Option<&'static str> = None;
    /// Does it show where a formula comes from, and answers nothing?
    const IS_PROOF: bool = false;
    const ROWS: &'static [Row];
    const WATCH: &'static [Watched];

    /// Which row is that of the last event of a step, which is not the first.
    fn row_idx(step: &Step<'_, Self>) -> usize;

    /// The row of the last event of a step.
    fn row(step: &Step<'_, Self>) -> &'static Row {
        &Self::ROWS[Self::row_idx(step)]
    }

    /// The row of a step where it is said in another way because of what is drawn around the run; tick and line are those of
    /// [`row`](Self::row).
    fn row_at(at: &At<'_, Self>) -> &'static Row {
        Self::row(&at.step)
    }

    /// What is said before the first event.
    const OPENING: Row;

    /// The same, where it is said in another way because of the input or of what is drawn around the run.
    fn opening(_: &At<'_, Self>) -> &'static Row {
        const { &Self::OPENING }
    }

    /// The value of a name at a step; none where the name is not alive, or no name of this method.
    fn named(at: &At<'_, Self>, name: &str) -> Option<Named>;

    #[must_use]
    fn listed(_: &At<'_, Self>, _list: &str) -> Vec<Named> {
        Vec::new()
    }

    /// What is shown of an option while this step is asked about: of the row that it is, or of what it is about.
    #[must_use]
    fn glimpse(_: &At<'_, Self>, _: &Row, _: Option<Link>) -> Glimpse {
        Glimpse::Nothing
    }

    /// Of a list that is only a part of what it stands for: the place of its first entry, and how long all of it is.
    #[must_use]
    fn part(_: &At<'_, Self>, _list: &str) -> Option<[usize; 2]> {
        None
    }

    /// The watch table. Only a method with a table of several columns says it in another way.
    #[must_use]
    fn watch(at: &At<'_, Self>) -> Watch {
        Self::WATCH
            .iter()
            .map(|watched| at.section(watched))
            .collect()
    }

    /// What is shown: first the drawing, without the backdrop, then what the method holds.
    fn views(at: &At<'_, Self>) -> Vec<View>;
}

impl MethodCard {
    pub const fn of<M: Telling>() -> Self {
        let is_faulty = M::DIFFERS_KEY.is_some();
        Self {
            id: M::ID,
            name_key: M::NAME_KEY,
            source: M::SOURCE,
            code: M::CODE,
            is_faulty,
            is_proof: M::IS_PROOF,
            group_key: match (is_faulty, M::IS_PROOF) {
                (true, _) => Some("faulty-title"),
                (false, true) => Some("methods-why"),
                (false, false) => None,
            },
        }
    }
}

pub struct At<'a, M: Telling> {
    pub step: Step<'a, M>,
    /// What is drawn around the run; none where a case gives numbers alone.
    pub scenery: Option<&'a M::Scenery>,
}

impl<M: Telling> Clone for At<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: Telling> Copy for At<'_, M> {}

#[derive(Clone, PartialEq, Debug)]
pub struct Named {
    /// Its value; none where the watch table has an empty cell.
    pub value: Option<Value>,
    /// What the watch table calls it, where not by its name.
    pub label: Option<Value>,
    /// The watch table's word on the value: "left", "≠ 0".
    pub note: Option<Value>,
    pub link: Option<Link>,
}

impl<V: Into<Value>> From<V> for Named {
    fn from(value: V) -> Self {
        Self {
            value: Some(value.into()),
            ..Self::empty()
        }
    }
}

impl Named {
    /// A name that is alive and has no value yet: an empty cell.
    pub const fn empty() -> Self {
        Self {
            value: None,
            label: None,
            note: None,
            link: None,
        }
    }

    pub fn maybe(value: Option<impl Into<Value>>) -> Self {
        value.map_or(Self::empty(), Self::from)
    }

    pub fn linked(self, link: impl Into<Link>) -> Self {
        let link = Some(link.into());
        Self { link, ..self }
    }

    pub fn labelled(self, label: impl Into<Value>) -> Self {
        let label = Some(label.into());
        Self { label, ..self }
    }

    pub fn noted(self, note: impl Into<Value>) -> Self {
        let note = Some(note.into());
        Self { note, ..self }
    }

    fn watched(self, name: &'static str) -> WatchRow {
        let label = self.label.unwrap_or_else(|| called(name));
        WatchRow {
            note: self.note,
            link: self.link,
            ..WatchRow::new(label, self.value)
        }
    }
}

/// What the watch table calls a name that has no other label: a name that begins with `watch-` is a key of the catalogue.
fn called(name: &'static str) -> Value {
    if name.starts_with("watch-") {
        Value::Term(name)
    } else {
        Value::Name(name.to_owned())
    }
}

#[derive(Clone, Copy, Debug)]
pub enum Watched {
    /// One row a name, of those that are alive.
    Names(&'static [&'static str]),
    /// The same, and the view of this name shows them too.
    Seen(&'static [&'static str], &'static str),
    /// One row an entry of the list.
    List(&'static str),
    /// The same, and the view of this name shows them too.
    ListSeen(&'static str, &'static str),
}

/// All names that a method's sentences, formulas and watch table take, each once.
pub fn known_names(rows: &[Row], opening: &Row, watch: &[Watched]) -> Vec<&'static str> {
    let mut names = Vec::new();
    for row in rows.iter().chain([opening]) {
        names.extend_from_slice(Catalog::variables(row.key));
        names.extend(row.so.iter().flat_map(|template| template::names(template)));
    }
    for watched in watch {
        if let Watched::Names(of) | Watched::Seen(of, _) = watched {
            names.extend_from_slice(of);
        }
    }
    names.sort_unstable();
    names.dedup();
    names
}

/// All lists of a method's watch table and of its questions, each once.
pub fn known_lists(rows: &[Row], watch: &[Watched]) -> Vec<&'static str> {
    let watched = watch.iter().filter_map(|watched| match watched {
        Watched::List(of) | Watched::ListSeen(of, _) => Some(*of),
        Watched::Names(_) | Watched::Seen(..) => None,
    });
    let asked = rows.iter().filter_map(|row| match row.answers?.options {
        Options::Of { list, .. } => Some(list),
        Options::Rows => None,
    });
    let mut lists: Vec<&str> = watched.chain(asked).collect();
    lists.sort_unstable();
    lists.dedup();
    lists
}
