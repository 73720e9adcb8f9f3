//! What the system answers where a file cannot be read or written, in the reader's language.

use std::io;

use super::{Diagnostic, Message};

/// An answer of the system: its kind, and its number where it has one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SystemError {
    kind: io::ErrorKind,
    number: Option<i32>,
}

impl SystemError {
    /// Of this kind, without a number.
    pub const fn of_kind(kind: io::ErrorKind) -> Self {
        Self { kind, number: None }
    }
}

impl From<io::Error> for SystemError {
    fn from(error: io::Error) -> Self {
        Self {
            kind: error.kind(),
            number: error.raw_os_error(),
        }
    }
}

/// Part of a sentence: the reason why something could not be done.
impl From<SystemError> for Diagnostic {
    fn from(error: SystemError) -> Self {
        use io::ErrorKind as Kind;
        let key = match error.kind {
            Kind::NotFound => "system-not-found",
            Kind::PermissionDenied => "system-denied",
            Kind::AlreadyExists => "system-exists",
            Kind::IsADirectory => "system-is-folder",
            Kind::InvalidInput => "system-not-file",
            Kind::NotADirectory => "system-not-folder",
            Kind::StorageFull | Kind::QuotaExceeded => "system-full",
            Kind::ReadOnlyFilesystem => "system-read-only",
            Kind::InvalidFilename => "system-bad-name",
            Kind::FileTooLarge => "system-too-large",
            Kind::ResourceBusy | Kind::ExecutableFileBusy => "system-busy",
            Kind::Unsupported => "system-no-files",
            // The kinds are an open list.
            _ => match error.number {
                Some(number) => {
                    let message = Message::new("system-number");
                    return Self::new(message.with("number", number.to_string()));
                }
                None => "system-silent",
            },
        };
        Self::new(Message::new(key))
    }
}

impl From<io::Error> for Diagnostic {
    fn from(error: io::Error) -> Self {
        SystemError::from(error).into()
    }
}
