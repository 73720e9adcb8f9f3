//! The measured costs as bars: time and operations for one segment.

use egui::{Align2, ProgressBar, RichText, Ui};
use egui_plot::{Bar, BarChart, PlotPoint, Text};

use crate::{paint::theme, panels::still_plot, text::Message, widgets::Look};

use super::{Measure, measure::Subject};

/// What was asked for in the window.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MeasureAsk {
    /// Measure, or measure again.
    Start,
    /// Close the window.
    Close,
}

/// The window's content.
pub fn measure_window(
    ui: &mut Ui,
    look: Look<'_>,
    measure: Option<&Measure>,
) -> Option<MeasureAsk> {
    let mut asked = None;
    ui.set_max_width(560.0_f32.min(ui.ctx().content_rect().width() - 48.0));
    ui.label(RichText::new(look.say("measure-title")).heading());
    ui.label(RichText::new(look.say("measure-about")).color(look.theme.soft));
    if let Some(measure) = measure {
        if !measure.is_done() {
            ui.add(ProgressBar::new(measure.progress()).desired_height(6.0));
        }
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
        let note = Message::new("measure-note").with("count", measure.n_segments());
        ui.label(
            RichText::new(look.catalog.message(&note))
                .small()
                .color(look.theme.soft),
        );
    }
    ui.horizontal(|ui| {
        let is_busy = measure.is_some_and(|measure| !measure.is_done());
        let start = egui::Button::new(look.say(if measure.is_some() {
            "measure-again"
        } else {
            "measure-start"
        }));
        if ui.add_enabled(!is_busy, start).clicked() {
            asked = Some(MeasureAsk::Start);
        }
        if ui.button(look.say("action-close")).clicked() {
            asked = Some(MeasureAsk::Close);
        }
    });
    asked
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
