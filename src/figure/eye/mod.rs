//! Where the viewer's eye stands, and what is in its frame: found from what the marks of a run measure.
//!
//! A scene says where the search begins. Of the eyes that see what a step measures in its true size ([`Sights`]) the one that
//! is nearest to that is taken, and brought so near that all that has to be seen ([`Extent`]) just fits.

mod corner;
mod extent;
mod search;
mod sights;
#[cfg(test)]
mod tests;

use glam::DVec3;

use crate::geom::Orbit;

use super::{
    layout::{ColumnLayout, Slot},
    lens::{Lens, Optics},
    space::{Seer, Space},
    view::{Body, View, ViewId},
};

pub use self::search::AROUND;

use self::{
    corner::{count, emptiest},
    extent::{Extent, drawn},
    search::{Search, held},
    sights::Sights,
};

/// What all steps of some runs have to be seen of, in each view of a space that an eye goes round.
#[derive(Clone, Debug, Default)]
pub struct Prospect {
    drawings: Vec<Drawing>,
}

#[derive(Clone, Debug)]
struct Drawing {
    id: ViewId,
    /// The eye of the scene.
    home: Orbit,
    sights: Vec<Sights>,
    extent: Extent,
    /// Width over height of the camera's picture, where that stands on the drawing.
    inset: Option<f64>,
}

/// An eye for each drawing of space; where none has been found, that of the scene.
#[derive(Clone, Debug, Default)]
pub struct Eyes {
    found: Vec<Found>,
}

#[derive(Clone, Debug)]
struct Found {
    id: ViewId,
    home: Orbit,
    eye: Orbit,
    /// What the step in hand marks, and what else is drawn: places that nothing should cover.
    places: [Vec<DVec3>; 2],
}

fn spaces(views: &[View]) -> impl Iterator<Item = (ViewId, Orbit, &Space)> {
    views.iter().filter_map(|view| match &view.body {
        Body::Space(space) => match space.seer {
            Seer::Eye(home) => Some((view.id, home, space)),
            Seer::Camera(_) | Seer::Apart(_) => None,
        },
        _ => None,
    })
}

fn inset_on(views: &[View]) -> Option<f64> {
    views.iter().skip(1).find_map(|view| match &view.body {
        Body::Space(space) => Lens::from(space.seer).aspect(),
        _ => None,
    })
}

impl Prospect {
    /// The views of one more step.
    pub fn add(&mut self, views: &[View]) {
        for (id, home, space) in spaces(views) {
            let is_same = |drawing: &Drawing| (drawing.id, drawing.home) == (id, home);
            let known = self.drawings.iter().position(is_same);
            let known = known.unwrap_or_else(|| {
                self.drawings.push(Drawing {
                    id,
                    home,
                    sights: Vec::new(),
                    extent: Extent::of_solids(space),
                    inset: None,
                });
                self.drawings.len() - 1
            });
            let drawing = &mut self.drawings[known];
            drawing.extent.add(&space.marks);
            let sights = Sights::of(space);
            if !drawing.sights.contains(&sights) {
                drawing.sights.push(sights);
            }
            drawing.inset = drawing.inset.or_else(|| inset_on(views));
        }
    }

    /// All that another run has to be seen of, too.
    pub fn extend(&mut self, other: &Self) {
        for more in &other.drawings {
            let is_same =
                |drawing: &&mut Drawing| (drawing.id, drawing.home) == (more.id, more.home);
            let Some(drawing) = self.drawings.iter_mut().find(is_same) else {
                self.drawings.push(more.clone());
                continue;
            };
            drawing.sights.extend(more.sights.iter().cloned());
            drawing.extent.extend(&more.extent);
            drawing.inset = drawing.inset.or(more.inset);
        }
    }

    /// The eyes for a step that has these views, of so many methods side by side: what it measures comes first. Where
    /// `shared` ones, of other steps as well, are good enough they are taken.
    pub fn eyes(&self, now: &[&[View]], n_columns: usize, shared: Option<&Eyes>) -> Eyes {
        let found = |drawing: &Drawing| {
            let shown = now.iter().flat_map(|views| spaces(views));
            let shown = shown.filter(|(id, home, _)| (*id, *home) == (drawing.id, drawing.home));
            let shown: Vec<&Space> = shown.map(|(.., space)| space).collect();
            let own: Vec<Sights> = shown.iter().map(|space| Sights::of(space)).collect();
            let places = held(drawing.home, drawing.extent.places());
            let search = Search {
                home: drawing.home,
                now: &own,
                run: &drawing.sights,
                places: &places,
                inset: drawing.inset,
                n_columns,
            };
            let nearest = search.nearest();
            let shared = shared.and_then(|eyes| eyes.of(drawing.id, drawing.home));
            let shared = shared.filter(|shared| search.may_take(&shared.eye, &nearest));
            Found {
                id: drawing.id,
                home: drawing.home,
                eye: shared.map_or(nearest, |shared| shared.eye),
                places: [
                    own.iter().flat_map(Sights::places).collect(),
                    shown.iter().flat_map(|space| drawn(space)).collect(),
                ],
            }
        };
        Eyes {
            found: self.drawings.iter().map(found).collect(),
        }
    }
}

impl Eyes {
    /// Lets the views of a step be seen by these eyes.
    pub fn turn(&self, views: &mut [View]) {
        for view in views {
            if let Body::Space(space) = &mut view.body
                && let Seer::Eye(home) = space.seer
                && let Some(found) = self.of(view.id, home)
            {
                space.seer = Seer::Eye(found.eye);
            }
        }
    }

    fn of(&self, id: ViewId, home: Orbit) -> Option<&Found> {
        let mut found = self.found.iter();
        found.find(|found| (found.id, found.home) == (id, home))
    }

    /// Puts the camera's picture into the emptiest corner of the drawing that it stands on. That one's middle stands at
    /// `at`, and its picture's 1 is `scale` points.
    pub fn place_inset(
        &self,
        places: &mut ColumnLayout,
        (inset, title): (ViewId, f32),
        (id, eye): (ViewId, Orbit),
        (at, scale): ([f32; 2], f32),
    ) {
        let found = self.found.iter().find(|it| (it.id, it.eye) == (id, eye));
        let slots = places.slot(id).zip(places.slot(inset));
        let (Some(found), Some((drawing, slot)), Some(optics)) =
            (found, slots, Optics::of(&Lens::Eye(eye)))
        else {
            return;
        };
        if !places.over(id).any(|over| over == slot) {
            return;
        }
        let on_page = |marks: &[DVec3]| {
            let seen = marks.iter().map(|&mark| {
                let [x, y] = optics.picture_from_view(optics.view_from_world(mark));
                [at[0] + scale * x as f32, at[1] - scale * y as f32]
            });
            seen.collect::<Vec<_>>()
        };
        let [own, others] = found.places.each_ref().map(|marks| on_page(marks));
        let under = |slot: Slot| {
            WEIGHT_OF_STEP * count(own.iter().copied(), slot) + count(others.iter().copied(), slot)
        };
        places.put(inset, emptiest(drawing, slot, title, under));
    }
}

/// What the step in hand marks counts for so many of what stands there anyway.
const WEIGHT_OF_STEP: usize = 8;

/// How well an eye sees what a space marks, in a drawing.
#[cfg(test)]
pub(crate) struct Judged {
    /// Of lengths, angles, distances between points, and areas.
    pub shortfalls: [f64; 4],
    /// On the drawing: what is marked, and what has to be in the frame.
    pub marked: Vec<[f64; 2]>,
    pub framed: Vec<[f64; 2]>,
}

/// The same, where the drawing's 1 is `scale` points.
#[cfg(test)]
pub(crate) fn judged(space: &Space, eye: Orbit, scale: f64) -> Judged {
    let optics = Optics::of(&Lens::Eye(eye)).expect("an eye sees");
    let on_drawing = |at: DVec3| optics.picture_from_view(optics.view_from_world(at));
    let sights = Sights::of(space);
    let mut extent = Extent::of_solids(space);
    extent.add(&space.marks);
    let [framed, ..] = extent.places();
    let seen = sights.seen(&optics);
    Judged {
        shortfalls: seen.shortfalls(search::APART_PTS / scale),
        marked: sights.places().map(on_drawing).collect(),
        framed: framed.into_iter().map(on_drawing).collect(),
    }
}
