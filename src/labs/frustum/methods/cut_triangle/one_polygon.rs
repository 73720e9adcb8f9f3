//! A triangle against planes as one polygon, shown.

use serde_json::{Value as Json, json};

use crate::{
    algo::{
        ring::Right,
        volume::{
            CutTriangles, IntersectionPolygon, IntersectionPolygonEvent as Event,
            IntersectionPolygonState as State, SpaceVertex, TrianglePlanes,
        },
    },
    figure::{
        Body, Caption, Link, Mark3, Role, Run, Shape3, Tick, View, Watch, WatchRow, WatchSection,
    },
    geom::Plane,
    labs::{Answer, CodeLine, Demo, Step, Verdict, record_beside, words::name},
    text::Message,
    trace::silent,
};

use super::{
    super::{
        super::{
            OnScene, OnSceneInput, Scene, Subject,
            demo::SpaceDemo,
            stage::{FaceLook, Fate, Scenery},
        },
        planes::{parameter_row, place, plane_rows},
    },
    LISTS_VIEW, PLANES_VIEW,
    agreement::{agreement_view, is_about_pictures, is_alone},
    captions::polygon_caption,
    code::polygon,
    list_view::lists,
    marks::{
        cut, cut_edge, cut_symbol, distance_mark, given, kept, lost, places, plane_mark, vertex,
        vertex_symbol, with_texel,
    },
    small::{Progress, small},
    stages::{of_polygon, of_triangles},
    tally::tally,
    tellings,
    texture::{checkered, checkered_on_screen},
    variant::{self, OnePolygon, Variant},
};

type Input = OnSceneInput<TrianglePlanes>;
type Shown<L> = OnScene<IntersectionPolygon<L>>;

impl Answer for CutTriangles {
    fn json(&self) -> Json {
        let places =
            |piece: &[_; 3]| -> Json { json!(piece.each_ref().map(|v: &SpaceVertex| v.at)) };
        let triangles: Vec<Json> = self.triangles.iter().map(places).collect();
        let mut json = json!({ "triangles": triangles });
        let uv = self.triangles.iter().map(|piece| piece.map(|v| v.uv));
        let uv: Vec<_> = uv.collect();
        if self.has_uv {
            json["uv"] = json!(uv);
        }
        json
    }
}

impl<L: Variant<OnePolygon>> SpaceDemo for Shown<L> {
    const SUBJECT: Subject = Subject::Triangle;

    fn input(scene: &Scene) -> Input {
        OnSceneInput::of(scene, variant::input(scene, L::IS_TEXTURED))
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let parts = tellings::of_polygon::<L>(&Self::input(scene).own);
        parts.verdict(scene, about, |v| v.at, run)
    }

    fn record(scene: &Scene) -> Box<dyn Run> {
        record_beside::<Self, OnScene<IntersectionPolygon>>(Self::input(scene))
    }
}

impl<L: Variant<OnePolygon>> Demo for Shown<L> {
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Sutherland & Hodgman, 1974";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Plane { .. } => Tick::Phase,
            Event::Cross { .. } => Tick::Cut,
            Event::Done { n_triangles: 0 } => Tick::Reject,
            Event::Done { .. } => Tick::Accept,
            Event::First { .. }
            | Event::Test { .. }
            | Event::Output { .. }
            | Event::Pass { .. }
            | Event::Fan { .. } => Tick::Test,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match event {
            Event::Plane { .. } => polygon::EACH,
            Event::First { .. } => polygon::INSIDE,
            Event::Test { .. } => polygon::DISTANCE,
            Event::Cross { .. } => polygon::CROSS,
            Event::Output { at } => match before.crossing {
                Some((crossing, _)) if crossing == *at => polygon::CROSS,
                Some(_) | None => polygon::INSIDE,
            },
            Event::Pass { .. } => polygon::PASS,
            Event::Fan { .. } | Event::Done { .. } => polygon::FAN,
        }
    }

    fn opening(input: &Input) -> Caption {
        let message = Message::new("ip-opening").with("planes", input.own.planes.len());
        Caption::new(message.with("n", 3_usize))
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        polygon_caption(event, before, input)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let Input { own, scenery } = step.input;
        let parts = tellings::of_polygon::<L>(own);
        let mut views = Vec::new();
        if let Some(scenery) = scenery.as_deref() {
            views.push(scenery.observer(|_| Fate::ToCome, marks(step, scenery)));
            if L::IS_TEXTURED {
                let seen = if L::IS_EVEN_ON_SCREEN {
                    let camera = scenery.scene().culler();
                    checkered_on_screen(&fan(step), camera, Role::Accent)
                } else {
                    checkered(&fan(step), Role::Accent)
                };
                views.push(scenery.camera(|_| Fate::ToCome, |_, _| FaceLook::Whole, seen));
            }
        }
        if !is_about_pictures(scenery.as_deref()) {
            let lists = lists(own, &parts, step.state, step.event);
            views.push(View::new(LISTS_VIEW, Body::Lists(lists)));
        }
        let has_more = |scenery: &&Scenery| !L::IS_TEXTURED && is_alone(scenery);
        if let Some(scenery) = scenery.as_deref().filter(has_more) {
            let (stages, progress) = (of_polygon::<L>(own), progress(step, own));
            let row = small(&own.triangle, &own.planes, &stages, progress, scenery);
            views.push(View::new(PLANES_VIEW, Body::Multiples(row)));
        }
        let found = [
            parts.n_cuts(),
            silent::<IntersectionPolygon<L>>(own).triangles.len(),
        ];
        views.extend(agreement_view(scenery.as_deref(), found));
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let (own, state) = (&step.input.own, step.state);
        let plane = state.plane_idx.and_then(|i| own.planes.get(i));
        let mut rows: Vec<WatchRow> = plane.into_iter().flat_map(plane_rows).collect();
        rows.extend(state.crossing.map(|(_, t)| parameter_row(Some(t))));
        let list = |ring: &[SpaceVertex], prime: &str| {
            let row = |(i, v): (usize, &SpaceVertex)| {
                let symbol = format!("{}{prime}", vertex_symbol(i));
                WatchRow::new(name(symbol), Some(place(v.at)))
            };
            let rows = WatchSection::list(ring.iter().enumerate().map(row).collect());
            if is_about_pictures(step.input.scenery.as_deref()) {
                rows
            } else {
                rows.seen_in(LISTS_VIEW)
            }
        };
        let mut sections = vec![
            WatchSection::list(rows),
            list(&state.input, ""),
            list(&state.output, "′"),
        ];
        if step.input.scenery.is_some() {
            let stages = [&of_polygon::<L>(own)[..], &of_triangles::<Right>(own)];
            sections.push(tally(stages, progress(step, own).n_done));
        }
        sections
    }
}

/// Where a run is.
fn progress<L: Variant<OnePolygon>>(step: &Step<'_, Shown<L>>, own: &TrianglePlanes) -> Progress {
    let is_over = matches!(step.event, Some(Event::Fan { .. } | Event::Done { .. }));
    let has_passed = matches!(step.event, Some(Event::Pass { .. }));
    Progress::at(step.state.plane_idx, has_passed, is_over, own.planes.len())
}

/// The polygon as it stands, as triangles with a texture: what has been put out of it, once it is done with.
fn fan<L: Variant<OnePolygon>>(step: &Step<'_, Shown<L>>) -> Vec<[SpaceVertex; 3]> {
    let ring = &step.state.input;
    (2..ring.len())
        .map(|i| [ring[0], ring[i - 1], ring[i]])
        .collect()
}

fn marks<L: Variant<OnePolygon>>(step: &Step<'_, Shown<L>>, scenery: &Scenery) -> Vec<Mark3> {
    let (own, state) = (&step.input.own, step.state);
    let parts = tellings::of_polygon::<L>(own);
    let mut marks = given(&own.triangle.map(|v| v.at));
    let has_passed = matches!(step.event, Some(Event::Pass { .. }));
    let list = if has_passed {
        &state.passed
    } else {
        &state.input
    };
    let textured = own.triangle[0].uv.is_some();
    match state.plane_idx {
        Some(plane_idx) => {
            marks.extend(plane_mark(scenery, plane_idx));
            marks.extend(at_work_marks(step, list, &own.planes[plane_idx]));
        }
        None => marks.extend(left_marks(step)),
    }
    if textured {
        marks.extend(checkered(&fan(step), Role::Accent));
    }
    for triangle in &state.triangles {
        marks.push(Mark3::new(Role::Accent, Shape3::Outline(places(triangle))).fine());
    }
    let cuts: Vec<[f64; 3]> = state.crossings.iter().map(|(_, at, _)| at.at).collect();
    if state.plane_idx.is_some() {
        marks.extend(cut_edge(&cuts));
        let cuts = state.crossings.iter().enumerate();
        marks.extend(cuts.map(|(i, (_, at, _))| {
            let mark = with_texel(cut(i, at.at), &cut_symbol(i), at.uv);
            parts.linked(mark, at)
        }));
    }
    for (i, v) in list.iter().enumerate() {
        let inside = match state.plane_idx {
            Some(_) => state.sides.get(i).map(|&(_, inside)| inside),
            None => Some(true),
        };
        let mark = with_texel(vertex(i, v.at, inside), &vertex_symbol(i), v.uv);
        marks.push(parts.linked(mark, v));
    }
    marks
}

/// While a plane is at work: the polygon that it takes, what it loses of that, and the distance that is measured.
fn at_work_marks<L: Variant<OnePolygon>>(
    step: &Step<'_, Shown<L>>,
    list: &[SpaceVertex],
    plane: &Plane,
) -> Vec<Mark3> {
    let mut marks: Vec<Mark3> = lost(list, plane).into_iter().collect();
    if matches!(step.event, Some(Event::Pass { .. })) {
        marks.extend(kept(&step.state.input, Role::Accent));
    } else {
        marks.push(Mark3::new(Role::Accent, Shape3::Outline(places(list))));
    }
    match step.event {
        Some(Event::First { at, distance, .. }) => {
            marks.extend(distance_mark(plane, at.at, distance));
        }
        Some(Event::Test {
            ends, distances, ..
        }) => {
            marks.extend(distance_mark(plane, ends[1].at, distances[1]));
        }
        Some(
            Event::Plane { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Pass { .. }
            | Event::Fan { .. }
            | Event::Done { .. },
        )
        | None => {}
    }
    marks
}

/// Before the first plane and after the last one: the polygon, and the right one where it is another.
fn left_marks<L: Variant<OnePolygon>>(step: &Step<'_, Shown<L>>) -> Vec<Mark3> {
    let list = &step.state.input;
    let right = right_result::<L>(step);
    let role = if right.is_some() {
        Role::Signal
    } else {
        Role::Accent
    };
    let mut marks = if L::IS_TEXTURED {
        vec![Mark3::new(role, Shape3::Outline(places(list)))]
    } else {
        kept(list, role)
    };
    let outline = |ring: Vec<_>| Mark3::new(Role::Accent, Shape3::Outline(places(&ring)));
    marks.extend(right.map(outline));
    marks
}

/// Once a wrong run is over: the polygon that the right rules leave, where it is another.
fn right_result<L: Variant<OnePolygon>>(step: &Step<'_, Shown<L>>) -> Option<Vec<SpaceVertex>> {
    if L::DIFFERS_KEY.is_none() || !step.state.is_done {
        return None;
    }
    let right = of_polygon::<Right>(&step.input.own);
    let ring = right.last()?.after.first()?.clone();
    (places(&ring) != places(&step.state.input)).then_some(ring)
}
