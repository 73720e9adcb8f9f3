//! The lessons that are compiled in.

use include_dir::{Dir, DirEntry, include_dir};

use super::files::{FileError, Files};

/// The course that is compiled in.
#[derive(Clone, Copy, Debug, Default)]
pub struct Embedded;

static LESSONS: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/lessons");

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
        Ok(paths)
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        let file = LESSONS.get_file(path).ok_or(FileError::NOT_FOUND)?;
        Ok(file.contents().to_vec())
    }

    fn shown(&self, path: &str) -> String {
        format!("lessons/{path}")
    }
}
