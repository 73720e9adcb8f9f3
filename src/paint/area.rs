//! Areas of any shape, filled: concave, with holes, crossing themselves.

use egui::{Color32, Mesh, Pos2, Shape};
use lyon_tessellation::{
    BuffersBuilder, FillOptions, FillTessellator, FillVertex, FillVertexConstructor, VertexBuffers,
    math::point,
    path::{FillRule, Path},
};

/// Coarser than a pixel's tenth nobody sees.
const TOLERANCE_PTS: f32 = 0.1;

/// Everything that an odd number of `outlines` goes round. Soft edges are left to the stroke over them.
pub fn filled(outlines: &[Vec<Pos2>], colour: Color32) -> Shape {
    let outlines = outlines.iter().map(|outline| outline.iter().copied());
    triangles(outlines).mesh(colour, |at| at)
}

/// Where the inside is, as triangles.
#[derive(Default)]
pub(super) struct Triangles(VertexBuffers<Pos2, u32>);

impl Triangles {
    /// With the corners at `place` of where they are.
    pub(super) fn mesh(&self, colour: Color32, place: impl Fn(Pos2) -> Pos2) -> Shape {
        let Self(buffers) = self;
        if buffers.indices.is_empty() {
            return Shape::Noop;
        }
        let mut mesh = Mesh::default();
        mesh.reserve_vertices(buffers.vertices.len());
        for &at in &buffers.vertices {
            mesh.colored_vertex(place(at), colour);
        }
        mesh.indices.clone_from(&buffers.indices);
        Shape::mesh(mesh)
    }
}

/// None where nothing can be filled: a stroke is drawn all the same.
pub(super) fn triangles<O: Iterator<Item = Pos2>>(
    outlines: impl IntoIterator<Item = O>,
) -> Triangles {
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
    let mut buffers = VertexBuffers::<Pos2, u32>::new();
    let options = FillOptions::tolerance(TOLERANCE_PTS).with_fill_rule(FillRule::EvenOdd);
    let done = FillTessellator::new().tessellate_path(
        &path.build(),
        &options,
        &mut BuffersBuilder::new(&mut buffers, Position),
    );
    done.map_or_else(|_| Triangles::default(), |()| Triangles(buffers))
}

struct Position;

impl FillVertexConstructor<Pos2> for Position {
    fn new_vertex(&mut self, vertex: FillVertex<'_>) -> Pos2 {
        let at = vertex.position();
        Pos2::new(at.x, at.y)
    }
}

#[cfg(test)]
mod tests {
    use egui::pos2;

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
            vec![
                pos2(x, x),
                pos2(x + side, x),
                pos2(x + side, x + side),
                pos2(x, x + side),
            ]
        };
        let ring = filled(&[square(0.0, 10.0), square(2.0, 5.0)], Color32::RED);
        assert!((area(&ring) - 75.0).abs() < 1e-3, "{}", area(&ring));
        let tie = [
            pos2(0.0, 0.0),
            pos2(4.0, 4.0),
            pos2(4.0, 0.0),
            pos2(0.0, 4.0),
        ];
        let tie = filled(&[tie.to_vec()], Color32::RED);
        assert!((area(&tie) - 8.0).abs() < 1e-3, "{}", area(&tie));
    }

    #[test]
    fn nothing_is_made_of_nothing() {
        for outlines in [vec![], vec![vec![]], vec![vec![pos2(f32::NAN, 0.0)]]] {
            assert_eq!(area(&filled(&outlines, Color32::RED)), 0.0);
        }
    }
}
