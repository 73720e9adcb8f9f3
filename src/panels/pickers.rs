//! Which methods are on stage: the same for every lab.

use egui::{
    Align, Color32, ComboBox, Layout, Rect, ScrollArea, Sense, Shape, Stroke, Ui, UiBuilder, Vec2,
    style::{StyleModifier, WidgetVisuals},
    vec2,
};

use crate::{
    labs::{Edit, MethodCard, Scene},
    paint::theme,
    widgets::{Look, menu_style, section},
};

/// Beside and under a list of methods, as far as the edges of the window.
const AROUND: Vec2 = vec2(48.0, 96.0);
const BETWEEN_COLUMNS: f32 = 16.0;

/// The scene's method; the change that was asked for.
/// Where `asks` first, a faulty one is not called by its fault.
pub fn method_picker(ui: &mut Ui, look: Look<'_>, scene: &Scene, asks: bool) -> Option<Edit> {
    let now = *scene.document().methods().first()?;
    let shown = look.say(now.name_asked(asks));
    let whole = format!("{}: {shown}", look.say("panel-algorithm"));
    let combo = list(ui, "method", shown).truncate();
    let combo = combo.show_ui(ui, |ui| method_choices(ui, look, scene, usize::MAX));
    combo.response.on_hover_text(whole);
    combo.inner.flatten()
}

pub fn method_choices(ui: &mut Ui, look: Look<'_>, scene: &Scene, most: usize) -> Option<Edit> {
    let now = *scene.document().methods().first()?;
    let methods = (scene.document().lab().methods)().into_iter();
    let right = methods.filter(|card| !card.is_faulty).collect();
    let chosen = choices(ui, look, (right, most), |card| card.id == now.id);
    chosen.map(|card| Edit::Method(card.id))
}

/// Where `asks` first, the faulty one that stands beside is not told.
pub fn compare_picker(ui: &mut Ui, look: Look<'_>, scene: &Scene, asks: bool) -> Option<Edit> {
    let beside = scene.document().methods().into_iter().skip(1);
    let names: Vec<String> = beside.map(|card| look.say(card.name_asked(asks))).collect();
    let shown = if names.is_empty() {
        look.say("cost-compare")
    } else {
        names.join(" + ")
    };
    let choices = |ui: &mut Ui| compare_choices(ui, look, (scene, asks), usize::MAX);
    let combo = list(ui, "compare", shown).show_ui(ui, choices);
    combo.response.on_hover_text(look.say("cost-compare"));
    combo.inner.flatten()
}

/// In `most` columns at most.
pub fn compare_choices(
    ui: &mut Ui,
    look: Look<'_>,
    (scene, asks): (&Scene, bool),
    most: usize,
) -> Option<Edit> {
    let mut asked = None;
    let methods = scene.document().methods();
    let (main, beside) = methods.split_first()?;
    let none = look.say("cost-compare-none");
    if ui.selectable_label(beside.is_empty(), none).clicked() {
        asked = Some(Edit::Compare(None));
    }
    let others = (scene.document().lab().methods)().into_iter();
    let others = others.filter(|card| card.id != main.id).collect();
    let is_beside = |card: &MethodCard| beside.iter().any(|beside| beside.id == card.id);
    let chosen = choices(ui, look, (others, most), |card| {
        is_beside(card) && !(asks && card.is_faulty)
    });
    chosen.map(|card| Edit::Compare(Some(card.id))).or(asked)
}

enum Row {
    Heading(&'static str),
    Choice(&'static MethodCard),
}

/// The methods under their headings, in rows of one height and as many columns as show them all, or `most`, which scroll; which
/// one was pressed.
fn choices(
    ui: &mut Ui,
    look: Look<'_>,
    (methods, most): (Vec<&'static MethodCard>, usize),
    is_chosen: impl Fn(&MethodCard) -> bool,
) -> Option<&'static MethodCard> {
    let groups = grouped(methods);
    let rows = || groups.iter().flatten();
    let said = |row: &Row| match row {
        Row::Heading(key) => look.say(key),
        Row::Choice(card) => look.say(card.name_key),
    };
    let height = ui.spacing().interact_size.y;
    let widths = rows().map(|row| {
        let font = theme::strong().resolve(ui.style());
        let painter = ui.painter();
        painter
            .layout_no_wrap(said(row), font, Color32::PLACEHOLDER)
            .size()
            .x
    });
    let padding = 2.0 * ui.spacing().button_padding.x;
    let width = widths.fold(0.0, f32::max) + padding;
    let room = ui.ctx().content_rect().size() - AROUND;
    let most = most.min((room.x / (width + BETWEEN_COLUMNS)) as usize);
    let n_columns = (rows().count() as f32 * height / room.y).ceil() as usize;
    let n_columns = n_columns.clamp(1, most.max(1));
    let mut pressed = None;
    let show = |ui: &mut Ui| {
        ui.spacing_mut().item_spacing.x = BETWEEN_COLUMNS;
        for column in columns(groups, n_columns) {
            ui.vertical(|ui| {
                for row in column {
                    let size = vec2(width, height);
                    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
                    let layout = Layout::top_down_justified(Align::Min);
                    let inside = UiBuilder::new().max_rect(rect).layout(layout);
                    let mut ui = ui.new_child(inside);
                    match &row {
                        Row::Heading(_) => {
                            ui.add_space(0.25 * height);
                            ui.horizontal(|ui| {
                                ui.add_space(0.5 * padding);
                                section(ui, look, &said(&row));
                            });
                        }
                        Row::Choice(card) => {
                            if ui.selectable_label(is_chosen(card), said(&row)).clicked() {
                                pressed = Some(*card);
                            }
                        }
                    }
                }
            });
        }
    };
    let area = ScrollArea::vertical().max_height(room.y);
    area.show(ui, |ui| ui.horizontal_top(show));
    pressed
}

/// In the order in which they are taught; groups in that of their first methods, and the one of mistakes last.
fn grouped(methods: Vec<&'static MethodCard>) -> Vec<Vec<Row>> {
    let mut groups: Vec<(Option<&str>, Vec<Row>)> = Vec::new();
    for card in methods {
        let key = card.group_key;
        if !groups.iter().any(|(known, _)| *known == key) {
            groups.push((key, key.map(Row::Heading).into_iter().collect()));
        }
        if let Some((_, rows)) = groups.iter_mut().find(|(known, _)| *known == key) {
            rows.push(Row::Choice(card));
        }
    }
    groups.sort_by_key(|(key, _)| *key == Some("faulty-title"));
    groups.into_iter().map(|(_, rows)| rows).collect()
}

/// Groups in so many columns, or fewer, of about one height.
fn columns(groups: Vec<Vec<Row>>, n_columns: usize) -> Vec<Vec<Row>> {
    let n_rows: usize = groups.iter().map(Vec::len).sum();
    let most = n_rows.div_ceil(n_columns);
    let mut columns: Vec<Vec<Row>> = Vec::new();
    for group in groups {
        let is_last = columns.len() == n_columns;
        match columns.last_mut() {
            Some(column) if is_last || column.len() + group.len() <= most => column.extend(group),
            _ => columns.push(group),
        }
    }
    columns
}

/// A button that opens a list of choices.
pub fn list<'a>(ui: &Ui, id: &'a str, shown: String) -> ComboBox<'a> {
    ComboBox::from_id_salt(id)
        .height(ui.ctx().content_rect().height() - AROUND.y)
        .icon(chevron)
        .popup_style(StyleModifier::new(menu_style))
        .selected_text(shown)
}

fn chevron(ui: &Ui, rect: Rect, _visuals: &WidgetVisuals, _is_open: bool) {
    let centre = rect.center().round();
    let line = [vec2(-3.5, -1.75), vec2(0.0, 1.75), vec2(3.5, -1.75)];
    let points = line.map(|offset| centre + offset).to_vec();
    let stroke = Stroke::new(1.5, ui.visuals().weak_text_color());
    ui.painter().add(Shape::line(points, stroke));
}
