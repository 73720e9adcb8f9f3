//! Scenes whose runs take longer than a frame.

use super::*;
use crate::{
    app::{found::Found, playback::Playback},
    figure::Body,
    geom::Mesh,
    labs::space::{Model, NamedMesh, SpaceChange},
};

/// A ring of so many squares by so many, each of two triangles.
fn ring(n: u32) -> Edit {
    let places = (0..n).flat_map(|i| (0..n).map(move |j| [i, j].map(|k| k as f32 / n as f32)));
    let positions = places.map(|turns| {
        let [(sin, cos), (up, out)] = turns.map(|turn| libm::sincosf(turn * std::f32::consts::TAU));
        let far = 0.7 + 0.3 * out;
        [far * cos, 0.3 * up, far * sin]
    });
    let at = |i: u32, j: u32| (i % n) * n + j % n;
    let squares = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    let faces = squares.flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        [[a, b, c], [a, c, d]]
    });
    let mesh = Mesh::new(positions.collect(), Vec::new(), faces.collect()).expect("a ring");
    let named = NamedMesh {
        name: "ring".to_owned(),
        mesh,
        picture: None,
    };
    Edit::own(SpaceChange::Add(Model::Mesh(Arc::new(named))))
}

/// So many take far longer than a frame.
const MANY: u32 = 180;

/// A street with a large ring that is being recorded, and the scene before.
fn recording() -> (Bench, Scene) {
    let mut bench = Bench::lab("frustum");
    let before = bench.app.scene().clone();
    bench.apply(Command::Edit(ring(MANY), None));
    bench.frame(0.02, Vec::new());
    assert!(bench.app.is_recording());
    (bench, before)
}

#[test]
fn while_a_large_scene_is_recorded_the_window_answers_and_says_what_it_does() {
    let (mut bench, before) = recording();
    let n_steps = bench.n_steps();
    assert_eq!(*bench.app.scene(), before, "the last picture stays");
    let said: Vec<String> = bench.texts().into_iter().map(|(text, _)| text).collect();
    let n = bench.app.history.now().document().size();
    let n = Catalog::of(Lang::En).value(&Value::Count(n));
    let is_said = said
        .iter()
        .any(|text| text.contains(&format!("{n} triangles")));
    assert!(is_said, "{n} is not in {said:?}");
    bench.frame(0.02, vec![key_event(Key::End, true, Modifiers::NONE)]);
    assert_eq!(bench.app.position(), n_steps, "of the run on the stage");
    for _ in 0..3 {
        bench.frame(1.0, Vec::new());
    }
    let wait_secs = bench.wait_secs;
    bench.frame(1.0, Vec::new());
    // It has not come meanwhile.
    if bench.app.is_recording() {
        assert!(wait_secs > 1.0, "drawn again after {wait_secs} s");
    }
    bench.settle();
    assert_eq!(*bench.app.scene(), *bench.app.history.now());
    assert!(bench.n_steps() > n_steps);
}

#[test]
fn escape_stops_and_brings_the_last_scene_back_and_redo_the_large_one() {
    let (mut bench, before) = recording();
    bench.frame(0.02, vec![key_event(Key::Escape, true, Modifiers::NONE)]);
    assert!(!bench.app.is_recording());
    assert_eq!(*bench.app.history.now(), before);
    bench.command(Command::Redo);
    assert!(bench.space().objects().len() > 1);
    assert_eq!(*bench.app.scene(), *bench.app.history.now());
}

#[test]
fn a_page_with_a_large_scene_is_left_as_it_was_when_its_recording_is_stopped() {
    let (mut bench, _) = recording();
    bench.settle();
    let at = bench.n_steps() / 2;
    bench.app.seek(at);
    bench.command(Command::Lab("lines"));
    let lines = bench.app.scene().clone();
    bench.apply(Command::Lab("frustum"));
    bench.frame(0.02, Vec::new());
    assert!(bench.app.is_recording());
    assert_eq!(*bench.app.scene(), lines, "it is still on the stage");
    bench.frame(0.02, vec![key_event(Key::Escape, true, Modifiers::NONE)]);
    assert_eq!(*bench.app.history.now(), lines);
    let page = bench.app.bookmark.page();
    assert_eq!(page, Some(Page::Free("lines".to_owned())));
    bench.command(Command::Lab("frustum"));
    assert_eq!(bench.app.position(), at);
}

#[test]
fn the_solids_of_the_first_picture_are_found_before_it_is_drawn() {
    let (mut bench, _) = recording();
    bench.settle();
    let (scene, bounds) = (bench.app.scene().clone(), bench.app.stage.bounds());
    let found = Found::of(&scene).with_wanted(bounds);
    let mut found = found.with_pictures(|n_steps| n_steps / 2, None);
    let (ahead, n_steps) = (std::mem::take(&mut found.ahead), found.runs[0].n_steps());
    let mut playback = Playback::of(found, n_steps / 2);
    playback.prepare(bounds, None);
    let mut n_spaces = 0;
    for view in &playback.frames[0].views {
        if let Body::Space(space) = &view.body {
            let lens = Lens::from(space.seer);
            assert!(
                ahead.iter().any(|known| known.is_of(space, &lens)),
                "{:?}",
                view.id
            );
            n_spaces += 1;
        }
    }
    assert_eq!(n_spaces, 2);
}

#[test]
fn a_mesh_that_is_added_leaves_the_run_at_its_step() {
    let mut bench = Bench::lab("frustum");
    let n_before = bench.n_steps();
    bench.command(Command::Seek(3));
    let said = bench.said();
    // Two triangles a square: its run is far longer than one that is searched event by event.
    bench.command(Command::Edit(ring(50), None));
    assert!(
        bench.n_steps() > n_before + 5_000 - 1,
        "{}",
        bench.n_steps()
    );
    assert_eq!((bench.app.position(), bench.said()), (3, said));
}
