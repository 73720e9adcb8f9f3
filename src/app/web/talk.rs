//! The page's address, which says what is open, and what it tells the page around it, and is asked by that.

use serde::Deserialize;
use serde_json::{Value as Json, json};
use wasm_bindgen::JsValue;
use web_sys::{CustomEvent, CustomEventInit, window};

use super::super::{App, Command, desk::Page, prelude::*};

#[derive(Default)]
pub struct Talk {
    /// What follows `#` in the address, as it was read or written last.
    place: String,
    told: Json,
    answered: Option<(String, Told)>,
}

/// What another page may ask: `{"page": "05-intervals/entering", "lang": "es", "theme": "dark"}`, each or all of it.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Asked {
    page: Option<String>,
    lang: Option<Lang>,
    theme: Option<ThemeKind>,
}

fn step(place: &str) -> Option<Page> {
    let (lesson, step) = place.split_once('/')?;
    Some(Page::Step(lesson.to_owned(), step.to_owned()))
}

fn place() -> String {
    let hash = window().and_then(|window| window.location().hash().ok());
    hash.unwrap_or_default().trim_start_matches('#').to_owned()
}

impl Talk {
    /// Before a frame: what the address has come to say, and what was asked.
    pub fn hear(&mut self, app: &mut App, asked: Vec<String>) {
        let now = place();
        if now != self.place {
            if let Some(page) = step(&now) {
                app.open_page(&page);
            }
            self.place = now;
        }
        for asked in asked {
            let Ok(asked) = serde_json::from_str::<Asked>(&asked) else {
                continue;
            };
            let page = asked.page.as_deref().and_then(step).map(Command::OpenPage);
            let look = asked.lang.map(Command::Language);
            app.push_all(
                page.into_iter()
                    .chain(look)
                    .chain(asked.theme.map(Command::Theme)),
            );
        }
    }

    /// After a frame: what is open now, and what was answered.
    pub fn tell(&mut self, app: &App) {
        let Some(place) = app.place() else {
            return;
        };
        let transport = &app.playback.transport;
        let now = json!({"page": place, "step": transport.position(), "of": transport.n_steps()});
        if self.told != now {
            let is_first = self.told.is_null();
            tell(&now);
            self.told = now;
            if !is_first && self.place != place {
                self.write(&place);
            }
        }
        let answered = Some((place, app.told_of_step()));
        if self.answered != answered {
            let before = self.answered.take();
            if let (Some((before, _)), Some((now, told))) = (before, &answered)
                && before == *now
            {
                tell(&json!({"page": now, "answered": told}));
            }
            self.answered = answered;
        }
    }

    fn write(&mut self, place: &str) {
        let history = window().and_then(|window| window.history().ok());
        let hash = format!("#{place}");
        let written = history.map(|it| it.replace_state_with_url(&JsValue::NULL, "", Some(&hash)));
        if written.is_some_and(|written| written.is_ok()) {
            place.clone_into(&mut self.place);
        }
    }
}

fn tell(what: &Json) {
    let about = CustomEventInit::new();
    about.set_detail(&what.to_string().into());
    let event = CustomEvent::new_with_event_init_dict("clipscope-told", &about);
    if let (Ok(event), Some(window)) = (event, window()) {
        // Nobody has to listen.
        let _ = window.dispatch_event(&event);
    }
}
