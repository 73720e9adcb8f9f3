//! Links: what stands behind the `#` of an address. A step of the course by its name, or a scene as its file spells it, deflated; then
//! what differs from how that opens by itself. A link that was once made is read by every later version.
//!
//! ```text
//! #05-intervals/entering&at=interval:2&lang=es
//! #v1=q84vSszLTk0BAA&eye=0,0,0,30,20,5,35
//! ```

mod address;
mod code;
mod error;
mod picture;
mod stand;

pub use address::{LONG_LINK, Link, MOST_LINK, Opens, StepName};
pub use error::LinkError;
pub use picture::{is_picture, link_element, link_in, with_link};
pub use stand::{Opened, Stand, said};

#[cfg(test)]
mod tests;
