//! Which file: asked in the system's dialog, or in the window, where its path is typed.

use egui::Context;

use crate::text::Message;

use super::{
    App, Command, Dialog,
    command::PathOf,
    dialog::{Answer, Figures, Question, Target},
};

impl App {
    pub(super) fn apply_dialog(&mut self, ctx: &Context, command: Command, now: f64) {
        match command {
            Command::Help if self.shown.dialog == Some(Dialog::Help) => self.shown.dialog = None,
            Command::Help => self.shown.dialog = Some(Dialog::Help),
            Command::OpenFile => self.ask(ctx, self.opened()),
            Command::Save => self.ask(ctx, self.saved()),
            Command::TypePath(PathOf::Opened) => self.shown.dialog = Some(self.opened()),
            Command::TypePath(PathOf::Saved) => self.shown.dialog = Some(self.saved()),
            // How figures look is asked first, and in the window.
            Command::Export => self.shown.dialog = Some(self.exported_to()),
            Command::Browse => {
                if let Some(dialog) = self.shown.dialog.take() {
                    self.ask(ctx, dialog);
                }
            }
            Command::Show(dialog) => self.shown.dialog = dialog,
            Command::Confirm => self.confirm(ctx, now),
            _ => {}
        }
    }

    /// Where a file of this scene would be put.
    fn suggested(&self, ending: &str) -> String {
        let step = self.bookmark.step().and_then(|step| step.figure.clone());
        let methods = self.history.now().document().methods();
        let method = methods.first().map(|card| card.id.to_owned());
        let stem = step.or(method).unwrap_or_default();
        self.platform.suggest(&format!("{stem}.{ending}"))
    }

    fn opened(&self) -> Dialog {
        let path = self.file.clone();
        Dialog::Open(Target::new(
            path.unwrap_or_else(|| self.platform.suggest("")),
        ))
    }

    fn saved(&self) -> Dialog {
        let path = self.file.clone();
        Dialog::Save(Target::new(path.unwrap_or_else(|| self.suggested("toml"))))
    }

    fn exported_to(&self) -> Dialog {
        let settings = &self.settings;
        let slide = || Figures::slide(settings.theme, settings.lang);
        let figures = settings.figures.unwrap_or_else(slide);
        Dialog::Export(Target::new(self.suggested("png")), figures)
    }

    /// Asks the system. Where it has no dialog, or the last one has not been heard of, the path is typed.
    fn ask(&mut self, ctx: &Context, dialog: Dialog) {
        let (title_key, opens, endings): (_, _, &[&str]) = match &dialog {
            Dialog::Open(_) => ("open-title", true, &["toml", "obj"]),
            Dialog::Save(_) => ("save-title", false, &["toml"]),
            Dialog::Export(..) => ("export-title", false, &["png"]),
            Dialog::Help => return,
        };
        let is_waiting = self.asked.take().is_some();
        let target = dialog.target().cloned();
        let Some(target) = target.filter(|_| self.platform.has_dialogs() && !is_waiting) else {
            self.shown.dialog = Some(dialog);
            return;
        };
        let question = Question {
            title: self.catalog().message(&Message::new(title_key)),
            path: target.path,
            opens,
            endings,
        };
        self.platform.ask(&question, ctx);
        self.asked = Some(dialog);
    }

    /// Does what was asked for when the system's dialog has been answered.
    pub(super) fn take_answer(&mut self, ctx: &Context, now: f64) {
        let Some(answer) = self.platform.answer() else {
            return;
        };
        let Some(mut dialog) = self.asked.take() else {
            return;
        };
        match answer {
            Answer::Chosen(path) => {
                // The system has asked about this file, and about none that is numbered after it.
                let replaces = !matches!(&dialog, Dialog::Export(_, figures) if figures.all);
                if let Some(target) = dialog.target_mut() {
                    *target = Target { path, replaces };
                }
                self.shown.dialog = Some(dialog);
                self.confirm(ctx, now);
            }
            Answer::Cancelled if !matches!(dialog, Dialog::Export(..)) => {}
            Answer::Cancelled | Answer::NoDialog => self.shown.dialog = Some(dialog),
        }
    }
}
