//! The objects of a scene: one more of each kind, the one in focus, and a street of many.

use crate::{
    geom::Solid,
    labs::space::{MAX_OBJECTS, Model, Object, Part, Scene, SpaceChange, Subject},
    lesson::spot,
    panels::prelude::*,
};

use super::{own, tuned};

/// Numbers of this form come after the camera's.
const FIRST_NUMBER: usize = 4;

pub fn rows(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let added = menu_button(ui, look.say("object-add"), |ui| kinds(ui, look));
    let can_remove = scene.objects().len() > 1;
    let remove = Button::new(look.say("object-remove"));
    let removed = ui.add_enabled(can_remove, remove).clicked();
    let form = form_button(ui, look.say("object-numbers"), |ui| {
        focus(ui, look, scene).or(place(ui, look, scene))
    });
    let added = added.inner.flatten().map(SpaceChange::Add).map(own);
    added
        .or(removed.then_some(PanelAsk::Edit(Edit::Remove(None))))
        .or(form.inner.flatten())
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

/// Which object is looked at, which face of it and which vertex: people count from 1.
fn focus(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let mut number = |key, part, index: usize, id| {
        let mut number = index + 1;
        ui.horizontal(|ui| {
            let label = ui.label(look.say(key));
            let count = scene.count(part);
            let field = DragValue::new(&mut number).range(1..=count).speed(0.1);
            ui.add(field).labelled_by(label.id);
        });
        (number != index + 1).then(|| tuned(SpaceChange::LookAt(part, number - 1), id))
    };
    let object = number("object-focus", Part::Object, scene.focus(), FIRST_NUMBER);
    let face = number("object-face", Part::Face, scene.face(), FIRST_NUMBER + 1);
    let vertex = number(
        "object-vertex",
        Part::Vertex,
        scene.vertex(),
        FIRST_NUMBER + 6,
    );
    object.or(face).or(vertex)
}

fn place(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let object: &Object = scene.focused();
    let mut asked = None;
    let keys = ["object-turn-x", "object-turn-y", "object-turn-z"];
    for (axis, key) in keys.into_iter().enumerate() {
        let mut turn_deg = object.turn_deg();
        let range = -360.0..=360.0;
        if let Some(degrees) = number_field(ui, look, (key, "°"), turn_deg[axis], &range) {
            turn_deg[axis] = degrees;
            asked = Some(tuned(SpaceChange::Turn(turn_deg), FIRST_NUMBER + 2 + axis));
        }
    }
    let size = ("object-size", "");
    if let Some(size) = number_field(ui, look, size, object.size(), &(0.01..=100.0)) {
        asked = Some(tuned(SpaceChange::Size(size), FIRST_NUMBER + 5));
    }
    if scene.method.info().subject == Subject::Surfaces {
        let opacity = ("object-opacity", "");
        if let Some(opacity) = number_field(ui, look, opacity, object.opacity(), &(0.0..=1.0)) {
            asked = Some(tuned(SpaceChange::Opacity(opacity), FIRST_NUMBER + 7));
        }
    }
    asked
}

pub fn street(ui: &mut Ui, look: Look<'_>, street: &mut Seeded) -> Option<PanelAsk> {
    let mut is_asked = false;
    form_button(ui, look.say("street-title"), |ui| {
        let slider = |ui: &mut Ui, count: &mut usize| {
            ui.add(Slider::new(count, 1..=MAX_OBJECTS).logarithmic(true))
        };
        is_asked = street.show_with(ui, look, ["street-count", "street-make"], slider);
    });
    let &mut Seeded { count, seed } = street;
    is_asked.then(|| own(SpaceChange::Street { count, seed }))
}
