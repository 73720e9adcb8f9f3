//! A triangle before the divide, shown.

use crate::algo::{
    ring::{EdgeTest, Known},
    volume::ClipPolygon,
};

use super::{
    clip_space::{Event, Uv, Vertex, bound_symbol, in_world, point, triangle},
    homogeneous_views::{BITS_VIEW, Picture, bits, camera_marks, lists, observer_marks, screens},
    prelude::*,
    variant::homogeneous,
};

type Shown<L> = HomogeneousTriangle<Uv, L>;

impl Answer for ClipPolygon<Uv> {
    fn told(&self) -> impl Serialize {
        let uv = || self.triangles().map(|piece| piece.map(|v| v.attributes));
        let has_uv = self.first_given().attributes.is_some();
        ToldTriangles {
            triangles: Each(|| self.triangles().map(|piece| piece.map(|v| v.at))),
            uv: has_uv.then_some(Each(uv)),
        }
    }
}

impl<L: Variant<Homogeneous>> SpaceTelling for Shown<L> {
    const SUBJECT: Subject = Subject::Triangle;

    fn input(scene: &Scene) -> [Vertex; 3] {
        triangle(scene)
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let recording = Recording::<Self>::new(Self::input(scene));
        let parts = in_clip_space(*recording.input(), recording.events());
        parts.verdict(scene, about, |v| in_world(v, scene), run)
    }
}

const fn codes(key: &'static str) -> Row {
    let row = Row::new(Phase, homogeneous::CODES, key);
    row.so(&["OR = {OR}", "AND = {AND}"]).answers("codes")
}

const fn asked(line: usize, key: &'static str) -> Row {
    let row = Row::new(Test, line, key);
    row.so(&["{bound of P}"]).answers("side")
}

fn rings<'a, L: Variant<Homogeneous>>(step: &Step<'a, Shown<L>>) -> RingStep<'a, Vertex> {
    let is_turn = |event: &Event| matches!(event, Event::Side { .. });
    RingStep::of(step.held, step.past, is_turn)
}

fn side(past: &[Event]) -> Option<VolumeSide> {
    let is_over = matches!(past.last(), Some(Event::Done { .. }));
    let mut turns = past.iter().rev().filter(|_| !is_over);
    turns.find_map(|event| match *event {
        Event::Side { side } => Some(side),
        _ => None,
    })
}

fn codes_in(past: &[Event]) -> Option<([SideCode; 3], SideCode, SideCode)> {
    past.iter().find_map(|event| match *event {
        Event::Codes { codes, or, and } => Some((codes, or, and)),
        _ => None,
    })
}

fn picture<'a, L: Variant<Homogeneous>>(step: &Step<'a, Shown<L>>) -> Picture<'a> {
    Picture {
        rings: rings(step),
        parts: in_clip_space(*step.input, step.past),
        codes: codes_in(step.past),
        side: side(step.past),
        event: step.event(),
    }
}

impl<L: Variant<Homogeneous>> Telling for Shown<L> {
    type Scenery = Scenery;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Blinn & Newell, 1978";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "code(V₀)",
        "code(V₁)",
        "code(V₂)",
        "OR",
        "AND",
        "t",
    ])];
    const OPENING: Row = Row::new(Phase, homogeneous::CODES, "ht-opening");

    table! { |event, step|
        divide: Event::Divide { .. } => Row::new(Phase, homogeneous::CODES, "ht-divide")
            .so(&["V₀/w = {V₀/w}", "V₁/w = {V₁/w}", "V₂/w = {V₂/w}"]);
        outside: Event::Codes { and, .. } if !and.is_inside() => codes("ht-codes-outside");
        inside: Event::Codes { or, .. } if or.is_inside() => codes("ht-codes-inside");
        cut: Event::Codes { .. } => codes("ht-codes-cut");
        side: Event::Side { .. } =>
            Row::new(Phase, homogeneous::EACH, "ht-side").so(&["{bound} ≥ 0"]);
        first_inside: Event::First(Known { inside: true, .. }) =>
            asked(homogeneous::FIRST, "ht-inside").keeps("P");
        first_outside: Event::First { .. } => asked(homogeneous::FIRST, "ht-outside").drops("P");
        test_inside: Event::Test(EdgeTest { rule, .. }) if rule.ends_inside() =>
            asked(homogeneous::BOUND, "ht-inside").keeps("P");
        // Of the edge that closes the ring the end has been asked before.
        closes: Event::Test(EdgeTest { idx: [_, 0], .. }) =>
            asked(homogeneous::BOUND, "ht-outside").about("P");
        test_outside: Event::Test { .. } => asked(homogeneous::BOUND, "ht-outside").drops("P");
        cuts: Event::Cross { .. } =>
            Row::new(Cut, homogeneous::CROSS, "ht-cross").so(&["t{=t of I}", "I = {at}"]);
        puts_cut: Event::Output { at } if rings(step).asked.is_crossing(at) =>
            Row::new(Test, homogeneous::CROSS, "ip-output");
        puts_first: Event::Output { .. } if rings(step).asked.test.is_none() =>
            Row::new(Test, homogeneous::FIRST, "ip-output");
        puts: Event::Output { .. } => Row::new(Test, homogeneous::INSIDE, "ip-output");
        pass: Event::Pass { .. } => Row::new(Test, homogeneous::EACH, "ht-pass");
        nothing: Event::Done { n_vertices: 0 } =>
            Row::new(Reject, homogeneous::DECIDE, "ht-done-empty");
        no_area: Event::Done { n_vertices: 1 | 2 } =>
            Row::new(Reject, homogeneous::FAN, "ht-done-empty");
        done: Event::Done { .. } => Row::new(Accept, homogeneous::FAN, "ht-done");
    }

    fn named(at: &At<'_, Self>, name_of: &str) -> Option<Named> {
        let past = at.step.past;
        let rings = rings(&at.step);
        let code = |i: usize| Some(name(codes_in(past)?.0[i].to_string()).into());
        let of_vertex = || of_vertex(at, &rings, name_of);
        let n_vertices = rings.list.len();
        Some(match (name_of, at.step.event()) {
            ("n", Some(Event::Output { .. })) => rings.output.len().into(),
            ("n", _) => n_vertices.into(),
            ("before", _) => rings.passed.len().into(),
            ("triangles", _) => n_vertices.saturating_sub(2).into(),
            ("behind", _) => {
                let behind = at.step.input.iter().filter(|v| v.at[3] <= 0.0);
                behind.count().into()
            }
            ("sides", _) => {
                let (_, or, _) = codes_in(past)?;
                let sides = SideCode::WRITTEN.into_iter().filter(|&side| or.has(side));
                sides.count().into()
            }
            ("side", _) => side_named(side(past)?),
            ("bound", _) => name(bound_symbol(side(past)?)).into(),
            ("code(V₀)", _) => code(0)?,
            ("code(V₁)", _) => code(1)?,
            ("code(V₂)", _) => code(2)?,
            ("OR", _) => name(codes_in(past)?.1.to_string()).into(),
            ("AND", _) => name(codes_in(past)?.2.to_string()).into(),
            _ => return of_vertex().or_else(|| rings.asked.named(name_of, vertex_symbol)),
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let At { step, scenery } = *at;
        let now = picture(&step);
        let mut views = Vec::new();
        let has_more = scenery.is_none_or(is_alone);
        if let Some(scenery) = scenery {
            let marks = observer_marks(&now, scenery);
            views.push(scenery.observer(|_| Fate::ToCome, marks));
        }
        if L::DIVIDES_FIRST && scenery.is_some() {
            views.push(screens(&now, step.input));
        } else if let Some(scenery) = scenery.filter(|_| has_more) {
            let marks = camera_marks(&now, scenery);
            views.push(scenery.camera(|_| Fate::ToCome, |_, _| FaceLook::Whole, marks));
        }
        let shows_values = !L::DIVIDES_FIRST;
        if has_more && shows_values {
            views.push(View::new(BITS_VIEW, Body::Bits(bits(&now))));
        }
        if shows_values && !is_about_pictures(scenery) {
            views.push(View::new(LISTS_VIEW, Body::Lists(lists(&now))));
        }
        views.extend(agreement_view(scenery));
        views
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let RingStep { list, output, .. } = rings(&at.step);
        let section = |polygon: &[Vertex], prime: &str| {
            let places = polygon.iter().map(|v| Value::Formula(point(v.at)));
            vertex_rows(places, prime, at.scenery)
        };
        let mut first = at.section(&Self::WATCH[0]);
        if !L::DIVIDES_FIRST && at.scenery.is_none_or(is_alone) {
            first = first.seen_in(BITS_VIEW);
        }
        vec![first, section(list, ""), section(output, "′")]
    }
}

fn of_vertex<L: Variant<Homogeneous>>(
    at: &At<'_, Shown<L>>,
    rings: &RingStep<'_, Vertex>,
    name_of: &str,
) -> Option<Named> {
    let (event, asked) = (at.step.event()?, rings.asked);
    let over_w = |i: usize| {
        let [x, y, z, _] = rings.list.get(i)?.at;
        Some(Formula::default().place([x, y, z]).into())
    };
    Some(match (name_of, event) {
        ("V₀/w", Event::Divide { .. }) => over_w(0)?,
        ("V₁/w", Event::Divide { .. }) => over_w(1)?,
        ("V₂/w", Event::Divide { .. }) => over_w(2)?,
        ("vertex", Event::Output { at }) if asked.is_crossing(at) => name("I").into(),
        ("vertex", _) => name(vertex_symbol(asked.place())).into(),
        ("P", _) => {
            let parts = in_clip_space(*at.step.input, at.step.past);
            let link = parts.link(&asked_now(&event)?.at)?;
            Named::from(name(vertex_symbol(asked.place()))).linked(link)
        }
        ("bound of P", _) => {
            let known = asked_now(&event)?;
            bound(side(at.step.past)?, known.at.at, known.distance).into()
        }
        ("t of I", Event::Cross(Crossing { t, .. })) => (t.num / t.den).into(),
        ("at", Event::Cross(Crossing { at, .. })) => point(at.at).into(),
        _ => return None,
    })
}

/// `w − x = 3 − 5 = −2 < 0`
fn bound(side: VolumeSide, at: [f64; 4], d: f64) -> Formula {
    let sign = if side.is_high() { " − " } else { " + " };
    let formula = sym(format!("{} = ", bound_symbol(side)))
        .num(at[3])
        .sym(sign);
    let formula = formula.operand(at[side.axis()]).equals(d);
    formula.sym(if d < 0.0 { " < 0" } else { " ≥ 0" })
}
