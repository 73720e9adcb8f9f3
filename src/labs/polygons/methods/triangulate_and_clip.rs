//! Ear clipping first, then each triangle clipped on its own, shown.

use crate::{
    algo::polygon::{
        EachTriangleEvent as Each, EarClipping, Pieces, SutherlandHodgman, Triangle,
        TriangulateAndClip, TriangulateAndClipEvent as Event, TriangulateAndClipHeld as Held,
        TriangulateAndClipInput as Input,
    },
    geom::pairs_around,
};

use super::{
    drawing::{self, Picture},
    ear_clipping,
    fates::{FATES, fates, is_done, is_triangulating, triangle_now},
    lists::{middle, outline},
    prelude::*,
    sutherland_hodgman,
    triangles::{points_of, triangle_link, triangle_name},
};

pseudocode! {
    TRIANGULATE: 0, "code-tac-triangulate", "words-tac-triangulate";
    EACH: 0, "code-tac-each", "words-tac-each";
    CLIP: 1, "code-tac-clip", "words-tac-clip";
    PIECE: 1, "code-tac-piece", "words-tac-piece";
}

const FEW_ENOUGH: usize = 200;
/// The row of a vertex that is put out hangs on the edge asked before it, and on where that edge crosses.
const LOOKS_BACK: usize = 4;

const EARS: &[Row] = EarClipping::ROWS;
const CLIPS: &[Row] = <SutherlandHodgman>::ROWS;
const N: usize = OWN.len() + EARS.len() + CLIPS.len();

/// What happens between the parts.
const OWN: &[Row] = &[
    Row::new(Phase, EACH, "tac-triangle").so(&["V₁ = {V₁}", "V₂ = {V₂}", "V₃ = {V₃}"]),
    piece("tac-whole").keeps("triangle"),
    piece("tac-piece")
        .answers_as("piece", "option-piece-cut")
        .cuts("triangle"),
    piece("tac-touch").drops("triangle"),
    piece("tac-none").drops("triangle"),
    Row::new(Reject, PIECE, "tac-finish"),
    Row::new(Accept, PIECE, "tac-finish"),
];

const fn own_idx(event: Each) -> usize {
    match event {
        Each::Triangle { .. } => 0,
        Each::Piece { outcome, .. } => match outcome {
            RingOutcome::Whole => 1,
            RingOutcome::Cut => 2,
            RingOutcome::Degenerate => 3,
            RingOutcome::Empty => 4,
        },
        Each::Finish { n_pieces: 0 } => 5,
        Each::Finish { .. } => 6,
    }
}

const fn piece(key: &'static str) -> Row {
    let row = Row::new(Test, PIECE, key).answers("piece");
    row.before_its_phase()
}

/// A row of a part, on the line that stands for the part here. What ends a part does not end the method.
const fn of_part_on(line: usize, row: Row) -> Row {
    let tick = match (line, row.tick) {
        (TRIANGULATE, Accept) | (CLIP, Phase | Accept | Reject) => Test,
        (_, tick) => tick,
    };
    Row { tick, line, ..row }
}

const ALL: [Row; N] = {
    let (mut all, mut i) = ([OWN[0]; N], 0);
    while i < N {
        all[i] = if i < OWN.len() {
            OWN[i]
        } else if i < OWN.len() + EARS.len() {
            of_part_on(TRIANGULATE, EARS[i - OWN.len()])
        } else {
            of_part_on(CLIP, CLIPS[i - OWN.len() - EARS.len()])
        };
        i += 1;
    }
    all
};

impl PolygonTelling for TriangulateAndClip {
    fn input(scene: &Scene) -> Result<Input, UnfitScene> {
        let region = sutherland_hodgman::region(scene)?;
        let polygon = ScenePart::Subject.simple(&scene.subject)?;
        Ok(Input { region, polygon })
    }

    fn crossing(event: &Event) -> Option<Point> {
        sutherland_hodgman::crossing_of(event)
    }

    fn dropped(step: &Step<'_, Self>) -> Vec<[Point; 2]> {
        sutherland_hodgman::dropped_by(step.past)
    }

    fn piece(step: &Step<'_, Self>) -> Option<Vec<Point>> {
        let is_piece = matches!(
            step.event(),
            Some(Event::Each(Each::Piece {
                outcome: RingOutcome::Whole | RingOutcome::Cut,
                ..
            }))
        );
        let last = step.held.pieces.rings().last().filter(|_| is_piece);
        last.map(<[Point]>::to_vec)
    }
}

impl Answer for Pieces {
    fn told(&self) -> impl Serialize {
        #[derive(Serialize)]
        struct Told<P> {
            polygons: P,
        }
        let polygons = Each(|| self.rings());
        Told { polygons }
    }
}

impl Telling for TriangulateAndClip {
    type Scenery = ();

    const ID: &'static str = "triangulate-and-clip";
    const NAME_KEY: &'static str = "alg-triangulate-and-clip";
    const SOURCE: &'static str = "Hearn & Baker, 1997, §6-8";
    const CODE: &'static [CodeLine] = &LINES;
    const ROWS: &'static [Row] = &ALL;
    const WATCH: &'static [Watched] = &[Watched::Names(&["now", "pieces"])];

    fn row_idx(step: &Step<'_, Self>) -> usize {
        if let Some(Event::Each(event)) = step.event() {
            return own_idx(event);
        }
        let recent = step.past.len().saturating_sub(LOOKS_BACK);
        let past = &step.past[recent..];
        let of_ears = |at: &At<'_, EarClipping>| OWN.len() + EarClipping::row_idx(&at.step);
        let of_clip = |at: &At<'_, SutherlandHodgman>| {
            OWN.len() + EARS.len() + <SutherlandHodgman>::row_idx(&at.step)
        };
        // Only the opening has no event, and nobody asks for its row here.
        of_part(&Step { past, ..*step }, of_ears, of_clip).unwrap_or_default()
    }

    const OPENING: Row = Row::new(Phase, TRIANGULATE, "tac-opening");

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        if let Some(Event::Each(event)) = at.step.event() {
            return each_named(&at.step, event, name);
        }
        match name {
            "now" | "pieces" => watched(&at.step, name),
            "n" if at.step.past.is_empty() => Some(at.step.input.polygon.vertices().len().into()),
            _ => {
                let of_ears = |at: &At<'_, EarClipping>| EarClipping::named(at, name);
                of_part(&at.step, of_ears, |at| <SutherlandHodgman>::named(at, name))?
            }
        }
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        let of_ears = |at: &At<'_, EarClipping>| EarClipping::listed(at, list);
        let of_clip = |at: &At<'_, SutherlandHodgman>| <SutherlandHodgman>::listed(at, list);
        of_part(&at.step, of_ears, of_clip).unwrap_or_default()
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        if is_triangulating(&at.step) {
            let sections = ears_at(&at.step, |at| at.filled(EarClipping::WATCH)).into_iter();
            let unseen = |section| WatchSection {
                seen_in: None,
                ..section
            };
            return sections.map(unseen).collect();
        }
        let mut watch = at.filled(Self::WATCH);
        if triangle_now(&at.step).is_some() {
            clip_at(&at.step, |at| {
                watch.extend(at.filled(<SutherlandHodgman>::WATCH));
                watch.extend(sutherland_hodgman::lists_watched(at));
            });
        }
        watch
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks(&at.step)),
            View::new(FATES, Body::Lists(fates(&at.step))),
        ]
    }
}

fn of_part<T>(
    step: &Step<'_, TriangulateAndClip>,
    of_ears: impl FnOnce(&At<'_, EarClipping>) -> T,
    of_clip: impl FnOnce(&At<'_, SutherlandHodgman>) -> T,
) -> Option<T> {
    match step.event()? {
        Event::Triangulate(_) => Some(ears_at(step, of_ears)),
        Event::Clip(_) => Some(clip_at(step, of_clip)),
        Event::Each(_) => None,
    }
}

/// The step of the triangulation. It looks at no event but the last.
fn ears_at<T>(
    step: &Step<'_, TriangulateAndClip>,
    look: impl FnOnce(&At<'_, EarClipping>) -> T,
) -> T {
    let past = match step.event() {
        Some(Event::Triangulate(event)) => Some(event),
        _ => None,
    };
    look(&At {
        step: Step {
            input: &step.input.polygon,
            held: &step.held.ears,
            past: past.as_slice(),
        },
        scenery: None,
    })
}

fn clip_at<T>(
    step: &Step<'_, TriangulateAndClip>,
    look: impl FnOnce(&At<'_, SutherlandHodgman>) -> T,
) -> T {
    let begins = |event: &Event| matches!(event, Event::Each(Each::Triangle { .. }));
    let start = step.past.iter().rposition(begins).unwrap_or_default();
    let past: Vec<_> = step.past[start..]
        .iter()
        .filter_map(|event| match event {
            Event::Clip(event) => Some(*event),
            Event::Triangulate(_) | Event::Each(_) => None,
        })
        .collect();
    look(&At {
        step: Step {
            input: &step.held.problem,
            held: &step.held.clip,
            past: &past,
        },
        scenery: None,
    })
}

fn each_named(step: &Step<'_, TriangulateAndClip>, event: Each, name: &str) -> Option<Named> {
    let held = step.held;
    Some(match (name, event) {
        ("triangle", _) => {
            let (triangle_idx, triangle) = triangle_now(step)?;
            Named::from(triangle_name(triangle)).linked(triangle_link(triangle_idx))
        }
        ("number", _) => (held.triangle_idx + 1).into(),
        ("total", _) => held.ears.cut_off.triangles().len().into(),
        ("V₁", Each::Triangle { corners, .. }) => corners[0].to_array().into(),
        ("V₂", Each::Triangle { corners, .. }) => corners[1].to_array().into(),
        ("V₃", Each::Triangle { corners, .. }) => corners[2].to_array().into(),
        ("n", Each::Piece { .. }) => held.clip.lists.list().len().into(),
        ("n", Each::Finish { n_pieces }) => n_pieces.into(),
        _ => return watched(step, name),
    })
}

fn watched(step: &Step<'_, TriangulateAndClip>, name: &str) -> Option<Named> {
    Some(match name {
        "now" => {
            let (triangle_idx, triangle) = triangle_now(step)?;
            let now = Named::from(triangle_name(triangle)).labelled(Value::Term("tac-now"));
            now.linked(triangle_link(triangle_idx))
        }
        "pieces" => Named::from(step.held.pieces.len()).labelled(Value::Term("tac-pieces")),
        _ => return None,
    })
}

fn marks(step: &Step<'_, TriangulateAndClip>) -> Vec<Mark> {
    let held = step.held;
    if is_triangulating(step) {
        return ears_at(step, |at| ear_clipping::marks(&at.step));
    }
    if is_done(step) {
        return merged_marks(&held.pieces);
    }
    let mut marks = triangle_marks(held);
    marks.extend(piece_marks(&held.pieces));
    marks.extend(clip_at(step, |at| drawing::marks(&Picture::of(&at.step))));
    marks
}

fn triangle_marks(held: &Held) -> Vec<Mark> {
    let whole = &held.ears.cut_off;
    let triangles = whole.triangles();
    if triangles.len() > FEW_ENOUGH {
        return Vec::new();
    }
    let mark = |(triangle_idx, &triangle): (usize, &Triangle)| {
        let shape = Shape::Outline(points_of(whole, triangle));
        Mark::new(Role::Faint, shape).linked(triangle_link(triangle_idx))
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
        let area = Shape::Area(vec![outline(ring)]);
        Mark::new(Role::Accepted, area).linked(triangle_link(triangle_idx))
    };
    rings.map(mark).collect()
}

/// The answer: the pieces merged, and the seams between them.
fn merged_marks(pieces: &Pieces) -> Vec<Mark> {
    let rings: Vec<Vec<[f64; 2]>> = pieces.merged().iter().map(|ring| outline(ring)).collect();
    if rings.is_empty() {
        return Vec::new();
    }
    let pieces = || pieces.rings().take(FEW_ENOUGH).enumerate();
    let edges = |ring: &[Point]| pairs_around(ring).collect::<Vec<_>>();
    let all: Vec<[Point; 2]> = pieces().flat_map(|(_, ring)| edges(ring)).collect();
    // A piece's edge that another one has the other way round, told once.
    let is_seam = |&(i, &[a, b]): &(usize, &[Point; 2])| all[..i].contains(&[b, a]);
    let seams = all.iter().enumerate().filter(is_seam).map(|(_, ends)| {
        let seam = Shape::Segment(ends.map(Point::to_array));
        Mark::new(Role::Ink, seam).dashed()
    });
    let names = pieces().map(|(i, ring)| {
        let piece = Mark::new(Role::Accepted, Shape::Label(middle(ring)));
        piece.labelled(name(numbered('Q', i)))
    });
    let merged = Mark::new(Role::Accepted, Shape::Area(rings));
    let merged = std::iter::once(merged).chain(seams);
    merged.chain(names).collect()
}
