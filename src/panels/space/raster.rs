//! How a scene is drawn pixel by pixel: what a step is, what tones tell, how depths are stored.

use crate::{
    algo::surface::{DepthBits, DepthNumber, DepthSteps},
    labs::space::{RasterPlan, Scene, SpaceChange, Tones},
    panels::{form::Form, prelude::*},
};

/// Depths of so many bits can be chosen, besides f64 and f32.
const BITS: [u32; 6] = [8, 10, 12, 16, 24, 32];
const STEPS: [(DepthSteps, &str); 3] = [
    (DepthSteps::Fragments, "raster-steps-fragments"),
    (DepthSteps::Spans, "raster-steps-spans"),
    (DepthSteps::Triangles, "raster-steps-triangles"),
];
const TONES: [(Tones, &str); 5] = [
    (Tones::Depth, "raster-tones-stored"),
    (Tones::Distance, "raster-tones-distance"),
    (Tones::Triangles, "raster-tones-triangles"),
    (Tones::Counts, "raster-tones-counts"),
    (Tones::Brightness, "raster-tones-brightness"),
];

pub fn choices(ui: &mut Ui, form: &Form<'_>, scene: &Scene) -> Option<PanelAsk> {
    let mut plan: RasterPlan = scene.raster;
    let say = |key| form.look.say(key);
    let entry = |id, key| (id, Message::new(key));
    let (id, name) = entry("raster.steps", "raster-steps");
    let steps = STEPS.map(|(steps, key)| (steps, say(key)));
    plan.steps = form
        .choice(ui, (id, &name, ""), plan.steps, &steps)
        .unwrap_or(plan.steps);
    let (id, name) = entry("raster.tones", "raster-tones");
    let tones = TONES.map(|(tones, key)| (tones, say(key)));
    plan.tones = form
        .choice(ui, (id, &name, ""), plan.tones, &tones)
        .unwrap_or(plan.tones);
    let floats = [DepthNumber::Double, DepthNumber::Single].into_iter();
    let fixed = BITS.into_iter().filter_map(DepthBits::new);
    let numbers = floats.chain(fixed.map(DepthNumber::Fixed));
    let numbers: Vec<_> = numbers.map(|number| (number, written(number))).collect();
    let format = &mut plan.format;
    let (id, name) = entry("raster.depth", "raster-number");
    let number = form.choice(ui, (id, &name, ""), format.number, &numbers);
    format.number = number.unwrap_or(format.number);
    let (id, name) = entry("raster.reversed", "raster-reversed");
    let is_reversed = form.check(ui, (id, &name, ""), format.is_reversed);
    format.is_reversed = is_reversed.unwrap_or(format.is_reversed);
    let (id, name) = entry("raster.cull", "raster-cull");
    let culls_backs = form.check(ui, (id, &name, ""), plan.culls_backs);
    plan.culls_backs = culls_backs.unwrap_or(plan.culls_backs);
    let change = Edit::own(SpaceChange::Raster(plan));
    (plan != scene.raster).then_some(PanelAsk::Edit(change))
}

fn written(number: DepthNumber) -> String {
    match number {
        DepthNumber::Double => "f64".to_owned(),
        DepthNumber::Single => "f32".to_owned(),
        DepthNumber::Fixed(bits) => format!("{} bit", bits.get()),
    }
}
