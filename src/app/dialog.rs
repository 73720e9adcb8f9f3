//! What lies over the window, or beside it: the list of keys, the question which file. It is asked in the system's dialog, or
//! in the window, where its path is typed.

use serde::{Deserialize, Serialize};

use super::{App, desk::SceneAct, prelude::*};

#[derive(Clone, PartialEq, Debug)]
pub enum Dialog {
    Help,
    Open(Target),
    Save(Target),
    /// A folder that becomes a lesson.
    Lesson(Target),
    Export(Target, Figures),
    /// About a whole scene, of this name.
    Scene(SceneAct, String),
    /// What has been seen and told; is it to be begun afresh once that is said again?
    Progress(bool),
    /// The same as a file to be handed in, or one that is taken up.
    HandIn(Target),
    TakeUp(Target),
}

impl Dialog {
    pub const fn target_mut(&mut self) -> Option<&mut Target> {
        match self {
            Self::Help | Self::Scene(..) | Self::Progress(_) => None,
            Self::Open(target)
            | Self::Save(target)
            | Self::Lesson(target)
            | Self::HandIn(target)
            | Self::TakeUp(target)
            | Self::Export(target, _) => Some(target),
        }
    }
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Target {
    pub path: String,
    /// Another file stands there: it is replaced when the reader says so again.
    pub replaces: bool,
}

impl Target {
    pub const fn new(path: String) -> Self {
        Self {
            path,
            replaces: false,
        }
    }
}

/// The path that was meant, where a whole one was typed over the name alone: what stands before it is not, and its ending only once.
pub fn meant(path: &str) -> String {
    let before = path.rfind("//").filter(|&at| at > 0);
    let whole = before.map_or(path, |at| &path[at + 1..]);
    let named = whole.rsplit_once('.').filter(|(stem, ending)| {
        let before = stem.rsplit_once('.').map(|(_, before)| before);
        before == Some(*ending)
    });
    named.map_or(whole, |(stem, _)| stem).to_owned()
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Question {
    pub title: String,
    /// What is suggested; to open a file, the folder it is looked for in counts.
    pub path: String,
    pub opens: bool,
    /// How the names of such files end: `toml`.
    pub endings: &'static [&'static str],
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Answer {
    /// This file; where it is to be written and there was one, the reader has said that it is to be replaced.
    Chosen(String),
    Cancelled,
    NoDialog,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Figures {
    pub size_px: [u32; 2],
    pub theme: ThemeKind,
    pub lang: Lang,
    pub all: bool,
}

impl Figures {
    pub const SIZES: [[u32; 2]; 3] = [[1280, 720], [1920, 1080], [3840, 2160]];
}

impl App {
    /// Where a file of this scene would be put.
    fn suggested(&self, ending: &str) -> String {
        let step = self.bookmark.step().and_then(|step| step.figure.clone());
        let methods = self.scene().document().methods();
        let method = methods.first().map(|card| card.id.to_owned());
        let stem = step.or(method).unwrap_or_default();
        self.platform.suggest(&format!("{stem}.{ending}"))
    }

    pub(super) fn opened(&self) -> Dialog {
        let path = self.history.file().map(str::to_owned);
        let path = path.unwrap_or_else(|| self.platform.suggest(""));
        Dialog::Open(Target::new(path))
    }

    pub(super) fn saved(&self) -> Dialog {
        let path = self.history.file().map(str::to_owned);
        Dialog::Save(Target::new(path.unwrap_or_else(|| self.suggested("toml"))))
    }

    pub(super) fn exported_to(&self) -> Dialog {
        let figures = self.settings.figures.unwrap_or(self.slide());
        Dialog::Export(Target::new(self.suggested("png")), figures)
    }

    /// A figure of this step that looks as the window does.
    pub(super) const fn slide(&self) -> Figures {
        Figures {
            size_px: Figures::SIZES[1],
            theme: self.settings.theme,
            lang: self.settings.lang,
            all: false,
        }
    }

    /// Has the system a dialog of its own for such files?
    pub(super) fn has_dialog(&self, opens: bool) -> bool {
        self.platform.has_dialogs() && (opens || self.platform.has_paths())
    }

    /// Asks the system. Where it has no dialog, or the last one has not been heard of, the path is typed.
    pub(super) fn ask(&mut self, ctx: &Context, mut dialog: Dialog) {
        let (title_key, opens, endings): (_, _, &[&str]) = match &dialog {
            Dialog::Open(_) => ("open-title", true, &["toml", "obj"]),
            Dialog::Save(_) => ("save-title", false, &["toml"]),
            Dialog::Lesson(_) => ("lesson-save-title", false, &[]),
            Dialog::Export(..) => ("export-title", false, self.platform.formats()),
            Dialog::HandIn(_) => ("hand-in-title", false, &["json"]),
            Dialog::TakeUp(_) => ("take-up-title", true, &["json"]),
            Dialog::Help | Dialog::Scene(..) | Dialog::Progress(_) => return,
        };
        let is_waiting = self.asked.take().is_some() && self.platform.has_paths();
        let target = dialog.target_mut().cloned();
        let Some(target) = target.filter(|_| self.has_dialog(opens) && !is_waiting) else {
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

#[cfg(test)]
mod tests {
    use super::meant;

    #[test]
    fn a_whole_path_typed_over_a_name_is_meant_alone() {
        let cases = [
            ("/work/own//tmp/a.toml.toml", "/tmp/a.toml"),
            ("/work/own//tmp/a.toml", "/tmp/a.toml"),
            ("/work/own/a.b.toml", "/work/own/a.b.toml"),
            ("a.toml.toml", "a.toml"),
            ("a", "a"),
            ("", ""),
        ];
        for (path, expected) in cases {
            assert_eq!(meant(path), expected, "{path}");
        }
    }
}
