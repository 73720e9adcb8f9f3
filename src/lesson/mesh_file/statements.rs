//! Lines and words of OBJ and MTL files, and the one thing that is asked of an MTL file.

use std::ops::Range;

pub(super) struct Statement<'t> {
    text: &'t str,
    words: Vec<Range<usize>>,
}

impl<'t> Statement<'t> {
    pub fn keyword(&self) -> &'t str {
        self.words
            .first()
            .map_or("", |span| &self.text[span.clone()])
    }

    /// Where the keyword stands.
    pub fn span(&self) -> Range<usize> {
        self.words.first().cloned().unwrap_or_default()
    }

    pub fn values(&self) -> impl ExactSizeIterator<Item = (&'t str, Range<usize>)> + '_ {
        let values = self.words.iter().skip(1);
        values.map(|span| (&self.text[span.clone()], span.clone()))
    }

    /// Everything after the keyword: a file's name may hold spaces.
    pub fn rest(&self) -> Option<&'t str> {
        let (first, last) = (self.words.get(1)?, self.words.last()?);
        Some(&self.text[first.start..last.end])
    }
}

/// The statements of a text, in order; one that ends in a backslash goes on in the next line. Without comments.
pub(super) fn statements(text: &str) -> impl Iterator<Item = Statement<'_>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let mut words = Vec::new();
        while at < text.len() {
            let end = text[at..].find('\n').map_or(text.len(), |i| at + i);
            let line = &text[at..end];
            let line = line.split('#').next().unwrap_or_default();
            words.extend(line.split_ascii_whitespace().map(|word| {
                // Its place follows from where it lies in memory.
                let start = word.as_ptr() as usize - text.as_ptr() as usize;
                start..start + word.len()
            }));
            at = end + 1;
            let goes_on = words
                .last()
                .is_some_and(|span: &Range<usize>| &text[span.clone()] == "\\");
            if goes_on {
                words.pop();
            } else if !words.is_empty() {
                break;
            }
        }
        (!words.is_empty()).then_some(Statement { text, words })
    })
}

/// The picture that a material of an MTL file is painted with, by its file's name, if it has one; `None` where there is no such
/// material.
pub fn read_mtl(bytes: &[u8], material: &str) -> Option<Option<String>> {
    let text = String::from_utf8_lossy(bytes);
    let mut is_wanted = false;
    let mut found = None;
    for statement in statements(&text) {
        match statement.keyword() {
            "newmtl" => {
                is_wanted = statement.rest() == Some(material);
                if is_wanted {
                    found.get_or_insert(None);
                }
            }
            "map_Kd" if is_wanted => found = Some(statement.rest().map(str::to_owned)),
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_continuations_and_windows_line_ends() {
        let text = "# a mesh\r\nv 1 2 3 # here\r\n\r\nf 1 \\\n 2 3\nmap_Kd my texture.png\r\n";
        let read: Vec<(&str, Vec<&str>)> = statements(text)
            .map(|s| (s.keyword(), s.values().map(|(word, _)| word).collect()))
            .collect();
        assert_eq!(
            read,
            [
                ("v", vec!["1", "2", "3"]),
                ("f", vec!["1", "2", "3"]),
                ("map_Kd", vec!["my", "texture.png"])
            ]
        );
        let last = statements(text).last().unwrap();
        assert_eq!(last.rest(), Some("my texture.png"));
    }
}
