//! The kinds of input that cases and scene files have in common.

use crate::{
    algo::{line::BitOrder, surface::Viewport},
    geom::{ConvexPolygon, Edge, Point, Polygon, ViewVolume, Window},
    labs::{
        numbered,
        space::{Opening, TaughtCamera},
    },
    text::{Formula, Message, Value},
};

use super::{At, Dim, Fault, Field, Given, Got, Part, Shape, Table};

/// `[xmin, ymin, xmax, ymax]`
pub const WINDOW: Part<Window> = Part::new("window", &Shape::Numbers(&[Dim::Exactly(4)]), |got| {
    let [xmin, ymin, xmax, ymax] = got.array();
    Ok(Window::new(xmin, ymin, xmax, ymax)?)
})
.expecting("expect-window")
.told(|got| {
    let [xmin, ymin, xmax, ymax] = got.array();
    Given::only(
        "object-window",
        [
            between(xmin, " ≤ x ≤ ", xmax),
            between(ymin, " ≤ y ≤ ", ymax),
        ],
    )
});

/// A report of a clip polygon with more vertices than this is refused: a step's table of values has a row an edge, and
/// a report a step an edge, so that its length grows with the square.
const MOST_CLIP_VERTICES: usize = 1024;

/// `clip`: a convex polygon, either way round.
pub const CONVEX_CLIP: Part<ConvexPolygon> = Part::new(
    "clip",
    &Shape::Numbers(&[Dim::UpTo(MOST_CLIP_VERTICES), Dim::Exactly(2)]),
    |got| Ok(ConvexPolygon::new(got.rows())?),
)
.expecting("expect-clip")
.told(|got| {
    let clip = ConvexPolygon::new(got.rows());
    clip.map_or_else(|_| Vec::new(), |clip| clip_told(clip.vertices()))
});

/// A report of an outline with more vertices than this is refused.
pub const MOST_VERTICES: usize = 10_000;

const OUTLINE: Shape = Shape::Numbers(&[Dim::UpTo(MOST_VERTICES), Dim::Exactly(2)]);

pub const CLIP: Part<Polygon> = Part::new("clip", &OUTLINE, polygon)
    .expecting("expect-polygon")
    .told(|got| polygon(got).map_or_else(|_| Vec::new(), |clip| clip_told(clip.vertices())));

pub const POLYGON: Part<Polygon> = Part::new("polygon", &OUTLINE, polygon)
    .expecting("expect-polygon")
    .told(|got| outline_told("object-polygon", 'V', got));

pub const HOLES: Field = Field::optional("holes", &Shape::List(&OUTLINE)).told(|got| {
    let holes = got.list().iter();
    holes
        .flat_map(|hole| points_told("object-hole", hole))
        .collect()
});

pub const BIT_ORDER: Part<BitOrder> =
    Part::new("bit_order", &Shape::Word(&["tbrl", "lrbt"]), |got| {
        Ok(bit_order(got))
    })
    .told(|got| bit_order_told(bit_order(got)))
    .told_absent(|| bit_order_told(BitOrder::default()));

/// `cull`: what shows its back is left out.
pub const CULL: Part<bool> = Part::new("cull", &Shape::Word(&["back"]), |_| Ok(true))
    .told(|_| Given::only("object-culled", [Value::Term("object-backs")]));

pub const SIZE: Part<Viewport> = Part::new(
    "size",
    &Shape::Wholes(&[Dim::Exactly(2)], 1, Viewport::MAX_SIDE as i64),
    |got| {
        let sides: [i64; 2] = got.wholes();
        let size = sides.map(|side| u32::try_from(side).unwrap_or(0));
        Viewport::new(size, Viewport::ANSWER_BITS).ok_or_else(|| {
            let fits = |side: &i64| (1..=i64::from(Viewport::MAX_SIDE)).contains(side);
            let at = sides.iter().position(|side| !fits(side)).unwrap_or(0);
            let code = if sides[at] < 1 {
                "degenerate"
            } else {
                "too-large"
            };
            let problem = Message::new("case-picture-side")
                .with("max", Viewport::MAX_SIDE as usize)
                .with("found", sides[at].to_string());
            Fault::new(code, problem).at(At::Entry(at))
        })
    },
)
.told(|got| {
    let [columns, rows] = got.wholes().map(|side| side as f64);
    let pixels = Formula::default().num(columns).sym(" × ").num(rows);
    Given::only("object-picture", [Value::Formula(pixels)])
});

const VOLUME_FIELDS: [Field; 5] = [
    Field::choice("fov_y_deg", &Shape::Number),
    Field::choice("height", &Shape::Number),
    Field::required("aspect", &Shape::Number),
    Field::required("near", &Shape::Number),
    Field::required("far", &Shape::Number),
];

/// `frustum`: in perspective, or with `height` where sight lines are parallel.
pub const FRUSTUM: Part<ViewVolume> = Part::new(
    "frustum",
    &Shape::Table(&Table {
        name_key: "object-view-volume",
        fields: &VOLUME_FIELDS,
        both_key: "problem-two-openings",
    }),
    |got| {
        let [aspect, near, far] = ["aspect", "near", "far"].map(|name| got.number_in(name));
        Ok(match opening(got) {
            Opening::FovY(degrees) => ViewVolume::perspective(degrees, aspect, near, far),
            Opening::Height(height) => ViewVolume::parallel(height, aspect, near, far),
        }?)
    },
)
.told(|got| table_told("object-view-volume", got));

pub const CAMERA: Part<TaughtCamera> = camera("camera", &CAMERA_TABLE);

pub const CAMERA_IN_FILE: Part<TaughtCamera> = camera("camera", &CAMERA_IN_FILE_TABLE);

/// The same, of which planes are kept while the camera moves on.
pub const FROZEN: Part<TaughtCamera> = camera("frozen", &CAMERA_IN_FILE_TABLE);

const CAMERA_TABLE: Shape = Shape::Table(&Table {
    name_key: "object-camera",
    fields: &camera_fields(Field::required("up", &Shape::PLACE)),
    both_key: "problem-two-openings",
});

const CAMERA_IN_FILE_TABLE: Shape = Shape::Table(&Table {
    name_key: "object-camera",
    fields: &camera_fields(Field::optional("up", &Shape::PLACE)),
    both_key: "problem-two-openings",
});

const fn camera_fields(up: Field) -> [Field; 8] {
    let [fov, height, aspect, near, far] = VOLUME_FIELDS;
    let [position, target] = [
        Field::required("position", &Shape::PLACE),
        Field::required("target", &Shape::PLACE),
    ];
    [position, target, up, fov, height, aspect, near, far]
}

const fn camera(name: &'static str, shape: &'static Shape) -> Part<TaughtCamera> {
    /// Which way is up where a file does not say.
    const UP: [f64; 3] = [0.0, 1.0, 0.0];
    let make = |got: &Got| {
        let place = |name, usual| got.get(name).map_or(usual, Got::array);
        let places = [place("position", UP), place("target", UP), place("up", UP)];
        let [aspect, near, far] = ["aspect", "near", "far"].map(|name| got.number_in(name));
        Ok(TaughtCamera::new(
            places,
            opening(got),
            aspect,
            [near, far],
        )?)
    };
    Part::new(name, shape, make)
        .expecting("expect-camera")
        .told(|got| table_told("object-camera", got))
}

fn opening(got: &Got) -> Opening {
    got.get("height").map_or_else(
        || Opening::FovY(got.number_in("fov_y_deg")),
        |height| Opening::Height(height.number()),
    )
}

/// `V₁ = (0, 0)`, `V₂ = …`
pub fn outline_told(name_key: &'static str, letter: char, got: &Got) -> Vec<Given> {
    let vertex = |(i, &at): (usize, &[f64; 2])| {
        let formula = Formula::default().sym(numbered(letter, i)).sym(" = ");
        Value::Formula(formula.point(at))
    };
    let vertices = got.rows().iter().enumerate().map(vertex);
    vec![Given::new(name_key, vertices)]
}

/// Without names: they go on after those of another outline.
fn points_told(name_key: &'static str, got: &Got) -> Vec<Given> {
    let points = got.rows().iter().map(|&at: &[f64; 2]| at.into());
    vec![Given::new(name_key, points)]
}

fn polygon(got: &Got) -> Result<Polygon, Fault> {
    Ok(Polygon::new(got.rows())?)
}

fn clip_told(vertices: &[Point]) -> Vec<Given> {
    let values = vertices.iter().map(|p| p.to_array().into());
    vec![Given::new("object-clip-polygon", values)]
}

/// `−1 ≤ x ≤ 1`
pub fn between(low: f64, symbol: &'static str, high: f64) -> Value {
    Value::Formula(Formula::default().num(low).sym(symbol).num(high))
}

/// Its fields: `near = 1`, `target = (0, 0, −1)`.
fn table_told(name_key: &'static str, got: &Got) -> Vec<Given> {
    let values = got.fields().iter().map(|(name, got)| {
        let formula = Formula::default().sym(*name).sym(" = ");
        Value::Formula(match got {
            Got::Number(x) => formula.num(*x),
            place => formula.place(place.array()),
        })
    });
    vec![Given::new(name_key, values)]
}

fn bit_order(got: &Got) -> BitOrder {
    match got.text() {
        "lrbt" => BitOrder::Lrbt,
        _ => BitOrder::Tbrl,
    }
}

fn bit_order_told(order: BitOrder) -> Vec<Given> {
    let side = |edge| match edge {
        Edge::Left => Value::Term("side-left"),
        Edge::Right => Value::Term("side-right"),
        Edge::Bottom => Value::Term("side-bottom"),
        Edge::Top => Value::Term("side-top"),
    };
    Given::only("object-outcode", order.written().map(side))
}
