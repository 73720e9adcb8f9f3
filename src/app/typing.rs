//! A place that is typed: P₁, a vertex, a side of the window, edited where it lies.

use egui::{Area, Context, Frame, Id, Key, Order, Pos2, RichText, TextEdit, vec2};

use crate::{labs::Handle, widgets::Look};

use super::Command;

/// A place while it is typed.
#[derive(Clone, PartialEq, Debug)]
pub struct Typing {
    /// Whose.
    pub handle: Handle,
    /// So far.
    pub text: String,
    /// Why it cannot lie there.
    pub problem: Option<String>,
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
