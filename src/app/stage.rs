//! The stage: the figure, a second view below it where the method has one, and the caption. Two of each
//! where two methods stand side by side.

use egui::{Align2, Id, Rect, Stroke, Ui, UiBuilder, pos2, vec2};

use crate::{
    figure::{Caption, Frame, ViewId},
    labs::{Handle, Lock, MethodCard, Sketch},
    paint::Viewport,
    panels::{Reach, spots},
    text::Message,
    widgets::{
        Canvas, CanvasShown, Spot, caption, caption_height, caption_text, column_title, gripped,
        strip_height, view,
    },
};

use super::{Command, clicks, model::Model, sketch, stage_state::StageState};

/// The least height that a stage keeps when a second view wants room.
const LEAST_STAGE: f32 = 140.0;

/// What can be taken hold of.
struct Hands<'a> {
    handles: &'a [Handle],
    locks: &'a [Lock],
    /// The handle that had the focus in the last frame.
    focused: Option<Handle>,
}

/// Draws the stage into all the room there is.
pub fn show(model: &Model<'_>, ui: &mut Ui, state: &mut StageState, commands: &mut Vec<Command>) {
    let rect = ui.max_rect();
    let frames = model.playback.frames();
    let methods = model.scene.document().methods();
    // A place that is clicked while an outline is drawn is a point of it.
    let is_drawing = state.sketch.is_some();
    let handles = if is_drawing {
        Vec::new()
    } else {
        model.scene.document().handles()
    };
    // A scene from elsewhere is the reader's own: nothing of it is locked.
    let step = model.place.step().filter(|_| !state.is_foreign);
    let hands = Hands {
        handles: &handles,
        locks: step.map_or(&[][..], |step| &step.locks),
        focused: state.focused.take(),
    };
    state.canvas_ids.clear();
    state.handle_ids.clear();
    let width = rect.width() / frames.len().max(1) as f32;
    // As much room under both stages, so that they show the same place.
    let beside = frames.iter().flat_map(|frame| frame.views.iter().skip(1));
    let second_height = beside
        .filter_map(|view| strip_height(model.look.theme, width, view))
        .reduce(f32::max);
    for (i, (frame, method)) in frames.iter().zip(methods).enumerate() {
        let left = (rect.left() + i as f32 * width).round();
        let right = (rect.left() + (i + 1) as f32 * width).round();
        let column = Rect::from_x_y_ranges(left..=right, rect.y_range());
        let column = Column {
            index: i,
            is_one_of_two: frames.len() > 1,
            second_height,
            rect: column,
            method,
            hands: &hands,
        };
        let inner = UiBuilder::new()
            .max_rect(column.rect)
            .id_salt(("column", i));
        ui.scope_builder(inner, |ui| {
            ui.set_clip_rect(column.rect.intersect(ui.clip_rect()));
            let shown = column.show(model, ui, state, frame);
            state.focused = state
                .focused
                .or(shown.focused.and_then(|i| handles.get(i).copied()));
            match &state.sketch {
                Some(drawn) => sketch::ask(model, ui, &shown, drawn, commands),
                None => clicks::ask(
                    model,
                    ui,
                    &shown,
                    (hands.handles, hands.locks),
                    state,
                    commands,
                ),
            }
        });
        if i > 0 {
            let line = Stroke::new(1.0, model.look.theme.hairline);
            ui.painter().vline(left, rect.y_range(), line);
        }
    }
}

/// One method's part of the stage.
struct Column<'a> {
    index: usize,
    is_one_of_two: bool,
    /// Height of the second view, if any column has one.
    second_height: Option<f32>,
    rect: Rect,
    method: &'static MethodCard,
    hands: &'a Hands<'a>,
}

impl Column<'_> {
    fn show(
        &self,
        model: &Model<'_>,
        ui: &mut Ui,
        state: &mut StageState,
        frame: &Frame,
    ) -> CanvasShown {
        let look = model.look;
        let hint = state.sketch.as_ref().map(Sketch::hint);
        let late = || (model.playback.is_late()).then(|| Message::new("run-later"));
        let hint = hint.or_else(late).map(Caption::new);
        let said = hint.as_ref().unwrap_or(&frame.caption);
        let n_rows = self.caption_rows(model);
        let whole = if self.is_one_of_two {
            self.title(model, ui)
        } else {
            self.rect
        };
        let (stage, rest) = split(
            whole,
            caption_height(look.theme, n_rows).min(0.4 * self.rect.height()),
        );
        let height = self.second_height.unwrap_or(0.0);
        let (stage, below) = if height > 0.0 && stage.height() - height >= LEAST_STAGE {
            let (stage, below) = split(stage, height);
            (stage, Some(below))
        } else {
            (stage, None)
        };
        let shown = self.canvas(model, ui, state, frame, said, stage);
        match (frame.views.get(1), below) {
            (Some(second), Some(below)) => {
                let pointed = view(ui, look, below, second, state.lit);
                state.pointed_on_stage = state.pointed_on_stage.or(pointed);
            }
            (None, Some(blank)) => {
                ui.painter().rect_filled(blank, 0.0, look.theme.background);
            }
            (_, None) => {}
        }
        ui.painter().rect_filled(rest, 0.0, look.theme.background);
        let line = Stroke::new(1.0, look.theme.hairline);
        ui.painter().hline(rest.x_range(), rest.top() + 0.5, line);
        caption(ui, look, rest, n_rows, said);
        shown
    }

    /// The method's name above its stage; the room below.
    fn title(&self, model: &Model<'_>, ui: &mut Ui) -> Rect {
        let look = model.look;
        let height = (36.0 * look.theme.text_scale).round();
        let strip = self.rect.with_max_y(self.rect.top() + height);
        ui.painter().rect_filled(strip, 0.0, look.theme.background);
        let difference = model.playback.difference();
        let note = difference
            .filter(|difference| difference.column == self.index)
            .map(|difference| look.catalog.message(&difference.message()));
        column_title(
            &ui.painter_at(strip),
            look,
            (strip.left_center() + vec2(24.0, 0.0), Align2::LEFT_CENTER),
            strip.width() - 32.0,
            &look.say(self.method.name_key),
            note.as_deref(),
        );
        self.rect.with_min_y(strip.bottom())
    }

    /// A caption that has little width gets another line.
    fn caption_rows(&self, model: &Model<'_>) -> usize {
        let wide = 560.0 * model.look.theme.text_scale;
        if self.rect.width() < wide && !model.is_low {
            3
        } else {
            2
        }
    }

    fn spots(
        &self,
        model: &Model<'_>,
        ui: &Ui,
        state: &StageState,
        id: Id,
        viewport: &Viewport,
    ) -> Vec<Spot> {
        let reach = Reach {
            viewport,
            // What a drag takes hold of is where the button went down.
            pointer: ui.input(|input| input.pointer.press_origin().or(input.pointer.latest_pos())),
            focused: self.hands.focused,
            selected: state.selected,
            gripped: gripped(ui, id),
        };
        let Hands { handles, locks, .. } = self.hands;
        spots(model.look, model.scene, handles, locks, &reach)
    }

    fn canvas(
        &self,
        model: &Model<'_>,
        ui: &mut Ui,
        state: &mut StageState,
        frame: &Frame,
        said: &Caption,
        rect: Rect,
    ) -> CanvasShown {
        let look = model.look;
        let viewport = state.viewport(ViewId::PLANE, rect);
        let lit = state.lit;
        let id = Id::unique(("stage", self.index));
        let spots = self.spots(model, ui, state, id, &viewport);
        let shown = Canvas {
            id,
            viewport,
            name: format!(
                "{}: {}",
                look.say("panel-stage"),
                look.say(self.method.name_key)
            ),
            text: caption_text(look.catalog, said),
            spots: &spots,
            snap: model.settings.snap,
            marks: state.marks(self.index, model, frame),
            lit,
            look,
        }
        .show(ui);
        state.canvas_ids.push(id);
        let ids = spots.iter().map(|spot| id.with(spot.index));
        state.handle_ids.extend(ids);
        if let Some(drawn) = &state.sketch {
            sketch::draw(model, ui, &viewport, drawn);
        }
        state.pointed_on_stage = state.pointed_on_stage.or(shown.pointed);
        state.saw(ViewId::PLANE, shown.viewport);
        shown
    }
}

/// The upper part, and the lower one of this height.
fn split(rect: Rect, height: f32) -> (Rect, Rect) {
    let y = (rect.bottom() - height).round();
    (
        Rect::from_min_max(rect.min, pos2(rect.right(), y)),
        Rect::from_min_max(pos2(rect.left(), y), rect.max),
    )
}
