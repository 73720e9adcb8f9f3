//! Why what was clicked was kept or dropped, as the method tells it in whose column it was clicked.

use egui::{Align2, Area, Frame, Order, Vec2};

use crate::{
    figure::said,
    labs::{Click, Verdict},
    text::{Notation, Said},
    widgets::{explained, quiet_button, rule, section},
};

use super::{App, Command, command::AskedIn, playback::Playback, prelude::*, run_room::RunRoom};

#[derive(Default)]
pub struct Verdicts {
    about: Option<(AskedIn, usize)>,
    room: RunRoom<Option<Verdict>>,
    /// What was told last, and in how many frames it is still to be brought into sight: what stands below is laid out one later.
    in_sight: (Option<AskedIn>, usize),
}

impl Verdicts {
    fn of(&mut self, app: &App, ui: &Ui, about: AskedIn) -> Option<&Verdict> {
        let on_stage = app.on_stage();
        let now = (about, on_stage.0.transport.position());
        if self.about.replace(now) != Some(now) {
            self.room = RunRoom::default();
        }
        let verdict = || verdict(on_stage.0, app.scene(), about);
        self.room.get(on_stage, ui, 0.0, verdict).as_ref()
    }
}

/// The step that a verdict names is one of the first column's run: the others have none.
pub fn verdict(playback: &Playback, scene: &Scene, (about, column): AskedIn) -> Option<Verdict> {
    let run = playback.runs().nth(column)?;
    let [step, _] = *playback.steps().get(column)?;
    let document = scene.document();
    if column == 0 {
        return document.verdict(about, (run, step));
    }
    let alone = alone(scene, column)?;
    let verdict = alone.document().verdict(about, (run, step))?;
    Some(Verdict {
        step: None,
        ..verdict
    })
}

/// What a click in a column is about: as the method answers that stands there.
pub fn asked(scene: &Scene, column: usize, click: &Click<'_>) -> Option<Link> {
    if column == 0 {
        return scene.document().asked(click);
    }
    alone(scene, column)?.document().asked(click)
}

/// The scene with the method of one column.
fn alone(scene: &Scene, column: usize) -> Option<Scene> {
    let method = scene.document().methods().get(column)?.id;
    let mut alone = scene.clone();
    alone.document_mut().set_compare(None);
    alone.document_mut().set_method(method);
    Some(alone)
}

/// Its numbers stand beside each other.
fn notation(verdict: &Verdict) -> Notation {
    let notes = verdict.notes.iter().map(Said::Message);
    Notation::of(said(&[], &verdict.why).into_iter().chain(notes))
}

/// Below all else of the inspector, scrolled into sight when it comes. Is anything told?
pub fn show(app: &App, ui: &mut Ui, about: Option<AskedIn>, verdicts: &mut Verdicts) -> bool {
    let about = about.filter(|_| may_tell(app));
    if verdicts.in_sight.0 != about {
        verdicts.in_sight = (about, 2);
    }
    let Some(about) = about else { return false };
    let scrolls = verdicts.in_sight.1;
    verdicts.in_sight.1 = scrolls.saturating_sub(1);
    let Some(verdict) = verdicts.of(app, ui, about) else {
        return false;
    };
    let top = ui.cursor().min;
    rule(ui, app.look());
    section(ui, app.look(), &title(app, about));
    told(app, ui, verdict);
    if scrolls > 0 {
        ui.scroll_to_rect(Rect::from_min_max(top, ui.cursor().max), None);
        ui.ctx().request_repaint();
    }
    true
}

/// In the lower right corner of the stage, where no inspector stands beside it.
pub fn on_stage(
    app: &App,
    ui: &Ui,
    (stage, about): (Rect, Option<AskedIn>),
    verdicts: &mut Verdicts,
) {
    const WIDTH: f32 = 320.0;
    const APART: f32 = 12.0;
    let Some(about) = about.filter(|_| may_tell(app)) else {
        return;
    };
    let Some(verdict) = verdicts.of(app, ui, about) else {
        return;
    };
    let look = app.look();
    let width = (WIDTH * look.theme.text_scale).min(stage.width() - 4.0 * APART);
    let area = Area::new(Id::unique("verdict on the stage"))
        .order(Order::Middle)
        .pivot(Align2::RIGHT_BOTTOM)
        .fixed_pos(stage.max - Vec2::splat(APART))
        .constrain_to(stage);
    area.show(ui.ctx(), |ui| {
        Frame::popup(ui.style())
            .fill(look.theme.background)
            .show(ui, |ui| {
                ui.set_max_width(width);
                ui.horizontal(|ui| {
                    ui.label(RichText::new(title(app, about)).strong());
                    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                        let close = look.say("action-close");
                        if icon_button(ui, look, Icon::Close, &close, true).clicked() {
                            app.push(Command::Ask(None));
                        }
                    });
                });
                told(app, ui, verdict);
            });
    });
}

/// Of what is asked about it would tell too much.
pub fn may_tell(app: &App) -> bool {
    !app.practice.is_asking()
}

/// With the name of the method that it is about, where there are several.
fn title(app: &App, (_, column): AskedIn) -> String {
    let title = app.look().say("verdict-title");
    let methods = app.scene().document().methods();
    match methods.get(column).filter(|_| methods.len() > 1) {
        Some(method) => format!("{title} {}", app.name_of(method)),
        None => title,
    }
}

fn told(app: &App, ui: &mut Ui, verdict: &Verdict) {
    let look = app.look_at_step();
    let alike = app.playback.notation().max(notation(verdict));
    let look = Look {
        catalog: look.catalog.alike(alike),
        ..look
    };
    explained(ui, look, &verdict.why);
    for note in &verdict.notes {
        ui.label(look.catalog.message(note));
    }
    if verdict.step.is_some() {
        let go = Button::new(accent(look, "verdict-go"));
        if quiet_button(ui, look, go).clicked() {
            app.push(Command::Verdict);
        }
    }
    if let Some((key, change)) = &verdict.offer
        && ui.button(look.say(key)).clicked()
    {
        app.push(Command::Edit(Edit::Own(change.clone()), None));
    }
}
