//! The camera's numbers in a form.

use crate::{
    labs::space::{CameraNumber, Opening, Scene, SpaceChange},
    panels::prelude::*,
};

use super::{own, tuned};

/// As near and as far as dragging takes a plane.
const DEPTHS: [f64; 2] = [0.01, 1000.0];

pub fn form(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let form = form_button(ui, look.say("camera-title"), |ui| {
        let asked = sight(ui, look, scene).or(numbers(ui, look, scene));
        asked.or(freeze(ui, look, scene))
    });
    form.inner.flatten()
}

fn sight(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let is_parallel = matches!(scene.camera.opening(), Opening::Height(_));
    let mut parallel = is_parallel;
    for (key, is_it) in [("camera-perspective", false), ("camera-parallel", true)] {
        ui.radio_value(&mut parallel, is_it, look.say(key));
    }
    (parallel != is_parallel).then(|| own(SpaceChange::Parallel(parallel)))
}

fn freeze(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let mut is_frozen = scene.frozen.is_some();
    let button = ui.checkbox(&mut is_frozen, look.say("camera-frozen"));
    let button = button.on_hover_text(look.say("camera-frozen-about"));
    (button.changed()).then(|| own(SpaceChange::Freeze(is_frozen)))
}

fn numbers(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let camera = &scene.camera;
    let [near, far] = camera.depths();
    let [nearest, farthest] = DEPTHS;
    let (opening, name, range) = match camera.opening() {
        Opening::FovY(degrees) => (degrees, ("camera-fov", "°"), 1.0..=170.0),
        Opening::Height(height) => (height, ("camera-height", ""), nearest..=farthest),
    };
    // As near to each other as they may be dragged.
    let gap = 0.01 * (far - near).abs().min(1.0);
    let (nears, fars) = (
        nearest.min(near)..=far - gap,
        near + gap..=farthest.max(far),
    );
    let mut asked = None;
    let mut field = |place, number, name, value, range| {
        if let Some(value) = number_field(ui, look, name, value, &range) {
            asked = Some(tuned(SpaceChange::Camera(number, value), place));
        }
    };
    let aspect = camera.aspect();
    field(0, CameraNumber::Opening, name, opening, range);
    field(
        1,
        CameraNumber::Aspect,
        ("camera-aspect", ""),
        aspect,
        0.1..=10.0,
    );
    field(2, CameraNumber::Near, ("camera-near", ""), near, nears);
    field(3, CameraNumber::Far, ("camera-far", ""), far, fars);
    asked
}
