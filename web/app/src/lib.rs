//! What the page calls.
#![cfg(target_arch = "wasm32")]

use std::panic;

use js_sys::Function;
use wasm_bindgen::prelude::*;
use web_sys::{CustomEvent, CustomEventInit, HtmlCanvasElement, window};

/// Runs the app in this canvas. `beside` promises the bytes of a file that lies beside the page, by its name. Of another course than
/// our own: where it lies, and its file, if that could be had.
///
/// # Errors
/// Why it cannot: no WebGL.
#[wasm_bindgen]
pub async fn start(
    canvas: HtmlCanvasElement,
    beside: Function,
    folder: Option<String>,
    course: Option<Vec<u8>>,
) -> Result<(), JsValue> {
    panic::set_hook(Box::new(|panic| tell(&panic.to_string())));
    let fetched = folder.map(|folder| (folder, course));
    clipscope::app::start(canvas, beside, fetched).await
}

/// The page stands when the app has fallen: it is told of that by an event.
fn tell(panic: &str) {
    let about = CustomEventInit::new();
    about.set_detail(&panic.into());
    let event = CustomEvent::new_with_event_init_dict("clipscope-panic", &about);
    if let (Ok(event), Some(window)) = (event, window()) {
        // There is nobody else to tell.
        let _ = window.dispatch_event(&event);
    }
}

/// For the test of what the page does then.
#[cfg(debug_assertions)]
#[wasm_bindgen]
pub fn panic() {
    panic!("for a test");
}
