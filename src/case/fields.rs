//! The fields that an algorithm takes, and those that a case gives.

use std::cell::Cell;

use crate::{
    geom::exponent,
    input::{Presence, Table},
};

use super::{
    prelude::*,
    raw::{Node, Pairs},
};

/// The fields of one case, after a check against those that its algorithm takes; or those of an object in it.
pub struct Fields<'a> {
    /// The object that they are fields of, where it is not the case itself.
    within: Option<&'a Path<'a>>,
    takes: &'static [Field],
    given: Vec<(&'static str, &'a RawValue)>,
    detail: Detail,
    /// Were all numbers moderate that have been read?
    is_moderate: Cell<bool>,
}

impl<'a> Fields<'a> {
    /// Refuses fields that are not among those that the algorithm of this name `takes`, then missing ones. `id`,
    /// `submission` and `algorithm` are left out.
    pub(super) fn check(
        name_key: &'static str,
        takes: &'static [Field],
        pairs: &Pairs<'a>,
        detail: Detail,
    ) -> Result<Self, Refusal> {
        let is_own = |name: &str| !matches!(name, "id" | "submission" | "algorithm");
        let pairs = pairs.0.iter().filter(|(name, _)| is_own(name));
        Self::checked(None, (name_key, takes), pairs, detail)
    }

    /// Those of an object: refuses one that is given twice, too.
    pub(super) fn of(node: &'a Node<'a>, table: &Table, detail: Detail) -> Result<Self, Refusal> {
        let pairs = node.pairs()?;
        pairs.check_once(|name| Path::Member(&node.path, name))?;
        let takes = (table.name_key, table.fields);
        Self::checked(Some(&node.path), takes, pairs.0.iter(), detail)
    }

    fn checked<'p>(
        within: Option<&'a Path<'a>>,
        (name_key, takes): (&'static str, &'static [Field]),
        pairs: impl Iterator<Item = &'p (String, &'a RawValue)>,
        detail: Detail,
    ) -> Result<Self, Refusal>
    where
        'a: 'p,
    {
        let mut given: Vec<(&'static str, &'a RawValue)> = Vec::with_capacity(takes.len());
        for (name, raw) in pairs {
            match takes.iter().find(|field| field.name == name) {
                Some(field) => given.push((field.name, raw)),
                None => return Err(unknown(&path(within, name), name_key, takes)),
            }
        }
        let is_given = |field: &&Field| given.iter().any(|(name, _)| *name == field.name);
        let choices = || takes.iter().filter(|field| field.need == Presence::Choice);
        let mut chosen = choices().filter(is_given);
        let (first, second) = (chosen.next(), chosen.next());
        for field in takes.iter().filter(|field| !is_given(field)) {
            let place = path(within, field.name);
            match field.need {
                Presence::Required => return Err(missing(&place)),
                Presence::Choice if first.is_none() => {
                    let fields = quoted(choices());
                    let problem = Message::new("case-missing-choice").with("fields", fields);
                    return Err(Refusal::at(Code::MissingField, &place, problem));
                }
                Presence::Choice | Presence::Optional => {}
            }
        }
        if let (Some(first), Some(second)) = (first, second) {
            let problem = Message::new("case-both")
                .with("one", first.name.to_owned())
                .with("other", second.name.to_owned());
            let place = path(within, second.name);
            return Err(Refusal::at(Code::UnknownField, &place, problem));
        }
        Ok(Self {
            within,
            takes,
            given,
            detail,
            is_moderate: Cell::new(true),
        })
    }

    /// How much is written of the case, and so how large it may be: see [`Detail::limit`].
    #[must_use]
    pub const fn detail(&self) -> Detail {
        self.detail
    }

    /// This part of the case, where it is given.
    ///
    /// # Errors
    /// What is wrong with its value, or with what it means.
    pub fn get<T>(&self, part: &Part<T>) -> Result<Option<T>, Refusal> {
        let node = self.node(part.name());
        node.map(|node| self.make(part, &node)).transpose()
    }

    fn make<T>(&self, part: &Part<T>, node: &Node<'_>) -> Result<T, Refusal> {
        let got = node.got(part.optional.shape, self.detail)?;
        self.is_moderate
            .set(self.is_moderate.get() && got.is_moderate());
        (part.make)(&got).map_err(|fault| Refusal::of(&node.path, fault))
    }

    /// This part of the case, which must be there.
    ///
    /// # Errors
    /// `missing-field`, or as for [`Fields::get`].
    pub fn need<T>(&self, part: &Part<T>) -> Result<T, Refusal> {
        let found = self.get(part)?;
        found.ok_or_else(|| missing(&path(self.within, part.name())))
    }

    pub(super) fn has<T>(&self, part: &Part<T>) -> bool {
        self.node(part.name()).is_some()
    }

    pub(super) fn each<T>(
        &self,
        name: &'static str,
        part: &Part<T>,
    ) -> Result<Option<Vec<T>>, Refusal> {
        let Some(list) = self.node(name) else {
            return Ok(None);
        };
        let entries = list.entries("json-list")?;
        let made = entries.map(|node| self.make(part, &node));
        made.collect::<Result<_, _>>().map(Some)
    }

    /// What is wrong with this part of the case, together with others.
    #[must_use]
    pub fn refuse<T>(&self, part: &Part<T>, fault: impl Into<Fault>) -> Refusal {
        Refusal::of(&path(self.within, part.name()), fault.into())
    }

    /// It is too much: the field that takes the most room is to blame.
    pub(super) fn too_much(&self, problem: Message) -> Refusal {
        let longest = self.given.iter().max_by_key(|(_, raw)| raw.get().len());
        match longest {
            Some((name, _)) => Refusal::at(Code::TooLarge, &path(self.within, name), problem),
            None => Refusal::whole(Code::TooLarge, problem),
        }
    }

    /// Were all numbers that have been read such that nothing worked out of them can leave the range of f64?
    pub(super) const fn is_moderate(&self) -> bool {
        self.is_moderate.get()
    }

    /// A number of the answer would be none: the largest of the case is to blame, or where none is large, the smallest.
    #[must_use]
    pub fn beyond_range(&self, key: &'static str) -> Refusal {
        let mut worst = (0, Refusal::whole(Code::NotFinite, Message::new(key)));
        for field in self.takes {
            let Some(node) = self.node(field.name) else {
                continue;
            };
            let seen = node.each_number(field.shape, self.detail, &mut |node, x| {
                let blame = match exponent(&[x]) {
                    large @ 100.. => large + 2000,
                    small => small.abs(),
                };
                if blame > worst.0 {
                    let problem = Message::new(key).with("number", short(node.raw.get()));
                    worst = (blame, Refusal::at(Code::NotFinite, &node.path, problem));
                }
            });
            debug_assert!(seen.is_ok(), "all fields have been read before");
        }
        worst.1
    }

    pub(super) fn told(&self) -> Vec<Given> {
        let told = self.takes.iter().flat_map(|field| {
            let node = self.node(field.name);
            let got = node.and_then(|node| node.got(field.shape, self.detail).ok());
            field.given(got.as_ref())
        });
        told.collect()
    }

    pub(super) fn all(&self) -> Result<Got, Refusal> {
        let given = self.takes.iter().filter_map(|field| {
            let node = self.node(field.name)?;
            let got = node.got(field.shape, self.detail);
            Some(got.map(|got| (field.name, got)))
        });
        given.collect::<Result<_, _>>().map(Got::Table)
    }

    pub(super) fn node(&self, name: &'static str) -> Option<Node<'a>> {
        let (_, raw) = self.given.iter().find(|(given, _)| *given == name)?;
        let path = path(self.within, name);
        Some(Node { path, raw })
    }
}

const fn path<'p>(within: Option<&'p Path<'p>>, name: &'p str) -> Path<'p> {
    match within {
        Some(object) => Path::Member(object, name),
        None => Path::Field(name),
    }
}

pub(super) fn missing(place: &Path<'_>) -> Refusal {
    let problem = Message::new("case-missing-field").with("name", place.to_string());
    Refusal::at(Code::MissingField, place, problem)
}

fn unknown(place: &Path<'_>, name_key: &'static str, takes: &[Field]) -> Refusal {
    let problem = Message::new("case-unknown-field")
        .with("name", short(&place.to_string()))
        .with("algorithm", Value::Term(name_key))
        .with("expected", quoted(takes.iter()));
    Refusal::at(Code::UnknownField, place, problem)
}

fn quoted<'f>(fields: impl Iterator<Item = &'f Field>) -> String {
    let names: Vec<&str> = fields.map(|field| field.name).collect();
    names.join(", ")
}

impl Node<'_> {
    /// Calls back with every number of a value of this shape, and its place.
    fn each_number(
        &self,
        shape: &Shape,
        detail: Detail,
        see: &mut impl FnMut(&Node<'_>, f64),
    ) -> Result<(), Refusal> {
        match shape {
            Shape::Number | Shape::Numbers([]) => see(self, self.number()?),
            Shape::Numbers([_, inner @ ..]) => {
                for node in self.entries("json-list")? {
                    node.each_number(&Shape::Numbers(inner), detail, see)?;
                }
            }
            Shape::List(entry) => {
                for node in self.entries("json-list")? {
                    node.each_number(entry, detail, see)?;
                }
            }
            Shape::Table(table) => {
                let fields = Fields::of(self, table, detail)?;
                for field in table.fields {
                    if let Some(node) = fields.node(field.name) {
                        node.each_number(field.shape, detail, see)?;
                    }
                }
            }
            Shape::OrNull(shape) => self.each_number(shape, detail, see)?,
            Shape::Bool | Shape::Whole(..) | Shape::Wholes(..) | Shape::Text | Shape::Word(_) => {}
        }
        Ok(())
    }

    pub(super) fn got(&self, shape: &Shape, detail: Detail) -> Result<Got, Refusal> {
        match shape {
            Shape::Number => self.number().map(Got::Number),
            Shape::Text => self.text().map(Got::Text),
            Shape::Word(words) => self.word(words),
            Shape::Numbers(dims) => {
                let mut numbers = Vec::new();
                self.numbers(dims, detail, &mut numbers)?;
                Ok(Got::Numbers(numbers))
            }
            Shape::Wholes(dims, ..) => self.wholes(dims, detail),
            Shape::Table(table) => Fields::of(self, table, detail)?.all(),
            Shape::List(entry) => {
                let entries = self.entries("json-list")?;
                let got = entries.map(|node| node.got(entry, detail));
                got.collect::<Result<_, _>>().map(Got::List)
            }
            Shape::OrNull(shape) => self.got(shape, detail),
            // Answers alone have these.
            Shape::Bool | Shape::Whole(..) => Err(self.wrong_type("json-whole")),
        }
    }
}
