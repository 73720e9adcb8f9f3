//! The transport: first, back, play, forward, last; and the speed.

use egui::Ui;

use crate::{
    text::{Message, Value},
    trace::Transport,
};

use super::{
    icon::{Icon, disc_button, icon_button},
    look::Look,
    menu::menu_button,
};

/// A button of the transport was pressed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Press {
    /// To the start.
    First,
    /// One step back.
    Back,
    /// Play, or pause.
    Play,
    /// One step on.
    Forward,
    /// To the end.
    Last,
}

/// Width of the five buttons and the space between them.
pub const fn transport_width() -> f32 {
    5.0 * 32.0 + 4.0 * 4.0
}

/// The five buttons in a row.
pub fn transport_buttons(ui: &mut Ui, look: Look<'_>, transport: &Transport) -> Option<Press> {
    let mut pressed = None;
    ui.spacing_mut().item_spacing.x = 4.0;
    let at_start = transport.position() == 0;
    let at_end = transport.position() >= transport.n_steps();
    let mut quiet = |ui: &mut Ui, icon, key, enabled, press| {
        if icon_button(ui, look, icon, &look.say(key), enabled).clicked() {
            pressed = Some(press);
        }
    };
    quiet(ui, Icon::First, "transport-first", !at_start, Press::First);
    quiet(ui, Icon::Back, "transport-back", !at_start, Press::Back);
    let (icon, key) = if transport.is_playing() {
        (Icon::Pause, "transport-pause")
    } else {
        (Icon::Play, "transport-play")
    };
    let can_play = transport.n_steps() > 0;
    let play = ui.add_enabled_ui(can_play, |ui| disc_button(ui, look, icon, &look.say(key)));
    let play = play.inner.clicked();
    quiet(
        ui,
        Icon::Forward,
        "transport-forward",
        !at_end,
        Press::Forward,
    );
    quiet(ui, Icon::Last, "transport-last", !at_end, Press::Last);
    if play { Some(Press::Play) } else { pressed }
}

/// The speed, and a menu of speeds; the one that was chosen, in steps a second.
pub fn speed_menu(ui: &mut Ui, look: Look<'_>, speed: f32) -> Option<f32> {
    let written = |speed: f32| format!("{}×", look.catalog.number(f64::from(speed)));
    let mut chosen = None;
    let button = menu_button(ui, written(speed), |ui| {
        for choice in Transport::SPEEDS {
            if ui
                .selectable_label(choice == speed, written(choice))
                .clicked()
            {
                chosen = Some(choice);
                ui.close();
            }
        }
    });
    let name = Message::new("transport-speed-value").with("speed", Value::Number(f64::from(speed)));
    button.response.on_hover_text(look.catalog.message(&name));
    chosen
}
