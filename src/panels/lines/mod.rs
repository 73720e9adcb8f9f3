//! What the lines lab adds to the window: its segments, and the measured costs of its methods.

mod measure;

use egui_plot::{Bar, BarChart};

use crate::{
    algo::line::BitOrder,
    labs::lines::{self, LinesChange, MAX_SEGMENTS, Scene},
};

use super::prelude::*;

use measure::{Measure, Subject};

#[derive(Default)]
pub struct LinesPanel {
    batch: Seeded,
    measure: Option<Measure>,
}

impl LabPanel for LinesPanel {
    fn lab(&self) -> &'static Lab {
        lines::LAB
    }

    fn menu(&mut self, ui: &mut Ui, look: Look<'_>, scene: &labs::Scene) -> Option<PanelAsk> {
        let change = scene_menu(ui, look, scene.get()?, &mut self.batch)?;
        Some(PanelAsk::Edit(change))
    }

    fn measures(&self, _: &labs::Scene) -> bool {
        true
    }

    fn bench(&mut self) -> Option<&mut dyn Bench> {
        Some(self)
    }
}

impl Bench for LinesPanel {
    fn show(&mut self, ui: &mut Ui, look: Look<'_>, scene: &labs::Scene) -> bool {
        ui.set_max_width(560.0_f32.min(ui.ctx().content_rect().width() - 48.0));
        let known = self.measure.as_ref();
        let about = look.say("measure-about");
        bench::head(ui, look, "measure-title", about, known);
        if let Some(known) = known {
            measured(ui, look, known);
        }
        let is_busy = known.is_some_and(|measure| !measure.is_done());
        let start = look.say(match known {
            Some(_) => "measure-again",
            None => "measure-start",
        });
        ui.horizontal(|ui| {
            if ui.add_enabled(!is_busy, Button::new(start)).clicked() {
                let scene = scene.get();
                self.measure = scene.map(|scene| Measure::new(scene, self.batch.seed));
                ui.ctx().request_repaint();
            }
            !quiet_button(ui, look, Button::new(look.say("action-close"))).clicked()
        })
        .inner
    }

    fn work(&mut self, clock: &dyn Fn() -> f64) -> bool {
        bench::work_on(self.measure.as_mut(), clock)
    }
}

fn scene_menu(ui: &mut Ui, look: Look<'_>, scene: &Scene, batch: &mut Seeded) -> Option<Edit> {
    let mut asked = None;
    if ui.button(look.say("action-add-segment")).clicked() {
        asked = Some(Edit::Add(None));
    }
    let can_remove = scene.segments().len() > 1;
    let remove = Button::new(look.say("action-remove-segment"));
    if ui.add_enabled(can_remove, remove).clicked() {
        asked = Some(Edit::Remove(None));
    }
    form_button(ui, look.say("batch-title"), |ui| {
        if batch.show(ui, look, ["batch-count", "batch-make"], 1..=MAX_SEGMENTS) {
            let Seeded { count, seed } = *batch;
            asked = Some(Edit::own(LinesChange::Random { count, seed }));
        }
    });
    menu_button(ui, look.say("settings-bit-order"), |ui| {
        for (order, key) in [
            (BitOrder::Tbrl, "bit-order-tbrl"),
            (BitOrder::Lrbt, "bit-order-lrbt"),
        ] {
            if ui.radio(scene.bit_order == order, look.say(key)).clicked() {
                asked = Some(Edit::own(LinesChange::BitOrder(order)));
                ui.close();
            }
        }
    });
    asked
}

fn measured(ui: &mut Ui, look: Look<'_>, measure: &Measure) {
    let costs = &measure.costs;
    let height = (ui.ctx().content_rect().height() - 260.0).clamp(80.0, 320.0);
    let nanos = costs.iter().map(|cost| (cost.subject, Some(cost.nanos)));
    let operations = costs.iter().map(|cost| (cost.subject, cost.operations));
    ui.columns(2, |columns| {
        chart(&mut columns[0], look, "measure-nanos", height, nanos);
        chart(
            &mut columns[1],
            look,
            "measure-operations",
            height,
            operations,
        );
    });
    let message = Message::new("measure-note").with("count", measure.batch.len());
    bench::note(ui, look, look.catalog.message(&message));
}

/// One horizontal bar a subject, its name and value over it.
fn chart(
    ui: &mut Ui,
    look: Look<'_>,
    key: &str,
    height: f32,
    values: impl Iterator<Item = (Subject, Option<f64>)>,
) {
    ui.label(RichText::new(look.say(key)).text_style(theme::strong()));
    let n_rows = Subject::all().count();
    let row = |i: usize| (n_rows - i) as f64;
    let known = values.enumerate();
    let known: Vec<_> = known
        .filter_map(|(i, (subject, value))| Some((row(i), subject, value?)))
        .collect();
    let most = known.iter().map(|known| known.2).fold(1e-9, f64::max);
    let bar = |&(row, _, value): &_| {
        Bar::new(row - 0.2, value)
            .width(0.3)
            .fill(look.theme.accent)
    };
    let bars = known.iter().map(bar).collect();
    let chart = BarChart::new(key, bars).horizontal().allow_hover(false);
    let texts = known.into_iter().map(|(row, subject, value)| {
        let name = look.say(subject.name_key());
        let value = look.catalog.number((value * 10.0).round() / 10.0);
        (row + 0.02, format!("{name}  {value}"))
    });
    let size = (n_rows, most * 1.02);
    row_bars(ui, look, (key, height), size, vec![chart], texts);
}
