//! The second view of parametric clippers: what is left of the parameter's interval.
//!
//! ```text
//!        left ▷ 1/4                ◁ 3/4 right
//!   ┬──────────┲━━━━━━━━━━━━━━━━━━━━┱──────────┬
//!   0        u_min                u_max        1
//! ```

use egui::{
    Align2, Color32, FontId, Pos2, Rect, Response, Role, Shape, Stroke, TextStyle, Ui, UiBuilder,
    Vec2, Vec2b, WidgetInfo, pos2, vec2,
};
use egui_plot::{
    Line, LineStyle, MarkerShape, Plot, PlotBounds, PlotPoints, PlotTransform, PlotUi, Points,
};

use crate::{
    figure::{LineTick, Link, NumberLine, Side},
    paint::Theme,
};

use super::super::Look;

/// How much of the line is always seen, beyond 0 and 1.
const BEYOND: f64 = 0.25;
/// Crossings farther out than this are drawn at the end of the line, as arrows that point to them.
const FARTHEST: f64 = 2.0;
/// Rows of labels above the line.
const LANES: usize = 3;

/// Height of the view.
#[must_use]
pub fn number_line_height(theme: &Theme) -> f32 {
    (56.0 + LANES as f32 * lane_height(theme)).round()
}

fn lane_height(theme: &Theme) -> f32 {
    15.0 * theme.text_scale
}

/// Draws the view in `rect`; the link of the crossing under the pointer.
pub fn number_line(
    ui: &mut Ui,
    look: Look<'_>,
    rect: Rect,
    line: &NumberLine,
    lit: Option<Link>,
) -> Option<Link> {
    let theme = look.theme;
    ui.painter().rect_filled(rect, 0.0, theme.background);
    ui.painter().hline(
        rect.x_range(),
        rect.top() + 0.5,
        Stroke::new(1.0, theme.hairline),
    );
    let inner = rect.shrink2(vec2(24.0_f32.min(rect.width() * 0.05), 8.0));
    let [low, high] = range(line);
    let shown = ui
        .scope_builder(UiBuilder::new().max_rect(inner), |ui| {
            plot(ui, theme, inner.size(), [low, high], line)
        })
        .inner;
    let (response, transform) = shown;
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, spoken(look, line)));
    let painting = Painting {
        ui,
        look,
        line,
        lit,
        transform,
        clamp: [low, high],
    };
    painting.axis();
    painting.bounds();
    painting.ticks(&response)
}

/// The part of the line that is shown.
fn range(line: &NumberLine) -> [f64; 2] {
    let ticks = line
        .ticks
        .iter()
        .map(|tick| tick.u.clamp(-FARTHEST, 1.0 + FARTHEST));
    let [mut low, mut high] = [0.0_f64, 1.0_f64];
    for u in ticks.filter(|u| u.is_finite()) {
        (low, high) = (low.min(u), high.max(u));
    }
    [low - BEYOND, high + BEYOND]
}

/// The plot gives the axis its scale, the interval and the markers.
fn plot(
    ui: &mut Ui,
    theme: &Theme,
    size: Vec2,
    [low, high]: [f64; 2],
    line: &NumberLine,
) -> (Response, PlotTransform) {
    let shown = Plot::new("number line")
        .width(size.x)
        .height(size.y)
        .show_axes(false)
        .show_grid(false)
        .show_background(false)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_scroll(false)
        .allow_boxed_zoom(false)
        .allow_double_click_reset(false)
        .auto_bounds(Vec2b::FALSE)
        .set_margin_fraction(Vec2::ZERO)
        .show_x(false)
        .show_y(false)
        .cursor_color(Color32::TRANSPARENT)
        .show(ui, |plot| {
            items(plot, theme, [low, high], line);
        });
    (shown.response, shown.transform)
}

/// The axis, what is left of it, and the crossings.
fn items(plot: &mut PlotUi<'_>, theme: &Theme, [low, high]: [f64; 2], line: &NumberLine) {
    // The line lies low: labels stand above it.
    plot.set_plot_bounds(PlotBounds::from_min_max([low, -0.55], [high, 1.0]));
    let mut stretch = |from: f64, to: f64, stroke: Stroke, style: LineStyle| {
        let points = PlotPoints::new(vec![[from, 0.0], [to, 0.0]]);
        let item = Line::new("", points).stroke(stroke).style(style);
        plot.line(item.allow_hover(false));
    };
    stretch(low, high, Stroke::new(1.5, theme.faint), LineStyle::Solid);
    let [from, to] = line.interval;
    if line.empty {
        let nothing = theme.stroke(2.0, theme.discarded);
        stretch(to, from, nothing, LineStyle::dashed_dense());
    } else {
        stretch(from, to, theme.stroke(5.0, theme.accent), LineStyle::Solid);
    }
    for tick in &line.ticks {
        let u = tick.u.clamp(low + 0.5 * BEYOND, high - 0.5 * BEYOND);
        let shape = match tick.side {
            Side::Entering => MarkerShape::Right,
            Side::Leaving => MarkerShape::Left,
        };
        let marker = Points::new("", vec![[u, 0.0]])
            .shape(shape)
            .radius(6.5 * theme.stroke_scale.sqrt())
            .color(colour(theme, tick));
        plot.points(marker.filled(true).allow_hover(false));
    }
}

/// This step's crossing is signal; one that holds a bound is accent; one that no longer matters is grey.
fn colour(theme: &Theme, tick: &LineTick) -> Color32 {
    match tick {
        LineTick { current: true, .. } => theme.signal,
        LineTick { holds: true, .. } => theme.accent,
        _ => theme.discarded,
    }
}

struct Painting<'a> {
    ui: &'a Ui,
    look: Look<'a>,
    line: &'a NumberLine,
    lit: Option<Link>,
    transform: PlotTransform,
    clamp: [f64; 2],
}

impl Painting<'_> {
    fn at(&self, u: f64) -> Pos2 {
        let inside = u.clamp(self.clamp[0], self.clamp[1]);
        let x = self.transform.position_from_point_x(inside);
        pos2(x, self.transform.position_from_point_y(0.0)).round()
    }

    fn mono(&self) -> FontId {
        TextStyle::Monospace.resolve(self.ui.style())
    }

    /// 0 and 1, and the parameter's name at the right end.
    fn axis(&self) {
        let theme = self.look.theme;
        for u in [0.0, 1.0] {
            let at = self.at(u);
            let tick = Rect::from_center_size(at, vec2(1.5, 12.0));
            self.ui.painter().rect_filled(tick, 0.0, theme.soft);
        }
        let end = self.at(self.clamp[1]);
        let tip = [end, end + vec2(-7.0, -3.5), end + vec2(-7.0, 3.5)];
        self.ui.painter().add(Shape::convex_polygon(
            tip.to_vec(),
            theme.faint,
            Stroke::NONE,
        ));
        self.ui.painter().text(
            end + vec2(0.0, 10.0),
            Align2::RIGHT_TOP,
            self.line.symbol,
            self.mono(),
            theme.soft,
        );
    }

    /// Below the line: both bounds, and 0 and 1 where those do not stand there already.
    fn bounds(&self) {
        let theme = self.look.theme;
        let mut taken: Vec<Rect> = Vec::new();
        let symbol = self.line.symbol;
        let value = |u: f64| self.look.catalog.number(u);
        let [low, high] = self.line.interval;
        let colour = if self.line.empty {
            theme.discarded
        } else {
            theme.accent
        };
        let labels = [
            (low, format!("{symbol}_min = {}", value(low)), colour),
            (high, format!("{symbol}_max = {}", value(high)), colour),
            (0.0, "0".to_owned(), theme.soft),
            (1.0, "1".to_owned(), theme.soft),
        ];
        for (u, text, colour) in labels {
            let galley = self
                .ui
                .fonts_mut(|fonts| fonts.layout_no_wrap(text, self.mono(), colour));
            let room = *self.transform.frame();
            let size = galley.size();
            let centre = self.at(u).x.clamp(
                room.left() + 0.5 * size.x,
                (room.right() - 0.5 * size.x - 16.0).max(room.left() + 0.5 * size.x),
            );
            let mut place =
                Rect::from_min_size(pos2(centre - 0.5 * size.x, self.at(u).y + 9.0), size);
            if let Some(first) = taken
                .iter()
                .find(|other| other.expand(6.0).intersects(place))
            {
                if u == 0.0 || u == 1.0 {
                    continue;
                }
                // Two bounds close together: side by side.
                place = place.translate(vec2(first.right() + 12.0 - place.left(), 0.0));
            }
            self.ui.painter().galley(place.min, galley, colour);
            taken.push(place);
        }
    }

    /// Above the line: the crossings' names and values, on as many lanes as it takes.
    fn ticks(&self, response: &Response) -> Option<Link> {
        let theme = self.look.theme;
        let pointer = response.hover_pos();
        let mut pointed = None;
        let mut taken: Vec<Rect> = Vec::new();
        // What matters now gets the lowest lane.
        let mut ticks: Vec<&LineTick> = self.line.ticks.iter().collect();
        ticks.sort_by_key(|tick| (!tick.current, !tick.holds));
        for tick in ticks {
            let at = self.at(tick.u);
            let is_lit = tick.link.is_some() && tick.link == self.lit;
            let is_near = pointer.is_some_and(|pointer| {
                (pointer.x - at.x).abs() <= 8.0 && (pointer.y - at.y).abs() <= 16.0
            });
            if is_near {
                pointed = tick.link;
            }
            if is_lit || is_near {
                self.ui
                    .painter()
                    .circle_stroke(at, 11.0, Stroke::new(1.5, theme.accent));
            }
            let words = format!(
                "{}  {}",
                self.look.catalog.value(&tick.name),
                self.look.catalog.number(tick.u)
            );
            let colour = colour(theme, tick);
            let font = TextStyle::Small.resolve(self.ui.style());
            let galley = self
                .ui
                .fonts_mut(|fonts| fonts.layout_no_wrap(words, font, colour));
            let Some(place) = self.free_lane(at, galley.size(), &taken) else {
                continue;
            };
            let foot = pos2(at.x, place.bottom() + 1.0);
            if foot.y < at.y - 14.0 {
                self.ui.painter().vline(
                    at.x,
                    foot.y..=at.y - 10.0,
                    Stroke::new(1.0, colour.gamma_multiply(0.5)),
                );
            }
            self.ui.painter().galley(place.min, galley, colour);
            taken.push(place);
        }
        pointed
    }

    fn free_lane(&self, at: Pos2, size: Vec2, taken: &[Rect]) -> Option<Rect> {
        let room = *self.transform.frame();
        let most = (room.right() - 0.5 * size.x).max(room.left() + 0.5 * size.x);
        let centre = at.x.clamp(room.left() + 0.5 * size.x, most);
        (0..LANES)
            .map(|lane| {
                let bottom = at.y - 10.0 - lane as f32 * lane_height(self.look.theme);
                Rect::from_min_size(pos2(centre - 0.5 * size.x, bottom - size.y).round(), size)
            })
            .find(|place| {
                taken
                    .iter()
                    .all(|other| !other.expand2(vec2(6.0, 0.0)).intersects(*place))
            })
    }
}

fn spoken(look: Look<'_>, line: &NumberLine) -> String {
    let [low, high] = line.interval.map(|u| look.catalog.number(u));
    format!("{}: {} … {}", line.symbol, low, high)
}
