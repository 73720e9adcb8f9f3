//! What can be done about a scene that is refused: buttons over the drawing.

use super::{App, Command, prelude::*, stage_state::StageState};

/// Where the buttons are.
pub fn ways_out(app: &App, ui: &mut Ui, state: &mut StageState, place: Rect) -> Rect {
    let look = app.look();
    let shown = ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
        ui.horizontal_wrapped(|ui| {
            let way = |ui: &mut Ui, words: String, command: Command| {
                let text = RichText::new(words).color(look.theme.accent);
                let button = Button::new(text).fill(look.theme.background);
                if ui.add(button).clicked() {
                    app.push(command);
                }
            };
            if app.history.can_undo() {
                way(ui, look.say("action-undo"), Command::Undo);
            }
            let ways = state.ways_out(app.scene(), app.stage_revision());
            if let Some((key, change)) = &ways.mended {
                let edit = Edit::Own(change.clone());
                way(ui, look.say(key), Command::Edit(edit, None));
            }
            for card in &ways.methods {
                let edit = Edit::Method(card.id);
                way(ui, look.say(card.name_key), Command::Edit(edit, None));
            }
        });
    });
    shown.response.rect
}
