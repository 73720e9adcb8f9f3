//! What is set is what is shown.

use super::*;
use crate::labs::{LABS, frustum, surfaces};

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
