//! Lists and pipelines: what polygon clippers hold.

use super::*;

fn entry(symbol: &str, marker: Option<ItemMarker>, role: Role) -> ListRow {
    ListRow {
        marker,
        role,
        ..ListRow::new(name(symbol))
    }
}

/// Entries by their symbols: after `.` soft, after `=` ink, after `+` accent, after `!` this step's.
fn list(title: &str, entries: &[&str], focus: usize) -> ListColumn {
    let entries = entries.iter().map(|entry_of| {
        let (role, symbol) = entry_of.split_at(1);
        let role = match role {
            "=" => Role::Ink,
            "+" => Role::Accent,
            "!" => Role::Signal,
            _ => Role::Soft,
        };
        let marker = match symbol {
            "C₁" | "C₃" => Some(ItemMarker::Ring),
            "C₂" | "C₄" => Some(ItemMarker::Dot),
            _ => None,
        };
        entry(symbol, marker, role)
    });
    ListColumn {
        is_ring: true,
        focus: Some(focus),
        ..ListColumn::new(name(title), entries.collect())
    }
}

/// C3: the walk leaves the subject's list for the window's.
pub fn two_lists() -> Lists {
    let subject = [
        ".S₁", "=C₁", ".S₂", ".S₃", ".S₄", "+C₂", "+S₅", "!C₃", ".S₆", ".S₇", "=C₄",
    ];
    let window = [".W₁", ".W₂", "=C₁", "=C₄", "!C₃", ".W₃", "=C₂", ".W₄"];
    let links = [(7, 4), (1, 2), (5, 6), (10, 3)].map(|(from, to)| {
        let role = if from == 7 { Role::Signal } else { Role::Soft };
        ListLink::between(from, to, role)
    });
    Lists {
        lists: vec![
            list("Subject list", &subject, 7),
            list("Window list", &window, 4),
        ],
        links: links.to_vec(),
        legend: vec![
            (ItemMarker::Dot, name("entering")),
            (ItemMarker::Ring, name("leaving")),
        ],
    }
}

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

pub fn long_lists() -> Lists {
    let entries = |letter: &str| -> Vec<ListRow> {
        let entry = |i: usize| {
            let role = if i == 25 { Role::Signal } else { Role::Soft };
            entry(&format!("{letter}{i}"), None, role)
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
        links: vec![ListLink::between(15, 38, Role::Signal)],
        legend: Vec::new(),
    }
}

pub fn pipeline() -> ClipperRow {
    let clipper = |side, first, previous| ClipperBox {
        name: name(side),
        first,
        previous,
        is_closed: side == "x = −4",
        link: None,
    };
    let traveller = |symbol, fate| Traveller {
        name: name(symbol),
        arrow: 2,
        fate,
    };
    let first = Some([-2.0, 1.0]);
    ClipperRow {
        clippers: vec![
            clipper("x = −4", first, Some([6.0, 1.0])),
            clipper("x = 4", first, Some([-1.0 / 3.0, 0.123_456])),
            clipper("y = −3", first, None),
            clipper("y = 3", None, None),
        ],
        at_work: Some(1),
        travellers: vec![
            traveller("I₁", Fate::GoesOn),
            traveller("V₃", Fate::Dropped),
        ],
        output: name("V′"),
        n_out: 1,
    }
}
