//! A section of the inspector: rows with a name at the left and at the right what can be set.

use egui::{
    Align, Area, Checkbox, Color32, ComboBox, CornerRadius, Frame, Id, Key, Label, Layout, Order,
    Response, RichText, Sense, Shape, Stroke, StrokeKind, TextStyle, Ui, UiBuilder,
    epaint::RectShape, vec2,
};

use crate::{
    labs::Lock,
    text::{Diagnostic, Message},
    widgets::{Look, select},
};

/// Of a row, the part that its fields have.
const FIELDS: f32 = 0.6;
const GAP: f32 = 4.0;
/// So wide is what is said under a field.
const MOST_SAID: f32 = 220.0;
/// No number is longer.
const MOST_TYPED: usize = 64;

pub struct Form<'a> {
    pub look: Look<'a>,
    /// What the lesson holds in place.
    pub locks: &'a [Lock],
    /// The control that a text leads to: it is lit.
    pub lit: Option<&'a str>,
    /// Is it to have the focus?
    pub takes_focus: bool,
}

/// A row, before it is drawn: the control's id, its name, and the group of handles that it is locked with.
pub type Entry<'a> = (&'a str, &'a Message, &'a str);

impl Form<'_> {
    /// A row with as many fields side by side; what the first one says of those that have anything to say.
    pub fn row<R>(
        &self,
        ui: &mut Ui,
        (id, name, group): Entry<'_>,
        n_fields: usize,
        mut field: impl FnMut(&mut Ui, usize) -> (Option<R>, Response),
    ) -> Option<R> {
        let name = self.look.catalog.message(name);
        let is_locked = self.locks.iter().any(|lock| lock.holds(group));
        let (wash, room) = (ui.painter().add(Shape::Noop), FIELDS * ui.available_width());
        let mut said = None;
        // Whatever stands before it, a field keeps its id, and so the focus.
        let scope = UiBuilder::new().scope_id(Id::unique(("control", id)));
        let content = |ui: &mut Ui| {
            ui.spacing_mut().item_spacing.x = GAP;
            let field_width = (room + GAP) / n_fields.max(2) as f32 - GAP;
            let fields = n_fields as f32 * (field_width + GAP);
            let all = ui.available_width();
            self.name(ui, &name, [all - room - GAP, all - fields]);
            ui.spacing_mut().interact_size.x = field_width;
            fields_look(ui, self.look);
            for i in 0..n_fields {
                let (to, field) = ui.add_enabled_ui(!is_locked, |ui| field(ui, i)).inner;
                said = said.take().or(to);
                let name = match n_fields {
                    1 => name.clone(),
                    _ => format!("{name} {}", ["x", "y", "z"][i]),
                };
                let label = |node: &mut egui::accesskit::Node| node.set_label(name);
                ui.ctx().accesskit_node_builder(field.id, label);
                if self.lit == Some(id) && self.takes_focus && i == 0 {
                    field.request_focus();
                    field.scroll_to_me(None);
                    // All of it is typed over.
                    select(ui.ctx(), field.id, 0..MOST_TYPED);
                }
            }
        };
        let row = ui.scope_builder(scope, |ui| ui.horizontal(content).response);
        if is_locked {
            let why = Message::new("handle-locked").with("name", name);
            row.inner.on_hover_text(self.look.catalog.message(&why));
        } else if self.lit == Some(id) {
            let theme = self.look.theme;
            let (rect, corner) = (row.inner.rect.expand(2.0), CornerRadius::same(4));
            let stroke = theme.stroke(1.5, theme.accent);
            let lit = RectShape::new(rect, corner, theme.accent_wash, stroke, StrokeKind::Outside);
            ui.painter().set(wash, lit);
        }
        said
    }

    /// Says under a field why what was typed in it is not taken, until something else is done.
    pub fn refuse(&self, ui: &Ui, field: &Response, refusal: Option<Diagnostic>) {
        let (id, ctx) = (field.id.with("refused"), ui.ctx());
        let is_over = ui.input(|input| {
            let is_typed = |event: &egui::Event| matches!(event, egui::Event::Text(_));
            input.pointer.any_pressed()
                || input.key_pressed(Key::Escape)
                || input.events.iter().any(is_typed)
        });
        if let Some(refusal) = refusal {
            let said = self.look.catalog.message(&refusal.message);
            ctx.data_mut(|data| data.insert_temp(id, said));
        } else if is_over {
            ctx.data_mut(|data| data.remove::<String>(id));
        }
        let Some(said) = ctx.data(|data| data.get_temp::<String>(id)) else {
            return;
        };
        let frame = Frame::popup(ui.style()).fill(self.look.theme.background);
        Area::new(id)
            .order(Order::Foreground)
            .fixed_pos(field.rect.left_bottom() + vec2(0.0, GAP))
            .constrain(true)
            .show(ctx, |ui| {
                ui.set_max_width(MOST_SAID * self.look.theme.text_scale);
                let text = RichText::new(said).color(self.look.theme.signal_text);
                frame.show(ui, |ui| ui.add(Label::new(text).wrap()));
            });
    }

    /// As wide as in other rows; a longer one takes what the fields leave.
    fn name(&self, ui: &mut Ui, name: &str, [width, most]: [f32; 2]) {
        let font = TextStyle::Body.resolve(ui.style());
        let painter = ui.painter();
        let text = painter.layout_no_wrap(name.to_owned(), font, Color32::PLACEHOLDER);
        let width = text.size().x.clamp(width, most.max(width));
        let size = vec2(width, ui.spacing().interact_size.y);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let layout = Layout::left_to_right(Align::Center);
        let mut place = ui.new_child(UiBuilder::new().max_rect(rect).layout(layout));
        let text = RichText::new(name).color(self.look.theme.soft);
        place.add(Label::new(text).truncate());
    }

    pub fn check(&self, ui: &mut Ui, entry: Entry<'_>, is_on: bool) -> Option<bool> {
        self.row(ui, entry, 1, |ui, _| {
            let mut is_on = is_on;
            let response = ui.add(Checkbox::without_text(&mut is_on));
            (response.changed().then_some(is_on), response)
        })
    }

    /// One of several, each with its name.
    pub fn choice<T: Copy + PartialEq>(
        &self,
        ui: &mut Ui,
        entry: Entry<'_>,
        now: T,
        all: &[(T, String)],
    ) -> Option<T> {
        self.row(ui, entry, 1, |ui, _| {
            let mut chosen = now;
            let named = all.iter().find(|(it, _)| *it == now);
            let shown = named.map_or("", |(_, name)| name);
            let combo = ComboBox::from_id_salt(entry.0).selected_text(shown);
            let combo = combo.width(ui.available_width()).truncate();
            let response = combo.show_ui(ui, |ui| {
                for (it, name) in all {
                    ui.selectable_value(&mut chosen, *it, name);
                }
            });
            ((chosen != now).then_some(chosen), response.response)
        })
    }
}

/// What can be filled in has a ground and a rim of its own.
fn fields_look(ui: &mut Ui, look: Look<'_>) {
    let rim = Stroke::new(1.0, look.theme.faint);
    let widgets = &mut ui.visuals_mut().widgets;
    for state in [
        &mut widgets.inactive,
        &mut widgets.hovered,
        &mut widgets.open,
    ] {
        (state.bg_fill, state.bg_stroke) = (look.theme.background, rim);
    }
    widgets.inactive.weak_bg_fill = look.theme.background;
}
