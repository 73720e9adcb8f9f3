//! Text of its own size: kept, and nothing out of reach where it is largest.

use super::*;

#[test]
fn keys_and_menu_change_it_and_it_is_kept() {
    let mut bench = Bench::course(SIZE);
    let text = |bench: &Bench| bench.app.settings().text;
    bench.press(Key::Plus, ctrl());
    bench.press(Key::Equals, ctrl());
    assert_eq!(text(&bench), 1.25);
    assert_eq!(restarted(&bench.app).settings().text, 1.25);
    bench.press(Key::Num0, ctrl());
    bench.press(Key::Minus, ctrl());
    assert_eq!(text(&bench), 0.9);
    bench.settle();
    bench.open_menus(&["Theme", "Text size", "110 %"]);
    assert_eq!(text(&bench), 1.1);
    assert_eq!(bench.ctx.zoom_factor(), 1.0);
}

#[test]
fn at_its_largest_everything_is_in_reach() {
    let screen = Rect::from_min_size(Pos2::ZERO, SIZE);
    for theme in [ThemeKind::Light, ThemeKind::Projector] {
        for lang in Lang::ALL {
            let mut bench = Bench::seen(lang, theme, SIZE);
            bench.command(Command::TextSize(2.0));
            let said = |key: &str| Catalog::of(lang).term(key);
            let is_method = |(name, _): &(String, Rect)| name.starts_with(&said("panel-algorithm"));
            let method = bench.named().into_iter().find(is_method);
            let (_, method) = method.expect("the method's menu");
            assert!(screen.contains_rect(method), "{theme} {lang}: {method}");
            for key in [
                "menu-more",
                "panel-course",
                "panel-inspector",
                "transport-play",
                "transport-last",
            ] {
                let rect = bench.found(&said(key));
                assert!(
                    screen.contains_rect(rect),
                    "{theme} {lang}: {key} at {rect}"
                );
            }
            bench.click_on(&said("menu-more"));
            for key in ["panel-scene", "settings-theme", "action-present"] {
                let rect = bench.found(&said(key));
                assert!(
                    screen.contains_rect(rect),
                    "{theme} {lang}: {key} at {rect}"
                );
            }
        }
    }
}
