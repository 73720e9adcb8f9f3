//! A scene that a method cannot take: said and shown on stage, in place of a run.

use serde_json::{Value as Json, json};

use crate::{
    figure::{Caption, Frame, Mark, Role, Run, Shape, Tick},
    geom::{GeomError, Polygon},
    labs::words::vertex_name,
    text::{Message, Value},
    trace::Counts,
};

use super::Scene;

/// A part of the scene.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    /// The polygon that is clipped.
    Subject,
    /// A hole in it.
    Hole(usize),
    /// The clip polygon.
    Clip,
}

/// Why a method cannot take a scene.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Refusal {
    /// The part that is at fault.
    pub part: Part,
    /// What is wrong with it.
    pub error: GeomError,
}

impl Refusal {
    /// This part, for this reason.
    #[must_use]
    pub const fn new(part: Part, error: GeomError) -> Self {
        Self { part, error }
    }

    fn outline(self, scene: &Scene) -> Polygon {
        match self.part {
            Part::Subject => scene.subject.clone(),
            Part::Hole(i) => scene.holes[i].clone(),
            Part::Clip => scene.clip_outline(),
        }
    }

    fn caption(self) -> Caption {
        let part = match self.part {
            Part::Subject => Value::Term("part-subject"),
            Part::Hole(_) => Value::Term("part-hole"),
            Part::Clip => Value::Term("part-clip"),
        };
        let message = match self.error {
            GeomError::NotConvex { vertex_idx } => {
                Message::new("refused-not-convex").with("vertex", vertex_name(vertex_idx))
            }
            GeomError::SelfIntersecting { vertex_idx } => {
                Message::new("refused-winds-twice").with("vertex", vertex_name(vertex_idx))
            }
            _ => Message::new("refused-degenerate"),
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
        marks
    }

    /// A run without a step that shows it.
    pub(super) fn run(self, scene: &Scene) -> Box<dyn Run> {
        Box::new(Refused {
            refusal: self,
            marks: self.marks(scene),
        })
    }
}

struct Refused {
    refusal: Refusal,
    marks: Vec<Mark>,
}

impl Run for Refused {
    fn n_steps(&self) -> usize {
        0
    }

    fn tick(&self, _step: usize) -> Tick {
        Tick::Reject
    }

    fn event_json(&self, _step: usize) -> Json {
        Json::Null
    }

    fn counts_at(&self, _step: usize) -> Counts {
        Counts::default()
    }

    fn frame(&self, _step: usize) -> Frame {
        Frame {
            marks: self.marks.clone(),
            caption: self.refusal.caption(),
            code_line: None,
            watch: Vec::new(),
            number_line: None,
            counts: Counts::default(),
        }
    }

    fn output_json(&self) -> Json {
        json!({ "refused": self.refusal.error.code() })
    }
}
