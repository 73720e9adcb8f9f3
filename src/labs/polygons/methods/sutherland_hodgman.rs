//! Sutherland–Hodgman, shown.

use std::sync::Arc;

use crate::{
    algo::{
        polygon::{
            Rule, SutherlandHodgman, SutherlandHodgmanEvent as Event,
            SutherlandHodgmanInput as Input, Textured, faulty::KeepsUv,
        },
        ring::{EdgeTest, Known},
    },
    labs::polygons::{GivenSubject, Panels, Texture},
};

use super::{
    super::handles::corner_link,
    drawing::{Picture, edge, marks},
    list_view::lists,
    lists::{LISTS, output_symbol, rows as list_rows},
    panels,
    prelude::*,
    skin::{LabVertex, NamedVertex},
    variant::{EACH, FIRST, IN_IN, IN_OUT, OUT_IN, OUT_OUT, PASS, Variant},
};

pub const SOURCE: &str = "Sutherland & Hodgman, 1974";

impl<L: Variant> PolygonTelling for SutherlandHodgman<Point, L> {
    const CARRIES_TEXTURE: bool = L::DIFFERS_KEY.is_none();
    const GIVEN: GivenSubject = GivenSubject::CutOff;

    fn input(scene: &Scene) -> Result<Input, UnfitScene> {
        input(scene)
    }

    fn border(step: &Step<'_, Self>) -> Option<usize> {
        edge(step).map(|edge| edge.idx())
    }

    fn asks(event: &Event<Point>) -> Option<Point> {
        asked_vertex(event)
    }

    fn crossing(event: &Event<Point>) -> Option<Point> {
        crossing_of(event)
    }

    fn dropped(step: &Step<'_, Self>) -> Vec<[Point; 2]> {
        dropped_by(step.past)
    }

    fn piece(step: &Step<'_, Self>) -> Option<Vec<Point>> {
        let is_done = matches!(step.event(), Some(Event::Done { .. }));
        is_done.then(|| step.held.lists.list().clone())
    }

    fn record(scene: &Scene) -> Result<Box<dyn Run>, UnfitScene> {
        let texture = match L::DIFFERS_KEY {
            Some(_) => Texture::None,
            None => scene.texture,
        };
        Ok(match texture {
            Texture::None => {
                let run = Recorded::<Self>::beside::<SutherlandHodgman>(
                    input(scene)?,
                    Some(Arc::new(scene.panels)),
                );
                Box::new(run)
            }
            Texture::Interpolated => {
                let input = textured(scene)?;
                Box::new(Recorded::<SutherlandHodgman<Textured, L>>::new(input, None))
            }
            Texture::Kept => {
                let input = textured(scene)?;
                Box::new(Recorded::<SutherlandHodgman<KeepsUv, L>>::new(input, None))
            }
        })
    }
}

pub fn crossing_of(event: &impl RingEvent<Point>) -> Option<Point> {
    match event.happening()? {
        Happening::Cross(crossing) => Some(crossing.at),
        _ => None,
    }
}

/// What a border has dropped of the edge that was looked at last: all of it, or what lies beyond the crossing.
pub fn dropped_by(past: &[impl RingEvent<Point>]) -> Vec<[Point; 2]> {
    let Some(EdgeTest { ends, rule, .. }) = Asked::of(past).test else {
        return Vec::new();
    };
    let [s, p] = ends;
    let part = match (past.last().and_then(RingEvent::happening), rule) {
        (Some(Happening::Test(_)), Rule::OutOut) => Some([s, p]),
        (Some(Happening::Cross(crossing)), Rule::InOut) => Some([crossing.at, p]),
        (Some(Happening::Cross(crossing)), Rule::OutIn) => Some([s, crossing.at]),
        (_, Rule::InIn | Rule::InOut | Rule::OutIn | Rule::OutOut) => None,
    };
    part.into_iter().collect()
}

/// The window, or the clip polygon where it is convex.
pub fn region(scene: &Scene) -> Result<ClipRegion, UnfitScene> {
    match scene.clip {
        None => Ok(scene.window.into()),
        Some(_) => scene.convex_clip().map(ClipRegion::from),
    }
}

pub fn input(scene: &Scene) -> Result<Input, UnfitScene> {
    Ok(Input::new(region(scene)?, &scene.subject))
}

fn textured<V: LabVertex>(scene: &Scene) -> Result<Input<V>, UnfitScene> {
    let texel = scene.texels();
    let vertices = scene.subject.vertices().iter();
    Ok(Input {
        region: region(scene)?,
        vertices: vertices.map(|&at| V::with_uv(at, texel(at))).collect(),
    })
}

const LIES: &[&str] = &["{S lies}", "{P lies}"];
const CROSSES: &[&str] = &["{I 1}", "{I 2}", "{I 3}", "{uv(I)}"];
const PUTS_OUT: &[&str] = &["{place} = {at}"];

const fn test(line: usize, key: &'static str) -> Row {
    Row::new(Test, line, key).so(LIES)
}

const fn cross(line: usize) -> Row {
    Row::new(Cut, line, "sh-cross").so(CROSSES)
}

const fn output(line: usize) -> Row {
    Row::new(Test, line, "sh-output").so(PUTS_OUT)
}

fn is_window<V: LabVertex, L: Variant>(step: &Step<'_, SutherlandHodgman<V, L>>) -> bool {
    matches!(step.input.region, ClipRegion::Window(_))
}

/// What the edge that was looked at last falls under; none where only the first vertex has been.
fn rule<V: LabVertex, L: Variant>(step: &Step<'_, SutherlandHodgman<V, L>>) -> Option<Rule> {
    Asked::of(step.past).test.map(|test| test.rule)
}

impl<V: LabVertex, L: Variant> Telling for SutherlandHodgman<V, L> {
    type Scenery = Panels;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = SOURCE;
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[Watched::Names(&["d_S", "d_P", "t"])];

    table! { |event, step|
        edge_side: Event::Edge { .. } if is_window(step) => Row::new(Phase, EACH, "sh-edge-side");
        edge: Event::Edge { .. } =>
            Row::new(Phase, EACH, "sh-edge").so(&["n = {normal}", "E = {E}"]);
        first_inside: Event::First(Known { inside: true, .. }) =>
            Row::new(Test, FIRST, "sh-first-inside").so(&["{P lies}"]).answers("first").keeps("P");
        first_outside: Event::First(Known { inside: false, .. }) =>
            Row::new(Test, FIRST, "sh-first-outside").so(&["{P lies}"]).answers("first").drops("P");
        // The edge that closes the ring puts out a crossing at most: its end has been asked before.
        closes_in_in: Event::Test(EdgeTest { idx: [_, 0], rule: Rule::InIn, .. }) =>
            puts_nothing(test(IN_IN, "sh-closing")).keeps("P");
        closes_in_out: Event::Test(EdgeTest { idx: [_, 0], rule: Rule::InOut, distances, .. })
            if is_crossed(distances) => puts_crossing(test(IN_OUT, "sh-closing-cross")).about("P");
        closes_leaving: Event::Test(EdgeTest { idx: [_, 0], rule: Rule::InOut, .. }) =>
            puts_nothing(test(IN_OUT, "sh-closing")).about("P");
        closes_out_in: Event::Test(EdgeTest { idx: [_, 0], rule: Rule::OutIn, distances, .. })
            if is_crossed(distances) => puts_crossing(test(OUT_IN, "sh-closing-cross")).keeps("P");
        closes_coming: Event::Test(EdgeTest { idx: [_, 0], rule: Rule::OutIn, .. }) =>
            puts_nothing(test(OUT_IN, "sh-closing")).keeps("P");
        closes_out_out: Event::Test(EdgeTest { idx: [_, 0], rule: Rule::OutOut, .. }) =>
            puts_nothing(test(OUT_OUT, "sh-closing")).about("P");
        in_in: Event::Test(EdgeTest { rule: Rule::InIn, .. }) => puts_end(test(IN_IN, "sh-in-in")).keeps("P");
        in_out: Event::Test(EdgeTest { rule: Rule::InOut, distances, .. }) if is_crossed(distances) =>
            puts_crossing(test(IN_OUT, "sh-in-out")).drops("P");
        leaves: Event::Test(EdgeTest { rule: Rule::InOut, .. }) => puts_nothing(test(IN_OUT, "sh-in-out-touch")).drops("P");
        out_in: Event::Test(EdgeTest { rule: Rule::OutIn, distances, .. }) if is_crossed(distances) =>
            puts_both(test(OUT_IN, "sh-out-in")).keeps("P");
        comes: Event::Test(EdgeTest { rule: Rule::OutIn, .. }) => puts_end(test(OUT_IN, "sh-out-in-touch")).keeps("P");
        out_out: Event::Test(EdgeTest { rule: Rule::OutOut, .. }) => puts_nothing(test(OUT_OUT, "sh-out-out")).drops("P");
        cuts_leaving: Event::Cross { .. } if rule(step) == Some(Rule::InOut) => cross(IN_OUT);
        cuts_coming: Event::Cross { .. } => cross(OUT_IN);
        puts_first: Event::Output { .. } if rule(step).is_none() => output(FIRST);
        puts_in_in: Event::Output { .. } if rule(step) == Some(Rule::InIn) => output(IN_IN);
        puts_in_out: Event::Output { .. } if rule(step) == Some(Rule::InOut) => output(IN_OUT);
        puts_out_in: Event::Output { .. } => output(OUT_IN);
        nothing_left: Event::Pass { n_vertices: 0, .. } => Row::new(Test, PASS, "sh-pass-empty");
        pass: Event::Pass { .. } => Row::new(Test, PASS, "sh-pass");
        empty: Event::Done { outcome: RingOutcome::Empty } => Row::new(Reject, PASS, "sh-done-empty");
        degenerate: Event::Done { outcome: RingOutcome::Degenerate } =>
            Row::new(Reject, PASS, "sh-done-degenerate");
        whole: Event::Done { outcome: RingOutcome::Whole } => Row::new(Accept, PASS, "sh-done-whole");
        cut: Event::Done { outcome: RingOutcome::Cut } => Row::new(Accept, PASS, "sh-done-cut");
    }

    const OPENING: Row = Row::new(Phase, EACH, "sh-opening");

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let Step { input, held, past } = at.step;
        let of_vertex = || of_vertex(at, name);
        let of_edge = || of_edge(at, name);
        Some(match name {
            "n" => held.lists.list().len().into(),
            "edges" => input.region.n_edges().into(),
            _ => {
                let of_test = || Asked::of(past).named(name, vertex_symbol);
                return of_vertex().or_else(of_edge).or_else(of_test);
            }
        })
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let mut watch = at.filled(Self::WATCH);
        let lists = lists_watched(at).into_iter();
        watch.extend(lists.map(|section| section.seen_in(LISTS)));
        watch
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let picture = Picture::of(&at.step);
        let panels = at
            .scenery
            .and_then(|&panels| panels::view(&at.step, panels));
        let drawing = [View::plane(marks(&picture))].into_iter().chain(panels);
        let lists = View::new(LISTS, Body::Lists(lists(&picture)));
        drawing.chain([lists]).collect()
    }
}

fn of_vertex<V: LabVertex, L: Variant>(
    at: &At<'_, SutherlandHodgman<V, L>>,
    name_of: &str,
) -> Option<Named> {
    let asked = Asked::of(at.step.past);
    let event = at.step.event()?;
    let vertex = asked_vertex(&event);
    Some(match (name_of, event) {
        ("vertex", Event::Output { at }) if asked.is_crossing(at) => name("I").into(),
        ("vertex", _) => name(vertex_symbol(asked.place())).into(),
        ("place", _) => {
            let last = at.step.held.lists.other().len().checked_sub(1)?;
            name(output_symbol(last)).into()
        }
        ("at", Event::Output { at }) => at.at().to_array().into(),
        ("P", _) => {
            let mut given = at.step.input.vertices.iter();
            let place = given.position(|given| vertex.is_some_and(|v| v.at() == given.at()));
            Named::from(name(vertex_symbol(asked.place()))).linked(corner_link(place?))
        }
        _ => return None,
    })
}

fn of_edge<V: LabVertex, L: Variant>(
    at: &At<'_, SutherlandHodgman<V, L>>,
    name_of: &str,
) -> Option<Named> {
    let asked = Asked::of(at.step.past);
    let (edge, event) = (edge(&at.step)?, at.step.event()?);
    let symbol = |i: usize| vertex_symbol(asked.test.map_or(0, |test| test.idx[i]));
    Some(match (name_of, event) {
        ("edge", _) => edge.name().into(),
        ("inside", _) => edge.inside().into(),
        ("border", _) => edge.border().into(),
        ("normal", Event::Edge { normal, .. }) => normal.into(),
        ("E", Event::Edge { origin, .. }) => origin.to_array().into(),
        ("uv(I)", Event::Cross(Crossing { at, .. })) => {
            let test = asked.test?;
            let ends = [0, 1].map(|i| NamedVertex {
                symbol: symbol(i),
                vertex: test.ends[i],
            });
            let weights = edge.weights(test.ends.map(|v| v.at()), test.distances);
            at.uv_formula([&ends[0], &ends[1]], &weights)?.into()
        }
        _ => {
            let symbols = [0, 1].map(symbol);
            edge.asked(name_of, &event, (&asked, symbols))?.into()
        }
    })
}

pub fn lists_watched<V: LabVertex, L: Variant>(
    at: &At<'_, SutherlandHodgman<V, L>>,
) -> Vec<WatchSection> {
    let rings = Picture::of(&at.step).rings;
    list_rows(rings.list, rings.output, rings.asked.place())
}
