//! The texture that shows whether texture coordinates are right: a turn, a mirror image and a stretch can all be told.

use egui::{Color32, ColorImage, Context, Id, Mesh, Shape, TextureHandle, TextureOptions, lerp};

use crate::figure::Texel;

use super::{Theme, Viewport};

const SQUARES: usize = 8;
const SIDE: usize = 256;

pub fn textured(
    ctx: &Context,
    theme: &Theme,
    viewport: &Viewport,
    triangles: &[[Texel; 3]],
) -> Shape {
    let mut mesh = Mesh::with_texture(board(ctx, theme).id());
    for corners in triangles {
        let first = mesh.vertices.len() as u32;
        for &(at, [u, v]) in corners {
            mesh.vertices.push(egui::epaint::Vertex {
                pos: viewport.to_screen(at),
                // v grows upwards, rows of an image downwards.
                uv: egui::pos2(u as f32, 1.0 - v as f32),
                color: Color32::WHITE,
            });
        }
        mesh.add_triangle(first, first + 1, first + 2);
    }
    Shape::mesh(mesh)
}

fn board(ctx: &Context, theme: &Theme) -> TextureHandle {
    let id = Id::unique(("checker", theme.accent.to_array()));
    if let Some(handle) = ctx.data(|data| data.get_temp::<TextureHandle>(id)) {
        return handle;
    }
    let image = picture(theme.background, theme.accent);
    let handle = ctx.load_texture("checker", image, TextureOptions::LINEAR);
    ctx.data_mut(|data| data.insert_temp(id, handle.clone()));
    handle
}

/// Squares in two strengths of one hue, stronger towards u = 1, v = 1.
fn picture(light: Color32, hue: Color32) -> ColorImage {
    let texel = |i: usize| {
        let (x, y) = (i % SIDE, i / SIDE);
        let (u, v) = (x as f32 / SIDE as f32, 1.0 - y as f32 / SIDE as f32);
        let is_dark = (x * SQUARES / SIDE + y * SQUARES / SIDE).is_multiple_of(2);
        let strength = lerp(0.15..=0.5, 0.5 * (u + v)) + if is_dark { 0.25 } else { 0.0 };
        light.lerp_to_gamma(hue, strength)
    };
    let pixels = (0..SIDE * SIDE).map(texel).collect();
    ColorImage::new([SIDE, SIDE], pixels)
}
