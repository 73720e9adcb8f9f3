//! What is drawn, in windows of every size, and when.

use super::*;
use crate::labs::lines::LinesChange;

#[test]
fn an_idle_app_asks_for_no_repaint() {
    let mut drawing = Bench::polygons();
    drawing.key(Key::D);
    drawing.click_at([0.5, 0.5]);
    drawing.frame(10.0, Vec::new());
    let others: [fn() -> Bench; 3] = [|| Bench::new(SIZE), || Bench::course(SIZE), Bench::polygons];
    let others = others.into_iter().map(|make| make());
    for mut bench in others.chain([drawing]) {
        bench.frame(10.0, Vec::new());
        let wait_secs = bench.wait_secs;
        assert!(wait_secs > 1e6, "asks for a repaint in {wait_secs} s");
    }
}

#[test]
fn every_size_language_and_theme_is_drawn() {
    let keys = [
        Key::F6,
        Key::F7,
        Key::F7,
        Key::F5,
        Key::PageDown,
        Key::F5,
        Key::F1,
    ];
    let others = [[320.0, 240.0], [3840.0, 2160.0], [240.0, 900.0]];
    for size in others.map(Vec2::from).into_iter().chain([SIZE]) {
        for lang in Lang::ALL {
            for theme in ThemeKind::ALL {
                let mut bench = Bench::seen(lang, theme, size);
                for key in keys {
                    bench.key(key);
                    let n_shapes = bench.frame(0.3, Vec::new());
                    assert!(n_shapes > 0, "{size} {lang} {theme} {key:?}");
                }
            }
        }
    }
}

#[test]
fn two_methods_stand_side_by_side_and_step_together() {
    let mut bench = Bench::new(SIZE);
    bench.apply(Command::Edit(Edit::Compare(Some("liang-barsky")), None));
    bench.key(Key::End);
    assert_eq!(bench.app.playback.frames.len(), 2);
    assert_eq!(bench.app.stage.canvas_ids.len(), 2);
    let ends = bench.app.playback.costs();
    let are_at_their_ends = ends.iter().all(|[now, end]| now == end);
    assert!(are_at_their_ends, "both are");
}

#[test]
fn a_hundred_thousand_segments_are_drawn() {
    let mut bench = Bench::new(SIZE);
    let (count, seed) = (100_000, 1);
    bench.edit(Edit::own(LinesChange::Random { count, seed }));
    assert!(bench.frame(0.1, Vec::new()) > 0);
    bench.key(Key::End);
    bench.undo();
    assert_eq!(bench.document().size(), 1);
}
