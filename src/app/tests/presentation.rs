//! The presentation: what it shows, and that all is as before when it is over.

use super::*;
use crate::lesson::Block;

fn dark() -> Bench {
    Bench::seen(Lang::En, ThemeKind::Dark, SIZE)
}

#[test]
fn it_fills_the_screen_and_leaves_it_as_it_was() {
    let mut bench = dark();
    let before = bench.app.settings();
    let theme = |bench: &Bench| bench.app.look().theme.kind;
    let asked = bench.key(Key::F5);
    assert!(asked.contains(&ViewportCommand::Fullscreen(true)));
    bench.apply(Command::Projector);
    assert_eq!(theme(&bench), ThemeKind::Projector);
    // What is remembered does not know of the lecture hall, should the window be closed in it.
    assert_eq!(bench.app.settings(), before);
    bench.apply(Command::Projector);
    assert_eq!(theme(&bench), ThemeKind::Dark);
    bench.apply(Command::Projector);
    let asked = bench.key(Key::F5);
    assert!(asked.contains(&ViewportCommand::Fullscreen(false)));
    assert_eq!(theme(&bench), ThemeKind::Dark);
    assert_eq!(bench.app.settings(), before);
}

#[test]
fn the_timeline_can_be_pressed_in_every_language_on_a_small_projector() {
    for lang in Lang::ALL {
        let mut bench = Bench::seen(lang, ThemeKind::Projector, vec2(1024.0, 768.0));
        bench.command(Command::Open([18, 0]));
        bench.key(Key::F5);
        let name = Catalog::of(lang).term("panel-timeline");
        let timeline = bench.found(&name);
        assert!(timeline.width() > 300.0, "{lang}: {timeline:?}");
        bench.press_at(timeline.center());
        let middle = bench.n_steps() / 2;
        assert!(bench.app.position().abs_diff(middle) <= 1, "{lang}");
    }
}

#[test]
fn escape_leaves_it_whatever_else_is_on_screen() {
    for (key, modifiers) in [
        (Key::Questionmark, Modifiers::NONE),
        (Key::S, ctrl()),
        (Key::M, ctrl()),
        (Key::Tab, Modifiers::NONE),
    ] {
        let mut bench = dark();
        bench.key(Key::F5);
        bench.press(key, modifiers);
        bench.settle();
        let asked = bench.key(Key::Escape);
        assert!(asked.contains(&ViewportCommand::Fullscreen(false)));
        assert!(bench.app.shown.presenting.is_none(), "{key:?}");
        assert_eq!(bench.app.shown.dialog, None);
    }
}

#[test]
fn a_pointer_that_rests_is_hidden_and_the_app_sleeps() {
    let mut bench = dark();
    bench.key(Key::F5);
    bench.frame(0.1, vec![Event::PointerMoved(pos2(900.0, 500.0))]);
    assert_ne!(bench.cursor, CursorIcon::None);
    for _ in 0..10 {
        if bench.wait_secs > 1e6 {
            break;
        }
        assert!(bench.wait_secs <= 3.0);
        bench.frame(bench.wait_secs.max(0.01), Vec::new());
    }
    bench.frame(3.0, Vec::new());
    assert_eq!(bench.cursor, CursorIcon::None);
    assert!(bench.wait_secs > 1e6, "wakes in {} s", bench.wait_secs);
    bench.frame(0.1, vec![Event::PointerMoved(pos2(910.0, 500.0))]);
    assert_ne!(bench.cursor, CursorIcon::None);
}

/// A clicker has two keys: in a scene of one's own they walk through its run.
#[test]
fn a_clicker_stays_in_the_free_scene_that_is_presented() {
    let mut bench = Bench::course(SIZE);
    bench.key(Key::F8);
    bench.command(Command::FIRST);
    let page = bench.app.bookmark.page();
    bench.key(Key::F5);
    bench.key(Key::PageDown);
    assert_eq!(
        (bench.app.bookmark.page(), bench.app.position()),
        (page.clone(), 1)
    );
    bench.key(Key::PageUp);
    assert_eq!((bench.app.bookmark.page(), bench.app.position()), (page, 0));
}

#[test]
fn a_presented_step_says_its_number_and_its_question_and_then_the_answer() {
    let mut bench = Bench::course(SIZE);
    let asks = (0..8).find(|&step| {
        bench.command(Command::Open([2, step]));
        bench.app.has_answer()
    });
    let step = asks.expect("a step of the lesson asks");
    bench.key(Key::F5);
    bench.settle();
    let number = format!("3.{}", step + 1);
    let has =
        |bench: &mut Bench, part: &str| bench.texts().iter().any(|(text, _)| text.contains(part));
    assert!(has(&mut bench, &number), "{:?}", bench.texts());
    assert!(has(&mut bench, "?"), "the question");
    let before = bench.texts().len();
    bench.key(Key::PageDown);
    bench.settle();
    assert!(bench.app.shown.is_answered && bench.texts().len() > before);
    bench.key(Key::PageDown);
    assert_ne!(bench.app.bookmark.at, [2, step]);
}

#[test]
fn a_presented_answer_is_read_from_its_first_word_to_its_last() {
    let size = vec2(1024.0, 768.0);
    let mut bench = Bench::seen(Lang::Es, ThemeKind::Projector, size);
    bench.key(Key::F5);
    let mut n_answers = 0;
    for (lesson, step) in [
        (8, 5),
        (8, 7),
        (9, 3),
        (9, 5),
        (10, 3),
        (10, 6),
        (12, 2),
        (12, 4),
        (30, 4),
        (39, 2),
    ] {
        bench.command(Command::Open([lesson, step]));
        if !bench.app.has_answer() {
            continue;
        }
        n_answers += 1;
        bench.command(Command::Answer(true));
        let below = |clip: &Rect| clip.top() > 0.5 * size.y;
        let is_cut = |(_, rect, clip): &(String, Rect, Rect)| {
            below(clip) && !clip.contains_rect(rect.shrink(1.0))
        };
        let cut: Vec<_> = bench.written().into_iter().filter(is_cut).collect();
        assert!(cut.is_empty(), "{lesson} {step}: {cut:?}");
    }
    assert!(n_answers > 5);
}

#[test]
fn what_a_presented_question_asks_for_is_put_beside_the_stage() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::Open([33, 0]));
    bench.key(Key::F5);
    bench.settle();
    let rows = Catalog::of(Lang::En).term("raster-rows");
    let is_there = |bench: &mut Bench| bench.named().iter().any(|(name, _)| *name == rows);
    assert!(!is_there(&mut bench));
    let mut named = bench.named().into_iter();
    let link = named.find(|(name, _)| name.ends_with(" rows"));
    bench.press_at(link.expect("a link").1.center());
    assert!(is_there(&mut bench) && bench.app.is_presenting());
    bench.key(Key::F5);
    bench.key(Key::F5);
    bench.settle();
    assert!(!is_there(&mut bench), "another presentation");
}

#[test]
fn a_presenter_draws_while_b_is_held_and_the_next_step_is_clean() {
    let mut bench = Bench::course(SIZE);
    bench.command(Command::FIRST);
    bench.key(Key::F5);
    let drawn = |bench: &Bench| bench.app.stage.pen.n_points();
    let draw = |bench: &mut Bench| {
        bench.frame(0.05, vec![key_event(Key::B, true, Modifiers::NONE)]);
        for x in [300.0, 340.0, 380.0] {
            bench.frame(0.05, vec![Event::PointerMoved(pos2(x, 300.0))]);
        }
        bench.frame(0.05, vec![key_event(Key::B, false, Modifiers::NONE)]);
    };
    draw(&mut bench);
    draw(&mut bench);
    assert_eq!(drawn(&bench).len(), 2);
    assert!(drawn(&bench).iter().all(|&n| n >= 3), "{:?}", drawn(&bench));
    bench.key(Key::ArrowRight);
    assert_eq!((bench.app.position(), drawn(&bench)), (1, Vec::new()));
}

#[test]
fn the_pen_drags_nothing_where_the_button_is_held_too() {
    let mut bench = Bench::course(SIZE);
    bench.key(Key::F5);
    let scene = bench.app.scene().clone();
    let from = bench
        .app
        .on_screen([0.0, 0.0])
        .expect("a frame has been drawn");
    bench.frame(0.05, vec![key_event(Key::B, true, Modifiers::NONE)]);
    bench.frame(0.05, vec![Event::PointerMoved(from)]);
    bench.button(from, true);
    for by in [20.0, 40.0, 60.0] {
        let at = from + vec2(by, 0.5 * by);
        bench.frame(0.05, vec![Event::PointerMoved(at)]);
    }
    bench.button(from + vec2(60.0, 30.0), false);
    bench.frame(0.05, vec![key_event(Key::B, false, Modifiers::NONE)]);
    assert!(bench.app.stage.pen.n_points()[0] >= 4);
    assert_eq!(
        bench.app.on_screen([0.0, 0.0]),
        Some(from),
        "the plot stays"
    );
    assert!(bench.app.scene() == &scene);
}

/// In a window of a projector, from the smallest on.
#[test]
fn the_methods_name_stands_whole_in_the_bar_or_is_cut_but_read_and_every_menu_is_there() {
    for (lang, size) in Lang::ALL.into_iter().flat_map(|lang| {
        let sizes = [vec2(1024.0, 768.0), vec2(1280.0, 720.0)];
        sizes.map(|size| (lang, size))
    }) {
        let mut bench = Bench::seen(lang, ThemeKind::Projector, size);
        bench.ctx.enable_accesskit();
        for at in [[1, 1], [8, 1], [20, 1], [33, 1]] {
            bench.command(Command::Open(at));
            for _ in 0..2 {
                let name = Catalog::of(lang).term(bench.document().methods()[0].name_key);
                let begins: String = name.chars().take(4).collect();
                let texts = bench.texts();
                let in_bar = |(text, rect): &&(String, Rect)| {
                    rect.bottom() < 52.0 && text.starts_with(&begins)
                };
                assert!(
                    texts.iter().any(|it| in_bar(&it)),
                    "{lang:?} {size}: {name}"
                );
                let names = crate::app::menus::names(&bench.app);
                let is_there = |name: &String| bench.names.iter().any(|(it, _)| it == name);
                let more = Catalog::of(lang).term("menu-more");
                assert!(names.iter().all(is_there) || is_there(&more), "{lang:?}");
                // And once more with the course unfolded.
                bench.command(Command::Course);
            }
        }
    }
}

#[test]
fn where_the_course_is_folded_a_button_shows_the_question_and_the_page_key_its_answer() {
    let mut bench = Bench::seen(Lang::En, ThemeKind::Projector, SIZE);
    let asks = (0..8).find(|&step| {
        bench.command(Command::Open([2, step]));
        bench.app.has_answer()
    });
    let step = asks.expect("a step of the lesson asks");
    bench.click_on("What is asked");
    bench.settle();
    bench.found("Show the answer");
    bench.key(Key::PageDown);
    assert!(bench.app.shown.is_answered);
    bench.key(Key::PageDown);
    assert_ne!(bench.app.bookmark.at, [2, step]);
}

fn has(bench: &mut Bench, part: &str) -> bool {
    bench.texts().iter().any(|(text, _)| text.contains(part))
}

/// A test has one window: there the second one lies in the first.
#[test]
fn the_speaker_reads_notes_that_nobody_else_sees() {
    let mut bench = Bench::course(vec2(1920.0, 1080.0));
    let lesson = &bench.app.bookmark.course.lessons[0];
    let text = lesson.step_text(0, Lang::En).expect("its text");
    let [Block::Note(note)] = &text.note[..] else {
        panic!("one note, not {:?}", text.note);
    };
    let (note, next) = (note[0].text.clone(), lesson.step_title(1, Lang::En));
    let next = next.expect("another step").to_owned();
    assert!(!has(&mut bench, &note) && !has(&mut bench, "!>"));
    bench.key(Key::F5);
    assert!(!has(&mut bench, &note));
    bench.key(Key::N);
    bench.settle();
    assert!(has(&mut bench, &note) && has(&mut bench, &next));
    bench.key(Key::N);
    bench.settle();
    assert!(!has(&mut bench, &note));
    bench.key(Key::N);
    bench.key(Key::Escape);
    bench.settle();
    assert!(!bench.app.is_presenting() && !has(&mut bench, &note));
}

#[test]
fn the_speakers_clock_is_drawn_once_a_minute() {
    let mut bench = Bench::course(vec2(1920.0, 1080.0));
    bench.key(Key::F5);
    bench.key(Key::N);
    bench.frame(5.0, Vec::new());
    for _ in 0..5 {
        bench.frame(bench.wait_secs.min(1.0), Vec::new());
    }
    assert!(
        (50.0..=61.0).contains(&bench.wait_secs),
        "{}",
        bench.wait_secs
    );
    assert!(has(&mut bench, "0:00"));
    bench.frame(bench.wait_secs, Vec::new());
    assert!(has(&mut bench, "0:01"));
    bench.key(Key::N);
    bench.frame(5.0, Vec::new());
    bench.frame(5.0, Vec::new());
    assert!(bench.wait_secs > 1e6, "wakes in {} s", bench.wait_secs);
}

#[test]
fn embedded_in_a_page_it_stays_what_it_is_and_leads_to_all_of_it() {
    struct Page;
    impl Platform for Page {
        fn address(&self) -> Option<String> {
            Some("https://here.edu/clipscope/".to_owned())
        }
    }
    let app = App::new(Course::embedded(), Settings::default()).with_platform(Page);
    let mut bench = Bench::with(app.embedded(), SIZE);
    let lesson = bench.app.bookmark.lesson().map(|lesson| lesson.id.clone());
    bench.key(Key::Escape);
    assert!(bench.app.is_presenting(), "there is nothing to leave");
    bench.app.push(Command::OpenWhole);
    let output = bench.run(Vec::new(), Vec::new());
    let opened = output
        .platform_output
        .commands
        .iter()
        .find_map(|it| match it {
            egui::OutputCommand::OpenUrl(url) => Some(url.url.clone()),
            _ => None,
        });
    let opened = opened.expect("a page is opened");
    let place = opened.strip_prefix("https://here.edu/clipscope/#");
    assert_eq!(
        place.and_then(|it| it.split_once('/')).map(|it| it.0),
        lesson.as_deref()
    );
}
