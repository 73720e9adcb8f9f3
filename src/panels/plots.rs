//! Plots of costs: bars without axes, and counts or times over a number, both by their logarithms.

use egui::{Align2, Color32, Rect, RichText, Sense, Stroke, TextStyle, Ui, Vec2, Vec2b, vec2};
use egui_plot::{BarChart, Line, LineStyle, Plot, PlotBounds, PlotPoint, Text};

use crate::widgets::Look;

/// Nothing in it can be moved, so that the Tab key does not stop at it.
fn fixed_plot(key: &str) -> Plot<'static> {
    Plot::new(key)
        .sense(Sense::hover())
        .show_background(false)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
}

fn still_plot(key: &str) -> Plot<'static> {
    fixed_plot(key)
        .show_axes(false)
        .show_grid(false)
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
    lines: &[PowerLine],
) {
    let power = |value: f64| match 10.0_f64.powi(value.round() as i32) {
        large @ 10_000.0.. => look.catalog.grouped(large),
        x => look.catalog.number(x),
    };
    let plot = fixed_plot(id)
        .height(height)
        .x_axis_label(look.say(axes[0]))
        .y_axis_label(look.say(axes[1]))
        .x_axis_formatter(move |mark, _| whole(mark.value, power))
        .y_axis_formatter(move |mark, _| whole(mark.value, power))
        .include_x(0.0)
        .include_x(5.4)
        .show_grid([false, true]);
    let font = TextStyle::Small.resolve(ui.style());
    let size = |key: &str| {
        let name = ui
            .painter()
            .layout_no_wrap(look.say(key), font.clone(), look.theme.ink);
        name.size()
    };
    let sizes: Vec<Vec2> = lines.iter().map(|line| size(line.name_key)).collect();
    plot.show(ui, |plot| {
        let last = |line: &PowerLine| line.points.last().map(|at| at.map(libm::log10));
        let place = |(line, size): (&PowerLine, &Vec2)| {
            let [x, y] = last(line)?;
            let at = plot.screen_from_plot(PlotPoint::new(x + 0.05, y));
            Some(Align2::LEFT_CENTER.anchor_size(at, *size))
        };
        let places = apart(lines.iter().zip(&sizes).map(place).collect());
        let places = places
            .into_iter()
            .map(|place| Some(plot.plot_from_screen(place?.left_center())));
        let places: Vec<Option<PlotPoint>> = places.collect();
        for line in lines {
            let points = line.points.iter().map(|at| at.map(libm::log10));
            let drawn = Line::new(look.say(line.name_key), points.collect::<Vec<_>>());
            let drawn = drawn.stroke(Stroke::new(2.0, line.color)).style(line.style);
            plot.line(drawn.allow_hover(false));
        }
        for (line, place) in lines.iter().zip(places) {
            if let Some(place) = place {
                let name = RichText::new(look.say(line.name_key)).small();
                let text = Text::new("name", place, name.color(line.color));
                plot.text(text.anchor(Align2::LEFT_CENTER).allow_hover(false));
            }
        }
    });
}

/// Names at the ends of lines, each moved down until it lies on none of those that are higher.
fn apart(mut places: Vec<Option<Rect>>) -> Vec<Option<Rect>> {
    let top = |place: &Option<Rect>| place.map_or(f32::INFINITY, |place| place.top());
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|&a, &b| top(&places[a]).total_cmp(&top(&places[b])));
    for nth in 1..order.len() {
        for before in 0..nth {
            let [over, under] = [before, nth].map(|nth| places[order[nth]]);
            if let (Some(over), Some(under)) = (over, under)
                && over.intersects(under)
            {
                let down = vec2(0.0, over.bottom() - under.top());
                places[order[nth]] = Some(under.translate(down));
            }
        }
    }
    places
}

/// A mark of a logarithmic axis: of whole powers only.
fn whole(value: f64, power: impl Fn(f64) -> String) -> String {
    if (value - value.round()).abs() < 1e-6 {
        power(value)
    } else {
        String::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_at_the_ends_of_lines_lie_on_none_of_the_others() {
        let name = |x: f32, y: f32| Some(Rect::from_min_size(egui::pos2(x, y), vec2(60.0, 14.0)));
        let places = vec![
            name(10.0, 40.0),
            None,
            name(12.0, 38.0),
            name(200.0, 39.0),
            name(0.0, 45.0),
        ];
        let apart: Vec<Rect> = apart(places.clone()).into_iter().flatten().collect();
        for (i, place) in apart.iter().enumerate() {
            // What only touches lies on nothing.
            let inside = place.shrink(0.01);
            assert!(
                apart[..i].iter().all(|other| !other.intersects(inside)),
                "{apart:?}"
            );
        }
        assert_eq!(apart[2], places[3].expect("a name"), "what has room stays");
    }
}
