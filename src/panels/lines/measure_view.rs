//! The measured costs as bars: time and operations for one segment.

use egui::{Align2, ProgressBar, RichText, Ui, Vec2b};
use egui_plot::{Bar, BarChart, Plot, PlotPoint, Text};

use crate::{labs::lines::Method, paint::theme, text::Message, widgets::Look};

use super::{Measure, measure::MethodCost};

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
        let height = (ui.ctx().content_rect().height() - 260.0).clamp(80.0, 320.0);
        ui.columns(2, |columns| {
            let nanos = |cost: &MethodCost| cost.nanos;
            chart(
                &mut columns[0],
                look,
                "measure-nanos",
                height,
                measure.costs(),
                &nanos,
            );
            let operations = |cost: &MethodCost| cost.operations.iter().sum();
            chart(
                &mut columns[1],
                look,
                "measure-operations",
                height,
                measure.costs(),
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

/// One horizontal bar a method, its name over it and its value after it.
fn chart(
    ui: &mut Ui,
    look: Look<'_>,
    key: &str,
    height: f32,
    costs: &[(Method, MethodCost)],
    value: &dyn Fn(&MethodCost) -> f64,
) {
    ui.label(RichText::new(look.say(key)).text_style(theme::strong()));
    let n_rows = Method::all().len();
    let most = costs
        .iter()
        .map(|(_, cost)| value(cost))
        .fold(0.0, f64::max)
        .max(1e-9);
    let row = |i: usize| (n_rows - i) as f64;
    let bars = costs.iter().enumerate().map(|(i, (_, cost))| {
        Bar::new(row(i) - 0.2, value(cost))
            .width(0.3)
            .fill(look.theme.accent)
    });
    let chart = BarChart::new(key, bars.collect())
        .horizontal()
        .allow_hover(false);
    let names: Vec<(f64, String)> = costs
        .iter()
        .enumerate()
        .map(|(i, (method, cost))| {
            let name = look.say(method.info().name_key);
            let value = look.catalog.number((value(cost) * 10.0).round() / 10.0);
            (row(i) + 0.02, format!("{name}  {value}"))
        })
        .collect();
    still(key).height(height).show(ui, |plot| {
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

/// A plot that only shows: it has no axes and cannot be moved.
fn still(key: &str) -> Plot<'static> {
    Plot::new(key)
        .show_axes(false)
        .show_grid(false)
        .show_background(false)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .show_x(false)
        .show_y(false)
        .cursor_color(egui::Color32::TRANSPARENT)
        .auto_bounds(Vec2b::FALSE)
}
