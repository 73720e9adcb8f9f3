//! Figures of the scene, exported one a frame, or copied.

use egui::ColorImage;

use crate::paint::Image;

use super::{
    App, Dialog,
    dialog::{Figures, Target},
    platform::StageFigure,
    prelude::*,
};

/// What is exported now, and what would be.
#[derive(Default)]
pub struct Exports {
    running: Option<Export>,
    /// The size of the file that the open dialog is about, in bytes, where it could be drawn.
    weighed: Option<(Weighed, Option<usize>)>,
}

/// What the size of a file depends on.
#[derive(PartialEq)]
struct Weighed {
    ending: String,
    figures: Figures,
    step: usize,
}

/// Figures on their way into files.
struct Export {
    path: String,
    figures: Figures,
    title: Option<String>,
    scene: Scene,
    lesson: Option<String>,
    /// The step that is drawn next, and the last one.
    next: usize,
    last: usize,
}

impl Export {
    fn figure<'a>(&'a self, lesson: Option<&'a Lesson>) -> StageFigure<'a> {
        StageFigure {
            title: self.title.as_deref(),
            scene: &self.scene,
            lesson,
            position: self.next,
            figures: self.figures,
        }
    }
}

/// What says its format.
pub fn ending_of(path: &str) -> &str {
    let ending = path.rsplit_once('.').map(|(_, ending)| ending);
    ending
        .filter(|ending| !ending.contains(['/', '\\']))
        .unwrap_or_default()
}

/// The file of a step: of many, each has its number before the ending.
pub fn path_of(path: &str, figures: Figures, step: usize) -> String {
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
    /// The first and the last step that become figures.
    pub(super) const fn exported(&self, figures: Figures) -> [usize; 2] {
        let transport = &self.playback.transport;
        if figures.all {
            [0, transport.n_steps()]
        } else {
            [transport.position(); 2]
        }
    }

    fn export_of(&self, path: String, figures: Figures) -> Export {
        let is_shown = self.is_open() && !figures.all;
        let title = self.bookmark.title(figures.lang, is_shown);
        let [next, last] = self.exported(figures);
        Export {
            path,
            figures,
            title: title.filter(|_| self.is_untouched()).map(str::to_owned),
            scene: self.scene().clone(),
            lesson: self.bookmark.lesson().map(|lesson| lesson.id.clone()),
            next,
            last,
        }
    }

    pub(super) fn export(&mut self, path: String, figures: Figures, ctx: &Context, now: f64) {
        self.exports.running = Some(self.export_of(path, figures));
        self.export_next(ctx, now);
    }

    /// Ends an export that is under way: was there one?
    pub(super) fn end_export(&mut self) -> bool {
        self.exports.running.take().is_some()
    }

    /// Draws the next figure of an export, one a frame: the window stays awake, and Escape ends it.
    pub(super) fn export_next(&mut self, ctx: &Context, now: f64) {
        let Some(mut export) = self.exports.running.take() else {
            return;
        };
        let path = path_of(&export.path, export.figures, export.next);
        let bytes = self.made(&export, ctx);
        let written = bytes.and_then(|bytes| self.platform.write(&path, &bytes));
        self.notices.clear();
        if written.is_ok() && export.next < export.last {
            export.next += 1;
            let message = Message::new("status-exporting")
                .with("count", export.next)
                .with("total", export.last + 1);
            self.exports.running = Some(export);
            ctx.request_repaint();
            self.tell(&message, now);
            return;
        }
        if written.is_err() {
            let dialog = Dialog::Export(Target::new(export.path), export.figures);
            self.shown.dialog = Some(dialog);
        }
        let keys = ["status-exported", "status-export-failed"];
        self.report(&path, written, keys, now);
    }

    /// To the next figure of an export, unless the scene has been changed since.
    fn link_of(&self, export: &Export) -> Option<String> {
        let is_shown = self.pending.is_none() && export.scene == *self.history.now();
        let moment = is_shown.then(|| self.playback.main().moment(export.next))?;
        self.link_at(export.next, &moment).fitting()
    }

    /// The file of the next figure of an export.
    fn made(&mut self, export: &Export, ctx: &Context) -> Result<Vec<u8>, Diagnostic> {
        let link = self.link_of(export);
        let lesson = export.lesson.as_ref();
        let lesson = lesson.and_then(|id| self.bookmark.course.lesson(id));
        let figure = export.figure(lesson);
        self.platform
            .figure_file(figure, ending_of(&export.path), link.as_deref(), ctx)
    }

    fn drawn(&mut self, export: &Export, ctx: &Context) -> Result<Image, Diagnostic> {
        let lesson = export.lesson.as_ref();
        let lesson = lesson.and_then(|id| self.bookmark.course.lesson(id));
        self.platform.draw(export.figure(lesson), ctx)
    }

    /// Finds out how large the file of this step becomes that the open dialog is about, where that is not known.
    pub(super) fn weigh_export(&mut self, ctx: &Context) {
        let Some(Dialog::Export(target, figures)) = &self.shown.dialog else {
            self.exports.weighed = None;
            return;
        };
        let of = Weighed {
            ending: ending_of(&target.path).to_owned(),
            figures: *figures,
            step: self.playback.transport.position(),
        };
        if self
            .exports
            .weighed
            .as_ref()
            .is_some_and(|(known, _)| *known == of)
        {
            return;
        }
        let mut export = self.export_of(target.path.clone(), *figures);
        export.next = of.step;
        let n_bytes = self.made(&export, ctx).ok().map(|bytes| bytes.len());
        self.exports.weighed = Some((of, n_bytes));
        ctx.request_repaint();
    }

    /// How large that is, and how many there are.
    pub(super) fn weight(&self, figures: Figures) -> Option<(usize, usize)> {
        let (_, n_bytes) = self.exports.weighed.as_ref()?;
        let [first, last] = self.exported(figures);
        Some(((*n_bytes)?, last - first + 1))
    }

    /// Puts what an export would write of this step on the system's clipboard.
    pub(super) fn copy_figure(&mut self, ctx: &Context, now: f64) {
        let export = self.copied("figure.png");
        let copied = self.drawn(&export, ctx).map(|Image { size, rgba }| {
            ctx.copy_image(ColorImage::from_rgba_unmultiplied(size, &rgba));
            let [width, height] = size.map(|side| side.to_string());
            let message = Message::new("status-copied").with("width", width);
            message.with("height", height)
        });
        self.tell_copied(copied, now);
    }

    /// The same as the text of an SVG file.
    pub(super) fn copy_svg(&mut self, ctx: &Context, now: f64) {
        let export = self.copied("figure.svg");
        let copied = self.made(&export, ctx).map(|bytes| {
            let kilobytes = bytes.len().div_ceil(1000);
            ctx.copy_text(String::from_utf8_lossy(&bytes).into_owned());
            Message::new("status-copied-svg").with("count", kilobytes)
        });
        self.tell_copied(copied, now);
    }

    fn copied(&self, path: &str) -> Export {
        let slide = self.slide();
        let last = self.settings.figures.unwrap_or(slide);
        let figures = Figures {
            size_px: last.size_px,
            ..slide
        };
        self.export_of(path.to_owned(), figures)
    }

    fn tell_copied(&mut self, copied: Result<Message, Diagnostic>, now: f64) {
        match copied {
            Ok(message) => self.tell(&message, now),
            Err(reason) => {
                let message = Message::new("status-copy-failed").with("reason", reason);
                self.complain(self.catalog().message(&message));
            }
        }
    }
}
