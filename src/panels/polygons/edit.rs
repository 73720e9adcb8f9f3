//! What a person can do to the polygons lab's scene.

use crate::{
    geom::{Point, Polygon},
    labs::{
        Handle,
        polygons::{Scene, SceneError, Texture},
    },
    panels::EditError,
};

/// One change to the scene.
#[derive(Clone, PartialEq, Debug)]
pub enum PolygonsEdit {
    /// A vertex in the middle of the edge that begins at this handle's; of the last edge where it has none.
    Insert(Option<Handle>),
    /// Without this handle's vertex; without the last where it has none.
    Delete(Option<Handle>),
    /// Another texture.
    Texture(Texture),
    /// Another polygon in place of the present one.
    Subject(Polygon),
}

impl PolygonsEdit {
    /// Does the change bring a scene that should be seen whole?
    #[must_use]
    pub const fn brings_another(&self) -> bool {
        matches!(self, Self::Subject(_))
    }

    /// Makes the change.
    ///
    /// # Errors
    /// [`EditError`] where the scene would not be valid: it is left as it was.
    pub fn apply(self, scene: &mut Scene) -> Result<(), EditError> {
        let mut changed = scene.clone();
        match self {
            Self::Texture(texture) => changed.texture = texture,
            Self::Subject(subject) => (changed.subject, changed.holes) = (subject, Vec::new()),
            Self::Insert(handle) => {
                if let Some((ring, i)) = ring_of(&mut changed, handle) {
                    *ring = with_vertex_after(ring, i)?;
                }
            }
            Self::Delete(handle) => {
                if let Some((ring, i)) = ring_of(&mut changed, handle) {
                    *ring = without_vertex(ring, i)?;
                }
            }
        }
        *scene = changed.check()?;
        Ok(())
    }
}

/// The outline that a handle's vertex belongs to, and which vertex it is.
fn ring_of(scene: &mut Scene, handle: Option<Handle>) -> Option<(&mut Polygon, usize)> {
    match handle {
        Some(Handle::ClipVertex(i)) => scene.clip.as_mut().map(|clip| (clip, i)),
        Some(Handle::HoleVertex(hole, i)) => scene.holes.get_mut(hole).map(|hole| (hole, i)),
        Some(Handle::Vertex(i)) => Some((&mut scene.subject, i)),
        _ => {
            let last = scene.subject.vertices().len() - 1;
            Some((&mut scene.subject, last))
        }
    }
}

fn with_vertex_after(ring: &Polygon, i: usize) -> Result<Polygon, EditError> {
    let edge = ring.edge(i);
    let middle = Point::new(
        edge.p1.x().midpoint(edge.p2.x()),
        edge.p1.y().midpoint(edge.p2.y()),
    )?;
    let mut vertices = ring.vertices().to_vec();
    vertices.insert(i + 1, middle);
    Ok(Polygon::from_points(vertices)?)
}

fn without_vertex(ring: &Polygon, i: usize) -> Result<Polygon, EditError> {
    let mut vertices = ring.vertices().to_vec();
    vertices.remove(i);
    Polygon::from_points(vertices).map_err(|_| SceneError::TooFewVertices.into())
}
