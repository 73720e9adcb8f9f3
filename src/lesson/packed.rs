//! A course in one file, for whoever has no folder: a page fetches it from beside itself, or from wherever allows it.
//!
//! ```json
//! {"clipscope-course": 1, "files": {"01-a/lesson.toml": "…", "01-a/wood.png": {"base64": "…"}}}
//! ```

use std::{cell::RefCell, collections::BTreeMap};

use base64::{Engine, prelude::BASE64_STANDARD as BASE64};
use serde::{Deserialize, Serialize};

use super::{
    course::Course,
    files::{FileError, Files},
    load::Loaded,
};
use crate::text::{Diagnostic, Message};

/// Its name beside the lessons.
pub const PACKED_FILE: &str = "course.json";
const VERSION: u32 = 1;

#[derive(Serialize, Deserialize)]
struct Packed {
    #[serde(rename = "clipscope-course")]
    version: u32,
    files: BTreeMap<String, Content>,
}

#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Content {
    Text(String),
    Bytes { base64: String },
}

/// Files, and what has been read of them.
struct Noted<'a> {
    files: &'a dyn Files,
    read: RefCell<BTreeMap<String, Content>>,
}

impl Files for Noted<'_> {
    fn list(&self) -> Result<Vec<String>, FileError> {
        self.files.list()
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        let bytes = self.files.read(path)?;
        let content = match String::from_utf8(bytes.clone()) {
            Ok(text) => Content::Text(text),
            Err(_) => Content::Bytes {
                base64: BASE64.encode(&bytes),
            },
        };
        self.read.borrow_mut().insert(path.to_owned(), content);
        Ok(bytes)
    }

    fn shown(&self, path: &str) -> String {
        self.files.shown(path)
    }
}

/// The course in these files as one file, with nothing that its lessons do not need; and what was found of it on the way.
pub fn packed(files: &dyn Files) -> (String, Loaded) {
    let noted = Noted {
        files,
        read: RefCell::default(),
    };
    let loaded = Course::check(&noted);
    let packed = Packed {
        version: VERSION,
        files: noted.read.into_inner(),
    };
    let text = serde_json::to_string(&packed).unwrap_or_default();
    (text, loaded)
}

/// The files that were packed.
///
/// # Errors
/// Where this is no packed course, or one of a later version.
pub fn unpacked(bytes: &[u8]) -> Result<BTreeMap<String, Vec<u8>>, Diagnostic> {
    let unfit = |reason: String| Message::new("problem-course-file").with("reason", reason);
    let read = serde_json::from_slice::<Packed>(bytes);
    let packed = read.map_err(|error| unfit(error.to_string()))?;
    if packed.version != VERSION {
        let version = packed.version.to_string();
        return Err(Message::new("problem-course-version")
            .with("version", version)
            .into());
    }
    let bytes = |(path, content)| {
        let bytes = match content {
            Content::Text(text) => Ok(text.into_bytes()),
            Content::Bytes { base64 } => BASE64.decode(base64),
        };
        let bytes = bytes.map_err(|error| unfit(format!("{path}: {error}")))?;
        Ok((path, bytes))
    };
    packed.files.into_iter().map(bytes).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::Embedded;

    #[test]
    fn a_packed_course_is_the_course() {
        let (text, loaded) = packed(&Embedded);
        assert_eq!(loaded.problems, []);
        let files = unpacked(text.as_bytes()).expect("as it was packed");
        let again = Course::check(&files);
        assert_eq!(again.course, loaded.course);
        assert_eq!(again.problems, []);
    }

    #[test]
    fn what_is_no_course_is_told() {
        for (text, code) in [
            ("", "problem-course-file"),
            ("[1]", "problem-course-file"),
            (r#"{"files": {}}"#, "problem-course-file"),
            (
                r#"{"clipscope-course": 2, "files": {}}"#,
                "problem-course-version",
            ),
            (
                r#"{"clipscope-course": 1, "files": {"a": {"base64": "?"}}}"#,
                "problem-course-file",
            ),
        ] {
            let told = unpacked(text.as_bytes()).expect_err("it is none");
            assert_eq!(told.message.key, code, "{text}");
        }
    }
}
