//! The system's own dialogs for files. They open in a thread of their own: the window waits for none of them.

use std::{
    path::Path,
    pin::Pin,
    sync::mpsc::{self, Receiver},
    thread,
};

use egui::Context;
use rfd::{AsyncFileDialog, FileHandle};

use super::dialog::{Answer, Question};

#[derive(Default)]
pub struct Chooser {
    answer: Option<Receiver<Answer>>,
    is_missing: bool,
}

impl Chooser {
    pub const fn is_missing(&self) -> bool {
        self.is_missing
    }

    /// Opens a dialog. What came of one before is heard no more.
    pub fn ask(&mut self, question: &Question, ctx: &Context) {
        let (said, answer) = mpsc::channel();
        self.answer = Some(answer);
        let dialog = dialog(question);
        let file: Pin<Box<dyn Future<Output = Option<FileHandle>> + Send>> = if question.opens {
            Box::pin(dialog.pick_file())
        } else {
            Box::pin(dialog.save_file())
        };
        let ctx = ctx.clone();
        thread::spawn(move || {
            let answer = if system::has_dialogs() {
                let file = pollster::block_on(file);
                file.map_or(Answer::Cancelled, |file| {
                    Answer::Chosen(file.path().display().to_string())
                })
            } else {
                Answer::NoDialog
            };
            // Nobody listens where another dialog was opened in the meantime.
            if said.send(answer).is_ok() {
                ctx.request_repaint();
            }
        });
    }

    pub fn answer(&mut self) -> Option<Answer> {
        let answer = self.answer.as_ref()?.try_recv().ok()?;
        self.answer = None;
        self.is_missing = answer == Answer::NoDialog;
        Some(answer)
    }
}

fn dialog(question: &Question) -> AsyncFileDialog {
    let path = Path::new(&question.path);
    let mut dialog = AsyncFileDialog::new().set_title(&question.title);
    let endings = question.endings.iter().map(|ending| format!("*.{ending}"));
    let shown = endings.collect::<Vec<_>>().join(", ");
    if !question.endings.is_empty() {
        dialog = dialog.add_filter(shown, question.endings);
    }
    if let Some(folder) = path.parent() {
        dialog = dialog.set_directory(folder);
    }
    match path.file_name() {
        Some(name) if !question.opens => dialog.set_file_name(name.display().to_string()),
        _ => dialog,
    }
}

/// On Linux and its kin dialogs are another program's, and there may be none: rfd then answers as if its dialog had been
/// closed, or waits for ever.
#[cfg(all(unix, not(target_os = "macos")))]
mod system {
    use std::{env, sync::mpsc, thread, time::Duration};

    /// A portal that has to be started first is there within a second.
    const PATIENCE: Duration = Duration::from_secs(3);

    pub fn has_dialogs() -> bool {
        has_portal() || has_program("zenity")
    }

    fn has_portal() -> bool {
        let (said, answer) = mpsc::channel();
        thread::spawn(move || said.send(pollster::block_on(version()).is_ok()));
        answer.recv_timeout(PATIENCE).unwrap_or(false)
    }

    async fn version() -> zbus::Result<()> {
        let bus = zbus::Connection::session().await?;
        let asked = ("org.freedesktop.portal.FileChooser", "version");
        let portal = Some("org.freedesktop.portal.Desktop");
        let properties = Some("org.freedesktop.DBus.Properties");
        let path = "/org/freedesktop/portal/desktop";
        bus.call_method(portal, path, properties, "Get", &asked)
            .await?;
        Ok(())
    }

    fn has_program(name: &str) -> bool {
        let paths = env::var_os("PATH").unwrap_or_default();
        env::split_paths(&paths).any(|folder| folder.join(name).is_file())
    }
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
mod system {
    pub const fn has_dialogs() -> bool {
        true
    }
}
