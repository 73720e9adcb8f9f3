//! A triangle against planes, triangle by triangle, shown.

use crate::algo::volume::PlaneAtATimeEvent as Event;

use super::{
    pieces_view::{AskedTriangle, Pieces, pieces},
    prelude::*,
    variant::one_by_one,
};

/// Of more triangles only the one that is asked has its name in the picture.
const MOST_NAMED: usize = 8;

type Shown<L> = PlaneAtATime<L>;

impl<L: Variant<OneByOne>> SpaceTelling for Shown<L> {
    const SUBJECT: Subject = Subject::Triangle;

    fn input(scene: &Scene) -> TrianglePlanes {
        variant::input(scene, L::IS_TEXTURED)
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let recording = Recording::<Self>::new(Self::input(scene));
        let parts = of_triangles(recording.input().triangle, recording.events());
        parts.verdict(scene, about, |v| v.at, run)
    }
}

const fn asked(line: usize, key: &'static str, option: &'static str) -> Row {
    Row::new(Test, line, key)
        .so(&["d₀{=d₀}", "d₁{=d₁}", "d₂{=d₂}"])
        .answers_as("inside", option)
}

const fn cross(line: usize) -> Row {
    Row::new(Cut, line, "ip-cross").so(&["{t of d}", "{place of cut}"])
}

fn count(inside: [bool; 3]) -> usize {
    inside.into_iter().filter(|&inside| inside).count()
}

fn count_on(inside: [bool; 3], distances: [f64; 3]) -> usize {
    (0..3).filter(|&i| inside[i] && distances[i] == 0.0).count()
}

fn n_inside<L: Variant<OneByOne>>(step: &Step<'_, Shown<L>>) -> usize {
    let asked = step.past.iter().rev().find_map(|event| match *event {
        Event::Triangle { inside, .. } => Some(count(inside)),
        _ => None,
    });
    asked.unwrap_or_default()
}

impl<L: Variant<OneByOne>> Telling for Shown<L> {
    type Scenery = Scenery;

    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = "Eberly, 2006";
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;
    const WATCH: &'static [Watched] = &[Watched::Names(&["normal", "D", "t"])];
    const OPENING: Row = Row::new(Phase, one_by_one::EACH, "pat-opening");

    table! { |event, step|
        plane: Event::Plane { .. } =>
            Row::new(Phase, one_by_one::EACH, "pat-plane").so(&["n = {normal}", "D{=D}"]);
        none: Event::Triangle { inside: [false, false, false], .. } =>
            asked(one_by_one::NONE, "pat-none", "pat-option-none").drops("triangle");
        three: Event::Triangle { inside: [true, true, true], .. } =>
            asked(one_by_one::THREE, "pat-three", "pat-option-three").keeps("triangle");
        on_one: Event::Triangle { inside, distances, .. }
            if count(inside) == 1 && count_on(inside, distances) > 0 =>
            asked(one_by_one::ONE, "pat-on", "pat-option-one").cuts("triangle");
        one: Event::Triangle { inside, .. } if count(inside) == 1 =>
            asked(one_by_one::ONE, "pat-one", "pat-option-one").cuts("triangle");
        on_two: Event::Triangle { inside, distances, .. } if count_on(inside, distances) > 0 =>
            asked(one_by_one::TWO, "pat-on", "pat-option-two").cuts("triangle");
        two: Event::Triangle { .. } =>
            asked(one_by_one::TWO, "pat-two", "pat-option-two").cuts("triangle");
        cuts_one: Event::Cross { .. } if n_inside(step) == 1 => cross(one_by_one::ONE);
        cuts: Event::Cross { .. } => cross(one_by_one::TWO);
        piece_of_one: Event::Piece { .. } if n_inside(step) == 1 =>
            Row::new(Test, one_by_one::ONE, "pat-piece");
        piece_of_two: Event::Piece { .. } if n_inside(step) == 2 =>
            Row::new(Test, one_by_one::TWO, "pat-piece");
        piece: Event::Piece { .. } => Row::new(Test, one_by_one::THREE, "pat-piece");
        pass_empty: Event::Pass { n_triangles: 0, .. } =>
            Row::new(Test, one_by_one::PASS, "pat-pass-empty");
        pass: Event::Pass { .. } => Row::new(Test, one_by_one::PASS, "pat-pass");
        empty: Event::Done { n_triangles: 0 } =>
            Row::new(Reject, one_by_one::PASS, "pat-done-empty");
        done: Event::Done { .. } => Row::new(Accept, one_by_one::PASS, "pat-done");
    }

    fn named(at: &At<'_, Self>, name_of: &str) -> Option<Named> {
        let Step { input, held, .. } = at.step;
        let now = Pieces::of(&at.step);
        let of_plane = || of_plane(name_of, &input.planes, now.plane_idx, at.scenery);
        Some(match (name_of, at.step.event()) {
            ("n", Some(Event::Piece { .. })) => now.next.len().into(),
            ("n" | "after", _) => held.left.triangles.len().into(),
            ("before", _) => now.passed.len().into(),
            ("crossings", _) => held.left.n_crossings.into(),
            _ => return of_plane().or_else(|| of_triangle(&now, at.step.event()?, name_of)),
        })
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let At { step, scenery } = *at;
        let (own, now) = (step.input, Pieces::of(&step));
        let mut views = Vec::new();
        if let Some(scenery) = scenery {
            views.push(scenery.observer(|_| Fate::ToCome, marks(&step, &now, scenery)));
        }
        let is_compared = !scenery.is_none_or(is_alone);
        let lists = Body::Lists(pieces(&now, step.event(), is_compared));
        views.push(View::new(LISTS_VIEW, lists));
        if let Some(scenery) = scenery.filter(|scenery| is_alone(scenery)) {
            views.push(small_view::<Self>(own, progress(&step, &now), scenery));
        }
        views
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let (own, now) = (at.step.input, Pieces::of(&at.step));
        let list = |list: &[[SpaceVertex; 3]], prime: &str| {
            let row = |(i, triangle): (usize, &[SpaceVertex; 3])| {
                let symbol = format!("{}{prime}", triangle_symbol(i));
                let corners = triangle.iter().map(|v| Some(place(v.at)));
                WatchRow::table(name(symbol), corners.collect())
            };
            let rows = list.iter().enumerate().map(row).collect();
            WatchSection::table(vec!["V₀", "V₁", "V₂"], rows).seen_in(LISTS_VIEW)
        };
        let mut sections = vec![at.section(&Self::WATCH[0]), list(now.list, "")];
        if !now.next.is_empty() {
            sections.push(list(now.next, "′"));
        }
        if at.scenery.is_some() {
            let n_done = progress(&at.step, &now).n_done;
            sections.push(tally::<IntersectionPolygon, Self>(own, n_done));
        }
        sections
    }
}

fn of_triangle(now: &Pieces<'_>, event: Event, name_of: &str) -> Option<Named> {
    let asked = now.asked.last();
    let distance = |i: usize| Some(Named::from(asked?.distances[i]));
    Some(match (name_of, event) {
        ("d₀", Event::Triangle { .. }) => distance(0)?,
        ("d₁", Event::Triangle { .. }) => distance(1)?,
        ("d₂", Event::Triangle { .. }) => distance(2)?,
        ("triangle", _) => {
            let idx = asked?.triangle_idx;
            Named::from(name(triangle_symbol(idx))).linked(triangle_link(idx))
        }
        ("inside", _) => count(asked?.inside).into(),
        ("on", _) => count_on(asked?.inside, asked?.distances).into(),
        ("t", _) => {
            let (num, den) = now.crossings().last().map(|(_, c)| (c.t.num, c.t.den))?;
            Value::Ratio { num, den }.into()
        }
        ("corners", Event::Piece { triangle }) => {
            let given = now.list.get(asked?.triangle_idx)?;
            names(asked?.corners(given, &triangle)).into()
        }
        (_, Event::Cross { idx, at, .. }) => {
            let nth = now.crossings().len().checked_sub(1)?;
            let distances = idx.map(|i| asked.map_or(0.0, |asked| asked.distances[i]));
            named_cut(name_of, nth, (idx, distances), &at)?
        }
        _ => return None,
    })
}

fn progress<L: Variant<OneByOne>>(step: &Step<'_, Shown<L>>, now: &Pieces<'_>) -> Progress {
    let has_passed = matches!(step.event(), Some(Event::Pass { .. }));
    let n_planes = step.input.planes.len();
    Progress::at(now.plane_idx, has_passed, now.is_done, n_planes)
}

fn marks<L: Variant<OneByOne>>(
    step: &Step<'_, Shown<L>>,
    now: &Pieces<'_>,
    scenery: &Scenery,
) -> Vec<Mark3> {
    let own = step.input;
    let parts = of_triangles(own.triangle, step.past);
    let mut marks = given(&own.triangle.map(|v| v.at));
    let has_passed = matches!(step.event(), Some(Event::Pass { .. }));
    let plane = now.plane_idx.and_then(|i| own.planes.get(i));
    let list = if has_passed { now.passed } else { now.list };
    if let Some((plane_idx, plane)) = now.plane_idx.zip(plane) {
        marks.extend(plane_mark(scenery, plane_idx));
        marks.extend(list.iter().filter_map(|triangle| lost(triangle, plane)));
    }
    let asked = now.asked.last().filter(|_| plane.is_some() && !has_passed);
    let is_measured = has_passed && !is_alone(scenery);
    for (i, triangle) in now.list.iter().enumerate() {
        let is_asked = asked.is_some_and(|asked| asked.triangle_idx == i);
        if plane.is_none() || has_passed || is_asked {
            let kept = kept(places(triangle), Role::Accent).into_iter();
            marks.extend(kept.map(|mark| mark.linked(triangle_link(i))));
        } else {
            let outline = Mark3::new(Role::Accent, Shape3::Outline(places(triangle)));
            marks.push(outline.fine().linked(triangle_link(i)));
        }
        let has_room = now.list.len() <= MOST_NAMED && !is_measured;
        marks.extend((has_room || is_asked).then(|| triangle_label(i, triangle)));
    }
    if let ([asked], true) = (&now.asked[..], is_measured) {
        marks.extend(products::<L>(asked, &now.passed[asked.triangle_idx]));
        marks.extend(parts.cuts_of(&asked.crossings));
    }
    if let Some(asked) = asked {
        let triangle = &now.list[asked.triangle_idx];
        for (i, v) in triangle.iter().enumerate() {
            marks.push(parts.linked(vertex(i, v, Some(asked.inside[i])), v));
        }
        let new = now.origins.iter().zip(now.next);
        let new = new.filter(|(origin, _)| **origin == asked.triangle_idx);
        let outline = |piece| Mark3::new(Role::Accent, Shape3::Outline(places(piece)));
        marks.extend(new.map(|(_, piece)| outline(piece)));
        marks.extend(parts.cuts_of(now.crossings()));
    }
    marks
}

/// The corners with their distances, and at each edge what they say of it: a cut where their product is negative.
fn products<L: Variant<OneByOne>>(
    asked: &AskedTriangle,
    triangle: &[SpaceVertex; 3],
) -> Vec<Mark3> {
    let d = asked.distances;
    let corners = triangle.iter().zip(asked.inside).enumerate();
    let corner = |(i, (v, inside))| vertex(i, v, Some(inside)).labelled(measured(i, d[i]));
    let edges = [[0, 1], [0, 2], [1, 2]].map(|[a, b]| {
        let product = sym(format!("d{}·d{}", subscript(a), subscript(b)));
        let said = if a == 0 || L::CUTS_FROM_PLANE {
            let relation = if d[a] * d[b] < 0.0 { " < 0" } else { "" };
            product.equals(d[a] * d[b]).sym(relation)
        } else {
            product.sym(" ").term("tri-not-asked")
        };
        label_amid(&[triangle[a], triangle[b]], said)
    });
    corners.map(corner).chain(edges).collect()
}
