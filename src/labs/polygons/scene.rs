//! The polygons lab's document: what is clipped against what, and by which method; and what the lab knows of a method.

use std::fmt;

use crate::{
    figure::Run,
    geom::{Point, Polygon, Window},
    text::{Diagnostic, Message},
};

/// More vertices than this, holes and clip polygon included, are refused: a frame could not draw them in time.
pub const MAX_VERTICES: usize = 20_000;

/// What the subject polygon is filled with.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub enum Texture {
    /// One colour.
    #[default]
    None,
    /// A texture whose coordinates are interpolated at every crossing, with the crossing's own t.
    Interpolated,
    /// The mistake: a crossing takes over the coordinates of the vertex outside.
    Kept,
}

impl Texture {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::None, Self::Interpolated, Self::Kept];

    /// As lesson and scene files spell it.
    pub const fn id(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Interpolated => "interpolated",
            Self::Kept => "kept",
        }
    }
}

/// One of the lab's methods.
pub type Method = crate::labs::Method<MethodInfo>;

/// How the subject is seen under a method's drawing, before its end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GivenSubject {
    /// As it is.
    Whole,
    /// As cut off, but for what the drawing outlines: the list that the method works on.
    CutOff,
}

/// What becomes of a vertex of the subject.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct VertexFate {
    /// The step that decided it.
    pub step: usize,
    /// Is it kept?
    pub is_kept: bool,
    /// The clip edge that was asked there, where one is asked at a time.
    pub border: Option<usize>,
}

/// Something that a run finds on its way, and the step at which it does.
#[derive(Clone, PartialEq, Debug)]
pub enum Found {
    /// An intersection.
    Crossing {
        /// At which step.
        step: usize,
        /// Where.
        at: Point,
    },
    /// A piece of the answer.
    Piece {
        /// At which step.
        step: usize,
        /// Around it.
        outline: Vec<Point>,
    },
}

/// What the lab knows of a method without running it.
pub struct MethodInfo {
    /// Does it clip: against the window, or a clip polygon in its place?
    pub clips: bool,
    /// Does it carry texture coordinates along?
    pub carries_texture: bool,
    /// How the subject is seen while it works.
    pub given: GivenSubject,
    /// Does it know holes?
    pub knows_holes: bool,
    /// Runs it on a scene; where it cannot take it, the run has no steps and says why.
    pub record: fn(&Scene) -> Box<dyn Run>,
    /// Can it take a scene?
    pub takes: fn(&Scene) -> bool,
    /// What becomes of a vertex of the subject that lies there.
    pub fate: fn(&Scene, Point) -> Option<VertexFate>,
    /// The intersections and the pieces that its run finds.
    pub found: fn(&Scene) -> Vec<Found>,
}

/// Always valid: every outline has three finite vertices or more. What a method asks beyond that, such as a
/// convex clip polygon, it checks itself, and says what is wrong on stage.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    /// How the polygon is clipped.
    pub method: Method,
    /// A second method on the same input, side by side.
    pub compare: Option<Method>,
    /// The clip window.
    pub window: Window,
    /// A clip polygon that takes the window's place.
    pub clip: Option<Polygon>,
    /// The polygon that is clipped.
    pub subject: Polygon,
    /// Holes in it, for methods that know them.
    pub holes: Vec<Polygon>,
    /// What it is filled with, for methods that carry texture coordinates along.
    pub texture: Texture,
}

/// Why a scene is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SceneError {
    /// More than [`MAX_VERTICES`].
    TooManyVertices(usize),
    /// A polygon keeps three vertices at least.
    TooFewVertices,
}

impl From<SceneError> for Diagnostic {
    fn from(error: SceneError) -> Self {
        match error {
            SceneError::TooManyVertices(count) => {
                let message = Message::new("error-too-many-vertices").with("count", count);
                Self::new(message.with("limit", MAX_VERTICES)).coded("too-large")
            }
            SceneError::TooFewVertices => Self::new(Message::new("error-last-three")),
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Diagnostic::from(*self).fmt(f)
    }
}

impl Scene {
    /// A polygon against a window.
    pub const fn new(method: Method, window: Window, subject: Polygon) -> Self {
        Self {
            method,
            compare: None,
            window,
            clip: None,
            subject,
            holes: Vec::new(),
            texture: Texture::None,
        }
    }

    /// What the lab opens on where there is no lesson.
    ///
    /// # Panics
    /// Never: its numbers are valid.
    pub fn first() -> Self {
        let method = Method::all().next();
        let window = Window::new(-1.0, -1.0, 1.0, 1.0);
        let subject = Polygon::new(&[[-2.0, -0.5], [0.5, -1.5], [1.5, 0.5], [0.0, 2.0]]);
        let parts = method.zip(window.ok()).zip(subject.ok());
        let ((method, window), subject) = parts.expect("constants that are valid");
        Self::new(method, window, subject)
    }

    /// The methods on stage.
    pub fn on_stage(&self) -> impl Iterator<Item = Method> {
        [Some(self.method), self.compare].into_iter().flatten()
    }

    /// The clip polygon, or the window's outline where there is none.
    pub fn clip_outline(&self) -> Polygon {
        let window = || Polygon::from(self.window);
        self.clip.clone().unwrap_or_else(window)
    }

    /// What gives a place its texture coordinates: the subject's box is the unit square. A box without width or
    /// height is taken to be as wide as high.
    pub fn texels(&self) -> impl Fn(Point) -> [f64; 2] + use<> {
        let [min, max] = crate::geom::extent(self.subject.vertices().iter().copied());
        move |at: Point| {
            let at = at.to_array();
            [0, 1].map(|i| {
                if max[i] > min[i] {
                    (at[i] - min[i]) / (max[i] - min[i])
                } else {
                    0.0
                }
            })
        }
    }

    /// Every outline of the subject: the polygon itself, then its holes.
    pub fn rings(&self) -> impl Iterator<Item = &Polygon> {
        std::iter::once(&self.subject).chain(&self.holes)
    }

    /// All vertices there are.
    pub fn n_vertices(&self) -> usize {
        self.rings()
            .chain(&self.clip)
            .map(|ring| ring.vertices().len())
            .sum()
    }

    /// # Errors
    /// [`SceneError::TooManyVertices`]
    pub fn check(self) -> Result<Self, SceneError> {
        match self.n_vertices() {
            0..=MAX_VERTICES => Ok(self),
            n => Err(SceneError::TooManyVertices(n)),
        }
    }
}
