//! What a file says of its drawing.

/// What stands in the file beside what is drawn.
#[derive(Clone, Copy, Default)]
pub struct About<'a> {
    pub title: &'a str,
    pub alternative: &'a str,
    pub lang: &'a str,
    pub link: Option<&'a str>,
}
