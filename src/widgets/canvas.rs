//! The stage surface: pan, zoom, grid, handles, and the figure's marks over them.

use egui::{
    Align2, CursorIcon, FontId, Id, Painter, PointerButton, Pos2, Rect, Response, Role, Sense,
    StrokeKind, Ui, WidgetInfo, vec2,
};

use crate::{
    figure::{Link, Mark},
    paint::{self, Around, Placed, Viewport},
};

use super::{
    grid,
    handles::{Handles, Moved, Spot, is_off_grid, snapped},
    hit,
    look::Look,
    pan_zoom::PanZoom,
};

/// Grid dots are at least this far apart, in points.
const GRID_PTS: f64 = 40.0;

/// The wheel draws a space nearer by this part of its distance for a point of its turn.
const PER_POINT: f32 = 0.002;

/// A stage to be shown.
pub struct Canvas<'a> {
    /// Its widget id; handles derive theirs from it.
    pub id: Id,
    /// Where, and which part of the world.
    pub viewport: Viewport,
    /// Its name to a screen reader.
    pub name: String,
    /// What it shows, in words: the caption.
    pub text: String,
    /// What can be taken hold of.
    pub spots: &'a [Spot],
    /// Do handles keep to the grid?
    pub snap: bool,
    /// Is there a grid to keep to?
    pub has_grid: bool,
    /// What a click would pick: drawn over the rest.
    pub pointed: Option<Mark>,
    /// What is drawn.
    pub marks: &'a [Mark],
    /// Where something else stands on it.
    pub covered: &'a [Rect],
    /// What stands out.
    pub lit: Option<Link>,
    /// How it looks.
    pub look: Look<'a>,
}

/// A click on a stage.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StageClick {
    /// On the screen.
    pub at: Pos2,
    /// The second of two in the same place.
    pub is_double: bool,
    /// With Ctrl held.
    pub has_ctrl: bool,
    /// The handle there, by its index.
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

/// What was done to a stage.
pub struct CanvasShown {
    /// As it was drawn.
    pub viewport: Viewport,
    /// The view that the person asked for by panning or zooming.
    pub view: Option<PanZoom>,
    /// It was pushed with the middle button, or with Shift held: an eye goes sideways then, and not round.
    pub pans: bool,
    /// A handle was moved.
    pub moved: Option<Moved>,
    /// The drag of a handle has ended.
    pub released: bool,
    /// The stage was clicked.
    pub clicked: Option<StageClick>,
    /// What the pointer is on.
    pub pointed: Option<Link>,
    /// Where in a camera's picture that stands on the stage: x and y from −1 to 1, y up.
    pub picture: Option<[f64; 2]>,
    /// The handle that has the keyboard's focus, by its index.
    pub focused: Option<usize>,
    /// Of the whole surface.
    pub response: Response,
}

impl Canvas<'_> {
    /// Draws the stage.
    pub fn show(self, ui: &mut Ui) -> CanvasShown {
        let viewport = self.viewport;
        let response = ui.interact(viewport.rect, self.id, Sense::click_and_drag());
        response.widget_info(|| WidgetInfo {
            current_text_value: Some(self.text.clone()),
            ..WidgetInfo::labeled(Role::Canvas, true, &self.name)
        });
        let step = viewport.grid_step(GRID_PTS);
        let handles = Handles {
            id: self.id,
            spots: self.spots,
            viewport: &viewport,
            grid: step,
            snap: self.snap,
            look: self.look,
        };
        let moved = handles.interact(ui, &response);
        let holds_handle = handles.gripped(ui).is_some();
        let view = pan_and_zoom(ui, &response, &self, &handles);

        let theme = self.look.theme;
        let painter = ui.painter_at(viewport.rect);
        painter.rect_filled(viewport.rect, 0.0, theme.background);
        if self.has_grid {
            grid::draw(&painter, &viewport, step, theme.hairline);
        }
        handles.draw_idle(ui, &painter, &response);
        let labels = self.figure(ui, &painter);
        if self.has_grid {
            grid::scale(&painter, &viewport, step, (self.look, &labels));
        }
        if let Some(pointed) = &self.pointed {
            let marks = std::slice::from_ref(pointed);
            paint::stage(
                &painter,
                &viewport,
                theme,
                self.look.catalog,
                marks,
                None,
                Around::default(),
            );
            ui.set_cursor_icon(CursorIcon::PointingHand);
        }
        handles.draw(ui, &painter, &response);
        let said = self
            .has_grid
            .then(|| handles.coordinates(ui, &response, step));
        if let Some(said) = said.flatten() {
            coordinates(&painter, viewport.rect, self.look, said);
        }
        if response.has_focus() {
            let ring = theme.stroke(2.0, theme.accent);
            painter.rect_stroke(viewport.rect.shrink(1.0), 2.0, ring, StrokeKind::Inside);
        }
        let focused = ui.memory(egui::Memory::focused);
        let hover = response.hover_pos().filter(|_| !response.dragged());
        CanvasShown {
            viewport,
            view,
            pans: response.dragged_by(PointerButton::Middle)
                || ui.input(|input| input.modifiers.shift),
            moved,
            released: holds_handle && response.drag_stopped(),
            clicked: click(ui, &response, &handles),
            pointed: hover
                .filter(|at| !self.is_covered(*at))
                .and_then(|at| hit::link_at(&viewport, self.marks, at)),
            focused: focused.and_then(|id| {
                let mut indices = self.spots.iter().map(|spot| spot.index);
                indices.find(|&i| handles.id_of(i) == id)
            }),
            response,
            picture: None,
        }
    }

    /// Does something else stand on it here?
    fn is_covered(&self, at: Pos2) -> bool {
        self.covered.iter().any(|covered| covered.contains(at))
    }

    /// Draws the marks; where their labels stand, which is remembered until the next frame.
    fn figure(&self, ui: &Ui, painter: &Painter) -> Vec<Placed> {
        let remembered = self.id.with("labels");
        let before: Vec<Placed> = ui
            .data(|data| data.get_temp(remembered))
            .unwrap_or_default();
        let Look { theme, catalog, .. } = self.look;
        let (marks, lit) = (self.marks, self.lit);
        let around = Around {
            before: &before,
            covered: self.covered,
        };
        let labels = paint::stage(painter, &self.viewport, theme, catalog, marks, lit, around);
        ui.data_mut(|data| data.insert_temp(remembered, labels.clone()));
        labels
    }
}

fn click(ui: &Ui, response: &Response, handles: &Handles<'_>) -> Option<StageClick> {
    let at = response
        .interact_pointer_pos()
        .filter(|_| response.clicked())?;
    Some(StageClick {
        at,
        is_double: response.double_clicked(),
        has_ctrl: ui.input(|input| input.modifiers.command),
        spot: handles.near(at),
    })
}

/// The place under the pointer, in the corner that nothing else is in.
fn coordinates(painter: &Painter, rect: Rect, look: Look<'_>, said: String) {
    let theme = look.theme;
    let font = FontId::monospace(11.0 * theme.text_scale.sqrt());
    let text = painter.layout_no_wrap(said, font, theme.soft);
    let place = Align2::RIGHT_TOP.anchor_size(rect.right_top() + vec2(-8.0, 8.0), text.size());
    painter.rect_filled(place.expand(4.0), 4.0, theme.background);
    painter.galley(place.min, text, theme.soft);
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
        let is_on_ground = origin.is_some_and(|at| !handles.is_about(at) && !canvas.is_covered(at));
        ui.data_mut(|data| data.insert_temp(pans, is_on_ground));
    }
    let is_on_ground = ui.data(|data| data.get_temp(pans)).unwrap_or(false);
    let drags_ground = response.dragged_by(PointerButton::Primary) && is_on_ground;
    let mut view = PanZoom::of(viewport);
    if drags_ground || response.dragged_by(PointerButton::Middle) {
        view = view.panned(response.drag_delta());
    }
    if let Some(at) = response.hover_pos() {
        let (factor, scroll) = ui.input(|i| (i.zoom_delta(), i.smooth_scroll_delta()));
        // Of a space the wheel draws nearer what is in the middle.
        view = if canvas.has_grid {
            view.zoomed(viewport.rect, f64::from(factor), at)
                .panned(scroll)
        } else {
            let factor = factor * libm::expf(scroll.y * PER_POINT);
            view.zoomed(viewport.rect, f64::from(factor), viewport.rect.center())
        };
    }
    (view != PanZoom::of(viewport)).then_some(view)
}
