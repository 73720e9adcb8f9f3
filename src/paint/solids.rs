//! Solids, in flat tones: each facet in one of three of its role, by how it is turned to a light that is fixed to the
//! world. Drawn at twice the pixels of the screen in both directions and averaged, and kept until something changes.

use std::sync::Arc;

use egui::{
    Color32, ColorImage, Context, Id, Mesh, Rect, Shape, TextureHandle, TextureOptions, Vec2, pos2,
};

use crate::figure::{Facet, Link, SolidMesh, SolidPicture, Solids};

use super::{
    Theme, Viewport,
    solid_samples::{FINE, Samples},
    solid_tones::tones,
};

/// While the eye turns, more facets than this are drawn coarsely.
const MANY: usize = 20_000;

/// What a picture is asked for.
struct Asked<'a> {
    solids: &'a Solids,
    place: Place,
    theme: &'a Theme,
    lit: Option<Link>,
}

/// A picture of solids, and what it was drawn for.
#[derive(Clone)]
struct Drawn {
    solids: Solids,
    place: Place,
    theme: &'static str,
    lit: Option<Link>,
    is_fine: bool,
    /// In which frame it was last asked for.
    frame: u64,
    surface: Surface,
    texture: TextureHandle,
}

/// What does not depend on where solids are seen from.
#[derive(Clone)]
struct Surface {
    mesh: Arc<SolidMesh>,
    /// Of facets: of length 1.
    normals: Arc<[[f32; 3]]>,
    tones: Arc<[Color32]>,
}

/// Where a picture stands: whole pixels of the screen, and the part of the lens's picture that is seen there.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Place {
    rect: Rect,
    size: [u32; 2],
    part: [[f64; 2]; 2],
}

/// All pictures of a context.
#[derive(Clone, Default)]
struct Kept(Vec<Drawn>);

/// What is seen of solids, where it was not yet, drawn; what is about `lit` stands out.
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
    kept.0.retain(|drawn| drawn.frame + 1 >= frame);
    let found = kept.0.iter().position(|it| it.place.rect == place.rect);
    let before = found.map(|found| kept.0.swap_remove(found));
    let is_moving = ctx.input(|input| input.pointer.any_down());
    let is_lit = |lit: &Link| solids.facets.iter().any(|facet| facet.link == Some(*lit));
    let asked = Asked {
        solids,
        place,
        theme,
        lit: lit.filter(is_lit),
    };
    let mut drawn = match before {
        Some(drawn) if drawn.is_of(&asked) && (drawn.is_fine || is_moving) => drawn,
        before => Drawn::new(ctx, &asked, is_moving, before),
    };
    drawn.frame = frame;
    if !drawn.is_fine {
        ctx.request_repaint();
    }
    let shape = drawn.shape();
    kept.0.push(drawn);
    ctx.data_mut(|data| data.insert_temp(id, kept));
    shape
}

impl Place {
    fn of(viewport: &Viewport, pixels_per_point: f32) -> Option<Self> {
        let rect = viewport.rect;
        let min = (rect.min.to_vec2() * pixels_per_point).floor();
        let max = (rect.max.to_vec2() * pixels_per_point).ceil();
        let size = [max.x - min.x, max.y - min.y];
        let is_usable = |side: &f32| (1.0..=SolidPicture::MAX_SIDE as f32).contains(side);
        let at = |corner: Vec2| (corner / pixels_per_point).to_pos2();
        let rect = Rect::from_min_max(at(min), at(max));
        let [low, high] = [rect.left_bottom(), rect.right_top()];
        size.iter().all(is_usable).then(|| Self {
            rect,
            size: size.map(|side| side as u32),
            part: [viewport.to_world(low), viewport.to_world(high)],
        })
    }
}

impl Drawn {
    fn new(ctx: &Context, asked: &Asked<'_>, is_moving: bool, before: Option<Self>) -> Self {
        let &Asked {
            solids,
            place,
            theme,
            lit,
        } = asked;
        let has_room = |side: &u32| FINE as u32 * side <= SolidPicture::MAX_SIDE;
        let is_fine = !(is_moving && solids.facets.len() > MANY);
        let known = before.as_ref().filter(|drawn| drawn.has_surface(asked));
        let mut surface = match known {
            Some(drawn) => drawn.surface.clone(),
            None => Surface::of(&solids.facets, theme, lit),
        };
        if known.is_some_and(|drawn| drawn.lit != lit) {
            surface.tones = tones(theme, &solids.facets, &surface.normals, lit).into();
        }
        let fine = if is_fine && place.size.iter().all(has_room) {
            FINE as u32
        } else {
            1
        };
        let image = image(&surface, solids, place, fine, theme);
        let options = TextureOptions::LINEAR;
        let texture = match before.map(|drawn| drawn.texture) {
            Some(mut texture) => {
                texture.set(image, options);
                texture
            }
            None => ctx.load_texture("solids", image, options),
        };
        Self {
            solids: solids.clone(),
            place,
            theme: theme.kind.id(),
            lit,
            is_fine,
            frame: 0,
            surface,
            texture,
        }
    }

    fn has_surface(&self, asked: &Asked<'_>) -> bool {
        Arc::ptr_eq(&self.solids.facets, &asked.solids.facets)
            && self.theme == asked.theme.kind.id()
    }

    fn is_of(&self, asked: &Asked<'_>) -> bool {
        self.has_surface(asked)
            && self.place == asked.place
            && self.lit == asked.lit
            && self.solids.lens == asked.solids.lens
    }

    /// Texel on pixel.
    fn shape(&self) -> Shape {
        let mut mesh = Mesh::with_texture(self.texture.id());
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        mesh.add_rect_with_uv(self.place.rect, whole, Color32::WHITE);
        Shape::mesh(mesh)
    }
}

impl Surface {
    fn of(facets: &[Facet], theme: &Theme, lit: Option<Link>) -> Self {
        let normal = |facet: &Facet| facet.normal().as_vec3().to_array();
        let normals: Arc<[[f32; 3]]> = facets.iter().map(normal).collect();
        Self {
            mesh: Arc::new(SolidMesh::of(facets)),
            tones: tones(theme, facets, &normals, lit).into(),
            normals,
        }
    }
}

/// With `fine` samples for a pixel in both directions.
fn image(surface: &Surface, solids: &Solids, place: Place, fine: u32, theme: &Theme) -> ColorImage {
    let [width, height] = place.size;
    let mut pixels = vec![Color32::TRANSPARENT; (width * height) as usize];
    let size = place.size.map(|side| side * fine);
    let picture = SolidPicture::new(&surface.mesh, &solids.lens, place.part, size);
    if let Some(picture) = picture {
        let samples = Samples {
            picture: &picture,
            tones: &surface.tones,
            outline: solids
                .is_outlined
                .then_some((theme.ink, &surface.normals[..])),
            size: place.size,
            fine,
        };
        samples.draw(&mut pixels);
    }
    ColorImage::new([width as usize, height as usize], pixels)
}
