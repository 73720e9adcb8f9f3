//! The stage surface: pan, zoom, grid, handles, and the figure's marks over them.

use egui::{PointerButton, Role};

use crate::{figure::Mark, paint::Placed};

use super::{
    fingers::{Pinch, reach},
    grid,
    handles::{Handles, Moved, Spot, gripped, is_off_grid, snapped},
    headings::focus_ring,
    hit,
    pan_zoom::PanZoom,
    prelude::*,
    taking,
};

const GRID_PTS: f64 = 40.0;
const PER_POINT: f32 = 0.002;
/// A marker and what is around it.
const TAKEN: f32 = 24.0;

pub struct Canvas<'a> {
    pub id: Id,
    pub viewport: Viewport,
    pub name: String,
    pub text: String,
    pub spots: &'a [Spot],
    /// The spot of what is drawn with a link, where that is a thing of the scene.
    pub seized: &'a dyn Fn(Link) -> Option<Seized>,
    pub snap: bool,
    pub has_grid: bool,
    /// Is it said what is under the pointer?
    pub reads_pointer: bool,
    pub pointed: Option<Mark>,
    pub marks: &'a [Mark],
    pub covered: &'a [Rect],
    pub lit: Option<Link>,
    pub look: Look<'a>,
}

/// A thing of the scene that has a handle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Seized {
    /// A press on what is drawn of it takes hold of this spot.
    By(usize),
    /// The lesson locks it.
    Locked,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StageClick {
    pub at: Pos2,
    pub is_double: bool,
    pub has_ctrl: bool,
    pub spot: Option<usize>,
}

/// The world point that a place on the stage stands for: on the grid where handles keep to it, unless Shift or Alt
/// is held.
pub fn place_at(ui: &Ui, viewport: &Viewport, at: Pos2, snap: bool) -> [f64; 2] {
    let exact = viewport.to_world(at);
    if !snap || is_off_grid(ui) {
        return exact;
    }
    let grid = viewport.grid_step(GRID_PTS);
    exact.map(|x| snapped(x, grid))
}

pub struct CanvasShown {
    pub viewport: Viewport,
    pub view: Option<PanZoom>,
    /// It was pushed with the middle button, or with Shift held: an eye goes sideways then, and not round.
    pub pans: bool,
    pub moved: Option<Moved>,
    pub released: bool,
    pub clicked: Option<StageClick>,
    pub pointed: Option<Link>,
    /// The handle that was taken last lies out of sight.
    pub is_lost: bool,
    /// Where in a camera's picture that stands on the stage: x and y from −1 to 1, y up.
    pub picture: Option<[f64; 2]>,
    pub focused: Option<usize>,
    pub response: Response,
}

impl Canvas<'_> {
    pub fn show(self, ui: &mut Ui) -> CanvasShown {
        let viewport = self.viewport;
        let response = ui.interact(viewport.rect, self.id, Sense::click_and_drag());
        response.widget_info(|| WidgetInfo {
            current_text_value: Some(self.text.clone()),
            ..WidgetInfo::labeled(Role::Canvas, true, &self.name)
        });
        let step = viewport.grid_step(GRID_PTS);
        let before: Vec<Placed> = ui
            .data(|data| data.get_temp(self.labels()))
            .unwrap_or_default();
        let [pointed, pressed] = under(ui, &response).map(|at| self.there(ui, &before, at));
        let pinch = Pinch::now(ui, self.id, viewport.rect);
        let handles = Handles {
            id: self.id,
            spots: self.spots,
            viewport: &viewport,
            grid: step,
            snap: self.snap,
            is_space: !self.has_grid,
            pointed: pointed.1,
            reach: reach(ui, taking::REACH),
            look: self.look,
        };
        let moved = handles.interact(ui, &response, pressed.1);
        let holds_handle = gripped(ui, self.id).is_some();
        let hover = response.hover_pos();
        let near = hover.and_then(|at| handles.free_near(ui, at));
        let is_named = |at| (before.iter()).any(|it| it.link.is_some() && it.rect.contains(at));
        let near = near.filter(|_| !hover.is_some_and(is_named));
        // A press takes what is near, whatever else is drawn there.
        let near = near.and_then(|i| handles.spot(i)?.link);
        let is_lost = handles.is_lost(ui);
        let (moved, view) = if pinch.is_on {
            handles.let_go(ui);
            (None, pinched(&viewport, pinch))
        } else {
            (moved, pan_and_zoom(ui, &response, &self, &handles))
        };

        self.draw(ui, &response, (&handles, &before));
        CanvasShown {
            viewport,
            view,
            pans: pinch.is_on
                || response.dragged_by(PointerButton::Middle)
                || ui.input(|input| input.modifiers.shift),
            moved,
            released: holds_handle && (pinch.is_on || response.drag_stopped()),
            clicked: click(ui, &response, &handles).filter(|_| !pinch.is_on),
            pointed: near.or(pointed.0),
            is_lost,
            focused: handles.focused(ui),
            response,
            picture: None,
        }
    }

    /// Where it is kept which labels were drawn, and where.
    fn labels(&self) -> Id {
        self.id.with("labels")
    }

    fn draw(&self, ui: &mut Ui, response: &Response, (handles, before): (&Handles<'_>, &[Placed])) {
        let (viewport, step) = (handles.viewport, handles.grid);
        let theme = self.look.theme;
        let painter = ui.painter_at(viewport.rect);
        painter.rect_filled(viewport.rect, 0.0, theme.background);
        if self.has_grid {
            grid::dots(&painter, viewport, step, theme.hairline);
        }
        handles.draw_idle(ui, &painter, response);
        let labels = self.figure(&painter, before);
        ui.data_mut(|data| data.insert_temp(self.labels(), labels.clone()));
        if self.has_grid {
            let taken = self.taken(&labels);
            grid::numbers(&painter, viewport, step, (self.look, &taken));
        }
        if let Some(pointed) = &self.pointed {
            let marks = std::slice::from_ref(pointed);
            let around = Around::default();
            self.look.stage(&painter, viewport, marks, None, around);
            ui.set_cursor_icon(CursorIcon::PointingHand);
        }
        handles.draw(ui, &painter, response);
        if self.has_grid {
            let said = handles.coordinates(ui, response, step);
            self.say_place(&painter, said, &labels);
        } else {
            let beside = (&labels[..], self.covered, self.reads_pointer);
            handles.draw_names(ui, &painter, response, beside);
        }
        focus_ring(
            &painter,
            self.look,
            response,
            viewport.rect.shrink(1.0),
            2.0,
        );
    }

    fn is_covered(&self, at: Pos2) -> bool {
        self.covered.iter().any(|covered| covered.contains(at))
    }

    /// What is drawn there, the topmost; and the handle of the topmost that can be taken hold of. What is locked gives way to that
    /// one, so that no other thing is lit than a press would take.
    fn there(&self, ui: &Ui, labels: &[Placed], at: Option<Pos2>) -> (Option<Link>, Option<usize>) {
        let Some(at) = at.filter(|at| !self.is_covered(*at)) else {
            return (None, None);
        };
        let label = labels.iter().find(|label| label.rect.contains(at));
        let named = label.and_then(|label| label.link);
        let drawn = hit::links_at(&self.viewport, self.marks, at, reach(ui, hit::REACH));
        let (mut topmost, mut lit) = (None, None);
        // Faces are looked for only where nothing over them can be taken hold of.
        for link in named.into_iter().chain(drawn) {
            let seized = (self.seized)(link);
            topmost = topmost.or(Some(link));
            if seized != Some(Seized::Locked) {
                lit = lit.or(Some(link));
            }
            if let Some(Seized::By(spot)) = seized {
                return (lit, Some(spot));
            }
        }
        (topmost, None)
    }

    fn say_place(&self, painter: &Painter, said: Option<String>, labels: &[Placed]) {
        let Some(said) = said.filter(|_| self.reads_pointer) else {
            return;
        };
        let taken = self.taken(labels);
        coordinates(painter, self.viewport.rect, self.look, (said, &taken));
    }

    /// Where handles are, and what the figure says.
    fn taken(&self, labels: &[Placed]) -> Vec<Rect> {
        let spots = self.spots.iter();
        let spots = spots.map(|spot| self.viewport.to_screen(spot.at));
        let taken = spots.map(|at| Rect::from_center_size(at, Vec2::splat(TAKEN)));
        taken.chain(labels.iter().map(|it| it.rect)).collect()
    }

    /// Draws the marks; where their labels stand, which is remembered until the next frame.
    fn figure(&self, painter: &Painter, before: &[Placed]) -> Vec<Placed> {
        let around = Around {
            before,
            covered: self.covered,
            fades: !self.has_grid,
        };
        let look = self.look;
        look.stage(painter, &self.viewport, self.marks, self.lit, around)
    }
}

/// Where the pointer is, and where the button has gone down for a drag.
fn under(ui: &Ui, response: &Response) -> [Option<Pos2>; 2] {
    let hover = response.hover_pos().filter(|_| !response.dragged());
    let starts = response.drag_started_by(PointerButton::Primary);
    let origin = ui.input(|input| input.pointer.press_origin());
    [hover, origin.filter(|_| starts)]
}

fn click(ui: &Ui, response: &Response, handles: &Handles<'_>) -> Option<StageClick> {
    let is_long = response.long_touched();
    let at = response.interact_pointer_pos();
    let at = at.filter(|_| is_long || response.clicked())?;
    Some(StageClick {
        at,
        is_double: response.double_clicked(),
        has_ctrl: is_long || ui.input(|input| input.modifiers.command),
        spot: handles.clicked(ui, at, response.double_clicked()),
    })
}

/// What the axes' numbers take at the left and at the foot of a drawing, in points.
const NUMBERS: Vec2 = vec2(34.0, 22.0);

/// At the first place of the drawing's edges at which they cover nothing, else where they cover least.
fn coordinates(painter: &Painter, rect: Rect, look: Look<'_>, (said, taken): (String, &[Rect])) {
    let theme = look.theme;
    let font = FontId::monospace(theme.pts(11.0, theme.text_scale.sqrt()));
    let text = painter.layout_no_wrap(said, font, theme.soft);
    let inner = rect.shrink(8.0);
    let bare = Rect::from_x_y_ranges(
        inner.left() + NUMBERS.x..=inner.right(),
        inner.top()..=inner.bottom() - NUMBERS.y,
    );
    let edges = [
        Align2::RIGHT_TOP,
        Align2::RIGHT_BOTTOM,
        Align2::LEFT_TOP,
        Align2::LEFT_BOTTOM,
        Align2::CENTER_TOP,
        Align2::CENTER_BOTTOM,
        Align2::RIGHT_CENTER,
    ];
    let places = edges.map(|edge| edge.align_size_within_rect(text.size(), bare));
    let covered = |place: &Rect| -> f32 {
        let plate = place.expand(4.0);
        let over = taken.iter().filter(|it| it.intersects(plate));
        over.map(|it| it.intersect(plate).area()).sum()
    };
    // The first of those at which they cover as little.
    let least = places.map(|place| (covered(&place), place));
    let least = least.into_iter().min_by(|(a, _), (b, _)| a.total_cmp(b));
    let Some((_, place)) = least else { return };
    painter.rect_filled(place.expand(4.0), 4.0, theme.background);
    painter.galley(place.min, text, theme.soft);
}

/// What was between two fingers stays between them.
fn pinched(viewport: &Viewport, pinch: Pinch) -> Option<PanZoom> {
    let touch = pinch.by?;
    let before = touch.center_pos - touch.translation_delta;
    let view = PanZoom::of(viewport);
    let view = view.zoomed(viewport.rect, f64::from(touch.zoom_delta), before);
    let view = view.panned(touch.translation_delta);
    (view != PanZoom::of(viewport)).then_some(view)
}

/// The view that was asked for. A press near a handle was meant for it, and does not move the view.
fn pan_and_zoom(
    ui: &Ui,
    response: &Response,
    canvas: &Canvas<'_>,
    handles: &Handles<'_>,
) -> Option<PanZoom> {
    let viewport = &canvas.viewport;
    let pans = canvas.id.with("pans");
    if response.drag_started_by(PointerButton::Primary) {
        let origin = ui.input(|input| input.pointer.press_origin());
        let is_free = |at| !handles.is_about(at) && !canvas.is_covered(at);
        let is_on_ground = origin.is_some_and(is_free) && gripped(ui, canvas.id).is_none();
        ui.data_mut(|data| data.insert_temp(pans, is_on_ground));
    }
    let is_on_ground = ui.data(|data| data.get_temp(pans)).unwrap_or(false);
    let drags_ground = response.dragged_by(PointerButton::Primary) && is_on_ground;
    let mut view = PanZoom::of(viewport);
    // A space turns under the right button wherever that goes down: solids may leave no ground.
    let turns = !canvas.has_grid && response.dragged_by(PointerButton::Secondary);
    if drags_ground || turns || response.dragged_by(PointerButton::Middle) {
        view = view.panned(response.drag_delta());
    }
    if let Some(at) = response.hover_pos() {
        let (factor, scroll) = ui.input(|i| (i.zoom_delta(), i.smooth_scroll_delta()));
        // Of a space the wheel draws nearer what is in the middle.
        view = if canvas.has_grid {
            let zoomed = view.zoomed(viewport.rect, f64::from(factor), at);
            zoomed.panned(scroll)
        } else {
            let factor = factor * libm::expf(scroll.y * PER_POINT);
            view.zoomed(viewport.rect, f64::from(factor), viewport.rect.center())
        };
    }
    (view != PanZoom::of(viewport)).then_some(view)
}
