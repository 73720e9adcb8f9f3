//! A triangle against planes as one polygon, shown.

use crate::{
    algo::{
        ring::{EdgeTest, Known, Rule},
        volume::{CutTriangles, IntersectionPolygonEvent as Event},
    },
    labs::rings::{is_crossed, puts_both, puts_crossing, puts_end, puts_nothing},
};

use super::{
    list_view::{fan_lists, lists},
    one_polygon_marks::{
        checkered, checkered_on_screen, compared, fan, is_fan_shown, marks, parts, plane_idx, rings,
    },
    prelude::*,
    variant::polygon,
};

type Shown<L> = IntersectionPolygon<L>;

impl Answer for CutTriangles {
    fn told(&self) -> impl Serialize {
        let uv = || self.triangles.iter().map(|piece| piece.map(|v| v.uv));
        ToldTriangles {
            triangles: Each(|| self.triangles.iter().map(|piece| piece.map(|v| v.at))),
            uv: self.has_uv.then_some(Each(uv)),
        }
    }
}

impl<L: Variant<OnePolygon>> SpaceTelling for Shown<L> {
    const SUBJECT: Subject = Subject::Triangle;
    // What is wrong with it comes after all steps: no step differs.
    const GROUP_KEY: Option<&'static str> = if L::IS_EVEN_ON_SCREEN {
        Some("faulty-title")
    } else {
        Self::SUBJECT.group_key()
    };

    fn input(scene: &Scene) -> TrianglePlanes {
        variant::input(scene, L::IS_TEXTURED)
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let recording = Recording::<Self>::new(Self::input(scene));
        let parts = of_polygon(recording.input().triangle, recording.events());
        parts.verdict(scene, about, |v| v.at, run)
    }
}

const fn test(key: &'static str) -> Row {
    Row::new(Test, polygon::DISTANCE, key).so(&["{distance}"])
}

const fn first(key: &'static str) -> Row {
    let row = Row::new(Test, polygon::FIRST, key);
    row.so(&["{distance}"]).answers("first")
}

const fn output(line: usize) -> Row {
    Row::new(Test, line, "ip-output").so(&["{vertex} = {at}"])
}

const fn pass(key: &'static str) -> Row {
    let row = Row::new(Test, polygon::PASS, key);
    row.so(&["{t of C₁}", "{t of C₂}", "{t of C₃}"])
}

fn dropped(rings: &RingStep<'_, SpaceVertex>) -> Vec<String> {
    let sides = rings.turn.sides.iter().enumerate();
    let dropped = sides.filter(|(_, (_, inside))| !inside);
    dropped.map(|(i, _)| vertex_symbol(i)).collect()
}

impl<L: Variant<OnePolygon>> Telling for Shown<L> {
    type Scenery = Scenery;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Sutherland & Hodgman, 1974";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[Watched::Names(&["normal", "D", "t"])];
    const OPENING: Row = Row::new(Phase, polygon::EACH, "ip-opening");

    table! { |event, step|
        plane: Event::Plane { .. } =>
            Row::new(Phase, polygon::EACH, "ip-plane").so(&["n = {normal}", "D{=D}"]);
        first_inside: Event::First(Known { inside: true, .. }) => first("ip-first-inside").keeps("P");
        first_outside: Event::First { .. } => first("ip-first-outside").drops("P");
        // The edge that closes the ring puts out a crossing at most: its end has been asked before.
        closes_cut: Event::Test(EdgeTest { idx: [_, 0], rule: Rule::InOut | Rule::OutIn, distances, .. })
            if is_crossed(distances) => puts_crossing(test("ip-closing-cross")).about("P");
        closes: Event::Test(EdgeTest { idx: [_, 0], .. }) => puts_nothing(test("sh-closing")).about("P");
        in_in: Event::Test(EdgeTest { rule: Rule::InIn, .. }) => puts_end(test("sh-in-in")).keeps("P");
        out_out: Event::Test(EdgeTest { rule: Rule::OutOut, .. }) => puts_nothing(test("sh-out-out")).drops("P");
        in_out: Event::Test(EdgeTest { rule: Rule::InOut, distances, .. }) if is_crossed(distances) =>
            puts_crossing(test("ip-in-out")).drops("P");
        leaves: Event::Test(EdgeTest { rule: Rule::InOut, .. }) => puts_nothing(test("ip-touch")).drops("P");
        out_in: Event::Test(EdgeTest { rule: Rule::OutIn, distances, .. }) if is_crossed(distances) =>
            puts_both(test("ip-out-in")).keeps("P");
        comes: Event::Test(EdgeTest { rule: Rule::OutIn, .. }) => puts_end(test("ip-touch")).keeps("P");
        cuts: Event::Cross { .. } =>
            Row::new(Cut, polygon::CROSS, "ip-cross").so(&["{t of d}", "{place of cut}"]);
        puts_cut: Event::Output { at } if rings(step).asked.is_crossing(at) => output(polygon::CROSS);
        puts_first: Event::Output { .. } if rings(step).asked.test.is_none() => output(polygon::FIRST);
        puts: Event::Output { .. } => output(polygon::INSIDE);
        pass_empty: Event::Pass { n_vertices: 0, .. } => pass("ip-pass-empty");
        pass_same: Event::Pass { .. } if dropped(&rings(step)).is_empty() => pass("ip-pass-same");
        pass_drops: Event::Pass { .. } if rings(step).turn.crossings.is_empty() =>
            pass("ip-pass-drops");
        pass_cuts: Event::Pass { .. } => pass("ip-pass-cuts");
        fan: Event::Fan { .. } => Row::new(Test, polygon::FAN, "ip-fan");
        empty: Event::Done { n_triangles: 0 } => Row::new(Reject, polygon::FAN, "ip-done-empty");
        done: Event::Done { .. } => Row::new(Accept, polygon::FAN, "ip-done");
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let Step { input, held, .. } = at.step;
        let rings = rings(&at.step);
        let of_plane = || of_plane(name, &input.planes, plane_idx(&at.step), at.scenery);
        let of_vertex = || of_vertex(at, &rings, name);
        let of_test = || rings.asked.named(name, vertex_symbol);
        Some(match (name, at.step.event()) {
            ("n", None) => input.triangle.len().into(),
            ("n", Some(Event::Output { .. })) => rings.output.len().into(),
            ("n", Some(Event::Fan { .. } | Event::Done { .. })) => held.left.triangles.len().into(),
            ("n" | "after" | "vertices", _) => rings.list.len().into(),
            ("total", _) => rings.list.len().saturating_sub(2).into(),
            ("crossings", _) => held.left.n_crossings.into(),
            ("before", _) => rings.passed.len().into(),
            ("dropped", _) => names(dropped(&rings)).into(),
            ("cuts", _) => names((0..rings.turn.crossings.len()).map(cut_symbol)).into(),
            ("corners", Some(Event::Fan { triangle })) => {
                let corner = |v: &SpaceVertex| rings.list.iter().position(|other| other == v);
                names(triangle.iter().filter_map(corner).map(vertex_symbol)).into()
            }
            _ => return of_plane().or_else(of_vertex).or_else(of_test),
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let At { step, scenery } = *at;
        let own = step.input;
        let mut views = Vec::new();
        if let Some(scenery) = scenery {
            views.push(scenery.observer(|_| Fate::ToCome, marks(&step, scenery)));
            if L::IS_TEXTURED {
                let fan = fan(&step);
                let camera = scenery.scene().culler();
                let even = L::IS_EVEN_ON_SCREEN.then(|| checkered_on_screen(&fan, camera));
                let mut seen = even.unwrap_or_else(|| checkered(&fan));
                if is_about_pictures(Some(scenery)) {
                    seen.extend(compared::<L>(&fan, camera));
                }
                views.push(scenery.camera(|_| Fate::ToCome, |_, _| FaceLook::Whole, seen));
            }
        }
        if !is_about_pictures(scenery) {
            let fan = &step.held.left.triangles;
            let lists = if is_fan_shown(&step, scenery) {
                fan_lists(&parts(&step), step.held.lists.list(), fan)
            } else {
                let plane = plane_idx(&step).is_some();
                let now = (step.event(), plane, !scenery.is_none_or(is_alone));
                lists(own, &parts(&step), &rings(&step), now)
            };
            views.push(View::new(LISTS_VIEW, Body::Lists(lists)));
        }
        let has_more = |scenery: &&Scenery| !L::IS_TEXTURED && is_alone(scenery);
        if let Some(scenery) = scenery.filter(has_more) {
            views.push(small_view::<Self>(own, progress(&step), scenery));
        }
        views.extend(agreement_view(scenery));
        views
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let RingStep { list, output, .. } = rings(&at.step);
        let section = |ring: &[SpaceVertex], prime: &str| {
            vertex_rows(ring.iter().map(|v| place(v.at)), prime, at.scenery)
        };
        let first = at.section(&Self::WATCH[0]);
        let mut sections = vec![first, section(list, ""), section(output, "′")];
        if at.scenery.is_some() {
            let n_done = progress(&at.step).n_done;
            sections.push(tally::<Self, PlaneAtATime>(at.step.input, n_done));
        }
        sections
    }
}

fn of_vertex<L: Variant<OnePolygon>>(
    at: &At<'_, Shown<L>>,
    rings: &RingStep<'_, SpaceVertex>,
    name_of: &str,
) -> Option<Named> {
    let (event, RingStep { turn, asked, .. }) = (at.step.event()?, rings);
    let n_cuts = turn.crossings.len();
    let of_cut = |nth: usize| {
        let (idx, _) = turn.crossings.get(nth)?;
        let d = [turn.sides.get(idx[0])?.0, turn.sides.get(idx[1])?.0];
        Some(parameter(&format!("t({})", cut_symbol(nth)), *idx, d))
    };
    Some(match (name_of, event) {
        ("vertex", Event::Output { at }) if asked.is_crossing(at) => {
            name(cut_symbol(n_cuts.saturating_sub(1))).into()
        }
        ("vertex", _) => name(vertex_symbol(asked.place())).into(),
        ("at", Event::Output { at }) => place(at.at).into(),
        ("P", _) => {
            let link = parts(&at.step).link(&asked_now(&event)?.at)?;
            Named::from(name(vertex_symbol(asked.place()))).linked(link)
        }
        ("distance", _) => {
            let plane = at.step.input.planes.get(plane_idx(&at.step)?)?;
            let known = asked_now(&event)?;
            distance(plane, asked.place(), known.at.at, known.distance).into()
        }
        ("cut", Event::Test { .. }) => name(cut_symbol(n_cuts)).into(),
        ("t of C₁", Event::Pass { .. }) => of_cut(0)?.into(),
        ("t of C₂", Event::Pass { .. }) => of_cut(1)?.into(),
        ("t of C₃", Event::Pass { .. }) => of_cut(2)?.into(),
        (_, Event::Cross(Crossing { at, .. })) => {
            let EdgeTest { idx, distances, .. } = asked.test?;
            named_cut(name_of, n_cuts - 1, (idx, distances), &at)?
        }
        _ => return None,
    })
}

fn progress<L: Variant<OnePolygon>>(step: &Step<'_, Shown<L>>) -> Progress {
    let is_over = matches!(step.event(), Some(Event::Fan { .. } | Event::Done { .. }));
    let has_passed = matches!(step.event(), Some(Event::Pass { .. }));
    let n_planes = step.input.planes.len();
    Progress::at(plane_idx(step), has_passed, is_over, n_planes)
}
