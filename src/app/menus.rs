//! The menus: in a row at the right of the bar, or in a narrow window behind one button.

use egui::Popup;

use crate::{
    panels::{PanelAsk, compare_choices, method_choices},
    widgets::{language_menu, menu_style, speed_menu, text_menu, theme_menu},
};

use super::{
    App, Command, Dialog,
    compose::Act,
    free_scenes,
    history::UndoGroup,
    prelude::*,
    room::{BESIDE_TRANSPORT, transport_has_room},
};

/// What the bar has room for, or not.
pub fn names(app: &App) -> [String; 4] {
    let [present, theme, scene] =
        ["action-present", "settings-theme", "panel-scene"].map(|key| app.look().say(key));
    [
        present,
        theme,
        app.settings.lang.native_name().to_owned(),
        scene,
    ]
}

/// The menus of the bar, from left to right.
pub fn in_a_row(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let look = app.look();
    menu_button(ui, look.say("panel-scene"), |ui| {
        scene(app, ui, panels);
    });
    language_and_theme(app, ui);
    if ui.button(look.say("action-present")).clicked() {
        app.push(Command::Present);
    }
}

pub fn behind_one_button(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let look = app.look();
    let button = icon_button(ui, look, Icon::More, &look.say("menu-more"), true);
    Popup::menu(&button).style(menu_style).show(|ui| {
        // In a wide window they are tabs.
        if app.is_narrow() {
            labs(app, ui, panels);
            ui.separator();
        }
        menu_button(ui, look.say("panel-scene"), |ui| {
            scene(app, ui, panels);
        });
        language_and_theme(app, ui);
        if ui
            .selectable_label(app.practice.is_on, look.say("practice"))
            .clicked()
        {
            app.push(Command::Practise);
        }
        if !transport_has_room(ui.ctx().content_rect().width() - 2.0 * f32::from(BESIDE_TRANSPORT))
        {
            let speed = app.playback.transport.speed();
            app.push_all(speed_menu(ui, look, speed).map(Command::Speed));
        }
        if ui.button(look.say("action-present")).clicked() {
            app.push(Command::Present);
        }
    });
}

fn labs(app: &App, ui: &mut Ui, panels: &[Box<dyn LabPanel>]) {
    for lab in panels.iter().map(|panel| panel.lab()) {
        let is_open = app.scene().document().lab() == lab;
        if ui.radio(is_open, app.look().say(lab.name_key)).clicked() && !is_open {
            app.push(Command::Lab(lab.id));
            ui.close();
        }
    }
}

fn language_and_theme(app: &App, ui: &mut Ui) {
    let look = app.look();
    menu_button(ui, app.settings.lang.native_name(), |ui| {
        app.push_all(language_menu(ui, app.settings.lang).map(Command::Language));
    });
    menu_button(ui, look.say("settings-theme"), |ui| {
        app.push_all(theme_menu(ui, look).map(Command::Theme));
        ui.separator();
        menu_button(ui, look.say("settings-text"), |ui| {
            app.push_all(text_menu(ui, app.settings.text).map(Command::TextSize));
        });
    });
}

fn scene(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let look = app.look();
    if !has_compare_in_the_bar(ui.ctx()) {
        menu_button(ui, look.say("cost-compare"), |ui| {
            // Beside the menu there is room for one column.
            let edit = compare_choices(ui, look, (app.scene(), app.hides_mistakes()), 1);
            app.push_all(edit.map(|edit| Command::Edit(edit, None)));
        });
    }
    let panel = panel_of(panels, app.scene());
    if let Some(panel) = panel {
        panel_rows(app, ui, panel);
    }
    let here = app.scene().document().lab();
    let labs = panels.iter().map(|panel| panel.lab());
    for lab in labs.filter(|&lab| lab != here) {
        let says = Message::new("scene-adopt").with("lab", Value::Term(lab.name_key));
        if (lab.adopt)(app.scene()).is_some() && ui.button(look.catalog.message(&says)).clicked() {
            app.push(Command::Adopt(lab.id));
            ui.close();
        }
    }
    let mut snap = app.settings.snap;
    if ui.checkbox(&mut snap, look.say("settings-snap")).changed() {
        app.push(Command::Snap(snap));
    }
    let mut asks = app.settings.asks;
    if ui.checkbox(&mut asks, look.say("settings-asks")).changed() {
        app.push(Command::AskInLessons(asks));
    }
    let mut at_end = app.settings.marks_at_end;
    let name = look.say("settings-marks-at-end");
    if ui.checkbox(&mut at_end, name).changed() {
        app.push(Command::MarkAtEnd(at_end));
    }
    ui.separator();
    changes(app, ui);
    menu_button(ui, look.say("free-scenes"), |ui| free_scenes::menu(app, ui));
    ui.separator();
    files(app, ui);
    let measure = Command::Measure(true);
    action(ui, look, ("cost-measure", "Ctrl+M"), app.shown.measures).then(|| app.push(measure));
    if cfg!(not(target_arch = "wasm32")) {
        action(ui, look, ("action-notes", "N"), true).then(|| app.push(Command::Notes));
    }
    let progress = Command::Show(Some(Dialog::Progress(false)));
    action(ui, look, ("progress-title", ""), true).then(|| app.push(progress));
    action(ui, look, ("action-help", "?"), true).then(|| app.push(Command::Help));
}

/// For who presents, who has no bar.
pub fn method(app: &App, ui: &mut Ui) {
    let look = app.look();
    menu_button(ui, look.say("panel-algorithm"), |ui| {
        let edit = method_choices(ui, look, app.scene(), 1);
        app.push_all(edit.map(|edit| Command::Edit(edit, None)));
    });
}

/// What a lab has: sections of what can be set lead to the inspector.
pub fn panel_rows(app: &App, ui: &mut Ui, panel: &mut Box<dyn LabPanel>) {
    let (look, scene) = (app.look(), app.scene());
    for (id, title) in panel.sections(scene) {
        let title = look.catalog.message(&title);
        if ui.button(format!("{title}…")).clicked() {
            app.push(Command::Control(id));
            ui.close();
        }
    }
    app.push_all(panel.menu(ui, look, scene).map(asked_of));
}

fn action(ui: &mut Ui, look: Look<'_>, (key, keys): (&str, &str), enabled: bool) -> bool {
    let keys = RichText::new(keys).color(look.theme.soft);
    let button = Button::new(look.say(key)).right_text(keys);
    ui.add_enabled(enabled, button).clicked()
}

fn changes(app: &App, ui: &mut Ui) {
    let free = if app.bookmark.free.is_some() {
        "action-course"
    } else {
        "action-free"
    };
    let [can_undo, can_redo] = app.can_travel();
    let differs = app.playback.difference.is_some_and(|it| it.step.is_some());
    let mut rows = vec![
        ("action-undo", "Ctrl+Z", can_undo, Command::Undo),
        ("action-redo", "Ctrl+Shift+Z", can_redo, Command::Redo),
        ("action-reset", "R", true, Command::Reset),
        ("action-smaller", "M", differs, Command::Smaller),
        (free, "F8", true, Command::Free),
        ("action-reset-view", "0", true, Command::FitView),
    ];
    if app.has_small_picture() {
        rows.push(("action-picture", "V", true, Command::Picture));
    }
    for (key, keys, enabled, command) in rows {
        action(ui, app.look(), (key, keys), enabled).then(|| app.push(command));
    }
}

/// Files that are opened and written; where the system asks for them, their paths can be typed all the same.
fn files(app: &App, ui: &mut Ui) {
    type Ask = fn(&App) -> Command;
    type May = fn(&App) -> bool;
    const ALWAYS: May = |_| true;
    // Else a key asks for the path anyway.
    const TYPES: May = |app| app.has_dialog(false);
    const SVG: May = |app| app.platform.formats().contains(&"svg");
    let rows: [(&str, &str, May, Ask); 8] = [
        ("action-open", "Ctrl+O", ALWAYS, |_| Command::OpenFile),
        ("action-open-path", "", TYPES, |app| {
            Command::Show(Some(app.opened()))
        }),
        ("action-save", "Ctrl+S", ALWAYS, |_| Command::Save),
        ("action-save-path", "", TYPES, |app| {
            Command::Show(Some(app.saved()))
        }),
        ("action-export", "Ctrl+E", ALWAYS, |_| Command::Export),
        ("action-copy", "Ctrl+Shift+C", ALWAYS, |_| {
            Command::CopyFigure
        }),
        ("action-copy-svg", "", SVG, |_| Command::CopySvg),
        ("action-link", "Ctrl+Shift+L", ALWAYS, |_| Command::CopyLink),
    ];
    lessons(app, ui);
    if !app.settings.recent.is_empty() {
        menu_button(ui, app.look().say("action-recent"), |ui| recent(app, ui));
    }
    for (key, keys, may, command) in rows {
        if may(app) && action(ui, app.look(), (key, keys), true) {
            app.push(command(app));
        }
    }
}

/// The open scene or lesson as a lesson of one's own, and one's own in the making.
fn lessons(app: &App, ui: &mut Ui) {
    if cfg!(target_arch = "wasm32") {
        return;
    }
    let save = match app.bookmark.step() {
        Some(_) => "lesson-copy",
        None => "lesson-save",
    };
    let made = match app.compose {
        Some(_) => ("compose-leave", true, Act::Compose),
        None => ("compose-begin", app.can_compose(), Act::Compose),
    };
    for (key, enabled, act) in [(save, true, Act::Save), made] {
        action(ui, app.look(), (key, ""), enabled).then(|| app.push(Command::Compose(act)));
    }
}

/// Files by their names, each with its folder beside it.
fn recent(app: &App, ui: &mut Ui) {
    for path in &app.settings.recent {
        let (folder, name) = path.rsplit_once(['/', '\\']).unwrap_or(("", path));
        let folder = RichText::new(folder).color(app.look().theme.soft);
        let row = Button::new(name).right_text(folder);
        if ui.add(row).clicked() {
            app.push(Command::OpenRecent(path.clone()));
        }
    }
}

pub fn asked_of(asked: PanelAsk) -> Command {
    match asked {
        PanelAsk::Edit(edit) => Command::Edit(edit, None),
        PanelAsk::Tune(edit, number) => Command::Edit(edit, Some(UndoGroup::Number(number))),
        PanelAsk::Draw(outline) => Command::Draw(outline),
    }
}

/// Remembers whether the bar has room to compare methods: what has none is in a menu.
pub fn compare_is_in_the_bar(ctx: &Context, is_there: bool) {
    ctx.data_mut(|data| data.insert_temp(Id::unique(COMPARE), is_there));
}

fn has_compare_in_the_bar(ctx: &Context) -> bool {
    ctx.data(|data| data.get_temp(Id::unique(COMPARE)).unwrap_or(true))
}

const COMPARE: &str = "compare is in the bar";
