//! What the page fetches from beside itself when it is first needed (feature `slim`); elsewhere all of it is compiled in.

use std::sync::OnceLock;

use miniz_oxide::inflate::decompress_to_vec_with_limit;

use super::lang::Lang;

/// A part of the program that lies beside the page, in a file of its own.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Part {
    /// The messages, the glossary and the course's texts in a language.
    Texts(Lang),
    /// The mesh that is shipped, and its picture.
    Spot,
}

type File = (String, Vec<u8>);

/// What has come of each part.
static COME: [OnceLock<Vec<File>>; Part::ALL.len()] = [const { OnceLock::new() }; Part::ALL.len()];

impl Part {
    pub const ALL: [Self; 4] = [
        Self::Texts(Lang::ZhCn),
        Self::Texts(Lang::Es),
        Self::Texts(Lang::PtBr),
        Self::Spot,
    ];

    /// Its name beside the page.
    pub const fn file(self) -> &'static str {
        match self {
            Self::Texts(Lang::En) => "texts-en.bin",
            Self::Texts(Lang::ZhCn) => "texts-zh-CN.bin",
            Self::Texts(Lang::Es) => "texts-es.bin",
            Self::Texts(Lang::PtBr) => "texts-pt-BR.bin",
            Self::Spot => "spot.bin",
        }
    }

    /// What of it has come.
    fn come(self) -> Option<&'static Vec<File>> {
        let nth = Self::ALL.iter().position(|part| *part == self)?;
        COME[nth].get()
    }

    /// Can it be used?
    pub fn is_here(self) -> bool {
        cfg!(not(feature = "slim")) || self == Self::Texts(Lang::En) || self.come().is_some()
    }

    pub fn files(self) -> impl Iterator<Item = (&'static str, &'static [u8])> {
        let files = self.come().map_or(&[][..], Vec::as_slice);
        files.iter().map(|(name, bytes)| (&**name, &**bytes))
    }

    pub fn get(self, name: &str) -> Option<&'static [u8]> {
        self.files()
            .find(|(its, _)| *its == name)
            .map(|(_, bytes)| bytes)
    }

    /// From now on it is there; was this its file?
    pub fn take_up(self, bytes: &[u8]) -> bool {
        let nth = Self::ALL.iter().position(|part| *part == self);
        let Some((nth, files)) = nth.zip(read(bytes)) else {
            return false;
        };
        COME[nth].get_or_init(|| files);
        true
    }
}

/// More is not unpacked.
const MOST_BYTES: usize = 8 << 20;

/// Files one after the other, each after a line with its name, a space and its length; gzipped, unless that has been undone on the way.
fn read(bytes: &[u8]) -> Option<Vec<File>> {
    // Without a name or anything else that is optional, what stands around what is deflated has these lengths.
    let deflated = bytes.strip_prefix(b"\x1f\x8b\x08\x00");
    let deflated = deflated.and_then(|rest| rest.get(6..rest.len().checked_sub(8)?));
    let unpacked = match deflated {
        Some(deflated) => &decompress_to_vec_with_limit(deflated, MOST_BYTES).ok()?,
        None => bytes,
    };
    let (mut rest, mut files) = (unpacked, Vec::new());
    while !rest.is_empty() {
        let end = rest.iter().position(|byte| *byte == b'\n')?;
        let line = str::from_utf8(&rest[..end]).ok()?;
        let (name, length) = line.rsplit_once(' ')?;
        let (file, after) = rest[end + 1..].split_at_checked(length.parse().ok()?)?;
        files.push((name.to_owned(), file.to_vec()));
        rest = after;
    }
    Some(files)
}

#[cfg(test)]
mod tests {
    use miniz_oxide::deflate::compress_to_vec;

    use super::*;

    #[test]
    fn a_part_is_read_gzipped_or_not_and_nothing_else_is() {
        let plain = b"app.ftl 4\na =\n01-a/es.md 0\nb 2\n\n\n";
        let files = ["app.ftl", "01-a/es.md", "b"].into_iter();
        let files = files.zip([&b"a =\n"[..], b"", b"\n\n"]);
        let files: Vec<File> = files
            .map(|(name, it)| (name.to_owned(), it.to_vec()))
            .collect();
        assert_eq!(read(plain), Some(files.clone()));
        let mut gzipped = b"\x1f\x8b\x08\x00\0\0\0\0\x02\x03".to_vec();
        gzipped.extend(compress_to_vec(plain, 9));
        gzipped.extend([0; 8]);
        assert_eq!(read(&gzipped), Some(files));
        assert_eq!(read(&gzipped[..gzipped.len() - 12]), None, "cut");
        assert_eq!(read(&plain[..plain.len() - 1]), None, "cut");
        for other in [
            &b"<!doctype html>"[..],
            b"\x1f\x8b\x08\x00",
            b"a -1\n",
            b"a 1",
        ] {
            assert_eq!(read(other), None, "{other:?}");
        }
        assert!(
            Part::ALL
                .iter()
                .all(|part| part.is_here() != cfg!(feature = "slim"))
        );
    }
}
