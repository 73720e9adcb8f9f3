//! What stands in a scene.

use std::sync::{Arc, LazyLock};

use crate::{
    algo::cull::FunnelObject,
    figure::Skin,
    geom::{AlignedBox, Matrix, Mesh, Solid, SpaceError, Texture, is_part},
    text::Diagnostic,
};

#[derive(Clone, PartialEq, Debug)]
pub struct NamedMesh {
    pub name: String,
    pub mesh: Mesh,
    pub picture: Option<Picture>,
}

/// A texture, and the file that it was read from: a scene that is saved keeps that as it is.
#[derive(Clone, Debug)]
pub struct Picture {
    texture: Arc<LazyLock<Texture, Decode>>,
    /// A PNG or a JPEG.
    pub file: Arc<[u8]>,
}

type Decode = Box<dyn FnOnce() -> Texture + Send>;

impl Picture {
    pub fn new(texture: Texture, file: &[u8]) -> Self {
        Self::later(|| texture, file)
    }

    /// Decoded once it is to be seen: a large one takes as long as all else at the start.
    pub fn later(decode: impl FnOnce() -> Texture + Send + 'static, file: &[u8]) -> Self {
        Self {
            texture: Arc::new(LazyLock::new(Box::new(decode))),
            file: file.into(),
        }
    }

    pub fn texture(&self) -> &Texture {
        &self.texture
    }
}

impl PartialEq for Picture {
    fn eq(&self, other: &Self) -> bool {
        self.file == other.file
    }
}

#[derive(Clone, PartialEq, Debug)]
pub enum Model {
    Solid(Solid),
    Mesh(Arc<NamedMesh>),
}

impl Model {
    /// Its surface, about its own origin.
    ///
    /// # Panics
    /// Never: every solid has its mesh.
    pub fn mesh(&self) -> &Mesh {
        static MESHES: LazyLock<Vec<(Solid, Mesh)>> =
            LazyLock::new(|| Solid::ALL.map(|solid| (solid, solid.mesh())).into());
        match self {
            Self::Solid(solid) => {
                let known = MESHES.iter().find(|(known, _)| known == solid);
                &known.expect("all solids are in the list").1
            }
            Self::Mesh(named) => &named.mesh,
        }
    }

    /// Is it a mesh of one face, whose corners are all its vertices?
    pub fn is_triangle(&self) -> bool {
        match self {
            Self::Solid(_) => false,
            Self::Mesh(named) => named.mesh.faces() == [[0, 1, 2]],
        }
    }

    pub fn skin(&self, face: [u32; 3]) -> Option<Skin> {
        let Self::Mesh(named) = self else {
            return None;
        };
        let texture = named.picture.as_ref()?.texture().clone();
        let uvs = face.map(|i| named.mesh.uvs().get(i as usize).copied());
        let [Some(a), Some(b), Some(c)] = uvs else {
            return None;
        };
        let uvs = [a, b, c];
        Some(Skin { texture, uvs })
    }
}

/// A model in the world: always valid.
#[derive(Clone, PartialEq, Debug)]
pub struct Object {
    model: Model,
    at: [f64; 3],
    turn_deg: [f64; 3],
    size: f64,
    opacity: f64,
}

impl Object {
    /// A model, enlarged, turned about its x, y and z axis in degrees, in this order, and put at a place.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]; [`SpaceError::Size`].
    pub fn new(
        model: Model,
        at: [f64; 3],
        turn_deg: [f64; 3],
        size: f64,
    ) -> Result<Self, SpaceError> {
        let object = Self {
            model,
            at,
            turn_deg,
            size,
            opacity: 1.0,
        };
        object.checked()
    }

    fn checked(self) -> Result<Self, SpaceError> {
        if self.size.is_nan() || self.size <= 0.0 {
            return Err(SpaceError::Size(self.size));
        }
        // Each vertex has to have a place.
        self.bounds()?;
        Ok(self)
    }

    pub const fn model(&self) -> &Model {
        &self.model
    }

    /// Where its model's origin is.
    pub const fn at(&self) -> [f64; 3] {
        self.at
    }

    /// About its x, y and z axis, in degrees.
    pub const fn turn_deg(&self) -> [f64; 3] {
        self.turn_deg
    }

    pub const fn size(&self) -> f64 {
        self.size
    }

    /// How much it covers of what is behind it, up to 1.
    pub const fn opacity(&self) -> f64 {
        self.opacity
    }

    /// From 0 to 1; `None` beyond that.
    pub fn with_opacity(self, opacity: f64) -> Option<Self> {
        is_part(opacity).then_some(Self { opacity, ..self })
    }

    /// Elsewhere.
    ///
    /// # Errors
    /// As for [`Object::new`].
    pub fn moved(&self, at: [f64; 3]) -> Result<Self, SpaceError> {
        Self { at, ..self.clone() }.checked()
    }

    /// Turned and enlarged in another way.
    ///
    /// # Errors
    /// As for [`Object::new`].
    pub fn reshaped(&self, turn_deg: [f64; 3], size: f64) -> Result<Self, SpaceError> {
        let reshaped = Self {
            turn_deg,
            size,
            ..self.clone()
        };
        reshaped.checked()
    }

    /// With another place for a vertex of its mesh, in the world. A solid keeps its vertices.
    ///
    /// # Errors
    /// [`Diagnostic`]: too far away for a mesh's numbers.
    pub fn with_corner(&self, vertex_idx: usize, to: [f64; 3]) -> Result<Self, Diagnostic> {
        let Model::Mesh(named) = &self.model else {
            return Ok(self.clone());
        };
        // A rotation is undone by its transpose.
        let turned = Matrix::rotation(self.turn_deg.map(f64::to_radians)).rows();
        let from_origin: [f64; 3] = std::array::from_fn(|i| to[i] - self.at[i]);
        let column = |j: usize| (0..3).map(|i| turned[i][j] * from_origin[i]).sum::<f64>();
        let mut positions = named.mesh.positions().to_vec();
        if let Some(position) = positions.get_mut(vertex_idx) {
            *position = [0, 1, 2].map(|j| (column(j) / self.size) as f32);
        }
        let uvs = named.mesh.uvs().to_vec();
        let mesh = Mesh::new(positions, uvs, named.mesh.faces().to_vec())?;
        let named = NamedMesh {
            mesh,
            ..NamedMesh::clone(named)
        };
        let model = Model::Mesh(Arc::new(named));
        let changed = Self {
            model,
            ..self.clone()
        };
        Ok(changed.checked()?)
    }

    pub fn world_from_model(&self) -> Matrix {
        let turned = Matrix::rotation(self.turn_deg.map(f64::to_radians));
        let sized = turned.after(&Matrix::scale(self.size));
        Matrix::translation(self.at).after(&sized)
    }

    /// Its vertices in the world.
    pub fn points(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        let world_from_model = self.world_from_model();
        let positions = self.model.mesh().positions().iter();
        positions.map(move |p| world_from_model.point(p.map(f64::from)))
    }

    /// Around it, along the axes of the world.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]: of one that is valid never.
    pub fn bounds(&self) -> Result<AlignedBox, SpaceError> {
        AlignedBox::around(self.points())
    }

    /// As the funnel asks of it.
    ///
    /// # Panics
    /// Never: a valid object has finite vertices.
    pub fn in_funnel(&self) -> FunnelObject {
        let object = FunnelObject::new(self.model.mesh(), &self.world_from_model());
        object.expect("its vertices were looked at")
    }

    /// A face's corners in the world.
    pub fn face(&self, face_idx: usize) -> Option<[[f64; 3]; 3]> {
        let mesh = self.model.mesh();
        let world_from_model = self.world_from_model();
        let face = *mesh.faces().get(face_idx)?;
        Some(mesh.corners(face).map(|p| world_from_model.point(p)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corner_lies_where_it_was_put_and_the_others_stay() {
        let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]];
        let mesh = Mesh::new(corners, Vec::new(), vec![[0, 1, 2]]).expect("a triangle");
        let named = NamedMesh {
            name: "A".to_owned(),
            mesh,
            picture: None,
        };
        let model = Model::Mesh(Arc::new(named));
        assert!(model.is_triangle());
        let turned =
            Object::new(model, [1.0, -2.0, 3.0], [20.0, 70.0, -35.0], 1.5).expect("finite");
        let to = [-0.5, 4.0, 2.25];
        let moved = turned.with_corner(1, to).expect("finite");
        let [before, after]: [Vec<[f64; 3]>; 2] = [&turned, &moved].map(|it| it.points().collect());
        assert_eq!((before[0], before[2]), (after[0], after[2]));
        for (is, wanted) in after[1].into_iter().zip(to) {
            assert!((is - wanted).abs() < 1e-6, "{is} is {wanted}");
        }
        assert!(turned.with_corner(1, [1e300, 0.0, 0.0]).is_err());
    }
}
