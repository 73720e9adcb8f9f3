//! How a lab's scenes are spelt, whichever lab it is.

use std::fmt::Write as _;

use toml::de::DeTable;

use crate::{
    figure::Moment,
    labs::{Lab, Scene},
    lesson::{
        prelude::*,
        stop::{moment, moment_in},
        toml_errors::with_toml,
        toml_fields::{Node, TomlFields},
    },
};

/// Where a scene's run stands.
const AT: &str = "at";

#[derive(Clone, PartialEq, Debug)]
pub struct SceneFile {
    pub scene: Scene,
    /// The step at which its run stands.
    pub position: usize,
    pub moment: Moment,
}

pub(crate) struct SceneFormat {
    pub lab: &'static Lab,
    pub fields: &'static [&'static str],
    /// The field that tells its scenes from all other labs', where the method does not.
    pub own_field: &'static str,
    /// How much, in segments or vertices, all scenes of one file may hold.
    pub room: usize,
    /// Reads a scene, reporting all its mistakes; takes its size from `room`.
    pub read: fn(fields: &TomlFields<'_>, room: &mut usize) -> Option<Scene>,
    /// Writes a scene of this lab.
    pub write: fn(&Scene) -> Option<String>,
}

#[derive(Clone, Copy)]
pub struct SceneFormats(pub(crate) &'static [&'static SceneFormat]);

impl SceneFormats {
    pub(crate) fn lab_ids(self) -> Vec<&'static str> {
        self.0.iter().map(|format| format.lab.id).collect()
    }

    pub(crate) fn of(self, lab_id: &str) -> Option<&'static SceneFormat> {
        let mut formats = self.0.iter().copied();
        formats.find(|format| format.lab.id == lab_id)
    }

    // One scene's fields stand at the top level, as `write` writes them; `file` is how mistakes name it.
    pub fn read(self, file: &str, bytes: &[u8]) -> Result<SceneFile, Vec<Problem>> {
        let source = Source::new(file.to_owned(), bytes);
        let sink = Sink::new(&source);
        let read = with_toml(&sink, |table, sink| {
            let format = self.of_table(table)?;
            let known = [format.fields, &[AT]].concat();
            let fields = TomlFields::new(table, 0..0, &known, sink);
            let scene = (format.read)(&fields, &mut { format.room })?;
            let start = Some((Moment::Start, 0));
            let stop = fields.get(AT).map_or(start, |at| stop(&scene, at));
            let (moment, position) = stop?;
            Some(SceneFile {
                scene,
                position,
                moment,
            })
        });
        match read {
            Some(read) if sink.n_errors() == 0 => Ok(read),
            _ => Err(sink.into_problems()),
        }
    }

    /// Writes a scene so that [`SceneFormats::read`] reads the very same one, bit for bit, and finds the same moment.
    pub fn write(self, scene: &Scene, at: &Moment) -> String {
        let format = self.of(scene.document().lab().id);
        let written = format.and_then(|format| (format.write)(scene));
        let mut text = written.unwrap_or_default();
        match at {
            Moment::Start => {}
            Moment::End | Moment::Event { .. } => {
                let _ = writeln!(text, "{AT} = {:?}", at.to_string());
            }
        }
        text
    }

    /// The one that a scene file is for: that of its method's lab, or of a field that only one lab has.
    fn of_table(self, table: &DeTable<'_>) -> Option<&'static SceneFormat> {
        let method = table.get("method").and_then(|item| item.get_ref().as_str());
        let formats = || self.0.iter().copied();
        let has_method = |format: &&'static SceneFormat| {
            let methods = (format.lab.methods)();
            methods.iter().any(|card| Some(card.id) == method)
        };
        formats()
            .find(has_method)
            .or_else(|| formats().find(|format| table.contains_key(format.own_field)))
            .or_else(|| formats().next())
    }
}

fn stop(scene: &Scene, at: Node<'_>) -> Option<(Moment, usize)> {
    let moment = moment(at)?;
    let position = at.accept(moment_in(scene, &moment))?;
    Some((moment, position))
}
