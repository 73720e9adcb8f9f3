//! A place that is typed: P₁, a vertex, a side of the window, edited where it lies.

use egui::{Area, Context, Frame, Id, Key, Order, Pos2, RichText, TextEdit, vec2};

use crate::{
    figure::{Link, Watch},
    labs::{Handle, Lock, Motion, Scene},
    lesson::LessonStep,
    text::Value,
    widgets::Look,
};

use super::Command;

/// A place while it is typed.
#[derive(Clone, PartialEq, Debug)]
pub struct Typing {
    /// Whose.
    pub handle: Handle,
    /// Where on the screen, if it is not at the handle.
    pub at: Option<Pos2>,
    /// So far.
    pub text: String,
    /// Why it cannot lie there.
    pub problem: Option<String>,
}

/// Does the lesson hold it in place?
pub fn is_held(step: Option<&LessonStep>, scene: &Scene, handle: Handle) -> bool {
    let locks = step.map(|step| step.locks_in(scene, &scene.document().handles()));
    locks.is_some_and(|locks| Lock::any_holds(locks, handle))
}

/// The handle of which the rows under a link tell: whose place they show, or the side that they are about. None that the
/// lesson holds.
pub fn told_of(
    scene: &Scene,
    step: Option<&LessonStep>,
    watch: &Watch,
    link: Link,
) -> Option<Handle> {
    let document = scene.document();
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
    (!is_held(step, scene, handle)).then_some(handle)
}

/// The field beside the handle at `at`. Enter applies it; Escape, or a click elsewhere, leaves it.
pub fn show(
    ctx: &Context,
    look: Look<'_>,
    (typing, at): (&mut Typing, Pos2),
    commands: &mut Vec<Command>,
) {
    let id = Id::unique("typed place");
    let frame = Frame::popup(&ctx.global_style()).fill(look.theme.background);
    let area = Area::new(id.with("area"))
        .order(Order::Foreground)
        .fixed_pos(at + vec2(16.0, 12.0))
        .constrain(true);
    area.show(ctx, |ui| {
        frame.show(ui, |ui| {
            let name = look.catalog.message(&typing.handle.name());
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
                commands.push(Command::Typed);
            } else if field.clicked_elsewhere() {
                commands.push(Command::Type(None));
            } else if !field.has_focus() {
                field.request_focus();
            }
        });
    });
}
