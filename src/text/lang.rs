//! The four languages Clipscope speaks, by the names that files, flags and systems give them.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

#[derive(
    Clone, Copy, PartialEq, Eq, Debug, Default, Hash, PartialOrd, Ord, Serialize, Deserialize,
)]
pub enum Lang {
    /// English: complete at all times, and what the others fall back to.
    #[default]
    #[serde(rename = "en")]
    En,
    #[serde(rename = "zh-CN")]
    ZhCn,
    #[serde(rename = "es")]
    Es,
    #[serde(rename = "pt-BR")]
    PtBr,
}

impl Lang {
    pub const ALL: [Self; 4] = [Self::En, Self::ZhCn, Self::Es, Self::PtBr];

    /// The BCP 47 tag that files and the command line use.
    pub const fn id(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::ZhCn => "zh-CN",
            Self::Es => "es",
            Self::PtBr => "pt-BR",
        }
    }

    pub const fn native_name(self) -> &'static str {
        match self {
            Self::En => "English",
            Self::ZhCn => "简体中文",
            Self::Es => "Español",
            Self::PtBr => "Português (Brasil)",
        }
    }

    /// Only the language counts: a reader in Lisbon is better served by the nearest catalogue than by English.
    pub fn from_locale(tag: &str) -> Option<Self> {
        let language = tag.split(['-', '_', '.', '@']).next()?;
        let is_of = |lang: &Self| {
            let mut parts = lang.id().split('-');
            parts
                .next()
                .is_some_and(|id| id.eq_ignore_ascii_case(language))
        };
        Self::ALL.into_iter().find(is_of)
    }

    pub const fn decimal_separator(self) -> char {
        match self {
            Self::En | Self::ZhCn => '.',
            Self::Es | Self::PtBr => ',',
        }
    }

    /// What stands between coordinates: never to be taken for a decimal separator.
    pub const fn list_separator(self) -> &'static str {
        match self {
            Self::En | Self::ZhCn => ", ",
            Self::Es | Self::PtBr => "; ",
        }
    }
}

impl fmt::Display for Lang {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.id())
    }
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownLang(pub String);

impl fmt::Display for UnknownLang {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ids = Lang::ALL.map(Lang::id).join(", ");
        write!(f, "unknown language {:?}: expected one of {ids}", self.0)
    }
}

impl std::error::Error for UnknownLang {}

impl FromStr for Lang {
    type Err = UnknownLang;

    fn from_str(id: &str) -> Result<Self, UnknownLang> {
        Self::ALL
            .into_iter()
            .find(|lang| lang.id().eq_ignore_ascii_case(id))
            .ok_or_else(|| UnknownLang(id.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_read_back() {
        for lang in Lang::ALL {
            assert_eq!(lang.id().parse(), Ok(lang));
            assert_eq!(serde_json::json!(lang), serde_json::json!(lang.id()));
        }
        assert_eq!("PT-br".parse(), Ok(Lang::PtBr));
    }

    #[test]
    fn an_unknown_id_is_answered_with_the_four() {
        let error = "fr"
            .parse::<Lang>()
            .expect_err("there is no French catalogue");
        assert_eq!(
            error.to_string(),
            "unknown language \"fr\": expected one of en, zh-CN, es, pt-BR"
        );
    }

    #[test]
    fn locales_find_their_language() {
        for (tag, expected) in [
            ("en_US.UTF-8", Some(Lang::En)),
            ("pt_BR.UTF-8", Some(Lang::PtBr)),
            ("pt", Some(Lang::PtBr)),
            ("zh-Hans", Some(Lang::ZhCn)),
            ("zh_CN", Some(Lang::ZhCn)),
            ("es-MX", Some(Lang::Es)),
            ("es_ES@euro", Some(Lang::Es)),
            ("ES", Some(Lang::Es)),
            ("C.UTF-8", None),
            ("POSIX", None),
            ("est", None),
            ("fr_FR", None),
            ("", None),
        ] {
            assert_eq!(Lang::from_locale(tag), expected, "locale {tag:?}");
        }
    }
}
