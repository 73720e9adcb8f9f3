//! The measured costs as bars: time and operations for one segment.

use egui::{Align2, RichText, Ui};
use egui_plot::{Bar, BarChart, PlotPoint, Text};

use crate::{
    paint::theme,
    panels::{bench::note, plots::still_plot},
    text::Message,
    widgets::Look,
};

use super::measure::{Measure, Subject};

/// The charts of the costs, and the number of segments that they are an average of.
pub fn measured(ui: &mut Ui, look: Look<'_>, measure: &Measure) {
    let costs = measure.costs();
    let height = (ui.ctx().content_rect().height() - 260.0).clamp(80.0, 320.0);
    let nanos: Vec<_> = costs
        .iter()
        .map(|cost| (cost.subject, Some(cost.nanos)))
        .collect();
    let operations: Vec<_> = costs
        .iter()
        .map(|cost| (cost.subject, cost.operations))
        .collect();
    ui.columns(2, |columns| {
        chart(&mut columns[0], look, "measure-nanos", height, &nanos);
        chart(
            &mut columns[1],
            look,
            "measure-operations",
            height,
            &operations,
        );
    });
    let message = Message::new("measure-note").with("count", measure.n_segments());
    note(ui, look, look.catalog.message(&message));
}

/// One horizontal bar a subject, its name and value over it.
fn chart(ui: &mut Ui, look: Look<'_>, key: &str, height: f32, values: &[(Subject, Option<f64>)]) {
    ui.label(RichText::new(look.say(key)).text_style(theme::strong()));
    let n_rows = Subject::all().count();
    let row = |i: usize| (n_rows - i) as f64;
    let known = || {
        values
            .iter()
            .enumerate()
            .filter_map(|(i, (subject, value))| Some((i, subject, (*value)?)))
    };
    let most = known().map(|(_, _, value)| value).fold(1e-9, f64::max);
    let bars = known().map(|(i, _, value)| {
        Bar::new(row(i) - 0.2, value)
            .width(0.3)
            .fill(look.theme.accent)
    });
    let chart = BarChart::new(key, bars.collect())
        .horizontal()
        .allow_hover(false);
    let names: Vec<(f64, String)> = known()
        .map(|(i, subject, value)| {
            let name = look.say(subject.name_key());
            let value = look.catalog.number((value * 10.0).round() / 10.0);
            (row(i) + 0.02, format!("{name}  {value}"))
        })
        .collect();
    still_plot(key).height(height).show(ui, |plot| {
        let bounds =
            egui_plot::PlotBounds::from_min_max([0.0, 0.4], [most * 1.02, n_rows as f64 + 0.6]);
        plot.set_plot_bounds(bounds);
        plot.bar_chart(chart);
        for (y, name) in names {
            let text = RichText::new(name).small().color(look.theme.ink);
            plot.text(
                Text::new("name", PlotPoint::new(0.0, y), text)
                    .anchor(Align2::LEFT_BOTTOM)
                    .allow_hover(false),
            );
        }
    });
}
