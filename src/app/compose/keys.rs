//! Keys of whoever makes a lesson: those that a text field would take, and those of the row that has the focus.

use super::{
    super::{App, Command, prelude::*},
    Act,
    list::row_id,
};

const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

pub fn keys(app: &App, ctx: &Context) -> Vec<Command> {
    let lesson = app.composed().and(app.bookmark.lesson());
    let Some(lesson) = lesson.filter(|_| app.stage.typing.is_none()) else {
        return Vec::new();
    };
    let n_steps = lesson.steps.len();
    let focused = ctx.memory(egui::Memory::focused);
    let row = (0..n_steps).find(|&nth| focused == Some(row_id(nth)));
    let keys = match row {
        // All that is changed is undone in order, letters too.
        None if ctx.text_edit_focused() => vec![
            (CTRL_SHIFT, Key::Z, Command::Redo),
            (CTRL, Key::Z, Command::Undo),
            (CTRL, Key::Y, Command::Redo),
            (CTRL, Key::Enter, Command::Compose(Act::Add(None))),
        ],
        None => Vec::new(),
        Some(nth) => vec![
            (
                Modifiers::NONE,
                Key::Insert,
                Command::Compose(Act::Add(row)),
            ),
            (
                Modifiers::NONE,
                Key::Delete,
                Command::Compose(Act::Delete(nth)),
            ),
            (
                Modifiers::ALT,
                Key::ArrowUp,
                Command::Compose(Act::Move(nth, -1)),
            ),
            (
                Modifiers::ALT,
                Key::ArrowDown,
                Command::Compose(Act::Move(nth, 1)),
            ),
        ],
    };
    let pressed = |input: &mut egui::InputState| -> Vec<Command> {
        let pressed = keys
            .into_iter()
            .filter(|(held, key, _)| input.consume_key(*held, *key));
        pressed.map(|(.., command)| command).collect()
    };
    let pressed = ctx.input_mut(pressed);
    for command in &pressed {
        if let Command::Compose(Act::Move(nth, by)) = command
            && let Some(to) = nth.checked_add_signed(*by).filter(|&to| to < n_steps)
        {
            // The arrow moves the step, and the focus goes with it.
            ctx.memory_mut(|memory| {
                memory.move_focus(egui::FocusDirection::None);
                memory.request_focus(row_id(to));
            });
        }
    }
    pressed
}
