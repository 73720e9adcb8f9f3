//! Reading an OBJ file.

use std::collections::HashMap;

use crate::{geom::Mesh, lesson::prelude::*};

use super::{
    faces::{has_area, triangles},
    statements::{Statement, statements},
};

/// A face of more corners is left out: no surface needs it, and to cut it takes long.
const MAX_CORNERS: usize = 1000;
/// A file of more triangles is refused: no frame could draw them in time.
const MAX_TRIANGLES: usize = 500_000;

#[derive(Clone, PartialEq, Debug)]
pub struct ObjFile {
    pub mesh: Mesh,
    /// The material file that it names, and the material of its first face.
    pub material: Option<[String; 2]>,
    pub warnings: Vec<Problem>,
}

// Refused are all mistakes that keep the mesh from being drawn; `file` is how they name it.
pub fn read_obj(file: &str, bytes: &[u8]) -> Result<ObjFile, Vec<Problem>> {
    read_obj_while(file, bytes, &|| true)
}

// The same as long as somebody wants it: else the reading ends early, and the answer means nothing.
pub fn read_obj_while(
    file: &str,
    bytes: &[u8],
    is_wanted: &dyn Fn() -> bool,
) -> Result<ObjFile, Vec<Problem>> {
    let source = Source::new(file.to_owned(), bytes);
    let sink = Sink::new(&source);
    let mut reader = Reader::default();
    let wanted = || statements(&source.text).take_while(|_| is_wanted());
    for statement in wanted() {
        match statement.keyword() {
            "v" => reader.positions.extend(numbers::<3>(&statement, 3, &sink)),
            "vt" => reader.uvs.extend(numbers::<2>(&statement, 1, &sink)),
            "mtllib" => reader.library = statement.rest().map(str::to_owned),
            "usemtl" if reader.material.is_none() => {
                reader.material = statement.rest().map(str::to_owned);
            }
            _ => {}
        }
    }
    if sink.n_errors() == 0 {
        reader.faces(wanted(), &sink);
    }
    reader.finish(sink)
}

/// The indices of a place and of texture coordinates, each where it is named.
type Corner = [Option<usize>; 2];

#[derive(Default)]
struct Reader {
    positions: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    library: Option<String>,
    material: Option<String>,
    /// Vertices of the mesh, by what a corner names.
    known: HashMap<Corner, u32>,
    vertices: Vec<Corner>,
    faces: Vec<[u32; 3]>,
    /// Triangles without area, and the face of the first.
    n_flat: usize,
    first_flat: Range<usize>,
}

impl Reader {
    /// In a second round: faces may name vertices that come later.
    fn faces<'t>(&mut self, statements: impl Iterator<Item = Statement<'t>>, sink: &Sink<'_>) {
        let mut so_far = [0; 2];
        for statement in statements {
            match statement.keyword() {
                "v" => so_far[0] += 1,
                "vt" => so_far[1] += 1,
                "f" => self.face(&statement, so_far, sink),
                _ => {}
            }
            if self.faces.len() > MAX_TRIANGLES {
                let message = Message::new("problem-too-many-faces").with("limit", MAX_TRIANGLES);
                sink.error(statement.span(), message, []);
                return;
            }
        }
    }

    fn face(&mut self, statement: &Statement<'_>, so_far: [usize; 2], sink: &Sink<'_>) {
        let words = statement.values();
        let corners = words.map(|(word, span)| self.corner(word, span, so_far, sink));
        let Some(corners) = corners.collect::<Option<Vec<_>>>() else {
            return;
        };
        let odd = match corners.len() {
            0..3 => Some(Message::new("problem-face-too-short")),
            3..=MAX_CORNERS => None,
            _ => Some(Message::new("problem-face-too-long").with("limit", MAX_CORNERS)),
        };
        if let Some(message) = odd {
            sink.warning(statement.span(), message.with("count", corners.len()));
            return;
        }
        let positions: Vec<_> = corners.iter().filter_map(|it| self.place(it)).collect();
        let Some(cut) = triangles(&positions) else {
            sink.warning(statement.span(), Message::new("problem-face-not-simple"));
            return;
        };
        let flat = cut.iter().filter(|it| !has_area(it.map(|i| positions[i])));
        let n_flat = flat.count();
        if self.n_flat == 0 && n_flat > 0 {
            self.first_flat = statement.span();
        }
        self.n_flat += n_flat;
        let corners = corners.into_iter();
        let vertices: Vec<u32> = corners.map(|corner| self.vertex(corner)).collect();
        let cut = cut.into_iter();
        self.faces
            .extend(cut.map(|triangle| triangle.map(|i| vertices[i])));
    }

    fn place(&self, [position, _]: &Corner) -> Option<[f32; 3]> {
        self.positions.get((*position)?).copied()
    }

    /// `position`, `position/uv`, `position//normal` or `position/uv/normal`: indices of position and texture coordinates.
    fn corner(
        &self,
        word: &str,
        span: Range<usize>,
        so_far: [usize; 2],
        sink: &Sink<'_>,
    ) -> Option<Corner> {
        let mut parts = word.split('/');
        let counts = [self.positions.len(), self.uvs.len()];
        let position = parts.next().unwrap_or_default();
        let Some(position) = index(position, so_far[0], counts[0]) else {
            let message = Message::new("problem-no-such-vertex")
                .with("index", short(position))
                .with("count", counts[0]);
            sink.error(span, message, [Message::new("expect-obj-index")]);
            return None;
        };
        let uv = parts.next().unwrap_or_default();
        let found = index(uv, so_far[1], counts[1]);
        if found.is_none() && !uv.is_empty() {
            let message = Message::new("problem-no-such-uv")
                .with("index", short(uv))
                .with("count", counts[1]);
            sink.warning(span, message);
        }
        Some([Some(position), found])
    }

    fn vertex(&mut self, corner: Corner) -> u32 {
        let Self {
            known, vertices, ..
        } = self;
        *known.entry(corner).or_insert_with(|| {
            vertices.push(corner);
            vertices.len() as u32 - 1
        })
    }

    fn finish(self, sink: Sink<'_>) -> Result<ObjFile, Vec<Problem>> {
        if sink.n_errors() > 0 {
            return Err(sink.into_problems());
        }
        if self.n_flat > 0 {
            let message = Message::new("problem-flat-faces").with("count", self.n_flat);
            sink.warning(self.first_flat.clone(), message);
        }
        let positions = self.vertices.iter().filter_map(|it| self.place(it));
        let has_uv = self.vertices.iter().any(|[_, uv]| uv.is_some());
        let uv = |[_, uv]: &Corner| {
            let found = uv.and_then(|i| self.uvs.get(i).copied());
            found.unwrap_or_default()
        };
        let uvs = self.vertices.iter().filter(|_| has_uv).map(uv);
        // Numbers and indices have been looked at: what makes no mesh has no faces.
        let Ok(mesh) = Mesh::new(positions.collect(), uvs.collect(), self.faces) else {
            sink.error(0..0, Message::new("problem-no-faces"), []);
            return Err(sink.into_problems());
        };
        let material = self.library.zip(self.material);
        Ok(ObjFile {
            mesh,
            material: material.map(|(library, name)| [library, name]),
            warnings: sink.into_problems(),
        })
    }
}

/// What an index names, from 1 or, negative, back from the last; `None` where that is nothing.
fn index(word: &str, so_far: usize, count: usize) -> Option<usize> {
    let index: i64 = word.parse().ok()?;
    let from_start = match index {
        1.. => index - 1,
        0 => return None,
        ..0 => so_far as i64 + index,
    };
    usize::try_from(from_start).ok().filter(|&i| i < count)
}

/// The first numbers of a statement, of which `needed` must be there.
fn numbers<const N: usize>(
    statement: &Statement<'_>,
    needed: usize,
    sink: &Sink<'_>,
) -> Option<[f32; N]> {
    let mut found = [0.0; N];
    if statement.values().len() < needed {
        let message = Message::new("problem-too-few-numbers")
            .with("count", statement.values().len())
            .with("needed", needed);
        sink.error(statement.span(), message, []);
        return None;
    }
    for ((word, span), number) in statement.values().zip(&mut found) {
        match word.parse::<f32>() {
            Ok(x) if x.is_finite() => *number = x,
            Ok(_) | Err(_) => {
                let message = Message::new("problem-no-number").with("word", short(word));
                sink.error(span, message, []);
                return None;
            }
        }
    }
    Some(found)
}

/// A word that may be as long as a file.
fn short(word: &str) -> String {
    const MOST: usize = 24;
    let mut shown: String = word.chars().take(MOST).collect();
    if word.chars().nth(MOST).is_some() {
        shown.push('…');
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        lesson::{read_mtl, tests::cases},
        text::{Catalog, Lang},
    };

    fn problems(text: &str) -> Vec<String> {
        let found = match read_obj("a.obj", text.as_bytes()) {
            Ok(read) => read.warnings,
            Err(problems) => problems,
        };
        let catalog = Catalog::of(Lang::En);
        let first_line =
            |problem: &Problem| problem.render(catalog).lines().next().map(str::to_owned);
        found.iter().filter_map(first_line).collect()
    }

    #[test]
    fn a_cube_of_quads_with_a_seam() {
        let text = "mtllib cube.mtl\nusemtl wood\n\
            v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
            vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
            f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf -4/2 -1/1 -2/4\nf -4/2 -2/4 -3/3\r\n";
        let read = read_obj("cube.obj", text.as_bytes()).unwrap();
        assert_eq!(read.mesh.faces().len(), 4);
        let n_vertices = read.mesh.positions().len();
        assert_eq!(n_vertices, 8, "each corner has two places in the texture");
        assert!(read.mesh.is_closed(), "its faces share their edges");
        let expected = ["cube.mtl", "wood"].map(str::to_owned);
        assert_eq!(read.material, Some(expected));
        assert_eq!(read.warnings, []);
        let mtl = b"newmtl other\nmap_Kd no.png\nnewmtl wood\nKd 1 1 1\nmap_Kd my wood.png\n";
        assert_eq!(
            read_mtl(mtl, "wood").flatten().as_deref(),
            Some("my wood.png")
        );
    }

    const WRONG: &str = "
f 1 2 4 => a.obj:4:7: error: There is no vertex 4: the file has 3.
f 0 1 2 => a.obj:4:3: error: There is no vertex 0: the file has 3.
f 1 2 -4 => a.obj:4:7: error: There is no vertex -4: the file has 3.
v 1 x 3 => a.obj:4:5: error: “x” is not a finite number.
v 1 NaN 3 => a.obj:4:5: error: “NaN” is not a finite number.
v 1 2 => a.obj:4:1: error: Numbers in this line: only 2 of 3.
 => a.obj:1:1: error: The file has no face that can be drawn.
";

    const LEFT_OUT: &str = "
f 1 2 => a.obj:5:1: warning: This face has only 2 vertices: it is left out.
f 1 2 1 3 => a.obj:5:1: warning: This face crosses itself or has no area: it is left out.
f 1 2 2 => a.obj:5:1: warning: 1 triangle has no area: it cannot be seen.
f 1/7 2 3 => a.obj:5:3: warning: There are no texture coordinates 7: the file has 0. The face is drawn without them.
";

    #[test]
    fn every_complaint_names_its_line() {
        let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        for [line, expected] in cases(WRONG) {
            let found = problems(&format!("{triangle}{line}\n"));
            assert_eq!(found.first(), Some(&expected), "{line}");
        }
        for [line, expected] in cases(LEFT_OUT) {
            let found = problems(&format!("{triangle}f 1 2 3\n{line}\n"));
            assert_eq!(found, [expected], "{line}");
        }
    }

    #[test]
    fn spot_is_read_whole() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/meshes/spot/spot.obj");
        let read = read_obj("spot.obj", &std::fs::read(path).unwrap()).unwrap();
        let mesh = read.mesh;
        assert_eq!((mesh.faces().len(), read.warnings), (5856, Vec::new()));
        assert!(mesh.is_closed());
        // A sphere without handles, by Euler, its seams joined.
        let mut ends: Vec<u32> = mesh.edges().iter().flat_map(|edge| edge.ends).collect();
        ends.sort_unstable();
        ends.dedup();
        assert_eq!(ends.len() + mesh.faces().len(), mesh.edges().len() + 2);
        assert_eq!(mesh.uvs().len(), mesh.positions().len());
    }

    #[test]
    fn a_line_as_long_as_a_book_is_no_trouble() {
        let corners = "1 2 3 ".repeat(200_000);
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf {corners}\n");
        assert_eq!(problems(&text).len(), 2);
        let text = format!("v {} 0 0\n", "9".repeat(1_000_000));
        assert_eq!(problems(&text).len(), 1);
    }
}
