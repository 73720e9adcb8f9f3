//! What the app remembers from one time to the next.

use serde::{Deserialize, Serialize};

use crate::{
    figure::Moment,
    labs::Scene,
    lesson::{Progress, SceneFormats},
    paint::{ThemeKind, text_sizes::text_size},
    text::Lang,
    trace::Transport,
};

use super::{
    desk::{Places, StoredWork},
    dialog::Figures,
};

#[allow(
    clippy::struct_excessive_bools,
    reason = "each is so or not whatever the others are"
)]
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    pub lang: Lang,
    pub theme: ThemeKind,
    pub course: bool,
    pub inspector: bool,
    pub snap: bool,
    /// Do steps of lessons ask what comes before they show it?
    pub asks: bool,
    /// Does a practice mark its answers when the run is done, and not one by one?
    pub marks_at_end: bool,
    /// Steps a second.
    pub speed: f32,
    /// How large text is, one of [`TEXT_SIZES`](crate::paint::text_sizes::TEXT_SIZES). Before, all was enlarged.
    #[serde(alias = "zoom")]
    pub text: f32,
    /// What stands beside the drawings is so many times as large as it is at first.
    pub board: f32,
    /// Has the reader gone a step, or dragged something? Who has not is told how.
    pub is_greeted: bool,
    /// The window's inner size in points, when it was closed.
    pub window: Option<[f32; 2]>,
    pub figures: Option<Figures>,
    /// Scene files that were opened or written lately, the last one first.
    pub recent: Vec<String>,
    /// In the course that is built in.
    #[serde(flatten)]
    pub places: Places,
    /// In those of folders, the one that was open last first.
    pub folders: Vec<(String, Places)>,
    /// The folder whose course is open.
    #[serde(skip)]
    pub folder: Option<String>,
    /// What has been seen of the courses, and told beforehand.
    pub progress: Progress,
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
            asks: true,
            marks_at_end: false,
            speed: 1.0,
            text: 1.0,
            board: 1.0,
            is_greeted: false,
            window: None,
            figures: None,
            recent: Vec::new(),
            places: Places::default(),
            folders: Vec::new(),
            folder: None,
            progress: Progress::default(),
            works: Vec::new(),
        }
    }
}

/// So many folders are remembered.
const MOST_FOLDERS: usize = 8;
/// What a window can be.
const SIDES: std::ops::RangeInclusive<f32> = 240.0..=8192.0;
const BOARDS: std::ops::RangeInclusive<f32> = 0.3..=3.0;

impl Settings {
    /// Whatever a file says: each value as near as it can be to what was said, and what means nothing left out.
    pub fn in_range(mut self) -> Self {
        let within = |x: f32, range: &std::ops::RangeInclusive<f32>, otherwise| {
            let x = if x.is_nan() { otherwise } else { x };
            x.clamp(*range.start(), *range.end())
        };
        let [slowest, .., fastest] = Transport::SPEEDS;
        self.speed = within(self.speed, &(slowest..=fastest), 1.0);
        self.text = text_size(within(self.text, &(0.5..=3.0), 1.0), 0);
        self.board = within(self.board, &BOARDS, 1.0);
        self.window = self
            .window
            .map(|sides| sides.map(|side| within(side, &SIDES, 720.0)));
        self.figures = self
            .figures
            .filter(|it| Figures::SIZES.contains(&it.size_px));
        self
    }

    /// Where the reader of the open course was last.
    pub fn places(&self) -> Places {
        let Some(open) = &self.folder else {
            return self.places.clone();
        };
        let known = self.folders.iter().find(|(folder, _)| folder == open);
        known.map(|(_, places)| places.clone()).unwrap_or_default()
    }

    pub fn with_places(mut self, now: Places) -> Self {
        match self.folder.clone() {
            None => self.places = now,
            Some(open) => {
                self.folders.retain(|(folder, _)| *folder != open);
                self.folders.insert(0, (open, now));
                self.folders.truncate(MOST_FOLDERS);
            }
        }
        self
    }

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

/// What is to be remembered, before its scenes are spelt: that takes a while where they are large.
pub struct Snapshot {
    pub settings: Settings,
    /// Each without its scene's text, and the scene.
    pub works: Vec<(StoredWork, Scene)>,
    pub formats: SceneFormats,
}

impl Snapshot {
    pub fn written(self) -> Settings {
        let written = |(work, scene): (StoredWork, Scene)| StoredWork {
            scene: self.formats.write(&scene, &Moment::Start),
            ..work
        };
        Settings {
            works: self.works.into_iter().map(written).collect(),
            ..self.settings
        }
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
