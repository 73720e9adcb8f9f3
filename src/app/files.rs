//! Files that go out: where the scene is saved, and its figures exported, one a frame.

use egui::Context;

use crate::{
    labs::Scene,
    text::{Catalog, Diagnostic, Message},
};

use super::{
    App, Dialog,
    dialog::{Figures, Target},
    notice::Notice,
    platform::StageFigure,
};

/// Figures on their way into files.
pub struct Export {
    path: String,
    figures: Figures,
    title: Option<String>,
    scene: Scene,
    /// The step that is drawn next, and the last one.
    next: usize,
    last: usize,
}

impl Export {
    fn figure(&self) -> StageFigure<'_> {
        StageFigure {
            title: self.title.as_deref(),
            scene: &self.scene,
            position: self.next,
            figures: self.figures,
        }
    }
}

/// The file of a step: of many, each has its number before the ending.
fn path_of(path: &str, figures: Figures, step: usize) -> String {
    if !figures.all {
        return path.to_owned();
    }
    let (stem, ending) = match path.rsplit_once('.') {
        Some((stem, ending)) if !ending.contains(['/', '\\']) => (stem, ending),
        _ => (path, "png"),
    };
    format!("{stem}-{step:03}.{ending}")
}

impl App {
    /// Does what the open dialog is about; a file that the scene is not of is replaced only when told to a second time.
    pub(super) fn confirm(&mut self, ctx: &Context, now: f64) {
        let mut asked = self.shown.dialog.take();
        let is_there = match &asked {
            Some(Dialog::Save(target)) => {
                self.file.as_deref() != Some(&target.path) && self.platform.exists(&target.path)
            }
            Some(Dialog::Export(target, figures)) => {
                let [first, last] = self.exported(*figures);
                let path = |step| path_of(&target.path, *figures, step);
                (first..=last).any(|step| self.platform.exists(&path(step)))
            }
            Some(Dialog::Open(_)) => false,
            Some(Dialog::Help) | None => return,
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
        match asked {
            Some(Dialog::Open(target)) => self.open(&target.path, ctx, now),
            Some(Dialog::Save(target)) => {
                let notice = self.save(&target.path, now);
                if notice.is_problem {
                    // The path is still there to be mended.
                    self.shown.dialog = Some(Dialog::Save(target));
                }
                self.notices.push(notice);
            }
            Some(Dialog::Export(target, figures)) => {
                self.settings.figures = Some(figures);
                self.exporting = Some(self.export_of(&target.path, figures));
                self.export_next(ctx, now);
            }
            Some(Dialog::Help) | None => {}
        }
        ctx.request_repaint();
    }

    /// Opens a scene, a mesh, or a folder of lessons.
    fn open(&mut self, path: &str, ctx: &Context, now: f64) {
        #[cfg(not(target_arch = "wasm32"))]
        if std::path::Path::new(path).is_dir() {
            self.open_folder(std::path::Path::new(path), ctx);
            return;
        }
        #[cfg(not(target_arch = "wasm32"))]
        if super::is_mesh(std::path::Path::new(path)) {
            self.load_mesh(path, ctx);
            return;
        }
        match self.platform.read(path) {
            Ok(bytes) => self.open_bytes(path, &bytes, now),
            Err(reason) => {
                self.report_unread(path, reason);
                // The path is still there to be mended.
                self.shown.dialog = Some(Dialog::Open(Target::new(path.to_owned())));
            }
        }
        ctx.request_repaint();
    }

    fn save(&mut self, path: &str, now: f64) -> Notice {
        let written = self.platform.write(path, self.as_file().as_bytes());
        if let Ok(path) = &written {
            self.file = Some(path.clone());
        }
        self.reported(path, written, ["status-saved", "status-save-failed"], now)
    }

    /// The first and the last step that become figures.
    const fn exported(&self, figures: Figures) -> [usize; 2] {
        let transport = self.playback.transport();
        if figures.all {
            [0, transport.n_steps()]
        } else {
            [transport.position(); 2]
        }
    }

    fn export_of(&self, path: &str, figures: Figures) -> Export {
        let title = self.bookmark.title(figures.lang);
        let [next, last] = self.exported(figures);
        Export {
            path: path.to_owned(),
            figures,
            title: title.filter(|_| self.is_untouched()).map(str::to_owned),
            scene: self.history.now().clone(),
            next,
            last,
        }
    }

    /// Draws the next figure of an export, one a frame: the window stays awake, and Escape ends it.
    pub(super) fn export_next(&mut self, ctx: &Context, now: f64) {
        let Some(mut export) = self.exporting.take() else {
            return;
        };
        let path = path_of(&export.path, export.figures, export.next);
        let drawn = self.platform.draw(export.figure());
        let written = drawn.and_then(|bytes| self.platform.write(&path, &bytes));
        self.notices.clear();
        let notice = if written.is_ok() && export.next < export.last {
            export.next += 1;
            let message = Message::new("status-exporting")
                .with("count", export.next)
                .with("total", export.last + 1);
            self.exporting = Some(export);
            ctx.request_repaint();
            Notice::passing(self.catalog().message(&message), now)
        } else {
            if written.is_err() {
                // The path is still there to be mended.
                let dialog = Dialog::Export(Target::new(export.path), export.figures);
                self.shown.dialog = Some(dialog);
            }
            let said = ["status-exported", "status-export-failed"];
            self.reported(&path, written, said, now)
        };
        self.notices.push(notice);
    }

    fn reported(
        &self,
        asked: &str,
        written: Result<String, Diagnostic>,
        [done, failed]: [&'static str; 2],
        now: f64,
    ) -> Notice {
        let catalog = Catalog::of(self.settings.lang);
        match written {
            Ok(path) => {
                Notice::passing(catalog.message(&Message::new(done).with("path", path)), now)
            }
            Err(reason) => {
                let reason = Message::new("error-at")
                    .with("place", asked.to_owned())
                    .with("problem", reason);
                Notice::problem(catalog.message(&Message::new(failed).with("reason", reason)))
            }
        }
    }
}
