//! The window without a window: input goes in, frames come out.

mod asking;
mod course;
mod crowds;
mod depth;
mod files;
mod frames;
mod frustum_menu;
mod hands;
mod keys;
mod labs;
mod menus;
mod meshes;
mod pages;
mod places;
mod polygons;
mod presentation;
mod third_lab;
mod verdicts;

use egui::{
    Context, Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, Vec2, ViewportId, pos2,
    vec2,
};

use crate::{lesson::Course, paint::fonts};

use super::{App, Settings};

const SIZE: Vec2 = vec2(1280.0, 720.0);
/// The drawing has room for a grid of halves, beside what the algorithm holds.
const ROOMY: Vec2 = vec2(1600.0, 900.0);

/// An app on a bare context, with a clock of its own.
struct Bench {
    ctx: Context,
    app: App,
    size: Vec2,
    time: f64,
    /// Seconds until the app wants to be drawn again, after the last frame.
    wait_secs: f64,
    /// What the last frame wanted of the pointer and of the window.
    cursor: egui::CursorIcon,
    asked_of_window: Vec<egui::ViewportCommand>,
    /// What a screen reader would hear of it, and where that lies.
    names: Vec<(String, Rect)>,
}

impl Bench {
    fn new(size: Vec2) -> Self {
        Self::with(App::new(Course::default(), Settings::default()), size)
    }

    fn with(app: App, size: Vec2) -> Self {
        let ctx = Context::default();
        ctx.set_fonts(fonts::definitions());
        let mut bench = Self {
            ctx,
            app,
            size,
            time: 0.0,
            wait_secs: 0.0,
            cursor: egui::CursorIcon::Default,
            asked_of_window: Vec::new(),
            names: Vec::new(),
        };
        bench.settle();
        bench
    }

    /// One frame with these events; `secs` after the last one.
    fn frame(&mut self, secs: f64, events: Vec<Event>) -> usize {
        self.frame_with(secs, events, Vec::new())
    }

    fn frame_with(
        &mut self,
        secs: f64,
        events: Vec<Event>,
        dropped_files: Vec<egui::DroppedFileHandle>,
    ) -> usize {
        self.time += secs;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            time: Some(self.time),
            events,
            dropped_files,
            ..RawInput::default()
        };
        let mut output = self.ctx.run_ui(input, |ui| self.app.ui(ui));
        output.textures_delta.clear();
        let viewport = &output.viewport_output[&ViewportId::ROOT];
        self.wait_secs = viewport.repaint_delay.as_secs_f64();
        if let Some(update) = &output.platform_output.accesskit_update {
            self.names = update.nodes.iter().filter_map(named).collect();
        }
        self.cursor = output.platform_output.cursor_icon;
        self.asked_of_window.clone_from(&viewport.commands);
        self.ctx.tessellate(output.shapes, 1.0).len()
    }

    /// All that is written in the window and is not cut, and where.
    fn texts(&mut self) -> Vec<(String, Rect)> {
        // What is scrolled out of sight is not written.
        let all = self.written().into_iter();
        all.filter(|(_, rect, clip)| clip.contains_rect(*rect))
            .map(|(text, rect, _)| (text, rect))
            .collect()
    }

    /// Where a text stands, and what of the window it may be seen in.
    fn clipped(&mut self, text: &str) -> (Rect, Rect) {
        let found = self.written().into_iter().find(|(known, ..)| known == text);
        let (_, rect, clip) = found.unwrap_or_else(|| panic!("{text} is not written"));
        (rect, clip)
    }

    /// All that is written: each text, where, and within what it is cut.
    fn written(&mut self) -> Vec<(String, Rect, Rect)> {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            time: Some(self.time),
            ..RawInput::default()
        };
        let mut output = self.ctx.run_ui(input, |ui| self.app.ui(ui));
        output.textures_delta.clear();
        let mut all = Vec::new();
        for clipped in &output.shapes {
            let mut texts = Vec::new();
            written(&clipped.shape, &mut texts);
            let clip = clipped.clip_rect;
            all.extend(texts.into_iter().map(|(text, rect)| (text, rect, clip)));
        }
        all
    }

    /// Frames without input, until nothing moves any more.
    fn settle(&mut self) {
        for _ in 0..60 {
            self.frame(0.1, Vec::new());
            if self.wait_secs > 0.0 {
                return;
            }
        }
    }

    fn press(&mut self, key: Key, modifiers: Modifiers) {
        let event = |pressed| Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers,
        };
        self.frame(0.05, vec![event(true)]);
        self.frame(0.05, vec![event(false)]);
    }

    fn key(&mut self, key: Key) {
        self.press(key, Modifiers::NONE);
    }

    /// Where a world point lies on the (first) stage.
    fn on_screen(&self, world: [f64; 2]) -> Pos2 {
        self.app.on_screen(world).expect("a frame has been drawn")
    }

    fn button(&mut self, at: Pos2, pressed: bool) {
        let button = Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        };
        self.frame(0.02, vec![Event::PointerMoved(at), button]);
    }

    fn drag(&mut self, from: Pos2, to: Pos2) {
        self.frame(0.02, vec![Event::PointerMoved(from)]);
        self.button(from, true);
        for i in 1..=8 {
            let at = from + (to - from) * (i as f32 / 8.0);
            self.frame(0.02, vec![Event::PointerMoved(at)]);
        }
        self.button(to, false);
        self.frame(0.02, vec![Event::PointerMoved(pos2(5.0, 5.0))]);
    }
}

/// The texts of a shape, each as it is read.
fn written(shape: &egui::Shape, texts: &mut Vec<(String, Rect)>) {
    match shape {
        egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| written(shape, texts)),
        egui::Shape::Text(text) => {
            let rect = text.galley.rect.translate(text.pos.to_vec2());
            texts.push((text.galley.text().to_owned(), rect));
        }
        _ => {}
    }
}

fn named((_, node): &(egui::accesskit::NodeId, egui::accesskit::Node)) -> Option<(String, Rect)> {
    let name = node.label().or(node.value())?.to_owned();
    let bounds = node.bounds()?;
    let rect = [bounds.x0, bounds.y0, bounds.x1, bounds.y1].map(|side| side as f32);
    let [x0, y0, x1, y1] = rect;
    Some((name, Rect::from_min_max(pos2(x0, y0), pos2(x1, y1))))
}

fn ctrl() -> Modifiers {
    Modifiers::CTRL | Modifiers::COMMAND
}
