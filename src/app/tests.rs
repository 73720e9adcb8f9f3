//! The window without a window: input goes in, frames come out.

use std::sync::Arc;

use egui::{
    Context, Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, Vec2, ViewportId, pos2,
    vec2,
};

use crate::{
    labs::lines::{Method, Scene},
    lesson::{Course, random_segments},
    paint::{ThemeKind, fonts},
    panels::lines::LinesEdit,
    text::Lang,
    trace::Transport,
};

use super::{App, Command, Dialog, Settings};

const SIZE: Vec2 = vec2(1280.0, 720.0);

/// An app on a bare context, with a clock of its own.
struct Bench {
    ctx: Context,
    app: App,
    size: Vec2,
    time: f64,
    /// Seconds until the app wants to be drawn again, after the last frame.
    wait_secs: f64,
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
        drop(output.textures_delta.set.drain());
        let viewport = &output.viewport_output[&ViewportId::ROOT];
        self.wait_secs = viewport.repaint_delay.as_secs_f64();
        self.ctx.tessellate(output.shapes, 1.0).len()
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
        self.app
            .stage
            .seen()
            .expect("a frame has been drawn")
            .to_screen(world)
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

fn ctrl() -> Modifiers {
    Modifiers::CTRL | Modifiers::COMMAND
}

#[test]
fn the_keys_step() {
    let mut bench = Bench::new(SIZE);
    let n_steps = bench.app.playback.transport().n_steps();
    for (key, modifiers, expected) in [
        (Key::ArrowRight, Modifiers::NONE, 1),
        (Key::ArrowRight, Modifiers::NONE, 2),
        (Key::ArrowLeft, Modifiers::NONE, 1),
        (Key::ArrowRight, Modifiers::SHIFT, 11),
        (Key::ArrowLeft, Modifiers::SHIFT, 1),
        (Key::End, Modifiers::NONE, n_steps),
        (Key::Home, Modifiers::NONE, 0),
    ] {
        bench.press(key, modifiers);
        assert_eq!(
            bench.app.position(),
            expected,
            "after {key:?} with {modifiers:?}"
        );
    }
}

#[test]
fn ctrl_and_arrows_jump_to_the_next_phase() {
    let mut bench = Bench::new(SIZE);
    bench.press(Key::ArrowRight, ctrl());
    let run = bench.app.playback.main();
    assert_eq!(run.tick(bench.app.position()), crate::figure::Tick::Phase);
    bench.press(Key::ArrowLeft, ctrl());
    assert_eq!(bench.app.position(), 0);
}

#[test]
fn an_end_is_dragged_and_one_undo_takes_the_whole_drag_back() {
    let mut bench = Bench::new(SIZE);
    bench.app.apply(&bench.ctx.clone(), Command::Seek(6));
    bench.settle();
    let before = bench.app.scene().clone();
    let moment = bench.app.playback.main().moment(6);
    let p2 = before.focused().p2.to_array();
    bench.drag(bench.on_screen(p2), bench.on_screen([2.5, 1.5]));
    assert_eq!(bench.app.scene().focused().p2.to_array(), [2.5, 1.5]);
    let now = bench.app.playback.main();
    assert_eq!(
        now.moment(bench.app.position()),
        moment,
        "the cursor stays at its moment"
    );
    bench.press(Key::Z, ctrl());
    assert_eq!(bench.app.scene(), &before);
    bench.press(Key::Z, ctrl() | Modifiers::SHIFT);
    assert_eq!(bench.app.scene().focused().p2.to_array(), [2.5, 1.5]);
    assert!(!bench.app.document.can_redo());
}

#[test]
fn a_drag_keeps_to_the_grid_and_the_background_pans() {
    let mut bench = Bench::new(SIZE);
    let p1 = bench.app.scene().focused().p1.to_array();
    bench.drag(bench.on_screen(p1), bench.on_screen([-1.61, -0.72]));
    assert_eq!(bench.app.scene().focused().p1.to_array(), [-1.5, -0.5]);
    let scene = bench.app.scene().clone();
    let fixed = [2.4, -1.3];
    let from = bench.on_screen(fixed);
    bench.drag(from, from + vec2(40.0, 30.0));
    assert_eq!(bench.app.scene(), &scene, "nothing but the view moved");
    assert!((bench.on_screen(fixed) - from - vec2(40.0, 30.0)).length() < 8.0);
}

#[test]
fn a_handle_with_the_focus_takes_the_arrows_until_escape() {
    let mut bench = Bench::new(SIZE);
    let p1 = bench.app.stage.handle_ids[0];
    bench.ctx.memory_mut(|memory| memory.request_focus(p1));
    bench.frame(0.1, Vec::new());
    bench.key(Key::ArrowRight);
    bench.key(Key::ArrowUp);
    assert_eq!(bench.app.scene().focused().p1.to_array(), [-1.5, -0.5]);
    assert_eq!(bench.app.position(), 0);
    bench.press(Key::ArrowLeft, Modifiers::ALT);
    assert_eq!(bench.app.scene().focused().p1.to_array(), [-1.55, -0.5]);
    bench.key(Key::Tab);
    bench.key(Key::ArrowLeft);
    assert_eq!(
        bench.app.scene().focused().p2.to_array(),
        [1.5, 1.5],
        "Tab goes on to the next"
    );
    bench.key(Key::Escape);
    bench.key(Key::ArrowRight);
    assert_eq!(bench.app.position(), 1);
}

#[test]
fn playing_takes_its_time_and_stops_at_the_end() {
    let mut bench = Bench::new(SIZE);
    bench.key(Key::Space);
    assert!(bench.app.playback.transport().is_playing());
    bench.frame(0.05, Vec::new());
    assert!(
        bench.wait_secs > 0.0 && bench.wait_secs <= 1.0,
        "waits {} s",
        bench.wait_secs
    );
    let n_steps = bench.app.playback.transport().n_steps();
    for _ in 0..3 * n_steps {
        bench.frame(0.5, Vec::new());
    }
    assert_eq!(bench.app.position(), n_steps);
    assert!(!bench.app.playback.transport().is_playing());
}

#[test]
fn an_idle_app_asks_for_no_repaint() {
    for course in [Course::default(), Course::embedded()] {
        let mut bench = Bench::with(App::new(course, Settings::default()), SIZE);
        bench.frame(10.0, Vec::new());
        assert!(
            bench.wait_secs > 1e6,
            "asks for a repaint in {} s",
            bench.wait_secs
        );
    }
}

#[test]
fn every_size_language_and_theme_is_drawn() {
    for size in [
        vec2(320.0, 240.0),
        SIZE,
        vec2(3840.0, 2160.0),
        vec2(240.0, 900.0),
    ] {
        for lang in Lang::ALL {
            for theme in ThemeKind::ALL {
                let settings = Settings {
                    lang,
                    theme,
                    ..Settings::default()
                };
                let mut bench = Bench::with(App::new(Course::embedded(), settings), size);
                for key in [
                    Key::F6,
                    Key::F7,
                    Key::F7,
                    Key::F5,
                    Key::PageDown,
                    Key::F5,
                    Key::F1,
                ] {
                    bench.key(key);
                    assert!(
                        bench.frame(0.3, Vec::new()) > 0,
                        "{size} {lang} {theme} {key:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn two_methods_stand_side_by_side_and_step_together() {
    let mut bench = Bench::new(SIZE);
    let other = Method::by_id("liang-barsky");
    let ctx = bench.ctx.clone();
    bench
        .app
        .apply(&ctx, Command::Edit(LinesEdit::Compare(other), None));
    bench.key(Key::End);
    assert_eq!(bench.app.playback.frames().len(), 2);
    assert_eq!(bench.app.stage.canvas_ids.len(), 2);
    let ends = bench.app.playback.costs();
    assert!(
        ends.iter().all(|[now, end]| now == end),
        "both are at their ends"
    );
}

#[test]
fn a_hundred_thousand_segments_are_drawn() {
    let mut bench = Bench::new(SIZE);
    let ctx = bench.ctx.clone();
    let edit = LinesEdit::Random {
        count: 100_000,
        seed: 1,
    };
    bench.app.apply(&ctx, Command::Edit(edit, None));
    bench.settle();
    assert!(bench.frame(0.1, Vec::new()) > 0);
    bench.key(Key::End);
    bench.press(Key::Z, ctrl());
    assert_eq!(bench.app.scene().segments().len(), 1);
}

#[derive(Debug)]
struct Dropped(&'static [u8]);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        std::path::Path::new("dropped.toml")
    }
    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.0.to_vec())
    }
}

#[test]
fn garbage_that_is_dropped_is_explained_and_changes_nothing() {
    let mut bench = Bench::new(SIZE);
    let before = bench.app.scene().clone();
    for garbage in [
        &b"\xff\xfe\x00"[..],
        b"",
        b"window = [1, 0, 0, 1]",
        b"a = [[[[",
    ] {
        let bytes: &'static [u8] = Box::leak(garbage.to_vec().into_boxed_slice());
        bench.frame_with(0.1, Vec::new(), vec![Arc::new(Dropped(bytes))]);
        assert!(!bench.app.notices.is_empty(), "{garbage:?} is explained");
        assert_eq!(bench.app.scene(), &before);
        bench.key(Key::Escape);
        assert!(bench.app.notices.is_empty());
    }
}

#[test]
fn a_scene_that_is_dropped_is_opened_and_can_be_undone() {
    let mut bench = Bench::new(SIZE);
    let before = bench.app.scene().clone();
    let segments = random_segments(&before.window, 3, 7);
    let scene = Scene::new(before.method, before.window, segments).expect("three segments");
    let text = crate::lesson::scene_to_toml(&scene).into_bytes();
    let file = Dropped(Box::leak(text.into_boxed_slice()));
    bench.frame_with(0.1, Vec::new(), vec![Arc::new(file)]);
    assert_eq!(bench.app.scene(), &scene);
    bench.press(Key::Z, ctrl());
    assert_eq!(bench.app.scene(), &before);
}

#[test]
fn a_scene_is_saved_where_the_dialog_says() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let app = App::new(Course::default(), Settings::default()).with_platform(super::Desktop);
    let mut bench = Bench::with(app, SIZE);
    bench.press(Key::S, ctrl());
    assert!(matches!(bench.app.shown.dialog, Some(Dialog::Save { .. })));
    let path = folder.path().join("scene.toml").display().to_string();
    let ctx = bench.ctx.clone();
    bench.app.apply(
        &ctx,
        Command::Show(Some(Dialog::Save { path: path.clone() })),
    );
    bench.key(Key::Enter);
    bench.settle();
    assert_eq!(bench.app.shown.dialog, None);
    let bytes = std::fs::read(&path).expect("the scene was written");
    let read = crate::lesson::scene_from_toml(&path, &bytes).expect("what is saved can be opened");
    assert_eq!(&read, bench.app.scene());
}

#[test]
fn a_presenter_walks_the_course_and_comes_back() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    bench.key(Key::F5);
    let n_steps: usize = bench
        .app
        .place
        .lessons()
        .iter()
        .map(|l| l.steps.len())
        .sum();
    for _ in 0..n_steps + 2 {
        bench.key(Key::PageDown);
        let step = bench.app.place.step().expect("a step is open");
        assert_eq!(bench.app.position(), step.position);
        assert_eq!(bench.app.scene(), &*step.scene);
    }
    for _ in 0..n_steps + 2 {
        bench.key(Key::PageUp);
    }
    assert_eq!(bench.app.place.indices(), [0, 0]);
    assert!(bench.app.shown.presenting);
    bench.key(Key::Escape);
    assert!(!bench.app.shown.presenting);
}

#[test]
fn reset_brings_the_lesson_s_scene_back() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let ctx = bench.ctx.clone();
    bench.app.apply(&ctx, Command::Edit(LinesEdit::Add, None));
    bench.settle();
    assert!(!bench.app.is_untouched());
    bench.key(Key::R);
    assert!(bench.app.is_untouched());
}

#[test]
fn a_course_that_breaks_or_vanishes_leaves_the_last_good_one() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let n_lessons = bench.app.place.lessons().len();
    bench
        .app
        .take_course("lessons", crate::lesson::Loaded::default(), 0.0);
    assert_eq!(bench.app.place.lessons().len(), n_lessons);
    assert!(!bench.app.notices.is_empty());
    bench.frame(0.1, Vec::new());
}

#[test]
fn settings_come_back() {
    let mut bench = Bench::with(App::new(Course::embedded(), Settings::default()), SIZE);
    let ctx = bench.ctx.clone();
    for command in [
        Command::Lesson { forward: true },
        Command::Speed(Transport::SPEEDS[4]),
        Command::Theme(ThemeKind::Dark),
        Command::Language(Lang::Es),
    ] {
        bench.app.apply(&ctx, command);
    }
    let stored = serde_json::to_string(&bench.app.settings()).expect("plain data");
    let settings = serde_json::from_str(&stored).expect("as it was written");
    let again = App::new(Course::embedded(), settings);
    assert_eq!(again.place.indices(), bench.app.place.indices());
    assert_eq!(again.settings(), bench.app.settings());
}
