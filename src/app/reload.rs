//! A lesson folder that is read again whenever it changes.

use std::{
    path::Path,
    sync::mpsc::{Receiver, channel},
    time::Duration,
};

use notify::{RecommendedWatcher, RecursiveMode, Watcher as _};

use crate::lesson::{Folder, Loaded, Severity};

use super::{App, prelude::*};

/// Editors write a file in several strokes: wait until they are done.
const SETTLE: Duration = Duration::from_millis(150);

pub struct Reload {
    folder: Folder,
    changed: Receiver<()>,
    /// Stops watching when it is dropped. `None` where the system offers no watching.
    watcher: Option<RecommendedWatcher>,
}

impl Reload {
    pub const fn folder(&self) -> &Folder {
        &self.folder
    }

    /// Watches a folder; every change wakes the window.
    fn new(folder: Folder, ctx: Context) -> Self {
        let (sender, changed) = channel();
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
            changed,
            watcher,
        }
    }
}

impl App {
    /// Reads this folder again whenever it changes.
    pub(super) fn watch(&mut self, folder: Folder, ctx: Context) {
        self.reload = Some(Reload::new(folder, ctx));
    }

    /// Opens a folder that was dropped, as `clipscope open` does; where it holds no lesson all stays as it was.
    pub(super) fn open_folder(&mut self, root: &Path, ctx: &Context) {
        let folder = Folder::new(root);
        let Loaded { course, problems } = Course::check_with(&folder, self.kit.formats);
        self.notices.clear();
        if course.lessons.is_empty() {
            self.report_unfit(&problems);
            return;
        }
        self.change_course(course, Some(folder.full_path()));
        self.report_errors(problems);
        self.watch(folder, ctx.clone());
    }

    pub(super) fn take_changed_course(&mut self, now: f64) {
        let changed = self
            .reload
            .as_ref()
            .map(|reload| reload.changed.try_iter().count());
        if changed.is_none_or(|n| n == 0) {
            return;
        }
        // What is made is not taken from the disk as it is.
        if self.compose.is_some() {
            self.look_outside();
        } else {
            self.read_course_again(now);
        }
    }

    pub(super) fn read_course_again(&mut self, now: f64) {
        let Some(reload) = &mut self.reload else {
            return;
        };
        let folder = reload.folder.clone();
        if let Some(watcher) = &mut reload.watcher {
            // A watch ends with the folder that it was set on; where it is gone, the parent's watch tells when it is back.
            let _ = watcher.watch(folder.root(), RecursiveMode::Recursive);
        }
        let path = folder.root().display().to_string();
        self.take_course(&path, Course::check_with(&folder, self.kit.formats), now);
    }

    /// Takes over what was read of a course; of broken lessons, the last good version stays.
    pub(super) fn take_course(&mut self, path: &str, loaded: Loaded, now: f64) {
        let was_untouched = self.is_untouched();
        let before = self.bookmark.step().cloned();
        let is_gone = loaded.course.lessons.is_empty();
        let errors = errors(loaded.problems);
        let was_broken = self.notices.iter().any(|notice| notice.is_problem);
        let mut is_another = false;
        if !is_gone {
            let old = &self.bookmark.course.lessons;
            let merged = merged(old, loaded.course.lessons, |lesson| {
                let is_its = |part| part == lesson.id.as_str();
                let mut files = errors.iter().map(|problem| Path::new(&problem.file));
                files.any(|file| file.iter().any(is_its))
            });
            is_another = merged != *old;
            self.bookmark.replace(Course { lessons: merged });
            if self.bookmark.step() != before.as_ref() && was_untouched {
                self.enter();
            }
        }
        let is_good = errors.is_empty() && !is_gone;
        if is_good && !is_another && !was_broken {
            // Saved again as it was, or another file beside the lessons.
            return;
        }
        self.notices.clear();
        if is_good {
            let message = Message::new("status-reloaded").with("path", path.to_owned());
            self.tell(&message, now);
        } else {
            let kept = self.catalog().term("status-last-good");
            self.complain(format!("{}\n{kept}", self.listing(&errors)));
        }
    }

    /// Shows what is wrong with a course that has just been opened.
    pub(super) fn report_errors(&mut self, problems: Vec<Problem>) {
        let errors = errors(problems);
        if !errors.is_empty() {
            self.complain(self.listing(&errors));
        }
    }
}

fn errors(mut problems: Vec<Problem>) -> Vec<Problem> {
    problems.retain(|problem| problem.severity == Severity::Error);
    problems
}

/// The new lessons, and the old ones that are broken now, in the order of their ids.
fn merged(old: &[Lesson], new: Vec<Lesson>, is_broken: impl Fn(&Lesson) -> bool) -> Vec<Lesson> {
    let is_kept = |old: &&Lesson| is_broken(old) && new.iter().all(|new| new.id != old.id);
    let mut lessons: Vec<Lesson> = old.iter().filter(is_kept).cloned().collect();
    lessons.extend(new);
    lessons.sort_by(|a, b| a.id.cmp(&b.id));
    lessons
}
