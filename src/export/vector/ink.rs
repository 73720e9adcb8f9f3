//! A colour by its name in the theme, so that a style sheet can change it, and how strong it is.

use egui::Color32;

use crate::paint::Theme;

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Ink {
    /// Its name in the theme, where it is one of its colours.
    pub role: Option<&'static str>,
    /// Full strength.
    pub rgb: [u8; 3],
    pub alpha: u8,
}

/// In the order in which they are looked for: where two are alike, the first is meant.
pub fn roles(theme: &Theme) -> [(&'static str, Color32); 13] {
    [
        ("background", theme.background),
        ("ink", theme.ink),
        ("soft", theme.soft),
        ("faint", theme.faint),
        ("accent", theme.accent),
        ("accent-wash", theme.accent_wash),
        ("signal", theme.signal),
        ("signal-text", theme.signal_text),
        ("accepted", theme.accepted),
        ("discarded", theme.discarded),
        ("hairline", theme.hairline),
        ("panel", theme.panel),
        ("hover", theme.hover),
    ]
}

impl Ink {
    pub fn of(theme: &Theme, colour: Color32) -> Self {
        let alpha = colour.a();
        let is_it = |role: &Color32| {
            // Multiplied by alpha, and rounded: one more or less is the same.
            let faded = role.gamma_multiply(f32::from(alpha) / 255.0).to_array();
            let pairs = faded.into_iter().zip(colour.to_array());
            pairs.into_iter().all(|(a, b)| a.abs_diff(b) <= 1)
        };
        let known = roles(theme).into_iter().find(|(_, role)| is_it(role));
        let [r, g, b, _] = match known {
            Some((_, role)) => role.to_array(),
            None => colour.to_srgba_unmultiplied(),
        };
        Self {
            role: known.map(|(name, _)| name),
            rgb: [r, g, b],
            alpha,
        }
    }

    pub fn is_opaque(self) -> bool {
        self.alpha == 255
    }

    pub fn strength(self) -> f32 {
        f32::from(self.alpha) / 255.0
    }

    pub fn hex(self) -> String {
        let [r, g, b] = self.rgb;
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paint::ThemeKind;

    #[test]
    fn a_faded_role_is_still_that_role() {
        for kind in ThemeKind::ALL {
            let theme = Theme::of(kind);
            for (name, colour) in roles(theme) {
                for strength in [1.0, 0.5, 0.2, 0.08] {
                    let ink = Ink::of(theme, colour.gamma_multiply(strength));
                    let named = ink.role.expect("a role");
                    let is_alike = roles(theme).iter().any(|(other, same)| {
                        *other == named && (strength < 1.0 || *same == colour)
                    });
                    assert!(is_alike, "{kind}: {name} is taken for {named}");
                    if strength == 1.0 {
                        assert_eq!(
                            ink.hex(),
                            format!("#{:02x}{:02x}{:02x}", colour.r(), colour.g(), colour.b())
                        );
                    }
                }
            }
            assert_eq!(Ink::of(theme, Color32::from_rgb(1, 200, 3)).role, None);
        }
    }
}
