//! What the app remembers, in a file of its own: written whole or not at all, soon after a change, and shared by several windows.
//!
//! A window writes what it changed itself and leaves alone what another one wrote meanwhile. Where both worked on one page, the later
//! work stays and the earlier one is a step of undo away ([`StoredWork::before`]).

use std::{
    collections::BTreeMap,
    env,
    fs::{self, File},
    io,
    path::{Path, PathBuf},
    thread::{self, JoinHandle},
};

use egui::Context;
use serde_json::{Map, Value as Json};

use crate::{
    export::write_whole,
    lesson::{Progress, read_file},
};

use super::{
    App, Settings,
    desk::{Page, StoredWork},
    prelude::*,
    settings::Snapshot,
};

/// More than all work that is kept takes.
const MAX_BYTES: u64 = 512 << 20;
/// After the first change that is not kept yet.
const PATIENCE_SECS: f64 = 1.0;

pub struct Memory {
    /// None where nothing can be kept.
    path: Option<PathBuf>,
    /// What this window had when it last read or wrote the file.
    known: Settings,
    /// When what has changed is to be written.
    due: Option<f64>,
    /// What is in the file when it has been written.
    writing: Option<JoinHandle<io::Result<Settings>>>,
    has_complained: bool,
}

impl Memory {
    /// What is remembered, if anything, and what is to be said of it.
    pub fn open(path: Option<PathBuf>) -> (Option<Settings>, Self, Option<Message>) {
        let mut memory = Self {
            path,
            known: Settings::default(),
            due: None,
            writing: None,
            has_complained: false,
        };
        let Some(path) = memory.path.clone() else {
            return (None, memory, None);
        };
        match read(&path) {
            Ok(Some(read)) => {
                memory.known = read.clone();
                (Some(read.in_range()), memory, None)
            }
            Ok(None) => (None, memory, None),
            Err(reason) => {
                let shown = |path: &Path| path.display().to_string();
                let said = match put_aside(&path) {
                    Ok(aside) => Message::new("status-memory-aside").with("aside", shown(&aside)),
                    Err(_) => {
                        memory.path = None;
                        Message::new("status-memory-unread")
                    }
                };
                let said = said.with("path", shown(&path)).with("reason", reason);
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
        let Some(due) = self.due else {
            return;
        };
        let is_writing = self.writing.as_ref().is_some_and(|it| !it.is_finished());
        if due > now || is_writing || app.is_dragging() {
            let rest = (due - now).max(0.1);
            ctx.request_repaint_after(std::time::Duration::from_secs_f64(rest));
            return;
        }
        self.due = None;
        self.finish(app);
        self.begin(app.snapshot());
    }

    /// At the end: what has not been written yet.
    pub fn end(&mut self, app: &mut App) {
        self.finish(app);
        self.begin(app.snapshot());
        self.finish(app);
    }

    /// Spells it and writes what has changed, beside the window.
    fn begin(&mut self, now: Snapshot) {
        let Some(path) = self.path.clone() else {
            return;
        };
        // Where that fails, all of it is to be written again.
        let before = std::mem::take(&mut self.known);
        let write = move || {
            let now = now.written();
            if now != before {
                keep(&path, &before, &now)?;
            }
            Ok(now)
        };
        self.writing = Some(thread::spawn(write));
    }

    /// Waits for what is being written, and says once where that failed.
    fn finish(&mut self, app: &mut App) {
        let Some(written) = self.writing.take().map(JoinHandle::join) else {
            return;
        };
        let failed = match written {
            Ok(Ok(now)) => {
                self.known = now;
                return;
            }
            Ok(Err(error)) => error,
            Err(_) => io::Error::from(io::ErrorKind::Other),
        };
        if !std::mem::replace(&mut self.has_complained, true) {
            let path = self.path.as_ref().map(|path| path.display().to_string());
            let message = Message::new("status-memory-unkept")
                .with("path", path.unwrap_or_default())
                .with("reason", Diagnostic::from(failed));
            app.complain(app.catalog().message(&message));
        }
    }
}

/// Where settings are kept on this system, if it says so.
pub fn path() -> Option<PathBuf> {
    let of = |name| {
        env::var_os(name)
            .filter(|it| !it.is_empty())
            .map(PathBuf::from)
    };
    let home = |rest: &str| Some(of("HOME")?.join(rest));
    let data = if cfg!(target_os = "windows") {
        of("APPDATA")
    } else if cfg!(target_os = "macos") {
        home("Library/Application Support")
    } else {
        of("XDG_DATA_HOME").or_else(|| home(".local/share"))
    };
    Some(data?.join("clipscope/settings.json"))
}

/// `None` where there is no such file.
fn read(path: &Path) -> Result<Option<Settings>, Diagnostic> {
    if path
        .symlink_metadata()
        .is_err_and(|error| error.kind() == io::ErrorKind::NotFound)
    {
        return Ok(None);
    }
    let bytes = read_file(path, MAX_BYTES)?;
    let settings = serde_json::from_slice(&bytes);
    settings
        .map(Some)
        .map_err(|_| Message::new("memory-broken").into())
}

/// Renames what cannot be read, so that nothing is written over it; its new name.
fn put_aside(path: &Path) -> io::Result<PathBuf> {
    let names = (1..).map(|n| match n {
        1 => path.with_extension("broken"),
        n => path.with_extension(format!("broken-{n}")),
    });
    let mut free = names.filter(|name| name.symlink_metadata().is_err());
    let aside = free.next().ok_or(io::ErrorKind::AlreadyExists)?;
    fs::rename(path, &aside)?;
    Ok(aside)
}

/// Writes what this window changed since `before` into what the file holds now.
fn keep(path: &Path, before: &Settings, now: &Settings) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    // Held to the end: two windows that write at once take turns. A system without locks has to do without.
    let lock = File::create(path.with_extension("lock"))?;
    let _ = lock.lock();
    let there = read(path).ok().flatten();
    let merged = there.map_or_else(|| now.clone(), |there| merged(before, now, &there));
    write_whole(path, &serde_json::to_vec(&merged)?)
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

    fn there(path: &Path) -> Settings {
        read(path).unwrap().unwrap()
    }

    #[test]
    fn two_windows_keep_what_each_has_changed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("inner/settings.json");
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
        let path = folder.path().join("settings.json");
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
            let (settings, memory, said) = Memory::open(Some(path.clone()));
            assert_eq!(settings, None);
            assert_eq!(said.unwrap().key, "status-memory-aside");
            assert!(memory.path.is_some() && !path.exists());
            let n_aside = fs::read_dir(folder.path()).unwrap().count();
            assert_eq!(n_aside, i + 1);
        }
        let (settings, _, said) = Memory::open(Some(path));
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
            let (read, memory, said) = Memory::open(Some(path));
            proptest::prop_assert!(memory.path.is_some());
            proptest::prop_assert_eq!(read.is_none(), said.is_some());
            let app = App::new(Course::embedded(), read.unwrap_or_default());
            proptest::prop_assert!((0.25..=4.0).contains(&app.settings().speed));
        }
    }
}
