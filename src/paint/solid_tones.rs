//! The tone of each facet of a solid.

use egui::Color32;
use glam::DVec3;

use crate::figure::{Facet, Link, Role};

use super::{Theme, ThemeKind, pen::stroke_colour};

/// Where light comes from: from the left, from above, and from before.
const LIGHT: DVec3 = DVec3::new(-0.35, 0.8, 0.48);
/// Cosines of the angle to it: what is turned to it more than the first is lit, more than the second half.
const LIT: [f64; 2] = [0.62, 0.15];

/// What stands out has so much of the accent.
const STANDS_OUT: f32 = 0.28;

/// One for each facet and its normal; what is about `lit` stands out.
pub fn tones(
    theme: &Theme,
    facets: &[Facet],
    normals: &[[f32; 3]],
    lit: Option<Link>,
) -> Vec<Color32> {
    let light = LIGHT.normalize();
    let tone = |(facet, normal): (&Facet, &[f32; 3])| {
        let cosine = DVec3::from(normal.map(f64::from)).dot(light);
        let darkness = LIT.iter().filter(|least| cosine <= **least).count();
        let tone = tone(theme, facet.role, darkness);
        if lit.is_some() && facet.link == lit {
            tone.lerp_to_gamma(theme.accent, STANDS_OUT)
        } else {
            tone
        }
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
    match role {
        // The ground shows through what is cut away.
        Role::Discarded => hue.gamma_multiply(strength),
        Role::Ink | Role::Soft | Role::Faint | Role::Accent | Role::Signal | Role::Accepted => {
            theme.background.lerp_to_gamma(hue, strength)
        }
    }
}
