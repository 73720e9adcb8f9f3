//! What is told of a step whatever its method is: sentences, formulas, the watch table and what might come. Compiled once, from
//! what the method names.

use std::ops::Deref;

use crate::{
    figure::{Caption, Choice, Decides, Glimpse, Link, Watch, WatchSection},
    text::{Catalog, Message, Value},
};

use super::{At, Named, Options, Question, Row, Telling, Watched};

/// A step of any method, with what that says of it.
pub trait Teller {
    fn rows(&self) -> &'static [Row];
    fn row(&self) -> &'static Row;
    fn named(&self, name: &str) -> Option<Named>;
    fn listed(&self, list: &str) -> Vec<Named>;
    fn part(&self, list: &str) -> Option<[usize; 2]>;
    fn glimpse(&self, row: &Row, link: Option<Link>) -> Glimpse;
}

impl<M: Telling> Teller for At<'_, M> {
    fn rows(&self) -> &'static [Row] {
        M::ROWS
    }

    fn row(&self) -> &'static Row {
        match self.step.past {
            [] => M::opening(self),
            _ => M::row_at(self),
        }
    }

    fn named(&self, name: &str) -> Option<Named> {
        M::named(self, name)
    }

    fn listed(&self, list: &str) -> Vec<Named> {
        M::listed(self, list)
    }

    fn part(&self, list: &str) -> Option<[usize; 2]> {
        M::part(self, list)
    }

    fn glimpse(&self, row: &Row, link: Option<Link>) -> Glimpse {
        M::glimpse(self, row, link)
    }
}

impl<'a, M: Telling> Deref for At<'a, M> {
    type Target = dyn Teller + 'a;

    fn deref(&self) -> &Self::Target {
        self
    }
}

impl dyn Teller + '_ {
    pub fn value(&self, name: &str) -> Option<Value> {
        self.named(name)?.value
    }

    /// The sentence of a key of the catalogue: its variables are names.
    pub fn message(&self, key: &'static str) -> Message {
        let names = Catalog::variables(key).iter();
        names.fold(Message::new(key), |message, &name| {
            match self.value(name) {
                Some(value) => message.with(name, value),
                // Filled in for each option.
                None if name == OPTION => message,
                None => message.with(name, missing(name)),
            }
        })
    }

    pub fn caption(&self) -> Caption {
        let row = self.row();
        let formulas = row.so.iter().filter_map(|template| self.formula(template));
        formulas.fold(Caption::new(self.message(row.key)), Caption::so)
    }

    /// The sections of a watch table that have a row now.
    pub fn filled(&self, watched: &[Watched]) -> Watch {
        let sections = watched.iter().map(|watched| self.section(watched));
        sections.filter(|it| !it.rows.is_empty()).collect()
    }

    pub fn section(&self, watched: &Watched) -> WatchSection {
        let names = |names: &[&'static str]| {
            let alive = names
                .iter()
                .filter_map(|&name| Some(self.named(name)?.watched(name)));
            WatchSection::list(alive.collect())
        };
        let list = |list: &'static str| {
            let entries = self.listed(list).into_iter();
            let section = WatchSection::list(entries.map(|entry| entry.watched(list)).collect());
            match self.part(list) {
                Some([first, of]) => section.part(first, of),
                None => section,
            }
        };
        match *watched {
            Watched::Names(of) => names(of),
            Watched::Seen(of, view) => names(of).seen_in(view),
            Watched::List(of) => list(of),
            Watched::ListSeen(of, view) => list(of).seen_in(view),
        }
    }

    pub fn decision(&self) -> Option<(Decides, Link)> {
        let row = self.row();
        let link = self.named(row.about?)?.link?;
        (row.decides != Decides::Nothing).then_some((row.decides, link))
    }

    /// What might come at this step, and which of these does; none where the step answers no question.
    pub fn options(&self) -> Option<Choice> {
        let row = self.row();
        let question = row.answers?;
        let mut options = self.answering(question.id);
        let right = match question.options {
            Options::Rows => self.said(row),
            Options::Of { name, .. } => self.said_of(row, self.value(name)?),
        };
        let rows = self.rows().iter();
        let of_list = rows.filter_map(|other| Some((other, other.answers?)));
        let mut of_list = of_list.filter(|(_, other)| other.id == question.id);
        let listed = of_list.find_map(|(other, it)| Some((other, it.options.list()?)));
        if let Some((of_list, list)) = listed {
            let said = |value| self.said_of(of_list, value);
            let entries = self.listed(list).into_iter();
            options.extend(entries.filter_map(|it| Some((said(it.value?), it.link, of_list))));
        }
        let right = options.iter().position(|(option, ..)| *option == right)?;
        let glimpses = options.iter();
        let glimpses = glimpses.map(|(_, link, row)| self.glimpse(row, *link));
        Some(Choice {
            question: question.id,
            glimpses: glimpses.collect(),
            links: options.iter().map(|(_, link, _)| *link).collect(),
            options: options.into_iter().map(|(option, ..)| option).collect(),
            right,
            is_of_phase: row.is_of_phase,
        })
    }

    /// The rows that answer a question as they are, each once.
    fn answering(&self, id: &'static str) -> Vec<Answered> {
        let question = Question {
            id,
            options: Options::Rows,
        };
        let mut options: Vec<Answered> = Vec::new();
        for row in self
            .rows()
            .iter()
            .filter(|row| row.answers == Some(question))
        {
            let option = self.said(row);
            if options.iter().all(|(known, ..)| *known != option) {
                options.push((option, None, row));
            }
        }
        options
    }

    fn said(&self, row: &Row) -> Value {
        Value::Message(self.message(row.option.unwrap_or(row.key)))
    }

    /// An entry of a list, as the row says it that picks one.
    fn said_of(&self, row: &Row, entry: Value) -> Value {
        match row.option {
            Some(key) => Value::Message(self.message(key).with(OPTION, entry)),
            None => entry,
        }
    }
}

/// In the message of an option: the entry of the list.
const OPTION: &str = "option";

/// An option as it is said, what it is about, and its row.
type Answered = (Value, Option<Link>, &'static Row);

/// What stands for a name that is not alive: no sentence may hold it, and a test walks every step for that.
fn missing(name: &str) -> Value {
    Value::Name(format!("⟦{name}⟧"))
}
