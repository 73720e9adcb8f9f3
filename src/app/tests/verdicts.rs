//! Why? What is clicked is told, and Enter goes to the step that decided it.

use egui::{Key, Pos2};

use super::{Bench, SIZE};
use crate::app::{App, Command, Settings};
use crate::{
    labs::{Edit, space},
    lesson::Course,
    widgets::rect_of,
};

/// On this lab's first scene.
fn bench(lab: &'static str) -> Bench {
    let mut bench = Bench::with(App::new(Course::default(), Settings::default()), SIZE);
    bench.command(Command::Lab(lab));
    bench
}

impl Bench {
    /// What the inspector says under "Why?".
    fn verdict(&mut self) -> Option<String> {
        let texts = self.texts();
        let title = texts.iter().position(|(text, _)| text == "Why?")?;
        texts.get(title + 1).map(|(text, _)| text.clone())
    }

    fn click_there(&mut self, at: Pos2) {
        self.button(at, true);
        self.button(at, false);
        self.settle();
    }
}

#[test]
fn an_object_that_is_clicked_is_told_and_enter_goes_to_its_step() {
    let mut bench = bench("frustum");
    assert_eq!(bench.verdict(), None, "nothing was asked");
    bench.key(Key::Enter);
    assert_eq!(bench.app.position(), 0);
    let object = bench.app.stage.on_screen([-6.5, 0.8, 0.5]);
    bench.click_there(object.expect("it is in sight"));
    let said = bench.verdict().expect("it is told");
    assert!(said.starts_with("Object 5 is culled"), "{said}");
    bench.key(Key::Enter);
    let step = bench.app.position();
    let event = bench.app.playback.main().event_json(step);
    assert_eq!(event["event"], "sphere");
    assert_eq!(event["class"], "outside");
    bench.key(Key::Home);
    bench.click_on("Go to its step (Enter)");
    assert_eq!(bench.app.position(), step);
    bench.key(Key::Escape);
    assert_eq!(bench.verdict(), None, "nothing is asked any more");
}

#[test]
fn a_segment_that_is_clicked_is_told_by_the_method_on_stage() {
    let mut bench = bench("lines");
    for (method, event) in [
        ("brute-force", "accept"),
        ("cohen-sutherland", "or"),
        ("liang-barsky", "interval"),
        ("cyrus-beck", "interval"),
        ("nicholl-lee-nicholl", "sector"),
    ] {
        bench.command(Command::Edit(Edit::Method(method), None));
        bench.command(Command::First);
        let on_the_segment = bench.on_screen([-1.2, -0.5]);
        bench.click_there(on_the_segment);
        assert!(bench.verdict().is_some(), "{method}");
        bench.key(Key::Enter);
        let run = bench.app.playback.main();
        assert_eq!(
            run.event_json(bench.app.position())["event"],
            event,
            "{method}"
        );
    }
}

#[test]
fn a_vertex_that_is_clicked_is_selected_and_told() {
    let mut bench = bench("polygons");
    let handle = bench.app.scene().document().handles()[0];
    let [x, y, _] = bench
        .app
        .scene()
        .document()
        .position(handle)
        .expect("the first vertex");
    let vertex = bench.on_screen([x, y]);
    bench.click_there(vertex);
    assert_eq!(bench.app.stage.selected, Some(handle));
    assert!(bench.verdict().is_some());
    bench.key(Key::Enter);
    assert!(bench.app.position() > 0);
}

#[test]
fn enter_belongs_to_whoever_has_the_focus() {
    let mut bench = bench("frustum");
    let object = bench.app.stage.on_screen([-6.5, 0.8, 0.5]);
    bench.click_there(object.expect("it is in sight"));
    let handle = bench.app.stage.handle_ids[0];
    bench.ctx.memory_mut(|memory| memory.request_focus(handle));
    bench.settle();
    bench.key(Key::Enter);
    assert!(bench.app.stage.typing.is_some(), "the handle's place");
    assert_eq!(bench.app.position(), 0);
}

#[test]
fn a_part_of_a_triangle_and_of_a_segment_that_is_clicked_is_told() {
    let mut bench = bench("frustum");
    for (method, at, said, event) in [
        (
            "intersection-polygon",
            [-5.5, 0.5, 0.0],
            "corner V₀",
            "first",
        ),
        (
            "intersection-polygon",
            [1.5, 2.5, -1.5],
            "edge V₁V₂",
            "cross",
        ),
        ("liang-barsky-3d", [3.0, 2.5, -4.0], "P₂", "row"),
    ] {
        bench.command(Command::Edit(Edit::Method(method), None));
        bench.command(Command::First);
        let place = bench.app.stage.on_screen(at).expect("it is in sight");
        bench.click_there(place);
        let texts = bench.texts();
        let is_said = texts.iter().any(|(text, _)| text.contains(said));
        assert!(bench.verdict().is_some() && is_said, "{method}: {said}");
        bench.key(Key::Enter);
        let run = bench.app.playback.main();
        let there = run.event_json(bench.app.position());
        assert_eq!(there["event"], event, "{method}: {said}");
    }
}

/// The middle of a view.
fn middle_of(bench: &Bench, id: &str) -> Pos2 {
    let places = bench.app.stage.places.iter();
    let found = places.clone().find(|(known, _)| known.0 == id);
    let (_, slot) = found.unwrap_or_else(|| panic!("no {id}"));
    rect_of(*slot).center()
}

#[test]
fn in_the_cameras_picture_the_pixel_is_told() {
    let mut bench = bench("frustum");
    let at = middle_of(&bench, "camera");
    bench.press_at(at);
    let said = bench.verdict().expect("it is told");
    assert!(said.contains("ixel ["), "{said}");
}

#[test]
fn a_pixel_of_a_raster_is_looked_at_and_let_go() {
    let mut bench = bench("surfaces");
    let looked_at = |bench: &Bench| {
        let scene: Option<&space::Scene> = bench.app.scene().get();
        scene.expect("in space").raster.pixel
    };
    assert_eq!(looked_at(&bench), None);
    let all = bench.app.playback.main().n_steps();
    let at = middle_of(&bench, "raster");
    bench.press_at(at);
    assert!(looked_at(&bench).is_some());
    assert!(bench.app.playback.main().n_steps() < all, "its story alone");
    // It may stand elsewhere by now, beside the table with its story.
    let at = bench.app.stage.places.clone();
    assert!(at.iter().any(|(id, _)| id.0 == "story"));
    bench.command(Command::Undo);
    assert_eq!(looked_at(&bench), None);
}
