//! What a run has worked out at a step: the segment in the view volume, and the pixels of the screen.

use crate::{
    algo::pipeline::{BresenhamInput, DrawnSegment, LineToPixelsEvent as Event, LineToPixelsInput},
    labs::frustum::prelude::*,
};

/// What has been told before the first pixel, and of the last one.
#[derive(Clone, Copy, Default)]
pub struct Known {
    /// Ends in clip space.
    pub projected: [Option<[f64; 4]>; 2],
    pub clipped: Option<[[f64; 4]; 2]>,
    pub is_rejected: bool,
    /// In pixels, with fractions.
    pub screen: Option<[[f64; 2]; 2]>,
    /// The pixels that they lie in.
    pub rounded: Option<[[i64; 2]; 2]>,
    /// e at the last pixel.
    pub error: Option<i64>,
}

impl Known {
    pub fn of(past: &[Event]) -> Self {
        let mut known = Self::default();
        for event in past.iter().take(5).chain(past.last()) {
            match *event {
                Event::Project { end, clip } => known.projected[end.idx()] = Some(clip),
                Event::Clip { ends } => known.clipped = Some(ends),
                Event::Reject => known.is_rejected = true,
                Event::Divide { screen } => known.screen = Some(screen),
                Event::Round { from, to } => known.rounded = Some([from, to]),
                Event::Pixel { error, .. } => known.error = Some(error),
            }
        }
        known
    }

    pub fn ends(&self, input: &LineToPixelsInput) -> Option<BresenhamInput> {
        match input {
            LineToPixelsInput::Pixels(ends) => Some(*ends),
            LineToPixelsInput::Segment(_) => {
                let [from, to] = self.rounded?;
                BresenhamInput::new(from, to).ok()
            }
        }
    }
}

/// How dark a pixel of the line is, and one that an end lies in.
pub const PUT: f64 = 0.9;
const END: f64 = 0.4;

pub fn marks(drawn: &DrawnSegment, known: &Known, event: Option<Event>) -> Vec<Mark3> {
    let ends = drawn.ends;
    let is_projecting = matches!(event, Some(Event::Project { .. }));
    let end = |(i, at): (usize, [f64; 3])| {
        let clip = known.projected[i].filter(|_| is_projecting);
        let label = sym(["P₁", "P₂"][i]);
        let label = clip.map_or(label.clone(), |[.., w]| label.sym(": w").equals(w));
        Mark3::new(Role::Ink, Shape3::Dot(at)).labelled(label)
    };
    let mut marks: Vec<Mark3> = ends.into_iter().enumerate().map(end).collect();
    let Some(kept) = kept(drawn, known) else {
        let is_lost = known.is_rejected;
        let role = if is_lost { Role::Discarded } else { Role::Ink };
        marks.push(Mark3::new(role, Shape3::Segment(ends)));
        if let Some(Event::Project { end, .. }) = event {
            marks.extend(projected(drawn, end));
        }
        return marks;
    };
    let is_now = matches!(event, Some(Event::Clip { .. }));
    for end in End::BOTH {
        let (cut, given) = (kept[end.idx()], ends[end.idx()]);
        if cut == given {
            continue;
        }
        if let Some(Event::Clip { ends }) = event {
            let sides = cut_by(ends[end.idx()]);
            marks.extend(sides.flat_map(|side| plane_at_work(&drawn.camera, side)));
        }
        marks.push(Mark3::new(Role::Discarded, Shape3::Segment([given, cut])));
        let role = if is_now { Role::Signal } else { Role::Accent };
        let dot = Mark3::new(role, Shape3::Dot(cut));
        marks.push(dot.labelled(end_name_now(end, true)));
    }
    marks.push(Mark3::new(Role::Accent, Shape3::Segment(kept)));
    if known.screen.is_some() {
        let images = kept.map(|at| image(drawn, at));
        let is_now = matches!(event, Some(Event::Divide { .. }));
        let role = if is_now { Role::Signal } else { Role::Ink };
        if let [Some(a), Some(b)] = images {
            marks.push(Mark3::new(role, Shape3::Segment([a, b])));
        }
        for (at, image) in kept.into_iter().zip(images) {
            let lines = seen_from(drawn, image).filter(|_| is_now);
            let lines = lines.map(|from| Mark3::new(role, Shape3::Segment([from, at])).fine());
            marks.extend(lines);
        }
    }
    marks
}

/// The sides of the volume on which an end lies, in clip space.
fn cut_by([x, y, z, w]: [f64; 4]) -> impl Iterator<Item = VolumeSide> {
    let is_on = move |side: &VolumeSide| {
        let along = [x, y, z][side.axis()];
        along == if side.is_high() { w } else { -w }
    };
    VolumeSide::ALL.into_iter().filter(is_on)
}

fn projected(drawn: &DrawnSegment, end: End) -> Vec<Mark3> {
    let at = drawn.ends[end.idx()];
    let image = image(drawn, at);
    if let (None, Some(wrong)) = (image, divided(drawn, at)) {
        let divided = sym(["P₁ / w₁", "P₂ / w₂"][end.idx()]);
        let not_so = Message::new("not-so").with("what", Value::Formula(divided));
        return vec![
            Mark3::new(Role::Signal, Shape3::Segment([at, wrong])).dashed(),
            Mark3::new(Role::Signal, Shape3::Ring(wrong)).labelled(not_so),
        ];
    }
    let from = seen_from(drawn, image).unwrap_or(at);
    let sight = Mark3::new(Role::Signal, Shape3::Segment([from, at])).fine();
    let image = image.map(|at| Mark3::new(Role::Signal, Shape3::Dot(at)));
    std::iter::once(sight).chain(image).collect()
}

/// Where a line of sight begins: at the eye, or of a parallel camera at the image.
fn seen_from(drawn: &DrawnSegment, image: Option<[f64; 3]>) -> Option<[f64; 3]> {
    match drawn.camera.volume().sight() {
        Sight::Perspective => Some(drawn.camera.position()),
        Sight::Parallel => image,
    }
}

fn image(drawn: &DrawnSegment, at: [f64; 3]) -> Option<[f64; 3]> {
    let camera = &drawn.camera;
    let is_before = camera.view_from_world().point(at)[2] < 0.0;
    let has_image = is_before || camera.volume().sight() == Sight::Parallel;
    divided(drawn, at).filter(|_| has_image)
}

/// Where the divide puts it: of what lies behind the eye through the eye, on the wrong side.
fn divided(drawn: &DrawnSegment, at: [f64; 3]) -> Option<[f64; 3]> {
    let camera = &drawn.camera;
    let near = camera.volume().near();
    let [x, y, z] = camera.view_from_world().point(at);
    let part = match camera.volume().sight() {
        Sight::Perspective => near / -z,
        Sight::Parallel => 1.0,
    };
    part.is_finite()
        .then(|| camera.world_from_view([x * part, y * part, -near]))
}

/// The ends of what is left, in the world: they lie on the segment as they do in clip space.
fn kept(drawn: &DrawnSegment, known: &Known) -> Option<[[f64; 3]; 2]> {
    let [Some(from), Some(to)] = known.projected else {
        return None;
    };
    let along = |at: [f64; 4]| {
        let length = |i: usize| (to[i] - from[i]).abs();
        let widest = (0..4).max_by(|&a, &b| length(a).total_cmp(&length(b)));
        let i = widest.unwrap_or_default();
        (at[i] - from[i]) / (to[i] - from[i])
    };
    let [p1, p2] = drawn.ends.map(DVec3::from);
    let world = |(at, end): ([f64; 4], [f64; 4])| {
        if at == end && end == from {
            return p1.into();
        }
        if at == end {
            return p2.into();
        }
        p1.lerp(p2, along(at)).into()
    };
    let [a, b] = known.clipped?;
    Some([(a, from), (b, to)].map(world))
}

pub const fn mark(role: Role, shape: RasterShape) -> RasterMark {
    RasterMark { role, shape }
}

/// The middle of a pixel.
pub fn centre(at: [i64; 2]) -> [f64; 2] {
    at.map(|x| x as f64 + 0.5)
}

pub fn framed([[left, top], [right, bottom]]: [[f64; 2]; 2]) -> impl Iterator<Item = RasterMark> {
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
    let sides = [0, 1, 2, 3].map(|i| [corners[i], corners[(i + 1) % 4]]);
    sides
        .into_iter()
        .map(|ends| mark(Role::Signal, RasterShape::Line(ends)))
}

pub fn raster(
    drawn: &DrawnSegment,
    known: &Known,
    (put, event): (&[[i64; 2]], Option<Event>),
) -> Raster {
    let [columns, rows] = drawn.viewport.size().map(|side| side as usize);
    let mut pixels = vec![Pixel::EMPTY; columns * rows];
    let mut fill = |[x, y]: [i64; 2], shade: f64| {
        let idx = y as usize * columns + x as usize;
        if let Some(pixel) = pixels.get_mut(idx) {
            pixel.role = Some(Role::Accent);
            pixel.shade = shade;
        }
    };
    for &at in known.rounded.iter().flatten() {
        fill(at, END);
    }
    for &at in put {
        fill(at, PUT);
    }
    if let Some(ends) = known.screen.filter(|_| put.is_empty()) {
        for (at, name) in ends.into_iter().zip(["S₁", "S₂"]) {
            let pixel = pixels.get_mut(beside(at, [columns, rows]));
            if let Some(pixel) = pixel {
                pixel.value = Some(Value::Name(name.into()));
            }
        }
    }
    let current = match event {
        Some(Event::Pixel { at, .. }) => Some(at.map(|x| x as usize)),
        _ => None,
    };
    let title = Message::new("raster-line")
        .with("columns", columns)
        .with("rows", rows);
    Raster {
        title: Value::Message(title),
        size: [columns, rows],
        pixels,
        scale: None,
        under: Vec::new(),
        bare: None,
        current,
        over: over(known, put, event),
    }
}

/// The pixel over the one that a place lies in, or in the first row under it: its name stands there.
fn beside([x, y]: [f64; 2], [columns, rows]: [usize; 2]) -> usize {
    let [column, row] = [x, y].map(|side| side.floor().max(0.0) as usize);
    let row = if row == 0 { 1 } else { row - 1 };
    row.min(rows - 1) * columns + column.min(columns - 1)
}

fn over(known: &Known, put: &[[i64; 2]], event: Option<Event>) -> Vec<RasterMark> {
    let mut over = Vec::new();
    if let Some(ends) = known.screen {
        let is_now = matches!(event, Some(Event::Divide { .. }));
        let role = if is_now { Role::Signal } else { Role::Soft };
        over.push(mark(role, RasterShape::Line(ends)));
        if put.is_empty() {
            over.extend(ends.map(|at| mark(role, RasterShape::Dot(at))));
        }
    }
    let Some(ends) = known.rounded else {
        return over;
    };
    over.push(mark(Role::Ink, RasterShape::Line(ends.map(centre))));
    if put.is_empty() {
        over.extend(ends.map(|at| mark(Role::Signal, RasterShape::Dot(centre(at)))));
    }
    over
}
