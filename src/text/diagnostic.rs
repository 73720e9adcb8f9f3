//! What is wrong, for people: every typed error becomes a [`Diagnostic`], and nothing else of it is shown.

use std::fmt;

use crate::geom::{Axis, GeomError, MeshError, SpaceError};

use super::{Catalog, Lang, Message, Value};

/// What is wrong, in every language. `Display` is the English sentence, for logs.
#[derive(Clone, PartialEq, Debug)]
pub struct Diagnostic {
    /// A stable name for this kind of mistake: `empty-window`. Where the command line's JSON has one, it is that.
    pub code: &'static str,
    /// What is wrong.
    pub message: Message,
    /// What was expected, and what may have been meant.
    pub notes: Vec<Message>,
}

impl Diagnostic {
    /// This sentence, and the code that its key ends in.
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

    /// The same under another code.
    pub const fn coded(mut self, code: &'static str) -> Self {
        self.code = code;
        self
    }

    /// The same with one more note.
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

impl From<GeomError> for Diagnostic {
    fn from(error: GeomError) -> Self {
        let message = match error {
            GeomError::NotFinite { .. } => Message::new("error-not-finite"),
            GeomError::EmptyWindow { axis, min, max } => {
                let [low, high] = match axis {
                    Axis::X => ["xmin", "xmax"],
                    Axis::Y => ["ymin", "ymax"],
                };
                Message::new("error-empty-window")
                    .with("low", low.to_owned())
                    .with("min", min)
                    .with("high", high.to_owned())
                    .with("max", max)
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
                Message::new("error-empty-box")
                    .with("low", format!("{axis}min"))
                    .with("min", min)
                    .with("high", format!("{axis}max"))
                    .with("max", max)
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
