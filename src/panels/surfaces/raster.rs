//! The raster's form: pixels, steps, order, how depths are stored.

use egui::ComboBox;

use crate::{
    algo::surface::{DepthBits, DepthNumber, DepthSteps},
    labs::space::{RasterPlan, Scene, SpaceChange, Tones},
    panels::prelude::*,
};

/// Numbers of this form come after those of camera and objects.
const FIRST_NUMBER: usize = 16;
/// Depths of so many bits can be chosen, besides f64 and f32.
const BITS: [u32; 6] = [8, 10, 12, 16, 24, 32];

pub fn form(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let form = form_button(ui, look.say("raster-title"), |ui| {
        let mut plan = scene.raster;
        let tuned = numbers(ui, look, &mut plan);
        choices(ui, look, &mut plan);
        let change = Edit::own(SpaceChange::Raster(plan));
        (plan != scene.raster).then(|| match tuned {
            Some(place) => PanelAsk::Tune(change, FIRST_NUMBER + place),
            None => PanelAsk::Edit(change),
        })
    });
    form.inner.flatten()
}

/// Which of the numbers was changed?
fn numbers(ui: &mut Ui, look: Look<'_>, plan: &mut RasterPlan) -> Option<usize> {
    let mut field = |key, value, range| number_field(ui, look, (key, ""), value, &range);
    let mut tuned = None;
    let range = f64::from(*RasterPlan::ROWS.start())..=f64::from(*RasterPlan::ROWS.end());
    if let Some(rows) = field("raster-rows", f64::from(plan.rows()), range) {
        *plan = plan.with_rows(rows.round() as u32);
        tuned = Some(0);
    }
    let seed = plan.shuffle.unwrap_or_default() as f64;
    if let Some(seed) = field("raster-shuffle", seed, 0.0..=9999.0) {
        plan.shuffle = (seed.round() >= 1.0).then_some(seed.round() as u64);
        tuned = Some(1);
    }
    // Column and row of the pixel that is looked at alone; −1 for none.
    let shown = plan.pixel.map_or([-1.0; 2], |pixel| pixel.map(f64::from));
    for (i, key) in ["raster-column", "raster-row"].into_iter().enumerate() {
        if let Some(value) = field(key, shown[i], -1.0..=160.0) {
            let mut pixel = shown.map(|x| x.max(0.0) as u32);
            pixel[i] = value.max(0.0).round() as u32;
            plan.pixel = (value >= 0.0).then_some(pixel);
            tuned = Some(2);
        }
    }
    tuned
}

fn choices(ui: &mut Ui, look: Look<'_>, plan: &mut RasterPlan) {
    ui.label(look.say("raster-steps"));
    for (steps, key) in [
        (DepthSteps::Fragments, "raster-steps-fragments"),
        (DepthSteps::Spans, "raster-steps-spans"),
        (DepthSteps::Triangles, "raster-steps-triangles"),
    ] {
        ui.radio_value(&mut plan.steps, steps, look.say(key));
    }
    ui.label(look.say("raster-tones"));
    for (tones, key) in [
        (Tones::Depth, "raster-tones-stored"),
        (Tones::Distance, "raster-tones-distance"),
        (Tones::Triangles, "raster-tones-triangles"),
        (Tones::Counts, "raster-tones-counts"),
        (Tones::Brightness, "raster-tones-brightness"),
    ] {
        ui.radio_value(&mut plan.tones, tones, look.say(key));
    }
    let format = &mut plan.format;
    let combo = ComboBox::from_label(look.say("raster-number")).selected_text(name(format.number));
    combo.show_ui(ui, |ui| {
        let fixed = BITS.into_iter().filter_map(DepthBits::new);
        let floats = [DepthNumber::Double, DepthNumber::Single].into_iter();
        for number in floats.chain(fixed.map(DepthNumber::Fixed)) {
            ui.selectable_value(&mut format.number, number, name(number));
        }
    });
    ui.checkbox(&mut format.is_reversed, look.say("raster-reversed"));
    ui.checkbox(&mut plan.culls_backs, look.say("raster-cull"));
}

fn name(number: DepthNumber) -> String {
    match number {
        DepthNumber::Double => "f64".to_owned(),
        DepthNumber::Single => "f32".to_owned(),
        DepthNumber::Fixed(bits) => format!("{} bit", bits.get()),
    }
}
