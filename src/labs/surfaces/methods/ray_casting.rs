//! Ray casting, shown: the ray with its hits in space and on its own axis, every question, the picture so far.

mod views;

use serde_json::{Value as Json, json};

use crate::{
    algo::surface::{
        Meeting, PlaneHit, RayCasting, RayCastingEvent as Event, RayCastingInput, RayCastingOutput,
        RayCastingState as State,
    },
    figure::{Caption, Tick, View, Watch, WatchRow, WatchSection},
    labs::{
        Answer, CodeLine, Demo, Step, code_line,
        space::{OnScene, OnSceneInput, Scene, Subject, demo::SpaceDemo, soup::surfaces_on_raster},
        words::{name, pixel_formula},
    },
    text::{Formula, Message, Value},
};

use super::on_raster::{depth_list, name_of};

type Input = OnSceneInput<RayCastingInput>;
type Shown = OnScene<RayCasting>;

/// More questions than these are not recorded: one ray is, through the pixel that is looked at.
const MOST_QUESTIONS: usize = 100_000;

impl Answer for RayCastingOutput {
    fn json(&self) -> Json {
        json!({ "ids": self.picture, "depth": depth_list(&self.depth) })
    }
}

impl SpaceDemo for Shown {
    const SUBJECT: Subject = Subject::Surfaces;

    fn input(scene: &Scene) -> Input {
        let surfaces = surfaces_on_raster(scene);
        let size = surfaces.size();
        let is_long = surfaces.n_pixels() * surfaces.triangles().len() > MOST_QUESTIONS;
        let middle = is_long.then_some(size.map(|side| side / 2));
        let asked = scene
            .raster
            .pixel
            .filter(|at| (0..2).all(|i| at[i] < size[i]));
        let pixel = asked.or(middle);
        OnSceneInput::of(scene, RayCastingInput { surfaces, pixel })
    }
}

/// `t = −(n·o + d) / (n·r) = 3.012 / 1.025 = 2.94`
fn quotient(found: &PlaneHit) -> Formula {
    let formula = Formula::decimals().sym("t = −(n·o + d) / (n·r) = ");
    let formula = formula
        .num(-found.numerator)
        .sym(" / ")
        .divisor(found.denominator);
    match found.t {
        Some(t) => formula.equals(t),
        None => formula,
    }
}

impl Demo for Shown {
    const ID: &'static str = "ray-casting";
    const NAME_KEY: &'static str = "alg-ray-casting";
    const SOURCE: &'static str = "Appel, 1968";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-ray-pixel", "words-ray-pixel"),
        code_line(1, "code-ray-triangle", "words-ray-triangle"),
        code_line(2, "code-ray-plane", "words-ray-plane"),
        code_line(2, "code-ray-inside", "words-ray-inside"),
        code_line(1, "code-ray-nearest", "words-ray-nearest"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Pixel { .. } => Tick::Phase,
            Event::Ask { nearest: true, .. } => Tick::Cut,
            Event::Ask { .. } => Tick::Test,
            Event::Seen { hit: Some(_), .. } | Event::Done => Tick::Accept,
            Event::Seen { hit: None, .. } => Tick::Reject,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Pixel { .. } => 0,
            Event::Ask { found, .. } => match found.meeting {
                Meeting::Culled => 1,
                Meeting::Parallel | Meeting::Behind | Meeting::BeforeNear | Meeting::BeyondFar => 2,
                Meeting::Beside | Meeting::Hit => 3,
            },
            Event::Seen { .. } | Event::Done => 4,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        match *event {
            Event::Pixel { pixel, ray } => {
                let message = Message::new("ray-pixel").with("at", pixel_formula(pixel));
                let direction = Formula::decimals().sym("r = ").place(ray.direction);
                Caption::new(message).so(direction)
            }
            Event::Ask {
                id, found, nearest, ..
            } => {
                let key = match (found.meeting, before.nearest) {
                    (Meeting::Hit, None) => "ray-hit-first",
                    (Meeting::Hit, Some(_)) if nearest => "ray-hit-nearer",
                    (Meeting::Hit, Some(_)) => "ray-hit-farther",
                    (other, _) => meeting_said(other),
                };
                let message = Message::new(key).with("triangle", name_of(input, id));
                let message = match before.nearest {
                    Some(hit) => message
                        .with("other", name_of(input, hit.id))
                        .with("t", Formula::decimals().num(hit.t)),
                    None => message,
                };
                let caption = Caption::new(message);
                if found.meeting == Meeting::Culled {
                    caption
                } else {
                    caption.so(quotient(&found))
                }
            }
            Event::Seen { pixel, hit, .. } => {
                let hits = before.hits.len();
                let message = match hit {
                    Some(hit) => Message::new("ray-seen").with("triangle", name_of(input, hit.id)),
                    None => Message::new("ray-seen-nothing"),
                };
                let message = message.with("hits", hits).with("at", pixel_formula(pixel));
                let caption = Caption::new(message);
                match hit {
                    Some(hit) => caption.so(Formula::decimals().sym("t = ").num(hit.t)),
                    None => caption,
                }
            }
            Event::Done => {
                let rays = input.own.pixel.map_or(input.own.surfaces.n_pixels(), |_| 1);
                let triangles = input.own.surfaces.triangles().len();
                let message = Message::new("ray-done").with("rays", rays);
                let message = message.with("triangles", triangles);
                let product = Formula::decimals().num(rays as f64).sym(" · ");
                let product = product.num(triangles as f64);
                Caption::new(message).so(product.equals(before.so_far.n_asked as f64))
            }
        }
    }

    fn opening(input: &Input) -> Caption {
        let [columns, rows] = input.own.surfaces.size().map(|side| side as usize);
        let message = Message::new("ray-opening")
            .with("columns", columns)
            .with("rows", rows)
            .with("rays", input.own.pixel.map_or(columns * rows, |_| 1))
            .with("triangles", input.own.surfaces.triangles().len());
        Caption::new(message)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        views::views(step)
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let pixel = state.pixel.map(|(at, _)| Value::Formula(pixel_formula(at)));
        let direction = state
            .pixel
            .map(|(_, ray)| Value::Formula(Formula::decimals().place(ray.direction)));
        let nearest = state.nearest.map(|hit| name_of(step.input, hit.id));
        let t = state
            .nearest
            .map(|hit| Value::Formula(Formula::decimals().num(hit.t)));
        let rows = vec![
            WatchRow::new(Value::Term("watch-pixel"), pixel),
            WatchRow::new(name("r"), direction),
            WatchRow::new(
                Value::Term("watch-hits"),
                Some(Value::Count(state.hits.len())),
            ),
            WatchRow::new(Value::Term("watch-nearest"), nearest),
            WatchRow::new(name("t"), t),
            WatchRow::new(
                Value::Term("watch-asked"),
                Some(Value::Count(state.so_far.n_asked as usize)),
            ),
        ];
        vec![WatchSection::list(rows)]
    }
}

const fn meeting_said(meeting: Meeting) -> &'static str {
    match meeting {
        Meeting::Culled => "ray-says-culled",
        Meeting::Parallel => "ray-says-parallel",
        Meeting::Behind => "ray-says-behind",
        Meeting::BeforeNear => "ray-says-before-near",
        Meeting::BeyondFar => "ray-says-beyond-far",
        Meeting::Beside => "ray-says-beside",
        Meeting::Hit => "ray-hit-first",
    }
}
