//! Large areas, cut into triangles once and not in every frame.
//!
//! The triangles are kept in units of the area's own box, so that panning and zooming need no new ones. While
//! something is dragged the area is another one in every frame: then only its outline is drawn.

use std::sync::Arc;

use egui::{Color32, Context, Id, Pos2, Shape, pos2};

use crate::geom::{Point, extent};

use super::{
    Viewport,
    area::{Triangles, triangles},
};

/// Outlines with fewer vertices in all are cut into triangles in every frame.
pub const LARGE: usize = 1_000;
/// The box's half extent in the units that the triangles are kept in: f32 is exact to a ten-thousandth of one.
const HALF: f64 = 1_000.0;
/// Areas kept: two columns with a subject and a result each, and what was shown a step before.
const MOST_KEPT: usize = 8;

/// The areas drawn last, each under a hash of its coordinates.
#[derive(Clone, Default)]
struct Kept(Vec<(u64, Arc<Triangles>)>);

/// Everything that an odd number of `outlines` goes round, in world coordinates.
pub fn filled_large(
    ctx: &Context,
    viewport: &Viewport,
    outlines: &[Vec<[f64; 2]>],
    colour: Color32,
) -> Shape {
    let Some(unit) = Unit::of(outlines) else {
        return Shape::Noop;
    };
    let id = Id::unique("large areas");
    let hash = hash_of(outlines);
    let mut kept: Kept = ctx.data(|data| data.get_temp(id)).unwrap_or_default();
    let found = kept.0.iter().position(|(known, _)| *known == hash);
    let area = match found {
        Some(i) => kept.0.remove(i),
        None if ctx.input(|input| input.pointer.any_down()) => return Shape::Noop,
        None => {
            let outlines = outlines.iter().map(|o| o.iter().map(|&p| unit.shrunk(p)));
            (hash, Arc::new(triangles(outlines)))
        }
    };
    let shape = area.1.mesh(colour, |at| viewport.to_screen(unit.world(at)));
    // The least lately drawn comes first, and goes first.
    kept.0.push(area);
    let surplus = kept.0.len().saturating_sub(MOST_KEPT);
    kept.0.drain(..surplus);
    ctx.data_mut(|data| data.insert_temp(id, kept));
    shape
}

/// From the world to units of an area's box, and back.
struct Unit {
    middle: [f64; 2],
    half: [f64; 2],
}

impl Unit {
    /// None where there is no vertex, or no box that numbers can hold.
    fn of(outlines: &[Vec<[f64; 2]>]) -> Option<Self> {
        let points = outlines.iter().flatten();
        let points: Vec<Point> = points
            .map(|&[x, y]| Point::new(x, y))
            .collect::<Result<_, _>>()
            .ok()?;
        if points.is_empty() {
            return None;
        }
        let [min, max] = extent(points);
        let middle = [0, 1].map(|i| min[i].midpoint(max[i]));
        let half = [0, 1].map(|i| (0.5 * max[i] - 0.5 * min[i]).max(f64::MIN_POSITIVE));
        Some(Self { middle, half })
    }

    fn shrunk(&self, p: [f64; 2]) -> Pos2 {
        let [x, y] = [0, 1].map(|i| (p[i] - self.middle[i]) / self.half[i] * HALF);
        pos2(x as f32, y as f32)
    }

    fn world(&self, at: Pos2) -> [f64; 2] {
        let at = [f64::from(at.x), f64::from(at.y)];
        [0, 1].map(|i| self.middle[i] + at[i] / HALF * self.half[i])
    }
}

/// FNV-1a by words: outlines that differ anywhere differ here, but for one chance in 2⁶⁴.
fn hash_of(outlines: &[Vec<[f64; 2]>]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut take = |word: u64| {
        hash = (hash ^ word).wrapping_mul(0x0000_0100_0000_01b3);
        // The product alone carries nothing down from the upper bits.
        hash ^= hash >> 29;
    };
    for outline in outlines {
        take(outline.len() as u64);
        for c in outline.as_flattened() {
            take(c.to_bits());
        }
    }
    hash
}

#[cfg(test)]
mod tests {
    use egui::{Rect, vec2};

    use super::*;

    #[test]
    fn an_area_is_cut_once_and_found_again() {
        let ctx = Context::default();
        let viewport = Viewport {
            rect: Rect::from_min_size(Pos2::ZERO, vec2(200.0, 200.0)),
            centre: [0.0; 2],
            scale: 10.0,
        };
        let square = vec![vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]];
        let draw =
            |outlines: &[Vec<[f64; 2]>]| filled_large(&ctx, &viewport, outlines, Color32::RED);
        let Shape::Mesh(mesh) = draw(&square) else {
            panic!("a square is filled");
        };
        let corners = mesh.vertices.iter().map(|v| v.pos);
        let bounds = Rect::from_points(&corners.collect::<Vec<_>>());
        assert_eq!(
            (bounds.min, bounds.max),
            (pos2(100.0, 60.0), pos2(140.0, 100.0))
        );
        let n_kept = || {
            ctx.data(|data| {
                data.get_temp::<Kept>(Id::unique("large areas"))
                    .unwrap()
                    .0
                    .len()
            })
        };
        let _ = draw(&square);
        assert_eq!(n_kept(), 1);
        for i in 0..20 {
            let _ = draw(&[vec![[0.0, 0.0], [1.0, 0.0], [f64::from(i), 1.0]]]);
        }
        assert_eq!(n_kept(), MOST_KEPT);
    }

    #[test]
    fn numbers_that_cannot_be_drawn_are_not() {
        let ctx = Context::default();
        let viewport = Viewport {
            rect: Rect::from_min_size(Pos2::ZERO, vec2(200.0, 200.0)),
            centre: [0.0; 2],
            scale: 10.0,
        };
        for outlines in [
            vec![],
            vec![vec![]],
            vec![vec![[f64::NAN, 0.0]; 3]],
            vec![vec![[1e308, -1e308], [-1e308, 1e308], [1e308, 1e308]]],
            vec![vec![[5.0, 5.0]; 3]],
        ] {
            let _ = filled_large(&ctx, &viewport, &outlines, Color32::RED);
        }
    }
}
