//! What a person can do to the polygons lab's scene, beyond what every lab knows.

use std::sync::Arc;

use crate::{
    geom::{GeomError, Point, Polygon, distance_to_segment},
    labs::{ChangeOf, Click, Handle, Lock, OutlineKind, Own},
    text::Diagnostic,
};

use super::{PRESETS, REGIONS, Scene, SceneError, SceneVertex, Texture, random_polygon};

#[derive(Clone, PartialEq, Debug)]
pub enum PolygonsChange {
    /// A vertex after this one: at this place, or in the middle of the edge.
    Insert(SceneVertex, Option<[f64; 2]>),
    Delete(SceneVertex),
    Texture(Texture),
    Subject(Polygon),
    Hole(Polygon),
    NoHole(usize),
    NoHoles,
    /// Another clip polygon; none for the window.
    Clip(Option<Polygon>),
    /// One of [`PRESETS`], about what clips.
    Preset(usize),
    /// One of [`REGIONS`], as large as what clips now.
    Region(usize),
    Random {
        count: usize,
        seed: u64,
    },
}

impl ChangeOf for PolygonsChange {
    type Of = Scene;

    fn make(&self, scene: &mut Scene) -> Result<Option<Handle>, Diagnostic> {
        let mut changed = scene.clone();
        let mut selected = None;
        match self.clone() {
            Self::Texture(texture) => changed.texture = texture,
            Self::Subject(subject) => (changed.subject, changed.holes) = (subject, Vec::new()),
            Self::Hole(hole) => changed.holes.push(hole),
            Self::NoHole(i) if i < changed.holes.len() => {
                changed.holes.remove(i);
            }
            Self::NoHole(_) => {}
            Self::NoHoles => changed.holes.clear(),
            Self::Clip(clip) => changed.clip = clip,
            Self::Region(i) => {
                if let Some(region) = REGIONS.get(i) {
                    changed.clip = Some(region.about(scene.clip_box())?.0);
                }
            }
            Self::Preset(i) => {
                if let Some(preset) = PRESETS.get(i) {
                    (changed.subject, changed.holes) = preset.about(scene.clip_box())?;
                }
            }
            Self::Random { count, seed } => {
                changed.subject = random_polygon(&scene.clip_window(), count, seed)?;
                changed.holes.clear();
            }
            Self::Insert(vertex, at) => {
                if let Some(ring) = changed.ring_mut(vertex) {
                    *ring = with_vertex_after(ring, vertex.idx(), at)?;
                    selected = Some(vertex.next().handle());
                }
            }
            Self::Delete(vertex) => {
                if let Some(ring) = changed.ring_mut(vertex) {
                    *ring = without_vertex(ring, vertex.idx())?;
                }
            }
        }
        *scene = changed.check()?;
        Ok(selected)
    }

    fn is_another(&self) -> bool {
        matches!(self, Self::Preset(_) | Self::Random { .. })
    }
}

fn with_vertex_after(ring: &Polygon, i: usize, at: Option<[f64; 2]>) -> Result<Polygon, GeomError> {
    let [p1, p2] = [ring.edge(i).p1, ring.edge(i).p2].map(Point::to_array);
    let [x, y] = at.unwrap_or([0, 1].map(|k| p1[k].midpoint(p2[k])));
    let mut vertices = ring.vertices().to_vec();
    vertices.insert(i + 1, Point::new(x, y)?);
    Polygon::from_points(vertices)
}

fn without_vertex(ring: &Polygon, i: usize) -> Result<Polygon, SceneError> {
    let mut vertices = ring.vertices().to_vec();
    vertices.remove(i);
    Polygon::from_points(vertices).map_err(|_| SceneError::TooFewVertices)
}

/// The vertex that a handle is of, or the subject's last one.
pub fn vertex_of(scene: &Scene, handle: Option<Handle>) -> SceneVertex {
    let last = SceneVertex::Subject(scene.subject.vertices().len() - 1);
    handle.and_then(SceneVertex::of).unwrap_or(last)
}

/// A click that puts something in puts a new vertex on the edge that it is on.
pub fn clicked(scene: &Scene, click: &Click<'_>) -> Option<PolygonsChange> {
    let ([x, y, _], [to_x, to_y, _]) = (click.at, click.place);
    let vertices = scene.subject_vertices().chain(scene.clip_vertices());
    let near = vertices.filter_map(|vertex| {
        let edge = scene.ring_of(vertex)?.edge(vertex.idx());
        let distance = distance_to_segment([x, y], [edge.p1.to_array(), edge.p2.to_array()]);
        (distance <= click.reach && click.inserts).then_some((distance, vertex))
    });
    let (_, nearest) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let is_locked = Lock::any_holds(click.locks, nearest.handle());
    (!is_locked).then_some(PolygonsChange::Insert(nearest, Some([to_x, to_y])))
}

pub static OUTLINES: [OutlineKind; 3] = [
    OutlineKind {
        name_key: "action-draw-subject",
        hint_key: "draw-subject",
        part_key: "part-subject",
        is_of_use: |_| true,
        close: |points| closed(points, PolygonsChange::Subject),
    },
    OutlineKind {
        name_key: "action-draw-clip",
        hint_key: "draw-clip",
        part_key: "part-clip",
        is_of_use: |scene| scene.get().is_some_and(Scene::clips),
        close: |points| closed(points, |clip| PolygonsChange::Clip(Some(clip))),
    },
    OutlineKind {
        name_key: "action-draw-hole",
        hint_key: "draw-hole",
        part_key: "part-hole",
        is_of_use: |scene| scene.get().is_some_and(Scene::knows_holes),
        close: |points| closed(points, PolygonsChange::Hole),
    },
];

fn closed(points: &[[f64; 2]], change: fn(Polygon) -> PolygonsChange) -> Option<Own> {
    Some(Arc::new(change(Polygon::new(points).ok()?)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labs::Sketch;

    #[test]
    fn three_points_close_and_a_repeated_one_does_not_count() {
        let mut sketch = Sketch::new(&OUTLINES[2]);
        for at in [[0.0; 2], [0.0; 2], [1.0, 0.0]] {
            sketch.place(at);
        }
        assert!(sketch.change().is_none() && !sketch.can_close());
        sketch.place([0.0, 1.0]);
        let change = sketch.change().expect("three points");
        assert!(format!("{change:?}").starts_with("Hole"), "{change:?}");
        for _ in 0..3 {
            assert!(sketch.take_back());
        }
        assert!(!sketch.take_back());
    }
}
