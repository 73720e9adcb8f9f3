//! A question on the picture: chips at what it might be, nothing that points at what it is, and one room for all of it.

mod glimpses;
mod hidden;

use super::*;
use crate::{
    figure::{Chip, ChipFate, Slot},
    lesson::Asks,
    paint::Placed,
};

const LABS: [&str; 4] = ["lines", "polygons", "frustum", "surfaces"];

fn practising(lab: &'static str) -> Bench {
    let mut bench = Bench::lab(lab);
    bench.ctx.enable_accesskit();
    bench.key(Key::Home);
    bench.key(Key::Q);
    bench.settle();
    assert!(bench.app.practice.is_asking(), "{lab}");
    bench
}

/// The next question; whether there is one.
fn goes_on(bench: &mut Bench) -> bool {
    let right = bench.app.practice.open().map(|asked| asked.choice.right);
    bench.command(Command::Choose(right.expect("it asks")));
    bench.command(Command::Play);
    bench.app.practice.is_asking()
}

/// What labels and chips the first drawing had.
fn placed(bench: &Bench) -> Vec<Placed> {
    let id = bench.app.stage.canvas_ids[0].with("labels");
    bench.ctx.data(|data| data.get_temp(id)).unwrap_or_default()
}

fn is_chip(placed: &Placed) -> bool {
    placed.text.starts_with('[')
}

fn each_colour(shape: &egui::Shape, found: &mut dyn FnMut(egui::Color32, Rect)) {
    use egui::{Shape, epaint::ColorMode};
    let rect = shape.visual_bounding_rect();
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| each_colour(shape, found)),
        Shape::Circle(circle) => [circle.fill, circle.stroke.color]
            .into_iter()
            .for_each(|colour| found(colour, rect)),
        Shape::LineSegment { stroke, .. } => found(stroke.color, rect),
        Shape::Path(path) => {
            found(path.fill, rect);
            if let ColorMode::Solid(colour) = path.stroke.color {
                found(colour, rect);
            }
        }
        Shape::Rect(it) => [it.fill, it.stroke.color]
            .into_iter()
            .for_each(|colour| found(colour, rect)),
        Shape::Text(text) => {
            for section in &text.galley.job.sections {
                let colour = text.override_text_color;
                let own = Some(section.format.color).filter(|it| *it != egui::Color32::PLACEHOLDER);
                found(colour.or(own).unwrap_or(text.fallback_color), rect);
            }
        }
        Shape::Mesh(mesh) => {
            for vertex in &mesh.vertices {
                found(vertex.color, rect);
            }
        }
        _ => {}
    }
}

/// Where anything is vermilion: nothing else in the light theme is nearer to red than to blue.
fn vermilion(bench: &mut Bench) -> Vec<Rect> {
    let mut found = Vec::new();
    for clipped in &bench.run(Vec::new(), Vec::new()).shapes {
        each_colour(&clipped.shape, &mut |colour, rect| {
            let rect = rect.intersect(clipped.clip_rect);
            if colour.r() > colour.b().saturating_add(8) && rect.is_positive() {
                found.push(rect);
            }
        });
    }
    found
}

#[test]
fn while_it_asks_nothing_but_the_question_and_its_chips_is_vermilion() {
    for lab in LABS {
        let mut bench = practising(lab);
        for _ in 0..10 {
            let texts = bench.texts();
            let question = Catalog::of(Lang::En).term("practice-question");
            let asked = texts.iter().find(|(text, _)| *text == question);
            let top = asked.expect("it is asked").1.top() - 16.0;
            let over: Vec<Rect> = vermilion(&mut bench);
            let chip = Chip {
                link: None,
                digit: 1,
                fate: ChipFate::Open,
            };
            let size = chip.size(bench.app.look().theme);
            let chips: Vec<Rect> = over
                .iter()
                .copied()
                .filter(|it| it.size() == size)
                .collect();
            let is_in_chip = |rect: &Rect| chips.iter().any(|chip| chip.contains_rect(*rect));
            let over = over.iter().filter(|rect| rect.top() < top);
            let over: Vec<&Rect> = over.filter(|rect| !is_in_chip(rect)).collect();
            assert!(
                over.is_empty(),
                "{lab} at {}: {over:?}",
                bench.app.position()
            );
            if !goes_on(&mut bench) {
                break;
            }
        }
        // The signal is there again at the step that was asked about.
        bench.key(Key::Escape);
        bench.key(Key::ArrowRight);
        assert!(!vermilion(&mut bench).is_empty(), "{lab}");
    }
}

#[test]
fn every_option_that_is_drawn_has_a_chip_which_covers_no_label_and_answers() {
    for lab in LABS {
        let mut bench = practising(lab);
        let (mut n_chips, mut n_linked) = (0, 0);
        for _ in 0..10 {
            let placed = placed(&bench);
            let (chips, labels): (Vec<_>, Vec<_>) = placed.iter().partition(|it| is_chip(it));
            for (i, chip) in chips.iter().enumerate() {
                let others = labels.iter().chain(&chips[..i]);
                for other in others {
                    assert!(
                        !chip.rect.intersects(other.rect),
                        "{lab}: {chip:?} {other:?}"
                    );
                }
                let nth = chip
                    .link
                    .and_then(|link| bench.app.practice.option_of(link));
                assert_eq!(
                    nth.map(|nth| format!("[{}]", nth + 1)),
                    Some(chip.text.clone())
                );
            }
            n_chips += chips.len();
            let asked = &bench.app.practice.open().expect("it asks").choice;
            n_linked += asked.links.iter().flatten().count();
            // Nothing swims.
            bench.frame(0.1, Vec::new());
            assert_eq!(self::placed(&bench), placed, "{lab}");
            if !goes_on(&mut bench) {
                break;
            }
        }
        assert!(n_chips > 0 || n_linked == 0, "{lab}: {n_linked}");
    }
}

fn sides() -> Bench {
    let page = Page::Step("04-cutting-with-outcodes".into(), "four-cuts".into());
    let mut bench = asked_at(page, Lang::En, SIZE);
    bench.settle();
    bench
}

fn asked_at(page: Page, lang: Lang, size: Vec2) -> Bench {
    let settings = Settings {
        lang,
        places: Places {
            page: Some(page),
            ..Places::default()
        },
        ..Settings::default()
    };
    let mut bench = Bench::with(App::new(Course::embedded(), settings), size);
    bench.ctx.enable_accesskit();
    bench.settle();
    bench
}

/// In the language with the longest words.
#[test]
fn all_options_are_in_sight() {
    let course = Course::embedded();
    let first = &course.lessons[0];
    let first = Page::Step(first.id.clone(), first.steps[0].id.clone());
    let mut bench = asked_at(first, Lang::Es, SIZE);
    for lesson in &course.lessons {
        let asks = |step: &&LessonStep| step.asks.is_some();
        for step in lesson.steps.iter().filter(asks) {
            bench.open_step(&lesson.id, &step.id);
            bench.settle();
            let Some(asked) = bench.app.practice.open() else {
                continue;
            };
            let said = asked.choice.said(Catalog::of(Lang::Es));
            bench.frame(0.1, Vec::new());
            let written = bench.written();
            // A subscript has no mark where it is lowered.
            let plain = |text: &str| text.replace(['_', '\n'], "");
            for option in said.iter().take(9) {
                let is_whole = |(text, at, clip): &&(String, Rect, Rect)| {
                    plain(text) == plain(option) && clip.expand(1.0).contains_rect(*at)
                };
                assert!(
                    written.iter().any(|it| is_whole(&it)),
                    "{}/{}: {option}",
                    lesson.id,
                    step.id
                );
            }
        }
    }
}

#[test]
fn a_chip_answers_and_tells_right_from_wrong() {
    let mut bench = sides();
    let chips: Vec<Placed> = placed(&bench).into_iter().filter(is_chip).collect();
    assert_eq!(chips.len(), 4, "{chips:?}");
    let right = bench.app.practice.open().expect("it asks").choice.right;
    let wrong = (right + 1) % 4;
    let chip = |nth: usize| chips.iter().find(|it| it.text == format!("[{}]", nth + 1));
    bench.press_at(chip(wrong).expect("it is there").rect.center());
    let fates: Vec<_> = bench
        .app
        .practice
        .chips()
        .iter()
        .map(|it| (it.digit - 1, it.fate))
        .collect();
    let mut expected = [(right, ChipFate::Right), (wrong, ChipFate::Wrong)];
    expected.sort_by_key(|(nth, _)| *nth);
    assert_eq!(fates, expected);
    assert_eq!(placed(&bench).into_iter().filter(is_chip).count(), 2);
    bench.key(Key::Enter);
    assert!(
        !placed(&bench).iter().any(is_chip),
        "gone with the question"
    );
}

#[test]
fn an_option_under_the_pointer_or_in_focus_is_lit_everywhere() {
    let mut bench = sides();
    let links = bench
        .app
        .practice
        .open()
        .expect("it asks")
        .choice
        .links
        .clone();
    let option = |bench: &Bench, nth: usize| {
        let name = format!("{} ", nth + 1);
        let is_it = |(name_of, _): &&(String, Rect)| name_of.starts_with(&name);
        bench
            .names
            .iter()
            .rev()
            .find(is_it)
            .expect("it is listed")
            .1
    };
    bench.frame(0.1, Vec::new());
    for nth in [0, 2] {
        let at = option(&bench, nth).center();
        bench.point(at);
        bench.frame(0.1, Vec::new());
        assert_eq!(bench.app.stage.lit, links[nth]);
    }
    bench.point(pos2(640.0, 3.0));
    // By the keyboard, too.
    let mut seen = std::collections::BTreeSet::new();
    for _ in 0..120 {
        bench.key(Key::Tab);
        bench.frame(0.1, Vec::new());
        seen.extend(
            links
                .iter()
                .position(|link| link.is_some() && *link == bench.app.stage.lit),
        );
    }
    assert_eq!(seen.len(), 4, "{seen:?}");
}

fn places(bench: &Bench) -> Vec<(ViewId, Slot)> {
    bench.app.stage.places.clone()
}

#[test]
fn escape_closes_what_lies_over_a_question_and_then_leaves_it_at_the_steps_own_moment() {
    let page = Page::Step("05-intervals".to_owned(), "entering".to_owned());
    let mut bench = asked_at(page, Lang::En, SIZE);
    let covers = [Command::Help, Command::Contents(true)];
    for command in covers.into_iter().chain([Command::Measure(true)]) {
        bench.command(command);
        assert!(bench.app.is_covered());
        bench.key(Key::Escape);
        assert!(!bench.app.is_covered() && bench.app.practice.is_asking());
    }
    // Where text is large, too, the room of a question that is put aside is the stage's.
    bench.command(Command::TextSize(1.5));
    let height = |bench: &Bench| places(bench)[0].1.size()[1];
    let asked = height(&bench);
    bench.key(Key::Escape);
    bench.settle();
    assert!(height(&bench) > asked, "{} {asked}", height(&bench));
    let home = bench.app.bookmark.step().and_then(|step| step.position());
    assert!(!bench.app.practice.is_asking());
    assert_eq!(Some(bench.app.position()), home);
}

#[test]
fn question_and_answer_leave_the_stage_as_high_and_their_room_when_they_go() {
    let course = Course::embedded();
    let all = course.lessons.iter().flat_map(|lesson| {
        let asking = lesson
            .steps
            .iter()
            .filter(|step| step.asks == Some(Asks::Decision));
        asking.map(|step| Page::Step(lesson.id.clone(), step.id.clone()))
    });
    // Of all labs some, and each kind of question.
    let pages: Vec<Page> = all.step_by(17).collect();
    assert!(pages.len() > 6);
    let windows = [SIZE, vec2(1024.0, 768.0)];
    for (i, page) in pages.iter().enumerate() {
        let (lang, size) = ([Lang::En, Lang::Es][i % 2], windows[i / 2 % 2]);
        let mut bench = asked_at(page.clone(), lang, size);
        let asked = bench.app.practice.open().map(|asked| asked.choice.clone());
        let Some(choice) = asked else { continue };
        let before = places(&bench);
        let wrong = (choice.right + 1) % choice.options.len();
        for (n, (command, is_there)) in [
            (Command::Choose(wrong), true),
            (Command::Play, false),
            (Command::Step(-1), false),
            (Command::AskAgain, true),
            (Command::ShowMe, true),
            (Command::Cancel, false),
        ]
        .into_iter()
        .enumerate()
        {
            bench.command(command);
            let what = format!("{page:?} {lang:?} {size:?} after {n}");
            if is_there {
                assert_eq!(places(&bench), before, "{what}");
            } else {
                assert!(bench.app.practice.open().is_none(), "{what}");
                // One line is left of the question, over the timeline; the other button is the lesson's.
                let again = Catalog::of(lang).term("lesson-ask-again");
                let named = bench.names.iter().filter(|(name, _)| *name == again);
                let tops: Vec<f32> = named.map(|(_, rect)| rect.top()).collect();
                let is_near = |top: &f32| size.y - top < 110.0;
                assert!(tops.iter().any(is_near), "{what}: {tops:?}");
            }
        }
    }
}

#[test]
fn while_practising_the_stage_keeps_its_height() {
    for lab in LABS {
        for (lang, size) in [(Lang::En, SIZE), (Lang::Es, vec2(1024.0, 768.0))] {
            let mut bench = Bench::new(size);
            bench.command(Command::Language(lang));
            bench.command(Command::Lab(lab));
            bench.key(Key::Home);
            bench.key(Key::Q);
            bench.settle();
            let before = places(&bench);
            for _ in 0..10 {
                assert_eq!(places(&bench), before, "{lab} {lang:?} asked");
                let wrong = bench
                    .app
                    .practice
                    .open()
                    .map(|asked| (asked.choice.right + 1) % asked.choice.options.len());
                bench.command(Command::Choose(wrong.expect("it asks")));
                assert_eq!(places(&bench), before, "{lab} {lang:?} answered");
                bench.command(Command::Play);
                if !bench.app.practice.is_asking() {
                    break;
                }
            }
        }
    }
}
