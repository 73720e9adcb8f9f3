//! The four languages Clipscope speaks, by the names that files, flags and systems give them.

use std::fmt;

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

    pub fn from_id(id: &str) -> Option<Self> {
        let mut all = Self::ALL.into_iter();
        all.find(|lang| lang.id().eq_ignore_ascii_case(id))
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

    /// What keeps the thousands of a large number apart; a line never ends there.
    pub const fn thousands_separator(self) -> &'static str {
        match self {
            Self::En | Self::ZhCn => ",",
            Self::Es => "\u{a0}",
            Self::PtBr => ".",
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_read_back() {
        for lang in Lang::ALL {
            assert_eq!(Lang::from_id(lang.id()), Some(lang));
            assert_eq!(serde_json::json!(lang), serde_json::json!(lang.id()));
        }
        assert_eq!(Lang::from_id("PT-br"), Some(Lang::PtBr));
        assert_eq!(Lang::from_id("fr"), None);
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
