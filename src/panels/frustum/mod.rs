//! What the frustum lab adds to the window: what culling costs, as bars of what it takes and what is left to draw, and where
//! the best choice changes.

mod culling_costs;

use egui::Color32;
use egui_plot::{Bar, BarChart, LineStyle};

use crate::labs::{
    frustum::{self, Culling},
    space::MAX_OBJECTS,
};

use super::{prelude::*, space::SpacePanel};

use culling_costs::{Costs, CullingCost, CullingCosts, SWEEP};

pub fn panel() -> SpacePanel<CullingCosts> {
    SpacePanel::new(frustum::LAB, culling_view)
}

fn culling_view(ui: &mut Ui, look: Look<'_>, costs: &mut CullingCosts, height: f32) {
    objects(ui, look, costs);
    if let Some(here) = &costs.here {
        bars(ui, look, here, 0.45 * height);
        ui.label(look.catalog.message(&inequality(look, here)));
    }
    lines(ui, look, costs, 0.55 * height);
    if let Some(message) = best(&costs.sweep) {
        ui.label(RichText::new(look.catalog.message(&message)).text_style(theme::strong()));
    }
}

fn objects(ui: &mut Ui, look: Look<'_>, costs: &mut CullingCosts) {
    ui.horizontal(|ui| {
        let label = ui.label(look.say("culling-objects"));
        let mut count = costs.n_objects();
        let slider = count_slider(look, &mut count, MAX_OBJECTS);
        if ui.add(slider).labelled_by(label.id).changed() {
            costs.measure(Some(count));
        }
        let own = Button::new(look.say("culling-own"));
        if ui.add_enabled(costs.street.is_some(), own).clicked() {
            costs.measure(None);
        }
    });
}

/// One bar a way: what culling takes in ink, then what drawing takes in the accent.
fn bars(ui: &mut Ui, look: Look<'_>, costs: &Costs, height: f32) {
    let row = |i: usize| (costs.len() - i) as f64;
    let most = costs.iter().map(CullingCost::secs).fold(1e-9, f64::max);
    let bar = |i: usize, secs: f64, fill: Color32| {
        Bar::new(row(i) - 0.22, 1e3 * secs).width(0.32).fill(fill)
    };
    let (mut culls, mut draws) = (Vec::new(), Vec::new());
    for (i, cost) in costs.iter().enumerate() {
        culls.push(bar(i, cost.cull_secs, look.theme.ink));
        draws.push(bar(i, cost.draw_secs, look.theme.accent));
    }
    let culls = BarChart::new("cull", culls).horizontal().allow_hover(false);
    let draws = BarChart::new("draw", draws).horizontal().allow_hover(false);
    let draws = draws.stack_on(&[&culls]);
    let texts = costs.iter().enumerate().map(|(i, cost)| {
        let message = Message::new("culling-row")
            .with("way", Value::Term(cost.culling.name_key()))
            .with("cull", millis(look, cost.cull_secs))
            .with("draw", millis(look, cost.draw_secs))
            .with("objects", cost.n_kept)
            .with("triangles", cost.n_triangles);
        (row(i) - 0.02, look.catalog.message(&message))
    });
    let (plot, size) = (("culling-bars", height), (costs.len(), 1.02e3 * most));
    row_bars(ui, look, plot, size, vec![culls, draws], texts);
}

/// Three decimals, or as many as tell a short time from none.
fn millis(look: Look<'_>, secs: f64) -> String {
    let millis = 1e3 * secs;
    let scale = if millis < 0.1 { 1e4 } else { 1e2 };
    look.catalog.number((millis * scale).round() / scale)
}

fn inequality(look: Look<'_>, costs: &Costs) -> Message {
    let [_, rough, exact] = costs;
    let compared = |a: f64, b: f64| {
        let written = [a, b].map(|secs| millis(look, secs));
        let sign = match a < b {
            _ if written[0] == written[1] => "≈",
            true => "<",
            false => ">",
        };
        (written, sign.to_owned())
    };
    let ([rough_cull, exact_cull], cull) = compared(rough.cull_secs, exact.cull_secs);
    let ([rough_draw, exact_draw], draw) = compared(rough.draw_secs, exact.draw_secs);
    Message::new("culling-inequality")
        .with("rough-cull", rough_cull)
        .with("cull-relation", cull)
        .with("exact-cull", exact_cull)
        .with("rough-draw", rough_draw)
        .with("draw-relation", draw)
        .with("exact-draw", exact_draw)
}

fn lines(ui: &mut Ui, look: Look<'_>, costs: &CullingCosts, height: f32) {
    let line = |(i, culling): (usize, Culling)| {
        let (color, style) = match culling {
            Culling::Nothing => (look.theme.soft, LineStyle::dashed_loose()),
            Culling::Rough => (look.theme.accent, LineStyle::Solid),
            Culling::Exact => (look.theme.ink, LineStyle::dotted_dense()),
        };
        let known = costs.sweep.iter().zip(SWEEP);
        let points = known.map(|(costs, count)| [count as f64, 1e3 * costs[i].secs()]);
        PowerLine {
            name_key: culling.name_key(),
            color,
            style,
            points: points.collect(),
        }
    };
    let lines: Vec<PowerLine> = Culling::ALL.into_iter().enumerate().map(line).collect();
    let axes = ["culling-axis-objects", "culling-axis-millis"];
    power_plot(ui, look, ("culling-lines", axes), height, &lines);
}

/// Which way is the fastest, and from how many objects on it is another.
fn best(sweep: &[Costs]) -> Option<Message> {
    if sweep.len() < SWEEP.len() {
        return None;
    }
    let fastest = |costs: &Costs| {
        let ways = costs.iter().min_by(|a, b| a.secs().total_cmp(&b.secs()));
        ways.map(|cost| cost.culling)
    };
    let ways: Vec<Culling> = sweep.iter().filter_map(fastest).collect();
    let (&first, &last) = (ways.first()?, ways.last()?);
    let name = |culling: Culling| Value::Term(culling.name_key());
    Some(match ways.iter().rposition(|&way| way != last) {
        None => Message::new("culling-best-always").with("way", name(last)),
        Some(few) => Message::new("culling-best-changes")
            .with("first", name(first))
            .with("last", name(last))
            .with("few", SWEEP[few])
            .with("many", SWEEP[few + 1]),
    })
}
