//! What is left out of the program and lies beside the page.

use std::{cell::Cell, rc::Rc};

use egui::Context;
use js_sys::{Function, Promise, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

use crate::paint::fonts::{self, chinese_fonts};

#[derive(Clone)]
pub struct Beside {
    fetch: Function,
    is_asked: Rc<Cell<bool>>,
}

impl Beside {
    pub fn new(fetch: Function) -> Self {
        Self {
            fetch,
            is_asked: Rc::default(),
        }
    }

    /// The fonts for Chinese. Until they are there eframe draws with those of the system; where they do not come they are asked
    /// for again in another visit.
    pub fn fetch_fonts(&self, ctx: &Context) {
        if self.is_asked.replace(true) {
            return;
        }
        let (fetch, ctx) = (self.fetch.clone(), ctx.clone());
        spawn_local(async move {
            let [regular, bold] = chinese_fonts::NAMES;
            if let Ok(regular) = fetched(&fetch, regular).await
                && let Ok(bold) = fetched(&fetch, bold).await
            {
                chinese_fonts::add([regular, bold]);
                ctx.set_fonts(fonts::definitions());
                ctx.request_repaint();
            }
        });
    }
}

async fn fetched(fetch: &Function, name: &str) -> Result<Vec<u8>, JsValue> {
    let promise = fetch.call1(&JsValue::NULL, &name.into())?;
    let bytes = JsFuture::from(promise.dyn_into::<Promise>()?).await?;
    Ok(Uint8Array::new(&bytes).to_vec())
}
