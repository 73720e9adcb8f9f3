//! One file a method: its sentences, marks and watched values.

mod ear_clipping;
mod triangles;
mod weiler_atherton;
