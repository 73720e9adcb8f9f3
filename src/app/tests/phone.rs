//! The window in one hand, and fingers on it.

use egui::{
    TouchDeviceId, TouchId, TouchPhase,
    accesskit::{Action, Role},
};

use super::{hands::ends, *};
use crate::{app::room::Room, widgets::TARGET};

const PHONE: Vec2 = vec2(390.0, 844.0);

fn touch(finger: u64, phase: TouchPhase, pos: Pos2) -> Event {
    Event::Touch {
        device_id: TouchDeviceId(0),
        id: TouchId(finger),
        phase,
        pos,
        force: None,
    }
}

impl Bench {
    /// As eframe tells of it in a browser: the first finger is the pointer, too.
    fn fingers_down(&mut self, at: &[Pos2]) {
        for (i, &pos) in at.iter().enumerate() {
            let down = touch(i as u64, TouchPhase::Start, pos);
            let press = button_event(at[0], true, Modifiers::NONE);
            self.frame(0.02, vec![press, down]);
        }
    }

    fn fingers_move(&mut self, to: &[Pos2]) {
        let moves = to.iter().enumerate();
        let moves = moves.map(|(i, &pos)| touch(i as u64, TouchPhase::Move, pos));
        let mut events = vec![Event::PointerMoved(to[0])];
        events.extend(moves);
        self.frame(0.02, events);
    }

    fn fingers_up(&mut self, at: &[Pos2]) {
        for (i, &pos) in at.iter().enumerate() {
            let release = button_event(at[0], false, Modifiers::NONE);
            let up = touch(i as u64, TouchPhase::End, pos);
            self.frame(0.02, vec![release, Event::PointerGone, up]);
        }
        self.settle();
    }

    fn finger_tap(&mut self, at: Pos2) {
        self.fingers_down(&[at]);
        self.fingers_up(&[at]);
    }

    fn swipe(&mut self, from: Pos2, by: Vec2) {
        self.fingers_down(&[from]);
        for i in 1..=4 {
            self.fingers_move(&[from + by * (i as f32 / 4.0)]);
        }
        self.fingers_up(&[from + by]);
    }

    /// All that can be pressed, but for words of a text, and where it is.
    fn pressable(&mut self) -> Vec<(String, Rect)> {
        self.ctx.enable_accesskit();
        self.settle();
        let output = self.run(Vec::new(), Vec::new());
        let update = output.platform_output.accesskit_update;
        let nodes = update.expect("it is enabled").nodes;
        let is_target = |node: &egui::accesskit::Node| {
            let is_whole = matches!(node.role(), Role::Link | Role::Label | Role::Canvas);
            node.supports_action(Action::Click) && !is_whole
        };
        nodes
            .iter()
            .filter(|(_, node)| is_target(node))
            .filter_map(named)
            .collect()
    }

    fn place_of(&mut self, key: &str) -> Pos2 {
        let name = self.app.look().say(key);
        let all = self.pressable();
        let found = all.iter().rfind(|(its, _)| *its == name);
        found
            .unwrap_or_else(|| panic!("{name} in {all:?}"))
            .1
            .center()
    }
}

fn phone() -> Bench {
    Bench::course(PHONE)
}

#[test]
fn stage_caption_and_transport_are_there_and_the_rest_a_tap_or_a_swipe_away() {
    let mut bench = phone();
    let drawing = rect_of(bench.app.stage.places[0].1);
    assert_eq!(drawing.width(), PHONE.x, "the stage has the whole width");
    let caption = caption_text(
        bench.app.look().catalog,
        &bench.app.playback.frames[0].caption,
    );
    let begin: String = caption.chars().take(12).collect();
    let texts = bench.texts();
    let is_written = |text: &str| texts.iter().any(|(its, _)| its.contains(text));
    assert!(is_written(&begin), "{begin} in {texts:?}");
    assert!(is_written("step "), "{texts:?}");
    let title = bench
        .app
        .bookmark
        .title(Lang::En, false)
        .expect("a step")
        .to_owned();
    assert!(is_written(&title), "the lesson peeks in");

    let sheet = pos2(200.0, PHONE.y - 160.0);
    let grip = pos2(200.0, 90.0);
    bench.finger_tap(sheet);
    assert_eq!(bench.app.room(), Room::Course);
    bench.finger_tap(grip);
    assert_eq!(bench.app.room(), Room::Stage);
    bench.swipe(sheet, vec2(5.0, -120.0));
    assert_eq!(bench.app.room(), Room::Course);
    bench.swipe(grip, vec2(5.0, 120.0));
    assert_eq!(bench.app.room(), Room::Stage);
    bench.swipe(sheet, vec2(-120.0, 5.0));
    assert_eq!(bench.app.room(), Room::Inspector);
    bench.swipe(grip, vec2(120.0, 5.0));
    assert_eq!(bench.app.room(), Room::Stage);
    for (key, room) in [
        ("panel-course", Room::Course),
        ("panel-inspector", Room::Inspector),
    ] {
        let button = bench.place_of(key);
        bench.finger_tap(pos2(button.x, 28.0));
        assert_eq!(bench.app.room(), room, "{key} at {button}");
        let button = bench.place_of(key);
        bench.finger_tap(pos2(button.x, 28.0));
        assert_eq!(bench.app.room(), Room::Stage, "{key}");
    }
}

#[test]
fn whatever_is_pressed_is_as_large_as_a_finger() {
    let mut small = Vec::new();
    for asks in [false, true] {
        let settings = Settings {
            asks,
            ..Settings::default()
        };
        let mut bench = Bench::with(App::new(Course::embedded(), settings), PHONE);
        for _ in 0..4 {
            bench.command(Command::Lesson { forward: true });
        }
        for rooms in [
            None,
            Some(Command::Course),
            Some(Command::Contents(true)),
            Some(Command::Inspector),
        ] {
            if let Some(room) = rooms {
                bench.command(room);
            }
            let room = bench.app.room();
            for (name, rect) in bench.pressable() {
                let size = rect.size() + Vec2::splat(0.5);
                if size.min_elem() < TARGET {
                    small.push(format!("{name}: {:?} in {room:?}", rect.size()));
                }
            }
        }
    }
    assert!(small.is_empty(), "{}", small.join("\n"));
}

#[test]
fn one_finger_pans_and_two_scale_what_is_between_them() {
    let mut bench = phone();
    let (fixed, by) = ([0.25, -0.125], vec2(10.0, 24.0));
    let middle = bench.on_screen(fixed);
    let width = |bench: &Bench| bench.on_screen([1.0, 0.0]).x - bench.on_screen([0.0, 0.0]).x;
    let before = (width(&bench), bench.app.scene().clone());
    let apart = |middle: Pos2, by: f32| [middle - vec2(by, 0.0), middle + vec2(by, 0.0)];
    bench.fingers_down(&apart(middle, 30.0));
    for i in 1..=6 {
        let part = i as f32 / 6.0;
        bench.fingers_move(&apart(middle + by * part, 30.0 + 30.0 * part));
    }
    bench.fingers_up(&apart(middle + by, 60.0));
    assert!(
        (width(&bench) / before.0 - 2.0).abs() < 0.05,
        "{} {}",
        width(&bench),
        before.0
    );
    let off = bench.on_screen(fixed) - middle - by;
    assert!(off.length() < 3.0, "{off}");
    assert_eq!(bench.app.scene(), &before.1, "no handle has moved");

    let rect = rect_of(bench.app.stage.places[0].1).shrink(40.0);
    let ground = [
        rect.left_top(),
        rect.right_top(),
        rect.left_bottom(),
        rect.right_bottom(),
    ];
    let handles = bench.document().handles().into_iter();
    let handles = handles.filter_map(|it| bench.document().position(it));
    let handles: Vec<Pos2> = handles.map(|[x, y, _]| bench.on_screen([x, y])).collect();
    let bare = |at: &Pos2| {
        handles
            .iter()
            .map(|it| it.distance(*at))
            .fold(f32::MAX, f32::min)
    };
    let ground = ground
        .into_iter()
        .max_by(|a, b| bare(a).total_cmp(&bare(b)));
    let ground = ground.expect("a corner");
    let seen = bench.on_screen(fixed);
    bench.swipe(ground, vec2(40.0, 30.0));
    let off = bench.on_screen(fixed) - seen - vec2(40.0, 30.0);
    assert!(off.length() < 12.0, "{off} from {ground}");
}

#[test]
fn a_second_finger_lets_go_of_what_the_first_has_dragged() {
    let mut bench = Bench::new(PHONE);
    let p1 = ends(&bench)[0];
    let from = bench.on_screen(p1) + vec2(15.0, 12.0);
    bench.fingers_down(&[from]);
    bench.fingers_move(&[from + vec2(30.0, 0.0)]);
    bench.fingers_move(&[from + vec2(60.0, 0.0)]);
    let dragged = ends(&bench)[0];
    assert_ne!(dragged, p1, "a finger beside the handle takes it");
    assert!(bench.app.is_dragging());
    let second = from + vec2(80.0, 80.0);
    let press = button_event(from, true, Modifiers::NONE);
    bench.frame(0.02, vec![press, touch(1, TouchPhase::Start, second)]);
    for i in 1..=3 {
        bench.fingers_move(&[from + vec2(60.0 + 20.0 * i as f32, 0.0), second]);
    }
    assert_eq!(ends(&bench)[0], dragged);
    assert!(!bench.app.is_dragging());
    bench.fingers_up(&[from + vec2(120.0, 0.0), second]);
    assert_eq!(ends(&bench)[0], dragged);
}

#[test]
fn a_finger_that_rests_does_what_ctrl_and_a_click_do() {
    let mut bench = Bench::polygons();
    bench.size = PHONE;
    bench.command(Command::FitView);
    let now = |bench: &Bench| bench.subject().len();
    let (n_before, ends) = (now(&bench), [0, 1].map(|i| bench.subject()[i]));
    let middle = bench.on_screen([0, 1].map(|i| 0.5 * (ends[0][i] + ends[1][i])));
    bench.finger_tap(middle);
    assert_eq!(now(&bench), n_before, "a tap puts none there");
    bench.frame(1.0, Vec::new());
    bench.fingers_down(&[middle]);
    for _ in 0..12 {
        bench.frame(0.1, Vec::new());
    }
    assert_eq!(now(&bench), n_before + 1);
    bench.fingers_up(&[middle]);
    assert_eq!(now(&bench), n_before + 1);
}

/// A system whose owner wants nothing to move, and has no mouse.
struct Still;

impl Platform for Still {
    fn has_fingers(&self) -> bool {
        true
    }

    fn wants_stillness(&self) -> bool {
        true
    }
}

#[test]
fn what_the_system_wishes_is_done_in_every_theme() {
    let app = App::new(Course::embedded(), Settings::default()).with_platform(Still);
    let mut bench = Bench::with(app, SIZE);
    for theme in [ThemeKind::Light, ThemeKind::Dark, ThemeKind::Projector] {
        bench.command(Command::Theme(theme));
        let style = bench.ctx.global_style();
        assert_eq!(style.animation_time, 0.0, "{theme}");
        assert!(style.spacing.interact_size.y >= TARGET, "{theme}");
    }
    let plain = Bench::course(SIZE);
    assert!(plain.ctx.global_style().animation_time > 0.0);
    assert!(plain.ctx.global_style().spacing.interact_size.y < TARGET);
}
