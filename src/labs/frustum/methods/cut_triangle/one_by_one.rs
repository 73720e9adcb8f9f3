//! A triangle against planes, triangle by triangle, shown.

use crate::{
    algo::{
        ring::Right,
        volume::{
            PlaneAtATime, PlaneAtATimeEvent as Event, PlaneAtATimeState as State, SpaceVertex,
            TrianglePlanes,
        },
    },
    figure::{
        Body, Caption, Link, Mark3, Role, Run, Shape3, Tick, View, Watch, WatchRow, WatchSection,
    },
    labs::{CodeLine, Demo, Step, Verdict, record_beside, words::name},
    text::Message,
};

use super::{
    super::{
        super::{
            OnScene, OnSceneInput, Scene, Subject,
            demo::SpaceDemo,
            stage::{Fate, Scenery},
        },
        planes::{parameter_row, place, plane_rows},
    },
    LISTS_VIEW, PLANES_VIEW,
    agreement::is_alone,
    captions::{one_by_one_caption, triangle_symbol},
    code::one_by_one,
    marks::{cut, cut_edge, given, kept, lost, places, plane_mark, vertex},
    pieces_view::{pieces, triangle_link},
    small::{Progress, small},
    stages::{of_polygon, of_triangles},
    tally::tally,
    tellings,
    variant::{self, OneByOne, Variant},
};

/// Of more triangles only the one that is asked has its name in the picture.
const MOST_NAMED: usize = 4;

type Input = OnSceneInput<TrianglePlanes>;
type Shown<L> = OnScene<PlaneAtATime<L>>;

impl<L: Variant<OneByOne>> SpaceDemo for Shown<L> {
    const SUBJECT: Subject = Subject::Triangle;

    fn input(scene: &Scene) -> Input {
        OnSceneInput::of(scene, variant::input(scene, L::IS_TEXTURED))
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let parts = tellings::of_triangles::<L>(&Self::input(scene).own);
        parts.verdict(scene, about, |v| v.at, run)
    }

    fn record(scene: &Scene) -> Box<dyn Run> {
        record_beside::<Self, OnScene<PlaneAtATime>>(Self::input(scene))
    }
}

impl<L: Variant<OneByOne>> Demo for Shown<L> {
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Eberly, 2006";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Plane { .. } => Tick::Phase,
            Event::Cross { .. } => Tick::Cut,
            Event::Done { n_triangles: 0 } => Tick::Reject,
            Event::Done { .. } => Tick::Accept,
            Event::Triangle { .. } | Event::Piece { .. } | Event::Pass { .. } => Tick::Test,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        let of = |inside: [bool; 3]| match inside.iter().filter(|&&inside| inside).count() {
            0 => one_by_one::NONE,
            1 => one_by_one::ONE,
            2 => one_by_one::TWO,
            3.. => one_by_one::THREE,
        };
        match event {
            Event::Plane { .. } => one_by_one::EACH,
            Event::Triangle { inside, .. } => of(*inside),
            Event::Cross { .. } | Event::Piece { .. } => {
                let asked = before.asked.last();
                asked.map_or(one_by_one::EACH, |asked| of(asked.inside))
            }
            Event::Pass { .. } | Event::Done { .. } => one_by_one::PASS,
        }
    }

    fn opening(input: &Input) -> Caption {
        let message = Message::new("pat-opening").with("planes", input.own.planes.len());
        Caption::new(message.with("n", 1_usize))
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        one_by_one_caption(event, before, input)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let Input { own, scenery } = step.input;
        let mut views = Vec::new();
        if let Some(scenery) = scenery.as_deref() {
            views.push(scenery.observer(|_| Fate::ToCome, marks(step, scenery)));
        }
        views.push(View::new(
            LISTS_VIEW,
            Body::Lists(pieces(step.state, step.event)),
        ));
        if let Some(scenery) = scenery.as_deref().filter(|scenery| is_alone(scenery)) {
            let (stages, progress) = (of_triangles::<L>(own), progress(step, own));
            let row = small(&own.triangle, &own.planes, &stages, progress, scenery);
            views.push(View::new(PLANES_VIEW, Body::Multiples(row)));
        }
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let (own, state) = (&step.input.own, step.state);
        let plane = state.plane_idx.and_then(|i| own.planes.get(i));
        let mut rows: Vec<WatchRow> = plane.into_iter().flat_map(plane_rows).collect();
        let t = state.crossings.last().map(|&(_, _, t)| t);
        rows.extend(t.map(|t| parameter_row(Some(t))));
        let list = |list: &[[SpaceVertex; 3]], prime: &str| {
            let row = |(i, triangle): (usize, &[SpaceVertex; 3])| {
                let symbol = format!("{}{prime}", triangle_symbol(i));
                let corners = triangle.iter().map(|v| Some(place(v.at)));
                WatchRow::table(name(symbol), corners.collect())
            };
            let rows = list.iter().enumerate().map(row).collect();
            WatchSection::table(vec!["V₀", "V₁", "V₂"], rows).seen_in(LISTS_VIEW)
        };
        let mut sections = vec![WatchSection::list(rows)];
        sections.push(list(&state.list, ""));
        if !state.next.is_empty() {
            sections.push(list(&state.next, "′"));
        }
        if step.input.scenery.is_some() {
            let stages = [&of_polygon::<Right>(own)[..], &of_triangles::<L>(own)];
            sections.push(tally(stages, progress(step, own).n_done));
        }
        sections
    }
}

fn progress<L: Variant<OneByOne>>(step: &Step<'_, Shown<L>>, own: &TrianglePlanes) -> Progress {
    let State {
        plane_idx, is_done, ..
    } = *step.state;
    let has_passed = matches!(step.event, Some(Event::Pass { .. }));
    Progress::at(plane_idx, has_passed, is_done, own.planes.len())
}

fn marks<L: Variant<OneByOne>>(step: &Step<'_, Shown<L>>, scenery: &Scenery) -> Vec<Mark3> {
    let (own, state) = (&step.input.own, step.state);
    let parts = tellings::of_triangles::<L>(own);
    let mut marks = given(&own.triangle.map(|v| v.at));
    let has_passed = matches!(step.event, Some(Event::Pass { .. }));
    let plane = state.plane_idx.and_then(|i| own.planes.get(i));
    let list = if has_passed {
        &state.passed
    } else {
        &state.list
    };
    if let Some((plane_idx, plane)) = state.plane_idx.zip(plane) {
        marks.extend(plane_mark(scenery, plane_idx));
        marks.extend(list.iter().filter_map(|triangle| lost(triangle, plane)));
    }
    let asked = state
        .asked
        .last()
        .filter(|_| plane.is_some() && !has_passed);
    let shown = if has_passed { &state.list } else { list };
    for (i, triangle) in shown.iter().enumerate() {
        let is_asked = asked.is_some_and(|asked| asked.triangle_idx == i);
        if plane.is_none() || has_passed || is_asked {
            let kept = kept(triangle, Role::Accent).into_iter();
            marks.extend(kept.map(|mark| mark.linked(triangle_link(i))));
        } else {
            let outline = Mark3::new(Role::Accent, Shape3::Outline(places(triangle)));
            marks.push(outline.fine().linked(triangle_link(i)));
        }
        if shown.len() > MOST_NAMED && !is_asked {
            continue;
        }
        let label = Mark3::new(Role::Ink, Shape3::Label(middle(triangle)));
        let symbol = name(triangle_symbol(i));
        marks.push(label.labelled(symbol).linked(triangle_link(i)));
    }
    if let Some(asked) = asked {
        let triangle = &state.list[asked.triangle_idx];
        for (i, v) in triangle.iter().enumerate() {
            let mark = vertex(i, v.at, Some(asked.inside[i]));
            marks.push(parts.linked(mark, v));
        }
        let new = state.origins.iter().zip(&state.next);
        let new = new.filter(|(origin, _)| **origin == asked.triangle_idx);
        marks
            .extend(new.map(|(_, piece)| Mark3::new(Role::Accent, Shape3::Outline(places(piece)))));
        let cuts: Vec<[f64; 3]> = state.crossings.iter().map(|(_, at, _)| at.at).collect();
        marks.extend(cut_edge(&cuts));
        let crossings = state.crossings.iter().enumerate();
        marks.extend(crossings.map(|(i, (_, at, _))| parts.linked(cut(i, at.at), at)));
    }
    marks
}

fn middle(triangle: &[SpaceVertex; 3]) -> [f64; 3] {
    std::array::from_fn(|i| triangle.iter().map(|v| v.at[i]).sum::<f64>() / 3.0)
}
