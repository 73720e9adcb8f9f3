//! Files that are dropped on the window.

use egui::Context;

use crate::{
    labs::Edit,
    lesson::{Problem, SceneFile},
    text::{Catalog, Diagnostic, Message},
};

#[cfg(not(target_arch = "wasm32"))]
use super::mesh_loading::{is_mesh, is_of_a_mesh};
use super::{App, notice::Notice};

impl App {
    /// Opens a scene, a mesh or a folder of lessons that was dropped, or says what is wrong with it.
    pub(super) fn take_dropped_files(&mut self, ctx: &Context) {
        let now = ctx.input(|input| input.time);
        let dropped = ctx.input_mut(|input| std::mem::take(&mut input.raw.dropped_files));
        #[cfg(not(target_arch = "wasm32"))]
        let has_mesh = dropped.iter().any(|file| is_mesh(file.path()));
        for file in dropped {
            #[cfg(not(target_arch = "wasm32"))]
            if file.path().is_dir() {
                self.open_folder(file.path(), ctx);
                continue;
            }
            #[cfg(not(target_arch = "wasm32"))]
            if has_mesh && is_of_a_mesh(file.path()) {
                continue;
            }
            #[cfg(not(target_arch = "wasm32"))]
            if is_mesh(file.path()) {
                self.load_mesh(&file.path().display().to_string(), ctx);
                continue;
            }
            let name = file.path().display().to_string();
            match bytes_of(&file) {
                Ok(bytes) => self.open_bytes(&name, &bytes, now),
                Err(reason) => self.report_unread(&name, reason),
            }
        }
    }

    /// Says why a file cannot be read.
    pub(super) fn report_unread(&mut self, path: &str, reason: Diagnostic) {
        let message = Message::new("status-open-failed")
            .with("path", path.to_owned())
            .with("reason", reason);
        let text = self.catalog().message(&message);
        self.notices.push(Notice::problem(text));
    }

    /// Shows the scene in these bytes, in the free scene of its lab; what is wrong with them is shown, and all left as
    /// it was.
    pub fn open_bytes(&mut self, name: &str, bytes: &[u8], now: f64) {
        match self.kit.formats.read(name, bytes) {
            Ok(read) => {
                self.notices.clear();
                self.open_scene(name, read, now);
            }
            Err(problems) => self.report_unfit(&problems),
        }
    }

    /// Says what is wrong with a file, and that all is as it was.
    pub(super) fn report_unfit(&mut self, problems: &[Problem]) {
        let mut text = self.listing(problems);
        text.push('\n');
        text.push_str(&self.catalog().term("status-kept"));
        self.notices.push(Notice::problem(text));
    }

    /// Shows a file's scene in the free scene of its lab; undo brings back what was there.
    pub(super) fn open_scene(&mut self, file: &str, opened: SceneFile, now: f64) {
        let SceneFile { scene, position } = opened;
        let lab = scene.document().lab();
        self.turn_to(|bookmark| bookmark.open_free(lab));
        self.edit(Edit::Replace(scene), None, now);
        self.playback.transport_mut().seek(position);
        self.file = Some(file.to_owned());
    }

    /// Problems as a compiler prints them; of very many, the first.
    pub(super) fn listing(&self, problems: &[Problem]) -> String {
        const MOST: usize = 64;
        let catalog = self.catalog();
        let mut lines: Vec<String> = problems
            .iter()
            .take(MOST)
            .map(|p| p.render(catalog))
            .collect();
        if problems.len() > MOST {
            let more = Message::new("status-more-problems").with("count", problems.len() - MOST);
            lines.push(catalog.message(&more));
        }
        lines.join("\n")
    }

    pub(super) fn catalog(&self) -> &'static Catalog {
        Catalog::of(self.settings.lang)
    }
}

/// Why a file cannot be read, the system is asked again: egui has its answer in English only.
#[cfg(not(target_arch = "wasm32"))]
fn bytes_of(file: &egui::DroppedFileHandle) -> Result<Vec<u8>, Diagnostic> {
    let read = |_| std::fs::read(file.path()).map_err(Diagnostic::from);
    file.bytes().or_else(read)
}

/// A browser hands files over later; the page will do that in its own way.
#[cfg(target_arch = "wasm32")]
fn bytes_of(_file: &egui::DroppedFileHandle) -> Result<Vec<u8>, Diagnostic> {
    Err(crate::text::SystemError::of_kind(std::io::ErrorKind::Unsupported).into())
}
