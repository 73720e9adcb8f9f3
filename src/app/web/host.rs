//! What stands around the canvas and is told of the app: the page's title, the whole screen, and the mirror for screen readers.
//! eframe leaves these out of what it does with a frame's output.

use std::{cell::RefCell, rc::Rc};

use egui::{Event, FullOutput, Key, Modifiers, Plugin, RawInput, ViewportCommand, accesskit};
use js_sys::Reflect;
use send_wrapper::SendWrapper;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{CustomEvent, Document, HtmlCanvasElement, window};

use super::super::{prelude::*, settings::Settings};
use super::mirror::Mirror;

pub struct Host(SendWrapper<Around>);

struct Around {
    document: Document,
    mirror: Option<Mirror>,
    heard: Heard,
}

/// What was done in the page around the canvas since the last frame.
#[derive(Clone, Default)]
pub struct Heard(Rc<RefCell<Said>>);

#[derive(Default)]
struct Said {
    events: Vec<Event>,
    /// By the page around.
    asked: Vec<String>,
    /// Is a presentation on the whole screen?
    is_full: bool,
}

impl Host {
    pub fn install(canvas: HtmlCanvasElement, ctx: &Context, heard: Heard) {
        let Some(document) = window().and_then(|window| window.document()) else {
            return;
        };
        let tell = |event: fn(accesskit::NodeId) -> Event| {
            let (heard, ctx) = (heard.clone(), ctx.clone());
            move |id| {
                heard.0.borrow_mut().events.push(event(id));
                ctx.request_repaint();
            }
        };
        let place = document.get_element_by_id("mirror");
        let mirror = place.and_then(|place| Mirror::new(place, canvas, tell(clicked)).ok());
        if mirror.is_some() {
            ctx.enable_accesskit();
        }
        heard.watch_screen(&document, ctx);
        ctx.add_plugin(Self(SendWrapper::new(Around {
            document,
            mirror,
            heard,
        })));
    }
}

fn clicked(id: accesskit::NodeId) -> Event {
    Event::AccessKitActionRequest(accesskit::ActionRequest {
        action: accesskit::Action::Click,
        target_tree: accesskit::TreeId::ROOT,
        target_node: id,
        data: None,
    })
}

impl Heard {
    pub fn listen(ctx: &Context) -> Self {
        let heard = Self::default();
        let (asked, ctx) = (heard.clone(), ctx.clone());
        let told = Closure::<dyn Fn(CustomEvent)>::new(move |event: CustomEvent| {
            asked
                .0
                .borrow_mut()
                .asked
                .extend(event.detail().as_string());
            ctx.request_repaint();
        });
        let told = told.into_js_value();
        let listening = window().map(|window| {
            window.add_event_listener_with_callback("clipscope-ask", told.unchecked_ref())
        });
        // A page that lets nobody listen asks nothing.
        let _ = listening;
        heard
    }

    pub fn asked(&self) -> Vec<String> {
        std::mem::take(&mut self.0.borrow_mut().asked)
    }

    /// Escape leaves the whole screen without a word to the page: the presentation ends with it.
    fn watch_screen(&self, document: &Document, ctx: &Context) {
        let (heard, ctx, asked) = (self.clone(), ctx.clone(), document.clone());
        let changed = Closure::<dyn Fn()>::new(move || {
            let mut said = heard.0.borrow_mut();
            if asked.fullscreen_element().is_none() && std::mem::take(&mut said.is_full) {
                said.events.push(Event::Key {
                    key: Key::Escape,
                    physical_key: None,
                    pressed: true,
                    repeat: false,
                    modifiers: Modifiers::NONE,
                });
                ctx.request_repaint();
            }
        });
        let changed = changed.into_js_value();
        // Without this listener, Escape has to be pressed twice.
        let _ =
            document.add_event_listener_with_callback("fullscreenchange", changed.unchecked_ref());
    }
}

impl Around {
    fn obey(&self, command: &ViewportCommand) -> bool {
        match command {
            ViewportCommand::Title(title) => self.document.set_title(title),
            ViewportCommand::Fullscreen(true) => {
                self.heard.0.borrow_mut().is_full = true;
                // A frame without the right to it presents where it stands.
                let root = self.document.document_element();
                let _ = root.map(|root| root.request_fullscreen());
            }
            ViewportCommand::Fullscreen(false) => {
                self.heard.0.borrow_mut().is_full = false;
                if self.document.fullscreen_element().is_some() {
                    self.document.exit_fullscreen();
                }
            }
            _ => return false,
        }
        true
    }
}

impl Plugin for Host {
    fn debug_name(&self) -> &'static str {
        "page"
    }

    fn input_hook(&mut self, _: &Context, input: &mut RawInput) {
        let mut said = self.0.heard.0.borrow_mut();
        input.events.append(&mut said.events);
    }

    fn output_hook(&mut self, _: &Context, output: &mut FullOutput) {
        for viewport in output.viewport_output.values_mut() {
            viewport.commands.retain(|command| !self.0.obey(command));
        }
        let update = output.platform_output.accesskit_update.take();
        if let (Some(mirror), Some(update)) = (&mut self.0.mirror, update) {
            mirror.show(update);
        }
    }
}

/// Is it in a frame of another page, as a part of that?
pub fn is_embedded() -> bool {
    let search = window().and_then(|window| window.location().search().ok());
    let search = search.unwrap_or_default();
    let mut parts = search.trim_start_matches('?').split('&');
    parts.any(|part| part == "embed" || part.starts_with("embed="))
}

/// Does the reader wish that little is sent?
pub fn saves_data() -> bool {
    let navigator = window().map(|window| JsValue::from(window.navigator()));
    let of = |object: JsValue, name: &str| Reflect::get(&object, &name.into()).ok();
    let network = navigator.and_then(|navigator| of(navigator, "connection"));
    let wish = network.and_then(|network| of(network, "saveData"));
    wish.and_then(|wish| wish.as_bool()).unwrap_or_default()
}

/// Says in which language the page is.
pub fn speak(lang: Lang) {
    let document = window().and_then(|window| window.document());
    let root = document.and_then(|document| document.document_element());
    let _: Option<Result<(), JsValue>> = root.map(|root| root.set_attribute("lang", lang.id()));
}

/// What the browser says of the system and of who sits there, by a media query.
pub fn is_so(query: &str) -> bool {
    let asked = window().and_then(|window| window.match_media(query).ok()?);
    asked.is_some_and(|asked| asked.matches())
}

/// So large is the text of what is held in a hand, of `TEXT_SIZES`.
const HAND_HELD: f32 = 1.1;

/// As on a first visit: in the browser's language, light or dark as the system wishes.
pub fn first_settings() -> Settings {
    let languages = window().map(|window| window.navigator().languages());
    let languages: Vec<String> = languages
        .into_iter()
        .flat_map(|languages| {
            languages
                .iter()
                .filter_map(|it| it.as_string())
                .collect::<Vec<_>>()
        })
        .collect();
    Settings {
        theme: if is_so("(prefers-color-scheme: dark)") {
            ThemeKind::Dark
        } else {
            ThemeKind::Light
        },
        text: if is_so("(pointer: coarse) and (max-width: 560px)") {
            HAND_HELD
        } else {
            1.0
        },
        ..Settings::for_locales(languages.iter().map(String::as_str))
    }
}
