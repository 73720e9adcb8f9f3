//! What can be set of the scene, in sections of the inspector, of which one at most is open; and how a lesson's text leads
//! there.

use egui::{Role, WidgetInfo};

use crate::{
    panels::Form,
    widgets::{quiet_button, rule, section},
};

use super::{App, Command, menus::asked_of, prelude::*, room::Room};

/// A control that a text leads to is lit so long.
const LIT_SECS: f64 = 2.0;

#[derive(Default)]
pub struct Controls {
    /// The id of a section.
    open: Option<&'static str>,
    /// A control that a text led to, and when.
    led_to: Option<(&'static str, f64)>,
    /// Was it a text that is presented, without an inspector beside it?
    is_presented: bool,
}

impl Controls {
    /// Are they beside a stage that is presented?
    pub const fn are_presented(&self) -> bool {
        self.is_presented && self.open.is_some()
    }

    pub const fn leave_presentation(&mut self) {
        self.is_presented = false;
    }
}

pub fn show(app: &App, ui: &mut Ui, panels: &mut [Box<dyn LabPanel>]) {
    let (look, scene) = (app.look(), app.scene());
    let Some(panel) = panel_of(panels, scene) else {
        return;
    };
    let sections = panel.sections(scene);
    if sections.is_empty() {
        return;
    }
    let controls = &app.shown.controls;
    let open = sections.iter().find(|(id, _)| Some(*id) == controls.open);
    rule(ui, look);
    ui.horizontal_wrapped(|ui| {
        section(ui, look, &look.say("panel-controls"));
        for &(id, ref title) in &sections {
            let is_open = controls.open == Some(id);
            let (theme, name) = (look.theme, look.catalog.message(title));
            let colour = if is_open { theme.accent } else { theme.soft };
            let text = RichText::new(format!("{name} {}", if is_open { "−" } else { "+" }));
            let button = quiet_button(ui, look, Button::new(text.color(colour)));
            button.widget_info(|| WidgetInfo::selected(Role::Button, true, is_open, &name));
            if button.clicked() {
                app.push(Command::Section((!is_open).then_some(id)));
            }
        }
    });
    let Some((id, _)) = open else {
        return;
    };
    let now = ui.input(|input| input.time);
    let lit = controls.led_to.filter(|(_, since)| now < since + LIT_SECS);
    let handles = scene.document().handles();
    let form = Form {
        look,
        locks: app.locks(&handles),
        lit: lit.map(|(id, _)| id),
        takes_focus: lit.is_some_and(|(_, since)| is_new(ui, since)),
    };
    if let Some((_, since)) = lit {
        ui.ctx()
            .request_repaint_after_secs((since + LIT_SECS - now) as f32);
    }
    let asked = ui.scope(|ui| panel.section(ui, &form, id, scene)).inner;
    app.push_all(asked.map(asked_of));
}

/// Is it the first frame that shows what was led to at this time?
fn is_new(ui: &Ui, since: f64) -> bool {
    let id = Id::unique("a control was led to");
    let last: Option<f64> = ui.data(|data| data.get_temp(id));
    ui.data_mut(|data| data.insert_temp(id, since));
    last != Some(since)
}

impl App {
    pub(super) fn open_section(&mut self, id: Option<&'static str>) {
        self.shown.controls.open = id;
    }

    /// Opens the section that a control is in and lights it.
    pub(super) fn lead_to(&mut self, id: &'static str, now: f64) {
        let (section, _) = id.split_once('.').unwrap_or((id, ""));
        self.shown.controls = Controls {
            open: Some(section),
            led_to: Some((id, now)),
            is_presented: self.is_presenting(),
        };
        if self.is_presenting() {
            return;
        }
        if self.is_narrow() {
            self.shown.room = Room::Inspector;
        } else {
            self.settings.inspector = true;
        }
    }
}
