//! What cases of the frustum lab give, part by part.

use crate::{
    algo::cull::Viewer,
    geom::{AlignedBox, Matrix, Plane, Sphere},
    input::{At, Dim, Fault, Given, Got, Part, Shape, between},
    labs::plane_symbol,
    text::{Formula, Message, Value},
};

/// A report of more planes than this is refused: a step's table of values has a row a plane, and a report a step a plane,
/// so that its length grows with the square.
const MOST_PLANES: usize = 1024;

/// `[nx, ny, nz, d]` each.
pub const PLANES: Part<Vec<Plane>> = Part::new(
    "planes",
    &Shape::Numbers(&[Dim::UpTo(MOST_PLANES), Dim::Exactly(4)]),
    |got| {
        let rows: &[[f64; 4]] = got.rows();
        if rows.is_empty() {
            return Err(Fault::new("wrong-length", Message::new("case-no-planes")));
        }
        let plane =
            |(i, &row)| Plane::new(row).map_err(|error| Fault::from(error).at(At::Entry(i)));
        rows.iter().enumerate().map(plane).collect()
    },
)
.told(|got| {
    let inside = |(i, &[x, y, z, d]): (usize, &[f64; 4])| {
        let formula = Formula::default().sym(plane_symbol(i)).sym(": ");
        let formula = formula.place([x, y, z]).sym("·p + ");
        Value::Formula(formula.operand(d).sym(" ≥ 0"))
    };
    let planes = got.rows().iter().enumerate().map(inside);
    vec![Given::new("object-planes", planes)]
});

pub const POINT: Part<[f64; 3]> =
    Part::new("point", &Shape::PLACE, |got| Ok(got.array())).told(|got| place("object-point", got));

pub const EYE: Part<Viewer> = Part::new("eye", &Shape::PLACE, |got| Ok(Viewer::Eye(got.array())))
    .told(|got| place("object-eye", got));

pub const VIEW_DIR: Part<Viewer> = Part::new("view_dir", &Shape::PLACE, |got| {
    let direction: [f64; 3] = got.array();
    if direction == [0.0; 3] {
        let problem = Message::new("case-zero-direction");
        return Err(Fault::new("degenerate", problem));
    }
    Ok(Viewer::Direction(direction))
})
.told(|got| place("object-view-direction", got));

/// Centre and radius.
pub const SPHERE: Part<Sphere> = Part::new("sphere", &Shape::Numbers(&[Dim::Exactly(4)]), |got| {
    Sphere::new(got.array()).map_err(|error| Fault::from(error).at(At::Entry(3)))
})
.told(|got| {
    let [x, y, z, r] = got.array();
    let told = [
        Formula::default().sym("c = ").place([x, y, z]),
        Formula::default().sym("r = ").num(r),
    ];
    Given::only("object-sphere", told.map(Value::Formula))
});

const BOX_SHAPE: Shape = Shape::Numbers(&[Dim::Exactly(6)]);

/// `[xmin, ymin, zmin, xmax, ymax, zmax]`
pub const BOX: Part<AlignedBox> =
    Part::new("box", &BOX_SHAPE, |got| Ok(AlignedBox::new(got.array())?)).told(box_told);

/// A box with an inside: a minimum below its maximum along every axis.
pub const SOLID_BOX: Part<AlignedBox> = Part::new("box", &BOX_SHAPE, |got| {
    let bounds = AlignedBox::new(got.array())?;
    let (min, max) = (bounds.min(), bounds.max());
    let Some(flat) = (0..3).find(|&axis| min[axis] == max[axis]) else {
        return Ok(bounds);
    };
    let axis_name = ["x", "y", "z"][flat];
    let problem = Message::new("case-flat-box")
        .with("low", format!("{axis_name}min"))
        .with("high", format!("{axis_name}max"))
        .with("at", min[flat]);
    Err(Fault::new("empty-window", problem))
})
.told(box_told);

fn box_told(got: &Got) -> Vec<Given> {
    let [min, max]: [[f64; 3]; 2] = got.matrix();
    let ranges = [(" ≤ x ≤ ", 0), (" ≤ y ≤ ", 1), (" ≤ z ≤ ", 2)];
    let range = |(symbol, axis): (_, usize)| between(min[axis], symbol, max[axis]);
    Given::only("object-box", ranges.map(range))
}

/// Both ends, one after the other.
pub const SEGMENT: Part<[[f64; 3]; 2]> =
    Part::new("segment", &Shape::Numbers(&[Dim::Exactly(6)]), |got| {
        Ok(got.matrix())
    })
    .told(segment_told::<3>);

/// In clip space, neither end being (0, 0, 0, 0).
pub const CLIP_SEGMENT: Part<[[f64; 4]; 2]> =
    Part::new("segment", &Shape::Numbers(&[Dim::Exactly(8)]), |got| {
        let ends: [[f64; 4]; 2] = got.matrix();
        if ends.contains(&[0.0; 4]) {
            return Err(Fault::new("degenerate", Message::new("case-no-point")));
        }
        Ok(ends)
    })
    .told(segment_told::<4>);

fn segment_told<const N: usize>(got: &Got) -> Vec<Given> {
    named("object-segment", ["P₁ = (", "P₂ = ("], got.matrix::<2, N>())
}

/// With or without an area.
pub const TRIANGLE: Part<[[f64; 3]; 3]> = rows("triangle").told(triangle_told::<3>);

pub const CLIP_TRIANGLE: Part<[[f64; 4]; 3]> = rows("triangle").told(triangle_told::<4>);

fn triangle_told<const N: usize>(got: &Got) -> Vec<Given> {
    let names = ["V₀ = (", "V₁ = (", "V₂ = ("];
    named("object-triangle", names, got.matrix::<3, N>())
}

/// So many rows of so many numbers, taken as they are.
const fn rows<const R: usize, const N: usize>(name: &'static str) -> Part<[[f64; N]; R]> {
    let shape = const { &Shape::Numbers(&[Dim::Exactly(R), Dim::Exactly(N)]) };
    Part::new(name, shape, |got| Ok(got.matrix()))
}

pub const UV: Part<[[f64; 2]; 3]> = rows("uv")
    .told(|got| Given::only("object-triangle-uv", got.matrix::<3, 2>().map(Value::Point)));

/// Four rows of four, for column vectors.
pub const MODEL: Part<Matrix> = Part::new(
    "model",
    &Shape::Numbers(&[Dim::Exactly(4), Dim::Exactly(4)]),
    |got| Matrix::affine(got.matrix()).map_err(|error| Fault::from(error).at(At::Entry(3))),
)
.told(|got| {
    let row = |row: [f64; 4]| Value::Formula(Formula::decimals().sym("(").list(&row).sym(")"));
    Given::only("object-model-matrix", got.matrix::<4, 4>().map(row))
});

pub const FROM: Part<[i64; 2]> = pixel("from").told(|got| pixel_told("object-from", got));
pub const TO: Part<[i64; 2]> = pixel("to").told(|got| pixel_told("object-to", got));

const fn pixel(name: &'static str) -> Part<[i64; 2]> {
    const PIXEL: Shape = Shape::Wholes(&[Dim::Exactly(2)], i64::MIN, i64::MAX);
    Part::new(name, &PIXEL, |got| Ok(got.wholes()))
}

fn pixel_told(name_key: &'static str, got: &Got) -> Vec<Given> {
    let [x, y]: [i64; 2] = got.wholes();
    let place = format!("[{x}, {y}]").replace('-', "−");
    Given::only(name_key, [Value::Name(place)])
}

fn place(name_key: &'static str, got: &Got) -> Vec<Given> {
    let formula = Formula::default().place(got.array());
    Given::only(name_key, [Value::Formula(formula)])
}

/// `P₁ = (0, 0, 1)`: the names have the opening parenthesis.
fn named<const R: usize, const N: usize>(
    name_key: &'static str,
    names: [&'static str; R],
    rows: [[f64; N]; R],
) -> Vec<Given> {
    let row = |(name, at): (&'static str, [f64; N])| {
        Value::Formula(Formula::default().sym(name).list(&at).sym(")"))
    };
    vec![Given::new(name_key, names.into_iter().zip(rows).map(row))]
}
