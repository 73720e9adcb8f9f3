//! What is set is what is shown.

use super::*;
use crate::{
    labs::{LABS, frustum, space::Part, surfaces},
    text::Message,
};

#[test]
fn a_number_that_is_set_is_the_number_that_is_shown() {
    for lab in [frustum::LAB, surfaces::LAB] {
        for card in (lab.methods)() {
            let mut scene = (lab.first_scene)();
            scene.document_mut().set_method(card.id);
            let first: &Scene = scene.get().expect("a scene in space");
            for control in sections(first).flat_map(|section| section.numbers) {
                let before = (control.numbers)(first);
                for (i, &was) in before.iter().enumerate() {
                    let range = (control.range)(first);
                    assert!(range.contains(&was), "{}: {was} in {range:?}", control.id);
                    let to = (was + 1.0).clamp(*range.start(), *range.end());
                    let mut changed = first.clone();
                    set(&mut changed, control.id, i, to).expect("a scene");
                    let now = (control.numbers)(&changed)[i];
                    assert!((now - to).abs() < 1e-9, "{}: {now} is {to}", control.id);
                }
            }
        }
    }
}

#[test]
fn every_group_can_be_locked() {
    for lab in LABS {
        let ids = (lab.controls)();
        let known = |group: &str| group.is_empty() || lab.lock_groups.contains(&group);
        let numbers = SECTIONS.iter().flat_map(|section| section.numbers);
        for control in numbers.filter(|control| ids.contains(&control.id)) {
            assert!(known(control.group), "{}: {}", lab.id, control.id);
        }
    }
}

#[test]
fn a_number_that_is_refused_is_the_number_that_was_typed() {
    let mut scene = (surfaces::LAB.first_scene)();
    let scene: &mut Scene = scene.get_mut().expect("a scene in space");
    let count = scene.count(Part::Object);
    for typed in [0, count + 1] {
        let refused = set(scene, "object.number", 0, typed as f64).expect_err("there is none");
        let expected = Message::new("error-no-such-object").with("focus", typed.to_string());
        assert_eq!(refused.message, expected.with("count", count));
    }
}
