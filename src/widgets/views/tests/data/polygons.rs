//! Lists and pipelines: what polygon clippers hold.

use crate::{
    figure::{
        ClipperBox, ClipperRow, Fate, ItemMarker, ListColumn, ListLink, ListRow, Lists, Role,
        Traveller,
    },
    text::Value,
};

use super::name;

fn entry(symbol: &str, marker: Option<ItemMarker>, role: Role) -> ListRow {
    let mut entry = ListRow::new(name(symbol));
    entry.marker = marker;
    entry.role = role;
    entry
}

fn list(title: &str, entries: &[(&str, Role)], focus: usize) -> ListColumn {
    let marker = |symbol: &str| match symbol {
        "C₁" | "C₃" => Some(ItemMarker::Ring),
        "C₂" | "C₄" => Some(ItemMarker::Dot),
        _ => None,
    };
    let entries = entries.iter();
    let entries = entries.map(|&(symbol, role)| entry(symbol, marker(symbol), role));
    ListColumn {
        is_ring: true,
        focus: Some(focus),
        ..ListColumn::new(name(title), entries.collect())
    }
}

/// C3: the walk leaves the subject's list for the window's.
pub fn two_lists() -> Lists {
    use Role::{Accent, Ink, Signal, Soft};
    let subject = [
        ("S₁", Soft),
        ("C₁", Ink),
        ("S₂", Soft),
        ("S₃", Soft),
        ("S₄", Soft),
        ("C₂", Accent),
        ("S₅", Accent),
        ("C₃", Signal),
        ("S₆", Soft),
        ("S₇", Soft),
        ("C₄", Ink),
    ];
    let window = [
        ("W₁", Soft),
        ("W₂", Soft),
        ("C₁", Ink),
        ("C₄", Ink),
        ("C₃", Signal),
        ("W₃", Soft),
        ("C₂", Ink),
        ("W₄", Soft),
    ];
    let link = |from, to, role| ListLink {
        from: [0, from],
        to: [1, to],
        role,
    };
    Lists {
        lists: vec![
            list("Subject list", &subject, 7),
            list("Window list", &window, 4),
        ],
        links: vec![
            link(7, 4, Signal),
            link(1, 2, Soft),
            link(5, 6, Soft),
            link(10, 3, Soft),
        ],
        legend: vec![
            (ItemMarker::Dot, name("entering")),
            (ItemMarker::Ring, name("leaving")),
        ],
    }
}

/// Sutherland–Hodgman: what comes in, what has come out.
pub fn in_and_out() -> Lists {
    use Role::{Accent, Discarded, Faint, Ink, Signal};
    let place = |mut entry: ListRow, at: [f64; 2]| {
        entry.details = vec![Some(Value::Point(at)), Some(Value::Number(at[0]))];
        entry
    };
    let input = vec![
        place(entry("V₁", Some(ItemMarker::Ring), Discarded), [-2.0, 1.0]),
        place(entry("V₂", Some(ItemMarker::Dot), Ink), [3.0, 1.0 / 3.0]),
        place(entry("V₃", Some(ItemMarker::Dot), Signal), [5.0, 4.5]),
        place(entry("V₄", None, Faint), [-1.0, 3.0]),
    ];
    let output = vec![
        place(entry("I₁", None, Accent), [0.0, 0.5]),
        place(entry("V₂", None, Signal), [3.0, 1.0 / 3.0]),
    ];
    Lists {
        lists: vec![
            ListColumn::new(name("In"), input),
            ListColumn::new(name("Out: x ≥ 0"), output),
            ListColumn::new(name("Next"), Vec::new()),
        ],
        links: Vec::new(),
        legend: Vec::new(),
    }
}

/// Lists of which a part is folded, some of it before the view was asked.
pub fn long_lists() -> Lists {
    let entries = |letter: &str| -> Vec<ListRow> {
        let entry = |i: usize| {
            entry(
                &format!("{letter}{i}"),
                None,
                if i == 25 { Role::Signal } else { Role::Soft },
            )
        };
        (10..50).map(entry).collect()
    };
    let long = |letter: &str| ListColumn {
        n_before: 10,
        n_after: 150,
        is_ring: true,
        focus: Some(15),
        ..ListColumn::new(name(letter), entries(letter))
    };
    Lists {
        lists: vec![long("S"), long("W")],
        links: vec![ListLink {
            from: [0, 15],
            to: [1, 38],
            role: Role::Signal,
        }],
        legend: Vec::new(),
    }
}

/// Four clippers, a vertex leaving the second and its crossing on the way to the third.
pub fn pipeline() -> ClipperRow {
    let clipper = |side, first, previous, is_closed| ClipperBox {
        name: name(side),
        first,
        previous,
        is_closed,
        link: None,
    };
    let traveller = |symbol, arrow, fate| Traveller {
        name: name(symbol),
        arrow,
        fate,
    };
    ClipperRow {
        clippers: vec![
            clipper("x = −4", Some([-2.0, 1.0]), Some([6.0, 1.0]), true),
            clipper(
                "x = 4",
                Some([-2.0, 1.0]),
                Some([-1.0 / 3.0, 0.123_456]),
                false,
            ),
            clipper("y = −3", Some([-2.0, 1.0]), None, false),
            clipper("y = 3", None, None, false),
        ],
        at_work: Some(1),
        travellers: vec![
            traveller("I₁", 2, Fate::GoesOn),
            traveller("V₃", 2, Fate::Dropped),
        ],
        output: name("V′"),
        n_out: 1,
    }
}
