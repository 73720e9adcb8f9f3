//! Files: those that are dropped or opened, and where the scene is saved.

use std::path::Path;

use crate::lesson::is_picture;

use super::{
    App, Dialog,
    dialog::{Target, meant},
    exports::path_of,
    mesh_loading::{is_mesh, is_of_a_mesh},
    prelude::*,
};

/// So many files are remembered.
const MOST_RECENT: usize = 8;

impl App {
    /// What is dropped on the window or pasted into it.
    pub(super) fn take_what_comes(&mut self, ctx: &Context) {
        self.take_pasted(ctx);
        let dropped = ctx.input_mut(|input| std::mem::take(&mut input.raw.dropped_files));
        let dropped = self.platform.arrived(dropped, ctx);
        let has_mesh = dropped.iter().any(|file| is_mesh(file.path()));
        for file in dropped {
            if has_mesh && is_of_a_mesh(file.path()) {
                continue;
            }
            if self.open_folder_or_mesh(file.path(), ctx) {
                continue;
            }
            let name = file.path().display().to_string();
            match self.bytes_of(&file) {
                Ok(bytes) => self.open_bytes(&name, &bytes),
                Err(reason) => self.report_unread(&name, reason),
            }
        }
    }

    /// Opens what is a folder of lessons or a mesh; is it one?
    fn open_folder_or_mesh(&mut self, path: &Path, ctx: &Context) -> bool {
        #[cfg(not(target_arch = "wasm32"))]
        if path.is_dir() {
            self.open_folder(path, ctx);
            return true;
        }
        let is_mesh = is_mesh(path);
        if is_mesh {
            self.load_mesh(&path.display().to_string(), ctx);
        }
        is_mesh
    }

    #[cfg(not(target_arch = "wasm32"))]
    #[allow(clippy::unused_self, reason = "in a page the platform has them")]
    fn bytes_of(&self, file: &egui::DroppedFileHandle) -> Result<Vec<u8>, Diagnostic> {
        use crate::lesson::{MAX_SCENE_BYTES, read_file};
        // Some systems drop what lies nowhere.
        let read = read_file(file.path(), MAX_SCENE_BYTES);
        let dropped = if file.path().exists() {
            None
        } else {
            file.bytes().ok()
        };
        dropped.map_or_else(|| Ok(read?), Ok)
    }

    #[cfg(target_arch = "wasm32")]
    fn bytes_of(&self, file: &egui::DroppedFileHandle) -> Result<Vec<u8>, Diagnostic> {
        self.platform.read(&file.path().display().to_string())
    }

    pub(super) fn report_unread(&mut self, path: &str, reason: Diagnostic) {
        let message = Message::new("status-open-failed").with("path", path.to_owned());
        let message = message.with("reason", reason);
        self.complain(self.catalog().message(&message));
    }

    /// Shows the scene in these bytes, in the free scene of its lab, or what a figure in them was drawn of; what is wrong with them is
    /// shown, and all left as it was.
    pub fn open_bytes(&mut self, name: &str, bytes: &[u8]) {
        if is_picture(bytes) {
            self.open_picture(name, bytes);
            return;
        }
        match self.kit.formats.read(name, bytes) {
            Ok(read) => {
                self.notices.clear();
                self.open_scene(name, read);
            }
            Err(problems) => self.report_unfit(&problems),
        }
    }

    /// Says what is wrong with a file, and that all is as it was.
    pub(super) fn report_unfit(&mut self, problems: &[Problem]) {
        let kept = self.catalog().term("status-kept");
        self.complain(format!("{}\n{kept}", self.listing(problems)));
    }

    pub(super) fn open_scene(&mut self, file: &str, opened: SceneFile) {
        let SceneFile {
            scene, position, ..
        } = opened;
        let lab = scene.document().lab();
        self.remember(file);
        self.open_free(lab);
        self.history.leave(self.position());
        self.history.open(file, scene);
        self.rerecord();
        self.fit();
        self.seek(position);
    }

    /// A scene file that was opened or written is at hand the next time.
    fn remember(&mut self, file: &str) {
        let path = self.platform.suggest(file);
        if self.platform.exists(&path) {
            let recent = &mut self.settings.recent;
            recent.retain(|known| *known != path);
            recent.insert(0, path);
            recent.truncate(MOST_RECENT);
        }
    }

    pub(super) fn open_recent(&mut self, path: &str) {
        self.notices.clear();
        match self.platform.read(path) {
            Ok(bytes) => self.open_bytes(path, &bytes),
            Err(reason) => {
                self.settings.recent.retain(|known| known != path);
                self.report_unread(path, reason);
                self.complain(self.catalog().term("status-forgotten"));
            }
        }
    }

    /// Problems as a compiler prints them; of very many, the first.
    pub(super) fn listing(&self, problems: &[Problem]) -> String {
        const MOST: usize = 64;
        let catalog = self.catalog();
        let shown = problems.iter().take(MOST);
        let mut lines: Vec<String> = shown.map(|problem| problem.render(catalog)).collect();
        if problems.len() > MOST {
            let more = Message::new("status-more-problems").with("count", problems.len() - MOST);
            lines.push(catalog.message(&more));
        }
        lines.join("\n")
    }

    /// Does what the open dialog is about; a file that the scene is not of is replaced only when told to a second time.
    pub(super) fn confirm(&mut self, ctx: &Context, now: f64) {
        let mut asked = self.shown.dialog.take();
        if let Some(target) = asked.as_mut().and_then(Dialog::target_mut) {
            target.path = meant(&target.path);
        }
        if let Some(Dialog::Scene(act, name)) = &asked {
            self.act_on_scene(*act, name);
            return;
        }
        let is_there = match &asked {
            Some(Dialog::Save(target)) => {
                self.history.file() != Some(&target.path) && self.platform.exists(&target.path)
            }
            Some(Dialog::Export(target, figures)) => {
                let [first, last] = self.exported(*figures);
                let path = |step| path_of(&target.path, *figures, step);
                (first..=last).any(|step| self.platform.exists(&path(step)))
            }
            Some(Dialog::HandIn(target)) => self.platform.exists(&target.path),
            Some(Dialog::Open(_) | Dialog::TakeUp(_) | Dialog::Lesson(_)) => false,
            Some(Dialog::Help | Dialog::Scene(..) | Dialog::Progress(_)) | None => return,
        };
        if let Some(target) = asked.as_mut().and_then(Dialog::target_mut)
            && is_there
            && !target.replaces
        {
            target.replaces = true;
            self.shown.dialog = asked;
            return;
        }
        self.notices.clear();
        // Where something goes wrong, the path is still there to be mended.
        match asked {
            Some(Dialog::Open(Target { path, .. })) => self.open_typed(path, ctx),
            Some(Dialog::Save(target)) => self.save(target, now),
            Some(Dialog::Lesson(target)) => self.save_lesson(target, ctx, now),
            Some(Dialog::HandIn(target)) => self.hand_in(target, now),
            Some(Dialog::TakeUp(target)) => self.take_up(target, now),
            Some(Dialog::Export(target, figures)) => {
                self.settings.figures = Some(figures);
                self.export(target.path, figures, ctx, now);
            }
            Some(Dialog::Help | Dialog::Scene(..) | Dialog::Progress(_)) | None => {}
        }
        ctx.request_repaint();
    }

    fn open_typed(&mut self, path: String, ctx: &Context) {
        if self.open_folder_or_mesh(Path::new(&path), ctx) {
            return;
        }
        match self.platform.read(&path) {
            Ok(bytes) => self.open_bytes(&path, &bytes),
            Err(reason) => {
                self.report_unread(&path, reason);
                if self.platform.has_paths() {
                    self.shown.dialog = Some(Dialog::Open(Target::new(path)));
                }
            }
        }
    }

    fn save(&mut self, target: Target, now: f64) {
        let path = target.path.clone();
        let written = self.platform.write(&path, self.as_file().as_bytes());
        match &written {
            Ok(path) => {
                self.history.saved(path.clone());
                self.remember(path);
            }
            Err(_) => self.shown.dialog = Some(Dialog::Save(target)),
        }
        self.report(&path, written, ["status-saved", "status-save-failed"], now);
    }

    /// Says what came of a file.
    pub(super) fn report(
        &mut self,
        asked: &str,
        written: Result<String, Diagnostic>,
        [done, failed]: [&'static str; 2],
        now: f64,
    ) {
        match written {
            Ok(path) => self.tell(&Message::new(done).with("path", path), now),
            Err(reason) => {
                let at = Message::new("error-at").with("place", asked.to_owned());
                let message = Message::new(failed).with("reason", at.with("problem", reason));
                self.complain(self.catalog().message(&message));
            }
        }
    }
}
