//! Which handles a step of a lesson locks, and which its text asks for.

use crate::labs::{Lab, Lock, Scene};

use super::toml_fields::Node;

/// Those of an unknown lab cannot be known.
pub fn locks(lab: Option<&Lab>, node: Node<'_>) -> Vec<Lock> {
    let nodes = node.list("expect-locks").into_iter().flatten();
    let Some(lab) = lab else {
        return Vec::new();
    };
    let lock = |node: Node<'_>| {
        let known = lab.lock_groups;
        node.one_of(known, "problem-unknown-lock", |name| Lock::of(lab, name))
    };
    nodes.filter_map(lock).collect()
}

/// Kinds of handles of the step's own scene.
pub fn drags_in(scene: &Scene, node: Node<'_>) -> Vec<String> {
    let handles = scene.document().handles().into_iter();
    let mut known: Vec<&str> = handles.map(|handle| handle.kind().id).collect();
    known.dedup();
    let nodes = node.list("expect-drags").into_iter().flatten();
    let kind = |node: Node<'_>| {
        node.one_of(&known, "problem-unknown-lock", |name| {
            known.contains(&name).then(|| name.to_owned())
        })
    };
    nodes.filter_map(kind).collect()
}
