//! A scene that a method cannot take: said and shown on stage, in place of a run.

use serde_json::{Value as Json, json};

use crate::{
    figure::{Caption, Frame, Mark, Role, Run, Shape, Tick, View, Words},
    geom::{ConvexPolygon, GeomError, Polygon},
    labs::words::{name, subscript, vertex_name},
    text::{Message, Value},
    trace::Counts,
};

use super::Scene;

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
    #[must_use]
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

    fn caption(self, scene: &Scene) -> Caption {
        let part = match self.part {
            ScenePart::Subject => Value::Term("part-subject"),
            ScenePart::Hole(_) => Value::Term("part-hole"),
            ScenePart::Clip => Value::Term("part-clip"),
        };
        let message = match self.error {
            GeomError::NotConvex { vertex_idx } => {
                Message::new("refused-not-convex").with("vertex", vertex_name(vertex_idx))
            }
            GeomError::SelfIntersecting { vertex_idx } => {
                Message::new("refused-winds-twice").with("vertex", vertex_name(vertex_idx))
            }
            GeomError::EdgesMeet { edges } => {
                let n = self.outline(scene).vertices().len();
                let [first, second] = edges.map(|i| edge_name([i, (i + 1) % n]));
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

    fn marks(self, scene: &Scene) -> Vec<Mark> {
        let outline = self.outline(scene);
        let vertices: Vec<[f64; 2]> = outline.vertices().iter().map(|p| p.to_array()).collect();
        let mut marks = vec![Mark::new(Role::Discarded, Shape::Outline(vertices.clone()))];
        if let GeomError::NotConvex { vertex_idx } | GeomError::SelfIntersecting { vertex_idx } =
            self.error
            && let Some(&at) = vertices.get(vertex_idx)
        {
            let ring = Mark::new(Role::Signal, Shape::Ring(at));
            marks.push(ring.labelled(vertex_name(vertex_idx)));
        }
        if let GeomError::EdgesMeet { edges } = self.error {
            let n = vertices.len();
            let edges = edges.map(|i| [i % n, (i + 1) % n]);
            marks.extend(edges.map(|[i, j]| {
                let edge = Shape::Segment([vertices[i], vertices[j]]);
                Mark::new(Role::Signal, edge).labelled(edge_name([i, j]))
            }));
        }
        marks
    }

    /// A run without a step that shows it.
    pub(super) fn run(self, scene: &Scene) -> Box<dyn Run> {
        Box::new(UnfitRun {
            refusal: self,
            caption: self.caption(scene),
            marks: self.marks(scene),
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

/// `V₁V₂`.
fn edge_name(ends: [usize; 2]) -> Value {
    name(ends.map(|i| format!("V{}", subscript(i + 1))).concat())
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

    fn frame(&self, _step: usize) -> Frame {
        Frame {
            views: vec![View::plane(self.marks.clone())],
            caption: self.caption.clone(),
            code_line: None,
            watch: Vec::new(),
            counts: Counts::default(),
        }
    }

    fn output_json(&self) -> Json {
        json!({ "refused": self.refusal.error.code() })
    }
}
