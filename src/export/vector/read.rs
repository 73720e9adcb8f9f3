//! egui's shapes read as paths, text and pictures. What is none of them becomes a picture.

mod galley;

use egui::{
    Color32, Pos2, Rect, Shape, Stroke, StrokeKind, TextureId, Vec2,
    emath::{GuiRounding, TSTransform},
    epaint::{ClippedShape, ColorMode, PathShape, PathStroke, RectShape, WHITE_UV},
    pos2,
};

use crate::paint::{Drawing, notes::Note};

use super::page::{Drawn, Form, Item, Path, Picture, Run, VectorPage, What};

/// What fades does so in this many steps: a step is as wide as a pixel of a screen.
const N_FADING: usize = 14;

pub fn read(drawing: &Drawing<'_>) -> VectorPage {
    let mut reader = Reader {
        drawing,
        items: Vec::new(),
        pixels: Vec::new(),
    };
    let mut shapes = drawing.shapes.iter();
    while let Some(shape) = shapes.next() {
        let clip = shape.clip_rect;
        match Note::of(&shape.shape) {
            Some(Note::Area(outlines, colour)) => reader.area(clip, outlines, *colour),
            Some(Note::Fade(rect, width, colour)) => reader.fade(clip, *rect, *width, *colour),
            Some(Note::Begin(_) | Note::End) | None => {
                reader.shape(clip, &shape.shape);
                continue;
            }
        }
        // The triangles that stand for it.
        shapes.next();
    }
    reader.flush();
    VectorPage {
        size: drawing.size_pts,
        pixels_per_point: drawing.pixels_per_point,
        theme: drawing.theme,
        items: reader.items,
    }
}

struct Reader<'a> {
    drawing: &'a Drawing<'a>,
    items: Vec<Item>,
    /// Neighbours that only pixels can show: one picture of all.
    pixels: Vec<ClippedShape>,
}

impl Reader<'_> {
    fn shape(&mut self, clip: Rect, shape: &Shape) {
        match shape {
            Shape::Noop => {}
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| self.shape(clip, shape)),
            Shape::Callback(_) => self.note(shape),
            Shape::Circle(circle) => {
                // egui's line goes round it.
                let radius = circle.radius + 0.5 * circle.stroke.width;
                let form = Form::Circle(circle.center, radius);
                self.path(clip, form, circle.fill, circle.stroke);
            }
            Shape::LineSegment { points, stroke } => self.segment(clip, *points, *stroke),
            Shape::Path(path) => match path.stroke.color {
                ColorMode::Solid(colour) => self.line(clip, path, colour),
                ColorMode::UV(_) => self.picture(clip, shape),
            },
            Shape::Rect(rect) if is_plain(rect) => self.rect(clip, rect),
            Shape::Text(text) => self.text(clip, text),
            Shape::Mesh(mesh) => match one_colour(mesh) {
                Some(colour) => self.triangles(clip, mesh, colour),
                None => self.picture(clip, shape),
            },
            Shape::Rect(_)
            | Shape::Ellipse(_)
            | Shape::Band(_)
            | Shape::QuadraticBezier(_)
            | Shape::CubicBezier(_) => self.picture(clip, shape),
        }
    }

    fn note(&mut self, shape: &Shape) {
        match Note::of(shape) {
            Some(Note::Begin(name)) => self.item(Item::Begin(name)),
            Some(Note::End) => match self.items.last() {
                Some(Item::Begin(_)) if self.pixels.is_empty() => {
                    self.items.pop();
                }
                _ => self.item(Item::End),
            },
            Some(Note::Area(..) | Note::Fade(..)) | None => {}
        }
    }

    fn item(&mut self, item: Item) {
        self.flush();
        self.items.push(item);
    }

    fn drawn(&mut self, clip: Rect, bounds: Rect, what: What) {
        let whole = Rect::from_min_size(Pos2::ZERO, self.drawing.size_pts);
        let clip = clip.intersect(whole);
        if !bounds.is_finite() || !clip.is_positive() || !clip.intersects(bounds) {
            return;
        }
        // A pixel's part that stands out is not worth a clip.
        let is_inside = clip.expand(0.5).contains_rect(bounds);
        let clip = (!is_inside).then_some(clip);
        self.item(Item::Drawn(Drawn { clip, what }));
    }

    fn path(&mut self, clip: Rect, form: Form, fill: Color32, stroke: Stroke) {
        let has_stroke = stroke.width > 0.0 && stroke.color != Color32::TRANSPARENT;
        let path = Path {
            form,
            fill: (fill != Color32::TRANSPARENT).then_some(fill),
            stroke: has_stroke.then_some((stroke.width, stroke.color)),
        };
        if path.fill.is_some() || path.stroke.is_some() {
            self.drawn(clip, path.bounds(), What::Path(path));
        }
    }

    fn area(&mut self, clip: Rect, outlines: &[Vec<Pos2>], colour: Color32) {
        let run = |outline: &Vec<Pos2>| Run {
            points: outline.clone(),
            is_closed: true,
        };
        let form = Form::Lines(outlines.iter().map(run).collect());
        self.path(clip, form, colour, Stroke::NONE);
    }

    /// Frames within each other, each as strong as the colour is in its middle. No two lie over each other: what is rounded when
    /// colours are mixed would add up.
    fn fade(&mut self, clip: Rect, rect: Rect, width: f32, colour: Color32) {
        let corners = |nth: usize| {
            let rect = rect.shrink(width * nth as f32 / N_FADING as f32);
            let (min, max) = (rect.min, rect.max);
            vec![min, pos2(max.x, min.y), max, pos2(min.x, max.y)]
        };
        self.item(Item::Begin("fade"));
        for nth in 0..N_FADING {
            let share = 1.0 - (nth as f32 + 0.5) / N_FADING as f32;
            let frame = [corners(nth), corners(nth + 1)];
            self.area(clip, &frame, colour.gamma_multiply(share));
        }
        self.item(Item::End);
    }

    /// As egui does it, one that stands upright or lies is put on whole pixels.
    fn segment(&mut self, clip: Rect, [mut a, mut b]: [Pos2; 2], stroke: Stroke) {
        let pixels = self.drawing.pixels_per_point;
        let [dx, dy] = [(a.x, b.x), (a.y, b.y)].map(|(a, b)| a == b);
        if dx {
            stroke.round_center_to_pixel(pixels, &mut a.x);
            b.x = a.x;
        }
        if dy {
            stroke.round_center_to_pixel(pixels, &mut a.y);
            b.y = a.y;
        }
        let run = Run {
            points: vec![a, b],
            is_closed: false,
        };
        self.path(clip, Form::Lines(vec![run]), Color32::TRANSPARENT, stroke);
    }

    fn line(&mut self, clip: Rect, path: &PathShape, colour: Color32) {
        let PathStroke { width, .. } = path.stroke;
        let run = Run {
            points: path.points.clone(),
            is_closed: path.closed,
        };
        let stroke = Stroke::new(width, colour);
        self.path(clip, Form::Lines(vec![run]), path.fill, stroke);
    }

    fn rect(&mut self, clip: Rect, shape: &RectShape) {
        let pixels = self.drawing.pixels_per_point;
        let rect = shape.rect;
        let mut stroke = shape.stroke;
        let is_bare = stroke.width <= 0.0 || stroke.color == Color32::TRANSPARENT;
        let thin = 2.0 / pixels;
        if is_bare && rect.width() <= thin {
            stroke = Stroke::new(rect.width(), shape.fill);
            return self.segment(clip, [rect.center_top(), rect.center_bottom()], stroke);
        }
        if is_bare && rect.height() <= thin {
            stroke = Stroke::new(rect.height(), shape.fill);
            return self.segment(clip, [rect.left_center(), rect.right_center()], stroke);
        }
        let by = match shape.stroke_kind {
            StrokeKind::Inside => -0.5 * stroke.width,
            StrokeKind::Middle => 0.0,
            StrokeKind::Outside => 0.5 * stroke.width,
        };
        let mut edges = [rect.min.x, rect.min.y, rect.max.x, rect.max.y];
        for edge in &mut edges {
            if is_bare || shape.stroke_kind != StrokeKind::Middle {
                *edge = edge.round_to_pixels(pixels);
            } else {
                stroke.round_center_to_pixel(pixels, edge);
            }
        }
        let rect = Rect::from_min_max([edges[0], edges[1]].into(), [edges[2], edges[3]].into());
        let radius = f32::from(shape.corner_radius.average() as u8);
        let by = if is_bare { 0.0 } else { by };
        let form = Form::Rect(rect.expand(by), (radius + by).max(0.0));
        self.path(clip, form, shape.fill, stroke);
    }

    fn triangles(&mut self, clip: Rect, mesh: &egui::Mesh, colour: Color32) {
        let corner = |i: &u32| mesh.vertices.get(*i as usize).map(|vertex| vertex.pos);
        let run = |corners: &[u32]| {
            let points = corners.iter().map(corner).collect::<Option<Vec<Pos2>>>()?;
            let [a, b, c] = points[..] else { return None };
            // All turn the same way: where two overlap it is filled once.
            let turn = (b - a).x * (c - a).y - (b - a).y * (c - a).x;
            let points = if turn < 0.0 { vec![a, c, b] } else { points };
            Some(Run {
                points,
                is_closed: true,
            })
        };
        let runs: Vec<Run> = mesh.indices.chunks(3).filter_map(run).collect();
        if !runs.is_empty() {
            self.path(clip, Form::Lines(runs), colour, Stroke::NONE);
        }
    }

    fn picture(&mut self, clip_rect: Rect, shape: &Shape) {
        self.pixels.push(ClippedShape {
            clip_rect,
            shape: shape.clone(),
            transform_after_tessellation: TSTransform::IDENTITY,
        });
    }

    fn flush(&mut self) {
        if self.pixels.is_empty() {
            return;
        }
        let pixels = std::mem::take(&mut self.pixels);
        let Some((min, image)) = self.drawing.on_glass(pixels) else {
            return;
        };
        let pts =
            |px: [usize; 2]| Vec2::from(px.map(|px| px as f32)) / self.drawing.pixels_per_point;
        let rect = Rect::from_min_size(pts(min).to_pos2(), pts(image.size));
        let what = What::Picture(Picture { rect, image });
        self.items.push(Item::Drawn(Drawn { clip: None, what }));
    }
}

/// Filled and stroked in one colour each, upright and with sharp edges.
fn is_plain(rect: &RectShape) -> bool {
    rect.brush.is_none() && rect.angle == 0.0 && rect.blur_width == 0.0
}

/// Of a mesh without a picture on it.
fn one_colour(mesh: &egui::Mesh) -> Option<Color32> {
    let first = mesh.vertices.first()?.color;
    let is_alike = |vertex: &egui::epaint::Vertex| vertex.color == first && vertex.uv == WHITE_UV;
    let is_bare = mesh.texture_id == TextureId::default();
    (is_bare && mesh.vertices.iter().all(is_alike)).then_some(first)
}
