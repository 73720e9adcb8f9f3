//! Contrast: what has to be seen is, on every ground that it is drawn on, and without telling hues apart.

use egui::Color32;

use crate::figure::{Mark, Role, Shape};

use super::{Theme, ThemeKind, pen::Pen};

const ROLES: [Role; 7] = [
    Role::Ink,
    Role::Soft,
    Role::Faint,
    Role::Accent,
    Role::Signal,
    Role::Accepted,
    Role::Discarded,
];

fn luminance(color: Color32) -> f64 {
    let [r, g, b, _] = color.to_array().map(|byte| {
        let c = f64::from(byte) / 255.0;
        if c <= 0.04045 {
            c / 12.92
        } else {
            libm::pow((c + 0.055) / 1.055, 2.4)
        }
    });
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

fn contrast(a: Color32, b: Color32) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

fn pen(theme: &Theme, role: Role, shape: Shape) -> Pen {
    Pen::of(theme, &Mark::new(role, shape))
}

fn grounds(theme: &Theme) -> [Color32; 4] {
    let wash = |role| pen(theme, role, Shape::Region([[0.0; 2]; 2])).wash;
    let stage = theme.background;
    [
        stage,
        theme.accent_wash,
        stage.blend(wash(Role::Signal)),
        stage.blend(wash(Role::Soft)),
    ]
}

#[test]
fn contrast_is_that_of_wcag() {
    assert!((contrast(Color32::WHITE, Color32::BLACK) - 21.0).abs() < 1e-9);
}

#[test]
fn text_stands_out_on_every_surface() {
    for kind in ThemeKind::ALL {
        let theme = Theme::of(kind);
        let Theme {
            background,
            panel,
            hover,
            accent_wash,
            ..
        } = *theme;
        for surface in [background, panel, hover, accent_wash] {
            for text in [theme.ink, theme.soft] {
                let ratio = contrast(text, surface);
                assert!(ratio >= 4.5, "{kind}: {text:?} on {surface:?}: {ratio:.2}");
            }
        }
    }
}

#[test]
fn every_role_is_seen_on_every_ground() {
    let mut weak = Vec::new();
    for kind in ThemeKind::ALL {
        let theme = Theme::of(kind);
        for role in ROLES {
            let drawn = [
                Shape::Segment([[0.0; 2]; 2]),
                Shape::Outline(Vec::new()),
                Shape::Dot([0.0; 2]),
            ];
            for ground in grounds(theme) {
                for shape in &drawn {
                    let pen = pen(theme, role, shape.clone());
                    let [stroke, text] = [pen.stroke.color, pen.text].map(|c| contrast(c, ground));
                    if stroke < 3.0 || text < 4.5 {
                        weak.push(format!(
                            "{kind}, {role:?} on {ground:?}: stroke {stroke:.2}, text {text:.2}"
                        ));
                    }
                }
            }
        }
    }
    assert!(weak.is_empty(), "{weak:#?}");
}

#[test]
fn few_segments_are_as_strong_as_the_one_in_focus_and_many_recede_the_further_the_more_there_are() {
    for kind in ThemeKind::ALL {
        let theme = Theme::of(kind);
        for role in [Role::Accent, Role::Discarded] {
            let mark = Mark::new(role, Shape::Crowd(Vec::new()));
            let stroke = |n| Pen::of_crowd(theme, &mark, n).stroke;
            let focused = pen(theme, role, Shape::Segment([[0.0; 2]; 2])).stroke;
            assert_eq!(stroke(2).width, focused.width, "{kind}");
            let ratio = contrast(stroke(2).color, theme.background);
            assert!(ratio >= 3.0, "{kind}, {role:?}: {ratio:.2}");
            let ratios = [2, 200, 2_000, 10_000].map(|n| {
                let seen = theme.background.blend(stroke(n).color);
                contrast(seen, theme.background)
            });
            assert!(ratios[1] < 1.6, "{kind}, {role:?}: {ratios:?}");
            assert!(ratios.is_sorted_by(|more, less| more > less), "{ratios:?}");
        }
    }
}

/// To an eye without green, green is grey: it differs in lightness and in its dashes.
#[test]
fn what_is_kept_differs_from_what_is_discarded_without_hue() {
    for kind in ThemeKind::ALL {
        let theme = Theme::of(kind);
        let outline = |role| pen(theme, role, Shape::Outline(Vec::new()));
        let (kept, gone) = (outline(Role::Accepted), outline(Role::Discarded));
        let ratio = contrast(kept.stroke.color, gone.stroke.color);
        assert!(ratio >= 1.3, "{kind}: {ratio:.2}");
        assert!(gone.is_dashed && !kept.is_dashed);
        let grounds = [kept.wash, gone.wash].map(|wash| theme.accent_wash.blend(wash));
        let ratio = contrast(grounds[0], grounds[1]);
        assert!(ratio >= 1.2, "{kind}: the areas are {ratio:.2}");
    }
}
