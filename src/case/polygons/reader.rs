//! What a case of the polygons lab gives, field by field, each told once for people on the way.

use crate::{
    algo::polygon::ClipRegion,
    case::{
        Code, Fields, Given, Node, Refusal, Told,
        parts::{given_clip, given_window, read_clip, read_window},
    },
    geom::{Point, Polygon, Region, SimplePolygon},
    labs::vertex_symbol,
    text::{Formula, Message, Value},
};

/// A report of an outline with more vertices than this is refused.
const MAX_VERTICES: usize = 10_000;
/// And so is one of two whose numbers of edges multiply to more: each pair may become several events, of which the JSON
/// answer holds every one. 10,000 vertices against a window are less.
const MAX_PAIRS: usize = 1 << 16;

/// Reads fields, and keeps what was given.
pub struct Reader<'a> {
    fields: &'a Fields<'a>,
    /// In the order in which they were read.
    given: Vec<Given>,
    /// Of the window or clip polygon, where there is one.
    n_clip_edges: usize,
}

impl<'a> Reader<'a> {
    pub const fn new(fields: &'a Fields<'a>) -> Self {
        Self {
            fields,
            given: Vec::new(),
            n_clip_edges: 1,
        }
    }

    /// What was read.
    pub fn told(self) -> Told {
        let given = self.given;
        Box::new(move || given.clone())
    }

    /// `window`, or a convex `clip`.
    pub fn convex_region(&mut self) -> Result<ClipRegion, Refusal> {
        if let Some(node) = self.fields.get("window") {
            let window = read_window(&node)?;
            self.given.push(given_window(&window));
            self.n_clip_edges = 4;
            return Ok(window.into());
        }
        let clip = read_clip(&self.fields.need("clip")?, self.fields.detail())?;
        self.given.push(given_clip(clip.vertices()));
        self.n_clip_edges = clip.vertices().len();
        Ok(clip.into())
    }

    /// `window`, or `clip`, which must be simple.
    pub fn simple_clip(&mut self) -> Result<SimplePolygon, Refusal> {
        if let Some(node) = self.fields.get("window") {
            let window = read_window(&node)?;
            self.given.push(given_window(&window));
            self.n_clip_edges = 4;
            return Ok(window.into());
        }
        let node = self.fields.need("clip")?;
        let clip = self.outline(&node)?;
        self.given.push(given_clip(clip.vertices()));
        self.n_clip_edges = clip.vertices().len();
        simple(&node, &clip)
    }

    /// `polygon`, of any shape.
    pub fn polygon(&mut self) -> Result<Polygon, Refusal> {
        let node = self.fields.need("polygon")?;
        let polygon = self.outline(&node)?;
        self.given.push(given_outline("object-polygon", &polygon));
        self.check_pairs(&node, polygon.vertices().len())?;
        Ok(polygon)
    }

    /// `polygon`, which must be simple.
    pub fn simple_polygon(&mut self) -> Result<SimplePolygon, Refusal> {
        let polygon = self.polygon()?;
        simple(&self.fields.need("polygon")?, &polygon)
    }

    /// `polygon`, less `holes` where there are any.
    pub fn region(&mut self) -> Result<Region, Refusal> {
        let outer = self.simple_polygon()?;
        let n_outer = outer.vertices().len();
        let Some(node) = self.fields.get("holes") else {
            return Ok(outer.into());
        };
        let outlines = node.list(|hole| self.outline(hole))?;
        let n_edges = outlines
            .iter()
            .map(|hole| hole.vertices().len())
            .sum::<usize>();
        self.check_pairs(&node, n_outer + n_edges)?;
        let holes = node.list(|hole| simple(hole, &self.outline(hole)?))?;
        for hole in &outlines {
            self.given.push(given_outline("object-hole", hole));
        }
        Region::new(outer, holes).map_err(|error| Refusal::geometry(&node.path, error))
    }

    /// `uv`: a place in the texture for each vertex.
    pub fn uv(&mut self, n_vertices: usize) -> Result<Vec<[f64; 2]>, Refusal> {
        let node = self.fields.need("uv")?;
        let uvs: Vec<[f64; 2]> = node.points(self.fields.detail().limit(MAX_VERTICES))?;
        if uvs.len() != n_vertices {
            let problem = Message::new("case-uv-length")
                .with("expected", n_vertices)
                .with("found", uvs.len());
            return Err(Refusal::at(Code::WrongLength, &node.path, problem));
        }
        let values = uvs.iter().map(|&uv| uv.into());
        self.given.push(Given::new("object-uv", values));
        Ok(uvs)
    }

    /// A list of three points or more.
    fn outline(&self, node: &Node<'_>) -> Result<Polygon, Refusal> {
        let most = self.fields.detail().limit(MAX_VERTICES);
        let outline: Vec<[f64; 2]> = node.points(most)?;
        Polygon::new(&outline).map_err(|error| Refusal::geometry(&node.path, error))
    }

    fn check_pairs(&self, node: &Node<'_>, n_edges: usize) -> Result<(), Refusal> {
        let found = n_edges.saturating_mul(self.n_clip_edges);
        if found <= self.fields.detail().limit(MAX_PAIRS) {
            return Ok(());
        }
        let problem = Message::new("case-too-many-pairs")
            .with("found", found)
            .with("max", MAX_PAIRS);
        Err(Refusal::at(Code::TooLarge, &node.path, problem))
    }
}

/// An outline that does not meet itself.
fn simple(node: &Node<'_>, outline: &Polygon) -> Result<SimplePolygon, Refusal> {
    SimplePolygon::try_from(outline).map_err(|error| Refusal::geometry(&node.path, error))
}

/// `V₁ = (0, 0)`, `V₂ = …`
fn given_outline(name_key: &'static str, outline: &Polygon) -> Given {
    let vertex = |(i, p): (usize, &Point)| {
        let formula = Formula::default().sym(vertex_symbol(i)).sym(" = ");
        Value::Formula(formula.point(p.to_array()))
    };
    Given::new(name_key, outline.vertices().iter().enumerate().map(vertex))
}
