//! One file a method: its sentences, marks and watched values.

mod brute_force;
mod cohen_sutherland;
mod convex_edges;
mod crossings;
mod cuts;
mod cyrus_beck;
mod liang_barsky;
mod nicholl_lee_nicholl;
mod prelude;
mod sectors;
mod shared;
mod why;
