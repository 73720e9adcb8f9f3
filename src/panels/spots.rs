//! A scene's handles as a canvas needs them: places and names.

use egui::Pos2;

use crate::{
    figure::Lens,
    labs::{Handle, Lock, Scene},
    paint::Viewport,
    text::{Formula, Value},
    widgets::{Look, Snap, Spot},
};

/// So many handles can all be shown, and visited with Tab.
const FEW: usize = 200;
/// Of more, those of the vertices within this distance of the pointer, in points,
const NEAR_PTS: f32 = 48.0;
/// and of these the nearest.
const MOST_NEAR: usize = 64;

#[derive(Clone, Copy)]
pub struct Reach<'a> {
    pub viewport: &'a Viewport,
    pub lens: Lens,
    pub pointer: Option<Pos2>,
    /// The handle that has the keyboard's focus: its neighbours are within reach of Tab.
    pub focused: Option<Handle>,
    pub selected: Option<Handle>,
    /// The kinds of handles that the lesson asks for.
    pub asked: &'a [String],
    /// The index of the handle that is being dragged.
    pub gripped: Option<usize>,
}

/// Spots of the scene's handles, in their order. Of very many vertices only those within reach have one: the
/// first, those near the pointer, the focused one and its neighbours, so that Tab walks along the outline.
/// The handles that are no vertices come first then, where Tab finds them.
pub fn spots(
    look: Look<'_>,
    scene: &Scene,
    handles: &[Handle],
    locks: &[Lock],
    reach: &Reach<'_>,
) -> Vec<Spot> {
    let spot = |index: usize| {
        let handle = *handles.get(index)?;
        Some(Spot {
            index,
            at: reach.at(scene, handle)?,
            name: look.catalog.message(&scene.document().called(handle)),
            place: reach.place(scene, handle)?,
            locked: Lock::any_holds(locks, handle),
            asked: reach.asked.iter().any(|kind| kind == handle.kind().id),
            link: handle.link(),
            snap: if handle.kind().is_whole {
                Snap::Offset
            } else {
                Snap::Place
            },
            marked: handle.kind().is_marked,
            selected: reach.selected == Some(handle),
        })
    };
    if handles.len() <= FEW {
        return (0..handles.len()).filter_map(spot).collect();
    }
    let whole = (0..handles.len()).filter(|&i| !handles[i].kind().is_vertex);
    let vertices = reach.vertices(scene, handles);
    whole.chain(vertices).filter_map(spot).collect()
}

impl Reach<'_> {
    fn at(&self, scene: &Scene, handle: Handle) -> Option<[f64; 2]> {
        let world = scene.document().held_at(handle)?;
        self.lens.drawing_from_world(world)
    }

    fn place(&self, scene: &Scene, handle: Handle) -> Option<Value> {
        let at = scene.document().position(handle)?;
        Some(match scene.document().measure(handle) {
            Some(measure) => measure.into(),
            None if self.lens == Lens::Plane => [at[0], at[1]].into(),
            None => Formula::default().place(at).into(),
        })
    }

    fn vertices(&self, scene: &Scene, handles: &[Handle]) -> Vec<usize> {
        let index_of = |handle: Handle| handles.iter().position(|&known| known == handle);
        let first = handles.iter().position(|h| h.kind().is_vertex);
        let mut within: Vec<usize> = first.into_iter().collect();
        if let Some(i) = self.focused.and_then(index_of) {
            within.extend([i.saturating_sub(1), i, i + 1]);
        }
        within.extend(self.selected.and_then(index_of));
        within.extend(self.gripped);
        if let Some(pointer) = self.pointer {
            let distance = |i: usize| {
                let at = self.viewport.to_screen(self.at(scene, handles[i])?);
                Some((at.distance(pointer), i)).filter(|(d, _)| *d <= NEAR_PTS)
            };
            let mut near: Vec<(f32, usize)> = (0..handles.len()).filter_map(distance).collect();
            near.sort_by(|a, b| a.0.total_cmp(&b.0));
            within.extend(near.into_iter().take(MOST_NEAR).map(|(_, i)| i));
        }
        within.retain(|&i| handles.get(i).is_some_and(|handle| handle.kind().is_vertex));
        within.sort_unstable();
        within.dedup();
        within
    }
}
