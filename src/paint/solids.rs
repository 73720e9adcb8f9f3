//! Solids in flat tones: each facet in one of three of its role, by how it is turned to a light fixed to the world. Drawn
//! at twice the pixels of the screen and averaged, and kept until something changes.

use std::sync::Arc;

use egui::{
    Color32, ColorImage, Context, Id, Mesh, Rect, Shape, TextureHandle, TextureOptions, Vec2, pos2,
};
use glam::DVec3;

use crate::figure::{Edging, Link, Role, SolidPicture, SolidScreen, Solids};

use super::{
    Theme, ThemeKind, Viewport,
    pen::stroke_colour,
    solid_outlines::Lined,
    solid_samples::{Band, FINE, Samples},
};

/// Where light comes from: from the left, from above, and from before.
const LIGHT: DVec3 = DVec3::new(-0.35, 0.8, 0.48);
/// Cosines of the angle to it: what is turned to it more than the first is lit, more than the second half.
const LIT: [f64; 2] = [0.62, 0.15];

const STANDS_OUT: f32 = 0.28;
/// While the eye turns, more facets than this are drawn coarsely.
const MANY: usize = 20_000;

#[derive(Clone)]
struct Asked {
    solids: Solids,
    place: Place,
    theme: Theme,
    lit: Option<Link>,
}

#[derive(Clone)]
struct Drawn {
    asked: Asked,
    is_fine: bool,
    frame: u64,
    surface: Surface,
    found: Found,
    /// Whole pixels of the screen: what is seen, and nothing of the clear glass around it.
    rect: Rect,
    texture: TextureHandle,
}

/// What was found of very many facets and stays, however they look: their triangles on the screen, or which are seen where all
/// of them are there.
#[derive(Clone, Default)]
struct Found {
    screen: Option<Arc<SolidScreen>>,
    bands: Arc<[Band]>,
}

/// What does not depend on where solids are seen from.
#[derive(Clone)]
struct Surface {
    /// Of which facets lines are found between the samples, if of any.
    outlined: Option<Arc<[bool]>>,
    tones: Arc<[Color32]>,
    are_dashed: Arc<[bool]>,
}

/// Where a picture stands: whole pixels of the screen, and the part of the lens's picture that is seen there.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Place {
    rect: Rect,
    size: [u32; 2],
    part: [[f64; 2]; 2],
}

type Kept = Vec<Drawn>;

pub fn solids(
    ctx: &Context,
    theme: &Theme,
    viewport: &Viewport,
    solids: &Solids,
    lit: Option<Link>,
) -> Shape {
    let Some(place) = Place::of(viewport, ctx.pixels_per_point()) else {
        return Shape::Noop;
    };
    let id = Id::unique("solids");
    let mut kept: Kept = ctx.data(|data| data.get_temp(id)).unwrap_or_default();
    let frame = ctx.cumulative_frame_nr();
    // What has not been asked for since the last frame is not on the screen any more.
    kept.retain(|drawn| drawn.frame + 1 >= frame);
    let mut places = kept.iter().map(|it| it.asked.place.rect);
    let found = places.position(|rect| rect == place.rect);
    let before = found.map(|found| kept.swap_remove(found));
    let is_moving = ctx.input(|input| input.pointer.any_down());
    let asked = Asked {
        solids: solids.clone(),
        place,
        theme: theme.clone(),
        lit,
    };
    let mut drawn = match before {
        Some(drawn) if asked.is_seen_in(&drawn) && (drawn.is_fine || is_moving) => drawn,
        before => Drawn::new(ctx, asked, is_moving, before),
    };
    drawn.frame = frame;
    if !drawn.is_fine {
        ctx.request_repaint();
    }
    let shape = drawn.shape();
    kept.push(drawn);
    ctx.data_mut(|data| data.insert_temp(id, kept));
    shape
}

impl Place {
    fn of(viewport: &Viewport, pixels_per_point: f32) -> Option<Self> {
        let rect = viewport.rect;
        let min = (rect.min.to_vec2() * pixels_per_point).floor();
        let max = (rect.max.to_vec2() * pixels_per_point).ceil();
        let size = [max.x - min.x, max.y - min.y];
        let is_usable = |side: &f32| (1.0..=SolidScreen::MAX_SIDE as f32).contains(side);
        let at = |corner: Vec2| (corner / pixels_per_point).to_pos2();
        let rect = Rect::from_min_max(at(min), at(max));
        let [low, high] = [rect.left_bottom(), rect.right_top()];
        size.iter().all(is_usable).then(|| Self {
            rect,
            size: size.map(|side| side as u32),
            part: [viewport.to_world(low), viewport.to_world(high)],
        })
    }

    /// The part of its picture that shows anything, at least one pixel, and where that stands.
    fn without_clear_edges(&self, image: &ColorImage) -> (Rect, ColorImage) {
        let width = image.width();
        let is_seen = |pixel: &Color32| *pixel != Color32::TRANSPARENT;
        let mut columns = width..0;
        let mut rows = image.height()..0;
        for (y, row) in image.pixels.chunks(width).enumerate() {
            let Some(first) = row.iter().position(is_seen) else {
                continue;
            };
            let end = row.iter().rposition(is_seen).map_or(first, |last| last + 1);
            columns = columns.start.min(first)..columns.end.max(end);
            rows = rows.start.min(y)..y + 1;
        }
        if columns.is_empty() {
            (columns, rows) = (0..1, 0..1);
        }
        let pixel = self.rect.size() / Vec2::from(self.size.map(|side| side as f32));
        let at = |x: usize, y: usize| self.rect.min + pixel * Vec2::from([x as f32, y as f32]);
        let rect = Rect::from_min_max(at(columns.start, rows.start), at(columns.end, rows.end));
        let [from, size] = [[columns.start, rows.start], [columns.len(), rows.len()]];
        (rect, image.region_by_pixels(from, size))
    }
}

impl Asked {
    fn has_surface_of(&self, drawn: &Drawn) -> bool {
        let drawn = &drawn.asked;
        self.solids.facets.are_shared_with(&drawn.solids.facets)
            && self.theme.kind == drawn.theme.kind
    }

    fn has_tones_of(&self, drawn: &Drawn) -> bool {
        let facets = &self.solids.facets;
        let lit = [self.lit, drawn.asked.lit].map(|lit| lit.filter(|&lit| facets.are_about(lit)));
        lit[0] == lit[1] && self.theme == drawn.asked.theme && *facets == drawn.asked.solids.facets
    }

    fn is_seen_in(&self, drawn: &Drawn) -> bool {
        self.has_surface_of(drawn) && self.has_tones_of(drawn) && self.stands_as(drawn)
    }

    fn stands_as(&self, drawn: &Drawn) -> bool {
        let drawn = &drawn.asked;
        self.place == drawn.place && self.solids.lens == drawn.solids.lens
    }

    fn are_dashed(&self) -> Arc<[bool]> {
        let facets = &self.solids.facets;
        let is_dashed = |idx| facets.role(idx) == Some(Role::Discarded);
        (0..facets.len()).map(is_dashed).collect()
    }

    fn tones(&self) -> Arc<[Color32]> {
        let (theme, light) = (&self.theme, LIGHT.normalize());
        let facets = &self.solids.facets;
        let colour = |(role, darkness, is_lit)| {
            let tone = tone(theme, role, darkness);
            if is_lit {
                tone.lerp_to_gamma(theme.accent, STANDS_OUT)
            } else {
                tone
            }
        };
        // Neighbours have few tones.
        let mut known: Vec<((Role, usize, bool), Color32)> = Vec::new();
        let tone = |(idx, normal): (usize, &[f32; 3])| {
            let facet = &facets[idx];
            let cosine = DVec3::from(normal.map(f64::from)).dot(light);
            let darkness = LIT.iter().filter(|least| cosine <= **least).count();
            let role = facets.role(idx).unwrap_or(facet.role);
            let key = (role, darkness, self.lit.is_some() && facet.link == self.lit);
            if let Some(&(_, tone)) = known.iter().find(|(of, _)| *of == key) {
                return tone;
            }
            let tone = colour(key);
            known.push((key, tone));
            tone
        };
        facets.mesh().normals.iter().enumerate().map(tone).collect()
    }

    fn image(&self, surface: &Surface, is_fine: bool, found: &mut Found) -> ColorImage {
        let size = self.place.size;
        let has_room = |side: &u32| FINE as u32 * side <= SolidScreen::MAX_SIDE;
        let is_doubled = is_fine && size.iter().all(has_room);
        let fine = if is_doubled { FINE as u32 } else { 1 };
        let mut pixels = vec![Color32::TRANSPARENT; (size[0] * size[1]) as usize];
        let ink = self.theme.ink;
        let facets = &self.solids.facets;
        let lined = |are_found| Lined {
            normals: &facets.mesh().normals,
            are_found,
            are_dashed: &surface.are_dashed,
        };
        let outlined = surface.outlined.as_deref();
        let samples = Samples {
            tones: &surface.tones,
            outline: outlined.map(|are_found| (ink, lined(are_found))),
            size,
            fine,
        };
        if found.bands.is_empty() {
            let screen = found.screen.take();
            let screen = screen.or_else(|| self.screen(size.map(|side| side * fine)));
            if let Some(screen) = screen {
                let picture = SolidPicture::new(facets.mesh(), &screen).looking(facets);
                let bands = samples.draw(&picture, &mut pixels);
                if facets.are_all_shown() {
                    found.bands = bands.into();
                } else if facets.len() > MANY {
                    found.screen = Some(screen);
                }
            }
        } else {
            samples.draw_again(&found.bands, &mut pixels);
        }
        ColorImage::new(size.map(|side| side as usize), pixels)
    }

    fn screen(&self, samples: [u32; 2]) -> Option<Arc<SolidScreen>> {
        let Solids { facets, lens } = &self.solids;
        let screen = SolidScreen::new(facets.mesh(), lens, self.place.part, samples);
        screen.map(Arc::new)
    }
}

impl Drawn {
    fn new(ctx: &Context, asked: Asked, is_moving: bool, before: Option<Self>) -> Self {
        let is_fine = !(is_moving && asked.solids.facets.len() > MANY);
        let known = before.as_ref().filter(|drawn| asked.has_surface_of(drawn));
        let surface = match known {
            Some(drawn) if asked.has_tones_of(drawn) => drawn.surface.clone(),
            Some(drawn) => Surface {
                tones: asked.tones(),
                are_dashed: asked.are_dashed(),
                ..drawn.surface.clone()
            },
            None => Surface::of(&asked),
        };
        let found = known.filter(|drawn| drawn.is_fine == is_fine && asked.stands_as(drawn));
        let mut found = found.map(|drawn| drawn.found.clone()).unwrap_or_default();
        if !asked.solids.facets.are_all_shown() {
            found.bands = Arc::default();
        }
        let image = asked.image(&surface, is_fine, &mut found);
        let (rect, image) = asked.place.without_clear_edges(&image);
        let options = TextureOptions::LINEAR;
        let texture = match before.map(|drawn| drawn.texture) {
            Some(mut texture) => {
                texture.set(image, options);
                texture
            }
            None => ctx.load_texture("solids", image, options),
        };
        Self {
            asked,
            is_fine,
            frame: 0,
            surface,
            found,
            rect,
            texture,
        }
    }

    fn shape(&self) -> Shape {
        let mut mesh = Mesh::with_texture(self.texture.id());
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        mesh.add_rect_with_uv(self.rect, whole, Color32::WHITE);
        Shape::mesh(mesh)
    }
}

impl Surface {
    fn of(asked: &Asked) -> Self {
        let facets = &asked.solids.facets;
        let outlined = facets.iter().map(|facet| facet.edging != Edging::Lines);
        let outlined: Arc<[bool]> = outlined.collect();
        Self {
            outlined: outlined.contains(&true).then_some(outlined),
            tones: asked.tones(),
            are_dashed: asked.are_dashed(),
        }
    }
}

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
