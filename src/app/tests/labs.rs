//! Every lab is in every table, with words in every language.

use super::*;
use crate::{
    case::Solvers,
    figure::{Body, ViewId},
    labs::LABS,
};

/// What works on a scene and not on a case: of a texture, `intersection-polygon` has the coordinates.
const WITHOUT_CASES: [&str; 4] = [
    "funnel",
    "textured-triangle",
    "undivided-texture",
    "occlusion",
];

#[test]
fn every_lab_has_a_format_solvers_a_panel_and_words() {
    let kit = Kit::default();
    let tabs: Vec<&str> = kit.panels.iter().map(|panel| panel.lab().id).collect();
    assert_eq!(tabs, LABS.map(|lab| lab.id), "a tab each, in their order");
    for lab in LABS {
        let id = lab.id;
        let scene = (lab.first_scene)();
        let written = kit.formats.write(&scene, &Moment::Start);
        let read = kit.formats.read("scene.toml", written.as_bytes());
        let read = read.expect("as it was written").scene;
        assert_eq!(read, scene, "{id}: its scenes are spelt");
        let methods = (lab.methods)();
        for card in methods
            .iter()
            .filter(|card| !card.is_faulty && !card.is_proof)
        {
            let is_solved = Solvers::standard().by_id(card.id).is_some();
            let has_cases = !WITHOUT_CASES.contains(&card.id);
            assert!(is_solved || !has_cases, "{}: no case can name it", card.id);
        }
        for lang in Lang::ALL {
            let names = methods.iter().map(|card| card.name_key);
            for key in names.chain([lab.name_key, lab.about_key]) {
                let said = Catalog::of(lang).term(key);
                assert!(!said.contains('⟦'), "{lang} has no {key}");
            }
            let recording = Message::new(lab.recording_key).with("method", "M".to_owned());
            let said = Catalog::of(lang).message(&recording.with("count", 2usize));
            assert!(!said.contains('⟦'), "{lang}: {said}");
        }
        for handle in scene.document().handles() {
            let at = scene.document().position(handle);
            assert!(at.is_some(), "{id}: {handle:?} lies nowhere");
            let group = handle.group();
            let is_known = lab.lock_groups.contains(&group);
            assert!(is_known, "{id}: nothing locks {group}");
        }
    }
}

#[test]
fn when_all_objects_are_tested_the_axes_keep_the_last_sphere() {
    let mut bench = Bench::lab("frustum");
    bench.edit(Edit::Method("funnel"));
    let known = |bench: &Bench| match bench.app.playback.frames[0].body(ViewId("distances")) {
        Some(Body::Gauges(gauges)) => gauges.rows.iter().filter(|row| row.value.is_some()).count(),
        _ => 0,
    };
    bench.command(Command::Seek(0));
    assert_eq!(known(&bench), 0);
    bench.command(Command::LAST);
    assert!(known(&bench) > 0, "of {} steps", bench.n_steps());
}
