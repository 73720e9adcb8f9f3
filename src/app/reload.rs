//! A lesson folder that is read again whenever it changes.

use std::{
    path::Path,
    sync::mpsc::{Receiver, channel},
    time::Duration,
};

use egui::Context;
use notify::{RecommendedWatcher, RecursiveMode, Watcher as _};

use crate::{
    lesson::{Course, Folder, Lesson, Loaded, Problem, Severity},
    text::Message,
};

use super::{App, bookmark::Bookmark, notice::Notice};

/// Editors write a file in several strokes: wait until they are done.
const SETTLE: Duration = Duration::from_millis(150);

/// A folder under observation.
pub struct Reload {
    folder: Folder,
    changed: Receiver<()>,
    /// Stops watching when it is dropped. `None` where the system offers no watching.
    watcher: Option<RecommendedWatcher>,
}

impl Reload {
    /// Watches a folder; every change wakes the window.
    pub fn new(folder: Folder, ctx: Context) -> Self {
        let (sender, receiver) = channel();
        let (raw_sender, raw) = channel::<()>();
        let watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
            if event.is_ok_and(|event| !event.kind.is_access()) {
                // The window is gone: nobody is left to tell.
                let _ = raw_sender.send(());
            }
        });
        let watcher = watcher.ok().and_then(|mut watcher| {
            let root = folder.root();
            watcher.watch(root, RecursiveMode::Recursive).ok()?;
            // The folder itself may go and come back, as under `git checkout`: its parent sees that.
            if let Some(parent) = root.canonicalize().ok().as_deref().and_then(Path::parent) {
                watcher.watch(parent, RecursiveMode::NonRecursive).ok()?;
            }
            Some(watcher)
        });
        std::thread::spawn(move || {
            while raw.recv().is_ok() {
                while raw.recv_timeout(SETTLE).is_ok() {}
                if sender.send(()).is_err() {
                    return;
                }
                ctx.request_repaint();
            }
        });
        Self {
            folder,
            changed: receiver,
            watcher,
        }
    }

    /// Watches the folder anew: a watch ends with the folder that it was set on.
    fn rearm(&mut self) {
        if let Some(watcher) = &mut self.watcher {
            // Where it is gone, the parent's watch tells when it is back.
            let _ = watcher.watch(self.folder.root(), RecursiveMode::Recursive);
        }
    }

    fn has_changed(&self) -> bool {
        self.changed.try_iter().count() > 0
    }
}

impl App {
    /// Reads this folder again whenever it changes.
    pub fn watch(&mut self, folder: Folder, ctx: Context) {
        self.reload = Some(Reload::new(folder, ctx));
    }

    /// Opens a folder that was dropped, as `clipscope open` does; where it holds no lesson all stays as it was.
    pub(super) fn open_folder(&mut self, root: &Path, ctx: &Context) {
        let folder = Folder::new(root);
        let Loaded { course, problems } = Course::check_with(&folder, self.kit.formats);
        self.notices.clear();
        if course.lessons.is_empty() {
            let kept = self.catalog().term("status-kept");
            let text = format!("{}\n{kept}", self.listing(&problems));
            self.notices.push(Notice::problem(text));
            return;
        }
        let (page, was_untouched) = (self.bookmark.page(), self.is_untouched());
        self.turn_to(|bookmark| {
            *bookmark = Bookmark::new(course);
            true
        });
        if self.bookmark.page() == page && was_untouched {
            self.enter();
        }
        self.report(&problems);
        self.watch(folder, ctx.clone());
    }

    pub(super) fn take_changed_course(&mut self, now: f64) {
        let changed = self.reload.as_ref().filter(|reload| reload.has_changed());
        if let Some(folder) = changed.map(|reload| reload.folder.clone()) {
            if let Some(reload) = &mut self.reload {
                reload.rearm();
            }
            let path = folder.root().display().to_string();
            self.take_course(&path, Course::check_with(&folder, self.kit.formats), now);
        }
    }

    /// Takes over what was read of a course; of broken lessons, the last good version stays.
    pub(super) fn take_course(&mut self, path: &str, loaded: Loaded, now: f64) {
        let was_untouched = self.is_untouched();
        let before = self.bookmark.step().cloned();
        let is_gone = loaded.course.lessons.is_empty();
        let errors: Vec<_> = loaded
            .problems
            .into_iter()
            .filter(|p| p.severity == Severity::Error)
            .collect();
        let path = path.to_owned();
        let was_broken = self.notices.shown().iter().any(|notice| notice.is_problem);
        let mut is_another = false;
        if !is_gone {
            let merged = merged(self.bookmark.lessons(), loaded.course.lessons, |lesson| {
                let of_lesson = |file: &str| {
                    Path::new(file)
                        .iter()
                        .any(|part| part == lesson.id.as_str())
                };
                errors.iter().any(|problem| of_lesson(&problem.file))
            });
            is_another = merged != self.bookmark.lessons();
            self.bookmark.replace(Course { lessons: merged });
            if self.bookmark.step() != before.as_ref() {
                self.course_changed(was_untouched);
            }
        }
        let is_good = errors.is_empty() && !is_gone;
        if is_good && !is_another && !was_broken {
            // Saved again as it was, or another file beside the lessons.
            return;
        }
        self.notices.clear();
        let catalog = self.catalog();
        if is_good {
            let text = catalog.message(&Message::new("status-reloaded").with("path", path));
            self.notices.push(Notice::passing(text, now));
        } else {
            let text = format!(
                "{}\n{}",
                self.listing(&errors),
                catalog.term("status-last-good")
            );
            self.notices.push(Notice::problem(text));
        }
    }

    /// After another version of the course has been read.
    fn course_changed(&mut self, was_untouched: bool) {
        if was_untouched {
            self.enter();
        }
    }

    /// Shows what is wrong with a course that has just been opened.
    pub(super) fn report(&mut self, problems: &[Problem]) {
        let errors: Vec<Problem> = problems
            .iter()
            .filter(|p| p.severity == Severity::Error)
            .cloned()
            .collect();
        if !errors.is_empty() {
            self.notices.push(Notice::problem(self.listing(&errors)));
        }
    }
}

/// The new lessons, and the old ones that are broken now, in the order of their ids.
fn merged(old: &[Lesson], new: Vec<Lesson>, is_broken: impl Fn(&Lesson) -> bool) -> Vec<Lesson> {
    let kept = old
        .iter()
        .filter(|lesson| is_broken(lesson) && new.iter().all(|n| n.id != lesson.id))
        .cloned();
    let mut lessons: Vec<Lesson> = kept.collect();
    lessons.extend(new);
    lessons.sort_by(|a, b| a.id.cmp(&b.id));
    lessons
}
