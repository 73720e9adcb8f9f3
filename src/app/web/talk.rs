//! The page's address, which is a link to what is on the stage, and what the app tells the page around it, and is asked by that.

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::{Value as Json, json};
use wasm_bindgen::JsValue;
use web_sys::{CustomEvent, CustomEventInit, window};

use crate::lesson::Progress;

use super::super::{App, Command, desk::Page, prelude::*};

/// The address waits until nothing has changed for so long, in seconds: a browser takes as long for one as for half a frame.
const REST_SECS: f64 = 0.25;

#[derive(Default)]
pub struct Talk {
    /// What follows `#` in the address, as it was read or written last.
    place: String,
    stands: Option<Stands>,
    /// What is to be written there, and since when it is so.
    comes: Option<(Stands, f64)>,
    told: Json,
    /// Of the open step: how its question is answered, and whether its goal is reached.
    done: Option<(String, Told, Option<bool>)>,
    /// The marks that this browser had kept when the page was opened.
    found: Option<Progress>,
    /// Does a platform keep its student's marks? Then this browser keeps none.
    pub is_on_platform: bool,
    /// The lessons whose score the page wants, and the marks that it has been told of.
    scored: Vec<String>,
    marks: Option<Progress>,
}

/// What a link depends on: as long as it is the same, so is the link.
#[derive(PartialEq)]
struct Stands {
    page: Option<Page>,
    revision: u64,
    position: usize,
    eye: Option<Orbit>,
    look: (Lang, ThemeKind),
}

impl Stands {
    fn of(app: &App) -> Self {
        Self {
            page: app.bookmark.page(),
            revision: app.history.revision(),
            position: app.position(),
            eye: app.stage.turned_eye(),
            look: (app.settings.lang, app.settings.theme),
        }
    }
}

/// What another page may ask: `{"page": "05-intervals/entering", "lang": "es", "theme": "dark"}`, each or all of it. A platform asks for
/// the score of lessons, `{"scored": ["05-intervals"]}`, and brings marks that it has kept, `{"progress": "…"}`. To those only what is new
/// since the page was opened is added, `{"afresh": true}`: what this browser has kept may be another student's.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Asked {
    /// A link without its `#`.
    page: Option<String>,
    lang: Option<Lang>,
    theme: Option<ThemeKind>,
    scored: Option<Vec<String>>,
    afresh: bool,
    progress: Option<String>,
}

fn place() -> String {
    let hash = window().and_then(|window| window.location().hash().ok());
    hash.unwrap_or_default().trim_start_matches('#').to_owned()
}

impl Talk {
    /// Before a frame: what the address has come to say, and what was asked.
    pub fn hear(&mut self, app: &mut App, asked: Vec<String>) {
        let progress = &app.settings.progress;
        self.found.get_or_insert_with(|| progress.clone());
        let now = place();
        if now != self.place {
            if !now.is_empty() {
                app.open_link(&format!("#{now}"));
            }
            self.place = now;
        }
        for asked in asked {
            if let Ok(asked) = serde_json::from_str::<Asked>(&asked) {
                self.obey(app, asked);
            }
        }
    }

    fn obey(&mut self, app: &mut App, asked: Asked) {
        if asked.afresh {
            let found = self.found.take().unwrap_or_default();
            let own = app.settings.progress.since(&found);
            app.begin_afresh();
            app.settings.progress.merge(&own);
            self.is_on_platform = true;
        }
        if let Some(progress) = &asked.progress {
            app.take_up_marks(progress.as_bytes());
        }
        if asked.afresh || asked.progress.is_some() {
            // What was done another time is not told again.
            self.done = None;
        }
        if let Some(page) = asked.page {
            app.open_link(&format!("#{page}"));
        }
        self.scored = asked
            .scored
            .unwrap_or_else(|| std::mem::take(&mut self.scored));
        let look = asked.lang.map(Command::Language);
        app.push_all(look.into_iter().chain(asked.theme.map(Command::Theme)));
    }

    /// After a frame: what is open now, and what was answered.
    pub fn tell(&mut self, app: &App, ctx: &Context) {
        self.tell_address(app, ctx);
        self.tell_score(app);
        let Some(place) = step_of(app) else {
            return;
        };
        let transport = &app.playback.transport;
        let now = json!({"page": place, "step": transport.position(), "of": transport.n_steps()});
        if self.told != now {
            tell(&now);
            self.told = now;
        }
        self.tell_done((place, app.told_of_step(), app.reached_of_step()));
    }

    /// What has been answered or reached since the frame before, on the same page.
    fn tell_done(&mut self, now: (String, Told, Option<bool>)) {
        let before = self.done.replace(now.clone());
        let (page, told, reached) = now;
        let Some(before) = before.filter(|before| before.0 == page) else {
            return;
        };
        if before.1 != told {
            tell(&json!({"page": page, "answered": told}));
        }
        if before.2 != reached && reached == Some(true) {
            tell(&json!({"page": page, "reached": true}));
        }
    }

    /// The address follows, but for what is still moving; at first it stays as the reader has it.
    fn tell_address(&mut self, app: &App, ctx: &Context) {
        let stands = Stands::of(app);
        if self.stands.as_ref() == Some(&stands) || app.is_dragging() || app.is_recording() {
            self.comes = None;
            return;
        }
        let is_first = self.stands.is_none();
        let now = ctx.input(|input| input.time);
        let since = self.comes.as_ref().filter(|(comes, _)| *comes == stands);
        let since = since.map_or(now, |(_, since)| *since);
        let left = since + REST_SECS - now;
        if left > 0.0 && !is_first {
            self.comes = Some((stands, since));
            ctx.request_repaint_after(web_time::Duration::from_secs_f64(left));
            return;
        }
        (self.stands, self.comes) = (Some(stands), None);
        let link = app.address_link().filter(|_| !is_first);
        let place = link.as_deref().map(|link| link.trim_start_matches('#'));
        if let Some(place) = place.filter(|place| *place != self.place) {
            self.write(place);
        }
    }

    fn tell_score(&mut self, app: &App) {
        if self.scored.is_empty() {
            return;
        }
        let marks = match &self.found {
            Some(found) if !self.is_on_platform => Cow::Owned(app.settings.progress.since(found)),
            _ => Cow::Borrowed(&app.settings.progress),
        };
        if self.marks.as_ref() == Some(&*marks) {
            return;
        }
        let course = &app.bookmark.course;
        let lessons = self.scored.iter().filter_map(|id| course.lesson(id));
        let lessons: Vec<&Lesson> = lessons.collect();
        let tally = marks.of_lessons(lessons.iter().copied());
        let open = tally.open() + tally.goals - tally.reached;
        tell(
            &json!({"score": tally.score(), "open": open, "progress": marks.written_of(&lessons)}),
        );
        self.marks = Some(marks.into_owned());
    }

    fn write(&mut self, place: &str) {
        let history = window().and_then(|window| window.history().ok());
        let hash = format!("#{place}");
        let written = history.map(|it| it.replace_state_with_url(&JsValue::NULL, "", Some(&hash)));
        if written.is_some_and(|written| written.is_ok()) {
            // As the browser spells it.
            self.place = self::place();
        }
    }
}

/// The open step by its name.
fn step_of(app: &App) -> Option<String> {
    match app.bookmark.page()? {
        Page::Step(lesson, step) => Some(format!("{lesson}/{step}")),
        Page::Free(_) | Page::Named(..) => None,
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
