//! The window: what it holds, what can be done to it, and how that is drawn.
//!
//! ```text
//! input ─► keys ─┐
//!                ├─► Command ─► App::apply ─► history, playback, bookmark, settings
//! panels ────────┘                                   │
//!   ▲                                                ▼
//!   └─────────────────────── &App ◄──────────────────┘
//! ```
//!
//! Panels read the [`App`] and push [`Command`]s onto it; nothing else changes anything.

mod answers;
mod apply;
mod bars;
mod bookmark;
#[cfg(not(target_arch = "wasm32"))]
mod chooser;
mod clicks;
mod command;
mod compose;
mod controls;
mod course_panel;
mod course_row;
mod course_steps;
mod desk;
mod dialog;
mod errand;
mod exports;
mod fetched;
mod files;
mod found;
mod free_panel;
mod free_scenes;
mod goal_panel;
mod goals;
mod hint;
mod history;
mod in_sight;
mod inspector;
mod keys;
mod kit;
mod large_picture;
mod layout;
mod links;
mod marks;
mod memory;
mod menus;
mod mesh_loading;
#[cfg(not(target_arch = "wasm32"))]
mod native;
mod notice;
mod overlays;
mod pages;
mod pen;
mod phone;
mod platform;
mod playback;
mod practice;
mod practice_panel;
mod prelude;
mod progress_page;
mod question;
mod recording;
#[cfg(not(target_arch = "wasm32"))]
mod reload;
mod room;
mod run_room;
mod said;
mod settings;
mod shelf;
mod shown;
mod sight;
mod speaker;
mod stage;
mod stage_state;
#[cfg(test)]
mod tests;
mod typing;
mod ways_out;
#[cfg(target_arch = "wasm32")]
mod web;
mod why;
mod window;

pub use command::{BINDINGS, Binding, Command};
pub use desk::{Page, Places, StoredWork};
pub use dialog::{Answer, Dialog, Figures, Question, Target};
pub use kit::Kit;
pub use mesh_loading::is_mesh;
#[cfg(not(target_arch = "wasm32"))]
pub use native::{Opening, run_native};
#[cfg(not(target_arch = "wasm32"))]
pub use platform::Desktop;
pub use platform::{NoFiles, Platform, Reader, StageFigure};
pub use settings::Settings;
pub(crate) use settings::Snapshot;
#[cfg(target_arch = "wasm32")]
pub use web::start;

use std::{cell::RefCell, collections::BTreeMap};

use web_time::Instant;

use crate::{panels, widgets::Album};

use bookmark::{Bookmark, FreeScene};
use desk::Desk;
use history::History;
use playback::{Hidden, Playback};
use prelude::*;

/// The whole app, without a window of its own.
pub struct App {
    settings: Settings,
    bookmark: Bookmark,
    desk: Desk,
    history: History<Scene>,
    playback: Playback,
    practice: practice::Practice,
    goals: goals::Goals,
    compose: Option<Box<compose::Compose>>,
    /// What takes the place of the playback once it is recorded.
    pending: Option<recording::Pending>,
    given_up: Option<errand::Errand<found::Found>>,
    /// The scenes of the open lesson, which are shown alike.
    album: Option<Album>,
    stage: stage_state::StageState,
    kit: Kit,
    shown: shown::Shown,
    /// Since what is remembered was last looked at.
    is_touched: bool,
    notices: Vec<notice::Notice>,
    platform: Box<dyn Platform>,
    /// What panels have asked for in this frame.
    commands: RefCell<Vec<Command>>,
    asked: Option<Dialog>,
    exports: exports::Exports,
    #[cfg(not(target_arch = "wasm32"))]
    reload: Option<reload::Reload>,
    loading: Vec<mesh_loading::MeshLoading>,
}

impl App {
    pub fn new(course: Course, settings: Settings) -> Self {
        Self::with_kit(course, settings, Kit::default())
    }

    /// The same with these labs, of which there is at least one.
    ///
    /// # Panics
    /// Where there is none.
    pub fn with_kit(course: Course, mut settings: Settings, kit: Kit) -> Self {
        let first = kit.panels.first().expect("a window has a lab").lab();
        let places = settings.places();
        let mut bookmark = Bookmark::restored(course, &places, |id| kit.lab(id));
        if bookmark.page().is_none() {
            bookmark.open_free(FreeScene::of(first), None);
        }
        let scene = (first.first_scene)();
        let stored = std::mem::take(&mut settings.works);
        let mut app = Self {
            desk: Desk {
                works: BTreeMap::new(),
                places,
            },
            settings,
            playback: Playback::record(&scene, 0),
            practice: practice::Practice::default(),
            goals: goals::Goals::default(),
            compose: None,
            pending: None,
            given_up: None,
            album: None,
            stage: stage_state::StageState::new(bookmark.bounds_of(&scene)),
            bookmark,
            history: History::new(scene),
            kit,
            shown: shown::Shown {
                title: "Clipscope".to_owned(),
                ..shown::Shown::default()
            },
            notices: Vec::new(),
            is_touched: false,
            platform: Box::new(NoFiles),
            commands: RefCell::default(),
            asked: None,
            exports: exports::Exports::default(),
            #[cfg(not(target_arch = "wasm32"))]
            reload: None,
            loading: Vec::new(),
        };
        app.lay_out(stored);
        app.enter();
        if app.is_the_readers() && app.history.can_undo() {
            app.tell(&Message::new("status-restored"), 0.0);
        }
        app
    }

    pub fn with_platform(mut self, platform: impl Platform + 'static) -> Self {
        self.platform = Box::new(platform);
        self
    }

    pub fn with_scene(mut self, file: &str, opened: SceneFile) -> Self {
        self.open_scene(file, opened);
        self
    }

    /// Goes to a step of the run; of a scene that is being recorded, once it is.
    pub fn seek(&mut self, position: usize) {
        match &mut self.pending {
            Some(pending) => pending.position = Some(position),
            None => self.playback.transport.seek(position),
        }
    }

    pub fn settings(&self) -> Settings {
        self.snapshot().written()
    }

    fn snapshot(&self) -> Snapshot {
        Snapshot {
            settings: self.plain_settings(),
            works: self.kept_works(),
            formats: self.kit.formats,
        }
    }

    /// Without the work on pages.
    fn plain_settings(&self) -> Settings {
        Settings {
            theme: self.lasting_theme(),
            speed: self.playback.transport.speed(),
            progress: self.marks().clone(),
            ..self.settings.clone()
        }
        .with_places(self.places())
    }

    fn places(&self) -> Places {
        Places {
            page: self.bookmark.page(),
            ..self.desk.places.clone()
        }
    }

    /// Has anything been asked for since this was last asked?
    fn take_touched(&mut self) -> bool {
        std::mem::take(&mut self.is_touched)
    }

    const fn is_dragging(&self) -> bool {
        self.history.is_in_gesture()
    }

    /// The scene on the stage.
    pub const fn scene(&self) -> &Scene {
        if self.shows_another() {
            self.playback.scene()
        } else {
            self.history.now()
        }
    }

    pub const fn position(&self) -> usize {
        self.playback.transport.position()
    }

    /// Where a point of the world lies on the (last) stage: for whoever drives the app from outside. `None`
    /// before the first frame.
    pub fn on_screen(&self, world: [f64; 2]) -> Option<Pos2> {
        self.stage.on_screen([world[0], world[1], 0.0])
    }

    pub fn ui(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        let now = ctx.input(|input| input.time);
        for command in self.pressed(&ctx) {
            self.apply(&ctx, command);
        }
        self.take_what_comes(&ctx);
        self.take_answer(&ctx, now);
        #[cfg(not(target_arch = "wasm32"))]
        self.take_changed_course(now);
        self.take_meshes(now);
        self.pass_fetched();
        self.pass_time(&ctx, now);
        self.take_smaller(web_time::Duration::ZERO, now);
        let is_dragging = self.history.is_in_gesture();
        if self.playback.is_late && !is_dragging {
            self.playback.rerecord(self.history.now());
        }
        self.ask_anew();
        self.look_at_goal();
        self.take_recorded(&ctx);
        self.take_up_lesson();
        self.playback.hide(Hidden {
            mistakes: self.hides_mistakes(),
            what_comes: self.practice.is_asking(),
            costs: self.is_hunting(),
        });
        let album = self.album.as_ref();
        self.playback.prepare(self.stage.bounds(), album);

        (self.shown.size, self.shown.measures) = (ctx.content_rect().size(), self.measures());
        self.shown.is_measuring &= self.shown.measures;
        self.install_theme(ui);
        self.name_window(&ctx);
        let lit = self.stage.lit;
        // What is drawn into is not read: panels see an app without its stage and its labs' panels.
        let mut stage = std::mem::take(&mut self.stage);
        let mut panels = std::mem::take(&mut self.kit.panels);
        layout::show(self, ui, &mut stage, &mut panels);
        self.hide_idle_pointer(&ctx);
        (self.stage, self.kit.panels) = (stage, panels);
        let commands = self.commands.take();
        if !commands.is_empty() || lit != self.stage.lit {
            ctx.request_repaint();
        }
        for command in commands {
            self.apply(&ctx, command);
        }
    }

    fn push(&self, command: Command) {
        self.commands.borrow_mut().push(command);
    }

    fn push_all(&self, commands: impl IntoIterator<Item = Command>) {
        self.commands.borrow_mut().extend(commands);
    }

    fn pressed(&self, ctx: &Context) -> Vec<Command> {
        let focus = keys::Focus::now(ctx, &self.stage.canvas_ids, &self.stage.handle_ids);
        let is_asked = self.shown.dialog.is_some() || self.shown.is_measuring;
        let may = |it: &Command| !is_asked || matches!(it, Command::Cancel | Command::Help);
        let mut commands = Vec::new();
        if !is_asked {
            commands = compose::keys(self, ctx);
        }
        if !is_asked && focus != keys::Focus::Text {
            commands.extend(practice::keys(self, ctx));
        }
        commands.extend(keys::commands(ctx, focus, may));
        let is_over = ctx.memory(|memory| memory.top_modal_layer().is_some());
        if focus == keys::Focus::Free && !is_over {
            keys::tab_to(ctx, self.stage.handle_ids.first().copied());
        }
        let is_held = self.stage.focused.is_some() || egui::Popup::is_any_open(ctx);
        if is_held && self.shown.presenting.is_none() && !self.is_recording() {
            // Escape gives the handle's focus back, or closes the menu: nothing more.
            commands.retain(|command| !matches!(command, Command::Cancel));
        }
        if self.stage.sketch.is_some() {
            commands.retain(Command::goes_with_a_sketch);
        }
        commands
    }

    fn pass_time(&mut self, ctx: &Context, now: f64) {
        self.export_next(ctx, now);
        self.weigh_export(ctx);
        if let Some(wait) = self.playback.advance(now) {
            ctx.request_repaint_after_secs(wait.max(0.0));
        }
        let waits = [self.expire_notices(now), self.pass_composed(ctx, now)];
        for wait in waits.into_iter().flatten() {
            ctx.request_repaint_after_secs(wait);
        }
        let start = Instant::now();
        let clock = || start.elapsed().as_secs_f64();
        panels::work(&mut self.kit.panels, ctx, &clock);
    }
}
