//! The camera's numbers in a form.

use egui::Ui;

use crate::{
    labs::space::{CameraNumber, Opening, Scene, SpaceChange},
    panels::{PanelAsk, number_field},
    widgets::{Look, form_button},
};

use super::{own, tuned};

/// As near and as far as dragging takes a plane.
const DEPTHS: [f64; 2] = [0.01, 1000.0];

/// How sight lines run, and the numbers of the volume; what was asked for.
pub fn form(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let form = form_button(ui, look.say("camera-title"), |ui| {
        let asked = sight(ui, look, scene).or(numbers(ui, look, scene));
        asked.or(freeze(ui, look, scene))
    });
    form.inner.flatten()
}

fn sight(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let is_parallel = match scene.camera.opening() {
        Opening::FovY(_) => false,
        Opening::Height(_) => true,
    };
    let mut asked = None;
    for (key, parallel) in [("camera-perspective", false), ("camera-parallel", true)] {
        let is_so = is_parallel == parallel;
        if ui.radio(is_so, look.say(key)).clicked() && !is_so {
            asked = Some(own(SpaceChange::Parallel(parallel)));
        }
    }
    asked
}

/// Goes on culling from here, and lets the camera fly.
fn freeze(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let mut is_frozen = scene.frozen.is_some();
    let button = ui.checkbox(&mut is_frozen, look.say("camera-frozen"));
    let button = button.on_hover_text(look.say("camera-frozen-about"));
    let is_asked = button.changed();
    is_asked.then(|| own(SpaceChange::Freeze(is_frozen)))
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
    let fields = [
        (CameraNumber::Opening, name, opening, range),
        (
            CameraNumber::Aspect,
            ("camera-aspect", ""),
            camera.aspect(),
            0.1..=10.0,
        ),
        (
            CameraNumber::Near,
            ("camera-near", ""),
            near,
            nearest.min(near)..=far - gap,
        ),
        (
            CameraNumber::Far,
            ("camera-far", ""),
            far,
            near + gap..=farthest.max(far),
        ),
    ];
    let mut asked = None;
    for (place, (number, name, value, range)) in fields.into_iter().enumerate() {
        if let Some(value) = number_field(ui, look, name, value, &range) {
            asked = Some(tuned(SpaceChange::Camera(number, value), place));
        }
    }
    asked
}
