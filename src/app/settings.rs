//! What the app remembers from one time to the next.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{paint::ThemeKind, text::Lang};

use super::{
    desk::{Page, StoredWork},
    dialog::Figures,
};

#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    pub lang: Lang,
    pub theme: ThemeKind,
    pub course: bool,
    pub inspector: bool,
    pub snap: bool,
    /// Steps a second.
    pub speed: f32,
    pub figures: Option<Figures>,
    pub page: Option<Page>,
    /// The page of each lab that was open last, by the lab's id.
    pub labs: BTreeMap<String, Page>,
    pub works: Vec<StoredWork>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            lang: Lang::En,
            theme: ThemeKind::Light,
            course: true,
            inspector: true,
            snap: true,
            speed: 1.0,
            figures: None,
            page: None,
            labs: BTreeMap::new(),
            works: Vec::new(),
        }
    }
}

impl Settings {
    /// As on a first start: in the language that `locales` asks for, the most wanted one first.
    pub fn for_locales<'a>(locales: impl IntoIterator<Item = &'a str>) -> Self {
        let lang = locales.into_iter().find_map(Lang::from_locale);
        Self {
            lang: lang.unwrap_or_default(),
            ..Self::default()
        }
    }

    #[cfg(not(target_arch = "wasm32"))]
    pub fn of_system() -> Self {
        // As gettext reads them.
        let names = ["LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG"];
        let values = names.iter().filter_map(|name| std::env::var(name).ok());
        let values: Vec<String> = values.collect();
        Self::for_locales(values.iter().flat_map(|value| value.split(':')))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_language_that_is_known_wins() {
        let lang = |locales: &[&str]| Settings::for_locales(locales.iter().copied()).lang;
        assert_eq!(lang(&["fr_FR", "pt_BR.UTF-8", "en"]), Lang::PtBr);
        assert_eq!(lang(&["C.UTF-8"]), Lang::En);
        assert_eq!(lang(&[]), Lang::En);
    }

    #[test]
    fn settings_of_another_version_are_read_as_far_as_they_go() {
        let read: Settings =
            serde_json::from_str(r#"{"theme": "dark", "gone": 1}"#).expect("valid");
        assert_eq!((read.theme, read.snap), (ThemeKind::Dark, true));
    }
}
