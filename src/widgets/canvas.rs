//! The stage surface: pan, zoom, grid, handles, and the figure's marks over them.

use egui::{Mesh, PointerButton, Role};

use crate::{figure::Mark, paint::Placed};

use super::{
    fingers::{Pinch, reach},
    handles::{Handles, Moved, Spot, gripped, is_off_grid, snapped},
    headings::focus_ring,
    hit,
    pan_zoom::PanZoom,
    prelude::*,
    taking,
};

const GRID_PTS: f64 = 40.0;
const PER_POINT: f32 = 0.002;
const DOT: f32 = 1.5;
/// Dots at most: a stage as large as a 4K screen holds fewer at any zoom.
const MAX_DOTS: f64 = 20_000.0;
const BETWEEN: f64 = 56.0;
const FROM_EDGE: f32 = 4.0;
/// A marker and what is around it.
const TAKEN: f32 = 24.0;
const MOST_NUMBERS: f64 = 200.0;

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
        let focused = ui.memory(egui::Memory::focused);
        let focused = focused.and_then(|id| {
            let mut indices = self.spots.iter().map(|spot| spot.index);
            indices.find(|&i| handles.id_of(i) == id)
        });
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
            focused,
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
            dots(&painter, viewport, step, theme.hairline);
        }
        handles.draw_idle(ui, &painter, response);
        let labels = self.figure(&painter, before);
        ui.data_mut(|data| data.insert_temp(self.labels(), labels.clone()));
        if self.has_grid {
            scale(&painter, viewport, step, (self.look, &labels));
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
        let spots = self
            .spots
            .iter()
            .map(|spot| self.viewport.to_screen(spot.at));
        let taken = spots.map(|at| Rect::from_center_size(at, Vec2::splat(TAKEN)));
        let taken: Vec<Rect> = taken.chain(labels.iter().map(|label| label.rect)).collect();
        coordinates(painter, self.viewport.rect, self.look, (said, &taken));
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

/// In the first corner in which they cover nothing, else in the first.
fn coordinates(painter: &Painter, rect: Rect, look: Look<'_>, (said, taken): (String, &[Rect])) {
    let theme = look.theme;
    let font = FontId::monospace(theme.pts(11.0, theme.text_scale.sqrt()));
    let text = painter.layout_no_wrap(said, font, theme.soft);
    let inner = rect.shrink(8.0);
    let corners = [Align2::RIGHT_TOP, Align2::RIGHT_BOTTOM, Align2::LEFT_TOP];
    let places = corners.map(|corner| corner.align_size_within_rect(text.size(), inner));
    let is_free = |place: &&Rect| !taken.iter().any(|it| it.intersects(place.expand(4.0)));
    let place = *places.iter().find(is_free).unwrap_or(&places[0]);
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

fn scale(painter: &Painter, viewport: &Viewport, step: f64, (look, labels): (Look<'_>, &[Placed])) {
    let rect = viewport.rect;
    let lines = (BETWEEN / (step * viewport.scale)).ceil().max(1.0);
    // Of grids of 1, 2 or 5 every fifth line has a round number, of others it has one, too.
    let mut round = [1.0, 2.0, 5.0, 10.0].into_iter();
    let every = step * round.find(|&n| n >= lines).unwrap_or(lines);
    let font = FontId::monospace(look.theme.pts(9.5, look.theme.text_scale));
    let [left, top] = viewport.to_world(rect.min);
    let [right, bottom] = viewport.to_world(rect.max);
    let room = f64::from(font.size) * 1.5 / viewport.scale;
    let numbers = |from: f64, to: f64| {
        let (first, last) = ((from / every).ceil(), (to / every).floor());
        let has_numbers = last - first < MOST_NUMBERS && first.abs().max(last.abs()) < 1e15;
        let n = (last - first + 1.0).max(0.0);
        let n = if has_numbers { n } else { 0.0 };
        (0..n as u32).map(move |i| (first + f64::from(i)) * every)
    };
    let number = |at: Pos2, align: Align2, x: f64| {
        let (colour, ground) = (look.theme.soft, look.theme.background);
        // Beside each other fractions would mix with decimals.
        let text = look.catalog.alike(Notation::Decimals).value(&x.into());
        let text = painter.layout_no_wrap(text, font.clone(), colour);
        let place = align.anchor_size(at, text.size());
        // A number gives way to what the figure says.
        let is_taken = |label: &Placed| label.rect.intersects(place.expand(4.0));
        if labels.iter().any(is_taken) {
            return;
        }
        painter.rect_filled(place.expand2(vec2(2.0, 0.0)), 0.0, ground);
        painter.galley(place.min, text, colour);
    };
    for x in numbers(left + 2.0 * room, right - room) {
        let at = pos2(viewport.to_screen([x, 0.0]).x, rect.bottom() - FROM_EDGE);
        number(at, Align2::CENTER_BOTTOM, x);
    }
    for y in numbers(bottom + 2.0 * room, top - room) {
        let at = pos2(rect.left() + FROM_EDGE, viewport.to_screen([0.0, y]).y);
        number(at, Align2::LEFT_CENTER, y);
    }
}

fn dots(painter: &Painter, viewport: &Viewport, step: f64, colour: Color32) {
    let [left, top] = viewport.to_world(viewport.rect.min);
    let [right, bottom] = viewport.to_world(viewport.rect.max);
    let [x0, x1, y0, y1] = [left, right, bottom, top].map(|w| (w / step).round());
    let n_dots = (x1 - x0 + 1.0) * (y1 - y0 + 1.0);
    // Where the numbers are too large for a step to make a difference, there is no grid.
    let is_exact = [x0, x1, y0, y1].iter().all(|k| k.abs() < 1e15);
    if !(n_dots <= MAX_DOTS && is_exact) {
        return;
    }
    let pixels = painter.pixels_per_point();
    let at_pixel = |at: Pos2| {
        let whole = |v: f32| (v * pixels).round() / pixels;
        Pos2::new(whole(at.x), whole(at.y))
    };
    let mut mesh = Mesh::default();
    for i in 0..=(x1 - x0) as u32 {
        for j in 0..=(y1 - y0) as u32 {
            let world = [(x0 + f64::from(i)) * step, (y0 + f64::from(j)) * step];
            let centre = at_pixel(viewport.to_screen(world));
            mesh.add_colored_rect(Rect::from_center_size(centre, Vec2::splat(DOT)), colour);
        }
    }
    painter.add(Shape::mesh(mesh));
}
