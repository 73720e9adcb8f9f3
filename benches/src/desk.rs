//! The app without a window: input goes in, triangles come out, and a clock stands beside.

use std::{hint::black_box, time::Instant};

use clipscope::{
    app::{App, Command, Page, Places, Settings},
    lesson::Course,
    paint::fonts,
};
use egui::{
    Context, Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, Vec2, ViewportId, pos2,
    vec2,
};

/// Points.
const SIZE: Vec2 = vec2(1280.0, 720.0);
/// What a screen gives a frame: the app's clock, not the one that measures.
const FRAME_SECS: f64 = 1.0 / 60.0;

/// An app that is drawn, as a window would, with its fonts and its theme.
pub struct Desk {
    ctx: Context,
    pub app: App,
    time: f64,
}

/// What one frame took, in seconds.
#[derive(Clone, Copy)]
pub struct Took {
    pub layout: f64,
    pub tessellation: f64,
}

impl Took {
    pub fn both(self) -> f64 {
        self.layout + self.tessellation
    }
}

impl Desk {
    /// The app on a step of the embedded course.
    pub fn at(lesson: &str, step: &str) -> Self {
        let course = Course::embedded();
        let found = course
            .lesson(lesson)
            .is_some_and(|lesson| lesson.step_index(step).is_some());
        assert!(found, "the course has no step {lesson} {step}");
        let settings = Settings {
            places: Places {
                page: Some(Page::Step(lesson.to_owned(), step.to_owned())),
                ..Places::default()
            },
            // So that a drag changes the scene in every frame.
            snap: false,
            asks: false,
            ..Settings::default()
        };
        let ctx = Context::default();
        ctx.set_fonts(fonts::definitions());
        let mut desk = Self {
            ctx,
            app: App::new(course, settings),
            time: 0.0,
        };
        desk.settle();
        desk
    }

    /// Does one thing, and lets everything come to rest.
    pub fn apply(&mut self, command: Command) {
        self.change(command);
        self.settle();
    }

    /// Does one thing: what comes of it is not drawn yet.
    pub fn change(&mut self, command: Command) {
        self.app.apply(&self.ctx, command);
    }

    /// Goes to a step of the run.
    pub fn seek(&mut self, position: usize) {
        self.app.seek(position);
    }

    /// How many steps the run has.
    pub fn n_steps(&mut self) -> usize {
        let before = self.app.position();
        self.app.seek(usize::MAX);
        let n_steps = self.app.position();
        self.app.seek(before);
        n_steps
    }

    fn settle(&mut self) {
        self.recorded();
        for _ in 0..30 {
            self.frame(Vec::new());
        }
    }

    /// Draws until a scene that takes long to record is on the stage, and comes to rest there; what each frame took.
    pub fn recorded(&mut self) -> Vec<Took> {
        let mut took = vec![self.frame(Vec::new())];
        while self.app.is_recording() {
            std::thread::sleep(std::time::Duration::from_millis(1));
            took.push(self.frame(Vec::new()));
        }
        took.extend([(); 3].map(|()| self.frame(Vec::new())));
        took
    }

    /// One frame with these events.
    pub fn frame(&mut self, events: Vec<Event>) -> Took {
        self.time += FRAME_SECS;
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, SIZE)),
            time: Some(self.time),
            events,
            ..RawInput::default()
        };
        let viewport = input.viewports.entry(ViewportId::ROOT).or_default();
        viewport.native_pixels_per_point = Some(1.0);
        let start = Instant::now();
        let mut output = self.ctx.run_ui(input, |ui| self.app.ui(ui));
        let layout = start.elapsed().as_secs_f64();
        // A window's painter would have taken them.
        output.textures_delta.clear();
        let start = Instant::now();
        black_box(self.ctx.tessellate(output.shapes, output.pixels_per_point));
        let tessellation = start.elapsed().as_secs_f64();
        Took {
            layout,
            tessellation,
        }
    }

    /// Where the first handle lies on the screen: the first end of the segment in focus, the first vertex.
    pub fn first_handle(&self) -> Pos2 {
        self.app
            .on_screen(self.first_place())
            .expect("a frame has been drawn")
    }

    /// Where it lies in the world.
    pub fn first_place(&self) -> [f64; 2] {
        let scene = self.app.scene().document();
        let first = scene.handles()[0];
        let [x, y, _] = scene.position(first).expect("a handle of the scene");
        [x, y]
    }

    /// Takes hold of what lies at `at`.
    pub fn grip(&mut self, at: Pos2) {
        self.frame(vec![Event::PointerMoved(at)]);
        self.frame(vec![button(at, true)]);
        self.frame(vec![Event::PointerMoved(at + vec2(8.0, 0.0))]);
    }

    /// Lets it go.
    pub fn let_go(&mut self, at: Pos2) {
        self.frame(vec![Event::PointerMoved(at), button(at, false)]);
        self.frame(vec![Event::PointerMoved(pos2(5.0, 5.0))]);
        self.settle();
    }
}

fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

/// A key, struck.
pub fn strike(key: Key) -> Vec<Event> {
    let event = |pressed| Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    vec![event(true), event(false)]
}
