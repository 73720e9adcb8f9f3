//! The raster's form: pixels, steps, order, how depths are stored.

use egui::{ComboBox, Ui};

use crate::{
    algo::surface::{DepthBits, DepthNumber, DepthSteps},
    labs::{
        Edit,
        space::{RasterPlan, Scene, SpaceChange, Tones},
    },
    panels::{PanelAsk, number_field},
    widgets::{Look, form_button},
};

/// Numbers of this form come after those of camera and objects.
const FIRST_NUMBER: usize = 16;
/// Depths of so many bits can be chosen, besides f64 and f32.
const BITS: [u32; 6] = [8, 10, 12, 16, 24, 32];

/// What was asked for.
pub fn form(ui: &mut Ui, look: Look<'_>, scene: &Scene) -> Option<PanelAsk> {
    let plan = scene.raster;
    let form = form_button(ui, look.say("raster-title"), |ui| {
        let rows = f64::from(plan.rows());
        let range = f64::from(*RasterPlan::ROWS.start())..=f64::from(*RasterPlan::ROWS.end());
        let tuned = number_field(ui, look, ("raster-rows", ""), rows, &range)
            .map(|rows| (plan.with_rows(rows.round() as u32), 0));
        let seed = plan.shuffle.unwrap_or_default() as f64;
        let shuffled = number_field(ui, look, ("raster-shuffle", ""), seed, &(0.0..=9999.0));
        let shuffled = shuffled.map(|seed| {
            let shuffle = (seed.round() >= 1.0).then_some(seed.round() as u64);
            let mut new = plan;
            new.shuffle = shuffle;
            (new, 1)
        });
        let looked_at = pixel(ui, look, plan).map(|plan| (plan, 2));
        let chosen = steps(ui, look, plan)
            .or(tones(ui, look, plan))
            .or(number(ui, look, plan))
            .or(checks(ui, look, plan));
        let ask = |(plan, place)| PanelAsk::Tune(change(plan), FIRST_NUMBER + place);
        let tuned = tuned.or(shuffled).or(looked_at).map(ask);
        tuned.or(chosen.map(|plan| PanelAsk::Edit(change(plan))))
    });
    form.inner.flatten()
}

/// Column and row of the pixel that is looked at alone; −1 for none.
fn pixel(ui: &mut Ui, look: Look<'_>, plan: RasterPlan) -> Option<RasterPlan> {
    let most = 160.0;
    let shown = plan.pixel.map_or([-1.0; 2], |pixel| pixel.map(f64::from));
    let keys = ["raster-column", "raster-row"];
    let mut asked = None;
    for (i, key) in keys.into_iter().enumerate() {
        if let Some(value) = number_field(ui, look, (key, ""), shown[i], &(-1.0..=most)) {
            let mut pixel = shown.map(|x| x.max(0.0) as u32);
            pixel[i] = value.max(0.0).round() as u32;
            let mut new = plan;
            new.pixel = (value >= 0.0).then_some(pixel);
            asked = Some(new);
        }
    }
    asked
}

fn change(plan: RasterPlan) -> Edit {
    Edit::own(SpaceChange::Raster(plan))
}

fn steps(ui: &mut Ui, look: Look<'_>, mut plan: RasterPlan) -> Option<RasterPlan> {
    let kinds = [
        (DepthSteps::Fragments, "raster-steps-fragments"),
        (DepthSteps::Spans, "raster-steps-spans"),
        (DepthSteps::Triangles, "raster-steps-triangles"),
    ];
    plan.steps = one_of(ui, look, "raster-steps", (plan.steps, kinds))?;
    Some(plan)
}

fn tones(ui: &mut Ui, look: Look<'_>, mut plan: RasterPlan) -> Option<RasterPlan> {
    let kinds = [
        (Tones::Triangles, "raster-tones-triangles"),
        (Tones::Stored, "raster-tones-stored"),
        (Tones::Distance, "raster-tones-distance"),
    ];
    plan.tones = one_of(ui, look, "raster-tones", (plan.tones, kinds))?;
    Some(plan)
}

/// Radio buttons under a heading: the one that was chosen and is not so now.
fn one_of<T: Copy + PartialEq>(
    ui: &mut Ui,
    look: Look<'_>,
    heading: &'static str,
    (now, kinds): (T, [(T, &'static str); 3]),
) -> Option<T> {
    ui.label(look.say(heading));
    let mut asked = None;
    for (kind, key) in kinds {
        let is_so = now == kind;
        if ui.radio(is_so, look.say(key)).clicked() && !is_so {
            asked = Some(kind);
        }
    }
    asked
}

fn number(ui: &mut Ui, look: Look<'_>, plan: RasterPlan) -> Option<RasterPlan> {
    let fixed = BITS.into_iter().filter_map(DepthBits::new);
    let numbers = [DepthNumber::Double, DepthNumber::Single].into_iter();
    let numbers = numbers.chain(fixed.map(DepthNumber::Fixed));
    let name = |number: DepthNumber| match number {
        DepthNumber::Double => "f64".to_owned(),
        DepthNumber::Single => "f32".to_owned(),
        DepthNumber::Fixed(bits) => format!("{} bit", bits.get()),
    };
    let mut asked = None;
    let shown =
        ComboBox::from_label(look.say("raster-number")).selected_text(name(plan.format.number));
    shown.show_ui(ui, |ui| {
        for number in numbers {
            let is_so = plan.format.number == number;
            if ui.selectable_label(is_so, name(number)).clicked() {
                let mut new = plan;
                new.format.number = number;
                asked = Some(new);
            }
        }
    });
    asked
}

fn checks(ui: &mut Ui, look: Look<'_>, plan: RasterPlan) -> Option<RasterPlan> {
    let mut new = plan;
    let mut check = |is_on: &mut bool, key| ui.checkbox(is_on, look.say(key)).changed();
    let reversed = check(&mut new.format.is_reversed, "raster-reversed");
    let culled = check(&mut new.culls_backs, "raster-cull");
    (reversed || culled).then_some(new)
}
