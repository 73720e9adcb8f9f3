//! The polygons lab's document: what is clipped against what, and by which method; and what the lab knows of a method.

use crate::{
    figure::Run,
    geom::{Point, Polygon, Window},
    text::{Diagnostic, Message},
};

/// More vertices than this, holes and clip polygon included, are refused: a frame could not draw them in time.
pub const MAX_VERTICES: usize = 20_000;

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub enum Texture {
    #[default]
    None,
    Interpolated,
    /// The mistake: a crossing takes over the coordinates of the vertex outside.
    Kept,
}

impl Texture {
    pub const ALL: [Self; 3] = [Self::None, Self::Interpolated, Self::Kept];

    pub const fn id(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Interpolated => "interpolated",
            Self::Kept => "kept",
        }
    }
}

/// What small drawings beside the lists of Sutherland–Hodgman show, whatever the step.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub enum Panels {
    #[default]
    None,
    /// The four rules, each with an edge of this pass.
    Rules,
    /// What each pass makes of the list.
    Passes,
    /// The triangle with none, one, two and three vertices inside of the first clip edge.
    Vertices,
}

impl Panels {
    pub const ALL: [Self; 4] = [Self::None, Self::Rules, Self::Passes, Self::Vertices];

    pub const fn id(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Rules => "rules",
            Self::Passes => "passes",
            Self::Vertices => "vertices",
        }
    }
}

pub type Method = crate::labs::Method<MethodInfo>;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GivenSubject {
    Whole,
    /// As cut off, but for what the drawing outlines: the list that the method works on.
    CutOff,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct VertexFate {
    pub step: usize,
    pub is_kept: bool,
    /// The clip edge that was asked there, where one is asked at a time.
    pub border: Option<usize>,
}

#[derive(Clone, PartialEq, Debug)]
pub enum Found {
    Crossing { step: usize, at: Point },
    Piece { step: usize, outline: Vec<Point> },
    Dropped { step: usize, part: [Point; 2] },
}

pub struct MethodInfo {
    pub clips: bool,
    pub carries_texture: bool,
    pub given: GivenSubject,
    pub knows_holes: bool,
    /// Runs it on a scene; where it cannot take it, the run has no steps and says why.
    pub record: fn(&Scene) -> Box<dyn Run>,
    pub takes: fn(&Scene) -> bool,
    /// The hole for which it does not take the scene.
    pub unfit_hole: fn(&Scene) -> Option<usize>,
    pub fate: fn(&Scene, Point) -> Option<VertexFate>,
    pub found: fn(&Scene) -> Vec<Found>,
}

/// Always valid: every outline has three finite vertices or more. What a method asks beyond that, such as a
/// convex clip polygon, it checks itself, and says what is wrong on stage.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    pub method: Method,
    pub compare: Option<Method>,
    pub window: Window,
    /// A clip polygon that takes the window's place.
    pub clip: Option<Polygon>,
    pub subject: Polygon,
    pub holes: Vec<Polygon>,
    pub texture: Texture,
    pub panels: Panels,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SceneError {
    TooManyVertices(usize),
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

impl Scene {
    pub const fn new(method: Method, window: Window, subject: Polygon) -> Self {
        Self {
            method,
            compare: None,
            window,
            clip: None,
            subject,
            holes: Vec::new(),
            texture: Texture::None,
            panels: Panels::None,
        }
    }

    /// What the lab opens on where there is no lesson.
    ///
    /// # Panics
    /// Never: its numbers are valid.
    pub fn first() -> Self {
        Self::of(&[[-2.0, -0.5], [0.5, -1.5], [1.5, 0.5], [0.0, 2.0]])
    }

    pub fn smallest() -> Self {
        Self::of(&[[-1.5, -0.5], [1.0, -0.5], [0.0, 1.5]])
    }

    fn of(outline: &[[f64; 2]]) -> Self {
        let method = Method::all().next();
        let window = Window::new(-1.0, -1.0, 1.0, 1.0);
        let subject = Polygon::new(outline);
        let parts = method.zip(window.ok()).zip(subject.ok());
        let ((method, window), subject) = parts.expect("constants that are valid");
        Self::new(method, window, subject)
    }

    pub fn on_stage(&self) -> impl Iterator<Item = Method> {
        [Some(self.method), self.compare].into_iter().flatten()
    }

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

    pub fn rings(&self) -> impl Iterator<Item = &Polygon> {
        std::iter::once(&self.subject).chain(&self.holes)
    }

    pub fn n_vertices(&self) -> usize {
        self.rings()
            .chain(&self.clip)
            .map(|ring| ring.vertices().len())
            .sum()
    }

    pub fn check(self) -> Result<Self, SceneError> {
        match self.n_vertices() {
            0..=MAX_VERTICES => Ok(self),
            n => Err(SceneError::TooManyVertices(n)),
        }
    }
}
