//! What is drawn of a scene whatever the method: solids by what becomes of them, the view volume, the ground.

mod crowd;
mod cube;
mod ground;
mod prelude;
mod solids;
mod spaces;
mod views;
mod volume;

pub use cube::{axis_equation, cube_view, face_at_work};
pub use solids::{FaceLook, Fate, Solids};
pub use spaces::{Followed, PictureSpace, SpacePlaces};
pub use views::{Scenery, face_link, object_link, vertex_link};
pub use volume::{normal_of, plane_at_work, side_key, side_link, side_name, side_named, volume};
