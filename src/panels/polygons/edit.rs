//! What a person can do to the polygons lab's scene.

use crate::{
    geom::{Point, Polygon},
    labs::{
        Handle,
        polygons::{PRESETS, Preset, REGIONS, Scene, SceneError, Texture, random_polygon},
    },
    panels::EditError,
};

/// One change to the scene.
#[derive(Clone, PartialEq, Debug)]
pub enum PolygonsEdit {
    /// A vertex after this handle's: at this place, or in the middle of the edge; on the last edge where it
    /// has no handle.
    Insert(Option<Handle>, Option<[f64; 2]>),
    /// Without this handle's vertex; without the last where it has none.
    Delete(Option<Handle>),
    /// Another texture.
    Texture(Texture),
    /// Another polygon in place of the present one.
    Subject(Polygon),
    /// One more hole.
    Hole(Polygon),
    /// No hole any more.
    NoHoles,
    /// Another clip polygon; none for the window.
    Clip(Option<Polygon>),
    /// One of [`PRESETS`], about what clips.
    Preset(usize),
    /// One of [`REGIONS`], as large as what clips now.
    Region(usize),
    /// A random polygon in place of the present one.
    Random {
        /// How many vertices.
        count: usize,
        /// The same seed gives the same polygon.
        seed: u64,
    },
}

impl PolygonsEdit {
    /// Does the change bring a scene that should be seen whole?
    #[must_use]
    pub const fn brings_another(&self) -> bool {
        matches!(self, Self::Preset(_) | Self::Random { .. })
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
            Self::Hole(hole) => changed.holes.push(hole),
            Self::NoHoles => changed.holes.clear(),
            Self::Clip(clip) => changed.clip = clip,
            Self::Region(i) => {
                if let Some(region) = REGIONS.get(i) {
                    changed.clip = Some(region.outline_about(scene.clip_box())?);
                }
            }
            Self::Preset(i) => {
                if let Some(preset) = PRESETS.get(i) {
                    (changed.subject, changed.holes) = placed(preset, scene)?;
                }
            }
            Self::Random { count, seed } => {
                let about = scene.clip_window();
                changed.subject = random_polygon(&about, count, seed)?;
                changed.holes.clear();
            }
            Self::Insert(handle, at) => {
                if let Some((ring, i)) = ring_of(&mut changed, handle) {
                    *ring = with_vertex_after(ring, i, at)?;
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

/// A preset's outline and holes about what clips in a scene.
fn placed(preset: &Preset, scene: &Scene) -> Result<(Polygon, Vec<Polygon>), EditError> {
    let about = scene.clip_box();
    let subject = preset.outline_about(about)?;
    let holes = preset.holes_about(about)?;
    Ok((subject, holes))
}

/// The outline that a handle's vertex belongs to, and which vertex it is.
fn ring_of(scene: &mut Scene, handle: Option<Handle>) -> Option<(&mut Polygon, usize)> {
    let (ring, i) = match handle {
        Some(Handle::ClipVertex(i)) => (scene.clip.as_mut()?, i),
        Some(Handle::HoleVertex(hole, i)) => (scene.holes.get_mut(hole)?, i),
        Some(Handle::Vertex(i)) => (&mut scene.subject, i),
        _ => {
            let last = scene.subject.vertices().len() - 1;
            (&mut scene.subject, last)
        }
    };
    // A handle may be older than the scene.
    (i < ring.vertices().len()).then_some((ring, i))
}

fn with_vertex_after(ring: &Polygon, i: usize, at: Option<[f64; 2]>) -> Result<Polygon, EditError> {
    let edge = ring.edge(i);
    let middle = [
        edge.p1.x().midpoint(edge.p2.x()),
        edge.p1.y().midpoint(edge.p2.y()),
    ];
    let [x, y] = at.unwrap_or(middle);
    let mut vertices = ring.vertices().to_vec();
    vertices.insert(i + 1, Point::new(x, y)?);
    Ok(Polygon::from_points(vertices)?)
}

fn without_vertex(ring: &Polygon, i: usize) -> Result<Polygon, EditError> {
    let mut vertices = ring.vertices().to_vec();
    vertices.remove(i);
    Polygon::from_points(vertices).map_err(|_| SceneError::TooFewVertices.into())
}
