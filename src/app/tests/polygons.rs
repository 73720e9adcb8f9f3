//! The polygons lab: outlines drawn by clicking, vertices put in and taken out, presets, mistakes.

use super::*;
use crate::{
    geom::Polygon,
    labs::polygons::{LAB, OUTLINES, PRESETS, PolygonsChange, REGIONS, SceneVertex},
};

impl Bench {
    /// The polygons lab on its first scene.
    pub(super) fn polygons() -> Self {
        let mut bench = Self::new(ROOMY);
        bench.command(Command::Lab(LAB.id));
        bench
    }

    pub(super) fn change(&mut self, change: PolygonsChange) {
        self.edit(Edit::own(change));
    }

    fn polygon(&self) -> &crate::labs::polygons::Scene {
        self.scene()
    }

    pub(super) fn subject(&self) -> Vec<[f64; 2]> {
        places(&self.polygon().subject)
    }

    fn selects(&self, vertex: usize) -> bool {
        self.app.stage.selected == Some(SceneVertex::Subject(vertex).handle())
    }

    fn click(&mut self, world: [f64; 2], n_times: usize, modifiers: Modifiers) {
        let at = self.on_screen(world);
        let moved = Event::PointerMoved(at);
        self.frame(0.5, vec![moved, Event::ModifiersChanged(modifiers)]);
        for pressed in [true, false].repeat(n_times) {
            self.frame(0.02, vec![button_event(at, pressed, modifiers)]);
        }
        let none = Event::ModifiersChanged(Modifiers::NONE);
        self.frame(0.02, vec![none]);
    }

    pub(super) fn click_at(&mut self, world: [f64; 2]) {
        self.click(world, 1, Modifiers::NONE);
    }

    fn double_click_at(&mut self, world: [f64; 2]) {
        self.click(world, 2, Modifiers::NONE);
    }

    fn hint(&self) -> Option<&'static str> {
        let sketch = self.app.stage.sketch.as_ref();
        sketch.map(|sketch| sketch.hint().key)
    }
}

fn places(polygon: &Polygon) -> Vec<[f64; 2]> {
    polygon.vertices().iter().map(|p| p.to_array()).collect()
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
    assert_eq!(bench.app.scene(), &before, "until it is closed");
    assert_eq!(bench.hint(), Some("draw-close"));
    bench.key(Key::Enter);
    assert_eq!(bench.subject(), TRIANGLE, "on the grid, as handles are");
    assert_eq!(bench.hint(), None);
    bench.undo();
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
    bench.click_at([1.25, 0.5]);
    bench.key(Key::Backspace);
    bench.undo();
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
    bench.edit(Edit::Method("weiler-atherton"));
    for (key, outline) in [(Key::C, &OUTLINES[1]), (Key::H, &OUTLINES[2])] {
        bench.key(key);
        assert!(bench.hint().is_some(), "{outline:?}");
        for at in TRIANGLE {
            bench.click_at(at);
        }
        bench.key(Key::Enter);
    }
    assert_eq!(places(bench.polygon().clip.as_ref().unwrap()), TRIANGLE);
    assert_eq!(places(&bench.polygon().holes[0]), TRIANGLE);
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
    bench.change(PolygonsChange::Subject(Polygon::new(&square).unwrap()));
    bench.double_click_at([0.5, -1.5]);
    assert_eq!(bench.subject().len(), 5);
    assert_eq!(bench.subject()[1], [0.5, -1.5]);
    assert!(bench.selects(1));
    bench.click([-1.5, 0.5], 1, ctrl());
    let last = bench.subject()[5];
    assert_eq!(last, [-1.5, 0.5], "the last edge closes the ring");
    bench.key(Key::Delete);
    assert_eq!(bench.subject().len(), 5, "the new vertex was selected");
    bench.double_click_at([0.5, 0.5]);
    bench.click_at([0.0, -1.5]);
    assert_eq!(bench.subject().len(), 5, "not on an edge, or not twice");
}

#[test]
fn insert_and_delete_are_about_the_vertex_that_was_taken_hold_of() {
    let mut bench = Bench::polygons();
    let before = bench.subject();
    bench.click_at(before[1]);
    assert!(bench.selects(1));
    bench.key(Key::Insert);
    assert_eq!(bench.subject().len(), before.len() + 1);
    assert!(bench.selects(2));
    bench.key(Key::Delete);
    assert_eq!(bench.subject(), before);
    bench.drag(bench.on_screen(before[2]), bench.on_screen([1.0, 1.0]));
    assert!(bench.selects(2));
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
        let said = Catalog::of(lang).term("error-last-three");
        let notices = bench.app.notices;
        assert!(notices.iter().any(|notice| notice.text == said), "{lang}");
    }
}

#[test]
fn every_preset_and_region_is_clipped_by_every_method() {
    let mut bench = Bench::polygons();
    let methods = (LAB.methods)();
    for (i, preset) in PRESETS.iter().enumerate() {
        bench.change(PolygonsChange::Preset(i));
        for method in &methods {
            bench.edit(Edit::Method(method.id));
            bench.key(Key::End);
            let n_shapes = bench.frame(0.1, Vec::new());
            assert!(n_shapes > 0, "{} {}", preset.name_key, method.id);
        }
    }
    for (i, region) in REGIONS.iter().enumerate() {
        bench.change(PolygonsChange::Region(i));
        assert!(bench.polygon().clip.is_some(), "{}", region.name_key);
        bench.key(Key::End);
    }
    bench.change(PolygonsChange::Clip(None));
    assert!(bench.polygon().clip.is_none());
}

#[test]
fn indices_that_are_none_change_nothing() {
    let mut bench = Bench::polygons();
    let before = bench.app.scene().clone();
    let random = |count| PolygonsChange::Random { count, seed: 0 };
    for edit in [
        PolygonsChange::Preset(usize::MAX),
        PolygonsChange::Region(usize::MAX),
        PolygonsChange::Insert(SceneVertex::Subject(999), None),
        PolygonsChange::Insert(SceneVertex::Subject(0), Some([f64::NAN, 0.0])),
        PolygonsChange::Insert(SceneVertex::Hole(7, 0), None),
        PolygonsChange::Delete(SceneVertex::Clip(3)),
        random(0),
        random(1_000_000),
    ] {
        bench.change(edit);
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
    let methods = (LAB.methods)();
    let first = |is_so: fn(&MethodCard) -> bool| methods.iter().find(|card| is_so(card)).unwrap();
    let (faulty, right) = (first(|card| card.is_faulty), first(|card| !card.is_faulty));
    let mut bench = Bench::polygons();
    bench.edit(Edit::Method(right.id));
    assert_eq!(bench.app.playback.difference, None);
    bench.edit(Edit::Compare(Some(faulty.id)));
    let difference = bench.app.playback.difference.expect("one is wrong");
    assert_eq!(difference.column, 1);
    let mut presets = PRESETS.iter();
    let along = presets.position(|preset| preset.name_key == "preset-along");
    bench.change(PolygonsChange::Preset(along.expect("a preset")));
    let difference = bench.app.playback.difference.expect("one is wrong");
    let step = difference
        .step
        .expect("its mistake are vertices on the border");
    let runs = bench.document().record();
    for same in 1..step {
        assert_eq!(runs[0].event_json(same), runs[1].event_json(same));
    }
    assert_ne!(runs[0].event_json(step), runs[1].event_json(step));
}

#[test]
fn a_scene_that_is_refused_is_all_in_sight_and_its_buttons_cover_none_of_it() {
    let mut bench = Bench::course(SIZE);
    bench.open_step("14-both-lists", "the-walk-that-switches");
    let handles = bench.document().handles();
    let mut at_s4 = handles.into_iter().filter(|handle| {
        let at = bench.document().position(*handle);
        at == Some([-2.0, 2.0, 0.0]) && handle.kind().is_vertex
    });
    let s4 = at_s4.next().expect("a vertex");
    bench.edit(Edit::Drag(s4, [2.0, -4.0, 0.0]));
    assert!(bench.app.playback.main().is_refused());
    let buttons = bench.app.stage.ways_out_at.expect("ways out");
    let seen = bench
        .app
        .stage
        .seen
        .values()
        .next()
        .expect("a drawing")
        .rect;
    let stands = bench.app.scene().document().handles();
    for handle in stands.into_iter().filter(|handle| handle.kind().is_vertex) {
        let place = bench.document().position(handle).expect("a place");
        let at = bench.on_screen([place[0], place[1]]);
        assert!(
            seen.contains(at) && !buttons.contains(at),
            "{place:?} {at} {seen}"
        );
    }
}
