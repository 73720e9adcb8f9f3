//! An interface drawn with no window: export, tests, the command line.

use egui::epaint::ClippedShape;
use egui::os::OperatingSystem;
use egui::{Color32, Memory, Pos2, RawInput, Rect, Ui, Vec2, ViewportId};

use super::cpu::{CpuPainter, Image};
use super::theme::{self, Theme, ThemeKind};
use super::{fonts, notes};

/// A layout that measures itself settles in two or three passes; an animation that never ends is drawn as it stands.
const MAX_PASSES: usize = 8;
/// Seconds between passes. Pictures hold no motion; egui wants its clock to advance.
const PASS_SECS: f64 = 1.0 / 60.0;
const MAX_SIDE_PX: f32 = 16_384.0;
const MAX_ATLAS_SIDE: usize = 4096;

/// Keep one for many pictures: fonts and glyphs are kept, and each picture has the same bytes as if it were the first.
pub struct Headless {
    ctx: egui::Context,
    painter: CpuPainter,
    kind: ThemeKind,
    pristine: Memory,
}

impl Headless {
    pub fn new(kind: ThemeKind) -> Self {
        let ctx = egui::Context::default();
        // Shortcuts are written out differently on a Mac: not in a figure.
        ctx.set_os(OperatingSystem::Nix);
        ctx.set_fonts(fonts::definitions());
        let mut headless = Self {
            pristine: ctx.memory(Memory::clone),
            ctx,
            painter: CpuPainter::default(),
            kind,
        };
        headless.install(kind);
        // Loads the fonts, and lets egui's first frames pass, which repaint without a reason.
        headless.run(Vec2::splat(64.0), 1.0, &mut |_| {});
        headless.pristine = headless.ctx.memory(Memory::clone);
        headless
    }

    pub fn theme(&self) -> &'static Theme {
        Theme::of(self.kind)
    }

    pub fn set_theme(&mut self, kind: ThemeKind) {
        if kind != self.kind {
            self.ctx
                .memory_mut(|memory| *memory = self.pristine.clone());
            self.install(kind);
            self.pristine = self.ctx.memory(Memory::clone);
        }
    }

    /// Over the theme's background, on `size_pts · pixels_per_point` pixels, rounded. There is no pointer, no keyboard, no
    /// animation, and no memory of earlier pictures; paint callbacks are not drawn.
    pub fn draw(
        &mut self,
        size_pts: Vec2,
        pixels_per_point: f32,
        mut ui: impl FnMut(&mut Ui),
    ) -> Image {
        let sheet = Sheet::new(size_pts, pixels_per_point);
        let (shapes, is_settled) = self.shapes(&sheet, false, &mut ui);
        let primitives = self.ctx.tessellate(shapes, sheet.pixels_per_point);
        let (ground, painter) = (self.theme().background, &self.painter);
        let image = painter.paint(&primitives, sheet.pixels_per_point, sheet.size_px, ground);
        self.settle(is_settled);
        image
    }

    /// The same as shapes, which `write` is given: their pixels are there for as long.
    pub fn write<R>(
        &mut self,
        size_pts: Vec2,
        pixels_per_point: f32,
        mut ui: impl FnMut(&mut Ui),
        write: impl FnOnce(&Drawing<'_>) -> R,
    ) -> R {
        let sheet = Sheet::new(size_pts, pixels_per_point);
        let (shapes, is_settled) = self.shapes(&sheet, true, &mut ui);
        let written = write(&Drawing {
            shapes: &shapes,
            size_pts: sheet.size_pts,
            pixels_per_point: sheet.pixels_per_point,
            theme: self.theme(),
            table: self,
            size_px: sheet.size_px,
        });
        self.settle(is_settled);
        written
    }

    /// What is drawn, and whether another pass would draw the same.
    fn shapes(
        &mut self,
        sheet: &Sheet,
        is_written: bool,
        ui: &mut dyn FnMut(&mut Ui),
    ) -> (Vec<ClippedShape>, bool) {
        // egui compares widgets with those of the pass before: that one is to be empty, too.
        self.run(sheet.size_pts, sheet.pixels_per_point, &mut |_| {});
        self.ctx
            .memory_mut(|memory| *memory = self.pristine.clone());
        self.ctx.clear_animations();
        if is_written {
            notes::listen(&self.ctx);
        }
        let (output, is_settled) = self.run(sheet.size_pts, sheet.pixels_per_point, ui);
        (output.shapes, is_settled)
    }

    fn settle(&mut self, is_settled: bool) {
        if !is_settled {
            // The pending repaints would give the next picture passes of its own.
            *self = Self::new(self.kind);
        }
    }

    fn install(&mut self, kind: ThemeKind) {
        self.kind = kind;
        theme::install(&self.ctx, Theme::of(kind));
        self.ctx.all_styles_mut(|style| {
            style.animation_time = 0.0;
            style.scroll_animation = egui::style::ScrollAnimation::none();
            style.visuals.text_cursor.blink = false;
        });
        // egui marks clashing ids in debug builds only: pictures are to be the same in both.
        self.ctx
            .options_mut(|options| options.warn_on_id_clash = false);
    }

    fn run(
        &mut self,
        size_pts: Vec2,
        pixels_per_point: f32,
        ui: &mut dyn FnMut(&mut Ui),
    ) -> (egui::FullOutput, bool) {
        let mut pass = 0;
        let mut focused = self.ctx.memory(Memory::focused);
        loop {
            let input = input(size_pts, pixels_per_point, pass);
            let mut output = self.ctx.run_ui(input, |root| ui(root));
            self.painter.apply(&mut output.textures_delta);
            pass += 1;
            let root = output.viewport_output.get(&ViewportId::ROOT);
            let wants_another = root.is_some_and(|root| root.repaint_delay.is_zero());
            // What takes the focus shows it one pass later, unasked.
            let had_focus = std::mem::replace(&mut focused, self.ctx.memory(Memory::focused));
            if pass == MAX_PASSES || (!wants_another && focused == had_focus) {
                return (output, !wants_another);
            }
        }
    }
}

/// A sheet to draw on, of whole pixels.
struct Sheet {
    size_px: [usize; 2],
    size_pts: Vec2,
    pixels_per_point: f32,
}

impl Sheet {
    fn new(size_pts: Vec2, pixels_per_point: f32) -> Self {
        let within = |value: f32, least: f32, most: f32| {
            // `f32::max` also turns what is not a number into the least.
            value.max(least).min(most)
        };
        let pixels_per_point = within(pixels_per_point, 0.125, 16.0);
        let side = |points: f32| within((points * pixels_per_point).round(), 1.0, MAX_SIDE_PX);
        let size_px = [side(size_pts.x), side(size_pts.y)];
        Self {
            size_px: size_px.map(|side| side as usize),
            size_pts: Vec2::from(size_px) / pixels_per_point,
            pixels_per_point,
        }
    }
}

/// What is drawn on a sheet: shapes in points, lowest first, with what the drawing says of itself among them.
pub struct Drawing<'a> {
    pub shapes: &'a [ClippedShape],
    pub size_pts: Vec2,
    pub pixels_per_point: f32,
    pub theme: &'static Theme,
    table: &'a Headless,
    size_px: [usize; 2],
}

impl Drawing<'_> {
    /// Some of the shapes on a piece of glass that is as large as they are, and where it lies, in pixels. Each pixel is multiplied by its
    /// alpha. Nothing of what is not on the sheet.
    pub fn on_glass(&self, mut shapes: Vec<ClippedShape>) -> Option<([usize; 2], Image)> {
        let sheet = Rect::from_min_size(Pos2::ZERO, self.size_pts);
        let seen = shapes.iter().map(|it| {
            let bounds = it.shape.visual_bounding_rect();
            bounds.intersect(it.clip_rect).intersect(sheet)
        });
        let seen = seen.filter(Rect::is_positive);
        let seen = seen.reduce(Rect::union)?;
        let px = |at: f32| at * self.pixels_per_point;
        let [width, height] = self.size_px;
        let min = [px(seen.min.x), px(seen.min.y)].map(|at| at.floor() as usize);
        let max = [(px(seen.max.x), width), (px(seen.max.y), height)];
        let max = max.map(|(at, most)| (at.ceil() as usize).min(most));
        let size = [max[0] - min[0], max[1] - min[1]];
        let by = -Vec2::from(min.map(|at| at as f32)) / self.pixels_per_point;
        for it in &mut shapes {
            it.shape.translate(by);
            it.clip_rect = it.clip_rect.translate(by);
        }
        let Headless { ctx, painter, .. } = self.table;
        let primitives = ctx.tessellate(shapes, self.pixels_per_point);
        let ground = Color32::TRANSPARENT;
        let image = painter.paint(&primitives, self.pixels_per_point, size, ground);
        Some((min, image))
    }
}

fn input(size_pts: Vec2, pixels_per_point: f32, pass: usize) -> RawInput {
    let mut input = RawInput {
        screen_rect: Some(Rect::from_min_size(Pos2::ZERO, size_pts)),
        max_texture_side: Some(MAX_ATLAS_SIDE),
        time: Some(pass as f64 * PASS_SECS),
        ..RawInput::default()
    };
    let root = input.viewports.entry(ViewportId::ROOT).or_default();
    root.native_pixels_per_point = Some(pixels_per_point);
    input
}
