//! Which handles lie elsewhere in another scene.

use crate::text::{Message, Value};

use super::{Handle, Scene};

/// Scenes of more handles are not looked through for the fewest.
const FEW: usize = 64;

/// The handles by which one scene becomes the other: each the one that brings most to its place there; of very many, all that lie
/// elsewhere, but for figures taken hold of as a whole.
pub fn moved(scene: &Scene, there: &Scene) -> Vec<Handle> {
    let mut left = elsewhere(scene, there);
    if left.len() > FEW {
        left.retain(|handle| handle.is_part());
        return left;
    }
    // A figure as a whole lies elsewhere until the last of its parts is in its place.
    let n_parts = |left: &[Handle]| left.iter().filter(|it| it.is_part()).count();
    let mut scene = scene.clone();
    let mut found = Vec::new();
    // Each round leaves fewer parts elsewhere.
    while n_parts(&left) > 0 {
        let moves = left.iter().filter_map(|&handle| {
            let mut moved = scene.clone();
            let to = there.document().position(handle)?;
            moved.document_mut().drag(handle, to).ok()?;
            Some((elsewhere(&moved, there), handle, moved))
        });
        let fewest = moves.min_by_key(|(rest, ..)| n_parts(rest));
        let fewer = fewest.filter(|(rest, ..)| n_parts(rest) < n_parts(&left));
        let Some((rest, handle, moved)) = fewer else {
            break;
        };
        found.push(handle);
        (left, scene) = (rest, moved);
    }
    found
}

fn elsewhere(scene: &Scene, there: &Scene) -> Vec<Handle> {
    let handles = scene.document().handles().into_iter();
    let is_elsewhere = |&handle: &Handle| {
        let to = there.document().position(handle);
        to.is_some_and(|to| scene.document().position(handle) != Some(to))
    };
    handles.filter(is_elsewhere).collect()
}

/// Their names, as the scene calls them, one after the other.
pub fn listed(scene: &Scene, handles: &[Handle]) -> Value {
    let names = handles
        .iter()
        .map(|handle| scene.document().called(*handle));
    let list = names.reduce(|list, name| {
        let pair = Message::new("handles-listed").with("list", list);
        pair.with("name", name)
    });
    list.map_or_else(|| Value::Name(String::new()), Value::Message)
}

#[cfg(test)]
mod tests {
    use crate::lesson::Course;

    use super::*;

    #[test]
    fn what_moved_is_told_by_the_fewest_handles() {
        let course = Course::embedded();
        let steps = course.lessons.iter().flat_map(|lesson| &lesson.steps);
        let mut n_alone = 0;
        for step in steps {
            let Some(goal) = &step.goal else { continue };
            let handles = moved(&step.scene, &goal.reached);
            assert!(!handles.is_empty(), "{}", step.id);
            assert!(moved(&step.scene, &step.scene).is_empty());
            let mut scene = (*step.scene).clone();
            for handle in &handles {
                let to = goal.reached.document().position(*handle);
                let to = to.expect("it is there, too");
                let _ = scene.document_mut().drag(*handle, to);
            }
            let met = goal.met_by(&scene);
            assert!(met.iter().all(|is_met| *is_met), "{}: {met:?}", step.id);
            n_alone += usize::from(handles.len() == 1);
        }
        assert!(n_alone > 20, "{n_alone}");
    }
}
