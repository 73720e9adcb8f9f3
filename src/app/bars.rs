//! The bar at the top and the transport at the bottom.

use egui::{Color32, Popup, TextStyle};

use crate::{
    panels::{compare_picker, method_picker},
    widgets::{
        Press, Timeline, explained, menu_style, quiet_button, speed_menu, transport_buttons,
    },
};

use super::{
    App, Command, compose, menus,
    prelude::*,
    question::question_button,
    room::{COURSE, CoursePart, Room, transport_has_room},
};

const BETWEEN_TABS: f32 = 12.0;
/// The program's name and a method's, before any scale.
const BESIDE_TABS: f32 = 270.0;
/// Of the buttons for course and inspector.
const SIDES_WIDTH: f32 = 80.0;

/// Everything stands in the order in which Tab walks it. How wide the menus at the right are is known from the last time.
pub fn top(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let bar = ui.max_rect();
    ui.spacing_mut().item_spacing.x = 4.0;
    let id = Id::unique("width of the menus");
    let width: f32 = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let menus = bar.with_min_x(bar.right() - width);
    let left = bar.with_max_x(menus.left() - 8.0);
    row(ui, left, |ui| {
        ui.shrink_clip_rect(left);
        if !app.is_narrow() {
            title(app, ui, bar, panels);
            for panel in &*panels {
                tab(app, ui, panel.lab(), bar);
                ui.add_space(BETWEEN_TABS);
            }
            ui.add_space(4.0);
        }
        pickers(app, ui);
    });
    let now = row(ui, menus, |ui| {
        if app.is_narrow() {
            menus::behind_one_button(app, ui, panels);
            question_button(app, ui);
            sides(app, ui);
        } else {
            let is_all = app.course_part() == CoursePart::Whole && app.settings.inspector;
            if !is_all || app.has_strip() {
                sides(app, ui);
            }
            if has_room_for_menus(app, ui, (panels, bar.width())) {
                menus::in_a_row(app, ui, panels);
            } else {
                menus::behind_one_button(app, ui, panels);
            }
        }
    });
    if now != width {
        ui.data_mut(|data| data.insert_temp(id, now));
        ui.ctx().request_discard("the menus have another width");
    }
}

/// From left to right within a part of the bar; how wide it is.
fn row(ui: &mut Ui, part: Rect, content: impl FnOnce(&mut Ui)) -> f32 {
    let layout = Layout::left_to_right(Align::Center);
    let part = UiBuilder::new().max_rect(part).layout(layout);
    ui.scope_builder(part, content).response.rect.width()
}

/// The program's name, and the gap up to the tabs; where it would leave no room for the method's name, it is left out.
fn title(app: &App, ui: &mut Ui, bar: Rect, panels: &[Box<dyn LabPanel>]) {
    let (look, scale) = (app.look(), app.look().theme.text_scale);
    let has_room = tabs_width(ui, look, panels) + BESIDE_TABS * scale < ui.available_width();
    if has_room {
        let title = RichText::new(look.say("app-title")).heading();
        ui.label(title.size(15.0 * scale));
    }
    let tabs = bar.left() + COURSE + 8.0 - ui.cursor().left();
    ui.add_space(match app.course_part() {
        CoursePart::Whole => tabs.max(16.0),
        CoursePart::Hidden | CoursePart::Strip if has_room => 24.0,
        CoursePart::Hidden | CoursePart::Strip => 0.0,
    });
}

fn tabs_width(ui: &Ui, look: Look<'_>, panels: &[Box<dyn LabPanel>]) -> f32 {
    let names = panels.iter().map(|panel| look.say(panel.lab().name_key));
    widths(ui, &theme::strong(), names, BETWEEN_TABS)
}

/// Of names in a row, each with the white space `around` it.
fn widths(ui: &Ui, style: &TextStyle, names: impl Iterator<Item = String>, around: f32) -> f32 {
    let font = style.resolve(ui.style());
    let width = |name| {
        let galley = (ui.painter()).layout_no_wrap(name, font.clone(), Color32::PLACEHOLDER);
        galley.size().x + around
    };
    names.map(width).sum()
}

/// Is the method's name still read beside the tabs, where all menus stand in a row?
fn has_room_for_menus(app: &App, ui: &Ui, (panels, room): (&[Box<dyn LabPanel>], f32)) -> bool {
    let around = 2.0 * ui.spacing().button_padding.x + ui.spacing().item_spacing.x;
    let menus = widths(
        ui,
        &TextStyle::Button,
        menus::names(app).into_iter(),
        around,
    );
    let before_tabs = match app.course_part() {
        CoursePart::Whole => COURSE,
        CoursePart::Hidden | CoursePart::Strip => 0.0,
    };
    let tabs = before_tabs + tabs_width(ui, app.look(), panels);
    let method = app.scene().document().methods().into_iter().take(1);
    let method = method.map(|card| app.look().say(card.name_asked(app.hides_mistakes())));
    let chevron = ui.spacing().icon_width + ui.spacing().icon_spacing;
    let method = widths(ui, &TextStyle::Button, method, around + chevron);
    tabs + method + SIDES_WIDTH + menus < room
}

fn tab(app: &App, ui: &mut Ui, lab: &'static Lab, bar: Rect) {
    let (look, is_open) = (app.look(), app.scene().document().lab() == lab);
    let colour = if is_open {
        look.theme.accent
    } else {
        look.theme.soft
    };
    let text = RichText::new(look.say(lab.name_key))
        .text_style(theme::strong())
        .color(colour);
    let label = quiet_button(ui, look, Button::selectable(false, text));
    let label = label.on_hover_text(look.say(lab.about_key));
    if is_open {
        let line = Rect::from_x_y_ranges(label.rect.x_range(), bar.bottom() - 2.0..=bar.bottom());
        ui.painter().rect_filled(line, 0.0, look.theme.accent);
    } else if label.clicked() {
        app.push(Command::Lab(lab.id));
    }
}

pub fn pickers(app: &App, ui: &mut Ui) {
    let edit = method_picker(ui, app.look(), app.scene(), app.hides_mistakes());
    app.push_all(edit.map(|edit| Command::Edit(edit, None)));
    let has_room = ui.available_width() > 150.0 * app.look().theme.text_scale;
    menus::compare_is_in_the_bar(ui.ctx(), has_room);
    if has_room {
        let edit = compare_picker(ui, app.look(), app.scene(), app.hides_mistakes());
        app.push_all(edit.map(|edit| Command::Edit(edit, None)));
    }
}

fn sides(app: &App, ui: &mut Ui) {
    for (icon, key, command) in &SIDES {
        let is_open = match command {
            Command::Course => {
                app.room() == Room::Course
                    || (!app.is_narrow() && app.course_part() == CoursePart::Whole)
            }
            _ => app.room() == Room::Inspector || (!app.is_narrow() && app.settings.inspector),
        };
        let button = icon_button(ui, app.look(), *icon, &app.look().say(key), true);
        if is_open {
            let under =
                Rect::from_min_size(button.rect.left_bottom() - vec2(0.0, 3.0), vec2(32.0, 2.0));
            ui.painter()
                .rect_filled(under.shrink2(vec2(8.0, 0.0)), 0.0, app.look().theme.accent);
        }
        if button.clicked() {
            app.push(command.clone());
        }
    }
}

pub fn transport(app: &App, ui: &mut Ui) {
    let width = ui.available_width();
    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
        buttons(app, ui);
        let has_room = transport_has_room(width);
        ui.add_space(if has_room { 24.0 } else { 0.0 });
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if app.composed().is_some() {
                compose::add_here(app, ui);
                ui.add_space(8.0);
            } else if has_room {
                practise(app, ui);
                let speed = app.playback.transport.speed();
                let chosen = speed_menu(ui, app.look(), speed);
                app.push_all(chosen.map(Command::Speed));
                ui.add_space(8.0);
            }
            number_and_timeline(app, ui);
        });
    });
}

fn practise(app: &App, ui: &mut Ui) {
    let look = app.look();
    let name = look.say("action-practise");
    let button = ui.selectable_label(app.practice.is_on, look.say("practice"));
    if button.on_hover_text(name).clicked() {
        app.push(Command::Practise);
    }
}

pub fn small_transport(app: &App, ui: &mut Ui) {
    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
        buttons(app, ui);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let timeline = TIMELINE * app.look().theme.text_scale;
            if ui.available_width() > hall_width(app, ui) + timeline {
                hall(app, ui);
            } else {
                let name = app.look().say("menu-more");
                let button = icon_button(ui, app.look(), Icon::More, &name, true);
                Popup::menu(&button)
                    .style(menu_style)
                    .show(|ui| hall(app, ui));
            }
            number_and_timeline(app, ui);
        });
    });
}

fn hall_width(app: &App, ui: &Ui) -> f32 {
    let names = HALL.map(|key| app.look().say(key)).into_iter();
    let around = 2.0 * ui.spacing().button_padding.x + ui.spacing().item_spacing.x;
    widths(ui, &TextStyle::Button, names, around)
}

fn hall(app: &App, ui: &mut Ui) {
    let look = app.look();
    if app.shown.is_embedded {
        if ui.link(look.say("action-open-whole")).clicked() {
            app.push(Command::OpenWhole);
        }
        return;
    }
    menus::method(app, ui);
    practise(app, ui);
    if ui.button(look.say("action-present-leave")).clicked() {
        app.push(Command::Present);
    }
    let is_on = look.theme.kind == ThemeKind::Projector;
    let projector = RichText::new(look.say("theme-projector"));
    if ui.selectable_label(is_on, projector).clicked() {
        app.push(Command::Projector);
    }
    if cfg!(not(target_arch = "wasm32")) {
        let notes = look.say("action-notes");
        if ui.selectable_label(app.shown.has_notes, notes).clicked() {
            app.push(Command::Notes);
        }
    }
}

fn buttons(app: &App, ui: &mut Ui) {
    let pressed = ui
        .scope(|ui| transport_buttons(ui, app.look(), &app.playback.transport))
        .inner;
    app.push_all(pressed.map(|press| match press {
        Press::First => Command::FIRST,
        Press::Back => Command::Step(-1),
        Press::Play => Command::Play,
        Press::Forward => Command::Step(1),
        Press::Last => Command::LAST,
    }));
}

fn number_and_timeline(app: &App, ui: &mut Ui) {
    let transport = &app.playback.transport;
    let steps = [transport.position(), transport.n_steps()];
    let words = step_told(app, steps);
    let has_words = ui.available_width() > 260.0 * app.look().theme.text_scale;
    let [step, n_steps] = steps;
    let text = if has_words || app.hides_total() {
        words.clone()
    } else {
        format!("{step} / {n_steps}")
    };
    ui.add(Label::new(text).extend()).on_hover_text(words);
    if ui.available_width() > LEAST_TIMELINE {
        ui.add_space(if has_words { 8.0 } else { 0.0 });
        timeline(app, ui);
    }
}

impl App {
    /// Is it not to be told how long the run is, and what all of it costs?
    pub(super) fn hides_length(&self) -> bool {
        let transport = &self.playback.transport;
        let is_over = transport.position() == transport.n_steps();
        (self.practice.is_on && !is_over) || self.practice.is_asking()
    }

    /// Is no number of all steps to be told? Of two programs in a hunt it would tell whether they differ.
    fn hides_total(&self) -> bool {
        self.hides_length() || self.is_hunting()
    }

    /// How long the timeline is: however long the run is, a little longer than what is told, where that is not to be told.
    pub(super) fn n_steps_told(&self) -> usize {
        const AHEAD: usize = 8;
        const ROUND: usize = 24;
        let transport = &self.playback.transport;
        if self.hides_length() {
            (transport.position() + AHEAD).next_multiple_of(ROUND)
        } else {
            transport.n_steps()
        }
    }
}

/// `step 4 of 6`, or `step 4` where the total is not to be told.
pub fn step_told(app: &App, steps: [usize; 2]) -> String {
    if app.hides_total() {
        let message = Message::new("practice-step").with("step", Value::Count(steps[0]));
        return app.look().catalog.message(&message);
    }
    step_text(app.look(), steps)
}

/// `step 4 of 6`.
pub fn step_text(look: Look<'_>, [step, n_steps]: [usize; 2]) -> String {
    let message = Message::new("transport-step")
        .with("step", Value::Count(step))
        .with("total", Value::Count(n_steps));
    look.catalog.message(&message)
}

pub fn timeline(app: &App, ui: &mut Ui) {
    let transport = &app.playback.transport;
    let look = app.look();
    let run = app.playback.main();
    let difference = app.difference_told();
    let note = difference.map(|difference| look.catalog.message(&difference.message()));
    let first = difference.and_then(|difference| difference.step);
    // Where the pseudocode is hidden so that a class can be asked, the steps to come do not answer.
    let told = match app.shown.code {
        _ if app.practice.is_on || app.practice.is_asking() => transport.position(),
        CodeView::Full | CodeView::Words => transport.n_steps(),
        CodeView::Hidden => app.playback.reached,
    };
    let note = note.filter(|_| first.is_none_or(|first| first <= told));
    let tip = |ui: &mut Ui, step: usize| {
        if step > told {
            ui.label(step_told(app, [step, transport.n_steps()]));
            return;
        }
        if let Some(note) = note.as_ref().filter(|_| first == Some(step)) {
            ui.label(format!("≠ {note}"));
        }
        explained(ui, look, &run.caption(step));
    };
    let name = look.say("panel-timeline");
    let asked = Timeline {
        n_steps: app.n_steps_told(),
        position: transport.position(),
        told,
        tick: &|step| run.tick(step),
        phases: &app.playback.phases,
        difference: first,
        steps: &app.steps_on_timeline(),
        asked: app.practice.step_asked(),
        tip: &tip,
        name: match &note {
            Some(note) => format!("{name}: {note}"),
            None => name,
        },
        look,
    }
    .show(ui);
    app.push_all(asked.map(Command::Seek));
}

const LEAST_TIMELINE: f32 = 48.0;
/// In a presentation the step's number and the timeline have so much before what else there is stands in a row, before any scale.
const TIMELINE: f32 = 340.0;
/// What else there is.
const HALL: [&str; 5] = [
    "panel-algorithm",
    "practice",
    "action-present-leave",
    "theme-projector",
    "action-notes",
];

const SIDES: [(Icon, &str, Command); 2] = [
    (Icon::LeftPanel, "panel-course", Command::Course),
    (Icon::RightPanel, "panel-inspector", Command::Inspector),
];
