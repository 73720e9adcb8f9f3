//! What the app remembers: written whole or not at all, soon after a change, and shared by several windows.
//!
//! A window writes what it changed itself and leaves alone what another one wrote meanwhile. Where both worked on one page, the later
//! work stays and the earlier one is a step of undo away ([`StoredWork::before`]).

use std::{collections::BTreeMap, io};

use egui::Context;
use serde_json::{Map, Value as Json};
use web_time::Duration;

use crate::lesson::Progress;

use super::{
    App, Settings,
    desk::{Page, StoredWork},
    errand::{Errand, Lost},
    prelude::*,
    settings::Snapshot,
    shelf::Shelf,
};

/// After the first change that is not kept yet.
const PATIENCE_SECS: f64 = 1.0;
/// How soon it is looked again whether something has been written.
const LOOK_SECS: f64 = 0.1;

pub struct Memory {
    /// None where nothing can be kept.
    shelf: Option<Shelf>,
    /// What this window had when it last read or wrote.
    known: Settings,
    /// When what has changed is to be written.
    due: Option<f64>,
    /// What is there when it has been written.
    writing: Option<Errand<io::Result<Settings>>>,
    has_complained: bool,
}

impl Memory {
    /// What is remembered, if anything, and what is to be said of it.
    pub fn open(shelf: Option<Shelf>) -> (Option<Settings>, Self, Option<Message>) {
        let mut memory = Self {
            shelf,
            known: Settings::default(),
            due: None,
            writing: None,
            has_complained: false,
        };
        let Some(shelf) = memory.shelf.clone() else {
            return (None, memory, None);
        };
        match shelf.read() {
            Ok(Some(read)) => {
                memory.known = read.clone();
                (Some(read.in_range()), memory, None)
            }
            Ok(None) => (None, memory, None),
            Err(reason) => {
                let said = if let Ok(aside) = shelf.put_aside() {
                    Message::new("status-memory-aside").with("aside", aside)
                } else {
                    memory.shelf = None;
                    Message::new("status-memory-unread")
                };
                let said = said.with("path", shelf.name()).with("reason", reason);
                (None, memory, Some(said))
            }
        }
    }

    /// Once a frame: writes what has changed, a moment after it did.
    pub fn pass(&mut self, app: &mut App, ctx: &Context) {
        let now = ctx.input(|input| input.time);
        if app.take_touched() {
            self.due.get_or_insert(now + PATIENCE_SECS);
        }
        let is_writing = self.is_writing(app, Duration::ZERO);
        let Some(due) = self.due else {
            if is_writing {
                ctx.request_repaint_after(Duration::from_secs_f64(LOOK_SECS));
            }
            return;
        };
        if due > now || is_writing || app.is_dragging() {
            let rest = (due - now).max(LOOK_SECS);
            ctx.request_repaint_after(Duration::from_secs_f64(rest));
            return;
        }
        self.due = None;
        let write = self.write(app.snapshot());
        self.writing = write.map(|write| Errand::start(ctx, write));
    }

    /// Keeps nothing from now on.
    #[cfg(target_arch = "wasm32")]
    pub fn forget(&mut self) {
        (self.shelf, self.due) = (None, None);
    }

    /// Has something not been written yet?
    #[cfg(target_arch = "wasm32")]
    pub const fn has_more(&self) -> bool {
        self.due.is_some() || self.writing.is_some()
    }

    /// At the end: what has not been written yet.
    pub fn end(&mut self, app: &mut App) {
        while self.is_writing(app, Duration::MAX) {}
        self.due = None;
        if let Some(write) = self.write(app.snapshot()) {
            self.take(write(), app);
        }
    }

    /// What spells it and writes what has changed, beside the window where that can be.
    fn write(&mut self, now: Snapshot) -> Option<impl FnOnce() -> io::Result<Settings> + use<>> {
        let shelf = self.shelf.clone()?;
        // Where that fails, all of it is to be written again.
        let before = std::mem::take(&mut self.known);
        Some(move || {
            let now = now.written();
            if now != before {
                keep(&shelf, &before, &now)?;
            }
            Ok(now)
        })
    }

    /// Is something being written for longer than this?
    fn is_writing(&mut self, app: &mut App, within: Duration) -> bool {
        let Some(writing) = &mut self.writing else {
            return false;
        };
        let written = match writing.answer(within) {
            Ok(None) => return true,
            Ok(Some(written)) => written,
            Err(Lost) => Err(io::ErrorKind::Other.into()),
        };
        self.writing = None;
        self.take(written, app);
        false
    }

    /// Says once where writing failed.
    fn take(&mut self, written: io::Result<Settings>, app: &mut App) {
        let failed = match written {
            Ok(now) => {
                self.known = now;
                return;
            }
            Err(failed) => Diagnostic::from(failed),
        };
        if let Some(shelf) = &self.shelf
            && !std::mem::replace(&mut self.has_complained, true)
        {
            app.complain(app.catalog().message(&shelf.unkept(failed)));
        }
    }
}

/// Writes what this window changed since `before` into what is there now.
fn keep(shelf: &Shelf, before: &Settings, now: &Settings) -> io::Result<()> {
    shelf.keep(|there| there.map_or_else(|| now.clone(), |there| merged(before, now, &there)))
}

/// What was changed `now`, and else what is `there`.
fn merged(before: &Settings, now: &Settings, there: &Settings) -> Settings {
    let fields = |settings: &Settings| -> Map<String, Json> {
        let json = serde_json::to_value(Settings {
            works: Vec::new(),
            progress: Progress::default(),
            ..settings.clone()
        });
        json.ok()
            .and_then(|json| json.as_object().cloned())
            .unwrap_or_default()
    };
    let (old, mut new, other) = (fields(before), fields(now), fields(there));
    for (name, value) in &mut new {
        if old.get(name) == Some(value)
            && let Some(other) = other.get(name)
        {
            *value = other.clone();
        }
    }
    let settings = serde_json::from_value(Json::Object(new)).unwrap_or_else(|_| now.clone());
    Settings {
        works: works([&before.works, &now.works, &there.works]),
        progress: now.progress.clone().joined(&there.progress),
        ..settings
    }
}

/// The same for work, page by page.
fn works([before, now, there]: [&[StoredWork]; 3]) -> Vec<StoredWork> {
    let by_page = |works: &[StoredWork]| -> BTreeMap<Page, StoredWork> {
        works
            .iter()
            .map(|work| (work.page.clone(), work.clone()))
            .collect()
    };
    let [before, mut now, mut there] = [before, now, there].map(by_page);
    let mut kept = Vec::new();
    let mut pages: Vec<Page> = now.keys().chain(there.keys()).cloned().collect();
    pages.sort();
    pages.dedup();
    for page in pages {
        let old = before.get(&page);
        let (own, other) = (now.remove(&page), there.remove(&page));
        let is_own = own.as_ref() != old;
        let is_other = other.as_ref() != old;
        kept.extend(match (is_own, is_other, own, other) {
            (true, true, Some(own), Some(other)) if own.scene != other.scene => {
                let before = Some(other.scene);
                Some(StoredWork { before, ..own })
            }
            (true, _, own, _) => own,
            (false, _, _, other) => other,
        });
    }
    kept
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::{app::desk::Places, lesson::Course, text::Lang};

    fn work(page: &str, scene: &str) -> StoredWork {
        StoredWork {
            page: Page::Free(page.to_owned()),
            scene: scene.to_owned(),
            position: 0,
            file: None,
            is_unsaved: false,
            before: None,
        }
    }

    fn with(lang: Lang, works: &[StoredWork]) -> Settings {
        Settings {
            lang,
            works: works.to_vec(),
            ..Settings::default()
        }
    }

    fn there(shelf: &Shelf) -> Settings {
        shelf.read().unwrap().unwrap()
    }

    #[test]
    fn two_windows_keep_what_each_has_changed() {
        let folder = tempfile::tempdir().unwrap();
        let path = Shelf::at(folder.path().join("inner/settings.json"));
        let start = with(Lang::En, &[work("lines", "a"), work("polygons", "b")]);
        keep(&path, &Settings::default(), &start).unwrap();
        // One changes the language and a page, the other another page, and takes one away.
        let one = with(Lang::Es, &[work("lines", "one"), work("polygons", "b")]);
        let other = with(Lang::En, &[work("lines", "a"), work("frustum", "other")]);
        keep(&path, &start, &one).unwrap();
        keep(&path, &start, &other).unwrap();
        let expected = with(Lang::Es, &[work("frustum", "other"), work("lines", "one")]);
        let mut kept = there(&path);
        kept.works.sort_by(|a, b| a.page.cmp(&b.page));
        assert_eq!(kept, expected);
    }

    #[test]
    fn of_two_on_one_page_the_later_stays_and_the_earlier_is_behind_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = Shelf::at(folder.path().join("settings.json"));
        let start = with(Lang::En, &[work("lines", "start")]);
        keep(&path, &Settings::default(), &start).unwrap();
        keep(&path, &start, &with(Lang::En, &[work("lines", "earlier")])).unwrap();
        keep(&path, &start, &with(Lang::En, &[work("lines", "later")])).unwrap();
        let kept = there(&path).works;
        let before = Some("earlier".to_owned());
        assert_eq!(
            kept,
            [StoredWork {
                before,
                ..work("lines", "later")
            }]
        );
    }

    #[test]
    fn what_cannot_be_read_is_put_aside_each_time_under_another_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("settings.json");
        for (i, bytes) in ["", "{", "[1]", "\u{0}"].iter().enumerate() {
            fs::write(&path, bytes).unwrap();
            let (settings, memory, said) = Memory::open(Some(Shelf::at(path.clone())));
            assert_eq!(settings, None);
            assert_eq!(said.unwrap().key, "status-memory-aside");
            assert!(memory.shelf.is_some() && !path.exists());
            let n_aside = fs::read_dir(folder.path()).unwrap().count();
            assert_eq!(n_aside, i + 1);
        }
        let (settings, _, said) = Memory::open(Some(Shelf::at(path)));
        assert_eq!((settings, said), (None, None));
    }

    #[test]
    fn values_out_of_range_are_put_in_range() {
        let json = r#"{"speed": 1e30, "zoom": 0.0, "window": [0, 1e9], "figures":
            {"size_px": [0, 4000000000], "theme": "dark", "lang": "en", "all": true}}"#;
        let read: Settings = serde_json::from_str(json).unwrap();
        let settings = read.in_range();
        assert!(settings.speed <= 4.0 && settings.text == 0.9);
        let window = settings.window.unwrap();
        assert!(
            window.iter().all(|side| (200.0..=16_384.0).contains(side)),
            "{window:?}"
        );
        assert_eq!(settings.figures, None, "no size that the dialog offers");
    }

    proptest::proptest! {
        // Each opens the course.
        #![proptest_config(proptest::test_runner::Config::with_cases(96))]

        /// Whatever a crash, a full disk or a hand has left: a window opens on it, or on what it always opens on.
        #[test]
        fn whatever_is_there_a_window_opens(
            at in 0_usize..400,
            byte in proptest::num::u8::ANY,
            n in 0_usize..400,
            number in proptest::num::f32::ANY,
        ) {
            let settings = Settings {
                speed: number,
                text: number,
                window: Some([number, 700.0]),
                places: Places {
                    page: Some(Page::Step("03-outcodes".to_owned(), "accepted".to_owned())),
                    ..Places::default()
                },
                works: vec![work("lines", "method = 7")],
                ..Settings::default()
            };
            let mut bytes = serde_json::to_vec(&settings).unwrap();
            let at = at % bytes.len();
            bytes[at] = byte;
            bytes.truncate(n.max(1));
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("settings.json");
            fs::write(&path, bytes).unwrap();
            let (read, memory, said) = Memory::open(Some(Shelf::at(path)));
            proptest::prop_assert!(memory.shelf.is_some());
            proptest::prop_assert_eq!(read.is_none(), said.is_some());
            let app = App::new(Course::embedded(), read.unwrap_or_default());
            proptest::prop_assert!((0.25..=4.0).contains(&app.settings().speed));
        }
    }
}
