//! The words of the field: each with its spellings in a language and a sentence of what it is.

use std::{collections::BTreeMap, sync::OnceLock};

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

/// The terms by their ids, in one language.
pub type Glossary = BTreeMap<String, Word>;

/// The terms in a language; none while a page has not fetched its texts. A test keeps all of them complete.
pub fn glossary(lang: Lang) -> Option<&'static Glossary> {
    static GLOSSARIES: [OnceLock<Glossary>; Lang::ALL.len()] =
        [const { OnceLock::new() }; Lang::ALL.len()];
    let source = source(lang)?;
    // What does not parse marks no words, and is named by the tests.
    let read = || toml::from_str(source).unwrap_or_default();
    Some(GLOSSARIES[lang as usize].get_or_init(read))
}

macro_rules! words {
    ($lang:literal) => {
        include_str!(concat!("../../assets/glossary/", $lang, ".toml"))
    };
}

#[cfg(not(feature = "slim"))]
#[expect(clippy::unnecessary_wraps, reason = "a page may have none yet")]
const fn source(lang: Lang) -> Option<&'static str> {
    Some(match lang {
        Lang::En => words!("en"),
        Lang::ZhCn => words!("zh-CN"),
        Lang::Es => words!("es"),
        Lang::PtBr => words!("pt-BR"),
    })
}

#[cfg(feature = "slim")]
fn source(lang: Lang) -> Option<&'static str> {
    use crate::text::Part;
    match lang {
        Lang::En => Some(words!("en")),
        Lang::ZhCn | Lang::Es | Lang::PtBr => {
            let file = Part::Texts(lang).get(&format!("{lang}.toml"))?;
            str::from_utf8(file).ok()
        }
    }
}
