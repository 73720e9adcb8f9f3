//! The window around the app: its title, its look, and the presentation, which fills the screen.

use egui::{InputState, OpenUrl, Vec2, ViewportCommand, style::ScrollAnimation};

use crate::widgets::TARGET;

use super::{App, prelude::*, run_room::WatchRooms};

/// In a presentation, a pointer that has rested for so long is hidden, in seconds.
const IDLE_SECS: f32 = 3.0;

#[derive(Clone, Copy, Debug)]
pub struct Before {
    theme: ThemeKind,
    is_fullscreen: bool,
    /// When it began, in seconds.
    pub since: f64,
}

/// Seconds until the pointer has rested enough to be hidden.
fn rest(ctx: &Context) -> f32 {
    IDLE_SECS - ctx.input(|input| input.pointer.time_since_last_movement())
}

impl App {
    /// Is a pointer of no interest that rests while something is presented?
    pub(super) fn has_hidden_pointer(&self, ctx: &Context) -> bool {
        self.hides_pointer() && rest(ctx) <= 0.0
    }

    const fn hides_pointer(&self) -> bool {
        self.shown.presenting.is_some() && !self.shown.is_embedded
    }

    /// Shows the stage, the caption and the transport only, as a part of another page.
    #[cfg(any(test, target_arch = "wasm32"))]
    pub(super) fn embedded(mut self) -> Self {
        self.shown.is_embedded = true;
        self.shown.presenting = Some(Before {
            theme: self.settings.theme,
            is_fullscreen: false,
            since: 0.0,
        });
        self
    }

    /// Opens what is embedded here in a page of its own.
    pub(super) fn open_whole(&self, ctx: &Context) {
        let link = self.link().fitting().unwrap_or_default();
        if let Some(address) = self.platform.address() {
            ctx.open_url(OpenUrl::new_tab(address + &link));
        }
    }

    pub(super) fn present(&mut self, ctx: &Context) {
        if self.leave_presentation(ctx) {
            return;
        }
        self.shown.presenting = Some(Before {
            theme: self.settings.theme,
            is_fullscreen: ctx.input(|input| input.viewport().fullscreen) == Some(true),
            since: ctx.input(|input| input.time),
        });
        ctx.send_viewport_cmd(ViewportCommand::Fullscreen(true));
    }

    pub(super) fn leave_presentation(&mut self, ctx: &Context) -> bool {
        let presenting = &mut self.shown.presenting;
        let Some(before) = presenting.take_if(|_| !self.shown.is_embedded) else {
            return false;
        };
        self.settings.theme = before.theme;
        self.shown.has_notes = false;
        self.shown.controls.leave_presentation();
        ctx.send_viewport_cmd(ViewportCommand::Fullscreen(before.is_fullscreen));
        true
    }

    pub(super) fn toggle_projector(&mut self) {
        let before = self.lasting_theme();
        let is_on = self.settings.theme == ThemeKind::Projector;
        self.settings.theme = match (is_on, before) {
            (false, _) => ThemeKind::Projector,
            (true, ThemeKind::Projector) => ThemeKind::Light,
            (true, before) => before,
        };
    }

    pub(super) fn lasting_theme(&self) -> ThemeKind {
        let before = self.shown.presenting;
        before.map_or(self.settings.theme, |before| before.theme)
    }

    /// Hides a pointer that rests while something is presented; asks to be drawn once more when it has rested enough.
    pub(super) fn hide_idle_pointer(&self, ctx: &Context) {
        if !self.hides_pointer() {
            return;
        }
        let left = rest(ctx);
        if left > 0.0 {
            ctx.request_repaint_after_secs(left);
        } else {
            ctx.set_cursor_icon(CursorIcon::None);
        }
    }

    /// Gives the context the theme, unless it has it: a headless table brings its own.
    pub(super) fn install_theme(&mut self, ui: &mut Ui) {
        self.install_colours(ui);
        // Nothing grows under a finger that is still down.
        let has_touched = |input: &InputState| input.has_touch_screen() && !input.any_touches();
        self.shown.is_touched |= ui.input(has_touched) || self.platform.has_fingers();
        let natural = self.look().theme.style().spacing.interact_size;
        let size = if self.has_fingers() {
            natural.max(Vec2::splat(TARGET))
        } else {
            natural
        };
        let is_still = self.platform.wants_stillness();
        let now = Some((size, is_still));
        if self.shown.hand.replace((size, is_still)) == now {
            return;
        }
        // Rows have another height.
        self.stage.watch = WatchRooms::default();
        ui.ctx().all_styles_mut(|style| {
            style.spacing.interact_size = size;
            if is_still {
                style.animation_time = 0.0;
                style.scroll_animation = ScrollAnimation::none();
            }
        });
        ui.reset_style();
    }

    fn install_colours(&mut self, ui: &mut Ui) {
        let theme = self.look().theme;
        let now = Some((theme.kind, theme.text_scale));
        if self.shown.theme == now {
            return;
        }
        let wanted = theme.style();
        let has = ui.ctx().global_style();
        if has.text_styles != wanted.text_styles
            || has.visuals.panel_fill != wanted.visuals.panel_fill
        {
            theme::install(ui.ctx(), theme);
            self.shown.hand = None;
            // This frame has begun with the old one.
            ui.reset_style();
        }
        self.shown.theme = now;
    }

    pub(super) fn name_window(&mut self, ctx: &Context) {
        let name_of = |path: &str| {
            let name = std::path::Path::new(path).file_name()?.to_str()?;
            Some(name.to_owned())
        };
        let file = self.history.file().and_then(name_of).map(|name| {
            let changed = ["", "● "][usize::from(self.history.is_unsaved())];
            format!("{changed}{name}")
        });
        let course = self.settings.folder.as_deref().and_then(name_of);
        let parts = [file, course, Some("Clipscope".to_owned())];
        let title = parts.into_iter().flatten().collect::<Vec<_>>().join(" – ");
        if self.shown.title != title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.shown.title = title;
        }
    }
}
