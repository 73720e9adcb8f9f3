//! Weiler–Atherton, shown.

mod lists;
mod marks;
mod named;
mod names;
mod prelude;
mod standing;
#[cfg(test)]
mod tests;

use crate::{
    algo::polygon::weiler_atherton::{Relation, WeilerAthertonOutput},
    geom::{GeomError, Region},
};

use named::{found_named, label, node_named, ring_named};
use prelude::*;
use standing::place_of;

pseudocode! {
    FIND: 0, "code-wa-find", "words-wa-find";
    INSERT: 0, "code-wa-insert", "words-wa-insert";
    LABEL: 0, "code-wa-label", "words-wa-label";
    START: 0, "code-wa-start", "words-wa-start";
    FOLLOW: 1, "code-wa-follow", "words-wa-follow";
    ENTER: 1, "code-wa-enter", "words-wa-enter";
    LEAVE: 1, "code-wa-leave", "words-wa-leave";
    CLOSE: 1, "code-wa-close", "words-wa-close";
    WHOLE: 0, "code-wa-whole", "words-wa-whole";
    HOLES: 0, "code-wa-holes", "words-wa-holes";
}

const MAX_ROWS: usize = 12;

const P: &[&str] = &["P = {at}"];

const fn vertex(tick: Tick, line: usize, key: &'static str) -> Row {
    Row::new(tick, line, key).so(&["{vertex} = {at}"])
}

const fn found(key: &'static str, option: &'static str) -> Row {
    Row::new(Cut, FIND, key).answers_as("contact", option)
}

/// Of a crossing the distances say it; of any other intersection, where it is.
const fn labelled(tick: Tick, key: &'static str) -> Row {
    const SO: &[&str] = &["a₁ = {a₁}{order}{a₂} = a₂", "{node} = {at}"];
    Row::new(tick, LABEL, key)
        .so(SO)
        .picks_as("label", "labels", "option-label")
}

const fn closed(key: &'static str) -> Row {
    Row::new(Accept, CLOSE, key).so(P).answers("closed")
}

const fn done(tick: Tick, key: &'static str) -> Row {
    Row::new(tick, HOLES, key).answers("relation")
}

fn stays(before: Side, after: Side) -> bool {
    before == after && matches!(before, Side::Inside | Side::Outside)
}

fn pinches(step: &Step<'_, WeilerAtherton>, node: u32) -> bool {
    standing::label(step.held, node) == Some(Pinching)
}

impl PolygonTelling for WeilerAtherton {
    const KNOWS_HOLES: bool = true;
    const SUBJECT: char = 'S';

    fn input(scene: &Scene) -> Result<Input, UnfitScene> {
        let subject = ScenePart::Subject.simple(&scene.subject)?;
        let clip = ScenePart::Clip.simple(&scene.clip_outline())?;
        let holes = scene.holes.iter().enumerate();
        let holes: Vec<_> = holes
            .map(|(i, hole)| ScenePart::Hole(i).simple(hole))
            .collect::<Result<_, _>>()?;
        let subject = Region::new(subject, holes).map_err(|error| match error {
            GeomError::MisplacedHole { hole_idx } => {
                UnfitScene::new(ScenePart::Hole(hole_idx), error)
            }
            error => UnfitScene::new(ScenePart::Subject, error),
        })?;
        Ok(Input { subject, clip })
    }

    fn tells(event: &Event, vertex: Point) -> Option<bool> {
        if let Event::Visit { at, .. } = *event {
            return (at == vertex).then_some(true);
        }
        // The first ring is the one around all others.
        if let Event::Whole {
            list: Subject,
            ring_idx: 0,
            kind,
            ..
        } = *event
        {
            return Some(kind.is_some());
        }
        None
    }

    fn crossing(event: &Event) -> Option<Point> {
        match *event {
            Event::Found { at, .. } => Some(at),
            _ => None,
        }
    }

    /// From where the subject leaves, up to the next intersection; of a ring that is outside, all of it.
    fn dropped(step: &Step<'_, Self>) -> Vec<[Point; 2]> {
        let lists = &step.held.lists;
        let entries = &lists.entries[0];
        let at = |entry: &Entry| lists.at(entry, step.input.subject.rings());
        let mut parts = Vec::new();
        if let Some(Event::Labelled {
            node_idx,
            after: Side::Outside,
            ..
        }) = step.event()
        {
            let from = lists.nodes[node_idx as usize].place(Subject);
            let mut from = from.map(|place| &entries[place]);
            while let Some(entry) = from {
                let next = &entries[entry.next as usize];
                parts.push([at(entry), at(next)]);
                from = next.node().is_none().then_some(next);
            }
        }
        if let Some(Event::Whole {
            list: Subject,
            ring_idx,
            kind: None,
            ..
        }) = step.event()
        {
            let vertices = step.input.subject.rings().ring(ring_idx as usize);
            let next = |i: usize| vertices[(i + 1) % vertices.len()];
            parts.extend((0..vertices.len()).map(|i| [vertices[i], next(i)]));
        }
        parts
    }

    fn piece(step: &Step<'_, Self>) -> Option<Vec<Point>> {
        let is_piece = matches!(
            step.event()?,
            Event::Closed { kind: Outer, .. }
                | Event::Whole {
                    kind: Some(Outer),
                    ..
                }
        );
        let last = step.held.rings.last().filter(|_| is_piece);
        last.map(|ring| ring.points.clone())
    }
}

impl Answer for WeilerAthertonOutput {
    fn told(&self) -> impl Serialize {
        #[derive(Serialize)]
        struct Told<P> {
            polygons: P,
            relation: Relation,
        }
        let rings = || {
            let pieces = self.pieces.iter();
            pieces.flat_map(|piece| std::iter::once(&piece.outer).chain(&piece.holes))
        };
        Told {
            polygons: Each(rings),
            relation: self.relation,
        }
    }
}

impl Telling for WeilerAtherton {
    type Scenery = ();

    const ID: &'static str = "weiler-atherton";
    const NAME_KEY: &'static str = "alg-weiler-atherton";
    const SOURCE: &'static str =
        "K. Weiler, P. Atherton, 1977; G. Greiner, K. Hormann, 1998; E. L. Foster et al., 2019";
    const CODE: &'static [CodeLine] = &LINES;

    const WATCH: &'static [Watched] = &[Watched::Names(&["start", "path", "rings"])];

    table! { |event, step|
        begins: Event::Vertex { list: Subject, vertex_idx: 0, .. } => vertex(Phase, FIND, "wa-vertex-subject");
        vertex: Event::Vertex { list: Subject, .. } => vertex(Test, FIND, "wa-vertex-subject");
        begins_clip: Event::Vertex { list: Clip, vertex_idx: 0, .. } => vertex(Phase, INSERT, "wa-vertex-clip");
        vertex_clip: Event::Vertex { list: Clip, .. } => vertex(Test, INSERT, "wa-vertex-clip");
        crossing: Event::Found { contact: Contact::Crossing, .. } =>
            found("wa-found-crossing", "wa-meet-crossing").so(&["t{=t}", "u{=u}", "{x}", "{y}"]);
        on_clip: Event::Found { contact: Contact::SubjectVertex, .. } =>
            found("wa-found-on-edge", "wa-meet-subject-vertex").so(&["{node} = {at}", "u{=u}"]);
        on_subject: Event::Found { contact: Contact::ClipVertex, .. } =>
            found("wa-found-on-edge", "wa-meet-clip-vertex").so(&["{node} = {at}", "t{=t}"]);
        on_both: Event::Found { contact: Contact::BothVertices, .. } =>
            found("wa-found-both", "wa-meet-both").so(&["{node} = {at}"]);
        inserted: Event::Inserted { at_vertex: false, .. } =>
            Row::new(Cut, INSERT, "wa-inserted").so(&["u{=u}"]).answers("inserted");
        inserted_vertex: Event::Inserted { at_vertex: true, .. } =>
            Row::new(Cut, INSERT, "wa-inserted-vertex").so(&["{node} = {at}"]).answers("inserted");
        first_entering: Event::Labelled { node_idx: 0, label: Entering, .. } => labelled(Phase, "wa-entering");
        entering: Event::Labelled { label: Entering, .. } => labelled(Test, "wa-entering");
        first_leaving: Event::Labelled { node_idx: 0, label: Leaving, .. } => labelled(Phase, "wa-leaving");
        leaving: Event::Labelled { label: Leaving, .. } => labelled(Test, "wa-leaving");
        first_same: Event::Labelled { node_idx: 0, label: Touching, before, after } if stays(before, after) =>
            labelled(Phase, "wa-touching-same");
        same: Event::Labelled { label: Touching, before, after, .. } if stays(before, after) =>
            labelled(Test, "wa-touching-same");
        first_touching: Event::Labelled { node_idx: 0, label: Touching, .. } => labelled(Phase, "wa-touching");
        touching: Event::Labelled { label: Touching, .. } => labelled(Test, "wa-touching");
        first_pinching: Event::Labelled { node_idx: 0, label: Pinching, .. } => labelled(Phase, "wa-pinching");
        pinching: Event::Labelled { label: Pinching, .. } => labelled(Test, "wa-pinching");
        start: Event::Start { .. } =>
            Row::new(Phase, START, "wa-start").so(&["{node} = {at}"]).picks("node", "nodes");
        visit: Event::Visit { list: Subject, corner: true, .. } =>
            Row::new(Test, FOLLOW, "wa-visit-subject").so(P).answers("subject corner").keeps("entry");
        past: Event::Visit { list: Subject, corner: false, .. } =>
            Row::new(Test, FOLLOW, "wa-past").answers("subject corner").drops("entry");
        visit_clip: Event::Visit { list: Clip, corner: true, .. } =>
            Row::new(Test, FOLLOW, "wa-visit-clip").so(P).answers("clip corner").keeps("entry");
        past_clip: Event::Visit { list: Clip, corner: false, .. } =>
            Row::new(Test, FOLLOW, "wa-past").answers("clip corner").drops("entry");
        pinch_clip: Event::Switch { node_idx, to: Clip, .. } if pinches(step, node_idx) =>
            Row::new(Cut, LEAVE, "wa-switch-pinch-clip").answers("switch");
        pinch_subject: Event::Switch { node_idx, to: Subject, .. } if pinches(step, node_idx) =>
            Row::new(Cut, ENTER, "wa-switch-pinch-subject").answers("switch");
        switch_clip: Event::Switch { to: Clip, .. } => Row::new(Cut, LEAVE, "wa-switch-clip").answers("switch");
        switch_subject: Event::Switch { to: Subject, .. } =>
            Row::new(Cut, ENTER, "wa-switch-subject").answers("switch");
        closed_outer: Event::Closed { kind: Outer, .. } => closed("wa-closed-outer");
        closed_hole: Event::Closed { kind: Hole, .. } => closed("wa-closed-hole");
        closed_sliver: Event::Closed { kind: Sliver, .. } => closed("wa-closed-sliver");
        subject_kept: Event::Whole { list: Subject, ring_idx: 0, kind: Some(_), .. } =>
            Row::new(Accept, WHOLE, "wa-whole-subject-kept").answers("whole subject");
        subject_dropped: Event::Whole { list: Subject, ring_idx: 0, kind: None, .. } =>
            Row::new(Reject, WHOLE, "wa-whole-subject-dropped").answers("whole subject");
        hole_kept: Event::Whole { list: Subject, kind: Some(_), .. } =>
            Row::new(Accept, WHOLE, "wa-whole-hole-kept").answers("whole hole");
        hole_dropped: Event::Whole { list: Subject, kind: None, .. } =>
            Row::new(Reject, WHOLE, "wa-whole-hole-dropped").answers("whole hole");
        clip_kept: Event::Whole { list: Clip, kind: Some(_), .. } =>
            Row::new(Accept, WHOLE, "wa-whole-clip-kept").answers("whole clip");
        clip_dropped: Event::Whole { list: Clip, kind: None, .. } =>
            Row::new(Reject, WHOLE, "wa-whole-clip-dropped").answers("whole clip");
        hole: Event::Hole { .. } => Row::new(Test, HOLES, "wa-hole");
        disjoint: Event::Done { relation: Relation::Disjoint } => done(Reject, "wa-done-disjoint");
        touch: Event::Done { relation: Relation::Touching } => done(Reject, "wa-done-touching");
        in_clip: Event::Done { relation: Relation::SubjectInside } => done(Accept, "wa-done-subject");
        in_subject: Event::Done { relation: Relation::ClipInside } => done(Accept, "wa-done-clip");
        equal: Event::Done { relation: Relation::Equal } => done(Accept, "wa-done-equal");
        cross: Event::Done { relation: Relation::Crossing } => done(Accept, "wa-done-crossing");
    }

    const OPENING: Row = Row::new(Phase, FIND, "wa-opening");

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        let (held, input) = (at.step.held, at.step.input);
        let watched = |named: Named, key| Some(named.labelled(Value::Term(key)));
        match (name, at.step.event()) {
            ("start", _) => {
                let start = held.walk.start.map(names::node);
                watched(Named::maybe(start), "wa-row-start")
            }
            ("path", _) => watched(held.walk.path.len().into(), "wa-row-path"),
            ("rings", _) => watched(held.rings.len().into(), "wa-row-rings"),
            ("n", None) => Some(names::border(input, Subject).points().len().into()),
            ("m", None) => Some(names::border(input, Clip).points().len().into()),
            (_, event) => match (event?, node_of(event?)) {
                (event @ Event::Found { .. }, _) => found_named(input, &event, name),
                (event, Some(node_idx)) => node_named(&at.step, event, node_idx, name),
                (event, None) => ring_named(&at.step, event, name),
            },
        }
    }

    fn listed(at: &At<'_, Self>, list: &str) -> Vec<Named> {
        let held = at.step.held;
        match list {
            "labels" => [Entering, Leaving, Touching, Pinching]
                .map(|it| label(it).into())
                .into(),
            "nodes" => (0..held.lists.nodes.len())
                .map(|idx| idx as u32)
                .map(|idx| Named::from(names::node(idx)).linked(names::node_link(idx)))
                .collect(),
            _ => Vec::new(),
        }
    }

    fn watch(at: &At<'_, Self>) -> Watch {
        let names = Self::WATCH.iter().map(|watched| at.section(watched));
        let lists = [Subject, Clip].map(|list| list_section(&at.step, list));
        lists.into_iter().chain(names).collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        vec![
            View::plane(marks::marks(&at.step)),
            View::new(lists::VIEW, Body::Lists(lists::lists(&at.step))),
        ]
    }
}

const fn node_of(event: Event) -> Option<u32> {
    if let Event::Found { node_idx, .. }
    | Event::Inserted { node_idx, .. }
    | Event::Labelled { node_idx, .. }
    | Event::Start { node_idx }
    | Event::Switch { node_idx, .. } = event
    {
        Some(node_idx)
    } else {
        None
    }
}

/// A list about the place where it is being built, labelled or walked: of each entry what it says.
fn list_section(step: &Step<'_, WeilerAtherton>, list: List) -> WatchSection {
    let (held, input) = (step.held, step.input);
    let entries = &held.lists.entries[list.idx()];
    let reach = ListColumn::reach_of(MAX_ROWS, entries.len(), current_place(step, list));
    let first = reach.start;
    let row = |place: usize| {
        let entry = &entries[place];
        let text = Formula::default().sym(names::entry(input, list, entry));
        let label = entry.node().and_then(|node| standing::label(held, node));
        let text = match label {
            Some(label) => text.sym(" ").term(names::label_key(label)),
            None => text,
        };
        WatchRow {
            link: entry.node().map(names::node_link),
            ..WatchRow::new(name((place + 1).to_string()), Some(Value::Formula(text)))
        }
    };
    let column = match list {
        Subject => "S",
        Clip => "C",
    };
    WatchSection::table(vec![column], reach.map(row).collect())
        .part(first, entries.len())
        .seen_in(lists::VIEW)
}

fn current_place(step: &Step<'_, WeilerAtherton>, list: List) -> Option<usize> {
    let event = step.event()?;
    if let Event::Vertex { list: built, .. } = event {
        let last = step.held.lists.entries[list.idx()].len().checked_sub(1);
        return last.filter(|_| built == list);
    }
    match node_of(event) {
        Some(node) => place_of(step.held, list, node),
        None => {
            let (walked, place) = step.held.walk.position?;
            (walked == list).then_some(place as usize)
        }
    }
}
