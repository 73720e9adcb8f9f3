//! Files that are dropped on the window.

use egui::Context;

use crate::{
    labs::Edit,
    lesson::Problem,
    text::{Catalog, Diagnostic, Message},
};

use super::{App, notice::Notice};

impl App {
    /// Opens a scene that was dropped, or says what is wrong with it.
    pub(super) fn take_dropped_files(&mut self, ctx: &Context) {
        let dropped = ctx.input_mut(|input| std::mem::take(&mut input.raw.dropped_files));
        for file in dropped {
            let name = file.path().display().to_string();
            match bytes_of(&file) {
                Ok(bytes) => self.open_scene(ctx, &name, &bytes),
                Err(reason) => {
                    let message = Message::new("status-open-failed")
                        .with("path", name)
                        .with("reason", reason);
                    let text = self.catalog().message(&message);
                    self.notices.push(Notice::problem(text));
                }
            }
        }
    }

    /// Shows the scene in these bytes; what is wrong with them is shown, and the scene left as it was.
    pub fn open_scene(&mut self, ctx: &Context, name: &str, bytes: &[u8]) {
        match self.kit.formats.read(name, bytes) {
            Ok(scene) => {
                self.notices.clear();
                let replace = Edit::Replace(scene);
                self.apply(ctx, super::Command::Edit(replace, None));
                self.apply(ctx, super::Command::First);
                self.stage.is_foreign = true;
            }
            Err(problems) => {
                let mut text = self.listing(&problems);
                text.push('\n');
                text.push_str(&self.catalog().term("status-kept"));
                self.notices.push(Notice::problem(text));
            }
        }
    }

    /// Problems as a compiler prints them; of very many, the first.
    pub(super) fn listing(&self, problems: &[Problem]) -> String {
        const MOST: usize = 8;
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
