//! What goes in, described once: the fields of cases and scene files, what their values look like, what they mean, and
//! what is said of them.
//!
//! ```text
//!            ┌──► reader of cases        JSON, one refusal with its path
//!   Part ────┼──► reader of scene files  TOML, every mistake with its place
//!            ├──► words for people       what is given, in answer keys
//!            └──► schema                 what `clipscope trace --schema` prints
//! ```
//!
//! A [`Part`] is one kind of input: its name, its [`Shape`], how a value of that shape ([`Got`]) becomes a window, a plane or
//! a camera, and how it is told. Readers check the shape, so that a part's own function only sees values of the right one.

mod field;
mod got;
mod parts;
mod schema;

pub use field::{At, Dim, Fault, Field, Given, Part, Presence, Shape, Table};
pub use got::Got;
pub use parts::{
    BIT_ORDER, CAMERA, CAMERA_IN_FILE, CLIP, CONVEX_CLIP, CULL, FROZEN, FRUSTUM, HOLES,
    MOST_VERTICES, POLYGON, SIZE, WINDOW, between, outline_told,
};
pub use schema::{of_fields, of_shape};
