//! The tone of each facet of a solid.

use egui::Color32;
use glam::DVec3;

use crate::figure::{Facet, Role};

use super::{Theme, ThemeKind, pen::stroke_colour};

/// Where light comes from: from the left, from above, and from before.
const LIGHT: DVec3 = DVec3::new(-0.35, 0.8, 0.48);
/// Cosines of the angle to it: what is turned to it more than the first is lit, more than the second half.
const LIT: [f64; 2] = [0.62, 0.15];

/// One for each facet and its normal.
pub fn tones(theme: &Theme, facets: &[Facet], normals: &[DVec3]) -> Vec<Color32> {
    let light = LIGHT.normalize();
    let tone = |(facet, normal): (&Facet, &DVec3)| {
        let cosine = normal.dot(light);
        let darkness = LIT.iter().filter(|least| cosine <= **least).count();
        tone(theme, facet.role, darkness)
    };
    facets.iter().zip(normals).map(tone).collect()
}

/// Of a role: lit, half lit, or turned away.
fn tone(theme: &Theme, role: Role, darkness: usize) -> Color32 {
    let (hue, strengths) = match role {
        Role::Ink => (theme.ink, [0.72_f32, 0.80, 0.88]),
        Role::Soft | Role::Faint => (theme.soft, [0.045, 0.11, 0.19]),
        Role::Discarded => (theme.soft, [0.025, 0.085, 0.16]),
        Role::Accent | Role::Signal | Role::Accepted => {
            (stroke_colour(theme, role), [0.07, 0.19, 0.337])
        }
    };
    let strength = match theme.kind {
        ThemeKind::Light => strengths[darkness],
        // Projectors wash out.
        ThemeKind::Projector => (1.25 * strengths[darkness]).min(0.95),
        // On a dark ground what is lit is the farthest from it.
        ThemeKind::Dark => strengths[2 - darkness] + 0.06,
    };
    theme.background.lerp_to_gamma(hue, strength)
}
