//! What the stage remembers between frames.

use std::{borrow::Cow, collections::BTreeMap};

use crate::{
    figure::{Body, CodeLinks, Frame, Layout, Mark, Seer, Slot, View},
    labs::Own,
    widgets::{CanvasShown, stage_viewport},
};

use super::{
    command::AskedIn,
    pen::Pen,
    playback::Playback,
    prelude::*,
    run_room::{OfColumns, RunRoom, WatchRooms},
    sight::{Sight, Turned},
    typing::Typing,
    why::Verdicts,
};

/// What can be done about a scene that is refused.
pub struct WaysOut {
    /// The methods that can take it.
    pub methods: Vec<&'static MethodCard>,
    /// What it is called that mends it, and the change.
    pub mended: Option<(&'static str, Own)>,
}

/// What the stage remembers between frames. None of it is part of the document.
#[derive(Default)]
pub struct StageState {
    sight: Sight,
    /// The eye that a link has, until its drawing is there.
    linked: Option<Orbit>,
    /// Where the views that were drawn last have their eyes.
    homes: BTreeMap<ViewId, Orbit>,
    pub lit: Option<Link>,
    pub pointed_on_stage: Option<Link>,
    pub pointed_in_inspector: Option<Link>,
    pub canvas_ids: Vec<Id>,
    pub handle_ids: Vec<Id>,
    pub focused: Option<Handle>,
    /// The vertex that was clicked or dragged last: what Insert and Delete are about.
    pub selected: Option<Handle>,
    /// The handle that was clicked or dragged last.
    pub clicked: Option<Handle>,
    /// What was clicked last, to be told why it was kept or dropped.
    pub asked: Option<AskedIn>,
    pub sketch: Option<Sketch>,
    /// Of a refused scene, and its revision.
    ways_out: Option<(u64, WaysOut)>,
    pub typing: Option<Typing>,
    pub pen: Pen,
    pub captions: RunRoom<f32>,
    pub watch: WatchRooms,
    pub code_links: OfColumns<CodeLinks>,
    pub all_costs: OfColumns<Option<Message>>,
    pub verdicts: Verdicts,
    pub inspected: usize,
    drawn: Option<(ViewId, Lens)>,
    pub seen: BTreeMap<ViewId, Viewport>,
    /// So much of the stage's height is taken by what comes and goes over it.
    pub taken: f32,
    /// Where buttons lie over the drawing that lead out of a scene that is refused.
    pub ways_out_at: Option<Rect>,
    /// Where the views of the stage stood last, column by column.
    pub places: Vec<(ViewId, Slot)>,
    pub laid: Option<Layout>,
    is_dragged: bool,
    layers: Vec<Layers>,
}

/// The marks of one column, kept until something changes: a large scene is not clipped again every frame.
struct Layers {
    under: (u64, &'static str, bool),
    n_under: usize,
    step: usize,
    marks: Vec<Mark>,
}

impl StageState {
    pub fn new(bounds: [[f64; 2]; 2]) -> Self {
        Self {
            sight: Sight::new(bounds),
            ..Self::default()
        }
    }

    pub const fn sight(&self) -> &Sight {
        &self.sight
    }

    /// As it was seen before.
    pub fn see(&mut self, sight: Sight) {
        self.sight = sight;
    }

    /// Which column was clicked last, and which handle was taken.
    pub fn note(&mut self, column: usize, shown: &CanvasShown, handles: &[Handle]) {
        if shown.clicked.is_some() {
            self.inspected = column;
        }
        let clicked = shown.clicked.as_ref().and_then(|click| click.spot);
        let taken = clicked.or(shown.moved.as_ref().map(|moved| moved.spot));
        let handle = taken.and_then(|spot| handles.get(spot)).copied();
        self.clicked = handle.or(self.clicked);
    }

    pub fn fit(&mut self, bounds: [[f64; 2]; 2]) {
        self.sight = Sight::new(bounds);
    }

    pub const fn bounds(&self) -> [[f64; 2]; 2] {
        self.sight.bounds
    }

    /// Is a drawing or a handle of the last frame being dragged, or has it just been let go? Where that was is still to be found.
    pub fn holds_layout(&mut self, ui: &Ui) -> bool {
        let mut ids = self.canvas_ids.iter().chain(&self.handle_ids);
        let dragged = ui.ctx().dragged_id();
        let is_dragged = dragged.is_some_and(|dragged| ids.any(|&id| id == dragged));
        let was_dragged = std::mem::replace(&mut self.is_dragged, is_dragged);
        if was_dragged && !is_dragged {
            ui.ctx().request_repaint();
        }
        is_dragged || was_dragged
    }

    /// The same click takes the question back.
    pub fn ask(&mut self, about: Option<AskedIn>) {
        self.asked = about.filter(|_| about != self.asked);
        if let Some((_, column)) = about {
            self.inspected = column;
        }
    }

    pub fn chosen(&self) -> Option<Handle> {
        self.focused.or(self.selected)
    }

    /// Nearer, or from farther away: about the pointer where that is on a view.
    pub fn zoom(&mut self, ctx: &Context, factor: f64) {
        let pointer = ctx.input(|input| input.pointer.hover_pos());
        let under = |(_, seen): &(_, &Viewport)| pointer.is_some_and(|at| seen.rect.contains(at));
        let pointed = self.seen.iter().find(under);
        if let Some((id, Lens::Eye(eye))) = self.drawn {
            self.turn(id, eye.zoomed(factor));
        } else if let Some((&id, seen)) = pointed.or_else(|| self.seen.iter().next()) {
            let around = pointer.filter(|_| pointed.is_some());
            let around = around.unwrap_or_else(|| seen.rect.center());
            let zoomed = PanZoom::of(seen).zoomed(seen.rect, factor, around);
            self.move_to(id, zoomed);
        }
    }

    pub fn turn(&mut self, id: ViewId, now: Orbit) {
        let Some(&home) = self.homes.get(&id) else {
            return;
        };
        self.sight
            .turned
            .retain(|it| (it.id, it.home) != (id, home));
        self.sight.turned.push(Turned { id, home, now });
    }

    /// The eye of the drawing, where it was turned.
    pub fn turned_eye(&self) -> Option<Orbit> {
        self.drawn.and_then(|(id, _)| self.turned(id))
    }

    /// Has the drawing seen from there, or from where it is seen by itself.
    pub const fn see_from(&mut self, eye: Option<Orbit>) {
        self.linked = eye;
    }

    fn turned(&self, id: ViewId) -> Option<Orbit> {
        let home = *self.homes.get(&id)?;
        let mut turned = self.sight.turned.iter();
        let found = turned.find(|it| (it.id, it.home) == (id, home));
        found.map(|it| it.now)
    }

    /// As far as the scene stays to be found again.
    pub fn move_to(&mut self, id: ViewId, to: PanZoom) {
        let seen = self.seen.get(&id);
        let bounded = seen.map(|seen| to.bounded(&Viewport::fit(seen.rect, self.sight.bounds)));
        self.sight.moved.insert(id, bounded.unwrap_or(to));
    }

    pub fn ways_out(&mut self, scene: &Scene, revision: u64) -> &WaysOut {
        let known = self.ways_out.take();
        let known = known.filter(|(of, _)| *of == revision);
        let (_, ways) = self.ways_out.insert(known.unwrap_or_else(|| {
            let document = scene.document();
            let methods = (document.lab().methods)().into_iter();
            let is_meant = |card: &&MethodCard| !card.is_faulty && !card.is_proof;
            let able = methods.filter(|card| is_meant(card) && document.takes(card.id));
            let ways = WaysOut {
                methods: able.collect(),
                mended: document.mended(),
            };
            (revision, ways)
        }));
        ways
    }

    pub fn is_moved(&self, id: ViewId) -> bool {
        self.sight.moved.contains_key(&id) || self.turned(id).is_some()
    }

    /// What is to be seen: all of a scene that does not lie well in what was to be seen.
    pub fn refitted(&self, scene: &Scene) -> [[f64; 2]; 2] {
        let ([min, max], [now_min, now_max]) = (self.sight.bounds, scene.document().frame());
        let lies_well = (0..2).all(|i| {
            let (size, now) = (max[i] - min[i], now_max[i] - now_min[i]);
            let beyond = (min[i] - now_min[i]).max(now_max[i] - max[i]);
            beyond <= 0.1 * size && now >= 0.5 * size
        });
        if lies_well {
            self.sight.bounds
        } else {
            scene.document().frame()
        }
    }

    pub fn on_screen(&self, world: [f64; 3]) -> Option<Pos2> {
        let (id, lens) = self.drawn?;
        let seen = self.seen.get(&id)?;
        Some(seen.to_screen(lens.drawing_from_world(world)?))
    }

    pub fn is_flat(&self) -> bool {
        self.drawn.is_none_or(|(_, lens)| lens == Lens::Plane)
    }

    pub fn drawing(&mut self, frame: &Frame) -> (ViewId, Lens) {
        let drawing = match frame.views.first() {
            Some(View {
                id,
                body: Body::Space(space),
            }) => {
                let lens = match space.seer {
                    Seer::Eye(eye) | Seer::Apart(eye) => {
                        self.homes.insert(*id, eye);
                        if let Some(linked) = self.linked.take() {
                            self.turn(*id, linked.wide(eye.aspect()));
                        }
                        Lens::Eye(self.turned(*id).unwrap_or(eye))
                    }
                    Seer::Camera(camera) => Lens::Camera(camera),
                };
                (*id, lens)
            }
            _ => (ViewId::PLANE, Lens::Plane),
        };
        self.drawn = Some(drawing);
        drawing
    }

    pub fn viewport(&self, (id, lens): (ViewId, Lens), rect: Rect) -> Viewport {
        let bounds = match lens {
            Lens::Plane => self.sight.bounds,
            Lens::Eye(_) | Lens::Camera(_) => return stage_viewport(rect, &lens),
        };
        let moved = self.sight.moved.get(&id);
        moved.map_or_else(|| Viewport::fit(rect, bounds), |moved| moved.on(rect))
    }

    pub fn marks(
        &mut self,
        column: usize,
        (scene, revision): (&Scene, u64),
        playback: &Playback,
        frame: &Frame,
    ) -> Cow<'_, [Mark]> {
        let transport = &playback.transport;
        let document = scene.document();
        let step = transport.position();
        let methods = document.methods();
        let method = methods.get(column).map_or("", |card| card.id);
        let under = (revision, method, step >= transport.n_steps());
        let known = self.layers.get(column);
        if known.is_none_or(|layers| layers.under != under) {
            let marks = document.backdrop(column, under.2);
            self.layers.truncate(column);
            self.layers.push(Layers {
                under,
                n_under: marks.len(),
                step: usize::MAX,
                marks,
            });
        }
        let is_bare = self.sketch.is_some() || playback.is_late;
        let layers = &mut self.layers[column];
        if is_bare {
            return Cow::Borrowed(&layers.marks[..layers.n_under]);
        }
        if layers.step != step {
            layers.marks.truncate(layers.n_under);
            layers.marks.extend(frame.marks().iter().cloned());
            layers.step = step;
        }
        Cow::Borrowed(&layers.marks)
    }
}
