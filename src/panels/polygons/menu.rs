//! The lab's controls.

use egui::Ui;

use crate::{
    labs::polygons::{Scene, Texture},
    widgets::Look,
};

use super::PolygonsEdit;

/// The texture; the change that was asked for.
pub fn scene_menu(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PolygonsEdit> {
    let mut asked = None;
    ui.menu_button(look.say("texture-title"), |ui| {
        for (texture, key) in [
            (Texture::None, "texture-none"),
            (Texture::Interpolated, "texture-interpolated"),
            (Texture::Kept, "texture-kept"),
        ] {
            if ui.radio(scene.texture == texture, look.say(key)).clicked() {
                asked = Some(PolygonsEdit::Texture(texture));
                ui.close();
            }
        }
    });
    asked
}
