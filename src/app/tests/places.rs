//! Where things stand at the steps of the course: nothing moves, and all of it is there.

use std::collections::BTreeSet;

use egui::{Event, Rect, Ui, UiBuilder, Vec2, vec2};

use super::{Bench, SIZE};
use crate::{
    app::{App, Command, Settings, inspector},
    figure::Link,
    lesson::{CodeView, Course},
    paint::ThemeKind,
    text::Lang,
    widgets::rect_of,
};

/// Inside the inspector's margins, between the bar at the top and the transport.
const INSPECTOR: Vec2 = vec2(264.0, 600.0);

fn bench(lang: Lang, theme: ThemeKind) -> Bench {
    let settings = Settings {
        lang,
        theme,
        ..Settings::default()
    };
    Bench::with(App::new(Course::embedded(), settings), SIZE)
}

/// Opens each step of the course in turn.
fn for_each_step(bench: &mut Bench, mut what: impl FnMut(&mut Bench, &str)) {
    let ctx = bench.ctx.clone();
    let lessons = bench.app.bookmark.lessons().iter();
    let lessons: Vec<usize> = lessons.map(|lesson| lesson.steps.len()).collect();
    for (lesson, n_steps) in lessons.into_iter().enumerate() {
        for step in 0..n_steps {
            bench.app.apply(&ctx, Command::Open([lesson, step]));
            bench.settle();
            let page = bench.app.bookmark.page().expect("a step is open");
            what(bench, &format!("{page:?}"));
        }
    }
}

/// The height of what the inspector holds, in a panel as wide as it stands.
fn height_of_inspector(bench: &Bench, ui: &mut Ui) -> f32 {
    let room = Rect::from_min_size(ui.max_rect().min, vec2(INSPECTOR.x, 10_000.0));
    let model = bench.app.model(SIZE);
    let frame = &bench.app.playback.frames()[0];
    let inner = UiBuilder::new().max_rect(room);
    let shown = ui.scope_builder(inner, |ui| {
        inspector::content(&model, ui, (frame, None), INSPECTOR.y, &mut Vec::new());
    });
    shown.response.rect.height()
}

#[test]
fn the_inspector_needs_no_scrolling_at_any_step_of_the_course() {
    let mut too_high = Vec::new();
    for lang in [Lang::En, Lang::Es] {
        let mut bench = bench(lang, ThemeKind::Light);
        for_each_step(&mut bench, |bench, place| {
            let ctx = bench.ctx.clone();
            for code in [CodeView::Full, CodeView::Words] {
                bench.app.shown.code = code;
                let mut height = 0.0;
                let mut output = ctx.run_ui(egui::RawInput::default(), |ui| {
                    height = height_of_inspector(bench, ui);
                });
                drop(output.textures_delta.set.drain());
                if height > INSPECTOR.y {
                    too_high.push(format!("{lang} {place} {code:?}: {height}"));
                }
            }
        });
    }
    assert!(too_high.is_empty(), "{}", too_high.join("\n"));
}

#[test]
fn nothing_on_the_stage_moves_from_one_step_of_a_run_to_the_next() {
    let mut bench = bench(Lang::En, ThemeKind::Light);
    for_each_step(&mut bench, |bench, place| {
        let first = bench.app.stage.places.clone();
        for step in 0..=bench.app.playback.transport().n_steps() {
            bench.app.seek(step);
            bench.frame(0.1, Vec::new());
            assert_eq!(bench.app.stage.places, first, "{place}, step {step}");
            let columns = bench.app.playback.frames().iter();
            for (frame, needs) in columns.zip(bench.app.playback.needs()) {
                for view in &frame.views {
                    let need = view.need();
                    let room = needs.iter().find(|room| room.id == need.id);
                    let room = room.unwrap_or_else(|| panic!("{place}, step {step}: {need:?}"));
                    let fits = (0..2).all(|i| {
                        need.least[i] <= room.least[i] && need.natural[i] <= room.natural[i]
                    });
                    assert!(fits, "{place}, step {step}: {need:?} in {room:?}");
                }
            }
        }
    });
}

#[test]
fn what_is_pointed_at_in_a_view_lights_up_on_the_stage() {
    let mut bench = bench(Lang::En, ThemeKind::Light);
    let mut lit = BTreeSet::new();
    for_each_step(&mut bench, |bench, place| {
        let [_, step] = bench.app.bookmark.indices();
        if step != 2 || bench.app.playback.frames().len() > 1 {
            return;
        }
        for (id, slot) in bench.app.stage.places.clone().into_iter().skip(1) {
            let rect = rect_of(slot);
            for nth in 0..80 {
                let part = vec2((nth % 4) as f32 / 4.0 + 0.1, (nth / 4) as f32 / 20.0);
                let at = rect.min + part * rect.size();
                bench.frame(0.02, vec![Event::PointerMoved(at)]);
                let Some(link) = bench.app.stage.lit else {
                    continue;
                };
                lit.insert(id.0);
                let mut marks = bench.app.scene().document().backdrop(0, false);
                marks.extend(bench.app.playback.frames()[0].marks().iter().cloned());
                let is_there = marks.iter().any(|mark| mark.link == Some(link));
                // A side of the window is drawn on its own only when its turn comes.
                let is_side = ["left", "right", "bottom", "top"]
                    .map(Link::from)
                    .contains(&link);
                assert!(is_there || is_side, "{place} {id:?} {link:?}");
            }
        }
    });
    for kind in ["codes", "crossings", "edges", "lists", "ring"] {
        assert!(lit.contains(kind), "{kind} is not in {lit:?}");
    }
}
