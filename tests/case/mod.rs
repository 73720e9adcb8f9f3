//! Cases and their answers: what every script and grader builds on.

mod asked;
mod frustum;
mod keys;
mod lines;
mod pipeline;
mod polygons;
mod range;
mod schema;
mod space_lines;
mod surfaces;
