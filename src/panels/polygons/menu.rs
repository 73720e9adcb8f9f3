//! The lab's controls.

use egui::{Button, RichText, Ui};

use crate::{
    labs::polygons::{PRESETS, REGIONS, Scene, Texture},
    panels::Seeded,
    widgets::Look,
};

use super::{Outline, PolygonsEdit};

/// What a frame can draw in time, with its run and everything else beside it.
const MAX_RANDOM: usize = 10_000;

/// What a person asked for in the menu.
#[derive(Clone, PartialEq, Debug)]
pub enum PolygonsAsk {
    /// A change of the scene.
    Edit(PolygonsEdit),
    /// To draw an outline.
    Draw(Outline),
}

/// Outlines to draw, presets, the clip region, the texture; what was asked for.
pub fn scene_menu(
    ui: &mut Ui,
    look: Look<'_>,
    scene: &Scene,
    random: &mut Seeded,
) -> Option<PolygonsAsk> {
    let mut asked = None;
    for (outline, name_key, key) in Outline::ALL {
        let key = RichText::new(key).color(look.theme.soft);
        let button = Button::new(look.say(name_key)).right_text(key);
        let has_use = match outline {
            Outline::Subject => true,
            Outline::Clip => scene.clips(),
            Outline::Hole => scene.knows_holes(),
        };
        if ui.add_enabled(has_use, button).clicked() {
            asked = Some(PolygonsAsk::Draw(outline));
            ui.close();
        }
    }
    let edit = presets(ui, look, random)
        .or(holes(ui, look, scene))
        .or(clip(ui, look, scene))
        .or(texture(ui, look, scene));
    edit.map(PolygonsAsk::Edit).or(asked)
}

fn presets(ui: &mut Ui, look: Look<'_>, random: &mut Seeded) -> Option<PolygonsEdit> {
    let mut asked = None;
    ui.menu_button(look.say("preset-title"), |ui| {
        for (i, preset) in PRESETS.iter().enumerate() {
            if ui.button(look.say(preset.name_key)).clicked() {
                asked = Some(PolygonsEdit::Preset(i));
                ui.close();
            }
        }
        ui.separator();
        ui.menu_button(look.say("preset-random"), |ui| {
            if random.show(ui, look, ["random-count", "random-make"], 3..=MAX_RANDOM) {
                let Seeded { count, seed } = *random;
                asked = Some(PolygonsEdit::Random { count, seed });
                ui.close();
            }
        });
    });
    asked
}

fn holes(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PolygonsEdit> {
    if scene.holes.is_empty() {
        return None;
    }
    let pressed = ui.button(look.say("action-no-holes")).clicked();
    pressed.then_some(PolygonsEdit::NoHoles)
}

fn clip(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PolygonsEdit> {
    let mut asked = None;
    ui.add_enabled_ui(scene.clips(), |ui| {
        ui.menu_button(look.say("region-title"), |ui| {
            let is_window = scene.clip.is_none();
            if ui.radio(is_window, look.say("region-window")).clicked() {
                asked = Some(PolygonsEdit::Clip(None));
                ui.close();
            }
            ui.separator();
            for (i, region) in REGIONS.iter().enumerate() {
                if ui.button(look.say(region.name_key)).clicked() {
                    asked = Some(PolygonsEdit::Region(i));
                    ui.close();
                }
            }
        });
    });
    asked
}

fn texture(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PolygonsEdit> {
    let mut asked = None;
    ui.add_enabled_ui(scene.carries_texture(), |ui| {
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
    });
    asked
}
