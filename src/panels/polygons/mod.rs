//! What the polygons lab adds to the window.

use crate::labs::polygons::{self, OUTLINES, PRESETS, PolygonsChange, REGIONS, Scene, Texture};

use super::prelude::*;

#[derive(Default)]
pub struct PolygonsPanel {
    random: Seeded,
}

impl LabPanel for PolygonsPanel {
    fn lab(&self) -> &'static Lab {
        polygons::LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &labs::Scene) -> Option<PanelAsk> {
        scene_menu(ui, look, scene, &mut self.random)
    }
}

/// What a frame can draw in time, with its run and everything else beside it.
const MAX_RANDOM: usize = 10_000;

/// The keys that draw, in the order of the lab's outlines.
const DRAW_KEYS: [&str; 3] = ["D", "C", "H"];

fn scene_menu(
    ui: &mut Ui,
    look: Look<'_>,
    scene: &labs::Scene,
    random: &mut Seeded,
) -> Option<PanelAsk> {
    let mut asked = None;
    for (outline, key) in OUTLINES.iter().zip(DRAW_KEYS) {
        let key = RichText::new(key).color(look.theme.soft);
        let button = Button::new(look.say(outline.name_key)).right_text(key);
        if ui.add_enabled((outline.is_of_use)(scene), button).clicked() {
            asked = Some(PanelAsk::Draw(outline));
            ui.close();
        }
    }
    let scene: &Scene = scene.get()?;
    let change = presets(ui, look, random)
        .or(holes(ui, look, scene))
        .or(clip(ui, look, scene))
        .or(texture(ui, look, scene));
    change
        .map(|change| PanelAsk::Edit(Edit::own(change)))
        .or(asked)
}

fn presets(ui: &mut Ui, look: Look<'_>, random: &mut Seeded) -> Option<PolygonsChange> {
    let mut asked = None;
    menu_button(ui, look.say("preset-title"), |ui| {
        for (i, preset) in PRESETS.iter().enumerate() {
            if ui.button(look.say(preset.name_key)).clicked() {
                asked = Some(PolygonsChange::Preset(i));
                ui.close();
            }
        }
        ui.separator();
        form_button(ui, look.say("preset-random"), |ui| {
            if random.show(ui, look, ["random-count", "random-make"], 3..=MAX_RANDOM) {
                let Seeded { count, seed } = *random;
                asked = Some(PolygonsChange::Random { count, seed });
            }
        });
    });
    asked
}

fn holes(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PolygonsChange> {
    if scene.holes.is_empty() {
        return None;
    }
    let pressed = ui.button(look.say("action-no-holes")).clicked();
    pressed.then_some(PolygonsChange::NoHoles)
}

fn clip(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PolygonsChange> {
    let mut asked = None;
    ui.add_enabled_ui(scene.clips(), |ui| {
        menu_button(ui, look.say("region-title"), |ui| {
            let is_window = scene.clip.is_none();
            if ui.radio(is_window, look.say("region-window")).clicked() {
                asked = Some(PolygonsChange::Clip(None));
                ui.close();
            }
            ui.separator();
            for (i, region) in REGIONS.iter().enumerate() {
                if ui.button(look.say(region.name_key)).clicked() {
                    asked = Some(PolygonsChange::Region(i));
                    ui.close();
                }
            }
        });
    });
    asked
}

fn texture(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PolygonsChange> {
    let mut asked = None;
    ui.add_enabled_ui(scene.carries_texture(), |ui| {
        menu_button(ui, look.say("texture-title"), |ui| {
            for (texture, key) in [
                (Texture::None, "texture-none"),
                (Texture::Interpolated, "texture-interpolated"),
                (Texture::Kept, "texture-kept"),
            ] {
                if ui.radio(scene.texture == texture, look.say(key)).clicked() {
                    asked = Some(PolygonsChange::Texture(texture));
                    ui.close();
                }
            }
        });
    });
    asked
}
