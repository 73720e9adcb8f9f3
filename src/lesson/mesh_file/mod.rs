//! Meshes as files hold them: Wavefront OBJ, as far as triangles and one texture need it.
//!
//! Read are `v`, `vt`, `f`, `mtllib` and `usemtl`; of an MTL file `newmtl` and `map_Kd`. Everything else, such as normals,
//! curves and groups, is passed over: normals follow from the faces. Every complaint names file, line and column.

mod faces;
mod obj;
mod picture;
mod statements;

pub use obj::{ObjFile, read_obj, read_obj_while};
pub(super) use picture::read_texture;
pub use picture::{PictureFault, picture_of, read_picture};
pub use statements::read_mtl;
