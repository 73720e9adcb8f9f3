//! Every lab is in every table, with words in every language.

use crate::{
    app::Kit,
    case::Solvers,
    figure::Moment,
    labs::LABS,
    text::{Catalog, Lang},
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
    let tabs: Vec<&str> = kit.panels.iter().map(|panel| panel.lab().id()).collect();
    assert_eq!(
        tabs,
        LABS.map(crate::labs::Lab::id),
        "a tab each, in their order"
    );
    for lab in LABS {
        let id = lab.id();
        let scene = lab.first_scene();
        let written = kit.formats.write(&scene, &Moment::Start);
        let read = kit.formats.read("scene.toml", written.as_bytes());
        let read = read.expect("as it was written").scene;
        assert_eq!(read, scene, "{id}: its scenes are spelt");
        let solved = |id: &str| Solvers::standard().by_id(id).is_some();
        let methods = lab.methods();
        let has_cases = |id: &str| !WITHOUT_CASES.contains(&id);
        let right = methods
            .iter()
            .filter(|card| !card.is_faulty && has_cases(card.id));
        for card in right {
            assert!(solved(card.id), "{}: no case can name it", card.id);
        }
        for lang in Lang::ALL {
            let names = methods.iter().map(|card| card.name_key);
            for key in names.chain([lab.name_key(), lab.about_key()]) {
                let said = Catalog::of(lang).term(key);
                assert!(!said.contains('⟦'), "{lang} has no {key}");
            }
        }
        for handle in scene.document().handles() {
            let at = scene.document().position(handle);
            assert!(at.is_some(), "{id}: {handle:?} lies nowhere");
            let group = handle.group();
            assert!(
                lab.lock_groups().contains(&group),
                "{id}: nothing locks {group}"
            );
        }
    }
}
