//! A place that is typed: P₁, a vertex, a side of the window, edited where it lies.

use egui::{Area, Frame, Order, TextEdit};

use crate::{
    labs::{typed_change, written},
    widgets::select,
};

use super::{App, Command, prelude::*};

#[derive(Clone, PartialEq, Debug)]
pub struct Typing {
    pub handle: Handle,
    pub at: Option<Pos2>,
    pub text: String,
    /// What stood there first, all of it selected.
    shown: String,
    pub problem: Option<String>,
}

/// Does the lesson hold it in place?
fn is_held(app: &App, handle: Handle) -> bool {
    let locks = app.locks(&app.scene().document().handles());
    Lock::any_holds(locks, handle)
}

pub fn told_of(app: &App, watch: &Watch, link: Link) -> Option<Handle> {
    let document = app.scene().document();
    let rows = watch.iter().flat_map(|section| &section.rows);
    let rows = rows.filter(|row| row.link == Some(link));
    let places = rows.flat_map(|row| row.cells.iter().flatten());
    let places: Vec<[f64; 3]> = places
        .filter_map(|value| match *value {
            Value::Point([x, y]) => Some([x, y, 0.0]),
            _ => None,
        })
        .collect();
    let is_told = |handle: &Handle| match handle.kind().motion {
        Motion::Axis(_) => handle.link() == Some(link),
        Motion::Plane | Motion::FacingEye if handle.kind().is_whole => false,
        Motion::Plane | Motion::FacingEye => document
            .position(*handle)
            .is_some_and(|at| places.contains(&at)),
    };
    let handle = document.handles().into_iter().find(is_told)?;
    (!is_held(app, handle)).then_some(handle)
}

/// The field beside the handle at `at`. Enter applies it; Escape, or a click elsewhere, leaves it.
pub fn show(app: &App, ctx: &Context, (typing, at): (&mut Typing, Pos2)) {
    let look = app.look();
    let id = Id::unique("typed place");
    let frame = Frame::popup(&ctx.global_style()).fill(look.theme.background);
    let area = Area::new(id.with("area"))
        .order(Order::Foreground)
        .fixed_pos(at + vec2(16.0, 12.0))
        .constrain(true);
    area.show(ctx, |ui| {
        frame.show(ui, |ui| {
            let name = look
                .catalog
                .message(&app.scene().document().called(typing.handle));
            let label = ui.label(RichText::new(name).color(look.theme.soft));
            let field = TextEdit::singleline(&mut typing.text)
                .id(id)
                .desired_width(140.0 * look.theme.text_scale)
                .font(egui::TextStyle::Monospace);
            let field = ui.add(field).labelled_by(label.id);
            if field.changed() {
                typing.problem = None;
            }
            if let Some(problem) = &typing.problem {
                ui.label(RichText::new(problem).color(look.theme.signal_text));
            }
            if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
                app.push(Command::Typed);
            } else if field.clicked_elsewhere() {
                app.push(Command::Type(None, None));
            } else if !field.has_focus() {
                field.request_focus();
                select(ui.ctx(), id, 0..typing.text.chars().count());
            }
        });
    });
}

impl App {
    pub(super) fn start_typing(&mut self, handle: Option<Handle>, at: Option<Pos2>) {
        let handle = handle.filter(|&handle| !is_held(self, handle));
        self.stage.typing = handle.and_then(|handle| {
            let catalog = self.look_at_step().catalog;
            let write = |x: f64| catalog.value(&x.into());
            let document = self.scene().document();
            let written_by = (catalog.lang(), write);
            let text = written(handle, document, self.stage.is_flat(), written_by)?;
            Some(Typing {
                handle,
                at,
                shown: text.clone(),
                text,
                problem: None,
            })
        });
    }

    pub(super) fn apply_typed(&mut self, ctx: &Context, now: f64) {
        let Some(mut typing) = self.stage.typing.take() else {
            return;
        };
        // The keys that come next are the handle's.
        let handles = self.scene().document().handles().into_iter();
        let mut handles = handles.zip(&self.stage.handle_ids);
        if let Some((_, &id)) = handles.find(|(handle, _)| *handle == typing.handle) {
            ctx.memory_mut(|memory| memory.request_focus(id));
        }
        let (document, is_flat) = (self.history.now().document(), self.stage.is_flat());
        let texts = [&*typing.shown, &*typing.text];
        let done = typed_change(typing.handle, document, is_flat, texts)
            .and_then(|edit| self.change(edit, None, now));
        if let Err(Diagnostic { message, .. }) = done {
            typing.problem = Some(self.catalog().message(&message));
            self.stage.typing = Some(typing);
        }
    }
}
