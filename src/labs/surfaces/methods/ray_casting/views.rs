//! The ray with its hits in space and on its own axis, every question, the picture so far.

use crate::{
    algo::surface::{Meeting, Ray, RayCasting, RayCastingEvent as Event},
    figure::{LineTick, NumberLine, Side},
    labs::space::Tones,
};

use super::super::{asks::asks, prelude::*};

use super::{
    names::{asked, hits, quotient, turn},
    shadow::shadow,
};

const ASKED_VIEW: &str = "asked";
const AXIS_VIEW: &str = "axis";
/// Of more triangles the table has only those that were hit, and no shadow is drawn.
const MOST_ROWS: usize = 12;

pub fn views(at: &At<'_, RayCasting>) -> Vec<View> {
    let own = now(at).or(at.step.held.nearest.map(|hit| hit.id));
    let mut views = on_raster::views(at, |scenery| {
        let scene = scenery.scene();
        let look = faces([(own, Role::Accent)], scene);
        let raster = if scene.raster.tones == Tones::Counts && scene.beside.len() == 1 {
            questions(at)
        } else {
            raster(at, own)
        };
        vec![
            scenery.observer_with(|_| Fate::ToCome, look, marks(at, scenery)),
            View::new(RASTER_VIEW, Body::Raster(raster)),
            View::new(ASKED_VIEW, Body::Table(table(at, scenery))),
            View::new(AXIS_VIEW, Body::NumberLine(axis(at, scenery))),
        ]
    });
    let surfaces = &at.step.input.surfaces;
    let all = || surfaces.n_pixels() * surfaces.triangles().len();
    let is_done = at.step.event() == Some(Event::Done);
    let said = ["{at}: {triangle}", "watch-asked"];
    views.extend(asks(at, "asks-ray-casting", said, is_done, all));
    views
}

const fn meeting_key(meeting: Meeting) -> &'static str {
    match meeting {
        Meeting::Culled => "ray-culled",
        Meeting::Parallel => "ray-parallel",
        Meeting::Behind => "ray-behind",
        Meeting::BeforeNear => "ray-before-near",
        Meeting::BeyondFar => "ray-beyond-far",
        Meeting::Beside => "ray-beside",
        Meeting::Hit => "ray-hit",
    }
}

/// The pixel in hand and its ray; none when all have been cast.
fn cast(at: &At<'_, RayCasting>) -> Option<([u32; 2], Ray)> {
    let is_over = at.step.event() == Some(Event::Done) && at.step.input.pixel.is_none();
    turn(at.step.past).filter(|_| !is_over)
}

fn now(at: &At<'_, RayCasting>) -> Option<u32> {
    match at.step.event()? {
        Event::Ask { id, .. } => Some(id),
        _ => None,
    }
}

/// The ray as far as it has been followed, and where it meets planes: the nearest hit filled, others hollow.
fn marks(at: &At<'_, RayCasting>, scenery: &Scenery) -> Vec<Mark3> {
    let Some((pixel, ray)) = cast(at) else {
        return Vec::new();
    };
    let (surfaces, camera) = (&at.step.input.surfaces, scenery.scene().camera.camera());
    let far = Rays::of(surfaces).far();
    let nearest = at.step.held.nearest;
    let mut marks = sight(surfaces, camera, pixel, nearest.map_or(far, |hit| hit.t));
    let place = |t: f64| camera.world_from_view(ray.at(t));
    if let Some(hit) = nearest {
        let beyond = Shape3::Segment([place(hit.t), place(far)]);
        marks.push(Mark3::new(Role::Signal, beyond).fine().dashed());
        if surfaces.triangles().len() <= MOST_ROWS {
            marks.extend(shadow(surfaces, camera, hit.id));
        }
    }
    let hits = hits(at.step.past).map(|hit| {
        let is_nearest = nearest.is_some_and(|nearest| nearest.id == hit.id);
        let shape = if is_nearest {
            Shape3::Dot
        } else {
            Shape3::Ring
        };
        Mark3::new(Role::Signal, shape(place(hit.t)))
    });
    marks.extend(hits);
    if let Some(Event::Ask { found, .. }) = at.step.event()
        && let (Meeting::Beside, Some(t)) = (found.meeting, found.t)
    {
        marks.push(Mark3::new(Role::Soft, Shape3::Ring(place(t))));
    }
    marks
}

fn raster(at: &At<'_, RayCasting>, own: Option<u32>) -> Raster {
    let picture = &at.step.held.so_far.picture;
    let letters = lettered(picture, |id| name_of(at.scenery, id));
    Raster {
        current: cast(at).map(|(pixel, _)| pixel.map(|x| x as usize)),
        ..raster_so_far(
            &at.step.input.surfaces,
            pixels(picture, own, letters),
            Vec::new(),
        )
    }
}

/// How many triangles the ray of each pixel has asked.
fn questions(at: &At<'_, RayCasting>) -> Raster {
    let surfaces = &at.step.input.surfaces;
    let mut pixels = vec![Pixel::EMPTY; surfaces.n_pixels()];
    let mut before = 0;
    for event in at.step.past {
        if let Event::Seen { pixel, n_asked, .. } = *event {
            pixels[at.step.held.so_far.picture.place(pixel)] = Pixel {
                role: Some(Role::Accent),
                shade: 0.9,
                value: Some(Value::Count((n_asked - before) as usize)),
            };
            before = n_asked;
        }
    }
    let title = Message::new("raster-questions").with("questions", before as usize);
    Raster {
        title: Value::Message(title.with("pixels", surfaces.n_pixels())),
        ..raster_so_far(surfaces, pixels, Vec::new())
    }
}

fn table(at: &At<'_, RayCasting>, scenery: &Scenery) -> Table {
    let (surfaces, past) = (&at.step.input.surfaces, at.step.past);
    let is_cast = cast(at).is_some();
    let ids: Vec<u32> = if surfaces.triangles().len() <= MOST_ROWS {
        surfaces.ids().collect()
    } else {
        hits(past).map(|hit| hit.id).collect()
    };
    let nearest = at.step.held.nearest.filter(|_| is_cast).map(|hit| hit.id);
    let row = |id: u32| {
        let found = asked(past).find(|(asked, _)| is_cast && *asked == id);
        let found = found.map(|(_, found)| found);
        let is_current = now(at) == Some(id);
        let is_hit = found.is_some_and(|found| found.meeting == Meeting::Hit);
        let role = if is_current {
            Role::Signal
        } else if is_hit {
            Role::Ink
        } else {
            Role::Soft
        };
        let number = |x: f64| Value::Formula(Formula::decimals().num(x));
        let quotient = |found| Value::Formula(quotient(Formula::decimals(), &found));
        let met = found.filter(|found| found.meeting != Meeting::Culled);
        let word = found.map(|found| match found.meeting {
            Meeting::Hit if nearest == Some(id) => Value::Term("ray-nearest"),
            other => Value::Term(meeting_key(other)),
        });
        let t = met.and_then(|found| found.t).map(number);
        TableRow {
            name: name_of(at.scenery, id),
            cells: vec![
                Cell::new(role, met.map(quotient)),
                Cell {
                    strong: nearest == Some(id),
                    ..Cell::new(role, t)
                },
                Cell::new(role, word),
            ],
            is_current,
            link: surface_link(scenery.scene(), id),
        }
    };
    let title = cast(at).map_or_else(Formula::default, |(at, _)| pixel_formula(at));
    Table {
        header: vec![
            title,
            Formula::default().sym("−(n·o + d) / n·r"),
            Formula::default().sym("t"),
            Formula::default().term("story-fate"),
        ],
        rows: ids.into_iter().map(row).collect(),
        notes: Vec::new(),
    }
}

/// The ray's own axis: the eye at 0, the raster at 1, what is hit, the plane that is met beside its triangle or behind the eye
/// at this step, and as far as the ray is followed.
fn axis(at: &At<'_, RayCasting>, scenery: &Scenery) -> NumberLine {
    let far = Rays::of(&at.step.input.surfaces).far();
    let is_cast = cast(at).is_some();
    let nearest = at.step.held.nearest.filter(|_| is_cast);
    let until = nearest.map_or(far, |hit| hit.t);
    let hits = hits(at.step.past).filter(|_| is_cast);
    let missed = match at.step.event() {
        Some(Event::Ask { id, found, .. }) if found.meeting != Meeting::Hit => {
            found.t.map(|t| (id, t))
        }
        Some(_) | None => None,
    };
    let ticks = hits.map(|hit| (hit.id, hit.t)).chain(missed);
    let ticks = ticks.map(|(id, t)| LineTick {
        u: t,
        value: Formula::decimals().num(t),
        side: Side::Leaving,
        holds: nearest.is_some_and(|nearest| nearest.id == id),
        current: now(at) == Some(id),
        name: name_of(at.scenery, id),
        link: surface_link(scenery.scene(), id),
    });
    NumberLine {
        symbol: "t",
        ends: [Value::Term("ray-eye"), Value::Term("ray-raster")],
        shown: [0.0, far],
        interval: [0.0, until],
        values: [0.0, until].map(|t| Formula::decimals().num(t)),
        empty: false,
        ticks: ticks.collect(),
        kept: None,
    }
}
