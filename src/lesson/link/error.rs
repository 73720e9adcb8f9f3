//! What can be wrong with a link.

use crate::text::{Diagnostic, Message};

#[derive(Clone, PartialEq, Eq, Debug)]
pub enum LinkError {
    /// It names neither a step nor a scene.
    Nothing,
    /// It was made by another version than this one reads.
    Version(String),
    /// What it holds cannot be unpacked: it was cut, say.
    Damaged,
    TooLarge,
    /// One of its values means nothing.
    Value {
        key: &'static str,
        value: String,
    },
}

impl From<LinkError> for Diagnostic {
    fn from(error: LinkError) -> Self {
        let message = match error {
            LinkError::Nothing => {
                let expected = Message::new("expect-link");
                return Self::new(Message::new("problem-no-link")).noting(expected);
            }
            LinkError::Version(version) => {
                Message::new("problem-link-version").with("version", version)
            }
            LinkError::Damaged => Message::new("problem-link-damaged"),
            LinkError::TooLarge => Message::new("problem-link-too-large"),
            LinkError::Value { key, value } => {
                let message = Message::new("problem-link-value").with("key", key.to_owned());
                message.with("value", value)
            }
        };
        Self::new(message)
    }
}
