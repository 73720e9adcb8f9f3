//! The transport: first, back, play, forward, last, as signs that are drawn, not written; and the speed.

use egui::Role;

use crate::{paint::fonts::semibold, trace::Transport};

use super::{
    fingers::target,
    headings::focus_ring,
    menu::{is_chosen, menu_button},
    prelude::*,
};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Press {
    First,
    Back,
    Play,
    Forward,
    Last,
}

pub const fn transport_width() -> f32 {
    5.0 * 32.0 + 4.0 * 4.0
}

pub fn transport_buttons(ui: &mut Ui, look: Look<'_>, transport: &Transport) -> Option<Press> {
    let mut pressed = None;
    ui.spacing_mut().item_spacing.x = 4.0;
    let at_start = transport.position() == 0;
    let at_end = transport.position() >= transport.n_steps();
    let mut quiet = |ui: &mut Ui, icon, key, enabled, press| {
        if icon_button(ui, look, icon, &look.say(key), enabled).clicked() {
            pressed = Some(press);
        }
    };
    quiet(ui, Icon::First, "transport-first", !at_start, Press::First);
    quiet(ui, Icon::Back, "transport-back", !at_start, Press::Back);
    let (icon, key) = if transport.is_playing() {
        (Icon::Pause, "transport-pause")
    } else {
        (Icon::Play, "transport-play")
    };
    let can_play = transport.n_steps() > 0;
    let play = ui.add_enabled_ui(can_play, |ui| disc_button(ui, look, icon, &look.say(key)));
    let play = play.inner.clicked();
    let (icon, press) = (Icon::Forward, Press::Forward);
    quiet(ui, icon, "transport-forward", !at_end, press);
    quiet(ui, Icon::Last, "transport-last", !at_end, Press::Last);
    if play { Some(Press::Play) } else { pressed }
}

pub fn speed_menu(ui: &mut Ui, look: Look<'_>, speed: f32) -> Option<f32> {
    let written = |speed: f32| format!("{}×", look.catalog.number(f64::from(speed)));
    let mut chosen = None;
    let button = menu_button(ui, written(speed), |ui| {
        for choice in Transport::SPEEDS {
            if is_chosen(ui, choice == speed, written(choice)) {
                chosen = Some(choice);
            }
        }
    });
    let name = Message::new("transport-speed-value").with("speed", Value::Number(f64::from(speed)));
    button.response.on_hover_text(look.catalog.message(&name));
    chosen
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Icon {
    First,
    Back,
    Play,
    Pause,
    Forward,
    Last,
    LeftPanel,
    RightPanel,
    More,
    Question,
    Close,
}

impl Icon {
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
            Self::Question => {
                let font = FontId::new(16.0, semibold());
                painter.text(c, Align2::CENTER_CENTER, "?", font, colour);
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

pub fn icon_button(ui: &mut Ui, look: Look<'_>, icon: Icon, name: &str, enabled: bool) -> Response {
    // What cannot be pressed is no stop of Tab.
    let sense = if enabled {
        Sense::click()
    } else {
        Sense::hover()
    };
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(target(ui, 32.0)), sense);
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

fn disc_button(ui: &mut Ui, look: Look<'_>, icon: Icon, name: &str) -> Response {
    let side = target(ui, 32.0);
    large_button(ui, look, (icon, side), name, true)
}

/// A disc so many points wide.
pub fn large_button(
    ui: &mut Ui,
    look: Look<'_>,
    (icon, side): (Icon, f32),
    name: &str,
    enabled: bool,
) -> Response {
    let theme = look.theme;
    if !enabled {
        let (rect, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::hover());
        let rim = theme.stroke(1.0, theme.hairline);
        ui.painter()
            .circle_stroke(rect.center(), 0.5 * side - 0.5, rim);
        icon.draw(ui.painter(), rect, theme.faint);
        return finish(ui, look, response, rect, name, false);
    }
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::click());
    let fill = if response.hovered() {
        theme.accent.lerp_to_gamma(theme.ink, 0.15)
    } else {
        theme.accent
    };
    ui.painter().circle_filled(rect.center(), 0.5 * side, fill);
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
    focus_ring(ui.painter(), look, &response, rect.expand(2.0), 6.0);
    let response = response.on_hover_cursor(CursorIcon::PointingHand);
    response.on_hover_text(name)
}
