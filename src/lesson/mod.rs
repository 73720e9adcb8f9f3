//! Lessons: a folder each, with the scenes and steps in `lesson.toml` and the text of the steps in one
//! Markdown file a language. Here they are read, checked and resolved to places in recorded runs.
//!
//! ```text
//! Files ──► Source ──► TomlFields ──► scenes, steps ─────┐
//! (bytes)   (UTF-8)    markdown::parse ──► texts ────────┴──► Course
//!              └────────────┴── mistakes ──► Sink ──► Vec<Problem>
//! ```
//!
//! A mistake never stops the reading: every mistake of every file is a [`Problem`] with its place, and a
//! lesson with one is left out while the others stay. Nothing here knows of a file system but `folder.rs`.

mod asking;
mod card;
mod course;
#[cfg(not(target_arch = "wasm32"))]
mod door;
mod draft;
mod files;
#[cfg(not(target_arch = "wasm32"))]
mod folder;
mod glossary;
mod grips;
mod lesson_file;
mod likeness;
mod link;
mod load;
mod markdown;
mod mentions;
mod mesh_file;
mod names;
mod packed;
mod prelude;
mod problem;
mod progress;
mod reference;
mod scene_file;
mod sections;
mod setting;
mod sink;
mod source;
mod step;
mod stop;
#[cfg(test)]
pub(crate) mod tests;
mod toml_errors;
mod toml_fields;
mod translated;
mod translation;

pub use asking::{Asks, Goal, in_words};
pub use card::{Card, CardRow};
pub use course::{Course, Lesson};
#[cfg(not(target_arch = "wasm32"))]
pub use door::{ask, read_file, read_file_while};
pub use draft::{Draft, NewStep};
pub use files::{Embedded, FileError, Files, MAX_FILE_BYTES, MAX_LESSONS, MAX_SCENE_BYTES};
#[cfg(not(target_arch = "wasm32"))]
pub use folder::Folder;
pub use glossary::{Glossary, Word, glossary};
pub use link::{
    LONG_LINK, Link, LinkError, MOST_LINK, Opened, Opens, Stand, StepName, is_picture,
    link_element, link_in, said, with_link,
};
pub use load::Loaded;
pub use markdown::{Block, BlockMarker, Inline, StepText};
pub use mesh_file::{
    ObjFile, PictureFault, picture_of, read_mtl, read_obj, read_obj_while, read_picture,
};
pub use packed::{PACKED_FILE, packed, unpacked};
pub use problem::{Place, Problem, Severity};
pub use progress::{MAX_PROGRESS_BYTES, Mark, Progress, Tally, Told};
#[cfg(all(test, feature = "gui"))]
pub(crate) use scene_file::SceneFormat;
pub use scene_file::{SceneFile, SceneFormats, exact, quoted, spot};
pub use spot::{has_stand_in, without_stand_in};
pub use step::{CodeView, LessonStep};
pub use stop::Stop;
pub use translated::{TRANSLATED_FILE, translated};
