//! The words of the field: each with its spellings in four languages and a sentence of what it is.

use std::{collections::BTreeMap, sync::LazyLock};

use serde::Deserialize;

use crate::text::Lang;

/// A term in one language.
#[derive(PartialEq, Eq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Word {
    /// As it stands in a sentence: singular, plural, and so on.
    pub forms: Vec<String>,
    /// What it is, in a sentence.
    pub says: String,
    /// What must not be said for it: another word for the same thing, or one that means something else.
    #[serde(default)]
    pub never: Vec<String>,
}

#[derive(PartialEq, Eq, Debug, Deserialize)]
pub struct Term {
    /// The step that teaches it, `lesson/step`: none before it says the term.
    pub taught: String,
    /// In every language.
    #[serde(flatten)]
    pub words: BTreeMap<Lang, Word>,
}

/// The terms by their ids.
pub type Glossary = BTreeMap<String, Term>;

/// What is compiled in. A test keeps it complete.
///
/// # Panics
/// Where the file is no glossary.
pub fn glossary() -> &'static Glossary {
    static GLOSSARY: LazyLock<Glossary> = LazyLock::new(|| {
        let source = include_str!("../../assets/glossary.toml");
        toml::from_str(source).expect("assets/glossary.toml is a glossary")
    });
    &GLOSSARY
}
