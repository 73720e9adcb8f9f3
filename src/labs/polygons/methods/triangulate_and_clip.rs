//! Ear clipping first, then each triangle clipped on its own, shown.

use serde_json::{Value as Json, json};

use crate::{
    algo::polygon::{
        EachTriangleEvent as Each, EarClipping, EarClippingEvent, EarsSoFar, Pieces, RingOutcome,
        SutherlandHodgman, SutherlandHodgmanEvent, SutherlandHodgmanInput, Triangle,
        TriangulateAndClip, TriangulateAndClipEvent as Event, TriangulateAndClipInput as Input,
        TriangulateAndClipState as State,
    },
    figure::{Body, Caption, Mark, Role, Shape, Tick, View, Watch, WatchRow, WatchSection},
    geom::{Point, SimplePolygon},
    labs::{
        Answer, CodeLine, Demo, Step, code_line,
        polygons::{PolygonDemo, Scene, ScenePart, UnfitScene},
        telling::{At, Telling},
        words::point_formula,
    },
    text::{Message, Value},
    trace::told::Recording,
};

use super::{
    clip_edge::EdgeLook,
    drawing, ear_clipping,
    fates::{FATES, fates},
    sutherland_hodgman,
    triangles::{points_of, triangle_link, triangle_name},
};

const TRIANGULATE: usize = 0;
const EACH: usize = 1;
const CLIP: usize = 2;
const PIECE: usize = 3;

/// Up to this number of triangles or pieces each has its outline.
const FEW_ENOUGH: usize = 200;

impl PolygonDemo for TriangulateAndClip {
    fn input(scene: &Scene) -> Result<Input, UnfitScene> {
        let region = sutherland_hodgman::region(scene)?;
        let polygon = SimplePolygon::try_from(&scene.subject)
            .map_err(|error| UnfitScene::new(ScenePart::Subject, error))?;
        Ok(Input { region, polygon })
    }

    fn crossing(event: &Event) -> Option<Point> {
        match event {
            Event::Clip(event) => SutherlandHodgman::<Point>::crossing(event),
            Event::Triangulate(_) | Event::Each(_) => None,
        }
    }

    fn piece(event: &Event, after: &State) -> Option<Vec<Point>> {
        match event {
            Event::Each(Each::Piece {
                outcome: RingOutcome::Whole | RingOutcome::Cut,
                ..
            }) => after.pieces.rings().last().map(<[Point]>::to_vec),
            Event::Each(Each::Piece { .. } | Each::Triangle { .. } | Each::Finish { .. })
            | Event::Triangulate(_)
            | Event::Clip(_) => None,
        }
    }
}

impl Answer for Pieces {
    fn json(&self) -> Json {
        let rings: Vec<&[Point]> = self.rings().collect();
        json!({ "polygons": rings })
    }
}

impl Demo for TriangulateAndClip {
    const ID: &'static str = "triangulate-and-clip";
    const NAME_KEY: &'static str = "alg-triangulate-and-clip";
    const SOURCE: &'static str = "Hearn & Baker, 1997, §6-8";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-tac-triangulate", "words-tac-triangulate"),
        code_line(0, "code-tac-each", "words-tac-each"),
        code_line(1, "code-tac-clip", "words-tac-clip"),
        code_line(1, "code-tac-piece", "words-tac-piece"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Triangulate(EarClippingEvent::Round { .. }) => Tick::Phase,
            Event::Triangulate(EarClippingEvent::Cut { .. } | EarClippingEvent::Last { .. }) => {
                Tick::Cut
            }
            Event::Triangulate(_) => Tick::Test,
            Event::Each(Each::Triangle { .. }) => Tick::Phase,
            Event::Clip(SutherlandHodgmanEvent::Cross { .. }) => Tick::Cut,
            Event::Clip(_) | Event::Each(Each::Piece { .. }) => Tick::Test,
            Event::Each(Each::Finish { n_pieces: 0 }) => Tick::Reject,
            Event::Each(Each::Finish { .. }) => Tick::Accept,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Triangulate(_) => TRIANGULATE,
            Event::Each(Each::Triangle { .. }) => EACH,
            Event::Clip(_) => CLIP,
            Event::Each(Each::Piece { .. } | Each::Finish { .. }) => PIECE,
        }
    }

    fn opening(input: &Input) -> Caption {
        let n = input.polygon.vertices().len();
        Caption::new(Message::new("tac-opening").with("n", n))
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        match event {
            Event::Triangulate(_) => {
                ears_at(&before.ears, before.ears.n_steps + 1, |at| at.caption())
            }
            Event::Each(event) => each_caption(*event, before),
            Event::Clip(event) => match &before.clip {
                Some(clip) => {
                    sutherland_hodgman::caption(event, clip, &before.region, EdgeLook::RIGHT)
                }
                None => Self::opening(input),
            },
        }
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(step)),
            View::new(FATES, Body::Lists(fates(step))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        if let Some(Event::Triangulate(_)) | None = step.event {
            return ears_at(&state.ears, state.ears.n_steps, |at| {
                let sections = at.filled(EarClipping::WATCH).into_iter();
                let unseen = |section| WatchSection {
                    seen_in: None,
                    ..section
                };
                sections.map(unseen).collect()
            });
        }
        let mut rows = Vec::new();
        if let Some((triangle_idx, triangle)) = triangle_now(state) {
            let row = WatchRow::new(Value::Term("tac-now"), Some(triangle_name(triangle)));
            rows.push(row.linked(triangle_link(triangle_idx)));
        }
        let n_pieces = Value::Count(state.pieces.len());
        rows.push(WatchRow::new(Value::Term("tac-pieces"), Some(n_pieces)));
        let mut watch = vec![WatchSection::list(rows)];
        if let Some(clip) = &state.clip {
            watch.extend(sutherland_hodgman::scalars(clip));
            watch.extend(sutherland_hodgman::lists_watched(clip));
        }
        watch
    }
}

/// The drawing.
fn marks(step: &Step<'_, TriangulateAndClip>) -> Vec<Mark> {
    let state = step.state;
    if let Some(Event::Triangulate(_)) | None = step.event {
        return ears_at(&state.ears, state.ears.n_steps, |at| {
            ear_clipping::marks(&at.step)
        });
    }
    if state.is_done {
        return merged_marks(&state.pieces);
    }
    let mut marks = triangle_marks(state);
    marks.extend(piece_marks(&state.pieces));
    if let (Some(clip), Some(corners)) = (&state.clip, corners(state)) {
        let event = if let Some(Event::Clip(event)) = step.event {
            Some(event)
        } else {
            None
        };
        let input = SutherlandHodgmanInput {
            region: state.region.clone(),
            vertices: corners.to_vec(),
        };
        let look = EdgeLook::RIGHT;
        marks.extend(drawing::marks(&input, clip, event, look));
    }
    marks
}

/// A step of the triangulation.
fn ears_at<T>(ears: &EarsSoFar, n_steps: usize, look: impl FnOnce(&At<'_, EarClipping>) -> T) -> T {
    let run = Recording::<EarClipping>::new(ears.polygon.clone());
    run.at(n_steps, |&step| {
        let scenery = None;
        look(&At { step, scenery })
    })
}

fn triangle_now(state: &State) -> Option<(usize, Triangle)> {
    let triangle_idx = state.triangle_idx?;
    let triangle = state.ears.cut_off.triangles().get(triangle_idx)?;
    Some((triangle_idx, *triangle))
}

fn corners(state: &State) -> Option<[Point; 3]> {
    let (_, triangle) = triangle_now(state)?;
    Some(state.ears.cut_off.corners(triangle))
}

fn each_caption(event: Each, before: &State) -> Caption {
    let named = |key: &'static str, triangle: Triangle| {
        Message::new(key).with("triangle", triangle_name(triangle))
    };
    match event {
        Each::Triangle {
            triangle_idx,
            triangle,
            corners,
        } => {
            let message = named("tac-triangle", triangle)
                .with("number", triangle_idx + 1)
                .with("total", before.ears.cut_off.triangles().len());
            let renamed = ["V₁", "V₂", "V₃"].into_iter().zip(corners);
            renamed.fold(Caption::new(message), |caption, (symbol, at)| {
                caption.so(point_formula(symbol, at))
            })
        }
        Each::Piece { outcome, .. } => {
            let triangle = triangle_now(before).map_or([0; 3], |(_, triangle)| triangle);
            let key = match outcome {
                RingOutcome::Whole => "tac-whole",
                RingOutcome::Cut => "tac-piece",
                RingOutcome::Degenerate => "tac-touch",
                RingOutcome::Empty => "tac-none",
            };
            let n = before.clip.as_ref().map_or(0, |clip| clip.input.len());
            Caption::new(named(key, triangle).with("n", n))
        }
        Each::Finish { n_pieces } => Caption::new(Message::new("tac-finish").with("n", n_pieces)),
    }
}

/// The triangles, as thin lines.
fn triangle_marks(state: &State) -> Vec<Mark> {
    let whole = &state.ears.cut_off;
    let triangles = whole.triangles();
    if triangles.len() > FEW_ENOUGH {
        return Vec::new();
    }
    let mark = |(triangle_idx, &triangle): (usize, &Triangle)| {
        let outline = Shape::Outline(points_of(whole, triangle));
        Mark::new(Role::Faint, outline).linked(triangle_link(triangle_idx))
    };
    triangles.iter().enumerate().map(mark).collect()
}

/// The pieces so far, side by side; the outline of all where they are many.
fn piece_marks(pieces: &Pieces) -> Vec<Mark> {
    if pieces.len() > FEW_ENOUGH {
        let edges = pieces.outline();
        let segments = edges.iter().map(|e| [e.p1, e.p2].map(Point::to_array));
        return vec![Mark::new(Role::Accepted, Shape::Crowd(segments.collect()))];
    }
    let rings = pieces.rings().zip(pieces.triangles());
    let mark = |(ring, &triangle_idx): (&[Point], &usize)| {
        let area = Shape::Area(vec![points(ring)]);
        Mark::new(Role::Accepted, area).linked(triangle_link(triangle_idx))
    };
    rings.map(mark).collect()
}

/// The answer: the pieces merged, and the seams between them.
fn merged_marks(pieces: &Pieces) -> Vec<Mark> {
    let rings: Vec<Vec<[f64; 2]>> = pieces.merged().iter().map(|ring| points(ring)).collect();
    if rings.is_empty() {
        return Vec::new();
    }
    let seams = pieces.rings().take(FEW_ENOUGH);
    let seams = seams.map(|ring| Mark::new(Role::Faint, Shape::Outline(points(ring))));
    let merged = Mark::new(Role::Accepted, Shape::Area(rings));
    std::iter::once(merged).chain(seams).collect()
}

fn points(ring: &[Point]) -> Vec<[f64; 2]> {
    ring.iter().map(|p| p.to_array()).collect()
}
