//! What lies over what: the parts of all marks in the order in which they are painted.

use egui::{Pos2, vec2};

use crate::figure::{Link, Mark, Role, Shape};

use super::{
    Theme, Viewport,
    parts::{Part, parts},
    pen::radius,
};

/// What lies over what, whatever the order of the marks; within a layer theirs holds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Layer {
    /// Shaded half-planes: the window's area covers them.
    Wash,
    /// Lines that may be missed lie under all that stands in space.
    Construction,
    Area,
    /// In the plane they lie over areas: a line runs on through the window.
    Extension,
    Casing,
    Glow,
    Stroke,
    Head,
    Marker,
}

impl Layer {
    /// That of a group in a drawing that is written down.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Wash => "half-planes",
            Self::Construction => "construction",
            Self::Area => "areas",
            Self::Extension => "extensions",
            Self::Casing => "casings",
            Self::Glow => "glow",
            Self::Stroke => "strokes",
            Self::Head => "arrows",
            Self::Marker => "markers",
        }
    }
}

#[derive(Clone, Debug)]
pub struct LayeredPart<'a> {
    pub layer: Layer,
    pub mark: &'a Mark,
    pub part: Part<'a>,
}

const AT_MARKER: f32 = 1.5;
const GAP: f32 = 2.5;

/// All parts of the marks, lowest first; arrows stop short of markers. What is about `lit` has a glow, too.
pub fn pieces<'a>(
    viewport: &Viewport,
    theme: &Theme,
    marks: &'a [Mark],
    lit: Option<Link>,
) -> Vec<LayeredPart<'a>> {
    let is_flat = !marks
        .iter()
        .any(|mark| matches!(mark.shape, Shape::Solids(_)));
    let mut pieces = Vec::new();
    for mark in marks {
        let is_lit = lit.is_some() && mark.link == lit;
        for part in parts(viewport, &mark.shape) {
            pieces.extend(is_lit.then(|| LayeredPart {
                layer: Layer::Glow,
                mark,
                part: part.clone(),
            }));
            pieces.extend(
                (mark.is_cased && part.line().is_some()).then(|| LayeredPart {
                    layer: Layer::Casing,
                    mark,
                    part: part.clone(),
                }),
            );
            pieces.push(LayeredPart {
                layer: match layer_of(&part, mark.role) {
                    Layer::Construction if is_flat => Layer::Extension,
                    layer => layer,
                },
                mark,
                part,
            });
        }
    }
    stop_short(theme, &mut pieces);
    pieces.sort_by_key(|piece| piece.layer);
    pieces
}

const fn layer_of(part: &Part<'_>, role: Role) -> Layer {
    match part {
        Part::Wash(_) => Layer::Wash,
        Part::Fill(_) | Part::Solids(_) | Part::Texture(_) => Layer::Area,
        Part::Stroke(_) | Part::Ring(_) if matches!(role, Role::Faint) => Layer::Construction,
        Part::Crowd(_) | Part::Stroke(_) | Part::Ring(_) => Layer::Stroke,
        Part::Arrow(_) | Part::Head(_) => Layer::Head,
        Part::Marker(..) => Layer::Marker,
    }
}

fn stop_short(theme: &Theme, pieces: &mut [LayeredPart<'_>]) {
    let room = |piece: &LayeredPart<'_>| {
        let Part::Marker(marker, at) = piece.part else {
            return None;
        };
        Some((at, radius(theme, marker, piece.mark)))
    };
    let markers: Vec<(Pos2, f32)> = pieces.iter().filter_map(room).collect();
    for piece in pieces {
        let Part::Arrow([from, tip]) = &mut piece.part else {
            continue;
        };
        let met = markers
            .iter()
            .filter(|(at, _)| at.distance(*tip) <= AT_MARKER);
        let room = met.map(|(_, radius)| radius + GAP).fold(0.0, f32::max);
        let along = *tip - *from;
        let short = along.normalized() * room.min(0.5 * along.length());
        *tip -= vec2(short.x, short.y);
    }
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;
    use crate::paint::ThemeKind;

    #[test]
    fn markers_lie_over_strokes_and_arrows_stop_short_of_them() {
        let marks = [
            Mark::new(Role::Ink, Shape::Ring([5.0, 0.0])),
            Mark::new(Role::Signal, Shape::Arrow([[0.0, 0.0], [5.0, 0.0]])),
            Mark::new(Role::Ink, Shape::Segment([[5.0, 0.0], [5.0, 5.0]])),
            Mark::new(Role::Signal, Shape::HalfPlane([[0.0, 0.0], [1.0, 0.0]])),
        ];
        let theme = Theme::of(ThemeKind::Light);
        let pieces = pieces(&Viewport::SQUARE, theme, &marks, None);
        let layers: Vec<Layer> = pieces.iter().map(|piece| piece.layer).collect();
        let lines = [Layer::Wash, Layer::Stroke, Layer::Stroke];
        assert_eq!(layers, [&lines[..], &[Layer::Head, Layer::Marker]].concat());
        let Part::Arrow([from, tip]) = pieces[3].part else {
            panic!("the arrow is the head's layer");
        };
        assert_eq!(from, pos2(100.0, 100.0));
        assert_eq!(tip, pos2(150.0 - 6.5 - GAP, 100.0));
    }
}
