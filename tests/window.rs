//! Pixel snapshots of the whole window: a telling step of each lab in each theme, in the lecture hall and in Chinese.
//!
//! `target/windows/` holds what differs; `CLIPSCOPE_BLESS=1 cargo test --test all window::` accepts it.

use clipscope::{
    app::{App, Page, Places, Settings},
    lesson::Course,
    paint::{Headless, ThemeKind},
    text::Lang,
};
use egui::vec2;

use crate::shared::pictures::Pictures;

/// A lesson's figure of each lab, by lesson and name.
const FIGURES: [[&str; 2]; 3] = [
    ["03-outcodes", "outcode-reject"],
    ["14-both-lists", "walk-switch"],
    ["22-whole-objects-first", "sphere-culled"],
];

#[test]
fn the_window_is_as_accepted() {
    let course = Course::embedded();
    let mut pictures = Pictures::of("windows");
    for theme in ThemeKind::ALL {
        let mut table = Headless::new(theme);
        for figure in FIGURES {
            pictures.check(
                &format!("{}-{theme}.png", figure[1]),
                &window(&course, &mut table, figure, theme, Lang::En),
            );
        }
        if theme == ThemeKind::Light {
            pictures.check(
                &format!("{}-zh-CN.png", FIGURES[0][1]),
                &window(&course, &mut table, FIGURES[0], theme, Lang::ZhCn),
            );
        }
    }
    pictures.finish();
}

/// The window at the moment of a figure.
fn window(
    course: &Course,
    table: &mut Headless,
    [lesson, figure]: [&str; 2],
    theme: ThemeKind,
    lang: Lang,
) -> Vec<u8> {
    let steps = &course.lesson(lesson).unwrap().steps;
    let step = steps
        .iter()
        .find(|step| step.figure.as_deref() == Some(figure))
        .unwrap();
    let settings = Settings {
        lang,
        theme,
        places: Places {
            page: Some(Page::Step(lesson.to_owned(), step.id.clone())),
            ..Places::default()
        },
        asks: false,
        ..Settings::default()
    };
    let mut app = App::new(course.clone(), settings);
    app.seek(step.position().unwrap());
    let image = table.draw(vec2(1280.0, 720.0), 1.0, |ui| app.ui(ui));
    image.to_png()
}
