//! Scenes as lesson and scene files spell them, each lab in a file of its own.

mod lines;
mod parts;
mod polygons;

use toml::de::DeTable;

use crate::labs::{Lab, Scene, lines::MAX_SEGMENTS, polygons::MAX_VERTICES};

use super::{
    problem::Problem, sink::Sink, source::Source, toml_errors::with_toml, toml_fields::Fields,
};

/// What the scenes of one file may still hold.
pub(super) struct Room {
    segments: usize,
    vertices: usize,
}

impl Room {
    /// Of a file that holds nothing yet.
    pub const fn of_file() -> Self {
        Self {
            segments: MAX_SEGMENTS,
            vertices: 10 * MAX_VERTICES,
        }
    }
}

/// The fields of this lab's scenes.
pub(super) const fn fields_of(lab: Lab) -> &'static [&'static str] {
    match lab {
        Lab::Lines => &lines::FIELDS,
        Lab::Polygons => &polygons::FIELDS,
    }
}

/// Reads a scene.
pub(super) fn scene(
    lab: Lab,
    fields: &Fields<'_>,
    room: &mut Room,
    sink: &mut Sink<'_>,
) -> Option<Scene> {
    match lab {
        Lab::Lines => lines::scene(fields, &mut room.segments, sink).map(Scene::Lines),
        Lab::Polygons => polygons::scene(fields, &mut room.vertices, sink).map(Scene::Polygons),
    }
}

/// Reads a scene file: one scene's fields at the top level, as [`scene_to_toml`] writes them.
///
/// # Errors
/// Every mistake in it, from the top to the end; `file` is how they name it.
pub fn scene_from_toml(file: &str, bytes: &[u8]) -> Result<Scene, Vec<Problem>> {
    let source = Source::new(file.to_owned(), bytes);
    let mut sink = Sink::new(&source);
    let scene = with_toml(&mut sink, |table, sink| {
        let lab = lab_of(table);
        let fields = Fields::of_file(table, fields_of(lab), sink);
        scene(lab, &fields, &mut Room::of_file(), sink)
    });
    match scene {
        Some(scene) if sink.n_errors() == 0 => Ok(scene),
        _ => Err(sink.into_problems()),
    }
}

/// The lab that a scene file is for: that of its method, or the one that has a polygon.
fn lab_of(table: &DeTable<'_>) -> Lab {
    let method = table.get("method").and_then(|item| item.get_ref().as_str());
    let has_method = |lab: &Lab| lab.methods().iter().any(|card| Some(card.id) == method);
    let by_field = if table.contains_key("polygon") {
        Lab::Polygons
    } else {
        Lab::Lines
    };
    Lab::ALL.into_iter().find(has_method).unwrap_or(by_field)
}

/// Writes a scene so that [`scene_from_toml`] reads the very same one, bit for bit.
#[must_use]
pub fn scene_to_toml(scene: &Scene) -> String {
    match scene {
        Scene::Lines(scene) => lines::to_toml(scene),
        Scene::Polygons(scene) => polygons::to_toml(scene),
    }
}
