//! Where things stand at the steps of the course: nothing moves, and all of it is there.

use std::collections::{BTreeMap, BTreeSet};

use super::{legible::too_small, *};
use crate::figure::{Body, CodeLinks, Need, Stand, View, ViewId};

/// Inside the inspector's margins, between the bar at the top and the transport.
const INSPECTOR: Vec2 = vec2(264.0, 600.0);

/// Opens each step of the course in turn.
fn each_step_of(mut bench: Bench, mut what: impl FnMut(&mut Bench, &str)) {
    let lessons = bench.app.bookmark.course.lessons.iter();
    let lessons: Vec<usize> = lessons.map(|lesson| lesson.steps.len()).collect();
    for (lesson, n_steps) in lessons.into_iter().enumerate() {
        for step in 0..n_steps {
            bench.command(Command::Open([lesson, step]));
            let page = bench.app.bookmark.page().expect("a step is open");
            what(&mut bench, &format!("{page:?}"));
        }
    }
}

fn each_step_in_english(what: impl FnMut(&mut Bench, &str)) {
    each_step_of(Bench::course(SIZE), what);
}

fn said_in_english(key: &str) -> String {
    Catalog::of(Lang::En).term(key)
}

/// As many steps of a run, or a few more, from its first to its last: a newcomer waits for this test.
fn some_steps(n_steps: usize, n_looked_at: usize) -> impl Iterator<Item = usize> {
    let stride = n_steps.div_ceil(n_looked_at).max(1);
    (0..n_steps).step_by(stride).chain([n_steps])
}

/// The height of what the inspector holds, in a panel as wide as it stands.
fn height_of_inspector(bench: &mut Bench, ui: &mut Ui) -> f32 {
    let room = Rect::from_min_size(ui.max_rect().min, vec2(INSPECTOR.x, 10_000.0));
    let mut stage = std::mem::take(&mut bench.app.stage);
    let mut panels = std::mem::take(&mut bench.app.kit.panels);
    bench.app.shown.size = SIZE;
    bench.app.shown.measures = bench.app.measures();
    let inner = UiBuilder::new().max_rect(room);
    let shown = ui.scope_builder(inner, |ui| {
        inspector::content(&bench.app, ui, &mut stage, (&mut panels, INSPECTOR.y));
    });
    (bench.app.stage, bench.app.kit.panels) = (stage, panels);
    shown.response.rect.height()
}

/// By how much the inspector is too high, with either kind of code.
fn too_high(bench: &mut Bench) -> Vec<String> {
    let ctx = bench.ctx.clone();
    let (code, size) = (bench.app.shown.code, bench.app.shown.size);
    let mut found = Vec::new();
    for code in [CodeView::Full, CodeView::Words] {
        bench.app.shown.code = code;
        let mut height = 0.0;
        // What stands below the rows is measured first.
        for _ in 0..2 {
            let mut output = ctx.run_ui(RawInput::default(), |ui| {
                height = height_of_inspector(bench, ui);
            });
            drop(output.textures_delta.set.drain());
        }
        if height > INSPECTOR.y {
            found.push(format!("with {code:?} the inspector has {height}"));
        }
    }
    (bench.app.shown.code, bench.app.shown.size) = (code, size);
    found
}

/// Left of what stands in the inspector, in a window of this size.
const INSPECTOR_LEFT: f32 = 1280.0 - 290.0;

/// What is written in the inspector, and where: in the order of drawing, without the scrolled.
fn written_in_inspector(bench: &mut Bench) -> Vec<(String, Rect)> {
    let mut texts = bench.texts();
    texts.retain(|(_, rect)| rect.left() > INSPECTOR_LEFT && rect.top() > 50.0);
    texts
}

fn place_of(written: &[(String, Rect)], text: &str) -> Option<Rect> {
    let found = written.iter().find(|(known, _)| known == text);
    found.map(|&(_, rect)| rect)
}

#[test]
fn nothing_in_the_inspector_moves_from_one_step_of_a_run_to_the_next() {
    each_step_in_english(|bench, place| {
        let headings = ["panel-watch", "cost-title", "cost-divisions", "cost-sums"];
        let mut known: BTreeMap<&str, Rect> = BTreeMap::new();
        for step in some_steps(bench.n_steps(), 5) {
            bench.app.seek(step);
            // What stands below the rows is measured first.
            bench.frame(0.1, Vec::new());
            let written = written_in_inspector(bench);
            for heading in headings {
                if let Some(rect) = place_of(&written, &said_in_english(heading)) {
                    let first = *known.entry(heading).or_insert(rect);
                    assert_eq!(rect, first, "{place}, step {step}: {heading}");
                }
            }
        }
        assert!(
            known.contains_key("cost-title"),
            "{place}: the cost is there"
        );
    });
}

#[test]
fn of_two_methods_the_one_that_is_clicked_is_inspected() {
    let mut bench = Bench::course(SIZE);
    bench.apply(Command::Edit(Edit::Compare(Some("liang-barsky")), None));
    bench.app.shown.code = CodeView::Full;
    bench.settle();
    let methods = bench.document().methods();
    let first_line = |i: usize| said_in_english(methods[i].code[0].code);
    let is_written = |bench: &mut Bench, text: &str| {
        let written = written_in_inspector(bench);
        assert!(!written.is_empty());
        place_of(&written, text).is_some()
    };
    assert!(is_written(&mut bench, &first_line(0)));
    bench.key(Key::End);
    bench.settle();
    for [step, n_steps] in bench.app.playback.steps() {
        assert_eq!(step, n_steps, "both are at their ends");
        let step = format!("step {step} of {n_steps}");
        assert!(is_written(&mut bench, &step), "{step}");
    }
    // Empty ground of the second drawing.
    let (_, slot) = bench.app.stage.places[bench.app.playback.frames[0].views.len()];
    bench.tap(rect_of(slot).min + vec2(8.0, 8.0));
    bench.settle();
    assert!(is_written(&mut bench, &first_line(1)));
    assert!(!is_written(&mut bench, &first_line(0)));
}

#[test]
fn of_three_methods_each_is_inspected_and_tells_why_it_shows_a_pixel() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("43-three-ways-one-picture", "no-order");
    bench.key(Key::End);
    bench.settle();
    let pixel = Link::nth(crate::figure::Raster::LINK, 3 * 16 + 5);
    for (column, part) in [
        (0, "shows face 1 of object A"),
        (1, "shows face 1 of object A"),
        (2, "shows nothing"),
    ] {
        // Three columns with equally many views.
        let places = &bench.app.stage.places;
        let (_, slot) = places[column * places.len() / 3];
        bench.tap(rect_of(slot).min + vec2(8.0, 60.0));
        bench.settle();
        assert_eq!(bench.app.stage.inspected, column);
        bench.command(Command::Ask(Some((pixel, column))));
        let texts = bench.texts();
        assert!(
            texts.iter().any(|(text, _)| text.contains(part)),
            "{column}: {texts:?}"
        );
    }
}

#[test]
fn every_line_of_the_pseudocode_lights_what_it_is_about_and_is_lit_by_it() {
    let [mut n_current, mut n_others] = [0; 2];
    each_step_in_english(|bench, place| {
        let links = CodeLinks::of(bench.app.playback.main());
        let now = bench.app.position();
        let frame = &bench.app.playback.frames[0];
        let (current, focus) = (frame.code_line, frame.focus().next());
        let code = bench.document().methods()[0].code;
        bench.app.shown.code = CodeView::Full;
        bench.settle();
        let written = written_in_inspector(bench);
        for (i, line) in code.iter().enumerate() {
            let text = said_in_english(line.code);
            let rect = place_of(&written, &text);
            let is_current = current == Some(i);
            let link = if is_current {
                focus
            } else {
                links.of_line(i, now)
            };
            let is_in_sight = rect.is_some() || !is_current || link.is_none();
            assert!(is_in_sight, "{place}: {text} is not in {written:?}");
            if let (Some(link), Some(rect)) = (link, rect) {
                bench.point(rect.center());
                assert_eq!(bench.app.stage.lit, Some(link), "{place}: {text}");
                let is_lit = is_current || links.lines(link).contains(&i);
                assert!(is_lit, "{place}: and back");
                n_current += usize::from(is_current);
                n_others += usize::from(!is_current);
            }
        }
    });
    assert!(n_current > 20 && n_others > 60, "{n_current}, {n_others}");
}

/// Every step keeps to the room that its run has asked for. The layout asks nothing else of a step, so those are drawn that
/// want another room than any before, or say a longer sentence.
#[test]
fn nothing_on_the_stage_moves_from_one_step_of_a_run_to_the_next() {
    each_step_in_english(|bench, place| {
        let first = bench.app.stage.places.clone();
        let n_steps = bench.n_steps();
        let (mut drawn, mut longest) = (Vec::new(), 0);
        for step in some_steps(n_steps, 120) {
            bench.app.seek(step);
            let bounds = bench.app.stage.bounds();
            bench.app.playback.prepare(bounds, None);
            let frames = bench.app.playback.on_stage().iter();
            let said = |frame: &Frame| caption_text(Catalog::of(Lang::En), &frame.caption);
            let length = frames.clone().map(|frame| said(frame).len()).max();
            let length = length.unwrap_or(0);
            let seen = |view: &&View| view.id != ViewId::ASKED;
            let wanted =
                frames.map(|frame| frame.views.iter().filter(seen).map(View::need).collect());
            let wanted: Vec<Vec<Need>> = wanted.collect();
            for (wanted, needs) in wanted.iter().zip(&bench.app.playback.needs) {
                for need in wanted {
                    let room = needs.iter().find(|room| room.id == need.id);
                    let room = room.unwrap_or_else(|| panic!("{place}, step {step}: {need:?}"));
                    let fits = (0..2).all(|i| {
                        need.least[i] <= room.least[i] && need.natural[i] <= room.natural[i]
                    });
                    assert!(fits, "{place}, step {step}: {need:?} in {room:?}");
                }
            }
            if length > longest || step == n_steps || !drawn.contains(&wanted) {
                bench.frame(0.1, Vec::new());
                assert_eq!(bench.app.stage.places, first, "{place}, step {step}");
                longest = longest.max(length);
                drawn.push(wanted);
            }
        }
    });
}

/// What has no room in a window of a lecture hall, its panels at both sides: comparisons have the least.
fn lost(bench: &Bench) -> Option<String> {
    let wanted = bench.app.playback.needs.iter().flatten();
    let wanted: Vec<_> = wanted.map(|need| need.id).collect();
    let places = &bench.app.stage.places;
    (places.len() < wanted.len()).then(|| format!("of {wanted:?} only {places:?}"))
}

/// Each language and theme, and the smallest projector.
const WINDOWS: [(Lang, ThemeKind, Vec2); 7] = [
    (Lang::En, ThemeKind::Light, SIZE),
    (Lang::Es, ThemeKind::Light, SIZE),
    (Lang::ZhCn, ThemeKind::Light, SIZE),
    (Lang::En, ThemeKind::Projector, SIZE),
    (Lang::PtBr, ThemeKind::Projector, SIZE),
    (Lang::En, ThemeKind::Light, vec2(1024.0, 768.0)),
    (Lang::En, ThemeKind::Projector, vec2(1024.0, 768.0)),
];

/// One walk for all that is asked of each step: a newcomer waits for it.
#[test]
fn no_step_of_the_course_loses_a_view_has_small_text_or_an_inspector_that_scrolls() {
    let mut wrong = Vec::new();
    for (lang, theme, size) in WINDOWS {
        each_step_of(Bench::seen(lang, theme, size), |bench, place| {
            let mut found = too_small(bench, theme);
            found.extend(lost(bench).filter(|_| size == SIZE));
            if theme == ThemeKind::Light && size == SIZE && lang != Lang::ZhCn {
                found.extend(too_high(bench));
            }
            let found = found.into_iter();
            wrong.extend(found.map(|it| format!("{lang} {theme} {size} {place}: {it}")));
        });
    }
    assert!(wrong.is_empty(), "{} steps: {wrong:#?}", wrong.len());
}

/// At 1280 × 720, beside the course and the inspector.
#[test]
fn what_is_measured_beside_a_drawing_is_whole() {
    let mut bench = Bench::course(vec2(1280.0, 720.0));
    bench.command(Command::Open([6, 1]));
    let written = bench.written();
    let measured = written.iter().find(|(text, ..)| text == "n·D = 10");
    let (_, rect, clip) = measured.unwrap_or_else(|| panic!("it is in {written:?}"));
    assert!(clip.contains_rect(*rect), "{rect:?} in {clip:?}");
}

#[test]
fn long_names_in_the_watch_table_stand_clear_of_each_other() {
    let mut bench = Bench::seen(Lang::Es, ThemeKind::Light, vec2(1024.0, 768.0));
    bench.command(Command::Open([30, 0]));
    let written = bench.texts();
    let names = ["un solo polígono", "triángulo a triángulo"];
    let [first, second] = names.map(|name| place_of(&written, name).expect("it is there"));
    assert!(first.bottom() <= second.top() + 2.0, "{first:?} {second:?}");
}

#[test]
fn what_is_pointed_at_in_a_view_lights_up_on_the_stage() {
    let mut lit = BTreeSet::new();
    let mut bench = Bench::course(SIZE);
    let lessons = bench.app.bookmark.course.lessons.iter();
    let n_steps: Vec<usize> = lessons.map(|lesson| lesson.steps.len()).collect();
    for (lesson, _) in n_steps.into_iter().enumerate().filter(|(_, n)| *n > 2) {
        bench.command(Command::Open([lesson, 2]));
        if bench.app.playback.frames.len() > 1 {
            continue;
        }
        for (id, slot) in bench.app.stage.places.clone().into_iter().skip(1) {
            let rect = rect_of(slot);
            for nth in 0..40 {
                let part = vec2((nth % 2) as f32 / 2.0 + 0.1, (nth / 2) as f32 / 20.0);
                bench.point(rect.min + part * rect.size());
                let Some(link) = bench.app.stage.lit else {
                    continue;
                };
                lit.insert(id.0);
                let frame = &bench.app.playback.frames[0];
                let mut marks = bench.document().backdrop(0, false);
                marks.extend(frame.marks().iter().cloned());
                let mut links: Vec<Option<Link>> = marks.iter().map(|mark| mark.link).collect();
                if let Body::Space(space) = &frame.views[0].body {
                    links.extend(space.marks.iter().map(|mark| mark.link));
                    links.extend(space.facets.iter().map(|facet| facet.link));
                }
                let is_there = links.contains(&Some(link));
                // A side of the window or of the volume is drawn on its own only when its turn comes.
                let sides = ["left", "right", "bottom", "top"].map(Link::from);
                let is_side = sides.contains(&link) || (0..6).any(|i| link == Link::nth("side", i));
                // A row of a matrix is about its sum, which stands beside it; a pixel about itself.
                let is_itself = ["matrix", "raster", "raster-before"].contains(&id.0);
                assert!(is_there || is_side || is_itself, "{lesson} {id:?} {link:?}");
            }
        }
    }
    for kind in ["codes", "crossings", "edges", "lists", "ring"] {
        assert!(lit.contains(kind), "{kind} is not in {lit:?}");
    }
}

#[test]
fn where_only_the_cameras_picture_differs_it_is_as_large_as_a_drawing() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open([30, 4]));
    let stands = |bench: &Bench| {
        let stand = |needs: &Vec<Need>| {
            let mut drawings = needs.iter().filter(|need| need.is_drawing());
            drawings.all(|need| need.stand == Stand::Drawing)
        };
        bench
            .app
            .playback
            .needs
            .iter()
            .map(stand)
            .collect::<Vec<_>>()
    };
    assert_eq!(stands(&bench), [true, true]);
    // Of one method it stands on the drawing.
    bench.command(Command::Open([30, 2]));
    assert_eq!(stands(&bench), [false]);
}

/// Until a hunt is solved its costs are not shown: no room waits for them.
#[test]
fn the_drawing_of_a_hunt_has_all_of_the_stage_until_it_is_solved() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("09-four-rules", "hunt-quad");
    bench.settle();
    let [(ViewId::PLANE, alone)] = bench.app.stage.places[..] else {
        panic!("{:?}", bench.app.stage.places);
    };
    assert!(alone.size()[0] > 0.9 * (SIZE.x - 512.0));
}
