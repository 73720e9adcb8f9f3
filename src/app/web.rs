//! The app in a canvas of a web page.

use eframe::{WebOptions, WebRunner, wasm_bindgen::JsValue, web_sys::HtmlCanvasElement};
use egui::Ui;

use crate::{lesson::Course, paint::fonts};

use super::{App, Settings};

struct Page(App);

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.0.ui(ui);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        eframe::set_value(storage, "settings", &self.0.settings());
    }
}

/// Runs the app in a page's canvas.
///
/// # Errors
/// Why it cannot: no WebGL.
pub async fn start(canvas: HtmlCanvasElement) -> Result<(), JsValue> {
    let create: eframe::AppCreator<'_> = Box::new(|creation| {
        creation.egui_ctx.set_fonts(fonts::definitions());
        let stored = creation
            .storage
            .and_then(|storage| eframe::get_value(storage, "settings"));
        let language = eframe::web_sys::window().and_then(|window| window.navigator().language());
        let settings = stored.unwrap_or_else(|| Settings::for_locales(language.as_deref()));
        let mut app = App::new(Course::embedded(), settings);
        app.greet();
        Ok(Box::new(Page(app)))
    });
    WebRunner::new()
        .start(canvas, WebOptions::default(), create)
        .await
}
