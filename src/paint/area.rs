//! Areas of any shape, filled: concave, with holes, crossing themselves.
//!
//! Large ones are cut into triangles once, in units of their own box, so that panning and zooming need no new ones. While
//! something is dragged only the outline is drawn.

use std::sync::Arc;

use egui::{Color32, Context, Id, Mesh, Pos2, Shape, pos2};
use lyon_tessellation::{
    BuffersBuilder, FillOptions, FillTessellator, FillVertex, VertexBuffers,
    math::point,
    path::{FillRule, Path},
};

use crate::geom::{Point, extent};

use super::Viewport;

/// Coarser than a pixel's tenth nobody sees.
const TOLERANCE_PTS: f32 = 0.1;
pub const LARGE: usize = 1_000;
/// The box's half extent in the units that the triangles are kept in: f32 is exact to a ten-thousandth of one.
const HALF: f64 = 1_000.0;
/// Areas kept: two columns with a subject and a result each, and what was shown a step before.
const MOST_KEPT: usize = 8;

type Triangles = VertexBuffers<Pos2, u32>;

/// Everything that an odd number of `outlines` goes round. Soft edges are left to the stroke over them.
pub fn filled(outlines: &[Vec<Pos2>], colour: Color32) -> Shape {
    let outlines = outlines.iter().map(|outline| outline.iter().copied());
    mesh(&triangles(outlines), colour, |at| at)
}

fn mesh(triangles: &Triangles, colour: Color32, place: impl Fn(Pos2) -> Pos2) -> Shape {
    if triangles.indices.is_empty() {
        return Shape::Noop;
    }
    let mut mesh = Mesh::default();
    mesh.reserve_vertices(triangles.vertices.len());
    for &at in &triangles.vertices {
        mesh.colored_vertex(place(at), colour);
    }
    mesh.indices.clone_from(&triangles.indices);
    Shape::mesh(mesh)
}

fn triangles<O: Iterator<Item = Pos2>>(outlines: impl IntoIterator<Item = O>) -> Triangles {
    let mut path = Path::builder();
    for outline in outlines {
        let mut points = outline.filter(|p| p.is_finite());
        let Some(first) = points.next() else { continue };
        path.begin(point(first.x, first.y));
        for p in points {
            path.line_to(point(p.x, p.y));
        }
        path.end(true);
    }
    let mut buffers = Triangles::new();
    let position = |vertex: FillVertex<'_>| Pos2::from(vertex.position().to_array());
    let options = FillOptions::tolerance(TOLERANCE_PTS).with_fill_rule(FillRule::EvenOdd);
    let done = FillTessellator::new().tessellate_path(
        &path.build(),
        &options,
        &mut BuffersBuilder::new(&mut buffers, position),
    );
    done.map_or_else(|_| Triangles::new(), |()| buffers)
}

type Kept = Vec<(u64, Arc<Triangles>)>;

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
    let found = kept.iter().position(|(known, _)| *known == hash);
    let area = match found {
        Some(i) => kept.remove(i),
        None if ctx.input(|input| input.pointer.any_down()) => return Shape::Noop,
        None => {
            let outlines = outlines.iter().map(|o| o.iter().map(|&p| unit.shrunk(p)));
            (hash, Arc::new(triangles(outlines)))
        }
    };
    let shape = mesh(&area.1, colour, |at| viewport.to_screen(unit.world(at)));
    // The least lately drawn comes first, and goes first.
    kept.push(area);
    let surplus = kept.len().saturating_sub(MOST_KEPT);
    kept.drain(..surplus);
    ctx.data_mut(|data| data.insert_temp(id, kept));
    shape
}

struct Unit {
    middle: [f64; 2],
    half: [f64; 2],
}

impl Unit {
    fn of(outlines: &[Vec<[f64; 2]>]) -> Option<Self> {
        let points = outlines.iter().flatten();
        let points = points.map(|&[x, y]| Point::new(x, y).ok());
        let points = points.collect::<Option<Vec<Point>>>()?;
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
    use egui::Rect;

    use super::*;

    fn area(shape: &Shape) -> f32 {
        let Shape::Mesh(mesh) = shape else {
            return 0.0;
        };
        let corner = |i: &u32| mesh.vertices[*i as usize].pos;
        mesh.indices
            .chunks_exact(3)
            .map(|t| {
                let [a, b, c] = [corner(&t[0]), corner(&t[1]), corner(&t[2])];
                0.5 * ((b - a).x * (c - a).y - (b - a).y * (c - a).x).abs()
            })
            .sum()
    }

    #[test]
    fn holes_stay_empty_and_a_bow_tie_has_two_wings() {
        let square = |x: f32, side: f32| {
            let end = x + side;
            vec![pos2(x, x), pos2(end, x), pos2(end, end), pos2(x, end)]
        };
        let ring = filled(&[square(0.0, 10.0), square(2.0, 5.0)], Color32::RED);
        assert!((area(&ring) - 75.0).abs() < 1e-3, "{}", area(&ring));
        let tie = [[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]].map(Pos2::from);
        let tie = filled(&[tie.to_vec()], Color32::RED);
        assert!((area(&tie) - 8.0).abs() < 1e-3, "{}", area(&tie));
    }

    #[test]
    fn an_area_is_cut_once_and_found_again() {
        let ctx = Context::default();
        let square = vec![vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]];
        let draw = |outlines: &[Vec<[f64; 2]>]| {
            filled_large(&ctx, &Viewport::SQUARE, outlines, Color32::RED)
        };
        let Shape::Mesh(mesh) = draw(&square) else {
            panic!("a square is filled");
        };
        let corners = mesh.vertices.iter().map(|v| v.pos);
        let bounds = Rect::from_points(&corners.collect::<Vec<_>>());
        let expected = Rect::from_min_max(pos2(100.0, 60.0), pos2(140.0, 100.0));
        assert_eq!(bounds, expected);
        let kept = || ctx.data(|data| data.get_temp::<Kept>(Id::unique("large areas")));
        let n_kept = || kept().unwrap().len();
        let _ = draw(&square);
        assert_eq!(n_kept(), 1);
        for i in 0..20 {
            let _ = draw(&[vec![[0.0, 0.0], [1.0, 0.0], [f64::from(i), 1.0]]]);
        }
        assert_eq!(n_kept(), MOST_KEPT);
    }

    #[test]
    fn nothing_is_made_of_nothing_and_numbers_that_cannot_be_drawn_are_not() {
        for outlines in [vec![], vec![vec![]], vec![vec![pos2(f32::NAN, 0.0)]]] {
            assert_eq!(area(&filled(&outlines, Color32::RED)), 0.0);
        }
        let ctx = Context::default();
        for outlines in [
            vec![],
            vec![vec![]],
            vec![vec![[f64::NAN, 0.0]; 3]],
            vec![vec![[1e308, -1e308], [-1e308, 1e308], [1e308, 1e308]]],
            vec![vec![[5.0, 5.0]; 3]],
        ] {
            let _ = filled_large(&ctx, &Viewport::SQUARE, &outlines, Color32::RED);
        }
    }
}
