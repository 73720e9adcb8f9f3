//! The stage: the drawing with its handles, and what else the figure's layout has. Two of each where two methods stand
//! side by side.

use std::borrow::Cow;

use egui::{InputState, TextStyle};

use crate::{
    figure::{Body, Caption, ColumnLayout, Frame, Layout, Need, Raster, Seer},
    panels::{Reach, spots},
    widgets::{
        BoundaryMoved, Canvas, CanvasShown, Composition, Spot, boundary, covered, gripped,
        height_for_all, picture_viewport, place_inset, projected, rect_of, spot_id, title_ground,
        title_of_space, under_title,
    },
};

use super::{
    App, Command, clicks,
    large_picture::{enlarge_pictures, is_cramped},
    prelude::*,
    room::INDENT,
    stage_state::StageState,
    typing::told_of,
    ways_out::ways_out,
    why,
};

pub fn show(app: &App, ui: &mut Ui, state: &mut StageState) {
    let rect = ui.max_rect();
    let frames = app.playback.on_stage();
    let methods = app.scene().document().methods();
    let methods = &methods[..frames.len().min(methods.len())];
    // A place that is clicked while an outline is drawn is a point of it.
    let handles = match state.sketch {
        Some(_) => Vec::new(),
        None => app.scene().document().handles(),
    };
    let step = app.bookmark.step();
    let locks = app.locks(&handles);
    let asked = step.map_or(&[][..], |step| &step.drags);
    let look = app.look_on_stage();
    let headings: Vec<String> = methods.iter().map(|it| app.name_of(it)).collect();
    let composition = Composition {
        look,
        spacing: app.spacing(),
        headings: &headings,
        difference: app.difference_told(),
    };
    // What is dragged stays under the pointer: all else has its new place when it has been let go.
    let held = state.laid.take().filter(|_| state.holds_layout(ui));
    let layout = held.unwrap_or_else(|| lay_out(app, ui, state, (rect, &composition)));
    let focused = state.focused.take();
    state.canvas_ids.clear();
    state.handle_ids.clear();
    let columns = frames.iter().zip(methods).zip(&layout.columns);
    for (i, ((frame, method), places)) in columns.enumerate() {
        let whole = rect_of(places.whole);
        let column = Column {
            app,
            index: i,
            places,
            method,
            frame,
            drawing: state.drawing(frame),
            composition: &composition,
            handles: &handles,
            locks,
            asked,
            focused,
        };
        let inner = UiBuilder::new().max_rect(whole).id_salt(("column", i));
        ui.scope_builder(inner, |ui| {
            ui.set_clip_rect(whole.intersect(ui.clip_rect()));
            let shown = column.show(ui, state);
            let focused = shown.focused.and_then(|i| handles.get(i).copied());
            state.focused = state.focused.or(focused);
            state.note(i, &shown, &handles);
            let (at, handles) = ((i, column.drawing), (&handles[..], locks));
            match &state.sketch {
                Some(drawn) => clicks::ask_of_sketch(app, ui, &shown, drawn),
                None => clicks::ask(app, ui, &shown, at, handles, state),
            }
        });
        column.show_ends(ui, whole, layout.board);
    }
    state.laid = Some(layout);
}

fn lay_out(
    app: &App,
    ui: &Ui,
    state: &mut StageState,
    (rect, composition): (Rect, &Composition<'_>),
) -> Layout {
    let width = composition.column_width(rect);
    let look = composition.look;
    // Two methods leave no room for sentences that are not shown.
    let album = app
        .album
        .as_ref()
        .filter(|_| composition.headings.len() == 1);
    let lesson = album.map(|album| album.caption_height(ui.painter(), look, width));
    // The lesson's sentences are those of its scenes.
    let is_told = album.is_some_and(|album| album.find(app.scene()).is_some());
    let mut own = || {
        *state.captions.get(app.on_stage(), ui, width, || {
            height_for_all(ui.painter(), look, app.playback.sentences(), width)
        })
    };
    let caption = match lesson {
        Some(lesson) if is_told => lesson,
        Some(lesson) => lesson.max(own()),
        None => own(),
    };
    ui.painter()
        .rect_filled(rect, 0.0, app.look().theme.background);
    let heights = [caption, 0.0];
    let playback = &app.playback;
    let mut needs = Cow::Borrowed(&playback.needs);
    if app.has_large_picture() {
        enlarge_pictures(needs.to_mut());
    }
    let title = app.title_on_stage();
    let given = [app.settings.board, state.taken];
    let lay_out = |needs: &[Vec<Need>]| {
        composition.lay_out(ui, rect, title.as_deref(), heights, needs, given)
    };
    let mut layout = lay_out(&needs);
    // Where both have no room, what is read leaves its own to the picture that is enlarged.
    if app.has_large_picture() && is_cramped(&layout, &needs) {
        for needs in needs.to_mut() {
            needs.retain(Need::is_drawing);
        }
        layout = lay_out(&needs);
    }
    if let Some(eyes) = &playback.eyes {
        for (frame, places) in playback.frames.iter().zip(&mut layout.columns) {
            place_inset(ui, composition.look, places, &frame.views, eyes);
        }
    }
    let views = layout.columns.iter().flat_map(|column| &column.views);
    state.places = views.copied().collect();
    layout
}

struct Column<'a> {
    app: &'a App,
    index: usize,
    places: &'a ColumnLayout,
    method: &'a MethodCard,
    frame: &'a Frame,
    drawing: (ViewId, Lens),
    composition: &'a Composition<'a>,
    handles: &'a [Handle],
    locks: &'a [Lock],
    /// The kinds of handles that the lesson asks for.
    asked: &'a [String],
    /// The handle that had the focus in the last frame.
    focused: Option<Handle>,
}

impl Column<'_> {
    fn show(&self, ui: &mut Ui, state: &mut StageState) -> CanvasShown {
        let (app, frame) = (self.app, self.frame);
        let hint = state.sketch.as_ref().map(Sketch::hint);
        let late = || (app.playback.is_late).then(|| Message::new("run-later"));
        let hint = hint.or_else(late).map(Caption::new);
        let said = hint.as_ref().unwrap_or(&frame.caption);
        let rect = rect_of(self.places.slot(self.drawing.0).unwrap_or_default());
        let mut shown = self.canvas(ui, state, said, rect);
        let column = (self.index, self.places);
        // The transport says the moment.
        let words = (said, None);
        let composition = self.composition;
        let pointed = composition.beside_the_drawing(ui, column, &frame.views, words, state.lit);
        let is_clicked = ui.input(|input| input.pointer.primary_clicked());
        if let Some(handle) = pointed.and_then(|link| told_of(app, &frame.watch, link)) {
            ui.set_cursor_icon(CursorIcon::Text);
            let click = |input: &InputState| input.pointer.interact_pos();
            let at = ui.input(click).filter(|_| is_clicked);
            app.push_all(at.map(|at| Command::Type(Some(handle), Some(at))));
        }
        let option = pointed.and_then(|link| app.practice.option_of(link));
        app.push_all(option.filter(|_| is_clicked).map(Command::Choose));
        let pixel = pointed.filter(|link| link.number_of(Raster::LINK).is_some());
        if pixel.is_some() && is_clicked {
            app.push(Command::Ask(pixel.map(|it| (it, self.index))));
        }
        state.pointed_on_stage = state.pointed_on_stage.or(pointed);
        // A click in an inset is a click on what is seen there.
        shown.pointed = shown.pointed.or(pointed);
        shown.picture = self.on_picture(ui);
        if let Some(at) = shown.picture {
            self.on_picture_clicked(ui, rect, at);
        }
        shown
    }

    /// A double click enlarges the camera's picture, or puts it back. One click on a picture that stands beside the drawing
    /// asks about a place in it; on one that lies over the drawing the drawing is clicked.
    fn on_picture_clicked(&self, ui: &Ui, drawing: Rect, at: [f64; 2]) {
        use egui::PointerButton::Primary;
        let (is_clicked, is_double) = ui.input(|input| {
            let pointer = &input.pointer;
            (
                pointer.primary_clicked(),
                pointer.button_double_clicked(Primary),
            )
        });
        if is_double {
            self.app.push(Command::Picture);
        } else if is_clicked && !ui.rect_contains_pointer(drawing) {
            let click = Click {
                picture: Some(at),
                locks: self.locks,
                ..Click::default()
            };
            let asked = why::asked(self.app.scene(), self.index, &click);
            self.app
                .push(Command::Ask(asked.map(|it| (it, self.index))));
        }
    }

    /// Where in the picture of the scene's camera the pointer is, if that stands on the drawing.
    fn on_picture(&self, ui: &Ui) -> Option<[f64; 2]> {
        let pointer = ui.input(|input| input.pointer.interact_pos())?;
        self.frame.views.iter().skip(1).find_map(|view| {
            let Body::Space(space) = &view.body else {
                return None;
            };
            let Seer::Camera(_) = space.seer else {
                return None;
            };
            let rect = rect_of(self.places.slot(view.id)?);
            let seen = picture_viewport(rect, &space.seer.into()).rect;
            let at = (pointer - seen.center()) / (0.5 * seen.size());
            let is_there = seen.contains(pointer) && ui.rect_contains_pointer(seen);
            is_there.then(|| [at.x, -at.y].map(f64::from))
        })
    }

    /// What divides it from its own board, and from the column before it.
    fn show_ends(&self, ui: &mut Ui, whole: Rect, board: f32) {
        let (app, look) = (self.app, self.app.look());
        // In one hand there is nothing to be gained by moving it.
        if let Some(between) = self.places.boundary().filter(|_| !app.is_phone()) {
            let id = Id::unique(("boundary", self.index));
            let moved = boundary(ui, look, id, &between).map(|moved| match moved {
                BoundaryMoved::Times(by) => board * by,
                BoundaryMoved::Home => 1.0,
            });
            app.push_all(moved.map(Command::Board));
        }
        if self.index > 0 {
            let line = Stroke::new(1.0, look.theme.hairline);
            ui.painter().vline(whole.left(), whole.y_range(), line);
        }
    }

    /// A space of each object's own has no handles.
    fn spots(&self, ui: &Ui, state: &StageState, id: Id, viewport: &Viewport) -> Vec<Spot> {
        let space = self.frame.space();
        if space.is_some_and(|space| matches!(space.seer, Seer::Apart(_))) {
            return Vec::new();
        }
        let reach = Reach {
            viewport,
            lens: self.drawing.1,
            // What a drag takes hold of is where the button went down.
            pointer: ui.input(|input| input.pointer.press_origin().or(input.pointer.latest_pos())),
            focused: self.focused,
            selected: state.selected,
            asked: self.asked,
            gripped: gripped(ui, id),
        };
        let (look, scene) = (self.app.look(), self.app.scene());
        spots(look, scene, self.handles, self.locks, &reach)
    }

    fn canvas(
        &self,
        ui: &mut Ui,
        state: &mut StageState,
        said: &Caption,
        rect: Rect,
    ) -> CanvasShown {
        let (app, frame, drawing) = (self.app, self.frame, self.drawing);
        let look = self.composition.look;
        let space = frame.space();
        let buttons = state.ways_out_at.filter(|_| self.index == 0);
        let seen_in = space.map_or(rect, |space| under_title(ui, rect, look, space));
        // Ways out of a refused scene lie over no part of it.
        let top = buttons.map_or(seen_in.top(), |buttons| buttons.bottom().max(seen_in.top()));
        let viewport = state.viewport(drawing, seen_in.with_min_y(top));
        let lit = state.lit;
        let id = Id::unique(("stage", self.index));
        let is_drawing = state.sketch.is_some();
        let spots = self.spots(ui, state, id, &viewport);
        let seen = space.map(|space| projected(ui.ctx(), id, space, &drawing.1));
        let scene = (app.scene(), app.stage_revision());
        let marks = match &seen {
            Some(seen) => Cow::Borrowed(&seen[..]),
            None => state.marks(self.index, scene, &app.playback, frame),
        };
        let marks = (app.practice).with_glimpse(marks, lit.filter(|_| self.index == 0));
        let corner = rect.shrink2(vec2(INDENT, 0.0));
        let ground = space.and_then(|space| title_ground(ui, look, corner, space));
        let covered = covered(self.places, drawing.0, look).into_iter();
        let covered: Vec<Rect> = covered.chain(buttons).chain(ground).collect();
        let (panel, method) = (look.say("panel-stage"), app.name_of(self.method));
        let pointed = (!is_drawing)
            .then(|| clicks::pointed(app, ui, (&viewport, drawing.1), self.locks, &marks));
        let shown = Canvas {
            id,
            viewport,
            name: format!("{panel}: {method}"),
            text: caption_text(look.catalog, said),
            spots: &spots,
            seized: &|link| clicks::seized(app, (self.handles, self.locks), link),
            snap: app.settings.snap,
            has_grid: drawing.1 == Lens::Plane,
            reads_pointer: !app.has_hidden_pointer(ui.ctx()),
            pointed: pointed.flatten(),
            marks: &marks,
            covered: &covered,
            lit,
            look,
        }
        .show(ui);
        if let Some(space) = space {
            title_of_space(ui, look, corner, space);
        }
        let is_as_given = app.bookmark.step().is_some() && app.is_untouched();
        self.over_the_drawing(ui, state, &viewport, (rect, shown.is_lost && !is_as_given));
        self.remember(state, (id, &spots), &shown);
        shown
    }

    fn remember(&self, state: &mut StageState, (id, spots): (Id, &[Spot]), shown: &CanvasShown) {
        state.canvas_ids.push(id);
        let ids = spots.iter().map(|spot| spot_id(id, spot.index));
        state.handle_ids.extend(ids);
        state.pointed_on_stage = state.pointed_on_stage.or(shown.pointed);
        state.seen.insert(self.drawing.0, shown.viewport);
    }

    fn over_the_drawing(
        &self,
        ui: &mut Ui,
        state: &mut StageState,
        viewport: &Viewport,
        (rect, is_lost): (Rect, bool),
    ) {
        let app = self.app;
        let is_refused = app.playback.main().is_refused() && state.sketch.is_none();
        if let Some(drawn) = &state.sketch {
            clicks::draw_sketch(app, ui, viewport, drawn);
        }
        if self.index == 0 {
            let buttons = is_refused.then(|| {
                let place = rect.shrink2(vec2(INDENT, 0.5 * INDENT));
                ways_out(app, ui, state, place)
            });
            if buttons != state.ways_out_at {
                state.ways_out_at = buttons;
                ui.ctx().request_repaint();
            }
        }
        if is_lost || state.is_moved(self.drawing.0) {
            fit(app, ui, rect);
        }
    }
}

fn fit(app: &App, ui: &mut Ui, rect: Rect) {
    let look = app.look();
    let text = accent(look, "action-fit");
    let font = TextStyle::Button.resolve(ui.style());
    let name = (ui.painter()).layout_no_wrap(look.say("action-fit"), font, look.theme.ink);
    let size = name.size() + 2.0 * vec2(ui.spacing().button_padding.x + 2.0, 4.0);
    let place = Align2::RIGHT_TOP.anchor_size(rect.right_top() + vec2(-8.0, 32.0), size);
    let button = ui.put(place, Button::new(text).fill(look.theme.background));
    let button = button.on_hover_text(look.say("action-reset-view"));
    if button.clicked() {
        app.push(Command::FitView);
    }
}
