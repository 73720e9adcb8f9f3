//! What lies over the window: the list of keys, the question where to save, messages.

/// A dialog that is open.
#[derive(Clone, PartialEq, Debug)]
pub enum Dialog {
    /// The list of keys.
    Help,
    /// Where to save the scene.
    Save(Target),
    /// Where to export the figure.
    Export(Target),
}

/// A file to be written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Target {
    /// As it is being typed.
    pub path: String,
    /// Another file stands there: it is replaced when the reader says so again.
    pub replaces: bool,
}

impl Target {
    /// A file that has not been asked about.
    #[must_use]
    pub const fn new(path: String) -> Self {
        Self {
            path,
            replaces: false,
        }
    }
}
