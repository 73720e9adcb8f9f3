//! The app in a canvas of a web page.

mod beside;
mod files;
mod host;
mod mirror;
mod talk;

use eframe::{WebOptions, WebRunner};
use egui::Ui;
use js_sys::Function;
use wasm_bindgen::JsValue;
use web_sys::HtmlCanvasElement;

use crate::{
    lesson::{Course, FileError, unpacked},
    paint::fonts,
};

use super::{App, Settings, memory::Memory, prelude::*, shelf::Shelf};

use beside::Beside;
use files::PageFiles;
use host::{Heard, Host};
use talk::Talk;

struct Page {
    app: App,
    memory: Memory,
    /// What the page has been told that it speaks.
    lang: Option<Lang>,
    beside: Beside,
    heard: Heard,
    talk: Talk,
}

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.talk.hear(&mut self.app, self.heard.asked());
        self.app.ui(ui);
        self.talk.tell(&self.app);
        self.memory.pass(&mut self.app, ui.ctx());
        let lang = Some(self.app.settings.lang);
        if std::mem::replace(&mut self.lang, lang) != lang {
            host::speak(self.app.settings.lang);
            // All that is left out of the program follows the first frame, where the reader does not save data.
        } else if lang == Some(Lang::ZhCn) || !host::saves_data() {
            self.beside.fetch_fonts(ui.ctx());
        }
    }

    /// eframe calls this when the page is left, is hidden or loses the focus, and every half minute.
    fn save(&mut self, _: &mut dyn eframe::Storage) {
        if self.memory.has_more() {
            self.memory.end(&mut self.app);
        }
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.window_fill.to_normalized_gamma_f32()
    }
}

/// A course that a page's address names: where it lies, and the file that was fetched from there.
pub type Fetched = (String, Option<Vec<u8>>);

/// The course that was fetched, in the place of our own.
fn opened(fetched: Option<Fetched>) -> (Course, Option<String>, Option<Diagnostic>) {
    let Some((folder, bytes)) = fetched else {
        return (Course::embedded(), None, None);
    };
    let missing = || Diagnostic::from(FileError::NOT_FOUND);
    let files = bytes.ok_or_else(missing).and_then(|bytes| unpacked(&bytes));
    match files {
        Ok(files) => (Course::check(&files).course, Some(folder), None),
        Err(reason) => {
            let message = Message::new("status-open-failed").with("path", folder);
            let message = message.with("reason", reason);
            (Course::embedded(), None, Some(message.into()))
        }
    }
}

/// Runs the app in a page's canvas. `beside` promises the bytes of a file that lies beside the page, by its name.
///
/// # Errors
/// Why it cannot: no WebGL.
pub async fn start(
    canvas: HtmlCanvasElement,
    beside: Function,
    fetched: Option<Fetched>,
) -> Result<(), JsValue> {
    let stage = canvas.clone();
    let create: eframe::AppCreator<'_> = Box::new(move |creation| {
        let ctx = &creation.egui_ctx;
        ctx.set_fonts(fonts::definitions());
        let shelf = Shelf::of_system();
        let refused = shelf
            .is_none()
            .then(|| Message::new("status-memory-refused"));
        let (stored, memory, said) = Memory::open(shelf);
        let (course, folder, unread) = opened(fetched);
        let settings = Settings {
            folder,
            ..stored.unwrap_or_else(host::first_settings)
        };
        let beside = Beside::new(beside);
        let files = PageFiles::new(beside.clone());
        let mut app = App::new(course, settings).with_platform(files);
        for said in said.into_iter().chain(refused) {
            app.complain(app.catalog().message(&said));
        }
        if let Some(unread) = unread {
            app.complain(app.catalog().message(&unread.message));
        }
        let is_embedded = host::is_embedded();
        if is_embedded {
            app = app.embedded();
        } else {
            app.greet();
        }
        let heard = Heard::listen(ctx);
        Host::install(stage, ctx, heard.clone());
        Ok(Box::new(Page {
            app,
            memory,
            lang: None,
            beside,
            heard,
            talk: Talk::default(),
        }))
    });
    WebRunner::new()
        .start(canvas, WebOptions::default(), create)
        .await
}
