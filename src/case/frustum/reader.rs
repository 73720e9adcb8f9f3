//! What a case of the frustum lab gives, field by field, each told once for people on the way.

use crate::{
    algo::cull::Viewer,
    case::{Code, Fields, Given, Node, Path, Refusal, Told, volume::read_volume},
    geom::{AlignedBox, Plane, Sphere},
    labs::plane_symbol,
    text::{Formula, Message, Value},
};

use super::segment::{read_clip_segment, read_segment, read_solid_box};

/// A report of more planes than this is refused: a step's table of values has a row a plane, and a report a step a plane,
/// so that its length grows with the square.
const MAX_PLANES: usize = 1024;

/// Reads fields, and keeps what was given.
pub struct Reader<'a> {
    fields: &'a Fields<'a>,
    /// In the order in which they were read.
    given: Vec<Given>,
}

impl<'a> Reader<'a> {
    pub const fn new(fields: &'a Fields<'a>) -> Self {
        let given = Vec::new();
        Self { fields, given }
    }

    /// What was read.
    pub fn told(self) -> Told {
        let given = self.given;
        Box::new(move || given.clone())
    }

    /// A field that must be there.
    pub fn need(&self, name: &'static str) -> Result<Node<'a>, Refusal> {
        self.fields.need(name)
    }

    /// A field that may be left out.
    pub fn get(&self, name: &'static str) -> Option<Node<'a>> {
        self.fields.get(name)
    }

    /// Keeps what was given.
    pub fn tell(&mut self, given: Given) {
        self.given.push(given);
    }

    /// `planes`, or those of a `frustum` in view space.
    pub fn planes(&mut self) -> Result<Vec<Plane>, Refusal> {
        let detail = self.fields.detail();
        let Some(node) = self.fields.get("planes") else {
            let (volume, given) = read_volume(&self.fields.need("frustum")?, detail)?;
            self.given.push(given);
            return Ok(volume.planes().to_vec());
        };
        let rows: Vec<[f64; 4]> = node.points(detail.limit(MAX_PLANES))?;
        if rows.is_empty() {
            let problem = Message::new("case-no-planes");
            return Err(Refusal::at(Code::WrongLength, &node.path, problem));
        }
        let plane = |(i, &row): (usize, &[f64; 4])| {
            Plane::new(row).map_err(|error| Refusal::space(&Path::Index(&node.path, i), error))
        };
        let planes: Vec<Plane> = rows
            .iter()
            .enumerate()
            .map(plane)
            .collect::<Result<_, _>>()?;
        let inside = |(i, plane): (usize, &Plane)| {
            let formula = Formula::default().sym(plane_symbol(i)).sym(": ");
            let formula = formula.place(plane.normal()).sym("·p + ");
            Value::Formula(formula.operand(plane.d()).sym(" ≥ 0"))
        };
        let given = Given::new("object-planes", planes.iter().enumerate().map(inside));
        self.given.push(given);
        Ok(planes)
    }

    /// `point`
    pub fn point(&mut self) -> Result<[f64; 3], Refusal> {
        let point = self.fields.need("point")?.numbers()?;
        self.given.push(place("object-point", point));
        Ok(point)
    }

    /// `sphere`
    pub fn sphere(&mut self) -> Result<Sphere, Refusal> {
        let node = self.fields.need("sphere")?;
        let radius = Path::Index(&node.path, 3);
        let sphere = Sphere::new(node.numbers()?).map_err(|e| Refusal::space(&radius, e))?;
        let told = [
            Formula::default().sym("c = ").place(sphere.center()),
            Formula::default().sym("r = ").num(sphere.radius()),
        ];
        let given = Given::new("object-sphere", told.map(Value::Formula).into_iter());
        self.given.push(given);
        Ok(sphere)
    }

    /// `box`
    pub fn bounds(&mut self) -> Result<AlignedBox, Refusal> {
        let node = self.fields.need("box")?;
        let bounds = AlignedBox::new(node.numbers()?);
        let bounds = bounds.map_err(|error| Refusal::space(&node.path, error))?;
        self.tell_box(&bounds);
        Ok(bounds)
    }

    /// `box`, which has an inside
    pub fn solid_box(&mut self) -> Result<AlignedBox, Refusal> {
        let bounds = read_solid_box(&self.fields.need("box")?)?;
        self.tell_box(&bounds);
        Ok(bounds)
    }

    fn tell_box(&mut self, bounds: &AlignedBox) {
        let (min, max) = (bounds.min(), bounds.max());
        let ranges = [(" ≤ x ≤ ", 0), (" ≤ y ≤ ", 1), (" ≤ z ≤ ", 2)].map(|(symbol, axis)| {
            let formula = Formula::default().num(min[axis]).sym(symbol);
            Value::Formula(formula.num(max[axis]))
        });
        self.given
            .push(Given::new("object-box", ranges.into_iter()));
    }

    /// `segment`
    pub fn segment(&mut self) -> Result<[[f64; 3]; 2], Refusal> {
        let ends = read_segment(&self.fields.need("segment")?)?;
        self.tell_segment(&ends);
        Ok(ends)
    }

    /// `segment`, in clip space
    pub fn clip_segment(&mut self) -> Result<[[f64; 4]; 2], Refusal> {
        let ends = read_clip_segment(&self.fields.need("segment")?)?;
        self.tell_segment(&ends);
        Ok(ends)
    }

    fn tell_segment<const N: usize>(&mut self, ends: &[[f64; N]; 2]) {
        let ends = ["P₁ = (", "P₂ = ("].into_iter().zip(ends);
        let ends = ends.map(|(symbol, at)| Formula::default().sym(symbol).list(at).sym(")"));
        let given = Given::new("object-segment", ends.map(Value::Formula));
        self.given.push(given);
    }

    /// `triangle`, with or without an area.
    pub fn triangle(&mut self) -> Result<[[f64; 3]; 3], Refusal> {
        let triangle = self.fields.need("triangle")?.rows()?;
        let corners = ["V₀ = ", "V₁ = ", "V₂ = "].into_iter().zip(triangle);
        let corners = corners.map(|(name, at)| Formula::default().sym(name).place(at));
        let given = Given::new("object-triangle", corners.map(Value::Formula));
        self.given.push(given);
        Ok(triangle)
    }

    /// `eye`, or `view_dir`.
    pub fn viewer(&mut self) -> Result<Viewer, Refusal> {
        if let Some(node) = self.fields.get("eye") {
            let eye = node.numbers()?;
            self.given.push(place("object-eye", eye));
            return Ok(Viewer::Eye(eye));
        }
        let node = self.fields.need("view_dir")?;
        let direction = node.numbers()?;
        if direction == [0.0; 3] {
            let problem = Message::new("case-zero-direction");
            return Err(Refusal::at(Code::Degenerate, &node.path, problem));
        }
        self.given.push(place("object-view-direction", direction));
        Ok(Viewer::Direction(direction))
    }
}

fn place(name_key: &'static str, at: [f64; 3]) -> Given {
    let formula = Formula::default().place(at);
    Given::new(name_key, [Value::Formula(formula)].into_iter())
}
