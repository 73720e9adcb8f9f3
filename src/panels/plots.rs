//! Plots of costs: bars without axes, and counts or times over a number, both by their logarithms.

use egui::{Align2, Color32, RichText, Stroke, Ui, Vec2b};
use egui_plot::{BarChart, Line, LineStyle, Plot, PlotBounds, PlotPoint, Text};

use crate::widgets::Look;

fn still_plot(key: &str) -> Plot<'static> {
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
        .cursor_color(Color32::TRANSPARENT)
        .auto_bounds(Vec2b::FALSE)
}

/// Horizontal bars in so many rows, as far as a value, and texts at their heights.
pub fn row_bars(
    ui: &mut Ui,
    look: Look<'_>,
    (key, height): (&str, f32),
    (n_rows, right): (usize, f64),
    charts: Vec<BarChart>,
    texts: impl Iterator<Item = (f64, String)>,
) {
    still_plot(key).height(height).show(ui, |plot| {
        let top = n_rows as f64 + 0.6;
        plot.set_plot_bounds(PlotBounds::from_min_max([0.0, 0.4], [right, top]));
        for chart in charts {
            plot.bar_chart(chart);
        }
        for (y, text) in texts {
            let text = RichText::new(text).small().color(look.theme.ink);
            let text = Text::new("row", PlotPoint::new(0.0, y), text);
            plot.text(text.anchor(Align2::LEFT_BOTTOM).allow_hover(false));
        }
    });
}

pub struct PowerLine {
    pub name_key: &'static str,
    pub color: Color32,
    pub style: LineStyle,
    /// All above 0.
    pub points: Vec<[f64; 2]>,
}

/// Lines over powers of ten, up to 10⁴ and room for names; `axes` are the catalogue keys of what stands along them.
pub fn power_plot(
    ui: &mut Ui,
    look: Look<'_>,
    (id, axes): (&'static str, [&'static str; 2]),
    height: f32,
    lines: Vec<PowerLine>,
) {
    let power = |value: f64| look.catalog.number(10.0_f64.powi(value.round() as i32));
    let plot = Plot::new(id)
        .height(height)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .show_background(false)
        .x_axis_label(look.say(axes[0]))
        .y_axis_label(look.say(axes[1]))
        .x_axis_formatter(move |mark, _| whole(mark.value, power))
        .y_axis_formatter(move |mark, _| whole(mark.value, power))
        .include_x(0.0)
        .include_x(5.4)
        .show_grid([false, true]);
    plot.show(ui, |plot| {
        for PowerLine {
            name_key,
            color,
            style,
            points,
        } in lines
        {
            let points: Vec<[f64; 2]> = points.iter().map(|at| at.map(libm::log10)).collect();
            let last = points.last().copied();
            let line = Line::new(look.say(name_key), points);
            let line = line.stroke(Stroke::new(2.0, color)).style(style);
            plot.line(line.allow_hover(false));
            if let Some([x, y]) = last {
                let name = RichText::new(look.say(name_key)).small().color(color);
                let text = Text::new("name", PlotPoint::new(x + 0.05, y), name);
                plot.text(text.anchor(Align2::LEFT_CENTER).allow_hover(false));
            }
        }
    });
}

/// A mark of a logarithmic axis: of whole powers only.
fn whole(value: f64, power: impl Fn(f64) -> String) -> String {
    if (value - value.round()).abs() < 1e-6 {
        power(value)
    } else {
        String::new()
    }
}
