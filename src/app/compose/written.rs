//! The files of a lesson that is made: checked, written, and looked at when another program has changed them.

use crate::lesson::{Draft, Severity};

use super::super::{App, prelude::*};

impl App {
    /// Reads the lesson from what is to be written: it is open from now on, where nothing is wrong with it.
    pub(super) fn check_composed(&mut self) {
        let open = self.open_id();
        let Some(compose) = &mut self.compose else {
            return;
        };
        let loaded = Course::check_with(
            &compose.draft().over(&compose.lesson, &*compose.files),
            self.kit.formats,
        );
        compose.problems = loaded.problems;
        compose
            .problems
            .retain(|problem| problem.severity == Severity::Error);
        let Some(lesson) = loaded.course.lessons.into_iter().next() else {
            return;
        };
        let mut runs: Vec<(&Scene, _)> = Vec::new();
        compose.stands.clear();
        for step in &lesson.steps {
            let nth = runs.iter().position(|(scene, _)| **scene == *step.scene);
            let nth = nth.unwrap_or_else(|| {
                runs.push((&step.scene, step.scene.document().record()));
                runs.len() - 1
            });
            if let (Some(run), Some(position)) = (runs[nth].1.first(), step.position()) {
                let tick = if position == 0 {
                    None
                } else {
                    Some(run.tick(position))
                };
                compose.stands.insert(step.id.clone(), (position, tick));
            }
        }
        let id = compose.lesson.clone();
        let Some(place) = self
            .bookmark
            .course
            .lessons
            .iter_mut()
            .find(|it| it.id == id)
        else {
            return;
        };
        *place = lesson;
        if self.has_composed_open() {
            self.bookmark.open_ids(&id, &open);
        }
    }

    /// Writes what has changed, unless another program has changed the files; at the end of all into other files then.
    pub(in super::super) fn write_composed(&mut self, is_end: bool) {
        self.look_outside();
        let Some(compose) = &mut self.compose else {
            return;
        };
        compose.due = None;
        if compose.is_written() || (compose.theirs.is_some() && !is_end) {
            return;
        }
        let aside = if compose.theirs.is_some() {
            ".mine"
        } else {
            ""
        };
        let draft = compose.draft().clone();
        let path = |name: &str| {
            compose
                .files
                .shown(&format!("{}/{name}{aside}", compose.lesson))
        };
        let mut failed = None;
        for (name, text) in draft.files() {
            if compose
                .on_disk
                .files()
                .all(|file| file != (name.clone(), text))
            {
                let written = self.platform.write(&path(&name), text.as_bytes());
                failed = failed.or(written.err().map(|reason| (path(&name), reason)));
            }
        }
        for (name, _) in compose.on_disk.files() {
            // A language that was begun, and undone.
            if aside.is_empty() && draft.files().all(|(known, _)| known != name) {
                let gone = self.platform.remove(&path(&name));
                failed = failed.or(gone.err().map(|reason| (path(&name), reason)));
            }
        }
        match failed {
            None => compose.on_disk = draft,
            Some((path, reason)) => {
                // What of it was written is no other program's.
                if let Ok(there) = Draft::read(&*compose.files, &compose.lesson) {
                    compose.on_disk = there;
                }
                let keys = ["status-saved", "status-save-failed"];
                self.report(&path, Err(reason), keys, 0.0);
            }
        }
    }

    /// Has another program changed the files?
    pub(in super::super) fn look_outside(&mut self) {
        let Some(compose) = &mut self.compose else {
            return;
        };
        let Ok(there) = Draft::read(&*compose.files, &compose.lesson) else {
            // In the middle of being written, or gone: it is written again.
            return;
        };
        if there == *compose.draft() {
            compose.on_disk = there;
            compose.theirs = None;
        } else {
            compose.theirs = (there != compose.on_disk).then_some(there);
        }
    }

    /// Whose version stays: the other program's, or this one's.
    pub(super) fn settle_outside(&mut self, takes_theirs: bool, now: f64) {
        let Some(theirs) = self.compose.as_mut().and_then(|it| it.theirs.take()) else {
            return;
        };
        if let Some(compose) = &mut self.compose {
            compose.on_disk = theirs.clone();
            compose.due = Some(now);
        }
        if takes_theirs {
            let id = self.open_id();
            self.compose(super::Kind::Once, now, |_, _| Some(theirs));
            self.open_composed(&id);
        }
    }
}
