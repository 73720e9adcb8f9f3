//! Small signs drawn as shapes: crisp at every size, and independent of fonts.

use egui::{
    Color32, CursorIcon, Painter, Rect, Response, Role, Sense, Shape, Stroke, StrokeKind, Ui, Vec2,
    WidgetInfo, pos2, vec2,
};

use super::look::Look;

/// A sign on a button.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Icon {
    /// A bar and a triangle to the left.
    First,
    /// A triangle to the left.
    Back,
    /// A triangle to the right.
    Play,
    /// Two bars.
    Pause,
    /// A triangle to the right.
    Forward,
    /// A triangle to the right and a bar.
    Last,
    /// A panel at the left.
    LeftPanel,
    /// A panel at the right.
    RightPanel,
    /// Three dots: more.
    More,
    /// A cross: close.
    Close,
}

impl Icon {
    /// Draws the sign in the middle of a rectangle.
    pub fn draw(self, painter: &Painter, rect: Rect, colour: Color32) {
        // Halves, so that edges fall on pixels at one pixel a point.
        let c = rect.center().round();
        let bar = |x: f32| {
            let bar = Rect::from_center_size(pos2(c.x + x, c.y), vec2(2.0, 12.0));
            painter.rect_filled(bar, 0.0, colour);
        };
        let triangle = |x: f32, to_right: bool| {
            let tip = if to_right { 5.0 } else { -5.0 };
            let points = vec![
                pos2(c.x + x + tip, c.y),
                pos2(c.x + x - tip, c.y - 6.0),
                pos2(c.x + x - tip, c.y + 6.0),
            ];
            painter.add(Shape::convex_polygon(points, colour, Stroke::NONE));
        };
        match self {
            Self::First => {
                bar(-6.0);
                triangle(2.0, false);
            }
            Self::Back => triangle(0.0, false),
            Self::Play => triangle(1.5, true),
            Self::Forward => triangle(0.0, true),
            Self::Last => {
                triangle(-2.0, true);
                bar(6.0);
            }
            Self::Pause => {
                for x in [-3.5, 3.5] {
                    let bar = Rect::from_center_size(pos2(c.x + x, c.y), vec2(4.0, 13.0));
                    painter.rect_filled(bar, 1.0, colour);
                }
            }
            Self::LeftPanel | Self::RightPanel => {
                let frame = Rect::from_center_size(c, vec2(15.0, 12.0));
                painter.rect_stroke(frame, 2.0, Stroke::new(1.25, colour), StrokeKind::Middle);
                let x = if self == Self::LeftPanel { -2.5 } else { 2.5 };
                painter.vline(c.x + x, frame.y_range(), Stroke::new(1.25, colour));
            }
            Self::More => {
                for x in [-5.0, 0.0, 5.0] {
                    painter.circle_filled(c + vec2(x, 0.0), 1.6, colour);
                }
            }
            Self::Close => {
                for y in [-4.0, 4.0] {
                    let line = [c + vec2(-4.0, -y), c + vec2(4.0, y)];
                    painter.line_segment(line, Stroke::new(1.5, colour));
                }
            }
        }
    }
}

/// A quiet square button with a sign; `name` is said by screen readers and shown as its tooltip.
pub fn icon_button(ui: &mut Ui, look: Look<'_>, icon: Icon, name: &str, enabled: bool) -> Response {
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(32.0), Sense::click());
    let theme = look.theme;
    let colour = match (enabled, response.hovered()) {
        (false, _) => theme.faint.gamma_multiply(0.6),
        (true, true) => theme.ink,
        (true, false) => theme.soft,
    };
    if enabled && response.hovered() {
        ui.painter().rect_filled(rect, 4.0, theme.hover);
    }
    icon.draw(ui.painter(), rect, colour);
    finish(ui, look, response, rect, name, enabled)
}

/// The disc of the transport's play button.
pub(super) fn disc_button(ui: &mut Ui, look: Look<'_>, icon: Icon, name: &str) -> Response {
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(32.0), Sense::click());
    let theme = look.theme;
    let fill = if response.hovered() {
        theme.accent.lerp_to_gamma(theme.ink, 0.15)
    } else {
        theme.accent
    };
    ui.painter().circle_filled(rect.center(), 16.0, fill);
    icon.draw(ui.painter(), rect, theme.background);
    finish(ui, look, response, rect, name, true)
}

fn finish(
    ui: &Ui,
    look: Look<'_>,
    response: Response,
    rect: Rect,
    name: &str,
    enabled: bool,
) -> Response {
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    if response.has_focus() {
        let ring = look.theme.stroke(2.0, look.theme.accent);
        ui.painter()
            .rect_stroke(rect.expand(2.0), 6.0, ring, StrokeKind::Inside);
    }
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text(name)
}
