//! Colours and sizes: three themes, one set of names. Blue is the living result and the selection, vermilion what happens
//! at this step, all else ink in three strengths. The hues are Okabe and Ito's; a role never depends on its hue alone.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::LazyLock;

use egui::style::{HandleShape, Selection, WidgetVisuals, Widgets};
use egui::{
    Color32, CornerRadius, FontFamily, FontId, Margin, Shadow, Stroke, Style, TextStyle,
    ThemePreference, Visuals, vec2,
};
use serde::{Deserialize, Serialize};

use crate::{figure::Chip, text::Catalog};

use super::{fonts::semibold, text_sizes::TEXT_SIZES};

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ThemeKind {
    #[default]
    Light,
    Dark,
    Projector,
}

impl ThemeKind {
    pub const ALL: [Self; 3] = [Self::Light, Self::Dark, Self::Projector];

    pub fn id(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Dark => "dark",
            Self::Projector => "projector",
        }
    }

    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.id() == id)
    }
}

impl fmt::Display for ThemeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    pub kind: ThemeKind,
    pub background: Color32,
    /// Panels, one shade off the stage.
    pub panel: Color32,
    pub hover: Color32,
    pub hairline: Color32,
    pub ink: Color32,
    pub soft: Color32,
    pub faint: Color32,
    pub accent: Color32,
    /// Accent as a surface: a selected row, the inside of a window.
    pub accent_wash: Color32,
    pub signal: Color32,
    pub signal_text: Color32,
    /// What has been accepted: darker than Okabe and Ito's green, which is as light as the grey of what is discarded.
    pub accepted: Color32,
    pub discarded: Color32,
    pub stroke_scale: f32,
    pub text_scale: f32,
    /// The same of titles and captions: what is large already grows less, so that figures keep their room.
    pub title_scale: f32,
    /// No text is set smaller, in points; a page can be enlarged.
    pub least_text: f32,
}

/// What everything is drawn with: the colours, and the words; and while something is asked, the chips of what might come.
#[derive(Clone, Copy)]
pub struct Look<'a> {
    pub theme: &'a Theme,
    pub catalog: &'a Catalog,
    pub chips: &'a [Chip],
}

impl<'a> Look<'a> {
    pub const fn new(theme: &'a Theme, catalog: &'a Catalog) -> Self {
        Self {
            theme,
            catalog,
            chips: &[],
        }
    }

    pub fn say(&self, key: &str) -> String {
        self.catalog.term(key)
    }
}

const fn rgb(hex: u32) -> Color32 {
    Color32::from_rgb((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

const LIGHT: Theme = Theme {
    kind: ThemeKind::Light,
    background: rgb(0xFF_FFFF),
    panel: rgb(0xF6_F7F9),
    hover: rgb(0xEA_EDF1),
    hairline: rgb(0xE1_E4E8),
    ink: rgb(0x1B_1F24),
    soft: rgb(0x57_606A),
    faint: rgb(0x9A_A3AD),
    accent: rgb(0x00_72B2),
    accent_wash: rgb(0xE6_F1F8),
    signal: rgb(0xD5_5E00),
    signal_text: rgb(0xAE_4B00),
    accepted: rgb(0x00_795A),
    discarded: rgb(0x7B_848E),
    stroke_scale: 1.0,
    text_scale: 1.0,
    title_scale: 1.0,
    least_text: 0.0,
};

const DARK: Theme = Theme {
    kind: ThemeKind::Dark,
    background: rgb(0x14_171B),
    panel: rgb(0x1B_1F24),
    hover: rgb(0x26_2C33),
    hairline: rgb(0x2C_323A),
    ink: rgb(0xE8_ECF1),
    soft: rgb(0xA3_ADB8),
    faint: rgb(0x66_707B),
    accent: rgb(0x56_B4E9),
    accent_wash: rgb(0x1E_3140),
    signal: rgb(0xF0_8A3C),
    signal_text: rgb(0xF0_8A3C),
    accepted: rgb(0x2B_C79A),
    discarded: rgb(0x77_818C),
    ..LIGHT
};

/// Projectors wash greys out: those that must be seen are a step darker than in daylight.
const PROJECTOR: Theme = Theme {
    kind: ThemeKind::Projector,
    hairline: rgb(0xC9_CED4),
    ink: rgb(0x00_0000),
    soft: rgb(0x3F_4750),
    faint: rgb(0x7A_838D),
    accent: rgb(0x00_69A5),
    accent_wash: rgb(0xDB_EBF5),
    accepted: rgb(0x00_6B4F),
    discarded: rgb(0x6F_7882),
    stroke_scale: 1.6,
    text_scale: 1.4,
    title_scale: 1.25,
    least_text: 12.0,
    ..LIGHT
};

pub fn caption() -> TextStyle {
    TextStyle::Name("caption".into())
}

pub fn caption_strong() -> TextStyle {
    TextStyle::Name("caption strong".into())
}

pub fn strong() -> TextStyle {
    TextStyle::Name("strong".into())
}

impl Theme {
    pub fn of(kind: ThemeKind) -> &'static Self {
        match kind {
            ThemeKind::Light => &LIGHT,
            ThemeKind::Dark => &DARK,
            ThemeKind::Projector => &PROJECTOR,
        }
    }

    /// That of a window, with text of one of [`TEXT_SIZES`].
    pub fn sized(kind: ThemeKind, text: f32) -> &'static Self {
        &Self::of_size(kind, text)[0]
    }

    /// The same without the signal's colour: while something is asked, nothing but the question has it, for it would point.
    pub fn hushed(kind: ThemeKind, text: f32) -> &'static Self {
        &Self::of_size(kind, text)[1]
    }

    /// A question's own colour, in a hushed theme as well.
    pub fn asks(&self) -> Color32 {
        Self::of(self.kind).signal_text
    }

    fn of_size(kind: ThemeKind, text: f32) -> &'static [Self; 2] {
        static SIZED: LazyLock<Vec<[Theme; 2]>> = LazyLock::new(|| {
            let of_size = |kind, text| {
                let theme = Theme::of(kind).with_text(text);
                let mut hushed = theme.clone();
                (hushed.signal, hushed.signal_text) = (theme.ink, theme.ink);
                [theme, hushed]
            };
            let of_kind = |kind| TEXT_SIZES.map(|text| of_size(kind, text));
            ThemeKind::ALL.into_iter().flat_map(of_kind).collect()
        });
        let nth = TEXT_SIZES.iter().position(|size| *size == text);
        let natural = || TEXT_SIZES.iter().position(|size| *size == 1.0);
        let nth = nth.or_else(natural).unwrap_or_default();
        &SIZED[kind as usize * TEXT_SIZES.len() + nth]
    }

    fn with_text(&self, text: f32) -> Self {
        Self {
            text_scale: self.text_scale * text,
            title_scale: self.title_scale * text,
            least_text: PROJECTOR.least_text * text.min(1.0),
            ..self.clone()
        }
    }

    /// Made to be read from afar: what has no room goes.
    pub const fn has_large_text(&self) -> bool {
        self.text_scale > 1.0
    }

    pub fn pts(&self, natural: f32, scale: f32) -> f32 {
        (natural * scale).max(self.least_text)
    }

    /// A line of a figure, `width` px wide before the theme's factor.
    pub fn stroke(&self, width: f32, color: Color32) -> Stroke {
        Stroke::new(width * self.stroke_scale, color)
    }

    pub fn style(&self) -> Style {
        let mut style = Style {
            text_styles: self.text_styles(),
            visuals: self.visuals(),
            ..Style::default()
        };
        let spacing = &mut style.spacing;
        spacing.item_spacing = vec2(8.0, 8.0);
        spacing.button_padding = vec2(8.0, 4.0);
        spacing.window_margin = Margin::same(16);
        spacing.menu_margin = Margin::same(8);
        spacing.indent = 16.0;
        // The bar stands beside what it scrolls, not over its last column.
        spacing.scroll.floating_allocated_width = 10.0;
        // A bar in sight tells that there is more, not words that fade.
        spacing.scroll.fade.strength = 0.0;
        spacing.scroll.dormant_handle_opacity = 0.6;
        spacing.scroll.floating_width = 4.0;
        spacing.interact_size = vec2(32.0, 24.0 * self.text_scale);
        spacing.default_area_size.y = 4000.0; // a list is as high as the window lets it be
        spacing.slider_width = 128.0;
        spacing.slider_rail_height = 4.0;
        spacing.icon_width = 16.0 * self.text_scale;
        spacing.icon_width_inner = 8.0 * self.text_scale;
        spacing.icon_spacing = 8.0;
        style
    }

    fn text_styles(&self) -> BTreeMap<TextStyle, FontId> {
        let font = |size: f32, family| FontId::new(self.pts(size, self.text_scale), family);
        let said = |family| FontId::new(14.5 * self.title_scale, family);
        [
            (TextStyle::Small, font(11.0, FontFamily::Proportional)),
            (TextStyle::Body, font(13.0, FontFamily::Proportional)),
            (TextStyle::Button, font(13.0, FontFamily::Proportional)),
            (TextStyle::Monospace, font(12.5, FontFamily::Monospace)),
            (TextStyle::Heading, font(16.0, semibold())),
            (strong(), font(13.0, semibold())),
            (caption(), said(FontFamily::Proportional)),
            (caption_strong(), said(semibold())),
        ]
        .into()
    }

    fn visuals(&self) -> Visuals {
        let basis = if self.kind == ThemeKind::Dark {
            Visuals::dark()
        } else {
            Visuals::light()
        };
        let mut visuals = Visuals {
            widgets: self.widgets(),
            // Also the ring of a focused text field.
            selection: Selection {
                bg_fill: self.accent_wash,
                stroke: Stroke::new(1.5, self.accent),
            },
            weak_text_color: Some(self.soft),
            hyperlink_color: self.accent,
            faint_bg_color: self.panel,
            extreme_bg_color: self.background,
            code_bg_color: self.panel,
            warn_fg_color: self.signal,
            error_fg_color: self.signal,
            window_fill: self.background,
            panel_fill: self.panel,
            window_stroke: Stroke::new(1.0, self.hairline),
            window_shadow: Shadow::NONE,
            popup_shadow: Shadow::NONE,
            window_corner_radius: CornerRadius::same(6),
            menu_corner_radius: CornerRadius::same(6),
            indent_has_left_vline: false,
            handle_shape: HandleShape::Circle,
            ..basis
        };
        visuals.text_cursor.stroke = Stroke::new(2.0, self.accent);
        visuals
    }

    fn widgets(&self) -> Widgets {
        // Nothing grows when touched, so that nothing on the stage moves.
        let state = |weak_bg_fill, bg_fill, bg_stroke, text| WidgetVisuals {
            weak_bg_fill,
            bg_fill,
            bg_stroke,
            corner_radius: CornerRadius::same(4),
            fg_stroke: Stroke::new(1.0, text),
            expansion: 0.0,
        };
        let hairline = Stroke::new(1.0, self.hairline);
        // egui shows the keyboard's focus as "active": this stroke is the focus ring.
        let ring = Stroke::new(2.0, self.accent);
        Widgets {
            noninteractive: state(self.panel, self.panel, hairline, self.ink),
            inactive: state(Color32::TRANSPARENT, self.hairline, Stroke::NONE, self.ink),
            hovered: state(self.hover, self.hairline, Stroke::NONE, self.ink),
            active: state(self.accent_wash, self.accent_wash, ring, self.ink),
            open: state(self.hover, self.hover, Stroke::NONE, self.ink),
        }
    }
}

/// egui keeps a style for light and one for dark surroundings: both are set, and the one of `theme` is chosen. Its own keys that
/// enlarge all are off: text has a size of its own.
pub fn install(ctx: &egui::Context, theme: &Theme) {
    let (light, dark, preference) = match theme.kind {
        ThemeKind::Light | ThemeKind::Projector => (theme, &DARK, ThemePreference::Light),
        ThemeKind::Dark => (&LIGHT, theme, ThemePreference::Dark),
    };
    ctx.set_style_of(egui::Theme::Light, light.style());
    ctx.set_style_of(egui::Theme::Dark, dark.style());
    ctx.set_theme(preference);
    ctx.options_mut(|options| options.zoom_with_keyboard = false);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_read_back() {
        for kind in ThemeKind::ALL {
            assert_eq!(ThemeKind::from_id(kind.id()), Some(kind));
            let json = serde_json::to_string(&kind).expect("a plain enum");
            assert_eq!(json, format!("\"{kind}\""));
        }
        assert_eq!(ThemeKind::from_id("sepia"), None);
    }

    #[test]
    fn each_size_of_text_is_a_theme_of_its_own() {
        for kind in ThemeKind::ALL {
            // A window has a least size of text, which a page can do without.
            let mut of_window = Theme::of(kind).clone();
            of_window.least_text = PROJECTOR.least_text;
            assert_eq!(Theme::sized(kind, 1.0), &of_window);
            assert_eq!(
                Theme::sized(kind, 2.0).text_scale,
                2.0 * Theme::of(kind).text_scale
            );
            assert_eq!(Theme::sized(kind, 2.0).kind, kind);
        }
    }

    #[test]
    fn both_styles_of_egui_are_set() {
        for kind in ThemeKind::ALL {
            let ctx = egui::Context::default();
            install(&ctx, Theme::of(kind));
            assert_eq!(ctx.global_style().visuals.panel_fill, Theme::of(kind).panel);
            assert!(ctx.style_of(egui::Theme::Dark).visuals.dark_mode);
            assert!(!ctx.style_of(egui::Theme::Light).visuals.dark_mode);
        }
    }
}
