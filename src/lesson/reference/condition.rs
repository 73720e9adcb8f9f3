//! Conditions on the runs of a scene: `output.visible = false`, `cost.div < cost.div by cyrus-beck`, `event.edge @ cut = 'left'`.
//!
//! Each side is a reference, at the end of the run where it names no moment, or a word in single quotes; `true`, `false` and `null`
//! are words.

use crate::{
    figure::{Moment, Run},
    labs::Scene,
    lesson::prelude::*,
};

use super::{
    Reference,
    parse::{parse, unreadable},
    resolve::place,
};

/// Numbers that are nearer to each other than this part of them are equal: a drag and a division round.
const EQUAL: f64 = 1e-9;

#[derive(Clone, PartialEq, Debug)]
pub struct Condition {
    left: Side,
    relation: Relation,
    right: Side,
}

#[derive(Clone, PartialEq, Debug)]
enum Side {
    Word(String),
    Of(Reference),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Relation {
    Equal,
    Unequal,
    Less,
    More,
    AtMost,
    AtLeast,
}

impl Relation {
    /// Each before those that its sign begins with.
    const SIGNS: [(&'static str, Self); 9] = [
        ("!=", Self::Unequal),
        ("≠", Self::Unequal),
        ("<=", Self::AtMost),
        ("≤", Self::AtMost),
        (">=", Self::AtLeast),
        ("≥", Self::AtLeast),
        ("=", Self::Equal),
        ("<", Self::Less),
        (">", Self::More),
    ];

    const fn sign(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::Unequal => "≠",
            Self::Less => "<",
            Self::More => ">",
            Self::AtMost => "≤",
            Self::AtLeast => "≥",
        }
    }

    fn holds(self, a: f64, b: f64) -> bool {
        let is_equal = (a - b).abs() <= EQUAL * a.abs().max(b.abs()).max(1.0);
        match self {
            Self::Equal => is_equal,
            Self::Unequal => !is_equal,
            Self::Less => a < b && !is_equal,
            Self::More => a > b && !is_equal,
            Self::AtMost => a < b || is_equal,
            Self::AtLeast => a > b || is_equal,
        }
    }
}

impl Condition {
    /// # Errors
    /// Where it is no comparison of two references.
    pub fn parse(text: &str) -> Result<Self, Diagnostic> {
        let is_quoted = |at: usize| {
            let before = &text[..at];
            [34, 39]
                .iter()
                .any(|quote| before.bytes().filter(|b| b == quote).count() % 2 == 1)
        };
        let first = text.char_indices().find_map(|(at, _)| {
            let mut signs = Relation::SIGNS.into_iter();
            let (sign, relation) = signs.find(|(sign, _)| text[at..].starts_with(sign))?;
            (!is_quoted(at)).then_some((at, sign, relation))
        });
        let (at, sign, relation) = first.ok_or_else(unreadable)?;
        Ok(Self {
            left: Side::parse(text[..at].trim())?,
            relation,
            right: Side::parse(text[at + sign.len()..].trim())?,
        })
    }

    /// Does it hold of a scene with these runs, each with its method's id? What has no value there holds for nothing.
    pub fn holds(&self, scene: &Scene, runs: &[(&'static str, &dyn Run)]) -> bool {
        let number = |side: &Side| side.number(scene, runs);
        if let (Some(a), Some(b)) = (number(&self.left), number(&self.right)) {
            return self.relation.holds(a, b);
        }
        let word = |side: &Side| side.word(scene, runs);
        match (word(&self.left), word(&self.right), self.relation) {
            (Some(a), Some(b), Relation::Equal) => a == b,
            (Some(a), Some(b), Relation::Unequal) => a != b,
            _ => false,
        }
    }
}

impl Condition {
    /// Both sides, where they are numbers, with the sign between them.
    pub fn compared(
        &self,
        scene: &Scene,
        runs: &[(&'static str, &dyn Run)],
    ) -> Option<(f64, &'static str, f64)> {
        if self.relation == Relation::Unequal {
            return None;
        }
        let [a, b] = [&self.left, &self.right].map(|side| side.number(scene, runs));
        Some((a?, self.relation.sign(), b?))
    }
}

impl Side {
    fn parse(text: &str) -> Result<Self, Diagnostic> {
        let quoted = text
            .strip_prefix('\'')
            .and_then(|text| text.strip_suffix('\''));
        let plain = || {
            ["true", "false", "null"]
                .into_iter()
                .find(|word| *word == text)
        };
        match quoted.or_else(plain) {
            Some(word) => Ok(Self::Word(word.to_owned())),
            None => parse(text).map(Self::Of),
        }
    }

    fn number(&self, scene: &Scene, runs: &[(&'static str, &dyn Run)]) -> Option<f64> {
        let Self::Of(reference) = self else {
            return None;
        };
        let place = place(reference, scene, runs.iter().copied(), &Moment::End);
        place.ok()?.number(&reference.value).ok()
    }

    fn word(&self, scene: &Scene, runs: &[(&'static str, &dyn Run)]) -> Option<String> {
        match self {
            Self::Word(word) => Some(word.clone()),
            Self::Of(reference) => {
                let place = place(reference, scene, runs.iter().copied(), &Moment::End);
                place.ok()?.word(&reference.value)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::SceneFormats;

    #[test]
    fn a_condition_holds_of_the_run_that_it_names() {
        let text = r#"
            method = "cohen-sutherland"
            compare = "liang-barsky"
            window = [-1, -1, 1, 1]
            segments = [[0.5, 1.75, -2, -0.5]]
        "#;
        let scene = SceneFormats::standard().read("", text.as_bytes());
        let scene = scene.expect("a scene").scene;
        let recorded = scene.document().record();
        let runs = scene.by_method(recorded.iter().map(|run| &**run));
        for (text, holds) in [
            ("events(cut) = 2", true),
            ("events(cut left) = 1", true),
            ("events(cut bottom) > 0", false),
            ("output.visible = true", true),
            ("output.visible != false", true),
            ("output.segment = null", false),
            ("event.edge @ cut = 'left'", true),
            ("event.edge @ cut #2 = 'left'", false),
            ("event.edge @ cut #3 = 'left'", false),
            ("cost.div < cost.div by liang-barsky", true),
            ("cost.div ≥ cost.div by liang-barsky", false),
            ("output.segment[1] = 3 / 3", true),
            ("no-such-name = 3", false),
        ] {
            let condition = Condition::parse(text).unwrap_or_else(|_| panic!("{text}"));
            assert_eq!(condition.holds(&scene, &runs), holds, "{text}");
        }
        for text in ["", "events(cut)", "= 3", "cost.div =", "a = b ("] {
            assert!(Condition::parse(text).is_err(), "{text}");
        }
    }
}
