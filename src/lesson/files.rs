//! Where lesson files come from: a map in memory is such a place, and what is compiled in.

use std::{collections::BTreeMap, io};

use include_dir::{Dir, DirEntry, include_dir};

use crate::text::{Diagnostic, Lang, Message, Part, SystemError};

/// A larger file is refused: no lesson is that long, so it is something else.
pub const MAX_FILE_BYTES: usize = 4 << 20;

/// The most bytes of a scene, a mesh or a picture: what a larger one holds could not be drawn in time.
pub const MAX_SCENE_BYTES: u64 = 128 << 20;

/// More lessons than this in one folder are left out.
pub const MAX_LESSONS: usize = 1_000;

/// What makes a folder a lesson.
pub(super) const LESSON_FILE: &str = "lesson.toml";

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FileError {
    /// In bytes.
    TooLarge {
        limit: u64,
    },
    /// A link, to another folder.
    LeadsOut,
    Unreadable(SystemError),
}

impl From<FileError> for Diagnostic {
    fn from(error: FileError) -> Self {
        Self::new(match error {
            FileError::TooLarge { limit } => {
                Message::new("error-file-too-large").with("limit", (limit >> 20) as usize)
            }
            FileError::LeadsOut => Message::new("error-link-out"),
            FileError::Unreadable(reason) => {
                Message::new("error-unreadable").with("reason", Self::from(reason))
            }
        })
    }
}

impl From<io::Error> for FileError {
    fn from(error: io::Error) -> Self {
        Self::Unreadable(error.into())
    }
}

/// A set of files. Paths are relative and use `/`.
pub trait Files {
    // The paths of all files that could belong to a lesson, `01-name/lesson.toml`, in any order.
    fn list(&self) -> Result<Vec<String>, FileError>;

    fn read(&self, path: &str) -> Result<Vec<u8>, FileError>;

    /// The path by which a person knows a file; the path of the whole for `""`.
    fn shown(&self, path: &str) -> String {
        path.to_owned()
    }

    /// These files, where they are part of the program.
    fn compiled_in(&self) -> Option<Embedded> {
        None
    }
}

impl Files for BTreeMap<String, Vec<u8>> {
    fn list(&self) -> Result<Vec<String>, FileError> {
        Ok(self.keys().cloned().collect())
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        let bytes = self.get(path).ok_or(FileError::NOT_FOUND)?;
        if bytes.len() > MAX_FILE_BYTES {
            let limit = MAX_FILE_BYTES as u64;
            return Err(FileError::TooLarge { limit });
        }
        Ok(bytes.clone())
    }
}

impl FileError {
    pub(crate) const NOT_FOUND: Self =
        Self::Unreadable(SystemError::of_kind(io::ErrorKind::NotFound));
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Embedded;

#[cfg(not(feature = "slim"))]
static LESSONS: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/lessons");
/// Without what is fetched: `build.rs` puts it there.
#[cfg(feature = "slim")]
static LESSONS: Dir<'static> = include_dir!("$OUT_DIR/lessons");

/// Texts of the course that have been fetched, by their paths.
fn fetched() -> impl Iterator<Item = (&'static str, &'static [u8])> {
    let all = Lang::ALL.into_iter();
    let files = all.flat_map(|lang| Part::Texts(lang).files());
    files.filter(|(path, _)| path.contains('/'))
}

impl Files for Embedded {
    fn list(&self) -> Result<Vec<String>, FileError> {
        fn walk(dir: &Dir<'_>, paths: &mut Vec<String>) {
            for entry in dir.entries() {
                match entry {
                    DirEntry::Dir(dir) => walk(dir, paths),
                    DirEntry::File(file) => paths.push(file.path().to_string_lossy().into_owned()),
                }
            }
        }
        let mut paths = Vec::new();
        walk(&LESSONS, &mut paths);
        paths.extend(fetched().map(|(path, _)| path.to_owned()));
        Ok(paths)
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        let file = LESSONS.get_file(path).map(include_dir::File::contents);
        let come = || {
            fetched()
                .find(|(its, _)| *its == path)
                .map(|(_, bytes)| bytes)
        };
        let bytes = file.or_else(come).ok_or(FileError::NOT_FOUND)?;
        Ok(bytes.to_vec())
    }

    fn shown(&self, path: &str) -> String {
        format!("lessons/{path}")
    }

    fn compiled_in(&self) -> Option<Embedded> {
        Some(*self)
    }
}
