//! Every typed error is a sentence in every language: whatever can go wrong, nobody reads it in English only.

use std::io::{self, ErrorKind};

use clipscope::{
    figure::MomentError,
    geom::{Axis, GeomError, MeshError, SpaceError},
    labs::{lines, polygons, space},
    lesson::FileError,
    text::{Catalog, Diagnostic, Lang, SystemError},
};

/// One of each variant; a new one has to join, or this does not compile.
fn geometry() -> Vec<GeomError> {
    let known = |error: GeomError| match error {
        GeomError::NotFinite { .. }
        | GeomError::EmptyWindow { .. }
        | GeomError::TooFewVertices
        | GeomError::Degenerate { .. }
        | GeomError::NotConvex { .. }
        | GeomError::SelfIntersecting { .. }
        | GeomError::EdgesMeet { .. }
        | GeomError::MisplacedHole { .. } => error,
    };
    let empty = |axis| GeomError::EmptyWindow {
        axis,
        min: 1.5,
        max: -1.0,
    };
    vec![
        known(GeomError::NotFinite {
            index: 1,
            value: f64::NAN,
        }),
        empty(Axis::X),
        empty(Axis::Y),
        GeomError::TooFewVertices,
        GeomError::Degenerate { vertex_idx: 2 },
        GeomError::NotConvex { vertex_idx: 2 },
        GeomError::SelfIntersecting { vertex_idx: 2 },
        GeomError::EdgesMeet { edges: [1, 3] },
        GeomError::MisplacedHole { hole_idx: 1 },
    ]
}

fn space() -> Vec<SpaceError> {
    let known = |error: SpaceError| match error {
        SpaceError::NotFinite { .. }
        | SpaceError::EmptyBox { .. }
        | SpaceError::ZeroNormal
        | SpaceError::NegativeRadius(_)
        | SpaceError::NoVertices
        | SpaceError::TargetAtPosition
        | SpaceError::UpAlongView
        | SpaceError::FieldOfView(_)
        | SpaceError::Size(_)
        | SpaceError::Height(_)
        | SpaceError::Aspect(_)
        | SpaceError::Near(_)
        | SpaceError::Far { .. }
        | SpaceError::NotAffine => error,
    };
    let empty = |axis| SpaceError::EmptyBox {
        axis,
        min: 1.5,
        max: -1.0,
    };
    vec![
        known(SpaceError::NotFinite {
            index: 1,
            value: f64::NAN,
        }),
        empty(0),
        empty(1),
        empty(2),
        SpaceError::ZeroNormal,
        SpaceError::NegativeRadius(-0.5),
        SpaceError::NoVertices,
        SpaceError::TargetAtPosition,
        SpaceError::UpAlongView,
        SpaceError::FieldOfView(180.0),
        SpaceError::Size(0.0),
        SpaceError::Height(-4.0),
        SpaceError::Aspect(0.0),
        SpaceError::Near(-1.0),
        SpaceError::Far {
            near: 2.0,
            far: 1.0,
        },
        SpaceError::NotAffine,
    ]
}

fn meshes() -> Vec<MeshError> {
    let known = |error: MeshError| match error {
        MeshError::NotFinite { .. }
        | MeshError::NoSuchVertex { .. }
        | MeshError::NoFaces
        | MeshError::UvLength { .. } => error,
    };
    vec![
        known(MeshError::NotFinite { vertex_idx: 1 }),
        MeshError::NoSuchVertex { face_idx: 2 },
        MeshError::NoFaces,
        MeshError::UvLength {
            n_uvs: 3,
            n_vertices: 4,
        },
    ]
}

fn scenes() -> Vec<Diagnostic> {
    use lines::SceneError as Lines;
    use polygons::SceneError as Polygons;
    use space::SceneError as Space;
    let lines = |error: Lines| match error {
        Lines::NoSegments | Lines::TooManySegments(_) | Lines::NoSuchFocus { .. } => error.into(),
    };
    let polygons = |error: Polygons| match error {
        Polygons::TooManyVertices(_) | Polygons::TooFewVertices => error.into(),
    };
    let space = |error: Space| match error {
        Space::NoObjects | Space::TooManyObjects(_) | Space::NoSuchPart { .. } => error.into(),
    };
    let no_part = |part, idx, count| space(Space::NoSuchPart { part, idx, count });
    vec![
        space(Space::NoObjects),
        space(Space::TooManyObjects(7)),
        no_part(space::Part::Object, 3, 2),
        no_part(space::Part::Face, 12, 12),
        no_part(space::Part::Vertex, 8, 8),
        lines(Lines::NoSegments),
        lines(Lines::TooManySegments(7)),
        lines(Lines::NoSuchFocus {
            focus: 3,
            n_segments: 2,
        }),
        polygons(Polygons::TooManyVertices(7)),
        polygons(Polygons::TooFewVertices),
    ]
}

fn moments() -> Vec<Diagnostic> {
    let known = |error: MomentError| match error {
        MomentError::Empty | MomentError::BadNumber => error.into(),
    };
    vec![known(MomentError::Empty), known(MomentError::BadNumber)]
}

/// The kinds that have a sentence of their own, and what stands for all others.
fn system() -> Vec<SystemError> {
    let kinds = [
        ErrorKind::NotFound,
        ErrorKind::PermissionDenied,
        ErrorKind::AlreadyExists,
        ErrorKind::IsADirectory,
        ErrorKind::NotADirectory,
        ErrorKind::StorageFull,
        ErrorKind::QuotaExceeded,
        ErrorKind::ReadOnlyFilesystem,
        ErrorKind::InvalidFilename,
        ErrorKind::InvalidInput,
        ErrorKind::FileTooLarge,
        ErrorKind::ResourceBusy,
        ErrorKind::Unsupported,
        ErrorKind::Other,
    ];
    let numbered = io::Error::from_raw_os_error(5);
    kinds
        .into_iter()
        .map(SystemError::of_kind)
        .chain([numbered.into()])
        .collect()
}

fn files() -> Vec<Diagnostic> {
    let known = |error: FileError| match error {
        FileError::TooLarge { .. } | FileError::LeadsOut | FileError::Unreadable(_) => error.into(),
    };
    let reasons = system().into_iter().map(FileError::Unreadable);
    reasons
        .chain([FileError::TooLarge { limit: 4 << 20 }, FileError::LeadsOut])
        .map(known)
        .collect()
}

#[test]
fn every_error_is_said_in_every_language() {
    let mut all: Vec<Diagnostic> = geometry().into_iter().map(Diagnostic::from).collect();
    all.extend(space().into_iter().map(Diagnostic::from));
    all.extend(meshes().into_iter().map(Diagnostic::from));
    all.extend(system().into_iter().map(Diagnostic::from));
    all.extend([scenes(), moments(), files()].concat());
    for diagnostic in all {
        assert!(!diagnostic.code.is_empty());
        let sentences = std::iter::once(&diagnostic.message).chain(&diagnostic.notes);
        for sentence in sentences {
            let said = Lang::ALL.map(|lang| Catalog::of(lang).message(sentence));
            let [english, others @ ..] = &said;
            for other in &said {
                assert!(!other.contains('⟦'), "{}: {other}", sentence.key);
            }
            for other in others {
                assert_ne!(other, english, "{} is English only", sentence.key);
            }
        }
    }
}

#[test]
fn an_error_keeps_its_code_and_its_numbers() {
    for error in geometry() {
        assert_eq!(Diagnostic::from(error).code, error.code());
    }
    for error in space() {
        assert_eq!(Diagnostic::from(error).code, error.code());
    }
    for error in meshes() {
        assert_eq!(Diagnostic::from(error).code, error.code());
    }
    let empty = GeomError::EmptyWindow {
        axis: Axis::Y,
        min: 1.5,
        max: -1.0,
    };
    assert_eq!(
        Diagnostic::from(empty).to_string(),
        "The window is empty: ymin = 1.5 must be less than ymax = −1."
    );
    let empty = SpaceError::EmptyBox {
        axis: 2,
        min: 1.5,
        max: -1.0,
    };
    assert_eq!(
        Diagnostic::from(empty).to_string(),
        "The box is empty: zmin = 1.5 must not be greater than zmax = −1."
    );
    let beyond = SpaceError::Far {
        near: 2.0,
        far: 0.5,
    };
    assert_eq!(
        Diagnostic::from(beyond).to_string(),
        "The far plane must lie beyond the near plane: far = 1/2 must be greater than near = 2."
    );
    let gone = FileError::from(io::Error::from(ErrorKind::NotFound));
    assert_eq!(
        Diagnostic::from(gone).to_string(),
        "The file cannot be read: no such file or folder."
    );
}
