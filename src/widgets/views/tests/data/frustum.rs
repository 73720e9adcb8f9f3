//! What the prototypes A1 and A6 show.

use super::*;

pub fn gauge(name: Value, value: Option<f64>, role: Role) -> Gauge {
    Gauge {
        name,
        value,
        verdict: None,
        role,
        is_bar: false,
        link: None,
    }
}

/// The planes of a view volume.
const PLANES: [&str; 6] = [
    "plane-near",
    "plane-far",
    "plane-left",
    "plane-right",
    "plane-bottom",
    "plane-top",
];

/// One sphere, six planes, of which three have been asked.
pub fn distances() -> Gauges {
    let asked = [2.6, 4.4, -3.4];
    let row = |(i, plane)| {
        let role = if i == 2 { Role::Signal } else { Role::Accent };
        gauge(Value::Term(plane), asked.get(i).copied(), role)
    };
    Gauges {
        title: Message::new("gauges-sphere").with("planes", 6_usize),
        sides: ["gauge-outside", "gauge-inside"].map(Message::new),
        band: Some(1.01),
        rows: PLANES.into_iter().enumerate().map(row).collect(),
    }
}

pub fn products() -> Gauges {
    let products = [117.0, 45.0, 27.0, -9.0, -45.0, -81.0, -99.0, -171.0];
    let row = |(i, &product): (usize, &f64)| {
        let (verdict, role) = match (i, product > 0.0) {
            (5, _) => ("gauge-culled", Role::Signal),
            (_, true) => ("gauge-drawn", Role::Accent),
            (_, false) => ("gauge-culled", Role::Discarded),
        };
        Gauge {
            verdict: Some(Message::new(verdict)),
            is_bar: true,
            ..gauge(Value::Count(i + 1), Some(product), role)
        }
    };
    Gauges {
        title: Message::new("gauges-faces").with("faces", 8_usize),
        sides: ["gauge-away", "gauge-faces-camera"].map(Message::new),
        band: None,
        rows: products.iter().enumerate().map(row).collect(),
    }
}

pub fn ribbon(amounts: [usize; 5]) -> Ribbon {
    let titles = [
        "level-scene",
        "level-spheres",
        "level-vertices",
        "level-cuts",
        "level-facing",
    ];
    let counts = Message::new("level-counts").with("objects", 10_usize);
    let stage = |(i, title): (usize, &'static str)| {
        let before = i.checked_sub(1);
        RibbonStage {
            title: Message::new(title),
            counts: counts.clone().with("triangles", amounts[i]),
            amount: amounts[i],
            change: before.map(|before| amounts[i] as i64 - amounts[before] as i64),
            is_to_come: i > 1,
        }
    };
    Ribbon {
        stages: titles.into_iter().enumerate().map(stage).collect(),
        at_work: Some(1),
        most: amounts.into_iter().fold(0, usize::max),
    }
}

pub fn small_drawings(current: Option<usize>) -> Multiples {
    let outline = vec![[0.0, 0.0], [4.0, 1.0], [1.0, 3.0]];
    let drawing = |(i, key): (usize, &'static str)| SmallDrawing {
        title: Value::Term(key),
        note: Some((Role::Ink, name(&format!("{} → {}", i + 6, i + 7)))),
        marks: vec![Mark::new(Role::Accent, Shape::Area(vec![outline.clone()]))],
        is_current: current == Some(i),
        is_to_come: current.is_none_or(|current| i > current),
        n_known: None,
        link: None,
    };
    Multiples {
        drawings: PLANES.into_iter().enumerate().map(drawing).collect(),
        bounds: [[0.0, 0.0], [4.0, 3.0]],
        tiles: Tiles::Strip,
    }
}
