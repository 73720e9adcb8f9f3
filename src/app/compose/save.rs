//! A lesson of one's own is put into a folder: it begins with a scene, or is a copy of another one.

use std::{collections::BTreeMap, fs, path::PathBuf};

use crate::{
    lesson::{Draft, Embedded, Files, TRANSLATED_FILE},
    text::Catalog,
};

use super::super::{App, Dialog, dialog::Target, prelude::*};

impl App {
    /// The files of a lesson that begins with the scene on the stage; a lesson's own where one of its steps is open.
    fn begun(&self) -> Vec<(String, Vec<u8>)> {
        let step = self.bookmark.step().and(self.bookmark.lesson());
        if let Some(lesson) = step {
            let embedded = || Box::new(Embedded) as Box<dyn Files>;
            let files = self.own_files().unwrap_or_else(embedded);
            let paths = files.list().unwrap_or_default().into_iter();
            let own = paths.filter_map(|path| {
                let name = path
                    .strip_prefix(&*lesson.id)?
                    .strip_prefix('/')?
                    .to_owned();
                let is_its = name != TRANSLATED_FILE && !name.contains('/');
                Some((name, files.read(&path).ok().filter(|_| is_its)?))
            });
            return own.collect();
        }
        let scene = self.history.now();
        let method = scene
            .document()
            .methods()
            .first()
            .map_or("scene", |card| card.id);
        let step = self.step_here(&Draft::default(), method.to_owned());
        let name = self.bookmark.free.as_ref().and_then(|it| it.name.as_ref());
        let unnamed = |lang| Catalog::of(lang).term("free-title");
        let title = |lang| (lang, name.cloned().unwrap_or_else(|| unnamed(lang)));
        let titles = BTreeMap::from([Lang::En, self.settings.lang].map(title));
        let source = self.catalog().term("compose-source-at-first");
        let written = self.kit.formats.write(scene, &Moment::Start);
        let lab = scene.document().lab().id;
        let draft = Draft::begun([lab, &source, &written], titles, &step);
        draft
            .files()
            .map(|(name, text)| (name, text.as_bytes().to_vec()))
            .collect()
    }

    /// Writes a lesson into a folder and goes on with it there.
    pub(in super::super) fn save_lesson(&mut self, target: Target, ctx: &Context, now: f64) {
        let root = PathBuf::from(&target.path);
        let is_taken = self
            .platform
            .exists(&root.join("lesson.toml").display().to_string());
        let made = fs::create_dir_all(&root).map_err(Diagnostic::from);
        let mut written = made.map(|()| target.path.clone());
        if is_taken {
            written = Err(Message::new("lesson-save-taken").into());
        }
        for (name, bytes) in self.begun() {
            if written.is_ok() {
                let path = root.join(name).display().to_string();
                written = self.platform.write(&path, &bytes);
            }
        }
        let is_written = written.is_ok();
        self.report(
            &target.path.clone(),
            written,
            ["status-saved", "status-save-failed"],
            now,
        );
        if !is_written {
            self.shown.dialog = Some(Dialog::Lesson(target));
            return;
        }
        self.open_folder(&root, ctx);
        self.turn_to(|bookmark| bookmark.open([0, 0]));
        self.begin_composing(now);
    }
}
