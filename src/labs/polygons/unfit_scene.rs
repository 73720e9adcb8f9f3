//! A scene that a method cannot take: said and shown on stage, in place of a run.

use crate::{
    figure::Caption,
    geom::{ConvexPolygon, GeomError, Polygon, SimplePolygon},
    labs::{prelude::*, refused::RefusedRun},
};

use super::Scene;

/// Of an outline with more vertices each would have no room for its name.
const MOST_NAMED: usize = 16;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ScenePart {
    Subject,
    Hole(usize),
    Clip,
}

impl ScenePart {
    /// This part's outline for methods that need it simple.
    pub fn simple(self, outline: &Polygon) -> Result<SimplePolygon, UnfitScene> {
        SimplePolygon::try_from(outline).map_err(|error| UnfitScene::new(self, error))
    }
}

/// Why a method cannot take a scene.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct UnfitScene {
    pub part: ScenePart,
    pub error: GeomError,
}

impl UnfitScene {
    pub const fn new(part: ScenePart, error: GeomError) -> Self {
        Self { part, error }
    }

    /// The hole that is at fault.
    pub const fn hole(self) -> Option<usize> {
        match self.part {
            ScenePart::Hole(i) => Some(i),
            ScenePart::Subject | ScenePart::Clip => None,
        }
    }

    /// A run without a step that says what is wrong, and shows it over the outline at fault, whose vertices have their names.
    pub(super) fn run(self, scene: &Scene, subject: char) -> Box<dyn Run> {
        let outline = self.outline(scene);
        let vertices: Vec<[f64; 2]> = outline.vertices().iter().map(|p| p.to_array()).collect();
        let edge = |i: usize| [i, i + 1].map(|k| k % vertices.len());
        let symbol = |i: usize| self.symbol(scene, subject, i);
        let refused = Message::new("not-so").with("what", Value::Term("refused"));
        let outline = Mark::new(Role::Discarded, Shape::Outline(vertices.clone()));
        let mut marks = vec![outline.labelled(refused)];
        if vertices.len() <= MOST_NAMED {
            let mark =
                |(i, &at)| Mark::new(Role::Soft, Shape::Vertex(at)).labelled(name(symbol(i)));
            marks.extend(vertices.iter().enumerate().map(mark));
        }
        let at_vertex = |key, i: usize| {
            let mark = |&at| Mark::new(Role::Signal, Shape::Ring(at)).labelled(name(symbol(i)));
            let message = Message::new(key).with("vertex", name(symbol(i)));
            (message, Vec::from_iter(vertices.get(i).map(mark)))
        };
        let (message, faults) = match self.error {
            GeomError::NotConvex { vertex_idx } => at_vertex("refused-not-convex", vertex_idx),
            GeomError::SelfIntersecting { vertex_idx } => {
                at_vertex("refused-winds-twice", vertex_idx)
            }
            GeomError::EdgesMeet { edges } => {
                let [first, second] = edges.map(|i| name(edge(i).map(symbol).concat()));
                let message = Message::new("refused-edges-meet").with("first", first.clone());
                let line = |i| Shape::Segment(edge(i).map(|k| vertices[k]));
                let named = [first, second.clone()].into_iter().zip(edges);
                let lines = named.map(|(name, i)| Mark::new(Role::Signal, line(i)).labelled(name));
                (message.with("second", second), lines.collect())
            }
            GeomError::MisplacedHole { .. } => (Message::new("refused-misplaced-hole"), vec![]),
            GeomError::NotFinite { .. }
            | GeomError::EmptyWindow { .. }
            | GeomError::TooFewVertices
            | GeomError::Degenerate { .. } => (Message::new("refused-degenerate"), vec![]),
        };
        marks.extend(faults);
        let part = Value::Term(match self.part {
            ScenePart::Subject => "part-subject",
            ScenePart::Hole(_) => "part-hole",
            ScenePart::Clip => "part-clip",
        });
        Box::new(RefusedRun {
            code: self.error.code(),
            caption: Caption::new(message.with("part", part)),
            views: vec![View::plane(marks)],
        })
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
        let (letter, n_rings) = match self.part {
            ScenePart::Subject => (subject, 0),
            ScenePart::Hole(i) => (subject, i + 1),
            ScenePart::Clip => ('C', 0),
        };
        let before = scene.rings().take(n_rings);
        let before: usize = before.map(|ring| ring.vertices().len()).sum();
        numbered(letter, before + idx)
    }
}

impl Scene {
    /// The clip region for methods that need it convex.
    pub fn convex_clip(&self) -> Result<ConvexPolygon, UnfitScene> {
        match &self.clip {
            None => Ok(ConvexPolygon::from(self.window)),
            Some(clip) => ConvexPolygon::try_from(Vec::from(clip.clone()))
                .map_err(|error| UnfitScene::new(ScenePart::Clip, error)),
        }
    }
}
