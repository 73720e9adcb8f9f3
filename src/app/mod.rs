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
//! Panels read the [`App`] and push [`Command`]s; nothing else changes anything.

mod apply;
mod asking;
mod bars;
mod bookmark;
#[cfg(not(target_arch = "wasm32"))]
mod chooser;
mod clicks;
mod command;
mod course_panel;
mod course_strip;
mod desk;
mod dialog;
mod drop;
mod files;
mod free_panel;
mod history;
mod inspector;
mod keys;
mod kit;
mod layout;
mod menus;
#[cfg(not(target_arch = "wasm32"))]
mod mesh_loading;
#[cfg(not(target_arch = "wasm32"))]
mod native;
mod notice;
mod overlays;
mod pages;
mod platform;
mod playback;
#[cfg(not(target_arch = "wasm32"))]
mod reload;
mod room;
mod run_room;
mod seen;
mod settings;
mod sketch;
mod stage;
mod stage_state;
mod stopwatch;
#[cfg(test)]
mod tests;
mod typed;
mod typing;
#[cfg(target_arch = "wasm32")]
mod web;
mod window;

pub use command::{BINDINGS, Binding, Command, PathOf};
pub use desk::{Page, StoredWork};
pub use dialog::{Answer, Dialog, Figures, Question, Target};
pub use kit::Kit;
#[cfg(not(target_arch = "wasm32"))]
pub use mesh_loading::is_mesh;
#[cfg(not(target_arch = "wasm32"))]
pub use native::{Opening, run_native};
#[cfg(not(target_arch = "wasm32"))]
pub use platform::Desktop;
pub use platform::{NoFiles, Platform, StageFigure};
pub use settings::Settings;
#[cfg(target_arch = "wasm32")]
pub use web::start;

use egui::{Pos2, Ui, Vec2};

use crate::{
    labs::Scene,
    lesson::{CodeView, Course, SceneFile},
    paint::ThemeKind,
    panels,
};

use bookmark::Bookmark;
use desk::Desk;
use history::History;
use keys::Focus;
use notice::Notices;
use playback::Playback;
use room::Room;
use stage_state::StageState;
use stopwatch::Stopwatch;

/// The whole app, without a window of its own.
pub struct App {
    settings: Settings,
    bookmark: Bookmark,
    desk: Desk,
    history: History<Scene>,
    /// The file that the scene was read from or written to last.
    file: Option<String>,
    playback: Playback,
    stage: StageState,
    kit: Kit,
    shown: Shown,
    notices: Notices,
    platform: Box<dyn Platform>,
    /// What a dialog of the system has been opened for.
    asked: Option<Dialog>,
    /// Figures on their way into files.
    exporting: Option<files::Export>,
    #[cfg(not(target_arch = "wasm32"))]
    reload: Option<reload::Reload>,
    /// Meshes that are being read.
    #[cfg(not(target_arch = "wasm32"))]
    loading: Vec<mesh_loading::MeshLoading>,
}

/// What of the window is shown.
#[allow(
    clippy::struct_excessive_bools,
    reason = "each is open or not whatever the others are"
)]
struct Shown {
    /// The window's size, as it was drawn last.
    size: Vec2,
    /// Can costs be measured in the open lab?
    measures: bool,
    code: CodeView,
    dialog: Option<Dialog>,
    /// Is the window with the measured costs open?
    is_measuring: bool,
    /// Does the list of lessons stand in the lesson's place?
    lists_lessons: bool,
    /// Is the answer of the open step shown?
    is_answered: bool,
    /// Stage, caption and a small transport alone.
    presenting: Option<window::Before>,
    /// Is the course open where it is a strip else?
    unfolded: bool,
    /// In a narrow window, the one place there is room for.
    room: Room,
    /// The theme that the context has been given.
    theme: Option<ThemeKind>,
    /// The window's title.
    title: String,
}

impl App {
    /// The app on a course, where it was left.
    pub fn new(course: Course, settings: Settings) -> Self {
        Self::with_kit(course, settings, Kit::default())
    }

    /// The same with these labs, of which there is at least one.
    ///
    /// # Panics
    /// Where there is none.
    pub fn with_kit(course: Course, mut settings: Settings, kit: Kit) -> Self {
        let mut bookmark = Bookmark::new(course);
        let first = kit.panels.first().expect("a window has a lab").lab();
        let is_open = match &settings.page {
            Some(page) => bookmark.open_page(page, |id| kit.lab(id)),
            None => bookmark.step().is_some(),
        };
        if !is_open && bookmark.step().is_none() {
            bookmark.open_free(first);
        }
        let scene = first.first_scene();
        let stored = std::mem::take(&mut settings.works);
        let mut app = Self {
            desk: Desk::new(std::mem::take(&mut settings.labs)),
            file: None,
            settings,
            bookmark,
            playback: Playback::record(&scene, 0),
            stage: StageState::new(&scene),
            history: History::new(scene),
            kit,
            shown: Shown {
                size: Vec2::ZERO,
                measures: false,
                code: CodeView::Full,
                dialog: None,
                is_measuring: false,
                lists_lessons: false,
                is_answered: false,
                presenting: None,
                unfolded: false,
                room: Room::Stage,
                theme: None,
                title: "Clipscope".to_owned(),
            },
            notices: Notices::default(),
            platform: Box::new(NoFiles),
            asked: None,
            exporting: None,
            #[cfg(not(target_arch = "wasm32"))]
            reload: None,
            #[cfg(not(target_arch = "wasm32"))]
            loading: Vec::new(),
        };
        app.lay_out(stored);
        app.enter();
        app
    }

    /// With files of this kind to save to.
    pub fn with_platform(mut self, platform: impl Platform + 'static) -> Self {
        self.platform = Box::new(platform);
        self
    }

    /// On this file's scene, in the free scene of its lab: what `clipscope open scene.toml` shows.
    pub fn with_scene(mut self, file: &str, opened: SceneFile) -> Self {
        self.open_scene(file, opened, 0.0);
        self
    }

    /// Goes to a step of the run.
    pub fn seek(&mut self, position: usize) {
        self.playback.transport_mut().seek(position);
    }

    /// What is remembered until the next time.
    pub fn settings(&self) -> Settings {
        Settings {
            page: self.bookmark.page(),
            labs: self.desk.all_last().clone(),
            works: self.stored_works(),
            theme: self.lasting_theme(),
            speed: self.playback.transport().speed(),
            ..self.settings.clone()
        }
    }

    /// The document.
    pub const fn scene(&self) -> &Scene {
        self.history.now()
    }

    /// The step of the run that is shown.
    pub const fn position(&self) -> usize {
        self.playback.transport().position()
    }

    /// Where a point of the world lies on the (last) stage: for whoever drives the app from outside. `None`
    /// before the first frame.
    pub fn on_screen(&self, world: [f64; 2]) -> Option<Pos2> {
        self.stage.on_screen([world[0], world[1], 0.0])
    }

    /// One frame: takes input, lets time pass, draws everything, and does what was asked for.
    pub fn ui(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        let now = ctx.input(|input| input.time);
        for command in self.pressed(&ctx) {
            self.apply(&ctx, command);
        }
        self.take_dropped_files(&ctx);
        self.take_answer(&ctx, now);
        #[cfg(not(target_arch = "wasm32"))]
        self.take_changed_course(now);
        #[cfg(not(target_arch = "wasm32"))]
        self.take_meshes(now);
        self.pass_time(&ctx, now);
        let is_dragging = self.history.is_in_gesture();
        if self.playback.is_late() && !is_dragging {
            self.playback.rerecord(self.history.now());
        }
        self.playback.prepare();

        self.install_theme(ui);
        self.name_window(&ctx);
        let mut commands = Vec::new();
        let lit = self.stage.lit;
        (self.shown.size, self.shown.measures) = (ctx.content_rect().size(), self.measures());
        // What is drawn into is not read: panels see an app without its stage and its labs' panels.
        let mut stage = std::mem::take(&mut self.stage);
        let mut panels = std::mem::take(&mut self.kit.panels);
        layout::show(self, ui, &mut stage, &mut panels, &mut commands);
        self.hide_idle_pointer(&ctx);
        (self.stage, self.kit.panels) = (stage, panels);
        if !commands.is_empty() || lit != self.stage.lit {
            ctx.request_repaint();
        }
        for command in commands {
            self.apply(&ctx, command);
        }
    }

    fn pressed(&self, ctx: &egui::Context) -> Vec<Command> {
        let focus = Focus::now(ctx, &self.stage.canvas_ids, &self.stage.handle_ids);
        let mut commands = keys::commands(ctx, focus);
        if focus == Focus::Free && self.shown.dialog.is_none() {
            keys::tab_to(ctx, self.stage.handle_ids.first().copied());
        }
        let is_held = self.stage.focused.is_some() || egui::Popup::is_any_open(ctx);
        if is_held && self.shown.presenting.is_none() {
            // Escape gives the handle's focus back, or closes the menu: nothing more.
            commands.retain(|command| !matches!(command, Command::Cancel));
        }
        if self.stage.sketch.is_some() {
            commands.retain(Command::goes_with_a_sketch);
        }
        if self.shown.dialog.is_some() || self.shown.is_measuring {
            commands.retain(|command| matches!(command, Command::Cancel | Command::Help));
        }
        commands
    }

    fn pass_time(&mut self, ctx: &egui::Context, now: f64) {
        self.export_next(ctx, now);
        if let Some(wait) = self.playback.advance(now) {
            ctx.request_repaint_after_secs(wait.max(0.0));
        }
        if let Some(wait) = self.notices.expire(now) {
            ctx.request_repaint_after_secs(wait);
        }
        let stopwatch = Stopwatch::start();
        panels::work(&mut self.kit.panels, ctx, &|| stopwatch.secs());
    }
}
