//! What lies over the window: the list of keys, where to save, measured costs.

mod dialogs;
mod help;
mod modal;

use modal::{heading, modal};

use super::{App, Command, Dialog, prelude::*, progress_page};

pub fn show(app: &App, ui: &Ui, panels: &mut [Box<dyn LabPanel>]) {
    let ctx = ui.ctx();
    if app.shown.is_measuring {
        measure(app, ctx, panels);
    }
    match app.shown.dialog.as_ref() {
        Some(Dialog::Help) => help::show(app, ctx),
        Some(Dialog::Scene(act, name)) => dialogs::scene(app, ctx, *act, name),
        Some(Dialog::Progress(is_sure)) => progress(app, ctx, *is_sure),
        Some(dialog) => dialogs::path(app, ctx, dialog),
        None => {}
    }
}

fn progress(app: &App, ctx: &Context, is_sure: bool) {
    let response = modal("progress", app.look()).show(ctx, |ui| {
        heading(app, ui, "progress-title");
        progress_page::show(app, ui, is_sure);
    });
    if response.should_close() {
        app.push(Command::Show(None));
    }
}

fn measure(app: &App, ctx: &Context, panels: &mut [Box<dyn LabPanel>]) {
    let (look, scene) = (app.look(), app.scene());
    let Some(bench) = panel_of(panels, scene).and_then(|panel| panel.bench()) else {
        return;
    };
    let response = modal("measure", look).show(ctx, |ui| {
        let height = (ctx.content_rect().height() - 96.0).max(60.0);
        ScrollArea::vertical()
            .max_height(height)
            .min_scrolled_height(height)
            .show(ui, |ui| bench.show(ui, look, scene))
            .inner
    });
    if !response.inner || response.should_close() {
        app.push(Command::Measure(false));
    }
}
