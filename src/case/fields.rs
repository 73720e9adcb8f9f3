//! The fields that an algorithm takes, and those that a case gives.

use serde_json::value::RawValue;

use crate::text::{Message, Value};

use super::{Code, Detail, Node, Path, Refusal, raw::Pairs, refusal::short};

/// Must a field be there?
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Presence {
    /// Always.
    Required,
    /// Exactly one of an algorithm's fields of this kind.
    Choice,
    /// It may be left out.
    Optional,
}

/// A field that an algorithm takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Field {
    /// As a case spells it.
    pub name: &'static str,
    /// Must it be there?
    pub need: Presence,
}

impl Field {
    /// A field that must be there.
    #[must_use]
    pub const fn required(name: &'static str) -> Self {
        let need = Presence::Required;
        Self { name, need }
    }

    /// One of several fields of which exactly one must be there.
    #[must_use]
    pub const fn choice(name: &'static str) -> Self {
        let need = Presence::Choice;
        Self { name, need }
    }

    /// A field that may be left out.
    #[must_use]
    pub const fn optional(name: &'static str) -> Self {
        let need = Presence::Optional;
        Self { name, need }
    }
}

/// The fields of one case, after a check against those that its algorithm takes; or those of an object in it.
pub struct Fields<'a> {
    /// The object that they are fields of, where it is not the case itself.
    within: Option<&'a Path<'a>>,
    given: Vec<(&'static str, &'a RawValue)>,
    detail: Detail,
}

impl<'a> Fields<'a> {
    /// Refuses fields that are not among those that the algorithm of this name `takes`, then missing ones. `id` and
    /// `algorithm` are left out.
    pub(super) fn check(
        name_key: &'static str,
        takes: &'static [Field],
        pairs: &Pairs<'a>,
        detail: Detail,
    ) -> Result<Self, Refusal> {
        let is_own = |name: &str| !matches!(name, "id" | "algorithm");
        let pairs = pairs.0.iter().filter(|(name, _)| is_own(name));
        Self::checked(None, name_key, takes, pairs, detail)
    }

    /// Those of an object, which is called by this key.
    ///
    /// # Errors
    /// `wrong-type`, `bad-json` where a field is given twice, `unknown-field` or `missing-field`
    pub fn of(
        node: &'a Node<'a>,
        name_key: &'static str,
        takes: &'static [Field],
        detail: Detail,
    ) -> Result<Self, Refusal> {
        let pairs = node.pairs()?;
        if let Some(name) = pairs.repeated() {
            let problem = Message::new("case-repeated-field").with("name", short(name));
            let place = Path::Member(&node.path, name);
            return Err(Refusal::at(Code::BadJson, &place, problem));
        }
        Self::checked(Some(&node.path), name_key, takes, pairs.0.iter(), detail)
    }

    fn checked<'p>(
        within: Option<&'a Path<'a>>,
        name_key: &'static str,
        takes: &'static [Field],
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
        let is_given = |name: &str| given.iter().any(|(given, _)| *given == name);
        let mut choices = takes.iter().filter(|f| f.need == Presence::Choice);
        let mut chosen = choices.clone().filter(|f| is_given(f.name));
        let (first, second) = (chosen.next(), chosen.next());
        for field in takes {
            match field.need {
                Presence::Required if !is_given(field.name) => {
                    return Err(missing(&path(within, field.name)));
                }
                Presence::Choice if first.is_none() => {
                    let names: Vec<&str> = choices.by_ref().map(|f| f.name).collect();
                    let problem = Message::new("case-missing-choice")
                        .with("fields", quoted(names.into_iter()));
                    return Err(Refusal::at(
                        Code::MissingField,
                        &path(within, field.name),
                        problem,
                    ));
                }
                _ => {}
            }
        }
        if let (Some(first), Some(second)) = (first, second) {
            let problem = Message::new("case-both")
                .with("one", first.name.to_owned())
                .with("other", second.name.to_owned());
            return Err(Refusal::at(
                Code::UnknownField,
                &path(within, second.name),
                problem,
            ));
        }
        Ok(Self {
            within,
            given,
            detail,
        })
    }

    /// How much is written of the case, and so how large it may be: see [`Detail::limit`].
    #[must_use]
    pub const fn detail(&self) -> Detail {
        self.detail
    }

    /// The field, where it is given.
    #[must_use]
    pub fn get(&self, name: &'static str) -> Option<Node<'a>> {
        let (_, raw) = self.given.iter().find(|(given, _)| *given == name)?;
        let path = path(self.within, name);
        Some(Node { path, raw })
    }

    /// The field.
    ///
    /// # Errors
    /// `missing-field`
    pub fn need(&self, name: &'static str) -> Result<Node<'a>, Refusal> {
        self.get(name)
            .ok_or_else(|| missing(&path(self.within, name)))
    }
}

/// Where a field stands: of the case, or of an object in it.
const fn path<'p>(within: Option<&'p Path<'p>>, name: &'p str) -> Path<'p> {
    match within {
        Some(object) => Path::Member(object, name),
        None => Path::Field(name),
    }
}

/// A field that must be there and is not.
pub(super) fn missing(place: &Path<'_>) -> Refusal {
    let problem = Message::new("case-missing-field").with("name", place.to_string());
    Refusal::at(Code::MissingField, place, problem)
}

fn unknown(place: &Path<'_>, name_key: &'static str, takes: &[Field]) -> Refusal {
    let problem = Message::new("case-unknown-field")
        .with("name", short(&place.to_string()))
        .with("algorithm", Value::Term(name_key))
        .with("expected", quoted(takes.iter().map(|f| f.name)));
    Refusal::at(Code::UnknownField, place, problem)
}

fn quoted(names: impl Iterator<Item = &'static str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}
