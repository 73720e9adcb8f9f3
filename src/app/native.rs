//! The app in a window of a desktop.

use eframe::{CreationContext, NativeOptions};
use egui::ViewportBuilder;

use crate::{lesson::Folder, paint::fonts};

use super::{App, Desktop, Settings, memory::Memory, prelude::*, shelf::Shelf};

const DEFAULT_SIZE: [f32; 2] = [1280.0, 720.0];
const LEAST_SIZE: [f32; 2] = [320.0, 240.0];

#[derive(Default)]
pub struct Opening {
    /// A lesson folder, read again whenever it changes; else the embedded course.
    pub folder: Option<Folder>,
    pub scene: Option<(String, SceneFile)>,
    pub mesh: Option<String>,
    pub link: Option<String>,
}

/// Opens the window, and comes back when it has been closed.
///
/// # Errors
/// Why there can be no window: no display, no OpenGL.
pub fn run_native(opening: Opening) -> Result<(), Message> {
    let (stored, memory, said) = Memory::open(Shelf::of_system());
    let settings = stored.unwrap_or_else(Settings::of_system);
    let size = settings.window.unwrap_or(DEFAULT_SIZE);
    let options = NativeOptions {
        viewport: ViewportBuilder::default()
            .with_app_id("clipscope")
            .with_title("Clipscope")
            .with_inner_size(size)
            .with_min_inner_size(LEAST_SIZE)
            .with_icon(icon()),
        ..NativeOptions::default()
    };
    let result = eframe::run_native(
        "clipscope",
        options,
        Box::new(|creation| {
            let mut app = create(creation, opening, settings);
            if let Some(said) = said {
                app.complain(app.catalog().message(&said));
            }
            Ok(Box::new(NativeWindow {
                app,
                memory,
                fits: false,
            }))
        }),
    );
    // What eframe says is the system's own; its frame is the reader's.
    result.map_err(|error| {
        let reason = without_place(&error.to_string()).to_owned();
        Message::new("status-no-window").with("reason", reason)
    })
}

/// What an error of winit says, without the line of its source: `os error at …/mod.rs:765: no display`.
fn without_place(error: &str) -> &str {
    let after = error
        .rsplit_once(".rs:")
        .and_then(|(_, rest)| rest.split_once(": "));
    after.map_or(error, |(_, said)| said)
}

fn create(creation: &CreationContext<'_>, opening: Opening, settings: Settings) -> App {
    let ctx = &creation.egui_ctx;
    // A window that was closed during a presentation is a window again.
    ctx.send_viewport_cmd(egui::ViewportCommand::Fullscreen(false));
    ctx.set_fonts(fonts::definitions());
    let loaded = opening.folder.as_ref().map(|folder| Course::check(folder));
    let course = loaded
        .as_ref()
        .map_or_else(Course::embedded, |loaded| loaded.course.clone());
    let root = opening.folder.as_ref().map(Folder::full_path);
    let settings = Settings {
        folder: root,
        ..settings
    };
    let mut app = App::new(course, settings).with_platform(Desktop::with_dialogs());
    // What is opened now stands where it is to stand.
    app.rewind_for_someone_new();
    if let Some((file, scene)) = opening.scene {
        app = app.with_scene(&file, scene);
    }
    if let Some(link) = opening.link {
        app.open_link(&link);
    }
    if let Some(path) = opening.mesh {
        app.load_mesh(&path, ctx);
    }
    if let Some(folder) = opening.folder {
        app.report_errors(loaded.unwrap_or_default().problems);
        app.watch(folder, ctx.clone());
    }
    app.greet();
    app
}

impl App {
    /// How large the window is: what the next one will be.
    fn note_window(&mut self, ctx: &Context) {
        let window = ctx.input(|input| {
            let viewport = input.viewport();
            let is_plain = viewport.fullscreen != Some(true) && viewport.maximized != Some(true);
            viewport.inner_rect.filter(|_| is_plain)
        });
        let window = window.map(|rect| [rect.width(), rect.height()]);
        self.settings.window = window.or(self.settings.window);
    }
}

/// The icon, where its file can be read: a window without one is still a window.
fn icon() -> egui::IconData {
    let bytes = include_bytes!("../../assets/icon.png");
    eframe::icon_data::from_png_bytes(bytes).unwrap_or_default()
}

struct NativeWindow {
    app: App,
    memory: Memory,
    /// Has been looked whether the window, with the frame around it, fits its screen?
    fits: bool,
}

/// A window that is larger than its screen becomes as small; false as long as the sizes are not known.
fn fit_screen(ctx: &Context) -> bool {
    let sizes = ctx.input(|input| {
        let viewport = input.viewport();
        let [outer, inner] = [viewport.outer_rect?, viewport.inner_rect?].map(|it| it.size());
        Some((outer, inner, viewport.monitor_size?))
    });
    if let Some((outer, inner, screen)) = sizes {
        let over = (outer - screen).max(egui::Vec2::ZERO);
        if over != egui::Vec2::ZERO {
            ctx.send_viewport_cmd(egui::ViewportCommand::InnerSize(inner - over));
        }
    }
    sizes.is_some()
}

impl eframe::App for NativeWindow {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.fits = self.fits || fit_screen(ui.ctx());
        self.app.ui(ui);
        self.app.note_window(ui.ctx());
        self.memory.pass(&mut self.app, ui.ctx());
    }

    fn on_exit(&mut self, _: Option<&eframe::glow::Context>) {
        self.app.leave_composed();
        self.memory.end(&mut self.app);
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        visuals.window_fill.to_normalized_gamma_f32()
    }
}

#[cfg(test)]
mod tests {
    use super::without_place;

    #[test]
    fn a_reader_hears_the_reason_and_no_place_in_a_source() {
        let said = "winit EventLoopError: os error at /a/winit-0.30.13/src/mod.rs:765: no display";
        assert_eq!(without_place(said), "no display");
        assert_eq!(without_place("no OpenGL: 2.1"), "no OpenGL: 2.1");
    }
}
