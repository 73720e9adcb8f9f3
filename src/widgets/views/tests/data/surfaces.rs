//! What the surfaces lab holds: what must come before what, as in the prototype B2, and trees; and what has come to a pixel,
//! as in the prototype B4.

use std::cmp::Ordering;

use super::*;

fn node(of: &str, shade: f64) -> GraphNode {
    GraphNode {
        name: name(of),
        tone: (Role::Soft, shade),
        role: Role::Ink,
        stage: NodeStage::There,
        number: None,
        note: None,
        link: None,
    }
}

fn arrow([from, to]: [usize; 2], kind: ArrowKind, role: Role) -> GraphArrow {
    let far = 4.31 + from as f64;
    let reason = Formula::decimals().num(far).sym(" > ").num(3.47);
    GraphArrow {
        from,
        to,
        kind,
        role,
        reason: Some(Value::Formula(reason)),
    }
}

pub fn cycle() -> Graph {
    let next = |i: usize| arrow([i, (i + 1) % 3], ArrowKind::Ring, Role::Signal);
    Graph {
        title: Value::Term("painter-must"),
        nodes: vec![node("A", 0.9), node("B", 0.7), node("C", 0.1)],
        arrows: (0..3).map(next).collect(),
        places: Places::Free(vec![[10.0, 8.0], [11.0, 5.0], [6.0, 5.0]]),
        ring: Some(Value::Term("painter-cycle")),
        focus: Some(0),
    }
}

pub fn many(n: usize) -> Graph {
    let names = (1..=n).map(|i| node(&format!("A{i}"), 0.3));
    let mut nodes: Vec<GraphNode> = names.collect();
    nodes[n - 1].role = Role::Signal;
    nodes[0].number = Some(Value::Count(1));
    let refused = GraphArrow {
        reason: Some(Value::Term("watch-overlap")),
        ..arrow([n - 1, 2], ArrowKind::Refused, Role::Signal)
    };
    Graph {
        nodes,
        arrows: vec![
            arrow([2, n - 1], ArrowKind::Holds, Role::Soft),
            arrow([0, 2], ArrowKind::Holds, Role::Soft),
            refused,
        ],
        places: Places::Free((0..n).map(|i| [(i % 5) as f64, (i % 3) as f64]).collect()),
        ring: None,
        focus: Some(n - 1),
        ..cycle()
    }
}

pub fn tree(n: usize, focus: usize) -> Graph {
    let below = |i: usize| [2 * i + 1, 2 * i + 2].map(|child| (child < n).then_some(child));
    let branch = |to: usize| GraphArrow {
        reason: Some(Value::Term(["bsp-behind", "bsp-before"][to % 2])),
        ..arrow([(to - 1) / 2, to], ArrowKind::Branch, Role::Soft)
    };
    let mut nodes: Vec<GraphNode> = (0..n).map(|i| node(&format!("D{i}+"), 0.3)).collect();
    nodes[focus].role = Role::Signal;
    nodes[focus].note = Some(Value::Term("bsp-eye-before"));
    nodes[0].number = Some(Value::Count(3));
    Graph {
        title: Value::Term("bsp-tree"),
        nodes,
        arrows: (1..n).map(branch).collect(),
        places: Places::Layers((0..n).map(below).collect()),
        ring: None,
        focus: Some(focus),
    }
}

fn number(before: Formula, x: f64) -> Value {
    Value::Formula(if x.is_finite() {
        before.num(x)
    } else {
        before.sym("∞")
    })
}

/// These depths come, the smaller one wins; the one at `now` has come last.
pub fn story(depths: &[f64], now: usize) -> Story {
    let mut held = f64::INFINITY;
    let cards = depths.iter().enumerate().map(|(nth, &new)| {
        let stored = held;
        let (fate, sign, word) = match new.total_cmp(&stored) {
            Ordering::Less => (StoryFate::Kept, "< ", "story-kept"),
            Ordering::Equal => (StoryFate::Tie, "= ", "story-tie"),
            Ordering::Greater => (StoryFate::Lost, "> ", "story-lost"),
        };
        held = held.min(new);
        let none = Formula::decimals();
        StoryCard {
            name: name(&format!("A{}", nth + 1)),
            tone: (Role::Soft, 0.2 * (nth % 5) as f64),
            new: (new, number(none.clone(), new)),
            against: number(none.sym(sign), stored),
            fate,
            word: Value::Term(word),
            stage: match nth.cmp(&now) {
                Ordering::Less => CellStage::Done,
                Ordering::Equal => CellStage::Current,
                Ordering::Greater => CellStage::ToCome,
            },
            link: None,
        }
    });
    let title = Message::new("story-title");
    Story {
        title: Value::Message(title.with("at", Formula::decimals().sym("[8, 6]"))),
        cards: cards.collect(),
        opening: (f64::INFINITY, number(Formula::decimals(), f64::INFINITY)),
        held: Value::Term("story-held"),
        down: Value::Term("story-nearer"),
        is_reversed: false,
    }
}

pub fn story_of_five(now: usize) -> Story {
    story(&[0.742, 0.563, 0.624, 0.419, 0.674], now)
}

pub fn long_story(n: usize, now: usize) -> Story {
    let depth = |i: usize| 0.9 - 0.6 * (i - i % 3) as f64 / n as f64;
    let depths: Vec<f64> = (0..n).map(depth).collect();
    story(&depths, now)
}
