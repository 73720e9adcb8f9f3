//! How a lab's scenes are spelt, whichever lab it is.

use std::fmt::Write as _;

use toml::de::DeTable;

use crate::{
    figure::Moment,
    labs::{Lab, Scene},
    lesson::{
        problem::Problem,
        sink::Sink,
        source::Source,
        step::{moment, never_comes},
        toml_errors::with_toml,
        toml_fields::{Item, TomlFields},
    },
};

/// Where a scene's run stands.
const AT: &str = "at";

/// What is in a scene file.
#[derive(Clone, PartialEq, Debug)]
pub struct SceneFile {
    /// The scene.
    pub scene: Scene,
    /// The step at which its run stands.
    pub position: usize,
}

/// The spelling of one lab's scenes.
pub(crate) trait SceneFormat: Sync {
    /// The lab.
    fn lab(&self) -> &'static dyn Lab;
    /// The fields of a scene.
    fn fields(&self) -> &'static [&'static str];
    /// The field that tells its scenes from all other labs', where the method does not.
    fn own_field(&self) -> &'static str;
    /// How much, in segments or vertices, all scenes of one file may hold.
    fn room(&self) -> usize;
    /// Reads a scene, reporting all its mistakes; takes its size from `room`.
    fn read(&self, fields: &TomlFields<'_>, room: &mut usize, sink: &mut Sink<'_>)
    -> Option<Scene>;
    /// Writes a scene, if it is this lab's.
    fn write(&self, scene: &Scene) -> Option<String>;
}

/// The spellings of all labs that there are.
#[derive(Clone, Copy)]
pub struct SceneFormats(&'static [&'static dyn SceneFormat]);

impl SceneFormats {
    /// These, in the order of their labs.
    pub(crate) const fn new(formats: &'static [&'static dyn SceneFormat]) -> Self {
        Self(formats)
    }

    /// The ids of their labs.
    pub(crate) fn lab_ids(self) -> Vec<&'static str> {
        self.0.iter().map(|format| format.lab().id()).collect()
    }

    /// That of the lab with this id.
    pub(crate) fn of(self, lab_id: &str) -> Option<&'static dyn SceneFormat> {
        let mut formats = self.0.iter().copied();
        formats.find(|format| format.lab().id() == lab_id)
    }

    /// Reads a scene file: one scene's fields at the top level, as [`SceneFormats::write`] writes them.
    ///
    /// # Errors
    /// Every mistake in it, from the top to the end; `file` is how they name it.
    pub fn read(self, file: &str, bytes: &[u8]) -> Result<SceneFile, Vec<Problem>> {
        let source = Source::new(file.to_owned(), bytes);
        let mut sink = Sink::new(&source);
        let read = with_toml(&mut sink, |table, sink| {
            let format = self.of_table(table)?;
            let known = [format.fields(), &[AT]].concat();
            let fields = TomlFields::of_file(table, &known, sink);
            let scene = format.read(&fields, &mut format.room(), sink)?;
            let position = fields
                .get(AT)
                .map_or(Some(0), |at| position(&scene, at, sink))?;
            Some(SceneFile { scene, position })
        });
        match read {
            Some(read) if sink.n_errors() == 0 => Ok(read),
            _ => Err(sink.into_problems()),
        }
    }

    /// Writes a scene so that [`SceneFormats::read`] reads the very same one, bit for bit, and finds the same moment.
    pub fn write(self, scene: &Scene, at: &Moment) -> String {
        let written = self.0.iter().find_map(|format| format.write(scene));
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
    fn of_table(self, table: &DeTable<'_>) -> Option<&'static dyn SceneFormat> {
        let method = table.get("method").and_then(|item| item.get_ref().as_str());
        let formats = || self.0.iter().copied();
        let has_method = |format: &&'static dyn SceneFormat| {
            let methods = format.lab().methods();
            methods.iter().any(|card| Some(card.id) == method)
        };
        formats()
            .find(has_method)
            .or_else(|| formats().find(|format| table.contains_key(format.own_field())))
            .or_else(|| formats().next())
    }
}

/// The step of a scene's run that a file names.
fn position(scene: &Scene, at: &Item<'_>, sink: &mut Sink<'_>) -> Option<usize> {
    let moment = moment(at, sink)?;
    let runs = scene.document().record();
    let run = runs.first()?;
    let found = run.find(&moment);
    if found.is_none() {
        sink.refuse(at.span(), never_comes(&moment, &**run), []);
    }
    found
}
