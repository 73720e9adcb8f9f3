//! A figure's marks as egui shapes.

use egui::{Color32, Mesh, Painter, Pos2, Rect, Shape as Egui, Stroke, vec2};

use crate::figure::{Link, Mark, Shape};

use super::{
    Look, Theme, Viewport,
    area::{LARGE, filled, filled_large},
    checker::textured,
    labels::{Around, Labels, Obstacle, Placed},
    layers::{Layer, LayeredPart, pieces},
    line::{Line, crowd},
    notes,
    overlap::leave_out_covered,
    parts::{HEAD, Marker, Part},
    pen::{Pen, radius},
    solids::solids,
};

const CASING: f32 = 1.25;
const FADE_PTS: f32 = 14.0;
/// How strongly what is lit is filled.
const LIT: f32 = 0.2;

impl Look<'_> {
    /// Draws the marks, then their labels where they cover nothing: where they stand. What is about `lit` stands out.
    pub fn stage(
        self,
        painter: &Painter,
        viewport: &Viewport,
        marks: &[Mark],
        lit: Option<Link>,
        around: Around<'_>,
    ) -> Vec<Placed> {
        let painter = &painter.with_clip_rect(viewport.rect);
        let theme = self.theme;
        let stage = Stage {
            painter,
            viewport,
            theme,
            lit,
        };
        let pieces = drawn(viewport, theme, marks, lit);
        for layer in pieces.chunk_by(|a, b| a.layer == b.layer) {
            notes::group(painter, layer[0].layer.name(), || stage.layer(layer));
        }
        if around.fades {
            fade(painter, theme, viewport.rect);
        }
        let labels = Labels::new(painter, viewport, self, (marks, &pieces), around);
        notes::group(painter, "labels", || labels.draw(painter, self, lit));
        labels.placed
    }

    /// Where the labels of the marks would stand, and what they keep off.
    pub fn arrange(
        self,
        painter: &Painter,
        viewport: &Viewport,
        marks: &[Mark],
        around: Around<'_>,
    ) -> (Vec<Placed>, Vec<Obstacle>) {
        let pieces = drawn(viewport, self.theme, marks, None);
        let labels = Labels::new(painter, viewport, self, (marks, &pieces), around);
        (labels.placed, labels.obstacles)
    }
}

/// Lets the background come through along the edges of a drawing.
fn fade(painter: &Painter, theme: &Theme, rect: Rect) {
    let width = FADE_PTS.min(0.1 * rect.size().min_elem());
    let inner = rect.shrink(width);
    let corners = |rect: Rect| {
        let [top, bottom] = [rect.left_top(), rect.right_bottom()];
        [top, rect.right_top(), bottom, rect.left_bottom()]
    };
    let mut mesh = Mesh::default();
    for (at, colour) in [(rect, theme.background), (inner, Color32::TRANSPARENT)] {
        for corner in corners(at) {
            mesh.colored_vertex(corner, colour);
        }
    }
    for i in 0..4 {
        let next = (i + 1) % 4;
        mesh.add_triangle(i, next, 4 + i);
        mesh.add_triangle(next, 4 + next, 4 + i);
    }
    notes::fade(painter, rect, width, theme.background);
    painter.add(mesh);
}

fn drawn<'a>(
    viewport: &Viewport,
    theme: &Theme,
    marks: &'a [Mark],
    lit: Option<Link>,
) -> Vec<LayeredPart<'a>> {
    let mut pieces = pieces(viewport, theme, marks, lit);
    leave_out_covered(&mut pieces, |piece| {
        let is_line = matches!(
            piece.layer,
            Layer::Extension | Layer::Construction | Layer::Stroke
        );
        is_line.then(|| Pen::of(theme, piece.mark).is_dashed)
    });
    pieces
}

struct Stage<'a> {
    painter: &'a Painter,
    viewport: &'a Viewport,
    theme: &'a Theme,
    lit: Option<Link>,
}

impl Stage<'_> {
    fn layer(&self, pieces: &[LayeredPart<'_>]) {
        for piece in pieces {
            match piece.layer {
                Layer::Glow => self.glow(piece),
                Layer::Casing => self.casing(piece),
                Layer::Wash
                | Layer::Construction
                | Layer::Area
                | Layer::Extension
                | Layer::Stroke
                | Layer::Head
                | Layer::Marker => self.part(piece),
            }
        }
    }

    fn part(&self, LayeredPart { mark, part, .. }: &LayeredPart<'_>) {
        let pen = Pen::of(self.theme, mark);
        let ctx = self.painter.ctx();
        let shape = match part {
            Part::Wash(corners) => Egui::convex_polygon(corners.clone(), pen.wash, Stroke::NONE),
            Part::Fill(outlines) if self.is_lit(mark) && matches!(mark.shape, Shape::Fill(_)) => {
                self.fill(outlines, self.theme.accent.gamma_multiply(LIT))
            }
            Part::Fill(outlines) => self.fill(outlines, pen.wash),
            Part::Texture(triangles) => textured(ctx, self.theme, self.viewport, triangles),
            Part::Solids(shown) => solids(ctx, self.theme, self.viewport, shown, self.lit),
            Part::Crowd(segments) => {
                let pen = Pen::of_crowd(self.theme, mark, segments.len());
                return crowd(self.painter, self.theme, self.viewport, segments, &pen);
            }
            Part::Stroke(points) => return self.line(&Line::new(points, false), &pen),
            Part::Ring(points) => return self.line(&Line::new(points, true), &pen),
            Part::Arrow([from, tip]) => {
                let base = *tip - (*tip - *from).normalized() * HEAD * self.theme.stroke_scale;
                self.line(&Line::new(&[*from, base], false), &pen);
                self.head([*from, *tip], pen.stroke.color)
            }
            Part::Head(ends) => self.head(*ends, pen.stroke.color),
            Part::Marker(marker, at) => return self.marker(*marker, *at, mark, &pen),
        };
        self.painter.add(shape);
    }

    fn is_lit(&self, mark: &Mark) -> bool {
        self.lit.is_some() && mark.link == self.lit
    }

    fn line(&self, line: &Line, pen: &Pen) {
        if pen.is_dashed {
            line.dash(self.painter, pen.stroke, pen.dash * self.theme.stroke_scale);
        } else {
            line.draw(self.painter, pen.stroke);
        }
    }

    fn fill(&self, outlines: &[Vec<[f64; 2]>], colour: Color32) -> Egui {
        let on_screen = || -> Vec<_> {
            let outlines = outlines.iter();
            outlines.map(|it| self.viewport.all_to_screen(it)).collect()
        };
        notes::area(self.painter, on_screen, colour);
        if outlines.iter().map(Vec::len).sum::<usize>() >= LARGE {
            return filled_large(self.painter.ctx(), self.viewport, outlines, colour);
        }
        filled(&on_screen(), colour)
    }

    fn head(&self, [from, tip]: [Pos2; 2], colour: Color32) -> Egui {
        let along = (tip - from).normalized() * HEAD * self.theme.stroke_scale;
        let across = along.rot90() * 0.45;
        let corners = vec![tip, tip - along + across, tip - along - across];
        Egui::convex_polygon(corners, colour, Stroke::NONE)
    }

    fn marker(&self, marker: Marker, at: Pos2, mark: &Mark, pen: &Pen) {
        let radius = radius(self.theme, marker, mark);
        let background = self.theme.background;
        match marker {
            Marker::Dot | Marker::Vertex => {
                // A rim in the background's colour sets the dot off from the lines that meet in it.
                let rim = self.theme.stroke_scale.sqrt() * 1.5;
                self.painter.circle_filled(at, radius + rim, background);
                self.painter.circle_filled(at, radius, pen.stroke.color);
            }
            Marker::Circle => {
                self.painter.circle(at, radius, background, pen.stroke);
            }
            Marker::Cross => {
                let arm = 0.75 * radius;
                for arm in [vec2(arm, arm), vec2(arm, -arm)] {
                    self.painter.line_segment([at - arm, at + arm], pen.stroke);
                }
            }
            Marker::Bound(along) => {
                let tip = at + along * HEAD * self.theme.stroke_scale;
                self.painter.add(self.head([at, tip], pen.stroke.color));
            }
        }
    }

    fn casing(&self, LayeredPart { mark, part, .. }: &LayeredPart<'_>) {
        let pen = Pen::of(self.theme, mark);
        let around = self.theme.stroke(2.0 * CASING, self.theme.background);
        let stroke = Stroke::new(pen.stroke.width + around.width, around.color);
        if let Some((points, is_closed)) = part.line() {
            Line::new(points, is_closed).draw(self.painter, stroke);
        }
    }

    fn glow(&self, LayeredPart { mark, part, .. }: &LayeredPart<'_>) {
        let glow = self.theme.stroke(9.0, self.theme.accent_wash);
        match part {
            Part::Stroke(points) => Line::new(points, false).draw(self.painter, glow),
            Part::Arrow(ends) | Part::Head(ends) => {
                Line::new(ends, false).draw(self.painter, glow);
            }
            Part::Marker(marker, at) => {
                let radius = radius(self.theme, *marker, mark) + 6.0;
                let rim = self.theme.stroke(1.5, self.theme.accent);
                self.painter
                    .circle(*at, radius, self.theme.accent_wash, rim);
            }
            // An outline shows well enough what is meant, and a glow of all its edges would hide what is inside.
            Part::Wash(_)
            | Part::Fill(_)
            | Part::Solids(_)
            | Part::Texture(_)
            | Part::Crowd(_)
            | Part::Ring(_) => {}
        }
    }
}
