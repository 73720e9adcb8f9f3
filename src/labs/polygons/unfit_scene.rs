//! A scene that a method cannot take: said and shown on stage, in place of a run.

use std::ops::ControlFlow;

use serde_json::{Value as Json, json};

use crate::{
    figure::{Caption, Mark, Role, Run, Shape, Shown, Tick, View, Watch, Words},
    geom::{ConvexPolygon, GeomError, Polygon},
    labs::words::{name, subscript},
    text::{Message, Value},
    trace::Counts,
};

use super::Scene;

/// Of an outline with more vertices each would have no room for its name.
const MOST_NAMED: usize = 16;

/// A part of the scene.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ScenePart {
    /// The polygon that is clipped.
    Subject,
    /// A hole in it.
    Hole(usize),
    /// The clip polygon.
    Clip,
}

/// Why a method cannot take a scene.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct UnfitScene {
    /// The part that is at fault.
    pub part: ScenePart,
    /// What is wrong with it.
    pub error: GeomError,
}

impl UnfitScene {
    /// This part, for this reason.
    pub const fn new(part: ScenePart, error: GeomError) -> Self {
        Self { part, error }
    }

    fn outline(self, scene: &Scene) -> Polygon {
        match self.part {
            ScenePart::Subject => scene.subject.clone(),
            ScenePart::Hole(i) => scene.holes[i].clone(),
            ScenePart::Clip => scene.clip_outline(),
        }
    }

    /// What the drawing calls a vertex of the part: `C₄`. Holes go on after the outline.
    fn symbol(self, scene: &Scene, subject: char, idx: usize) -> String {
        let before = match self.part {
            ScenePart::Subject | ScenePart::Clip => 0,
            ScenePart::Hole(i) => {
                let rings = std::iter::once(&scene.subject).chain(&scene.holes[..i]);
                rings.map(|ring| ring.vertices().len()).sum()
            }
        };
        let letter = match self.part {
            ScenePart::Subject | ScenePart::Hole(_) => subject,
            ScenePart::Clip => 'C',
        };
        format!("{letter}{}", subscript(before + idx + 1))
    }

    fn caption(self, scene: &Scene, subject: char) -> Caption {
        let vertex = |idx| name(self.symbol(scene, subject, idx));
        let edge = |ends: [usize; 2]| name(ends.map(|i| self.symbol(scene, subject, i)).concat());
        let part = match self.part {
            ScenePart::Subject => Value::Term("part-subject"),
            ScenePart::Hole(_) => Value::Term("part-hole"),
            ScenePart::Clip => Value::Term("part-clip"),
        };
        let message = match self.error {
            GeomError::NotConvex { vertex_idx } => {
                Message::new("refused-not-convex").with("vertex", vertex(vertex_idx))
            }
            GeomError::SelfIntersecting { vertex_idx } => {
                Message::new("refused-winds-twice").with("vertex", vertex(vertex_idx))
            }
            GeomError::EdgesMeet { edges } => {
                let n = self.outline(scene).vertices().len();
                let [first, second] = edges.map(|i| edge([i % n, (i + 1) % n]));
                Message::new("refused-edges-meet")
                    .with("first", first)
                    .with("second", second)
            }
            GeomError::MisplacedHole { .. } => Message::new("refused-misplaced-hole"),
            GeomError::NotFinite { .. }
            | GeomError::EmptyWindow { .. }
            | GeomError::TooFewVertices
            | GeomError::Degenerate { .. } => Message::new("refused-degenerate"),
        };
        Caption::new(message.with("part", part))
    }

    /// The outline at fault with the names of its vertices, and what is wrong with it over them.
    fn marks(self, scene: &Scene, subject: char) -> Vec<Mark> {
        let outline = self.outline(scene);
        let vertices: Vec<[f64; 2]> = outline.vertices().iter().map(|p| p.to_array()).collect();
        let symbol = |i: usize| name(self.symbol(scene, subject, i));
        let mut marks = vec![Mark::new(Role::Discarded, Shape::Outline(vertices.clone()))];
        if vertices.len() <= MOST_NAMED {
            let named = vertices.iter().enumerate();
            marks.extend(
                named.map(|(i, &at)| Mark::new(Role::Soft, Shape::Vertex(at)).labelled(symbol(i))),
            );
        }
        match self.error {
            GeomError::NotConvex { vertex_idx } | GeomError::SelfIntersecting { vertex_idx } => {
                let at = vertices.get(vertex_idx).copied();
                marks.extend(at.map(|at| {
                    Mark::new(Role::Signal, Shape::Ring(at)).labelled(symbol(vertex_idx))
                }));
            }
            GeomError::EdgesMeet { edges } => {
                let n = vertices.len();
                let edges = edges.map(|i| [i % n, (i + 1) % n].map(|i| vertices[i]));
                marks.extend(edges.map(|ends| Mark::new(Role::Signal, Shape::Segment(ends))));
            }
            GeomError::MisplacedHole { .. }
            | GeomError::NotFinite { .. }
            | GeomError::EmptyWindow { .. }
            | GeomError::TooFewVertices
            | GeomError::Degenerate { .. } => {}
        }
        marks
    }

    /// A run without a step that shows it.
    pub(super) fn run(self, scene: &Scene, subject: char) -> Box<dyn Run> {
        Box::new(UnfitRun {
            refusal: self,
            caption: self.caption(scene, subject),
            marks: self.marks(scene, subject),
        })
    }
}

impl Scene {
    /// The clip region for methods that need it convex.
    ///
    /// # Errors
    /// [`UnfitScene`] where it is not.
    pub fn convex_clip(&self) -> Result<ConvexPolygon, UnfitScene> {
        match &self.clip {
            None => Ok(ConvexPolygon::from(self.window)),
            Some(clip) => ConvexPolygon::try_from(Vec::from(clip.clone()))
                .map_err(|error| UnfitScene::new(ScenePart::Clip, error)),
        }
    }
}

struct UnfitRun {
    refusal: UnfitScene,
    caption: Caption,
    marks: Vec<Mark>,
}

impl Run for UnfitRun {
    fn n_steps(&self) -> usize {
        0
    }

    fn is_refused(&self) -> bool {
        true
    }

    fn tick(&self, _step: usize) -> Tick {
        Tick::Reject
    }

    fn event_json(&self, _step: usize) -> Json {
        Json::Null
    }

    fn read_words(&self, _step: usize, _words: &mut Words) {}

    fn counts_at(&self, _step: usize) -> Counts {
        Counts::default()
    }

    fn code_line(&self, _step: usize) -> Option<usize> {
        None
    }

    fn visit(
        &self,
        _from_to: [usize; 2],
        look: &mut dyn FnMut(usize, &dyn Shown) -> ControlFlow<()>,
    ) {
        // Its only step: there is none after it to go on to.
        let _ = look(0, self);
    }

    fn output_json(&self) -> Json {
        json!({ "refused": self.refusal.error.code() })
    }
}

impl Shown for UnfitRun {
    fn caption(&self) -> Caption {
        self.caption.clone()
    }

    fn watch(&self) -> Watch {
        Watch::new()
    }

    fn views(&self) -> Vec<View> {
        vec![View::plane(self.marks.clone())]
    }
}
