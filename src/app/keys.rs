//! From key presses to commands.

use egui::{Context, Event, FocusDirection, Id, Key, Modifiers};

use super::command::{BINDINGS, Binding, Command};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Focus {
    /// Nothing, or the stage, has the focus: every key is a command.
    Free,
    /// A handle has it: arrows move the handle.
    Handle,
    /// A button or a menu has it: arrows, Space and Enter are egui's.
    Widget,
    /// Text is being written: only keys that write nothing are commands.
    Text,
}

impl Focus {
    pub fn now(ctx: &Context, stages: &[Id], handles: &[Id]) -> Self {
        if ctx.text_edit_focused() {
            return Self::Text;
        }
        match ctx.memory(egui::Memory::focused) {
            None => Self::Free,
            Some(id) if stages.contains(&id) => Self::Free,
            Some(id) if handles.contains(&id) => Self::Handle,
            Some(_) => Self::Widget,
        }
    }

    fn takes(self, key: Key, modifiers: Modifiers) -> bool {
        let is_arrow = matches!(
            key,
            Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown
        );
        match self {
            Self::Free => false,
            Self::Handle => is_arrow && !modifiers.command,
            Self::Widget => {
                (is_arrow && !modifiers.command) || matches!(key, Key::Space | Key::Enter)
            }
            // A text field undoes and saves nothing of the scene's.
            Self::Text => !matches!(
                key,
                Key::F1 | Key::F5 | Key::F6 | Key::F7 | Key::F9 | Key::Escape
            ),
        }
    }
}

/// The commands of the keys that were pressed; a key of one that `may` not be done is left to whatever has the focus.
pub fn commands(ctx: &Context, focus: Focus, may: impl Fn(&Command) -> bool) -> Vec<Command> {
    let mut commands = Vec::new();
    ctx.input_mut(|input| {
        input.events.retain(|event| {
            let Event::Key {
                key,
                pressed: true,
                repeat,
                modifiers,
                ..
            } = event
            else {
                return true;
            };
            let binding = binding(*key, *modifiers).filter(|_| !focus.takes(*key, *modifiers));
            let Some((.., command, _)) = binding.filter(|(.., command, _)| may(command)) else {
                return true;
            };
            if !repeat || command.repeats() {
                commands.push(command.clone());
            }
            // egui closes its own popups with Escape, too.
            *key == Key::Escape
        });
    });
    if focus == Focus::Free && !commands.is_empty() {
        // The arrow that stepped the trace must not move the focus as well.
        ctx.memory_mut(|memory| memory.move_focus(FocusDirection::None));
    }
    commands
}

/// Where nothing has the focus yet, Tab goes to the stage first.
pub fn tab_to(ctx: &Context, first: Option<Id>) {
    let Some(first) = first else {
        return;
    };
    let is_tab = |event: &Event| match event {
        // Shift may have been let go since.
        Event::Key {
            key: Key::Tab,
            pressed: true,
            modifiers,
            ..
        } => !modifiers.any(),
        _ => false,
    };
    let was_pressed = ctx.input_mut(|input| {
        let n_events = input.events.len();
        input.events.retain(|event| !is_tab(event));
        input.events.len() < n_events
    });
    if was_pressed {
        ctx.memory_mut(|memory| {
            memory.move_focus(FocusDirection::None);
            memory.request_focus(first);
        });
    }
}

fn binding(key: Key, modifiers: Modifiers) -> Option<&'static Binding> {
    let is_it = |(wanted, k, ..): &&Binding| {
        // These two are written with Shift on some keyboards and without on others.
        let shift = match k {
            Key::Questionmark | Key::Plus => wanted.shift,
            _ => modifiers.shift,
        };
        *k == key && Modifiers { shift, ..modifiers }.matches_exact(*wanted)
    };
    BINDINGS.iter().find(is_it)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_means_two_things() {
        let all: Vec<_> = BINDINGS
            .iter()
            .map(|&(held, key, ..)| (held, key))
            .collect();
        for (i, a) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|b| a != b), "{a:?} is bound twice");
        }
    }

    #[test]
    fn shift_tells_shortcuts_apart_but_not_signs() {
        let help = |key, modifiers| binding(key, modifiers).map(|binding| binding.3);
        let ctrl = Modifiers::CTRL | Modifiers::COMMAND;
        for (key, modifiers, expected) in [
            (Key::Z, ctrl, Some("action-undo")),
            (Key::Z, ctrl | Modifiers::SHIFT, Some("action-redo")),
            (Key::Questionmark, Modifiers::SHIFT, Some("action-help")),
            (Key::Questionmark, Modifiers::NONE, Some("action-help")),
            (Key::R, Modifiers::SHIFT, None),
        ] {
            assert_eq!(help(key, modifiers), expected);
        }
    }
}
