//! What is wrong, for people: every typed error becomes a [`Diagnostic`], and nothing else of it is shown.

use std::{fmt, io};

use crate::geom::{Axis, GeomError, MeshError, SpaceError};

use super::{Catalog, Lang, Message, Value};

/// What is wrong, in every language. `Display` is the English sentence, for logs.
#[derive(Clone, PartialEq, Debug)]
pub struct Diagnostic {
    /// A stable name for this kind of mistake: `empty-window`. Where the command line's JSON has one, it is that.
    pub code: &'static str,
    pub message: Message,
    pub notes: Vec<Message>,
}

impl Diagnostic {
    pub fn new(message: Message) -> Self {
        let key = message.key;
        let code = ["error-", "problem-", "case-", "system-"]
            .iter()
            .find_map(|area| key.strip_prefix(area))
            .unwrap_or(key);
        Self {
            code,
            message,
            notes: Vec::new(),
        }
    }

    pub const fn coded(mut self, code: &'static str) -> Self {
        self.code = code;
        self
    }

    pub fn noting(mut self, note: Message) -> Self {
        self.notes.push(note);
        self
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&Catalog::of(Lang::En).message(&self.message))
    }
}

impl From<Message> for Diagnostic {
    fn from(message: Message) -> Self {
        Self::new(message)
    }
}

/// As the reason in another sentence.
impl From<Diagnostic> for Value {
    fn from(diagnostic: Diagnostic) -> Self {
        Self::Message(diagnostic.message)
    }
}

fn empty(key: &'static str, axis: &str, [min, max]: [f64; 2]) -> Message {
    Message::new(key)
        .with("low", format!("{axis}min"))
        .with("min", min)
        .with("high", format!("{axis}max"))
        .with("max", max)
}

impl From<GeomError> for Diagnostic {
    fn from(error: GeomError) -> Self {
        let message = match error {
            GeomError::NotFinite { .. } => Message::new("error-not-finite"),
            GeomError::EmptyWindow { axis, min, max } => {
                let axis = match axis {
                    Axis::X => "x",
                    Axis::Y => "y",
                };
                empty("error-empty-window", axis, [min, max])
            }
            GeomError::TooFewVertices => Message::new("error-too-few-vertices"),
            GeomError::Degenerate { .. } => Message::new("error-degenerate"),
            GeomError::NotConvex { .. } => Message::new("error-not-convex"),
            GeomError::SelfIntersecting { .. } => Message::new("error-self-intersecting"),
            GeomError::EdgesMeet { edges: [i, j] } => Message::new("error-edges-meet")
                .with("first", i)
                .with("second", j),
            GeomError::MisplacedHole { hole_idx } => {
                Message::new("error-misplaced-hole").with("hole", hole_idx)
            }
        };
        Self::new(message).coded(error.code())
    }
}

impl From<SpaceError> for Diagnostic {
    fn from(error: SpaceError) -> Self {
        let message = match error {
            SpaceError::NotFinite { .. } => Message::new("error-not-finite"),
            SpaceError::EmptyBox { axis, min, max } => {
                let axis = ["x", "y", "z"].get(axis).copied().unwrap_or_default();
                empty("error-empty-box", axis, [min, max])
            }
            SpaceError::ZeroNormal => Message::new("error-zero-normal"),
            SpaceError::NegativeRadius(radius) => {
                Message::new("error-negative-radius").with("radius", radius)
            }
            SpaceError::NoVertices => Message::new("error-no-vertices"),
            SpaceError::TargetAtPosition => Message::new("error-target-at-position"),
            SpaceError::UpAlongView => Message::new("error-up-along-view"),
            SpaceError::FieldOfView(degrees) => {
                Message::new("error-field-of-view").with("degrees", degrees)
            }
            SpaceError::Size(size) => Message::new("error-size").with("size", size),
            SpaceError::Height(height) => Message::new("error-height").with("height", height),
            SpaceError::Aspect(aspect) => Message::new("error-aspect").with("aspect", aspect),
            SpaceError::Near(near) => Message::new("error-near").with("near", near),
            SpaceError::Far { near, far } => Message::new("error-far")
                .with("near", near)
                .with("far", far),
            SpaceError::NotAffine => Message::new("error-not-affine"),
        };
        Self::new(message).coded(error.code())
    }
}

impl From<MeshError> for Diagnostic {
    fn from(error: MeshError) -> Self {
        let message = match error {
            MeshError::NotFinite { .. } => Message::new("error-not-finite"),
            MeshError::NoSuchVertex { face_idx } => {
                Message::new("error-face-vertex").with("face", face_idx)
            }
            MeshError::NoFaces => Message::new("error-no-mesh-faces"),
            MeshError::UvLength { n_uvs, n_vertices } => Message::new("error-uv-length")
                .with("uvs", n_uvs)
                .with("vertices", n_vertices),
        };
        Self::new(message).coded(error.code())
    }
}

/// What the system answers where a file cannot be read or written: its kind, and its number where it has one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SystemError {
    kind: io::ErrorKind,
    number: Option<i32>,
}

impl SystemError {
    pub const fn of_kind(kind: io::ErrorKind) -> Self {
        Self { kind, number: None }
    }

    pub const fn kind(&self) -> io::ErrorKind {
        self.kind
    }
}

/// ELOOP: what a link that leads to itself is answered by.
const TOO_MANY_LINKS: i32 = if cfg!(target_os = "linux") { 40 } else { 62 };

impl From<io::Error> for SystemError {
    fn from(error: io::Error) -> Self {
        Self {
            kind: error.kind(),
            number: error.raw_os_error(),
        }
    }
}

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
            _ if error.number == Some(TOO_MANY_LINKS) => "system-loop",
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
