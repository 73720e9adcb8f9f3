//! The window without a window: input goes in, frames come out.

mod asked_on_stage;
mod asking;
mod composing;
mod course;
mod crowds;
mod depth;
mod dragged;
mod files;
mod frames;
mod free_scenes;
mod frustum_menu;
mod goals;
mod hands;
mod held;
mod held_ends;
mod hints;
mod keys;
mod labs;
mod legible;
mod links;
mod menus;
mod meshes;
mod pages;
mod phone;
mod places;
mod polygons;
mod practice;
mod presentation;
mod recording;
mod text_size;
mod third_lab;
mod verdicts;

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use egui::{Event, PointerButton, RawInput, Vec2, ViewportCommand, ViewportId};

use super::*;
use crate::{
    figure::Frame,
    labs::{Document, lines, space},
    paint::fonts,
    text::Catalog,
    widgets::rect_of,
};

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
    cursor: CursorIcon,
    asked_of_window: Vec<ViewportCommand>,
    /// What a screen reader would hear of it, and where that lies.
    names: Vec<(String, Rect)>,
}

impl Bench {
    /// Without a course.
    fn new(size: Vec2) -> Self {
        Self::with(App::new(Course::default(), Settings::default()), size)
    }

    /// The same, where there are files.
    fn on_a_desktop() -> Self {
        let app = App::new(Course::default(), Settings::default());
        Self::with(app.with_platform(Desktop::default()), SIZE)
    }

    /// On this lab's first scene.
    fn lab(id: &'static str) -> Self {
        let mut bench = Self::new(SIZE);
        bench.command(Command::Lab(id));
        bench
    }

    fn course(size: Vec2) -> Self {
        Self::seen(Lang::En, ThemeKind::Light, size)
    }

    fn open_step(&mut self, lesson: &str, step: &str) {
        let page = Page::Step(lesson.to_owned(), step.to_owned());
        self.command(Command::OpenPage(page));
    }

    /// The course in this language and theme.
    fn seen(lang: Lang, theme: ThemeKind, size: Vec2) -> Self {
        let settings = Settings {
            lang,
            theme,
            // What lessons ask has tests of its own.
            asks: false,
            ..Settings::default()
        };
        Self::with(App::new(Course::embedded(), settings), size)
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
            cursor: CursorIcon::Default,
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
        let output = self.run(events, dropped_files);
        let viewport = &output.viewport_output[&ViewportId::ROOT];
        self.wait_secs = viewport.repaint_delay.as_secs_f64();
        if let Some(update) = &output.platform_output.accesskit_update {
            self.names = update.nodes.iter().filter_map(named).collect();
        }
        self.cursor = output.platform_output.cursor_icon;
        self.asked_of_window.clone_from(&viewport.commands);
        self.ctx.tessellate(output.shapes, 1.0).len()
    }

    fn run(
        &mut self,
        events: Vec<Event>,
        dropped_files: Vec<egui::DroppedFileHandle>,
    ) -> egui::FullOutput {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, self.size)),
            time: Some(self.time),
            events,
            dropped_files,
            ..RawInput::default()
        };
        let mut output = self.ctx.run_ui(input, |ui| self.app.ui(ui));
        output.textures_delta.clear();
        output
    }

    /// All that is written in the window and is not cut, and where.
    fn texts(&mut self) -> Vec<(String, Rect)> {
        // What is scrolled out of sight is not written.
        let all = self.written().into_iter();
        all.filter(|(_, rect, clip)| clip.contains_rect(*rect))
            .map(|(text, rect, _)| (text, rect))
            .collect()
    }

    /// All that is written: each text, where, and within what it is cut.
    fn written(&mut self) -> Vec<(String, Rect, Rect)> {
        let mut all = Vec::new();
        for clipped in &self.run(Vec::new(), Vec::new()).shapes {
            each_galley(&clipped.shape, &mut |galley, at| {
                let rect = galley.rect.translate(at.to_vec2());
                all.push((galley.text().to_owned(), rect, clipped.clip_rect));
            });
        }
        all
    }

    /// The size of the largest letters of each text, whether or not it is cut.
    fn sizes(&mut self) -> Vec<(String, f32)> {
        let output = self.run(Vec::new(), Vec::new());
        let mut galleys = Vec::new();
        for clipped in &output.shapes {
            each_galley(&clipped.shape, &mut |galley, _| {
                galleys.push(galley.clone());
            });
        }
        let largest = |galley: &Arc<egui::Galley>| {
            let sections = galley.job.sections.iter();
            let sizes = sections.map(|section| section.format.font_id.size);
            (galley.text().to_owned(), sizes.fold(0.0, f32::max))
        };
        let texts = galleys.iter().map(largest);
        texts.filter(|(text, _)| !text.is_empty()).collect()
    }

    /// Frames without input, until nothing moves any more.
    fn settle(&mut self) {
        self.frame(0.0, Vec::new());
        while self.app.is_recording() {
            std::thread::sleep(std::time::Duration::from_millis(2));
            self.frame(0.0, Vec::new());
        }
        for _ in 0..60 {
            self.frame(0.1, Vec::new());
            if self.wait_secs > 0.0 {
                return;
            }
        }
    }

    fn apply(&mut self, command: Command) {
        self.app.apply(&self.ctx.clone(), command);
    }

    fn command(&mut self, command: Command) {
        self.apply(command);
        self.settle();
    }

    fn edit(&mut self, edit: Edit) {
        self.command(Command::Edit(edit, None));
    }

    /// Presses a key and lets it go; what its press asked of the window.
    fn press(&mut self, key: Key, modifiers: Modifiers) -> Vec<ViewportCommand> {
        self.frame(0.05, vec![key_event(key, true, modifiers)]);
        let asked = self.asked_of_window.clone();
        self.frame(0.05, vec![key_event(key, false, modifiers)]);
        asked
    }

    fn key(&mut self, key: Key) -> Vec<ViewportCommand> {
        self.press(key, Modifiers::NONE)
    }

    fn undo(&mut self) {
        self.press(Key::Z, ctrl());
    }

    /// A scene that reaches the open step's goal.
    fn solution(&self) -> Scene {
        let goal = self.app.bookmark.step().and_then(|step| step.goal.as_ref());
        (*goal.expect("the step has a goal").reached).clone()
    }

    fn document(&self) -> &dyn Document {
        self.app.scene().document()
    }

    /// The scene of the lab that is open.
    fn scene<D: Document>(&self) -> &D {
        self.app.scene().get().expect("of the open lab")
    }

    fn space(&self) -> &space::Scene {
        self.scene()
    }

    fn n_steps(&self) -> usize {
        self.app.playback.transport.n_steps()
    }

    /// The event of the step that is shown.
    fn event(&self) -> serde_json::Value {
        let run = self.app.playback.main();
        run.event_json(self.app.position())["event"].clone()
    }

    fn said(&self) -> String {
        let notices = self.app.notices.iter();
        let texts: Vec<&str> = notices.map(|notice| &*notice.text).collect();
        texts.join("\n")
    }

    fn handle_at(&self, nth: usize) -> Pos2 {
        let response = self.ctx.read_response(self.app.stage.handle_ids[nth]);
        response.expect("it is drawn").rect.center()
    }

    /// Where a world point lies on the (first) stage.
    fn on_screen(&self, world: [f64; 2]) -> Pos2 {
        self.app.on_screen(world).expect("a frame has been drawn")
    }

    fn focus(&mut self, id: Id) {
        self.ctx.memory_mut(|memory| memory.request_focus(id));
    }

    fn point(&mut self, at: Pos2) {
        self.frame(0.02, vec![Event::PointerMoved(at)]);
    }

    fn button(&mut self, at: Pos2, pressed: bool) {
        let button = button_event(at, pressed, Modifiers::NONE);
        self.frame(0.02, vec![Event::PointerMoved(at), button]);
    }

    fn tap(&mut self, at: Pos2) {
        self.button(at, true);
        self.button(at, false);
    }

    fn press_at(&mut self, at: Pos2) {
        self.frame(0.1, vec![Event::PointerMoved(at)]);
        self.tap(at);
        self.settle();
    }

    fn drag(&mut self, from: Pos2, to: Pos2) {
        self.point(from);
        self.button(from, true);
        for i in 1..=8 {
            self.point(from + (to - from) * (i as f32 / 8.0));
        }
        self.button(to, false);
        self.point(pos2(5.0, 5.0));
    }

    fn write(&mut self, text: &str) {
        self.frame(0.1, vec![Event::Text(text.to_owned())]);
    }

    fn drop_file(&mut self, path: impl Into<PathBuf>, bytes: Option<&[u8]>) {
        let file = Dropped(path.into(), bytes.map(<[u8]>::to_vec));
        self.frame_with(0.1, Vec::new(), vec![Arc::new(file)]);
    }
}

/// A file that is dropped, and what it holds where that has been read already.
#[derive(Debug)]
struct Dropped(PathBuf, Option<Vec<u8>>);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        self.1.clone().ok_or_else(|| "os error 21".to_owned())
    }
}

/// The same app after a restart.
fn restarted(app: &App) -> App {
    let stored = serde_json::to_string(&app.settings()).expect("plain data");
    let settings = serde_json::from_str(&stored).expect("as it was written");
    App::new(Course::embedded(), settings)
}

fn key_event(key: Key, pressed: bool, modifiers: Modifiers) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers,
    }
}

fn button_event(pos: Pos2, pressed: bool, modifiers: Modifiers) -> Event {
    Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers,
    }
}

fn each_galley(shape: &egui::Shape, found: &mut impl FnMut(&Arc<egui::Galley>, Pos2)) {
    match shape {
        egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| each_galley(shape, found)),
        egui::Shape::Text(text) => found(&text.galley, text.pos),
        _ => {}
    }
}

fn named((_, node): &(egui::accesskit::NodeId, egui::accesskit::Node)) -> Option<(String, Rect)> {
    let name = node.label().or(node.value())?.to_owned();
    let bounds = node.bounds()?;
    let [x0, y0, x1, y1] = [bounds.x0, bounds.y0, bounds.x1, bounds.y1].map(|side| side as f32);
    Some((name, Rect::from_min_max(pos2(x0, y0), pos2(x1, y1))))
}

fn ctrl() -> Modifiers {
    Modifiers::CTRL | Modifiers::COMMAND
}
