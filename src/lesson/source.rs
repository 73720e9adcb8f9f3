//! A text file and the places in it.

use std::{borrow::Cow, cell::RefCell, collections::BTreeMap, ops::Range, sync::Arc};

use crate::labs::space::{NamedMesh, Picture};

use super::{
    files::{FileError, Files},
    problem::Place,
};

/// Of a longer line, only what surrounds the place is kept.
const MAX_LINE_CHARS: usize = 120;
const LEAD_CHARS: usize = 50;

pub(crate) struct Source<'a> {
    pub file: String,
    /// Without a byte order mark.
    pub text: Cow<'a, str>,
    /// Where the file stopped being UTF-8, and the byte that stands there.
    pub bad_byte: Option<(usize, u8)>,
    /// Where files beside it come from, and their folder; none of a file that stands alone.
    pub folder: Option<(&'a dyn Files, &'a str)>,
    pub beside: Beside,
}

/// What has been read of the files beside one, each once, whoever names it.
#[derive(Default)]
pub(crate) struct Beside {
    /// By their names; `None` where there is a mistake, which has been told.
    pub meshes: RefCell<BTreeMap<String, Option<Arc<NamedMesh>>>>,
    pub pictures: RefCell<BTreeMap<String, Picture>>,
}

impl Beside {
    pub fn n_texels(&self) -> usize {
        let pictures = self.pictures.borrow();
        let sizes = pictures.values().map(|it| it.texture().size());
        sizes.map(|[width, height]| width * height).sum()
    }
}

impl<'a> Source<'a> {
    /// Text that is not UTF-8 is read as far as it goes, for the place to be shown.
    pub fn new(file: String, bytes: &'a [u8]) -> Self {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let bad_byte = std::str::from_utf8(bytes)
            .err()
            .map(|error| (error.valid_up_to(), bytes[error.valid_up_to()]));
        Self {
            file,
            text: String::from_utf8_lossy(bytes),
            bad_byte,
            folder: None,
            beside: Beside::default(),
        }
    }

    /// A file beside it, as a person knows it, and what it holds; `None` where there is no such folder.
    pub fn beside(&self, name: &str) -> Option<(String, Result<Vec<u8>, FileError>)> {
        let (files, folder) = self.folder?;
        let path = format!("{folder}/{name}");
        Some((files.shown(&path), files.read(&path)))
    }

    /// The place of these bytes of the text; what lies past the end of the first line is not shown.
    pub fn place(&self, span: Range<usize>) -> Place {
        let text = &*self.text;
        let start = text.floor_char_boundary(span.start);
        let end = text.ceil_char_boundary(span.end).max(start);
        let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let full = text[line_start..line_end].trim_end_matches('\r');
        let before = text[line_start..start].chars().count();
        let meant = text[start..end.min(line_end)].trim_end();
        let length = meant.chars().count().max(1);
        let (source_line, caret) = excerpt(full, before);
        Place {
            line: text[..line_start].matches('\n').count() + 1,
            column: before + 1,
            source_line,
            caret,
            length,
        }
    }

    pub fn line(&self, at: usize) -> usize {
        let at = self.text.floor_char_boundary(at);
        self.text[..at].matches('\n').count() + 1
    }
}

/// The line, or what surrounds its character `at`, and the index of that character in it.
fn excerpt(line: &str, at: usize) -> (String, usize) {
    if line.chars().nth(MAX_LINE_CHARS).is_none() {
        return (line.to_owned(), at);
    }
    let first = at.saturating_sub(LEAD_CHARS);
    let mut shown: String = line.chars().skip(first).take(MAX_LINE_CHARS).collect();
    if line.chars().nth(first + MAX_LINE_CHARS).is_some() {
        shown.push('…');
    }
    if first == 0 {
        return (shown, at);
    }
    shown.insert(0, '…');
    (shown, at - first + 1)
}
