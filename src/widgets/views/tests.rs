//! The views of the prototypes C1 to C4, drawn: nothing overlaps, what is folded is counted.
//!
//! `CLIPSCOPE_SAMPLES=/tmp cargo test --lib -- widgets::views` also leaves the pictures there.

pub mod data;

use super::{body_of, prelude::*};
use crate::{
    figure::{Body, Pixel, Raster, Run, Tiles, View, notation},
    lesson::{Course, Lesson, LessonStep},
    paint::{Headless, ThemeKind, crosses},
    text::{Catalog, Lang, Notation},
};

fn look() -> Look<'static> {
    Look::new(
        Headless::new(ThemeKind::Light).theme(),
        Catalog::of(Lang::En),
    )
}

/// Draws a view in a room of this size; what is wrong with it.
fn drawn(
    table: &mut Headless,
    name: &str,
    catalog: &Catalog,
    room: Vec2,
    view: &dyn OnSlate,
) -> Option<String> {
    let (theme, lang) = (table.theme(), catalog.lang());
    let look = Look::new(theme, catalog);
    let rect = Rect::from_min_size(pos2(16.0, 16.0), room);
    let mut found = None;
    let image = table.draw(room + vec2(32.0, 32.0), 4.0 / 3.0, |ui| {
        let mut slate = view.slate(Slate::new(ui.painter(), look), room);
        view.draw(&mut slate, rect, &mut Links::default());
        found = fault(&slate, rect.expand(1.0));
    });
    if let Ok(folder) = std::env::var("CLIPSCOPE_SAMPLES") {
        let (kind, Vec2 { x, y }) = (look.theme.kind, room);
        let path = format!("{folder}/view-{name}-{kind}-{lang}-{x}x{y}.png");
        std::fs::write(path, image.to_png()).expect("a folder that can be written");
    }
    found
}

/// Text that covers another, is struck by a line, or stands out of the room.
fn fault(slate: &Slate<'_>, room: Rect) -> Option<String> {
    for (i, text) in slate.texts.iter().enumerate() {
        if !room.contains_rect(*text) {
            return Some(format!("{text:?} leaves {room:?}"));
        }
        for other in &slate.texts[..i] {
            // Of a line a tenth is room above and below its letters.
            let both = text.intersect(*other);
            if both.width() > 0.5 && both.height() > 0.1 * text.height() {
                return Some(format!("{text:?} covers {other:?}"));
            }
        }
        // Boxes of text have white space at their top and bottom.
        let core = text.shrink2(vec2(0.5, 0.15 * text.height()));
        if let Some(stroke) = slate.strokes.iter().find(|&&stroke| crosses(stroke, core)) {
            return Some(format!("{stroke:?} strikes {text:?}"));
        }
    }
    slate.texts.is_empty().then(|| "nothing is said".to_owned())
}

fn check(name: &str, rooms: &[Vec2], view: &dyn OnSlate) {
    for kind in ThemeKind::ALL {
        let mut table = Headless::new(kind);
        for lang in Lang::ALL {
            for &room in rooms {
                // On a projector text does not shrink below what is read from the last row.
                let is_far = kind == ThemeKind::Projector;
                let room = if is_far { 1.5 * room } else { room };
                let what = format!("{name}, {kind}, {lang}, {room:?}");
                let fault = drawn(&mut table, name, Catalog::of(lang), room, view);
                assert_eq!(fault, None, "{what}");
            }
        }
    }
}

const ROOMS: [Vec2; 2] = [vec2(400.0, 360.0), vec2(300.0, 260.0)];

#[test]
fn values_are_read() {
    check("c1", &ROOMS, &data::and_of_codes());
    check("c1-codes", &ROOMS, &data::codes_found());
    check("c2-table", &ROOMS, &data::empty_interval());
    check("table-200", &ROOMS, &data::many_edges(200, 77));
    check("c4", &ROOMS, &data::normal());
    check("c4-parallel", &ROOMS, &data::parallel());
    check("a1-distances", &ROOMS, &data::frustum::distances());
    check("a6-products", &ROOMS, &data::frustum::products());
}

#[test]
fn lists_are_linked_and_say_how_much_they_fold_and_pipelines_are_whole() {
    check("c3", &ROOMS, &data::polygons::two_lists());
    check("lists-in-out", &ROOMS, &data::polygons::in_and_out());
    check("lists-40", &ROOMS, &data::polygons::long_lists());
    let rooms = [vec2(900.0, 100.0), vec2(560.0, 120.0), vec2(420.0, 120.0)];
    check("clippers", &rooms, &data::polygons::pipeline());
}

#[test]
fn an_empty_interval_is_crossed_over() {
    let rooms = [vec2(430.0, 100.0), vec2(620.0, 140.0)];
    check("c2-axis", &rooms, &data::axis([0.375, 0.25], 1));
    check("c2-axis-open", &rooms, &data::axis([0.375, 0.75], 1));
    check("c2-axis-start", &rooms, &data::axis([0.0, 1.0], 2));
    check("c2-axis-close", &rooms, &data::axis([0.5, 0.53], 0));
    check("c2-axis-touch", &rooms, &data::axis([0.5, 0.5], 0));
    check("c2-axis-late", &rooms, &data::axis([1.5, 1.0], 0));
}

#[test]
fn an_interval_that_is_empty_for_another_reason_is_not_said_to_be_crossed_over() {
    let said = |bounds: [f64; 2]| {
        let mut line = data::axis(bounds, 0);
        line.empty = true;
        line.spoken(look())
    };
    assert!(said([0.375, 0.25]).contains("u_min > u_max"));
    assert!(!said([0.0, 1.0]).contains('>'));
    assert!(said([0.0, 1.0]).contains("nothing is left"));
}

#[test]
fn what_each_gate_and_each_plane_took_and_left_is_said() {
    let rooms = [vec2(744.0, 84.0), vec2(1100.0, 110.0)];
    let narrows = [322, 156, 151, 163, 85];
    check("a1-ribbon", &rooms, &data::frustum::ribbon(narrows));
    let widens = [150, 150, 0, 340, 339];
    check("ribbon-widens", &rooms, &data::frustum::ribbon(widens));
    let rooms = [vec2(744.0, 130.0), vec2(1100.0, 160.0)];
    for current in [None, Some(0), Some(5)] {
        check("a4-small", &rooms, &data::frustum::small_drawings(current));
    }
}

#[test]
fn of_many_triangles_and_a_large_tree_what_is_about_the_step_is_seen() {
    let rooms = [vec2(520.0, 220.0), vec2(300.0, 200.0)];
    check("graph-9", &rooms, &data::surfaces::many(9));
    check("graph-60", &rooms, &data::surfaces::many(60));
    let rooms = [vec2(520.0, 220.0), vec2(300.0, 150.0)];
    check("tree-7", &rooms, &data::surfaces::tree(7, 2));
    check("tree-200", &rooms, &data::surfaces::tree(200, 130));
}

#[test]
fn a_cycle_is_named_and_a_story_shows_what_won_and_what_lost() {
    let rooms = [vec2(520.0, 180.0), vec2(300.0, 150.0)];
    check("b2-cycle", &rooms, &data::surfaces::cycle());
    let said = data::surfaces::cycle().spoken(look());
    assert!(said.contains("A → B (4.31 > 3.47)"), "{said}");
    assert!(said.contains("C → A") && said.ends_with("cycle"), "{said}");
    let rooms = [vec2(560.0, 220.0), vec2(300.0, 190.0)];
    for now in [0, 2, 4] {
        check("b4", &rooms, &data::surfaces::story_of_five(now));
    }
    check("story-17", &rooms, &data::surfaces::long_story(17, 11));
    let said = data::surfaces::story_of_five(2).spoken(look());
    assert!(said.contains("→ A3: 0.624 > 0.563, lost"), "{said}");
    assert!(
        said.contains("2 more"),
        "what is to come is counted: {said}"
    );
}

fn room_on_a_page(view: &View) -> Vec2 {
    match &view.body {
        Body::NumberLine(_) | Body::Clippers(_) | Body::Ribbon(_) => vec2(540.0, 112.0),
        Body::Multiples(it) if it.tiles == Tiles::Strip => vec2(860.0, 112.0),
        Body::Graph(_) | Body::Story(_) => vec2(400.0, 170.0),
        Body::Spaces(_) => vec2(864.0, 134.0),
        _ => vec2(390.0, 380.0),
    }
}

fn each_run(mut check: impl FnMut(&Lesson, &LessonStep, &dyn Run)) {
    for lesson in &Course::embedded().lessons {
        for step in lesson.steps.iter().filter(|step| step.figure.is_some()) {
            for run in step.scene.document().record() {
                check(lesson, step, &*run);
            }
        }
    }
}

#[test]
fn nothing_overlaps_in_the_figures_of_the_course() {
    let mut table = Headless::new(ThemeKind::Light);
    let mut faults = Vec::new();
    each_run(|lesson, step, run| {
        let frame = run.frame(step.position().unwrap_or(run.n_steps()).min(run.n_steps()));
        let catalog = Catalog::of(Lang::En).alike(notation(Notation::Own, [&frame]));
        for view in &frame.views {
            let Some(body) = body_of(view) else { continue };
            let name = format!("{}-{}-{}", lesson.id, step.id, view.id.0);
            let room = room_on_a_page(view);
            let fault = drawn(&mut table, &name, catalog, room, body);
            faults.extend(fault.map(|fault| format!("{name}: {fault}")));
        }
    });
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn a_raster_whose_numbers_have_no_room_is_not_titled_with_their_unit() {
    let pixel = Pixel {
        value: Some(Value::Count(742)),
        ..Pixel::EMPTY
    };
    let raster = Raster {
        title: Value::Term("raster-depth"),
        bare: Some(Value::Term("raster-depth-bare")),
        size: [16, 12],
        pixels: vec![pixel; 16 * 12],
        scale: None,
        under: Vec::new(),
        current: None,
        over: Vec::new(),
    };
    let mut table = Headless::new(ThemeKind::Light);
    let mut texts = |room: Vec2| {
        let mut texts = Vec::new();
        table.draw(room, 1.0, |ui| {
            let mut slate = raster.slate(Slate::new(ui.painter(), look()), room);
            let rect = Rect::from_min_size(Pos2::ZERO, room);
            raster.draw(&mut slate, rect, &mut Links::default());
            texts.clone_from(&slate.texts);
        });
        texts
    };
    let [large, small] = [vec2(640.0, 520.0), vec2(100.0, 110.0)].map(&mut texts);
    assert_eq!([large.len(), small.len()], [1 + 16 * 12, 1]);
    assert!(small[0].width() < large[0].width(), "{small:?} {large:?}");
}
