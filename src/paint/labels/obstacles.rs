//! What labels keep off: every stroke, head and marker.

use egui::{Pos2, Rect};

use crate::{
    figure::Role,
    paint::{
        Theme, Viewport,
        cut::length_in,
        layers::{Layer, LayeredPart},
        parts::{HEAD, Part},
        pen::{Pen, radius},
    },
};

use super::{anchor::edges_of, places::corners};

const MOST: usize = 2_000;
/// An outline of more points than this leaves no room beside it to look for.
const MOST_OF_AN_OUTLINE: usize = 500;
const MOST_FACETS: usize = 1_500;
/// A crowd of more segments than this is a texture behind the figure.
const MOST_OF_A_CROWD: usize = 50;
const QUIET: f32 = 0.6;
const CLEAR: f32 = 4.0;

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Obstacle {
    Stroke([Pos2; 2], f32),
    Disc(Pos2, f32),
    /// A triangle of a texture: no ground for text.
    Picture([Pos2; 3]),
    /// A triangle of the camera's face, which is as dark as text.
    Dark([Pos2; 3]),
    /// A triangle of a solid's face: what is said of the solid stands beside it.
    Surface([Pos2; 3]),
}

impl Obstacle {
    pub fn covers(&self, rect: Rect) -> bool {
        match *self {
            Self::Stroke(ends, half) => length_in(ends, rect.expand(half)) > 0.0,
            Self::Disc(at, radius) => rect.distance_to_pos(at) < radius,
            Self::Picture(corners) | Self::Dark(corners) | Self::Surface(corners) => {
                meets(corners, rect)
            }
        }
    }

    /// How bad it is to stand here, in points of distance that a label would rather go.
    pub(super) fn cost(&self, rect: Rect) -> f32 {
        match *self {
            Self::Stroke(ends, half) => {
                if length_in(ends, rect.expand(half + CLEAR)) == 0.0 {
                    return 0.0;
                }
                match length_in(ends, rect.expand(half)) {
                    0.0 => 8.0,
                    within => 80.0 + 2.0 * within,
                }
            }
            Self::Disc(at, radius) => match rect.distance_to_pos(at) - radius {
                ..0.0 => 250.0,
                ..CLEAR => 8.0,
                _ => 0.0,
            },
            Self::Picture(corners) if meets(corners, rect) => 45.0,
            Self::Dark(corners) | Self::Surface(corners) if meets(corners, rect) => 30.0,
            Self::Picture(_) | Self::Dark(_) | Self::Surface(_) => 0.0,
        }
    }

    pub(super) const fn is_picture(&self) -> bool {
        matches!(self, Self::Picture(_) | Self::Dark(_))
    }

    pub(super) const fn is_surface(&self) -> bool {
        matches!(self, Self::Surface(_))
    }

    pub(super) fn bounds(&self) -> Rect {
        match *self {
            Self::Stroke([a, b], half) => Rect::from_two_pos(a, b).expand(half),
            Self::Disc(at, radius) => Rect::from_center_size(at, egui::Vec2::splat(2.0 * radius)),
            Self::Picture(corners) | Self::Dark(corners) | Self::Surface(corners) => {
                Rect::from_points(&corners)
            }
        }
    }
}

pub fn obstacles(viewport: &Viewport, theme: &Theme, pieces: &[LayeredPart<'_>]) -> Vec<Obstacle> {
    let is_drawn = |piece: &&LayeredPart| !matches!(piece.layer, Layer::Glow | Layer::Casing);
    let all = pieces.iter().filter(is_drawn);
    let all = all.flat_map(|piece| of_piece(viewport, theme, piece));
    let all = all.filter(|obstacle| obstacle.bounds().intersects(viewport.rect));
    let (surfaces, mut others): (Vec<_>, Vec<_>) = all.partition(Obstacle::is_surface);
    others.truncate(MOST);
    others.extend(surfaces);
    others
}

fn of_piece(viewport: &Viewport, theme: &Theme, piece: &LayeredPart<'_>) -> Vec<Obstacle> {
    let LayeredPart { mark, part, .. } = piece;
    let half = 0.5 * Pen::of(theme, mark).stroke.width;
    // What may be missed may be written over.
    let is_quiet = mark.weight.is_some_and(|weight| weight.strength < QUIET);
    let strokes = match part {
        Part::Stroke(_) | Part::Ring(_) if is_quiet => vec![],
        Part::Stroke(points) | Part::Ring(points) if points.len() > MOST_OF_AN_OUTLINE => vec![],
        _ => edges_of(part),
    };
    let strokes = strokes.into_iter();
    let mut obstacles: Vec<Obstacle> = strokes.map(|ends| Obstacle::Stroke(ends, half)).collect();
    match part {
        Part::Arrow([from, tip]) | Part::Head([from, tip]) => {
            let middle = *tip - (*tip - *from).normalized() * 0.5 * HEAD * theme.stroke_scale;
            obstacles.push(Obstacle::Disc(middle, 0.5 * HEAD * theme.stroke_scale));
        }
        Part::Marker(marker, at) => {
            obstacles.push(Obstacle::Disc(*at, radius(theme, *marker, mark)));
        }
        Part::Crowd(segments) if segments.len() <= MOST_OF_A_CROWD => {
            let half = 0.5 * Pen::of_crowd(theme, mark, segments.len()).stroke.width;
            let on_screen = |ends: &[[f64; 2]; 2]| ends.map(|p| viewport.to_screen(p));
            let stroke = |ends| Obstacle::Stroke(on_screen(ends), half);
            obstacles.extend(segments.iter().map(stroke));
        }
        Part::Texture(triangles) => {
            let corners = triangles.iter().take(MOST_OF_A_CROWD);
            let on_screen = corners.map(|corners| corners.map(|(at, _)| viewport.to_screen(at)));
            obstacles.extend(on_screen.map(Obstacle::Picture));
        }
        Part::Solids(solids) if solids.facets.len() <= MOST_FACETS => {
            for (role, outline) in solids.faces() {
                let corners = viewport.all_to_screen(&outline);
                let fan = corners.windows(2).skip(1);
                let fan = fan.map(|pair| [corners[0], pair[0], pair[1]]);
                let is_dark = role == Role::Ink;
                let face = if is_dark {
                    Obstacle::Dark
                } else {
                    Obstacle::Surface
                };
                obstacles.extend(fan.map(face));
            }
        }
        _ => {}
    }
    obstacles
}

/// Have a triangle and a rectangle something in common? None of the sides of either parts them.
fn meets([a, b, c]: [Pos2; 3], rect: Rect) -> bool {
    let turn = (b - a).rot90().dot(c - a).signum();
    let is_parted = |[p, q]: [Pos2; 2]| {
        let is_beyond = |at: &Pos2| turn * (q - p).rot90().dot(*at - p) <= 0.0;
        corners(rect).iter().all(is_beyond)
    };
    Rect::from_points(&[a, b, c]).intersects(rect)
        && ![[a, b], [b, c], [c, a]].map(is_parted).contains(&true)
}
