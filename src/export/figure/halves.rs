//! What stands beside each other in a figure: the methods of a scene, or how it was and how it is.

use super::picture::{Options, Picture};
use crate::{
    figure::Eyes,
    labs::Scene,
    text::{Catalog, Lang},
    widgets::{Album, Column, Recorded},
};

/// A scene at a step, with each of its methods; with the first one, where it stands beside another scene.
pub struct Half<'a> {
    pub recorded: &'a Recorded,
    pub columns: Vec<Column>,
    /// What it is seen by, once that is found.
    pub eyes: Eyes,
}

/// One for each scene and its step.
pub fn halves<'a>(
    album: &'a Album,
    stops: &[(&Scene, usize)],
    asked_in: Option<Lang>,
) -> Vec<Half<'a>> {
    let half = |&(scene, step): &(&Scene, usize)| {
        let recorded = album.recorded(scene);
        let mut columns = recorded.columns(step, asked_in);
        if stops.len() > 1 {
            columns.truncate(1);
        }
        Half {
            recorded,
            columns,
            eyes: Eyes::default(),
        }
    };
    stops.iter().map(half).collect()
}

/// What stands over each column.
pub fn headings(halves: &[Half<'_>], picture: &Picture<'_>) -> Vec<String> {
    let Options { lang, asks, .. } = picture.options;
    let catalog = Catalog::of(lang);
    match halves {
        [_, _] => match picture.before.and_then(|before| before.sides) {
            Some(sides) => sides.to_vec(),
            None => ["figure-before", "figure-now"]
                .map(|key| catalog.term(key))
                .to_vec(),
        },
        _ => {
            let columns = halves.iter().flat_map(|half| &half.columns);
            let name = |column: &Column| catalog.term(column.method.name_asked(asks));
            columns.map(name).collect()
        }
    }
}
