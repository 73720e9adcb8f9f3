//! What is written can be read: no text is too small, no name is cut or covers another.

use super::*;

/// Text of less than twelve points. Of a formula its letters count, not what is lowered; a quotient's halves are a little smaller than they. What is
/// written in pixels may be smaller where nobody sits in a last row.
pub(super) fn too_small(bench: &mut Bench, theme: ThemeKind) -> Vec<String> {
    let is_small = |(text, pts): &(String, f32)| {
        let is_of_pixel = text.chars().count() < 4;
        let least = match theme {
            ThemeKind::Light if is_of_pixel => 9.5,
            _ if text.contains('/') => 11.0,
            _ => 12.0,
        };
        *pts < least
    };
    let small = bench.sizes().into_iter().filter(is_small);
    small
        .map(|(text, pts)| format!("{text:?} is {pts}"))
        .collect()
}

fn elided(bench: &mut Bench) -> Vec<String> {
    let mut found = Vec::new();
    for clipped in &bench.run(Vec::new(), Vec::new()).shapes {
        each_galley(&clipped.shape, &mut |galley, _| {
            found.extend(galley.elided.then(|| galley.text().to_owned()));
        });
    }
    found
}

#[test]
fn names_of_fields_of_methods_and_of_lessons_are_whole_where_there_is_room() {
    let mut bench = Bench::seen(Lang::Es, ThemeKind::Light, vec2(1024.0, 768.0));
    // The methods with the longest names beside each other; then the fields of the camera.
    for step in [[30, 4], [30, 5], [18, 1]] {
        bench.command(Command::Open(step));
        bench.command(Command::Section(Some("camera")));
        assert_eq!(elided(&mut bench), Vec::<String>::new(), "{step:?}");
    }
    bench.command(Command::Course);
    let lesson = bench.app.bookmark.lesson().expect("it is open");
    let lesson = lesson.title(Lang::Es).to_owned();
    assert!(lesson.chars().count() > 16);
    let cut = elided(&mut bench);
    assert!(!cut.iter().any(|text| text.contains(&lesson)), "{cut:?}");
}

/// The far plane's handle is beside the second object.
#[test]
fn the_name_of_a_handle_covers_no_other_name() {
    for lang in Lang::ALL {
        let mut bench = Bench::seen(lang, ThemeKind::Light, SIZE);
        bench.command(Command::Open([18, 0]));
        let name = Catalog::of(lang).term("handle-far");
        let texts = bench.texts();
        let plate = texts.iter().find(|(text, _)| *text == name);
        let (_, plate) = plate.unwrap_or_else(|| panic!("no {name}: {texts:?}"));
        for (text, rect) in texts.iter().filter(|(text, _)| *text != name) {
            assert!(!rect.intersects(*plate), "{lang}: {name} and {text}");
        }
    }
}
