//! The polygons lab: outlines drawn by clicking, vertices put in and taken out, presets, mistakes.

use egui::{Event, Key, Modifiers, PointerButton, Pos2};

use super::{Bench, ROOMY, SIZE, ctrl};
use crate::{
    app::{App, Command, Settings},
    labs::{
        Edit, lines,
        polygons::{LAB, OUTLINES, PRESETS, PolygonsChange, REGIONS, Scene, SceneVertex},
    },
    lesson::Course,
    text::Lang,
};

impl Bench {
    /// The polygons lab on its first scene.
    pub(super) fn polygons() -> Self {
        let mut bench = Self::new(ROOMY);
        bench.command(Command::Lab(LAB.id()));
        bench
    }

    pub(super) fn command(&mut self, command: Command) {
        let ctx = self.ctx.clone();
        self.app.apply(&ctx, command);
        self.settle();
    }

    pub(super) fn edit(&mut self, edit: PolygonsChange) {
        self.command(Command::Edit(Edit::own(edit), None));
    }

    fn polygon(&self) -> &Scene {
        self.app.scene().get().expect("the polygons lab")
    }

    pub(super) fn subject(&self) -> Vec<[f64; 2]> {
        let vertices = self.polygon().subject.vertices().iter();
        vertices.map(|p| p.to_array()).collect()
    }

    fn click(&mut self, at: Pos2, modifiers: Modifiers) {
        let moved = Event::PointerMoved(at);
        self.frame(0.5, vec![moved, Event::ModifiersChanged(modifiers)]);
        for pressed in [true, false] {
            let button = Event::PointerButton {
                pos: at,
                button: PointerButton::Primary,
                pressed,
                modifiers,
            };
            self.frame(0.02, vec![button]);
        }
        let none = Event::ModifiersChanged(Modifiers::NONE);
        self.frame(0.02, vec![none]);
    }

    fn click_at(&mut self, world: [f64; 2]) {
        self.click(self.on_screen(world), Modifiers::NONE);
    }

    fn double_click_at(&mut self, world: [f64; 2]) {
        let at = self.on_screen(world);
        self.frame(0.5, vec![Event::PointerMoved(at)]);
        for pressed in [true, false, true, false] {
            let button = Event::PointerButton {
                pos: at,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            };
            self.frame(0.02, vec![button]);
        }
        self.frame(0.02, Vec::new());
    }

    fn hint(&self) -> Option<&'static str> {
        self.app
            .stage
            .sketch
            .as_ref()
            .map(|sketch| sketch.hint().key)
    }
}

const TRIANGLE: [[f64; 2]; 3] = [[-1.5, -1.0], [1.0, -1.0], [0.0, 1.5]];

#[test]
fn a_polygon_is_drawn_by_clicking_and_enter_closes_it() {
    let mut bench = Bench::polygons();
    let before = bench.app.scene().clone();
    bench.key(Key::D);
    assert_eq!(bench.hint(), Some("draw-subject"));
    for at in TRIANGLE {
        bench.click_at([at[0] + 0.03, at[1] - 0.04]);
    }
    assert_eq!(
        bench.app.scene(),
        &before,
        "nothing changes until it is closed"
    );
    assert_eq!(bench.hint(), Some("draw-close"));
    bench.key(Key::Enter);
    assert_eq!(bench.subject(), TRIANGLE, "on the grid, as handles are");
    assert_eq!(bench.hint(), None);
    bench.press(Key::Z, ctrl());
    assert_eq!(bench.app.scene(), &before, "one undo takes it back");
}

#[test]
fn a_double_click_or_one_on_the_first_vertex_closes_the_outline() {
    for on_first in [false, true] {
        let mut bench = Bench::polygons();
        bench.key(Key::D);
        bench.click_at(TRIANGLE[0]);
        bench.click_at(TRIANGLE[1]);
        if on_first {
            bench.click_at(TRIANGLE[2]);
            bench.click_at(TRIANGLE[0]);
        } else {
            bench.double_click_at(TRIANGLE[2]);
        }
        assert_eq!(bench.subject(), TRIANGLE, "on the first: {on_first}");
    }
}

#[test]
fn backspace_takes_a_point_back_and_escape_leaves_everything_as_it_was() {
    let mut bench = Bench::polygons();
    let before = bench.app.scene().clone();
    bench.key(Key::D);
    bench.click_at(TRIANGLE[0]);
    bench.click_at([2.0, 0.0]);
    bench.key(Key::Backspace);
    bench.press(Key::Z, ctrl());
    let sketch = bench.app.stage.sketch.as_ref().expect("still drawing");
    assert_eq!(sketch.points(), [[0.0; 2]; 0]);
    bench.key(Key::Enter);
    assert_eq!(bench.hint(), Some("draw-subject"), "nothing to close yet");
    bench.click_at(TRIANGLE[0]);
    let position = bench.app.position();
    bench.key(Key::ArrowRight);
    assert_eq!(bench.app.position(), position, "the run stands still");
    bench.key(Key::Escape);
    assert_eq!(bench.hint(), None);
    assert_eq!(bench.app.scene(), &before);
    assert!(!bench.app.history.can_undo());
}

#[test]
fn a_clip_polygon_and_a_hole_are_drawn_the_same_way() {
    let mut bench = Bench::polygons();
    bench.key(Key::H);
    assert_eq!(bench.hint(), None, "Sutherland–Hodgman knows no holes");
    assert!(!bench.app.notices.is_empty(), "and that is said");
    bench.command(Command::Edit(Edit::Method("weiler-atherton"), None));
    for (key, outline) in [(Key::C, &OUTLINES[1]), (Key::H, &OUTLINES[2])] {
        bench.key(key);
        assert!(bench.hint().is_some(), "{outline:?}");
        for at in TRIANGLE {
            bench.click_at(at);
        }
        bench.key(Key::Enter);
    }
    let drawn = |polygon: &crate::geom::Polygon| {
        polygon
            .vertices()
            .iter()
            .map(|p| p.to_array())
            .collect::<Vec<_>>()
    };
    assert_eq!(drawn(bench.polygon().clip.as_ref().unwrap()), TRIANGLE);
    assert_eq!(drawn(&bench.polygon().holes[0]), TRIANGLE);
}

#[test]
fn the_lines_lab_draws_no_polygon() {
    let mut bench = Bench::new(SIZE);
    for key in [Key::D, Key::C, Key::H, Key::Enter, Key::Backspace] {
        bench.key(key);
    }
    assert_eq!(bench.hint(), None);
    assert!(!bench.app.history.can_undo());
}

#[test]
fn two_clicks_or_ctrl_and_one_put_a_vertex_on_an_edge() {
    let mut bench = Bench::polygons();
    let square = [[-1.5, -1.5], [1.5, -1.5], [1.5, 1.5], [-1.5, 1.5]];
    let polygon = crate::geom::Polygon::new(&square).unwrap();
    bench.edit(PolygonsChange::Subject(polygon));
    bench.double_click_at([0.5, -1.5]);
    assert_eq!(bench.subject().len(), 5);
    assert_eq!(bench.subject()[1], [0.5, -1.5]);
    assert_eq!(
        bench.app.stage.selected,
        Some(SceneVertex::Subject(1).handle())
    );
    bench.click(bench.on_screen([-1.5, 0.5]), ctrl());
    assert_eq!(
        bench.subject()[5],
        [-1.5, 0.5],
        "the last edge closes the ring"
    );
    bench.key(Key::Delete);
    assert_eq!(
        bench.subject().len(),
        5,
        "the new vertex was the selected one"
    );
    bench.double_click_at([0.5, 0.5]);
    bench.click_at([0.0, -1.5]);
    assert_eq!(bench.subject().len(), 5, "not on an edge, or not twice");
}

#[test]
fn insert_and_delete_are_about_the_vertex_that_was_taken_hold_of() {
    let mut bench = Bench::polygons();
    let before = bench.subject();
    bench.click_at(before[1]);
    assert_eq!(
        bench.app.stage.selected,
        Some(SceneVertex::Subject(1).handle())
    );
    bench.key(Key::Insert);
    assert_eq!(bench.subject().len(), before.len() + 1);
    assert_eq!(
        bench.app.stage.selected,
        Some(SceneVertex::Subject(2).handle())
    );
    bench.key(Key::Delete);
    assert_eq!(bench.subject(), before);
    bench.drag(bench.on_screen(before[2]), bench.on_screen([1.0, 1.0]));
    assert_eq!(
        bench.app.stage.selected,
        Some(SceneVertex::Subject(2).handle())
    );
    bench.key(Key::Delete);
    assert_eq!(bench.subject(), [before[0], before[1], before[3]]);
}

#[test]
fn the_last_three_vertices_stay_and_it_is_said_in_every_language() {
    for lang in Lang::ALL {
        let mut bench = Bench::polygons();
        bench.command(Command::Language(lang));
        let n = bench.subject().len();
        for _ in 0..n {
            bench.key(Key::Delete);
        }
        assert_eq!(bench.subject().len(), 3);
        let said = crate::text::Catalog::of(lang).term("error-last-three");
        let notices = bench.app.notices.shown();
        assert!(notices.iter().any(|notice| notice.text == said), "{lang}");
    }
}

#[test]
fn every_preset_and_region_is_clipped_by_every_method() {
    let mut bench = Bench::polygons();
    let methods = LAB.methods();
    for (i, preset) in PRESETS.iter().enumerate() {
        bench.edit(PolygonsChange::Preset(i));
        for method in &methods {
            bench.command(Command::Edit(Edit::Method(method.id), None));
            bench.key(Key::End);
            assert!(
                bench.frame(0.1, Vec::new()) > 0,
                "{} {}",
                preset.name_key,
                method.id
            );
        }
    }
    for (i, region) in REGIONS.iter().enumerate() {
        bench.edit(PolygonsChange::Region(i));
        assert!(bench.polygon().clip.is_some(), "{}", region.name_key);
        bench.key(Key::End);
    }
    bench.edit(PolygonsChange::Clip(None));
    assert!(bench.polygon().clip.is_none());
}

#[test]
fn indices_that_are_none_change_nothing() {
    let mut bench = Bench::polygons();
    let before = bench.app.scene().clone();
    for edit in [
        PolygonsChange::Preset(usize::MAX),
        PolygonsChange::Region(usize::MAX),
        PolygonsChange::Insert(SceneVertex::Subject(999), None),
        PolygonsChange::Insert(SceneVertex::Subject(0), Some([f64::NAN, 0.0])),
        PolygonsChange::Insert(SceneVertex::Hole(7, 0), None),
        PolygonsChange::Delete(SceneVertex::Clip(3)),
        PolygonsChange::Random { count: 0, seed: 0 },
        PolygonsChange::Random {
            count: 1_000_000,
            seed: 0,
        },
    ] {
        bench.edit(edit);
        assert_eq!(bench.app.scene(), &before);
    }
    for place in [[f64::NAN; 2], [f64::INFINITY, 0.0], [1e300, -1e300]] {
        bench.command(Command::Draw(&OUTLINES[0]));
        for _ in 0..4 {
            bench.command(Command::Place(place));
            bench.command(Command::Place([1.0, 2.0]));
        }
        bench.command(Command::CloseOutline);
        bench.key(Key::Escape);
        bench.key(Key::Escape);
    }
}

#[test]
fn the_first_difference_of_a_faulty_method_is_named_and_marked() {
    let methods = LAB.methods();
    let faulty = methods
        .iter()
        .find(|card| card.is_faulty)
        .expect("mistakes");
    let right = methods
        .iter()
        .find(|card| !card.is_faulty)
        .expect("a method");
    let mut bench = Bench::polygons();
    bench.command(Command::Edit(Edit::Method(right.id), None));
    assert_eq!(bench.app.playback.difference(), None);
    bench.command(Command::Edit(Edit::Compare(Some(faulty.id)), None));
    let difference = bench.app.playback.difference().expect("one is wrong");
    assert_eq!(difference.column, 1);
    let i = PRESETS
        .iter()
        .position(|preset| preset.name_key == "preset-along");
    bench.edit(PolygonsChange::Preset(i.expect("a preset")));
    let difference = bench.app.playback.difference().expect("one is wrong");
    let step = difference
        .step
        .expect("vertices on the border are its mistake");
    let runs = bench.app.scene().document().record();
    for same in 1..step {
        assert_eq!(runs[0].event_json(same), runs[1].event_json(same));
    }
    assert_ne!(runs[0].event_json(step), runs[1].event_json(step));
}

#[test]
fn an_idle_polygons_lab_asks_for_no_repaint() {
    let mut bench = Bench::polygons();
    bench.frame(10.0, Vec::new());
    assert!(
        bench.wait_secs > 1e6,
        "asks for a repaint in {} s",
        bench.wait_secs
    );
    bench.key(Key::D);
    bench.click_at([0.5, 0.5]);
    bench.frame(10.0, Vec::new());
    bench.frame(10.0, Vec::new());
    assert!(
        bench.wait_secs > 1e6,
        "while drawing: in {} s",
        bench.wait_secs
    );
}

#[test]
fn the_lab_opens_from_its_tab_and_goes_back() {
    let app = App::new(Course::embedded(), Settings::default());
    let mut bench = Bench::with(app, SIZE);
    for lab in [LAB, lines::LAB, LAB] {
        bench.command(Command::Lab(lab.id()));
        assert_eq!(bench.app.scene().document().lab(), lab);
        assert!(bench.frame(0.1, Vec::new()) > 0);
    }
}
