//! The objects of a scene: one more of each kind, one less, and a street of many.

use crate::{
    geom::Solid,
    labs::space::{MAX_OBJECTS, Model, Scene, SpaceChange},
    lesson::spot,
    panels::prelude::*,
};

use super::own;

pub fn rows(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let are_shown = scene.shows_objects();
    let rows = ui.add_enabled_ui(are_shown, |ui| {
        let added = menu_button(ui, look.say("object-add"), |ui| kinds(ui, look));
        let remove = Button::new(look.say("object-remove"));
        let removed = ui.add_enabled(scene.objects().len() > 1, remove).clicked();
        let added = added.inner.flatten().map(SpaceChange::Add).map(own);
        added.or(removed.then_some(PanelAsk::Edit(Edit::Remove(None))))
    });
    if !are_shown {
        ui.label(RichText::new(look.say("objects-not-drawn")).color(look.theme.soft));
    }
    rows.inner
}

fn kinds(ui: &mut Ui, look: Look<'_>) -> Option<Model> {
    let mut asked = None;
    for solid in Solid::ALL {
        if ui.button(look.say(solid_key(solid))).clicked() {
            asked = Some(Model::Solid(solid));
            ui.close();
        }
    }
    if ui.button(look.say("solid-spot")).clicked() {
        asked = Some(spot::model());
        ui.close();
    }
    asked
}

const fn solid_key(solid: Solid) -> &'static str {
    match solid {
        Solid::Cube => "solid-cube",
        Solid::Tetrahedron => "solid-tetrahedron",
        Solid::Octahedron => "solid-octahedron",
        Solid::Sphere => "solid-sphere",
        Solid::Torus => "solid-torus",
        Solid::Angle => "solid-angle",
    }
}

pub fn street(ui: &mut Ui, look: Look<'_>, street: &mut Seeded) -> Option<PanelAsk> {
    let mut is_asked = false;
    form_button(ui, look.say("street-title"), |ui| {
        let slider =
            |ui: &mut Ui, count: &mut usize| ui.add(count_slider(look, count, MAX_OBJECTS));
        is_asked = street.show_with(ui, look, ["street-count", "street-make"], slider);
    });
    let &mut Seeded { count, seed } = street;
    is_asked.then(|| own(SpaceChange::Street { count, seed }))
}
