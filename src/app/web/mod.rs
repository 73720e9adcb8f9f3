//! The app in a canvas of a web page.

mod beside;
mod files;
mod host;
mod mirror;
mod talk;

use eframe::{WebOptions, WebRunner};
use egui::{Context, Ui};
use js_sys::Function;
use wasm_bindgen::JsValue;
use web_sys::HtmlCanvasElement;

use crate::{
    lesson::{Course, FileError, unpacked},
    paint::fonts,
    text::Part,
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
    has_followed: bool,
}

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.talk.hear(&mut self.app, self.heard.asked());
        self.app.ui(ui);
        self.talk.tell(&self.app, ui.ctx());
        if self.talk.is_on_platform {
            self.memory.forget();
        }
        self.memory.pass(&mut self.app, ui.ctx());
        let lang = Some(self.app.settings.lang);
        if std::mem::replace(&mut self.lang, lang) != lang {
            host::speak(self.app.settings.lang);
        } else {
            self.follow(ui.ctx());
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

impl Page {
    /// All that is left out of the program follows the first frame, where the reader does not save data.
    fn follow(&mut self, ctx: &Context) {
        let stays = self.has_followed || host::saves_data();
        if !stays || self.app.settings.lang == Lang::ZhCn {
            self.beside.fetch_fonts(ctx);
        }
        if !stays {
            self.has_followed = true;
            for part in Part::ALL {
                self.beside.fetch_part(part);
            }
        }
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

/// The settings that were kept, or those of a first visit, once the texts of their language have come; without these in English.
async fn settings(stored: Option<Settings>, fetch: &Function) -> (Settings, Option<Message>) {
    let mut settings = stored.unwrap_or_else(host::first_settings);
    let texts = Part::Texts(settings.lang);
    if texts.is_here() || beside::take_up(fetch, texts).await {
        return (settings, None);
    }
    let what = settings.lang.native_name().to_owned();
    settings.lang = Lang::En;
    (
        settings,
        Some(Message::new("status-not-come").with("what", what)),
    )
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
    let shelf = Shelf::of_system();
    let refused = (shelf.is_none()).then(|| Message::new("status-memory-refused"));
    let (stored, memory, said) = Memory::open(shelf);
    let (settings, lost) = settings(stored, &beside).await;
    let create: eframe::AppCreator<'_> = Box::new(move |creation| {
        let ctx = &creation.egui_ctx;
        ctx.set_fonts(fonts::definitions());
        let (course, folder, unread) = opened(fetched);
        let settings = Settings { folder, ..settings };
        let beside = Beside::new(beside, ctx.clone());
        let files = PageFiles::new(beside.clone());
        let mut app = App::new(course, settings).with_platform(files);
        for said in said.into_iter().chain(refused).chain(lost) {
            app.complain(app.catalog().message(&said));
        }
        if let Some(unread) = unread {
            app.complain(app.catalog().message(&unread.message));
        }
        let is_embedded = host::is_embedded();
        if is_embedded {
            app = app.embedded();
        } else {
            app.rewind_for_someone_new();
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
            has_followed: false,
        }))
    });
    WebRunner::new()
        .start(canvas, WebOptions::default(), create)
        .await
}
