//! The segments out of focus: all clipped at once, as a program would.

use crate::{
    algo::line::{
        CyrusBeck, CyrusBeckInput,
        batch::{ClippedSegments, Segments, clip_all},
    },
    figure::{Mark, Role, Shape},
    geom::Segment,
    labs::words::{name, subscript},
    trace::silent,
};

use super::Scene;

/// Of segments out of focus.
const LETTERS: [&str; 3] = ["Q", "R", "S"];

/// Every segment of the scene but the focused one: as given, and `clipped`, the visible parts over them.
#[must_use]
pub fn crowd(scene: &Scene, clipped: bool) -> Vec<Mark> {
    let (before, rest) = scene.segments().split_at(scene.focus());
    let given: Vec<Segment> = before.iter().chain(&rest[1..]).copied().collect();
    if given.is_empty() {
        return Vec::new();
    }
    let visible = if clipped {
        clip(scene, &given)
    } else {
        Vec::new()
    };
    let names = names(&given);
    [(Role::Discarded, given), (Role::Accent, visible)]
        .into_iter()
        .map(|(role, segments)| {
            let ends = |s: Segment| [s.p1.to_array(), s.p2.to_array()];
            Mark::new(role, Shape::Crowd(segments.into_iter().map(ends).collect()))
        })
        .chain(names)
        .collect()
}

/// Few of them have names at their ends, as the one in focus has: Q₁ and Q₂, R₁ and R₂.
fn names(given: &[Segment]) -> Vec<Mark> {
    if given.len() > LETTERS.len() {
        return Vec::new();
    }
    let ends = |(segment, letter): (&Segment, &str)| {
        [(segment.p1, 1), (segment.p2, 2)].map(|(at, nth)| {
            let symbol = format!("{letter}{}", subscript(nth));
            Mark::new(Role::Soft, Shape::Vertex(at.to_array())).labelled(name(symbol))
        })
    };
    given.iter().zip(LETTERS).flat_map(ends).collect()
}

/// By the batch clipper against a window, by Cyrus–Beck against a polygon.
fn clip(scene: &Scene, given: &[Segment]) -> Vec<Segment> {
    match scene.polygon_in_use() {
        Some(clip) => {
            let clipped = given.iter().map(|&segment| {
                let clip = clip.clone();
                silent::<CyrusBeck>(&CyrusBeckInput { clip, segment })
            });
            clipped.flatten().collect()
        }
        None => {
            let mut clipped = ClippedSegments::default();
            let segments: Segments = given.iter().copied().collect();
            clip_all(&scene.window, &segments, &mut clipped);
            clipped.iter().flatten().collect()
        }
    }
}
