//! A scene that is like another one of its lesson, but for some fields: `like = "practice"`.
//!
//! Tables are merged field by field, and a list takes entries by their numbers: `objects.4.at = [3, 1, 0]` moves one object.

use toml::de::{DeTable, DeValue};

use super::{prelude::*, toml_fields::Node};

const LIKE: &str = "like";

/// The fields of the scene `name`: where it is like another one, those of the other but for its own. `None` where there is no
/// such scene to be like, which is reported.
pub(super) fn fields<'t>(all: &'t DeTable<'t>, name: &str, node: Node<'t>) -> Option<DeTable<'t>> {
    let own = node.table()?;
    let mut layers = vec![own];
    let mut names = vec![name.to_owned()];
    while let Some(like) = layers.last().and_then(|table| table.get(LIKE)) {
        let node = Node::of(like, node.sink);
        let known: Vec<&str> = all.keys().map(|key| &**key.get_ref()).collect();
        let other = node.one_of(&known, "problem-unknown-scene", |name| {
            known.contains(&name).then(|| name.to_owned())
        })?;
        if names.contains(&other) {
            node.error(
                Message::new("problem-like-itself").with("name", clipped(&other)),
                [],
            );
            return None;
        }
        layers.push(all.get(&*other)?.get_ref().as_table()?);
        names.push(other);
    }
    let mut fields = layers.pop()?.clone();
    while let Some(layer) = layers.pop() {
        merge(&mut fields, layer);
    }
    fields.remove(LIKE);
    Some(fields)
}

fn merge<'t>(table: &mut DeTable<'t>, over: &DeTable<'t>) {
    for (key, value) in over {
        let old = table.get_mut(&**key.get_ref());
        if !old.is_some_and(|old| is_merged(old.get_mut(), value.get_ref())) {
            table.insert(key.clone(), value.clone());
        }
    }
}

/// Puts a table's fields into another, or into the entries of a list that have their numbers; not where there are none.
fn is_merged<'t>(old: &mut DeValue<'t>, new: &DeValue<'t>) -> bool {
    match (old, new) {
        (DeValue::Table(old), DeValue::Table(new)) => {
            merge(old, new);
            true
        }
        (DeValue::Array(old), DeValue::Table(new)) => {
            let index = |key: &str| key.parse().ok().filter(|&i: &usize| i < old.len());
            let indices: Option<Vec<usize>> = new.keys().map(|key| index(key.get_ref())).collect();
            let Some(indices) = indices else {
                return false;
            };
            for (i, value) in indices.into_iter().zip(new.values()) {
                let Some(entry) = old.get_mut(i) else {
                    continue;
                };
                if !is_merged(entry.get_mut(), value.get_ref()) {
                    *entry = value.clone();
                }
            }
            true
        }
        _ => false,
    }
}
