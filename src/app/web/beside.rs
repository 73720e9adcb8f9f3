//! What is left out of the program and lies beside the page.

use std::{
    cell::{Cell, RefCell},
    collections::BTreeSet,
    rc::Rc,
};

use egui::Context;
use js_sys::{Function, Promise, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};

use crate::{
    paint::fonts::{self, chinese_fonts},
    text::Part,
};

#[derive(Clone)]
pub struct Beside {
    fetch: Function,
    ctx: Context,
    is_asked: Rc<Cell<bool>>,
    parts: Rc<RefCell<Parts>>,
}

#[derive(Default)]
struct Parts {
    on_their_way: BTreeSet<Part>,
    /// And whether they have come.
    fetched: Vec<(Part, bool)>,
}

impl Beside {
    pub fn new(fetch: Function, ctx: Context) -> Self {
        Self {
            fetch,
            ctx,
            is_asked: Rc::default(),
            parts: Rc::default(),
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

    /// Is it on its way from now on? Not where it was before, or is there.
    pub fn fetch_part(&self, part: Part) -> bool {
        if part.is_here() || !self.parts.borrow_mut().on_their_way.insert(part) {
            return false;
        }
        let it = self.clone();
        spawn_local(async move {
            let has_come = take_up(&it.fetch, part).await;
            let mut parts = it.parts.borrow_mut();
            parts.fetched.push((part, has_come));
            parts.on_their_way.remove(&part);
            it.ctx.request_repaint();
        });
        true
    }

    pub fn take_fetched(&self) -> Vec<(Part, bool)> {
        std::mem::take(&mut self.parts.borrow_mut().fetched)
    }
}

/// Fetches a part, and has it used from now on.
pub async fn take_up(fetch: &Function, part: Part) -> bool {
    let bytes = fetched(fetch, part.file()).await;
    bytes.is_ok_and(|bytes| part.take_up(&bytes))
}

async fn fetched(fetch: &Function, name: &str) -> Result<Vec<u8>, JsValue> {
    let promise = fetch.call1(&JsValue::NULL, &name.into())?;
    let bytes = JsFuture::from(promise.dyn_into::<Promise>()?).await?;
    Ok(Uint8Array::new(&bytes).to_vec())
}
